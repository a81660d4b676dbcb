"""Where cam and follower touch: the lever of the contact force, the curvature that it meets, how the surfaces pass.

The outward unit normal n of the cam and the derivative a of the follower's touching point by the lift give the reach
n . a: what a contact force of 1 N does along the lift (m/m or m/rad). A flank ``+1`` is the outer one of a groove, on
whose inner side the roller runs; ``-1`` is the profile that a follower rests on from outside.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.cam.disc import TURN, Disc, DiscJets
from linkwright.cam.extremes import Figure, extremes
from linkwright.cam.followers import dot
from linkwright.data_classes import dataclass
from linkwright.notation import Jet

Array = NDArray[np.float64]

JUMP = 1e-9
"""A larger difference on both sides of a join, over the largest value, is a jump."""
SEEN = 64
"""Places of each piece at which the largest value is looked for."""


class NoContact(ValueError):
    """What is asked has no answer for this contact; ``key`` and ``data`` (SI, ``theta`` the cam angle) say why."""

    def __init__(self, key: str, **data: float) -> None:
        super().__init__(key)
        self.key, self.data = key, data


@dataclass(frozen=True)
class ContactPlace:
    """One place at which a cam holds its follower: a disc ``shift`` rad ahead of the cam angle, its flank; ``mirrored``
    if the disc is described in a world in which y is -y."""

    disc: Disc
    shift: float = 0.0
    flank: int = -1
    mirrored: bool = False

    @property
    def joins(self) -> list[float]:
        """The cam angles at which the law changes on this side."""
        return [join - self.shift for join in self.disc.joins]

    def look(self, theta: Array) -> DiscJets:
        """The disc where it touches on this side at cam angles (n,)."""
        return self.disc.look(np.mod(np.asarray(theta) + self.shift, TURN) if self.shift else theta)

    def reduced(self, look: DiscJets) -> Jet:
        """The radius (m) of the cylinder that touches a plane as cam and follower touch: 1/R = 1/roller + 1/profile,
        with a hollow profile's radius negative. Of a knife edge 0; negative where the cam is undercut."""
        if self.disc.follower.faced:
            return 1.0 / look.curvature
        roller = self.disc.follower.radius
        return roller * (1.0 + self.flank * roller * look.curvature)

    def passing(self, look: DiscJets) -> Jet:
        """How far the cam's surface passes the follower's body at the contact (m/rad), counter-clockwise about the
        cam's centre positive: slides on a face or an edge; turns a roller."""
        reach = self.flank * self.disc.follower.radius
        contact = tuple(c + reach * n for c, n in zip(look.centre, look.along, strict=True))
        body = self.disc.follower.velocity((contact[0], contact[1]))
        tangent = -look.along[1], look.along[0]
        return self.disc.sense * dot((contact[0], contact[1]), look.along) - look.lift.rate() * dot(body, tangent)


def contact_lever(look: DiscJets) -> Jet:
    """The lever of the contact force along the lift (m/m or m/rad): the cosine of the pressure angle times the length
    of the arm."""
    return dot(look.along, look.arm)


def on_face(disc: Disc) -> Figure:
    """Where on a flat face the cam touches it (m): of a swinging one from the foot of its pivot's perpendicular towards
    its free end, of a sliding one from the slide's way through the shaft to the left of it."""
    pivot = getattr(disc.follower, "distance", 0.0)
    return lambda look: dot((look.centre[0] - pivot, look.centre[1]), (-look.along[1], look.along[0]))


def drivable(side: ContactPlace) -> None:
    """Raise :class:`NoContact` where the lift or its rate jumps (``cam.shock``: an infinite force), or where the
    pressure angle reaches a right angle (``cam.locked``)."""
    disc = side.disc
    for order in (0, 1):
        within = [_angle(np.linspace(start, np.nextafter(stop, start), SEEN)) for start, stop in disc.pieces]
        found = [rows(disc.lift(theta).d[order], SEEN) for theta in within]
        size = float(np.abs(found).max())
        for (start, _), before, after in zip(disc.pieces, [found[-1], *found], found, strict=False):
            if abs(after[0] - before[-1]) > JUMP * size:
                raise NoContact("cam.shock", theta=start)
    least = extremes(disc, contact_lever)[0]
    if not least.value > 0:
        raise NoContact("cam.locked", theta=least.theta)


def rows(value: Any, size: int) -> Array:
    """An entry of a jet as an array (size,)."""
    return np.broadcast_to(np.asarray(value, dtype=float), (size,))


def _angle(theta: Array) -> Jet:
    return Jet([theta, np.ones_like(theta), *(np.zeros_like(theta) for _ in range(2))])
