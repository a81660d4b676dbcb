"""What loads and measures share: tables and windows, as files state them; the limits on measures."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from pathlib import PurePosixPath, PureWindowsPath
from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Discriminator, Tag, WithJsonSchema

from linkwright.elements.fields import Interval, freeze
from linkwright.expressions.dimensions import argument, crossed, value
from linkwright.expressions.fields import Expression, Frozen, Two, fault, pair, parse_text
from linkwright.expressions.language import is_signal
from linkwright.expressions.system import Unknown
from linkwright.expressions.typed_fields import Ends, Quantity, Scope, Sign
from linkwright.expressions.units import PURE, TIME, Dimension, UnitError, unit
from linkwright.expressions.unknown_units import unknown_unit
from linkwright.expressions.written import Fault, short_text, unexpected
from linkwright.findings import Joined
from linkwright.reductions import figure

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
        raise fault("units.unknown", **unknown_unit(text.split(None, 1)[1], error)) from None
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

    file: FileBeside | None = None
    points: Annotated[tuple[CellRow, ...], BeforeValidator(_rows)] | None = None
    x: Column | None = None
    y: Column | None = None
    period: Annotated[Expression | None, _column_of(argument, Sign.POSITIVE, "period")] = None
    between: Literal["linear", "cubic", "quintic"] = "cubic"

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        columns = [key for key in ("x", "y") if key in given]
        if ("file" in given) == ("points" in given):
            yield "table.source", {}
        elif "file" in given and len(columns) < 2:
            yield "table.columns", {}
        elif "points" in given and columns:
            yield "table.inline-columns", {"given": Joined(columns)}


def _signal(raw: Any) -> str:
    text = short_text(raw)
    if not is_signal(parse_text(text)):
        raise fault("window.signal", given=text[:60])
    return text


def _single_signal(raw: Any) -> Any:
    if len(raw) != 1:
        raise fault("window.one-signal", count=len(raw))
    return raw


_Signal = Annotated[str, BeforeValidator(_signal), Quantity(lambda c: crossed(c.name), scope=Scope.SIGNALS)]
_Crossing = Annotated[Interval, Quantity(lambda c: crossed(c.name), ends=Ends.RISING)]
_BySignal = Annotated[dict[_Signal, _Crossing], BeforeValidator(_single_signal), freeze]

Window = Annotated[
    Annotated[Interval, Quantity(TIME, ends=Ends.RISING), Tag("time")] | Annotated[_BySignal, Tag("signal")],
    Discriminator(lambda raw: "signal" if isinstance(raw, Mapping) else "time"),
]


BOUND = Quantity(
    lambda c: figure(c.name, c.mechanism.measures[c.name]) if c.name in c.mechanism.measures else None,
    ends=Ends.ORDERED,
)
"""What bounds a measure of the same name."""
