"""Shapes of a drawing as paths of SVG, in pixels, y down, with a digit behind the point."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

MOST_POINTS, MOST_CORNERS = 48, 200
"""A line has no more points, and a closed one, such as a wheel with slots, no more corners."""
FEW = 4
"""A line of so few places, such as a box, is drawn as it is."""
UNSEEN = 0.15
"""A line may differ by so much, in pixels, from the one that it stands for ..."""
COARSER = (1, 2, 4, 8)
"""... or these times as much, where it would have too many points."""
TEETH = 12
"""Half-turns of a coil spring."""


def number(value: float) -> str:
    """A length to tenths of a pixel."""
    text = f"{value:.1f}".removesuffix(".0")
    return "0" if text == "-0" else text


def written(places: Iterable[Iterable[float]]) -> str:
    """Places as the points of a path, its first command left out."""
    return "L".join(" ".join(number(value) for value in place) for place in places)


def line(places: Array, *, closed: bool = False, unseen: float = UNSEEN) -> str:
    """A line through places, interrupted where there is none, by no more points than are needed to stay within
    ``unseen`` pixels of it."""
    known = np.isfinite(places).all(axis=1)
    ends = np.flatnonzero(np.diff(known)) + 1
    pieces = [part for part in np.split(places, ends) if len(part) > 1 and np.isfinite(part).all()]
    return "".join(f"M{written(_thinned(part, closed, unseen))}{'Z' * closed}" for part in pieces)


def _thinned(places: Array, closed: bool, unseen: float) -> Array:
    if len(places) <= FEW:
        return places
    ring, most = (np.concatenate([places, places[:1]]), MOST_CORNERS) if closed else (places, MOST_POINTS)
    for times in COARSER:
        seen = ring[needed(ring, times * unseen)]
        if len(seen) <= most:
            break
    else:
        seen = ring[np.linspace(0, len(ring) - 1, most).round().astype(int)]
    return seen[:-1] if closed and len(seen) > 2 else seen


def needed(places: Array, unseen: float) -> NDArray[np.bool_]:
    """Which of the places (n, 2) of a line are needed for no other to lie farther than ``unseen`` from the chord that
    takes its place: the ends, and again and again the farthest place from each chord (Douglas and Peucker 1973,
    doi:10.3138/FM57-6770-U75U-7727), here of all chords at once."""
    kept = np.zeros(len(places), bool)
    kept[[0, -1]] = True
    while True:
        ends = np.flatnonzero(kept)
        chord = np.minimum(np.cumsum(kept), len(ends) - 1) - 1
        start = places[ends[chord]]
        along, to = places[ends[chord + 1]] - start, places - start
        square = (along**2).sum(axis=1)
        share = np.clip((along * to).sum(axis=1) / np.where(square > 0, square, 1.0), 0.0, 1.0)
        away = np.hypot(*(to - share[:, None] * along).T)
        farthest = np.maximum.reduceat(away, ends[:-1])[chord]
        more = np.flatnonzero((away > unseen) & (away == farthest))
        if not more.size:
            return kept
        kept[more[np.diff(chord[more], prepend=-1) > 0]] = True  # of equal ones the first


def hull(points: Array) -> Array:
    """The convex hull of places (Andrew's monotone chain), counter-clockwise in the plane of its coordinates."""
    ordered = points[np.lexsort((points[:, 1], points[:, 0]))].tolist()
    lower, upper = _chain(ordered), _chain(ordered[::-1])
    return np.array(lower if len(lower) < 2 else [*lower[:-1], *upper[:-1]], float).reshape(-1, 2)


def _chain(points: list[list[float]]) -> list[list[float]]:
    """One side of the hull of sorted places; those that coincide count once."""
    out: list[list[float]] = []
    for p in points:
        while len(out) > 1:
            a, b = out[-2:]
            if (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 1e-9:
                break
            out.pop()
        if not out or np.hypot(p[0] - out[-1][0], p[1] - out[-1][1]) > 1e-6:
            out.append(p)
    return out


def outline(ring: Array, r: float) -> str:
    """The outline of a hull as the picture has it, a distance r outside it: a circle, a rounded bar or a rounded plate.
    The hull runs counter-clockwise with y up."""
    ring = ring[::-1]
    if len(ring) == 0:
        return ""
    if len(ring) == 1:
        x, y = ring[0]
        d = number(2 * r)
        return f"M{number(x - r)} {number(y)}a{number(r)} {number(r)} 0 1 1 {d} 0a{number(r)} {number(r)} 0 1 1-{d} 0Z"
    sides = np.roll(ring, -1, axis=0) - ring
    normals = sides[:, ::-1] * [1, -1] / np.hypot(*sides.T)[:, None] * r
    starts, ends = ring + normals, np.roll(ring, -1, axis=0) + normals
    arc = f"A{number(r)} {number(r)} 0 0 1 "
    lines = [written(pair) for pair in zip(starts, ends, strict=True)]
    return f"M{arc.join(lines)}{arc}{written(starts[:1])}Z"


def spring(start: Array, stop: Array, look: str, r: float) -> str:
    """A spring between two places: a coil that reaches r to either side, or the barrel and rod of a strut."""
    length = float(np.hypot(*(stop - start))) or 1.0
    along = (stop - start) / length
    across = np.array([-along[1], along[0]])

    def at(*places: tuple[float, float]) -> str:
        return written(start + share * length * along + side * across for share, side in places)

    if look == "strut":
        w = 0.7 * r
        barrel = at((0.1, -w), (0.6, -w), (0.6, w), (0.1, w))
        return f"M{at((0, 0), (0.1, 0))}M{barrel}ZM{at((0.6, 0), (1, 0))}"
    coil = [(0.15 + 0.7 * (i + 0.5) / TEETH, r if i % 2 else -r) for i in range(TEETH)]
    return f"M{at((0, 0), (0.15, 0), *coil, (0.85, 0), (1, 0))}"
