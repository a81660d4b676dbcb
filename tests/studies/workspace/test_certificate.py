"""Shapes that are right have no fault; wrong ones are told by what is wrong with them."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import shapely
from numpy.typing import NDArray

from helpers.reach import Guide, TwoCylinders
from helpers.reach.circles import TURN
from linkwright.studies.workspace.border import border, polygons
from linkwright.studies.workspace.cells import Decided
from linkwright.studies.workspace.certificate import ENCLOSED, SEARCHED, Contradiction, RegionCertificate, certified
from linkwright.studies.workspace.places import ModePlaces
from studies.workspace.made_up import MM, decided_of, places_of

Array = NDArray[np.float64]
CHORD = 2e-7
RING = Guide(0.0, 0j, None, (20.0, 60.0))


class Known:
    """What a mechanism reaches, drawn."""

    def __init__(self, places: ModePlaces) -> None:
        self.places, self.decided = places, decided_of(places)
        a, b, _ = border(places.depth, self.decided.edge, CHORD)
        self.shape = polygons(places.depth, a, b, CHORD)

    def told(self, shape: Any, decided: Decided | None = None, places: ModePlaces | None = None) -> RegionCertificate:
        return certified(places or self.places, decided or self.decided, shape, CHORD)

    def kinds(self, shape: Any) -> set[str]:
        found = self.told(shape)
        assert not found.certified
        return {fault.kind for fault in found.faults}


@pytest.fixture(scope="module")
def ring() -> Known:
    """A turning guide with a slide on it: between 20 and 60 mm about the origin."""
    return Known(places_of(RING, 0))


@pytest.fixture(scope="module")
def two_parts() -> Known:
    """A slide that gets 20 mm behind its guide's foot and 30 mm before it, which turns by little: two sectors."""
    return Known(places_of(Guide(2.0, 0j, (-0.5, 0.5), (-20.0, 30.0)), 0))


def test_a_right_shape_has_no_fault(ring: Known) -> None:
    found = ring.told(ring.shape)
    area = math.pi * (60**2 - 20**2) * MM**2
    assert found.certified and found.grade == ENCLOSED and found.faults == ()
    assert found.area is not None and found.area[0] <= area <= found.area[1]
    assert found.open == pytest.approx(found.area[1] - found.area[0]) and found.open < 1e-3 * area
    assert found.parts and found.holes
    assert 0 < found.finest < 1e-7


def test_an_exact_circle_has_none_either(ring: Known) -> None:
    """Drawn by other means, with corners of its own."""
    circles = [shapely.Point(0, 0).buffer(radius * MM, 1000) for radius in (60, 20)]
    assert ring.told(circles[0].difference(circles[1])).certified


def test_a_hole_that_is_filled(ring: Known) -> None:
    kinds = ring.kinds(shapely.Polygon(ring.shape.exterior))
    assert {"too-much", "area"} <= kinds and "left-out" not in kinds
    found = ring.told(shapely.Polygon(ring.shape.exterior))
    assert not found.holes and found.parts
    fault = next(one for one in found.faults if one.kind == "too-much")
    assert fault.size == pytest.approx(math.pi * 20**2 * MM**2, rel=0.05)
    assert math.hypot(*fault.at) < 20 * MM


def test_a_hole_that_is_none(ring: Known) -> None:
    extra = ring.shape.difference(shapely.Point(40 * MM, 0).buffer(5 * MM))
    found = ring.told(extra)
    assert {fault.kind for fault in found.faults} >= {"left-out", "area", "edge"}
    assert found.parts and not found.holes
    fault = next(one for one in found.faults if one.kind == "left-out")
    assert math.dist(fault.at, (40 * MM, 0)) < 6 * MM


def test_a_part_that_is_missing(ring: Known) -> None:
    half = ring.shape.intersection(shapely.segmentize(shapely.box(-1, 0, 1, 1), 1e-3))
    assert {"left-out", "area", "edge"} <= ring.kinds(half)


def test_a_part_too_many(ring: Known) -> None:
    more = ring.shape.union(shapely.box(0.061, 0.001, 0.066, 0.006))
    found = ring.told(more)
    assert "too-much" in {fault.kind for fault in found.faults} and not found.parts and found.holes


def test_an_edge_that_is_shifted(ring: Known) -> None:
    """By half of the smallest cells: some decided ones beside the edge are on its other side."""
    off = ring.decided.open.size.min() / 2
    assert "edge" in ring.kinds(shapely.transform(ring.shape, lambda at: at + np.array([off, 0])))
    moved = shapely.transform(ring.shape, lambda at: at + np.array([2 * off, 0]))
    assert {"left-out", "too-much"} <= ring.kinds(moved)
    assert ring.told(shapely.transform(ring.shape, lambda at: at + np.array([CHORD / 2, 0]))).certified


def test_an_edge_through_cells_that_are_decided(ring: Known) -> None:
    """A cut into the ring as narrow as half a millimetre, its corners in cells on its way."""
    cut = shapely.segmentize(shapely.box(0.03, -0.00025, 0.07, 0.00025), 1e-4)
    found = ring.told(ring.shape.difference(cut))
    fault = next(one for one in found.faults if one.kind == "edge")
    assert fault.size > 10 and 0.02 < fault.at[0] < 0.06 and abs(fault.at[1]) < 0.001


