"""Joints of two links on two equations, in which the links of a dyad can meet: pins and slides.

Their slopes and actions are stated, by link, for speed and for dyads, which need the slopes of each link apart.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Sequence
from typing import Self

from linkwright.elements.joint import Inner, Twist
from linkwright.notation import Body, Scalar, Wrench

Slopes = tuple[tuple[Scalar, Scalar], tuple[Scalar, Scalar]]
"""The slopes of two equations to a freedom of each of two links."""


class LowerPair(Inner):
    """A joint as closure between two links."""

    @abstractmethod
    def seen_from(self, a: Body, b: Body) -> Self:
        """The same joint by coordinates in the frames in which the two links lie as ``a`` and ``b`` say."""

    @abstractmethod
    def slopes(self, a: Body, b: Body, first: Twist, second: Twist) -> Slopes:
        """d(gap)/d(coordinates)."""

    @abstractmethod
    def action(self, a: Body, b: Body, multipliers: tuple[Scalar, Scalar]) -> Wrench:
        """The wrench on the first link that the closure's multipliers stand for; that on the second is the opposite."""

    def rates(self, bodies: Sequence[Body], twists: Sequence[Twist]) -> list[Scalar]:
        return [one + other for one, other in self.slopes(bodies[0], bodies[1], twists[0], twists[1])]

    def actions(self, bodies: Sequence[Body], multipliers: Sequence[Scalar]) -> list[Wrench]:
        own = self.action(bodies[0], bodies[1], (multipliers[0], multipliers[1]))
        return [own, own.opposite]
