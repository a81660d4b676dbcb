"""Where a mechanism's expressions stand: the dimension that each place wants, and the names that may stand there.

The fields of its entries say nearly all of it (:mod:`linkwright.expressions.typed_fields`). What is added here are
expressions that no field holds: those that an entry stands for.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from itertools import chain

from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, FrozenDict, Position
from linkwright.expressions.typed_fields import Context, Path, Scope
from linkwright.expressions.units import Dimension
from linkwright.model.actions import FIGURES, Measure, crossed, figure, instant, measured
from linkwright.model.mechanism import Mechanism, Spring
from linkwright.model.motions import ARGUMENT
from linkwright.model.pins import homes
from linkwright.model.walk import Found, Place, Site, sites, walk

__all__ = [
    "FIGURES",
    "OF_FORMULA",
    "Path",
    "Place",
    "Scope",
    "crossed",
    "figure",
    "measured",
    "places",
    "position_parts",
    "spring_dimensions",
    "stated",
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


def spring_dimensions(spring: Spring) -> dict[str, Dimension]:
    """The dimensions of a spring's numbers by key."""
    alone = Context(Mechanism.model_construct(links=FrozenDict()), ("springs", ""))
    found = ((str(site.path[-1]), place.wanted) for site in sites(spring, alone) for place in site.places())
    return {key: wanted for key, wanted in found if isinstance(wanted, Dimension)}


def stated(m: Mechanism) -> list[Found]:
    """What the typed fields of a mechanism hold whose short forms are spelled out: one walk, for all that asks."""
    return walk(m, Context(m), *SECTIONS, "measures", "require")


def places(m: Mechanism, found: Iterable[Found]) -> Iterator[Place]:
    """Every expression of a mechanism, the definitions of its parameters first; ``found`` is what is :func:`stated`."""
    by_entry: dict[str, dict[Path, list[Place]]] = {}
    for one in found:
        if isinstance(one, Site):
            by_entry.setdefault(str(one.path[0]), {}).setdefault(one.path[1:2], []).extend(one.places())
    for section in SECTIONS:
        own = by_entry.get(section, {})
        if section not in _BESIDES:
            yield from chain.from_iterable(own.values())
            continue
        for name in getattr(m, section):
            yield from own.get((name,), ())
            yield from _BESIDES[section](m, name)
    own, bounds = by_entry.get("measures", {}), by_entry.get("require", {})
    for name, measure in m.measures.items():
        yield from _path(m, name, measure)
        yield from own.get((name,), ())
        if (when := measure.instant) and when.expression:
            yield Place(("measures", name, "where"), Expression(when.expression), instant(name), Scope.SIGNALS)
        yield from bounds.get((name,), ())


def _window(m: Mechanism, name: str) -> Iterator[Place]:
    """The signal that bounds the window of a load, of which the load is then a function."""
    load = m.loads[name]
    window = m.windows.get(load.window) if load.window else None
    for signal in window if isinstance(window, dict) else ():
        yield Place(("loads", name, "window"), Expression(signal), crossed(str(load.window)), Scope.LOAD)


def _table(m: Mechanism, name: str) -> Iterator[Place]:
    """The table of a spring as if it were called, which tells the units of its columns."""
    spring = m.springs[name]
    if spring.table:
        key, one, value = ("torque", "1 rad", u.TORQUE) if spring.torsional else ("force", "1 m", u.FORCE)
        yield Place(("springs", name, key), Expression(f"{spring.table}({one})"), value, Scope.TIME)


_BESIDES: dict[str, Callable[[Mechanism, str], Iterator[Place]]] = {"loads": _window, "springs": _table}
"""Expressions of an entry of a section that no field holds."""


def _path(m: Mechanism, name: str, measure: Measure) -> Iterator[Place]:
    """What is reduced where a measure names a point."""
    if measure.point is not None and measure.point in homes(m):
        wanted = u.SPEED if measure.path else u.LENGTH
        yield Place(("measures", name, measure.reduction), measure.signal, wanted, Scope.SIGNALS)
