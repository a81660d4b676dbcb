"""Structures with joints that report forces of their own: slots, gears, racks, belts, rolling discs.

Reactions against statics by hand, among them the forces that come with a joint's force, such as that which pushes gears
apart; and the report, whose drawing asks for the signals of these joints.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import linkwright as lw
from linkwright.app.job import carry_out, examine_document
from linkwright.graph.statics import Statics
from linkwright.studies.reactions.outcome import ReactionsOutcome
from linkwright.studies.run_context import RunContext
from studies.models import UNITS

Array = NDArray[np.float64]
G = 9.80665
TAN = math.tan(math.radians(20.0))


def beam() -> dict[str, Any]:
    """A beam of 2 m and 200 N, on a pin at one end and on a pin in a level slot at its middle; a load at 0.5 m."""
    return {
        "gravity": [0, "-10 m/s^2"],
        "links": {
            "frame": {"points": {"A": [0, 0], "R": [0, 0]}},
            "beam": {
                "points": {"A": [0, 0], "B": [1000, 0], "P": [500, 0]},
                "mass": 20,
                "com": [1000, 0],
                "inertia": 1e6,
            },
        },
        "joints": {"support": {"pin_in_slot": ["beam", "frame"], "pin": "B", "straight": "R at 0 deg"}},
        "loads": {"p": {"on": "beam", "at": "P", "force": [30, -100]}},
        "assembly": {"B": [1000, 0]},
    }


def wheels(joint: dict[str, Any], distance: float) -> dict[str, Any]:
    """A wheel on which 2 N m act, and one that is held by a strut."""
    return {
        "gravity": "earth",
        "links": {
            "frame": {"points": {"A": [0, 0], "D": [distance, 0], "E": [100, 100]}},
            "first": {"points": {"A": [0, 0]}, "mass": 1, "shape": "disc 20 mm at A"},
            "second": {"points": {"D": [0, 0], "Q": [30, 0]}},
            "strut": {"points": {"E": [0, 0], "Q": [130 if distance > 100 else 100, 0]}},
        },
        "joints": {"between": {**joint, "centres": ["A", "D"], "radii": [20, 40]}},
        "assembly": {"Q": [distance + 30, 0.5]},
        "loads": {"torque": {"on": "first", "torque": 2}},
    }


def rack() -> dict[str, Any]:
    """A pinion held by a strut, and a rack of 1 kg that is pushed with 10 N."""
    return {
        "gravity": "earth",
        "links": {
            "frame": {"points": {"M": [0, 0], "G": [0, -20], "E": [-50, 40]}},
            "pinion": {"points": {"M": [0, 0], "P": [0, 15]}},
            "rack": {"points": {"R": [0, 0]}, "mass": 1, "shape": "point R"},
            "strut": {"points": {"E": [0, 0], "P": [56, 0]}},
        },
        "joints": {
            "slide": {"prismatic": ["frame", "rack"], "line": ["G at 0 deg", "R at 0 deg"]},
            "mesh": {"rack": ["pinion", "rack"], "centre": "M", "pitch_line": "R at 0 deg", "radius": 20},
        },
        "assembly": {"P": [0, 15]},
        "loads": {"push": {"on": "rack", "at": "R", "force": [10, 0]}},
    }


def rolling() -> dict[str, Any]:
    """A disc on the ground that a level strut holds against 1 N m."""
    return {
        "gravity": "earth",
        "links": {
            "frame": {"points": {"O": [0, 0], "E": [-100, 30]}},
            "wheel": {"points": {"C": [0, 0]}, "mass": 2, "shape": "disc 30 mm at C"},
            "strut": {"points": {"E": [0, 0], "C": [100, 0]}},
        },
        "joints": {"ground": {"rolling": ["wheel", "frame"], "centre": "C", "radius": 30, "on_line": "O at 0 deg"}},
        "assembly": {"C": [0, 30]},
        "loads": {"turn": {"on": "wheel", "torque": 1}},
    }


MODELS = {
    "beam": beam(),
    "gears": wheels({"gears": ["first", "second"]}, 60),
    "slack belt": wheels({"belt": ["first", "second"]}, 160),
    "belt": wheels({"belt": ["first", "second"], "pretension": 80}, 160),
    "rack": rack(),
    "rolling": rolling(),
}
LEAN = math.sqrt(1.0 - (20 / 160) ** 2)
"""The cosine of the strands' angle to the line of centres."""
EXPECTED = {
    # By moments about A: 1 m * B = 0.5 m * 100 N + 1 m * 200 N.
    "beam": {"force(frame, beam, A).x": -30, "force(frame, beam, A).y": 50, "force(beam, frame, support).y": -250},
    # 2 N m at 20 mm, and the force that pushes the wheels apart.
    "gears": {
        "force(first, second).x": 100 * TAN,
        "force(first, second).y": 100,
        "force(frame, first).x": 100 * TAN,
        "force(frame, first).y": 100 + G,
    },
    # One strand pulls with 100 N; or both with 80 N +- 50 N.
    "slack belt": {"force(first, second).x": -100 * LEAN, "force(frame, first).x": -100 * LEAN},
    "belt": {"force(first, second).x": -160 * LEAN, "force(frame, first).x": -160 * LEAN},
    "rack": {
        "force(pinion, rack).x": -10,
        "force(pinion, rack).y": -10 * TAN,
        "force(frame, rack).normal": G + 10 * TAN,
    },
    # The strut is level: the ground carries the weight; 1 N m at 30 mm.
    "rolling": {"force(wheel, frame).x": 1 / 0.03, "force(wheel, frame).y": -2 * G},
}


