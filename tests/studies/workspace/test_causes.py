"""Clearances in the errors of a workspace: closed forms, mechanisms whose joints are displaced, and their regions."""

from __future__ import annotations

from itertools import product
from typing import Any

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from helpers.compiled import compiled_from
from helpers.examples import UNITS
from linkwright.elements.clearance import OnFlank
from linkwright.expressions.units import LENGTH
from linkwright.kernels import Compiled
from linkwright.studies.accuracy.clearance_contacts import loose_joints
from linkwright.studies.accuracy.clearance_options import Clearance
from linkwright.studies.accuracy.contributors import Contributor, Contributors
from linkwright.studies.workspace.causes import Causes
from linkwright.studies.workspace.curves import curves
from linkwright.studies.workspace.errors import Errors
from linkwright.studies.workspace.guaranteed import edge_shifts, edges, guaranteed
from linkwright.studies.workspace.mesh import DriveBox, mesh
from linkwright.studies.workspace.region_search import reached
from linkwright.studies.workspace.regions import Region
from linkwright.studies.workspace.sheet import ModeSheet
from linkwright.studies.workspace.solving import reaches

Array = NDArray[np.float64]
TURN = np.linspace(0, 2 * np.pi, 72, endpoint=False)
ROUND = np.stack([np.cos(TURN), np.sin(TURN)])
BOX = DriveBox((0.3, 0.2), (2.5, 2.9))

PINS = {"O1": ("ox", "oy"), "B": ("bx", "by"), "C": ("cx", "cy"), "D": ("dx", "dy")}
"""The pins of the five-bar with the parameters that displace the place of one of its links there."""
SHIFTS = [name for pair in PINS.values() for name in pair]


def five_bar(**lengths: float) -> Compiled:
    """Cranks of 1, couplers of 1.2 and 1.1 on a base of 1 (m); P is off the first coupler. Of each pin the place on
    one of its links may be elsewhere."""
    shifts = dict.fromkeys(SHIFTS, 0.0)
    data: dict[str, Any] = {
        "linkwright": 1,
        "units": UNITS,
        "parameters": {"b": 1.2, "c": 1.1} | shifts | lengths,
        "links": {
            "frame": {"points": {"O1": [0, 0], "O4": [1, 0]}},
            "crank1": {"points": {"O1": ["ox", "oy"], "B": [1, 0]}},
            "link2": {"points": {"B": ["bx", "by"], "C": ["b", 0], "P": [0.5, 0.4]}},
            "link3": {"points": {"D": [0, 0], "C": ["c + cx", "cy"]}},
            "crank4": {"points": {"O4": [0, 0], "D": ["1 + dx", "dy"]}},
        },
        "assembly": {"C": "left of B-D"},
        "drives": {
            "motor": {"turns": "crank1", "on": "frame", "speed": 1, "start": 2.0},
            "servo": {"turns": "crank4", "on": "frame", "speed": 1, "start": 1.0},
        },
    }
    return compiled_from(data)


def shifted(compiled: Compiled, **shifts: float) -> Array:
    """The mechanism's parameters, some of them shifted."""
    return compiled.parameters + [shifts.get(name, 0.0) for name in compiled.graph.parameters]


def sheet_of(compiled: Compiled, parameters: Array | None = None, point: str = "P") -> ModeSheet:
    drives = compiled.graph.drives
    return ModeSheet(compiled, point, (drives[0], drives[1]), (1.0,) * len(compiled.graph.branched), parameters)


def deviating(compiled: Compiled, names: Any, within: float) -> Contributors:
    """Independent parameters within plus or minus so much."""
    every = []
    for name in names:
        direction = np.array([float(one == name) for one in compiled.graph.parameters])
        limits = (-within, within, 0.0, within / 3)
        every.append(Contributor(name, direction, 1.0, *limits, np.asarray, LENGTH, "m", 1.0, "", "normal"))
    return Contributors(tuple(every), np.eye(len(every)), compiled.parameters.size)


def causes(compiled: Compiled, clearances: dict[str, Any], names: Any = (), within: float = 0.0) -> Causes:
    """Clearances (m) of joints, besides such parameters."""
    stated = {name: Clearance.model_validate(entry) for name, entry in clearances.items()}
    return Causes(deviating(compiled, names, within), tuple(loose_joints(compiled, stated)))


