"""The lengths and coordinates that a sketch stands for, as numbers that a page lets its reader move.

They stand nowhere in the file. Once one is moved, its value is stated as a parameter, as a file does that changes a
drawn length; :func:`entry_place` says where the file takes it.
"""

from __future__ import annotations

import re
from typing import NamedTuple

from linkwright.expressions.dimensions import DimensionError, declared_scale
from linkwright.expressions.units import LENGTH
from linkwright.model.live_numbers import PLACES, SHARE
from linkwright.model.named_numbers import NamedNumbers
from linkwright.model.sketch import drawn_parameters
from linkwright.model.yaml_text import Source

SECTION = "parameters"
_BRACE = re.compile(r"parameters\s*:\s*\{\s*")
_BLOCK = re.compile(r"parameters\s*:\s*(?:#.*)?$")
_INDENT = re.compile(r"\s+(?=[^\s#])")


class DrawnNumber(NamedTuple):
    """A parameter of the sketch: its ``value``, the ends of its slider (SI), and whether it is a link's length."""

    name: str
    value: float
    low: float
    high: float
    is_length: bool


class EntryPlace(NamedTuple):
    """Where a file takes a further parameter: in its ``line`` (from 1), in braces at ``column``, or below it with an
    ``indent``; without a line in a section of its own. ``unit`` stands behind the digits."""

    line: int | None
    column: int
    indent: str
    unit: str


def drawn_numbers(named: NamedNumbers) -> list[DrawnNumber]:
    """The parameters that the sketch of a file stands for, lengths of links first."""
    nominal, found = named.quantities.parameters, []
    largest = max((abs(v) for n, v in nominal.items() if named.quantities.dimensions.of(n) == LENGTH), default=0.0)
    for name, is_length in drawn_parameters(named.written).items():
        if name not in nominal or name in named.spelled.placed.parameters:
            continue
        value = nominal[name]
        reach = SHARE * abs(value) if is_length else max(SHARE * abs(value), PLACES * largest)
        found.append(DrawnNumber(name, value, value - reach, value + reach, is_length))
    return sorted(found, key=lambda one: not one.is_length)


def entry_place(named: NamedNumbers, source: Source) -> EntryPlace | None:
    """Where a file takes a further parameter; ``None`` where its text has no plain place for one."""
    if not isinstance(source.data, dict) or source.text is None:
        return None
    lines, unit = source.text.splitlines(), _unit(named)
    if SECTION not in source.data:
        line = source.lines.get(("sketch",))
        in_block = line is not None and lines[line - 1].startswith("sketch")
        return EntryPlace(None, 0, "", unit) if in_block else None
    line = source.lines.get((SECTION,))
    if line is None or not source.data[SECTION]:
        return None
    if brace := _BRACE.match(lines[line - 1]):
        return EntryPlace(line, brace.end(), "", unit)
    if _BLOCK.match(lines[line - 1]):
        indents = (_INDENT.match(text) for text in lines[line:])
        indent = next((one.group() for one in indents if one), "")
        return EntryPlace(line, 0, indent, unit) if indent else None
    return None


def _unit(named: NamedNumbers) -> str:
    """What stands behind a length: nothing where the file declares its unit of lengths."""
    try:
        declared_scale(LENGTH, named.quantities.declared)
    except DimensionError:
        return f" {named.quantities.unit_of(LENGTH)[0]}"
    return ""
