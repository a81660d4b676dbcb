"""The proof of an NC file: it is read back, the cutter is swept, the follower run over what is left."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from linkwright.cam.disc import TURN, Disc
from linkwright.cam.followers import dot
from linkwright.cam.nc.reader import Move, NCFault, read
from linkwright.cam.nc.swept import NothingLeft, Swept, swept
from linkwright.cam.nc.track import Tight
from linkwright.cam.rolling import rolled, rolled_within
from linkwright.data_classes import dataclass

Array = NDArray[np.float64]

ANGLES = 3600
RAPID = 10_000.0
"""mm/min at which rapid motions are reckoned."""


@dataclass(frozen=True)
class NCProof:
    """What a file makes of a cam. Lifts in m or rad at ``theta`` (rad): ``error`` is made less wanted, (2, n): of the
    bottom and of the top of the cam, of a groove (4, n): of the inner flank's, then of the outer one's; ``rate``
    likewise of its derivative by theta, by differences over the angles' step. ``gouge`` and ``rest`` (m): how deep the
    profile or a flank is cut into, and what stands before it, at the worst. ``time`` (s), ``length`` (m) of the cutting
    motions, ``depth`` (m) of the deepest. ``play``: the least and the largest play (m) of the roller across its groove.
    Nothing of it where there are ``faults``.
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
    faults: tuple[NCFault, ...] = ()
    depth: float = math.nan
    play: tuple[float, float] | None = None

    @property
    def worst(self) -> float:
        """The largest error of the lift, of whatever sign."""
        return float(np.abs(self.error).max()) if self.error.size else math.inf


def prove(disc: Disc, text: str, cutter: float, angles: int = ANGLES, groove: bool = False) -> NCProof:
    """Read an NC file back for a cam, or for its ``groove``; ``cutter`` (m) is the radius of the cutter that mills."""
    found = read(text)
    faults, theta = list(found.faults), np.arange(angles) * TURN / angles
    flanks: list[tuple[int, Array]] = []
    if not faults:
        try:
            lowest, every = swept(found.moves, 1e3 * cutter)
            different = [lowest] if every is lowest else [lowest, every]
            flanks = [(-1, one.inner / 1e3) for one in different]
            flanks += [(1, one.outer / 1e3) for one in different if groove]
            faults += [_fault_at("nc.stray", stray) for one in different for stray in _strays(disc, one, groove)]
            faults += [_fault_at("nc.island", island) for island in lowest.islands if groove]
        except NothingLeft:
            faults = [NCFault("nc.nothing-left", 0)]
        except Tight as tight:
            faults = [NCFault("nc.tight", tight.line)]
    if faults:
        none = np.empty((2, 0))
        return NCProof(theta, none, none, math.nan, math.nan, math.nan, math.nan, tuple(found.moves), (), tuple(faults))
    look = disc.look(theta)
    wanted = np.broadcast_to(look.lift.d[0], theta.shape)
    run = {-1: rolled, 1: rolled_within}
    lifts = np.array([run[flank](disc, contour, theta) for flank, contour in flanks])
    error = np.repeat(lifts, 2 // len(different), axis=0) - wanted
    with np.errstate(invalid="ignore"):  # where the follower falls off
        rate = (np.roll(error, -1, axis=1) - np.roll(error, 1, axis=1)) / (2 * TURN / angles)
        play = np.abs(dot(look.along, look.arm).d[0]) * (error[2:] - error[:2]) if groove else None
    off = [sorted(-flank * _beyond(disc, contour, flank)) for flank, contour in flanks]
    return NCProof(
        theta,
        error,
        rate,
        gouge=float(max(0.0, *(-least for least, _ in off))),
        rest=float(max(0.0, *(most for _, most in off))),
        time=sum(60 * move.length / (move.feed or RAPID) for move in found.moves),
        length=sum(move.length for move in found.moves if move.feed) / 1e3,
        moves=tuple(found.moves),
        contours=tuple(contour for _, contour in flanks),
        depth=-min(move.end[2] for move in found.moves) / 1e3,
        play=None if play is None else (float(play.min()), float(play.max())),
    )


def _fault_at(key: str, place: Array) -> NCFault:
    return NCFault(key, 0, {"x": f"{place[0]:.4g}", "y": f"{place[1]:.4g}"})


def _strays(disc: Disc, one: Swept, groove: bool) -> Iterator[Array]:
    """Places (mm) of what is cut aside of what is to be cut: within the profile, beyond the outer flank of a groove."""
    for stray in one.strays:
        inside = _beyond(disc, stray / 1e3, -1)[0] < 0
        if inside or (groove and _beyond(disc, stray / 1e3, 1)[-1] > 0):
            yield stray.mean(axis=1)


def _beyond(disc: Disc, contour: Array, flank: int) -> Array:
    """How far a contour lies outward of the profile (``flank`` -1) or of the outer flank (+1), m, along the normals of
    their nearest places: the least and the largest."""
    from scipy.spatial import KDTree

    look = disc.look(np.linspace(0.0, TURN, 4 * ANGLES, endpoint=False))
    exact = look.offset(flank * disc.follower.radius)
    normal = look.offset(1.0) - look.offset(0.0)
    which = KDTree(exact.T).query(contour.T)[1]
    out = ((contour - exact[:, which]) * normal[:, which]).sum(axis=0)
    return np.array([out.min(), out.max()])
