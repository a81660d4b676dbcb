"""The workspace of the five-bar of Peng Liping and Zi Bin, Journal of Mechanical Transmission 34(4), 2010, 20-23.

Crank O1-B (l1), couplers B-C (l2) and D-C (l3), crank O4-D (l4), frame (l5); P on the link D-C, r2 from D, at -alpha
to it. The paper draws the region for alpha = 0, 60, 90 and 180 deg and prints no areas. Here they come from its
equations turned round: P and the branch give D, D and the link give C, C gives B, each where its triangle closes, and
the side of B-D on which C lies tells the assembly mode. Lines x = const are cut at the ends of their reached pieces by
bisection, and their lengths summed up: no curve, no drive value, and nothing of linkwright takes part in that.

Tolerances: a line's length grows like a root where the edge is upright, so that sums over n lines converge with
n^-1.5, unevenly: 3000 lines are off by no more than 0.01 mm2 here, 12 000 by 1.2e-3 mm2. The areas in ``AREAS`` are
those of the product with chords of 3e-7 mm, from which 12 000 lines differ by that. The drawn edge lies within the
chord of 3e-5 mm, so that the drawn area is off by no more than that times the perimeter (72 to 177 mm).
"""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely
from numpy.typing import NDArray

import linkwright as lw
from linkwright.studies.workspace.outcome import Workspace

EXAMPLE = Path(__file__).parents[2] / "examples" / "five_bar_workspace.yaml"
L1, L2, L3, L4, L5, R2 = 8.0, 26.0, 28.0, 10.0, 30.0, 20.0
MM2 = 1e6
LINES = 0.015
"""By so much (mm2) the areas from 3000 lines may be off."""
CLOSE = 1.5e-3
"""By so much (mm2) those in the table."""
AREAS = {0: (344.1375, 344.1375), 60: (508.5566, 389.9452), 90: (528.6021, 464.5807), 180: (500.1548, 500.1548)}
BOTH = {0: 0.0, 60: 0.0, 90: 2.1886, 180: 96.8617}
HOLE = 292.781
"""Of either hole at 180 deg (mm2)."""
Mask = NDArray[np.bool_]


def reached(x: Any, y: Any, alpha: float) -> tuple[Mask, Mask]:
    """Whether P gets to places (mm) with C left of B-D, and right of it."""
    p, left, right = x + 1j * y, np.zeros(np.shape(x), bool), np.zeros(np.shape(x), bool)
    with np.errstate(invalid="ignore", divide="ignore"):
        for first in (1, -1):
            to = p - L5  # O4-D-P: the triangle of l4, r2 and the distance of P
            share = (L4**2 - R2**2 + abs(to) ** 2) / (2 * abs(to) ** 2)
            d = L5 + to * (share + 1j * first * np.sqrt((L4 / abs(to)) ** 2 - share**2))
            c = d + (p - d) / R2 * L3 * np.exp(1j * np.radians(alpha))
            for second in (1, -1):
                share = (L1**2 - L2**2 + abs(c) ** 2) / (2 * abs(c) ** 2)  # O1-B-C
                b = c * (share + 1j * second * np.sqrt((L1 / abs(c)) ** 2 - share**2))
                side = ((d - b).conj() * (c - b)).imag
                left, right = left | (side > 0), right | (side < 0)
    return left, right


@cache
def areas(alpha: float, lines: int = 3000) -> tuple[float, ...]:
    """Areas (mm2) that the left mode, the right one and both reach, by lines x = const."""
    x, step = np.linspace(-1, L5 + L4 + R2 + 1, lines, endpoint=False, retstep=True)
    x = x + step / 2
    y = np.linspace(-L4 - R2 - 1, L4 + R2 + 1, 1201)
    return tuple(_summed(inside, x, y, alpha, k) * step for k, inside in enumerate(modes(x[:, None], y[None], alpha)))


def modes(x: Any, y: Any, alpha: float) -> tuple[Mask, Mask, Mask]:
    """Whether P gets to places with C left of B-D, right of it, and in both ways."""
    left, right = reached(x, y, alpha)
    return left, right, left & right


def _summed(inside: Mask, x: Any, y: Any, alpha: float, which: int) -> float:
    """The lengths of the reached pieces of all lines, their ends by bisection between the places y looked at."""
    line, cell = np.nonzero(inside[:, 1:] != inside[:, :-1])
    start, stop, rises = y[cell], y[cell + 1], inside[line, cell + 1]
    for _ in range(40):
        middle = (start + stop) / 2
        after = modes(x[line], middle, alpha)[which] == rises
        start, stop = np.where(after, start, middle), np.where(after, middle, stop)
    return float((np.where(rises, -1.0, 1.0) * stop).sum())


@pytest.fixture(scope="module")
def found() -> dict[int, Workspace]:
    """The example's four workspaces, without what else it asks for."""
    nothing_else = dict.fromkeys(("trajectories", "quality", "errors"))
    outcome = lw.workspace(EXAMPLE, options=nothing_else)
    assert not outcome.failures and not outcome.warnings
    return {round(np.degrees(one.values["alpha"])): one for one in outcome.workspaces}


@pytest.mark.parametrize("alpha", AREAS)
def test_the_table_holds_what_the_lines_find(alpha: int) -> None:
    assert areas(alpha) == pytest.approx((*AREAS[alpha], BOTH[alpha]), abs=LINES)


@pytest.mark.parametrize("alpha", AREAS)
def test_areas_parts_and_holes_of_both_modes_are_certified(found: dict[int, Workspace], alpha: int) -> None:
    holes = {0: (0, 0), 60: (1, 0), 90: (1, 1), 180: (1, 1)}[alpha]
    for one, area, count in zip(found[alpha].regions, AREAS[alpha], holes, strict=True):
        drawn, proven = one.figures, one.region.certificate
        assert proven.area is not None and proven.certified and proven.parts and proven.holes
        assert (drawn.parts, drawn.holes) == (1, count)
        assert drawn.area * MM2 == pytest.approx(area, abs=3e-5 * drawn.perimeter * 1e3 + CLOSE)
        low, high = (bound * MM2 for bound in proven.area)
        assert low - CLOSE < area < high + CLOSE and high - low < 6e-4 * area


@pytest.mark.parametrize(("alpha", "independent"), [(0, True), (60, True), (90, False), (180, False)])
def test_the_two_regions_are_independent_at_two_of_the_four_angles(
    found: dict[int, Workspace], alpha: int, independent: bool
) -> None:
    """The paper calls them so without exception; at 90 and 180 deg both modes reach some places."""
    (overlap,) = found[alpha].overlaps
    assert overlap.shape.is_empty == independent
    assert overlap.shape.area * MM2 == pytest.approx(BOTH[alpha], abs=3e-5 * overlap.shape.length * 1e3 + CLOSE)


@pytest.mark.parametrize("alpha", [0, 180])
def test_the_regions_mirror_each_other_where_p_lies_on_the_line_of_its_link(
    found: dict[int, Workspace], alpha: int
) -> None:
    one, other = (region.shape for region in found[alpha].regions)
    mirrored = shapely.transform(other, lambda at: at * (1, -1))
    assert shapely.hausdorff_distance(one.boundary, mirrored.boundary) < 1e-4 * one.length
    assert one.symmetric_difference(mirrored).area < 2 * 3e-8 * one.length


def test_each_mode_leaves_a_hole_at_180_deg(found: dict[int, Workspace]) -> None:
    for one in found[180].regions:
        (ring,) = one.shape.interiors
        assert shapely.Polygon(ring).area * MM2 == pytest.approx(HOLE, abs=3e-5 * ring.length * 1e3 + CLOSE)
