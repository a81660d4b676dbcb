"""Limits where pins meet, where a motion is carried through change points, and at ends at which a cluster folds."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from studies.limits.test_study import DEG, MM, course, limits_of, only, place, same_angle
from studies.models import CRANK, UNITS, codes, four_bar, slider_crank

KEEP = {"cycle": {"turns": "1 motor", "samples": 60, "through": "keep"}}


def kite(side: float) -> dict[str, Any]:
    """Crank and ground of 100 mm, coupler and rocker of ``side``, from 90 deg of the crank."""
    return four_bar(100, side, side, 100, drives={"motor": {**CRANK, "start": "90 deg"}}, studies=KEEP)


def rocker(side: float, crank: float) -> float:
    """The rocker's angle (rad) of :func:`kite` with the pin left of the line from crank pin to pivot: two circles."""
    pin, pivot = 100 * np.exp(1j * crank), 100.0
    towards = pivot - pin
    height = math.sqrt(side**2 - abs(towards) ** 2 / 4)
    return float(np.angle(pin + towards / 2 + 1j * height * towards / abs(towards) - pivot))


@pytest.mark.parametrize("side", [180.0, 100.0])
def test_a_crank_pin_that_meets_the_rockers_pivot(side: float) -> None:
    """In its mode, the rocker goes to 180 deg as the pins meet at 360 deg, and on from 0: values from both sides."""
    found, stretch = only(limits_of(kite(side)))
    assert found.full
    swing = course(stretch, "rocker.angle")
    assert abs(rocker(side, 2 * math.pi - 1e-9)) == pytest.approx(math.pi)
    assert rocker(side, 2 * math.pi + 1e-9) == pytest.approx(0.0, abs=1e-8)
    assert swing.high.value == pytest.approx(math.pi, abs=1e-11)
    assert swing.low.value == pytest.approx(0.0, abs=1e-11)
    assert place(found, swing.low.time) == pytest.approx(2 * math.pi, abs=1e-12)
    assert [place(found, touch.time) for touch in stretch.touches] == pytest.approx(
        ([math.pi] if side == 100 else []) + [2 * math.pi], abs=1e-9
    )
    assert swing.reversals == ()
    t = np.array([90, 180, 359]) * DEG - found.sweep.origin
    wanted = [rocker(side, angle * DEG) for angle in (90, 180, 359)]
    turned = found.sweep.evaluate(["rocker.angle"], t)[0]
    assert all(same_angle(angle, other) for angle, other in zip(turned, wanted, strict=True))


def test_a_slider_that_rests_has_no_limit_positions_there() -> None:
    """Crank and rod of one length, pin C ahead of B: the slider rests in the middle over half a turn."""
    data = slider_crank(100, 100, 0, drives={"motor": {**CRANK, "start": "20 deg"}}, studies=KEEP)
    outcome = limits_of(data)
    found, alone = only(outcome)
    (end,) = course(alone, "guide.s").reversals
    assert (end.value, place(found, end.time), end.top) == (pytest.approx(0.2), pytest.approx(2 * math.pi), True)
    assert course(alone, "guide.s").stroke == pytest.approx(0.2)
    assert outcome.motion is not None
    carried = course(outcome.motion, "guide.s")
    assert carried.stroke == pytest.approx(0.4, rel=1e-12)
    assert [(r.value, r.top) for r in carried.reversals] == [(pytest.approx(-0.2), False), (pytest.approx(0.2), True)]


def test_the_motion_of_a_parallelogram_turns_its_rocker() -> None:
    studies = {"cycle": {"turns": "2 motor", "samples": 60, "through": "keep"}}
    data = four_bar(60, 180, 60, 180, drives={"motor": {**CRANK, "start": "30 deg"}}, studies=studies)
    outcome = limits_of(data)
    assert outcome.motion is not None
    assert course(outcome.motion, "rocker.angle").stroke == pytest.approx(4 * math.pi, rel=1e-12)
    assert [touch.time for touch in outcome.motion.touches] == pytest.approx([5 / 12, 11 / 12, 17 / 12, 23 / 12])
    (_, alone) = only(outcome)
    assert course(alone, "rocker.angle").stroke == pytest.approx(math.pi, abs=1e-10)  # keeps its side


