"""The expressions of a mechanism carried to one order of derivatives: every signal, and the rows that kernels need."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import casadi as ca

from linkwright.elements.force import NOUNS
from linkwright.expressions.fields import Expression
from linkwright.expressions.language import Call, Name, Node, evaluate, is_signal, signal_text
from linkwright.expressions.units import Dimension
from linkwright.graph.actions import active, wrenches
from linkwright.graph.cams import Contact, contact
from linkwright.graph.forces import Forces, lever, solve_forces, unit_efforts
from linkwright.graph.geometry import ZERO, Geometry
from linkwright.graph.motion import Motion, solve_motion
from linkwright.graph.poles import pole
from linkwright.graph.seconds import other_side, second
from linkwright.model.signals import Signal
from linkwright.notation import Body, Jet, Scalar, Vec, Wrench
from linkwright.structure import FRAME

if TYPE_CHECKING:
    from linkwright.graph.graph import Graph

LETTERS = {"": 0, "v": 1, "a": 2, "j": 3}
LINK_ORDERS = {"angle": 0, "omega": 1, "alpha": 2, "jerk": 3}
SLIDE_ORDERS = {"s": 0, "v": 1, "a": 2, "j": 3}


@dataclass
class View:
    """The mechanism's expressions carried to one order of derivatives."""

    graph: Graph
    x: Any
    p: Any
    motion: Motion
    laws: dict[str, Jet]
    given: dict[str, Any]  # the inputs of loads and springs
    plays: list[Any]

    @classmethod
    def build(cls, graph: Graph, order: int, inputs: tuple[str, ...], plays: Sequence[str] = ()) -> View:
        symbols = [ca.SX.sym(name) for name in inputs]
        x, first = ca.vertcat(*symbols), len(graph.motion_inputs)
        given, symbols = dict(zip(inputs[first:], symbols[first:], strict=True)), symbols[:first]
        values = [ca.SX.sym(name) for name in graph.parameters]
        width = graph.width
        laws = {drive: Jet(symbols[i * width : i * width + order + 1]) for i, drive in enumerate(graph.drives)}
        branches = dict(zip(graph.branched, symbols[len(graph.drives) * width : graph.first_unknown], strict=True))
        unknowns, rest = {}, symbols[graph.first_unknown :]
        for cluster in graph.structure.clusters:
            unknowns[cluster], rest = rest[: len(cluster.free)], rest[len(cluster.free) :]
        offsets = [ca.SX.sym(name) for name in plays]
        parameters = dict(zip(graph.parameters, values, strict=True))
        geometry = Geometry(graph.quantities, parameters, dict(zip(plays, offsets, strict=True)))
        motion = solve_motion(
            graph.structure, geometry, laws, lambda group, _: branches.get(group, 1.0), unknowns.__getitem__
        )
        return cls(graph, x, ca.vertcat(*values), motion, laws, given, offsets)

    @cached_property
    def forces(self) -> Forces:
        pushes = {name: at.pushes(self.graph.actions.cams[name]) for name, at in self.contacts.items()}
        holds = {
            name: (at.pushes(self.graph.actions.cams[name]), self.contacts[name].reach / at.reach)
            for name, at in self.seconds.items()
        }
        return solve_forces(self.motion, wrenches(self), pushes, holds)

    @cached_property
    def contacts(self) -> dict[str, Contact]:
        """Where the followers of cams touch."""
        cams = self.graph.actions.cams.items()
        return {name: contact(self.motion, drive, self.given[f"ratio/{name}/0"]) for name, drive in cams}

    @cached_property
    def seconds(self) -> dict[str, Contact]:
        """Where those with a second disc or a yoke touch on the other side."""
        found: dict[str, Contact] = {}
        for name, drive in self.graph.actions.cams.items():
            if drive.paired:
                what = second(self.motion.geometry, drive, self.given.get(f"total/{name}", 0.0))
                found[name] = contact(self.motion, other_side(drive), self.given[f"ratio/{name}/0"], what)
        return found

    def row(self, name: str) -> Scalar:
        """The expression of one output row."""
        kind, slash, what = name.partition("/")
        if slash:
            return self._of_action(kind, what)
        owner, colon, what = name.rpartition(":")
        if colon:
            return self._internal(owner, what)
        signal = self.graph.signal(name)
        return _ROWS[signal.kind](self, signal)

    def value(self, expression: Expression, dimension: Dimension) -> Scalar:
        """The value of an expression in parameters, the time, tables and signals."""
        return self.evaluate(self.graph.quantities.bind(expression, dimension))

    def evaluate(self, node: Node) -> Scalar:
        """The same of a tree bound to SI."""

        def named(name: Name) -> Scalar:
            if is_signal(name):
                return self.row(name.text)
            return self.given["t"] if name.text == "t" else self.motion.geometry.parameters[name.text]

        def called(call: Call) -> Scalar:
            return self.row(signal_text(call)) if is_signal(call) else self.lookup(call.name, call.args[0])

        return evaluate(node, named, called)

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

    def inside(self, window: str) -> Scalar:
        """Whether the pose lies in a window."""
        return active(self, window)

    def turns(self, name: str) -> Scalar:
        """The whole turns of an angle beyond those that axes tell."""
        return self.given.get(f"turns/{name}", 0.0)

    def lookup(self, table: str, argument: Node, integral: bool = False) -> Scalar:
        """A table's answer, an input of the pose."""
        known = ((k.table, k.argument, k.integral) for k in self.graph.actions.lookups)
        return self.given[f"table/{list(known).index((table, argument, integral))}/0"]

    def _of_action(self, kind: str, what: str) -> Scalar:
        """Rows of what acts: the sum of a load's values, whether a window holds, the argument that a table
        is asked for, an angle without whole turns."""
        mechanism = self.graph.quantities.mechanism
        if kind == "load":
            one = next(one for one in self.graph.actions.every if one.row == f"load/{what}")
            return one.kind.strength(self, one.name, one.entry)
        if kind == "window":
            return active(self, what)
        if kind == "argument":
            return self.evaluate(self.graph.actions.lookups[int(what)].argument)
        bodies = self.motion.bodies
        if what in self.graph.actions.turned:
            turned, base = self.graph.actions.turned[what][1]
            return bodies[turned].heading - bodies[base].heading
        return self.own(what, 0, whole=False) if what in mechanism.drives else bodies[what].heading

    def _internal(self, owner: str, what: str) -> Scalar:
        if owner in self.motion.bodies and what in ("x", "y", "cos", "sin"):
            body = self.motion.bodies[owner]
            start = body.point(ZERO).now
            return {"cos": body.axis.x.d[0], "sin": body.axis.y.d[0], "x": start.x, "y": start.y}[what]
        if owner == "drives over outputs":
            return lever(self.motion, unit_efforts(self.motion)).determinant()
        if owner in ("span", "room"):
            dyad = next(dyad for group, (dyad, _) in self.motion.dyads.items() if group.label == what)
            found = dyad.span() if owner == "span" else dyad.room()
            return 1.0 if found is None else found
        if owner in ("reach", "determinant"):
            cluster = next((s for c, s in self.motion.clusters.items() if c.label == what), None)
            if cluster is not None:
                return cluster.determinant()
            solved = next(s for group, (_, s) in self.motion.dyads.items() if group.label == what)
            return solved.reach if owner == "reach" else solved.determinant
        kind, _, label = owner.partition(":")
        return self._of_cluster(kind, label, int(what))

    def _of_cluster(self, what: str, label: str, index: int) -> Scalar:
        """Rows of a cluster: what closure i misses, d(closure)/d(coordinate) row by row, coordinate i's rate."""
        solved = next(s for cluster, s in self.motion.clusters.items() if cluster.label == label)
        if what == "slope":
            return solved.slopes[index // len(solved.slopes)][index % len(solved.slopes)]
        return solved.gaps[index] if what == "gap" else solved.rates[index][0]

    def link(self, signal: Signal) -> Scalar:
        body = self.motion.bodies[signal.owners[0]]
        order = LINK_ORDERS[signal.attribute]
        if order:
            return body.turn.d[order - 1]
        turns = self.given.get(f"turns/{signal.owners[0]}")
        angle = body.heading
        return angle if turns is None else angle + 2 * ca.pi * turns

    def acting(self, signal: Signal) -> Scalar:
        one = self.graph.quantities.signals.acting[signal.owners[0]]
        return one.kind.signal(self, one.name, one.entry, signal.attribute)

    def point(self, signal: Signal) -> Scalar:
        link = self.graph.quantities.signals.homes[signal.owners[0]]
        return _component(self.motion.bodies[link].point(self.motion.point(link, signal.owners[0])), signal)

    def com(self, signal: Signal) -> Scalar:
        link = signal.owners[0]
        return _component(self.motion.bodies[link].point(self.motion.geometry.mass(link)[1]), signal)

    def slide(self, signal: Signal) -> Scalar:
        return self.motion.travel(signal.owners[0]).d[SLIDE_ORDERS[signal.attribute]]

    def joint(self, signal: Signal) -> Scalar:
        name = signal.owners[0]
        kind = self.graph.structure.topology.kind_of(name)
        bodies, geometry = self.motion.bodies, self.motion.geometry
        return kind.signal(geometry, name, signal.attribute, bodies, lambda link: self.forces.reactions[name, link])

    def drive(self, signal: Signal) -> Scalar:
        name = signal.owners[0]
        if signal.attribute in ("torque", "force"):
            return self.forces.efforts[name]
        if signal.attribute == "power":
            return self.forces.efforts[name] * self.own(name, 1)
        if signal.attribute == "pressure":
            return self.contacts[name].pressure
        if signal.attribute == "pressure_second":
            return self.seconds[name].pressure
        return self.own(name, {**LINK_ORDERS, **SLIDE_ORDERS}[signal.attribute])

    def own(self, name: str, order: int, whole: bool = True) -> Scalar:
        """A drive's value or a rate of it; of one with an output, as it follows from the motion (rad, ``whole`` turns
        where they are known)."""
        drive = self.motion.geometry.mechanism.drives[name]
        if drive.output is None:
            return self.laws[name].d[order]
        if drive.slides:
            joint = self.graph.structure.topology.acting(name)[0].joint
            return self.motion.moved(drive, joint).d[order]
        link, on = self.motion.bodies[drive.link], self.motion.bodies[drive.on]
        if order:
            return link.turn.d[order - 1] - on.turn.d[order - 1]
        if link.angle is not None and on.angle is not None:
            return link.angle - on.angle
        turned = self.motion.turned(drive)
        raw = ca.atan2(turned.y, turned.x)
        return raw + 2 * ca.pi * self.given.get(f"turns/{name}", 0.0) if whole else raw

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
        return normal if signal.attribute == "normal" else ca.SX(wrench.moment) / normal

    def shaking(self, signal: Signal) -> Scalar:
        wrench: Wrench = self.forces.shaking
        return wrench.moment if signal.attribute == "moment" else getattr(wrench.force, signal.attribute)

    def energy(self, signal: Signal) -> Scalar:
        geometry, total = self.motion.geometry, 0.0
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


def _component(at: Vec, signal: Signal) -> Scalar:
    jet: Jet = getattr(at, signal.attribute[-1])
    return jet.d[LETTERS[signal.attribute[:-1]]]


_KINDS = ("link", "point", "com", "slide", "joint", "drive", "force", "shaking", "energy")
_ROWS: dict[str, Callable[[View, Signal], Scalar]] = {kind: getattr(View, kind) for kind in _KINDS} | {"pole": pole}
_ROWS |= dict.fromkeys(NOUNS.values(), View.acting)
