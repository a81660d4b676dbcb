"""Crossing limit positions: where the wanted path touches the edge of the workspace, a track continues through it.

At a limit position the jacobian J = d(x, y)/d(drives) has rank 1. Near it the point moves like (a, b²) for drives
(a, b). A path (u, c u²) that touches the edge therefore has two smooth solutions, b = +-sqrt(c) u, that cross there.
Solving for the path directly is unreliable: an error e of the path gives b = +-sqrt(c u² + e), which turns back or
has no solution, and its error is the square root of e.

So the track doesn't solve for the path near a limit position. It crosses on a *bridge*: a quintic in u between a solved
place before the limit position and one behind it, with equal first and second derivatives at both. A bridge is accepted
only if the point stays close to the path along all of it, the determinant of J changes its sign exactly once, and the
determinants of the closures keep theirs.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.studies.workspace.mesh import DriveBox
from linkwright.studies.workspace.target_path import TargetPath

if TYPE_CHECKING:
    from linkwright.studies.workspace.path_continuation import SheetWithRates

Array = NDArray[np.float64]

SHORT, LONG = 0.02, 0.3
"""From one end of a bridge to the limit position: how far the drives may go, in rad where a range is a whole turn."""
LOOKS = 65
TURNED = 0.1
"""A bridge's far end is corrected by no more than this (as above)."""


@dataclass(frozen=True)
class Bridge:
    """From node ``first`` of a track to ``u``, where it has the ``node`` (3, 2, 1) and the determinant there."""

    first: int
    u: float
    node: Array
    determinant: float


def bridge(
    mover: SheetWithRates,
    box: DriveBox,
    wanted: TargetPath,
    u: Sequence[float],
    nodes: Sequence[Array],
    signs: Sequence[float],
    off: float,
) -> Bridge | None:
    """The longest way on from one of a track's last nodes, if there is one, with the point no farther than ``off`` (m)
    from the path: errors of the path do least to it. ``signs`` are the determinants at the nodes."""
    scale = box.size / (2 * np.pi)
    best = None
    # Try the nodes from the last one backward: a longer bridge is less sensitive to errors of the path.
    for k in range(len(u) - 1, 0, -1):
        away = (np.abs(nodes[-1][0, :, 0] - nodes[k][0, :, 0]) / scale).max()
        if away > LONG or signs[k] * signs[-1] < 0:
            break
        # The determinant must fall towards zero; linear extrapolation gives the distance to the limit position.
        fallen = 1.0 - signs[k] / signs[k - 1]
        if not 0 < fallen < 1:
            continue
        ahead = (u[k] - u[k - 1]) * (1.0 - fallen) / fallen
        far = float((np.abs(nodes[k][1, :, 0]) / scale).max()) * ahead
        # Only bridges of a sensible length; the far end lies as far behind the limit position as this node before it.
        if SHORT < far < LONG and u[k] + 2 * ahead <= 1.0:
            found = _bridged(mover, scale, wanted, k, u[k], 2 * ahead, nodes[k], signs[k], off)
            if found is not None and not box_left(box, found.node[0, :, 0]).any():
                best = found
    return best


def box_left(box: DriveBox, q: Array) -> NDArray[np.bool_]:
    """Which drives are beyond the ends of their ranges."""
    slack = 1e-12 * box.size
    return ~np.array(box.turns) & ((q < np.array(box.low) - slack) | (q > np.array(box.high) + slack))


def curve(u: Array, nodes: Array) -> Any:
    """The quintics between nodes (3, 2, n) with two derivatives, as a function of u."""
    from scipy.interpolate import BPoly

    return BPoly.from_derivatives(u, np.moveaxis(nodes, (2, 0, 1), (0, 1, 2)))


def _bridged(
    mover: SheetWithRates,
    scale: Array,
    wanted: TargetPath,
    k: int,
    u: float,
    wide: float,
    node: Array,
    before: float,
    off: float,
) -> Bridge | None:
    # Predict the far end by Taylor series and correct it onto the path.
    foretold = node[0] + wide * node[1] + wide**2 / 2 * node[2]
    path = wanted.of(np.array([u + wide]))
    with np.errstate(all="ignore"):
        q, ok = mover.solve_drives(foretold, path[0])
        # A large correction would mean another solution.
        if not ok.all() or not (np.abs(q - foretold)[:, 0] / scale < TURNED).all():
            return None
        there, look = mover.along(q, path)
    # Behind a limit position the determinant has the opposite sign.
    after = float(look.determinant[0])
    if not np.isfinite(there).all() or not after * before < 0:
        return None
    # Verify the quintic along its whole length: the point near the path, one sign change of the determinant, none of
    # the closures'.
    places = np.linspace(u, u + wide, LOOKS)
    spline = curve(places[[0, -1]], np.concatenate([node, there], axis=2))
    looks = mover.look(spline(places).T, spline(places, nu=1).T)
    away = np.hypot(*(looks.at - wanted.of(places)[0]))
    once = (np.diff(np.sign(looks.determinant)) != 0).sum() == 1
    sound = once and (np.abs(np.diff(np.sign(looks.closure))) == 0).all() and (away <= off).all()
    return Bridge(k, u + wide, there, after) if sound else None