def poses(count: int, compiled: Compiled) -> Array:
    """Drive values (2, n) at which the five-bar closes well."""
    q = np.random.default_rng(1).uniform([BOX.low], [BOX.high], (20 * count, 2)).T
    return np.asarray(q[:, sheet_of(compiled).place(q)[1] > 0.1][:, :count])


def test_every_direction_of_every_pin_is_within_the_error() -> None:
    """The place on a link that is put on a pin goes round by the clearance in 72 steps; then all of them together, each
    in the direction that is worst for one along which the point is off."""
    compiled, plays = five_bar(), {"O1": 2e-7, "B": 3e-7, "C": 1e-7, "D": 1.5e-7}
    q = poses(12, compiled)
    found = Errors(sheet_of(compiled), causes(compiled, plays), 12)(q)
    here = sheet_of(compiled).place(q)[0]
    ways: list[Array] = []
    for pin, clearance in plays.items():
        vectors = clearance * ROUND.T
        moves = [shifted(compiled, **dict(zip(PINS[pin], vector, strict=True))) for vector in vectors]
        each = [sheet_of(compiled, move).place(q)[0] - here for move in moves]
        ways.append(np.stack(each))
        alone = Errors(sheet_of(compiled), causes(compiled, {pin: clearance}), 12)(q)
        for k, axis in enumerate("xy"):
            most = ways[-1][:, k].max(axis=0)
            assert (most <= alone[f"error {axis} most"] * 1.0005).all()
            np.testing.assert_allclose(most, alone[f"error {axis} most"], rtol=2e-3)
            np.testing.assert_allclose(-ways[-1][:, k].min(axis=0), -alone[f"error {axis} least"], rtol=2e-3)
        far = np.hypot(*np.moveaxis(ways[-1], 1, 0)).max(axis=0)
        np.testing.assert_allclose(far, alone["error worst"], rtol=2e-3)
    farthest = np.zeros(q.shape[1])
    for normal in ROUND.T:
        best = [np.einsum("tkn,k->tn", way, normal).argmax(axis=0) for way in ways]
        for i in range(q.shape[1]):
            shifts: dict[str, float] = {}
            for (pin, clearance), which in zip(plays.items(), best, strict=True):
                shifts |= dict(zip(PINS[pin], clearance * ROUND[:, which[i]], strict=True))
            there = sheet_of(compiled, shifted(compiled, **shifts)).place(q[:, i : i + 1])[0]
            farthest[i] = max(farthest[i], np.hypot(*(there - here[:, i : i + 1]))[0])
    assert (farthest <= found["error worst"] * 1.0005).all()  # but for terms of second order
    np.testing.assert_allclose(farthest, found["error worst"], rtol=3e-3)


def arm() -> Compiled:
    """Two links in a row, of 0.4 and 0.3 (m); P is the tip."""
    data: dict[str, Any] = {
        "linkwright": 1,
        "units": UNITS,
        "parameters": {"a": 0.4, "b": 0.3},
        "links": {
            "frame": {"points": {"O": [0, 0]}},
            "upper": {"points": {"O": [0, 0], "A": ["a", 0]}},
            "fore": {"points": {"A": [0, 0], "P": ["b", 0]}},
        },
        "drives": {
            "shoulder": {"turns": "upper", "on": "frame", "speed": 1, "start": 0},
            "elbow": {"turns": "fore", "on": "upper", "speed": 1, "start": 1.0},
        },
    }
    return compiled_from(data)


def test_the_pins_of_an_arm_add_their_clearances() -> None:
    """Each displaces the tip as it is displaced: the tolerances add sqrt(2 + 2 |cos(elbow)|) of theirs."""
    compiled = arm()
    q = np.random.default_rng(2).uniform(0, 7, (2, 50))
    found = Errors(sheet_of(compiled), causes(compiled, {"O": 3e-4, "A": 1e-4}, "ab", 1e-3), 50)(q)
    np.testing.assert_allclose(found["error worst"], 1e-3 * np.sqrt(2 + 2 * np.abs(np.cos(q[1]))) + 4e-4, rtol=1e-9)
    x = 1e-3 * (np.abs(np.cos(q[0])) + np.abs(np.cos(q.sum(axis=0)))) + 4e-4
    np.testing.assert_allclose(found["error x most"], x, rtol=1e-12)
    np.testing.assert_allclose(found["error x least"], -x, rtol=1e-12)
    one, two = np.cos(q[0]) / 3e3, np.cos(q.sum(axis=0)) / 3e3
    variance = one**2 + two**2 + (3e-4**2 + 1e-4**2) / 2  # the mean of cos^2 over all directions
    np.testing.assert_allclose(found["spread x"], 3 * np.sqrt(variance), rtol=1e-12)


