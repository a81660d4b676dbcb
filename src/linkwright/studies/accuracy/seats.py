"""Where joints with clearance rest: the contacts of a pin and of a guide, and how an output changes with them.

A pin is one contact of two directions, a guide two contacts (its ends) of one direction each, across it. Each contact
is displaced by the clearance along its force. The clearance as a massless link: Garrett and Hall 1969; docs/theory.md.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, ClassVar, Protocol

import numpy as np

from linkwright.expressions.units import LENGTH
from linkwright.graph.geometry import Geometry
from linkwright.graph.rows import BodyPlace, Named
from linkwright.kernels import Compiled
from linkwright.model.pins import Pin
from linkwright.studies.accuracy.clearance_options import Clearance
from linkwright.studies.accuracy.rollers import on_roller, rollers

Rows = Mapping[Named, Any]
Seats = list[tuple[Any, ...]]
"""For each contact the components of a vector: arrays over poses, or jets of such."""


class Held(Protocol):
    """A link held by another with a clearance (m). ``plays`` are the two offsets of the joint by which the graph
    differentiates, ``rows`` what has to be known of each pose."""

    @property
    def kind(self) -> str:
        """The word for such a joint."""

    @property
    def joint(self) -> str:
        """Its name."""

    @property
    def links(self) -> tuple[str, str]:
        """The link that holds, or the pin where there are three links or more; the link held."""

    @property
    def clearance(self) -> float:
        """The radial clearance, or half the play (m)."""

    @property
    def plays(self) -> tuple[str, str]:
        """Names of the joint's offsets (see :class:`Geometry`)."""

    @property
    def round(self) -> bool:
        """Whether its two displacements are one vector of any direction; else each is one on its own."""

    @property
    def rows(self) -> tuple[Named, ...]:
        """Names of the rows that the methods need."""

    @property
    def places(self) -> tuple[Named, ...]:
        """Those of them that the gradients need: of positions alone."""

    def forces(self, rows: Rows) -> Seats:
        """Force (N) of the second of ``links`` on the first, or on the pin, at each contact."""

    def gradients(self, x: Any, y: Any, rows: Rows) -> Seats:
        """The derivative of an output by the second link's displacement from the first at each contact, from those
        by the two plays."""

    def size(self, x: Any, y: Any) -> Any:
        """What two components at the contacts come to together: of forces what the joint transmits, of gradients the
        largest effect of unit displacements."""

    def displacement(self, seats: Seats) -> tuple[Any, Any]:
        """Displacements at the contacts as that of the second link from the first: of a pin in the frame (m), of a
        guide across it at its centre (m) and the tilt (rad)."""


@dataclass(frozen=True)
class OnPin:
    """A link on a pin, or on the other link there: the pin's journal lies in the bearing at ``clearance``."""

    joint: str
    links: tuple[str, str]
    clearance: float
    kind: ClassVar[str] = "pin"
    round: ClassVar[bool] = True

    @property
    def plays(self) -> tuple[str, str]:
        link = self.links[1]
        return f"{self.joint}/{link}/x", f"{self.joint}/{link}/y"

    @property
    def rows(self) -> tuple[Named, ...]:
        on, link = self.links
        return (*(f"force({link}, {on}, {self.joint}).{axis}" for axis in "xy"), *self.places)

    @property
    def places(self) -> tuple[Named, ...]:
        return BodyPlace(self.links[1], "cos"), BodyPlace(self.links[1], "sin")

    def forces(self, rows: Rows) -> Seats:
        return [(rows[self.rows[0]], rows[self.rows[1]])]

    def gradients(self, x: Any, y: Any, rows: Rows) -> Seats:
        # The play moves the place on the link that is held: where it goes, the link goes the other way.
        cos, sin = (rows[name] for name in self.places)
        return [(y * sin - x * cos, -(x * sin) - y * cos)]

    def size(self, x: Any, y: Any) -> Any:
        return np.hypot(x, y)

    def displacement(self, seats: Seats) -> tuple[Any, Any]:
        ((x, y),) = seats
        return x, y


