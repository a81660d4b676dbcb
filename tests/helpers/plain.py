"""Mechanisms as plain SI numbers, written out as model files in any units, and moved about in the plane.

What the tests know of a mechanism they know from here, not from linkwright's own reading of the file.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

XY = tuple[float, float]
FRAME = "frame"

UNITS: dict[str, float] = {
    "m": 1.0,
    "mm": 1e-3,
    "cm": 1e-2,
    "inch": 0.0254,
    "rad": 1.0,
    "deg": math.pi / 180,
    "kg": 1.0,
    "g": 1e-3,
    "lb": 0.45359237,
    "s": 1.0,
    "ms": 1e-3,
    "min": 60.0,
    "N": 1.0,
    "kN": 1e3,
    "lbf": 4.4482216152605,
    "N*m": 1.0,
    "N*mm": 1e-3,
}
SI = {"length": "m", "angle": "rad", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"}
_OTHERS = {
    "length": ("m", "mm", "cm", "inch"),
    "angle": ("rad", "deg"),
    "mass": ("kg", "g", "lb"),
    "force": ("N", "kN", "lbf"),
    "torque": ("N*m", "N*mm"),
}


def turned(v: XY, angle: float) -> XY:
    """A vector turned counter-clockwise."""
    c, s = math.cos(angle), math.sin(angle)
    return c * v[0] - s * v[1], s * v[0] + c * v[1]


@dataclass(frozen=True)
class Law:
    """q0 + q1 t + amp sin(w t + phase), with any derivative."""

    q0: float
    q1: float = 0.0
    amp: float = 0.0
    w: float = 1.0
    phase: float = 0.0

    def __call__(self, t: float, k: int = 0) -> float:
        wave = self.amp * self.w**k * math.sin(self.w * t + self.phase + k * math.pi / 2)
        return wave + (self.q0 + self.q1 * t if k == 0 else self.q1 if k == 1 else 0.0)

    def times(self, factor: float) -> Law:
        return replace(self, q0=self.q0 * factor, q1=self.q1 * factor, amp=self.amp * factor)

    def plus(self, value: float) -> Law:
        return replace(self, q0=self.q0 + value)


@dataclass(frozen=True)
class PlainLink:
    """Points, mass, centre of mass and moment of inertia about it, in the link's frame; ``shape`` as in a file."""

    points: dict[str, XY]
    mass: float | None = None
    com: XY = (0.0, 0.0)
    inertia: float = 0.0
    shape: tuple[str, ...] = ()  # ("rod", A, B), ("point", A) or ("disc", radius, A): com and inertia follow


@dataclass(frozen=True)
class PlainSlide:
    """A line on each of two links: point name and angle (rad) in the link's frame."""

    links: tuple[str, str]
    points: tuple[str, str]
    angles: tuple[float, float]


@dataclass(frozen=True)
class PlainDrive:
    """``turns`` or ``slides``: link against ``on``, by a law. With a ``track`` no joint is asked: a point of the link,
    and a line of ``on`` by a point and an angle."""

    kind: str
    link: str
    on: str
    law: Law
    track: tuple[str, str, float] | None = None


@dataclass(frozen=True)
class PlainLoad:
    """A force at a place of a link (a point's name or coordinates), fixed in ``turns_with`` or along a slide; the
    opposite acts on the link ``against``."""

    on: str
    at: str | XY | None = None
    force: XY | float | None = None
    turns_with: str | None = None
    along: str | None = None
    torque: float | None = None
    against: str | None = None


@dataclass(frozen=True)
class Plain:
    """A mechanism in SI. ``pins`` maps a pin to its (link, point) members, in the order of the links.

    ``start`` is each link's x, y, angle at t = 0, known from the sketch it was made of.
    """

    links: dict[str, PlainLink]
    pins: dict[str, tuple[tuple[str, str], ...]]
    slides: dict[str, PlainSlide]
    drives: dict[str, PlainDrive]
    start: dict[str, tuple[float, float, float]]
    assembly: dict[str, Any] = field(default_factory=dict)
    loads: dict[str, PlainLoad] = field(default_factory=dict)
    gravity: XY | None = None

    @property
    def moving(self) -> list[str]:
        return [name for name in self.links if name != FRAME]

    def mass(self, name: str) -> tuple[float, XY, float]:
        """Mass, centre of mass and moment of inertia about it."""
        link = self.links[name]
        if link.mass is None:
            return 0.0, (0.0, 0.0), 0.0
        if not link.shape:
            return link.mass, link.com, link.inertia
        form, *rest = link.shape
        if form == "rod":
            (ax, ay), (bx, by) = (link.points[p] for p in rest)
            return link.mass, ((ax + bx) / 2, (ay + by) / 2), link.mass * ((bx - ax) ** 2 + (by - ay) ** 2) / 12
        if form == "disc":
            return link.mass, link.points[rest[1]], link.mass * float(rest[0]) ** 2 / 2
        return link.mass, link.points[rest[0]], 0.0


