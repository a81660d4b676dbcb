"""The order of derivatives that each signal needs, by the kind of element it belongs to."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from linkwright.elements.entries import NOUNS
from linkwright.model.signals import POWER, Signal

if TYPE_CHECKING:
    from linkwright.graph.graph import Graph

LETTERS = {"": 0, "v": 1, "a": 2, "j": 3}
LINK_ORDERS = {"angle": 0, "omega": 1, "alpha": 2, "jerk": 3}
SLIDE_ORDERS = {"s": 0, "v": 1, "a": 2, "j": 3}
DRIVE_ORDERS = {**LINK_ORDERS, **SLIDE_ORDERS}


def _of_forces(graph: Graph, signal: Signal) -> int:
    return graph.actions.forces


def _of_drive(graph: Graph, signal: Signal) -> int:
    follower = graph.actions.followers.get(signal.owners[0])
    if follower is not None and signal.attribute in follower.extra:
        return 0
    order = DRIVE_ORDERS.get(signal.attribute)
    return _of_forces(graph, signal) if order is None else order


def _of_joint(graph: Graph, signal: Signal) -> int:
    order = graph.structure.topology.kind_of(signal.owners[0]).orders[signal.attribute]
    return order if signal.kinematic else max(order, graph.actions.forces)


def _of_acting(graph: Graph, signal: Signal) -> int:
    kind = graph.quantities.signals.acting[signal.owners[0]].kind
    return kind.orders.get(signal.attribute, kind.order)


def _of_point(graph: Graph, signal: Signal) -> int:
    return LETTERS[signal.attribute[:-1]]


ORDERS: dict[str, Callable[[Graph, Signal], int]] = {
    "link": lambda graph, signal: LINK_ORDERS[signal.attribute],
    "point": _of_point,
    "com": _of_point,
    "slide": lambda graph, signal: SLIDE_ORDERS[signal.attribute],
    "joint": _of_joint,
    "drive": _of_drive,
    "force": _of_forces,
    "shaking": _of_forces,
    "energy": lambda graph, signal: _of_forces(graph, signal) if signal.attribute in POWER else 1,
    "power": _of_forces,
    "pole": lambda graph, signal: 1,
} | dict.fromkeys(NOUNS.values(), _of_acting)
