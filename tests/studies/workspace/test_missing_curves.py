"""Curves that a mesh misses, found again from the poses turned round."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from numpy.typing import NDArray

from helpers.reach import FiveBar
from linkwright.studies.workspace.curves import Segments
from linkwright.studies.workspace.missing_curves import missed, missed_anywhere
from linkwright.studies.workspace.pose_counts import DrivePaths, contradiction
from linkwright.studies.workspace.region_enclosure import _rings, _square
from studies.workspace.made_up import CHORD, Drawn, drawn

Array = NDArray[np.float64]
BAR = FiveBar(18.0, 30.0, 27.0, 20.0, 22.0, 14.0, 0.7, motor=(0.5, 3.0), servo=(-1.0, 2.5))


@pytest.fixture(scope="module")
def one() -> Drawn:
    return drawn(BAR)


def ends(one: Drawn, segments: list[Segments]) -> Array:
    some = DrivePaths.of(one.places.sheet, segments)
    return np.stack([some.a, some.b]).transpose(2, 0, 1)


def away(some: Array, others: Array) -> Array:
    """How far (m) the middles of pieces are from others."""
    lines = shapely.multilinestrings(shapely.linestrings(others))
    return np.asarray(shapely.distance(lines, shapely.points(some.mean(axis=1))))


def apart(some: Array, others: Array) -> float:
    """How far they are at most."""
    return float(away(some, others).max())


def length(some: Array) -> float:
    """The length (m) of all pieces."""
    return float(np.hypot(*(some[:, 1] - some[:, 0]).T).sum())


@pytest.mark.parametrize("kind", ["singular", "modes", "limit"])
def test_all_of_a_kind_are_found_again(one: Drawn, kind: str) -> None:
    kept, gone = ([some for some in one.segments if (some.kind == kind) == which] for which in (False, True))
    square = _square(one.places)
    assert square is not None
    found = missed_anywhere(one.places, square, kept, CHORD)
    again = [some for some in found if some.kind == kind]
    # A curve where two modes meet is drawn where the mechanism just closes, some chords within the true one.
    lost = ends(one, gone)[away(ends(one, gone), ends(one, again)) > 40 * CHORD]
    assert length(lost) < 0.01 * length(ends(one, gone))
    assert np.median(away(ends(one, again), ends(one, gone))) < CHORD
    # Where curves touch, pieces may be taken for another kind: of others few are found though they are there.
    assert length(ends(one, found)) - length(ends(one, again)) < 0.05 * length(ends(one, kept))
    assert contradiction(one.places, DrivePaths.of(one.places.sheet, [*kept, *found]), CHORD) is None


def test_folds_are_where_the_jacobian_is_singular(one: Drawn) -> None:
    """The drives' values beside a fold change as a root of the way; those of both poses that meet there have the
    fold's for their mean."""
    square = _square(one.places)
    assert square is not None
    kept = [some for some in one.segments if some.kind != "singular"]
    found = missed_anywhere(one.places, square, kept, CHORD)
    here = one.places.sheet.look(np.concatenate([some.a for some in found], axis=1))
    size = np.abs(here.jacobian).max(axis=(0, 1)) ** 2
    assert np.median(np.abs(here.determinant) / size) < 1e-4  # 8e-4 at the values of one pose
    assert (np.abs(here.determinant) < 1e-2 * size).mean() > 0.99


def test_a_regions_edge_is_found_again(one: Drawn) -> None:
    edge = _rings(one.shape)
    square = _square(one.places)
    assert square is not None
    assert missed(one.places, edge, square[2], one.segments, CHORD) == []
    found = missed(one.places, edge, square[2], [], CHORD)
    a, b, _ = edge
    assert apart(ends(one, found), np.stack([a, b]).transpose(2, 0, 1)) < 5 * CHORD
    assert length(ends(one, found)) == pytest.approx(one.shape.length, rel=1e-2)
