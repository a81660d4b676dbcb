"""The largest and least values of a cam's figures over a turn, with their places, root-found."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import lru_cache
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from linkwright.cam.disc import Disc, DiscJets, Lift, inside
from linkwright.data_classes import dataclass
from linkwright.notation import Jet
from linkwright.results.stationary import crossings, stationary

Array = NDArray[np.float64]
Figure = Callable[[DiscJets], Jet]
"""A figure with at least its first derivative by the cam angle."""

MOVES = 1e-9
"""A follower that moves by no more than this per radian (m or rad) dwells."""
VALUES = 2
"""The order of the lift that the values of figures need."""
SAME = 1e-12
"""Values that differ by less than this share of the largest one are one."""
STEPS = 128
"""The first steps of a piece between two joins."""


@dataclass(frozen=True)
class CamExtreme:
    """A value in SI and the cam angle ``theta`` (rad) at which it is taken, or from one side of which."""

    value: float
    theta: float


def extremes(
    disc: Disc, figure: Figure, over: Iterable[tuple[float, float]] | None = None, exact: bool = True
) -> tuple[CamExtreme, CamExtreme]:
    """The least and the largest value of a figure, of the whole turn or ``over`` stretches within pieces of the law;
    limits from inside count at their ends. A value that is kept over a stretch is placed at its start. Not ``exact``:
    the best of 2 :data:`STEPS` places of each stretch, much sooner. Raises ValueError where the figure is nowhere a
    number."""
    key = figure, tuple(disc.pieces if over is None else over), exact
    if key not in disc.known_extremes:
        disc.known_extremes[key] = _find_extremes(disc, *key)
    found: tuple[CamExtreme, CamExtreme] = disc.known_extremes[key]
    return found


def _find_extremes(
    disc: Disc, figure: Figure, over: tuple[tuple[float, float], ...], exact: bool
) -> tuple[CamExtreme, CamExtreme]:
    found: list[tuple[Array, Array]] = []
    for start, stop in over:

        def rates(theta: Array, start: float = start, stop: float = stop) -> tuple[Array, Array]:
            with np.errstate(divide="ignore", invalid="ignore"):  # of a cusp, told by its radius
                jet = figure(disc.within(theta, start, stop))
            rows = [np.broadcast_to(d, theta.shape) for d in jet.d[:2]]
            return rows[0][None], rows[1][None]

        if exact:
            at = np.concatenate([[start, stop], stationary(rates, start, stop, STEPS)[0]])
            found.append((at, rates(at)[0][0]))
        else:
            at, look = disc.grid(start, stop, 2 * STEPS, VALUES)
            with np.errstate(divide="ignore", invalid="ignore"):
                found.append((at, np.broadcast_to(figure(look).d[0], at.shape)))
    if not found:
        raise ValueError("no stretch")
    theta, values = (np.concatenate(rows) for rows in zip(*found, strict=True))
    kept = ~np.isnan(values)
    if not kept.any():
        raise ValueError("no value")
    theta, values = theta[kept], values[kept]
    low, high = float(values.min()), float(values.max())
    close = SAME * max(abs(low), abs(high))
    starts, ends = (np.array(side) for side in zip(*over, strict=True))
    return tuple(
        CamExtreme(value, _first(theta[np.abs(values - value) <= close], starts, ends)) for value in (low, high)
    )  # type: ignore[return-value]


def _first(theta: Array, starts: Array, ends: Array) -> float:
    """Of the places of one value: the first start of a stretch that it is kept over, else the first of all."""
    kept = starts[np.isin(starts, theta) & np.isin(ends, theta)]
    return float(np.min(kept if kept.size else theta))


def stretches(disc: Disc, rising: bool) -> list[tuple[float, float]]:
    """Where the follower rises, or where it returns: cam angles within a piece of the law each."""
    return [(start, stop) for start, stop, up in moving(disc.lift, tuple(disc.pieces)) if up == rising]


@lru_cache(maxsize=64)
def moving(lift: Lift, pieces: tuple[tuple[float, float], ...]) -> list[tuple[float, float, bool]]:
    """The stretches on which a lift changes, and whether it grows."""
    found = []
    for start, stop in pieces:

        def rate(theta: Array, start: float = start, stop: float = stop) -> Array:
            at = inside(theta, start, stop)
            return np.broadcast_to(lift(Jet([at, np.ones_like(at)])).d[1], theta.shape)

        turns = [start, *crossings(rate, start, stop, STEPS), stop]
        for a, b in pairwise(turns):
            moves = rate(np.linspace(a, b, 9)[1:-1])
            if np.abs(moves).max() > MOVES:
                found.append((a, b, bool(moves[np.abs(moves).argmax()] > 0)))
    return found


@lru_cache(maxsize=64)
def curvature(by: float = 0.0) -> Figure:
    """The curvature (1/m) of the curve ``by`` (m) outward of the pitch curve; negative beyond a cusp."""

    def figure(look: DiscJets) -> Jet:
        with np.errstate(divide="ignore", invalid="ignore"):  # at a cusp
            return look.curvature / (1.0 + by * look.curvature)

    return figure


def pressure(look: DiscJets) -> Jet:
    """The size of the pressure angle (rad)."""
    return abs(look.pressure)
