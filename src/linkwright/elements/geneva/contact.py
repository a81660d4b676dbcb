"""Geneva drives: how the wheel follows the driver, and where the two touch.

With psi the angle of a pin's arm from the line of centres, a the centre distance and lambda = r/a, the pin is in a slot
while cos(psi) > sin(pi/n), that is over pi - 2 pi/n of a turn. There the wheel has turned from the middle position by

    beta = atan2(lambda sin(psi), 1 - lambda cos(psi))

against the driver (external wheel); before and after that it stands at -pi/n and pi/n, and each turn of the driver adds
2 pi/n. Rates come from jets. Source: J. H. Bickford, Mechanisms for Intermittent Motion (1972), on external Geneva
mechanisms.

In the slot the pin bears on a flank, along the normal of the slot's middle line, with the moment arm |O2 P| about the
wheel's centre. In between, the driver's disc of radius R fills the wheel's arc. All its pressure points to the driver's
centre, so that the driver feels no moment. How it is spread is statically indeterminate. Stated is the smallest force
that holds a moment on the wheel: at a horn, the end of the wheel's arc on its rim, where the arm about the wheel's
centre is longest, and which makes contact first where the clearance is the same along the arc. The rim has the radius
a cos(pi/n), so that the horns lie on the disc at the angles +-phi from the line of centres with

    cos(phi) = (R^2 + a^2 sin(pi/n)^2)/(2 a R),

and a force there has the arm a sin(phi). Which horn bears follows from the sign of the moment. Everything works on
numbers, arrays, duals, enclosures and symbols alike.
"""

from __future__ import annotations

from math import isfinite, pi
from typing import TYPE_CHECKING

import numpy as np

from linkwright.data_classes import dataclass
from linkwright.elements.follower import FollowerGeometry, UnitEffort
from linkwright.expressions import units as u
from linkwright.notation import Jet, Pair, Scalar, Wrench
from linkwright.notation.duals import value_of
from linkwright.notation.jets import call
from linkwright.notation.planar import angle_near

if TYPE_CHECKING:
    from linkwright.elements.follower import PoseQuery
    from linkwright.elements.geneva.follower import GenevaDrive

EDGE = 1e-12
"""A pin counts as in the slot where the cosine exceeds its limit by so much: at the very end of a stretch, where
round-off would decide, the wheel is locked."""


@dataclass(frozen=True)
class Dimensions:
    """The dimensions of a Geneva drive at some parameters (SI), in the axes of the links that have them.

    ``centres`` are those of driver and wheel in their links, ``shafts`` the same on the carrier; ``arms`` go from the
    driver's centre to each pin; ``half`` is half the angle between two slots, ``slot`` the direction of one of them.
    """

    centres: tuple[Pair, Pair]
    shafts: tuple[Pair, Pair]
    arms: tuple[Pair, ...]
    half: Scalar
    slot: Scalar
    arc: Scalar

    @classmethod
    def of(cls, geometry: FollowerGeometry, drive: GenevaDrive) -> Dimensions:
        """Those of an entry."""
        entry = drive.geneva
        centres = [geometry.pinned(*end) for end in zip(entry.wheels, entry.centres, strict=True)]
        shafts = [geometry.pinned(drive.on, point) for point in drive.shafts]
        arms = tuple(geometry.point(entry.wheels[0], pin).minus(centres[0]) for pin in entry.pins)
        half = half_angle(geometry.number(entry.slots, u.PURE))
        slot, arc = geometry.number(entry.slot, u.ANGLE), geometry.number(entry.arc, u.LENGTH)
        return cls((centres[0], centres[1]), (shafts[0], shafts[1]), arms, half, slot, arc)

    @property
    def line(self) -> Pair:
        """From the driver's centre to the wheel's, on the carrier."""
        return self.shafts[1].minus(self.shafts[0])

    @property
    def distance(self) -> Scalar:
        """The centre distance (m)."""
        return self.line.length

    @property
    def horn(self) -> tuple[Scalar, Scalar]:
        """Cosine and sine of the angle of a horn from the line of centres, as seen from the driver's centre."""
        a, reach = self.distance, self.distance * call("sin", self.half)
        cosine = (self.arc * self.arc + reach * reach) / (2.0 * (a * self.arc))
        return cosine, call("sqrt", 1.0 - cosine * cosine)


def half_angle(slots: Scalar) -> Scalar:
    """Half the angle (rad) between two slots; infinite without slots."""
    with np.errstate(divide="ignore"):
        return np.divide(pi, slots) if isinstance(slots, int | float) else pi / slots


