"""What a varied parameter takes: steps, a list, or a distribution; each given as values over (0, 1), its quantiles.

A distribution is a class under ``@register`` whose key in the file is its name. Samples are made by its inverse
distribution function, so that every plan (stratified, low-discrepancy, random) serves every distribution (Devroye,
Non-Uniform Random Variate Generation, 1986, ch. II.2).
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Iterator, Mapping
from functools import reduce
from operator import or_
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

import numpy as np
from numpy.typing import NDArray
from pydantic import BeforeValidator, Discriminator, Field, Tag

from linkwright.data_classes import dataclass
from linkwright.elements.fields import Interval
from linkwright.expressions.fields import Expression, Frozen, TypedParts, Written
from linkwright.expressions.written import Fault, fault, unexpected
from linkwright.findings import Joined
from linkwright.notation.registry import Registry

Array = NDArray[np.float64]
Place = tuple[str | int, ...]

LEAST_SHARE = 1e-9
"""A distribution isn't cut to a range that holds less than this share of it."""
MOST_STEPS = 1_000_000


@dataclass(frozen=True)
class ParameterSpread:
    """What a parameter takes, in SI: its value at shares u in (0, 1), and its ``points`` where there are only so many.

    ``quantile`` takes and gives arrays of any shape.
    """

    quantile: Callable[[Array], Array]
    points: Array | None = None


def _pointed(points: Array) -> ParameterSpread:
    """Equally likely values."""
    last = points.size - 1
    return ParameterSpread(lambda u: points[np.minimum((u * points.size).astype(np.int64), last)], points)


class Steps(Frozen):
    """Equal steps, both ends included."""

    from_: Expression = Field(alias="from")
    to: Expression
    count: int = Field(le=MOST_STEPS)

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        count = given.get("count")
        if isinstance(count, int) and count < 2:
            yield "study.one-value", {"count": count}

    def parts(self) -> list[tuple[Place, Expression]]:
        """Its expressions with their places."""
        return [(("from",), self.from_), (("to",), self.to)]

    def number_faults(self, numbers: list[float]) -> Iterator[Fault]:
        """What is wrong with the numbers of its parts."""
        if numbers[0] == numbers[1]:
            yield "value.not-rising", {"low": self.from_.text[:40], "high": self.to.text[:40]}

    def spread(self, numbers: list[float]) -> ParameterSpread:
        """The values from the numbers of its parts (SI)."""
        return _pointed(np.linspace(numbers[0], numbers[1], self.count))


class Listed(Written):
    """Values one by one."""

    __slots__ = ("values",)
    json_type = {"type": "array", "items": {"type": ["number", "string"]}, "minItems": 2}
    values: tuple[Expression, ...]

    def read(self, raw: Any) -> None:
        if len(raw) < 2:
            raise fault("study.one-value", count=len(raw))
        self.set_attribute("raw", tuple(raw))
        self.set_attribute("values", tuple(Expression(value) for value in raw))

    def quantities(self) -> TypedParts:
        return [(value, None) for value in self.values]

    def parts(self) -> list[tuple[Place, Expression]]:
        """Its expressions with their places."""
        return [((i,), value) for i, value in enumerate(self.values)]

    def number_faults(self, numbers: list[float]) -> Iterator[Fault]:
        """Nothing: any list will do."""
        yield from ()

    def spread(self, numbers: list[float]) -> ParameterSpread:
        """The values."""
        return _pointed(np.array(numbers))


class Distribution(Frozen):
    """Base of the distributions."""

    name: ClassVar[str]

    @abstractmethod
    def parts(self) -> list[tuple[Place, Expression]]:
        """Its expressions with their places."""

    @abstractmethod
    def number_faults(self, numbers: list[float]) -> Iterator[Fault]:
        """What is wrong with the numbers of its parts (SI)."""

    @abstractmethod
    def spread(self, numbers: list[float]) -> ParameterSpread:
        """The values from the numbers of its parts (SI)."""


DISTRIBUTIONS: Registry[type[Distribution]] = Registry()


def register(cls: type[Distribution]) -> type[Distribution]:
    """Register a distribution under its key in the file; a second one of the same name is an error."""
    DISTRIBUTIONS[cls.name] = cls
    return cls


