"""The arrows of a report's drawing: velocities, accelerations, reactions, loads, weights, each by its rows."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from linkwright.elements.cylinder import ends_of
from linkwright.escape import printed
from linkwright.expressions.units import ACCELERATION, FORCE, LENGTH, SPEED, Dimension
from linkwright.graph.force_rows import FORCE as FORCE_PARTS
from linkwright.graph.force_rows import PLACE, AppliedForce, ReactionPlace, Weight
from linkwright.graph.rows import Named
from linkwright.model.signals import Contact
from linkwright.report.data import ArrowData, ArrowKind
from linkwright.results import Result
from linkwright.structure import FRAME

Array = NDArray[np.float64]

LEAST = 1e-9
"""Arrows that never get longer than this, over the longest of their kind, are round-off."""


class Arrow(NamedTuple):
    """An arrow: its kind, what it belongs to, the rows of its vector and of its place; or a point of a link instead."""

    kind: ArrowKind
    name: str
    vector: tuple[Named, Named]
    place: tuple[Named, Named] | None
    at: tuple[str, str] | None = None


DIMENSIONS: dict[ArrowKind, Dimension] = {
    "velocity": SPEED,
    "acceleration": ACCELERATION,
    "reaction": FORCE,
    "load": FORCE,
    "weight": FORCE,
}


def arrows(result: Result) -> list[Arrow]:
    """All arrows of a motion that have a length."""
    every = [*chain(_rates(result), _reactions(result), _loads(result), _weights(result))]
    rows = [*dict.fromkeys(row for arrow in every for row in arrow.vector)]
    values = dict(zip(rows, result.run.compiled.evaluate(rows, result.t), strict=True)) if rows else {}
    lengths = [_largest(np.hypot(*(values[row] for row in arrow.vector))) for arrow in every]
    longest: dict[str, float] = {}
    for arrow, length in zip(every, lengths, strict=True):
        longest[arrow.kind] = max(longest.get(arrow.kind, 0.0), length)
    return [a for a, length in zip(every, lengths, strict=True) if length > LEAST * longest[a.kind]]


def arrow_rows(shown: Sequence[Arrow]) -> dict[Named, Dimension]:
    """The rows of arrows with their dimensions."""
    found: dict[Named, Dimension] = {}
    for arrow in shown:
        found |= dict.fromkeys(arrow.vector, DIMENSIONS[arrow.kind]) | dict.fromkeys(arrow.place or (), LENGTH)
    return found


def arrow_data(result: Result, shown: Sequence[Arrow]) -> list[ArrowData]:
    """Arrows for the drawing, by the labels of their rows."""
    graph, quantities = result.run.compiled.graph, result.run.compiled.quantities
    found: list[ArrowData] = []
    for arrow in shown:
        unit = printed(quantities.unit_of(DIMENSIONS[arrow.kind])[0])
        data: ArrowData = {
            "kind": arrow.kind,
            "name": arrow.name,
            "unit": unit,
            "rows": graph.labels(arrow.vector),
        }
        if arrow.place:
            data["places"] = graph.labels(arrow.place)
        if arrow.at:
            data["at"] = arrow.at
        found.append(data)
    return found


def _rates(result: Result) -> Iterator[Arrow]:
    compiled = result.run.compiled
    points, unnamed = compiled.quantities.signals.links_of_points, ends_of(compiled.mechanism.cylinders)
    kinds: tuple[tuple[ArrowKind, str], ...] = (("velocity", "v"), ("acceleration", "a"))
    for kind, letter in kinds:
        for point, link in points.items():
            if link != FRAME and point not in unnamed:
                yield Arrow(kind, point, (f"{point}.{letter}x", f"{point}.{letter}y"), None, (link, point))


def _reactions(result: Result) -> Iterator[Arrow]:
    compiled = result.run.compiled
    pins = compiled.structure.topology.pins
    for contact in compiled.quantities.signals.reactions:
        name = force_name(result, contact)
        vector: tuple[Named, Named] = (f"{name}.x", f"{name}.y")
        if (pin := pins.get(contact.joint)) is not None:
            yield Arrow("reaction", name, vector, None, (contact.link, pin.point(contact.link)))
        else:
            x, y = (ReactionPlace(contact.joint, contact.link, part) for part in FORCE_PARTS)
            yield Arrow("reaction", name, vector, (x, y))


def force_name(result: Result, contact: Contact) -> str:
    """The name of a reaction, without its attribute: with its joint where two links have several."""
    name = f"force({contact.link}, {contact.on})"
    return name if f"{name}.x" in result.names else f"force({contact.link}, {contact.on}, {contact.joint})"


def _loads(result: Result) -> Iterator[Arrow]:
    """What elements apply to links; what acts on the frame as well is drawn at the other link."""
    compiled = result.run.compiled
    for one in compiled.graph.actions.every:
        for index, link in enumerate(compiled.graph.acted_on(one)):
            if link == FRAME:
                continue
            fx, fy = (AppliedForce(*one.path, index, part) for part in FORCE_PARTS)
            x, y = (AppliedForce(*one.path, index, part) for part in PLACE)
            yield Arrow("load", one.name, (fx, fy), (x, y))


def _weights(result: Result) -> Iterator[Arrow]:
    mechanism = result.run.compiled.mechanism
    if mechanism.gravity is None:
        return
    for link in mechanism.links:
        if link != FRAME and mechanism.has_mass(link):
            place: tuple[Named, Named] = (f"com({link}).x", f"com({link}).y")
            yield Arrow("weight", link, (Weight(link, "x"), Weight(link, "y")), place)


def _largest(values: Array) -> float:
    return float(np.max(np.abs(values), initial=0.0, where=np.isfinite(values)))