def test_an_area_that_is_off(ring: Known) -> None:
    """Larger by a hundredth all round."""
    assert "area" in ring.kinds(shapely.transform(ring.shape, lambda at: at * 1.01))


def test_much_that_is_open(ring: Known) -> None:
    decided = ring.decided
    open_ = replace(decided, least=np.zeros_like(decided.least), most=np.ones_like(decided.most))
    every = {fault.kind for fault in ring.told(ring.shape, open_).faults}
    low, high = open_.area
    assert ("open" in every) == (high - low > 0.01 * ring.shape.area)
    # As if cells of the ring itself had stayed open.
    some = decided.reached.level == decided.reached.level.min()
    less = replace(decided, reached=decided.reached.subset(~some), most=decided.most + 1.0)
    assert "open" in {fault.kind for fault in ring.told(ring.shape, less).faults}


def test_poses_that_do_not_lead_back(ring: Known) -> None:
    class Wrong(ModePlaces):
        """Its inverse is off by a thousandth of a radian."""

        def drives(self, at: Array) -> tuple[Array, Array]:
            values, depths = super().drives(at)
            return values + np.array([1e-3, 0.0])[:, None], depths

    places = Wrong(ring.places.poses, ring.places.sheet, ring.places.box)
    found = ring.told(ring.shape, places=places)
    (fault,) = found.faults
    assert fault.kind == "back" and fault.size > 0.9
    assert 0.02 < math.hypot(*fault.at) < 0.06


def test_only_what_is_enclosed_without_fault_is_certified() -> None:
    fault = Contradiction("edge", 1.0, (0.0, 0.0))
    assert RegionCertificate(ENCLOSED, (1.0, 2.0)).certified
    assert not RegionCertificate(ENCLOSED, (1.0, 2.0), faults=(fault,)).certified
    assert not RegionCertificate(SEARCHED).certified and RegionCertificate(SEARCHED).open is None


def sector(angles: tuple[float, float], radii: tuple[float, float]) -> Any:
    """Between two angles and two radii (mm)."""
    way = np.linspace(*angles, 400)
    outer, inner = (radius * MM * np.stack([np.cos(way), np.sin(way)], axis=1) for radius in radii[::-1])
    return shapely.Polygon([*outer, *inner[::-1]])


def test_two_sectors_that_meet_in_their_feet_only() -> None:
    """A slide through the foot of its guide: where both sectors touch it isn't told whether they are one part."""
    known = Known(places_of(Guide(0.0, 0j, (-0.5, 0.5), (-20.0, 30.0)), 0))
    found = known.told(known.shape)
    assert found.area is not None
    expected = (30**2 + 20**2) / 2 * MM**2
    assert found.area[0] <= expected <= found.area[1]
    assert not found.parts


def test_two_parts_are_counted() -> None:
    """Cylinders of which one gets short: above the base a lens of two rings is cut into two."""
    mechanism = TwoCylinders(50.0, (20.0, 60.0), (20.0, 60.0))
    known = Known(places_of(mechanism, 0))
    parts = len(shapely.get_parts(known.shape))
    found = known.told(known.shape)
    assert found.certified and found.parts and found.holes
    assert not known.told(shapely.union(known.shape, shapely.box(0.2, 0.2, 0.21, 0.21))).parts
    z = np.random.default_rng(0).uniform(-60, 110, (40_000, 2)) @ [1, 1j]
    truth = mechanism.reached(z) & 1 == 1
    inside = shapely.contains_xy(known.shape, z.real * MM, z.imag * MM)
    assert (inside != truth).sum() == 0 and parts >= 1


def necked(gap: float) -> Known:
    """A slide that gets past the foot of a guide so far (mm) aside, which turns by half a radian to either way."""
    return Known(places_of(Guide(gap, 0j, (math.pi / 2 - 0.5, math.pi / 2 + 0.5), (-20.0, 30.0)), 0))


def test_a_narrow_neck_joins_two_parts() -> None:
    """Between a circle of the gap's radius and where the guide's outermost lines cross: 0.07 mm of 50."""
    known = necked(0.5)
    found = known.told(known.shape)
    assert found.certified and found.parts and found.holes
    assert len(shapely.get_parts(known.shape)) == 1
    crossing = 0.5 / math.cos(0.5)
    neck = shapely.Point(-crossing * MM, 0).buffer(0.1 * MM)
    apart = known.shape.difference(neck)
    assert len(shapely.get_parts(apart)) == 2
    assert not known.told(apart).parts


@pytest.mark.parametrize("gap", [0.1, 0.02, 0.01])
def test_of_a_neck_that_is_narrower_no_other_count_is_certified(gap: float) -> None:
    known = necked(gap)
    found = known.told(known.shape)
    assert found.certified
    assert not found.parts or len(shapely.get_parts(known.shape)) == 1


def test_a_ring_that_is_cut_is_no_ring() -> None:
    """All but a degree of the turn: no hole; with the whole turn there is one."""
    cut = Known(places_of(Guide(0.0, 0j, (0.3, 0.3 + TURN - math.radians(1)), (20.0, 60.0)), 0))
    found = cut.told(cut.shape)
    assert found.certified and found.parts and found.holes
    assert len(shapely.get_parts(cut.shape)) == 1 and not cut.shape.interiors
    closed = shapely.Polygon(cut.shape.exterior).union(sector((0.3 - math.radians(1.1), 0.31), (20, 60)))
    assert closed.interiors
    assert not cut.told(closed).holes and not cut.told(closed).certified
