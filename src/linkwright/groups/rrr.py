"""RRR: two links pinned to known bodies and to each other; the inner pin is where two circles meet."""

from __future__ import annotations

from linkwright.elements import InnerPin
from linkwright.groups.dyad import Dyad, Root, pin, pointing, register, root_of
from linkwright.notation import Body, Pair, Scalar
from linkwright.notation.jets import call


@register
class RRR(Dyad):
    """Branch +1: the inner pin lies to the left of the line from the first outer pin to the second."""

    signature = "RRR"
    rules = (
        ("{inner}: left of {first}-{second}", "{inner}: right of {second}-{first}"),
        ("{inner}: right of {first}-{second}", "{inner}: left of {second}-{first}"),
    )
    inner: InnerPin

    def root(self, branch: Scalar) -> Root:
        first, second = pin(self.first), pin(self.second)
        arm1, arm2 = self.inner.first.minus(first.foot), self.inner.second.minus(second.foot)
        r1, r2 = arm1.dot(arm1), arm2.dot(arm2)
        l1, l2 = arm1.length, arm2.length
        base = second.base.now.minus(first.base.now)
        square = base.dot(base)
        d = base.length
        # Heron's product and each arm from its own pin: a short arm keeps its digits beside a long one.
        along1 = 0.5 * (r1 + (d - l2) * (d + l2)) / square
        along2 = 0.5 * (r2 + (d - l1) * (d + l1)) / square
        heron = (l1 + l2 + d) * (l1 + l2 - d) * (d - l1 + l2) * (d + l1 - l2)
        aside = branch * 0.5 * root_of(heron, (l1 + l2) ** 4, self.nearest) / square
        to_pin = Pair(along1 * base.x - aside * base.y, along1 * base.y + aside * base.x)
        back = Pair(-along2 * base.x - aside * base.y, -along2 * base.y + aside * base.x)
        return Root(pointing(to_pin, arm1), pointing(back, arm2), 0.25 * heron / (square * (r1 + r2)))

    def spanned(self) -> tuple[Scalar, Scalar, Scalar]:
        first, second = pin(self.first), pin(self.second)
        r1, r2 = self.inner.first.minus(first.foot).length, self.inner.second.minus(second.foot).length
        return second.base.now.minus(first.base.now).length, call("abs", r1 - r2), r1 + r2

    def apart(self) -> Scalar:
        base = pin(self.second).base.now.minus(pin(self.first).base.now)
        return base.dot(base)

    def radicand(self) -> Scalar:
        first, second = pin(self.first), pin(self.second)
        r1, r2 = self.inner.first.minus(first.foot).length, self.inner.second.minus(second.foot).length
        base = second.base.now.minus(first.base.now)
        longest = (r1 + r2) ** 2
        return (longest - base.dot(base)) * (base.dot(base) - (r1 - r2) ** 2) / longest

    def scale(self, a: Body, b: Body) -> Scalar:
        arm1 = self.inner.first.minus(pin(self.first).foot)
        arm2 = self.inner.second.minus(pin(self.second).foot)
        return arm1.length * arm2.length
