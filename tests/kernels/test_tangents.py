"""Tangents against differences of the mechanism itself, evaluated at shifted parameters."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from helpers.differences import OFFSETS, WEIGHTS
from linkwright.compilation import examine
from linkwright.kernels import Compiled
from linkwright.kernels.parameter_batch import Varied
from linkwright.kernels.tangents import Tangents
from linkwright.model.document import Document, load, plain

Array = NDArray[np.float64]
EXAMPLES = Path(__file__).parents[2] / "examples"

STEP = 1e-3
"""Of the differences, over the parameter: their error is far below the tolerance, their round-off some 1e-12."""


def toleranced(name: str, parameters: dict[str, object], **changes: object) -> Compiled:
    """An example in which some numbers have become parameters."""
    data = plain(load(EXAMPLES / f"{name}.yaml"))
    data["parameters"] = {**data.get("parameters", {}), **parameters}
    for path, value in changes.items():
        *parts, last = path.split("__")
        entry = data
        for part in parts:
            entry = entry[part]
        entry[last] = value
    compiled, findings = examine(Document.model_validate(data), EXAMPLES)
    assert compiled is not None, findings
    return compiled


def directions(compiled: Compiled, names: list[str]) -> Array:
    """The unit vectors of some parameters, derived ones following by the differences of their linear expressions."""
    varied = Varied(compiled, names)
    nominal = np.array([compiled.quantities.parameters[name] for name in names])
    shifted = varied.parameters(nominal[:, None] + np.eye(len(names)))
    return shifted - compiled.parameters[:, None]


def differences(compiled: Compiled, names: list[str], signals: list[str], t: Array, rates: bool) -> Array:
    """(signals, 1 or 2, names, times)."""
    varied = Varied(compiled, names)
    nominal = np.array([compiled.quantities.parameters[name] for name in names])
    steps = STEP * np.where(nominal == 0, 1.0, np.abs(nominal))
    shifts = (steps[:, None] * OFFSETS)[None] * np.eye(len(names))[:, :, None]
    p = varied.parameters((nominal[:, None, None] + shifts).reshape(len(names), -1))
    y = varied.evaluate(signals, p, t, rates).reshape(len(signals), -1, len(names), OFFSETS.size, t.size)
    return np.einsum("skndt,d->sknt", y, WEIGHTS) / steps[:, None]


CASES = {
    "dyads": (
        lambda: toleranced(
            "paper_feeder",
            {"m": "2 kg", "offset": "1 deg"},
            links__rocker__mass="m",
            drives__motor__start="20 deg + offset",
        ),
        ["AB", "AH", "m", "offset"],
        ["E.x", "E.ay", "motor.torque", "force(frame, crank).x"],
    ),
    "a law, and a drive held to an output": (
        lambda: toleranced("press_law", {}),
        ["r", "middle", "half"],
        ["guide.s", "motor.angle", "motor.torque"],
    ),
    "a law with elementary functions": (
        lambda: toleranced(
            "five_bar",
            {"b": 20, "c": "1 s", "k": 1.5},
            drives__servo__position=(
                "90 deg + b*(1 deg)*sin(180 deg*t/c)^2 + (1 deg)*(k + t/c)^k + (1 deg)*max(cos(k*t/c), 0.1)"
                " + step5(t, 0.1*c, 0 deg, 3*c, k*(1 deg)) + (1 deg)*abs(k - t/c)*hypot(k, t/c)/exp(k)"
            ),
        ),
        ["b", "c", "k", "l3", "alpha"],
        ["P.x", "P.vy", "servo.torque"],
    ),
    "a cluster": (
        lambda: toleranced(
            "platform",
            {"leg": 143, "e": 129},
            links__leg1__points={"A1": [0, 0], "B1": ["leg", 0]},
            links__plate__points={"B1": [0, 0], "B2": [209, 0], "B3": ["e", 154]},
        ),
        ["leg", "e"],
        ["B3.x", "plate.alpha", "motor.torque", "force(leg3, plate).x"],
    ),
    "a table": (
        lambda: toleranced(
            "slider_crank_gas", {"late": 0.5}, drives__engine__start="late", tables__gas__between="cubic"
        ),
        ["r", "l", "bore", "late"],
        ["engine.torque", "C.ax", "force(frame, crank).x"],
    ),
}


@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize("rates", [False, True])
def test_tangents_are_the_slopes_of_the_signals(case: str, rates: bool) -> None:
    make, names, signals = CASES[case]
    compiled = make()
    t = np.linspace(0.01, 0.039 if "table" in case else 0.47, 7)
    values, slopes = Tangents(compiled, directions(compiled, names)).evaluate(signals, t, rates)
    found = slopes if rates else slopes[:, None]
    expected = differences(compiled, names, signals, t, rates)
    size = np.abs(expected).max(axis=(2, 3), keepdims=True)
    # Differences of rates over a tenth of a percent lose some digits beside steep laws.
    np.testing.assert_allclose(found / size, expected / size, atol=2e-9, rtol=0)
    np.testing.assert_array_equal(values[:, 0] if rates else values, compiled.evaluate(signals, t))


def test_a_play_is_what_the_dimension_does_that_only_the_joint_shares() -> None:
    compiled = toleranced("slider_crank", {})
    t = np.linspace(0.0, 0.19, 9)
    plays = ["C/rod/x", "B/crank/x", "guide/normal", "guide/tilt"]
    slopes = Tangents(compiled, directions(compiled, ["l", "r", "e"]), plays).evaluate(["guide.s", "rod.angle"], t)[1]
    (dl, dr, de), (c, b, normal, tilt) = slopes[:, :3].swapaxes(0, 1), slopes[:, 3:].swapaxes(0, 1)
    for found, expected in ((c, dl), (b, dr), (normal, -de), (tilt, 0 * de)):
        np.testing.assert_allclose(found, expected, atol=1e-12 * np.abs(slopes).max())
    turned = Tangents(compiled, np.empty((3, 0)), ["guide/tilt"]).evaluate(["slider.angle"], t)[1]
    np.testing.assert_allclose(turned, -1.0)


def test_the_directions_are_followed_whatever_their_number() -> None:
    compiled = toleranced("four_bar", {})
    along = directions(compiled, ["a", "b", "c", "d"])
    t = np.linspace(0.0, 0.4, 9)
    together = Tangents(compiled, along).evaluate(["P.x"], t)[1][0]
    for k in range(4):
        alone = Tangents(compiled, along[:, [k]]).evaluate(["P.x"], t)[1][0]
        np.testing.assert_array_equal(alone[0], together[k])
    sum_ = Tangents(compiled, along.sum(axis=1, keepdims=True)).evaluate(["P.x"], t)[1][0]
    np.testing.assert_allclose(sum_[0], together.sum(axis=0), rtol=1e-12)


@pytest.mark.parametrize("case", ["a cluster", "a law with elementary functions"])
def test_at_other_parameters_they_are_those_of_the_mechanism_made_with_them(case: str) -> None:
    make, names, signals = CASES[case]
    compiled = make()
    t, along = np.linspace(0.01, 0.47, 7), directions(compiled, names)
    nominal = np.array([compiled.quantities.parameters[name] for name in names])
    p = Varied(compiled, names).parameters(1.01 * nominal[:, None])[:, 0]
    values, slopes = Tangents(compiled, along).at_parameters(p).evaluate(signals, t)
    step = 1e-4 * along
    around = [
        Tangents(compiled, along).at_parameters(p + k * step[:, 0]).evaluate(signals, t)[0] for k in (-2, -1, 1, 2)
    ]
    expected = (around[0] - 8 * around[1] + 8 * around[2] - around[3]) / 12e-4
    np.testing.assert_allclose(slopes[:, 0], expected, rtol=1e-5, atol=1e-7 * np.abs(expected).max())
    np.testing.assert_allclose(values, Varied(compiled, names).evaluate(signals, p[:, None], t)[:, 0], rtol=1e-12)
