"""Tangents: how signals change with the parameters, exactly, as a program.

The program takes a direction beside the parameters and gives the derivative along it: forward differentiation of the
expressions (Griewank and Walther, *Evaluating Derivatives*, 2nd ed., ch. 3). Its size doesn't grow with the number of
parameters, of which each is a direction. What the closures of higher groups make of their coordinates follows from the
implicit function theorem: J du = -(dg/dp) dp.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import casadi as ca

from linkwright.graph.program import ExpressionStage, Program
from linkwright.graph.view import View
from linkwright.notation.symbols import Symbol, column

if TYPE_CHECKING:
    from linkwright.graph.graph import Graph
    from linkwright.graph.rows import Named


def tangent(graph: Graph, named: Sequence[Named], rates: bool = False, plays: Sequence[str] = ()) -> Program:
    """The program of some rows with their derivatives along a direction.

    Each has two outputs, or with ``rates`` four: value (and time derivative), then the tangents of these. Inputs
    are the graph's and their tangents (those of drives and tables count), parameters the graph's, their tangents, and
    those of the ``plays`` (see :class:`Geometry`), which are 0 themselves.
    """
    order, names = graph.order(named), graph.labels(named)
    view = View.build(graph, max(order, 1) if rates else order, graph.inputs, plays)
    rows = column(view.row(one) for one in named)
    if rates:
        rows = ca.vertcat(rows, ca.jtimes(rows, view.x, graph.flow(view)))
    symbols = [Symbol.named(f"d({name})") for name in graph.inputs]
    inputs: list[Any] = list(symbols)
    directions = ca.SX.sym("direction", len(graph.parameters) + len(plays))

    def along(what: Any) -> Any:
        """The tangent of expressions."""
        free = ca.vertcat(view.x, view.p, *view.plays)
        return ca.jtimes(what, free, ca.vertcat(*inputs, directions))

    for i in range(len(graph.drives) * graph.width, graph.first_unknown):
        inputs[i] = ca.SX(0)  # branches
    for higher_group in graph.structure.higher_groups:
        at = graph.coordinates(higher_group)
        for row in at:
            inputs[row] = ca.SX(0)
        solved = view.motion.higher_groups[higher_group]
        missed = along(ca.vertcat(*solved.gaps))
        for row, q in zip(at, solved.factor.solve([missed[i] for i in range(len(at))]), strict=True):
            inputs[row] = -q
    both = ca.vertcat(rows, along(rows))
    if plays:
        both = ca.substitute(both, ca.vertcat(*view.plays), ca.DM.zeros(len(plays)))
    count, kinds = len(names), 4 if rates else 2
    ordered = [both[kind * count + i] for i in range(count) for kind in range(kinds)]
    block = ExpressionStage.from_rows(ca.vertcat(view.x, *symbols), ca.vertcat(view.p, directions), ordered)
    said = [f"d({name})" for name in (*graph.parameters, *plays)]
    outputs = tuple(f"{name}/{kind}" for name in names for kind in range(kinds))
    return Program((), block, (*graph.inputs, *(f"d({n})" for n in graph.inputs)), (*graph.parameters, *said), outputs)


def jacobian(
    graph: Graph, named: Sequence[Named], by: Sequence[str], others: Sequence[Named] = (), plays: Sequence[str] = ()
) -> Program:
    """The program of some rows of a mechanism of dyads, then of the derivatives of each by some inputs,
    parameters and ``plays`` of joints, which are 0 themselves: all of one row, then all of the next; then
    ``others``, without derivatives. They share what they have in common."""
    view = View.build(graph, graph.order((*named, *others)), graph.inputs, plays)
    free = ca.vertsplit(ca.vertcat(view.x, view.p, *view.plays))
    symbols = dict(zip((*graph.inputs, *graph.parameters, *plays), free, strict=True))
    rows = column(view.row(one) for one in named)
    slopes = ca.densify(ca.jacobian(rows, ca.vertcat(*(symbols[name] for name in by))))
    every = column([rows, ca.reshape(slopes.T, -1, 1), *map(view.row, others)])
    if plays:
        every = ca.substitute(every, ca.vertcat(*view.plays), ca.DM.zeros(len(plays)))
    block = ExpressionStage.from_rows(view.x, view.p, [every])
    names, rest = graph.labels(named), graph.labels(others)
    outputs = (*names, *(f"d({name})/d({other})" for name in names for other in by), *rest)
    return Program((), block, graph.inputs, graph.parameters, outputs)
