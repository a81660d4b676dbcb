"""The numbers of a model that a page lets its reader move, as plain data: values, ranges, places in the text."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from typing import TypedDict

from linkwright.expressions.fields import Expression
from linkwright.expressions.language import Name
from linkwright.expressions.typed_fields import Path, Sign
from linkwright.expressions.units import ANGLE, LENGTH, Dimension
from linkwright.model.named_numbers import NamedNumbers
from linkwright.model.number_places import of_copies
from linkwright.model.number_spans import NumberSpan, number_spans
from linkwright.model.tolerances import ClassName, full_tolerance
from linkwright.model.walk import QuantityPlace
from linkwright.model.yaml_text import Source
from linkwright.tolerances.classes import NoTolerance

SHARE = 0.5
"""The share of a value by which it may be moved either way."""
PLACES = 0.25
"""The share of the largest length by which a coordinate may be moved at least."""
LEAST = 0.01
"""The smallest share of a value that must be positive."""


class LiveNumber(TypedDict):
    """A number by the ``name`` of its parameter.

    ``value``, ``low`` and ``high`` are in SI, and so are the limits of its ``tolerance``; ``size`` is the SI value of
    its ``unit``. ``path`` is its place in the
    model, ``label`` that in short. ``line`` counts from 1; ``start`` and ``end`` are the columns of its ``digits`` in
    that line, in code points from 0.
    """

    name: str
    label: str
    path: list[str | int]
    value: float
    unit: str
    size: float
    low: float
    high: float
    tolerance: list[float] | None
    line: int
    start: int
    end: int
    digits: str


def live_numbers(named: NamedNumbers, written: str | Source) -> list[LiveNumber]:
    """The named parameters and written numbers of a model that stand as such in its text, in the order of the text;
    ``written`` is that, or what was read of it."""
    spans, signs = number_spans(named, written).spans, _signs(named)
    found: list[LiveNumber] = []
    for name, span in sorted(spans.items(), key=lambda item: item[1].start):
        low, high = _range(named, name, span, signs.get(name, Sign.ANY))
        tolerance = _tolerance(named, name)
        found.append(
            {
                "name": name,
                "label": _label(span.path) if name in named.numbers else name,
                "path": [*span.path],
                "value": named.quantities.parameters[name],
                "unit": span.unit,
                "size": span.size,
                "low": low,
                "high": high,
                "tolerance": tolerance,
                "line": span.line,
                "start": span.column,
                "end": span.column + len(span.digits),
                "digits": span.digits,
            }
        )
    return found


def _label(path: Path) -> str:
    """A place in short: without its section, unless that is all there is; of a sub-assembly's parameter the names."""
    if of_copies(path):
        path = tuple(key for key in path if key not in ("subassemblies", "copies", "parameters"))
        return ".".join(map(str, path))
    return ".".join(str(key) for key in (path[1:] if len(path) > 2 or path[0] == "parameters" else path))


def _signs(named: NamedNumbers) -> dict[str, Sign]:
    """The strictest sign that any place wants of a parameter which is its whole value."""
    order = [*Sign]
    found = {name: number.sign for name, number in named.numbers.items()}
    for site in named.quantities.fields:
        if isinstance(site, QuantityPlace) and isinstance(node := site.parts[0][0].node, Name):
            sign = site.parts[0][1].sign_at(site.context)
            found[node.text] = max(found.get(node.text, Sign.ANY), sign, key=order.index)
    return found


def _range(named: NamedNumbers, name: str, span: NumberSpan, sign: Sign) -> tuple[float, float]:
    """From where to where a number may be moved (SI): by a share of its value."""
    value, dimension = named.quantities.parameters[name], named.quantities.dimensions.of(name)
    reach = SHARE * abs(value) or _reach(named, dimension, span.size)
    is_coordinate = dimension == LENGTH and sign is Sign.ANY and name in named.numbers
    if is_coordinate:  # where its axes lie is a choice
        reach = max(reach, PLACES * max(_alike(named, dimension)))
    low, high = value - reach, value + reach
    if sign is Sign.NOT_NEGATIVE:
        low = max(low, 0.0)
    elif sign is Sign.POSITIVE:
        low = max(low, LEAST * value)
    return low, high


def _tolerance(named: NamedNumbers, name: str) -> list[float] | None:
    """The limits of a parameter's tolerance (SI), where it has one."""
    value, dimension = named.quantities.parameters[name], named.quantities.dimensions.of(name)
    stated = named.quantities.mechanism.parameters.get(name)
    limits = full_tolerance(stated.tolerance).limits if stated is not None else None
    if isinstance(limits, ClassName):
        if dimension == LENGTH:
            with contextlib.suppress(NoTolerance):
                low, high = limits.found.limits(abs(value))
                return [value + low, value + high]
        return None
    if limits is None:
        return None
    ends = [limits] if isinstance(limits, Expression) else [*limits]
    off = [named.quantities.value(end, dimension) for end in ends]
    return [value + (off[0] if len(off) == 2 else -off[0]), value + off[-1]]


def _reach(named: NamedNumbers, dimension: Dimension, unit: float) -> float:
    """How far a zero may be moved (SI): a length by the largest of the mechanism, an angle by 1 rad, all else by a
    share of the largest of its kind; by one unit where there is no other."""
    if dimension == ANGLE:
        return 1.0
    largest = max(_alike(named, dimension), default=0.0)
    return (1.0 if dimension == LENGTH else SHARE) * largest or unit


def _alike(named: NamedNumbers, dimension: Dimension) -> Iterator[float]:
    """The magnitudes of all parameters of a dimension."""
    for name, value in named.quantities.parameters.items():
        if named.quantities.dimensions.of(name) == dimension:
            yield abs(value)
