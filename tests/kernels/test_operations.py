"""The table of operations: every emitter knows each of them, and computes with it what the table says."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np
import pytest

from helpers.emitted import EMITTERS, every_emitter
from helpers.programs import every_operation, of_one
from linkwright.enclosures.panels import Panels
from linkwright.enclosures.program import BOXES, Stage, taylor
from linkwright.enclosures.taylor import TaylorModel
from linkwright.kernels import jax_trace, numpy_blocks, straight_line
from linkwright.symbols import OPERATIONS

WRITTEN_OUT = ("twice", "if_else_zero")
"""What the JAX emitter spells in its own way."""
KNOWN: dict[str, Collection[str]] = {
    "numpy": numpy_blocks.FUNCTIONS,
    "jax": {*jax_trace.NAMES, *WRITTEN_OUT},
    "written": straight_line.WRITABLE,
    "taylor models": taylor().functions,
    "boxes": BOXES.functions,
}
CONDITIONED = ("logical_not", "logical_and", "logical_or", "if_else_zero")
PLACES = np.array([[0.3, -0.6, 0.9, 0.2], [0.7, 0.4, 0.9, -0.8]])
"""Operands at which every operation but a few has a value."""


def test_each_operation_is_entered_under_its_name() -> None:
    assert [each.name for each in OPERATIONS.values()] == [*OPERATIONS]


@pytest.mark.parametrize("emitter", KNOWN)
def test_each_emitter_knows_each_operation_and_no_other(emitter: str) -> None:
    assert {*KNOWN[emitter]} == {*OPERATIONS}


@pytest.mark.parametrize("kernel", every_emitter())
def test_each_kernel_computes_what_the_table_says(kernel: str) -> None:
    made = every_operation()
    found = EMITTERS[kernel](made).run(PLACES, np.zeros(0))
    expected = np.array([made(place, np.zeros(0)) for place in PLACES.T]).T
    for name, one, other in zip(made.outputs, found, expected, strict=True):
        np.testing.assert_allclose(one, other, rtol=1e-14, atol=1e-15, err_msg=name)


@pytest.mark.parametrize("name", OPERATIONS)
def test_taylor_models_enclose_what_the_table_says(name: str) -> None:
    """Over a panel on which the first operand runs through a small stretch, at its middle; a condition is 1."""
    x, y = (1.0 if name in CONDITIONED else 0.3), 0.7
    on = Panels(np.array([x - 1e-3]), np.array([x + 1e-3]), 1e-15)
    made = of_one(OPERATIONS[name])
    inputs = (TaylorModel.time(on), TaylorModel.number(float(y)))
    with np.errstate(all="ignore"):
        (found,) = Stage(made.block, np.zeros(0), [0], taylor())(inputs.__getitem__)
    low, high = found.range() if isinstance(found, TaylorModel) else (np.array([found]), np.array([found]))
    expected = float(made(np.array([x, y]), np.zeros(0))[0])
    assert low[0] <= expected <= high[0]
