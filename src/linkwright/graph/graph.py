"""A mechanism as one program: its groups run on symbols give every signal as an expression.

Inputs per pose are the drives' values and rates and the groups' branches; the parameters are inputs common to
all poses. Signals are made when they are asked for.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import casadi as ca

from linkwright.expressions.language import Call, Name, parse
from linkwright.graph.actions import Actions
from linkwright.graph.geometry import Geometry, widest
from linkwright.graph.program import ExpressionStage, NewtonStage, Program
from linkwright.graph.view import LETTERS, LINK_ORDERS, SLIDE_ORDERS, View
from linkwright.model.quantities import Quantities
from linkwright.model.signals import Signal
from linkwright.notation import MAX_ORDER
from linkwright.structure import Cluster, Structure


@dataclass
class Graph:
    """The symbolic mechanism. ``inputs`` names the rows of the per-pose input in order."""

    quantities: Quantities
    structure: Structure
    _views: dict[int, View] = field(default_factory=dict)
    _programs: dict[tuple[tuple[str, ...], bool, bool], Program] = field(default_factory=dict)

    @cached_property
    def drives(self) -> tuple[str, ...]:
        """The drives in the order of their inputs."""
        return tuple(self.structure.topology.mechanism.drives)

    @cached_property
    def motors(self) -> tuple[str, ...]:
        """The drives but those that stand for cams."""
        return tuple(name for name in self.drives if name not in self.actions.cams)

    @cached_property
    def branched(self) -> tuple[Any, ...]:
        """The groups with two assembly modes, in the order of their branch inputs."""
        return tuple(group for group in self.structure.groups if group.modes > 1)

    @cached_property
    def actions(self) -> Actions:
        """What acts on the links."""
        return Actions(self)

    @cached_property
    def inputs(self) -> tuple[str, ...]:
        """Rows of the per-pose input: those of the motion, then what loads and springs need besides."""
        return (*self.motion_inputs, *self.actions.inputs)

    @cached_property
    def motion_inputs(self) -> tuple[str, ...]:
        """Rows of the motion: each drive's value and rates up to one past jerk, the branches, and the
        coordinates of the clusters, which Newton supplies."""
        rows = [f"{drive}:{k}" for drive in self.drives for k in range(self.width)]
        rows += [f"branch:{group.label}" for group in self.branched]
        return (*rows, *(f"u:{c.label}:{i}" for c in self.structure.clusters for i in range(len(c.free))))

    @cached_property
    def first_unknown(self) -> int:
        """The first input row that Newton supplies."""
        return len(self.drives) * self.width + len(self.branched)

    @property
    def width(self) -> int:
        """How many rows each drive has: its value and its rates."""
        return MAX_ORDER + 2

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

    def program(self, names: Sequence[str], rates: bool = False, solve: bool = False) -> Program:
        """The program of the named signals; with ``rates``, each followed by its time derivative.

        The inputs have the clusters' coordinates, or with ``solve`` only starts from which the program solves them.
        Names are signals, or the internal rows ``reach:GROUP``, ``room:GROUP``, ``determinant:GROUP``, ``LINK:cos``,
        ``LINK:sin``, ``load/NAME``, ``window/NAME``, ``argument/NUMBER``, ``raw/NAME``.
        """
        key = (tuple(names), rates, solve)
        if key not in self._programs:
            self._programs[key] = self._build(*key)
        return self._programs[key]

    def solving(self, cluster: Cluster) -> Program:
        """The program that solves one cluster, from inputs in which the earlier ones stand already."""
        view, rows = self._view(0), self.coordinates(cluster)
        block = ExpressionStage.from_rows(view.x, view.p, [view.x[row] for row in rows])
        names = tuple(self.inputs[row] for row in rows)
        return Program((self.newton(cluster),), block, self.inputs, self.parameters, names)

    def newton(self, cluster: Cluster) -> NewtonStage:
        """The stage that solves a cluster."""
        view = self._view(0)
        closure = ExpressionStage.from_rows(view.x, view.p, [view.row(name) for name in self.closure(cluster)])
        sliding = tuple(not turns for turns in cluster.turning)
        return NewtonStage(tuple(self.coordinates(cluster)), closure, tuple(cluster.units(self.size or 1.0)), sliding)

    def _solves(self, block: ExpressionStage) -> tuple[NewtonStage, ...]:
        """The Newton stages on which a block depends."""
        kept: list[NewtonStage] = []
        used = block.used[0]
        for cluster in reversed(self.structure.clusters):
            if used.intersection(self.coordinates(cluster)):
                kept.insert(0, self.newton(cluster))
                used |= kept[0].closure.used[0]
        return tuple(kept)

    def _build(self, names: tuple[str, ...], rates: bool, solve: bool) -> Program:
        order = max((self.order_of(name) for name in names), default=0)
        view = self._view(max(order, 1) if rates and self.structure.clusters else order)
        rows = [ca.SX(view.row(name)) for name in names]
        if rates:
            slopes = ca.jtimes(ca.vertcat(*rows), view.x, self.flow(view))
            rows = [part for i, row in enumerate(rows) for part in (row, slopes[i])]
        block = ExpressionStage.from_rows(view.x, view.p, rows)
        outputs = tuple(part for name in names for part in ((name, f"d({name})") if rates else (name,)))
        return Program(self._solves(block) if solve else (), block, self.inputs, self.parameters, outputs)

    def flow(self, view: View) -> Any:
        """The rate of change of the inputs in time."""
        flow = []
        for i in range(len(self.drives)):
            rows = range(i * self.width, (i + 1) * self.width)
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
            own = (one.kind.order for one in self.actions.every if one.row == name)
            return 0 if name.startswith("raw/") else max(self.actions.order, *own, 0)
        if ":" in name:
            return 1 if name.startswith("rate:") else 0
        signal = self.signal(name)
        if signal.kind == "joint":
            order = self.structure.topology.kind_of(signal.owners[0]).orders[signal.attribute]
            return order if signal.kinematic else max(order, self.actions.forces)
        if (one := self.quantities.signals.acting.get(signal.owners[0])) is not None and signal.kind == one.noun:
            return one.kind.orders.get(signal.attribute, one.kind.order)
        if signal.kind in ("force", "shaking") or signal.attribute in ("torque", "force", "power"):
            return self.actions.forces
        if signal.attribute in ("pressure", "pressure_second"):
            return 0
        if signal.kind in ("energy", "pole"):
            return 1
        orders = {"link": LINK_ORDERS, "drive": {**LINK_ORDERS, **SLIDE_ORDERS}, "slide": SLIDE_ORDERS}
        known = orders.get(signal.kind)
        return known[signal.attribute] if known else LETTERS[signal.attribute[:-1]]

    def _view(self, order: int) -> View:
        if order not in self._views:
            self._views[order] = View.build(self, order, self.inputs)
        return self._views[order]
