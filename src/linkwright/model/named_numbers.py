"""A mechanism whose written numbers are parameters, so that a program of it takes them as inputs.

The numbers are named before short forms are expanded. A sketched place is then a parameter of which the lengths follow,
and so is the centre of mass of a cylinder's rod; once expanded, both are parts of arithmetic. The names stand in the
derived expressions, by which each moved number moves all that follows from it.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Container, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any

from linkwright.data_classes import dataclass
from linkwright.expressions.fields import Expression, Position
from linkwright.expressions.language import Name, nodes
from linkwright.expressions.typed_fields import Context, Path, Sign
from linkwright.expressions.units import Dimension
from linkwright.expressions.written import FrozenDict
from linkwright.findings import Finding, raise_errors
from linkwright.model.desugar import Spelled, spell_out
from linkwright.model.document import Document, plain
from linkwright.model.mechanism import FRAME, Mechanism, scopes
from linkwright.model.number_places import NumberPlace, data_at, literal, number_places, of_copies
from linkwright.model.parts import Parameter
from linkwright.model.quantities import Quantities
from linkwright.model.walk import ExpressionPlace, references, written_sites

CONSTANT = ("parameters", "assembly", "plane", "tables", "require")
"""The sections whose numbers stay: parameters have a name, and the limits of their tolerances follow them; an assembly
mode is a choice, of which sketched places are a hint; the plane of a sketch holds at the nominal values; points of a
table are its data, as those of a CSV file are; a requirement judges a result, of which it is no part."""

Uses = Callable[[Mechanism], Sequence[ExpressionPlace]]
"""Expressions outside a mechanism that tell the units of what it leaves open, found for one without short forms."""


@dataclass(frozen=True)
class WrittenNumber:
    """A number of a file that is a parameter now: its place in the file, its dimension, its ``value`` in SI and the
    sign that it must have."""

    path: Path
    dimension: Dimension
    value: float
    sign: Sign = Sign.ANY

    @property
    def is_parameter(self) -> bool:
        """Whether it is the value of a sub-assembly's parameter, which copies share."""
        return of_copies(self.path)


@dataclass(frozen=True)
class NamedNumbers:
    """A mechanism as it is ``written``, and the same with its numbers as parameters; these by their names, in the order
    of the file. ``spelled`` is the named one with its short forms expanded, ``quantities`` are those of that."""

    written: Mechanism
    spelled: Spelled
    numbers: Mapping[str, WrittenNumber]
    quantities: Quantities

    @property
    def mechanism(self) -> Mechanism:
        """The named one, its short forms as they are written."""
        return self.spelled.written

    def with_file_paths(self, findings: Iterable[Finding]) -> list[Finding]:
        """Findings on the named mechanism, with the places of its numbers in the file."""

        def path(of: Path) -> Path:
            known = self.numbers.get(str(of[1])) if len(of) > 1 and of[0] == "parameters" else None
            return of if known is None else known.path

        return [replace(finding, path=path(finding.path)) for finding in findings]


def named_numbers(m: Mechanism, uses: Uses | None = None, without: Container[str] = ()) -> NamedNumbers:
    """A sound mechanism with each of its plain numbers as a parameter of the same value and unit; those of the sections
    ``without`` stay.

    Their names (``n'12``) are ones that no file can give. The value of a sub-assembly's parameter is one for all copies
    that give it no other. These numbers stay: within arithmetic, of :data:`CONSTANT`
    sections, zeros that put the axes of a moving link where they are, numbers whose dimension depends on that of other
    places, such as the wrap of a measure (they tell these in turn, in an order that a parameter would change), and
    those on which nothing depends once short forms are expanded.

    Raises :class:`ModelError` where the dimensions of the mechanism aren't clear.
    """
    data = _data(m)
    gauges = _gauges(m)
    places = [p for p in number_places(m, data) if p.section not in without and _may_vary(p, gauges)]
    spelled, names = _spelled(_with_names(m, data, places)), _names(places)
    quantities = _quantities(spelled, uses)
    used = {part.text for place in quantities.places for part in nodes(place.expression.node) if isinstance(part, Name)}
    if not used.issuperset(names):
        places = [place for name, place in names.items() if name in used]
        spelled, names = _spelled(_with_names(m, data, places)), _names(places)
        quantities = _quantities(spelled, uses)
    numbers = {
        name: WrittenNumber(place.path, quantities.dimensions.of(name), quantities.parameters[name], place.sign)
        for name, place in names.items()
    }
    return NamedNumbers(m, spelled, FrozenDict(numbers), quantities)


