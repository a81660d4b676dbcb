"""Input by sketch: links given by the places of their joints in one pose, their lengths derived and named.

A sketched link has its origin at its first point and its x axis through its second one. Their distance becomes a
parameter (``AB``), and so do the coordinates of further points (``coupler_P_x``, ``coupler_P_y``), each an expression
of the sketched places. A parameter of that name in the file takes its place.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from itertools import chain

from linkwright.elements.cylinder import Cylinder, links_of
from linkwright.elements.drive import Drive
from linkwright.elements.points import links_of_points
from linkwright.expressions.fields import AssemblyRule, Expression, LineOn, Position
from linkwright.expressions.unknown import near
from linkwright.expressions.written import RESERVED, FrozenDict
from linkwright.findings import Finding
from linkwright.model.mechanism import FRAME, Mechanism
from linkwright.model.parts import Joint, Link, Parameter
from linkwright.model.pins import shared_pins

WORD = re.compile(r"\bsketch\b")
_SHORT = re.compile(r"[^\W\d_]\d*")

Path = tuple[str | int, ...]
Text = str
"""An expression as a file would have it."""


class Drawn(AssemblyRule):
    """A rule that the sketch stands for; what the file states on the same group comes first."""

    __slots__ = ()


def with_sketch(m: Mechanism) -> Mechanism:
    """The mechanism with the lengths, assembly rules and starts that its sketch stands for."""
    if not m.sketch:
        return m
    sketch = _Sketch(m)
    links = {name: sketch.link(name, link) for name, link in m.links.items()}
    drives = {name: sketch.drive(drive) for name, drive in m.drives.items()}
    update = {
        "links": FrozenDict(links),
        "drives": FrozenDict(drives),
        "assembly": FrozenDict({**sketch.rules(), **m.assembly}),
        "parameters": FrozenDict({**m.parameters, **sketch.derived, **m.parameters}),
    }
    return m.model_copy(update=update)


class _Sketch:
    def __init__(self, m: Mechanism) -> None:
        self.m = m
        self.derived: dict[str, Parameter] = {}
        self.lengths: set[str] = set()

    def named(self, name: str, value: Text) -> Text:
        """An expression by its name; in full where the name is taken by something that is no parameter."""
        if name in self.m.tables or name in self.m.laws or name in RESERVED:
            return value
        self.derived.setdefault(name, Parameter(value=Expression(value)))
        return name

    def link(self, name: str, link: Link) -> Link:
        """A link with the places of its sketched points in its own axes."""
        known = [point for point in sketched(link) if point in self.m.sketch]
        places: dict[str, Position] = {}
        if name == FRAME:
            places = {point: self.m.sketch[point] for point in known}
        elif known:
            places[known[0]] = Position([0, 0])
            for i, point in enumerate(known[1:]):
                places[point] = Position(self.local(name, known, point) if i else [self.length(*known[:2]), 0])
        return link.model_copy(update={"points": FrozenDict({**link.points, **places})}) if places else link

    def length(self, a: str, b: str) -> Text:
        short = all(_SHORT.fullmatch(point) for point in (a, b))
        name = f"{a}{b}" if short else f"{a}_{b}"
        self.lengths.add(name)
        return self.named(name, self.distance(a, b))

    def local(self, link: str, known: list[str], point: str) -> list[Text]:
        """The coordinates of a further point: its distance from the origin, turned by the angle to the x axis."""
        far = self.distance(known[0], point)
        turn = f"({self.angle(known[0], point)}) - ({self.angle(*known[:2])})"
        parts = (("x", "cos"), ("y", "sin"))
        return [self.named(f"{link}_{point}_{axis}", f"{far}*{function}({turn})") for axis, function in parts]

    def place(self, point: str) -> tuple[Text, Text]:
        """A sketched place, as x and y."""
        at = self.m.sketch[point]
        first, second = at.first.text, at.second.text
        return (f"({first})*cos({second})", f"({first})*sin({second})") if at.polar else (first, second)

    def step(self, a: str, b: str) -> tuple[Text, Text]:
        """The way from one sketched point to another."""
        (x, y), (u, v) = self.place(a), self.place(b)
        return f"({u}) - ({x})", f"({v}) - ({y})"

    def distance(self, a: str, b: str) -> Text:
        return "hypot({}, {})".format(*self.step(a, b))

    def angle(self, a: str, b: str) -> Text:
        x, y = self.step(a, b)
        return f"atan2({y}, {x})"

    def rules(self) -> dict[str, Drawn]:
        """The sketched places of all moving points."""
        fixed = self.m.links[FRAME].points if FRAME in self.m.links else ()
        moving = set(chain.from_iterable(link.points for link in self.m.links.values()))
        return {name: Drawn(list(self.place(name))) for name in self.m.sketch if name in moving - {*fixed}}

    def drive(self, drive: Drive) -> Drive:
        """A drive whose law says `sketch`, or has a speed alone, with its value in the sketch where that is known."""
        value = self.value(drive)
        if value and starts_as_drawn(drive):
            return drive.model_copy(update={"start": Expression(f"({value})")})
        update = {
            key: Expression(WORD.sub(lambda _: f"({value})", law.text))
            for key in ("start", "position")
            if value and (law := getattr(drive, key)) is not None and WORD.search(law.text)
        }
        return drive.model_copy(update=update) if update else drive

    def value(self, drive: Drive) -> Text | None:
        """What a drive prescribes, in the sketch: an angle between two links, a cylinder's length, a travel on the
        frame; of a drive with an output, that of the output.
        """
        if drive.moves and not drive.output:
            return self.along(drive)
        slide = drive.output or drive.extends
        if slide in self.m.cylinders:
            return self.between(self.m.cylinders[slide], self.distance)
        wanted = [drive.slides, drive.on] if drive.slides and slide is None else []
        for name, joint in self.m.prismatic_joints():
            if name == slide or sorted(wanted) == sorted(joint.links):
                return self.travel(joint)
        pair = (drive.output, FRAME) if drive.output else (drive.turns, drive.on)
        angles = [self.axis(link) for link in pair if link]
        return None if None in angles or len(angles) < 2 else f"({angles[0]}) - ({angles[1]})"

    def between(self, cylinder: Cylinder, value: Callable[[str, str], Text]) -> Text | None:
        """Something of the way from one pin of a cylinder to the other, where both are sketched."""
        ends = cylinder.from_, cylinder.to
        return value(*ends) if {*ends} <= self.m.sketch.keys() else None

    def axis(self, link: str) -> Text | None:
        """The angle of a link's x axis in the sketch."""
        if link == FRAME:
            return "0"
        for name, cylinder in self.m.cylinders.items():
            if link in links_of(name):
                return self.between(cylinder, self.angle)
        known = sketched(self.m.links[link])[:2] if link in self.m.links else []
        return self.angle(known[0], known[1]) if len(known) == 2 and {*known} <= self.m.sketch.keys() else None

    def travel(self, joint: Joint) -> Text | None:
        """The travel of a slide whose first link is the frame, between two sketched points."""
        assert joint.line is not None
        return self.distance_along(joint.line[0], joint.line[1].point) if joint.links[0] == FRAME else None

    def along(self, drive: Drive) -> Text | None:
        """The place of a drive's point along a line of the frame, between two sketched points."""
        if drive.on != FRAME or drive.along is None or drive.at is None:
            return None
        return self.distance_along(drive.along, drive.at)

    def distance_along(self, line: LineOn, point: str) -> Text | None:
        """How far along a line of the frame a sketched point lies."""
        if not {line.point, point} <= self.m.sketch.keys():
            return None
        (x, y), angle = self.step(line.point, point), line.angle.text
        return f"({x})*cos({angle}) + ({y})*sin({angle})"


