"""The proof of an NC file: it is read back, the cutter is swept, the follower run over what is left."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from linkwright.cam.disc import TURN, Disc
from linkwright.cam.nc.reader import Fault, Move, read
from linkwright.cam.nc.swept import NothingLeft, swept
from linkwright.cam.nc.track import Tight
from linkwright.cam.rolling import rolled

Array = NDArray[np.float64]

ANGLES = 3600
RAPID = 10_000.0
"""mm/min at which rapid motions are reckoned."""


@dataclass(frozen=True)
class Proof:
    """What a file makes of a cam. Lifts in m or rad at ``theta`` (rad): ``error`` is made less wanted, (2, n): of the
    bottom and of the top of the cam; ``rate`` likewise of its derivative by theta, by differences over the angles'
    step. ``gouge`` and ``rest`` (m): how deep the profile is cut into, and what stands above it, at the worst. ``time``
    (s), ``length`` (m) of the cutting motions. Nothing of it where there are ``faults``.
    """

    theta: Array
    error: Array
    rate: Array
    gouge: float
    rest: float
    time: float
    length: float
    moves: tuple[Move, ...]
    contours: tuple[Array, ...]
    faults: tuple[Fault, ...] = ()

    @property
    def worst(self) -> float:
        """The largest error of the lift, of whatever sign."""
        return float(np.abs(self.error).max()) if self.error.size else math.inf


def prove(disc: Disc, text: str, cutter: float, angles: int = ANGLES) -> Proof:
    """Read an NC file back for a cam; ``cutter`` (m) is the radius of the cutter that mills it."""
    found = read(text)
    faults = list(found.faults)
    theta = np.arange(angles) * TURN / angles
    if not faults:
        try:
            contours = tuple(one.inner / 1e3 for one in swept(found.moves, 1e3 * cutter))
        except NothingLeft:
            faults = [Fault("nc.nothing-left", 0)]
        except Tight as tight:
            faults = [Fault("nc.tight", tight.line)]
    if faults:
        none = np.empty((2, 0))
        return Proof(theta, none, none, math.nan, math.nan, math.nan, math.nan, tuple(found.moves), (), tuple(faults))
    wanted = np.broadcast_to(disc.look(theta).lift.d[0], theta.shape)
    error = np.array([rolled(disc, contour, theta) for contour in contours]) - wanted
    with np.errstate(invalid="ignore"):  # where the follower falls off
        rate = (np.roll(error, -1, axis=1) - np.roll(error, 1, axis=1)) / (2 * TURN / angles)
    gouge, rest = _off(disc, contours)
    time = sum(60 * move.length / (move.feed or RAPID) for move in found.moves)
    length = sum(move.length for move in found.moves if move.feed) / 1e3
    return Proof(theta, error, rate, gouge, rest, time, length, tuple(found.moves), contours)


def _off(disc: Disc, contours: Sequence[Array]) -> tuple[float, float]:
    """How far contours lie inside and outside of the profile (m): along the normals of its nearest places."""
    from scipy.spatial import KDTree

    look = disc.look(np.linspace(0.0, TURN, 4 * ANGLES, endpoint=False))
    profile = look.offset(-disc.follower.radius)
    normal = look.offset(1.0) - look.offset(0.0)
    nearest = KDTree(profile.T)
    gouge = rest = 0.0
    for contour in contours:
        which = nearest.query(contour.T)[1]
        out = ((contour - profile[:, which]) * normal[:, which]).sum(axis=0)
        gouge, rest = max(gouge, float(-out.min())), max(rest, float(out.max()))
    return gouge, rest
