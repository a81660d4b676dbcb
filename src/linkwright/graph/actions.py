"""What acts on the links besides gravity and inertia, and the inputs of each pose that it needs.

How fast a follower moves with its motor is such an input too: the direction of its force depends on it. Tables
can't be expressions of the graph, so a table's value at an argument enters as an input, with its rate; so do
the time and the whole turns of an angle that the graph knows from its axis alone.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

from linkwright.data_classes import dataclass
from linkwright.elements.follower import Follower
from linkwright.elements.force import Acting, Break
from linkwright.expressions.language import (
    FUNCTIONS,
    Call,
    Name,
    Node,
    Number,
    is_signal,
    nodes,
    signal_text,
    signals_in,
)
from linkwright.expressions.trees import children, with_parts
from linkwright.model.signals import Signal
from linkwright.notation import Scalar, Wrench
from linkwright.notation.jets import call

if TYPE_CHECKING:
    from linkwright.graph.graph import Graph
    from linkwright.graph.view import View


@dataclass(frozen=True)
class Lookup:
    """A table, or its integral, at an argument (bound to SI); ``level`` tables stand within one another there.
    ``at_rest`` are those that only starts from standstill ask."""

    table: str
    argument: Node
    integral: bool = False
    level: int = 0
    at_rest: bool = False


class Actions:
    """What acts on the links of a mechanism, as the graph needs it."""

    def __init__(self, graph: Graph) -> None:
        self.graph, self.mechanism = graph, graph.quantities.mechanism
        self.every = [*self.mechanism.acting()]
        self.at = {one.path: one for one in self.every}

    @cached_property
    def resisting(self) -> list[Acting]:
        """What follows from reactions."""
        return [one for one in self.every if one.kind.resists]

    @cached_property
    def laws(self) -> list[Node]:
        """The expressions of all that acts."""
        bind = self.graph.quantities.bind
        return [bind(part, dimension) for one in self.every for part, dimension in one.kind.laws(one.entry)]

    @cached_property
    def windows(self) -> tuple[str, ...]:
        """The windows outside which something doesn't act."""
        windows = (one.kind.window(one.entry) for one in self.every)
        return tuple(dict.fromkeys(window for window in windows if window))

    @cached_property
    def signals(self) -> list[Signal]:
        """The signals on which it depends."""
        texts = [signal_text(part) for part in signals_in(*self.laws)]
        texts += [window.signal for window in map(self.graph.quantities.window, self.windows) if window.signal]
        texts += [text for one in self.every for text in one.kind.depends(one.name, one.entry)]
        return [self.graph.signal(text) for text in dict.fromkeys(texts)]

    @cached_property
    def lookups(self) -> tuple[Lookup, ...]:
        """All tables that are asked, each after those within its argument."""
        found: dict[Lookup, None] = {}

        def note(node: Node, at_rest: bool = False) -> int:
            """Note all tables in a tree; how deep they stand within one another."""
            levels = [note(child, at_rest) for child in children(node)]
            level = max(levels, default=0)
            if isinstance(node, Call) and is_table(node):
                found[Lookup(node.name, node.args[0], level=level, at_rest=at_rest)] = None
                level += 1
            return level

        for law in self.laws:
            note(law)
        for one in self.every:
            for asked in one.kind.needed_tables(one.name, one.entry):
                found[Lookup(*asked, level=note(asked.argument))] = None
        if self.graph.quantities.signals.static:
            for lookup in [*found]:
                standing = self.at_rest(lookup.argument)
                if standing != lookup.argument:
                    found[replace(lookup, argument=standing, level=note(standing, at_rest=True), at_rest=True)] = None
        return tuple(found)

    def at_rest(self, tree: Node) -> Node:
        """An expression where nothing moves: rates of the motion are 0."""

        def stopped(part: Node) -> Node | None:
            if not (isinstance(part, Name | Call) and is_signal(part)):
                return None
            signal = self.graph.signal(signal_text(part))
            return Number(0.0) if signal.kinematic and signal.dimension.time < 0 else None

        return with_parts(tree, stopped)

    def needed_tables(self, one: Acting) -> set[str]:
        """The tables that an element asks."""
        named = (part for law, _ in one.kind.laws(one.entry) for part in nodes(law.node))
        own = {asked.table for asked in one.kind.needed_tables(one.name, one.entry)}
        return own | {part.name for part in named if isinstance(part, Call)}

    @cached_property
    def breaks(self) -> list[Break]:
        """Where something isn't smooth, as kinds tell it."""
        bind = self.graph.quantities.bind
        return [way for one in self.every for way in one.kind.breaks(one.name, one.entry, bind)]

    @cached_property
    def jumps(self) -> list[Node]:
        """What changes its sign where a force jumps, besides the ends of windows."""
        return [way.node for way in self.breaks if way.jumps]

    @cached_property
    def counted_angles(self) -> dict[str, tuple[Acting, tuple[str, str]]]:
        """By name what follows the angle between two links over whole turns, and these."""
        found = ((one, one.kind.counted_angle(one.entry)) for one in self.every)
        return {one.name: (one, links) for one, links in found if links is not None}

    @cached_property
    def turning(self) -> tuple[str, ...]:
        """Links, drives with outputs, and torsional springs whose angle matters to what acts but is known without
        whole turns."""
        links = [s.owners[0] for s in self.signals if s.kind in ("link", "drive") and s.attribute == "angle"]
        return (
            *(link for link in links if self.graph.wraps(link)),
            *(name for name, (_, pair) in self.counted_angles.items() if any(map(self.graph.wraps, pair))),
        )

    @cached_property
    def timed(self) -> bool:
        """Whether something depends on the time itself."""
        named = any(isinstance(part, Name) and part.text == "t" for law in self.laws for part in nodes(law))
        return named or any(self.graph.quantities.window(name).signal is None for name in self.windows)

    @cached_property
    def varying(self) -> list[Acting]:
        """What may vary with the time while nothing moves."""
        return [one for one in self.every if one.kind.laws(one.entry)]

    @cached_property
    def inputs(self) -> tuple[str, ...]:
        """The input rows: the time, the whole turns of each such angle, value and rate of each table's answer, of each
        follower its rate over the motor's, with its rate in time, and what places a second contact."""
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
        known = {"t": 1.0} | {f"table/{i}/0": given[f"table/{i}/1"] for i in range(len(self.lookups))}
        known |= {f"ratio/{name}/0": given[f"ratio/{name}/1"] for name in self.followers}
        return [known.get(name, 0.0) for name in self.inputs]

    @cached_property
    def order(self) -> int:
        """The order of derivatives that the laws' values need."""
        return self.graph.order(signal.text for signal in self.signals)

    @cached_property
    def forces(self) -> int:
        """The order of derivatives that all forces need: inertia's, or more."""
        return max(2, self.order, *(one.kind.order for one in self.every))


def is_table(call: Call) -> bool:
    """Whether a call asks a table."""
    return call.attribute is None and call.name not in FUNCTIONS


def active(view: View, name: str) -> Scalar:
    """1 inside a window, 0 outside."""
    window = view.graph.quantities.window(name)
    value = view.given["t"] if window.signal is None else view.row(window.signal)
    low, high = (view.motion.geometry.number(end, window.dimension) for end in window.ends)
    over = value - low
    if window.turning:
        over = over - 2 * math.pi * call("floor", over / (2 * math.pi))
    return call("logical_and", over >= 0, over <= high - low)


def wrenches(view: View) -> Iterator[tuple[str, Wrench]]:
    """What acts on each link besides gravity and inertia: (link, wrench)."""
    yield from given_wrenches(view)
    for one in view.graph.actions.resisting:
        yield from one.kind.wrenches(view, one.name, one.entry)


def given_wrenches(view: View) -> Iterator[tuple[str, Wrench]]:
    """Those of them that don't follow from reactions."""
    for one in (one for one in view.graph.actions.every if not one.kind.resists):
        yield from one.kind.wrenches(view, one.name, one.entry)
