"""The output rows of programs: signals, and what only kernels, proofs and studies need besides.

A row says itself what it is called, which order of derivatives it needs and what its expression is. Callers hand in
rows, or the texts of signals, which :meth:`linkwright.graph.graph.Graph.signal` reads.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from typing import TYPE_CHECKING, ClassVar

from linkwright.data_classes import dataclass
from linkwright.elements.force import Acting
from linkwright.expressions.language import Node, Number, nodes, signal_text, signals_in, text_of
from linkwright.graph.actions import active
from linkwright.graph.derivative_orders import ORDERS
from linkwright.graph.forces import lever, unit_efforts
from linkwright.graph.geometry import ZERO
from linkwright.model.signals import Signal
from linkwright.notation import Body, Scalar
from linkwright.structure import Structure

if TYPE_CHECKING:
    from linkwright.graph.graph import Graph
    from linkwright.graph.view import View


@dataclass(frozen=True)
class Row(ABC):
    """One output row of a program; ``called`` is its label, with its fields in braces."""

    called: ClassVar[str]

    @property
    def label(self) -> str:
        """What it is called among a program's outputs; no two rows of a mechanism share it."""
        return self.called.format(**vars(self))

    def order(self, graph: Graph) -> int:
        """The order of derivatives that it needs."""
        return 0

    @abstractmethod
    def expression(self, view: View) -> Scalar:
        """Its expression, in SI."""


Named = str | Row
"""A row, or the text of a signal."""


@dataclass(frozen=True)
class SignalRow(Row):
    """A signal."""

    signal: Signal
    called = "{signal.text}"

    def order(self, graph: Graph) -> int:
        return ORDERS[self.signal.kind](graph, self.signal)

    def expression(self, view: View) -> Scalar:
        return view.expression(self.signal)


# Groups and higher groups, each by its label.


@dataclass(frozen=True)
class GroupRow(Row):
    """Something of a group."""

    group: str


@dataclass(frozen=True)
class ReachRow(GroupRow):
    """A dyad's reach: what stands under its root over the square of its size, 0 where its two modes meet, negative
    where it can't be assembled; 1 where there is no root to take."""

    called = "reach:{group}"

    def expression(self, view: View) -> Scalar:
        return view.motion.dyad(self.group)[1].reach


@dataclass(frozen=True)
class Span(GroupRow):
    """The distance (m) whose vanishing makes a dyad's pose vague (:meth:`Dyad.span`), 1 where there is none."""

    called = "span:{group}"

    def expression(self, view: View) -> Scalar:
        span = view.motion.dyad(self.group)[0].span()
        return 1.0 if span is None else span


@dataclass(frozen=True)
class Apart(GroupRow):
    """The square of the distance of a dyad's outer pins (:meth:`Dyad.apart`, m^2), 1 where these can't meet."""

    called = "apart:{group}"

    def expression(self, view: View) -> Scalar:
        apart = view.motion.dyad(self.group)[0].apart()
        return 1.0 if apart is None else apart


@dataclass(frozen=True)
class Radicand(GroupRow):
    """What stands under a dyad's root (m^2), where it has one; 1 elsewhere."""

    called = "room:{group}"

    def expression(self, view: View) -> Scalar:
        room = view.motion.dyad(self.group)[0].radicand()
        return 1.0 if room is None else room


@dataclass(frozen=True)
class Determinant(GroupRow):
    """The margin to singularity of a group or higher group: 0 singular, 1 best."""

    called = "determinant:{group}"

    def expression(self, view: View) -> Scalar:
        return view.motion.determinant(self.group)


@dataclass(frozen=True)
class Sharpness(GroupRow):
    """The determinant of a higher group's closures by its coordinates, in their units: rates are divided by it. It is
    small too where a coordinate hardly moves its closures, as where a pin comes near the pivot of the lever that it
    turns, which the margin to singularity, being over the lengths of the columns, doesn't tell."""

    called = "sharpness:{group}"

    def expression(self, view: View) -> Scalar:
        return view.motion.higher_group(self.group).factor.determinant()


@dataclass(frozen=True)
class HigherGroupRow(GroupRow):
    """The entry ``index`` of something of a higher group."""

    index: int


@dataclass(frozen=True)
class Gap(HigherGroupRow):
    """What one of a higher group's closures misses."""

    called = "gap:{group}:{index}"

    def expression(self, view: View) -> Scalar:
        return view.motion.higher_group(self.group).gaps[self.index]


@dataclass(frozen=True)
class Slope(HigherGroupRow):
    """The derivative of a higher group's closure by one of its coordinates, numbered row by row."""

    called = "slope:{group}:{index}"

    def expression(self, view: View) -> Scalar:
        slopes = view.motion.higher_group(self.group).slopes
        closure, coordinate = divmod(self.index, len(slopes))
        return slopes[closure][coordinate]


@dataclass(frozen=True)
class CoordinateRate(HigherGroupRow):
    """The rate in time of one of a higher group's coordinates."""

    called = "rate:{group}:{index}"

    def order(self, graph: Graph) -> int:
        return 1

    def expression(self, view: View) -> Scalar:
        return view.motion.higher_group(self.group).rates[self.index][0]


