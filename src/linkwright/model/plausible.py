"""Numbers that fit the format and yet look like a slip: gravity in a wrong unit, lengths, masses, speeds.

Gravity far from the earth's is a warning. The others are notes: they never change an exit code.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from contextlib import suppress
from itertools import combinations
from typing import TypeVar

from linkwright.escape import printed
from linkwright.expressions import units as u
from linkwright.expressions.dimensions import DimensionError
from linkwright.expressions.fields import Expression
from linkwright.expressions.language import Call, ExpressionError, Name, Number, nodes
from linkwright.expressions.units import Dimension
from linkwright.findings import Finding, Joined, Term
from linkwright.model.gravity import EARTH
from linkwright.model.parts import Link
from linkwright.model.places import ExpressionPlace
from linkwright.model.quantities import Quantities

Key = TypeVar("Key")

OTHER_GRAVITY = 100.0
"""Gravity this many times larger or smaller than the earth's gives a warning."""
RATIO = 300.0
"""Lengths, or masses, that differ by this factor or more give a note."""
SLOW, FAST = math.pi / 30, 1e5 * math.pi / 30
"""Speeds (rad/s) below the one or above the other give a note: 1 rpm, 100 000 rpm."""
MOST_POINTS = 40
"""So many points of a link are looked at."""


def implausible(q: Quantities) -> list[Finding]:
    """Warnings and notes on a mechanism whose quantities are free of findings."""
    return [*_gravity(q), *_lengths(q), *_masses(q), *_speeds(q)]


def unloaded(q: Quantities) -> Iterator[Finding]:
    """A note where forces or torques are measured, but nothing can make any: no mass, no load, spring or friction."""
    m = q.mechanism
    heavy = any(m.has_mass(link) for link in m.links)
    if heavy or any(True for _ in m.acting()) or any(getattr(joint, "pretension", None) for joint in m.joints.values()):
        return
    asked = dict.fromkeys(place.path[1] for place in q.places if place.path[0] == "measures" and _asks_forces(q, place))
    if asked:
        yield Finding("plausible.unloaded", ("measures", next(iter(asked))), {"names": Joined(asked)}, severity="note")


def _asks_forces(q: Quantities, place: ExpressionPlace) -> bool:
    """Whether an expression has a signal of a force, a torque or a power."""
    for node in nodes(place.expression.node):
        if isinstance(node, Name | Call):
            with suppress(DimensionError, ExpressionError):
                if q.signals.find(node).dimension.mass:
                    return True
    return False


def amount(q: Quantities, value: float, dimension: Dimension) -> str:
    """A value (SI) in the model's unit, as text with the unit."""
    unit, size = q.unit_of(dimension)
    return f"{value / size + 0.0:.6g} {printed(unit)}"  # 0.0, as -0 reads oddly


def _gravity(q: Quantities) -> Iterator[Finding]:
    gravity = q.mechanism.gravity
    if gravity is None:
        return
    x, y = (q.value(part, u.ACCELERATION) for part in gravity.parts)
    size = math.hypot(x, y)
    if size and not EARTH / OTHER_GRAVITY <= size <= EARTH * OTHER_GRAVITY:
        earth = "earth" if x == 0 and y < 0 else f"earth along [{x / size:.6g}, {y / size:.6g}]"
        data = {"given": amount(q, size, u.ACCELERATION), "si": f"{size:.6g} m/s²", "times": f"{size / EARTH:.3g}"}
        yield Finding("gravity.size", ("gravity",), {**data, "earth": earth}, severity="warning")


def _lengths(q: Quantities) -> Iterator[Finding]:
    known: dict[tuple[str, str, str], float] = {}
    for name, link in q.mechanism.links.items():
        places = {point: _place(q, link, point) for point in list(link.points)[:MOST_POINTS]}
        for (a, p), (b, r) in combinations(places.items(), 2):
            known[name, a, b] = abs(p - r)
    if pair := _extremes_far_apart(known):
        short, long = pair
        data = {"ratio": f"{known[long] / known[short]:.3g}", "short": _distance(*short), "long": _distance(*long)}
        data |= {"low": amount(q, known[short], u.LENGTH), "high": amount(q, known[long], u.LENGTH)}
        yield Finding("plausible.lengths", ("links", short[0]), {**data}, severity="note")


def _distance(link: str, a: str, b: str) -> Term:
    return Term("length-on", points=f"{a}-{b}", link=link)


def _place(q: Quantities, link: Link, point: str) -> complex:
    """A point in its link's axes (m), as x + i y."""
    return complex(*link.place(q.value, point))


def _masses(q: Quantities) -> Iterator[Finding]:
    given = {("links", name): link.mass for name, link in q.mechanism.links.items()}
    given |= {one.path: weight.mass for one in q.mechanism.acting() if (weight := one.kind.weighs(one.entry))}
    known = {path: q.value(mass, u.MASS) for path, mass in given.items() if mass is not None}
    if pair := _extremes_far_apart(known):
        light, heavy = pair
        data = {"ratio": f"{known[heavy] / known[light]:.3g}", "light": light[1], "heavy": heavy[1]}
        data |= {"low": amount(q, known[light], u.MASS), "high": amount(q, known[heavy], u.MASS)}
        yield Finding("plausible.masses", light, {**data}, severity="note")


def _extremes_far_apart(known: Mapping[Key, float]) -> tuple[Key, Key] | None:
    """The smallest and the largest of some values, where they are far apart; zero, to round-off, isn't one."""
    top = max(known.values(), default=0.0)
    some = {key: value for key, value in known.items() if value > 1e-9 * top}
    if not some:
        return None
    low, high = min(some, key=some.__getitem__), max(some, key=some.__getitem__)
    return (low, high) if some[high] >= RATIO * some[low] else None


def _speeds(q: Quantities) -> Iterator[Finding]:
    for name, drive in q.mechanism.drives.items():
        if drive.speed is None or drive.acceleration is not None or not q.mechanism.prescribed(name).turns:
            continue
        speed = abs(q.value(drive.speed, u.OMEGA))
        if speed > FAST or (0 < speed < SLOW and _bare(q, drive.speed)):
            example = f"{drive.speed.text} rpm" if drive.speed.bare_number() is not None else "60 rpm"
            data = {"name": name, "speed": amount(q, speed, u.OMEGA), "rpm": f"{speed * 30 / math.pi:.4g}"}
            data |= {"period": amount(q, 2 * math.pi / speed, u.TIME), "unit": printed(q.unit_of(u.OMEGA)[0])}
            yield Finding("plausible.speed", ("drives", name, "speed"), {**data, "example": example}, severity="note")


def _bare(q: Quantities, expression: Expression) -> bool:
    """Whether no unit is written in an expression, nor in the parameters that it names."""
    parameters = q.mechanism.parameters
    for node in nodes(expression.node):
        if isinstance(node, Number) and node.unit:
            return False
        if isinstance(node, Name) and node.text in parameters and not _bare(q, parameters[node.text].value):
            return False
    return True
