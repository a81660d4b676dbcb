"""Cost laws: what it costs to keep a dimension within plus and minus a half-width.

A law is a class under ``@register`` whose key in the file is its name. Its numbers are for half-widths in the
parameter's own unit; :meth:`Cost.law` gives it for half-widths in m or rad. Laws: G. H. Sutherland and B. Roth, J. Eng.
Ind. 97 (1975) 283-286 (reciprocal power); M. F. Spotts, J. Eng. Ind. 95 (1973) 762-764 (reciprocal squared); F. H.
Speckhart, J. Eng. Ind. 94 (1972) 447-453 (exponential).
"""

from __future__ import annotations

import math
import re
from abc import abstractmethod
from collections.abc import Callable, Mapping
from functools import cached_property, reduce
from operator import or_
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Protocol

import numpy as np
from numpy.typing import NDArray
from pydantic import BeforeValidator, Discriminator, Tag, WithJsonSchema

from linkwright.data_classes import dataclass
from linkwright.elements.fields import Interval
from linkwright.expressions.fields import Frozen, fault
from linkwright.expressions.written import plain_number, unexpected
from linkwright.findings import Joined
from linkwright.notation.registry import Registry

Array = NDArray[np.float64]
Slopes = tuple[float, float]
Widths = Callable[[str], float | None]
"""The half-width (m) of a standard grade for a parameter; None where there is none."""

NEAR = 1e-6
"""Within this share of a half-width two are the same to a law with kinks."""
GRADE = re.compile(r"IT(?:01|0|1[0-8]?|[2-9])")
LARGEST = 1e40


class CostLaw(Protocol):
    """The cost of a half-width (SI): convex, falling."""

    def cost(self, half: float) -> float:
        """The cost; infinite where the law has none."""

    def slopes(self, half: float) -> Slopes:
        """Its derivatives below and above."""


@dataclass(frozen=True)
class Smooth:
    """A law with its first and second derivatives."""

    formula: Callable[[float], float]
    slope: Callable[[float], float]
    curvature: Callable[[float], float]

    def cost(self, half: float) -> float:
        return float(self.formula(half))

    def slopes(self, half: float) -> Slopes:
        return (self.slope(half),) * 2


@dataclass(frozen=True, eq=False)
class Stepped:
    """Processes with their half-widths, ascending, costs and labels; the law is their lower convex hull, the most that
    a convex law can ask without being dearer than a process."""

    halves: Array
    costs: Array
    labels: tuple[str, ...]

    def cost(self, half: float) -> float:
        """The cheapest process that keeps within ``half``."""
        kept = self.costs[self.halves <= half * (1 + NEAR)]
        return float(kept.min(initial=np.inf))

    def slopes(self, half: float) -> Slopes:
        corners, slopes = self.corners, np.concatenate([[-np.inf], self.pieces[1], [0.0]])
        i = int(np.argmin(np.abs(corners - half)))
        if abs(corners[i] - half) <= NEAR * half:
            return float(slopes[i]), float(slopes[i + 1])
        return (float(slopes[np.searchsorted(corners, half)]),) * 2

    @property
    def corners(self) -> Array:
        """The half-widths at which the hull has its corners."""
        return self.halves[self._hull]

    @property
    def pieces(self) -> tuple[Array, Array]:
        """The straight pieces of the hull, intercepts and slopes; the hull is the largest of them."""
        halves, costs = self.halves[self._hull], self.costs[self._hull]
        slopes = np.diff(costs) / np.diff(halves)
        return costs[:-1] - slopes * halves[:-1], slopes

    @cached_property
    def _hull(self) -> list[int]:
        """Andrew's monotone chain, as far as the costs fall."""
        hull: list[int] = []
        for i in range(self.halves.size):
            if hull and self.costs[i] >= self.costs[hull].min():
                continue
            while len(hull) > 1 and self._slope(hull[-2], hull[-1]) >= self._slope(hull[-1], i):
                hull.pop()
            hull.append(i)
        return hull

    def _slope(self, i: int, k: int) -> float:
        return float((self.costs[k] - self.costs[i]) / (self.halves[k] - self.halves[i]))


class Cost(Frozen):
    """Base of the laws as a file states them."""

    name: ClassVar[str]
    between: Interval | None = None

    @abstractmethod
    def law(self, size: float, widths: Widths) -> CostLaw:
        """The law for half-widths in SI; ``size`` is the parameter's unit in SI."""

    def unknown(self, widths: Widths) -> list[str]:
        """The grades that the parameter has no half-width for."""
        return []


COSTS: Registry[type[Cost]] = Registry()


def register(cls: type[Cost]) -> type[Cost]:
    """Register a law under its key in the file; a second one of the same name is an error."""
    COSTS[cls.name] = cls
    return cls


