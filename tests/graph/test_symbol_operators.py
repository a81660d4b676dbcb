"""Operators of symbols make the nodes that CasADi's own functions make."""

from __future__ import annotations

import itertools
import operator
from collections.abc import Callable
from typing import Any

import casadi as ca
import numpy as np
import pytest

from linkwright.graph import symbol_operators
from linkwright.notation.jets import call

X, Y, V, M = ca.SX.sym("x"), ca.SX.sym("y"), ca.SX.sym("v", 3), ca.SX.sym("M", 3, 3)
SPARSE = ca.SX(3, 3)
SPARSE[0, 1] = X
SYMBOLS = [X, Y, V, M, SPARSE, X * Y + 1, -X, ca.SX(0), ca.SX(1)]
OTHERS = [
    *SYMBOLS,
    2.0,
    0.0,
    -0.0,
    1.0,
    -1.0,
    3,
    0,
    True,
    np.float64(2.5),
    np.int64(3),
    np.ones(3),
    ca.DM([1, 2, 3]),
    np.nan,
]
OWN = {"add": ca.plus, "sub": ca.minus, "mul": ca.times, "truediv": ca.rdivide}
ODD = [ca.SX.sym("w", 2), "a", None, [1.0, "b"]]


def same(one: Any, other: Any) -> bool:
    """Whether two expressions are one graph, with the same places filled; NaN is no node like another."""
    alike = ca.is_equal(one, other, 100) or str(one) == str(other)
    return bool(one.sparsity() == other.sparsity() and alike)


@pytest.mark.parametrize("name", symbol_operators.CODES)
def test_the_nodes_are_casadis(name: str) -> None:
    python: Callable[[Any, Any], Any] = getattr(operator, name)
    for one, other in itertools.product(SYMBOLS, OTHERS):
        assert same(python(one, other), OWN[name](one, other)), (one, other)
        assert same(python(other, one), OWN[name](other, one)), (other, one)


@pytest.mark.parametrize("name", symbol_operators.CODES)
def test_what_cannot_be_is_an_error_still(name: str) -> None:
    python: Callable[[Any, Any], Any] = getattr(operator, name)
    for odd in ODD:
        for pair in ((V, odd), (odd, V)):
            with pytest.raises((TypeError, NotImplementedError, RuntimeError)):
                python(*pair)


def test_elementary_functions_are_casadis() -> None:
    names = {"sin": ca.sin, "sqrt": ca.sqrt, "arctan": ca.atan, "arcsin": ca.asin, "abs": ca.fabs, "exp": ca.exp}
    for name, own in names.items():
        for symbol in SYMBOLS:
            assert same(call(name, symbol), own(symbol)), (name, symbol)
