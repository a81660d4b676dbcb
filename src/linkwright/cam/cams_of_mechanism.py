"""The cams of a compiled mechanism as discs, and where a disc's own axes lie in the link that carries it.

A disc's axes (:mod:`linkwright.cam.followers`) start at the shaft; x points to a swinging follower's pivot, y along the
way on which a sliding one rises. A swinging follower on the other side is a mirror image: its disc turns the other way.
The second disc of a conjugate pair is such a mirror image of the first, as its contact is on the other side.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from math import atan2, cos, pi, sin
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.cam.disc import Disc
from linkwright.cam.followers import (
    CamFollowerGeometry,
    SwingingFlat,
    SwingingRoller,
    TranslatingFlat,
    TranslatingKnife,
    TranslatingRoller,
)
from linkwright.cam.form_closure import Conjugate, opposite
from linkwright.data_classes import dataclass
from linkwright.elements.cam_contact import cam_followers
from linkwright.elements.cam_contact.contact import CamPair, seat, sense
from linkwright.elements.cam_contact.follower import CamFollower
from linkwright.elements.cam_contact.second import second_seat
from linkwright.expressions import units as u
from linkwright.graph.geometry import Geometry
from linkwright.kernels import Compiled
from linkwright.notation import Jet, Pair, Scalar
from linkwright.notation.jets import call

Array = NDArray[np.float64]
Parameters = Mapping[str, float]


@dataclass(frozen=True)
class Frame:
    """A disc's axes in its link: their ``origin`` (m), the ``angle`` (rad) of x, and +1, or -1 where y is mirrored."""

    origin: tuple[float, float]
    angle: float
    mirror: int

    def placed(self, points: Array) -> Array:
        """Points of the disc (2, ...) in the link's axes, m."""
        c, s = cos(self.angle), sin(self.angle)
        x, y = points[0], self.mirror * points[1]
        return np.stack([self.origin[0] + c * x - s * y, self.origin[1] + s * x + c * y])

    @property
    def mirrored(self) -> Frame:
        """The axes of a pair's second disc, this being the first one's."""
        return replace(self, mirror=-self.mirror)


def disc(compiled: Compiled, name: str, parameters: Parameters | None = None) -> Disc:
    """A cam of a mechanism (SI), at the nominal parameters or at others (all of them, SI).

    Its angle theta is that at which the law is asked: the motor's, counted in the cam's sense, and the phase.
    Raises KeyError where the mechanism has no such cam, ``NoFollower`` or ``MotionError`` where it or its law can't be
    made with the parameters.
    """
    drive, here = _read(compiled, name, parameters)
    law = compiled.motions[drive.cam.law]
    motion = law.checked(parameters or law.nominal)
    follower = _follower(drive, here)
    follower.touch(Jet.constant(0.0, 0))  # which says what it can't reach
    turns = max(1, round(2 * pi / motion.period))
    joins = [at + k * motion.period for k in range(turns) for at in motion.breaks]
    return Disc(follower, motion.on, _mirror(drive) * sense(_geometry(compiled, parameters), drive), tuple(joins))


def second(compiled: Compiled, name: str, parameters: Parameters | None = None) -> Conjugate:
    """The second disc of a cam that is closed by one; undercut ones too. Its axes are ``frame(...).mirrored``.

    Where the file states the second contact, the base circle and what is between follow from its place; else the base
    circle is the stated one or the first one's, and what lies between follows. Raises as :func:`disc`, and
    :class:`linkwright.cam.contact.NoContact`: ``cam.second-side``, ``cam.second-base``.
    """
    drive, here = _read(compiled, name, parameters)
    first, geometry = disc(compiled, name, parameters), _geometry(compiled, parameters)
    there = second_seat(geometry, drive)
    lengths = {} if drive.cam.roller is None else {"roller": float(there.roller)}
    if drive.derived:
        return opposite(first, base=float(there.base), **lengths)
    if here.turns:
        lengths["face" if here.faced else "arm"] = float(there.reach)
    elif not here.faced:
        lengths["offset"] = -float(there.aside)
    return opposite(first, between=here.sign * float(there.offset - here.offset), **lengths)


def frame(compiled: Compiled, name: str, parameters: Parameters | None = None) -> Frame:
    """Where a disc's axes lie in the link that carries it."""
    drive, here = _read(compiled, name, parameters)
    geometry = _geometry(compiled, parameters)
    way = here.pivot.minus(here.shaft) if here.turns else here.way
    angle = atan2(way.y, way.x) - (0.0 if here.turns else pi / 2)
    phase = float(geometry.number(drive.cam.phase, u.ANGLE))
    shaft = geometry.point(drive.cam.cam, drive.shaft[0])
    at = angle + sense(geometry, drive) * phase
    return Frame((float(shaft.x), float(shaft.y)), at, _mirror(drive))


def _geometry(compiled: Compiled, parameters: Parameters | None) -> Geometry:
    return Geometry(compiled.quantities, parameters or compiled.quantities.parameters)


def _read(compiled: Compiled, name: str, parameters: Parameters | None) -> tuple[CamFollower, CamPair]:
    drive = cam_followers(compiled.mechanism)[name]
    return drive, seat(_geometry(compiled, parameters), drive)


def outline(
    geometry: Geometry, drive: CamFollower, angle: Jet, lift: Jet, flanks: Sequence[int]
) -> list[tuple[Scalar, Scalar]]:
    """Places (m) on the ``flanks`` of a cam's first disc (-1: where a follower rests, +1: the outer one of a groove) in
    the axes of its link, from the cam angle (rad) and the lift (m or rad) as jets of it, of order 2.

    Numbers or symbols, as the geometry has them.
    """
    here, mirror = seat(geometry, drive), _mirror(drive)
    made = Disc(_follower(drive, here, lambda value: value), lambda _: lift, mirror * sense(geometry, drive))
    pitch, normal, *_ = made.envelope(angle, made.follower.held(lift + here.start))
    way = here.pivot.minus(here.shaft) if here.turns else Pair(here.way.y, -here.way.x)
    size = way.length
    turn = sense(geometry, drive) * geometry.number(drive.cam.phase, u.ANGLE)
    shaft, found = geometry.point(drive.cam.cam, drive.shaft[0]), []
    for flank in flanks:
        x, y = (p.d[0] + flank * here.roller * n.d[0] for p, n in zip(pitch, normal, strict=True))
        at = Pair(x, mirror * y).rotated(Pair(way.x / size, way.y / size)).rotated(_unit(turn))
        found.append((shaft.x + at.x, shaft.y + at.y))
    return found


def _unit(angle: Scalar) -> Pair:
    return Pair(call("cos", angle), call("sin", angle))


def _mirror(drive: CamFollower) -> int:
    return drive.side if drive.pivot is not None else 1


def _follower(drive: CamFollower, here: CamPair, number: Callable[[Scalar], Any] = float) -> CamFollowerGeometry:
    base, roller, aside, reach = (number(value) for value in (here.base, here.roller, here.aside, here.reach))
    if here.turns:
        distance = number(here.distance)
        return SwingingFlat(base, distance, reach) if here.faced else SwingingRoller(base, roller, distance, reach)
    if here.faced:
        return TranslatingFlat(base)
    return (
        TranslatingRoller(base, roller, aside) if drive.cam.roller is not None else TranslatingKnife(base, 0.0, aside)
    )
