"""Conditions on a mechanism's numbers: what must be finite, positive or not negative, and what is wrong otherwise.

A condition is stated once, over whatever gives the numbers: those of one mechanism, arrays of many samples, or symbols,
of which a page makes the same conditions.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from functools import partial
from itertools import chain
from typing import Any

import numpy as np

from linkwright.data_classes import dataclass
from linkwright.elements.distances import ByDistances, placed
from linkwright.elements.entries import NumberFault, UnknownPlaceError
from linkwright.expressions.dimensions import DimensionError
from linkwright.expressions.fields import Expression
from linkwright.expressions.language import Name
from linkwright.expressions.typed_fields import Ends, Sign
from linkwright.expressions.units import LENGTH, Dimension
from linkwright.findings import Finding, Joined, Term
from linkwright.model.places import ExpressionPlace, Scope
from linkwright.model.quantities import LARGEST, Quantities
from linkwright.model.walk import QuantityPlace
from linkwright.notation import Pair

CONSTANT = (Scope.CONSTANT, Scope.LOAD)
"""Where constants stand; a load may vary, and is then looked at while it moves."""

Values = Callable[[Expression, Dimension], Any]
"""Gives the values of expressions (SI): numbers, arrays of samples, or symbols."""


class Figure(str):
    """A number of a sentence that has no digits yet, since it is an array of samples or a symbol: its value (SI), and
    the unit in which it is told with the SI value of that. As text it is a mark."""

    value: Any
    unit: str
    size: float

    def __new__(cls, value: Any, unit: str, size: float) -> Figure:
        made = super().__new__(cls, "…")
        made.value, made.unit, made.size = value, unit, size
        return made


def _figures(part: Any) -> Iterator[Figure]:
    """The figures of a finding's data, in their order."""
    if isinstance(part, Figure):
        yield part
    elif isinstance(part, Joined):
        yield from chain.from_iterable(map(_figures, part.parts))


def _with_texts(part: Any, texts: Iterator[str]) -> Any:
    """The same with texts in place of the figures."""
    if isinstance(part, Figure):
        return next(texts)
    if isinstance(part, Joined):
        return Joined([_with_texts(one, texts) for one in part.parts], part.data["between"])
    return part


@dataclass(frozen=True)
class Condition:
    """That ``margin`` (SI) has a ``sign``: POSITIVE, NOT_NEGATIVE, or with ANY only a value below :data:`LARGEST`.

    ``finding`` is what is wrong otherwise. Where that states the margin as ``value``, ``size`` is the SI value of the
    unit.
    """

    margin: Any
    sign: Sign
    finding: Finding
    size: float | None = None

    @property
    def broken(self) -> Any:
        """Whether it doesn't hold, or in which samples."""
        if self.sign is Sign.POSITIVE:
            return np.less_equal(self.margin, 0)
        if self.sign is Sign.NOT_NEGATIVE:
            return np.less(self.margin, 0)
        return np.logical_not(np.abs(self.margin) < LARGEST)

    @property
    def figures(self) -> list[Figure]:
        """The other numbers that its sentence has no digits of."""
        return [figure for part in self.finding.data.values() for figure in _figures(part)]

    def fault(self, value: str, texts: Iterable[str] = ()) -> Finding:
        """What is wrong, where it states the margin with this text of it, and its figures with these."""
        own, rest = self.finding, iter(texts)
        data = {key: _with_texts(part, rest) for key, part in own.data.items()} if texts else own.data
        return Finding(own.code, own.path, data if self.size is None else {**data, "value": value})


def finite(q: Quantities, values: Values, names: bool = True) -> Iterator[Condition]:
    """That all constants have a value; without ``names`` those that are more than the name of a parameter."""
    for place in q.places:
        composed = names or not isinstance(place.expression.node, Name)
        if place.scope in CONSTANT and composed and (condition := _finite(q, values, place)) is not None:
            yield condition


def conditions(q: Quantities, values: Values, nominal: bool = False) -> Iterator[Condition]:
    """All further ones, of numbers that are finite. Of those with the same code and path the first counts that is
    broken. ``nominal`` numbers don't vary about others."""
    stated = [site for site in q.fields if isinstance(site, QuantityPlace)]
    signs = (one for site in stated for one in signed(q, values, site))
    intervals = (one for site in stated for one in _interval(q, values, site))
    return chain(signs, _triangles(q, values), _elements(q, values, nominal), _rods(q, values), intervals)


def _finite(q: Quantities, values: Values, place: ExpressionPlace) -> Condition | None:
    try:
        value = values(place.expression, q.dimensions.resolve(place.wanted))
    except DimensionError:
        return None
    return Condition(value, Sign.ANY, Finding("value.not-finite", place.path, {"text": place.expression.text[:60]}))


