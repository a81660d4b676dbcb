"""Maps: figures of a sheet over a grid of its drives' values and, by the working point's place, over the plane."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright._machine import processors
from linkwright.data_classes import dataclass
from linkwright.expressions.units import Dimension
from linkwright.kernels.threaded import pool
from linkwright.model.quantities import Quantities
from linkwright.results.stationary import bracketed
from linkwright.studies.workspace.mesh import DriveBox, halves, sides_of

Array = NDArray[np.float64]
Figures = Callable[[Array], Mapping[str, Array]]
"""From drive values (2, n) all figures by name, (n,) each, NaN where the mechanism can't be assembled; ``x`` and ``y``
of the working point are among them."""

ZOOMS, NARROWER, LOOKS = 16, 4.0, 9
"""An extreme is looked for on so many grids, each so much narrower than the one before, with so many places a side."""
ENDLESS = 1e4
"""What grows by this factor on the way there goes to infinity, what falls by it to zero: a root grows by 3e4."""
MOST = 1 << 14
"""Poses that are computed together: few enough to stay in cache."""


@dataclass(frozen=True)
class Map:
    """One figure: values (steps + 1, steps + 1) in SI over the first and the second drive's values, NaN where the
    mechanism can't be assembled; its dimension, the unit that it is shown in with its SI value."""

    name: str
    values: Array
    dimension: Dimension
    unit: str
    size: float


@dataclass(frozen=True)
class MapExtreme:
    """The least or greatest value of a map (SI), the drive values (2,) and the place (2,) of the working point.

    0 or infinite where it comes as near to that as one likes: then the place is a limit that isn't reached.
    """

    value: float
    drives: Array
    at: Array


@dataclass(frozen=True)
class Line:
    """A piece of a contour line, (2, k) both: drive values, and places of the working point (m)."""

    drives: Array
    at: Array


@dataclass(frozen=True)
class Maps:
    """Maps on a grid of ``axes``: drive values (steps + 1,) of each drive; ``at`` (2, steps + 1, steps + 1) are the
    places of the working point (m)."""

    box: DriveBox
    axes: tuple[Array, Array]
    at: Array
    maps: dict[str, Map]
    figures: Figures

    def least(self, name: str) -> MapExtreme | None:
        """The least value of a map; None where the mechanism can be assembled nowhere."""
        return self.extremes([name])[name][0]

    def greatest(self, name: str) -> MapExtreme | None:
        """The greatest value of a map."""
        return self.extremes([name])[name][1]

    def extremes(self, names: Sequence[str] | None = None) -> dict[str, tuple[MapExtreme | None, MapExtreme | None]]:
        """The least and the greatest value of maps, of all by default: from the best places of the grid, on narrower
        and narrower grids around the best places so far."""
        names = [*self.maps] if names is None else names
        if not names or np.isnan(self.maps[names[0]].values).all():
            return dict.fromkeys(names, (None, None))
        signs = np.tile([-1.0, 1.0], len(names))[:, None]
        steps = np.array([axis[1] - axis[0] for axis in self.axes])
        rows = np.repeat(np.stack([self.maps[name].values.ravel() for name in names]), 2, axis=0)
        found = np.nanargmax(signs * rows, axis=1)
        first = np.take_along_axis(rows, found[:, None], axis=1)[:, 0]
        best = signs[:, 0] * first
        q = np.stack([axis[i] for axis, i in zip(self.axes, np.unravel_index(found, self.at.shape[1:]), strict=True)])
        for zoom in range(ZOOMS):
            ticks = np.linspace(-1, 1, LOOKS) / NARROWER**zoom
            offsets = steps[:, None] * np.stack(np.meshgrid(ticks, ticks, indexing="ij")).reshape(2, -1)
            places = self._within((q[:, :, None] + offsets[:, None]).reshape(2, -1)).reshape(2, best.size, -1)
            figures = self.figures(places.reshape(2, -1))
            here = np.stack([figures[name].reshape(best.size, -1)[i : i + 2] for i, name in _twice(names)])
            here = np.nan_to_num(signs * here.reshape(best.size, -1), nan=-np.inf)
            which = here.argmax(axis=1)
            better = here[np.arange(best.size), which] > best
            best = np.where(better, here.max(axis=1), best)
            q = np.where(better, places[:, np.arange(best.size), which], q)
        at = self.figures(q)
        every = [
            MapExtreme(_endless(value, start), q[:, i], np.array([at["x"][i], at["y"][i]]))
            for i, (value, start) in enumerate(zip((signs[:, 0] * best).tolist(), first.tolist(), strict=True))
        ]
        return {name: (every[i], every[i + 1]) for i, name in _twice(names)}

    def _within(self, q: Array) -> Array:
        low, high = np.array(self.box.low)[:, None], np.array(self.box.high)[:, None]
        return np.where(np.array(self.box.turns)[:, None], q, np.clip(q, low, high))

    def contour(self, name: str, level: float) -> list[Line]:
        """The lines on which a map has a value (SI), by marching triangles; their corners lie on the true line."""
        values = self.maps[name].values.ravel() - level
        pairs, ends, _ = crossings(halves(self.axes[0].size, self.axes[1].size), values)
        if not len(pairs):
            return []
        grid = np.stack(np.meshgrid(*self.axes, indexing="ij")).reshape(2, -1)
        start, way = grid[:, pairs[:, 0]], grid[:, pairs[:, 1]] - grid[:, pairs[:, 0]]

        def off(share: Array, rows: NDArray[np.intp]) -> Array:
            return self.figures(start[:, rows] + share * way[:, rows])[name] - level

        share = bracketed(off, np.arange(len(pairs)), np.zeros(len(pairs)), np.ones(len(pairs)))
        q = start + share * way
        found = self.figures(q)
        at = np.stack([found["x"], found["y"]])
        return [Line(q[:, chain], at[:, chain]) for chain in chained(ends)]


