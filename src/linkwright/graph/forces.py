"""Kinetostatics: reactions and drive efforts by d'Alembert's principle, group after group from the far end.

Each link carries the wrench of gravity, inertia and loads. A dyad's inner reaction follows from the freedoms of
its outer joints (two linear equations with the transposed closure matrix); what a link then passes on to the
body that it hangs on is the sum of its wrenches.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import field
from functools import partial, reduce

from linkwright.data_classes import dataclass
from linkwright.elements import Twist
from linkwright.elements.force import Reactions, Resistance
from linkwright.graph.friction import FrictionSystem, Resisting
from linkwright.graph.geometry import ZERO
from linkwright.graph.higher_groups import Beside
from linkwright.graph.load_sharing import shares
from linkwright.graph.motion import Motion
from linkwright.graph.placing import outer_joint
from linkwright.groups.linear import Factor
from linkwright.notation import Body, Pair, Scalar, Wrench
from linkwright.notation.jets import is_zero
from linkwright.structure import FRAME, Connection, Driven, Group, HigherGroup, LinkPlacement, Wedge
from linkwright.symbols import choice

Efforts = dict[str, dict[str, Wrench]]
"""The wrenches of unit efforts, by mover and link."""
Holds = Mapping[str, tuple[dict[str, Wrench], Scalar]]
"""Of followers with a second contact the wrenches of a unit effort there, and its effort for each unit of the pull."""


@dataclass
class Forces:
    """Reactions and efforts. ``reactions[joint, link]`` is the wrench of the link on the joint (N, N m): on the
    pin, or through the line on the other link, stated about the pin, or the second link's point of the line."""

    reactions: dict[tuple[str, str], Wrench] = field(default_factory=dict)
    efforts: dict[str, Scalar] = field(default_factory=dict)
    shaking: Wrench = field(default_factory=lambda: Wrench.zero(ZERO))
    friction: FrictionSystem | None = None
    pushes: Efforts = field(default_factory=dict)

    def reaction(self, joint: str, link: str) -> Wrench:
        """The wrench of a link on a joint; of a follower's contact, whose effort it is, about that."""
        if joint in self.pushes:
            return self.pushes[joint][link].times(-self.efforts[joint])
        return self.reactions[joint, link]


def solve_forces(
    motion: Motion,
    applied: Iterable[tuple[str, Wrench]] = (),
    pushes: Efforts | None = None,
    holds: Holds | None = None,
    resisting: Sequence[Resisting] = (),
) -> Forces:
    """All reactions, drive efforts and the shaking wrench, from motion of order 2 and what is applied to links.

    A drive with an output acts at its own joint, not where the motion is prescribed, and a follower in its contact
    (``pushes``: the wrenches of a unit effort there, by follower): the effort is the one that leaves none to be exerted
    where the motion is prescribed. All forces are linear in it.

    Where a follower would have to pull, its second contact pushes instead, if it has one (``holds``: the wrenches of
    a unit effort there, and its effort for each unit of the pull). Both do the same along the lift, hence the same for
    all efforts; what differs are the reactions. Such an effort is minus the second contact's force.

    What is ``resisting`` follows from the reactions (:mod:`linkwright.graph.friction`), which have to be linear in what
    acts: what comes with the size of a multiplier or of a two-sided contact's effort is then an effort of its own.
    """
    own = {link: own_wrench(motion, link, body) for link, body in motion.bodies.items() if link != FRAME}
    own[FRAME] = Wrench.zero(ZERO)
    for link, wrench in applied:
        own[link] = own[link].plus(wrench)
    if not resisting:
        return _balanced(motion, own, pushes, holds)
    still = {link: Wrench.zero(body.anchor.now) for link, body in motion.bodies.items()}
    means, changing = halved(pushes or {}, holds or {})
    acting = [*resisting, *changing]
    every = [*acting, *separating(motion)]
    alone = [_balanced(motion, _added(still, dict(one.units), 1.0), means, None, Beside.NONE) for one in every]
    system = FrictionSystem.of(every, _balanced(motion, own, means, None, Beside.CONSTANT), alone)
    efforts = system.solved()[: len(acting)]
    for one, effort in zip(acting, efforts, strict=True):
        own = _added(own, dict(one.units), effort)
    forces = _balanced(motion, own, means, None)
    for name, (_, share) in (holds or {}).items():
        effort = forces.efforts[name]
        forces.efforts[name] = choice(effort < 0, share * effort, effort)
    forces.friction, forces.pushes = system, pushes or {}
    return forces