def slide(away: float = 0.0, tilt: float = 0.0) -> Compiled:
    """A turning guide, and on it a slider with P 0.05 m ahead of the middle of its length and 0.02 m beside it."""
    data: dict[str, Any] = {
        "linkwright": 1,
        "units": UNITS,
        "links": {
            "frame": {"points": {"A": [0, 0]}},
            "upper": {"points": {"A": [0, 0]}},
            "fore": {"points": {"E": [0, away], "P": [0.05, 0.02]}},
        },
        "joints": {"guide": {"prismatic": ["upper", "fore"], "line": ["A at 0", f"E at {tilt!r}"]}},
        "drives": {
            "turn": {"turns": "upper", "on": "frame", "speed": 1, "start": 0.3},
            "push": {"slides": "fore", "on": "upper", "position": 0.06},
        },
    }
    return compiled_from(data)


@pytest.mark.parametrize("length", [0.04, 0.2])
def test_both_ends_of_a_guide_are_free(length: float) -> None:
    """The slider lies at any of its four corners: displaced across by (y1 + y2)/2, tilted by (y1 - y2)/L."""
    clearance, q = 1e-5, np.array([[0.4, 2.0, 4.1], [0.05, 0.06, 0.07]])
    entry = {"guide": {"clearance": clearance, "length": length}}
    found = Errors(sheet_of(slide()), causes(slide(), entry), 3)(q)
    here = sheet_of(slide()).place(q)[0]
    off = [
        sheet_of(slide(clearance * (one + two) / 2, clearance * (one - two) / length)).place(q)[0] - here
        for one, two in product((-1, 1), repeat=2)
    ]
    np.testing.assert_allclose(np.max([np.hypot(*one) for one in off], axis=0), found["error worst"], rtol=1e-3)
    for k, axis in enumerate("xy"):
        np.testing.assert_allclose(np.max([one[k] for one in off], axis=0), found[f"error {axis} most"], rtol=3e-3)


def cylinders(**shifts: float) -> Compiled:
    """Two cylinders from A and B to P, whose guides' lines on the rods may lie beside P and be tilted; the right one's
    bears about G, a place of its barrel."""
    data: dict[str, Any] = {
        "linkwright": 1,
        "units": UNITS,
        "parameters": dict.fromkeys(("away1", "tilt1", "away2", "tilt2", "px", "py"), 0.0) | shifts,
        "links": {
            "frame": {"points": {"A": [0, 0], "B": [0.5, 0]}},
            "barrel1": {"points": {"A": [0, 0]}},
            "rod1": {"points": {"P": ["px", "py"], "Q1": [0, "away1"], "S": [0.02, 0.03]}},
            "barrel2": {"points": {"B": [0, 0], "G": [0.3, 0]}},
            "rod2": {"points": {"P": [0, 0], "Q2": [0, "away2"], "T": [0.02, 0.03]}},
        },
        "joints": {
            "left": {"prismatic": ["barrel1", "rod1"], "line": ["A at 0", "Q1 at tilt1"]},
            "right": {"prismatic": ["barrel2", "rod2"], "line": ["B at 0", "Q2 at tilt2"]},
        },
        "assembly": {"P": "left of A-B"},
        "drives": {
            "first": {"slides": "rod1", "on": "barrel1", "position": 0.55},
            "second": {"slides": "rod2", "on": "barrel2", "position": 0.45},
        },
    }
    return compiled_from(data)


