"""Where friction jams a mechanism, found by letting all coefficients grow from zero to their values.

With a share s of the coefficients the efforts m obey G(m, s) = 0 (:mod:`linkwright.graph.friction`). At s = 0 the
Jacobian dG/dm is the unit matrix, and its determinant 1. Followed over s, the determinant comes to zero where the
efforts grow beyond all bounds or two solutions meet: from there on no efforts of the drives move the mechanism in the
prescribed way. Beyond, Newton's method may find solutions again that no motion leads to, so that the end alone tells
nothing.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from linkwright.graph.force_rows import FrictionNumber
from linkwright.kernels import Compiled

Array = NDArray[np.float64]

SHARES, STEPS, ARRIVED = 64, 6, 1e-8
"""Shares of the coefficients at which solutions are looked at, Newton's steps at each, and a step (over the efforts)
that has arrived."""


@dataclass(frozen=True)
class Laws:
    """The laws of efforts at poses: ``factor`` and ``rest`` (efforts, poses); of each effort of each seat the force
    (parts, poses) without efforts, and what a unit of each adds (efforts, parts, poses)."""

    factor: Array
    rest: Array
    seats: list[list[tuple[Array, Array]]]

    def linear(self, m: Array, share: float) -> tuple[Array, Array]:
        """What the laws miss at efforts m (efforts, poses), and the Jacobian of that (poses, efforts, efforts)."""
        n, poses = m.shape
        gaps, jacobian = np.empty((poses, n)), np.zeros((poses, n, n))
        for i, seats in enumerate(self.seats):
            size, grown = np.zeros(poses), np.zeros((n, poses))
            for load, units in seats:
                force = load + np.einsum("jap,jp->ap", units, m)
                length = np.sqrt((force**2).sum(axis=0))
                size = size + length
                along = np.divide(force, length, out=np.zeros_like(force), where=length > 0)
                grown = grown + np.einsum("ap,jap->jp", along, units)
            factor = share * self.factor[i]
            gaps[:, i] = m[i] - factor * size - self.rest[i]
            jacobian[:, i] = -(factor * grown).T
            jacobian[:, i, i] += 1.0
        return gaps, jacobian


def laws(compiled: Compiled, t: Array) -> Laws:
    """The laws of all friction at times t (s)."""
    shape = compiled.graph.friction_shape
    n = len(shape)
    count = sum(2 + sum(parts * (1 + n) for parts in seats) for seats in shape)
    rows = iter(compiled.evaluate([FrictionNumber(i) for i in range(count)], t))
    factor, rest = np.empty((n, t.size)), np.empty((n, t.size))
    found: list[list[tuple[Array, Array]]] = []
    for i, seats in enumerate(shape):
        factor[i], rest[i] = next(rows), next(rows)
        own: list[tuple[Array, Array]] = []
        for parts in seats:
            load = np.array([next(rows) for _ in range(parts)])
            own.append((load, np.array([[next(rows) for _ in range(parts)] for _ in range(n)])))
        found.append(own)
    return Laws(factor, rest, found)


def followed(of: Laws) -> tuple[Array, Array]:
    """The share of the coefficients at which each pose jams (poses,), infinite where it doesn't up to all of them; the
    efforts (efforts, poses) at all of them."""
    m = of.rest.copy()
    share = np.full(m.shape[1], np.inf)
    for s in np.linspace(0.0, 1.0, SHARES + 1)[1:]:
        moved = np.full(m.shape[1], np.inf)
        with np.errstate(all="ignore"):
            for _ in range(STEPS):
                gaps, jacobian = of.linear(m, s)
                jacobian = np.where(np.isfinite(jacobian), jacobian, 0.0) + 0.0
                step = _solved(jacobian, gaps)
                m = m - step.T
                moved = np.abs(step).max(axis=1) / np.maximum(np.abs(m).max(axis=0), 1e-300)
            lost = ~((np.linalg.det(np.nan_to_num(of.linear(m, s)[1])) > 0) & (moved < ARRIVED)) & (m != 0).any(axis=0)
        share = np.where(lost & np.isinf(share), s, share)
    return share, m


def _solved(jacobian: Array, gaps: Array) -> Array:
    """Newton's steps (poses, efforts); NaN at a pose whose Jacobian is singular."""
    flat = np.linalg.det(jacobian) == 0
    regular = np.where(flat[:, None, None], np.eye(gaps.shape[1]), jacobian)
    step = np.linalg.solve(regular, gaps[..., None])[..., 0]
    return np.where(flat[:, None], np.nan, step)
