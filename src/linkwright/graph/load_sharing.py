"""How redundant joints share their load: as the stiffness of joints and links has it that the file states.

Of all reactions in equilibrium, those of linearly elastic joints have the least complementary energy, the sum of
F^2/(2 k) (Castigliano; S. P. Timoshenko, D. H. Young, Theory of Structures, ch. 8). With the reactions
F = F_0 + sum_k s_k F_k, where F_k are those of a unit multiplier of the k-th equation left out, that is the linear
system sum_l (F_k . C F_l) s_l = -F_k . C F_0 of the compliances C. Displacements are small: the motion stays that of
rigid links.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import TYPE_CHECKING

from linkwright.data_classes import dataclass
from linkwright.expressions.units import STIFFNESS, TORSIONAL_STIFFNESS
from linkwright.graph.geometry import Geometry
from linkwright.groups.linear import Factor
from linkwright.model.stiffness import JOINTS, Stiffness
from linkwright.notation import Body, Pair, Scalar, Wrench
from linkwright.structure import Topology

if TYPE_CHECKING:
    from linkwright.graph.forces import Forces
    from linkwright.graph.motion import Motion

Reaction = Callable[[str, str], Wrench]
"""The wrench of a link on a joint, by the joint and the link."""


@dataclass(frozen=True)
class Elastic:
    """Something that yields: its compliance (m/N, of a moment rad/(N m)), and its force or moment by the reactions, as
    components (N, N m)."""

    compliance: Scalar
    force: Callable[[Reaction], Sequence[Scalar]]


def shares(motion: Motion, base: Forces, states: Sequence[Forces]) -> list[Scalar]:
    """The multipliers of the equations left out, from the forces without them and those of a unit of each."""
    every = [*elastic(motion.geometry, motion.structure.topology, motion.bodies.__getitem__)]
    read = [[of.force(_reaction(forces)) for of in every] for forces in (base, *states)]

    def work(a: int, b: int) -> Scalar:
        pairs = zip(every, read[a], read[b], strict=True)
        return sum((of.compliance * x * y for of, xs, ys in pairs for x, y in zip(xs, ys, strict=True)), 0.0)

    count = range(1, len(states) + 1)
    matrix = [[work(k, i) for i in count] for k in count]
    return [-s for s in Factor(matrix).solve([work(k, 0) for k in count])]


def _reaction(forces: Forces) -> Reaction:
    return lambda joint, link: forces.reactions[joint, link]


def elastic(geometry: Geometry, topology: Topology, body: Callable[[str], Body]) -> Iterator[Elastic]:
    """All that yields, of links that lie as ``body`` says."""
    stated = geometry.mechanism.stiffness
    for name in topology.joints:
        if (entry := stated.get(name) or stated.get(JOINTS)) is not None:
            yield from _of_joint(geometry, topology, body, name, entry)
    for name, entry in stated.items():
        if name in topology.mechanism.links and name not in topology.joints:
            yield _of_link(geometry, topology, body, name, entry)


def _compliance(geometry: Geometry, entry: Stiffness) -> Scalar:
    return 1.0 if entry.value is None else 1.0 / geometry.number(entry.value, STIFFNESS)


def _of_joint(
    geometry: Geometry, topology: Topology, body: Callable[[str], Body], name: str, entry: Stiffness
) -> Iterator[Elastic]:
    """A pin or contact yields alike in all directions, of more than two links at each of them; a slide across, and
    where a stiffness is stated for that in tilting."""
    kind, links = topology.joints[name]
    if not kind.parallel:
        for link in links if len(links) > 2 else links[:1]:
            yield Elastic(_compliance(geometry, entry), partial(_force, name, link))
        return
    first = links[0]
    normal = body(first).direction(geometry.line(name, first)[1]).perp.now
    yield Elastic(_compliance(geometry, entry), lambda of: [normal.dot(of(name, first).force)])
    if entry.tilt is not None:
        tilting = 1.0 / geometry.number(entry.tilt, TORSIONAL_STIFFNESS)
        yield Elastic(tilting, lambda of: [of(name, first).moment])


def _force(joint: str, link: str, of: Reaction) -> list[Scalar]:
    return [*of(joint, link).force]


def _of_link(
    geometry: Geometry, topology: Topology, body: Callable[[str], Body], link: str, entry: Stiffness
) -> Elastic:
    """A link on two pins yields along the line of both: to the mean of the forces at its ends."""
    ends = [pin for pin in topology.pins.values() if link in pin.links]
    first, second = (body(link).point(geometry.pin_point(pin.name, link)).now for pin in ends)
    away = second.minus(first)
    along = Pair(away.x / away.length, away.y / away.length)

    def pull(of: Reaction) -> list[Scalar]:
        one, other = (of(pin.name, link).force for pin in ends)
        return [(along.dot(one) - along.dot(other)) / 2.0]

    return Elastic(_compliance(geometry, entry), pull)