@pytest.mark.parametrize("point", ["S", "T"])
def test_guides_and_pins_of_two_cylinders(point: str) -> None:
    """The rod of a guide is displaced by y at its middle and tilted there, which at its own foot, ahead by k, is y - k
    tilt across; corners of both guides, and the pin in its worst of 72 directions, against the maps."""
    compiled, c, length = cylinders(), 1e-7, 0.1
    q = np.random.default_rng(3).uniform([[0.45], [0.35]], [[0.65], [0.55]], (2, 10))
    entries = {
        "left": {"clearance": c, "length": length},
        "right": {"clearance": 2 * c, "length": length, "centre": "G"},
        "P": {"clearance": c},
    }
    found = Errors(sheet_of(compiled, point=point), causes(compiled, entries), 10)(q)
    here = sheet_of(compiled, point=point).place(q)[0]

    def off(i: int, **shifts: float) -> Array:
        there = sheet_of(compiled, shifted(compiled, **shifts), point).place(q[:, i : i + 1])[0]
        return np.asarray((there - here[:, i : i + 1])[:, 0])

    for i in range(q.shape[1]):
        guides = []
        for one, ahead, size in (("1", 0.0, c), ("2", 0.3 - q[1, i], 2 * c)):
            ends = [np.array(pair) * size for pair in product((-1, 1), repeat=2)]
            tilts = [(y[0] - y[1]) / length for y in ends]
            aways = [y.mean() - ahead * tilt for y, tilt in zip(ends, tilts, strict=True)]
            pairs = zip(aways, tilts, strict=True)
            guides.append([off(i, **{f"away{one}": away, f"tilt{one}": tilt}) for away, tilt in pairs])
        pin = [off(i, px=c * x, py=c * y) for x, y in ROUND.T]
        every = np.array([a + b + p for a, b, p in product(*guides, pin)])
        assert np.hypot(*every.T).max() == pytest.approx(found["error worst"][i], rel=2e-3)
        for k, axis in enumerate("xy"):
            assert every[:, k].max() == pytest.approx(found[f"error {axis} most"][i], rel=2e-3)


def region_of(sheet: ModeSheet, steps: int, chord: float) -> Region:
    made = mesh(sheet, BOX, steps)
    segments = curves(sheet, made, chord)
    return Region(sheet, BOX, reached(sheet, BOX, made, segments, chord)[0], tuple(segments), made, steps, 0.0)


@pytest.mark.parametrize("kind", ["singular", "free"])
def test_boundaries_move_as_with_places_displaced(kind: str) -> None:
    """By a clearance's two displacements as by the two coordinates of the place that is put on the pin."""
    compiled = five_bar()
    region = region_of(sheet_of(compiled), 20, 1e-3)
    played = Errors(region.sheet, causes(compiled, dict.fromkeys(PINS, 1e-3)), 10)
    placed = Errors(region.sheet, causes(compiled, {}, SHIFTS, 1e-3), 10)
    found, expected = (
        [one for one in edges(region, errors) if (one.kind == "singular") == (kind == "singular")]
        for errors in (played, placed)
    )
    assert found and [one.kind for one in found] == [one.kind for one in expected]
    for one, other in zip(found, expected, strict=True):
        sizes = (np.hypot(e.shifts[0::2], e.shifts[1::2]) for e in (one, other))
        np.testing.assert_allclose(*sizes, rtol=1e-6, atol=1e-7)


def test_the_rim_and_pins_that_meet_move_as_with_places_displaced() -> None:
    compiled = five_bar(b=1.2, c=1.2)
    sheet = sheet_of(compiled, point="C")
    played = Errors(sheet, causes(compiled, dict.fromkeys(PINS, 1e-3)), 10)
    placed = Errors(sheet, causes(compiled, {}, SHIFTS, 1e-3), 10)
    angles = np.linspace(0.3, 6.0, 8)
    pit = np.radians([[60], [120]])
    q = np.stack([pit + 3e-6 * np.stack([np.cos(angles + step), np.sin(angles + step)]) for step in (0, 0.01)], axis=1)
    for kind in ("pins", "modes"):
        at = q if kind == "pins" else q * 0.97 - 0.02
        normal = np.tile([[1.0], [0.2]], 8)
        sizes = [np.hypot(s[0::2], s[1::2]) for s in (edge_shifts(e, kind, at, normal) for e in (played, placed))]
        assert np.isfinite(sizes[0]).all() and sizes[0].max() > 0.1
        np.testing.assert_allclose(*sizes, rtol=1e-4, atol=1e-6)


