"""Signals of a run, and expressions of them, enclosed over panels of time."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.enclosures.higher_groups import EnclosedGroup
from linkwright.enclosures.panels import MARGIN, Panels
from linkwright.enclosures.program import Stage, taylor
from linkwright.enclosures.taylor import TaylorModel, lift
from linkwright.expressions.language import Call, Name, Node, evaluate, is_signal, nodes
from linkwright.graph.rows import TableArgument
from linkwright.notation import Jet
from linkwright.notation.angles import whole_turns
from linkwright.results import Run

Array = NDArray[np.float64]


class Enclosure:
    """Expressions (bound to SI) of a run's signals, enclosed over panels of time; ``precise`` with long doubles, which
    takes several times as long."""

    def __init__(self, run: Run, trees: Sequence[Node], precise: bool = False) -> None:
        self.run, self.trees, self.precise = run, list(trees), precise
        dtype = np.longdouble if precise else np.float64
        compiled = run.compiled
        self.names = run.signals_of(trees)
        program = compiled.graph.program(self.names)
        strict = any(
            isinstance(n, Call) and n.name == "atan2" for law in compiled.graph.actions.laws for n in nodes(law)
        )
        self.stage = Stage(program.block, compiled.parameters, range(len(self.names)), taylor(strict, dtype))
        self.wrapped = [name for name in self.names if compiled.graph.wrapped(name)]
        self.inputs = Inputs(run, strict, dtype)

    def panels(self, start: Array, stop: Array) -> Panels:
        """Panels of the run."""
        return Panels(start, stop, MARGIN * (self.run.stop - self.run.start), precise=self.precise)

    def signals(self, on: Panels) -> dict[str, TaylorModel]:
        """Every signal over panels, angles continuous over the run."""
        rows = dict(zip(self.names, self.stage(self.inputs.over(on)), strict=True))
        for name in self.wrapped:
            middle = np.broadcast_to(rows[name].c[0], on.mid.shape).astype(float)
            turns = whole_turns(middle, self.run._continuous(name, on.mid.astype(float), middle))
            rows[name] = rows[name] + _turns(turns, on)
        return rows

    def __call__(self, on: Panels) -> list[TaylorModel]:
        """Every expression over panels, with as many columns as there are panels."""
        with np.errstate(all="ignore"):
            rows = self.signals(on)
            return [_wide(self.expressed(tree, rows, on), on) for tree in self.trees]

    def expressed(self, tree: Node, rows: dict[str, TaylorModel], on: Panels) -> TaylorModel:
        """An expression from its signals."""
        quantities = self.run.compiled.quantities

        def name_value(name: Name) -> Any:
            if is_signal(name):
                return rows[self.run.canonical(name)]
            return TaylorModel.time(on) if name.text == "t" else quantities.parameters[name.text]

        def call_value(call: Call) -> Any:
            if is_signal(call):
                return rows[self.run.canonical(call)]
            argument = lift(evaluate(call.args[0], name_value, call_value))
            return self.run.compiled.tables[call.name].at_parameters(quantities.parameters).or_nan(Jet([argument])).d[0]

        return lift(evaluate(tree, name_value, call_value))


def _turns(turns: Array, on: Panels) -> TaylorModel:
    """So many whole turns (rad)."""
    return TaylorModel((2 * np.pi * turns)[None], 2.5e-16 * np.abs(turns), on)


def _wide(model: TaylorModel, on: Panels) -> TaylorModel:
    shape = (len(model.c), on.count)
    return TaylorModel(np.broadcast_to(model.c, shape), np.broadcast_to(model.r, on.count), on)


class Inputs:
    """The input rows of a run's programs over panels."""

    def __init__(self, run: Run, strict: bool, dtype: Any) -> None:
        self.compiled, self.strict, self.dtype = run.compiled, strict, dtype
        graph, rows = self.compiled.graph, self.compiled.supply.rows
        self.time = rows.get("t")
        self.driven = len(graph.drives) * graph.width  # the rows of drives come first
        self.answers = {rows[f"table/{i}/{k}"]: (i, k) for i in range(len(graph.actions.lookups)) for k in (0, 1)}
        self.ratios = {rows[f"ratio/{name}/{k}"]: (name, k) for name in graph.actions.followers for k in (0, 1)}
        self.lookups: dict[int, Stage] = {}
        self.solved: dict[int, EnclosedGroup] = {}
        for higher_group in self.compiled.structure.higher_groups:
            solved = EnclosedGroup(self.compiled, higher_group, dtype)
            self.solved.update(dict.fromkeys(solved.rows, solved))

    def over(self, on: Panels) -> Any:
        """The rows over panels, each made when it is asked for."""
        compiled, graph = self.compiled, self.compiled.graph
        made: dict[int, TaylorModel] = {}
        time = TaylorModel.time(on)

        @cache
        def middle() -> Array:
            return compiled.inputs(on.mid.astype(float))

        def same(row: int) -> TaylorModel:
            """What is the same all over a panel."""
            return TaylorModel(middle()[row][None], np.zeros(on.count), on)

        @cache
        def drive(name: str) -> Jet:
            law = compiled.laws[name]
            return law.of(time, law.parameters, False)  # type: ignore[arg-type]

        @cache
        def ratio(name: str) -> tuple[Any, Any]:
            law = compiled.supply.followers[name]
            motor = drive(law.motor)
            return law.ratio(motor.d[0], motor.d[1], law.parameters)

        def make(row: int) -> TaylorModel:
            if row in self.solved:
                made.update(self.solved[row](x, on))
                return made[row]
            if row < self.driven:
                which, order = divmod(row, graph.width)
                return lift(drive(graph.drives[which]).d[order])
            if row == self.time:
                return time
            if row in self.answers:
                return self.answer(*self.answers[row], x)
            if row in self.ratios:
                name, k = self.ratios[row]
                return lift(ratio(name)[k])
            return lift(same(row))

        def x(row: int) -> TaylorModel:
            if row not in made:
                made[row] = make(row)
            return made[row]

        return x

    def answer(self, number: int, order: int, x: Any) -> TaylorModel:
        """What a table answers, or its rate."""
        compiled, graph = self.compiled, self.compiled.graph
        if number not in self.lookups:
            program = graph.program([TableArgument(number)], rates=True)
            self.lookups[number] = Stage(program.block, compiled.parameters, (0, 1), taylor(self.strict, self.dtype))
        lookup = graph.actions.lookups[number]
        table = compiled.tables[lookup.table]
        argument = Jet(self.lookups[number](x))
        return lift((table.integral if lookup.integral else table.or_nan)(argument).d[order])
