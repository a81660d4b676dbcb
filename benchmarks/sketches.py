"""Random mechanisms drawn as sketches: every joint is put into the plane first, so each closes at the start.

A sketch knows each link's place, each joint and each drive's law at t = 0 without solving anything, and writes the
data of a model file. Its links carry their own coordinates of every joint, with which a pose can be judged.
"""

from __future__ import annotations

import math
import random
from dataclasses import dataclass
from typing import Any

from linkwright.model.document import Document
from linkwright.structure import Driven, decompose

FRAME = "frame"
PERIOD = 2 * math.pi
XY = tuple[float, float]

GROUPS: dict[str, tuple[tuple[str, str], ...]] = {
    # Joints between the new links a, b, c ... and known ones (1, 2 ...).
    "dyad": (("1", "a"), ("a", "b"), ("b", "2")),
    "triad": (("1", "a"), ("a", "m"), ("2", "b"), ("b", "m"), ("3", "c"), ("c", "m")),
    "double triad": (
        ("1", "a"), ("a", "m"), ("2", "b"), ("b", "m"), ("m", "n"), ("3", "c"), ("c", "n"), ("4", "d"), ("d", "n"),
    ),
    "class IV": (("1", "m"), ("m", "a"), ("a", "n"), ("m", "b"), ("b", "n"), ("n", "2")),
}  # fmt: skip
"""Assur groups of class II, III and IV by their joints."""
LOADS: tuple[list[dict[str, Any]], ...] = (
    [],
    [{"force": [9, -4]}],
    [{"force": [2, 3]}, {"torque": 1, "force": [0, 5]}],
)


def turned(v: XY, angle: float) -> XY:
    """A vector turned counter-clockwise."""
    c, s = math.cos(angle), math.sin(angle)
    return c * v[0] - s * v[1], s * v[0] + c * v[1]


@dataclass
class Joint:
    """A pin or a slide of two links or, for a pin, more: at a place, along a direction (rad)."""

    kind: str
    links: list[str]
    at: XY
    angle: float = 0.0


@dataclass(frozen=True)
class Law:
    """start + speed t, or start + size (sin(rate t + phase) - sin phase)."""

    start: float
    speed: float = 0.0
    size: float = 0.0
    rate: int = 1
    phase: float = 0.0


@dataclass
class Drive:
    """The joint that is driven: ``link`` against ``on``."""

    joint: str
    kind: str
    link: str
    on: str
    law: Law


