"""Random mechanisms, made from a sketch at t = 0: driven links first, then dyads of any kind on known links.

The sketch places every joint and every link's frame in the plane, so the pose at t = 0, the drives' start values
and the assembly modes are known without solving anything.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any, Protocol, TypeVar

from hypothesis import strategies as st

from helpers.plain import FRAME, XY, Law, Plain, PlainDrive, PlainLink, PlainLoad, PlainSlide, turned

T = TypeVar("T")
DURATION = 0.4
"""The span of time (s) in which the sketches stay away from singular poses, mostly."""


class Source(Protocol):
    """Where a sketch draws its numbers from."""

    def uniform(self, low: float, high: float) -> float: ...

    def pick(self, options: Sequence[T]) -> T: ...


class Seeded:
    """Numbers from a seed."""

    def __init__(self, seed: int) -> None:
        self.random = random.Random(seed)

    def uniform(self, low: float, high: float) -> float:
        return self.random.uniform(low, high)

    def pick(self, options: Sequence[T]) -> T:
        return self.random.choice(options)


class Drawn:
    """Numbers that hypothesis draws, and shrinks."""

    def __init__(self, draw: Callable[..., Any]) -> None:
        self.draw = draw

    def uniform(self, low: float, high: float) -> float:
        return float(self.draw(st.floats(low, high)))

    def pick(self, options: Sequence[T]) -> T:
        return self.draw(st.sampled_from(options))  # type: ignore[no-any-return]


class Sketch:
    """A mechanism under construction in the plane."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self.pose: dict[str, tuple[float, float, float]] = {FRAME: (0.0, 0.0, 0.0)}
        self.points: dict[str, dict[str, XY]] = {FRAME: {}}
        self.pins: dict[str, list[tuple[str, str]]] = {}
        self.slides: dict[str, PlainSlide] = {}
        self.drives: dict[str, PlainDrive] = {}
        self.assembly: dict[str, Any] = {}
        self.loads: dict[str, PlainLoad] = {}
        self.kinds: list[str] = []

    # Numbers.

    def flag(self, *odds: bool) -> bool:
        return self.source.pick(odds or (False, True))

    def anywhere(self, reach: float = 2.0) -> XY:
        return self.source.uniform(-reach, reach), self.source.uniform(-reach, reach)

    def angle(self) -> float:
        return self.source.uniform(-3.1, 3.1)

    def aslant(self) -> float:
        """An angle whose sine is well away from zero."""
        return self.source.uniform(0.5, 2.6) * self.source.pick((1, -1))

    def off(self, at: XY, angle: float, along: float, across: float = 0.0) -> XY:
        step = turned((along, across), angle)
        return at[0] + step[0], at[1] + step[1]

    # Parts.

    def link(self) -> str:
        name = f"L{len(self.pose)}"
        self.pose[name] = (*self.anywhere(), self.angle())
        self.points[name] = {}
        return name

    def place(self, link: str, name: str, at: XY) -> None:
        """Give a link a point at a place of the sketch."""
        x, y, angle = self.pose[link]
        self.points[link][name] = turned((at[0] - x, at[1] - y), -angle)

    def pin(self, at: XY, *links: str) -> str:
        """A pin, by points of one name, or now and then by a joint between points of two names."""
        name = f"P{len(self.pins) + 1}"
        other = self.flag(False, False, False, True)
        self.pins[name] = [(link, f"{name}{'ab'[i]}" if other else name) for i, link in enumerate(links)]
        for link, point in self.pins[name]:
            self.place(link, point, at)
        return name

    def known_pin(self, link: str, without: str = "") -> str | None:
        """A pin of a link, not shared with the link ``without``, that one more link can be put on."""
        names = [
            name
            for name, members in self.pins.items()
            if (link, name) in members and all(p == name and m != without for m, p in members)
        ]
        return self.source.pick(names) if names else None

    def where(self, link: str, point: str) -> XY:
        x, y, angle = self.pose[link]
        dx, dy = turned(self.points[link][point], angle)
        return x + dx, y + dy

    def slide(self, a: str, b: str, through: XY, angle: float) -> str:
        """A prismatic joint on a line of the sketch; its points lie anywhere on the line."""
        name = f"S{len(self.slides) + 1}"
        places = [self.off(through, angle, self.source.uniform(-1.0, 1.0)) for _ in (a, b)]
        entries = [(a, f"{name}a", places[0]), (b, f"{name}b", places[1])]
        for link, point, at in entries:
            self.place(link, point, at)
        if self.flag():
            entries.reverse()
        (first, p1, _), (second, p2, _) = entries
        angles = tuple(angle - self.pose[link][2] for link in (first, second))
        self.slides[name] = PlainSlide((first, second), (p1, p2), angles)  # type: ignore[arg-type]
        return name

    def outer(self, kind: str, base: str, link: str, at: XY, angle: float) -> str:
        return self.pin(at, base, link) if kind == "R" else self.slide(base, link, at, angle)

    def share(self, pin: str, link: str) -> str:
        """Put one more link on a pin."""
        self.place(link, pin, self.where(self.pins[pin][0][0], pin))
        self.pins[pin].append((link, pin))
        return pin

    def drive(self, kind: str, base: str) -> str:
        """A link driven against a known one, the two named either way round; at times on a pin that is there."""
        link, name = self.link(), f"M{len(self.drives) + 1}"
        known = self.known_pin(base) if kind == "R" and self.flag(False, False, True) else None
        joint = self.share(known, link) if known else self.outer(kind, base, link, self.anywhere(), self.angle())
        moved, on = (link, base) if self.flag(True, True, False) else (base, link)
        if kind == "R":
            value, size = self.pose[moved][2] - self.pose[on][2], 1.0
        else:
            s = self.slides[joint]
            ends = {end: self.where(end, point) for end, point in zip(s.links, s.points, strict=True)}
            angle = self.pose[s.links[0]][2] + s.angles[0]
            gap = ends[moved][0] - ends[on][0], ends[moved][1] - ends[on][1]
            value, size = turned(gap, -angle)[0], 0.4
        speed = size * self.source.uniform(0.2, 0.8) * self.source.pick((1, -1))
        if self.flag():
            law = Law(value, speed)
        else:
            amp, phase = 0.1 * size, self.source.uniform(-1.5, 1.5)
            law = Law(value - amp * math.sin(phase), speed, amp, 3.0, phase)
        self.drives[name] = PlainDrive("turns" if kind == "R" else "slides", moved, on, law)
        return link

    def dyad(self, kind: str, first: str, second: str) -> tuple[str, str]:
        """Two links on two known ones, joined by the letters of ``kind``; far from a singular pose."""
        a, b = self.link(), self.link()
        self.kinds.append(kind)
        uniform = self.source.uniform
        at, phi, eps = self.anywhere(), self.angle(), self.aslant()
        shared = self.known_pin(first, second) if kind[0] == "R" and self.flag() else None
        if shared is not None:
            at = self.where(first, shared)
            self.share(shared, a)
        r1, r2 = uniform(0.5, 2.0), uniform(0.5, 2.0)
        start = shared or (self.pin(at, first, a) if kind[0] == "R" else "")
        if kind == "RRR":
            middle = self.off(at, phi, r1)
            inner = self.pin(middle, a, b)
            known = self.known_pin(second, first) if self.flag(False, False, True) else None
            if known not in (None, shared) and math.dist(at, self.where(second, known)) > 0.3:
                end, end_at = self.share(known, b), self.where(second, known)
            else:
                end_at = self.off(middle, phi + eps, r2)
                end = self.pin(end_at, second, b)
            side = (end_at[0] - at[0]) * (middle[1] - at[1]) - (end_at[1] - at[1]) * (middle[0] - at[0])
            self.choose(inner, f"{'left' if side > 0 else 'right'} of {start}-{end}", inner, middle)
        elif kind == "RRP":
            middle, heading = self.off(at, phi, r1), phi + eps - math.pi / 2
            inner = self.pin(middle, a, b)
            end = self.slide(second, b, self.off(middle, heading, 0.0, uniform(-1.0, 1.0)), heading)
            ahead = self.ahead(at, middle, end)
            self.choose(inner, f"{ahead} of {start} along {end}", inner, middle)
        elif kind == "RPR":
            end_at, heading = self.off(at, phi, r1), phi + eps - math.pi / 2
            end = self.pin(end_at, second, b)
            inner = self.slide(a, b, self.anywhere(), heading)
            self.place(a, f"K{a}", mark := self.off(at, phi, uniform(0.5, 1.0), uniform(0.5, 1.0)))
            self.choose(end, f"{self.ahead(at, end_at, inner)} of {start} along {inner}", f"K{a}", mark)
        elif kind == "PRP":
            self.slide(first, a, self.anywhere(), phi)
            self.pin(at, a, b)
            self.slide(second, b, self.anywhere(), phi + eps)
        elif kind == "RPP":
            self.slide(a, b, self.anywhere(), phi)
            self.slide(second, b, self.anywhere(), phi + eps)
        else:
            raise ValueError(kind)
        return a, b

    def ahead(self, start: XY, end: XY, slide: str) -> str:
        s = self.slides[slide]
        angle = self.pose[s.links[0]][2] + s.angles[0]
        return "ahead" if turned((end[0] - start[0], end[1] - start[1]), -angle)[0] > 0 else "behind"

    def choose(self, name: str, rule: str, mark: str, at: XY) -> None:
        """State the assembly mode by side, or by a sketched point where the point has the name of its pin."""
        sketched = self.flag(False, False, True) and any(mark in points for points in self.points.values())
        self.assembly[mark if sketched else name] = at if sketched else rule

    # The rest.

    def mass(self, link: str) -> PlainLink:
        points, pick = self.points[link], self.source.pick
        way = pick(("none", "given", "given", "given", "rod", "disc", "point"))
        names = list(points)
        if way == "none":
            return PlainLink(points)
        mass = self.source.uniform(0.2, 3.0)
        if way == "given":
            return PlainLink(points, mass, self.anywhere(1.0), self.source.uniform(0.01, 0.5))
        if way == "rod" and len(names) > 1 and math.dist(points[names[0]], points[names[1]]) > 0.01:
            return PlainLink(points, mass, shape=("rod", names[0], names[1]))
        if way == "disc":
            return PlainLink(points, mass, shape=("disc", self.source.uniform(0.1, 0.5), names[0]))  # type: ignore[arg-type]
        return PlainLink(points, mass, shape=("point", names[-1]))

    def load(self) -> None:
        pick = self.source.pick
        on = pick([link for link in self.points if link != FRAME])
        name = f"F{len(self.loads) + 1}"
        at: str | XY = pick(list(self.points[on])) if self.flag() else self.anywhere(1.0)
        way = pick(("fixed", "turning", "along", "torque", "both"))
        if way == "along" and self.slides:
            entry = PlainLoad(on, at, self.source.uniform(-20, 20), along=pick(list(self.slides)))
        elif way == "torque":
            entry = PlainLoad(on, torque=self.source.uniform(-5, 5))
        else:
            force = self.anywhere(20.0)
            turns_with = pick(list(self.points)) if way == "turning" else None
            entry = PlainLoad(on, at, force, turns_with, torque=3.0 if way == "both" else None)
        self.loads[name] = entry

    def finish(self) -> Plain:
        """The mechanism, with masses, loads and gravity drawn."""
        if not self.points[FRAME]:
            self.place(FRAME, "O", (0.0, 0.0))
        for link in self.points:
            if link != FRAME and self.flag():
                self.place(link, f"Q{link}", self.off(self.pose[link][:2], 0.3, 0.7))
        for _ in range(self.source.pick((0, 1, 2))):
            self.load()
        links = {name: PlainLink(points) if name == FRAME else self.mass(name) for name, points in self.points.items()}
        gravity = self.source.pick((None, (0.0, -9.80665), (3.0, -5.0)))
        pins = {name: tuple(members) for name, members in self.pins.items()}
        return Plain(links, pins, self.slides, self.drives, self.pose, self.assembly, self.loads, gravity)


