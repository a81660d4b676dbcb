"""Springs, dampers and gas springs: length or angle, force, energy; what they do to their links.

A force is positive in tension, a torque where it turns its link back: both work to reduce the length or angle.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

import casadi as ca

from linkwright.expressions import units as u
from linkwright.expressions.language import Name
from linkwright.model.mechanism import Spring
from linkwright.model.pins import spring_ends
from linkwright.model.places import spring_dimensions
from linkwright.notation import Pair, Scalar, Vec, Wrench

if TYPE_CHECKING:
    from linkwright.graph.view import View


def number(view: View, spring: Spring, key: str, default: float = 0.0) -> Scalar:
    """One of a spring's numbers (SI)."""
    given = getattr(spring, key)
    return default if given is None else view.motion.geometry.number(given, spring_dimensions(spring)[key])


def ends(view: View, spring: Spring) -> tuple[Vec, Vec]:
    """The places of its two ends."""
    (a, p), (b, q) = spring_ends(view.motion.geometry.mechanism, spring)
    motion = view.motion
    return motion.bodies[a].point(motion.point(a, p)), motion.bodies[b].point(motion.point(b, q))


def stretch(view: View, name: str, order: int) -> Scalar:
    """Length (m) or angle (rad), or its rate (order 1)."""
    spring = view.motion.geometry.mechanism.springs[name]
    if not spring.torsional:
        start, end = ends(view, spring)
        gap = end.minus(start)
        return gap.dot(gap).sqrt().d[order]
    turned, base = (view.motion.bodies[str(link)] for link in (spring.turns, spring.on))
    if order:
        return turned.turn.d[0] - base.turn.d[0]
    turns = view.given.get(f"turns/{name}", 0.0)
    return raw_angle(view, str(spring.turns)) - raw_angle(view, str(spring.on)) + 2 * math.pi * turns


def raw_angle(view: View, link: str) -> Scalar:
    """A link's angle (rad): exact where it is known so, else in -pi .. pi."""
    body = view.motion.bodies[link]
    return ca.atan2(body.axis.y.d[0], body.axis.x.d[0]) if body.angle is None else body.angle


def column(stroke: Scalar, progression: Scalar, exponent: Scalar) -> Scalar:
    """The length of the gas column of an extended gas spring, from p V^n = constant (Bauer 2011, ch. 2)."""
    return stroke / (1 - progression ** (-1 / exponent))


def elastic(view: View, name: str) -> tuple[Scalar, Scalar]:
    """The force or torque that its length or angle makes, and the energy stored (N, J or N m, J)."""
    spring = view.motion.geometry.mechanism.springs[name]
    x = stretch(view, name, 0)
    if spring.table:
        argument = Name(f"{name}.{spring.measure}")
        return view.lookup(spring.table, argument), view.lookup(spring.table, argument, integral=True)
    if spring.gas is not None:
        assert spring.length is not None
        push, n = number(view, spring, "gas"), number(view, spring, "exponent", 1.0)
        short, long = (view.motion.geometry.number(edge, u.LENGTH) for edge in spring.length)
        h = column(long - short, number(view, spring, "progression"), n)
        grown = ca.log(h / (h - (long - x)))  # NaN where it is pushed in past its gas
        stored = h * grown
        if not (isinstance(n, float) and n == 1):
            stored = ca.if_else(ca.fabs(n - 1) < 1e-9, stored, h / (n - 1) * (ca.exp((n - 1) * grown) - 1))
        return -push * ca.exp(n * grown), push * stored
    k, preload = number(view, spring, "stiffness"), number(view, spring, "preload")
    if spring.stiffness is None:
        return 0.0, 0.0
    over = x - number(view, spring, "free")
    return preload + k * over, (preload + k * over / 2) * over


def effort(view: View, name: str) -> Scalar:
    """Its force (N, positive in tension) or torque (N m, positive where it turns back), damping included."""
    spring = view.motion.geometry.mechanism.springs[name]
    force = elastic(view, name)[0]
    return force if spring.damping is None else force + number(view, spring, "damping") * stretch(view, name, 1)


def spring_wrenches(view: View, name: str) -> Iterator[tuple[str, Wrench]]:
    """What a spring does to its two links."""
    mechanism = view.motion.geometry.mechanism
    spring, force = mechanism.springs[name], effort(view, name)
    if spring.torsional:
        for link, moment in ((spring.turns, -force), (spring.on, force)):
            about = view.motion.bodies[str(link)].anchor.now
            yield str(link), Wrench(Pair(0.0, 0.0), moment, about)
        return
    start, end = ends(view, spring)
    gap, length = end.minus(start).now, stretch(view, name, 0)
    (a, _), (b, _) = spring_ends(mechanism, spring)
    pull = Pair(force * gap.x / length, force * gap.y / length)
    yield a, Wrench(pull, 0.0, start.now)
    yield b, Wrench(Pair(-pull.x, -pull.y), 0.0, end.now)
