"""The motion of all links: the structure's steps run in order, on numbers or on symbols alike."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import field
from functools import partial

from linkwright.data_classes import dataclass
from linkwright.elements import Twist
from linkwright.elements.lower_pair import LowerPair
from linkwright.elements.mover import Mover
from linkwright.graph.geometry import Geometry
from linkwright.graph.higher_groups import SolvedHigherGroup, solve_higher_group
from linkwright.graph.placing import driven_body, inner_joint, outer_joint, place_chain
from linkwright.graph.wedges import SolvedWedge, solve_wedge
from linkwright.groups import REGISTRY, Dyad, Solved
from linkwright.groups.dyad import determinant_of
from linkwright.notation import Body, Jet, Pair, Scalar, Wrench
from linkwright.notation.planar import unit_vector
from linkwright.structure import FRAME, Driven, Group, HigherGroup, Step, Structure, Wedge

Branch = Callable[[Group, Dyad], Scalar]
Unknowns = Callable[[HigherGroup], list[Scalar]]


@dataclass
class Motion:
    """Bodies by link, the solved groups, and the freedom of each driven link; with ``nearest``, dyads that can't close
    stay open where they come nearest to it."""

    structure: Structure
    geometry: Geometry
    order: int
    bodies: dict[str, Body] = field(default_factory=dict)
    higher_groups: dict[HigherGroup, SolvedHigherGroup] = field(default_factory=dict)
    dyads: dict[Group, tuple[Dyad, Solved]] = field(default_factory=dict)
    wedges: dict[Wedge, SolvedWedge] = field(default_factory=dict)
    twists: dict[Driven, Twist] = field(default_factory=dict)
    nearest: bool = False

    def dyad(self, label: str) -> tuple[Dyad, Solved]:
        """A solved dyad by its label."""
        return next(found for group, found in self.dyads.items() if group.label == label)

    def higher_group(self, label: str) -> SolvedHigherGroup:
        """A solved higher group by its label."""
        return next(found for higher_group, found in self.higher_groups.items() if higher_group.label == label)

    def determinant(self, label: str) -> Scalar:
        """The margin to singularity of a dyad (its normalised determinant) or higher group."""
        dyads = {group.label: solved.determinant for group, (_, solved) in self.dyads.items()}
        return dyads[label] if label in dyads else self.higher_group(label).margin()

    def point(self, link: str, name: str) -> Pair:
        """Coordinates of a link's point in its frame."""
        return self.geometry.point(link, name)

    def travel(self, joint: str) -> Jet:
        """The distance along a prismatic joint, from the first link's point to the second's."""
        a, b = self.geometry.mechanism.joints[joint].links
        (first, heading), (second, _) = (self.geometry.line(joint, link) for link in (a, b))
        start, end = self.bodies[a].point(first), self.bodies[b].point(second)
        return end.minus(start).dot(self.bodies[a].direction(heading))

    def slide_value(self, drive: Mover, joint: str) -> Jet:
        """The value of a drive that slides along a joint as it follows from the motion."""
        travel = self.travel(joint)
        return travel if drive.link == self.geometry.mechanism.joints[joint].links[1] else -travel

    def track_value(self, drive: Mover) -> Jet:
        """The value of a drive that moves a point along a line as it follows from the motion."""
        return drive.track(self.geometry).travel(self.bodies[drive.link], self.bodies[drive.on])

    def drive_axis(self, drive: Mover) -> Pair:
        """Cosine and sine of the value of a drive that turns as it follows from the motion."""
        return self.bodies[drive.link].axis.now.rotated_back(self.bodies[drive.on].axis.now)

    def unit(self, mover: str) -> dict[str, Wrench]:
        """What an effort of 1 N m or 1 N of a drive or follower would do at its own joint, by link."""
        entry = self.geometry.mechanism.movers[mover]
        if entry.turns:
            wrench = Wrench(Pair(0.0, 0.0), 1.0, Pair(0.0, 0.0))
        elif entry.moves:
            track, on = entry.track(self.geometry), self.bodies[entry.on]
            place = self.bodies[entry.link].point(track.point).now
            wrench = Wrench(on.direction(unit_vector(track.angle)).now, 0.0, place)
        else:
            joint, on = self.structure.topology.acting(mover)[0].joint, self.bodies[entry.on]
            point, heading = self.geometry.line(joint, entry.on)
            wrench = Wrench(on.direction(heading).now, 0.0, on.point(point).now)
        return {entry.link: wrench, entry.on: wrench.opposite}


