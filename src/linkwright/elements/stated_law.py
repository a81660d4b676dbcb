"""A law of motion as an entry states it: a constant speed or acceleration, or an expression in the time."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Any

from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression
from linkwright.expressions.language import Binary, Name, Node, Number
from linkwright.expressions.units import Dimension
from linkwright.expressions.written import Fault

Bind = Callable[[Expression, Dimension], Node]
"""An expression as a tree in SI, where it stands for a quantity of a dimension."""


class StatedLaw:
    """What entries with the keys ``speed``, ``start``, ``acceleration`` or ``position`` share."""

    if TYPE_CHECKING:  # entries have these among their own fields, in their order
        speed: Expression | None
        start: Expression | None
        acceleration: Expression | None
        position: Expression | None

    @staticmethod
    def law_faults(given: Mapping[str, Any]) -> Iterator[Fault]:
        """What is wrong with the keys that are given."""
        if ("speed" in given) == ("position" in given):
            yield "drive.law", {}
        elif "start" in given and "speed" not in given:
            yield "drive.start", {}
        if "acceleration" in given and "speed" not in given:
            yield "drive.acceleration", {}

    def uniform(self, angle: bool) -> list[tuple[Expression, Dimension]]:
        """Of one without ``position``: start, speed and acceleration, as far as they are given, with their dimensions
        where what is prescribed is an ``angle`` or else a length."""
        of = (u.ANGLE, u.OMEGA, u.ALPHA) if angle else (u.LENGTH, u.SPEED, u.ACCELERATION)
        given = zip((self.start, self.speed, self.acceleration), of, strict=True)
        return [(expression, dimension) for expression, dimension in given if expression is not None]

    def tree(self, bind: Bind, angle: bool) -> Node:
        """The value (rad or m) in t, parameters and called functions."""
        if self.position is not None:
            return bind(self.position, u.ANGLE if angle else u.LENGTH)
        powers = {u.ANGLE: 0, u.LENGTH: 0, u.OMEGA: 1, u.SPEED: 1, u.ALPHA: 2, u.ACCELERATION: 2}
        terms = (_term(bind(expression, of), powers[of]) for expression, of in self.uniform(angle))
        total: Node = Number(0.0)
        for term in terms:
            total = Binary("+", total, term)
        return total


def _term(value: Node, power: int) -> Node:
    """A value times t^power/power!."""
    time = Name("t")
    every: tuple[tuple[Node, ...], ...] = ((), (time,), (Number(0.5), time, time))
    for factor in every[power]:
        value = Binary("*", value, factor)
    return value
