"""A mechanism as one program: its groups run on symbols give every signal as an expression.

Inputs per pose are the drives' values and rates and the groups' branches; the parameters are inputs common to
all poses. Signals are made when they are asked for.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import casadi as ca

from linkwright.graph.actions import Actions, active, load_values, wrenches
from linkwright.graph.forces import Forces, lever, solve_forces, unit_efforts
from linkwright.graph.geometry import ZERO, Geometry, widest
from linkwright.graph.motion import Motion, solve_motion
from linkwright.graph.program import ExpressionStage, Program
from linkwright.graph.springs import effort, elastic, raw_angle, stretch
from linkwright.model.expressions import Call, Name, Node, evaluate, is_signal, parse, signal_text
from linkwright.model.fields import Expression
from linkwright.model.quantities import Quantities
from linkwright.model.signals import Signal
from linkwright.model.units import Dimension
from linkwright.notation import MAX_ORDER, Jet, Pair, Scalar, Vec, Wrench
from linkwright.structure import FRAME, Cluster, Structure

_LETTERS = {"": 0, "v": 1, "a": 2, "j": 3}
_LINK_ORDERS = {"angle": 0, "omega": 1, "alpha": 2, "jerk": 3}
_SLIDE_ORDERS = {"s": 0, "v": 1, "a": 2, "j": 3}
INFINITE = 1e9
"""Beyond so many times the mechanism's size an instant centre lies at infinity."""
ROUND_OFF = 1e-13
"""A turning of two links against each other below this share of their motion is none."""