def _twice(names: Sequence[str]) -> Iterator[tuple[int, str]]:
    """The names, numbered by twos."""
    return zip(range(0, 2 * len(names), 2), names, strict=True)


def _endless(value: float, first: float) -> float:
    """What grows or falls without end from its ``first`` value is infinite or 0."""
    if abs(value) > ENDLESS * abs(first):
        return float(np.copysign(np.inf, value))
    return 0.0 if abs(value) < abs(first) / ENDLESS else value


def mapped(quantities: Quantities, box: DriveBox, steps: int, figures: Figures, kinds: Mapping[str, Dimension]) -> Maps:
    """Maps of the named figures on ``steps`` equal steps of each drive, ends included."""
    first, second = (np.linspace(a, b, steps + 1) for a, b in zip(box.low, box.high, strict=True))
    grid = np.stack(np.meshgrid(first, second, indexing="ij")).reshape(2, -1)
    parts = evaluate_in_threads(figures, grid)
    rows = {name: parts[name].reshape(steps + 1, -1) for name in ("x", "y", *kinds)}
    made = {name: Map(name, rows[name], kind, *quantities.unit_of(kind)) for name, kind in kinds.items()}
    return Maps(box, (first, second), np.stack([rows["x"], rows["y"]]), made, figures)


def evaluate_in_threads(figures: Figures, q: Array) -> dict[str, Array]:
    """All figures at many drive values (2, n), on as many threads as there are processors."""
    parts = [q[:, start : start + MOST] for start in range(0, q.shape[1], MOST)] or [q]
    found = [figures(parts[0])] if len(parts) == 1 else [*pool(processors()).map(figures, parts)]
    return {name: np.concatenate([part[name] for part in found]) for name in found[0]}


def crossings(
    triangles: NDArray[np.intp], values: Array
) -> tuple[NDArray[np.intp], NDArray[np.intp], NDArray[np.intp]]:
    """Where values at the triangles' corners pass zero: sides (m, 2) by their corners, the pieces of lines from one of
    those to another, (n, 2), and the triangle that each passes, (n,)."""
    above = values >= 0
    which = above[triangles].any(axis=1) & ~above[triangles].all(axis=1) & np.isfinite(values[triangles]).all(axis=1)
    triangles = triangles[which]
    sides = np.sort(sides_of(triangles), axis=1)
    crossed = above[sides[:, 0]] != above[sides[:, 1]]
    own = sides[crossed]
    _, first, where = np.unique(own[:, 0] * values.size + own[:, 1], return_index=True, return_inverse=True)
    of = np.full(len(sides), -1)
    of[crossed] = where
    return own[first], np.sort(of.reshape(3, -1), axis=0)[1:].T, np.flatnonzero(which)


def chained(pieces: NDArray[np.intp]) -> list[list[int]]:
    """Pieces (n, 2), given by their ends, as lines: the ends of each in order, the first once more where it closes."""
    beside: dict[int, list[int]] = defaultdict(list)
    for a, b in pieces.tolist():
        beside[a].append(b)
        beside[b].append(a)
    lines, seen = [], set()
    for start in sorted(beside, key=lambda end: len(beside[end])):  # the ends of open lines first
        if start in seen:
            continue
        line, here = [start], start
        seen.add(start)
        while True:
            following = [end for end in beside[here] if end not in seen]
            if not following:
                if len(line) > 2 and start in beside[here]:
                    line.append(start)
                break
            here = following[0]
            seen.add(here)
            line.append(here)
        lines.append(line)
    return lines
