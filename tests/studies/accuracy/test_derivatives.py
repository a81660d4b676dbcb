"""Derivatives of measures against differences of the measures of mechanisms with other dimensions."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from helpers.compiled import compiled_from
from linkwright.kernels import Compiled
from linkwright.kernels.parameter_batch import Varied
from linkwright.model.document import load, plain
from linkwright.reductions import REDUCTIONS, kind_of
from linkwright.results import Run
from linkwright.studies.accuracy.derivatives import Derivatives
from linkwright.studies.accuracy.signal_sensitivities import Slopes
from linkwright.studies.batch_plan import Measuring

EXAMPLES = Path(__file__).parents[3] / "examples"

MEASURES = {
    "span": {"span": "E.x"},
    "max": {"max": "motor.torque"},
    "min": {"min": "E.vx"},
    "kinked": {"min": "abs(E.vx) + abs(E.x - AD)/(1 s)", "window": "late"},
    "extremes": {"extremes": "force(frame, crank).x", "window": "early"},
    "mean": {"mean": "motor.power", "window": "early"},
    "rms": {"rms": "motor.torque", "window": "high"},
    "path": {"path": "C", "window": "high"},
    "at_an_extreme": {"value": "crank.angle", "where": "max E.x", "wrap": [0, 360]},
    "at_a_kink": {"value": "E.y", "where": "min abs(E.vx) + abs(E.x - AD)/(1 s)", "window": "late"},
    "at_an_end": {"value": "E.x", "where": "end", "window": "early"},
    "at_a_start": {"value": "E.y", "where": "start", "window": "high"},
    "straight": {"straightness": "C"},
    "straight_part": {"straightness": "E", "window": "early"},
    "passing": {"dwell": "rocker.angle", "within": "wide/(1 m)", "window": "late"},
    "resting": {"dwell": "E.x", "within": "wide"},
    "efficiency": {"efficiency": ["drag"], "window": "high"},
    "share": {"share": ["oil"], "useful": ["drag"], "window": "early"},
    "max_in_a_window": {"max": "C.y", "window": "early"},
}
NOMINAL = {"AB": 0.155, "wide": 0.05, "CD": 0.3, "AD": 0.3, "edge": 0.31, "m": 2, "offset": 0.02}
DWELLS = {name: measure for name, measure in MEASURES.items() if "dwell" in measure}
OFFSETS, WEIGHTS = np.array([-2, -1, 1, 2]), np.array([1, -8, 8, -1]) / 12  # differences of fourth order


def feeder(measures: dict[str, Any] = MEASURES, **sections: Any) -> Compiled:
    data: dict[str, Any] = plain(load(EXAMPLES / "paper_feeder.yaml"))
    data["parameters"] |= {"edge": "0.31 s", "m": "2 kg", "offset": "1 deg", "wide": "50 mm"}
    data["links"]["rocker"]["mass"] = "m"
    data["drives"]["motor"]["start"] = "20 deg + offset"
    data["windows"] = {"early": ["0.05 s", "edge"], "late": ["0.4 s", "0.7 s"], "high": {"C.y": ["CD/3", "CD*0.9"]}}
    drag = {"on": "slider", "at": "E", "force": ["-20 N*E.vx/(1 m/s)", 0]}
    data["loads"] = {"push": {"on": "slider", "at": "E", "force": [5, -7], "window": "high"}, "drag": drag}
    data["springs"] = {"oil": {"turns": "rocker", "on": "frame", "damping": "0.3 N*m*s/rad"}}
    data["measures"] = measures
    data["require"] = {}
    return compiled_from(data | sections)


def derived(
    measures: dict[str, Any], names: list[str], **sections: Any
) -> dict[str, tuple[list[Any], np.ndarray, np.ndarray]]:
    """Of each measure its derivatives by parameters, their differences (figures, names), and the parameters' values."""
    compiled = feeder(measures, **sections)
    run = Run(compiled, 0.0, 1.5, 200)
    varied = Varied(compiled, names)
    start = np.array([compiled.quantities.parameters[name] for name in names])
    directions = varied.parameters(start[:, None] + np.eye(len(names))) - compiled.parameters[:, None]
    derivatives = Derivatives(run, Slopes(run, directions))
    nominal = np.array([NOMINAL[name] for name in names])
    steps = 2e-4 * nominal
    shifts = (steps[:, None] * OFFSETS)[None] * np.eye(len(names))[:, :, None]
    many = Measuring(varied, run).evaluate(varied.parameters((start[:, None, None] + shifts).reshape(len(names), -1)))
    differences = {}
    for name, measure in compiled.mechanism.measures.items():
        values = [many.figures[name][label].values for label in kind_of(measure).labels]
        shaped = np.array(values).reshape(len(values), len(names), -1)
        differences[name] = shaped @ WEIGHTS / steps
    return {name: (derivatives.of(name), differences[name], nominal) for name in measures}


