"""Angles as sums of joint values, and vectors as sums of arms at such angles."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Mapping

from linkwright.data_classes import dataclass
from linkwright.exports.process_simulate.trees import ZERO, Tree, add, call, multiply, number

TINY = 1e-13
"""An arm shorter than this share of the others is none."""


@dataclass(frozen=True)
class Angle:
    """``constant`` (rad) and so many times each of some symbols: joint values, or trees that stand for themselves."""

    constant: float = 0.0
    parts: tuple[tuple[str, int], ...] = ()

    def plus(self, other: Angle, times: int = 1) -> Angle:
        """The sum with so many times another."""
        parts = dict(self.parts)
        for symbol, count in other.parts:
            parts[symbol] = parts.get(symbol, 0) + times * count
        kept = tuple((symbol, count) for symbol, count in parts.items() if count)
        return Angle(self.constant + times * other.constant, kept)

    def minus(self, other: Angle) -> Angle:
        """The difference."""
        return self.plus(other, -1)

    def rotated(self, by: float) -> Angle:
        """The angle with a number added (rad)."""
        return Angle(self.constant + by, self.parts)

    def tree(self, symbols: Mapping[str, Tree]) -> Tree:
        """The angle as a tree."""
        return add(*(multiply(number(count), symbols[name]) for name, count in self.parts), number(self.constant))


def cosine(angle: Angle, symbols: Mapping[str, Tree]) -> Tree:
    """cos of an angle, which is written with its first symbol positive."""
    if angle.parts and angle.parts[0][1] < 0:
        angle = Angle().minus(angle)
    return _wave("cos", angle, symbols)


def sine(angle: Angle, symbols: Mapping[str, Tree]) -> Tree:
    """sin of an angle, which is written with its first symbol positive."""
    if angle.parts and angle.parts[0][1] < 0:
        return multiply(number(-1), _wave("sin", Angle().minus(angle), symbols))
    return _wave("sin", angle, symbols)


def _wave(name: str, angle: Angle, symbols: Mapping[str, Tree]) -> Tree:
    """Whole turns are left out; quarter turns change function and sign."""
    quarters = angle.constant / (math.pi / 2)
    nearest = round(quarters)
    if abs(quarters - nearest) > 1e-12:
        if not angle.parts:
            return number(math.cos(angle.constant) if name == "cos" else math.sin(angle.constant))
        constant = math.remainder(angle.constant, 2 * math.pi)
        return call(name, Angle(constant, angle.parts).tree(symbols))
    sign, turned = _QUARTERS[name][nearest % 4]
    bare = Angle(0.0, angle.parts).tree(symbols)
    return multiply(number(sign), call(turned, bare))


_QUARTERS = {
    "cos": ((1.0, "cos"), (-1.0, "sin"), (-1.0, "cos"), (1.0, "sin")),
    "sin": ((1.0, "sin"), (1.0, "cos"), (-1.0, "sin"), (-1.0, "cos")),
}


@dataclass(frozen=True)
class Arm:
    """A length (a tree in mm) in a direction."""

    length: Tree
    angle: Angle


@dataclass(frozen=True)
class Vector:
    """A sum of arms; those that keep their directions to each other are one."""

    arms: tuple[Arm, ...] = ()

    @classmethod
    def of(cls, arms: Iterable[Arm]) -> Vector:
        fixed: dict[tuple[tuple[str, int], ...], complex] = {}
        sliding = []
        for arm in arms:
            if arm.length.op == "number":
                key = tuple(sorted(arm.angle.parts))
                fixed[key] = fixed.get(key, 0.0) + cmath.rect(arm.length.value, arm.angle.constant)
            else:
                sliding.append(arm)
        size = max(map(abs, fixed.values()), default=0.0)
        kept = [
            Arm(number(abs(sum_)), Angle(cmath.phase(sum_), key))
            for key, sum_ in fixed.items()
            if abs(sum_) > TINY * max(size, 1.0)
        ]
        return cls((*kept, *sliding))

    @classmethod
    def fixed(cls, x: float, y: float, angle: Angle) -> Vector:
        """A vector (mm) on a link at an angle."""
        return cls.of([Arm(number(math.hypot(x, y)), angle.rotated(math.atan2(y, x)))])

    def plus(self, other: Vector) -> Vector:
        """The sum."""
        return Vector.of((*self.arms, *other.arms))

    def minus(self, other: Vector) -> Vector:
        """The difference."""
        return self.plus(Vector(tuple(Arm(arm.length, arm.angle.rotated(math.pi)) for arm in other.arms)))

    def rotated(self, by: Angle) -> Vector:
        """The vector turned by an angle."""
        return Vector(tuple(Arm(arm.length, arm.angle.plus(by)) for arm in self.arms))

    def along(self, direction: Angle, symbols: Mapping[str, Tree]) -> Tree:
        """Its component along a direction (mm)."""
        return add(*(multiply(arm.length, cosine(arm.angle.minus(direction), symbols)) for arm in self.arms))

    def across(self, direction: Angle, symbols: Mapping[str, Tree]) -> Tree:
        """Its component across a direction, to the left of it (mm)."""
        return add(*(multiply(arm.length, sine(arm.angle.minus(direction), symbols)) for arm in self.arms))

    def square(self, symbols: Mapping[str, Tree]) -> Tree:
        """The square of its length (mm^2), by the law of cosines."""
        total = ZERO
        for i, arm in enumerate(self.arms):
            total = add(total, multiply(arm.length, arm.length))
            for other in self.arms[:i]:
                between = cosine(arm.angle.minus(other.angle), symbols)
                total = add(total, multiply(number(2.0), arm.length, other.length, between))
        return total
