"""Drive values at which the working point of a sheet is at given places: by Newton's method from values nearby."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from linkwright.studies.workspace.mesh import RIM, DriveBox, Mesh
from linkwright.studies.workspace.sheet import ModeSheet

Array = NDArray[np.float64]
Rows = NDArray[np.intp]

STARTS = 12
NEWTON = 40
DAMPS = np.array([1.0]), 3.0 ** -np.arange(1.0, 8.0)
"""Shares of a step of Newton's method: where the first brings it no nearer, the largest of the others that does."""
DONE = 1e-3
"""What misses by less than this share of what is near enough needn't come nearer."""


def reaches(sheet: ModeSheet, box: DriveBox, made: Mesh, places: Array, near: float) -> tuple[NDArray[np.bool_], Array]:
    """Whether the working point comes to places (2, n) within ``near`` (m), and the drive values (2, n) at which."""
    from scipy.spatial import cKDTree

    corners = made.q[:, np.unique(made.triangles)]
    at = sheet.place(corners)[0]
    known = np.isfinite(at).all(axis=0)
    corners, at = corners[:, known], at[:, known]
    count = places.shape[1]
    nearest = cKDTree(at.T).query(places.T, k=min(STARTS, at.shape[1]))[1].reshape(count, -1)
    found, values = np.zeros(count, dtype=bool), np.full((2, count), np.nan)
    for starts in (nearest[:, :1], nearest[:, 1:]):
        rest, tries = np.flatnonzero(~found), starts.shape[1]
        q, ok = solved(sheet, box, corners[:, starts[rest].ravel()], np.repeat(places[:, rest], tries, axis=1), near)
        row, first = np.unique(np.flatnonzero(ok) // max(tries, 1), return_index=True)
        found[rest[row]] = True
        values[:, rest[row]] = q[:, ok][:, first]
    return found, values


def solved(sheet: ModeSheet, box: DriveBox, q: Array, places: Array, near: float) -> tuple[Array, NDArray[np.bool_]]:
    """Drive values at which the working point is at places (2, n), by damped Newton from ``q``; which were found."""
    low, high = np.array(box.low)[:, None], np.array(box.high)[:, None]
    held = ~np.array(box.turns)[:, None]

    def tried(rows: Rows, step: Array, damp: Array) -> tuple[Array, Array]:
        """Places (2, damps, rows) after parts of a step, and by how much they miss, infinite where out of reach."""
        found = q[:, None, rows] - damp[:, None] * step[:, None]
        found = np.where(held[:, None], np.clip(found, low[:, None], high[:, None]), found)
        at, reach = sheet.place(found.reshape(2, -1))
        off = np.hypot(*(at.reshape(found.shape) - places[:, None, rows]))
        return found, np.where(reach.reshape(off.shape) > RIM, off, np.inf)

    q, miss = q.copy(), np.hypot(*(sheet.place(q)[0] - places))
    rows = np.arange(miss.size)
    for _ in range(NEWTON):
        rows = rows[miss[rows] > DONE * near]
        if not rows.size:
            break
        here = sheet.look(q[:, rows])
        off, j, det = here.at - places[:, rows], here.jacobian, here.determinant
        with np.errstate(all="ignore"):
            step = np.stack([j[1, 1] * off[0] - j[0, 1] * off[1], j[0, 0] * off[1] - j[1, 0] * off[0]]) / det
        step = np.nan_to_num(step, nan=0.0, posinf=0.0, neginf=0.0)
        step *= np.minimum(1.0, 0.3 * box.size.min() / np.maximum(np.abs(step).max(axis=0), 1e-300))
        better = np.zeros(rows.size, dtype=bool)
        for damps in DAMPS:
            rest = np.flatnonzero(~better)
            there, off = tried(rows[rest], step[:, rest], damps)
            nearer = off < miss[rows[rest]]
            first, good = nearer.argmax(axis=0), nearer.any(axis=0)
            chosen = first[good], np.flatnonzero(good)
            q[:, rows[rest[good]]], miss[rows[rest[good]]] = there[:, *chosen], off[chosen]
            better[rest[good]] = True
        rows = rows[better]  # the others are stuck
    return q, miss <= near
