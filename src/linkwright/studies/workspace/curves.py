"""The curves that can bound a workspace, in the drives' plane and as paths of the working point.

They are where the jacobian is singular, where two assembly modes meet (the rim of a sheet), and the ends of the
drives' ranges. Each is found on the triangles of a mesh and refined until its path lies within a chord tolerance.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from linkwright.studies.workspace.mesh import HALVINGS, RIM, Mesh, halved
from linkwright.studies.workspace.sheet import Sheet

Array = NDArray[np.float64]
Rows = NDArray[np.intp]

ROUNDS = 24
"""Segments are halved at most so many times."""
SECANTS = 12
WAY = 0.5
"""The curve is looked for no further beside the middle of a segment than this share of its length."""
STEADY = 1e-13
"""A place is on a curve when a step is below this share of the segment."""


@dataclass(frozen=True)
class Segments:
    """Pieces of one kind of curve: drive values at the ends of each, (2, segments) both, and how far a piece may lie
    off the true path where it couldn't be refined (m), 0 where it could: (segments,)."""

    kind: str
    a: Array
    b: Array
    off: Array


def curves(sheet: Sheet, mesh: Mesh, chord: float) -> list[Segments]:
    """All of a sheet's curves, their paths' chords within ``chord`` (m)."""
    inner, rim = _singular(sheet, mesh)
    limit = mesh.q[:, mesh.limit.T].swapaxes(0, 1)
    return [
        refined(sheet, "singular", *inner, chord, lambda q: sheet.look(q).numerator),
        refined(sheet, "modes", *rim, chord, lambda q: sheet.place(q)[1] - RIM),
        refined(sheet, "limit", *limit, chord, None),
    ]


def _singular(sheet: Sheet, mesh: Mesh) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
    """Pieces of the singular curve, one in each triangle that it passes; the rim's, cut where the curve meets it."""
    q, triangles = mesh.q, mesh.triangles
    positive = sheet.look(q).numerator >= 0
    mixed = triangles[positive[triangles].any(axis=1) & ~positive[triangles].all(axis=1)]
    sides = np.concatenate([mixed[:, [0, 1]], mixed[:, [1, 2]], mixed[:, [2, 0]]])
    crossed = positive[sides[:, 0]] != positive[sides[:, 1]]
    pairs, where = np.unique(np.sort(sides[crossed], axis=1), axis=0, return_inverse=True)
    rim = np.sort(mesh.rim, axis=1)
    on_rim = _among(pairs, rim)
    places = np.empty((2, len(pairs)))
    for chosen, bend in ((~on_rim, None), (on_rim, sheet)):
        a, b = q[:, pairs[chosen, 0]], q[:, pairs[chosen, 1]]
        sign = positive[pairs[chosen, 0]]
        path = _straight(a, b) if bend is None else _along_rim(sheet, a, b)
        share = halved(lambda s, path=path, sign=sign: (sheet.look(path(s)).numerator >= 0) == sign, a.shape[1])
        places[:, chosen] = path(share)
    at = np.full(len(sides), -1)
    at[crossed] = where.ravel()
    two = np.sort(at.reshape(3, -1), axis=0)[1:]
    cut = dict(zip(map(tuple, pairs[on_rim].tolist()), np.flatnonzero(on_rim).tolist(), strict=True))
    starts, ends = [], []
    for first, last in rim.tolist():
        middle = cut.get((first, last))
        stops = [q[:, first], *([] if middle is None else [places[:, middle]]), q[:, last]]
        starts += stops[:-1]
        ends += stops[1:]
    whole = np.array(starts).reshape(-1, 2).T, np.array(ends).reshape(-1, 2).T
    return (places[:, two[0]], places[:, two[1]]), whole


def _among(pairs: Rows, known: Rows) -> NDArray[np.bool_]:
    size = int(max(pairs.max(initial=0), known.max(initial=0))) + 1
    return np.isin(pairs[:, 0] * size + pairs[:, 1], known[:, 0] * size + known[:, 1])


