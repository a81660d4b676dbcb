"""Continuation of higher groups near change points: against closed forms of mechanisms that have one, whose two
assembly modes come as near to each other as is wished.

The first two were reported as jumping to the other mode under checks that passed.
"""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
import pytest

from helpers.compiled import compiled_from
from linkwright.graph.rows import determinants
from linkwright.kernels.step_certificate import bending, signs

SI = {"length": "m", "angle": "rad", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"}
CRANK, GROUND = 0.1, 0.3
SPEED = 2.0


def pin_on_arc(gap: float) -> dict[str, Any]:
    """A four-bar whose rocker is an arc about D that passes A; the coupler is longer than the crank by a gap."""
    b = CRANK * np.array([np.cos(1.0), np.sin(1.0)])
    c = on_arc(b[:, None], CRANK + gap, np.ones(1))[:, 0]
    return {
        "units": SI,
        "links": {
            "frame": {"points": {"A": [0, 0], "D": [GROUND, 0]}},
            "crank": {"points": {"A": [0, 0], "B": [CRANK, 0]}},
            "coupler": {"points": {"B": [0, 0], "C": [CRANK + gap, 0]}},
        },
        "joints": {"slot": {"pin_in_slot": ["coupler", "frame"], "pin": "C", "arc": {"centre": "D", "radius": GROUND}}},
        "assembly": {"C": c.tolist()},
        "drives": {"motor": {"turns": "crank", "on": "frame", "speed": SPEED, "start": 1.0}},
    }


def on_arc(b: np.ndarray, coupler: float, side: np.ndarray) -> np.ndarray:
    """C at the ends of a coupler from B (2, poses), on the arc about D: on the side of the line from D to B."""
    line = b - np.array([[GROUND], [0.0]])
    far = np.hypot(*line)
    along = (far**2 + GROUND**2 - coupler**2) / (2 * far)
    across = np.sqrt((GROUND - along) * (GROUND + along))
    unit = line / far
    return np.asarray(np.array([[GROUND], [0.0]]) + along * unit + side * across * np.array([unit[1], -unit[0]]))


def pin_in_straight_slot(gap: float) -> dict[str, Any]:
    """A lever whose slot holds a crank pin that passes the lever's own pin C at a gap."""
    c, start = np.array([0.0, -CRANK]), 0.5
    b = (CRANK + gap) * np.array([np.cos(start), np.sin(start)])
    d = c + 0.4 * (b - c) / np.hypot(*(b - c))
    return {
        "units": SI,
        "links": {
            "frame": {"points": {"O": [0, 0], "C": c.tolist()}},
            "crank": {"points": {"O": [0, 0], "B": [CRANK + gap, 0]}},
            "lever": {"points": {"C": [0, 0], "D": [0.4, 0]}},
        },
        "joints": {"slot": {"pin_in_slot": ["crank", "lever"], "pin": "B", "straight": "C at 0 rad"}},
        "assembly": {"D": d.tolist()},
        "drives": {"motor": {"turns": "crank", "on": "frame", "speed": SPEED, "start": start}},
    }


GAPS = [1e-1, 1e-2, 1e-3, 1e-4, 3e-5, 1e-5, 1e-6]


@pytest.mark.parametrize("gap", GAPS)
@pytest.mark.parametrize("poses", [50, 201])
def test_pin_on_arc_keeps_to_its_side_of_the_line_from_the_centre(gap: float, poses: int) -> None:
    compiled = compiled_from(pin_on_arc(gap * CRANK))
    t = np.linspace(0.0, 3.3, poses)
    c = compiled.evaluate(["C.x", "C.y"], t)
    b = CRANK * np.array([np.cos(1.0 + SPEED * t), np.sin(1.0 + SPEED * t)])
    assert np.abs(c - on_arc(b, CRANK * (1 + gap), np.ones(t.size))).max() < 1e-9
    assert c[1].min() >= 0 or gap > 0.01


@pytest.mark.parametrize("gap", [0.5, 1e-1, 1e-3])
def test_margin_of_one_equation_is_the_sine_of_the_transmission_angle(gap: float) -> None:
    compiled = compiled_from(pin_on_arc(gap * CRANK))
    t = np.linspace(0.0, 3.3, 51)
    (margin,) = np.abs(compiled.evaluate(determinants(compiled.structure), t))
    b, c = compiled.evaluate(["B.x", "B.y", "C.x", "C.y"], t).reshape(2, 2, -1)
    coupler, radius = c - b, c - np.array([[GROUND], [0.0]])
    sine = (coupler[0] * radius[1] - coupler[1] * radius[0]) / np.hypot(*coupler) / np.hypot(*radius)
    assert margin == pytest.approx(np.abs(sine), rel=1e-9)


@pytest.mark.parametrize("gap", GAPS)
@pytest.mark.parametrize("poses", [50, 201])
def test_lever_turns_on_where_its_slot_nearly_passes_its_own_pin(gap: float, poses: int) -> None:
    compiled = compiled_from(pin_in_straight_slot(gap * CRANK))
    t = np.linspace(0.0, 4.0, poses)
    angle, travel = compiled.evaluate(["lever.angle", "slot.s"], t)
    turned = 0.5 + SPEED * t
    x, y = CRANK * (1 + gap) * np.cos(turned), CRANK * (1 + gap) * np.sin(turned) + CRANK
    assert np.abs(travel - np.hypot(x, y)).max() < 1e-9
    assert np.abs(np.exp(1j * angle) - np.exp(1j * np.arctan2(y, x))).max() < 1e-9


def test_end_of_a_path_at_a_fold_is_told() -> None:
    """With a coupler that is too short by 1e-4 the two modes do meet: the motion ends there, and not on the other."""
    coupler = CRANK * (1 - 1e-4)
    model = pin_on_arc(-1e-4 * CRANK)
    compiled = compiled_from(model)
    t = np.linspace(0.0, 3.3, 2001)
    c = compiled.evaluate(["C.x", "C.y"], t)
    b = CRANK * np.array([np.cos(1.0 + SPEED * t), np.sin(1.0 + SPEED * t)])
    with np.errstate(invalid="ignore"):
        right = on_arc(b, coupler, np.ones(t.size))
    ends = t[np.argmax(np.isnan(right[0]))] if np.isnan(right[0]).any() else np.inf
    (follower,) = compiled.followers
    assert follower.path.end is not None
    assert follower.path.end == pytest.approx(ends, abs=2 * t[1])
    known = np.isfinite(c[0])
    assert known.any() and np.isnan(c[0, t > follower.path.end]).all()
    assert np.abs(c - right)[:, known].max() < 1e-7


def test_more_poses_between_those_of_a_path_leave_it_as_it_is() -> None:
    compiled = compiled_from(pin_on_arc(1e-3 * CRANK))
    t = np.linspace(0.0, 3.3, 101)
    before = compiled.inputs(t)
    (follower,) = compiled.followers
    poses, last = len(follower.path.t), follower.path.t[-1]
    for time in t[1:-1].tolist():
        follower.lay_through(time, compiled.parameters, partial(compiled.inputs, higher_groups=0))
    assert len(follower.path.t) > poses
    assert follower.path.t[-1] == last
    assert follower.path.end is None
    assert (np.diff(follower.path.t) > 0).all()
    assert np.abs(compiled.inputs(t) - before).max() < 1e-9


def test_path_ends_before_a_pose_that_has_another_mode() -> None:
    """The mode is asked of each pose: with the other one as that of the start, none of them is taken."""
    compiled = compiled_from(pin_on_arc(1e-3 * CRANK))
    t = np.linspace(0.0, 3.3, 101)
    compiled.inputs(t)
    (follower,) = compiled.followers
    follower.sign = -follower.sign
    x = compiled.inputs(t)
    assert follower.path.end is not None
    assert np.isnan(x[follower.rows][:, t > follower.path.end]).all()


def test_slopes_of_two_roots_that_meet_in_a_fold_differ_in_sign_and_bend() -> None:
    """u² = d has roots with the slopes 2 u: a start between them is nobody's."""
    near = np.array([[[2e-3]], [[-2e-3]]])
    assert signs(near).tolist() == [1.0, -1.0]
    assert bending(near[:1], near[1:], np.ones((1, 1)))[0] == pytest.approx(2.0)
    assert bending(np.zeros((1, 1, 1)), near[1:], np.ones((1, 1)))[0] == np.inf
    assert np.isnan(signs(np.full((1, 2, 2), np.nan)))[0]