@register
class Normal(Distribution):
    """The normal distribution about a mean, cut to low .. high where these are given."""

    name = "normal"
    normal: Expression
    sigma: Expression
    low: Expression | None = None
    high: Expression | None = None

    def parts(self) -> list[tuple[Place, Expression]]:
        given = ((key, getattr(self, key)) for key in ("normal", "sigma", "low", "high"))
        return [((key,), expression) for key, expression in given if expression is not None]

    def number_faults(self, numbers: list[float]) -> Iterator[Fault]:
        mean, sigma, low, high = self._numbers(numbers)
        if sigma <= 0:
            yield "study.sigma", {"sigma": self.sigma.text[:40]}
        elif low >= high:
            assert self.low and self.high
            yield "value.not-rising", {"low": self.low.text[:40], "high": self.high.text[:40]}
        elif self._share(mean, sigma, low, high)[1] < LEAST_SHARE:
            yield "study.cut-distribution", {"share": LEAST_SHARE}

    def spread(self, numbers: list[float]) -> ParameterSpread:
        from scipy.special import ndtri

        mean, sigma, low, high = self._numbers(numbers)
        side = -1.0 if low > mean else 1.0  # the upper tail is taken as the lower one, where there are digits
        below, share = self._share(mean, sigma, low, high)

        def quantile(u: Array) -> Array:
            rank = below + share * (u if side > 0 else 1 - u)
            return np.asarray(np.clip(mean + side * sigma * ndtri(rank), low, high))

        return ParameterSpread(quantile)

    def _numbers(self, numbers: list[float]) -> tuple[float, float, float, float]:
        given = dict(zip((place[0] for place, _ in self.parts()), numbers, strict=True))
        return given["normal"], given["sigma"], given.get("low", -np.inf), given.get("high", np.inf)

    def _share(self, mean: float, sigma: float, low: float, high: float) -> tuple[float, float]:
        """What lies below the range (above it, where all of it is above the mean), and within."""
        from scipy.special import ndtr

        a, b = (low - mean) / sigma, (high - mean) / sigma
        a, b = (-b, -a) if a > 0 else (a, b)
        below = float(ndtr(a))
        return below, float(ndtr(b)) - below


@register
class Uniform(Distribution):
    """Every value between two ends alike."""

    name = "uniform"
    uniform: Interval

    def parts(self) -> list[tuple[Place, Expression]]:
        return [(("uniform", i), part) for i, part in enumerate(self.uniform)]

    def number_faults(self, numbers: list[float]) -> Iterator[Fault]:
        if not numbers[0] < numbers[1]:
            yield "value.not-rising", {"low": self.uniform[0].text[:40], "high": self.uniform[1].text[:40]}

    def spread(self, numbers: list[float]) -> ParameterSpread:
        low, high = numbers
        return ParameterSpread(lambda u: low + u * (high - low))


def _three(raw: Any) -> Any:
    if not isinstance(raw, list | tuple) or len(raw) != 3:
        raise unexpected("triangle", raw)
    return tuple(raw)


@register
class Triangular(Distribution):
    """Between two ends, the density rising to the most likely value and falling from there."""

    name = "triangular"
    triangular: Annotated[tuple[Expression, Expression, Expression], BeforeValidator(_three)]

    def parts(self) -> list[tuple[Place, Expression]]:
        return [(("triangular", i), part) for i, part in enumerate(self.triangular)]

    def number_faults(self, numbers: list[float]) -> Iterator[Fault]:
        low, mode, high = numbers
        if not (low <= mode <= high and low < high):
            yield "study.triangle", {"values": Joined(part.text[:20] for part in self.triangular)}

    def spread(self, numbers: list[float]) -> ParameterSpread:
        low, mode, high = numbers
        width, rise = high - low, mode - low

        def quantile(u: Array) -> Array:
            rising = low + np.sqrt(u * width * rise)
            return np.where(u * width < rise, rising, high - np.sqrt((1 - u) * width * (high - mode)))

        return ParameterSpread(quantile)


def _kind(raw: Any) -> str:
    if isinstance(raw, list | tuple | Listed):
        return "a list"
    keys = raw if isinstance(raw, Mapping) else (getattr(raw, "name", ""),)
    return next((f"a {name}" for name in DISTRIBUTIONS if name in keys), "steps of")


def _looks(raw: Any) -> Any:
    known = not isinstance(raw, Mapping) or not {"from", "to", "count", *DISTRIBUTIONS}.isdisjoint(raw)
    if not isinstance(raw, list | tuple | Mapping | Steps | Listed | Distribution) or not known:
        raise unexpected("varying", raw)
    return raw


def _branches() -> Any:
    """The union of all that a parameter may take. A branch is chosen by its key, so that its faults are told once;
    its tag is no name that a file may hold."""
    branches: list[Any] = [Annotated[Steps, Tag("steps of")], Annotated[Listed, Tag("a list")]]
    return reduce(or_, branches + [Annotated[cls, Tag(f"a {name}")] for name, cls in DISTRIBUTIONS.items()])


if TYPE_CHECKING:
    Vary = Steps | Listed | Distribution
else:
    Vary = Annotated[_branches(), Discriminator(_kind), BeforeValidator(_looks)]
