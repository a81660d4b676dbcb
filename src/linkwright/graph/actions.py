"""What acts on the links besides gravity and inertia: loads and springs, and the inputs of each pose that they need.

How fast a follower moves over its cam is such an input too: the direction of the contact's force depends on it. Tables
can't be expressions of the graph, so a table's value at an argument enters as an input, with its rate; so do
the time and the whole turns of an angle that the graph knows from its axis alone.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import casadi as ca

from linkwright.elements.follower import Follower
from linkwright.expressions import units as u
from linkwright.expressions.language import FUNCTIONS, Call, Name, Node, is_signal, nodes, parse, signal_text
from linkwright.expressions.trees import children
from linkwright.graph.springs import spring_wrenches
from linkwright.model.mechanism import Load
from linkwright.model.signals import Signal
from linkwright.notation import Pair, Scalar, Wrench
from linkwright.structure import FRAME

if TYPE_CHECKING:
    from linkwright.graph.graph import Graph
    from linkwright.graph.view import View


@dataclass(frozen=True)
class Lookup:
    """A table, or its integral, at an argument (bound to SI); ``level`` tables stand within one another there."""

    table: str
    argument: Node
    integral: bool = False
    level: int = 0


class Actions:
    """The loads and springs of a mechanism, as the graph needs them."""

    def __init__(self, graph: Graph) -> None:
        self.graph, self.mechanism = graph, graph.quantities.mechanism

    @cached_property
    def laws(self) -> list[Node]:
        """The expressions of all loads."""
        bind = self.graph.quantities.bind
        return [bind(part, dimension) for load in self.mechanism.loads.values() for part, dimension in load.parts]

    @cached_property
    def windows(self) -> tuple[str, ...]:
        """The windows outside which some load doesn't act."""
        return tuple(dict.fromkeys(load.window for load in self.mechanism.loads.values() if load.window))

    @cached_property
    def signals(self) -> list[Signal]:
        """The signals on which loads depend."""
        found = [part for law in self.laws for part in nodes(law) if isinstance(part, Name | Call) and is_signal(part)]
        texts = [signal_text(part) for part in found]
        for name in self.windows:
            window = self.mechanism.windows[name]
            texts += [] if isinstance(window, tuple) else window
        return [self.graph.signal(text) for text in dict.fromkeys(texts)]

    @cached_property
    def lookups(self) -> tuple[Lookup, ...]:
        """All tables that loads and springs ask, each after those within its argument."""
        found: dict[Lookup, None] = {}

        def note(node: Node) -> int:
            """Note all tables in a tree; how deep they stand within one another."""
            levels = [note(child) for child in children(node)]
            level = max(levels, default=0)
            if isinstance(node, Call) and is_table(node):
                found[Lookup(node.name, node.args[0], level=level)] = None
                level += 1
            return level

        for law in self.laws:
            note(law)
        for name, spring in self.mechanism.springs.items():
            if spring.table:
                argument = Name(f"{name}.{spring.measure}")
                found.update({Lookup(spring.table, argument, integral): None for integral in (False, True)})
        return tuple(found)

    @cached_property
    def turning(self) -> tuple[str, ...]:
        """Links, drives with outputs, and torsional springs whose angle matters to a load or spring but is known
        without whole turns."""
        links = [s.owners[0] for s in self.signals if s.kind in ("link", "drive") and s.attribute == "angle"]
        springs = [name for name, s in self.mechanism.springs.items() if s.torsional]
        return (
            *(link for link in links if self.graph.wraps(link)),
            *(name for name in springs if any(map(self.graph.wraps, self._links(name)))),
        )

    def _links(self, spring: str) -> tuple[str, str]:
        """The two links of a torsional spring."""
        entry = self.mechanism.springs[spring]
        return str(entry.turns), str(entry.on)

    @cached_property
    def timed(self) -> bool:
        """Whether some load depends on the time itself."""
        named = any(isinstance(part, Name) and part.text == "t" for law in self.laws for part in nodes(law))
        return named or any(isinstance(self.mechanism.windows[name], tuple) for name in self.windows)

    @cached_property
    def inputs(self) -> tuple[str, ...]:
        """The input rows: the time, the whole turns of each such angle, value and rate of each table's answer, of each
        cam the follower's rate over the cam's, with its rate in time, and what places a second contact."""
        tables = (f"table/{i}/{k}" for i in range(len(self.lookups)) for k in (0, 1))
        ratios = (f"ratio/{name}/{k}" for name in self.followers for k in (0, 1))
        totals = (f"total/{name}" for name, drive in self.followers.items() if drive.derived)
        return (*(["t"] if self.timed else []), *(f"turns/{name}" for name in self.turning), *tables, *ratios, *totals)

    @cached_property
    def followers(self) -> Mapping[str, Follower]:
        """The joints that have a link follow a drive."""
        return self.mechanism.followers

    def flow(self, given: dict[str, Any]) -> list[Any]:
        """The rates of these inputs in time."""
        known = {"t": ca.SX(1)} | {f"table/{i}/0": given[f"table/{i}/1"] for i in range(len(self.lookups))}
        known |= {f"ratio/{name}/0": given[f"ratio/{name}/1"] for name in self.followers}
        return [known.get(name, ca.SX(0)) for name in self.inputs]

    @cached_property
    def order(self) -> int:
        """The order of derivatives that the loads' values need."""
        return self.graph.order(signal.text for signal in self.signals)


