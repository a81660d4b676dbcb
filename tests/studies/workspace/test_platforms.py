"""Platforms of triads turned round: an arm on a coupler that a rocker, a slider or a rocking block guides, against the
coupler's motion by complex numbers, which is known in closed form from the crank's angle."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from numpy.typing import NDArray

from linkwright.enclosures.forms import AffineForm
from linkwright.studies.workspace.cells import HEAVY
from linkwright.studies.workspace.mesh import DriveBox
from linkwright.studies.workspace.places import FOLD, KnownPoses, ModePlaces
from linkwright.studies.workspace.platform import in_whole
from linkwright.studies.workspace.region_enclosure import _square, _vague, enclosed
from linkwright.studies.workspace.sheet import ModeSheet
from studies.workspace.models import LEGS, ArmOnCoupler, random_arm

Array = NDArray[np.float64]
Points = NDArray[np.complex128]
STEPS = 6000
WHOLE = DriveBox((0.0, 0.0), (2 * np.pi, 2 * np.pi), (True, True)).askew()
PART = DriveBox((0.5, -1.0), (2.5, 1.0), (False, False))


def poses(shape: ArmOnCoupler, z: Points, box: DriveBox, side: float) -> tuple[NDArray[np.int_], NDArray[np.bool_]]:
    """In how many poses the arm's tip is at places, by the signs of its distance from E less its length as the crank
    turns; and whether that is sure, as no such distance comes near without a change of sign."""
    theta = np.linspace(box.low[0], box.high[0], STEPS + 1)
    a, way = shape.coupler(theta, side)
    pin = a + shape.tip * way
    number, sure = np.zeros(z.size, dtype=int), np.ones(z.size, dtype=bool)
    for k, place in enumerate(z.tolist()):
        off = np.abs(pin - place) - shape.arm
        cross = np.flatnonzero(off[1:] * off[:-1] < 0)
        share = off[cross] / (off[cross] - off[cross + 1])
        first, turn = shape.coupler(theta[cross] + share * (theta[1] - theta[0]), side)
        servo = np.angle((place - first - shape.tip * turn) / turn)
        if box.turns[1]:
            number[k] = cross.size
        else:
            number[k] = ((servo > box.low[1]) & (servo < box.high[1])).sum()
            sure[k] &= bool((np.abs(servo[:, None] - [box.low[1], box.high[1]]) > 1e-3).all())
        turning = (off[1:-1] - off[:-2]) * (off[2:] - off[1:-1]) <= 0
        ends = off[:0] if box.turns[0] else off[[0, -1]]
        sure[k] &= bool((np.abs(np.append(off[1:-1][turning], ends)) > 1e-5).all())
    return number, sure


@cache
def sheet_of(leg: str, side: float) -> ModeSheet:
    return ArmOnCoupler(leg).sheet(side)


def places_of(leg: str, side: float, box: DriveBox) -> ModePlaces:
    return places_on(sheet_of(leg, side), box)


def places_on(sheet: ModeSheet, box: DriveBox) -> ModePlaces:
    found = KnownPoses.of(sheet.compiled, "P")
    assert found is not None
    return ModePlaces(found, sheet, box)


@pytest.mark.parametrize("leg", LEGS)
def test_the_pose_that_leads_to_a_place_is_among_those_that_come_back(leg: str) -> None:
    places = places_of(leg, 1.0, WHOLE)
    assert [one.label for one in places.inverse.triads] and not places.inverse.groups
    q = np.random.default_rng(0).uniform(WHOLE.low, WHOLE.high, (800, 2)).T
    at, reach = places.sheet.place(q)
    q, at = q[:, reach > 0.02], at[:, reach > 0.02]
    values, depth = places.drives(at)
    away = np.abs((values - q + np.pi) % (2 * np.pi) - np.pi).max(axis=1)
    assert ((away < 1e-6) & (depth > 0)).any(axis=0).mean() > 0.995  # but beside folds
    back = [np.hypot(*(places.sheet.place(one)[0] - at)) for one in values]
    assert np.where(depth > 1e-8, back, 0.0).max() < 1e-7


@pytest.mark.parametrize("box", [WHOLE, PART], ids=["whole", "part"])
@pytest.mark.parametrize("side", [1.0, -1.0])
@pytest.mark.parametrize("leg", LEGS)
def test_as_many_poses_as_signs_change(leg: str, side: float, box: DriveBox) -> None:
    places = places_of(leg, side, box)
    z = np.random.default_rng(1).uniform(-1.3, 1.3, 250) + 1j * np.random.default_rng(2).uniform(-1.2, 1.2, 250)
    z += 0.3
    number, sure = poses(ArmOnCoupler(leg), z, box, side)
    found = places.count(np.stack([z.real, z.imag]))
    np.testing.assert_array_equal(found[sure], number[sure])
    assert sure.mean() > 0.95 and number.max() >= (2 if box is WHOLE else 1)


@pytest.mark.parametrize("seed", range(9))
def test_of_any_lengths_each_pose_leads_to_its_place_and_none_is_missed(seed: int) -> None:
    """Signs miss poses near the ends of the coupler's range, so that there may be more than they tell."""
    shape, random = random_arm(seed), np.random.default_rng(seed)
    z = random.uniform(-1.5, 1.8, 80) + 1j * random.uniform(-1.5, 1.5, 80)
    at, places = np.stack([z.real, z.imag]), places_on(shape.sheet(1.0), WHOLE)
    values, depth = places.drives(at)
    real = depth > 0
    for k in range(len(values)):
        back = shape.placed(values[k], 1.0)
        assert (np.abs(back - z)[real[k]] < 1e-9).all()
        for other in range(k):
            both = real[k] & real[other]
            assert (np.abs(np.angle(np.exp(1j * (values[k, 0] - values[other, 0])))[both]) > 1e-7).all()
    number, sure = poses(shape, z, WHOLE, 1.0)
    assert (real.sum(axis=0) >= number)[sure].all() and number.max() > 0