@dataclass
class Graph:
    """The symbolic mechanism. ``inputs`` names the rows of the per-pose input in order."""

    quantities: Quantities
    structure: Structure
    _views: dict[int, View] = field(default_factory=dict)
    _programs: dict[tuple[tuple[str, ...], bool], Program] = field(default_factory=dict)

    @cached_property
    def drives(self) -> tuple[str, ...]:
        """The drives in the order of their inputs."""
        return tuple(self.structure.topology.mechanism.drives)

    @cached_property
    def branched(self) -> tuple[Any, ...]:
        """The groups with two assembly modes, in the order of their branch inputs."""
        return tuple(group for group in self.structure.groups if group.modes > 1)

    @cached_property
    def actions(self) -> Actions:
        """The loads and springs."""
        return Actions(self)

    @cached_property
    def inputs(self) -> tuple[str, ...]:
        """Rows of the per-pose input: those of the motion, then what loads and springs need besides."""
        return (*self.motion_inputs, *self.actions.inputs)

    @cached_property
    def motion_inputs(self) -> tuple[str, ...]:
        """Rows of the motion: each drive's value and rates up to one past jerk, the branches, and the
        coordinates of the clusters, which Newton supplies."""
        rows = [f"{drive}:{k}" for drive in self.drives for k in range(MAX_ORDER + 2)]
        rows += [f"branch:{group.label}" for group in self.branched]
        return (*rows, *(f"u:{c.label}:{i}" for c in self.structure.clusters for i in range(len(c.free))))

    @cached_property
    def first_unknown(self) -> int:
        """The first input row that Newton supplies."""
        return len(self.drives) * (MAX_ORDER + 2) + len(self.branched)

    @cached_property
    def pose_rows(self) -> tuple[str, ...]:
        """The output rows of all moving links' poses: place of the origin (m), cosine and sine, link by link."""
        links = self.structure.topology.moving
        return tuple(f"{link}:{row}" for link in links for row in ("x", "y", "cos", "sin"))

    def coordinates(self, cluster: Cluster) -> list[int]:
        """The input rows of a cluster's coordinates."""
        return [self.inputs.index(f"u:{cluster.label}:{i}") for i in range(len(cluster.free))]

    def closure(self, cluster: Cluster) -> list[str]:
        """The output rows of a cluster's closures: what each misses, then its slopes to each coordinate."""
        n, label = len(cluster.free), cluster.label
        return [f"gap:{label}:{i}" for i in range(n)] + [f"slope:{label}:{i}" for i in range(n * n)]

    @cached_property
    def parameters(self) -> tuple[str, ...]:
        """The parameters, in the order of the parameter input."""
        return tuple(self.quantities.parameters)

    def signal(self, text: str) -> Signal:
        """The signal of a name. Raises DimensionError for a name that isn't one."""
        node = parse(text)
        assert isinstance(node, Name | Call)
        return self.quantities.signals.find(node)

    def program(self, names: Sequence[str], rates: bool = False) -> Program:
        """The program of the named signals; with ``rates``, each followed by its time derivative.

        Names are signals, or the internal rows ``reach:GROUP``, ``determinant:GROUP``, ``LINK:cos``, ``LINK:sin``,
        ``load/NAME``, ``window/NAME``, ``argument/NUMBER``, ``raw/NAME``.
        """
        key = (tuple(names), rates)
        if key not in self._programs:
            self._programs[key] = self._build(*key)
        return self._programs[key]

    def _build(self, names: tuple[str, ...], rates: bool) -> Program:
        order = max((self.order_of(name) for name in names), default=0)
        view = self._view(max(order, 1) if rates and self.structure.clusters else order)
        rows = [ca.SX(view.row(name)) for name in names]
        if rates:
            slopes = ca.jtimes(ca.vertcat(*rows), view.x, self._flow(view))
            rows = [part for i, row in enumerate(rows) for part in (row, slopes[i])]
        stage = ExpressionStage.from_rows(view.x, view.p, rows)
        outputs = tuple(part for name in names for part in ((name, f"d({name})") if rates else (name,)))
        return Program((stage,), self.inputs, self.parameters, outputs)

    def _flow(self, view: View) -> Any:
        """The rate of change of the inputs in time."""
        flow = []
        for i in range(len(self.drives)):
            rows = range(i * (MAX_ORDER + 2), (i + 1) * (MAX_ORDER + 2))
            flow += [view.x[k + 1] for k in rows[:-1]] + [ca.SX(0)]
        flow += [ca.SX(0)] * len(self.branched)
        solved = (view.motion.clusters[c] for c in self.structure.clusters)
        flow += [rates[0] for cluster in solved for rates in cluster.rates]
        return ca.vertcat(*flow, *self.actions.flow(view.given))

    @cached_property
    def size(self) -> float:
        """The largest distance (m) of two points of one link, at the parameters' nominal values."""
        geometry = Geometry(self.quantities, self.quantities.parameters)
        links = geometry.mechanism.links.items()
        return widest([geometry.point(link, name) for name in entry.points] for link, entry in links)

    def wraps(self, owner: str) -> bool:
        """Whether the angle of a link or drive comes from axes alone, so that it jumps by a turn now and then."""
        drive, bodies = self.structure.topology.mechanism.drives.get(owner), self._bare.motion.bodies
        if drive is None:
            return bodies[owner].angle is None
        return drive.output is not None and None in (bodies[drive.link].angle, bodies[drive.on].angle)

    def wrapped(self, name: str) -> bool:
        """Whether a signal is an angle that jumps so."""
        owner, _, attribute = name.partition(".")
        mechanism = self.structure.topology.mechanism
        return attribute == "angle" and (owner in mechanism.links or owner in mechanism.drives) and self.wraps(owner)

    @cached_property
    def _bare(self) -> View:
        """The motion alone, to order 0."""
        return View.build(self, 0, self.motion_inputs)

    def order_of(self, name: str) -> int:
        """The order of derivatives that a row needs."""
        if "/" in name:
            return 0 if name.startswith("raw/") else self.actions.order
        if ":" in name:
            return 1 if name.startswith("rate:") else 0
        signal = self.signal(name)
        if signal.kind in ("force", "shaking") or signal.attribute in ("torque", "force", "power"):
            return max(2, self.actions.order) if signal.kind != "spring" else 1
        if signal.kind in ("energy", "pole"):
            return 1
        if signal.kind == "spring":
            return int(signal.attribute in ("v", "omega"))
        orders = {"link": _LINK_ORDERS, "drive": {**_LINK_ORDERS, **_SLIDE_ORDERS}, "slide": _SLIDE_ORDERS}
        known = orders.get(signal.kind)
        return known[signal.attribute] if known else _LETTERS[signal.attribute[:-1]]

    def _view(self, order: int) -> View:
        if order not in self._views:
            self._views[order] = View.build(self, order, self.inputs)
        return self._views[order]