DYADS = ("RRR", "RRP", "RPR", "PRP", "RPP")


def four_bar(s: Sketch) -> None:
    s.dyad("RRR", s.drive("R", FRAME), FRAME)


def slider_crank(s: Sketch) -> None:
    s.dyad("RRP", s.drive("R", FRAME), FRAME)


def driven_slider_crank(s: Sketch) -> None:
    """The piston drives."""
    s.dyad("RRR", s.drive("P", FRAME), FRAME)


def inverted_slider_crank(s: Sketch) -> None:
    s.dyad("RPR", s.drive("R", FRAME), FRAME)


def scotch_yoke(s: Sketch) -> None:
    s.dyad("RPP", s.drive("R", FRAME), FRAME)


def elliptic_trammel(s: Sketch) -> None:
    s.dyad("PRP", s.drive("R", FRAME), FRAME)


def six_bar(s: Sketch) -> None:
    """Watt and Stephenson chains, and all the others that two dyads of any kind make."""
    crank = s.drive(s.source.pick("RRP"), FRAME)
    a, b = s.dyad(s.source.pick(DYADS), crank, FRAME)
    bases = s.source.pick(((a, FRAME), (b, FRAME), (FRAME, a), (b, crank), (a, b), (b, a), (crank, b)))
    s.dyad(s.source.pick(DYADS), *bases)


