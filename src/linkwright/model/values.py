"""Whether a mechanism's numbers make sense: finite, masses not negative, intervals that hold something."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np

from linkwright.expressions import units as u
from linkwright.findings import Finding, Joined
from linkwright.model.conditions import Condition, conditions, finite
from linkwright.model.quantities import Quantities
from linkwright.model.slides import closing, pairs_of

PARALLEL = 1e-9
"""Directions that differ by less than this angle (rad) are the same."""


def check_values(quantities: Quantities) -> list[Finding]:
    """Faults of numbers. The quantities are free of findings; of those of many samples, each sample is looked at."""
    bad = [*broken(quantities, finite(quantities, quantities.value))]
    if bad and quantities.samples is None:
        return bad
    stated = conditions(quantities, quantities.value, nominal=quantities.samples is None)
    return [*bad, *broken(quantities, stated), *_slides(quantities)]


def broken(q: Quantities, stated: Iterable[Condition]) -> Iterator[Finding]:
    """What is wrong with the numbers: of each code and path once, the first."""
    said: set[tuple[object, ...]] = set()
    for condition in stated:
        wrong = condition.broken
        if q.bad(wrong) and (key := (condition.finding.code, condition.finding.path)) not in said:
            said.add(key)
            size = condition.size
            texts = [f"{_first(wrong, one.value) / one.size:.6g} {one.unit}" for one in condition.figures]
            yield condition.fault("" if size is None else f"{_first(wrong, condition.margin) / size:.6g}", texts)


def _first(wrong: Any, value: Any) -> float:
    """A value, of many samples that of the first one of which something is wrong."""
    return float(np.extract(wrong, np.broadcast_to(value, np.shape(wrong)))[0])


def _slides(q: Quantities) -> Iterator[Finding]:
    unit, size = q.unit_of(u.ANGLE)
    for name, loop, miss in tilts(q):
        if q.bad(wrong := np.abs(miss) > PARALLEL):
            angle = f"{abs(np.extract(wrong, miss)[0]) / size:.6g}"
            data = {"joint": name, "loop": Joined(loop), "angle": angle, "unit": unit}
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
