"""Contact force and shaft torque over the turn: the generalised force balance along the lift, without friction.

Along the lift s the follower's inertia, its spring and the process ask of the cam Q = I s'' w^2 + c s + p + load, in N
of a translating, N m of a swinging follower. The contact force is N = Q / (n . a), a being the derivative of the
touching point by the lift: n . a is the cosine of the pressure angle, times the arm of a swinging roller. By virtual
work the shaft gives T = Q s'. (Rothbart, Cam Design Handbook, 2004, ch. 8; Norton, Cam Design and
Manufacturing Handbook, 2nd ed.) The cam turns uniformly and all bodies are rigid.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from linkwright.cam.contact import ContactPlace, contact_lever, drivable, rows
from linkwright.cam.disc import Disc, DiscJets
from linkwright.cam.disc import inside as within
from linkwright.cam.extremes import STEPS, CamExtreme, Figure, extremes
from linkwright.data_classes import dataclass
from linkwright.notation import Jet
from linkwright.results.stationary import crossings

Array = NDArray[np.float64]
Load = Callable[[DiscJets], Jet]
"""A generalised force (N or N m) that presses the follower onto the cam, with its first derivative by the cam angle."""

NOTHING = 1e-12
"""What presses less than this share of the largest force doesn't press."""
NODES = 64
"""Places of the Gauss-Legendre rule over each piece between two joins."""


def by_lift(function: Callable[[Jet], Jet]) -> Load:
    """A load (N or N m) that depends on the lift (m or rad), such as a weight on a swinging arm."""
    return lambda look: function(look.lift)


def by_angle(function: Callable[[Jet], Jet]) -> Load:
    """A load (N or N m) that depends on the cam angle (rad, 0 .. 2 pi), such as a process."""
    return by_both(lambda angle, _: function(angle))


def by_both(function: Callable[[Jet, Jet], Jet]) -> Load:
    """A load (N or N m) that depends on the cam angle (rad, 0 .. 2 pi) and the lift (m or rad)."""
    return lambda look: function(Jet([look.theta, np.ones_like(look.theta), np.zeros_like(look.theta)]), look.lift)


@dataclass(frozen=True)
class FollowerLoads:
    """What acts on a follower along its lift; in brackets the units of a swinging one, about its pivot.

    ``inertia`` kg (kg m2); ``rate`` of the spring N/m (N m/rad) and ``preload`` N (N m) at the lift 0; ``load`` N (N
    m), a constant such as a weight, or a function of the lift or the angle (:func:`by_lift`, :func:`by_angle`), whose
    ``joins`` (rad) are the cam angles at which its formula changes. All positive onto the cam.
    """

    inertia: float = 0.0
    rate: float = 0.0
    preload: float = 0.0
    load: float | Load = 0.0
    joins: Sequence[float] = ()

    def along(self, look: DiscJets, omega: float) -> Jet:
        """The force along the lift (N or N m) that the cam must give at a speed (rad/s), positive away from it."""
        moved = look.lift.rate().rate() * (self.inertia * omega**2) + look.lift * self.rate + self.preload
        return moved + (self.load(look) if callable(self.load) else self.load)

    def over(self, disc: Disc) -> Disc:
        """The disc with the loads' joins among its own."""
        return replace(disc, joins=(*disc.joins, *self.joins)) if self.joins else disc


@dataclass(frozen=True)
class Bearing:
    """A stretch of cam angles (rad) on which one side bears: 1 the first, -1 the second, 0 where nothing presses."""

    start: float
    stop: float
    side: int


