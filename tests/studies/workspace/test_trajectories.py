"""Trajectories at a constant value of one drive, against the intersection of circles written out here."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from linkwright.kernels import Compiled
from linkwright.studies.workspace.coupler_curve import CurveStretch
from linkwright.studies.workspace.mesh import DriveBox
from linkwright.studies.workspace.sheet import ModeSheet
from linkwright.studies.workspace.trajectories import Trajectories, trajectories
from studies.workspace.models import arm, five_bar

Array = NDArray[np.float64]
Lengths = tuple[float, float, float, float, float]

TURN = 2 * np.pi
WHOLE = DriveBox((0.0, 0.0), (TURN, TURN), (True, True))
ROUND: Lengths = (8.0, 26.0, 28.0, 10.0, 30.0)
"""Peng and Zi's lengths: both cranks turn fully."""
BROKEN: Lengths = (20.0, 26.0, 28.0, 10.0, 30.0)
VALUES = np.arange(24) * TURN / 24
CHORD = 1e-3


def sheet(lengths: Lengths, sign: float = 1.0) -> ModeSheet:
    return ModeSheet(five_bar(*lengths), "C", ("motor", "servo"), (sign,))


def pins(lengths: Lengths, hold: int, held: float, q: Array) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    """The ends B and D of both cranks at values of the moving drive."""
    first, _, _, fourth, base = lengths
    motor, servo = (np.full_like(q, held), q) if hold == 0 else (q, np.full_like(q, held))
    return first * np.exp(1j * motor), base + fourth * np.exp(1j * servo)


def apart(lengths: Lengths, hold: int, held: float, q: Array) -> tuple[Array, Array, Array]:
    """How far B and D are apart, and by how much less than the couplers' sum and more than their difference."""
    b, d = pins(lengths, hold, held, q)
    far = np.abs(d - b)
    return far, lengths[1] + lengths[2] - far, far - abs(lengths[1] - lengths[2])


def each(found: Trajectories) -> list[tuple[float, CurveStretch]]:
    return [(one.held, stretch) for one in found.each for stretch in one.stretches]


@pytest.mark.parametrize("sign", [1.0, -1.0])
@pytest.mark.parametrize("hold", [0, 1])
@pytest.mark.parametrize("lengths", [ROUND, BROKEN])
def test_corners_lie_on_both_circles_on_one_side(lengths: Lengths, hold: int, sign: float) -> None:
    found = trajectories(sheet(lengths, sign), WHOLE, hold, VALUES, CHORD)
    sides = set()
    for held, stretch in each(found):
        b, d = pins(lengths, hold, held, stretch.q)
        c = stretch.at[0] + 1j * stretch.at[1]
        assert np.abs(np.abs(c - b) - lengths[1]).max() < 1e-9 * lengths[1]
        assert np.abs(np.abs(c - d) - lengths[2]).max() < 1e-9 * lengths[2]
        cross = ((d - b).conj() * (c - b)).imag
        sides |= {*np.sign(cross[np.abs(cross) > 1e-3]).tolist()}
    assert len(sides) == 1


@pytest.mark.parametrize("hold", [0, 1])
def test_stretches_are_where_the_couplers_reach_and_end_where_they_are_straight(hold: int) -> None:
    """On a grid of 100 000 angles: which of them lie in a stretch is what the couplers' lengths say."""
    found = trajectories(sheet(BROKEN), WHOLE, hold, VALUES, CHORD)
    angles = np.linspace(0.0, TURN, 100_000, endpoint=False)
    ends, broken = [], 0
    for one in found.each:
        _, room, beyond = apart(BROKEN, hold, one.held, angles)
        closes = (room > 0) & (beyond > 0)
        inside = np.zeros(angles.size, dtype=bool)
        for stretch in one.stretches:
            inside |= (angles - stretch.q[0]) % TURN <= stretch.q[-1] - stretch.q[0]
            if not stretch.closed:
                _, *rooms = apart(BROKEN, hold, one.held, stretch.q[[0, -1]])
                ends.append(np.minimum(*np.abs(rooms)))
        broken += not closes.all()
        assert (inside == closes).all()
        assert closes.all() == any(stretch.closed for stretch in one.stretches)
    assert broken and found.full_range_count == VALUES.size - broken
    assert np.max(ends) < 1e-9 * (BROKEN[1] + BROKEN[2])


def test_chords_lie_within_their_tolerance() -> None:
    """Against the exact point at ten places within each step."""
    at = sheet(BROKEN)
    found = trajectories(at, WHOLE, 1, VALUES, CHORD)
    worst = 0.0
    for held, stretch in each(found):
        shares = np.linspace(0, 1, 12)[1:-1, None]
        q = stretch.q[:-1] + shares * np.diff(stretch.q)
        there = at.place(np.stack([q.ravel(), np.full(q.size, held)]))[0].reshape(2, *q.shape)
        a, way = stretch.at[:, None, :-1], np.diff(stretch.at)[:, None]
        share = np.clip(((there - a) * way).sum(axis=0) / np.maximum((way * way).sum(axis=0), 1e-300), 0, 1)
        worst = max(worst, float(np.nanmax(np.hypot(*(there - a - share * way)))))
    assert 0.05 * CHORD < worst < 1.1 * CHORD


