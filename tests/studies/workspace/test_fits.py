"""Required figures in a region, and the largest that fit, against closed forms of convex shapes and of rings."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from linkwright.studies.workspace.fits import circle_fits, largest_circle, largest_rectangle, rectangle_fits

FACETS = 512
DISC = shapely.Point(0.3, -0.2).buffer(0.5, quad_segs=FACETS)
RING = shapely.Point(0, 0).buffer(1.0, quad_segs=FACETS) - shapely.Point(0, 0).buffer(0.4, quad_segs=FACETS)
TRIANGLE = shapely.Polygon([(0, 0), (4, 0), (0, 3)])


@pytest.mark.parametrize("aspect", [1.0, 2.5])
def test_largest_rectangles_of_convex_shapes(aspect: float) -> None:
    """Base 4 and height 3 of a right triangle: w / 4 + h / 3 = 1. A disc: the diagonal is its diameter."""
    found = largest_rectangle(TRIANGLE, aspect, 0.0)
    assert found is not None
    exact = 1 / (1 / 4 + 1 / (3 * aspect))
    assert found.width <= exact * (1 + 1e-12) <= found.at_most * (1 + 1e-9)
    assert found.width == pytest.approx(exact, rel=2e-4)
    assert found.centre == pytest.approx((exact / 2, exact / aspect / 2), abs=2e-3)
    round_ = largest_rectangle(DISC, aspect, 0.7)
    assert round_ is not None
    exact = aspect / np.hypot(1.0, aspect)
    assert round_.width <= exact <= round_.at_most + 1e-5
    assert round_.width == pytest.approx(exact, rel=2e-4)


def test_a_turned_rectangle_holds_itself() -> None:
    angle, size = 0.4, np.array([0.8, 0.3])
    c, s = np.cos(angle), np.sin(angle)
    corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * size / 2 @ np.array([[c, s], [-s, c]]) + [2.0, 1.0]
    found = largest_rectangle(shapely.Polygon(corners), size[0] / size[1], angle)
    assert found is not None
    assert (found.width, found.height) == pytest.approx(tuple(size), rel=3e-4)
    assert found.centre == pytest.approx((2.0, 1.0), abs=3e-4)
    long = largest_rectangle(shapely.Polygon(corners), 1.0, angle)
    assert long is not None  # the centres of the best squares are a whole line
    assert long.width == pytest.approx(0.3, rel=1e-6)


def test_squares_in_a_ring() -> None:
    """Beside the hole: the upright square whose one side touches it and whose two far corners lie on the rim,
    (0.4 + w)² + (w / 2)² = 1, or the one on the diagonal, a corner on the rim, two sides' neighbours at the hole."""
    found = largest_rectangle(RING, 1.0, 0.0)
    assert found is not None
    beside = max(np.roots([1.25, 0.8, 0.16 - 1.0]).real)
    diagonal = np.sqrt(0.5) * (1.0 - 0.4)
    assert found.width == pytest.approx(max(beside, diagonal), rel=5e-4)
    assert found.at_most - found.width < 2.1e-4


def test_largest_circles() -> None:
    found = largest_circle(TRIANGLE)
    assert found is not None
    assert found.radius == pytest.approx(1.0, rel=2e-4)
    assert found.centre == pytest.approx((1.0, 1.0), abs=1e-3)
    ring = largest_circle(RING)
    assert ring is not None
    assert ring.radius == pytest.approx(0.3, abs=2e-4)
    assert ring.radius <= 0.3 <= ring.at_most
    assert largest_circle(shapely.Polygon()) is None
    assert largest_rectangle(shapely.Polygon(), 1.0, 0.0) is None
    assert circle_fits(shapely.Polygon(), 1.0) is None
    assert rectangle_fits(shapely.Polygon(), 1.0, 1.0) is None


def test_by_how_much_figures_fit_or_miss() -> None:
    fit = circle_fits(RING, 0.2, (0.7, 0.0))
    assert fit is not None
    assert (fit.fits, fit.outside) == (True, 0.0)
    assert (fit.margin, fit.scale) == pytest.approx((0.1, 1.5), rel=1e-3)
    over = circle_fits(RING, 0.5, (0.7, 0.0))
    assert over is not None
    assert not over.fits
    assert (over.margin, over.scale) == pytest.approx((-0.2, 0.6), rel=2e-3)  # 0.2 over the rim, as deep in the hole
    around = circle_fits(RING, 0.6, (0.0, 0.0))
    assert around is not None
    assert (around.fits, around.scale) == (False, 0.0)
    assert around.margin == pytest.approx(-0.4, rel=1e-3)  # the middle of the hole
    assert around.outside == pytest.approx(0.4**2 / 0.6**2, rel=1e-3)


def test_by_how_much_rectangles_fit_or_miss() -> None:
    fit = rectangle_fits(TRIANGLE, 1.0, 0.5, centre=(1.0, 1.0))
    assert fit is not None
    assert fit.fits
    assert fit.margin == pytest.approx((12 - 3 * 1.5 - 4 * 1.25) / 5)  # the corner (1.5, 1.25) to 3x + 4y = 12
    assert fit.scale == pytest.approx(1 + 2.5 / 2.5)
    miss = rectangle_fits(TRIANGLE, 2.0, 1.0, angle=np.pi / 2, centre=(0.25, 1.0))
    assert miss is not None
    assert not miss.fits
    assert miss.margin == pytest.approx(-0.25)
    assert miss.scale == pytest.approx(0.5)
    assert miss.outside == pytest.approx(0.25)
    anywhere = rectangle_fits(TRIANGLE, 2.0, 1.0)
    assert anywhere is not None
    assert anywhere.fits
    assert anywhere.scale == pytest.approx(1 / (2 / 4 + 1 / 3), rel=1e-3)


def test_a_disc_that_hardly_misses_takes_few_places(monkeypatch: pytest.MonkeyPatch) -> None:
    """Cells deep within a region are left out at once: by the outside distance alone there were over a million."""
    tried = []
    points = shapely.points
    monkeypatch.setattr(shapely, "points", lambda at: tried.append(len(at)) or points(at))
    fit = circle_fits(shapely.Point(0.0, 0.0).buffer(1.0, quad_segs=64), 1.0005, (0.0, 0.0))
    assert fit is not None
    assert not fit.fits
    assert fit.margin == pytest.approx(-(1.0005 - np.cos(np.pi / 256)), rel=2e-3)
    assert sum(tried) < 200_000
