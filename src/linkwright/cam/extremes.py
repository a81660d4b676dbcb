"""The largest and least values of a cam's figures over a turn, with their places, root-found."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from linkwright.cam.disc import Disc, Look
from linkwright.notation import Jet
from linkwright.results.stationary import stationary

Array = NDArray[np.float64]
Figure = Callable[[Look], Jet]
"""A figure with at least its first derivative by the cam angle."""

STEPS = 128
"""The first steps of a piece between two joins."""


@dataclass(frozen=True)
class Extreme:
    """A value in SI and the cam angle ``theta`` (rad) at which it is taken, or from one side of which."""

    value: float
    theta: float


def extremes(disc: Disc, figure: Figure) -> tuple[Extreme, Extreme]:
    """The least and the largest value of a figure; limits from either side count at the joins of the law. Raises
    ValueError where the figure is nowhere a number."""
    found: list[tuple[Array, Array]] = []
    for start, stop in disc.pieces:

        def rates(theta: Array, start: float = start, stop: float = stop) -> tuple[Array, Array]:
            jet = figure(disc.look(np.clip(theta, start, np.nextafter(stop, start))))
            rows = [np.broadcast_to(d, theta.shape) for d in jet.d[:2]]
            return rows[0][None], rows[1][None]

        inside = stationary(rates, start, stop, STEPS)[0]
        at = np.concatenate([[start, stop], inside])
        found.append((at, rates(at)[0][0]))
    theta, values = (np.concatenate(rows) for rows in zip(*found, strict=True))
    kept = ~np.isnan(values)
    if not kept.any():
        raise ValueError("no value")
    theta, values = theta[kept], values[kept]
    return tuple(Extreme(float(values[k]), float(theta[k])) for k in (values.argmin(), values.argmax()))  # type: ignore[return-value]


def curvature(by: float = 0.0) -> Figure:
    """The curvature (1/m) of the curve ``by`` (m) outward of the pitch curve; negative beyond a cusp."""
    return lambda look: look.curvature / (1.0 + by * look.curvature)


def pressure(look: Look) -> Jet:
    """The signed pressure angle (rad)."""
    return look.pressure
