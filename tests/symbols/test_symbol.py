"""Symbols: each made once, simplified as it is made, and gone when nobody holds it."""

from __future__ import annotations

import gc
import math
from typing import Any

import numpy as np
import pytest

from linkwright.notation import Jet
from linkwright.symbols import (
    ExpressionStage,
    Symbol,
    as_symbol,
    choice,
    derivatives_along,
    ordered,
    symbol,
    without_collection,
)

x, y, z = Symbol.several("x", 3)
HOLDS = x < y


def test_what_is_made_alike_is_one() -> None:
    assert x * y + z is x * y + z
    assert as_symbol(0.5) is as_symbol(0.5)
    assert as_symbol(0.0) is not as_symbol(-0.0)
    assert Symbol.named("same") is not Symbol.named("same")


SIMPLER: list[tuple[Any, Any]] = [
    (x + 0.0, x), (0.0 + x, x), (x + x, 2.0 * x), (x + (-y), x - y), ((-x) + y, y - x), ((x - y) + y, x),
    (x + (y - x), y), (x + 2.0 * x, 3.0 * x), (x.do("sin") ** 2 + x.do("cos") ** 2, as_symbol(1.0)),
    (x - 0.0, x), (0.0 - x, -x), (x - x, as_symbol(0.0)), (x - (-y), x + y), ((x + y) - y, x), ((x + y) - x, y),
    (x - (x + y), -y), ((-x) - y, -(x + y)), (2.0 * x - x, x), ((-x).do("negative"), x),
    (x * 1.0, x), (x * -1.0, -x), (x * 0.0, as_symbol(0.0)), (x * x, x.do("square")), (x * 2.0, x.do("twice")),
    (3.0 * (2.0 * x), 6.0 * x), (3.0 * (x * 5.0), 15.0 * x), (x * (-y), -(x * y)), ((-x) * (-y), x * y),
    (x * (y / x), y), ((1.0 / x) * y, y / x), (choice(HOLDS, x, 0.0) * z, choice(HOLDS, x * z, 0.0)),
    (0.0 / x, as_symbol(0.0)), (x / x, as_symbol(1.0)), (x / 1.0, x), (1.0 / x, x.do("reciprocal")),
    ((x * y) / x, y), ((-x) / y, -(x / y)), (x / (1.0 / y), x * y), ((2.0 * x) / (2.0 * y), x / y),
    (x**0.0, as_symbol(1.0)), (x**1.0, x), (x**2, x * x), (x**4, (x * x) * (x * x)), (x**-2, 1.0 / (x * x)),
    (x**0.5, x.do("sqrt")), ((x * x).do("sqrt"), abs(x)), (x.do("sqrt") ** 2, x), (abs(-x), abs(x)),
    ((-x).do("cos"), x.do("cos")), (x.do("exp").do("log"), x), (x < x, as_symbol(0.0)), (x <= x, as_symbol(1.0)),
    (choice(1.0, x, y), x), (choice(0.0, x, y), y), (x.do("fmin", x), x),
]  # fmt: skip
"""Pairs of which each first one comes out as the second."""


@pytest.mark.parametrize(("found", "simpler"), SIMPLER, ids=lambda one: repr(one))
def test_simplification(found: Symbol, simpler: Symbol) -> None:
    assert found is simpler


@pytest.mark.parametrize("operation", [math.exp, abs, math.sqrt], ids=lambda one: one.__name__)
def test_numbers_are_done_at_once(operation: Any) -> None:
    name = {"abs": "fabs"}.get(operation.__name__, operation.__name__)
    assert as_symbol(2.0).do(name) is as_symbol(operation(2.0))


@pytest.mark.parametrize(
    ("name", "operands", "value"),
    [("divide", (1.0, 0.0), math.inf), ("divide", (0.0, 0.0), math.nan), ("log", (0.0,), -math.inf),
     ("sqrt", (-1.0,), math.nan), ("power", (0.0, -1.0), math.inf), ("exp", (1e3,), math.inf),
     ("reciprocal", (-0.0,), -math.inf), ("fmin", (math.nan, 1.0), 1.0), ("floor", (math.inf,), math.inf)],
)  # fmt: skip
def test_numbers_without_a_finite_result_follow_ieee(name: str, operands: tuple[float, ...], value: float) -> None:
    first, *others = map(as_symbol, operands)
    np.testing.assert_equal(float(first.do(name, *others)), value)


def test_what_is_not_chosen_may_be_nan() -> None:
    root = choice(x > 0.0, x.do("sqrt"), 0.0)
    stage = ExpressionStage([x], [], [root, *derivatives_along([root], {x: as_symbol(1.0)})])
    assert stage.numbers([-4.0], []) == [0.0, 0.0]
    assert stage.numbers([4.0], []) == [2.0, 0.25]


def test_other_kinds_of_numbers_have_their_way() -> None:
    jet = Jet([1.0, 2.0])
    assert isinstance(x * jet, Jet)
    assert isinstance(jet - x, Jet)
    assert np.float64(2.0) * x is x.do("twice")
    with pytest.raises(TypeError):
        x + np.ones(2)
    with pytest.raises(TypeError):
        x + "1"  # type: ignore[operator]


def test_a_symbol_without_a_value_is_neither_true_nor_a_number() -> None:
    assert as_symbol(2.0)
    for asked in (bool, float):
        with pytest.raises(TypeError):
            asked(x)
    with pytest.raises(NotImplementedError, match="erf"):
        x.do("erf")


def test_symbols_that_nobody_holds_are_gone() -> None:
    gc.collect()
    before = sum(map(len, symbol._TABLES.values()))
    rows = [x.do("sin") * k + y.do("cos") ** k for k in range(3, 40)]
    assert sum(map(len, symbol._TABLES.values())) > before + 100
    del rows
    gc.collect()
    assert sum(map(len, symbol._TABLES.values())) == before


def test_graphs_may_be_deep() -> None:
    """Without recursion, when they are walked, differentiated, listed and given up."""
    deep, count = x, 50_000
    for _ in range(count):
        deep = (deep * y).do("sin")
    assert len(ordered([deep])) == 2 * count + 2
    (slope,) = derivatives_along([deep], {y: as_symbol(1.0)})
    stage = ExpressionStage([x, y], [], [deep, slope])
    assert all(map(math.isfinite, stage.numbers([0.5, 0.9], [])))
    del deep, slope


def test_collection_is_paused_and_goes_on() -> None:
    """Whatever happens meanwhile; and where it was off it stays so."""
    assert gc.isenabled()
    with pytest.raises(KeyError), without_collection():
        assert not gc.isenabled()
        with without_collection():
            pass
        assert not gc.isenabled()
        raise KeyError
    assert gc.isenabled()
