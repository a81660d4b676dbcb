"""Mirrored copies: a mechanism and its mirror image, moved by mirrored drives, are mirror images at all times."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import linkwright as lw
from linkwright.compilation import compile_mechanism
from linkwright.elements.entries import ENTRIES, ElementEntry
from linkwright.elements.kind_modules import KIND_MODULES
from linkwright.kernels import Compiled

UNITS = {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"}
SHIFT = 250.0
T = np.linspace(0.0, 1.0, 13)

HALF: dict[str, Any] = {
    "ports": ["pin"],
    "parameters": {"l": 120},
    "links": {
        "frame": {
            "points": {"D": [100, 10], "G": "200 at 40 deg", "H": {"from": {"D": 60, "G": 120}, "side": "left of D-G"}}
        },
        "coupler": {
            "points": {"pin": [0, 0], "C": ["l", 0], "P": "70 at 30 deg"},
            "mass": 1.5,
            "com": [50, 12],
            "inertia": 900,
        },
        "rocker": {
            "points": {"D": [0, 0], "C": [80, 5], "Q": {"from": {"D": 50, "C": 60}, "side": "right of D-C"}},
            "mass": 2,
            "shape": "rod D-C",
        },
        "rod": {"points": {"P": [0, 0], "S": [150, 0]}},
        "slider": {"points": {"S": [0, 0], "V": [15, 4]}, "mass": 0.7, "shape": "point S"},
        "blade": {"points": {"B1": [5, 3], "B2": [40, 3]}},
    },
    "joints": {
        "guide": {"prismatic": ["frame", "slider"], "line": ["G at 25 deg", "S at 10 deg"]},
        "knuckle": {"revolute": ["blade", "slider"], "at": ["B1", "V"]},
        "slot": {"pin_in_slot": ["blade", "frame"], "pin": "B2", "straight": "G at 25 deg", "flank": "left"},
    },
    "cylinders": {"ram": {"from": "H", "to": "Q", "barrel": {"mass": 0.4, "com": 20}}},
    "assembly": {"C": "left of pin-D", "S": "ahead of P along guide", "B2": [234, 166]},
    "springs": {"pull": {"from": "H", "to": "C", "stiffness": "2 N/mm", "free": 30}},
    "counterweights": {"weight": {"on": "rocker", "mass": 0.5, "at": [-20, 7]}},
    "friction": {"rub": {"slide": "guide", "length": 40, "coefficient": 0.1}},
    "loads": {"push": {"on": "slider", "at": [3, 2], "along": "guide", "force": -40}},
}


def both(half: dict[str, Any] = HALF, **copy: Any) -> dict[str, Any]:
    """A copy and its mirror image, each on its own crank."""
    copies = {
        "left": {"of": "half", "join": {"pin": "A"}},
        "right": {"of": "half", "join": {"pin": "B"}, "mirrored": True},
    }
    copies["right"] |= copy
    return {
        "linkwright": 1,
        "units": UNITS,
        "gravity": "earth",
        "subassemblies": {"half": half},
        "links": {
            "frame": {"points": {"O": [0, 0], "M": [SHIFT, 0]}},
            "crank": {"points": {"O": [0, 0], "A": [30, 0]}},
            "counter": {"points": {"M": [0, 0], "B": [30, 0]}},
        },
        "copies": copies,
        "drives": {
            "motor": {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": 40},
            "other": {"turns": "counter", "on": "frame", "speed": "-60 rpm", "start": "180 - 40"},
        },
    }


@pytest.fixture(scope="module")
def made() -> Compiled:
    return compile_mechanism(lw.Document.model_validate(both(at=[SHIFT, 0])))


def values(made: Compiled, copy: str, rows: list[str]) -> np.ndarray:
    return made.evaluate([row.format(copy) for row in rows], T)


@pytest.mark.parametrize("point", ["C", "P", "Q", "S", "V", "B2", "D", "G", "H"])
def test_points_are_mirror_images(made: Compiled, point: str) -> None:
    rows = [f"{{}}_{point}.{attribute}" for attribute in ("x", "y", "vx", "vy", "ax", "ay")]
    left, right = values(made, "left", rows), values(made, "right", rows)
    left[0] = SHIFT / 1000 - left[0]
    left[2] *= -1
    left[4] *= -1
    np.testing.assert_allclose(right, left, rtol=1e-9, atol=1e-11 * max(1.0, float(np.abs(left).max())))


def test_forces_are_mirror_images(made: Compiled) -> None:
    """With gravity, inertia, springs, friction and loads; the crank's torque has the other sign."""
    rows = ["force(frame, {}_rocker).x", "force(frame, {}_rocker).y", "force({}_coupler, {}_rocker).x"]
    left, right = (
        values(made, "left", [r.replace("{}", "{0}") for r in rows]),
        values(made, "right", [r.replace("{}", "{0}") for r in rows]),
    )
    left[[0, 2]] *= -1
    np.testing.assert_allclose(right, left, rtol=1e-7, atol=1e-7)
    motor, other = made.evaluate(["motor.torque", "other.torque"], T)
    np.testing.assert_allclose(other, -motor, rtol=1e-7, atol=1e-9)
    assert float(np.abs(motor).max()) > 0.1