class Sketch:
    """A mechanism under construction in the plane; ``kinds`` says what it is made of."""

    def __init__(self, seed: int) -> None:
        self.random = random.Random(seed)
        self.pose: dict[str, tuple[float, float, float]] = {FRAME: (0.0, 0.0, 0.0)}
        self.joints: dict[str, Joint] = {}
        self.drives: dict[str, Drive] = {}
        self.cranks: dict[str, XY] = {}
        self.known: set[str] = {FRAME}
        self.kinds: list[str] = []

    def link(self) -> str:
        name = f"L{len(self.pose)}"
        uniform = self.random.uniform
        self.pose[name] = (uniform(-1, 1), uniform(-1, 1), uniform(-3.1, 3.1))
        return name

    def joint(self, a: str, b: str, kind: str | None = None) -> str:
        """A joint between two links anywhere, on a crank near its pivot; a pin now and then on one that is there."""
        kind = kind or self.random.choice("RRRP")
        name = f"{'J' if kind == 'R' else 'S'}{len(self.joints) + 1}"
        pins = [n for n, j in self.joints.items() if j.kind == "R" and a in j.links and {*j.links} <= self.known]
        if kind == "R" and pins and self.random.random() < 0.25:
            self.joints[pins[0]].links.append(b)
            return pins[0]
        centre = self.cranks.get(a) or self.cranks.get(b)
        at = (self.random.uniform(-1, 1), self.random.uniform(-1, 1))
        if centre is not None:
            step = turned((self.random.uniform(0.03, 0.25), 0.0), self.random.uniform(-3.1, 3.1))
            at = centre[0] + step[0], centre[1] + step[1]
        self.joints[name] = Joint(kind, [a, b], at, self.random.uniform(-3.1, 3.1))
        return name

    def drive(self, name: str, joint: str, link: str, on: str, turns: float = 0.5) -> None:
        """Drive a joint: a turn of constant speed, by some odds, or to and fro."""
        j, uniform = self.joints[joint], self.random.uniform
        link, on = self.random.choice(((link, on), (on, link)))
        # A slide's value is the way from on's point of the line to the link's; both are the joint's place.
        value = self.pose[link][2] - self.pose[on][2] if j.kind == "R" else 0.0
        if j.kind == "R" and self.random.random() < turns:
            law = Law(value, self.random.choice((1.0, -1.0)))
        else:
            size = uniform(0.02, 0.4) if j.kind == "R" else uniform(0.02, 0.2)
            law = Law(value, size=size, rate=self.random.choice((1, 1, 2, 3)), phase=uniform(-3, 3))
        self.drives[name] = Drive(joint, j.kind, link, on, law)

    def driven_link(self, base: str) -> str:
        """A new link driven against a known one."""
        link = self.link()
        joint = self.joint(base, link, self.random.choice("RRRP"))
        if self.joints[joint].kind == "R":
            self.cranks[link] = self.joints[joint].at
        self.drive(f"M{len(self.drives) + 1}", joint, link, base)
        self.known.add(link)
        return link

    def group(self, kind: str) -> None:
        """An Assur group on known links, two different ones at least."""
        ends = list(dict.fromkeys(end for joint in GROUPS[kind] for end in joint))
        known, new = sorted(self.known, key=list(self.pose).index), [end for end in ends if end.isalpha()]
        names = {end: self.random.choice(known) for end in ends if end.isdigit()}
        names |= {"1": known[-1], "2": self.random.choice(known[:-1])} | {end: self.link() for end in new}
        for a, b in GROUPS[kind]:
            self.joint(*sorted((names[a], names[b]), key=lambda link: link not in self.known))
        self.known |= {names[end] for end in new}
        self.kinds.append(kind)

    def elsewhere(self) -> None:
        """Move a drive to another joint, inside a loop or at the far end."""
        name = self.random.choice(list(self.drives))
        taken = {d.joint for d in self.drives.values()}
        free = [n for n, j in self.joints.items() if n not in taken and len(j.links) == 2]
        if free:
            joint = self.random.choice(free)
            link, on = self.joints[joint].links
            self.drive(name, joint, link, on, turns=0.1)
            self.kinds.append("moved drive")

    # What it is.

    def point(self, joint: str, link: str) -> str:
        """The name of a link's point on a joint; those of a slide differ."""
        return joint if self.joints[joint].kind == "R" else f"{joint}{link}"

    def local(self, joint: str, link: str) -> XY:
        """A joint in a link's own axes."""
        x, y, angle = self.pose[link]
        at = self.joints[joint].at
        return turned((at[0] - x, at[1] - y), -angle)

    def points(self, link: str) -> dict[str, XY]:
        """All points of a link by name, in its own axes."""
        return {self.point(n, link): self.local(n, link) for n, j in self.joints.items() if link in j.links}

    def mechanism(self) -> dict[str, Any]:
        """The data of a model file: links without masses, joints, drives."""
        joints = {
            name: {
                "prismatic": list(j.links),
                "line": [f"{self.point(name, link)} at {j.angle - self.pose[link][2]!r}" for link in j.links],
            }
            for name, j in self.joints.items()
            if j.kind == "P"
        }
        return {
            "linkwright": 1,
            "units": {"length": "m", "angle": "rad", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"},
            "links": {link: {"points": self.points(link) or {"O": [0, 0]}} for link in self.pose},
            "joints": joints,
            "drives": {name: self.drive_data(drive) for name, drive in self.drives.items()},
            "studies": {"cycle": {"duration": PERIOD, "samples": 48}},
        }

    def data(self) -> dict[str, Any]:
        """The same with masses, gravity, loads, and the assembly stated by sketched points."""
        pick, uniform = self.random.choice, self.random.uniform
        data = self.stated(self.mechanism())
        for link in list(self.pose)[1:]:
            if self.random.random() < 0.7:
                com = [uniform(-1, 1), uniform(-1, 1)]
                data["links"][link] |= {"mass": uniform(0.2, 3), "com": com, "inertia": uniform(0.01, 0.5)}
        data["loads"] = {
            f"F{i}": {"on": pick(list(self.pose)[1:]), "at": [uniform(-1, 1), uniform(-1, 1)], **force}
            for i, force in enumerate(pick(LOADS))
        }
        return data | {"gravity": pick(([0, 0], [0, -9.81]))}

    def drive_data(self, drive: Drive) -> dict[str, Any]:
        verb, unit = ("turns", "rad") if drive.kind == "R" else ("slides", "m")
        law, entry = drive.law, {verb: drive.link, "on": drive.on}
        if law.size == 0:
            return entry | {"start": law.start, "speed": law.speed}
        wave = f"sin({law.rate} rad/s*t + {law.phase!r} rad) - sin({law.phase!r} rad)"
        return entry | {"position": f"{law.start!r} {unit} + {law.size!r} {unit}*({wave})"}

    def stated(self, data: dict[str, Any]) -> dict[str, Any]:
        """The same with a marked point on each link whose assembly has to be stated, and its place in the sketch."""
        steps = decompose(Document.model_validate(data)).steps
        data["assembly"] = {}
        for step in steps:
            if not isinstance(step, Driven) and getattr(step, "modes", 2) > 1:
                for link in step.links:
                    x, y, angle = self.pose[link]
                    dx, dy = turned((0.6, 0.35), angle)
                    data["links"][link]["points"][f"Z{link}"] = [0.6, 0.35]
                    data["assembly"][f"Z{link}"] = [x + dx, y + dy]
        return data


def sketch(seed: int) -> Sketch:
    """One random mechanism: one to three drives, one to three groups."""
    s = Sketch(seed)
    last = FRAME
    for _ in range(s.random.choice((1, 1, 1, 2, 2, 3))):
        last = s.driven_link(s.random.choice((FRAME, FRAME, last)))
    for _ in range(s.random.choice((1, 1, 1, 2, 2, 3))):
        beyond = any(kind != "dyad" for kind in s.kinds)  # one of the large groups is enough
        s.group("dyad" if beyond else s.random.choice(("dyad", "dyad", "dyad", *GROUPS)))
    if s.random.random() < 0.35:
        s.elsewhere()
    return s
