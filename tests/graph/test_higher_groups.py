"""Groups beyond the dyads: against constraint equations solved in full and 3 n Newton-Euler equations."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import linkwright as lw
from helpers.compiled import compiled_from
from helpers.expected import expected_forces, expected_motion, oracle_states, worst
from helpers.plain import plain_of
from linkwright.compilation import examine
from linkwright.graph.rows import BodyPlace
from linkwright.model.document import Document, parse_document
from linkwright.results import Run, certify
from linkwright.structure import HigherGroup

SLOWLY = {"speed": 0.2, "start": 0}
SI = {"length": "m", "angle": "rad", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"}


def body(points: dict[str, list[float]], mass: float = 1.0) -> dict[str, Any]:
    """A link with mass off its line."""
    return {"points": points, "mass": mass, "com": [0.3, 0.1], "inertia": 0.2}


def model(links: dict[str, Any], assembly: dict[str, Any], drives: dict[str, Any], **more: Any) -> dict[str, Any]:
    return {
        "units": SI,
        "gravity": [0.4, -9.81],
        "links": links,
        "assembly": assembly,
        "drives": drives,
        "loads": {"push": {"on": next(reversed(links)), "at": [0.2, 0.3], "force": [3, -5], "in": "frame"}},
        **more,
    }


def apart(a: list[float], b: list[float]) -> float:
    return float(np.hypot(a[0] - b[0], a[1] - b[1]))


def seen_from(origin: list[float], along: list[float], point: list[float]) -> list[float]:
    """A point's coordinates in the frame with this origin and x axis through ``along``."""
    axis = np.subtract(along, origin) / apart(along, origin)
    arm = np.subtract(point, origin)
    return [float(axis @ arm), float(axis[0] * arm[1] - axis[1] * arm[0])]


def triad() -> dict[str, Any]:
    """Three legs on a plate, one of them on a crank: the Assur group of class III."""
    b1, b2, b3 = [0.6, 1.4], [2.6, 0.8], [2.4, 2.3]
    links = {
        "frame": {"points": {"O": [0, 0], "A2": [4, 0.5], "A3": [3, 4]}},
        "crank": body({"O": [0, 0], "A1": [0.3, 0]}),
        "leg1": body({"A1": [0, 0], "B1": [apart([0.3, 0], b1), 0]}),
        "leg2": body({"A2": [0, 0], "B2": [apart([4, 0.5], b2), 0]}),
        "leg3": body({"A3": [0, 0], "B3": [apart([3, 4], b3), 0]}),
        "plate": body({"B1": [0, 0], "B2": seen_from(b1, b2, b2), "B3": seen_from(b1, b2, b3)}, 2.0),
    }
    return model(links, {"B1": b1, "B2": b2, "B3": b3}, {"motor": {"turns": "crank", "on": "frame", **SLOWLY}})


def double_triad() -> dict[str, Any]:
    """Four links in two loops without a dyad: a double butterfly's core."""
    links = {
        "frame": {"points": {"O": [0, 0], "F": [2.5, 0]}},
        "crank": body({"O": [0, 0], "A": [0.25, 0]}),
        "left": body({"A": [0, 0], "B": [1, 0], "C": [0.5, 0.4]}),
        "right": body({"F": [0, 0], "D": [1, 0]}),
        "low": body({"B": [0, 0], "D": [0.7, 0], "H": [0.3, 0.5]}),
        "high": body({"C": [0, 0], "H": [0.6, 0]}),
    }
    sketch = {"B": [1.2, 0.3], "C": [0.6, 0.7], "D": [1.8, 0.6], "H": [1.2, 0.9]}
    return model(links, sketch, {"motor": {"turns": "crank", "on": "frame", **SLOWLY}})


def cylinder() -> dict[str, Any]:
    """A driven slide inside a loop: barrel on the frame, rod on a boom."""
    links = {
        "frame": {"points": {"O": [0, 0], "K": [0.3, -0.9]}},
        "barrel": body({"K": [0, 0]}),
        "rod": body({"M": [0, 0]}),
        "boom": body({"O": [0, 0], "M": [1.3, -0.1], "tip": [2.6, -0.3]}),
    }
    slide = {"lift": {"prismatic": ["barrel", "rod"], "line": ["K at 0", "M at 0"]}}
    drives = {"raise": {"slides": "rod", "on": "barrel", "speed": 0.1, "start": 1.2}}
    return model(links, {"M": [1.3, -0.1]}, drives, joints=slide)


