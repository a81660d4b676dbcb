"""Curves of a mode that no mesh of the drives' plane has found: from the places that its poses reach.

Where the region of one pose ends, the mode has a curve: two poses meet there, or two modes, or a range ends. Pieces of
such edges that lie on no curve found so far are given the drives' values there.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from linkwright.notation.angles import wrapped
from linkwright.studies.workspace.border import border
from linkwright.studies.workspace.cells import decided
from linkwright.studies.workspace.curves import Segments
from linkwright.studies.workspace.places import ModePlaces
from linkwright.studies.workspace.pose_counts import DrivePaths

Array = NDArray[np.float64]
Square = tuple[Array, float, float]
Edge = tuple[Array, Array, Array]

BESIDE, CHORDS = 1e-6, 4.0
"""Pieces of an edge are on a curve of their kind within this share of the region's extent, or so many chords."""
DEEP = 6
"""Cells in which the edge of what one pose reaches is traced are halved so many times more where it isn't one line."""
SHARES = 0.05, 0.5, 0.95
"""A piece is on a curve if it is at these shares of its way."""
ALIKE = 2e-3
"""Drives' values are those of one curve if they differ by less than this share of the ranges: they change quickly
beside a fold."""
NEAR = 10.0
"""The drives' values lead to the place, within so many times the way within."""
MIDDLE, INWARD = 2.0, (0.1, 1.0, 10.0)
"""The drives' values are those of places so many chords within the edge, at the middles of pieces and at their ends, as
far as need be: nearer the round-off of the values may let the mechanism come apart."""


def missed_anywhere(places: ModePlaces, square: Square, segments: list[Segments], chord: float) -> list[Segments]:
    """Pieces of all of a mode's curves that are missing; each pose's region lies in a square (corner, side, extent)."""
    found: list[Segments] = []
    for branch in range(len(places.branches)):
        one = places.only(branch)
        edge = border(one.depth, decided(one, *square, deep=DEEP).edge, chord / 2)
        found += missed(places, edge, square[2], [*segments, *found], chord, branch)
    return found


def missed(
    places: ModePlaces, edge: Edge, extent: float, segments: list[Segments], chord: float, branch: int | None = None
) -> list[Segments]:
    """Pieces of the edge of what all poses reach or one ``branch``, by their ends (2, n) both and by how much (m) each
    may be off, (n,), that lie on no curve of their kind: as curves."""
    a, b, off = edge
    near, found = max(BESIDE * extent, CHORDS * chord), []
    values, kinds = _drives(places, branch, (a + b) / 2, b - a, MIDDLE * chord)
    for kind in sorted(set(places.kinds)):
        drawn = DrivePaths.of(places.sheet, [one for one in segments if one.kind == kind])
        own = np.flatnonzero(kinds == kind)
        asked = None if branch is None else values[:, own]
        on = [_on(places, drawn, (a + share * (b - a))[:, own], asked, near) for share in SHARES]
        own = own[~np.all(on, axis=0)]
        way = (b - a)[:, own]
        first, last = (_drives_at_ends(places, branch, end[:, own], way, chord) for end in (a, b))
        last = first + _nearest(places, last - first)  # beyond a seam, where a piece lies across it
        known = np.isfinite(first).all(axis=0) & np.isfinite(last).all(axis=0)
        if known.any():
            found.append(Segments(kind, first[:, known], last[:, known], off[own[known]]))
    return found


def _on(places: ModePlaces, drawn: DrivePaths, at: Array, values: Array | None, distance: float) -> NDArray[np.bool_]:
    """Which places, (2, n), are on a curve; with the drives' values, (2, n): on that one, of those with one path."""
    import shapely

    place, piece = drawn.near(shapely.points(at.T), distance)
    found = np.zeros(at.shape[1], dtype=bool)
    if values is None:
        found[place] = True
        return found
    size = places.box.size[:, None]
    first, last = drawn.drives[:, :, piece]
    away = np.abs(_nearest(places, values[:, place] - (first + last) / 2)) - np.abs(last - first) / 2
    found[place[(away < ALIKE * size).all(axis=0)]] = True
    return found


def _drives_at_ends(places: ModePlaces, branch: int | None, at: Array, along: Array, chord: float) -> Array:
    """The drives' values (2, n) at ends of pieces, NaN where there are none."""
    found = np.full_like(at, np.nan)
    for share in INWARD:
        rest = np.flatnonzero(np.isnan(found).any(axis=0))
        found[:, rest] = _drives(places, branch, at[:, rest], along[:, rest], share * chord)[0]
    return found


def _drives(
    places: ModePlaces, branch: int | None, at: Array, along: Array, within: float
) -> tuple[Array, NDArray[np.str_]]:
    """The drives' values (2, n) so far (m) within places of an edge, NaN where they lead elsewhere, and the kinds of
    curve there. What is reached lies to the left or right of the way ``along`` the edge."""
    aside, row = within * np.stack([-along[1], along[0]]) / np.hypot(*along), np.arange(at.shape[1])
    poses = places.poses_of(branch)
    reached = places.depths(at + aside)[poses].max(axis=0) > 0
    inside, outside = np.where(reached, at + aside, at - aside), np.where(reached, at - aside, at + aside)
    values, depths = places.drives(inside)
    of = poses[depths[poses].argmax(axis=0)]
    ended = np.nan_to_num(places.functions(outside)[of, :, row], nan=np.inf).argmin(axis=1)
    one, other = values[of, :, row].T, values[places.partner(of, ended), :, row].T
    # Beside a fold the values of both poses that meet there change as a root of the way, but their mean doesn't.
    mean = one + np.nan_to_num(_nearest(places, other - one)) / 2
    chosen = np.full_like(one, np.nan)
    for q in (one, mean):
        near = np.hypot(*(places.sheet.place(q)[0] - at)) < NEAR * within
        chosen[:, near] = q[:, near]
    return chosen, np.array(places.kinds)[ended]


def _nearest(places: ModePlaces, apart: Array) -> Array:
    """Differences (2, n) of drives' values, of those that turn fully less whole turns."""
    return np.where(np.array(places.box.turns)[:, None], wrapped(apart), apart)