@pytest.fixture(scope="module")
def found() -> dict[str, Any]:
    """Of dwells by two parameters only: each takes some 0.2 s."""
    others = {name: measure for name, measure in MEASURES.items() if name not in DWELLS}
    return derived(others, list(NOMINAL)) | derived(DWELLS, ["AB", "wide"])


@pytest.mark.parametrize("name", MEASURES)
def test_a_derivative_is_the_slope_of_the_measure(name: str, found: Any) -> None:
    derivatives, differences, nominal = found[name]
    assert len(derivatives) == len(differences)
    for one, expected in zip(derivatives, differences, strict=True):
        assert not one.tie
        np.testing.assert_array_equal(one.sides[:, 0], one.sides[:, 1])
        size = np.abs(expected * nominal).max()
        off = (one.sides[:, 0] - expected) * nominal
        np.testing.assert_allclose(off / size, 0.0, atol=3e-8)


@pytest.mark.parametrize(
    ("expression", "near"),
    [
        ("motor.torque + 1000 N*m*t/(1 s)", ["0.09 s", "0.2 s"]),
        ("motor.torque - 1000 N*m*t/(1 s)", ["0.25 s", "0.32 s"]),
        ("-motor.torque - 10 kN*m*t/(1 s)", ["0.09 s", "0.2 s"]),
        ("-motor.torque + 10 kN*m*t/(1 s)", ["0.25 s", "0.32 s"]),
    ],
)
def test_at_the_jump_of_a_load_an_extreme_moves_as_on_its_side(expression: str, near: list[str]) -> None:
    """The first two lie where the load doesn't act yet or any more, the others where it does."""
    sections = {
        "loads": {"push": {"on": "slider", "at": "E", "force": [500, 0], "window": "acts"}},
        "windows": {"acts": ["0.1 s", "edge"], "near": near},
    }
    names = ["AB", "edge", "m"]
    (one,), (expected,), nominal = derived({"top": {"max": expression, "window": "near"}}, names, **sections)["top"]
    assert one.time == pytest.approx(0.1 if near[0] == "0.09 s" else 0.31, abs=1e-9)
    off = (one.sides[:, 0] - expected) * nominal
    np.testing.assert_allclose(off / np.abs(expected * nominal).max(), 0.0, atol=3e-8)


def test_every_reduction_with_a_rule_is_looked_at() -> None:
    assert {feeder().mechanism.measures[name].reduction for name in MEASURES} == set(REDUCTIONS)


def test_where_two_places_have_the_same_extreme_the_derivative_is_one_sided() -> None:
    """A crank pin that is as high at either end of a window; the start angle lifts one end and lowers the other."""
    data = plain(load(EXAMPLES / "paper_feeder.yaml"))
    data["parameters"] |= {"offset": "0 deg"}
    data["drives"]["motor"] = {"turns": "crank", "on": "frame", "speed": "40 rpm", "start": "0 deg + offset"}
    data["windows"] = {"below": ["0.75 s", "1.5 s"]}
    data["measures"] = {"top": {"max": "B.y", "window": "below"}, "wide": {"span": "B.y", "window": "below"}}
    data["require"] = {}
    compiled = compiled_from(data)
    names = list(compiled.graph.parameters)
    directions = np.zeros((len(names), 2))
    directions[names.index("offset"), 0] = directions[names.index("AB"), 1] = 1.0
    derivatives = Derivatives(Run(compiled, 0.0, 1.5, 200), Slopes(Run(compiled, 0.0, 1.5, 200), directions))
    (one,) = derivatives.of("top")
    assert one.tie
    np.testing.assert_allclose(one.sides[0], [-0.155, 0.155], rtol=1e-9)  # -AB below, AB above
    np.testing.assert_allclose(one.sides[1], 0.0, atol=1e-12)