# Transformations: the same mechanism elsewhere, turned, mirrored, larger.


def rotated(plain: Plain, angle: float) -> Plain:
    """The whole mechanism, gravity and fixed loads with it, turned about the origin."""
    frame = plain.links[FRAME]
    links = plain.links | {FRAME: replace(frame, points={n: turned(p, angle) for n, p in frame.points.items()})}
    slides = {
        name: replace(s, angles=tuple(a + angle * (k == FRAME) for a, k in zip(s.angles, s.links, strict=True)))
        for name, s in plain.slides.items()
    }
    drives = {
        name: d if d.kind == "slides" else replace(d, law=d.law.plus(angle * ((d.on == FRAME) - (d.link == FRAME))))
        for name, d in plain.drives.items()
    }
    loads = {
        name: replace(load, force=turned(load.force, angle))
        if isinstance(load.force, tuple) and load.turns_with in (None, FRAME)
        else load
        for name, load in plain.loads.items()
    }
    gravity = plain.gravity and turned(plain.gravity, angle)
    start = {name: (*turned((x, y), angle), a + angle) for name, (x, y, a) in plain.start.items()}
    return replace(
        plain,
        links=links,
        slides=slides,
        drives=drives,
        loads=loads,
        gravity=gravity,
        start=start,
        assembly=_sketches(plain, lambda p: turned(p, angle)),
    )


def translated(plain: Plain, shift: XY) -> Plain:
    """The whole mechanism shifted."""

    def moved(p: XY) -> XY:
        return p[0] + shift[0], p[1] + shift[1]

    frame = plain.links[FRAME]
    links = plain.links | {FRAME: replace(frame, points={n: moved(p) for n, p in frame.points.items()})}
    start = {name: (*moved((x, y)), a) for name, (x, y, a) in plain.start.items()}
    return replace(plain, links=links, start=start, assembly=_sketches(plain, moved))


def mirrored(plain: Plain) -> Plain:
    """The mechanism seen from behind, y to -y: angles, torques and sides swap their sign."""

    def flip(p: XY) -> XY:
        return p[0], -p[1]

    links = {
        name: replace(link, points={n: flip(p) for n, p in link.points.items()}, com=flip(link.com))
        for name, link in plain.links.items()
    }
    slides = {name: replace(s, angles=tuple(-a for a in s.angles)) for name, s in plain.slides.items()}
    drives = {name: replace(d, law=d.law.times(-1.0)) if d.kind == "turns" else d for name, d in plain.drives.items()}
    loads = {
        name: replace(
            load,
            force=flip(load.force) if isinstance(load.force, tuple) else load.force,
            at=flip(load.at) if isinstance(load.at, tuple) else load.at,
            torque=None if load.torque is None else -load.torque,
        )
        for name, load in plain.loads.items()
    }
    swap = {"left of": "right of", "right of": "left of"}
    assembly = {
        name: re.sub("left of|right of", lambda m: swap[m.group()], rule) if isinstance(rule, str) else flip(rule)
        for name, rule in plain.assembly.items()
    }
    return replace(
        plain,
        links=links,
        slides=slides,
        drives=drives,
        loads=loads,
        assembly=assembly,
        gravity=plain.gravity and flip(plain.gravity),
        start={name: (x, -y, -a) for name, (x, y, a) in plain.start.items()},
    )


def scaled(plain: Plain, k: float) -> Plain:
    """All lengths times k, masses and times kept: accelerations and forces grow with k, torques with its square."""

    def times(p: Any) -> Any:
        return tuple(k * v for v in p) if isinstance(p, tuple) else k * p

    links = {
        name: replace(
            link,
            points={n: times(p) for n, p in link.points.items()},
            com=times(link.com),
            inertia=link.inertia * k * k,
            shape=("disc", link.shape[1] * k, link.shape[2]) if link.shape[:1] == ("disc",) else link.shape,  # type: ignore[operator]
        )
        for name, link in plain.links.items()
    }
    drives = {name: replace(d, law=d.law.times(k)) if d.kind == "slides" else d for name, d in plain.drives.items()}
    loads = {
        name: replace(
            load,
            force=None if load.force is None else times(load.force),
            at=times(load.at) if isinstance(load.at, tuple) else load.at,
            torque=None if load.torque is None else load.torque * k * k,
        )
        for name, load in plain.loads.items()
    }
    return replace(
        plain,
        links=links,
        drives=drives,
        loads=loads,
        gravity=plain.gravity and times(plain.gravity),
        start={name: (k * x, k * y, a) for name, (x, y, a) in plain.start.items()},
        assembly=_sketches(plain, times),
    )


