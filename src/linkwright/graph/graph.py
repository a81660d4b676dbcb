"""A mechanism as one program: its groups run on symbols give every signal as an expression.

Inputs per pose are the drives' values and rates and the groups' branches; the parameters are inputs common to
all poses. Signals are made when they are asked for.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import field
from functools import cached_property
from typing import Any

from linkwright.data_classes import dataclass
from linkwright.elements.force import Acting
from linkwright.expressions.language import Call, Name, parse
from linkwright.graph.actions import Actions
from linkwright.graph.geometry import Geometry, widest
from linkwright.graph.program import NewtonStage, Program
from linkwright.graph.rows import BodyPlace, CoordinateRate, Gap, Named, Row, SignalRow, Slope
from linkwright.graph.view import View
from linkwright.model.quantities import Quantities
from linkwright.model.signals import Signal
from linkwright.notation import MAX_ORDER
from linkwright.notation.jets import is_zero
from linkwright.structure import HigherGroup, Structure
from linkwright.symbols import ExpressionStage, Symbol, derivatives_along, symbols_of, without_collection


@dataclass
class Graph:
    """The symbolic mechanism. ``inputs`` names the rows of the per-pose input in order."""

    quantities: Quantities
    structure: Structure
    _views: dict[int, View] = field(default_factory=dict)
    _programs: dict[tuple[tuple[Named, ...], bool, bool], Program] = field(default_factory=dict)
    _read: dict[str, SignalRow] = field(default_factory=dict)
    _wrapped: dict[Named, bool] = field(default_factory=dict)

    @cached_property
    def drives(self) -> tuple[str, ...]:
        """The drives in the order of their inputs."""
        return tuple(self.structure.topology.mechanism.movers)

    @cached_property
    def motors(self) -> tuple[str, ...]:
        """The drives but the followers."""
        return tuple(self.structure.topology.mechanism.drives)

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
        """Rows of the per-pose input: those of the motion, then what acting elements and followers need besides."""
        return (*self.motion_inputs, *self.actions.inputs)

    @cached_property
    def motion_inputs(self) -> tuple[str, ...]:
        """Rows of the motion: each drive's value and rates up to one past jerk, the branches, and the
        coordinates of the higher groups, which Newton supplies."""
        rows = [f"{drive}:{k}" for drive in self.drives for k in range(self.width)]
        rows += [f"branch:{group.label}" for group in self.branched]
        return (*rows, *(f"u:{c.label}:{i}" for c in self.structure.higher_groups for i in range(len(c.free))))

    @cached_property
    def first_unknown(self) -> int:
        """The first input row that Newton supplies."""
        return len(self.drives) * self.width + len(self.branched)

    @cached_property
    def nearest_poses(self) -> Program:
        """The program of the pose rows where dyads that can't close come nearest to it; then of each dyad with two
        modes the distance (m) that it must span, with the least and the most that it can, -1 without a limit."""
        view = View.build(self, 0, self.inputs, nearest=True)
        groups = [group.label for group in self.branched]
        spanned = [view.motion.dyad(group)[0].spanned() or (0.0, 0.0, math.inf) for group in groups]
        spans = [-1.0 if isinstance(part, float) and math.isinf(part) else part for one in spanned for part in one]
        block = ExpressionStage(view.x, view.p, [*(view.row(row) for row in self.pose_rows), *spans])
        names = [f"{group}/{part}" for group in groups for part in ("distance", "least", "most")]
        return Program((), block, self.inputs, self.parameters, (*(row.label for row in self.pose_rows), *names))

    @property
    def width(self) -> int:
        """How many rows each drive has: its value and its rates."""
        return MAX_ORDER + 2

    @cached_property
    def pose_rows(self) -> tuple[BodyPlace, ...]:
        """The output rows of all moving links' poses: place of the origin (m), cosine and sine, link by link."""
        return tuple(row for link in self.structure.topology.moving for row in BodyPlace.all(link))

    def coordinates(self, higher_group: HigherGroup) -> list[int]:
        """The input rows of a higher group's coordinates."""
        return [self.inputs.index(f"u:{higher_group.label}:{i}") for i in range(len(higher_group.free))]

    def closure(self, higher_group: HigherGroup) -> list[Row]:
        """The output rows of a higher group's closures: what each misses, then its slopes to each coordinate."""
        n, label = len(higher_group.free), higher_group.label
        return [*(Gap(label, i) for i in range(n)), *(Slope(label, i) for i in range(n * n))]

    def coordinate_rates(self, higher_group: HigherGroup) -> list[CoordinateRate]:
        """The output rows of the rates of a higher group's coordinates."""
        return [CoordinateRate(higher_group.label, i) for i in range(len(higher_group.free))]

    @cached_property
    def parameters(self) -> tuple[str, ...]:
        """The parameters, in the order of the parameter input."""
        return tuple(self.quantities.parameters)

    def signal(self, text: str) -> Signal:
        """The signal of a name. Raises DimensionError for a name that isn't one."""
        if (known := self.quantities.signals.by_text.get(text)) is not None:
            return known
        node = parse(text)
        assert isinstance(node, Name | Call)
        return self.quantities.signals.find(node)

    def row(self, named: Named) -> Row:
        """A row as it is, or that of a signal's text."""
        if isinstance(named, Row):
            return named
        if named not in self._read:
            self._read[named] = SignalRow(self.signal(named))
        return self._read[named]

    def signals(self, named: Iterable[Named]) -> list[Signal | None]:
        """The signals of some rows; ``None`` for a row of another kind."""
        rows = map(self.row, named)
        return [row.signal if isinstance(row, SignalRow) else None for row in rows]

    def labels(self, named: Iterable[Named]) -> list[str]:
        """What rows are called among outputs: a signal as it was asked for."""
        return [one if isinstance(one, str) else one.label for one in named]

    def order(self, named: Iterable[Named]) -> int:
        """The order of derivatives that some rows need."""
        return max((self.row(one).order(self) for one in named), default=0)

    def program(self, named: Sequence[Named], rates: bool = False, solve: bool = False) -> Program:
        """The program of some rows; with ``rates``, each followed by its time derivative.

        The inputs have the higher groups' coordinates, or with ``solve`` only starts from which the program solves
        them.
        """
        key = (tuple(named), rates, solve)
        if key not in self._programs:
            self._programs[key] = self._build(*key)
        return self._programs[key]

    @without_collection()
    def with_rates(self, named: Sequence[Named], rated: Sequence[Named]) -> Program:
        """The program of some rows, then of others each of which is followed by its time derivative; all share what
        they have in common."""
        order = self.order([*named, *rated])
        view = self._view(max(order, 1) if rated and self.structure.higher_groups else order)
        rows = [view.row(one) for one in named]
        values = symbols_of(view.row(one) for one in rated)
        slopes = derivatives_along(values, self.flow(view)) if values else []
        rows += [part for i, value in enumerate(values) for part in (value, slopes[i])]
        block = ExpressionStage(view.x, view.p, rows)
        outputs = [*self.labels(named), *(part for n in self.labels(rated) for part in (n, f"d({n})"))]
        return Program((), block, self.inputs, self.parameters, tuple(outputs))

    def solving(self, higher_group: HigherGroup) -> Program:
        """The program that solves one higher group, from inputs in which the earlier ones stand already."""
        view, rows = self._view(0), self.coordinates(higher_group)
        block = ExpressionStage(view.x, view.p, [view.x[row] for row in rows])
        names = tuple(self.inputs[row] for row in rows)
        return Program((self.newton(higher_group),), block, self.inputs, self.parameters, names)

    def newton(self, higher_group: HigherGroup) -> NewtonStage:
        """The stage that solves a higher group."""
        view = self._view(0)
        closure = ExpressionStage(view.x, view.p, [row.expression(view) for row in self.closure(higher_group)])
        sliding = tuple(not turns for turns in higher_group.turning)
        return NewtonStage(
            tuple(self.coordinates(higher_group)), closure, tuple(higher_group.units(self.size or 1.0)), sliding
        )

    def _solves(self, block: ExpressionStage) -> tuple[NewtonStage, ...]:
        """The Newton stages on which a block depends."""
        kept: list[NewtonStage] = []
        used = block.used[0]
        for higher_group in reversed(self.structure.higher_groups):
            if used.intersection(self.coordinates(higher_group)):
                kept.insert(0, self.newton(higher_group))
                used |= kept[0].closure.used[0]
        return tuple(kept)

    @without_collection()
    def _build(self, named: tuple[Named, ...], rates: bool, solve: bool) -> Program:
        order, names = self.order(named), self.labels(named)
        view = self._view(max(order, 1) if rates and self.structure.higher_groups else order)
        rows = [view.row(one) for one in named]
        if rates:
            slopes = derivatives_along(symbols_of(rows), self.flow(view))
            rows = [part for i, row in enumerate(rows) for part in (row, slopes[i])]
        block = ExpressionStage(view.x, view.p, rows)
        outputs = tuple(part for name in names for part in ((name, f"d({name})") if rates else (name,)))
        return Program(self._solves(block) if solve else (), block, self.inputs, self.parameters, outputs)

    def flow(self, view: View) -> dict[Symbol, Symbol]:
        """The rate of change of the inputs in time, by input."""
        flow: list[Any] = []
        for i in range(len(self.drives)):
            rows = range(i * self.width, (i + 1) * self.width)
            flow += [*(view.x[k + 1] for k in rows[:-1]), 0.0]
        flow += [0.0] * len(self.branched)
        solved = (view.motion.higher_groups[c] for c in self.structure.higher_groups)
        flow += [rates[0] for higher_group in solved for rates in higher_group.rates]
        flow += self.actions.flow(view.given)
        return dict(zip(view.x, symbols_of(flow), strict=True))

    @cached_property
    def size(self) -> float:
        """The largest distance (m) of two points of one link, at the parameters' nominal values."""
        geometry = Geometry(self.quantities, self.quantities.parameters)
        links = geometry.mechanism.links.items()
        return widest([geometry.point(link, name) for name in entry.points] for link, entry in links)

    def wraps(self, owner: str) -> bool:
        """Whether the angle of a link or drive comes from axes alone, so that it jumps by a turn now and then."""
        drive, bodies = self.structure.topology.mechanism.movers.get(owner), self._bare.motion.bodies
        if drive is None:
            return bodies[owner].angle is None
        return drive.output is not None and None in (bodies[drive.link].angle, bodies[drive.on].angle)

    def wrapped(self, named: Named) -> bool:
        """Whether a row is an angle that jumps so."""
        if named not in self._wrapped:
            (signal,) = self.signals([named])
            self._wrapped[named] = (
                signal is not None
                and signal.kind in ("link", "drive")
                and signal.attribute == "angle"
                and self.wraps(signal.owners[0])
            )
        return self._wrapped[named]

    @cached_property
    def _bare(self) -> View:
        """The motion alone, to order 0."""
        return View.build(self, 0, self.motion_inputs)

    @cached_property
    def friction_shape(self) -> list[list[int]]:
        """Of each effort of friction how many parts the force of each seat has."""
        system = self._view(self.actions.forces).forces.friction
        return [] if system is None else system.shape

    def acted_on(self, one: Acting) -> list[str]:
        """The links on which an element acts, in the order of its wrenches."""
        view = self._view(max(self.actions.order, one.kind.order))
        return [link for link, _ in one.kind.wrenches(view, one.name, one.entry)]

    def acts_by_couples(self, one: Acting) -> bool:
        """Whether an element acts by moments alone, which are the same about every place."""
        view = self._view(max(self.actions.order, one.kind.order))
        forces = [wrench.force for _, wrench in one.kind.wrenches(view, one.name, one.entry)]
        return all(is_zero(part) for force in forces for part in (force.x, force.y))

    def _view(self, order: int) -> View:
        if order not in self._views:
            self._views[order] = View.build(self, order, self.inputs)
        return self._views[order]