def halved(pushes: Efforts, holds: Holds) -> tuple[Efforts, list[Resisting]]:
    """Efforts of followers as they are where reactions have to be linear in what acts.

    An effort e acts by e w at the first contact, and where it is negative by -e v at the second one, if that exerts v
    for each unit of pull: in all by e (w - v)/2 + |e| (w + v)/2. The first half is linear; the second one does no work,
    and is an effort of the size of the first.
    """
    means, changing = dict(pushes), list[Resisting]()
    for name, (other, share) in holds.items():
        own, links = pushes[name], [*{**pushes[name], **other}]
        pull = {link: wrench.times(share) for link, wrench in other.items()}
        both = [{link: of[link] for link in links if link in of} for of in (own, pull)]
        means[name] = _added(_scaled(both[0], 0.5), both[1], -0.5)
        units = [*_added(_scaled(both[0], 0.5), both[1], 0.5).items()]
        changing.append(Resisting(name, units, Resistance(1.0, 0.0), partial(_effort_of, name, means[name])))
    return means, changing


def _scaled(wrenches: Mapping[str, Wrench], factor: float) -> dict[str, Wrench]:
    return {link: wrench.times(factor) for link, wrench in wrenches.items()}


def _effort_of(name: str, unit: Mapping[str, Wrench], reactions: Reactions) -> list[tuple[Scalar, ...]]:
    """An effort, from what it does to a link: the reaction on its contact is that of minus so many units."""
    link, one = next(iter(unit.items()))
    return [(-_multiple(reactions(name, link), one),)]


def _multiple(found: Wrench, unit: Wrench) -> Scalar:
    """By how much a wrench is a multiple of another."""
    one = unit.at(found.about)
    size = one.force.dot(one.force) + one.moment * one.moment
    return (found.force.dot(one.force) + found.moment * one.moment) / size


def _balanced(
    motion: Motion,
    own: dict[str, Wrench],
    pushes: Efforts | None,
    holds: Holds | None,
    beside: Beside = Beside.ALL,
) -> Forces:
    """All forces under the wrenches of the links."""
    units = unit_efforts(motion) | (pushes or {})
    if not units:
        return _shared(motion, own, beside)
    lacking = _Solver(motion, own, Beside.NONE).run().efforts
    efforts = dict(zip(units, lever(motion, units).solve([-lacking[name] for name in units]), strict=True))
    for name, unit in units.items():
        if holds and name in holds:
            effort, (other, share) = efforts[name], holds[name]
            pulls = effort < 0
            efforts[name] = choice(pulls, share * effort, effort)
            own = _added(own, other, choice(pulls, -efforts[name], 0.0))
            own = _added(own, unit, choice(pulls, 0.0, effort))
        else:
            own = _added(own, unit, efforts[name])
    forces = _shared(motion, own, beside)
    forces.efforts |= efforts
    forces.pushes = pushes or {}
    return forces


def _shared(motion: Motion, own: dict[str, Wrench], beside: Beside) -> Forces:
    """All forces; those of redundant joints as the stiffness has it that the file states, or with nothing in the
    equations that no step keeps, as one of the states that statics allows."""
    forces = _Solver(motion, own, beside).run()
    if not motion.structure.releases or not motion.geometry.mechanism.stiffness:
        return forces
    count = sum(one.rows for one in motion.structure.releases)
    still = {link: Wrench.zero(body.anchor.now) for link, body in motion.bodies.items()}
    units = [[float(i == k) for i in range(count)] for k in range(count)]
    states = [_Solver(motion, still, Beside.NONE, unit).run() for unit in units]
    return _Solver(motion, own, beside, shares(motion, forces, states)).run()