def renamed(plain: Plain, new: Callable[[str], str]) -> Plain:
    """Every link, point, joint, drive and load under another name (the frame keeps its own)."""

    def of(name: str) -> str:
        return name if name == FRAME else new(name)

    def rule(text: Any) -> Any:
        if not isinstance(text, str):
            return text
        words = {"left", "right", "of", "ahead", "behind", "along", "open", "crossed"}
        return re.sub(r"\w+", lambda m: m.group() if m.group() in words else of(m.group()), text)

    links = {
        of(name): replace(
            link,
            points={of(p): at for p, at in link.points.items()},
            shape=tuple(of(s) if isinstance(s, str) and i else s for i, s in enumerate(link.shape)),
        )
        for name, link in plain.links.items()
    }
    return Plain(
        links,
        {of(pin): tuple((of(link), of(p)) for link, p in of_pin) for pin, of_pin in plain.pins.items()},
        {
            of(n): replace(s, links=tuple(map(of, s.links)), points=tuple(map(of, s.points)))
            for n, s in plain.slides.items()
        },
        {of(n): replace(d, link=of(d.link), on=of(d.on)) for n, d in plain.drives.items()},
        {of(n): at for n, at in plain.start.items()},
        {of(n): rule(text) for n, text in plain.assembly.items()},
        {
            of(n): replace(
                load,
                on=of(load.on),
                at=of(load.at) if isinstance(load.at, str) else load.at,
                turns_with=load.turns_with and of(load.turns_with),
                along=load.along and of(load.along),
                against=load.against and of(load.against),
            )
            for n, load in plain.loads.items()
        },
        plain.gravity,
    )


def reordered(plain: Plain, order: Callable[[list[str]], list[str]]) -> Plain:
    """The same entries in another order of the file."""

    def shuffled(entries: dict[str, Any]) -> dict[str, Any]:
        return {name: entries[name] for name in order(list(entries))}

    links = {name: replace(link, points=shuffled(link.points)) for name, link in shuffled(plain.links).items()}
    rank = list(links)
    pins = {
        name: tuple(sorted(members, key=lambda m: rank.index(m[0]))) for name, members in shuffled(plain.pins).items()
    }
    return replace(
        plain,
        links=links,
        pins=pins,
        slides=shuffled(plain.slides),
        drives=shuffled(plain.drives),
        loads=shuffled(plain.loads),
        assembly=shuffled(plain.assembly),
    )


def _sketches(plain: Plain, move: Callable[[XY], XY]) -> dict[str, Any]:
    return {name: rule if isinstance(rule, str) else move(rule) for name, rule in plain.assembly.items()}


# Model files.