def drawn_parameters(m: Mechanism, stated: bool = False) -> dict[str, bool]:
    """The parameters that a mechanism's sketch stands for and a file may state instead, each with whether it is the
    length of a link; else it is a coordinate of a further point. With ``stated`` those too that the file states."""
    if not m.sketch:
        return {}
    sketch = _Sketch(m)
    for name, link in m.links.items():
        sketch.link(name, link)
    return {name: name in sketch.lengths for name in sketch.derived if stated or name not in m.parameters}


def starts_as_drawn(drive: Drive) -> bool:
    """Whether a drive has a speed, and its start is left to the sketch."""
    return drive.speed is not None and drive.start is None and drive.position is None


def drawn_values(m: Mechanism) -> dict[str, Text]:
    """The value in the sketch of each drive that is given a start, or a position, apart from it."""
    if not m.sketch or "sketch" in m.parameters:
        return {}
    sketch, found = _Sketch(m), {}
    for name, drive in m.drives.items():
        law = drive.start or drive.position
        if law is not None and not WORD.search(law.text) and _sound(m, drive) and (value := sketch.value(drive)):
            found[name] = value
    return found


def drawn_rules(m: Mechanism) -> dict[str, Drawn]:
    """The sketched places of all moving points, as rules of assembly; of a mechanism with or without short forms."""
    return _Sketch(m).rules()


