"""Grooves: what the cutter leaves against the exact flanks, the roller run along both, and files that are wrong."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import shapely
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from tests.cam.lifts import HEAT_SEAL, harmonic, heat_seal

from linkwright.cam.disc import Disc
from linkwright.cam.followers import SwingingRoller, TranslatingRoller
from linkwright.cam.nc.groove import Groove
from linkwright.cam.nc.job import MillingJob, passes
from linkwright.cam.nc.posts import POSTS
from linkwright.cam.nc.preflight import faults
from linkwright.cam.nc.proof import NCProof, prove
from linkwright.cam.nc.reader import Move, read
from linkwright.cam.rolling import rolled_within

DISC = Disc(SwingingRoller(0.039, 0.020, 0.085, 0.090), heat_seal, -1, HEAT_SEAL)
JOB = MillingJob(8.0, 12.0, 2e-5, 12.0, 400.0, 100.0, 6000.0, start=math.radians(200), spring=False, groove=True)
SMALL = Disc(TranslatingRoller(0.016, 0.006, 0.002), harmonic(0.003, 4e-4, 0.3), -1)
LITTLE = replace(JOB, cutter=2.4, depth=6.0, step=6.0, tolerance=5e-6, start=0.0, lead=2.0)
ANGLES = 180


def milled(disc: Disc, job: MillingJob, post: str = "fanuc") -> str:
    return POSTS[post].text(job, list(Groove(disc, job).passes()))


def proven(disc: Disc, job: MillingJob, text: str) -> NCProof:
    return prove(disc, text, job.cutter / 1e3, ANGLES, groove=True)


def exact(disc: Disc) -> Any:
    """The region between the flanks (mm), from the pitch curve alone: all that the roller goes over."""
    pitch = 1e3 * disc.look(np.linspace(0, 2 * np.pi, 3000, endpoint=False)).offset(0.0)
    ring = shapely.buffer(shapely.LinearRing(pitch.T), 1e3 * disc.follower.radius, quad_segs=64)
    assert len(ring.interiors) == 1
    return ring


def region(proof: NCProof) -> Any:
    """What is left out between the contours of a proof (mm), at the bottom."""
    inner, outer = proof.contours[0], proof.contours[len(proof.contours) // 2]
    return shapely.Polygon(1e3 * outer.T).buffer(0) - shapely.Polygon(1e3 * inner.T).buffer(0)


def assert_sound(disc: Disc, job: MillingJob, proof: NCProof) -> None:
    assert not proof.faults
    assert 0 < proof.worst < job.tolerance
    wanted, made = exact(disc), region(proof)
    arm = 1e3 * getattr(disc.follower, "arm", 1.0)  # a lift that is off by e moves the contact by less than e times it
    assert wanted.symmetric_difference(made).area < job.tolerance * arm * wanted.length
    assert max(proof.gouge, proof.rest) < 1e-3 * arm * job.tolerance
    assert proof.depth == pytest.approx(1e-3 * job.depth)
    assert proof.play is not None
    assert -2 * proof.gouge - 2 * proof.rest <= proof.play[0] <= proof.play[1] <= 2 * (proof.gouge + proof.rest) + 1e-7


def test_each_post_makes_the_groove_within_its_tolerance() -> None:
    job = replace(JOB, step=4.0)
    made = list(Groove(DISC, job).passes())
    ways = []
    for post in POSTS.values():
        assert not list(faults(DISC, job, post))
        text = post.text(job, made)
        assert max(map(len, text.splitlines())) <= post.longest
        found = read(text)
        assert not found.faults
        ways.append([(m.start, m.end, m.centre, m.turn) for m in found.moves if m.feed])
    assert_sound(DISC, job, proven(DISC, job, text))
    assert all(way == ways[0] for way in ways)


@pytest.mark.parametrize(
    "change",
    [
        {"cutter": 6.0, "spring": True},
        {"cutter": 5.97},
        {"cutter": 1.5, "allowance": 0.3, "step": 3.0},
        {"cutter": 4.8, "allowance": 1.5},
        {"compensation": True, "lead": 3.0},
        {"compensation": True, "lead": 5.0, "cutter": 3.6, "allowance": 0.2, "climb": False},
    ],
    ids=str,
)
def test_the_ways_to_mill(change: dict[str, Any]) -> None:
    job, disc = replace(LITTLE, **change), replace(SMALL, sense=1)
    assert not list(faults(disc, job, POSTS["fanuc"]))
    assert_sound(disc, job, proven(disc, job, milled(disc, job)))


@pytest.mark.parametrize("climb", [True, False])
def test_what_is_cut_lies_on_the_right_of_a_climbing_cutter(climb: bool) -> None:
    """With M3; the island around the centre is on the right of a clockwise path, the outer flank of the other."""
    work = Groove(SMALL, replace(LITTLE, climb=climb, allowance=0.3))
    for flank, clockwise in ((-1, climb), (1, not climb)):
        corners = np.array([element.start for element in work.finish(flank).elements[1:-1]])
        x, y = corners.T
        assert (np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)) < 0) == clockwise


def downward(moves: list[Move]) -> Iterator[tuple[Move, Any]]:
    """Motions straight down into the blank, with what has been cut so deep before; a circle that stays on its line."""
    for k, move in enumerate(moves):
        if move.start[:2] == move.end[:2] and move.end[2] < min(move.start[2], 0.0):
            before = [m for m in moves[:k] if max(m.start[2], m.end[2]) <= move.end[2] and m.start[:2] != m.end[:2]]
            lines = [shapely.LineString([m.start[:2], *bent(m), m.end[:2]]) for m in before]
            yield move, shapely.union_all(shapely.buffer(lines, LITTLE.cutter, quad_segs=32))


def bent(move: Move) -> list[tuple[float, float]]:
    if move.centre is None:
        return []
    angle = math.atan2(move.start[1] - move.centre[1], move.start[0] - move.centre[0])
    some = angle + move.turn * move.sweep * np.linspace(0, 1, 30)[1:-1]
    return [(move.centre[0] + move.radius * math.cos(a), move.centre[1] + move.radius * math.sin(a)) for a in some]


def test_nothing_is_plunged_into_the_full() -> None:
    """All that goes straight down does so where the cutter fits into what has been cut before."""
    moves = read(milled(SMALL, replace(LITTLE, step=3.0, allowance=0.3))).moves
    found = list(downward(moves))
    assert len(found) == 2 * 4 + 2  # on each level two passes beside the slot on each side; a finish on each flank
    for move, gone in found:
        disc = shapely.Point(move.end[:2]).buffer(LITTLE.cutter - 0.03)
        assert disc.difference(gone).area < 1e-3
    ramp = [m for m in moves if m.start[2] != m.end[2] and m.start[:2] != m.end[:2]]
    assert [ramp[0].start[2], ramp[-1].end[2]] == [0.0, -6.0]
    slope = [(m.start[2] - m.end[2]) / math.dist((0, 0), (m.radius * m.sweep if m.turn else m.length, 0)) for m in ramp]
    assert max(slope) == pytest.approx(min(slope), rel=0.2)  # of lengths in the file's digits


@pytest.mark.parametrize("start", range(0, 360, 30))
def test_coarse_digits_leave_the_leads(start: int) -> None:
    """Round-off puts their ends up to 0.7 digits beyond the flank."""
    work = Groove(DISC, replace(JOB, cutter=10.0, tolerance=4e-4, decimals=2, start=math.radians(start)))
    for one in work.beside():
        assert np.abs(work.offset(np.array([one.entry]))).max() < work.cleared / 2


def test_the_feed_is_kept_at_the_flanks() -> None:
    """The centre of the cutter is slower than the flank around which it goes inside, faster outside."""
    work = Groove(SMALL, replace(LITTLE, allowance=0.3))
    for flank, least, most in ((-1, 1.05, 1.3), (1, 0.8, 0.95)):
        ratios = [element.ratio for element in work.finish(flank).elements[1:-1] if element.centre]
        assert least < np.median(ratios) < most
    assert {element.ratio for element in work.slot().elements} == {1.0}


@pytest.mark.parametrize("sense", [1, -1])
@pytest.mark.parametrize("wide", [0.0, 1e-4, -1e-4])
def test_the_roller_against_a_flank_from_within(sense: int, wide: float) -> None:
    """An eccentric circle as pitch curve: e cos(theta) + sqrt(p^2 - e^2 sin^2(theta)), p larger by what is cut more."""
    p, e, roller = 50e-3, 10e-3, 8e-3
    theta = np.linspace(0, 2 * np.pi, 50)
    start = p - e

    def lift(angle: Any) -> Any:
        return (p * p - (angle.sin() * e) ** 2).sqrt() - angle.cos() * e - start

    disc = Disc(TranslatingRoller(start - roller, roller), lift, sense)
    fine = np.linspace(0, 2 * np.pi, 60_000, endpoint=False)
    flank = (p + roller + wide) * np.array([np.cos(fine), np.sin(fine)]) - np.array([[0.0], [e]])
    wanted = np.sqrt((p + wide) ** 2 - (e * np.sin(theta)) ** 2) - e * np.cos(theta) - start
    assert np.abs(rolled_within(disc, flank, theta) - wanted).max() < 1e-8


TEXT = milled(SMALL, LITTLE)


def test_wrong_cutters_are_caught() -> None:
    """On both flanks: the play is twice what is cut too much."""
    for off in (1e-4, -1e-4):
        proof = prove(SMALL, TEXT, 0.0024 + off, ANGLES, groove=True)
        assert (proof.gouge if off > 0 else proof.rest) == pytest.approx(1e-4, rel=0.1)
        assert proof.play == pytest.approx((2 * off, 2 * off), rel=0.1)
        assert proof.worst > LITTLE.tolerance


def test_a_groove_milled_as_a_plate_is_caught() -> None:
    """Its path leaves the outer flank, and its leads cut into it."""
    plate = replace(LITTLE, groove=False, lead=15.0)
    proof = proven(SMALL, LITTLE, POSTS["fanuc"].text(LITTLE, list(passes(SMALL, plate))))
    assert proof.rest > 3e-3 and proof.gouge > 1e-3 and proof.worst > LITTLE.tolerance


@pytest.mark.parametrize(("name", "flank"), [("outer", 1), ("inner", -1)])
def test_a_flank_on_the_wrong_side_and_a_flank_that_is_missing_are_caught(name: str, flank: int) -> None:
    work, note = Groove(SMALL, replace(LITTLE, cutter=3.6, allowance=0.3)), f"finish {name} flank"
    made = {one.note: one for one in work.passes()}
    beyond = work.route(1e3 * SMALL.follower.radius + work.job.cutter, flank)
    wrong = made | {note: replace(made[note], elements=tuple(beyond.elements()))}
    proof = proven(SMALL, work.job, POSTS["fanuc"].text(work.job, list(wrong.values())))
    assert proof.faults or (proof.gouge == pytest.approx(7.2e-3, rel=0.05) and proof.worst > LITTLE.tolerance)
    left = [one for one in made.values() if one.note != note]
    proof = proven(SMALL, work.job, POSTS["fanuc"].text(work.job, left))
    assert proof.rest == pytest.approx(0.3e-3, rel=0.05) and proof.gouge < 3e-6
    assert proof.play == pytest.approx((-0.3e-3, -0.3e-3), rel=0.05)


def test_an_island_is_caught() -> None:
    """Without the passes between the slot and the flanks."""
    work = Groove(SMALL, replace(LITTLE, cutter=1.2))
    some = [one for one in work.passes() if "slot" in one.note or "4/4" in one.note]
    proof = proven(SMALL, work.job, POSTS["fanuc"].text(work.job, some))
    assert [fault.key for fault in proof.faults] == ["nc.island"] * 2


def altered(number: int, find: str, put: str) -> str:
    lines = TEXT.splitlines()
    changed = re.sub(find, put, lines[number])
    assert changed != lines[number]
    return "\n".join([*lines[:number], changed, *lines[number + 1 :]])


def test_a_lost_decimal_is_caught() -> None:
    lines = TEXT.splitlines()
    number = next(k for k in range(len(lines) - 20, 0, -1) if re.match(r"X-?\d+\.\d+ Y-?\d\d\.\d+ I", lines[k]))
    proof = proven(SMALL, LITTLE, altered(number, r"Y(-?\d)(\d)\.", r"Y\1.\2"))
    assert [(f.key, f.line) for f in proof.faults][:1] == [("nc.radius", number + 1)]
    entry = next(k for k, line in enumerate(lines) if "INNER FLANK" in line) + 1
    assert proven(SMALL, LITTLE, altered(entry, r"Y(-?\d)(\d)\.", r"Y\1.\2")).faults


HOLE = "G0 X5 Y5\nG1 Z-3 F100\nG0 Z5\nM5"


@pytest.mark.parametrize(("x", "groove"), [("5", True), ("80", True), ("5", False), ("80", False)])
def test_a_hole_elsewhere_is_caught(x: str, groove: bool) -> None:
    """But beside a plate there is nothing to be spoilt."""
    text = TEXT if groove else POSTS["fanuc"].text(LITTLE, list(passes(SMALL, LITTLE)))
    proof = prove(SMALL, text.replace("M5", HOLE.replace("X5", f"X{x}")), 0.0024, ANGLES, groove)
    wanted = [] if x == "80" and not groove else [("nc.stray", x)]
    assert [(fault.key, fault.data["x"]) for fault in proof.faults] == wanted


@pytest.mark.parametrize(
    ("disc", "change", "key"),
    [
        (DISC, {"cutter": 20.1}, "nc.wide-cutter"),
        (DISC, {"cutter": 20.0}, None),
        (DISC, {"compensation": True, "lead": 20.0, "cutter": 15.0}, "nc.groove-lead"),
        (DISC, {"compensation": True}, "nc.short-lead"),
        (Disc(TranslatingRoller(0.03, 0.01), harmonic(0.008, 0.015)), {}, None),
        (Disc(SwingingRoller(0.02, 0.030, 0.085, 0.090), heat_seal, 1, HEAT_SEAL), {}, "nc.undercut"),
        (Disc(TranslatingRoller(0.01, 0.03), harmonic(0.0, 0.03)), {}, "nc.undercut-outer"),
    ],
)
def test_what_is_refused_before(disc: Disc, change: dict[str, Any], key: str | None) -> None:
    job = replace(JOB, tolerance=1e-5, **change)
    assert [fault.key for fault in faults(disc, job, POSTS["fanuc"])] == ([] if key is None else [key])


@settings(max_examples=3)
@given(
    swings=st.booleans(),
    base=st.floats(0.03, 0.09),
    roller=st.floats(0.2, 0.7),
    size=st.floats(0.02, 0.12),
    share=st.floats(0.3, 1.0),
    allowance=st.sampled_from([0.0, 0.3]),
    sense=st.sampled_from([1, -1]),
    climb=st.booleans(),
)
def test_random_grooves(
    swings: bool, base: float, roller: float, size: float, share: float, allowance: float, sense: int, climb: bool
) -> None:
    """Lifts, rollers and cutters over their ranges, as shares of the base circle or of each other."""
    roller *= base
    if swings:
        disc = Disc(SwingingRoller(base, roller, 2 * base, 1.8 * base), harmonic(size, size / 8, 0.3), sense)
    else:
        disc = Disc(TranslatingRoller(base, roller, base / 8), harmonic(size * base, size * base / 8, 0.3), sense)
    tolerance = 2e-6 / (1.8 * base if swings else 1.0)
    job = replace(JOB, cutter=1e3 * roller * share, tolerance=tolerance, allowance=allowance, climb=climb)
    assume(not list(faults(disc, job, POSTS["fanuc"])))
    assert_sound(disc, job, proven(disc, job, milled(disc, job)))