def reaches(structure: Structure) -> list[ReachRow]:
    """The reaches of all groups with two modes."""
    return [ReachRow(group.label) for group in structure.groups if group.modes > 1]


def spans(structure: Structure) -> list[Span]:
    """The spans of all groups that have one."""
    return [Span(group.label) for group in structure.groups if group.has_span]


def change_rows(structure: Structure) -> list[ReachRow | Apart]:
    """The rows whose double roots are the change points of dyads: the reaches of those with two modes, and the squares
    of the distances of outer pins."""
    pins = [Apart(group.label) for group in structure.groups if group.has_outer_pins]
    return [*reaches(structure), *pins]


def determinants(structure: Structure) -> list[Determinant]:
    """The determinants of all groups, then of all higher groups."""
    labels = [
        *(group.label for group in structure.groups),
        *(higher_group.label for higher_group in structure.higher_groups),
    ]
    return [Determinant(label) for label in labels]


# Links and drives.

_PARTS: dict[str, Callable[[Body], Scalar]] = {
    "x": lambda body: body.point(ZERO).now.x,
    "y": lambda body: body.point(ZERO).now.y,
    "cos": lambda body: body.axis.x.d[0],
    "sin": lambda body: body.axis.y.d[0],
}


@dataclass(frozen=True)
class BodyPlace(Row):
    """``x`` or ``y`` of a link's origin (m), or the ``cos`` or ``sin`` of its angle."""

    link: str
    part: str
    called = "{link}:{part}"

    def expression(self, view: View) -> Scalar:
        return _PARTS[self.part](view.motion.bodies[self.link])

    @classmethod
    def all(cls, link: str) -> list[BodyPlace]:
        """The rows of a link's pose: x, y, cos, sin."""
        return [cls(link, part) for part in _PARTS]


@dataclass(frozen=True)
class OutputLever(Row):
    """The determinant of the drives' rates over those of their outputs, to its sign: zero where the drives can't move
    them."""

    called = "drives over outputs:"

    def expression(self, view: View) -> Scalar:
        return lever(view.motion, unit_efforts(view.motion)).determinant()


@dataclass(frozen=True)
class RawAngle(Row):
    """The angle (rad) of a link or drive, or that which a torsional spring or the like follows, without whole turns."""

    owner: str
    called = "raw/{owner}"

    def expression(self, view: View) -> Scalar:
        bodies, counted = view.bodies, view.graph.actions.counted_angles
        if self.owner in counted:
            link, base = counted[self.owner][1]
            return bodies[link].heading - bodies[base].heading
        prescribed = self.owner in view.graph.quantities.mechanism.movers
        return view.drive_value(self.owner, 0, whole=False) if prescribed else bodies[self.owner].heading


# What acts.


class ActionRow(Row):
    """A row that needs the signals on which loads depend."""

    def order(self, graph: Graph) -> int:
        return graph.actions.order


@dataclass(frozen=True)
class ElementActionRow(ActionRow):
    """A row of one element that acts, which may need more signals than the loads do."""

    section: str
    name: str

    def order(self, graph: Graph) -> int:
        own: int = graph.actions.at[self.section, self.name].kind.order
        return max(graph.actions.order, own)


@dataclass(frozen=True)
class Strength(ElementActionRow):
    """What an element without a signal of its own does, such as a load: its signs and finiteness are looked at."""

    called = "{section}/{name}"

    def expression(self, view: View) -> Scalar:
        one = view.graph.actions.at[self.section, self.name]
        return one.kind.strength(view, one.name, one.entry)


def effort(one: Acting) -> Named:
    """What tells what an element does."""
    attribute = one.kind.effort(one.entry)
    return f"{one.name}.{attribute}" if attribute else Strength(*one.path)


@dataclass(frozen=True)
class WindowRow(ActionRow):
    """1 inside a window, 0 outside."""

    name: str
    called = "window/{name}"

    def expression(self, view: View) -> Scalar:
        return active(view, self.name)


@dataclass(frozen=True)
class TableArgument(ActionRow):
    """What a table is asked for, by the number of the lookup (:attr:`linkwright.graph.actions.Actions.lookups`)."""

    index: int
    called = "argument/{index}"

    def expression(self, view: View) -> Scalar:
        return view.evaluate(view.graph.actions.lookups[self.index].argument)


# What is made of signals.


@dataclass(frozen=True)
class ExpressionRow(Row):
    """An expression of signals and parameters, bound to SI."""

    node: Node
    called = "expression/{node}"

    @property
    def label(self) -> str:
        # The text shows twelve digits; what it rounds is told besides.
        numbers = [part.value for part in nodes(self.node) if isinstance(part, Number)]
        rest = [repr(value) for value in numbers if float(f"{value:.12g}") != value]
        return " ".join([f"expression/{text_of(self.node)}", *rest])

    def order(self, graph: Graph) -> int:
        return graph.order(map(signal_text, signals_in(self.node)))

    def expression(self, view: View) -> Scalar:
        return view.evaluate(self.node)
