"""The dialects: what each lets a function be made of, and how directions and lengths are said in it.

What is known of the tool's grammar is in docs/how-to/process-simulate.md. ``seed`` has what the paper on the four-bar
used: acos, sqrt, sin, cos; ``wizard`` what functions that the tool makes itself were seen to hold: acos, sin, atan2.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, ClassVar

import numpy as np

from linkwright.data_classes import dataclass
from linkwright.exports.process_simulate.linkage import Linkage, Refused
from linkwright.exports.process_simulate.trees import Array, Tree, add, call, divide, multiply, negated, number
from linkwright.exports.process_simulate.vectors import Angle, Vector, cosine, sine
from linkwright.findings import Finding, Joined
from linkwright.notation.registry import Registry

CLEAR = 0.05
"""How far a direction stays from where its function ends (rad), wherever the paper's plain form does that."""
LEAST = 0.005
"""How far it must stay."""
FRAMED = Angle()
"""The angle of the frame."""


@dataclass(frozen=True)
class Triangle:
    """A dyad of three pins: its two links' arms from the outer pins, the base between these, the inner angle.

    ``inner`` is the direction of the second arm less that of the first; ``branch`` +1 where the inner pin is left of
    the base; ``lengths`` those of the arms.
    """

    base: Vector
    arms: tuple[Vector, Vector]
    lengths: tuple[Tree, Tree]
    branch: float
    inner: Angle


class Dialect:
    """How functions are written. ``functions`` has their names with the number of arguments; ``minus`` is whether
    differences have a sign, where not they are sums with ``(-1)(x)``. ``window`` is the range of its direction."""

    name: ClassVar[str]
    functions: ClassVar[Mapping[str, int]]
    minus: ClassVar[bool]
    window: ClassVar[float]

    def length(self, links: Linkage, vector: Vector) -> Tree:
        """The length of a vector (mm)."""
        raise NotImplementedError

    def aim(self, links: Linkage, vector: Vector, seen: Angle = FRAMED) -> Angle:
        """The direction of a vector, which is asked for as ``seen`` from a link."""
        raise NotImplementedError

    def from_base(self, links: Linkage, triangle: Triangle, side: int) -> Angle:
        """How far the first (0) or second (1) arm is turned from the base, seen from its own end of that."""
        raise NotImplementedError

    def root(self, links: Linkage, arm: Vector, aside: Tree, direction: Angle, branch: float) -> Tree:
        """Of an arm (mm) that is ``aside`` of a line, how far it reaches along the line's direction."""
        raise NotImplementedError

    def lower(self, tree: Tree) -> Tree:
        """A tree with nothing in it that the dialect lacks."""
        return tree

    def single(self, vector: Vector, links: Linkage) -> Angle | None:
        """The direction of a vector of one arm."""
        if len(vector.arms) != 1:
            return None
        (arm,) = vector.arms
        values = links.numbers(arm.length)
        if values.min() > 0:
            return arm.angle
        return arm.angle.rotated(math.pi) if values.max() < 0 else None

    def reference(self, links: Linkage, vector: Vector, seen: Angle) -> tuple[Angle, float]:
        """A direction from which a vector's strays within the window, and which side of it: +1, -1, 0 both.

        Best is that of an arm, with the fewest joints to write; else whatever has the vector in mid-window.
        """
        plain, centred = list[tuple[Any, ...]](), list[tuple[Any, ...]]()
        widest = math.inf
        for arm in vector.arms:
            low, high = _spread(links, vector, arm.angle)
            widest = min(widest, high - low)
            weight = sum(len(other.minus(arm.angle).parts) for other in (seen, *(arm.angle for arm in vector.arms)))
            middle = math.floor((low + high) / math.pi)
            for quarter in range(middle - 1, middle + 3):
                base = quarter * math.pi / 2
                for side, start in self.starts(base):
                    room = min(low - start, start + self.window - high)
                    if room > CLEAR:
                        key = (weight, quarter % 2, -round(room, 6), side < 0, len(plain))
                        plain.append((*key, arm.angle.rotated(base), side))
            start = (low + high - self.window) / 2
            side, base = (1.0, start) if self.window < 4 else (0.0, start + self.window / 2)
            if low - start > LEAST:
                centred.append((weight, 0, start - low, False, len(centred), arm.angle.rotated(base), side))
        if not plain and not centred:
            raise Refused(_too_far(links, vector, widest, self))
        found = min(plain or centred)
        return found[5], found[6]

    def starts(self, base: float) -> tuple[tuple[float, float], ...]:
        """The sides of a reference, each with the least direction that it has."""
        raise NotImplementedError


def _spread(links: Linkage, vector: Vector, reference: Angle) -> tuple[float, float]:
    """The least and largest direction of a vector from a reference (rad), over all poses without a jump."""
    total: Array = np.zeros(links.poses.shape, dtype=complex)
    for arm in vector.arms:
        angle = links.angle_values(arm.angle.minus(reference))
        total = total + links.numbers(arm.length) * np.exp(1j * angle)
    turned = np.unwrap(np.angle(total))
    return float(turned.min()), float(turned.max())