class Writer:
    """Writes a plain mechanism as the data of a model file.

    ``units`` are declared; ``pick(n)`` draws an integer below n and so decides how each number is written: bare,
    in some other unit, as a parameter or as arithmetic on one. Without it all numbers are bare.
    """

    def __init__(self, units: Mapping[str, str] = SI, pick: Callable[[int], int] | None = None) -> None:
        self.units, self.pick = dict(units), pick
        self.parameters: dict[str, Any] = {}

    def value(self, value: float, base: str) -> Any:
        """A length, angle, mass, force or torque."""
        bare = value / UNITS[self.units[base]]
        way = self.pick(8) if self.pick else 0
        if way < 4:
            return bare
        if way < 6:
            others = _OTHERS[base]
            other = others[self.pick(len(others))]  # type: ignore[misc]
            written: Any = f"{value / UNITS[other]!r} {other}"
        else:
            written = bare
        if way == 4:
            return written
        name = f"p{len(self.parameters)}"
        if way == 5:
            self.parameters[name] = written
            return name
        self.parameters[name] = bare / 4 if way == 6 else -2 * bare
        return f"3*{name} + {name}" if way == 6 else f"-{name}/2"

    def bare(self, value: float, **powers: int) -> float:
        """A number in a unit made of the declared ones."""
        for base, power in powers.items():
            value /= UNITS[self.units[base]] ** power
        return value

    def pair(self, at: XY, base: str = "length") -> list[Any]:
        return [self.value(v, base) for v in at]

    def place(self, at: XY) -> Any:
        """Coordinates, or now and then the same in polar form."""
        if self.pick and self.pick(5) == 0:
            return f"{math.hypot(*at)!r} m at {math.atan2(at[1], at[0])!r} rad"
        return self.pair(at)

    def document(self, plain: Plain) -> dict[str, Any]:
        """The data of a model file."""
        data: dict[str, Any] = {"linkwright": 1, "units": self.units}
        if plain.gravity:
            data["gravity"] = [self.bare(g, length=1, time=-2) for g in plain.gravity]
        data["links"] = {name: self.link(link) for name, link in plain.links.items()}
        joints = {
            name: {"revolute": [m[0] for m in members], "at": [m[1] for m in members]}
            for name, members in plain.pins.items()
            if len({point for _, point in members}) > 1
        }
        for name, s in plain.slides.items():
            lines = [f"{p} at {a / UNITS[self.units['angle']]!r}" for p, a in zip(s.points, s.angles, strict=True)]
            joints[name] = {"prismatic": list(s.links), "line": lines}
        if joints:
            data["joints"] = joints
        if plain.assembly:
            data["assembly"] = {
                name: rule if isinstance(rule, str) else self.pair(rule) for name, rule in plain.assembly.items()
            }
        data["drives"] = {name: self.drive(drive) for name, drive in plain.drives.items()}
        if plain.loads:
            data["loads"] = {name: self.load(load) for name, load in plain.loads.items()}
        if self.parameters:
            data["parameters"] = self.parameters
        return data

    def link(self, link: PlainLink) -> dict[str, Any]:
        entry: dict[str, Any] = {"points": {name: self.place(at) for name, at in link.points.items()}}
        if link.mass is None:
            return entry
        entry["mass"] = self.value(link.mass, "mass")
        if not link.shape:
            entry |= {"com": self.place(link.com), "inertia": self.bare(link.inertia, mass=1, length=2)}
        elif link.shape[0] == "rod":
            entry["shape"] = f"rod {link.shape[1]}-{link.shape[2]}"
        elif link.shape[0] == "disc":
            entry["shape"] = f"disc {float(link.shape[1])!r} m at {link.shape[2]}"
        else:
            entry["shape"] = f"point {link.shape[1]}"
        return entry

    def drive(self, drive: PlainDrive) -> dict[str, Any]:
        base = "angle" if drive.kind == "turns" else "length"
        unit, law = SI[base], drive.law
        entry: dict[str, Any] = {drive.kind: drive.link, "on": drive.on}
        if law.amp == 0.0:
            speed = self.bare(law.q1, **{base: 1, "time": -1})
            return entry | {"start": self.value(law.q0, base), "speed": speed}
        text = (
            f"({law.q0!r} {unit}) + ({law.q1!r} {unit}/s)*t"
            f" + ({law.amp!r} {unit})*sin(({law.w!r} rad/s)*t + ({law.phase!r} rad))"
        )
        return entry | {"position": text}

    def load(self, load: PlainLoad) -> dict[str, Any]:
        entry: dict[str, Any] = {"on": load.on}
        if load.at is not None:
            entry["at"] = load.at if isinstance(load.at, str) else self.place(load.at)
        if load.along is not None:
            entry |= {"along": load.along, "force": self.value(float(load.force or 0.0), "force")}  # type: ignore[arg-type]
        elif isinstance(load.force, tuple):
            entry["force"] = self.pair(load.force, "force")
        if load.turns_with is not None:
            entry["in"] = load.turns_with
        if load.torque is not None:
            entry["torque"] = self.value(load.torque, "torque")
        if load.against is not None:
            entry["against"] = load.against
        return entry


def document_of(plain: Plain, **units: str) -> dict[str, Any]:
    """The data of a model file with bare numbers, in SI or the units given."""
    return Writer(SI | units).document(plain)


# Reading simple files: enough for the examples of the tests, and no code of linkwright's.