@dataclass(frozen=True)
class CamForces:
    """A cam under load at a speed ``omega`` (rad/s). ``theta`` (n,) are cam angles, both sides of each join among them.

    With a ``second`` side the follower is closed by form and the contact forces of both are never negative; without it
    the cam only pushes, and where the contact force is negative, the follower lifts off.
    """

    first: ContactPlace
    loads: FollowerLoads
    omega: float
    theta: Array
    second: ContactPlace | None = None

    @cached_property
    def disc(self) -> Disc:
        """The first side's disc with all joins."""
        disc = self.loads.over(self.first.disc)
        return disc if self.second is None else replace(disc, joins=(*disc.joins, *self.second.joins))

    def figure(self, second: bool = False) -> Figure:
        """The contact force (N) on a side, negative where the other one bears, as a figure of the first's look."""
        if not second:
            return lambda look: self.loads.along(look, self.omega) / contact_lever(look)
        assert self.second is not None
        side = self.second
        return lambda look: -self.loads.along(look, self.omega) / contact_lever(side.look(look.theta))

    def values(self, figure: Figure) -> Array:
        """A figure of the first side's look at ``theta``: (n,)."""
        return rows(figure(self.disc.look(self.theta)).d[0], self.theta.size)

    @cached_property
    def along(self) -> Array:
        """The force along the lift (N or N m) that the cam gives: (n,)."""
        return self.values(lambda look: self.loads.along(look, self.omega))

    @cached_property
    def contact(self) -> Array:
        """The contact force (N) along the normal on the first side: (n,); negative: lift-off, or 0 with a second."""
        found = self.values(self.figure())
        return found if self.second is None else np.maximum(found, 0.0)

    @cached_property
    def contact_second(self) -> Array:
        """The contact force (N) on the second side: (n,); 0 without one."""
        if self.second is None:
            return np.zeros_like(self.theta)
        return np.maximum(self.values(self.figure(second=True)), 0.0)

    @cached_property
    def torque(self) -> Array:
        """The torque (N m) that the shaft must give in the sense in which it turns: (n,)."""
        return self.values(self._torque)

    def _torque(self, look: DiscJets) -> Jet:
        return self.loads.along(look, self.omega) * look.lift.rate()

    @cached_property
    def contact_range(self) -> tuple[CamExtreme, CamExtreme]:
        """The least and the largest contact force (N) on the first side; negative where it doesn't bear."""
        return extremes(self.disc, self.figure())

    @cached_property
    def second_range(self) -> tuple[CamExtreme, CamExtreme] | None:
        """The same of the second side."""
        return None if self.second is None else extremes(self.disc, self.figure(second=True))

    @cached_property
    def torque_range(self) -> tuple[CamExtreme, CamExtreme]:
        """The least and the largest torque (N m) of the shaft; the least is negative: the follower drives."""
        return extremes(self.disc, self._torque)

    @cached_property
    def work(self) -> float:
        """What a turn takes (J): the integral of the torque; 0 where all loads depend on the lift alone."""
        return self._integral(1)

    @cached_property
    def torque_rms(self) -> float:
        """The root of the mean square of the torque (N m)."""
        return float(np.sqrt(self._integral(2) / (2 * np.pi)))

    def _integral(self, power: int) -> float:
        nodes, weights = np.polynomial.legendre.leggauss(NODES)
        whole = 0.0
        for start, stop in self.disc.pieces:
            look = self.disc.look(start + (stop - start) * (nodes + 1) / 2)
            whole += float(weights @ rows(self._torque(look).d[0], NODES) ** power) * (stop - start) / 2
        return whole

    @cached_property
    def bearing(self) -> list[Bearing]:
        """Which side bears, stretch by stretch from 0 to 2 pi; without a second side, -1 is where the follower lifts
        off."""
        size = float(np.abs(self.along).max())
        found: list[Bearing] = []
        for start, stop in self.disc.pieces:

            def along(theta: Array, start: float = start, stop: float = stop) -> Array:
                look = self.disc.look(within(theta, start, stop))
                return rows(self.loads.along(look, self.omega).d[0], theta.size)

            for a, b in pairwise([start, *map(float, crossings(along, start, stop, STEPS)), stop]):
                inside = along(np.linspace(a, b, 9)[1:-1])
                most = float(inside[np.abs(inside).argmax()])
                side = int(np.sign(most)) if abs(most) > NOTHING * size else 0
                if found and found[-1].side == side:
                    found[-1] = replace(found[-1], stop=b)
                else:
                    found.append(Bearing(a, b, side))
        return found

    @property
    def reversals(self) -> list[float]:
        """The cam angles (rad) at which the side that bears changes: with play between them the follower knocks."""
        bears = [part for part in self.bearing if part.side]
        turn = zip([bears[-1], *bears] if bears else [], bears, strict=False)
        return [after.start for before, after in turn if before.side != after.side]


def forces(
    disc: Disc, loads: FollowerLoads, omega: float, steps: int = 360, second: ContactPlace | None = None
) -> CamForces:
    """A cam under load at a speed (rad/s), at ``steps`` cam angles and both sides of each join.

    ``second`` is the other side of a follower closed by form (:mod:`linkwright.cam.form_closure`). Raises
    :class:`linkwright.cam.contact.NoContact`.
    """
    first = ContactPlace(disc)
    for side in [first] if second is None else [first, second]:
        drivable(side)
    made = CamForces(first, loads, omega, np.empty(0), second)
    ends = [place for start, stop in made.disc.pieces for place in (start, np.nextafter(stop, start))]
    theta = np.union1d(np.linspace(0.0, 2 * np.pi, steps, endpoint=False), ends)
    return replace(made, theta=theta)
