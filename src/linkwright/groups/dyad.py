"""The contract of the dyads, and what all of them share: rates, equilibrium, the Newton twin.

A dyad is two links, each on a known body by an outer joint, that meet in an inner joint: the Assur groups of
class II. Its unknowns are the two outer coordinates; its closure, the inner joint's two equations. A file per
dyad states the closed-form root with its assembly branch; everything else follows from the closure here.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Callable
from typing import ClassVar

from linkwright.data_classes import dataclass
from linkwright.elements import Outer, OuterLine, OuterPin, Twist
from linkwright.elements.lower_pair import LowerPair, Slopes
from linkwright.notation import Body, Jet, Pair, Scalar, Wrench
from linkwright.notation.jets import call
from linkwright.notation.registry import Registry

Coordinate = Scalar | Pair
Carry = Callable[[Body], Body]

SLACK = 1e-12
"""A group short by less than this share of its size closes but for round-off."""

REGISTRY: Registry[type[Dyad]] = Registry()


def register(cls: type[Dyad]) -> type[Dyad]:
    """Register a dyad under its signature; a second one of the same signature is an error."""
    REGISTRY[cls.signature] = cls
    return cls


@dataclass(frozen=True)
class Root:
    """A closed-form position: the outer coordinates, and ``reach``, negative where the group can't close.

    ``reach`` is the radicand over the square of the group's size (1 where there is no root to take).
    """

    first: Coordinate
    second: Coordinate
    reach: Scalar

    def of_unit_length(self) -> Root:
        """The same with axes of unit length, which those of a group that can't close haven't."""
        return Root(_normalised(self.first), _normalised(self.second), self.reach)


def _normalised(coordinate: Coordinate) -> Coordinate:
    if not isinstance(coordinate, Pair):
        return coordinate
    size = coordinate.length
    return Pair(coordinate.x / size, coordinate.y / size)


@dataclass(frozen=True)
class Solved:
    """A solved dyad: the motion of its two links at the inner joint, the normalised determinant of its closure."""

    first: Body
    second: Body
    determinant: Scalar
    slopes: Slopes
    twists: tuple[Twist, Twist]
    reach: Scalar


def _itself(body: Body) -> Body:
    return body


class Dyad(ABC):
    """One kind of dyad on its joints.

    Each of its two sides is a link, or several that drives hold on each other: then the coordinate places the link
    at the outer joint, ``carry`` gives the one at the inner joint with all rates, and ``frozen`` is the inner joint
    as it lies on the links at the outer joints in the present pose, which is all that the position needs.

    With ``nearest``, a group that can't close is placed where it comes nearest to closing: what is under its root
    counts as 0, and the inner joint stays open.

    ``signature`` is outer, inner, outer joint; ``rules`` the ways in which a file states branch +1, and those for
    -1, by the names of the ``first`` and ``second`` outer joints and the ``inner`` one; none where there is one
    assembly mode only.
    """

    signature: ClassVar[str]
    rules: ClassVar[tuple[tuple[str, ...], ...]] = ()
    first: Outer
    second: Outer
    inner: LowerPair

    def __init__(
        self,
        first: Outer,
        inner: LowerPair,
        second: Outer,
        carry: tuple[Carry, Carry] = (_itself, _itself),
        frozen: LowerPair | None = None,
        nearest: bool = False,
    ) -> None:
        self.first, self.joint, self.second, self.carry = first, inner, second, carry
        self.inner, self.nearest = frozen or inner, nearest

    @abstractmethod
    def root(self, branch: Scalar) -> Root:
        """The closed-form position of assembly branch +1 or -1."""

    @abstractmethod
    def scale(self, a: Body, b: Body) -> Scalar:
        """The size of the closure's determinant at its best, so that determinant/scale lies in -1..1."""

    def shortfall(self) -> tuple[float, float] | None:
        """On plain numbers: where the group can't close, the distance (m) it must span and the nearest it can."""
        if (spanned := self.spanned()) is None:
            return None
        distance, least, most = map(float, spanned)
        if distance > most * (1 + SLACK):
            return distance, most
        return (distance, least) if distance < least * (1 - SLACK) else None

    def spanned(self) -> tuple[Scalar, Scalar, Scalar] | None:
        """The distance (m) that the group must span, the least and the most that it can; ``None`` where it always
        closes."""
        return None

    def span(self) -> Scalar | None:
        """A distance (m) whose vanishing makes the pose vague while the normalised determinant doesn't show it."""
        return None

    def apart(self) -> Scalar | None:
        """The square of the distance (m^2) of the outer pins, where they may meet: with arms of one length, or a line
        through both. There the inner joint may lie anywhere, and the two modes meet although the reach doesn't vanish.
        ``None`` where that can't be."""
        return None

    def radicand(self) -> Scalar | None:
        """What is under the root (m^2), negative where the group can't close: a polynomial of the known links' places,
        smooth where the outer pins meet, as the reach isn't. ``None`` where there is no root."""
        return None

    def solve(self, branch: Scalar, order: int) -> Solved:
        """Position in closed form, then each rate from the closure differentiated once more (linear in it)."""
        root = self.root(branch).of_unit_length() if self.nearest else self.root(branch)
        rates: tuple[list[Scalar], list[Scalar]] = ([], [])
        a, b = self.place(root.first, rates[0]), self.place(root.second, rates[1], second=True)
        twists = self.first.twist(a), self.second.twist(b)
        slopes = self.joint.slopes(*self.inner_bodies(a, b), *twists)
        determinant = determinant_of(slopes)
        inverse = 1.0 / determinant if order else 0.0
        for k in range(1, order + 1):
            a = self.place(root.first, [*rates[0], 0.0])
            b = self.place(root.second, [*rates[1], 0.0], second=True)
            rest = [gap.d[k] for gap in self.joint.gap(*self.inner_bodies(a, b))]
            q1, q2 = _solve(slopes, inverse, rest)
            rates[0].append(-q1)
            rates[1].append(-q2)
        a, b = self.place(root.first, rates[0]), self.place(root.second, rates[1], second=True)
        best = self.scale(a, b)
        a, b = self.inner_bodies(a, b)
        return Solved(a, b, determinant / best, slopes, twists, root.reach)

    def inner_bodies(self, a: Body, b: Body) -> tuple[Body, Body]:
        """The links at the inner joint, from those at the outer joints."""
        return self.carry[0](a), self.carry[1](b)

    def place(self, start: Coordinate, rates: list[Scalar], second: bool = False) -> Body:
        """One of the links at its coordinate with the rates known so far."""
        return (self.second if second else self.first).place(start, Jet(rates))

    def balance(self, solved: Solved, on_first: Wrench, on_second: Wrench) -> Wrench:
        """The wrench on the first link at the inner joint that keeps both links in equilibrium.

        ``on_first`` and ``on_second`` are all other wrenches on the links but the outer reactions (inertia
        among them). The freedom of an outer joint does no work on its reaction, so two equations remain, with
        the transposed matrix of the closure.
        """
        (j11, j12), (j21, j22) = solved.slopes
        transposed = ((j11, j21), (j12, j22))
        works = [solved.twists[0].work(on_first), solved.twists[1].work(on_second)]
        m1, m2 = _solve(transposed, 1.0 / determinant_of(transposed), works)
        return self.joint.action(solved.first, solved.second, (-m1, -m2))

    def newton(self, start: tuple[Coordinate, Coordinate], tolerance: float = 1e-14) -> tuple[Body, Body]:
        """The twin of :meth:`root` on plain numbers: Newton on the same closure from a start nearby."""
        here = list(start)
        size = 1.0
        for _ in range(50):
            a, b = self.place(here[0], []), self.place(here[1], [], second=True)
            gaps = [float(gap.d[0]) for gap in self.inner.gap(a, b)]
            slopes = self.inner.slopes(a, b, self.first.twist(a), self.second.twist(b))
            steps = _solve(slopes, 1.0 / determinant_of(slopes), gaps)
            here = [_stepped_coordinate(q, -float(step)) for q, step in zip(here, steps, strict=True)]
            if max(map(abs, steps)) < tolerance * size:
                break
        return self.place(here[0], []), self.place(here[1], [], second=True)


