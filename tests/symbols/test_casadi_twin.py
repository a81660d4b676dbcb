"""Symbols against CasADi: values, derivatives, numbers of instructions; random expressions and all mechanisms."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np
import pytest

import linkwright as lw
from helpers.casadi_twin import CODES, Twin, numbers
from helpers.longer import mostly_long
from helpers.programs import random_rows
from linkwright.compilation import compile_mechanism
from linkwright.graph.view import View
from linkwright.kernels import Compiled
from linkwright.model.document import load
from linkwright.symbols import (
    OPERATIONS,
    ExpressionStage,
    OrthogonalFactors,
    Symbol,
    as_symbol,
    derivatives_along,
    jacobian,
    ordered,
)

ROOT = Path(__file__).parents[2]
FILES = [*sorted((ROOT / "examples").glob("*.yaml")), *sorted((ROOT / "src/linkwright/gallery").glob("*.yaml"))]
SEEDS = range(60)
CLOSE = 1e-9
"""Over the largest of a row's values: rows of random expressions lose digits where they cancel."""


def finite(rows: list[Symbol], free: list[Symbol], at: Any) -> list[Symbol]:
    """The rows of which all parts are numbers at a place: of 0/0, of x/0, and of the sign of NaN CasADi makes
    constants of its own."""
    parts = ordered(rows)
    values = ExpressionStage(free, [], parts).numbers(at, [])
    bad = {part for part, value in zip(parts, values, strict=True) if not math.isfinite(value)}
    return [row for row in rows if bad.isdisjoint(ordered([row]))]


def test_the_table_has_an_operation_of_casadi_for_each() -> None:
    assert {*CODES} == {*OPERATIONS}


@pytest.mark.parametrize("name", OPERATIONS)
def test_operations_and_their_slopes(name: str) -> None:
    """Each at places on either side of where it changes, all its slopes too."""
    operation = OPERATIONS[name]
    free = Symbol.several("x", operation.operands)
    row = free[0].do(name, *free[1:])
    twin = Twin(free, [row])
    value, slopes = twin.function(twin.rows), twin.function(twin.jacobian())
    stage = ExpressionStage(free, [], [row, *jacobian([row], free)[0]])
    for place in ((0.3, 0.7), (0.9, 0.2), (0.5, -0.4), (-0.6, 0.8), (-0.2, -0.3)):
        at = np.array(place[: operation.operands])
        expected = [*numbers(value, at), *numbers(slopes, at)]
        np.testing.assert_allclose(stage.numbers(at, []), expected, rtol=1e-14, atol=1e-15)


@pytest.mark.parametrize("seed", SEEDS)
def test_random_expressions(seed: int) -> None:
    """Values, derivatives along a direction, and by each symbol."""
    free = Symbol.several("x", 5)
    rng = np.random.default_rng(seed)
    at, direction = rng.uniform(0.2, 2.0, 5), rng.uniform(-1, 1, 5)
    rows = finite(random_rows(seed, free[:3], free[3:], size=60), free, at)
    assert rows
    twin = Twin(free, rows)
    constants = {symbol: as_symbol(float(rate)) for symbol, rate in zip(free, direction, strict=True)}
    slopes = [slope for of_row in jacobian(rows, free) for slope in of_row]
    found = ExpressionStage(free, [], [*rows, *derivatives_along(rows, constants), *slopes]).numbers(at, [])
    along = twin.along(dict(enumerate(direction)))
    expected = [numbers(twin.function(part), at) for part in (twin.rows, along, twin.jacobian())]
    known = np.concatenate(expected)
    both = np.isfinite(found) & np.isfinite(known)  # a slope may be infinite where the value isn't
    assert both.mean() > 0.7
    size = np.maximum(1.0, np.abs(known[both]))
    np.testing.assert_allclose(np.array(found)[both] / size, known[both] / size, rtol=0.0, atol=CLOSE)


def compiled_or_skipped(path: Path) -> Compiled:
    try:
        return compile_mechanism(load(path))
    except lw.ModelError as error:  # a structure has no motion
        pytest.skip(str(error)[:60])


@pytest.mark.parametrize("path", mostly_long(FILES, FILES[::4].__contains__), ids=lambda path: path.stem)
def test_mechanisms(path: Path) -> None:
    """All signals of a mechanism: their values by CasADi's virtual machine; their rates, and their slopes along a
    direction of the parameters, by its derivatives; and hardly more instructions than its own list of them has."""
    compiled = compiled_or_skipped(path)
    graph = compiled.graph
    names = [signal.text for signal in compiled.quantities.signals.all() if signal.attribute != "arm"]
    view = View.build(graph, max(1, graph.order(names)), graph.inputs)
    rows, flow = [as_symbol(view.row(name)) for name in names], graph.flow(view)
    x, p = compiled.inputs(np.array([0.0123]))[:, 0], compiled.parameters
    free, at = [*view.x, *view.p], [*x, *p]
    directions = np.random.default_rng(3).uniform(-1, 1, p.size)
    along = dict(zip(view.p, map(as_symbol, directions.tolist()), strict=True))
    twin = Twin(free, [*rows, *flow.values()])
    values = twin.rows[: len(rows)]
    in_time = ca.jtimes(values, twin.free[: len(view.x)], twin.rows[len(rows) :])
    by_parameters = ca.jtimes(values, twin.free[len(view.x) :], ca.DM(directions)) if p.size else ca.DM([])
    rates, slopes = derivatives_along(rows, flow), derivatives_along(rows, along) if p.size else []
    for own, other in ((rows, values), (rates, in_time), (slopes, by_parameters)):
        if not own:
            continue
        stage = ExpressionStage(free, [], own)
        found, known = np.array(stage.numbers(at, [])), numbers(twin.function(other), at)
        both = np.isfinite(found) & np.isfinite(known)  # CasADi makes constants of 0/0 and x/0
        assert both.mean() > 0.9
        size = max(1.0, float(np.abs(known[both]).max()))
        np.testing.assert_allclose(found[both], known[both], rtol=1e-9, atol=1e-13 * size)
        assert len(stage.instructions) <= 1.05 * twin.function(other).n_instructions() + 5


def test_products_of_factors() -> None:
    """A x = b and the transposed system hold, derivatives of solutions too: dx = -A^-1 dA x."""
    rng = np.random.default_rng(5)
    entries = [Symbol.several(f"row{i}", 4) for i in range(4)]
    free = [symbol for row in entries for symbol in row]
    solution = OrthogonalFactors(entries).solve([1.0, 0.0, -2.0, 0.5])
    stage = ExpressionStage(free, [], [slope for of_row in jacobian(solution, free) for slope in of_row])
    matrix = rng.uniform(-1, 1, (4, 4))
    inverse = np.linalg.inv(matrix)
    x = inverse @ [1.0, 0.0, -2.0, 0.5]
    expected = -np.einsum("ki,j->kij", inverse, x).reshape(4, 16)
    np.testing.assert_allclose(np.reshape(stage.numbers(matrix.ravel(), []), (4, 16)), expected, rtol=1e-11)
