"""The table of operations: every emitter knows each of them, and computes with it what CasADi does."""

from __future__ import annotations

from collections.abc import Collection

import casadi as ca
import numpy as np
import pytest

from helpers.kernels import every
from linkwright.enclosures.panels import Panels
from linkwright.enclosures.program import BOXES, Stage, taylor
from linkwright.enclosures.taylor import TaylorModel
from linkwright.graph.program import ExpressionStage, Program
from linkwright.kernels import KERNELS, jax_trace, numpy_blocks, straight_line
from linkwright.kernels.operations import OPERATIONS, Operation, operation

WRITTEN_OUT = ("twice", "if_else_zero")
"""What the JAX emitter spells in its own way."""
EMITTERS: dict[str, Collection[str]] = {
    "numpy": numpy_blocks.FUNCTIONS,
    "jax": {*jax_trace.NAMES, *WRITTEN_OUT},
    "written": straight_line.WRITABLE,
    "taylor models": taylor().functions,
    "boxes": BOXES.functions,
}
CONDITIONED = ("logical_not", "logical_and", "logical_or", "if_else_zero")
PLACES = np.array([[0.3, -0.6, 0.9, 0.2], [0.7, 0.4, 0.9, -0.8]])
"""Operands at which every operation but a few has a value."""


def program(done: Operation, code: int) -> Program:
    """A program of one operation."""
    x = ca.SX.sym("x", 2)
    row = ca.SX.unary(code, x[0]) if done.operands == 1 else ca.SX.binary(code, x[0], x[1])
    stage = ExpressionStage(ca.Function("one", [x, ca.SX(0, 1)], [row]))
    return Program((), stage, ("x", "y"), (), (done.name,))


def every_operation() -> Program:
    """A program of all of them; the power of a constant is CasADi's own operation."""
    x = ca.SX.sym("x", 2)
    rows = [
        ca.SX.unary(code, x[0]) if each.operands == 1 else ca.SX.binary(code, x[0], x[1])
        for each in OPERATIONS.values()
        for code in each.codes
    ]
    names = tuple(f"{each.name} {code}" for each in OPERATIONS.values() for code in each.codes)
    stage = ExpressionStage(ca.Function("all", [x, ca.SX(0, 1)], [ca.vertcat(*rows)]))
    return Program((), stage, ("x", "y"), (), names)


def test_codes_belong_to_one_operation() -> None:
    codes = [code for each in OPERATIONS.values() for code in each.codes]
    assert len({*codes}) == len(codes)
    assert all(operation(code).name in OPERATIONS for code in codes)
    assert [each.name for each in OPERATIONS.values()] == [*OPERATIONS]


@pytest.mark.parametrize("emitter", EMITTERS)
def test_each_emitter_knows_each_operation_and_no_other(emitter: str) -> None:
    assert {*EMITTERS[emitter]} == {*OPERATIONS}


@pytest.mark.parametrize("kernel", every())
def test_each_kernel_computes_what_casadi_does(kernel: str) -> None:
    made = every_operation()
    found = KERNELS[kernel](made).run(PLACES, np.zeros(0))
    expected = np.array([made(place, np.zeros(0)) for place in PLACES.T]).T
    for name, one, other in zip(made.outputs, found, expected, strict=True):
        np.testing.assert_allclose(one, other, rtol=1e-14, atol=1e-15, err_msg=name)


@pytest.mark.parametrize("name", OPERATIONS)
def test_taylor_models_enclose_what_casadi_computes(name: str) -> None:
    """Over a panel on which the first operand runs through a small stretch, at its middle; a condition is 1."""
    x, y = (1.0 if name in CONDITIONED else 0.3), 0.7
    on = Panels(np.array([x - 1e-3]), np.array([x + 1e-3]), 1e-15)
    for code in OPERATIONS[name].codes:
        made = program(OPERATIONS[name], code)
        inputs = (TaylorModel.time(on), TaylorModel.number(float(y)))
        with np.errstate(all="ignore"):
            (found,) = Stage(made.block, np.zeros(0), [0], taylor())(inputs.__getitem__)
        low, high = found.range() if isinstance(found, TaylorModel) else (np.array([found]), np.array([found]))
        expected = float(made(np.array([x, y]), np.zeros(0))[0])
        assert low[0] <= expected <= high[0]


@pytest.mark.parametrize("kernel", every())
def test_an_operation_beyond_the_table_is_refused_by_name(kernel: str) -> None:
    x = ca.SX.sym("x", 2)
    stage = ExpressionStage(ca.Function("one", [x, ca.SX(0, 1)], [ca.erf(x[0])]))
    made = Program((), stage, ("x", "y"), (), ("erf",))
    with pytest.raises(NotImplementedError, match="OP_ERF"):
        KERNELS[kernel](made).run(PLACES, np.zeros(0))


def test_enclosures_refuse_it_by_name_too() -> None:
    x = ca.SX.sym("x", 2)
    stage = ExpressionStage(ca.Function("one", [x, ca.SX(0, 1)], [ca.erf(x[0])]))
    for kind in (taylor(), BOXES):
        with pytest.raises(NotImplementedError, match="OP_ERF"):
            Stage(stage, np.zeros(0), [0], kind)
