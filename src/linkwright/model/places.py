"""Where a mechanism's expressions stand: the dimension that each place wants, and the names that may stand there.

The fields of its entries say nearly all of it (:mod:`linkwright.expressions.typed_fields`). What is added here are
expressions that no field holds: those that an entry stands for.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from linkwright.elements.force import NOUNS
from linkwright.elements.load import crossed
from linkwright.elements.points import homes
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, FrozenDict, Position
from linkwright.expressions.typed_fields import Context, Path, Scope
from linkwright.expressions.units import Dimension
from linkwright.model.actions import FIGURES, Measure, figure, instant, measured
from linkwright.model.mechanism import Mechanism
from linkwright.model.motions import ARGUMENT
from linkwright.model.walk import Place, Site, sites

__all__ = [
    "FIGURES",
    "OF_FORMULA",
    "Path",
    "Place",
    "Scope",
    "crossed",
    "figure",
    "measured",
    "mechanism_sites",
    "places",
    "position_parts",
]

OF_FORMULA = FrozenDict({ARGUMENT: u.PURE})
"""What a motion law's formula names."""

SECTIONS = (
    "parameters", "plane", "gravity", "links", "joints", "cylinders", "assembly", "drives", "cams", "loads", "springs",
    "counterweights", "tables", "laws", "windows",
)  # fmt: skip
"""The sections in the order in which their dimensions are inferred; measures follow, each with its bounds."""


def position_parts(position: Position) -> tuple[tuple[Expression, Dimension], tuple[Expression, Dimension]]:
    """The two expressions of a position with their dimensions."""
    return (position.first, u.LENGTH), (position.second, u.ANGLE if position.polar else u.LENGTH)


def mechanism_sites(m: Mechanism) -> Iterator[Site]:
    """Every quantity that the fields of a mechanism hold, whose short forms are spelled out."""
    return sites(m, Context(m), *SECTIONS, "measures", "require")


def places(m: Mechanism) -> Iterator[Place]:
    """Every expression of a mechanism, the definitions of its parameters first."""
    acting = [*m.acting()]
    for section in SECTIONS:
        if section not in NOUNS:
            yield from _places(sites(m, Context(m), section))
        for one in acting:
            if one.section == section:
                yield from _places(sites(one.entry, Context(m, one.path)))
                uses = one.kind.uses(m, one.entry)
                yield from (Place((*one.path, use.key), use.expression, use.wanted, use.scope) for use in uses)
    bounds: dict[str, list[Site]] = {}
    for site in sites(m, Context(m), "require"):
        bounds.setdefault(site.context.name, []).append(site)
    for name, measure in m.measures.items():
        yield from _path(m, name, measure)
        yield from _places(sites(measure, Context(m, ("measures", name))))
        if (when := measure.instant) and when.expression:
            yield Place(("measures", name, "where"), Expression(when.expression), instant(name), Scope.SIGNALS)
        yield from _places(bounds.get(name, ()))


def _places(found: Iterable[Site]) -> Iterator[Place]:
    return (place for site in found for place in site.places())


def _path(m: Mechanism, name: str, measure: Measure) -> Iterator[Place]:
    """What is reduced where a measure names a point."""
    if measure.point is not None and measure.point in homes(m):
        wanted = u.SPEED if measure.path else u.LENGTH
        yield Place(("measures", name, measure.reduction), measure.signal, wanted, Scope.SIGNALS)