def loader() -> dict[str, Any]:
    """Two driven cylinders, the second between boom and bellcrank; a dyad follows."""
    links = {
        "frame": {"points": {"O": [0, 0], "K": [0.3, -0.9]}},
        "boom": body({"O": [0, 0], "M": [1.3, -0.1], "N": [0.35, 0.25], "Q": [1.5, 0.3], "S": [2.6, -0.3]}, 4.0),
        "barrel1": body({"K": [0, 0]}),
        "rod1": body({"M": [0, 0]}),
        "bellcrank": body({"Q": [0, 0], "R": [-0.06, 0.48], "T": [-0.12, -0.42]}),
        "barrel2": body({"N": [0, 0]}),
        "rod2": body({"R": [0, 0]}),
        "pushrod": body({"T": [0, 0], "U": [1.0, 0]}),
        "bucket": body({"S": [0, 0], "U": [-0.06, 0.33], "tip": [0.85, -0.25]}),
    }
    joints = {
        "lift": {"prismatic": ["barrel1", "rod1"], "line": ["K at 0", "M at 0"]},
        "tilt": {"prismatic": ["barrel2", "rod2"], "line": ["N at 0", "R at 0"]},
    }
    drives = {
        "raise": {"slides": "rod1", "on": "barrel1", "speed": 0.03, "start": 1.25},
        "dump": {"slides": "barrel2", "on": "rod2", "speed": -0.02, "start": -1.2},
    }
    sketch = {"M": [1.3, -0.1], "R": [1.44, 0.78], "U": "left of T-S"}
    return model(links, sketch, drives, joints=joints)


def coupler_drive() -> dict[str, Any]:
    """A four-bar driven between crank and coupler."""
    links = {
        "frame": {"points": {"A": [0, 0], "D": [3, 0]}},
        "crank": body({"A": [0, 0], "B": [1, 0]}),
        "coupler": body({"B": [0, 0], "C": [3, 0]}),
        "rocker": body({"D": [0, 0], "C": [2, 0]}),
    }
    drives = {"motor": {"turns": "crank", "on": "coupler", "speed": 0.1, "start": 0.9}}
    return model(links, {"B": [0.6, 0.8], "C": [3.5, 1.9]}, drives)


def sliding_triad() -> dict[str, Any]:
    """A triad with a slide on the frame and one between two moving links."""
    b1, b2, b3, on_rail = [0.6, 1.4], [2.4, 1.6], [1.9, 2.8], [0.0, 2.6]
    rail = float(np.arctan2(b3[1] - on_rail[1], b3[0] - on_rail[0]))
    rod = float(np.arctan2(-b2[1], 4 - b2[0]) - np.arctan2(b2[1] - b1[1], b2[0] - b1[0]))
    links = {
        "frame": {"points": {"O": [0, 0], "A2": [4, 0], "P": on_rail}},
        "crank": body({"O": [0, 0], "A1": [0.3, 0]}),
        "leg1": body({"A1": [0, 0], "B1": [apart([0.3, 0], b1), 0]}),
        "sleeve": body({"A2": [0, 0]}),
        "block": body({"B3": [0, 0]}),
        "plate": body({"B1": [0, 0], "B2": seen_from(b1, b2, b2), "B3": seen_from(b1, b2, b3)}, 2.0),
    }
    joints = {
        "rail": {"prismatic": ["frame", "block"], "line": [f"P at {rail!r}", "B3 at 0"]},
        "rod": {"prismatic": ["plate", "sleeve"], "line": [f"B2 at {rod!r}", "A2 at 0"]},
    }
    drives = {"motor": {"turns": "crank", "on": "frame", **SLOWLY}}
    return model(links, {"B1": b1, "B2": b2, "B3": b3}, drives, joints=joints)


CASES = {f.__name__: f for f in (triad, double_triad, cylinder, loader, coupler_drive, sliding_triad)}
T = np.linspace(0.0, 1.5, 7)


@pytest.mark.parametrize("name", CASES)
def test_motion_and_forces_agree_with_the_full_equations(name: str) -> None:
    """To 1e-9 of the largest of each kind; the oracle starts from our start pose and follows by itself."""
    data = CASES[name]()
    compiled = compiled_from(data)
    beyond = any(isinstance(step, HigherGroup) for step in compiled.structure.steps)
    assert beyond == (name not in ("cylinder", "loader", "coupler_drive"))  # those are dyads of held links
    moving = compiled.structure.topology.moving
    x0 = compiled.evaluate([row for link in moving for row in BodyPlace.all(link)], np.zeros(1))[:, 0].reshape(-1, 4)
    start = {link: (x, y, float(np.arctan2(s, c))) for link, (x, y, c, s) in zip(moving, x0.tolist(), strict=True)}
    oracle, states = oracle_states(plain_of(data, start), T)
    expected = [*expected_motion(oracle, states).values(), expected_forces(oracle, states)]
    for expectation in expected:
        error, signal = worst(compiled.evaluate(list(expectation), T), expectation, 1.0)
        assert error < 1e-9, signal


@pytest.mark.parametrize("name", CASES)
def test_the_certificate_holds(name: str) -> None:
    run = Run(compiled_from(CASES[name]()), 0.0, 3.0, 60)
    certificate = certify(run)
    assert certificate.sound(1e-11)
    assert certificate.mobility == certificate.gruebler == len(run.compiled.mechanism.drives)
    assert certificate.nearest is not None
    assert 0.01 < certificate.nearest.determinant <= 1.0


