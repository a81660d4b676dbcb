"""How straight a path is: the narrowest strip that holds it."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from linkwright.results import Run
from linkwright.results.stationary import stationary

Array = NDArray[np.float64]
Path = NDArray[np.complex128]
Interval = tuple[float, float]

ROUNDS = 60


def straightness(
    place: Callable[[Array], Path], speed: Callable[[Array], Path], intervals: list[Interval], steps: int
) -> float:
    """The distance of the two closest parallel lines that hold a path (ISO 1101; minimum zone, ISO 12780-1)."""
    return narrowest(place, speed, intervals, steps)[0]


def narrowest(
    place: Callable[[Array], Path], speed: Callable[[Array], Path], intervals: list[Interval], steps: int
) -> tuple[float, complex, Array]:
    """The narrowest strip that holds a path: its width, the unit vector across it, the times at which the path is
    outermost in that direction and its opposite, with the ends.

    ``place`` gives x + iy of the point at times, ``speed`` its velocity so; ``steps`` over each interval to begin
    with. The narrowest strip of some points of the path is a lower bound, the whole path's extent across that strip
    an upper one; the path's outermost points join the others until the two bounds meet.
    """
    points = hull(place(np.concatenate([np.linspace(a, b, steps + 1) for a, b in intervals])))
    extent = float(np.abs(points - points[0]).max())
    best, held = (np.inf if extent > 0 else 0.0), (1j, np.empty(0))
    for _ in range(ROUNDS if extent > 0 else 0):
        least, across = strip(points)
        heights, outermost, when = [], [], []
        for a, b in intervals:
            times = _turning(place, speed, across, a, b, steps)
            when.append(times)
            outermost.append(found := place(times))
            heights.append((found * across.conjugate()).real)
        height, found = np.concatenate(heights), np.concatenate(outermost)
        if np.ptp(height) < best:
            best, held = float(np.ptp(height)), (across, np.concatenate(when))
        if best - least <= 1e-12 * best + 1e-15 * extent:
            break
        points = hull(np.concatenate([points, found[[height.argmin(), height.argmax()]]]))
    return best, *held


def _turning(
    place: Callable[[Array], Path], speed: Callable[[Array], Path], across: complex, a: float, b: float, steps: int
) -> Array:
    """The times at which a path is outermost in a direction and its opposite, and the ends."""

    def rates(t: Array) -> tuple[Array, Array]:
        value, rate = place(t), speed(t)
        return (value * across.conjugate()).real[None], (rate * across.conjugate()).real[None]

    return np.concatenate([[a], stationary(rates, a, b, steps)[0], [b]])


def strip(corners: Path) -> tuple[float, complex]:
    """The width of the narrowest strip around a convex polygon, and the unit vector across it.

    One side of it lies on an edge of the polygon (Houle and Toussaint 1988).
    """
    edges = np.roll(corners, -1) - corners
    across = 1j * edges / np.abs(edges)
    widths = ((corners[None] - corners[:, None]) * across.conjugate()[:, None]).real.max(axis=1)
    i = int(widths.argmin())
    return float(widths[i]), complex(across[i])


def hull(points: Path) -> Path:
    """The corners of the convex hull, counter-clockwise (Andrew's monotone chain)."""
    ordered = np.unique(points)  # by x, then by y
    sides: list[complex] = []
    for row in (ordered.tolist(), ordered[::-1].tolist()):
        side: list[complex] = []
        for p in row:
            while len(side) > 1 and ((side[-1] - side[-2]).conjugate() * (p - side[-2])).imag <= 0:
                side.pop()
            side.append(p)
        sides += side[:-1]
    return np.array(sides or ordered)


def around(run: Run, point: str, intervals: list[Interval]) -> tuple[float, complex, Array]:
    """The narrowest strip that holds a point's path over some intervals, as :func:`narrowest` gives it."""

    def plane(*names: str) -> Callable[[Array], Path]:
        def along(t: Array) -> Path:
            x, y = run.evaluate([f"{point}.{name}" for name in names], t)
            return np.asarray(x + 1j * y)

        return along

    return narrowest(plane("x", "y"), plane("vx", "vy"), intervals, max(run.grid, 100))
