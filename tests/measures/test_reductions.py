"""What each registered reduction keeps, on slider cranks of any dimensions: its figures are those of dense samples,
many samples give what single ones do, and its derivatives are differences of its figures."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import Phase, given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from helpers.compiled import compiled_from
from linkwright.expressions.language import parse
from linkwright.kernels import Compiled
from linkwright.kernels.parameter_batch import Varied
from linkwright.measures import measure_all
from linkwright.reductions import REDUCTIONS, kind_of
from linkwright.results import Run
from linkwright.studies.accuracy.derivatives import Derivatives
from linkwright.studies.accuracy.signal_sensitivities import Slopes
from linkwright.studies.batch_plan import Measuring
from studies.models import slider_crank

Array = NDArray[np.float64]
Sampled = Callable[[Array, Callable[[str], Array]], list[float]]

SIGNAL, BAND = "C.vx + 2*B.y/(1 s)", 0.03
"""What is reduced, and the width of a dwell's band (m)."""


PRESS, OIL = {"on": "slider", "at": "C", "force": ["-30 N - 40 N*C.vx/(1 m/s)", 0]}, 5.0
"""A load that does useful work, and a damper (N s/m) that takes the rest."""


def given_power(of: Callable[[str], Array], t: Array) -> float:
    """The drive's work less the energy stored (J)."""
    energy = of("energy.kinetic")
    return float(np.trapezoid(of("motor.power"), t) - energy[-1] + energy[0])


def useful(of: Callable[[str], Array], t: Array) -> float:
    return float(np.trapezoid((30 + 40 * of("C.vx")) * of("C.vx"), t))


def longest(t: Array, y: Array) -> float:
    """The longest stretch of samples that vary by no more than the band."""
    best, first = 0.0, 0
    for last in range(t.size):
        while np.ptp(y[first : last + 1]) > BAND:
            first += 1
        best = max(best, float(t[last] - t[first]))
    return best


def narrowest(x: Array, y: Array) -> float:
    """The least extent over very many directions."""
    angles = np.linspace(0, np.pi, 20001)[:, None]
    return float(np.ptp(x[::20] * np.cos(angles) + y[::20] * np.sin(angles), axis=1).min())


CASES: dict[str, tuple[dict[str, Any], Sampled]] = {
    "span": ({"span": SIGNAL}, lambda t, of: [np.ptp(of(SIGNAL))]),
    "max": ({"max": SIGNAL}, lambda t, of: [of(SIGNAL).max()]),
    "min": ({"min": SIGNAL}, lambda t, of: [of(SIGNAL).min()]),
    "extremes": ({"extremes": SIGNAL}, lambda t, of: [of(SIGNAL).min(), of(SIGNAL).max()]),
    "mean": ({"mean": SIGNAL}, lambda t, of: [np.trapezoid(of(SIGNAL), t) / np.ptp(t)]),
    "rms": ({"rms": SIGNAL}, lambda t, of: [np.sqrt(np.trapezoid(of(SIGNAL) ** 2, t) / np.ptp(t))]),
    "value": ({"value": "B.x", "where": f"max {SIGNAL}"}, lambda t, of: [of("B.x")[of(SIGNAL).argmax()]]),
    "path": ({"path": "B"}, lambda t, of: [np.trapezoid(np.hypot(of("B.vx"), of("B.vy")), t)]),
    "straightness": ({"straightness": "B"}, lambda t, of: [narrowest(of("B.x"), of("B.y"))]),
    "efficiency": ({"efficiency": ["press"]}, lambda t, of: [useful(of, t) / given_power(of, t)]),
    "share": (
        {"share": ["oil"], "useful": ["press"]},
        lambda t, of: [np.trapezoid(OIL * of("C.vx") ** 2, t) / given_power(of, t)],
    ),
    "dwell": ({"dwell": "C.x", "within": f"{BAND} m"}, lambda t, of: [longest(t, of("C.x"))]),
}
"""Of each a measure, and its figures (SI) from times and signals at them."""
NEAR = {"value": 2e-3, "dwell": 1e-3}
"""Of these samples know no more than their own distance."""
MEASURES = {name: {**measure, "window": "part"} for name, (measure, _) in CASES.items()}
SIZES = st.tuples(st.floats(40, 60), st.floats(140, 200), st.floats(-20, 20))
NAMES = ["r", "l", "e"]


def model(sizes: Any) -> Compiled:
    """A slider crank with these dimensions (mm)."""
    acting: dict[str, Any] = {
        "loads": {"press": PRESS},
        "springs": {"oil": {"from": "F", "to": "C", "damping": f"{OIL} N*s/m"}},
    }
    return compiled_from(slider_crank(*sizes, measures=MEASURES, windows={"part": ["0.1 s", "0.85 s"]}, **acting))


def run_of(compiled: Compiled) -> Run:
    return Run(compiled, 0.0, 1.0, 60)


def test_every_registered_reduction_is_looked_at() -> None:
    assert CASES.keys() == REDUCTIONS.keys()
    assert all(kind.entry.reduction == name for name, kind in REDUCTIONS.items())


@settings(max_examples=5, deadline=None, phases=[Phase.generate])
@given(SIZES)
def test_figures_are_those_of_dense_samples(sizes: tuple[float, float, float]) -> None:
    run, t = run_of(model(sizes)), np.linspace(0.1, 0.85, 20001)

    def of(text: str) -> Array:
        return np.asarray(run.jets(run.compiled.quantities.dimensions.bind(parse(text), None), t).d[0])

    for result in measure_all(run)[0]:
        assert tuple(one.label for one in result.found) == kind_of(result.measure).labels
        expected, near = CASES[result.name][1](t, of), NEAR.get(result.name, 1e-6)
        assert [one.value for one in result.found] == pytest.approx(expected, rel=near, abs=1e-9), result.name


@settings(max_examples=2, deadline=None, phases=[Phase.generate])
@given(SIZES)
def test_many_samples_are_single_ones_and_derivatives_their_differences(sizes: tuple[float, float, float]) -> None:
    compiled, step = model(sizes), 1e-6
    run, varied, nominal = run_of(compiled), Varied(compiled, NAMES), 1e-3 * np.array(sizes)[:, None]
    shifts = step * np.concatenate([np.eye(3), -np.eye(3)], axis=1)
    many = Measuring(varied, run).evaluate(varied.parameters(nominal + shifts))
    for i, shift in enumerate(shifts.T):
        for result in measure_all(run_of(model(sizes + 1e3 * shift)))[0]:
            found = [many.figures[result.name][one.label].values[i] for one in result.found]
            assert found == pytest.approx([one.value for one in result.found], rel=1e-9), result.name
    directions = varied.parameters(nominal + np.eye(3)) - compiled.parameters[:, None]
    derivatives = Derivatives(run, Slopes(run, directions))
    for name in MEASURES:
        for one, label in zip(derivatives.of(name), REDUCTIONS[name].labels, strict=True):
            values = many.figures[name][label].values
            assert one.label == label
            assert one.sides[:, 0] == pytest.approx((values[:3] - values[3:]) / (2 * step), rel=1e-5, abs=1e-5), name