def solve_motion(
    structure: Structure,
    geometry: Geometry,
    drives: dict[str, Jet],
    branch: Branch,
    unknowns: Unknowns,
    motion: Motion | None = None,
) -> Motion:
    """Run the steps: ``drives`` gives each drive's value and rates, ``branch`` each dyad's assembly branch,
    ``unknowns`` each higher group's coordinates (rad or m).

    A ``motion`` given is filled step by step, so that ``branch`` can look at what is solved so far.
    """
    order = min((jet.order for jet in drives.values()), default=0)
    motion = motion or Motion(structure, geometry, order)
    motion.bodies[FRAME] = Body.fixed(order)
    for step in structure.steps:
        solve_step(motion, step, drives, branch, unknowns)
    return motion


def solve_step(motion: Motion, step: Step, drives: dict[str, Jet], branch: Branch, unknowns: Unknowns) -> None:
    """Run one step of a motion."""
    if isinstance(step, Driven):
        _drive(motion, step, drives[step.drive])
    elif isinstance(step, Group):
        _group(motion, step, drives, branch)
    elif isinstance(step, Wedge):
        solve_wedge(motion, step, drives)
    else:
        solve_higher_group(motion, step, drives, unknowns)


def _drive(motion: Motion, step: Driven, law: Jet) -> None:
    outer, body = driven_body(motion, step, law)
    motion.bodies[step.link] = body
    motion.twists[step] = outer.twist(body)


def known_determinant(motion: Motion, group: Group) -> Scalar:
    """The determinant of a dyad's closure where the poses of its links are known already."""
    first, second = (outer_joint(motion, c, link) for c, link in zip(group.outer, group.ends, strict=True))
    meeting = group.meeting
    a, b = (motion.bodies[link] for link in meeting)
    twists = (joint.twist(motion.bodies[end]) for joint, end in zip((first, second), group.ends, strict=True))
    return determinant_of(_lower_pair(motion, group, meeting).slopes(a, b, *twists))


def _lower_pair(motion: Motion, group: Group, meeting: tuple[str, str]) -> LowerPair:
    """The joint in which the two links of a dyad meet."""
    joint = inner_joint(motion, group.inner, meeting)
    assert isinstance(joint, LowerPair)  # what the dyad's signature says
    return joint


def _group(motion: Motion, step: Group, drives: dict[str, Jet], branch: Branch) -> None:
    first, second = (outer_joint(motion, c, link) for c, link in zip(step.outer, step.ends, strict=True))
    meeting = step.meeting
    joint = _lower_pair(motion, step, meeting)
    sides = list(zip(step.ends, step.chains, strict=True))
    carry_a, carry_b = (partial(place_chain, motion, end, chain, drives) for end, chain in sides)
    frozen = joint.seen_from(carry_a(Body.fixed(0)), carry_b(Body.fixed(0))) if any(step.chains) else joint
    dyad = REGISTRY[step.signature](first, joint, second, (carry_a, carry_b), frozen, motion.nearest)
    solved = dyad.solve(branch(step, dyad), motion.order)
    motion.dyads[step] = dyad, solved
    a, b = solved.first, solved.second
    if step.inner.kind.parallel:
        a, b = _same_angle(motion, step, meeting, a, b), _same_angle(motion, step, meeting[::-1], b, a)
    motion.bodies[meeting[0]], motion.bodies[meeting[1]] = a, b


def _same_angle(motion: Motion, step: Group, links: tuple[str, ...], body: Body, other: Body) -> Body:
    """The body with its angle known exactly where the link that it slides on has a known angle."""
    if body.angle is not None or other.angle is None:
        return body
    link, on = links
    joint = step.inner.joint
    angle = other.angle + motion.geometry.seat(joint, on)[2] - motion.geometry.seat(joint, link)[2]
    return Body(body.anchor, body.local, body.axis, body.turn, angle)
