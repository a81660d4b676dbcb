"""Mechanisms with two drives and inverse kinematics in closed form: what values of the drives carry P to a place.

Each has ``reached(z)``: for places z (complex, file's unit) an array of bits, one for each of ``modes``, set where
some values of the drives in their ranges carry P there in that mode; ``placed(q, mode)``: where the values q (2, n; rad
or the file's unit) put P, NaN where the mechanism doesn't close; ``round``: a circle that holds all of P's places;
``spans``: the drives' ranges; ``document()``: the model file.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from helpers.reach.circles import TURN, Points, left, meetings, on_line, turned, within

Bits = NDArray[np.uint8]
Values = NDArray[np.float64]
Span = tuple[float, float]
SIDES = ("left", "right")
UNITS = {"length": "mm", "angle": "deg"}


class Mechanism(Protocol):
    """A mechanism whose places of P are known in closed form."""

    @property
    def modes(self) -> tuple[str, ...]:
        """A word of the rule that states each mode, or nothing where there is one mode."""

    @property
    def round(self) -> tuple[complex, float]:
        """Centre and radius of a circle around all places of P."""

    @property
    def spans(self) -> tuple[Span, Span]:
        """The ranges of the two drives (rad or mm)."""

    def reached(self, z: Points) -> Bits:
        """The modes in which each place is reached, a bit each."""

    def placed(self, q: Values, mode: int) -> Points:
        """Where values of the drives put P."""

    def document(self, start: Values) -> dict[str, Any]:
        """The model file, at rest at values of the drives."""


def sides(found: Bits, ok: NDArray[np.bool_], is_left: NDArray[np.bool_]) -> None:
    """Set the bits of the modes left and right."""
    found |= (ok & is_left).astype(np.uint8) | ((ok & ~is_left).astype(np.uint8) << 1)


def study(**options: Any) -> dict[str, Any]:
    """The workspace of P in all modes."""
    return {"workspace": {"point": "P", "modes": "all", **options}}


def degrees(span: Span | None) -> list[float] | None:
    """A range of angles as the file states it."""
    return None if span is None else [round(math.degrees(end), 6) for end in span]


def ranges(**spans: list[float] | None) -> dict[str, Any]:
    """The section ``drives`` of the study, of those that are stated."""
    given = {name: span for name, span in spans.items() if span is not None}
    return {"drives": given} if given else {}


@dataclass(frozen=True)
class FiveBar:
    """Cranks O1-B (l1) and O4-D (l4), base l5, links B-C (l2) and D-C (l3), P on D-C at ``r``, ``angle`` (rad)."""

    l1: float
    l2: float
    l3: float
    l4: float
    l5: float
    r: float
    angle: float
    motor: Span | None = None
    servo: Span | None = None
    modes = SIDES

    @property
    def round(self) -> tuple[complex, float]:
        return complex(self.l5), self.l4 + self.r

    @property
    def spans(self) -> tuple[Span, Span]:
        return self.motor or (0.0, TURN), self.servo or (0.0, TURN)

    def reached(self, z: Points) -> Bits:
        found = np.zeros(z.shape, np.uint8)
        for d in meetings(self.l5, self.l4, z, self.r):
            some = np.flatnonzero(turned(d - self.l5, self.servo))
            pin = d[some]
            c = pin + (z[some] - pin) * (self.l3 / self.r * np.exp(-1j * self.angle))
            here = np.zeros(some.shape, np.uint8)
            for b in meetings(0j, self.l1, c, self.l2):
                sides(here, turned(b, self.motor), left(b, pin, c))
            found[some] |= here
        return found

    def placed(self, q: Values, mode: int) -> Points:
        b, d = self.l1 * np.exp(1j * q[0]), self.l5 + self.l4 * np.exp(1j * q[1])
        c = meetings(b, self.l2, d, self.l3)[mode]
        return np.asarray(d + (c - d) * (self.r / self.l3 * np.exp(1j * self.angle)))

    def document(self, start: Values) -> dict[str, Any]:
        links = {
            "frame": {"points": {"O1": [0, 0], "O4": [self.l5, 0]}},
            "crank1": {"points": {"O1": [0, 0], "B": [self.l1, 0]}},
            "link2": {"points": {"B": [0, 0], "C": [self.l2, 0]}},
            "link3": {"points": {"D": [0, 0], "C": [self.l3, 0], "P": polar(self.r, self.angle)}},
            "crank4": {"points": {"O4": [0, 0], "D": [self.l4, 0]}},
        }
        drives = {"motor": turns("crank1", start[0]), "servo": turns("crank4", start[1])}
        asked = study(**ranges(motor=degrees(self.motor), servo=degrees(self.servo)))
        return filed(links, drives, asked, assembly={"C": "left of B-D"})


@dataclass(frozen=True)
class TwoCylinders:
    """Two cylinders from A and B (``base`` apart) to the pin P (2-RPR)."""

    base: float
    first: Span
    second: Span
    modes = SIDES

    @property
    def round(self) -> tuple[complex, float]:
        return 0j, self.first[1]

    @property
    def spans(self) -> tuple[Span, Span]:
        return self.first, self.second

    def reached(self, z: Points) -> Bits:
        found = np.zeros(z.shape, np.uint8)
        sides(found, within(abs(z), self.first) & within(abs(z - self.base), self.second), z.imag > 0)
        return found

    def placed(self, q: Values, mode: int) -> Points:
        square = self.base**2
        along = (q[0] ** 2 - q[1] ** 2 + square) / (2 * self.base)
        with np.errstate(invalid="ignore"):
            return np.asarray(along + 1j * np.sqrt(q[0] ** 2 - along**2) * (1 - 2 * mode))

    def document(self, start: Values) -> dict[str, Any]:
        links = {"frame": {"points": {"A": [0, 0], "B": [self.base, 0]}}}
        cylinders = {
            "one": {"from": "A", "to": "P", "length": [*self.first]},
            "two": {"from": "B", "to": "P", "length": [*self.second]},
        }
        drives = {"first": {"extends": "one", **still(start[0])}, "second": {"extends": "two", **still(start[1])}}
        return filed(links, drives, study(), cylinders=cylinders, assembly={"P": "left of A-B"})


@dataclass(frozen=True)
class TwoSlides:
    """Driven slides on lines of the frame through 0 and ``foot``, rods B-C (l2) and D-C (l3) between them (PRRRP); P on
    the second rod at ``r``, ``angle`` (rad). The lines have the directions ``ways`` (rad)."""

    foot: complex
    ways: tuple[float, float]
    l2: float
    l3: float
    r: float
    angle: float
    first: Span
    second: Span
    modes = SIDES

    @property
    def round(self) -> tuple[complex, float]:
        a, b = (self.foot + end * np.exp(1j * self.ways[1]) for end in self.second)
        return complex((a + b) / 2), float(abs(b - a) / 2 + self.r)

    @property
    def spans(self) -> tuple[Span, Span]:
        return self.first, self.second

    def reached(self, z: Points) -> Bits:
        found = np.zeros(z.shape, np.uint8)
        one, two = np.exp(1j * self.ways[0]), np.exp(1j * self.ways[1])
        for s in on_line(self.foot, two, z, self.r):
            some = np.flatnonzero(within(s, self.second))
            d = self.foot + s[some] * two
            c = d + (z[some] - d) * (self.l3 / self.r * np.exp(-1j * self.angle))
            here = np.zeros(some.shape, np.uint8)
            for t in on_line(0j, one, c, self.l2):
                sides(here, within(t, self.first), left(t * one, d, c))
            found[some] |= here
        return found

    def placed(self, q: Values, mode: int) -> Points:
        b, d = q[0] * np.exp(1j * self.ways[0]), self.foot + q[1] * np.exp(1j * self.ways[1])
        c = meetings(b, self.l2, d, self.l3)[mode]
        return np.asarray(d + (c - d) * (self.r / self.l3 * np.exp(1j * self.angle)))

    def document(self, start: Values) -> dict[str, Any]:
        links = {
            "frame": {"points": {"F": [0, 0], "G": [self.foot.real, self.foot.imag]}},
            "slider1": {"points": {"B": [0, 0]}},
            "slider2": {"points": {"D": [0, 0]}},
            "link2": {"points": {"B": [0, 0], "C": [self.l2, 0]}},
            "link3": {"points": {"D": [0, 0], "C": [self.l3, 0], "P": polar(self.r, self.angle)}},
        }
        one, two = (f"{math.degrees(way):.6g} deg" for way in self.ways)
        joints = {
            "rail1": {"prismatic": ["frame", "slider1"], "line": [f"F at {one}", "B at 0 deg"]},
            "rail2": {"prismatic": ["frame", "slider2"], "line": [f"G at {two}", "D at 0 deg"]},
        }
        drives = {"first": slides("slider1", "frame", start[0]), "second": slides("slider2", "frame", start[1])}
        asked = study(**ranges(first=[*self.first], second=[*self.second]))
        return filed(links, drives, asked, joints=joints, assembly={"C": "left of B-D"})


@dataclass(frozen=True)
class Guide:
    """A driven crank about the origin with a guide ``offset`` aside, and on it a driven slider with P at ``p``."""

    offset: float
    p: complex
    crank: Span | None
    slide: Span
    modes = ("",)

    @property
    def round(self) -> tuple[complex, float]:
        along = max(abs(end + self.p.real) for end in self.slide)
        return 0j, math.hypot(along, self.offset + self.p.imag)

    @property
    def spans(self) -> tuple[Span, Span]:
        return self.crank or (0.0, TURN), self.slide

    def reached(self, z: Points) -> Bits:
        aside = self.offset + self.p.imag
        with np.errstate(invalid="ignore"):
            along = np.sqrt(z.real**2 + z.imag**2 - aside**2)
        found = np.zeros(z.shape, np.bool_)
        for here in (along, -along):
            found |= within(here - self.p.real, self.slide) & turned(z / (here + 1j * aside), self.crank)
        return found.astype(np.uint8)

    def placed(self, q: Values, mode: int) -> Points:
        return np.asarray((q[1] + self.p + 1j * self.offset) * np.exp(1j * q[0]))

    def document(self, start: Values) -> dict[str, Any]:
        links = {
            "frame": {"points": {"O": [0, 0]}},
            "crank": {"points": {"O": [0, 0], "A": [0, self.offset]}},
            "slider": {"points": {"E": [0, 0], "P": [self.p.real, self.p.imag]}},
        }
        joints = {"guide": {"prismatic": ["crank", "slider"], "line": ["A at 0 deg", "E at 0 deg"]}}
        drives = {"motor": turns("crank", start[0]), "ram": slides("slider", "crank", start[1])}
        asked = study(**ranges(motor=degrees(self.crank), ram=[*self.slide]))
        return filed(links, drives, asked, joints=joints)


@dataclass(frozen=True)
class Chain:
    """A four-bar O1-B (l1), B-C (l2), O4-C (l3), base l5, driven at O1; on its rocker a driven arm C-P (r)."""

    l1: float
    l2: float
    l3: float
    l5: float
    r: float
    motor: Span | None = None
    elbow: Span | None = None
    modes = SIDES

    @property
    def round(self) -> tuple[complex, float]:
        return complex(self.l5), self.l3 + self.r

    @property
    def spans(self) -> tuple[Span, Span]:
        return self.motor or (0.0, TURN), self.elbow or (0.0, TURN)

    def reached(self, z: Points) -> Bits:
        found = np.zeros(z.shape, np.uint8)
        for c in meetings(self.l5, self.l3, z, self.r):
            rocker = c - self.l5
            some = np.flatnonzero(turned((z - c) / rocker, self.elbow))
            pin = c[some]
            here = np.zeros(some.shape, np.uint8)
            for b in meetings(0j, self.l1, pin, self.l2):
                sides(here, turned(b, self.motor), left(b, np.full_like(b, self.l5), pin))
            found[some] |= here
        return found

    def placed(self, q: Values, mode: int) -> Points:
        c = meetings(self.l1 * np.exp(1j * q[0]), self.l2, complex(self.l5), self.l3)[mode]
        return np.asarray(c + (c - self.l5) * (self.r / self.l3 * np.exp(1j * q[1])))

    def document(self, start: Values) -> dict[str, Any]:
        links = {
            "frame": {"points": {"O1": [0, 0], "O4": [self.l5, 0]}},
            "crank": {"points": {"O1": [0, 0], "B": [self.l1, 0]}},
            "coupler": {"points": {"B": [0, 0], "C": [self.l2, 0]}},
            "rocker": {"points": {"O4": [0, 0], "C": [self.l3, 0]}},
            "arm": {"points": {"C": [0, 0], "P": [self.r, 0]}},
        }
        drives = {"motor": turns("crank", start[0]), "elbow": turns("arm", start[1], on="rocker")}
        asked = study(**ranges(motor=degrees(self.motor), elbow=degrees(self.elbow)))
        return filed(links, drives, asked, assembly={"C": "left of B-O4"})


def filed(links: Any, drives: Any, asked: Any, **sections: Any) -> dict[str, Any]:
    """A model file."""
    return {"linkwright": 1, "units": UNITS, "links": links, **sections, "drives": drives, "studies": asked}


def polar(r: float, angle: float) -> str:
    """A point as the file states it."""
    return f"{r} at {math.degrees(angle):.6g} deg"


def turns(link: str, at: float, on: str = "frame") -> dict[str, Any]:
    """A drive that turns a link and rests at an angle (rad)."""
    return {"turns": link, "on": on, "position": f"{math.degrees(at):.6f} deg + 0.001 deg*t/(1 s)"}


def slides(link: str, on: str, at: float) -> dict[str, Any]:
    """A drive that moves a slider and rests."""
    return {"slides": link, "on": on, **still(at)}


def still(at: float) -> dict[str, Any]:
    """The law of a length that hardly changes."""
    return {"position": f"{at:.6f} mm + 0.0001 mm*t/(1 s)"}