def test_a_held_servo_leads_the_coupler_along_a_circle() -> None:
    """With the servo held, C stays on a circle about D: the length is that of its arc, there and back."""
    found = trajectories(sheet(ROUND), WHOLE, 1, np.array([0.7]), 1e-5)
    (stretch,) = found.stretches
    about = stretch.at[0] - ROUND[4] - ROUND[3] * np.cos(0.7), stretch.at[1] - ROUND[3] * np.sin(0.7)
    swing = np.ptp(np.unwrap(np.arctan2(about[1], about[0])))
    assert stretch.closed
    assert found.length == pytest.approx(2 * swing * ROUND[2], rel=1e-6)


@pytest.mark.parametrize("slack", [1e-5, 1e-9])
@pytest.mark.parametrize("gap", [True, False])
def test_what_is_narrower_than_the_steps_is_found(gap: bool, slack: float) -> None:
    """B and D are farthest apart where the motor points away from D. The couplers are straight, but for so little, or
    folded: a gap of some 0.1 or 0.001 deg, or all that there is. By the cosine rule
    |D - B|^2 = (|D| + first)^2 - 4 |D| first sin(angle / 2)^2 at an angle from there."""
    held = 0.3 if gap else np.pi + 0.3
    d = 30.0 + 10.0 * np.exp(1j * held)
    far = abs(d) + 8.0
    reach = far - slack
    lengths = (8.0, reach / 2 + 1, reach / 2 - 1, 10.0, 30.0) if gap else (8.0, 40.0 + reach, 40.0, 10.0, 30.0)
    (stretch,) = trajectories(sheet(lengths), WHOLE, 1, np.array([held]), CHORD).stretches
    wide = 4 * np.arcsin(np.sqrt(slack * (2 * far - slack) / (4 * abs(d) * 8.0)))
    span = stretch.q[-1] - stretch.q[0]
    assert (TURN - span if gap else span) == pytest.approx(wide, rel=1e-4)
    assert np.cos(np.mean(stretch.q[[0, -1]]) - np.angle(d)) == pytest.approx(1.0 if gap else -1.0, abs=1e-9)


def test_a_trajectory_breaks_where_the_pins_meet() -> None:
    """Equal couplers on pins that meet with the servo at 120 deg: there C jumps to the other side."""
    found = trajectories(sheet((1.0, 1.2, 1.2, 1.0, 1.0)), WHOLE, 1, np.radians([119.0, 120.0]), 1e-4)
    apart_, met = found.each
    assert not any(np.abs(np.exp(1j * s.q[[0, -1]]) - np.exp(1j * np.pi / 3)).min() < 1e-6 for s in apart_.stretches)
    ends = [q for s in met.stretches for q in s.q[[0, -1]] if abs(np.exp(1j * q) - np.exp(1j * np.pi / 3)) < 1e-6]
    assert len(ends) == 2
    assert all(np.hypot(*np.diff(s.at)).max() < 0.1 for s in found.stretches)


def test_an_open_chain_has_whole_circles_and_ranges_have_their_ends() -> None:
    """Held elbow: circles about the shoulder; held shoulder: half circles about the elbow's pin."""
    compiled: Compiled = arm(2.0, 1.0)
    place = ModeSheet(compiled, "P", ("shoulder", "elbow"), ())
    circles = trajectories(place, WHOLE, 1, np.array([0.0, np.pi / 2, np.pi]), 1e-5)
    assert [one.length for one in circles.each] == pytest.approx([6 * np.pi, TURN * 5**0.5, TURN], rel=1e-5)
    assert circles.full_range_count == 3
    half = trajectories(place, DriveBox((0, 0), (TURN, np.pi), (True, False)), 0, np.array([0.0, 1.0]), 1e-5)
    for held, stretch in each(half):
        assert (stretch.q[0], stretch.q[-1], stretch.closed) == (0.0, np.pi, False)
        assert stretch.length == pytest.approx(np.pi, rel=1e-5)
        assert stretch.at[:, 0] == pytest.approx([3 * np.cos(held), 3 * np.sin(held)])
    assert half.full_range_count == 2


def test_where_nothing_closes_there_is_no_stretch() -> None:
    """With the servo at 0 deg D is 40 away, and the crank and the couplers reach 39; at 180 deg it is 20 away."""
    lengths = (1.0, 19.0, 19.0, 10.0, 30.0)
    never, ever = trajectories(sheet(lengths), WHOLE, 1, np.array([0.0, np.pi]), CHORD).each
    assert (never.stretches, never.length) == ((), 0)
    assert ever.length > 0
