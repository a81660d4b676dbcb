"""Where the numbers of a model stand in the text of its file, and the same text with other numbers.

Nothing is parsed and written again: the digits alone are replaced. Unit, blanks, quotes, exponent, comments, line ends
and a byte order mark stay as they are.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from decimal import Decimal

from linkwright.data_classes import dataclass
from linkwright.expressions.dimensions import DimensionError, declared_scale
from linkwright.expressions.language import ExpressionError, Node, Number, parse
from linkwright.expressions.typed_fields import Path
from linkwright.expressions.units import PURE, Dimension, unit, unit_text
from linkwright.expressions.written import FrozenDict
from linkwright.model.copies import with_copies
from linkwright.model.named_numbers import NamedNumbers
from linkwright.model.number_places import NumberPlace, literal, number_places
from linkwright.model.placed_copies import Placed
from linkwright.model.yaml_text import Source, WrittenScalar, read_text

_NUMBER = re.compile(r"(?:[-+−]\s*)*(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")
_SIGNS = re.compile(r"[-+−\s]*")
_EXPONENT = re.compile(r"[eE]([+-]?[0-9]+)$")
_BREAK = re.compile(r"\r\n|\n|\r")
_MARK = "\ufeff"
"""The byte order mark."""


class NumberRefusedError(ValueError):
    """A number that can't be written into the text: its ``name``, and the ``reason`` as a key (see
    :class:`NumberSpans`)."""

    def __init__(self, name: str, reason: str) -> None:
        super().__init__(f"{name}: {reason}")
        self.name, self.reason = name, reason


@dataclass(frozen=True)
class NumberSpan:
    """A number in a text: its ``digits`` with their sign, from ``start`` to ``end``.

    ``path`` is the place in the model. Places in the text count code points from 0, ``line`` from 1; ``column`` is that
    of the first digit or sign, ``text`` the whole line. ``unit`` is the one that is written, or else that of the file's
    ``units``, and ``size`` its SI value. ``quote`` is the quotation mark around the value, empty without; ``keyed``
    says that it stands behind ``value:``.
    """

    path: Path
    digits: str
    start: int
    end: int
    line: int
    column: int
    text: str
    unit: str
    size: float
    quote: str = ""
    keyed: bool = False

    @property
    def value(self) -> float:
        """The number in SI."""
        return self.read(self.digits)

    def read(self, digits: str) -> float:
        """The value in SI that a reader of the file gets from some digits in its place."""
        number = literal(parse(digits))
        assert number is not None
        return number.value * self.size

    def written(self, value: float, resolution: float | None = None) -> str:
        """The digits for a value, both it and the ``resolution`` in SI: to the largest power of ten in the written unit
        that isn't above the resolution; without one, the shortest that are read as this value or a neighbour of it."""
        if not math.isfinite(value):
            raise ValueError("only finite numbers can be written")
        number = Decimal(repr(self._shortest(value)))
        if resolution:
            step = Decimal(1).scaleb(math.floor(math.log10(resolution / self.size) + 1e-9))  # 0.0001/0.001 is 0.1
            number = (number / step).to_integral_value() * step
        exponent = _EXPONENT.search(self.digits)
        text = format(abs(number).scaleb(-int(exponent[1]) if exponent else 0), "f")
        text = text.rstrip("0").rstrip(".") if "." in text else text
        if exponent:  # to some readers of YAML a number has an exponent only behind a point
            text += (".0" if "." in self.digits and "." not in text else "") + exponent[0]
        signs = _SIGNS.match(self.digits)
        given = signs.group() if signs else ""
        minus = len(re.findall("[-−]", given)) % 2 == 1
        return (given if minus == (number < 0) else "-" if number < 0 else "") + text

    def _shortest(self, value: float) -> float:
        """The number with the fewest digits that stands for a value: 412 mm for 0.412 m, which is its neighbour."""
        inside = value / self.size
        short = (float(f"{inside:.{digits}g}") for digits in range(1, 18))
        return next((number for number in short if abs(number * self.size - value) <= math.ulp(value)), inside)


