"""A random mechanism while it grows: every point is put into the plane first, so that each joint closes at the start.

Growers add links, joints and drives, and whatever acts on them. Each is registered under the words of the vocabulary
that it covers (:func:`grows`). Values that depend on the axes of links, such as directions and angles of drives, are
functions: a link gets its axes when the file is written. Lengths are in mm, angles in deg.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any

FRAME = "frame"
XY = tuple[float, float]
Data = dict[str, Any]
CALM, SMALL = 110.0, 14.0
"""How far from a link's middle its joints lie: of a link that swings, and of one that turns round and round."""
DIGITS = 12
UNITS = {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"}


def polar(radius: float, angle: float) -> XY:
    """A vector by its length and direction (deg)."""
    return radius * math.cos(math.radians(angle)), radius * math.sin(math.radians(angle))


def away(at: XY, radius: float, angle: float) -> XY:
    """The place so far from another in a direction (deg)."""
    step = polar(radius, angle)
    return at[0] + step[0], at[1] + step[1]


def heading(start: XY, end: XY) -> float:
    """The direction from one place to another (deg)."""
    return math.degrees(math.atan2(end[1] - start[1], end[0] - start[0]))


def left_of(start: XY, end: XY, at: XY) -> bool:
    """Whether a place is on the left, seen from the first to the second."""
    return (end[0] - start[0]) * (at[1] - start[1]) - (end[1] - start[1]) * (at[0] - start[0]) > 0


def rounded(value: float) -> float:
    """A number as the file has it."""
    return round(value, DIGITS) + 0.0


@dataclass
class Growing:
    """A mechanism on the way. ``places`` has each link's points where they are in the frame at the start, ``axes`` its
    origin and the direction of its x axis, ``home`` about where its joints are, ``known`` the links whose motion is
    determined, in their order; ``shafts`` the pins about which a known link turns on another."""

    random: random.Random
    places: dict[str, dict[str, XY]] = field(default_factory=lambda: {FRAME: {}})
    axes: dict[str, tuple[float, float, float]] = field(default_factory=lambda: {FRAME: (0.0, 0.0, 0.0)})
    home: dict[str, XY] = field(default_factory=lambda: {FRAME: (0.0, 0.0)})
    reach: dict[str, float] = field(default_factory=lambda: {FRAME: 160.0})
    known: list[str] = field(default_factory=lambda: [FRAME])
    shafts: list[tuple[str, str, str]] = field(default_factory=list)
    turning: set[str] = field(default_factory=set)
    data: dict[str, Data] = field(default_factory=dict)
    carried: bool = False
    count: int = 0

    # What there is.

    def section(self, name: str) -> Data:
        """A section of the file."""
        return self.data.setdefault(name, {})

    def name(self, letter: str) -> str:
        """A name that nothing has."""
        self.count += 1
        return f"{letter}{self.count}"

    def moving(self) -> list[str]:
        """The moving links."""
        return [link for link in self.places if link != FRAME]

    def points(self) -> list[tuple[str, str]]:
        """Every point with a link that has it, moving ones."""
        return [(link, point) for link in self.moving() for point in self.places[link]]

    def size(self) -> int:
        """The number of moving links, those of cylinders and copies too."""
        inside = sum(len(self.data["subassemblies"][c["of"]]["links"]) - 1 for c in self.section("copies").values())
        return len(self.places) - 1 + 2 * len(self.section("cylinders")) + inside

    # What is added.

    def link(self, at: XY, reach: float = CALM) -> str:
        """A new link with its origin near a place."""
        name = self.name("b")
        uniform = self.random.uniform
        self.axes[name] = (at[0] + uniform(-20, 20), at[1] + uniform(-20, 20), uniform(-179, 179))
        self.places[name], self.home[name], self.reach[name] = {}, at, reach
        return name

    def settle(self, *links: str) -> None:
        """Their motion is determined."""
        self.known += links

    def put(self, at: XY, *links: str, name: str | None = None) -> str:
        """A point at a place, of one link or pinned on several."""
        name = name or self.name("P")
        for link in links:
            self.places[link][name] = at
        return name

    def pin(self, at: XY, a: str, b: str) -> str:
        """A pin of two links; now and then of points of different names."""
        if self.random.random() < 0.06:
            name, ends = self.name("R"), [self.put(at, a), self.put(at, b)]
            self.section("joints")[name] = {"revolute": [a, b], "at": ends}
            return name
        return self.put(at, a, b)

    def slide(self, a: str, b: str, at: XY, direction: float) -> str:
        """A prismatic joint of two links along a direction (deg)."""
        name = self.name("S")
        line = [self.line(a, at, direction), self.line(b, away(at, self.random.uniform(-30, 30), direction), direction)]
        self.section("joints")[name] = {"prismatic": [a, b], "line": line}
        return name

    def line(self, link: str, at: XY, direction: float) -> Callable[[], str]:
        """A line of a link through a new point of it."""
        return self.line_of(link, self.put(at, link), direction)

    def line_of(self, link: str, point: str, direction: float) -> Callable[[], str]:
        """A line of a link through one of its points."""
        return lambda: f"{point} at {rounded(direction - self.axes[link][2])} deg"

    def angle(self, link: str, on: str = FRAME) -> float:
        """The angle of a link against another at the start, when all axes are settled (deg)."""
        return self.axes[link][2] - self.axes[on][2]

    def hint(self, link: str) -> None:
        """Tell where a link is at the start, by a point that is away from its pins."""
        at = away(self.home[link], self.random.uniform(40, 90), self.random.uniform(0, 360))
        point = self.put(at, link)
        self.section("assembly")[point] = [rounded(at[0]), rounded(at[1])]

    def tell(self, point: str, at: XY) -> None:
        """Tell where a point is at the start."""
        self.section("assembly")[point] = [rounded(at[0]), rounded(at[1])]

    # Where something new may be.

    def base(self, *but: str) -> str:
        """A known link, rather a late one."""
        there = [link for link in self.known if link not in but]
        return self.random.choice(there[-6:] if self.random.random() < 0.7 else there)

    def spot(self, link: str, near: XY | None = None) -> XY:
        """A place for a joint on a link; on the frame, about so far from another."""
        uniform = self.random.uniform
        if link == FRAME and near is not None:
            return away(near, uniform(70, 200), uniform(0, 360))
        return away(self.home[link], self.reach[link] * uniform(0.35, 1.0), uniform(0, 360))

    # How it is written.

    def local(self, link: str, at: XY) -> list[float]:
        """A place in a link's own axes."""
        x, y, turned = self.axes[link]
        cos, sin = math.cos(math.radians(turned)), math.sin(math.radians(turned))
        dx, dy = at[0] - x, at[1] - y
        return [rounded(cos * dx + sin * dy), rounded(cos * dy - sin * dx)]

    def written(self, links: Data) -> Data:
        """The model file with these links: all other sections, their functions called."""
        sections = {name: entries for name, entries in self.data.items() if entries != {}}
        made: Data = called({"linkwright": 1, "units": UNITS, "links": links, **sections})
        return made


def called(value: Any) -> Any:
    """The same with the values of functions in their place."""
    if callable(value):
        return called(value())
    if isinstance(value, dict):
        return {key: called(inside) for key, inside in value.items()}
    if isinstance(value, list):
        return [called(inside) for inside in value]
    return rounded(value) if isinstance(value, float) else value


@dataclass(frozen=True)
class Grower:
    """A function that adds to a mechanism: the stage at which it does, its weight within it, the words of the
    vocabulary that it covers."""

    stage: str
    grow: Callable[[Growing], None]
    weight: float
    covers: tuple[str, ...]


GROWERS: dict[str, Grower] = {}


def grows(stage: str, *covers: str, weight: float = 1.0) -> Callable[[Any], Any]:
    """Register a grower under its function's name."""

    def entered(grow: Callable[[Growing], None]) -> Callable[[Growing], None]:
        name = grow.__name__
        assert name not in GROWERS
        GROWERS[name] = Grower(stage, grow, weight, covers)
        return grow

    return entered


def at_stage(stage: str) -> Iterator[Grower]:
    """The growers of a stage."""
    return (grower for grower in GROWERS.values() if grower.stage == stage)
