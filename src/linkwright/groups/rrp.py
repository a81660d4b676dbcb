"""RRP: a link on a pin, pinned to a link that slides on a known line; a circle meets a line."""

from __future__ import annotations

from linkwright.groups.dyad import Dyad, Root, length, line, pin, pointing, register
from linkwright.groups.joints import InnerPin
from linkwright.notation import Body, Pair, Scalar
from linkwright.notation.jets import call


@register
class RRP(Dyad):
    """Branch +1: the inner pin is ahead of the outer pin's foot point, along the line's direction."""

    signature = "RRP"
    modes = 2
    inner: InnerPin

    def root(self, branch: Scalar) -> Root:
        hinge, slide = pin(self.first), line(self.second)
        arm = self.inner.first.minus(hinge.foot)
        square = arm.dot(arm)
        d = slide.direction.now
        # The inner pin travels on a line parallel to the slide's: its place at zero travel, seen from the hinge.
        offset = self.inner.second.minus(slide.foot).turned_back(slide.heading).turned(d)
        start = slide.base.now.minus(hinge.base.now)
        start = Pair(start.x + offset.x, start.y + offset.y)
        behind, aside = d.dot(start), d.cross(start)
        radicand = square - aside * aside
        ahead = branch * call("sqrt", radicand)
        to_pin = Pair(ahead * d.x - aside * d.y, ahead * d.y + aside * d.x)
        return Root(pointing(to_pin, arm), ahead - behind, radicand / square)

    def scale(self, a: Body, b: Body) -> Scalar:
        return length(self.inner.first.minus(pin(self.first).foot))