@dataclass(frozen=True)
class NumberSpans:
    """The numbers of a model by the names of their parameters, as far as they stand in the ``text``.

    ``refused`` has the others, each with the reason: ``expression`` (arithmetic or another name is written),
    ``derived`` (from a sketch), ``shared`` (of all copies of a sub-assembly, and a number for itself), ``not-found``
    (not in this text), ``form`` (in brackets, with escapes or over several lines), ``unit`` (a zero without a unit,
    whose unit the file doesn't declare).
    """

    text: str
    spans: Mapping[str, NumberSpan]
    refused: Mapping[str, str]

    def rewritten(self, changes: Mapping[str, float], resolution: float | None = None) -> str:
        """The text with other values of some numbers in SI; see :meth:`NumberSpan.written`.

        Raises :class:`NumberRefusedError` for a number that has no place in it.
        """
        for name in changes:
            if name not in self.spans:
                raise NumberRefusedError(name, self.refused.get(name, "not-found"))
        text = self.text
        for name in sorted(changes, key=lambda name: self.spans[name].start, reverse=True):
            span = self.spans[name]
            text = f"{text[: span.start]}{span.written(changes[name], resolution)}{text[span.end :]}"
        return text


def number_spans(named: NamedNumbers, written: str | Source) -> NumberSpans:
    """Where the named parameters and the written numbers of a model stand in its text: that of its file, as text or as
    it was read, or the one that :func:`~linkwright.model.document.dump` gives."""
    source = written if isinstance(written, Source) else read_text(written.encode())
    text = (source.text or "") if isinstance(written, Source) else written
    offset, data = len(_MARK) if text.startswith(_MARK) else 0, source.data
    by_path = {place.path: place for place in number_places(named.written, data)} if isinstance(data, dict) else {}
    lines = [0, *(match.end() for match in _BREAK.finditer(text))]
    spans: dict[str, NumberSpan] = {}
    refused: dict[str, str] = {}
    placed = with_copies(named.written)
    for name, path, dimension in _numbers(named, placed):
        place = by_path.get(path)
        if place is None:
            refused[name] = _missing(named, placed, name)
            continue
        found = _found(text, offset, place, source.scalars)
        of = _unit(place.expression.node, dimension, named.quantities.declared)
        if found is None or of is None:
            refused[name] = "form" if found is None else "unit"
            continue
        start, end, quote = found
        line = sum(at <= start for at in lines)
        stop = _BREAK.search(text, start)
        first = lines[line - 1]
        whole = text[max(first, offset) : stop.start() if stop else len(text)]
        column, keyed = start - max(first, offset), path[0] == "parameters" and place.data_path != path
        spans[name] = NumberSpan(path, text[start:end], start, end, line, column, whole, *of, quote, keyed)
    return NumberSpans(text, FrozenDict(spans), FrozenDict(refused))


def _numbers(named: NamedNumbers, placed: Placed) -> Iterator[tuple[str, Path, Dimension]]:
    """All numbers by name, each with its place in the model and its dimension: parameters first."""
    given = {name: path for copy in reversed(placed.copies) for name, path in copy.given.items() if path[0] == "copies"}
    for name in named.quantities.parameters:
        if name not in named.numbers:
            yield name, given.get(name, ("parameters", name)), named.quantities.dimensions.of(name)
    for name, number in named.numbers.items():
        yield name, number.path, number.dimension


def _missing(named: NamedNumbers, placed: Placed, name: str) -> str:
    """Why a number has no place in the data of a text."""
    if name in named.numbers:
        return "not-found"
    stated = named.written.parameters.get(name)
    if stated is None:
        return "derived" if name not in placed.mechanism.parameters else "shared"
    return "expression" if literal(stated.value.node) is None else "not-found"


def _unit(node: Node, dimension: Dimension, declared: Mapping[str, str]) -> tuple[str, float] | None:
    """The unit in which a number is written, and its SI value."""
    number = literal(node)
    if number is not None and number.unit is not None:
        return number.unit, unit(number.unit)[0]
    if dimension == PURE:
        return "", 1.0
    try:
        return unit_text(dimension, dict(declared)), declared_scale(dimension, declared)
    except (DimensionError, ValueError):
        return None


def _found(
    text: str, offset: int, place: NumberPlace, scalars: Mapping[Path, WrittenScalar]
) -> tuple[int, int, str] | None:
    """From where to where the number of a place stands in the text, and the quotation mark around its value."""
    scalar = scalars.get(place.data_path)
    if scalar is None:
        return None
    first, last = scalar.start + offset + len(scalar.quote), scalar.end + offset - len(scalar.quote)
    if text[first:last] != scalar.value:  # escapes, folded lines
        return None
    start, end = (first + place.start, first + place.end) if isinstance(place.expression.raw, str) else (first, last)
    match = _NUMBER.match(text, start, end)
    if match is None or not _reads_as(text[start:end], place.expression.node):
        return None
    return *match.span(), scalar.quote


def _reads_as(text: str, node: Node) -> bool:
    """Whether a part of the text is this number."""
    try:
        found, wanted = literal(parse(text)), literal(node)
    except ExpressionError:
        return False
    return isinstance(found, Number) and found == wanted
