"""A plate cam: pitch curve, profile, their curvature and the pressure angle, exact, at any cam angle.

A point x of the fixed frame is R(-sense theta) x in the cam's. With the roller's centre C(theta) in the fixed frame the
pitch curve is c = R(-sense theta) C; its outward normal n is common to it, to the profile c - r n and to all that is
offset from it. A flat face touches its envelope at H n + dH/dphi J n, phi being the direction of its normal in the
cam's frame and H its distance. Curvature 1/rho = -sense (c' x c'') / |c'|^3, positive where the cam is convex; of a
flat face rho = H + d2H/dphi2. (Rothbart, Cam Design Handbook, 2004, ch. 7; Norton, Cam Design and Manufacturing
Handbook, ch. 7.)
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.cam.followers import CamFollowerGeometry, ContactJets, Vector, cross, dot, rotated
from linkwright.data_classes import dataclass
from linkwright.notation import Jet

Array = NDArray[np.float64]
Lift = Callable[[Jet], Jet]
"""The lift (m or rad) with its derivatives as a jet, from the cam angle as a jet."""

TURN = 2 * math.pi
ORDER = 3
KEPT = 1024
"""The most steps of a stretch at which the cam is kept."""


@dataclass(frozen=True)
class DiscJets:
    """A cam at some angles, jets of the cam angle whose entries are (n,).

    ``lift`` is of order 3. In the cam's frame: ``pitch`` is the pitch curve (without a roller: the profile), ``normal``
    its outward unit normal. ``curvature`` is the pitch curve's (1/m), ``pressure`` the signed pressure angle (rad) from
    the normal to the follower's velocity, positive on a rise without offset; ``speed`` the length of the pitch curve's
    derivative. In the fixed frame: ``centre`` is the roller's centre or the edge or place of contact, ``along`` the
    normal there, ``arm`` the derivative of that place of the follower by the lift.
    """

    theta: Array
    lift: Jet
    pitch: Vector
    normal: Vector
    curvature: Jet
    pressure: Jet
    speed: Jet
    centre: Vector
    along: Vector
    arm: Vector

    def offset(self, by: float) -> Array:
        """The curve ``by`` (m) outward of the pitch curve, in the cam's frame: (2, n)."""
        rows = [
            np.broadcast_to(p.d[0] + by * n.d[0], self.theta.shape)
            for p, n in zip(self.pitch, self.normal, strict=True)
        ]
        return np.array(rows)

    def radius(self, by: float = 0.0) -> Array:
        """The radius of curvature (m) of the curve ``by`` outward of the pitch curve: (n,)."""
        with np.errstate(divide="ignore"):
            return np.asarray(1.0 / np.broadcast_to(self.curvature.d[0], self.theta.shape) + by)


def inside(theta: Array, start: float, stop: float) -> Array:
    """Angles kept within a piece of the law: at its end, where the next one begins, those from the left."""
    return np.clip(theta, start, np.nextafter(stop, start))


