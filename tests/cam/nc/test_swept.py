"""What a cutter leaves, against closed forms: circles, gouges of large cutters, ways that are gone many times."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest

from linkwright.cam.nc.reader import Move
from linkwright.cam.nc.swept import NothingLeft, Swept, swept
from linkwright.cam.nc.track import Tight, pieces

Place = tuple[float, float]


def circle(radius: float, z: float = -1.0, side: int = 0) -> list[Move]:
    """Counter-clockwise by halves."""
    ends = [(radius, 0.0, z), (-radius, 0.0, z), (radius, 0.0, z)]
    return [Move(k, ends[k], ends[k + 1], (0.0, 0.0), 1, 100.0, side) for k in range(2)]


def lines(*places: Place, z: float = -1.0) -> list[Move]:
    return [Move(k, (*a, z), (*b, z), None, 0, 100.0) for k, (a, b) in enumerate(pairwise(places))]


@pytest.mark.parametrize("cutter", [0.5, 8.0, 100.0])
def test_circles_are_exact(cutter: float) -> None:
    """GEOS alone is off by some 1e-5 of the cutter."""
    whole, again = swept(circle(1.5 * cutter), cutter)
    assert again is whole
    assert np.abs(np.hypot(*whole.inner) - 0.5 * cutter).max() < 1e-10
    assert np.abs(np.hypot(*whole.outer) - 2.5 * cutter).max() < 1e-10


def test_corners_of_the_way() -> None:
    """Around a square: straight sides inside, where the corner stays; round corners outside."""
    one = swept(lines((-30, -30), (30, -30), (30, 30), (-30, 30), (-30, -30)), 10.0)[0]
    assert np.abs(np.abs(one.inner).max(axis=0) - 20.0).max() < 1e-10
    x, y = np.abs(one.outer)
    away = np.where((x > 30) & (y > 30), np.hypot(x - 30, y - 30), np.maximum(x, y) - 30)
    assert np.abs(away - 10.0).max() < 1e-10


def test_a_compensated_way() -> None:
    assert np.abs(np.hypot(*swept(circle(30.0, side=-1), 5.0)[0].inner) - 30.0).max() < 1e-10
    with pytest.raises(Tight):
        swept(circle(5.0, side=1), 5.0)


@pytest.mark.parametrize("deep", [1e-4, 1.0])
def test_gouges_of_a_large_cutter_are_seen(deep: float) -> None:
    """On a circle of 600 mm radius the cutter of 200 mm dips inward over a short straight way."""
    angle = 0.01
    a, b = (600 * np.array([math.cos(s * angle), math.sin(s * angle)]) for s in (-1, 1))
    dip = (600.0 - deep, 0.0)
    ring = [Move(0, (*b, -1.0), (*a, -1.0), (0.0, 0.0), 1, 100.0), *lines(tuple(a), dip, tuple(b))]
    way = np.stack([a, np.array(dip)])  # the centre of the cam is as near to the contour as to the way, less the cutter
    share = np.clip(-(way[0] @ (way[1] - way[0])) / ((way[1] - way[0]) ** 2).sum(), 0, 1)
    nearest = np.hypot(*(way[0] + share * (way[1] - way[0])))
    assert nearest < 600 - 0.9 * deep
    assert np.hypot(*swept(ring, 200.0)[0].inner).min() == pytest.approx(nearest - 200, abs=1e-7)


def test_what_is_gone_again_is_swept_once() -> None:
    many = [move for k in range(1, 201) for move in circle(30.0, -0.1 * k)]
    assert len(pieces(many, 5.0)) == 2
    lowest, every = swept(many, 5.0)
    assert every is lowest


def test_a_motion_that_enters_on_its_way_counts() -> None:
    """A ramp from above cuts where it has got into the blank; it isn't of the deepest level."""
    ramp = Move(9, (30.0, 0.0, 1.0), (0.5, 40.0, -2.0), None, 0, 100.0)
    lowest, every = swept([*circle(30.0, -2.0), ramp], 5.0)
    assert np.hypot(*lowest.outer).max() == pytest.approx(35.0)
    assert np.hypot(*every.outer).max() == pytest.approx(math.hypot(0.5, 40.0) + 5.0)


def test_islands_and_strays() -> None:
    """Two circles whose bands don't touch, but for a bridge between them; a place beside the circle."""
    bridge = lines((30.0, 0.0), (50.0, 0.0))
    one = Swept(tuple(pieces([*circle(30.0), *bridge, *circle(50.0)], 8.0)), 8.0)
    (island,) = one.islands
    assert 38 < np.hypot(*island) < 42
    assert not list(swept([*circle(30.0), *bridge, *circle(45.0)], 8.0)[0].islands)
    (stray,) = swept([*circle(30.0), *lines((0.0, 1.0), (0.0, 2.0))], 5.0)[0].strays
    assert stray[1].max() == pytest.approx(7.0)
    with pytest.raises(NothingLeft):
        _ = swept(lines((10.0, 0.0), (20.0, 0.0)), 5.0)[0].inner