def sketched(link: Link) -> list[str]:
    """The points of a link whose places are those of the sketch."""
    return [name for name, position in link.points.items() if position.sketched]


def sketch_faults(m: Mechanism) -> Iterator[Finding]:
    """Faults of the sketch, before it is spelled out."""
    used = set(shared_pins(m))
    for name, link in m.links.items():
        for point in sketched(link):
            used.add(point)
            if point not in m.sketch:
                data = {"link": name, "name": point, "near": near(point, list(m.sketch))}
                yield Finding("sketch.missing-point", ("links", name, "points"), data)
    for name in m.sketch:
        if name not in used:
            yield Finding("sketch.unused", ("sketch", name), {"name": name})
    for name, drive in m.drives.items():
        for key in ("start", "position"):
            law = getattr(drive, key)
            asked = law is not None and "sketch" not in m.parameters and WORD.search(law.text) and _sound(m, drive)
            if asked and not _has_sketched_value(m, drive):
                yield Finding("sketch.no-value", ("drives", name, key), {"name": name})
        if starts_as_drawn(drive) and _sound(m, drive) and not _has_sketched_value(m, drive):
            yield Finding("drive.start", ("drives", name))


def _has_sketched_value(m: Mechanism, drive: Drive) -> bool:
    """Whether the sketch tells a drive's value."""
    return bool(m.sketch) and _Sketch(m).value(drive) is not None


def _sound(m: Mechanism, drive: Drive) -> bool:
    """Whether all that a drive names is there: else that is its fault, whatever the sketch tells."""
    links = {*m.links, *chain.from_iterable(map(links_of, m.cylinders))}
    named = {drive.turns, drive.on, drive.slides, drive.extends, drive.moves, drive.output} - {None, ""}
    cylinders = [m.cylinders[name] for name in named if name in m.cylinders]
    ends = {end for cylinder in cylinders for end in (cylinder.from_, cylinder.to)}
    return named <= links | m.cylinders.keys() | m.joints.keys() and ends <= {*links_of_points(m), *shared_pins(m)}


def sketch_path(m: Mechanism, path: Path) -> Path | None:
    """Where a place that the sketch made stands in the file."""
    if path[:3] == ("links", FRAME, "points") and path[3:4] and path[3] in m.sketch and FRAME in m.links:
        return ("sketch", path[3]) if path[3] in sketched(m.links[FRAME]) else None
    if len(path) > 1 and path[0] in ("parameters", "assembly") and path[1] not in getattr(m, str(path[0])):
        return ("sketch", path[1]) if path[1] in m.sketch else ("sketch",)
    return None
