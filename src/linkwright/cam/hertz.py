"""Line contact of cam and follower: pressure and width; how a roller spins.

Two cylinders pressed together by F over a width L touch on a strip of half-width b = sqrt(4 F R / (pi L E)) with the
peak pressure sqrt(F E / (pi L R)) = 2 F / (pi b L), where 1/R = 1/R1 + 1/R2, a hollow's radius negative, and
1/E = (1 - v1^2)/E1 + (1 - v2^2)/E2. (Hertz, 1882; Johnson, Contact Mechanics, 1985, 4.2c; Norton, Cam Design and
Manufacturing Handbook, 2nd ed.) It holds while b is small against both radii and for a face or a roller
without crown, aligned.
"""

from __future__ import annotations

import math
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from linkwright.cam.contact import ContactPlace, NoContact, rows
from linkwright.cam.disc import TURN, DiscJets
from linkwright.cam.extremes import CamExtreme, Figure, extremes
from linkwright.cam.loads import CamForces
from linkwright.data_classes import dataclass
from linkwright.notation import Jet

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Material:
    """An elastic material: Young's modulus (Pa), Poisson's ratio."""

    modulus: float
    poisson: float


STEEL = Material(207e9, 0.292)
"""As in Norton, Machine Design, and Shigley's Mechanical Engineering Design, table A-5 (carbon steel)."""


def effective(first: Material, second: Material) -> float:
    """The modulus (Pa) of a material that yields against a rigid body as both do against each other."""
    return 1.0 / sum((1.0 - one.poisson**2) / one.modulus for one in (first, second))


@dataclass(frozen=True)
class Pressure:
    """Hertz pressure over the turn at the cam angles of ``forces``; 0 where the side doesn't bear.

    ``width`` (m) is the common length of the contact line, ``modulus`` (Pa) the effective one.
    """

    forces: CamForces
    width: float
    modulus: float
    second: bool = False

    @property
    def side(self) -> ContactPlace:
        """The side that it is about."""
        side = self.forces.second if self.second else self.forces.first
        assert side is not None
        return side

    @cached_property
    def reduced(self) -> Array:
        """The radius R (m) of both curvatures: (n,)."""
        look = self.side.look(self.forces.theta)
        return rows(self.side.reduced(look).d[0], self.forces.theta.size)

    @property
    def line_load(self) -> Array:
        """The force over the width (N/m): (n,)."""
        forces = self.forces
        found: Array = np.maximum(forces.contact_second if self.second else forces.contact, 0.0) / self.width
        return found

    @cached_property
    def peak(self) -> Array:
        """The pressure (Pa) in the middle of the strip: (n,)."""
        found: Array = np.sqrt(self.line_load * self.modulus / (math.pi * self.reduced))
        return found

    @cached_property
    def highest(self) -> CamExtreme:
        """The largest pressure (Pa) of the turn; 0 where the side never bears."""
        contact = self.forces.figure(self.second)
        square = extremes(self.forces.disc, lambda look: contact(look) / self.side.reduced(self.side.look(look.theta)))
        most = square[1].value * self.modulus / (math.pi * self.width)
        return CamExtreme(math.sqrt(max(0.0, most)), square[1].theta)


def pressure(
    forces: CamForces, width: float, cam: Material = STEEL, follower: Material = STEEL, second: bool = False
) -> Pressure:
    """The Hertz pressure on the first or the second side under the forces. ``width`` (m) is that of the contact.

    Raises :class:`linkwright.cam.contact.NoContact`: ``cam.knife`` for an edge, ``cam.undercut`` where there is no
    profile.
    """
    found = Pressure(forces, width, effective(cam, follower), second)
    meets(found.side)
    return found


def meets(side: ContactPlace) -> None:
    """Raise :class:`linkwright.cam.contact.NoContact` where no line touches."""
    follower = side.disc.follower
    if not follower.faced and not follower.radius > 0:
        raise NoContact("cam.knife")
    least = extremes(side.disc, side.reduced)[0]
    if not least.value > 0:
        raise NoContact("cam.undercut", theta=(least.theta - side.shift) % TURN)


@dataclass(frozen=True)
class Rolling:
    """How the surfaces pass at a cam speed ``omega`` (rad/s), at cam angles ``theta`` (n,): a roller that doesn't slip
    turns by it, a face or an edge slides by it."""

    side: ContactPlace
    omega: float
    theta: Array

    @cached_property
    def surface(self) -> Array:
        """The speed (m/s) of the cam's surface past the follower's body at the contact, positive in the sense in which
        that of a disc passes which turns counter-clockwise: (n,)."""
        return self._values(lambda look: self.side.passing(look) * (self._sense * self.omega))

    @cached_property
    def spin(self) -> Array:
        """The roller's speed (rad/s) against its pin, counter-clockwise positive: (n,)."""
        return self._values(self._spin)

    @cached_property
    def acceleration(self) -> Array:
        """The roller's acceleration (rad/s2) in the fixed frame, counter-clockwise positive: (n,)."""
        return self._values(self._acceleration)

    @cached_property
    def spin_range(self) -> tuple[CamExtreme, CamExtreme]:
        """The least and the largest spin (rad/s) against the pin."""
        return self._extremes(self._spin)

    @property
    def _sense(self) -> int:
        return -1 if self.side.mirrored else 1

    def _turning(self, look: DiscJets) -> Jet:
        """By the cam angle: the roller touches with the surface that is ``flank`` times its radius from the pin."""
        if not (radius := self.side.disc.follower.radius) > 0:
            raise NoContact("cam.no-roller")
        return self.side.passing(look) * (self._sense * self.side.flank / radius)

    def _spin(self, look: DiscJets) -> Jet:
        return self._turning(look) * self.omega

    def _acceleration(self, look: DiscJets) -> Jet:
        own = self._turning(look).rate()
        if self.side.disc.follower.turns:  # clockwise with the lift
            own = own - look.lift.rate().rate() * self._sense
        return own * self.omega**2

    def _values(self, figure: Figure) -> Array:
        return rows(figure(self.side.look(self.theta)).d[0], self.theta.size)

    def _extremes(self, figure: Figure) -> tuple[CamExtreme, CamExtreme]:
        low, high = (
            CamExtreme(one.value, (one.theta - self.side.shift) % TURN) for one in extremes(self.side.disc, figure)
        )
        return low, high


def rolling(side: ContactPlace, omega: float, theta: Array) -> Rolling:
    """How the surfaces pass on a side at a cam speed (rad/s); ``ContactPlace(disc)`` is a follower that rests on a cam.

    Raises :class:`linkwright.cam.contact.NoContact` (``cam.undercut``).
    """
    if side.disc.follower.radius > 0 or side.disc.follower.faced:
        meets(side)
    return Rolling(side, omega, theta)