def separating(motion: Motion) -> Iterator[Resisting]:
    """Forces that follow from the size of a closure's multiplier, as of teeth that push gears apart: efforts like those
    of friction, where reactions have to be linear in what acts."""
    for solved in motion.higher_groups.values():
        for c, inner in solved.closures:
            bodies = [motion.bodies[link] for link in c.links]
            at_rest, loaded = (inner.besides(bodies, [size] * c.rows) for size in (0.0, 1.0))
            units = [
                (link, more.plus(less.opposite)) for link, more, less in zip(c.links, loaded, at_rest, strict=False)
            ]
            if c.rows != 1 or all(is_zero(part) for _, unit in units for part in (*unit.force, unit.moment)):
                continue
            unit, law, link = inner.actions(bodies, [1.0])[0], Resistance(1.0, 0.0), c.links[0]

            def seats(
                reactions: Reactions, joint: str = c.joint, link: str = link, unit: Wrench = unit
            ) -> list[tuple[Scalar, ...]]:
                # The multiplier: its unit wrench is known, and reactions are multiples of it where nothing is beside.
                return [(_multiple(reactions(joint, link), unit),)]

            yield Resisting(c.joint, units, law, seats)


def unit_efforts(motion: Motion) -> Efforts:
    """Of each drive with an output, the wrenches of an effort of 1 N m or N at its own joint, by link."""
    found: Efforts = {}
    for name, drive in motion.geometry.mechanism.drives.items():
        if drive.output is None:
            continue
        found[name] = motion.unit(name)
    return found


def lever(motion: Motion, units: Efforts) -> Factor:
    """What each unit effort leaves to be exerted at each output: minus the rates of the drives over their outputs."""
    zero = {link: Wrench.zero(ZERO) for link in motion.bodies}
    answers = [_Solver(motion, zero | unit, Beside.NONE).run().efforts for unit in units.values()]
    return Factor([[answer[name] for answer in answers] for name in units])


def _added(own: dict[str, Wrench], unit: dict[str, Wrench], effort: Scalar) -> dict[str, Wrench]:
    """The links' wrenches with those of an effort."""
    return {link: wrench.plus(unit[link].times(effort)) if link in unit else wrench for link, wrench in own.items()}