@pytest.mark.parametrize("name", CASES)
def test_rates_of_every_signal_agree_with_differences(name: str) -> None:
    run = Run(compiled_from(CASES[name]()), 0.0, 3.0, 60)
    names = [signal.text for signal in run.compiled.quantities.signals.all() if not signal.text.endswith(".arm")]
    t, h = np.array([0.4, 1.1, 2.3]), 2e-3
    _, rates = run.rates(names, t)
    weights = {-3: -1 / 60, -2: 3 / 20, -1: -3 / 4, 1: 3 / 4, 2: -3 / 20, 3: 1 / 60}
    differences = sum(w * run.evaluate(names, t + k * h) for k, w in weights.items()) / h
    scale = np.abs(rates).max(axis=1, keepdims=True) + 1.0
    assert (np.abs(rates - differences) / scale).max() < 1e-6


def test_times_may_come_in_any_order_and_alone() -> None:
    compiled = compiled_from(triad())
    t = np.array([1.7, 0.2, 0.9])
    alone = np.array([compiled_from(triad()).evaluate(["plate.omega"], t[i : i + 1])[0, 0] for i in range(3)])
    assert np.abs(compiled.evaluate(["plate.omega"], t)[0] - alone).max() < 1e-12


def test_both_modes_of_a_sketched_group() -> None:
    """A sketch on the other side leads to the other assembly mode, and each keeps its own."""
    up, down = coupler_drive(), coupler_drive()
    down["assembly"] = {"B": [0.6, -0.8], "C": [2.5, -1.9]}
    ends = [compiled_from(data).evaluate(["C.y"], np.linspace(0, 3, 50))[0] for data in (up, down)]
    assert (ends[0] > 0).all()
    assert (ends[1] < 0).all()


def test_a_group_without_a_sketch_is_refused_by_its_links() -> None:
    data = triad()
    data["assembly"] = {}
    _, findings = examine(Document.model_validate(data))
    assert [f.code for f in findings] == ["assembly.no-sketch"]
    assert set(findings[0].data["links"].parts) == {"leg1", "leg2", "leg3", "plate"}
    # The pins whose places are wanted: not those on the frame, nor on the crank, which are known.
    assert str(findings[0].data["pins"]) == "B1, B2, B3"
    assert "linkwright modes FILE" in findings[0].mend


def test_a_group_that_can_not_close_is_refused() -> None:
    data = triad()
    data["links"]["leg3"]["points"]["B3"] = [0.1, 0]
    _, findings = examine(Document.model_validate(data))
    assert [f.code for f in findings] == ["assembly.not-found"]


def test_a_mechanism_of_kilometres_is_put_together_too() -> None:
    """Newton's method ends at round-off, which is that of the places."""
    small, large = triad(), triad()
    for data, factor in ((small, 1.0), (large, 4096.0)):
        for link in data["links"].values():
            link.update(points={name: [factor * c for c in place] for name, place in link["points"].items()})
            for key in ("mass", "com", "inertia", "shape"):
                link.pop(key, None)
        data["assembly"] = {name: [factor * c for c in place] for name, place in data["assembly"].items()}
        data.pop("loads", None)
    found = [compiled_from(data).evaluate(["plate.omega"], T)[0] for data in (small, large)]
    assert np.abs(found[1] - found[0]).max() < 1e-10


def test_a_start_in_a_singular_position_is_told_as_such() -> None:
    """A beam on two pins in upright slots exactly its length apart closes, in a position in which it can't be turned;
    with slots nearer together it has an assembly, with slots farther apart it has none."""

    def findings(apart: float) -> list[str]:
        data = {
            "linkwright": 1,
            "units": {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"},
            "links": {
                "frame": {"points": {"F1": [0, 0], "F2": [apart, 0], "G": [300, -200]}},
                "beam": {"points": {"T1": [0, 0], "T2": [800, 0], "C": [400, 0]}},
            },
            "joints": {
                "g1": {"pin_in_slot": ["beam", "frame"], "pin": "T1", "straight": "F1 at 90 deg"},
                "g2": {"pin_in_slot": ["beam", "frame"], "pin": "T2", "straight": "F2 at 90 deg"},
            },
            "cylinders": {"cyl": {"from": "G", "to": "C"}},
            "assembly": {"T1": [0, 300], "T2": [apart, 300 + max(800**2 - apart**2, 0) ** 0.5]},
            "drives": {"ram": {"extends": "cyl", "position": "520 mm + 50 mm*t/(1 s)"}},
        }
        return [finding.code for finding in lw.check(parse_document(data)) if finding.severity == "error"]

    assert findings(800) == ["assembly.singular-start"]
    assert findings(820) == ["assembly.not-found"]
    assert findings(795) == []