@dataclass(frozen=True)
class InGuide:
    """The second link of a slide in its guide of ``length`` (m) about ``centre``, a point; ``foot`` is the point of
    the second link's line, ``heading`` the first line's direction in its link."""

    joint: str
    links: tuple[str, str]
    clearance: float
    length: float
    centre: str
    foot: str
    heading: tuple[float, float]
    kind: ClassVar[str] = "guide"
    round: ClassVar[bool] = False

    @property
    def plays(self) -> tuple[str, str]:
        return f"{self.joint}/normal", f"{self.joint}/tilt"

    @cached_property
    def rows(self) -> tuple[Named, ...]:
        first, second = self.links
        force = f"force({second}, {first}, {self.joint})"
        return (f"{force}.normal", f"{force}.moment", *self.places)

    @cached_property
    def places(self) -> tuple[Named, ...]:
        first = self.links[0]
        points = (f"{point}.{axis}" for point in (self.centre, self.foot) for axis in "xy")
        return (BodyPlace(first, "cos"), BodyPlace(first, "sin"), *points)

    def _ahead(self, rows: Rows) -> Any:
        """How far the centre lies ahead of the foot along the line (m)."""
        cos, sin, x, y, foot_x, foot_y = (rows[name] for name in self.places)
        (a, b) = self.heading
        return (x - foot_x) * (cos * a - sin * b) + (y - foot_y) * (sin * a + cos * b)

    def forces(self, rows: Rows) -> Seats:
        normal, moment = rows[self.rows[0]], rows[self.rows[1]]
        turning = (moment - self._ahead(rows) * normal) * (1 / self.length)
        return [(normal * 0.5 + turning,), (normal * 0.5 - turning,)]

    def gradients(self, x: Any, y: Any, rows: Rows) -> Seats:
        across, tilt = -x, self._ahead(rows) * x - y
        return [(across * 0.5 + tilt * (1 / self.length),), (across * 0.5 - tilt * (1 / self.length),)]

    def size(self, x: Any, y: Any) -> Any:
        return np.abs(x) + np.abs(y)

    def displacement(self, seats: Seats) -> tuple[Any, Any]:
        (ahead,), (behind,) = seats
        return (ahead + behind) * 0.5, (ahead - behind) * (1 / self.length)


def held(compiled: Compiled, clearances: Mapping[str, Clearance]) -> list[Held]:
    """What is held with the stated clearances, which are sound."""
    pins, of_rollers = compiled.quantities.signals.pins, rollers(compiled)
    found: list[Held] = []
    for name, entry in clearances.items():
        clearance = compiled.quantities.value(entry.clearance, LENGTH)
        if name in pins:
            found += _on_pin(pins[name], entry, clearance)
        elif name in of_rollers:
            found.append(on_roller(compiled, of_rollers[name], clearance))
        else:
            found.append(_in_guide(compiled, name, entry, clearance))
    return found


def _on_pin(pin: Pin, entry: Clearance, clearance: float) -> Iterator[OnPin]:
    """Of two links the second on the first; of more each on the pin, but the one in which it is fixed."""
    if len(pin.links) == 2:
        yield OnPin(pin.name, (pin.links[0], pin.links[1]), clearance)
    else:
        yield from (OnPin(pin.name, (pin.name, link), clearance) for link in pin.links if link != entry.in_)


def _in_guide(compiled: Compiled, name: str, entry: Clearance, clearance: float) -> InGuide:
    joint = compiled.mechanism.joints[name]
    assert joint.line is not None
    assert entry.length is not None
    foot, length = joint.line[1].point, compiled.quantities.value(entry.length, LENGTH)
    heading = Geometry(compiled.quantities, compiled.quantities.parameters).line(name, joint.links[0])[1]
    direction = float(heading.x), float(heading.y)
    return InGuide(name, (joint.links[0], joint.links[1]), clearance, length, entry.centre or foot, foot, direction)