def test_travels_and_lengths_are_the_same(made: Compiled) -> None:
    rows = ["{}_guide.s", "{}_slot.s", "{}_ram.s", "{}_pull.length", "{}_rub.force"]
    np.testing.assert_allclose(values(made, "right", rows), values(made, "left", rows), rtol=1e-9, atol=1e-10)


def test_a_slot_bears_on_the_other_flank(made: Compiled) -> None:
    left, right = values(made, "left", ["{}_slot.force"]), values(made, "right", ["{}_slot.force"])
    np.testing.assert_allclose(right, -left, rtol=1e-7, atol=1e-7)
    joints = made.mechanism.joints
    assert [joints[f"{name}_slot"].one_sided for name in ("left", "right")] == [{"force": -1}, {"force": 1}]


def test_a_mirror_image_of_a_mirror_image_is_the_thing_itself() -> None:
    twice = both(at=[SHIFT, 0])
    twice["subassemblies"]["image"] = {
        "ports": ["pin"],
        "copies": {"i": {"of": "half", "join": {"pin": "pin"}, "mirrored": True}},
    }
    twice["copies"]["left"] = {"of": "image", "join": {"pin": "A"}, "mirrored": True}
    one = compile_mechanism(lw.Document.model_validate(both(at=[SHIFT, 0])))
    other = compile_mechanism(lw.Document.model_validate(twice))
    rows = ["C.x", "C.y", "S.x", "S.y", "B2.x", "guide.s"]
    expected = one.evaluate([f"left_{row}" for row in rows], T)
    np.testing.assert_allclose(other.evaluate([f"left_i_{row}" for row in rows], T), expected, rtol=1e-9, atol=1e-12)


OTHERS: dict[str, dict[str, Any]] = {
    "drives": {"servo": {"turns": "rocker", "on": "crank", "speed": 1, "start": 0}},
    "loads": {"wind": {"on": "rocker", "at": "C", "force": [10, "2 N*sin(crank.angle)"]}},
    "springs": {"twist": {"turns": "rocker", "on": "crank", "stiffness": 1, "free": 0}},
}
"""What is between the copy and a link that isn't mirrored, or follows it."""


@pytest.mark.parametrize("section", OTHERS)
def test_what_has_no_mirror_image_is_refused_by_name(section: str) -> None:
    half = {**HALF, section: OTHERS[section]}
    found = [
        f for f in lw.check(lw.Document.model_validate(both(half, at=[SHIFT, 0]))) if f.code == "subassembly.mirrored"
    ]
    (name,) = OTHERS[section]
    assert [(f.element, f.data["name"]) for f in found] == [("copies.right.mirrored", name)]


def test_lines_on_links_that_stay_are_refused() -> None:
    half = {**HALF, "ports": ["pin", "table"]}
    half["joints"] = {
        **HALF["joints"],
        "guide": {"prismatic": ["table", "slider"], "line": ["O at 25 deg", "S at 10 deg"]},
    }
    data = both(half, at=[SHIFT, 0], join={"pin": "B", "table": "crank"})
    data["copies"]["left"]["join"]["table"] = "crank"
    found = [f for f in lw.check(lw.Document.model_validate(data)) if f.code == "subassembly.mirrored"]
    assert [f.data["name"] for f in found] == ["guide"]


def test_every_kind_is_mirrored() -> None:
    """How each is, the column of mirrored copies in combinations/test_matrix.py says."""
    kinds = {kind: entry for entries in ENTRIES.values() for kind, entry in entries.items() if kind in KIND_MODULES}
    assert {kind for kind, entry in kinds.items() if entry.mirrored is ElementEntry.mirrored} == set()


def test_loads_and_windows_in_a_mirror() -> None:
    """Vectors in the frame and in a link, torques, what they follow, and when."""
    half = {**HALF, "loads": {**HALF["loads"]}}
    half["windows"] = {"high": {"rocker.angle": [60, 200]}, "early": {"C.x": [0, 500]}}
    half["loads"] |= {
        "wind": {"on": "rocker", "at": "C", "force": ["20 N + 3 N*s/m*C.vx", -15]},
        "cut": {"on": "coupler", "at": [30, 5], "force": [12, "0.2 N/mm*(C.x - 40 mm)"], "in": "coupler"},
        "brake": {
            "on": "rocker",
            "against": "coupler",
            "torque": "0.4*sin(rocker.angle) - 0.02*rocker.omega/(1 rad/s)",
        },
        "tap": {"on": "rocker", "at": "C", "force": [0, -25], "window": "high"},
        "pat": {"on": "rocker", "at": "C", "force": [9, 0], "window": "early"},
    }
    half["springs"] = {"twist": {"turns": "rocker", "on": "frame", "stiffness": 3, "free": 70, "preload": 0.4}}
    made = compile_mechanism(lw.Document.model_validate(both(half, at=[SHIFT, 0])))
    left, right = made.evaluate(["motor.torque", "other.torque"], T)
    assert np.ptp(left) > 0.5
    np.testing.assert_allclose(right, -left, rtol=1e-7, atol=1e-7)