def is_table(call: Call) -> bool:
    """Whether a call asks a table."""
    return call.attribute is None and call.name not in FUNCTIONS


def active(view: View, name: str) -> Scalar:
    """1 inside a window, 0 outside."""
    quantities = view.graph.quantities
    window, number = quantities.mechanism.windows[name], view.motion.geometry.number
    if isinstance(window, tuple):
        value, dimension, edges = view.given["t"], u.TIME, window
    else:
        ((text, edges),) = window.items()
        value, dimension = view.row(text), quantities.dimensions.dimension(parse(text))
    low, high = (number(edge, dimension) for edge in edges)
    over = value - low
    if dimension == u.ANGLE:
        over = over - 2 * ca.pi * ca.floor(over / (2 * ca.pi))
    return ca.logic_and(over >= 0, over <= high - low)


def load_values(view: View, load: Load) -> tuple[Pair, Scalar]:
    """A load's force (N, in the axes that it is given in) and torque (N m)."""
    values = [view.value(part, dimension) for part, dimension in load.parts]
    if load.window:
        inside = active(view, load.window)
        values = [ca.if_else(inside, value, 0.0) for value in values]
    return spread(load, values)


def spread(load: Load, values: list[Any]) -> tuple[Pair, Any]:
    """The values of a load's parts as force and torque; a single force goes along the first axis."""
    torque = values[-1] if load.torque is not None else 0.0
    force = values[: -1 if load.torque is not None else None]
    return Pair(*(*force, 0.0, 0.0)[:2]), torque


def load_wrench(view: View, load: Load) -> Wrench:
    """A load's wrench at its point."""
    motion, geometry = view.motion, view.motion.geometry
    force, torque = load_values(view, load)
    if load.along:
        joint = geometry.mechanism.joints[load.along]
        heading = geometry.line(load.along, joint.links[0])[1]
        force = force.turned(motion.bodies[joint.links[0]].direction(heading).now)
    elif load.in_ and load.in_ != FRAME:
        force = force.turned(motion.bodies[load.in_].axis.now)
    return Wrench(force, torque, motion.bodies[load.on].point(geometry.place(load.on, load.at)).now)


def wrenches(view: View) -> Iterator[tuple[str, Wrench]]:
    """What loads and springs do to each link: (link, wrench). A load between two links has an opposite on the other."""
    for load in view.graph.quantities.mechanism.loads.values():
        wrench = load_wrench(view, load)
        yield load.on, wrench
        if load.against:
            yield load.against, wrench.opposite
    for name in view.graph.quantities.mechanism.springs:
        yield from spring_wrenches(view, name)