class Reader:
    """A plain mechanism from a file's data: bare numbers, numbers with a unit, arithmetic on parameters."""

    def __init__(self, data: Mapping[str, Any], start: Mapping[str, tuple[float, float, float]]) -> None:
        self.data, self.start = data, dict(start)
        self.units = SI | dict(data.get("units", {}))

    def number(self, raw: Any, *bases: str) -> float:
        """``bases`` such as "length" or "/time" give the unit of bare numbers."""
        text = re.sub(r"(\d)\s+([a-zA-Z])", r"\1*\2", str(raw)).replace("^", "**")
        words = {**UNITS, "rpm": math.pi / 30, "pi": math.pi}
        known = {name: getattr(math, name) for name in ("sin", "cos", "atan2", "sqrt", "hypot")}
        parameters = {name: self.number(value) for name, value in self.data.get("parameters", {}).items()}
        value = float(eval(text, {"__builtins__": {}}, words | known | parameters))
        in_unit = any(re.search(rf"\b{word}\b", text) for word in words if word != "pi") or "atan2" in text
        return value if in_unit or not bases else value * self.factor(*bases)

    def factor(self, *bases: str) -> float:
        value = 1.0
        for base in bases:
            unit = UNITS[self.units[base.lstrip("/")]]
            value = value / unit if base.startswith("/") else value * unit
        return value

    def place(self, raw: Any) -> XY:
        if isinstance(raw, str):
            radius, angle = raw.split(" at ")
            return turned((self.number(radius, "length"), 0.0), self.number(angle, "angle"))
        return self.number(raw[0], "length"), self.number(raw[1], "length")

    def plain(self) -> Plain:
        links = {name: self.link(entry) for name, entry in self.data["links"].items()}
        pins: dict[str, list[tuple[str, str]]] = {}
        for name, link in links.items():
            for point in link.points:
                pins.setdefault(point, []).append((name, point))
        slides = {}
        for name, joint in self.data.get("joints", {}).items():
            lines = [line.split(" at ") for line in joint["line"]]
            angles = tuple(self.number(angle, "angle") for _, angle in lines)
            slides[name] = PlainSlide(tuple(joint["prismatic"]), tuple(p for p, _ in lines), angles)  # type: ignore[arg-type]
        gravity = self.data.get("gravity")
        if gravity == "earth":
            gravity = ["0 m/s^2", "-9.80665 m/s^2"]
        return Plain(
            links,
            {name: tuple(members) for name, members in pins.items() if len(members) > 1},
            slides,
            {name: self.drive(entry) for name, entry in self.data["drives"].items()},
            {FRAME: (0.0, 0.0, 0.0)} | self.start,
            dict(self.data.get("assembly", {})),
            {name: self.load(entry) for name, entry in self.data.get("loads", {}).items()},
            gravity and tuple(self.number(g, "length", "/time", "/time") for g in gravity),
        )

    def link(self, entry: Mapping[str, Any]) -> PlainLink:
        points = {name: self.place(at) for name, at in entry["points"].items()}
        if "mass" not in entry:
            return PlainLink(points)
        mass = self.number(entry["mass"], "mass")
        if "shape" in entry:
            form, rest = entry["shape"].split(" ", 1)
            return PlainLink(points, mass, shape=(form, *re.split(r"\s*-\s*", rest)))
        inertia = self.number(entry["inertia"], "mass", "length", "length")
        return PlainLink(points, mass, self.place(entry["com"]), inertia)

    def drive(self, entry: Mapping[str, Any]) -> PlainDrive:
        kind = "turns" if "turns" in entry else "slides"
        base = "angle" if kind == "turns" else "length"
        law = Law(self.number(entry["start"], base), self.number(entry["speed"], base, "/time"))
        return PlainDrive(kind, entry[kind], entry["on"], law)

    def load(self, entry: Mapping[str, Any]) -> PlainLoad:
        force = entry.get("force")
        if isinstance(force, list | tuple):
            force = tuple(self.number(f, "force") for f in force)
        elif force is not None:
            force = self.number(force, "force")
        torque = self.number(entry["torque"], "torque") if "torque" in entry else None
        turns_with, along, against = (entry.get(key) for key in ("in", "along", "against"))
        return PlainLoad(entry["on"], entry.get("at"), force, turns_with, along, torque, against)


def plain_of(data: Mapping[str, Any], start: Mapping[str, tuple[float, float, float]]) -> Plain:
    """A plain mechanism from a file's data; ``start`` guesses the links' x, y, angle at t = 0."""
    return Reader(data, start).plain()


def relative(a: Any, b: Any, floor: float = 1e-300) -> float:
    """The largest difference of two arrays over the largest value of the second."""
    a, b = np.asarray(a, dtype=float), np.asarray(b, dtype=float)
    return float(np.max(np.abs(a - b), initial=0.0) / max(float(np.max(np.abs(b), initial=0.0)), floor))