@dataclass
class View:
    """The mechanism's expressions carried to one order of derivatives."""

    graph: Graph
    x: Any
    p: Any
    motion: Motion
    laws: dict[str, Jet]
    given: dict[str, Any]  # the inputs of loads and springs

    @classmethod
    def build(cls, graph: Graph, order: int, inputs: tuple[str, ...]) -> View:
        symbols = [ca.SX.sym(name) for name in inputs]
        x, first = ca.vertcat(*symbols), len(graph.motion_inputs)
        given, symbols = dict(zip(inputs[first:], symbols[first:], strict=True)), symbols[:first]
        values = [ca.SX.sym(name) for name in graph.parameters]
        width = MAX_ORDER + 2
        laws = {drive: Jet(symbols[i * width : i * width + order + 1]) for i, drive in enumerate(graph.drives)}
        branches = dict(zip(graph.branched, symbols[len(graph.drives) * width : graph.first_unknown], strict=True))
        unknowns, rest = {}, symbols[graph.first_unknown :]
        for cluster in graph.structure.clusters:
            unknowns[cluster], rest = rest[: len(cluster.free)], rest[len(cluster.free) :]
        geometry = Geometry(graph.quantities, dict(zip(graph.parameters, values, strict=True)))
        motion = solve_motion(
            graph.structure, geometry, laws, lambda group, _: branches.get(group, 1.0), unknowns.__getitem__
        )
        return cls(graph, x, ca.vertcat(*values), motion, laws, given)

    @cached_property
    def forces(self) -> Forces:
        return solve_forces(self.motion, wrenches(self))

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

    def lookup(self, table: str, argument: Node, integral: bool = False) -> Scalar:
        """A table's answer, an input of the pose."""
        known = ((k.table, k.argument, k.integral) for k in self.graph.actions.lookups)
        return self.given[f"table/{list(known).index((table, argument, integral))}/0"]

    def _of_action(self, kind: str, what: str) -> Scalar:
        """Rows of loads and springs: the sum of a load's values, whether a window holds, the argument that a table
        is asked for, an angle without whole turns."""
        mechanism = self.graph.quantities.mechanism
        if kind == "load":
            force, torque = load_values(self, mechanism.loads[what])
            return force.x + force.y + torque
        if kind == "window":
            return active(self, what)
        if kind == "argument":
            return self.evaluate(self.graph.actions.lookups[int(what)].argument)
        if what in mechanism.springs:
            spring = mechanism.springs[what]
            return raw_angle(self, str(spring.turns)) - raw_angle(self, str(spring.on))
        return self.own(what, 0, whole=False) if what in mechanism.drives else raw_angle(self, what)

    def _internal(self, owner: str, what: str) -> Scalar:
        if owner in self.motion.bodies and what in ("x", "y", "cos", "sin"):
            body = self.motion.bodies[owner]
            start = body.point(ZERO).now
            return {"cos": body.axis.x.d[0], "sin": body.axis.y.d[0], "x": start.x, "y": start.y}[what]
        if owner == "drives over outputs":
            return lever(self.motion, unit_efforts(self.motion)).determinant()
        if owner == "span":
            span = next(dyad.span() for group, (dyad, _) in self.motion.dyads.items() if group.label == what)
            return 1.0 if span is None else span
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
        order = _LINK_ORDERS[signal.attribute]
        if order:
            return body.turn.d[order - 1]
        turns = self.given.get(f"turns/{signal.owners[0]}")
        angle = raw_angle(self, signal.owners[0])
        return angle if turns is None else angle + 2 * ca.pi * turns

    def spring(self, signal: Signal) -> Scalar:
        name, attribute = signal.owners[0], signal.attribute
        if attribute == "energy":
            return elastic(self, name)[1]
        if attribute in ("force", "torque"):
            return effort(self, name)
        if attribute == "power":
            return -effort(self, name) * stretch(self, name, 1)
        return stretch(self, name, int(attribute in ("v", "omega")))

    def point(self, signal: Signal) -> Scalar:
        link = self.graph.quantities.signals.homes[signal.owners[0]]
        return _component(self.motion.bodies[link].point(self.motion.point(link, signal.owners[0])), signal)

    def com(self, signal: Signal) -> Scalar:
        link = signal.owners[0]
        return _component(self.motion.bodies[link].point(self.motion.geometry.mass(link)[1]), signal)

    def travel(self, joint: str) -> Jet:
        """The distance along a prismatic joint, from the first link's point to the second's."""
        a, b = self.motion.geometry.mechanism.joints[joint].links
        (first, heading), (second, _) = (self.motion.geometry.line(joint, link) for link in (a, b))
        start, end = self.motion.bodies[a].point(first), self.motion.bodies[b].point(second)
        return end.minus(start).dot(self.motion.bodies[a].direction(heading))

    def slide(self, signal: Signal) -> Scalar:
        return self.travel(signal.owners[0]).d[_SLIDE_ORDERS[signal.attribute]]

    def drive(self, signal: Signal) -> Scalar:
        name = signal.owners[0]
        if signal.attribute in ("torque", "force"):
            return self.forces.efforts[name]
        if signal.attribute == "power":
            return self.forces.efforts[name] * self.own(name, 1)
        return self.own(name, {**_LINK_ORDERS, **_SLIDE_ORDERS}[signal.attribute])

    def own(self, name: str, order: int, whole: bool = True) -> Scalar:
        """A drive's value or a rate of it; of one with an output, as it follows from the motion (rad, ``whole`` turns
        where they are known)."""
        drive = self.motion.geometry.mechanism.drives[name]
        if drive.output is None:
            return self.laws[name].d[order]
        if drive.slides:
            joint = self.graph.structure.topology.acting(name)[0].joint
            travel = self.travel(joint).d[order]
            return travel if drive.link == self.motion.geometry.mechanism.joints[joint].links[1] else -travel
        link, on = self.motion.bodies[drive.link], self.motion.bodies[drive.on]
        if order:
            return link.turn.d[order - 1] - on.turn.d[order - 1]
        if link.angle is not None and on.angle is not None:
            return link.angle - on.angle
        raw = ca.atan2(on.axis.now.cross(link.axis.now), on.axis.now.dot(link.axis.now))
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

    def pole(self, signal: Signal) -> Scalar:
        """The point where two links have one velocity: from a's anchor P, perp(v)/omega with the velocity v of P
        and the turning omega of a, both as seen from b."""
        a, b = (self.motion.bodies[link] for link in signal.owners)
        place, size = a.anchor.now, self.graph.size
        arm = place.minus(b.anchor.now)
        carried = Pair(b.anchor.x.d[1] - b.turn.d[0] * arm.y, b.anchor.y.d[1] + b.turn.d[0] * arm.x)
        own = Pair(a.anchor.x.d[1], a.anchor.y.d[1])
        speed, omega = own.minus(carried), ca.SX(a.turn.d[0] - b.turn.d[0])
        whole = own.dot(own) + carried.dot(carried) + size**2 * (a.turn.d[0] ** 2 + b.turn.d[0] ** 2)
        # At infinity and at rest this is zero, and what is divided by it is neither finite nor has a finite rate.
        turns = (size * omega) ** 2 > speed.dot(speed) / INFINITE**2 + whole * ROUND_OFF**2
        omega, beyond = omega * turns, 1 / ca.SX(turns) - 1
        step = Pair(beyond - speed.y / omega, beyond + speed.x / omega)
        if signal.attribute in ("x", "y"):
            return getattr(place, signal.attribute) + getattr(step, signal.attribute)
        inside = step.turned_back(a.axis.now)
        return a.local.x + inside.x if signal.attribute == "u" else a.local.y + inside.y

    def energy(self, signal: Signal) -> Scalar:
        geometry, total = self.motion.geometry, 0.0
        if signal.attribute == "elastic":
            return sum((elastic(self, name)[1] for name in geometry.mechanism.springs), 0.0)
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
    return jet.d[_LETTERS[signal.attribute[:-1]]]


_KINDS = ("link", "point", "com", "slide", "drive", "spring", "force", "shaking", "pole", "energy")
_ROWS: dict[str, Callable[[View, Signal], Scalar]] = {kind: getattr(View, kind) for kind in _KINDS}