def _too_far(links: Linkage, vector: Vector, spread: float, dialect: Dialect) -> Finding:
    joints = Joined(dict.fromkeys(j for arm in vector.arms for j in [links.where(arm.angle)] if j))
    data = {
        "joints": joints or "-",
        "spread": f"{math.degrees(spread):.4g}",
        "most": f"{math.degrees(dialect.window - 2 * LEAST):.4g}",
        "dialect": dialect.name,
    }
    return Finding("functions.sweep", ("exports", "process-simulate", "dialect"), data)


DIALECTS: Registry[Dialect] = Registry()


def register(cls: type[Dialect]) -> type[Dialect]:
    """Register a dialect under its name; a second one of the same name is an error."""
    DIALECTS[cls.name] = cls()
    return cls


@register
class Seed(Dialect):
    """The paper's: a direction is the arccosine of a component over the length, which is a root."""

    name = "seed"
    functions: ClassVar[Mapping[str, int]] = {"acos": 1, "sqrt": 1, "sin": 1, "cos": 1}
    minus = True
    window = math.pi

    def starts(self, base: float) -> tuple[tuple[float, float], ...]:
        return (1.0, base), (-1.0, base - math.pi)

    def length(self, links: Linkage, vector: Vector) -> Tree:
        if self.single(vector, links) is not None:
            return _positive(links, vector)
        return call("sqrt", vector.square(links.symbols))

    def aim(self, links: Linkage, vector: Vector, seen: Angle = FRAMED) -> Angle:
        """phi + acos((x cos phi + y sin phi)/r), by a reference phi from which the direction stays within half a turn
        to one side."""
        if (known := self.single(vector, links)) is not None:
            return known
        reference, side = self.reference(links, vector, seen)
        share = divide(vector.along(reference, links.symbols), self.length(links, vector))
        return reference.plus(links.hidden(call("acos", share)), round(side))

    def from_base(self, links: Linkage, triangle: Triangle, side: int) -> Angle:
        """The law of cosines, as the paper's equation (13)."""
        own = triangle.lengths[side]
        own_square, other_square = (triangle.arms[k].square(links.symbols) for k in (side, 1 - side))
        above = add(own_square, triangle.base.square(links.symbols), negated(other_square))
        below = multiply(number(2.0), own, self.length(links, triangle.base))
        sign = triangle.branch * (1, -1)[side]
        return Angle().plus(links.hidden(call("acos", divide(above, below))), round(sign))

    def root(self, links: Linkage, arm: Vector, aside: Tree, direction: Angle, branch: float) -> Tree:
        if aside.op == "number" and aside.value == 0:
            return multiply(number(branch), self.length(links, arm))
        square = add(arm.square(links.symbols), negated(multiply(aside, aside)))
        return multiply(number(branch), call("sqrt", square))


@register
class Wizard(Dialect):
    """What the tool's own wizard was seen to write: no root, no cosine, no difference."""

    name = "wizard"
    functions: ClassVar[Mapping[str, int]] = {"acos": 1, "sin": 1, "atan2": 2}
    minus = False
    window = 2 * math.pi

    def starts(self, base: float) -> tuple[tuple[float, float], ...]:
        return ((0.0, base - math.pi),)

    def length(self, links: Linkage, vector: Vector) -> Tree:
        """x cos phi + y sin phi with phi = atan2(y, x)."""
        if self.single(vector, links) is not None:
            return _positive(links, vector)
        return vector.along(self.aim(links, vector), links.symbols)

    def aim(self, links: Linkage, vector: Vector, seen: Angle = FRAMED) -> Angle:
        if (known := self.single(vector, links)) is not None:
            return known
        reference, _ = self.reference(links, vector, seen)
        y, x = vector.across(reference, links.symbols), vector.along(reference, links.symbols)
        return reference.plus(links.hidden(call("atan2", y, x)))

    def from_base(self, links: Linkage, triangle: Triangle, side: int) -> Angle:
        """The base as its own arm less the other, both seen from the own arm, so that no length is needed; the side
        of it never changes, so that no turn is lost."""
        own, other = triangle.lengths[side], triangle.lengths[1 - side]
        inner = triangle.inner if side == 0 else Angle().minus(triangle.inner)
        x = add(own, negated(multiply(other, cosine(inner, links.symbols))))
        y = multiply(other, sine(inner, links.symbols))
        return links.hidden(call("atan2", y, x))

    def root(self, links: Linkage, arm: Vector, aside: Tree, direction: Angle, branch: float) -> Tree:
        """The arm's component along the direction."""
        return arm.along(direction, links.symbols)

    def lower(self, tree: Tree) -> Tree:
        """cos x as sin(x + pi/2)."""
        args = tuple(map(self.lower, tree.args))
        if tree.op in ("sin", "cos"):
            return call("sin", _ahead(args[0], math.pi / 2 if tree.op == "cos" else 0.0))
        return tree if args == tree.args else Tree(tree.op, args, tree.value, tree.name)


def _ahead(angle: Tree, by: float) -> Tree:
    """An angle and a number, which isn't below zero."""
    constants = [arg.value for arg in angle.args if arg.op == "number"] if angle.op == "+" else []
    turned = math.fmod(sum(constants) + by + 4 * math.pi, 2 * math.pi)
    return add(angle, number(turned - sum(constants)))


def _positive(links: Linkage, vector: Vector) -> Tree:
    """The length of a vector of one arm."""
    (arm,) = vector.arms
    return arm.length if links.numbers(arm.length).min() > 0 else negated(arm.length)
