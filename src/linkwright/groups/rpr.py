"""RPR: two links on known pins that slide along each other (inverted slider-crank, oscillating cylinder)."""

from __future__ import annotations

import math

from linkwright.elements import InnerLine
from linkwright.groups.dyad import Dyad, Root, pin, register, root_of
from linkwright.notation import Body, Pair, Scalar
from linkwright.notation.jets import call


@register
class RPR(Dyad):
    """Branch +1: the second outer pin is ahead of the first along the sliding line."""

    signature = "RPR"
    rules = (
        ("{second}: ahead of {first} along {inner}", "{first}: behind {second} along {inner}"),
        ("{second}: behind {first} along {inner}", "{first}: ahead of {second} along {inner}"),
    )
    inner: InnerLine

    def root(self, branch: Scalar) -> Root:
        first, second = pin(self.first), pin(self.second)
        across = self._across()
        base = second.base.now.minus(first.base.now)
        square = base.dot(base)
        radicand = square - across * across
        along = branch * root_of(radicand, square, self.nearest)
        # The base vector is (along, across) in the line's frame: the line's direction follows.
        heading = Pair((along * base.x + across * base.y) / square, (along * base.y - across * base.x) / square)
        return Root(
            heading.rotated_back(self.inner.first_heading),
            heading.rotated_back(self.inner.second_heading),
            radicand / square,
        )

    def spanned(self) -> tuple[Scalar, Scalar, Scalar]:
        return self.span(), call("abs", self._across()), math.inf

    def radicand(self) -> Scalar:
        base, across = pin(self.second).base.now.minus(pin(self.first).base.now), self._across()
        return base.dot(base) - across * across

    def _across(self) -> Scalar:
        """The distance of the second outer pin from the first, across the sliding line: fixed by the links."""
        arm1 = self.inner.first.minus(pin(self.first).foot).rotated_back(self.inner.first_heading)
        arm2 = self.inner.second.minus(pin(self.second).foot).rotated_back(self.inner.second_heading)
        return arm1.y - arm2.y

    def span(self) -> Scalar:
        """The distance of the outer pins: where they meet, the sliding line may point anywhere."""
        return pin(self.second).base.now.minus(pin(self.first).base.now).length

    def apart(self) -> Scalar:
        base = pin(self.second).base.now.minus(pin(self.first).base.now)
        return base.dot(base)

    def scale(self, a: Body, b: Body) -> Scalar:
        return self.span()
