"""What is asked of a model and what loads and measures share: tables, windows and measures, as its file states them."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import PurePosixPath, PureWindowsPath
from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Discriminator, Field, Tag, WithJsonSchema

from linkwright.elements.fields import Interval, freeze
from linkwright.elements.load import crossed
from linkwright.expressions.dimensions import Wanted, argument, value
from linkwright.expressions.fields import Expression, Frozen, Name, Two, fault, pair, parse_text
from linkwright.expressions.language import is_signal
from linkwright.expressions.system import Unknown
from linkwright.expressions.typed_fields import Ends, Quantity, Ref, Scope, Sign
from linkwright.expressions.units import LENGTH, PURE, TIME, Dimension, UnitError, unit
from linkwright.expressions.written import Fault, short_text, unexpected

MAX_ROWS = 10_000

Row = Annotated[Two, BeforeValidator(pair("table-row"))]


def _beside(raw: Any) -> str:
    """The name of a file in the model's own folder or below."""
    name = short_text(raw)
    for path in (PurePosixPath(name), PureWindowsPath(name)):
        if not name.strip() or path.is_absolute() or path.drive or ".." in path.parts:
            raise fault("table.place", file=name[:60])
    return name


FileBeside = Annotated[str, BeforeValidator(_beside)]


def column_unit(text: str | None) -> tuple[float, Dimension]:
    """The unit of ``'COLUMN UNIT'``: its SI value and dimension. Raises UnitError."""
    words = (text or "").split(None, 1)
    return unit(words[1]) if len(words) == 2 else (1.0, PURE)


def _column(raw: Any) -> str:
    text = short_text(raw)
    if not text.strip():
        raise unexpected("column", raw)
    try:
        column_unit(text)
    except UnitError as error:
        raise fault("units.unknown", word=str(error)[:40]) from None
    return text


Column = Annotated[str, BeforeValidator(_column), WithJsonSchema({"type": "string"})]


def _rows(raw: Any) -> Any:
    if not isinstance(raw, list | tuple):
        raise unexpected("table-rows", raw)
    if len(raw) > MAX_ROWS:
        raise fault("file.too-many", count=len(raw), limit=MAX_ROWS)
    return raw


def _column_of(column: Callable[[str], Unknown], sign: Sign = Sign.ANY, term: str = "number") -> Quantity:
    """A number of a column of a table, whose dimension the table's uses tell."""
    return Quantity(lambda c: column(c.name), sign, term)


CellRow = Annotated[
    tuple[Annotated[Expression, _column_of(argument)], Annotated[Expression, _column_of(value)]],
    BeforeValidator(pair("table-row")),
]


class Table(Frozen):
    """A function given by points, inline or in a CSV file beside the model."""

    file: FileBeside | None = Field(None, description="a CSV file beside the model; with x and y")
    points: Annotated[tuple[CellRow, ...], BeforeValidator(_rows)] | None = Field(
        None, description="the points [x, y] themselves, x ascending"
    )
    x: Column | None = Field(None, description="'COLUMN UNIT' of the argument in the file, e.g. 'angle deg'")
    y: Column | None = Field(None, description="'COLUMN UNIT' of the value in the file, e.g. 'pressure bar'")
    period: Annotated[Expression | None, _column_of(argument, Sign.POSITIVE, "period")] = Field(
        None, description="the argument after which the table repeats itself"
    )
    between: Literal["linear", "cubic", "quintic"] = Field(
        "cubic", description="how values between the points are found: straight lines or a spline"
    )

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        columns = [key for key in ("x", "y") if key in given]
        if ("file" in given) == ("points" in given):
            yield "table.source", {}
        elif "file" in given and len(columns) < 2:
            yield "table.columns", {}
        elif "points" in given and columns:
            yield "table.inline-columns", {"given": ", ".join(columns)}


def _signal(raw: Any) -> str:
    text = short_text(raw)
    if not is_signal(parse_text(text)):
        raise fault("window.signal", given=text[:60])
    return text


def _one(raw: Any) -> Any:
    if len(raw) != 1:
        raise fault("window.one-signal", count=len(raw))
    return raw


_Signal = Annotated[str, BeforeValidator(_signal), Quantity(lambda c: crossed(c.name), scope=Scope.SIGNALS)]
_Crossing = Annotated[Interval, Quantity(lambda c: crossed(c.name), ends=Ends.RISING)]
_BySignal = Annotated[dict[_Signal, _Crossing], BeforeValidator(_one), freeze]

Window = Annotated[
    Annotated[Interval, Quantity(TIME, ends=Ends.RISING), Tag("time")] | Annotated[_BySignal, Tag("signal")],
    Discriminator(lambda raw: "signal" if isinstance(raw, Mapping) else "time"),
]


_INSTANT = re.compile(
    r"^\s*(?:(?P<extreme>max|min)\s+(?P<of>\S.*)|(?P<end>start|end)|(?P<signal>[^=]+)=(?P<level>[^=]+))\s*$", re.S
)


@dataclass(frozen=True)
class Instant:
    """When a value is taken: at the ``max`` or ``min`` of an expression, at ``start`` or ``end``, or where an
    expression (a signal less its level) is ``zero``."""

    kind: str
    expression: str = ""

    @classmethod
    def read(cls, text: str) -> Instant | None:
        """As a file writes it: ``max E.x``, ``min E.x``, ``start``, ``end``, ``motor.angle = 24 deg``."""
        match = _INSTANT.match(text)
        if match is None:
            return None
        if match["extreme"]:
            return cls(match["extreme"], match["of"])
        return cls(match["end"]) if match["end"] else cls("zero", f"({match['signal']}) - ({match['level'].strip()})")