class Indexing:
    """The wheel's angle on the carrier by the driver's, continuous over all turns; ``nominal`` numbers tell whole
    turns."""

    def __init__(self, drive: GenevaDrive, nominal: Dimensions) -> None:
        self.drive, self.nominal = drive, nominal
        self.turns: list[float] = []
        first = 0.0
        for number, arm in enumerate(nominal.arms):
            angle = self._behind(nominal, arm, arm)
            # The first pin's within half a turn of the line of centres, the others' up to one turn ahead of it.
            low = first if number else -pi
            turns = 2 * pi * -float((angle - low) // (2 * pi)) if isfinite(angle) else 0.0
            self.turns.append(turns)
            first = first if number else angle + turns

    def _behind(self, at: Dimensions, arm: Pair, near: Pair) -> Scalar:
        """The angle (rad) of a pin's arm in the driver less that of the line of centres on the carrier."""
        return angle_near(arm, near) - angle_near(at.line, self.nominal.line)

    def angles(self, at: Dimensions, motor: Jet) -> list[Jet]:
        """Of each pin's arm the angle from the line of centres (rad), over all turns, by the motor's value."""
        known = zip(at.arms, self.nominal.arms, self.turns, strict=True)
        driver = motor * float(self.drive.motor_sign)
        return [driver + (self._behind(at, arm, near) + turns) for arm, near, turns in known]

    def value(self, at: Dimensions, motor: Jet) -> Jet:
        """The wheel's angle on the carrier (rad)."""
        line = angle_near(at.line, self.nominal.line)
        found = Jet.constant(line + pi - at.slot, motor.order)
        for number, (arm, psi) in enumerate(zip(at.arms, self.angles(at, motor), strict=True)):
            turned = advanced(psi, arm.length / at.distance, at.half)
            found = found - (turned - at.half if number else turned)  # the others have turned it by half a slot already
        return found


def advanced(psi: Jet, ratio: Scalar, half: Scalar) -> Jet:
    """By how much a pin has turned the wheel (rad) from where a slot points at the driver: from the pin's angle from
    the line of centres, over all turns, and from the ratio of its radius to the centre distance."""
    turns = value_of(psi.d[0]) / (2 * pi)
    inside = in_slot(call("cos", value_of(psi.d[0])), half)
    pushed = (psi.sin() * ratio).arctan2(1.0 - psi.cos() * ratio) + 2.0 * half * call("floor", turns + 0.5)
    locked = Jet.constant(2.0 * half * (call("floor", turns) + 0.5), psi.order)
    found: Jet = pushed.where(inside, locked)
    return found


def in_slot(cosine: Scalar, half: Scalar) -> Scalar:
    """Whether a pin is in a slot, by the cosine of its angle from the line of centres."""
    return cosine > call("sin", value_of(half)) + EDGE


def contact(poses: PoseQuery, drive: GenevaDrive, sign: int = 1) -> UnitEffort:
    """What 1 N of the contact does that turns the wheel counter-clockwise (``sign`` 1) or clockwise (-1), from the
    poses alone. Its reach is the moment arm (m) about the wheel's centre."""
    bodies, at = poses.bodies, Dimensions.of(poses.geometry, drive)
    driver, wheel = (bodies[link] for link in drive.geneva.wheels)
    shaft, centre = driver.point(at.centres[0]).now, wheel.point(at.centres[1]).now
    line = centre.minus(shaft)
    cosine, sine = at.horn
    size = line.length
    along = Pair(line.x / size, line.y / size)
    force = Pair(cosine, -sign * sine).rotated(along)
    place, reach = shaft.plus(force, at.arc), size * sine
    engaged: Scalar = 0.0
    for arm in at.arms:
        pin = driver.point(at.centres[0].plus(arm)).now
        inside = in_slot(pin.minus(shaft).dot(along) / arm.length, at.half)
        out = pin.minus(centre)
        depth = out.length
        flank = Pair(-sign * out.y / depth, sign * out.x / depth)
        place, force = either(inside, pin, place), either(inside, flank, force)
        reach, engaged = call("where", inside, depth, reach), call("where", inside, 1.0, engaged)
    push = Wrench(force, 0.0, place)
    return UnitEffort(
        {drive.link: push, drive.geneva.wheels[0]: push.opposite}, reach, {"arm": reach, "engaged": engaged}
    )


def either(condition: Scalar, one: Pair, other: Pair) -> Pair:
    """One of two vectors."""
    return Pair(*(call("where", condition, a, b) for a, b in zip(one, other, strict=True)))
