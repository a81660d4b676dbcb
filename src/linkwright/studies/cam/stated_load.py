"""The load along the lift as a file states it: a constant, or an expression in the cam angle and the lift."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.cam.contact import rows
from linkwright.cam.disc import TURN, Disc, DiscJets, inside
from linkwright.cam.extremes import STEPS, extremes
from linkwright.cam.loads import Load, by_both
from linkwright.data_classes import dataclass
from linkwright.expressions import units as u
from linkwright.expressions.dimensions import DimensionError, argument
from linkwright.expressions.fields import Expression
from linkwright.expressions.language import FUNCTIONS, Call, Name, Node, evaluate, nodes
from linkwright.findings import Finding, ModelError
from linkwright.kernels import Compiled
from linkwright.kernels.laws import read_table
from linkwright.laws import TableLaw
from linkwright.model.names import Names
from linkwright.model.places import ExpressionPlace, Scope
from linkwright.model.quantities import LARGEST
from linkwright.notation import Jet
from linkwright.results.discontinuities import joins, knots, switches
from linkwright.results.stationary import crossings
from linkwright.studies.cam.force_options import ANGLE, LIFT, load_names

Array = NDArray[np.float64]

NEAR = 1e-9
"""Joins (rad) that are nearer to each other are one."""
MOST = 256
"""The most corners of a table that are taken for joins; more are so slight that nobody misses them."""
SEEN = 1440
"""The steps of a turn at which a load must have a value."""
LOOKS, FINER = 4, 65
"""A pole is looked at so many times, each time at so many places of the step in which it is."""
LEAP = 1e-3
"""What leaps by less than this share of the largest load is no pole."""
SLACK = 1e-12
"""By this share of its range a table may be asked for more, which is round-off."""


@dataclass(frozen=True)
class StatedLoad:
    """A load (N or N m), and the cam angles (rad) at which its formula changes."""

    load: float | Load
    joins: tuple[float, ...] = ()


def stated_load(
    compiled: Compiled,
    disc: Disc,
    of: Expression,
    dimension: u.Dimension,
    at: tuple[str | int, ...],
    constant: Callable[[], float],
) -> tuple[StatedLoad, list[Finding]]:
    """The load and what is wrong with it; ``constant`` reads one that doesn't change."""
    reader = _LoadReader(compiled, disc, at)
    if found := reader.unfit(of, dimension):
        return StatedLoad(math.nan), found
    if not any(_varies(node) for node in nodes(of.node)):
        return StatedLoad(constant()), []
    try:
        node = compiled.quantities.formula(of, dimension, reader.names)
    except DimensionError as error:
        return StatedLoad(math.nan), [Finding(error.key, at, error.data)]
    try:
        return reader.over_turn(node), []
    except ModelError as wrong:
        return StatedLoad(math.nan), list(wrong.findings)


def _varies(node: Node) -> bool:
    if isinstance(node, Name):
        return node.text in (ANGLE, LIFT)
    return isinstance(node, Call) and node.name not in FUNCTIONS