def _numbers(law: str, count: int) -> BeforeValidator:
    """The numbers of a law: ``count`` of them, the first at least 0 and the others positive; the first may be left
    out."""

    def check(raw: Any) -> tuple[float, ...]:
        numbers = list(raw) if isinstance(raw, list | tuple) else [raw]
        values = [float(plain_number(number, "cost")) for number in numbers]
        values = [0.0, *values] if len(values) == count - 1 else values
        if len(values) != count:
            raise unexpected("cost", raw)
        if not (0 <= values[0] < LARGEST and all(1 / LARGEST < value < LARGEST for value in values[1:])):
            raise fault("accuracy.cost", law=law, given=Joined(f"{value:g}" for value in values))
        return tuple(values)

    return BeforeValidator(check)


def _listed(count: int) -> WithJsonSchema:
    """The schema of ``count`` numbers of which the first may be left out."""
    each = {"type": "number", "minimum": 0}
    listed = {"type": "array", "items": each, "minItems": count - 1, "maxItems": count}
    return WithJsonSchema({"anyOf": [each, listed]} if count == 2 else listed)


@register
class Reciprocal(Cost):
    """a + b/d of a half-width d."""

    name = "reciprocal"
    reciprocal: Annotated[tuple[float, ...], _numbers("reciprocal", 2), _listed(2)]

    def law(self, size: float, widths: Widths) -> CostLaw:
        a, b = self.reciprocal[0], self.reciprocal[1] * size
        return Smooth(lambda d: a + b / d, lambda d: -b / d**2, lambda d: 2 * b / d**3)


@register
class ReciprocalSquared(Cost):
    """a + b/d^2 of a half-width d."""

    name = "reciprocal_squared"
    reciprocal_squared: Annotated[tuple[float, ...], _numbers("reciprocal_squared", 2), _listed(2)]

    def law(self, size: float, widths: Widths) -> CostLaw:
        a, b = self.reciprocal_squared[0], self.reciprocal_squared[1] * size**2
        return Smooth(lambda d: a + b / d**2, lambda d: -2 * b / d**3, lambda d: 6 * b / d**4)


@register
class Exponential(Cost):
    """a + b exp(-d/m) of a half-width d."""

    name = "exponential"
    exponential: Annotated[tuple[float, ...], _numbers("exponential", 3), _listed(3)]

    def law(self, size: float, widths: Widths) -> CostLaw:
        a, b, m = self.exponential[0], self.exponential[1], self.exponential[2] * size
        return Smooth(
            lambda d: a + b * math.exp(-d / m),
            lambda d: -b / m * math.exp(-d / m),
            lambda d: b / m**2 * math.exp(-d / m),
        )


def _processes(raw: Any) -> tuple[tuple[str | float, float], ...]:
    """Grades or half-widths with their costs."""
    pairs = list(raw.items()) if isinstance(raw, Mapping) else raw
    if not isinstance(pairs, list | tuple) or not pairs:
        raise unexpected("processes", raw)
    found: list[tuple[str | float, float]] = []
    for pair in pairs:
        if not isinstance(pair, list | tuple) or len(pair) != 2:
            raise unexpected("processes", pair)
        key = pair[0] if isinstance(pair[0], str) else float(plain_number(pair[0], "processes"))
        cost = float(plain_number(pair[1], "cost"))
        if isinstance(key, str) and not GRADE.fullmatch(key):
            raise unexpected("processes", key)
        if not 0 <= cost < LARGEST or (isinstance(key, float) and not 1 / LARGEST < key < LARGEST):
            raise fault("accuracy.cost", law="table", given=f"{key}: {cost:g}")
        found.append((key, cost))
    return tuple(found)


@register
class Processes(Cost):
    """Processes, each with the grade or the half-width that it keeps, and its cost: the choice is among these."""

    name = "table"
    table: Annotated[
        tuple[tuple[str | float, float], ...],
        BeforeValidator(_processes),
        WithJsonSchema(
            {
                "anyOf": [
                    {"type": "object", "additionalProperties": {"type": "number"}, "propertyNames": {"pattern": "^IT"}},
                    {"type": "array", "items": {"type": "array", "minItems": 2, "maxItems": 2}},
                ]
            }
        ),
    ]

    def law(self, size: float, widths: Widths) -> CostLaw:
        rows = []
        for key, cost in self.table:
            half = widths(key) if isinstance(key, str) else key * size
            rows.append((float(half or np.nan), cost, key if isinstance(key, str) else f"{key:g}"))
        halves, costs, labels = zip(*sorted(rows), strict=True)
        return Stepped(np.array(halves), np.array(costs), labels)

    def unknown(self, widths: Widths) -> list[str]:
        return [key for key, _ in self.table if isinstance(key, str) and widths(key) is None]


def _kind(raw: Any) -> str:
    keys = raw if isinstance(raw, Mapping) else (getattr(raw, "name", ""),)
    return next((f"by {name}" for name in COSTS if name in keys), "by nothing")


def _looks(raw: Any) -> Any:
    if not isinstance(raw, Mapping | Cost) or _kind(raw) == "by nothing":
        raise unexpected("cost", raw)
    return raw


if TYPE_CHECKING:
    AnyCost = Cost
else:
    AnyCost = Annotated[
        reduce(or_, (Annotated[cls, Tag(f"by {name}")] for name, cls in COSTS.items())),
        Discriminator(_kind),
        BeforeValidator(_looks),
    ]