REDUCTIONS = ("span", "max", "min", "extremes", "mean", "rms", "value", "path", "straightness", "dwell")


def _where(raw: Any) -> str:
    text = short_text(raw)
    instant = Instant.read(text)
    if instant is None:
        raise fault("measure.bad-where", given=text[:60])
    if instant.expression:
        parse_text(instant.expression)
    return text


def _unit(raw: Any) -> str:
    text = short_text(raw)
    try:
        unit(text)
    except UnitError as error:
        raise fault("units.unknown", word=str(error)[:40]) from None
    return text


FIGURES = {"path": LENGTH, "straightness": LENGTH, "dwell": TIME}
"""What a reduction gives where that isn't of the kind of its signal."""


def measured(name: str) -> Wanted:
    """The unknown dimension of a measure, which its bounds share."""
    return (f"measure {name}", 0)


def figure(name: str, measure: Measure) -> Wanted:
    """What a measure's figure is, and so its bounds, its wrap and its unit."""
    return FIGURES.get(measure.reduction) or measured(name)


def banded(name: str) -> Wanted:
    """The unknown dimension of the signal of a dwell, which its band shares."""
    return (f"dwell {name}", 0)


def instant(name: str) -> Wanted:
    """The unknown dimension of the expression that places a value in time."""
    return (f"where {name}", 0)


_REDUCED = Quantity(lambda c: measured(c.name), scope=Scope.SIGNALS)
_FIGURE = Quantity(lambda c: figure(c.name, c.entry), ends=Ends.RISING)
BOUND = Quantity(
    lambda c: figure(c.name, c.mechanism.measures[c.name]) if c.name in c.mechanism.measures else None,
    ends=Ends.ORDERED,
)
"""What bounds a measure of the same name."""


class Measure(Frozen):
    """A named scalar of a run: one reduction of a signal expression, or of a point's path."""

    span: Annotated[Expression | None, _REDUCED] = Field(
        None, description="largest less smallest value of this signal expression"
    )
    max: Annotated[Expression | None, _REDUCED] = Field(None, description="largest value")
    min: Annotated[Expression | None, _REDUCED] = Field(None, description="smallest value")
    extremes: Annotated[Expression | None, _REDUCED] = Field(
        None, description="both: the smallest and the largest value"
    )
    mean: Annotated[Expression | None, _REDUCED] = Field(None, description="mean over time")
    rms: Annotated[Expression | None, _REDUCED] = Field(None, description="root of the mean square over time")
    value: Annotated[Expression | None, _REDUCED] = Field(None, description="value at one instant; with where")
    where: Annotated[str, BeforeValidator(_where)] | None = Field(
        None,
        description="the instant of a value: 'max E.x', 'min E.x', 'motor.angle = 24 deg', 'start' or 'end'",
        examples=["max E.x", "min E.x", "motor.angle = 24 deg", "start", "end"],
    )
    path: Annotated[Name | None, Ref("point")] = Field(None, description="the length of this point's path")
    straightness: Annotated[Name | None, Ref("point")] = Field(
        None, description="the distance of the two closest parallel lines that hold this point's path"
    )
    dwell: Annotated[Expression | None, Quantity(lambda c: banded(c.name), scope=Scope.SIGNALS)] = Field(
        None, description="the longest time in which this signal expression stays in a band; with within"
    )
    within: Annotated[Expression | None, Quantity(lambda c: banded(c.name), Sign.POSITIVE, "within")] = Field(
        None, description="the whole width of the band of a dwell"
    )
    window: Annotated[Name | None, Ref("window")] = Field(
        None, description="the window (of windows) to which the measure is confined"
    )
    wrap: Annotated[Interval | None, _FIGURE] = Field(
        None, description="[low, high]: whole turns are added until it lies there"
    )
    unit: Annotated[str, BeforeValidator(_unit)] | None = Field(
        None, description="unit of the figure, instead of the declared one"
    )

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        reductions = [name for name in REDUCTIONS if name in given]
        if len(reductions) != 1:
            yield (
                "measure.reduction",
                {"given": ", ".join(reductions) or "-", "known": ", ".join(REDUCTIONS)},
            )
        elif ("value" in given) != ("where" in given):
            yield "measure.where", {}
        elif ("dwell" in given) != ("within" in given):
            yield "measure.within", {}

    @property
    def reduction(self) -> str:
        """The name of the reduction."""
        return next(name for name in REDUCTIONS if getattr(self, name) is not None)

    @property
    def instant(self) -> Instant | None:
        """When a value is taken."""
        return None if self.where is None else Instant.read(self.where)

    @property
    def point(self) -> str | None:
        """The point whose path is looked at."""
        return self.path or self.straightness

    @property
    def signal(self) -> Expression:
        """The expression that is reduced: for a path the point's speed, for a straightness its x."""
        if self.point is not None:
            return Expression(f"hypot({self.path}.vx, {self.path}.vy)" if self.path else f"{self.point}.x")
        expression: Expression = getattr(self, self.reduction)
        return expression

    @property
    def subject(self) -> str:
        """What is reduced, for the reader."""
        within = f" within {self.within.text}" if self.within else ""
        return self.point or f"{self.signal.text}{within}"
