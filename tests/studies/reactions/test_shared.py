"""Structures whose joints share a load by their stiffness, against displacements of rigid links on springs."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import linkwright as lw
from linkwright.findings import Finding
from linkwright.model.document import Document

UNITS = {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"}


def beam(stiffness: Any, places: tuple[float, ...] = (0, 1000, 2000), at: float = 500.0) -> dict[str, Any]:
    """A beam on a pin and rollers."""
    points = {f"S{i}": [x, 0] for i, x in enumerate(places)}
    joints = {
        f"roller{i}": {"pin_in_slot": ["beam", "frame"], "pin": f"S{i}", "straight": "F at 0 deg"}
        for i in range(1, len(places))
    }
    return {
        "units": UNITS, "joints": joints, "stiffness": stiffness,
        "links": {"frame": {"points": {"S0": [0, 0], "F": [0, 0]}}, "beam": {"points": {**points, "P": [at, 0]}}},
        "assembly": {name: place for name, place in points.items() if name != "S0"},
        "loads": {"p": {"on": "beam", "at": "P", "force": [0, -600]}},
        "studies": {"reactions": {}},
    }  # fmt: skip


def answer(data: dict[str, Any]) -> tuple[dict[str, float | None], list[Finding]]:
    outcome = lw.run(Document.model_validate(data)).reactions
    assert not outcome.failures
    return {reaction.name: reaction.value for reaction in outcome.reactions}, outcome.warnings


def on_springs(places: tuple[float, ...], k: list[float], at: float) -> np.ndarray:
    """Forces of springs under a rigid beam that sinks and tilts."""
    x, springs = np.array(places), np.array(k)
    a = np.array([[springs.sum(), springs @ x], [springs @ x, springs @ x**2]])
    sunk, tilted = np.linalg.solve(a, [600.0, 600.0 * at])
    return np.asarray(springs * (sunk + tilted * x))


@pytest.mark.parametrize(
    ("places", "k"),
    [((0, 1000, 2000), [1, 1, 1]), ((0, 1000, 2000), [1, 2, 1]), ((0, 700, 1500, 2600), [3, 1, 0.4, 2])],
)
@pytest.mark.parametrize("at", [500.0, 1300.0])
def test_a_beam_on_supports_of_some_stiffness(places: tuple[float, ...], k: list[float], at: float) -> None:
    names = ["S0", *(f"roller{i}" for i in range(1, len(places)))]
    stiffness: Any = {name: f"{value} kN/mm" for name, value in zip(names, k, strict=True)}
    values, warnings = answer(beam(stiffness if len(set(k)) > 1 else "equal", places, at))
    upward = [values["force(frame, beam, S0).y"]]
    upward += [-float(values[f"force(beam, frame, {name}).y"] or 0.0) for name in names[1:]]
    np.testing.assert_allclose(np.array(upward, dtype=float), on_springs(places, k, at), atol=1e-9)
    assert [(f.code, f.severity) for f in warnings] == [("reactions.shared", "warning")]
    assert warnings[0].data["degree"] == len(places) - 2
    assert warnings[0].data["sharing"].key == ("term.redundant-equal" if len(set(k)) == 1 else "term.redundant-shared")


def test_three_bars_share_by_their_stiffness() -> None:
    """A vertical bar and two at 45 degrees under a load on a pin: the vertical one carries P k1 / (k1 + 2 k2 cos^2)."""
    points = {"A": [0, 0], "B": [1000, 0], "C": [-1000, 0]}
    links = {"frame": {"points": points}, "middle": {"points": {"A": [0, 0], "E": [1000, 0]}}}
    links |= {name: {"points": {p: [0, 0], "E": ["1000*sqrt(2)", 0]}} for name, p in (("left", "C"), ("right", "B"))}
    links["hook"] = {"points": {"E": [0, 0], "H": [0, -100]}}
    links["slack"] = {"points": {"H": [0, 0], "W": [100, 0]}}
    links["frame"]["points"]["W"] = [100, -1100]
    values, _ = answer({
        "units": UNITS, "links": links, "assembly": {"E": [0, -1000], "H": [0, -1100]},
        "loads": {"p": {"on": "hook", "at": "E", "force": [0, -600]}},
        "stiffness": {"middle": "3 kN/mm", "left": "2 kN/mm", "right": "2 kN/mm"},
        "studies": {"reactions": {}},
    })  # fmt: skip
    assert values["force(frame, middle).y"] == pytest.approx(600 * 3 / (3 + 2 * 2 / 2), rel=1e-9)
    assert values["force(frame, left).y"] == pytest.approx(600 * 1 / 5, rel=1e-9)


def test_what_no_stiffness_determines_stays_without_a_value() -> None:
    """Two stiff pins that pull on the beam against each other along it, beside rollers of known stiffness."""
    data = beam({"roller1": "1 kN/mm", "roller2": "1 kN/mm"}, (0, 700, 1500))
    data["links"]["frame"]["points"]["S3"] = [2000, 0]
    data["links"]["beam"]["points"]["S3"] = [2000, 0]
    values, warnings = answer(data)
    assert values["force(frame, beam, S0).x"] is None
    assert values["force(frame, beam, S3).x"] is None
    # On two rigid pins the beam doesn't sink, so the rollers carry nothing.
    assert values["force(frame, beam, S0).y"] == pytest.approx(450, abs=1e-9)
    assert [f.code for f in warnings] == ["reactions.shared", "reactions.indeterminate"]
