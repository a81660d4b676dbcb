"""Where plain numbers are written in a model: each quantity that is a number alone, with its place in plain data.

A quantity is found by its typed field, the number in the text of the value that holds it: the angle of ``G at 90 deg``,
the radius of ``70 at 30 deg``. The data are those of a file as it is read, or of a document as it is written.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

from pydantic_core import PydanticCustomError

from linkwright.expressions.dimensions import Wanted
from linkwright.expressions.fields import Expression
from linkwright.expressions.language import Negative, Node, Number
from linkwright.expressions.typed_fields import Context, Path, Scope, Sign
from linkwright.expressions.written import Shortened, Written
from linkwright.model.mechanism import Mechanism, scopes
from linkwright.model.walk import QuantityPlace, written_sites

_MARK = "number'"
"""An expression that no file has: names of a file hold no apostrophe."""
_SCOPES = (Scope.CONSTANT, Scope.LOAD, Scope.TIME)
"""Where a number alone is a quantity of the mechanism."""


class NumberPlace(NamedTuple):
    """A number that is the whole value of a place.

    ``path`` is that of the quantity; behind it which one, where a value holds several (``x``, 0). ``data_path`` leads
    to the text or number in plain data that holds it, from ``start`` to ``end`` in that as text. ``wanted`` is the
    dimension of the place, as far as it is known there.
    """

    path: Path
    data_path: Path
    start: int
    end: int
    expression: Expression
    wanted: Wanted | None
    sign: Sign = Sign.ANY

    @property
    def section(self) -> str:
        """The section in which it stands, of the file or of a sub-assembly."""
        return str(self.path[2] if self.path[0] == "subassemblies" else self.path[0])


def stands_for_number(name: str) -> bool:
    """Whether a name is one of those that no file has, which are given to its numbers."""
    return "'" in name


def of_copies(path: Path) -> bool:
    """Whether at a place stands the value of a parameter that all copies of a sub-assembly have which give it no other:
    that of the sub-assembly itself, or what it gives to a copy within."""
    inside = path[2:] if path[0] == "subassemblies" else ()
    own = inside[:1] == ("parameters",) and len(inside) == 2
    return own or (inside[:3:2] == ("copies", "parameters") and len(inside) == 4)


def literal(node: Node) -> Number | None:
    """The number that an expression is, with its sign; ``None`` of arithmetic and names."""
    if isinstance(node, Negative) and isinstance(node.of, Number):
        return Number(-node.of.value, node.of.unit)
    return node if isinstance(node, Number) else None


def number_places(m: Mechanism, data: Mapping[str, Any]) -> Iterator[NumberPlace]:
    """All plain numbers of a mechanism with its short forms, in the order of its fields, as far as they stand in
    ``data``; then those of its sub-assemblies."""
    for at, part in scopes(m):
        for place in _places(part, data_at(data, at)):
            yield place._replace(path=(*at, *place.path), data_path=(*at, *place.data_path))


def _places(m: Mechanism, data: Any) -> Iterator[NumberPlace]:
    for site in written_sites(m, Context(m)):
        for index, (expression, of) in enumerate(site.parts):
            if of.scope not in _SCOPES or literal(expression.node) is None:
                continue
            if (found := _in_data(site, index, data)) is not None:
                sign = of.sign_at(site.context) if index == 0 else Sign.ANY
                yield NumberPlace(_path(site, index), *found, expression, of.dimension_at(site.context), sign)


def data_at(data: Any, path: Path) -> Any:
    """What stands at a place of plain data; ``None`` where there is nothing."""
    for key in path:
        known: Any = data if isinstance(data, Mapping) else range(len(data)) if isinstance(data, list | tuple) else ()
        if key not in known:
            return None
        data = data[key]
    return data


def _path(site: QuantityPlace, index: int) -> Path:
    if len(site.parts) == 1:
        return site.path
    names: tuple[str | int, ...] = site.written.part_names() if site.written is not None else ()
    return (*site.path, names[index] if index < len(names) else index)


def _in_data(site: QuantityPlace, index: int, data: Any) -> tuple[Path, int, int] | None:
    """The path to the text or number that holds one of the numbers of a site, and where it stands in that."""
    path, held, written = site.path, data_at(data, site.path), site.written
    entry = site.context.entry
    if isinstance(held, Mapping) and isinstance(entry, Shortened):
        path = (*path, entry.main)
        held = held.get(entry.main)
    expression = site.parts[index][0]
    if isinstance(held, list | tuple) and index < len(held):
        path, held, written, index = (*path, index), held[index], expression, 0
    if isinstance(held, bool) or not isinstance(held, int | float | str):
        return None
    if not isinstance(held, str):
        return (path, 0, len(str(held))) if held == expression.raw else None
    span = span_of_part(held, expression.text.strip(), expression if written is None else written, index)
    return None if span is None else (path, *span)


def span_of_part(text: str, part: str, written: Written, index: int) -> tuple[int, int] | None:
    """Where a part of a written value stands in its text: there another expression takes its place, and no other's."""
    wanted = [expression.text.strip() for expression, _ in written.quantities()]
    if index >= len(wanted) or wanted[index] != part:
        return None
    wanted[index] = _MARK
    start = text.rfind(part)
    while start >= 0:
        end = start + len(part)
        try:
            other = type(written)(f"{text[:start]}{_MARK}{text[end:]}")
        except PydanticCustomError:
            other = None
        if other is not None and [expression.text.strip() for expression, _ in other.quantities()] == wanted:
            return start, end
        start = text.rfind(part, 0, end - 1) if end > 1 else -1
    return None