class _Solver:
    """One pass through the steps, the last first; ``spare`` are the multipliers of the equations that no step keeps."""

    def __init__(
        self,
        motion: Motion,
        wrenches: dict[str, Wrench],
        beside: Beside = Beside.ALL,
        spare: Sequence[Scalar] | None = None,
    ) -> None:
        self.motion, self.wrenches, self.beside, self.spare = motion, dict(wrenches), beside, spare
        self.forces = Forces()
        self.carried: dict[tuple[str, str], Wrench] = {}

    def run(self) -> Forces:
        self.released()
        for step in reversed(self.motion.structure.steps):
            if isinstance(step, Driven):
                self.drive(step, self.motion.twists[step])
            elif isinstance(step, Group):
                self.group(step)
            elif isinstance(step, Wedge):
                self.wedge(step)
            else:
                self.higher_group(step)
        for (joint, link), wrench in self.carried.items():
            self.react(joint, link, wrench.opposite)
        self.forces.shaking = self.wrenches[FRAME]
        return self.forces

    def released(self) -> None:
        """What the equations that no step keeps do, which are none of the unknowns."""
        structure, bodies = self.motion.structure, self.motion.bodies
        left = None if self.spare is None else list(self.spare)
        for one in structure.releases:
            for link in one.links:
                self.react(one.joint, link, Wrench.zero(bodies[link].anchor.now))
            if left is None:
                continue
            of_links = [bodies[link] for link in one.links]
            inner = one.inner(self.motion.geometry)
            for unit in one.multipliers(self.motion.geometry, of_links):
                times = left.pop(0)
                for link, action in zip(one.links, inner.actions(of_links, unit), strict=True):
                    own = action.times(times)
                    self.react(one.joint, link, own.opposite)
                    self.wrenches[link] = self.wrenches[link].plus(own)

    def drive(self, step: Driven | LinkPlacement, twist: Twist) -> None:
        assert step.drive is not None
        total = self.wrenches[step.link]
        effort = -twist.work(total)
        self.forces.efforts[step.drive] = effort if step.sign > 0 else -effort
        held = total.at(twist.about)
        if twist.turn:
            held = Wrench(held.force, 0.0, held.about)
        else:
            along = Pair(effort * twist.along.x, effort * twist.along.y)
            held = held.plus(Wrench(along, 0.0, twist.about))
        self.hand_on(step.joint, step.link, total, held)

    def group(self, step: Group) -> None:
        dyad, solved = self.motion.dyads[step]
        loads = [reduce(Wrench.plus, (self.wrenches[link] for link in side)) for side in step.sides]
        inner = dyad.balance(solved, *loads)
        for side, chain, outer, own in zip(step.sides, step.chains, step.outer, (inner, inner.opposite), strict=True):
            self.react(step.inner.joint, side[-1], own.opposite)
            self.wrenches[side[-1]] = self.wrenches[side[-1]].plus(own)
            for edge in reversed(chain):
                self.drive(edge, outer_joint(self.motion, edge.joint, edge.link).twist(self.motion.bodies[edge.link]))
            total = self.wrenches[side[0]]
            self.hand_on(outer, side[0], total, total)

    def wedge(self, step: Wedge) -> None:
        end, second = step.links[-1], step.outer[1]
        own = self.motion.wedges[step].balance(reduce(Wrench.plus, (self.wrenches[link] for link in step.links)))
        self.hand_on(second, end, own.opposite, own.opposite)
        self.wrenches[end] = self.wrenches[end].plus(own)
        for edge in reversed(step.chain):
            self.drive(edge, outer_joint(self.motion, edge.joint, edge.link).twist(self.motion.bodies[edge.link]))
        total = self.wrenches[step.link]
        self.hand_on(step.outer[0], step.link, total, total)

    def higher_group(self, step: HigherGroup) -> None:
        solved, bodies = self.motion.higher_groups[step], self.motion.bodies
        balanced = solved.balance({link: self.wrenches[link] for link in step.links}, bodies, self.beside)
        for connection, (actions, multipliers) in zip(step.closures, balanced, strict=True):
            if connection.kind.prescribed:
                (self.forces.efforts[connection.joint],) = multipliers
            for link, own in zip(connection.links, actions, strict=True):
                if not connection.kind.prescribed:
                    self.react(connection.joint, link, own.opposite)
                self.wrenches[link] = self.wrenches[link].plus(own)
        for edge in reversed(step.edges):
            if edge.drive is not None:
                self.drive(edge, solved.twists[edge.link])
            elif not edge.joint.kind.floating:  # closures alone hold a floating link
                total = self.wrenches[edge.link]
                self.hand_on(edge.joint, edge.link, total, total)

    def hand_on(self, connection: Connection, link: str, total: Wrench, held: Wrench) -> None:
        """A link passes its whole wrench to its base; ``held`` is the part that the joint itself transmits."""
        base = connection.other(link)
        self.react(connection.joint, link, held)
        key = (connection.joint, base)
        self.carried[key] = self.carried[key].plus(held) if key in self.carried else held
        self.wrenches[base] = self.wrenches[base].plus(total)

    def react(self, joint: str, link: str, wrench: Wrench) -> None:
        geometry, bodies = self.motion.geometry, self.motion.bodies
        about = self.motion.structure.topology.kind_of(joint).reference(geometry, joint, link, bodies)
        key = (joint, link)
        known = self.forces.reactions.get(key)
        moved = wrench.at(about)
        self.forces.reactions[key] = moved if known is None else known.plus(moved)


def own_wrench(motion: Motion, link: str, body: Body) -> Wrench:
    """Gravity and inertia on a link, about its anchor."""
    geometry = motion.geometry
    wrench = Wrench.zero(body.anchor.now)
    mass, centre, inertia = geometry.mass(link)
    if not (is_zero(mass) and is_zero(inertia)):
        at, g = body.point(centre), geometry.gravity()
        force = Pair(mass * (g.x - at.x.d[2]), mass * (g.y - at.y.d[2]))
        wrench = wrench.plus(Wrench(force, -inertia * body.turn.d[1], at.now))
    return wrench
