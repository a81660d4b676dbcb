"""What is drawn of a Geneva drive: the wheel with its slots and arcs, the driver's locking disc with its cut-outs, and
its pins.

Widths that have no influence on motion and forces, those of pins and slots, are chosen so that they look like a drive.
"""

from __future__ import annotations

from math import pi
from typing import TYPE_CHECKING

import numpy as np

from linkwright.elements.curves import Curve, circle, polygon
from linkwright.elements.geneva.contact import Dimensions
from linkwright.expressions import units as u
from linkwright.notation import Pair, Scalar
from linkwright.notation.jets import call
from linkwright.notation.planar import unit_vector

if TYPE_CHECKING:
    from linkwright.elements.follower import FollowerGeometry
    from linkwright.elements.geneva.entry import GenevaEntry

ROUND, ARC = 5, 13
"""Corners of a slot's rounded end, and of an arc of the wheel."""
AROUND = 144
"""Corners of the locking disc."""
WIDE = 0.4
"""Radius of a pin over the room that the locking disc leaves it."""


def outline(at: Dimensions, driver: str, wheel: str, nominal: FollowerGeometry, entry: GenevaEntry) -> list[Curve]:
    """The closed lines of both links; the number of slots is that of the ``nominal`` dimensions."""
    slots = round(float(nominal.number(entry.slots, u.PURE)))
    width = WIDE * (at.distance * call("sin", at.half) - at.arc)
    corners = [corner for number in range(slots) for corner in _sector(at, at.slot + 2.0 * at.half * number, width)]
    lines = [polygon(wheel, [at.centres[1].plus(corner) for corner in corners]), disc(driver, at)]
    return [*lines, *(circle(driver, at.centres[0].plus(arm), width) for arm in at.arms)]


def _sector(at: Dimensions, direction: Scalar, width: Scalar) -> list[Pair]:
    """The wheel's outline about its centre, from the bottom of a slot in some direction to that of the next one."""
    a, rim = at.distance, at.distance * call("cos", at.half)
    bottom = a * (1.0 - call("sin", at.half))
    mouth = call("sqrt", rim * rim - width * width)
    cosine, sine = at.horn
    horn = call("arctan2", sine, cosine)
    along, between = unit_vector(direction), unit_vector(direction + at.half)
    following = unit_vector(direction + 2.0 * at.half)
    rounded = [unit_vector(turn) for turn in np.linspace(-pi, -3 * pi / 2, ROUND)]
    end = [Pair(bottom + width * corner.x, width * corner.y) for corner in rounded]
    shares = np.linspace(-1.0, 1.0, ARC)
    arc = [Pair(a - at.arc * call("cos", horn * share), at.arc * call("sin", horn * share)) for share in shares]
    found = [corner.rotated(along) for corner in (*end, Pair(mouth, width))]
    found += [corner.rotated(between) for corner in arc]
    return [*found, *(Pair(x, -y).rotated(following) for x, y in (Pair(mouth, width), *end[::-1]))]


def disc(driver: str, at: Dimensions) -> Curve:
    """The locking disc: round, but for hollows that end where the pin enters and leaves a slot."""
    edge, reach = call("sin", at.half), call("cos", at.half)  # cosine and sine of the angle at which a cut-out ends
    hollow = at.distance * at.distance + at.arc * at.arc - 2.0 * at.distance * at.arc * edge

    def place(turn: Scalar) -> Pair:
        here, radius = unit_vector(turn), at.arc
        for arm in at.arms:
            size = arm.length
            cosine, sine = here.dot(arm) / size, here.cross(arm) / size
            beside = at.distance * call("fmin", call("abs", sine), reach)
            cut = at.distance * call("fmax", cosine, edge) - call("sqrt", hollow - beside * beside)
            radius = call("where", cosine > edge, cut, radius)
        return at.centres[0].plus(here, radius)

    return Curve(driver, place, (0.0, 2.0 * pi), closed=True, points=AROUND)
