"""Where friction jams a mechanism, found by letting all coefficients grow from zero to their values.

With a share s of the coefficients the efforts m obey G(m, s) = 0 (:mod:`linkwright.graph.friction`). At s = 0 the
Jacobian dG/dm is the unit matrix, and its determinant 1. Followed over s, the determinant comes to zero where the
efforts grow beyond all bounds or two solutions meet: from there on no efforts of the drives move the mechanism in the
prescribed way. Beyond, Newton's method may find solutions again that no motion leads to, so that the end alone tells
nothing.
"""

from __future__ import annotations

from itertools import product

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.graph.force_rows import FrictionNumber
from linkwright.kernels import Compiled

Array = NDArray[np.float64]

SHARES, STEPS, ARRIVED = 64, 6, 1e-8
"""Shares of the coefficients at which solutions are looked at, Newton's steps at each, and a step (over the efforts)
that has arrived."""
LONG, HALVINGS = 40, 40
"""Newton's steps from far away, and halvings of the share at which a mechanism jams."""
FAR, FEW, APART = (3.0, 1e3, 1e6), 6, 1e-6
"""How far away Newton's method starts, over the efforts; how many efforts are few; solutions nearer than this share are
one."""
GROWN, TINY = 100.0, 1e-12
"""Efforts that grow to so many times their size, while the share is halved towards the one that jams, grow beyond all
bounds; the least size of efforts (N, N m)."""


@dataclass(frozen=True)
class Laws:
    """The laws of efforts at poses: ``factor`` and ``rest`` (efforts, poses); of each effort of each seat the force
    (parts, poses) without efforts, and what a unit of each adds (efforts, parts, poses)."""

    factor: Array
    rest: Array
    seats: list[list[tuple[Array, Array]]]

    def at(self, poses: int | NDArray[np.intp]) -> Laws:
        """The laws at some of the poses."""
        which = np.atleast_1d(poses)
        seats = [[(load[..., which], units[..., which]) for load, units in own] for own in self.seats]
        return Laws(self.factor[:, which], self.rest[:, which], seats)

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


def several(of: Laws, m: Array) -> Array:
    """At which poses other efforts than m (efforts, poses) obey the laws: (poses,).

    The laws are a map of efforts to efforts. With the sizes of what each effort adds to each seat, K_ij = |c_i| sum_k
    |b_ikj| bounds how the map stretches differences. Where the spectral radius of K is below 1 it contracts in some
    norm, and by Banach's theorem there is one solution alone. Elsewhere Newton's method is started from far away in
    all directions: a law of one effort is convex, so that this finds all of its solutions (two at most); of several
    efforts it may miss some.
    """
    n, poses = m.shape
    stretch = np.zeros((poses, n, n))
    for i, seats in enumerate(of.seats):
        sizes = sum((np.sqrt((units**2).sum(axis=1)) for _, units in seats), np.zeros((n, poses)))
        stretch[:, i] = (np.abs(of.factor[i]) * sizes).T
    stretch = np.where(np.isfinite(stretch), stretch, 0.0)
    open_ = np.flatnonzero(np.abs(np.linalg.eigvals(stretch)).max(axis=1, initial=0.0) >= 1)
    found = np.zeros(poses, dtype=bool)
    if not open_.size:
        return found
    some, known = of.at(open_), m[:, open_]
    size = np.abs(known).max(axis=0) + TINY
    for direction in _directions(n):
        for far in FAR:
            other = known + far * size * direction[:, None]
            with np.errstate(all="ignore"):
                for _ in range(LONG):
                    other = other - _solved(*reversed(some.linear(other, 1.0))).T
                gaps = np.abs(some.linear(other, 1.0)[0]).max(axis=1)
                reach = np.maximum(np.abs(other).max(axis=0), size)
                apart = np.abs(other - known).max(axis=0) > APART * reach
                found[open_] |= (gaps <= ARRIVED * reach) & apart
    return found


def meets(of: Laws) -> bool:
    """Of the laws at one pose that jams: whether the efforts stay finite where two solutions meet; else they grow
    beyond all bounds."""
    low, high, m = 0.0, 1.0, of.rest.copy()
    for s in np.linspace(0.0, 1.0, SHARES + 1)[1:]:
        moved = _corrected(of, m, float(s))
        if moved is None:
            high = float(s)
            break
        low, m = float(s), moved
    sizes = []
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        moved = _corrected(of, m, middle)
        if moved is None:
            high = middle
        else:
            low, m = middle, moved
            sizes.append(float(np.abs(m).max()))
    return bool(len(sizes) > 1 and sizes[-1] < GROWN * sizes[0])


def _corrected(of: Laws, m: Array, share: float) -> Array | None:
    """The efforts at a share of the coefficients, from those at one nearby; ``None`` where there are none."""
    for _ in range(LONG):
        gaps, jacobian = of.linear(m, share)
        step = _solved(jacobian, gaps)
        m = m - step.T
        if not np.isfinite(m).all():
            return None
        if np.abs(step).max() <= ARRIVED * np.abs(m).max():
            return m if np.linalg.det(of.linear(m, share)[1])[0] > 0 else None
    return None


def _directions(n: int) -> list[Array]:
    """Ways to go far away: all combinations of signs of a few efforts, of more each alone and all together."""
    if n <= FEW:
        return [np.array(signs) for signs in product((-1.0, 1.0), repeat=n)]
    return [sign * one for sign in (-1.0, 1.0) for one in (*np.eye(n), np.ones(n))]
