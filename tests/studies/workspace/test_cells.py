"""Cells that are decided, against closed forms of regions and of poses; quadtrees made by hand."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from helpers.reach import Chain, FiveBar, Guide, TwoCylinders
from helpers.reach.mechanisms import Mechanism
from linkwright.studies.workspace import cells as module
from linkwright.studies.workspace.cells import (
    Cells,
    Decided,
    LinearForms,
    among,
    cut_on,
    cut_sides,
    key,
    known_corners,
    merge_cells,
)
from linkwright.studies.workspace.places import ModePlaces
from studies.workspace.made_up import MM, decided_of, places_of
from studies.workspace.test_regions import lens

Array = NDArray[np.float64]
CYLINDERS = TwoCylinders(50.0, (40.0, 70.0), (35.0, 60.0))
RING = Guide(0.0, 0j, None, (20.0, 60.0))
MECHANISMS: dict[str, Mechanism] = {
    "five-bar": FiveBar(18.0, 30.0, 27.0, 20.0, 22.0, 14.0, 0.7, motor=(0.5, 3.0)),
    "two cylinders": CYLINDERS,
    "ring": RING,
    "four-bar and an arm": Chain(15.0, 40.0, 35.0, 50.0, 20.0, elbow=(-2.0, 1.0)),
}


@pytest.fixture(scope="module", params=MECHANISMS)
def case(request: pytest.FixtureRequest) -> tuple[Mechanism, ModePlaces, Decided]:
    mechanism = MECHANISMS[request.param]
    places = places_of(mechanism, 0)
    return mechanism, places, decided_of(places)


def inside(cells: Cells, count: int) -> Array:
    """Random places in cells, as many in small ones as in large, and some of their corners."""
    random = np.random.default_rng(4)
    some = random.integers(0, cells.level.size, count)
    shares = random.uniform(0, 1, (2, count))
    shares[:, ::4] = np.round(shares[:, ::4])
    return np.asarray(cells.low[:, some] + shares * cells.size[some])


def test_all_of_a_decided_cell_is_reached_or_none(case: tuple[Mechanism, ModePlaces, Decided]) -> None:
    mechanism, _, decided = case
    for cells, expected in ((decided.reached, 1), (decided.never, 0)):
        at = inside(cells, 20_000)
        with np.errstate(all="ignore"):
            bits = mechanism.reached((at[0] + 1j * at[1]) / MM)
        assert (bits & 1 == expected).all()


def test_cells_cover_the_square_once(case: tuple[Mechanism, ModePlaces, Decided]) -> None:
    _, _, decided = case
    every = merge_cells([decided.reached, decided.never, decided.open])
    assert (every.size**2).sum() == pytest.approx(every.side**2, rel=1e-12)
    at = every.corner[:, None] + np.random.default_rng(1).uniform(0, every.side, (2, 300))
    within = ((at[:, :, None] >= every.low[:, None]) & (at[:, :, None] < every.high[:, None])).all(axis=0)
    assert (within.sum(axis=1) == 1).all()


def test_shares_of_open_cells_lie_between_their_bounds(case: tuple[Mechanism, ModePlaces, Decided]) -> None:
    mechanism, _, decided = case
    cells, some = decided.open, np.random.default_rng(2).integers(0, decided.open.level.size, 30)
    axis = (np.arange(64) + 0.5) / 64
    x, y = (part.ravel() for part in np.meshgrid(axis, axis))
    for k in some:
        at = cells.low[:, k, None] + np.stack([x, y]) * cells.size[k]
        with np.errstate(all="ignore"):
            share = float((mechanism.reached((at[0] + 1j * at[1]) / MM) & 1 == 1).mean())
        # An edge through the cell is told to some of 64 places along a side.
        assert decided.least[k] - 0.05 <= share <= decided.most[k] + 0.05
    assert (decided.least <= decided.most).all()


def test_the_edge_lies_in_the_cells_in_which_it_is_traced(case: tuple[Mechanism, ModePlaces, Decided]) -> None:
    """Between two places, one of which is reached, there is an edge: bisected, it lies in such a cell."""
    _, places, decided = case
    random = np.random.default_rng(3)
    ends = decided.open.corner[:, None] + random.uniform(0, decided.open.side, (2, 2, 6000))
    within = np.stack([places.depth(end) > 0 for end in ends])
    apart = within[0] != within[1]
    (one, other), first = ends[:, :, apart], within[0, apart]
    one, other = np.where(first, one, other), np.where(first, other, one)
    for _ in range(60):
        middle = (one + other) / 2
        is_in = places.depth(middle) > 0
        one, other = np.where(is_in, middle, one), np.where(is_in, other, middle)
    assert one.shape[1] > 100
    cells = decided.edge
    slack = 1e-12 * cells.side
    for k in range(min(one.shape[1], 200)):
        at = one[:, k, None]
        assert ((at >= cells.low - slack) & (at <= cells.high + slack)).all(axis=0).any()


def expected_area(mechanism: Mechanism) -> float:
    """The closed form (m2)."""
    if isinstance(mechanism, Guide):
        low, high = mechanism.slide
        return float(np.pi * (high**2 - low**2)) * MM**2
    assert isinstance(mechanism, TwoCylinders)
    discs = [(i * k, mechanism.first[i > 0], mechanism.second[k > 0]) for i in (1, -1) for k in (1, -1)]
    return sum(sign * lens(one, other, mechanism.base) for sign, one, other in discs) / 2 * MM**2


@pytest.mark.parametrize("mechanism", [CYLINDERS, RING], ids=["two cylinders", "ring"])
def test_bounds_hold_the_area_and_draw_near_to_it(mechanism: Mechanism, monkeypatch: pytest.MonkeyPatch) -> None:
    area, wide = expected_area(mechanism), []
    places = places_of(mechanism, 0)
    monkeypatch.setattr(module, "LITTLE", 1.0)  # cut on no more than that
    for fine in (6, 8, 10):
        monkeypatch.setattr(module, "FINE", fine)
        low, high = decided_of(places).area
        assert low <= area <= high
        wide.append(high - low)
    # An arc leaves its line by the square of a cell's size: a quarter of that size leaves a sixteenth open, but for
    # cells at corners.
    assert wide[1] < wide[0] / 6 and wide[2] < wide[1] / 8 and wide[2] < 1e-4 * area


def test_cutting_open_cells_on_keeps_the_square_and_draws_the_bounds_together() -> None:
    places = places_of(CYLINDERS, 0)
    found = decided_of(places)
    which = np.random.default_rng(5).random(found.open.level.size) < 0.1
    more = cut_on(places, found, which)
    before, after = (merge_cells([one.reached, one.never, one.open]) for one in (found, more))
    assert (after.size**2).sum() == pytest.approx((before.size**2).sum(), rel=1e-13)
    assert after.level.size > before.level.size
    assert found.area[0] <= more.area[0] <= expected_area(CYLINDERS) <= more.area[1] <= found.area[1]
    assert more.forms.of.max() < more.open.level.size == more.least.size == more.most.size
    np.testing.assert_array_equal(more.edge.number, found.edge.number)
    same = cut_on(places, found, np.zeros_like(which))
    assert same.area == pytest.approx(found.area, rel=1e-15)


def quadtree() -> Cells:
    """A square of 4 m, its lower left quarter cut once more: cells of 2 m and four of 1 m."""
    large = np.array([[1, 0, 1], [0, 1, 1]])
    small = np.array([[0, 1, 0, 1], [0, 0, 1, 1]])
    return Cells(np.array([0.0, 0.0]), 4.0, np.concatenate([large, small], axis=1), np.array([1, 1, 1, 2, 2, 2, 2]))


def test_cells_know_their_places() -> None:
    cells = quadtree()
    np.testing.assert_array_equal(cells.size, [2, 2, 2, 1, 1, 1, 1])
    np.testing.assert_array_equal(cells.low[:, :4], [[2, 0, 2, 0], [0, 2, 2, 0]])
    np.testing.assert_array_equal(cells.high[:, 3], [1, 1])
    np.testing.assert_array_equal(cells.middle[:, 0], [3, 1])
    np.testing.assert_array_equal(cells.subset(np.array([4])).low[:, 0], [1, 0])


def test_quarters_cover_their_cell() -> None:
    parts = quadtree().subset(np.array([0, 5])).quarters()
    assert parts.level.tolist() == [2, 2, 2, 2, 3, 3, 3, 3]
    np.testing.assert_array_equal(parts.low[:, :4], [[2, 3, 2, 3], [0, 0, 1, 1]])
    np.testing.assert_array_equal(parts.low[:, 4:], [[0, 0.5, 0, 0.5], [1, 1, 1.5, 1.5]])


def test_corners_are_known_once_each() -> None:
    """On a grid of 4: nine corners of the small cells, and those of the large ones."""
    corners = known_corners(quadtree(), 2)
    expected = {(i, k) for i in range(3) for k in range(3)} | {(i, k) for i in (0, 2, 4) for k in (0, 2, 4)}
    assert [(int(c) >> 32, int(c) & 0xFFFFFFFF) for c in corners] == sorted(expected)


def test_keys_are_found_among_those_known() -> None:
    known = np.array([2, 5, 9])
    assert among(np.array([1, 2, 5, 9, 10]), known).tolist() == [False, True, True, True, False]
    assert among(np.array([1]), known[:0]).tolist() == [False]
    assert int(key(np.array([3, 4]))) == (3 << 32) + 4


def test_sides_are_cut_at_their_neighbours_corners() -> None:
    """Each piece of a side within the square belongs to two cells, from end to end alike."""
    cells = quadtree()
    start, stop, cell, side = cut_sides(cells, 2, known_corners(cells, 2))
    pieces: dict[tuple[int, ...], int] = {}
    for k in range(cell.size):
        ends = (*start[:, k].tolist(), *stop[:, k].tolist())
        pieces[ends] = pieces.get(ends, 0) + 1
    rim = [ends for ends in pieces if any(ends[a] == ends[a + 2] and ends[a] in (0, 4) for a in (0, 1))]
    assert all(count == (1 if ends in rim else 2) for ends, count in pieces.items())
    assert len(rim) == 10 and len(pieces) == 20
    assert np.count_nonzero(cell == 0) == 5  # its left side is cut
    assert side[cell == 0].tolist().count(1) == 2


def test_lines_in_cells_are_told_by_straight_forms() -> None:
    """One pose of cell 0 needs u > 0 within 0.1, one of cell 1 u > -3."""
    forms = LinearForms(
        np.array([0, 1]), np.array([[0.0, 3.0]]), np.array([[0.1, 0.1]]), np.array([[[1.0, 1.0]], [[0.0, 0.0]]])
    )
    start = np.array([[0.5, -1.0, -0.5, -1.0, 0.0], [0.0, 0.0, -1.0, -1.0, 0.0]])
    stop = np.array([[1.0, -0.2, 0.5, 1.0, 0.0], [1.0, 1.0, 1.0, 1.0, 0.0]])
    told = forms.tells(np.array([0, 0, 0, 1, 2]), start, stop)
    assert told.tolist() == [1, -1, 0, 1, -1]  # of cell 2 no pose is left
