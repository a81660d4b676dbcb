"""A mechanism's expressions carried to one order of derivatives: what rows are made of, and every signal."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, TypeVar

from linkwright.data_classes import dataclass
from linkwright.elements.entries import NOUNS
from linkwright.elements.follower import UnitEffort
from linkwright.elements.touch import Touch
from linkwright.expressions.fields import Expression
from linkwright.expressions.language import Call, Name, Node, evaluate, is_signal, signal_text
from linkwright.expressions.units import Dimension
from linkwright.graph.actions import active, given_wrenches
from linkwright.graph.creeping import creeping_rates
from linkwright.graph.derivative_orders import DRIVE_ORDERS, LETTERS, LINK_ORDERS, SLIDE_ORDERS
from linkwright.graph.forces import Forces, solve_forces
from linkwright.graph.friction import Resisting
from linkwright.graph.geometry import Geometry
from linkwright.graph.motion import Motion, solve_motion
from linkwright.graph.placing import answered
from linkwright.graph.power import dissipated, supplied, totals
from linkwright.graph.singular_orders import pole
from linkwright.model.signals import BREAKAWAY, POWER, Signal
from linkwright.notation import Body, Jet, Pair, Scalar, Vec, Wrench
from linkwright.notation.jets import call
from linkwright.structure import FRAME
from linkwright.symbols import Symbol, as_symbol, substituted

if TYPE_CHECKING:
    from linkwright.graph.graph import Graph
    from linkwright.graph.rows import Named

Made = TypeVar("Made")


@dataclass
class View:
    """The mechanism's expressions carried to one order of derivatives."""

    graph: Graph
    x: list[Symbol]
    p: list[Symbol]
    motion: Motion
    laws: dict[str, Jet]
    given: dict[str, Any]  # the inputs of acting elements and followers
    plays: list[Symbol]
    starting: bool = False  # whether all resists as where motion is about to start
    _shared: dict[tuple[str, tuple[str, ...]], Any] = field(default_factory=dict)  # by kind and owners of signals

    @classmethod
    def build(
        cls,
        graph: Graph,
        order: int,
        inputs: tuple[str, ...],
        plays: Sequence[str] = (),
        nearest: bool = False,
        starting: bool = False,
    ) -> View:
        symbols = [Symbol.named(name) for name in inputs]
        x, first = symbols, len(graph.motion_inputs)
        given, symbols = dict(zip(inputs[first:], symbols[first:], strict=True)), symbols[:first]
        values = [Symbol.named(name) for name in graph.parameters]
        width = graph.width
        laws = {drive: Jet(symbols[i * width : i * width + order + 1]) for i, drive in enumerate(graph.drives)}
        branches = dict(zip(graph.branched, symbols[len(graph.drives) * width : graph.first_unknown], strict=True))
        unknowns, rest = {}, symbols[graph.first_unknown :]
        for higher_group in graph.structure.higher_groups:
            unknowns[higher_group], rest = rest[: len(higher_group.free)], rest[len(higher_group.free) :]
        offsets = [Symbol.named(name) for name in plays]
        parameters = dict(zip(graph.parameters, values, strict=True))
        geometry = Geometry(graph.quantities, parameters, dict(zip(plays, offsets, strict=True)))
        motion = solve_motion(
            graph.structure,
            geometry,
            laws,
            lambda group, _: branches.get(group, 1.0),
            unknowns.__getitem__,
            Motion(graph.structure, geometry, order, nearest=nearest),
        )
        return cls(graph, x, values, motion, laws, given, offsets, starting)

    @cached_property
    def forces(self) -> Forces:
        pushes = {name: dict(at.wrenches) for name, at in self.contacts.items()}
        holds = {name: (dict(at.wrenches), self.contacts[name].reach / at.reach) for name, at in self.seconds.items()}
        every = self.graph.actions.resisting
        resisting = [Resisting.of(self, one.at_start if self.starting else one) for one in every]
        return solve_forces(self.motion, given_wrenches(self), pushes, holds, resisting)

    @cached_property
    def contacts(self) -> dict[str, UnitEffort]:
        """How the followers' efforts act."""
        followers = self.graph.actions.followers.items()
        return {name: one.acting(name, self.motion, self.given[f"ratio/{name}/0"]) for name, one in followers}

    @cached_property
    def seconds(self) -> dict[str, UnitEffort]:
        """How those act that touch on the other side too."""
        found: dict[str, UnitEffort] = {}
        for name, follower in self.graph.actions.followers.items():
            ratio, total = self.given[f"ratio/{name}/0"], self.given.get(f"total/{name}", 0.0)
            if (other := follower.second(name, self.motion, ratio, total)) is not None:
                found[name] = other
        return found

    @cached_property
    def _starting(self) -> View:
        """The same where motion is about to start, with inputs of its own."""
        plays = [play.name for play in self.plays]
        return View.build(self.graph, self.graph.actions.forces, self.graph.inputs, plays, starting=True)

    def breakaway(self, drive: str, sense: int, friction: bool = True) -> Scalar:
        """The effort (N m or N) at which a drive starts the motion from rest, towards larger values or (``sense`` -1)
        smaller ones; without ``friction`` the one that holds the pose.

        All creeps in the sense of the drive, so slowly that speeds tell directions alone and no inertia is left."""
        still, forces = self._starting, self._starting.forces
        assert forces.friction is not None
        effort = forces.efforts[drive] if friction else forces.friction.drives[drive]
        rows = creeping_rates(self.graph, drive, sense, lambda i: self.x[i])
        x = [as_symbol(rows.get(i, symbol)) for i, symbol in enumerate(self.x)]
        before, after = [*still.x, *still.p, *still.plays], [*x, *self.p, *self.plays]
        return substituted([as_symbol(effort)], dict(zip(before, after, strict=True)))[0]

    def row(self, named: Named) -> Scalar:
        """The expression of one output row."""
        return self.graph.row(named).expression(self)

    def expression(self, signal: Signal) -> Scalar:
        """The expression of a signal."""
        return _SIGNALS[signal.kind](self, signal)

    def value(self, expression: Expression, dimension: Dimension) -> Scalar:
        """The value of an expression in parameters, the time, tables and signals."""
        return self.evaluate(self.graph.quantities.bind(expression, dimension))

    def evaluate(self, node: Node) -> Scalar:
        """The same of a tree bound to SI."""

        def name_value(name: Name) -> Scalar:
            if is_signal(name):
                return self.row(name.text)
            return self.given["t"] if name.text == "t" else self.motion.geometry.parameters[name.text]

        def call_value(call: Call) -> Scalar:
            return self.row(signal_text(call)) if is_signal(call) else self.lookup(call.name, call.args[0])

        return evaluate(node, name_value, call_value)

    # What kinds of force elements ask for.

    @property
    def geometry(self) -> Geometry:
        """The dimensions of the mechanism."""
        return self.motion.geometry

    @property
    def bodies(self) -> Mapping[str, Body]:
        """The links by name."""
        return self.motion.bodies

    def signal(self, text: str) -> Scalar:
        """A signal by its name."""
        return self.row(text)

    def reaction(self, joint: str, link: str) -> Wrench:
        """The wrench of a link on a joint."""
        return self.forces.reaction(joint, link)

    def touch(self, joint: str) -> Touch:
        """Where the links of a contact touch."""
        follower = self.graph.actions.followers.get(joint)
        if follower is not None:
            return follower.touch(joint, self.motion, self.contacts[joint])
        return self.graph.structure.topology.kind_of(joint).touch(self.geometry, joint, self.bodies)

    def effort(self, name: str) -> Scalar:
        """The effort of what follows from reactions."""
        assert self.forces.friction is not None
        return self.forces.friction.efforts[name]

    def inside(self, window: str) -> Scalar:
        """Whether the pose lies in a window."""
        return active(self, window)

    def turns(self, name: str) -> Scalar:
        """The whole turns of an angle beyond those that axes tell."""
        return self.given.get(f"turns/{name}", 0.0)

    def lookup(self, table: str, argument: Node, integral: bool = False) -> Scalar:
        """A table's answer, an input of the pose."""
        known = [(k.table, k.argument, k.integral) for k in self.graph.actions.lookups]
        asked = self.graph.actions.at_rest(argument) if self.starting else argument
        return self.given[f"table/{known.index((table, asked, integral))}/0"]

    def link(self, signal: Signal) -> Scalar:
        body = self.motion.bodies[signal.owners[0]]
        order = LINK_ORDERS[signal.attribute]
        if order:
            return body.turn.d[order - 1]
        turns = self.given.get(f"turns/{signal.owners[0]}")
        angle = body.heading
        return angle if turns is None else angle + 2 * math.pi * turns

    def acting(self, signal: Signal) -> Scalar:
        one = self.graph.quantities.signals.acting[signal.owners[0]]
        return one.kind.signal(self, one.name, one.entry, signal.attribute)

    def point(self, signal: Signal) -> Scalar:
        link = self.graph.quantities.signals.links_of_points[signal.owners[0]]
        return self._component(signal, link, self.motion.point(link, signal.owners[0]))

    def com(self, signal: Signal) -> Scalar:
        link = signal.owners[0]
        return self._component(signal, link, self.motion.geometry.mass(link)[1])

    def _component(self, signal: Signal, link: str, local: Pair) -> Scalar:
        """What a signal names of a place on a link."""
        at: Vec = self.shared(signal, lambda: self.motion.bodies[link].point(local))
        jet: Jet = getattr(at, signal.attribute[-1])
        return jet.d[LETTERS[signal.attribute[:-1]]]

    def shared(self, signal: Signal, make: Callable[[], Made]) -> Made:
        """What all signals of the same owners are parts of, made once."""
        key = (signal.kind, signal.owners)
        if key not in self._shared:
            self._shared[key] = make()
        made: Made = self._shared[key]
        return made

    def slide(self, signal: Signal) -> Scalar:
        return self.motion.travel(signal.owners[0]).d[SLIDE_ORDERS[signal.attribute]]

    def joint(self, signal: Signal) -> Scalar:
        name = signal.owners[0]
        kind = self.graph.structure.topology.kind_of(name)

        def reaction(link: str) -> Wrench:
            return self.forces.reactions[name, link]

        def signal_value(bodies: Mapping[str, Body]) -> Scalar:
            return kind.signal(self.geometry, name, signal.attribute, bodies, reaction)

        return answered(kind, name, self.bodies, signal_value)

    def drive(self, signal: Signal) -> Scalar:
        name = signal.owners[0]
        follower = self.graph.actions.followers.get(name)
        if follower is not None and signal.attribute in follower.extra:
            acting = self.contacts[name] if signal.attribute in self.contacts[name].signals else self.seconds[name]
            return acting.signals[signal.attribute]
        if (order := DRIVE_ORDERS.get(signal.attribute)) is not None:
            return self.drive_value(name, order)
        if signal.attribute in BREAKAWAY:
            return self.breakaway(name, BREAKAWAY[signal.attribute])
        effort = self.forces.efforts[name]
        return effort * self.drive_value(name, 1) if signal.attribute == "power" else effort

    def drive_value(self, name: str, order: int, whole: bool = True) -> Scalar:
        """A drive's value or a rate of it; of one with an output, as it follows from the motion (rad, ``whole`` turns
        where they are known)."""
        drive = self.motion.geometry.mechanism.movers[name]
        if drive.output is None:
            return self.laws[name].d[order]
        if drive.slides:
            joint = self.graph.structure.topology.acting(name)[0].joint
            return self.motion.slide_value(drive, joint).d[order]
        if drive.moves:
            return self.motion.track_value(drive).d[order]
        link, on = self.motion.bodies[drive.link], self.motion.bodies[drive.on]
        if order:
            return link.turn.d[order - 1] - on.turn.d[order - 1]
        if link.angle is not None and on.angle is not None:
            return link.angle - on.angle
        turned = self.motion.drive_axis(drive)
        raw = call("arctan2", turned.y, turned.x)
        return raw + 2 * math.pi * self.given.get(f"turns/{name}", 0.0) if whole else raw

    def force(self, signal: Signal) -> Scalar:
        contact = self.graph.quantities.signals.contact(signal.owners)
        wrench = self.forces.reactions[contact.joint, contact.link]
        if signal.attribute in ("x", "y"):
            return getattr(wrench.force, signal.attribute)
        if signal.attribute == "moment":
            return wrench.moment
        first = self.motion.geometry.mechanism.joints[contact.joint].links[0]
        heading = self.motion.geometry.line(contact.joint, first)[1]
        normal = self.motion.bodies[first].direction(heading).perp.now.dot(wrench.force)
        return normal if signal.attribute == "normal" else as_symbol(wrench.moment) / normal

    def power(self, signal: Signal) -> Scalar:
        (one,) = self.graph.quantities.signals.powered[signal.owners[0]]
        if one is None:
            return self.row(f"{signal.owners[0]}.power")
        return (supplied if signal.attribute == "supplied" else dissipated)(self, one)

    def shaking(self, signal: Signal) -> Scalar:
        wrench: Wrench = self.forces.shaking
        return wrench.moment if signal.attribute == "moment" else getattr(wrench.force, signal.attribute)

    def energy(self, signal: Signal) -> Scalar:
        geometry, total = self.motion.geometry, 0.0
        if signal.attribute in POWER:
            return totals(self, signal.attribute)
        if signal.attribute == "stored":
            every = self.graph.quantities.signals.energies
            return sum((self.energy(replace(signal, attribute=part)) for part in every), 0.0)
        if signal.attribute == "elastic":
            stored = (one for one in self.graph.actions.every if one.kind.stores)
            return sum((one.kind.energy(self, one.name, one.entry) for one in stored), 0.0)
        for link, body in self.motion.bodies.items():
            mass, centre, inertia = geometry.mass(link)
            if link == FRAME or not geometry.mechanism.has_mass(link):
                continue
            at = body.point(centre)
            if signal.attribute == "kinetic":
                speed = at.x.d[1] * at.x.d[1] + at.y.d[1] * at.y.d[1]
                total = total + 0.5 * (mass * speed + inertia * body.turn.d[0] * body.turn.d[0])
            else:
                g = geometry.gravity()
                total = total - mass * (g.x * at.x.d[0] + g.y * at.y.d[0])
        return total


_KINDS = ("link", "point", "com", "slide", "joint", "drive", "force", "shaking", "energy", "power")
_SIGNALS: dict[str, Callable[[View, Signal], Scalar]] = {kind: getattr(View, kind) for kind in _KINDS} | {"pole": pole}
_SIGNALS |= dict.fromkeys(NOUNS.values(), View.acting)
