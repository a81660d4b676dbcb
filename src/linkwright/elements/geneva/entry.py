"""What a file says of a Geneva drive, and what may be wrong with its numbers.

For an entry without shock the pin moves along the slot where it enters and leaves it: there the pin's arm is square to
the slot's middle line, which asks for the radius r = a sin(pi/n) at the centre distance a and n slots. The locking
disc, of radius R, has to reach the wheel's rim and to leave the pin room: a (1 - cos(pi/n)) < R < r.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations
from typing import Annotated, Any, ClassVar, Self

import numpy as np
from pydantic import BeforeValidator

from linkwright.elements.entries import NumberFault, StatedPlaces
from linkwright.elements.fields import TwoLinks, point_of_joint
from linkwright.elements.follower import FollowerEntry
from linkwright.elements.geneva.contact import half_angle
from linkwright.elements.mirror import Mirror, Reflection
from linkwright.elements.pitch import WheelsEntry
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Name
from linkwright.expressions.typed_fields import Quantity, Sign
from linkwright.expressions.written import unexpected
from linkwright.notation import Pair
from linkwright.notation.jets import call

EXACT, VARIED = 1e-6, 1e-2
"""By what share of the centre distance the pin's radius may differ from that of an entry without shock, where numbers
are nominal, and where they vary by tolerances."""
FEWEST, MOST = 3, 100
LIMITS = {"fewest": FEWEST, "most": MOST}
"""Slots: with two, the pin's circle would go through the wheel's centre; each one is drawn."""
WHOLE = 1e-9
"""Numbers of slots are whole but for this."""


def _points(raw: Any) -> Any:
    if not isinstance(raw, list | tuple) or not raw:
        raise unexpected("point-names", raw)
    return tuple(raw)


class GenevaEntry(WheelsEntry, FollowerEntry):
    """A driver whose pins turn a wheel by its slots."""

    kind: ClassVar[str] = "geneva"
    signals = {}

    geneva: TwoLinks
    pins: Annotated[tuple[Annotated[Name, point_of_joint(0)], ...], BeforeValidator(_points)]
    slots: Annotated[Expression, Quantity(u.PURE, whole=True)]
    arc: Annotated[Expression, Quantity(u.LENGTH)]
    slot: Annotated[Expression, Quantity(u.ANGLE)] = Expression("0 deg")

    def mirrored(self, name: str, mirror: Mirror) -> Self:
        """The same drive seen in a mirror."""
        mirror.holds(*self.wheels, self.carrier)
        return self.model_copy(update={"slot": Reflection(True).image(self.slot)})

    @property
    def links(self) -> tuple[str, ...]:
        return self.wheels

    @property
    def joint_points(self) -> tuple[str, ...]:
        return ()

    def place_faults(self, places: StatedPlaces, nominal: bool) -> Iterator[NumberFault]:
        n = places.number(self.slots, u.PURE)
        if nominal:
            yield WHOLE - abs(n - np.round(n)), Sign.POSITIVE, ("geneva.slots", LIMITS, "slots")
        yield n - FEWEST + WHOLE, Sign.POSITIVE, ("geneva.slots", LIMITS, "slots")
        yield MOST - n + WHOLE, Sign.POSITIVE, ("geneva.slots", LIMITS, "slots")
        mechanism, driver = places.mechanism, self.wheels[0]
        ends = self.carrier_points(mechanism) if self.carrier in mechanism.links else [None]
        known = mechanism.links[driver].points if driver in mechanism.links else {}
        if None in ends or any(name not in known for name in (self.centres[0], *self.pins)):
            return
        first, second = (places.point(self.carrier, str(point)) for point in ends)
        away = second.minus(first)
        distance = away.length
        data = {"carrier": self.carrier, "distance": places.text_of(distance, u.LENGTH)}
        yield distance, Sign.POSITIVE, ("geneva.concentric", data, "centres")
        if nominal and not (distance > 0 and n >= FEWEST - WHOLE):
            return  # nothing else can be right
        half, slack = call("sin", half_angle(n)), EXACT if nominal else VARIED
        centre = places.point(driver, self.centres[0])
        arms = [places.point(driver, pin).minus(centre) for pin in self.pins]
        yield from self._pin_faults(places, arms, distance, half, slack)
        arc, least = places.number(self.arc, u.LENGTH), distance * (1.0 - call("cos", half_angle(n)))
        shown = {"radius": arc, "low": least, "high": distance * half}
        texts = {key: places.text_of(value, u.LENGTH) for key, value in shown.items()}
        for margin in (arc - least, distance * half - arc):
            yield margin, Sign.POSITIVE, ("geneva.arc", texts, "arc")

    def _pin_faults(
        self, places: StatedPlaces, arms: list[Pair], distance: Any, half: Any, slack: float
    ) -> Iterator[NumberFault]:
        """That each pin enters without shock, and that no two are in slots at a time; ``arms`` are their places about
        the driver's centre (m), ``half`` the sine of half the angle between two slots."""
        wanted = distance * half
        for name, arm in zip(self.pins, arms, strict=True):
            radius = arm.length
            data = {"pin": name, "centre": self.centres[0], "radius": places.text_of(radius, u.LENGTH)}
            data |= {"wanted": places.text_of(wanted, u.LENGTH), "distance": places.text_of(distance, u.LENGTH)}
            margin = slack * distance - call("abs", radius - wanted)
            yield margin, Sign.NOT_NEGATIVE, ("geneva.entry", data, "pins")
        # A pin is in a slot over pi - 2 pi/n of the driver's turn, of which the cosine is 2 half^2 - 1.
        for (one, a), (other, b) in combinations(zip(self.pins, arms, strict=True), 2):
            size = call("sqrt", a.dot(a) * b.dot(b))
            margin = (2.0 * half * half - 1.0 + slack) * size - a.dot(b)
            yield margin, Sign.NOT_NEGATIVE, ("geneva.pins", {"first": one, "second": other}, "pins")