def signed(q: Quantities, values: Values, site: QuantityPlace) -> Iterator[Condition]:
    """That a quantity is as large as it must be; of an interval, its lower end."""
    (expression, of), sign = site.parts[0], site.parts[0][1].sign_at(site.context)
    if sign is Sign.ANY or (wanted := of.dimension_at(site.context)) is None:
        return
    dimension = q.dimensions.resolve(wanted)
    unit, size = q.unit_of(dimension)
    finding = Finding("value.too-small", site.path, {"what": Term(of.term), "value": "", "unit": unit})
    yield Condition(values(expression, dimension), sign, finding, size)


def _interval(q: Quantities, values: Values, site: QuantityPlace) -> Iterator[Condition]:
    """That an interval's ends lie the right way round, or leave something between them."""
    ends = site.parts[0][1].ends
    if ends is Ends.ANY or len(site.parts) != 2:
        return
    found = [values(place.expression, q.dimensions.resolve(place.wanted)) for place in site.places()]
    if len(found) == 2:
        low, high = found
        texts = (expression.text[:40] for expression, _ in site.parts)
        finding = Finding("value.not-rising", site.path, dict(zip(("low", "high"), texts, strict=True)))
        yield Condition(high - low, Sign.NOT_NEGATIVE if ends is Ends.ORDERED else Sign.POSITIVE, finding)


@dataclass(frozen=True)
class _Places:
    """The numbers of a mechanism and the places of its points, from whatever gives the values."""

    q: Quantities
    values: Values

    @property
    def mechanism(self) -> Any:
        return self.q.mechanism

    def number(self, expression: Expression, dimension: Dimension) -> Any:
        return self.values(expression, dimension)

    def point(self, link: str, name: str) -> Pair:
        entry = self.q.mechanism.links.get(link)
        if entry is None or not placed(entry.points, name):
            raise UnknownPlaceError(link, name)
        found: Pair = entry.place(self.values, name)
        return found

    def text_of(self, value: Any, dimension: Dimension) -> str:
        unit, size = self.q.unit_of(dimension)
        return _number(value, unit, size)


def _elements(q: Quantities, values: Values, nominal: bool) -> Iterator[Condition]:
    """What elements say of their numbers together."""
    m, places = q.mechanism, _Places(q, values)
    stated: list[tuple[tuple[str | int, ...], Iterator[NumberFault]]] = [
        *((one.path, one.entry.number_faults(values)) for one in m.acting()),
        *((("paths", name), path.number_faults(values)) for name, path in m.paths.items()),
        *((("joints", name), joint.number_faults(values)) for name, joint in m.joints.items()),
        *((("joints", name), _where_placed(joint.place_faults(places, nominal))) for name, joint in m.joints.items()),
    ]
    for element, faults in stated:
        for margin, sign, (code, data, *path) in faults:
            yield Condition(margin, sign, Finding(code, (*element, *path), data))


def _where_placed(faults: Iterator[NumberFault]) -> Iterator[NumberFault]:
    """The faults of an element up to the first place that no link has, whatever other element names it."""
    with suppress(UnknownPlaceError):
        yield from faults


def _rods(q: Quantities, values: Values) -> Iterator[Condition]:
    """That the ends of a rod are two places."""
    for name, link in q.mechanism.links.items():
        if link.shape and link.shape.form == "rod" and all(point in link.points for point in link.shape.points):
            if not all(placed(link.points, point) for point in link.shape.points):
                continue
            start, end = (link.place(values, point) for point in link.shape.points)
            apart = abs(end.x - start.x) + abs(end.y - start.y)
            points = "-".join(link.shape.points)
            yield Condition(apart, Sign.POSITIVE, Finding("value.rod", ("links", name, "shape"), {"points": points}))


def _triangles(q: Quantities, values: Values) -> Iterator[Condition]:
    """That there are triangles with the sides by which points of links are stated."""
    unit, size = q.unit_of(LENGTH)
    for name, link in q.mechanism.links.items():
        for point, at in link.points.items():
            if not isinstance(at, ByDistances) or not placed(link.points, point):
                continue
            path, (first, second) = ("links", name, "points", point), at.side.points
            sides, slacks = at.triangle(values, partial(link.place, values))
            ends = ((point, first), (point, second), (first, second))
            stated = zip(ends, sides, strict=True)
            shown = Joined(Joined([f"{p}-{q} =", _number(side, unit, size)], " ") for (p, q), side in stated)
            data = {"point": point, "link": name, "sides": shown, "unit": unit, "value": ""}
            for slack in slacks:
                yield Condition(slack, Sign.POSITIVE, Finding("triangle.impossible", path, data), size)


def _number(value: Any, unit: str, size: float) -> str:
    """A number (SI) as text, where it is one."""
    return f"{value / size:.6g} {unit}" if isinstance(value, int | float) else Figure(value, unit, size)


def varying_conditions(q: Quantities, values: Values, varies: Callable[[Any], bool]) -> list[Condition]:
    """All conditions of which the margin ``varies``, in the order in which they are checked; that a parameter has a
    value isn't stated again where it stands alone."""
    return [one for one in chain(finite(q, values, False), conditions(q, values)) if varies(one.margin)]