def _straight(a: Array, b: Array) -> Callable[[Array], Array]:
    return lambda share: a + share * (b - a)


def _along_rim(sheet: Sheet, a: Array, b: Array) -> Callable[[Array], Array]:
    """The rim between two places on it: from the chord across to where the reach is that of the rim."""
    across = np.stack([a[1] - b[1], b[0] - a[0]])

    def path(share: Array) -> Array:
        q = a + share * (b - a)
        found = q.copy()
        inside = sheet.place(q)[1] > RIM
        for side in (1.0, -1.0):
            beyond = sheet.place(q + side * WAY * across)[1] > RIM
            turned = (beyond != inside) & (found == q).all(axis=0)
            if turned.any():
                start, step, was = q[:, turned], side * WAY * across[:, turned], inside[turned]
                at = halved(lambda s, i=start, d=step, w=was: (sheet.place(i + s * d)[1] > RIM) == w, start.shape[1])
                found[:, turned] = start + np.where(was, at, at + 2.0**-HALVINGS) * step
        return found

    return path


def refined(
    sheet: Sheet, kind: str, a: Array, b: Array, chord: float, f: Callable[[Array], Array] | None
) -> Segments:
    """Segments halved until the middle of each path lies within ``chord`` of its chord; the curve is where ``f`` is 0,
    or straight in the drives' plane."""
    done: list[tuple[Array, Array, Array]] = []
    pa, pb = sheet.place(a)[0], sheet.place(b)[0]
    for turn in range(ROUNDS):
        if not a.shape[1]:
            break
        middle, found = ((a + b) / 2, np.full(a.shape[1], True)) if f is None else _beside(f, a, b)
        pm = sheet.place(middle)[0]
        found &= np.isfinite(pm).all(axis=0)
        off = _distance(pm, pa, pb)
        fine = ~found | ((off <= chord) & (turn > 0))
        done.append((a[:, fine], b[:, fine], np.where(found[fine], 0.0, np.hypot(*(pb - pa)[:, fine]))))
        rest = ~fine
        a, b = np.concatenate([a[:, rest], middle[:, rest]], 1), np.concatenate([middle[:, rest], b[:, rest]], 1)
        pa, pb = np.concatenate([pa[:, rest], pm[:, rest]], 1), np.concatenate([pm[:, rest], pb[:, rest]], 1)
    if a.shape[1]:
        done.append((a, b, np.hypot(*(pb - pa))))
    if not done:
        return Segments(kind, a, b, np.empty(0))
    return Segments(kind, *(np.concatenate(parts, axis=-1) for parts in zip(*done, strict=True)))


def _beside(f: Callable[[Array], Array], a: Array, b: Array) -> tuple[Array, NDArray[np.bool_]]:
    """The zeros of f on the normals through the middles of segments, by the secant method; whether one was found."""
    middle, across = (a + b) / 2, np.stack([a[1] - b[1], b[0] - a[0]])
    s0, s1 = np.zeros(a.shape[1]), np.full(a.shape[1], 1e-4)
    f0, f1 = f(middle), f(middle + s1 * across)
    for _ in range(SECANTS):
        with np.errstate(all="ignore"):
            step = np.where(f1 == f0, 0.0, f1 * (s1 - s0) / (f1 - f0))
        s0, f0, s1 = s1, f1, np.clip(s1 - step, -WAY, WAY)
        f1 = f(middle + s1 * across)
    with np.errstate(invalid="ignore"):
        found = np.isfinite(f1) & (np.abs(s1 - s0) <= 1e-7) & (np.abs(s1) < WAY)
    return middle + s1 * across, found


def _distance(p: Array, a: Array, b: Array) -> Array:
    """How far points are from the segments a .. b: (n,)."""
    d, r = b - a, p - a
    square = (d * d).sum(axis=0)
    with np.errstate(all="ignore"):
        share = np.clip(np.where(square > 0, (d * r).sum(axis=0) / square, 0.0), 0.0, 1.0)
    return np.asarray(np.hypot(*(r - share * d)))
