"""Four-bars and slider-cranks of a mechanism by type, from their lengths alone (Grashof 1883; Barker 1985)."""

from __future__ import annotations

import math
from collections.abc import Iterator

from linkwright.data_classes import dataclass
from linkwright.elements.cylinder import links_of
from linkwright.graph.geometry import Geometry
from linkwright.kernels import Compiled
from linkwright.structure import FRAME
from linkwright.structure.loops import Loop, loops_of_four
from linkwright.studies.assembly_checks import TOUCH

EQUAL = TOUCH / 10
"""A margin within this share of the lengths' sum is a change point: the reach of its dyads only touches zero there."""


@dataclass(frozen=True)
class FourLinks:
    """A closed loop of four links with its type.

    ``lengths`` (m) belong to ``links`` (of a slider-crank: crank, rod, offset). ``margin`` (m) is s + l - (p + q) of a
    four-bar and r + e - l of a slider-crank with r the shorter one: negative where ``shortest`` turns fully
    against the others, zero (within ``EQUAL``) at a change point. ``fixed`` is the frame, where it is one of the four.
    ``kind`` is a key of the catalogue.
    """

    family: str
    links: tuple[str, ...]
    lengths: tuple[float, ...]
    shortest: str
    fixed: str | None
    kind: str
    margin: float

    @property
    def turning(self) -> tuple[str, ...]:
        """The links that turn fully: the shortest, or where that is the frame its two neighbours.

        At a change point they turn through it, and of two equally short links both do. A driven slide turns none of
        them: it can't move its loop through the dead centres at which it stands.
        """
        if not at_most(self.margin, sum(self.lengths)) or self.kind == "driven-slide":
            return ()
        at = self.links.index(self.fixed or self.shortest)
        beside = self.links[at - 1], self.links[(at + 1) % 4]
        if self.shortest == FRAME:
            return beside
        if self.kind == "change-point" and self.family == "four-bar" and self.fixed:
            return tuple(link for link in beside if self._passes(link, FRAME)) or (self.shortest,)
        return (self.shortest,)

    def _passes(self, link: str, base: str) -> bool:
        """Whether the other two links of a four-bar span all distances of the far ends of these two."""
        size = sum(self.lengths)
        a, b = (self.lengths[self.links.index(name)] for name in (link, base))
        c, d = (self.lengths[i] for i, name in enumerate(self.links) if name not in (link, base))
        return at_most(a + b - (c + d), size) and at_most(abs(c - d) - abs(a - b), size)


def at_most(margin: float, size: float) -> bool:
    """Whether a margin (m) is negative or that of a change point, of links whose lengths add up to ``size`` (m)."""
    return margin <= EQUAL * size


def four_links(compiled: Compiled) -> list[FourLinks]:
    """Every four-bar and slider-crank in a mechanism, in any place of it."""
    return list(_classified(compiled))


def _classified(compiled: Compiled) -> Iterator[FourLinks]:
    geometry = Geometry(compiled.quantities, compiled.quantities.parameters)
    for loop in loops_of_four(compiled.structure.topology):
        if all(loop.turning):
            found = _four_bar(compiled, geometry, loop)
        elif loop.turning.count(False) == 1:
            found = _slider_crank(compiled, geometry, loop.rotated((loop.turning.index(False) + 1) % 4))
        else:
            continue
        if min(found.lengths[: 2 if found.family == "slider-crank" else 4]) > EQUAL * sum(found.lengths):
            yield found


def _length(compiled: Compiled, geometry: Geometry, loop: Loop, i: int) -> float:
    """The distance of a binary link's two pins (m)."""
    pins, link = compiled.structure.topology.pins, loop.links[i]
    a, b = (geometry.point(link, pins[joint.joint].point(link)) for joint in (loop.joints[i - 1], loop.joints[i]))
    return math.hypot(float(a.x - b.x), float(a.y - b.y))


def _four_bar(compiled: Compiled, geometry: Geometry, loop: Loop) -> FourLinks:
    lengths = tuple(_length(compiled, geometry, loop, i) for i in range(4))
    order = sorted(range(4), key=lengths.__getitem__)
    s, p, q, longest = (lengths[i] for i in order)
    margin = (s + longest) - (p + q)
    fixed = FRAME if FRAME in loop.links else None
    if at_most(abs(margin), sum(lengths)):
        kind = "change-point"
    elif fixed is None:
        kind = "grashof" if margin < 0 else "non-grashof"
    elif margin > 0:
        kind = "triple-rocker"
    else:
        away = (order[0] - loop.links.index(FRAME)) % 4
        kind = ("double-crank", "crank-rocker", "double-rocker", "crank-rocker")[away]
    return FourLinks("four-bar", loop.links, lengths, loop.links[order[0]], fixed, kind, margin)


def _slider_crank(compiled: Compiled, geometry: Geometry, loop: Loop) -> FourLinks:
    """A loop begun after its slide, so that its links are a sliding one, two pinned ones, and the other sliding one."""
    if loop.links[0] == FRAME or (
        loop.links[3] != FRAME and loop.links[0] == compiled.mechanism.joints[loop.joints[3].joint].links[0]
    ):  # the guide stands first: the frame, or the first link of the slide
        guide, crank, rod, slider = loop.links
    else:
        slider, rod, crank, guide = loop.links
        loop = Loop((guide, crank, rod, slider), (*loop.joints[2::-1], loop.joints[3]))
    r, l = (_length(compiled, geometry, loop, i) for i in (1, 2))  # noqa: E741
    offset = abs(_across(compiled, geometry, loop, 0, 0) - _across(compiled, geometry, loop, 3, 2))
    margin = min(r, l) + offset - max(r, l)
    shortest = crank if r <= l else rod
    fixed = FRAME if FRAME in loop.links else None
    if FRAME not in (guide, slider) and (inverted := _inverted(compiled, loop)):
        kind = inverted
    elif at_most(abs(margin), r + l + offset):
        kind = "change-point"
    elif fixed is None:
        kind = "slider-chain"
    elif FRAME in (guide, slider):
        kind = "slider-crank"
    else:
        kind = "turning-block" if shortest == FRAME else "rocking-block"
    return FourLinks("slider-crank", loop.links, (r, l, offset), shortest, fixed, kind, margin)


def _inverted(compiled: Compiled, loop: Loop) -> str | None:
    """The kind of a loop whose slide, its last joint, is driven, or belongs to a cylinder on the frame."""
    m, slide = compiled.mechanism, loop.joints[3]
    if any(slide.joint == c.joint for name in m.movers for c in compiled.structure.topology.drivable_joints(name)):
        return "driven-slide"
    cylinder = any({*links_of(name)} == {slide.a, slide.b} for name in m.cylinders)
    return "cylinder" if cylinder and FRAME in loop.links else None


def _across(compiled: Compiled, geometry: Geometry, loop: Loop, link: int, pin: int) -> float:
    """The distance of a sliding link's pin from its line (m), to the left of the line's direction."""
    name, joint = loop.links[link], loop.joints[3].joint
    point, heading = geometry.line(joint, name)
    at = geometry.point(name, compiled.structure.topology.pins[loop.joints[pin].joint].point(name))
    return float(heading.cross(at.minus(point)))
