"""Where a mechanism's expressions stand: the dimension that each place wants, and the names that may stand there.

The fields of its entries say nearly all of it (:mod:`linkwright.expressions.typed_fields`). What is added here are
expressions that no field holds: those that an entry stands for.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import chain

from linkwright.elements.entries import NOUNS
from linkwright.expressions import units as u
from linkwright.expressions.dimensions import crossed
from linkwright.expressions.fields import FrozenDict
from linkwright.expressions.typed_fields import Context, Path, Scope
from linkwright.model.mechanism import Mechanism
from linkwright.model.motions import ARGUMENT
from linkwright.model.walk import ExpressionPlace, Found, QuantityPlace, walk

__all__ = [
    "OF_FORMULA",
    "ExpressionPlace",
    "Path",
    "Scope",
    "crossed",
    "find_typed_values",
    "places",
]

OF_FORMULA = FrozenDict({ARGUMENT: u.PURE})
"""What a motion law's formula names."""

SECTIONS = (
    "parameters", "plane", "gravity", "links", "joints", "cylinders", "assembly", "drives", "paths", "cams", *NOUNS,
    "tables", "laws", "windows", "stiffness",
)  # fmt: skip
"""The sections in the order in which their dimensions are inferred; measures follow, each with its bounds."""


def find_typed_values(m: Mechanism) -> list[Found]:
    """What the typed fields of a mechanism hold whose short forms are spelled out: one walk, for all that asks."""
    return walk(m, Context(m), *SECTIONS, "measures", "require")


def places(m: Mechanism, found: Iterable[Found]) -> Iterator[ExpressionPlace]:
    """Every expression of a mechanism, the definitions of its parameters first; ``found`` is from
    :func:`find_typed_values`."""
    by_entry: dict[str, dict[Path, list[ExpressionPlace]]] = {}
    for one in found:
        if isinstance(one, QuantityPlace):
            by_entry.setdefault(str(one.path[0]), {}).setdefault(one.path[1:2], []).extend(one.places())
    acting = [*m.acting()]
    for section in SECTIONS:
        own = by_entry.get(section, {})
        if section not in NOUNS:
            yield from chain.from_iterable(own.values())
        for element in acting:
            if element.section == section:
                yield from own.get((element.name,), ())
                uses = element.kind.implied_expressions(m, element.entry)
                yield from (
                    ExpressionPlace((*element.path, use.key), use.expression, use.wanted, use.scope) for use in uses
                )
    own, bounds = by_entry.get("measures", {}), by_entry.get("require", {})
    for name, measure in m.measures.items():
        yield from own.get((name,), ())
        uses = measure.implied_expressions(m, name)
        yield from (ExpressionPlace(("measures", name, use.key), use.expression, use.wanted, use.scope) for use in uses)
        yield from bounds.get((name,), ())