def solved(name: str, out: Path) -> ReactionsOutcome:
    data = {"units": UNITS, "studies": {"reactions": {}}, **MODELS[name]}
    examined = examine_document(lw.Document.model_validate(data))
    job = carry_out(examined, RunContext(out=out))
    assert job.exit_code == 0, [str(f) for f in [*job.examined.findings, *job.found]]
    outcome = job.outcomes["reactions"]
    assert isinstance(outcome, ReactionsOutcome)
    assert max(outcome.closure, outcome.equilibrium) < 1e-12
    return outcome


@pytest.mark.parametrize("name", MODELS)
def test_reactions_are_those_of_statics_and_the_report_is_written(name: str, tmp_path: Path) -> None:
    outcome = solved(name, tmp_path)
    values = {reaction.name: reaction.value for reaction in outcome.reactions}
    assert {key: values[key] for key in EXPECTED[name]} == pytest.approx(EXPECTED[name], rel=1e-12, abs=1e-9)
    assert (tmp_path / "report.html").stat().st_size > 10_000


@pytest.mark.parametrize("name", MODELS)
def test_only_links_without_other_joints_are_bars(name: str, tmp_path: Path) -> None:
    """A wheel that is pinned at two places bears the forces of its teeth besides."""
    bars = {bar.link for bar in solved(name, tmp_path).bars}
    assert bars == ({"strut"} if name != "beam" else set())


class OneLink:
    """The equations of a link that two joints hold along x, one along y and one against turning, of size 1 m. The first
    one's force pushes it up besides, half as strongly."""

    size, links, rows = 1.0, ("link",), ("tooth", "rod", "post", "key")

    def jacobian(self, z: Array) -> Array:
        return np.array([[1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])

    def besides(self, z: Array, multipliers: Array) -> list[tuple[str, Array]]:
        own = np.array([0.0, 0.5 * abs(multipliers[0]), 0.0])
        return [("tooth", own)] if own.any() else []


def test_what_follows_from_an_undetermined_force_is_undetermined() -> None:
    system: Any = OneLink()
    statics = Statics(system, np.zeros(3), {"link": np.array([-8.0, -1.0, 0.5])})
    tooth, rod, post, key = np.eye(5)[:4]
    assert statics.self_stresses.shape == (4, 1)
    assert [statics.component(row) for row in (tooth, rod, post)] == [None, None, None]
    assert statics.component(tooth + rod) == pytest.approx(8.0, rel=1e-14)
    assert statics.component(key) == pytest.approx(-0.5, rel=1e-14)
    assert statics.relative_residual < 1e-15