class _LoadReader:
    def __init__(self, compiled: Compiled, disc: Disc, at: tuple[str | int, ...]) -> None:
        self.compiled, self.disc, self.at = compiled, disc, at
        self.names = load_names(disc.follower.turns)

    def unfit(self, of: Expression, dimension: u.Dimension) -> list[Finding]:
        """Names that aren't known or can't stand here."""
        mechanism, signals = self.compiled.mechanism, self.compiled.quantities.signals
        names, place = Names(mechanism, signals), ExpressionPlace(self.at, of, dimension, Scope.TURN, self.names)
        named = {node.text for node in nodes(of.node) if isinstance(node, Name)}
        taken = sorted(named & self.names.keys() & mechanism.parameters.keys())
        found = [Finding("cam.load-name", self.at, {"name": name}) for name in taken]
        return [*found, *names.misplaced(place), *names.unknown(place)]

    def over_turn(self, node: Node) -> StatedLoad:
        """An expression in SI. Raises :class:`ModelError` where it has no value."""
        calls = [part for part in nodes(node) if isinstance(part, Call) and part.name not in FUNCTIONS]
        tables = self._tables(calls)
        value = self._function(node, tables)
        for call in reversed(calls):  # those within others first
            if call.name in tables:
                self._within(call.name, tables[call.name], self._function(call.args[0], tables))
        load = by_both(value)
        made = StatedLoad(load, tuple(self._joins(node, calls, tables)))
        self._finite(made)
        return made

    def _tables(self, calls: list[Call]) -> dict[str, TableLaw]:
        read: dict[str, TableLaw] = {}
        wrong: list[Finding] = []
        for name in dict.fromkeys(call.name for call in calls if call.name in self.compiled.mechanism.tables):
            try:
                read[name] = read_table(self.compiled.quantities, name, self.compiled.folder)
            except ModelError as error:
                wrong += error.findings
        if wrong:
            raise ModelError(wrong)
        return read

    def _function(self, node: Node, tables: Mapping[str, TableLaw]) -> Callable[[Jet, Jet], Jet]:
        """An expression as a function of the cam angle and the lift; NaN where it has no value."""
        parameters, motions = self.compiled.quantities.parameters, self.compiled.motions

        def function(angle: Jet, lift: Jet) -> Jet:
            given = {ANGLE: angle, LIFT: lift}

            def named(name: Name) -> Any:
                return given[name.text] if name.text in given else parameters[name.text]

            def evaluate_call(call: Call) -> Jet:
                asked = evaluate(call.args[0], named, evaluate_call)
                x = asked if isinstance(asked, Jet) else Jet.constant(asked, angle.order)
                return motions[call.name].on(x) if call.name in motions else tables[call.name].or_nan(x)

            with np.errstate(all="ignore"):
                value = evaluate(node, named, evaluate_call)
            return value if isinstance(value, Jet) else Jet.constant(value, angle.order)

        return function

    def _within(self, name: str, table: TableLaw, asked: Callable[[Jet, Jet], Jet]) -> None:
        """Raise :class:`ModelError` where a table is asked for what it doesn't hold."""
        low, high = float(table.x[0]), float(table.x[-1])
        if table.period is not None:
            return
        try:
            found = extremes(self.disc, by_both(asked))
        except ValueError:
            return  # nowhere a number, which is told of the whole
        over = [low - found[0].value, found[1].value - high]
        worst = int(over[1] > over[0])
        if over[worst] > SLACK * (high - low):
            unit, size = self._unit(self.compiled.quantities.dimensions.of(argument(name)))
            told = {"at": found[worst].value, "low": low, "high": high}
            data = {key: f"{value / size:.6g}" for key, value in told.items()}
            raise self._error("cam.load-outside", found[worst].theta, table=name, of=unit, **data)

    def _finite(self, made: StatedLoad) -> None:
        """Raise :class:`ModelError` where the load has no value."""
        assert callable(made.load)
        for start, stop in self._pieces(made.joins):
            steps = max(8, math.ceil(SEEN * (stop - start) / TURN))
            theta = inside(np.linspace(start, stop, steps + 1), start, stop)
            values, _ = self._load_and_rate(made.load, theta)
            bad = ~(np.abs(values) < LARGEST)
            if bad.any():
                raise self._error("cam.load-not-finite", float(theta[bad][0]))
            if (pole := self._pole(made.load, theta)) is not None:
                raise self._error("cam.load-not-finite", pole)

    def _load_and_rate(self, load: Load, theta: Array) -> tuple[Array, Array]:
        """A load and its rate by the cam angle."""
        jet = load(self.disc.look(theta))
        return rows(jet.d[0], theta.size), rows(jet.d[1], theta.size)

    def _pole(self, load: Load, theta: Array) -> float | None:
        """Where a load leaps against its rate however near one looks, as across a pole; ``None`` where it doesn't."""
        least = 0.0
        for _ in range(LOOKS):
            values, rates = self._load_and_rate(load, theta)
            leap, step = np.diff(values), np.diff(theta)
            least = least or LEAP * float(np.abs(values).max())
            against = np.maximum(rates[1:] * leap, rates[:-1] * leap) < 0
            steep = np.maximum(np.abs(rates[1:]), np.abs(rates[:-1])) * step > np.abs(leap) / 2
            found = np.flatnonzero(against & steep & (np.abs(leap) > least))
            if not found.size:
                return None
            theta = np.linspace(theta[found[0]], theta[found[0] + 1], FINER)
        return float(theta[0])

    def _error(self, code: str, theta: float, **data: str) -> ModelError:
        unit, size = self._unit(u.ANGLE)
        return ModelError([Finding(code, self.at, {"theta": f"{theta / size:.6g} {unit}", **data})])

    def _unit(self, dimension: u.Dimension) -> tuple[str, float]:
        return self.compiled.quantities.unit_of(dimension)

    def _pieces(self, joins: tuple[float, ...] = ()) -> list[tuple[float, float]]:
        starts = sorted({start for start, _ in self.disc.pieces} | {*joins})
        return list(zip(starts, [*starts[1:], TURN], strict=True))

    def _joins(self, node: Node, calls: list[Call], tables: Mapping[str, TableLaw]) -> Iterator[float]:
        """The cam angles at which the formula changes, but for those of the cam's own law."""
        found: list[float] = []
        for part in nodes(node):
            for switch in (*switches(part), *joins(self.compiled.motions, part)):
                value = self._values(self._function(switch, tables))
                found += [at for piece in self._pieces() for at in crossings(value, *piece, STEPS)]
        for call in calls:
            if call.name in tables and tables[call.name].degree == 1:
                corners = knots(self._values(self._function(call.args[0], tables)), tables[call.name], 0.0, TURN, SEEN)
                found += list(corners) if corners.size <= MOST else []
        known = [start for start, _ in self._pieces()] + [TURN]
        for at in sorted(map(float, found)):
            if min(abs(at - other) for other in known) > NEAR:
                known.append(at)
                yield at

    def _values(self, function: Callable[[Jet, Jet], Jet]) -> Callable[[Array], Array]:
        load = by_both(function)

        def values(theta: Array) -> Array:
            look: DiscJets = self.disc.look(theta.ravel())
            return rows(load(look).d[0], theta.size).reshape(theta.shape)

        return values
