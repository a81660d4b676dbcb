"""RPP: a link on a known pin slides along a link that slides on a known line (the paper feeder's slider)."""

from __future__ import annotations

from linkwright.elements import InnerLine
from linkwright.groups.dyad import Dyad, Root, line, pin, register
from linkwright.notation import Body, Pair, Scalar


@register
class RPP(Dyad):
    """One assembly mode: the second link's angle is known, so the first one's is too."""

    signature = "RPP"
    inner: InnerLine

    def root(self, branch: Scalar) -> Root:
        hinge, slide = pin(self.first), line(self.second)
        axis2 = slide.direction.now.rotated_back(slide.heading)
        heading = self.inner.second_heading.rotated(axis2)
        axis1 = heading.rotated_back(self.inner.first_heading)
        arm1 = self.inner.first.minus(hinge.foot).rotated(axis1)
        arm2 = self.inner.second.minus(slide.foot).rotated(axis2)
        start = slide.base.now.minus(hinge.base.now)
        # Distance across the inner line, from the first link's point to the second's, at zero travel.
        across = heading.cross(Pair(start.x + arm2.x - arm1.x, start.y + arm2.y - arm1.y))
        return Root(axis1, -across / heading.cross(slide.direction.now), 1.0)

    def scale(self, a: Body, b: Body) -> Scalar:
        return 1.0
