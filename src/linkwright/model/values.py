"""Whether a mechanism's numbers make sense: finite, masses not negative, intervals that hold something."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from linkwright.expressions import units as u
from linkwright.expressions.dimensions import DimensionError
from linkwright.expressions.typed_fields import Ends, Sign
from linkwright.findings import Finding, Joined, Term
from linkwright.model.places import ExpressionPlace, Scope, position_parts
from linkwright.model.quantities import LARGEST, Quantities
from linkwright.model.slides import closing, pairs_of
from linkwright.model.walk import QuantityPlace

PARALLEL = 1e-9
"""Directions that differ by less than this angle (rad) are the same."""
CONSTANT = (Scope.CONSTANT, Scope.LOAD)
"""Where constants stand; a load may vary, and is then looked at while it moves."""


def check_values(quantities: Quantities) -> list[Finding]:
    """Faults of numbers. The quantities are free of findings; of those of many samples, each sample is looked at."""
    constant = [place for place in quantities.places if place.scope in CONSTANT]
    bad = [finding for place in constant for finding in _finite(quantities, place)]
    if bad and quantities.samples is None:
        return bad
    stated = [found for found in quantities.fields if isinstance(found, QuantityPlace)]
    signs = (finding for site in stated for finding in sign_faults(quantities, site))
    special = (finding for part in (_acting, _rods, _slides, _joints) for finding in part(quantities))
    return [*bad, *signs, *special, *(finding for site in stated for finding in _interval_faults(quantities, site))]


def _finite(q: Quantities, place: ExpressionPlace) -> Iterator[Finding]:
    try:
        value = q.value(place.expression, q.dimensions.resolve(place.wanted))
    except DimensionError:
        return
    if q.bad(np.logical_not(np.abs(value) < LARGEST)):
        yield Finding("value.not-finite", place.path, {"text": place.expression.text[:60]})


def sign_faults(q: Quantities, site: QuantityPlace) -> Iterator[Finding]:
    """That a quantity is too small; of an interval, its lower end."""
    (expression, of), sign = site.parts[0], site.parts[0][1].sign_at(site.context)
    if sign is Sign.ANY or (wanted := of.dimension_at(site.context)) is None:
        return
    dimension = q.dimensions.resolve(wanted)
    value = q.value(expression, dimension)
    if q.bad(wrong := np.less_equal(value, 0) if sign is Sign.POSITIVE else np.less(value, 0)):
        unit, size = q.unit_of(dimension)
        data = {"what": Term(of.term), "value": f"{np.extract(wrong, value)[0] / size:.6g}", "unit": unit}
        yield Finding("value.too-small", site.path, data)


def _interval_faults(q: Quantities, site: QuantityPlace) -> Iterator[Finding]:
    """That an interval's ends lie the wrong way round, or leave nothing between them."""
    ends = site.parts[0][1].ends
    if ends is Ends.ANY or len(site.parts) != 2:
        return
    values = [q.value(place.expression, q.dimensions.resolve(place.wanted)) for place in site.places()]
    if len(values) < 2:
        return
    low, high = values
    if q.bad(np.logical_not(low <= high if ends is Ends.ORDERED else low < high)):
        texts = (expression.text[:40] for expression, _ in site.parts)
        yield Finding("value.not-rising", site.path, dict(zip(("low", "high"), texts, strict=True)))


def _acting(q: Quantities) -> Iterator[Finding]:
    for one in q.mechanism.acting():
        for wrong, (code, data, *path) in one.entry.number_faults(q.value):
            if q.bad(wrong):
                yield Finding(code, (*one.path, *path), data)


def _rods(q: Quantities) -> Iterator[Finding]:
    for name, link in q.mechanism.links.items():
        if link.shape and link.shape.form == "rod" and all(point in link.points for point in link.shape.points):
            ends = [
                [q.value(expression, dimension) for expression, dimension in position_parts(link.points[point])]
                for point in link.shape.points
            ]
            alike = len({link.points[point].polar for point in link.shape.points}) == 1
            if alike and q.bad(np.logical_and(*map(np.equal, *ends))):
                points = "-".join(link.shape.points)
                yield Finding("value.rod", ("links", name, "shape"), {"points": points})


def _slides(q: Quantities) -> Iterator[Finding]:
    unit, size = q.unit_of(u.ANGLE)
    for name, loop, miss in tilts(q):
        if q.bad(wrong := np.abs(miss) > PARALLEL):
            angle = f"{abs(np.extract(wrong, miss)[0]) / size:.6g}"
            data = {"joint": name, "loop": Joined(loop), "angle": angle, "unit": unit}
            yield Finding("joint.slides-tilted", ("joints", name), data)


def _joints(q: Quantities) -> Iterator[Finding]:
    for name, joint in q.mechanism.joints_but_pins():
        for code, data, *path in joint.number_faults(q.value):
            yield Finding(code, ("joints", name, *path), data)


def tilts(q: Quantities) -> Iterator[tuple[str, list[str], Any]]:
    """By how much (rad, -pi to pi, of each sample) a slide that closes a loop of slides misses the direction that the
    others give it, where that isn't 0: its name, those of all slides joined to it, the angle."""
    parts: dict[str, dict[str, Any]] = {}  # by link the directions of all links that slides join to it
    pairs = pairs_of(q.mechanism)
    for name in pairs if closing(pairs.items()) else ():
        joint = q.mechanism.joints[name]
        assert joint.line is not None
        (a, b), (here, there) = joint.links, (q.value(line.angle, u.ANGLE) for line in joint.line)
        first, second = (parts.setdefault(link, {link: 0.0}) for link in (a, b))
        turn = first[a] + here - second[b] - there
        if first is not second:
            first |= {link: angle + turn for link, angle in second.items()}
            parts |= dict.fromkeys(second, first)
        elif np.any(np.abs(miss := np.arctan2(np.sin(turn), np.cos(turn))) > PARALLEL):
            yield name, [other for other, pair in pairs.items() if pair <= first.keys()], miss
