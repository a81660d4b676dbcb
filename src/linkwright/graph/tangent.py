"""Tangents: how signals change with the parameters, exactly, as a program.

The program takes a direction beside the parameters and gives the derivative along it: forward differentiation of the
expressions (Griewank and Walther, *Evaluating Derivatives*, 2nd ed., ch. 3). Its size doesn't grow with the number of
parameters, of which each is a direction. What the closures of higher groups make of their coordinates follows from the
implicit function theorem: J du = -(dg/dp) dp.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from linkwright.graph.program import Program
from linkwright.graph.view import View
from linkwright.symbols import (
    ExpressionStage,
    Symbol,
    as_symbol,
    derivatives_along,
    substituted,
    symbols_of,
    without_collection,
)
from linkwright.symbols import jacobian as slopes_of

if TYPE_CHECKING:
    from linkwright.graph.graph import Graph
    from linkwright.graph.rows import Named


@without_collection()
def tangent(graph: Graph, named: Sequence[Named], rates: bool = False, plays: Sequence[str] = ()) -> Program:
    """The program of some rows with their derivatives along a direction.

    Each has two outputs, or with ``rates`` four: value (and time derivative), then the tangents of these. Inputs
    are the graph's and their tangents (those of drives and tables count), parameters the graph's, their tangents, and
    those of the ``plays`` (see :class:`Geometry`), which are 0 themselves.
    """
    order, names = graph.order(named), graph.labels(named)
    view = View.build(graph, max(order, 1) if rates else order, graph.inputs, plays)
    rows = symbols_of(view.row(one) for one in named)
    if rates:
        rows += derivatives_along(rows, graph.flow(view))
    directions = Symbol.several("direction", len(graph.parameters) + len(plays))
    free = [*view.x, *view.p, *view.plays]
    # The inputs change as their own tangents say, but for the branches, which don't, and for the coordinates of higher
    # groups, which follow from the others.
    tangents = [Symbol.named(f"d({name})") for name in graph.inputs]
    first_branch = len(graph.drives) * graph.width
    still = [*range(first_branch, graph.first_unknown)]
    still += [row for higher_group in graph.structure.higher_groups for row in graph.coordinates(higher_group)]
    zero = as_symbol(0.0)
    changes = [zero if i in still else tangent for i, tangent in enumerate(tangents)]
    direction = dict(zip(free, [*changes, *directions], strict=True))
    for higher_group in graph.structure.higher_groups:
        solved = view.motion.higher_groups[higher_group]
        missed = derivatives_along(symbols_of(solved.gaps), direction)
        for row, rate in zip(graph.coordinates(higher_group), solved.factor.solve(missed), strict=True):
            direction[view.x[row]] = as_symbol(-rate)
    both = _without_plays([*rows, *derivatives_along(rows, direction)], view)
    count, kinds = len(names), 4 if rates else 2
    ordered = [both[kind * count + i] for i in range(count) for kind in range(kinds)]
    block = ExpressionStage([*view.x, *tangents], [*view.p, *directions], ordered)
    said = [f"d({name})" for name in (*graph.parameters, *plays)]
    outputs = tuple(f"{name}/{kind}" for name in names for kind in range(kinds))
    return Program((), block, (*graph.inputs, *(f"d({n})" for n in graph.inputs)), (*graph.parameters, *said), outputs)


def _without_plays(rows: Sequence[Symbol], view: View) -> list[Symbol]:
    """Rows at plays of 0."""
    return substituted(rows, dict.fromkeys(view.plays, as_symbol(0.0))) if view.plays else [*rows]


@without_collection()
def jacobian(
    graph: Graph, named: Sequence[Named], by: Sequence[str], others: Sequence[Named] = (), plays: Sequence[str] = ()
) -> Program:
    """The program of some rows of a mechanism of dyads, then of the derivatives of each by some inputs,
    parameters and ``plays`` of joints, which are 0 themselves: all of one row, then all of the next; then
    ``others``, without derivatives. They share what they have in common."""
    view = View.build(graph, graph.order((*named, *others)), graph.inputs, plays)
    free = [*view.x, *view.p, *view.plays]
    symbols = dict(zip((*graph.inputs, *graph.parameters, *plays), free, strict=True))
    rows = symbols_of(view.row(one) for one in named)
    slopes = slopes_of(rows, [symbols[name] for name in by])
    every = [*rows, *(slope for of_row in slopes for slope in of_row), *symbols_of(view.row(one) for one in others)]
    block = ExpressionStage(view.x, view.p, _without_plays(every, view))
    names, rest = graph.labels(named), graph.labels(others)
    outputs = (*names, *(f"d({name})/d({other})" for name in names for other in by), *rest)
    return Program((), block, graph.inputs, graph.parameters, outputs)
