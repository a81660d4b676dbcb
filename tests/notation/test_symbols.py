"""Symbols make the nodes that CasADi's own operators make."""

from __future__ import annotations

import operator
from typing import Any

import casadi as ca
import numpy as np
import pytest

from linkwright.notation.jets import call, symbolic
from linkwright.notation.symbols import Symbol, column

BY = {"add": operator.add, "sub": operator.sub, "mul": operator.mul, "truediv": operator.truediv}
OTHERS = [0.0, 1.0, -1.0, 2, True, np.float64(0.5), ca.SX(3), ca.SX.sym("plain"), ca.SX.sym("column", 2)]


def same(a: Any, b: Any) -> bool:
    return str(a) == str(b) and a.shape == b.shape


@pytest.mark.parametrize("name", BY)
@pytest.mark.parametrize("other", OTHERS, ids=str)
def test_operators(name: str, other: Any) -> None:
    by, own, plain = BY[name], Symbol.named("a"), ca.SX.sym("a")
    for found, expected in ((by(own, other), by(plain, other)), (by(other, own), by(other, plain))):
        assert same(found, expected)
        assert isinstance(found, Symbol) or isinstance(other, np.number)  # NumPy asks CasADi first
    assert same(-own, -plain)
    assert isinstance(-own, Symbol)


@pytest.mark.parametrize(
    "name", ["sin", "cos", "sqrt", "abs", "arcsin", "arccos", "arctan", "exp", "log", "floor", "tan", "sign"]
)
def test_functions_of_one_number(name: str) -> None:
    casadi = {"abs": "fabs", "arcsin": "asin", "arccos": "acos", "arctan": "atan"}.get(name, name)
    assert same(call(name, Symbol.named("a")), getattr(ca, casadi)(ca.SX.sym("a")))


@pytest.mark.parametrize(("name", "casadi"), [("arctan2", "atan2"), ("copysign", "copysign"), ("maximum", "fmax")])
def test_functions_of_two(name: str, casadi: str) -> None:
    own, plain = Symbol.named("a"), ca.SX.sym("a")
    assert same(call(name, own, 2.0), getattr(ca, casadi)(plain, 2.0))
    assert same(call(name, 2.0, own), getattr(ca, casadi)(2.0, plain))


def test_arrays_are_casadis_to_dispatch() -> None:
    own, plain, row = Symbol.named("a"), ca.SX.sym("a"), np.array([[1.0, 2.0]])
    assert same(own * row, plain * row)
    assert same(own + ca.DM([1, 2]), plain + ca.DM([1, 2]))


def test_what_is_symbolic() -> None:
    assert symbolic(Symbol.named("a"))
    assert symbolic(ca.SX.sym("a"))
    assert not any(map(symbolic, (1.0, np.zeros(2), None)))


def test_a_column_takes_numbers() -> None:
    assert isinstance(column([]), ca.SX)
    assert isinstance(column([0.0, 1.0]), ca.SX)
    assert column([0.0, Symbol.named("a")]).shape == (2, 1)