def _stepped_coordinate(q: Coordinate, step: float) -> Coordinate:
    if not isinstance(q, Pair):
        return q + step
    turned = q.rotated(Pair(math.cos(step), math.sin(step)))
    size = math.hypot(turned.x, turned.y)
    return Pair(turned.x / size, turned.y / size)


def determinant_of(m: Slopes) -> Scalar:
    """Of the closure's slopes."""
    (a, b), (c, d) = m
    return a * d - b * c


def _solve(m: Slopes, inverse: Scalar, right: list[Scalar]) -> tuple[Scalar, Scalar]:
    (a, b), (c, d) = m
    return (d * right[0] - b * right[1]) * inverse, (a * right[1] - c * right[0]) * inverse


def root_of(radicand: Scalar, scale: Scalar, nearest: bool = False) -> Scalar:
    """The square root; on plain numbers 0 where round-off alone makes the radicand negative, against its ``scale``;
    with ``nearest`` 0 wherever it is negative."""
    if nearest:
        return call("sqrt", call("fmax", radicand, 0.0))
    if isinstance(radicand, float) and -SLACK * scale < radicand < 0:
        return 0.0
    return call("sqrt", radicand)


def pointing(arm: Pair, local: Pair) -> Pair:
    """The axis of a link whose arm of coordinates ``local`` points along ``arm`` (both of one length)."""
    turned = arm.rotated_back(local)
    square = local.dot(local)
    return Pair(turned.x / square, turned.y / square)


def pin(joint: Outer) -> OuterPin:
    """The outer joint as the pin that the signature says it is."""
    assert isinstance(joint, OuterPin)
    return joint


def line(joint: Outer) -> OuterLine:
    """The outer joint as the line that the signature says it is."""
    assert isinstance(joint, OuterLine)
    return joint