def _data(m: Mechanism) -> dict[str, Any]:
    """A mechanism as plain data that can be changed, with what is given and happens to be the default."""
    as_written = plain(m) if isinstance(m, Document) else m.model_dump(exclude_defaults=True, by_alias=True)
    data: dict[str, Any] = json.loads(json.dumps(as_written))
    for at, part in scopes(m):
        for site in written_sites(part, Context(part)):
            entry, key, holder = site.context.entry, site.path[-1], data_at(data, (*at, *site.path[:-1]))
            given = {type(entry).model_fields[name].alias or name for name in entry.model_fields_set}
            if isinstance(holder, dict) and key not in holder and key in given and isinstance(site.written, Expression):
                holder[key] = site.written.raw
    return data


def _may_vary(place: NumberPlace, gauges: Container[Path]) -> bool:
    if of_copies(place.path):  # of the dimension that its uses tell
        return True
    gauge = place.path in gauges and _is_zero(place.expression)
    return place.section not in CONSTANT and isinstance(place.wanted, Dimension) and not gauge


def _names(places: Sequence[NumberPlace]) -> dict[str, NumberPlace]:
    """The places by names: with an apostrophe, which expressions read and names of a file can't have."""
    return {f"n'{i}": place for i, place in enumerate(places, start=1)}


def _with_names(m: Mechanism, data: Mapping[str, Any], places: Sequence[NumberPlace]) -> Mechanism:
    """The mechanism with names in place of these numbers."""
    changed: dict[str, Any] = json.loads(json.dumps(data))
    names = _names(places)
    for name, place in sorted(names.items(), key=lambda item: item[1].start, reverse=True):  # from the right
        holder, key = data_at(changed, place.data_path[:-1]), place.data_path[-1]
        text = str(holder[key])
        holder[key] = f"{text[: place.start]}{name}{text[place.end :]}"
    parameters = {name: Parameter(value=_alone(place.expression)) for name, place in names.items()}
    made = type(m).model_validate(changed)
    return made.model_copy(update={"parameters": FrozenDict({**made.parameters, **parameters})})


def _alone(expression: Expression) -> Expression:
    """An expression without the blanks around it."""
    return Expression(expression.raw.strip()) if isinstance(expression.raw, str) else expression


def _gauges(m: Mechanism) -> set[Path]:
    """The zeros of moving links that say where their axes lie: the origin, the height of the point that the x axis goes
    through; of a link without such a point, the direction of lines on it. With other values the link would be the same
    in other axes."""
    return {(*at, *path) for at, part in scopes(m) for path in _own_gauges(part)}


def _own_gauges(m: Mechanism) -> set[Path]:
    found: set[Path] = set()
    turned: set[str] = set()  # links whose x axis goes through no second point
    for name, link in m.links.items():
        stated = {point: at for point, at in link.points.items() if isinstance(at, Position)}
        flat = {point: at for point, at in stated.items() if not at.sketched and _is_zero(at.second)}
        origin = next((point for point, at in flat.items() if _is_zero(at.first)), None)
        if name == FRAME or origin is None:
            continue
        along = next((point for point in flat if point != origin), None)
        found |= {("links", name, "points", origin, part) for part in flat[origin].part_names()}
        if along is None:
            turned.add(name)
        else:
            found.add(("links", name, "points", along, flat[along].part_names()[1]))
    for line in references(m, Context(m)):
        if line.ref.kind == "point" and line.ref.link_at(line.context) in turned:
            found.add(line.context.path)
    return found


def _is_zero(expression: Expression) -> bool:
    number = literal(expression.node)
    return number is not None and number.value == 0


def _spelled(m: Mechanism) -> Spelled:
    spelled = spell_out(m)
    raise_errors(spelled.findings)
    return spelled


def _quantities(spelled: Spelled, uses: Uses | None) -> Quantities:
    quantities = Quantities(spelled.mechanism, () if uses is None else uses(spelled.mechanism), spelled.fields)
    raise_errors(quantities.findings)
    return quantities
