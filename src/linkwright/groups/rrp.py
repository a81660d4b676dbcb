"""RRP: a link on a pin, pinned to a link that slides on a known line; a circle meets a line."""

from __future__ import annotations

from linkwright.elements import InnerPin
from linkwright.groups.dyad import Dyad, Root, line, pin, pointing, register, root_of
from linkwright.notation import Body, Pair, Scalar
from linkwright.notation.jets import call


@register
class RRP(Dyad):
    """Branch +1: the inner pin is ahead of the outer pin's foot point, along the line's direction."""

    signature = "RRP"
    rules = (("{inner}: ahead of {first} along {second}",), ("{inner}: behind {first} along {second}",))
    inner: InnerPin

    def root(self, branch: Scalar) -> Root:
        hinge, slide = pin(self.first), line(self.second)
        arm = self.inner.first.minus(hinge.foot)
        square = arm.dot(arm)
        d = slide.direction.now
        behind, aside = self._start()
        radicand = square - aside * aside
        ahead = branch * root_of(radicand, square, self.nearest)
        to_pin = Pair(ahead * d.x - aside * d.y, ahead * d.y + aside * d.x)
        return Root(pointing(to_pin, arm), ahead - behind, radicand / square)

    def spanned(self) -> tuple[Scalar, Scalar, Scalar]:
        radius, (_, aside) = self.inner.first.minus(pin(self.first).foot).length, self._start()
        return call("abs", aside), 0.0, radius

    def radicand(self) -> Scalar:
        arm, (_, aside) = self.inner.first.minus(pin(self.first).foot), self._start()
        return arm.dot(arm) - aside * aside

    def _start(self) -> tuple[Scalar, Scalar]:
        """The inner pin at zero travel as seen from the outer pin: along the line's direction and across it."""
        hinge, slide = pin(self.first), line(self.second)
        d = slide.direction.now
        offset = self.inner.second.minus(slide.foot).rotated_back(slide.heading).rotated(d)
        start = slide.base.now.minus(hinge.base.now)
        start = Pair(start.x + offset.x, start.y + offset.y)
        return d.dot(start), d.cross(start)

    def scale(self, a: Body, b: Body) -> Scalar:
        return self.inner.first.minus(pin(self.first).foot).length
