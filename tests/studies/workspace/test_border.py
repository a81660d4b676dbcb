"""Edges traced of regions made up of discs and half planes, whose perimeters and areas are known."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely
from numpy.typing import NDArray

from linkwright.studies.workspace.border import border, polygons, triangulated
from linkwright.studies.workspace.cells import Cells
from linkwright.studies.workspace.curves import distance
from studies.workspace.made_up import Depth, above, both, coarser, disc, edge_cells, either, without

Array = NDArray[np.float64]
CHORD = 1e-5
TURN = 2 * math.pi


def square(half: float, tilt: float) -> Depth:
    ways = [tilt + k * math.pi / 2 for k in range(4)]
    return both(*(above((half * math.sin(way), -half * math.cos(way)), way) for way in ways))


def wedge(angle: float, long: float) -> Depth:
    """Two lines from (-1, 0.1) at an angle to each other, closed by an arc."""
    tip = (-1.0, 0.1)
    return both(above(tip, 0.2), above(tip, 0.2 + angle + math.pi), disc(*tip, long))


TEN = math.radians(10)
SHAPES: dict[str, tuple[Depth, float, float, int, int]] = {  # depth; area, perimeter, parts, holes
    "disc": (disc(0.1, 0.2, 1.3), math.pi * 1.69, TURN * 1.3, 1, 0),
    "square": (square(1.0, 0.3), 4.0, 8.0, 1, 0),
    "square along the cells": (square(1.0, 0.0), 4.0, 8.0, 1, 0),
    "ring": (without(disc(0, 0, 1.5), disc(0.1, 0, 0.7)), math.pi * (2.25 - 0.49), TURN * 2.2, 1, 1),
    "wedge": (wedge(TEN, 2.4), TEN / 2 * 2.4**2, 2.4 * (2 + TEN), 1, 0),
    "two discs": (either(disc(-0.9, 0, 0.6), disc(0.9, 0.3, 0.5)), math.pi * 0.61, TURN * 1.1, 2, 0),
}


def found(depth: Depth, cells: Cells) -> tuple[Array, Array, float]:
    """The pieces, once it is seen that they are those of closed rings."""
    a, b, off = border(depth, cells, CHORD)
    ends, count = np.unique(np.concatenate([a, b], axis=1), axis=1, return_counts=True)
    assert ends.shape[1] == a.shape[1] and (count == 2).all()
    return a, b, float(off.max(initial=0.0))


@pytest.mark.parametrize("cut", [False, True], ids=["alike", "two sizes"])
@pytest.mark.parametrize("name", SHAPES)
def test_shapes_are_drawn_within_the_chord_tolerance(name: str, cut: bool) -> None:
    depth, area, perimeter, parts, holes = SHAPES[name]
    cells = edge_cells(depth, 7)
    a, b, off = found(depth, coarser(cells, 0.3) if cut else cells)
    assert off <= (8 if name != "wedge" else 32) * CHORD  # the wedge's tip, between large cells
    shape = polygons(depth, a, b, CHORD)
    polygon = shapely.get_parts(shape)
    assert len(polygon) == parts and sum(len(one.interiors) for one in polygon) == holes
    # The edge is drawn to the tolerance, then made simpler to it; but for corners, where it may be off by more.
    assert shape.area == pytest.approx(area, abs=2 * CHORD * perimeter + 16 * CHORD**2)
    assert shape.length == pytest.approx(perimeter, rel=1e-3, abs=0.05 * CHORD / math.sin(TEN / 2))
    corners = shapely.get_coordinates(shape.boundary).T
    assert np.abs(depth(corners)).max() < max(2 * CHORD, off)


@pytest.mark.parametrize("name", SHAPES)
def test_pieces_hug_the_edge(name: str) -> None:
    """Their middles lie within the chord tolerance of it, but for a few at corners, within what is said."""
    depth = SHAPES[name][0]
    a, b, off = found(depth, edge_cells(depth, 6))
    away = np.abs(depth((a + b) / 2))
    assert (away > 1.1 * CHORD).sum() <= 16
    assert away.max() <= max(CHORD, off) * 1.1


def test_discs_that_touch_are_two() -> None:
    """Where they touch the edge is ambiguous, but the area isn't, nor where all else is."""
    depth = either(disc(-0.6, 0, 0.6), disc(0.6, 0, 0.6))
    a, b, _ = found(depth, edge_cells(depth, 7))
    shape = polygons(depth, a, b, CHORD)
    expected = shapely.union(shapely.Point(-0.6, 0).buffer(0.6, 512), shapely.Point(0.6, 0).buffer(0.6, 512))
    assert shape.area == pytest.approx(2 * math.pi * 0.36, rel=2e-4)
    assert shape.symmetric_difference(expected).area < 1e-3
    assert shapely.hausdorff_distance(shape, expected) < 0.02


def test_more_of_a_wedges_tip_is_drawn_than_a_cell() -> None:
    depth = SHAPES["wedge"][0]
    a, b, _ = found(depth, edge_cells(depth, 5))
    tip = np.array([[-1.0], [0.1]])
    assert np.hypot(*(np.concatenate([a, b], axis=1) - tip)).min() < 200 * CHORD < 4.1 / 2**5 / 10


def test_no_cells_have_no_edge() -> None:
    depth = disc(0, 0, 1)
    a, b, off = border(depth, edge_cells(depth).subset(slice(0, 0)), CHORD)
    assert a.shape == b.shape == (2, 0) and off.size == 0
    assert polygons(depth, a, b, CHORD).is_empty


def test_cells_are_cut_into_triangles_that_share_their_sides() -> None:
    """Of a large cell beside four small ones: all of them are covered once, and inner sides belong to two triangles."""
    number = np.array([[0, 2, 3, 2, 3], [0, 0, 0, 1, 1]])
    corners, triangles, cell = triangulated(Cells(np.zeros(2), 8.0, number, np.array([2, 3, 3, 3, 3])))
    x, y = corners[:, triangles]
    area = np.abs((x[:, 1] - x[:, 0]) * (y[:, 2] - y[:, 0]) - (x[:, 2] - x[:, 0]) * (y[:, 1] - y[:, 0])) / 2
    assert area.sum() == pytest.approx(8)
    assert np.bincount(cell, weights=area).tolist() == pytest.approx([4, 1, 1, 1, 1])
    assert np.bincount(cell).tolist() == [5, 4, 4, 4, 4]
    sides = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    _, count = np.unique(sides, axis=0, return_counts=True)
    assert {*count.tolist()} <= {1, 2} and (count == 1).sum() == 3 + 2 * 2 + 2


def test_how_far_places_lie_from_pieces() -> None:
    a, b = np.array([[0.0], [0.0]]), np.array([[2.0], [0.0]])
    at = np.array([[1.0], [0.5]])
    assert distance(at, a, b) == pytest.approx([0.5])
