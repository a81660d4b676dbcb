"""The profile as a drawing or a solid wants it: arcs and lines within a tolerance; and its exact area."""

from __future__ import annotations

import numpy as np

from linkwright.cam.disc import Disc
from linkwright.cam.nc.path import SHARE, CutterPath, Element

DECIMALS = 9
"""Of a mm: what rounding takes of the tolerance doesn't count."""
NODES = 200
"""Places of the Gauss-Legendre rule over each piece between two joins."""


def contour(disc: Disc, tolerance: float, offset: float | None = None) -> list[Element]:
    """Arcs and lines (mm), end to end and closed, counter-clockwise, within ``tolerance`` (m) of the profile, or of the
    curve ``offset`` (m) outward of the pitch curve. Raises :class:`linkwright.cam.nc.path.Sharp`."""
    by = -disc.follower.radius if offset is None else offset
    path = CutterPath(disc, by, 0.0, -disc.sense, tolerance / SHARE, DECIMALS, along=True)
    return path.elements()


def area(disc: Disc, offset: float | None = None) -> float:
    """The area (m2) within the profile, or within the curve ``offset`` (m) outward of the pitch curve: half the
    integral of p x p', piece by piece."""
    by = -disc.follower.radius if offset is None else offset
    nodes, weights = np.polynomial.legendre.leggauss(NODES)
    whole = 0.0
    for start, stop in disc.pieces:
        look = disc.look(start + (stop - start) * (nodes + 1) / 2)
        x, y = (p + by * n for p, n in zip(look.pitch, look.normal, strict=True))
        whole += float(weights @ (x.d[0] * y.d[1] - y.d[0] * x.d[1])) * (stop - start) / 4
    return -disc.sense * whole
