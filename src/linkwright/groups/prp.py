"""PRP: two links that slide on known lines and are pinned to each other; two lines meet."""

from __future__ import annotations

from linkwright.elements import InnerPin, OuterLine
from linkwright.groups.dyad import Dyad, Root, line, register
from linkwright.notation import Body, Pair, Scalar


@register
class PRP(Dyad):
    """One assembly mode."""

    signature = "PRP"
    inner: InnerPin

    def root(self, branch: Scalar) -> Root:
        first, second = line(self.first), line(self.second)
        start1, start2 = _start(first, self.inner.first), _start(second, self.inner.second)
        between = start2.minus(start1)
        d1, d2 = first.direction.now, second.direction.now
        cross = d1.cross(d2)
        return Root(between.cross(d2) / cross, between.cross(d1) / cross, 1.0)

    def scale(self, a: Body, b: Body) -> Scalar:
        return 1.0


def _start(slide: OuterLine, local: Pair) -> Pair:
    """Where the inner pin is when the slide's coordinate is zero."""
    offset = local.minus(slide.foot).rotated_back(slide.heading).rotated(slide.direction.now)
    base = slide.base.now
    return Pair(base.x + offset.x, base.y + offset.y)
