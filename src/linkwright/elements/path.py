"""Paths that two drives are to move a point along: a straight line, an arc, or both coordinates over the time.

The two drives name the path as their output. Each prescribes one coordinate of the point, in the axes of the link in
which the path is stated; what both have to do, and with which efforts, follows from that (inverse kinematics and
inverse dynamics). The law of line and arc is the distance along them, so that its rate is the point's speed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Annotated, Any

import numpy as np
from pydantic import BeforeValidator, Field

from linkwright.data_classes import dataclass
from linkwright.elements.entries import NumberFault
from linkwright.elements.fields import LinkName
from linkwright.elements.joint import Applied, JointGeometry
from linkwright.elements.mover import MoverSignals
from linkwright.elements.points import FRAME
from linkwright.elements.prescribed import Track
from linkwright.elements.stated_law import Bind, StatedLaw
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Frozen, Name, Position, pair
from linkwright.expressions.language import Binary, Call, Node
from linkwright.expressions.typed_fields import Quantity, Ref, Scope, Sign
from linkwright.expressions.units import Dimension
from linkwright.expressions.written import Fault
from linkwright.findings import Joined
from linkwright.notation import Pair
from linkwright.notation.jets import call


class PathArc(Frozen):
    """An arc about a ``centre``; the distance along it counts counter-clockwise from the direction ``from``."""

    centre: Position
    radius: Annotated[Expression, Quantity(u.LENGTH, Sign.POSITIVE, "path-radius")]
    from_: Annotated[Expression, Quantity(u.ANGLE)] = Field(Expression("0 deg"), alias="from")


class PointPath(StatedLaw, Frozen):
    """A path of the point ``at`` of the link ``moves``, in the axes of ``on``, and how it is passed."""

    moves: LinkName
    at: Annotated[Name, Ref("point", of="moves")]
    on: LinkName = FRAME
    line: Annotated[tuple[Position, Position], BeforeValidator(pair("two-positions"))] | None = None
    arc: PathArc | None = None
    x: Annotated[Expression | None, Quantity(u.LENGTH, scope=Scope.TIME)] = None
    y: Annotated[Expression | None, Quantity(u.LENGTH, scope=Scope.TIME)] = None
    speed: Annotated[Expression | None, Quantity(u.SPEED)] = None
    start: Annotated[Expression | None, Quantity(u.LENGTH)] = None
    acceleration: Annotated[Expression | None, Quantity(u.ACCELERATION)] = None
    position: Annotated[Expression | None, Quantity(u.LENGTH, scope=Scope.TIME)] = None

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        shapes = [key for key in ("line", "arc", "x") if key in given]
        if len(shapes) != 1 or ("x" in given) != ("y" in given):
            yield "path.shape", {"given": Joined([*shapes, *(["y"] if "y" in given else [])]) or "-"}
        elif "x" not in given:
            yield from cls.law_faults(given)
        elif law := [key for key in ("speed", "start", "acceleration", "position") if key in given]:
            yield "path.law", {"given": Joined(law)}

    @property
    def stated(self) -> Iterator[tuple[str, Expression]]:
        """The keys whose expressions may contain the time."""
        every = (("x", self.x), ("y", self.y), ("position", self.position))
        return ((key, expression) for key, expression in every if expression is not None)

    def number_faults(self, value: Callable[[Expression, Dimension], Any]) -> Iterator[NumberFault]:
        """That the ends of a line are two places."""
        if self.line is not None:
            start, end = (_place(of, value) for of in self.line)
            away = end.minus(start)
            yield away.length, Sign.POSITIVE, ("path.no-length", {}, "line")

    def coordinate(self, bind: Bind, across: bool) -> Node:
        """x, or ``across`` y, in the axes of ``on`` (m), as a tree in t."""
        if self.x is not None and self.y is not None:
            return bind(self.y if across else self.x, u.LENGTH)
        passed = self.tree(bind, angle=False)
        if self.line is not None:
            start, end = (_trees(of, bind) for of in self.line)
            away = [Binary("-", b, a) for a, b in zip(start, end, strict=True)]
            share = Binary("/", passed, Call("hypot", tuple(away)))
            return Binary("+", start[across], Binary("*", share, away[across]))
        assert self.arc is not None
        radius = bind(self.arc.radius, u.LENGTH)
        turned = Binary("+", bind(self.arc.from_, u.ANGLE), Binary("/", passed, radius))
        around = Call("sin" if across else "cos", (turned,))
        return Binary("+", _trees(self.arc.centre, bind)[across], Binary("*", radius, around))


def _place(of: Position, value: Callable[[Expression, Dimension], Any]) -> Pair:
    first, second = (value(part, dimension) for part, dimension in _parts(of))
    return Pair(first * call("cos", second), first * call("sin", second)) if of.polar else Pair(first, second)


def _trees(of: Position, bind: Bind) -> tuple[Node, Node]:
    first, second = (bind(part, dimension) for part, dimension in _parts(of))
    if not of.polar:
        return first, second
    return Binary("*", first, Call("cos", (second,))), Binary("*", first, Call("sin", (second,)))


def _parts(of: Position) -> tuple[tuple[Expression, Dimension], tuple[Expression, Dimension]]:
    return (of.first, u.LENGTH), (of.second, u.ANGLE if of.polar else u.LENGTH)


@dataclass(frozen=True)
class Coordinate(MoverSignals):
    """What one of the two drives prescribes: x of the path's point, or ``across`` y, in the axes of ``on``."""

    path: PointPath
    output: str
    across: bool

    turns = None
    slides = None

    @property
    def moves(self) -> str:
        return self.path.moves

    @property
    def at(self) -> str:
        """The point that is moved."""
        return self.path.at

    @property
    def link(self) -> str:
        """The link that has the point."""
        return self.path.moves

    @property
    def on(self) -> str:
        """The link in whose axes the path is stated."""
        return self.path.on

    @property
    def signals(self) -> Mapping[str, Dimension]:
        """None of its own: the drive has those of what it moves."""
        return {}

    def track(self, geometry: JointGeometry) -> Track:
        """The point, and the axis of ``on``."""
        return Track(geometry.point(self.link, self.path.at), Pair(0.0, 0.0), np.pi / 2 if self.across else 0.0)

    def applied(self, reports: Any, name: str) -> list[Applied]:
        """Nothing: the drive acts elsewhere."""
        return []