@pytest.mark.parametrize("leg", LEGS)
@pytest.mark.parametrize("size", [3e-2, 3e-3, 1e-4])
def test_sets_hold_all_poses(leg: str, size: float) -> None:
    """Of the poses at random places of cells each lies in a set that may hold one, and sets that must hold one do."""
    places, rng = places_of(leg, 1.0, WHOLE), np.random.default_rng(3)
    count = 60
    at = places.sheet.place(rng.uniform(WHOLE.low, WHOLE.high, (count, 2)).T)[0]
    at = at[:, np.isfinite(at).all(axis=0)]
    half, zero = np.full(at.shape[1], size), np.zeros(at.shape[1])
    sets = places.platforms.over([AffineForm(at[0], half, zero), AffineForm(at[1], zero, half)])
    low, high = sets.rooms[0].bounds
    for u, v in rng.uniform(-1, 1, (5, 2)):
        x, rooms = places.platforms.poses_at(at + size * np.array([[u], [v]]))
        pose, real = x[2:], rooms[0] > 1e-12
        held = np.zeros(sets.of.size, dtype=bool)
        for slot, of in np.argwhere(real):
            mine = np.flatnonzero(sets.of == of)
            off = [
                np.abs(pose[k, slot, of] - form.value - u * form.u - v * form.v)[mine] - form.rest[mine]
                for k, form in enumerate(AffineForm(*form.parts(sets.of.size)) for form in sets.x[2:])
            ]
            inside = (np.max(off, axis=0) < 1e-9) & (high[mine] >= 0)
            assert inside.any()
            held[mine[inside]] = True
        full = np.unique(sets.number[held])
        assert np.isin(sets.number[low > 0], full).all()
    if size < 1e-3:
        assert (low > 0).mean() > 0.8


@pytest.mark.parametrize("leg", LEGS)
def test_forms_hold_the_functions_of_some_set(leg: str) -> None:
    """At a place that is reached some set of its cell has no function that must be negative; where a set's functions
    must all be positive the place is reached."""
    places, rng = places_of(leg, 1.0, PART), np.random.default_rng(4)
    at, half = rng.uniform([[-0.2], [-0.2]], [[1.2], [1.2]], (2, 300)), np.full(300, 4e-3)
    forms, of = places.forms(at, half, np.zeros(300, dtype=int))
    low, high = forms.bounds
    sure, may = np.zeros(300, dtype=bool), np.zeros(300, dtype=bool)
    sure[of[(low > 0).all(axis=0)]] = True
    may[of[~(high < 0).any(axis=0)]] = True
    for u, v in rng.uniform(-1, 1, (6, 2)):
        depth = places.depth(at + half * np.array([[u], [v]]))
        assert may[depth > 1e-12].all() and (depth[sure] > 0).all()
    assert 20 < sure.sum() < may.sum() < 250 and places.kinds[0] == FOLD


def test_a_region_is_enclosed_and_certified(monkeypatch: pytest.MonkeyPatch) -> None:
    """Its area against a raster of places decided by the signs along the coupler's way."""
    monkeypatch.setattr("linkwright.studies.workspace.cells.HEAVY", 8 * HEAVY)
    monkeypatch.setattr("linkwright.studies.workspace.certificate.ROUNDS", 0)
    box, side = DriveBox((0.8, -0.6), (1.6, 0.4), (False, False)), 1.0
    found = enclosed(places_of("PR", side, box), 1e-4)
    assert found is not None and found.certificate.certified
    low, high = found.certificate.area or (0.0, 0.0)
    x0, y0, x1, y1 = found.shape.bounds
    n = 60
    x, y = np.meshgrid(x0 + (np.arange(n) + 0.5) * (x1 - x0) / n, y0 + (np.arange(n) + 0.5) * (y1 - y0) / n)
    number, sure = poses(ArmOnCoupler("PR"), (x + 1j * y).ravel(), box, side)
    import shapely

    inside = shapely.contains_xy(found.shape, x.ravel(), y.ravel())
    np.testing.assert_array_equal(inside[sure], number[sure] > 0)
    assert low <= found.shape.area <= high and high - low < 0.01 * found.shape.area


def test_a_parallelogram_is_left_to_the_search() -> None:
    """Its platform can move with its angle unchanged: the polynomial has a double zero at every place."""
    places = places_on(ArmOnCoupler("RR", crank=0.4, rocker=0.4, length=0.8, base=0.8).sheet(1.0), PART)
    square = _square(places)
    assert square is not None and _vague(places, *square[:2]) and enclosed(places, 1e-4) is None
    regular = places_of("RR", 1.0, PART)
    assert not _vague(regular, *(_square(regular) or ())[:2])


def test_poses_in_no_stretch_are_in_no_whole_one() -> None:
    assert in_whole(np.array([1, -1, 0, 1]), np.array([False, True])).tolist() == [0, 3]
    assert in_whole(np.array([-1, -1]), np.empty(0, dtype=bool)).size == 0
