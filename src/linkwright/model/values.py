"""Whether a mechanism's numbers make sense: finite, masses not negative, intervals that hold something."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from linkwright.findings import Finding, Term
from linkwright.model import units as u
from linkwright.model.dimensions import DimensionError
from linkwright.model.fields import Expression
from linkwright.model.places import Place, Scope, crossed, figure, position_parts, spring_dimensions
from linkwright.model.quantities import LARGEST, Quantities
from linkwright.model.slides import closing, pairs_of
from linkwright.model.units import Dimension

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
    return [*bad, *(finding for part in (_bodies, _rods, _slides, _intervals) for finding in part(quantities))]


def _finite(q: Quantities, place: Place) -> Iterator[Finding]:
    try:
        value = q.value(place.expression, q.dimensions.resolve(place.wanted))
    except DimensionError:
        return
    if q.bad(np.logical_not(np.abs(value) < LARGEST)):
        yield Finding("value.not-finite", place.path, {"text": place.expression.text[:60]})


def _bodies(q: Quantities) -> Iterator[Finding]:
    def least(path: tuple[Any, ...], term: str, of: Expression, dimension: Dimension, over: bool) -> Iterator[Finding]:
        value, (unit, size) = q.value(of, dimension), q.unit_of(dimension)
        if q.bad(wrong := np.less_equal(value, 0) if over else np.less(value, 0)):
            data = {"what": Term(term), "value": f"{np.extract(wrong, value)[0] / size:.6g}", "unit": unit}
            yield Finding("value.too-small", path, data)

    for name, link in q.mechanism.links.items():
        if link.mass is not None:
            yield from least(("links", name, "mass"), "mass", link.mass, u.MASS, False)
        if link.inertia is not None:
            yield from least(("links", name, "inertia"), "inertia", link.inertia, u.INERTIA, False)
        if link.shape and link.shape.radius:
            yield from least(("links", name, "shape"), "radius", link.shape.radius, u.LENGTH, True)
    for name, weight in q.mechanism.counterweights.items():
        yield from least(("counterweights", name, "mass"), "mass", weight.mass, u.MASS, True)
        if weight.inertia is not None:
            yield from least(("counterweights", name, "inertia"), "inertia", weight.inertia, u.INERTIA, False)
    for name, spring in q.mechanism.springs.items():
        for key, dimension in spring_dimensions(spring).items():
            given = getattr(spring, key)
            if isinstance(given, Expression) and key != "preload" and not (key == "free" and spring.torsional):
                over = key in ("gas", "exponent")
                yield from least(("springs", name, key), "number", given, dimension, over)
        progression = spring.progression if spring.gas is not None else None
        if progression is not None and q.bad(np.less_equal(q.value(progression, u.PURE), 1)):
            yield Finding("spring.progression", ("springs", name, "progression"), {})
    for section in ("springs", "cylinders"):
        for name, part in getattr(q.mechanism, section).items():
            if part.length:
                yield from least((section, name, "length"), "length", part.length[0], u.LENGTH, False)
    for name, table in q.mechanism.tables.items():
        if table.period is not None:
            yield from least(("tables", name, "period"), "period", table.period, u.PURE, True)
    for name, cam in q.mechanism.cams.items():
        for path, contact in cam.contacts(("cams", name)):
            for key in ("base", "roller"):
                if (radius := getattr(contact, key)) is not None:
                    yield from least((*path, key), "radius", radius, u.LENGTH, True)
    for name, measure in q.mechanism.measures.items():
        if measure.within is not None:
            dimension = q.dimensions.dimension(measure.signal.node)
            yield from least(("measures", name, "within"), "within", measure.within, dimension, True)


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
            data = {"joint": name, "loop": ", ".join(loop), "angle": angle, "unit": unit}
            yield Finding("joint.slides-tilted", ("joints", name), data)


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


def _intervals(q: Quantities) -> Iterator[Finding]:
    m, resolve = q.mechanism, q.dimensions.resolve
    for name, spring in m.springs.items():
        if spring.length:
            yield from _rising(q, ("springs", name, "length"), spring.length, u.LENGTH)
    for name, window in m.windows.items():
        if isinstance(window, tuple):
            yield from _rising(q, ("windows", name), window, u.TIME)
        else:
            for signal, edges in window.items():
                yield from _rising(q, ("windows", name, signal), edges, resolve(crossed(name)))
    for name, joint in m.joints.items():
        if joint.travel:
            yield from _rising(q, ("joints", name, "travel"), joint.travel, u.LENGTH)
    for name, cylinder in m.cylinders.items():
        if cylinder.length:
            yield from _rising(q, ("cylinders", name, "length"), cylinder.length, u.LENGTH)
    for name, measure in m.measures.items():
        dimension = resolve(figure(name, measure))
        if measure.wrap:
            yield from _rising(q, ("measures", name, "wrap"), measure.wrap, dimension)
        if name in m.require and len(m.require[name].bounds) == 2:
            low, high = m.require[name].bounds
            yield from _rising(q, ("require", name), (low, high), dimension, equal=True)


def _rising(
    q: Quantities,
    path: tuple[Any, ...],
    edges: tuple[Expression, Expression],
    dimension: Dimension,
    equal: bool = False,
) -> Iterator[Finding]:
    low, high = (q.value(edge, dimension) for edge in edges)
    if q.bad(np.logical_not(low <= high if equal else low < high)):
        data = {"low": edges[0].text[:40], "high": edges[1].text[:40]}
        yield Finding("value.not-rising", path, data)