def five_bar(s: Sketch) -> None:
    s.dyad(s.source.pick(DYADS), s.drive("R", FRAME), s.drive(s.source.pick("RP"), FRAME))


def driven_in_series(s: Sketch) -> None:
    first = s.drive(s.source.pick("RP"), FRAME)
    second = s.drive(s.source.pick("RP"), first)
    s.dyad(s.source.pick(DYADS), second, s.source.pick((FRAME, first)))


def eight_bar(s: Sketch) -> None:
    known = [FRAME, s.drive("R", FRAME), s.drive(s.source.pick("RP"), FRAME)]
    for _ in range(3):
        first = s.source.pick(known)
        known += s.dyad(s.source.pick(DYADS), first, s.source.pick([k for k in known if k != first]))


def arm(s: Sketch) -> None:
    """No loop at all: three driven links in a row."""
    link = FRAME
    for _ in range(3):
        link = s.drive(s.source.pick("RP"), link)


RECIPES: dict[str, Callable[[Sketch], None]] = {
    recipe.__name__: recipe
    for recipe in (
        four_bar, slider_crank, driven_slider_crank, inverted_slider_crank, scotch_yoke, elliptic_trammel,
        six_bar, five_bar, driven_in_series, eight_bar, arm,
    )
}  # fmt: skip