@dataclass(frozen=True)
class Disc:
    """A follower on a cam that turns in the sense ``sense`` (+1: counter-clockwise), with its lift over a turn.

    ``joins`` are the angles, 0 .. 2 pi, at which the law of the lift changes; values there are those from the right.
    """

    follower: CamFollowerGeometry
    lift: Lift
    sense: int = 1
    joins: Sequence[float] = (0.0,)

    @cached_property
    def pieces(self) -> list[tuple[float, float]]:
        """The cam angles between joins: (start, stop) of each, a turn in all."""
        starts = sorted({float(join) % TURN for join in self.joins} | {0.0})
        return list(zip(starts, [*starts[1:], TURN], strict=True))

    @cached_property
    def known_extremes(self) -> dict[Any, Any]:
        """What has been found out about it: :func:`linkwright.cam.extremes.extremes`."""
        return {}

    @cached_property
    def _grids(self) -> dict[tuple[float, float, int, int], tuple[Array, DiscJets]]:
        return {}

    def grid(self, start: float, stop: float, steps: int, order: int = ORDER) -> tuple[Array, DiscJets]:
        """Equal steps over a stretch within a piece, and the cam there, at its end from the left; kept, as many figures
        are looked for on the same stretches."""
        key = start, stop, steps, order
        if key not in self._grids:
            theta = np.linspace(start, stop, steps + 1)
            self._grids[key] = theta, self.look(inside(theta, start, stop), order)
        return self._grids[key]

    def within(self, theta: Array, start: float, stop: float) -> DiscJets:
        """The cam at angles (n,) within a piece, at its end from the left; see :meth:`grid` for equal steps."""
        steps = theta.size - 1
        if 1 < steps <= KEPT and np.array_equal(theta, np.linspace(start, stop, steps + 1)):
            return self.grid(start, stop, steps)[1]
        return self.look(inside(theta, start, stop))

    def look(self, theta: Array, order: int = ORDER) -> DiscJets:
        """The cam at angles (n,); of a lower ``order`` that of the lift, and all else with it."""
        theta = np.asarray(theta, dtype=float)
        angle = Jet([theta, np.ones_like(theta), *(np.zeros_like(theta) for _ in range(order - 1))])
        lift = self.lift(angle)
        with np.errstate(divide="ignore", invalid="ignore"):  # in a cusp the curvature is infinite
            made = self.envelope(angle, self.follower.touch(lift))
        return DiscJets(theta, lift, *made)

    def envelope(self, angle: Jet, touch: ContactJets) -> tuple[Vector, Vector, Jet, Jet, Jet, Vector, Vector, Vector]:
        """The parts of :class:`DiscJets` from ``pitch`` on, from the cam angle and what the follower holds against the
        cam as jets of it, of order 2 at least; numbers or symbols."""
        return self._flat_face_contact(angle, touch) if self.follower.faced else self._roller_contact(angle, touch)

    def _roller_contact(
        self, angle: Jet, touch: ContactJets
    ) -> tuple[Vector, Vector, Jet, Jet, Jet, Vector, Vector, Vector]:
        centre = touch.at
        assert centre is not None
        way = self._rate_in_cam(centre)
        square = dot(way, way)
        speed = square.sqrt()
        along = -self.sense * way[1] / speed, self.sense * way[0] / speed
        curvature = -self.sense * cross(way, self._rate_in_cam(way)) / (square * speed)
        pitch, normal = rotated(-self.sense * angle, centre, along)
        arm = self.follower.velocity(centre)
        return pitch, normal, curvature, self._pressure(along, arm), speed, centre, along, arm

    def _rate_in_cam(self, a: Vector) -> Vector:
        """The derivative of a vector as the cam sees it, in directions of the fixed frame."""
        return a[0].rate() + self.sense * a[1], a[1].rate() - self.sense * a[0]

    def _flat_face_contact(
        self, angle: Jet, touch: ContactJets
    ) -> tuple[Vector, Vector, Jet, Jet, Jet, Vector, Vector, Vector]:
        facing, height, along = touch.facing, touch.height, touch.along
        assert facing is not None and height is not None and along is not None
        direction = facing - self.sense * angle
        slope = height.rate() / direction.rate()
        normal = direction.cos(), direction.sin()
        pitch = height * normal[0] - slope * normal[1], height * normal[1] + slope * normal[0]
        radius = height + slope.rate() / direction.rate()
        contact = height * along[0] - slope * along[1], height * along[1] + slope * along[0]
        arm = self.follower.velocity(contact)
        speed = radius * abs(direction.rate())
        return pitch, normal, 1.0 / radius, self._pressure(along, arm), speed, contact, along, arm

    def _pressure(self, along: Vector, arm: Vector) -> Jet:
        return (-self.sense * cross(along, arm)).arctan2(dot(along, arm))
