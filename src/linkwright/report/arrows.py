"""The arrows of a report's drawing: rates, reactions, loads, weights and moments, each by its rows."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from linkwright.elements.cylinder import ends_of
from linkwright.escape import printed
from linkwright.expressions.units import ACCELERATION, FORCE, LENGTH, SPEED, TORQUE, Dimension
from linkwright.graph.force_rows import FORCE as FORCE_PARTS
from linkwright.graph.force_rows import MOMENT, PLACE, AppliedForce, DriveForce, ReactionPlace, Weight
from linkwright.graph.rows import Named
from linkwright.model.pins import Pin
from linkwright.model.signals import Contact
from linkwright.report.data import ArrowData, ArrowKind
from linkwright.results import Result
from linkwright.structure import FRAME
from linkwright.structure.topology import Topology

Array = NDArray[np.float64]

LEAST = 1e-9
"""Arrows that never get longer than this, over the longest of their kind, are round-off."""


class Arrow(NamedTuple):
    """An arrow: its kind, what it belongs to, the rows of its vector and of its place; or a point of a link instead.

    A moment has one row in place of a vector: counter-clockwise positive, on the link that its name tells.
    """

    kind: ArrowKind
    name: str
    vector: tuple[Named, ...]
    place: tuple[Named, Named] | None
    at: tuple[str, str] | None = None


DIMENSIONS: dict[ArrowKind, Dimension] = {
    "velocity": SPEED,
    "acceleration": ACCELERATION,
    "reaction": FORCE,
    "load": FORCE,
    "weight": FORCE,
    "moment": TORQUE,
}


def arrows(result: Result) -> list[Arrow]:
    """All arrows of a motion that have a length."""
    forces = (_reactions, _loads, _drive_forces, _weights, _moments)
    every = [*chain(_rates(result), *(of(result) for of in forces))]
    rows = [*dict.fromkeys(row for arrow in every for row in arrow.vector)]
    values = dict(zip(rows, result.run.compiled.evaluate(rows, result.t), strict=True)) if rows else {}
    lengths = [_largest(np.linalg.norm([values[row] for row in arrow.vector], axis=0)) for arrow in every]
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


def _drive_forces(result: Result) -> Iterator[Arrow]:
    """What drives exert on the points that they move."""
    compiled = result.run.compiled
    for name in compiled.graph.motors:
        drive = compiled.mechanism.drives[name]
        if drive.moves and drive.at:
            x, y = (DriveForce(name, part) for part in FORCE_PARTS)
            yield Arrow("load", name, (x, y), None, (drive.link, drive.at))


def _weights(result: Result) -> Iterator[Arrow]:
    mechanism = result.run.compiled.mechanism
    if mechanism.gravity is None:
        return
    for link in mechanism.links:
        if link != FRAME and mechanism.has_mass(link):
            place: tuple[Named, Named] = (f"com({link}).x", f"com({link}).y")
            yield Arrow("weight", link, (Weight(link, "x"), Weight(link, "y")), place)


def _moments(result: Result) -> Iterator[Arrow]:
    """Drive torques at the drives' pins, moments of reactions, what elements apply besides forces."""
    yield from _torques(result)
    for contact in result.run.compiled.quantities.signals.reactions:
        moment = f"{force_name(result, contact)}.moment"
        if moment in result.names:
            x, y = (ReactionPlace(contact.joint, contact.link, part) for part in FORCE_PARTS)
            yield Arrow("moment", moment, (moment,), (x, y))
    yield from _couples(result)


def _torques(result: Result) -> Iterator[Arrow]:
    """What drives exert on the links that they turn."""
    compiled = result.run.compiled
    topology = compiled.structure.topology
    for name in compiled.graph.motors:
        drive = compiled.mechanism.drives[name]
        if not drive.turns:
            continue
        # Without a pin of both links it is drawn at a pin of the link that it turns.
        joints = topology.acting(name) or topology.connections_of(drive.link)
        if pins := [topology.pins[one.joint] for one in joints if one.joint in topology.pins]:
            torque = f"{name}.{drive.effort}"
            yield Arrow("moment", torque, (torque,), None, (drive.link, pins[0].point(drive.link)))


def _couples(result: Result) -> Iterator[Arrow]:
    """Moments that elements apply to moving links.

    Without a force a moment is the same about every place: that on one link is drawn about its pin on the frame, two
    opposite ones between links that share a pin as one about this pin, on the first of these links that moves.
    """
    compiled = result.run.compiled
    for one in compiled.graph.actions.every:
        links = compiled.graph.acted_on(one)
        moving = [(index, link) for index, link in enumerate(links) if link != FRAME]
        pin = _pin_between(compiled.structure.topology, links) if compiled.graph.acts_by_couples(one) else None
        for index, link in moving[:1] if pin else moving:
            moment = AppliedForce(*one.path, index, MOMENT)
            x, y = (AppliedForce(*one.path, index, part) for part in PLACE)
            place, at = (None, (link, pin.point(link))) if pin else ((x, y), None)
            yield Arrow("moment", one.name, (moment,), place, at)


def _pin_between(topology: Topology, links: Sequence[str]) -> Pin | None:
    """The pin of two links, or of one on the frame, if there is one."""
    joined = {*links, FRAME} if len(links) == 1 else {*links}
    return next((pin for pin in topology.pins.values() if len(links) <= 2 and joined <= {*pin.links}), None)


def _largest(values: Array) -> float:
    return float(np.max(np.abs(values), initial=0.0, where=np.isfinite(values)))