def test_mechanisms_with_displaced_pins_reach_the_guaranteed_part() -> None:
    """Pins displaced by their clearances in random directions, lengths at corners of their tolerances: all reach its
    border but for terms of second order; of places farther out some of them don't reach most."""
    compiled, within = five_bar(), 1e-3
    plays = {"B": 1e-3, "C": 1.5e-3, "D": 1e-3}
    region = region_of(sheet_of(compiled), 20, 1e-4)
    found = guaranteed(region, causes(compiled, plays, "bc", within))
    without = guaranteed(region, causes(compiled, {}, "bc", within))
    assert without.shape.contains(found.shape) and found.least > without.least and found.most > without.most
    inner = shapely.boundary(found.shape.buffer(-100 * within**2)).simplify(1e-3)
    places = shapely.get_coordinates(inner).T
    parts = edges(region, Errors(region.sheet, causes(compiled, plays, "bc", within), 10))
    middles = np.concatenate([one.ends.mean(axis=1) for one in parts], axis=1)
    outward = np.concatenate([one.outward for one in parts], axis=1)
    width = np.concatenate([one.width for one in parts])
    steps = mesh(region.sheet, BOX, 40)
    # Not those in gaps between coarse chords.
    true = ~reaches(region.sheet, BOX, steps, middles + 5e-4 * outward, 1e-7)[0]
    outer = (middles - 0.6 * width * outward)[:, np.flatnonzero(true & (width > 5e-4))[::6]]
    rng, hit = np.random.default_rng(6), []
    for _ in range(48):
        turn = rng.uniform(0, 2 * np.pi, 3)
        shifts = dict(zip("bc", rng.choice([-within, within], 2), strict=True))
        for pin, angle in zip("BCD", turn, strict=True):
            vector = plays[pin] * np.array([np.cos(angle), np.sin(angle)])
            shifts |= dict(zip(PINS[pin], vector, strict=True))
        sheet = sheet_of(compiled, shifted(compiled, **shifts))
        hit.append(reaches(sheet, BOX, mesh(sheet, BOX, 40), np.concatenate([places, outer], axis=1), 1e-7)[0])
    by_all = np.all(hit, axis=0)
    assert by_all[: places.shape[1]].all()
    assert by_all[places.shape[1] :].mean() < 0.25


def test_a_flank_stands_between_pins() -> None:
    """Its one displacement is free, up to the clearance to either side."""
    made = causes(arm(), {"A": 1e-3, "O": 2e-3})
    first, last = made.held
    mixed = Causes(made.contributors, (first, OnFlank("slot", ("x", "y"), 3e-3, "slot.force"), last))
    assert mixed.plays[2:3] == ["slot/across"]
    assert np.diag(mixed.covariance) == pytest.approx([5e-7, 5e-7, 9e-6, 2e-6, 2e-6])
    slopes = np.random.default_rng(1).normal(size=(2, 5, 20))
    by = 1e-3 * np.hypot(*slopes[0, :2]) + 3e-3 * np.abs(slopes[0, 2]) + 2e-3 * np.hypot(*slopes[0, 3:])
    assert mixed.most(slopes[0]) == pytest.approx(by, rel=1e-12)
    along = np.einsum("in,ijk->njk", ROUND, slopes)
    reach = 1e-3 * np.hypot(along[:, 0], along[:, 1]) + 3e-3 * np.abs(along[:, 2])
    reach += 2e-3 * np.hypot(along[:, 3], along[:, 4])
    farthest = mixed.farthest(slopes)
    assert (farthest >= reach.max(axis=0) * (1 - 1e-12)).all()
    assert (farthest <= reach.max(axis=0) * 1.003).all()


@settings(max_examples=40, deadline=None)
@given(st.floats(0, 1e-2), st.floats(0, 1e-2), st.integers(0, 2**32 - 1))
def test_more_clearance_is_more_error(one: float, two: float, seed: int) -> None:
    compiled = arm()
    made = [causes(compiled, {"A": 1e-3, "O": 1e-3}, "ab", 1e-3)]
    (joints,) = [c.held for c in made]
    none, less, more = (
        Causes(made[0].contributors, tuple(type(j)(j.joint, j.links, c) for j in joints))  # type: ignore[call-arg]
        for c in (0.0, min(one, two), max(one, two))
    )
    slopes = np.random.default_rng(seed).normal(size=(2, 6, 20))
    bare = Causes(made[0].contributors)
    np.testing.assert_array_equal(none.most(slopes[0]), bare.most(slopes[0, :2]))
    np.testing.assert_allclose(none.farthest(slopes), bare.farthest(slopes[:, :2]), rtol=1e-12)
    assert (less.most(slopes[0]) <= more.most(slopes[0])).all()
    assert (less.farthest(slopes) <= more.farthest(slopes) * 1.001).all()