def test_a_motion_that_cant_be_carried_is_a_warning() -> None:
    law = "step5(t, 0.2 s, 150 deg, 0.6 s, 180 deg)"
    data = four_bar(60, 180, 60, 180, drives={"motor": {"turns": "crank", "on": "frame", "position": law}})
    outcome = limits_of({**data, "studies": {"cycle": {"duration": "1 s", "through": "keep"}}})
    assert outcome.motion is None
    assert set(codes(outcome.warnings)) == {"motion.cannot-carry"}


@pytest.mark.parametrize(("start", "sign"), [("0 deg", 1), ("180 deg", 1), ("0 deg", -1), ("180 deg", -1)])
@pytest.mark.parametrize("turns", [0.75, 1, 2])
def test_a_limit_position_at_the_start(start: str, sign: int, turns: float) -> None:
    """An in-line slider-crank from a dead centre of its crank: the slider turns round there. Once a turn where the
    motion ends in the pose of its start."""
    studies = {"cycle": {"turns": f"{turns} motor", "samples": 60}}
    drives = {"motor": {**CRANK, "start": start, "speed": f"{60 * sign} rpm"}}
    motion = limits_of(slider_crank(50, 160, 0, drives=drives, studies=studies)).motion
    assert motion is not None
    first = 0.0 if start == "0 deg" else math.pi
    wanted = [
        (k / 2, (50 * math.cos(first + math.pi * k) + 160) * MM, math.cos(first + math.pi * k) > 0)
        for k in range(int(2 * turns) if turns != 0.75 else 2)
    ]
    found = course(motion, "guide.s").reversals
    assert [r.time for r in found] == pytest.approx([time for time, _, _ in wanted], abs=1e-9)
    assert [r.value for r in found] == pytest.approx([value for _, value, _ in wanted], abs=1e-13)
    assert [r.top for r in found] == [top for _, _, top in wanted]


def test_a_motion_from_rest_has_no_limit_position_at_its_start() -> None:
    """Everything stands still there; from 90 deg the slider just begins to move."""
    law = "step5(t, 0 s, 90 deg, 1 s, 170 deg)"
    drives = {"motor": {"turns": "crank", "on": "frame", "position": law}}
    motion = limits_of(slider_crank(50, 160, 0, drives=drives, studies={"cycle": {"duration": "1 s"}})).motion
    assert motion is not None
    assert course(motion, "guide.s").reversals == ()


def garage_door() -> dict[str, Any]:
    """A bar of 2 m whose lower end runs up a wall, the upper one along a ceiling at 2.1 m, where it is driven."""
    return {
        "units": UNITS,
        "links": {
            "frame": {"points": {"T": [0, 0], "H": [0, 2100]}},
            "block": {"points": {"A": [0, 0]}},
            "door": {"points": {"A": [0, 0], "B": [2000, 0]}},
        },
        "joints": {
            "low": {"prismatic": ["frame", "block"], "line": ["T at 90 deg", "A at 90 deg"]},
            "up": {"pin_in_slot": ["door", "frame"], "pin": "B", "straight": "H at 0 deg"},
        },
        "assembly": {"A": [0, 120], "B": [280, 2100]},
        "drives": {
            "opener": {
                "moves": "door",
                "at": "B",
                "on": "frame",
                "along": "H at 0 deg",
                "position": "280 mm + 1500 mm*t/(10 s)",
            }
        },
    }


def test_the_stroke_up_to_the_ends_at_which_a_cluster_folds() -> None:
    """A.y = 2100 - sqrt(2000^2 - x^2) mm: level with the ceiling at both ends, where its rate is infinite."""
    found, stretch = only(limits_of(garage_door()))
    assert [place(found, t) for t in (found.sweep.start, found.sweep.stop)] == pytest.approx([-2.0, 2.0], rel=1e-8)
    low = course(stretch, "low.s")
    assert low.low.value == pytest.approx(0.1, abs=1e-12)
    assert low.high.value == pytest.approx(2.1, rel=1e-9)
    assert low.stroke == pytest.approx(2.0, rel=1e-9)
