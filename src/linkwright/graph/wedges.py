"""Links on two slides whose direction is known, as in a wedge drive: one travel, one equation.

The link keeps its direction to all links of its loop of slides, so that the second slide only says where it is across
that slide's line. Motion and forces along the slides follow; how the loop's slides share moments does not.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from linkwright.data_classes import dataclass
from linkwright.elements import InnerLine, OuterLine, Twist
from linkwright.graph.placing import inner_joint, outer_joint, place_chain
from linkwright.notation import Jet, Pair, Scalar, Wrench
from linkwright.structure import Wedge

if TYPE_CHECKING:
    from linkwright.graph.motion import Motion

PARALLEL = 1e-9
"""Lines at a smaller angle (its sine) count as parallel."""


class Parallel(ZeroDivisionError):
    """The two lines are parallel, on plain numbers."""

    def __init__(self, wedge: Wedge) -> None:
        super().__init__()
        self.wedge = wedge


@dataclass(frozen=True)
class SolvedWedge:
    """A solved link on two slides: the freedom that the first slide leaves it, the second one's ``normal`` and a point
    on its line (m), and the sine of the angle between the two lines."""

    twist: Twist
    normal: Pair
    point: Pair
    sine: Scalar

    def balance(self, wrench: Wrench) -> Wrench:
        """The second slide's force on the link that keeps it in equilibrium along the first slide (N).

        ``wrench`` is all else that acts on the link but the first slide's reaction. No moment is stated: any couple
        around the loop of slides is as good.
        """
        force = -self.twist.work(wrench) / self.sine
        return Wrench(Pair(force * self.normal.x, force * self.normal.y), 0.0, self.point)


def solve_wedge(motion: Motion, step: Wedge, drives: dict[str, Jet]) -> None:
    """Place the link and those that drives hold on it with all rates. The travel is linear in its equation."""
    first = outer_joint(motion, step.outer[0], step.link)
    base, end = step.bases[1], step.links[-1]
    second = inner_joint(motion, step.outer[1], (base, end))
    assert isinstance(first, OuterLine)
    assert isinstance(second, InnerLine)
    on = motion.bodies[base]
    line = on.direction(second.first_heading).now
    sine = first.direction.now.dot(line.perp)
    if isinstance(sine, float) and not abs(sine) > PARALLEL:
        raise Parallel(step)

    def miss(rates: list[Scalar]) -> Scalar:
        """What the second slide's equation misses, at its highest rate."""
        body = place_chain(motion, step.link, step.chain, drives, first.place(rates[0], Jet(rates[1:])))
        return second.gap(on, body)[1].d[len(rates) - 1]

    rates: list[Scalar] = []
    for _ in range(motion.order + 1):
        rates.append(-miss([*rates, 0.0]) / sine)
    miss(rates)
    body = motion.bodies[end]
    twist = first.twist(motion.bodies[step.link])
    motion.wedges[step] = SolvedWedge(twist, line.perp, body.point(second.second).now, sine)