def build(recipe: str, source: Source) -> Plain:
    """One random mechanism of a recipe."""
    sketch = Sketch(source)
    RECIPES[recipe](sketch)
    return sketch.finish()


@st.composite
def mechanisms(draw: Callable[..., Any], recipe: str | None = None) -> Plain:
    """Random mechanisms of one recipe, or of any: half from evenly spread numbers, half from hypothesis' own."""
    name = recipe or draw(st.sampled_from(list(RECIPES)))
    seed = draw(st.none() | st.integers(0, 10**6))
    return build(name, Drawn(draw) if seed is None else Seeded(seed))


def driven_elsewhere(plain: Plain, source: Source) -> Plain:
    """The same mechanism with its one drive at another joint: links may have to be placed all together then.

    The pose at the start is kept; the assembly has to be stated anew (see :func:`sketched`).
    """
    (old,) = plain.drives.values()
    joints: dict[tuple[str, str], list[str]] = {}
    for members in plain.pins.values():
        names = [link for link, _ in members]
        for i, a in enumerate(names):
            for b in names[i + 1 :]:
                joints.setdefault((a, b), []).append("turns")
    for slide in plain.slides.values():
        joints.setdefault(slide.links, []).append("slides")
    single = [
        (pair, kinds[0])
        for pair, kinds in joints.items()
        if len(kinds) == 1 and pair[::-1] not in joints and {*pair} != {old.link, old.on}
    ]
    (a, b), kind = source.pick(single)
    if source.pick((True, False)):
        a, b = b, a
    value = plain.start[a][2] - plain.start[b][2]
    if kind == "slides":
        slide = next(s for s in plain.slides.values() if {*s.links} == {a, b})
        ends = {}
        for link, point in zip(slide.links, slide.points, strict=True):
            x, y, angle = plain.start[link]
            dx, dy = turned(plain.links[link].points[point], angle)
            ends[link] = x + dx, y + dy
        heading = plain.start[slide.links[0]][2] + slide.angles[0]
        value = turned((ends[a][0] - ends[b][0], ends[a][1] - ends[b][1]), -heading)[0]
    law = Law(value, source.pick((1, -1)) * source.uniform(0.05, 0.3))
    return replace(plain, drives={"M1": PlainDrive(kind, a, b, law)}, assembly={})


def sketched(plain: Plain, links: Sequence[str]) -> Plain:
    """The same with a point more on each of some links, whose place in the sketch states the assembly."""
    marked, assembly = dict(plain.links), dict(plain.assembly)
    for link in links:
        x, y, angle = plain.start[link]
        local = (0.6, 0.35)
        dx, dy = turned(local, angle)
        marked[link] = replace(marked[link], points=marked[link].points | {f"Z{link}": local})
        assembly[f"Z{link}"] = x + dx, y + dy
    return replace(plain, links=marked, assembly=assembly)
