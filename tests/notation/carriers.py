"""Jets on floats, NumPy arrays and symbols: one computation carried by each of the three."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import factorial
from typing import Any

import mpmath
import numpy as np

from linkwright.notation import Jet
from linkwright.symbols import ExpressionStage, Symbol

Rows = Sequence[Sequence[float]]
"""Jets as plain numbers: for each argument its value and derivatives."""


def on_floats(f: Callable[..., Jet], *rows: Sequence[float]) -> list[float]:
    return [float(d) for d in f(*(Jet(row) for row in rows)).d]


def on_arrays(f: Callable[..., Jet], *rows: Sequence[float]) -> list[float]:
    """The same in the last of three places of arrays, the other two taken by neighbours."""
    shifts = np.array([0.01, -0.003, 0.0])
    jets = [Jet([row[0] + shifts, *(np.full(3, d) for d in row[1:])]) for row in rows]
    return [float(np.broadcast_to(d, 3)[2]) for d in f(*jets).d]


def on_symbols(f: Callable[..., Jet], *rows: Sequence[float]) -> list[float]:
    jets = [Jet(Symbol.several(f"x{i}", len(row))) for i, row in enumerate(rows)]
    result = f(*jets)
    symbols = [d for jet in jets for d in jet.d]
    return ExpressionStage(symbols, [], result.d).numbers([v for row in rows for v in row], [])


CARRIERS: dict[str, Callable[..., list[float]]] = {
    "floats": on_floats,
    "arrays": on_arrays,
    "symbols": on_symbols,
}


def exact(f: Callable[..., Any], *rows: Sequence[float], order: int | None = None) -> list[float]:
    """The derivatives of ``f`` of polynomials with the given derivatives, from mpmath's Taylor coefficients."""
    order = min(len(row) for row in rows) - 1 if order is None else order

    def composed(t: Any) -> Any:
        return f(*(sum(mpmath.mpf(d) * t**k / factorial(k) for k, d in enumerate(row)) for row in rows))

    with mpmath.workdps(50):
        return [float(c * factorial(k)) for k, c in enumerate(mpmath.taylor(composed, 0, order))]


def assert_close(found: Sequence[float], wanted: Sequence[float], tolerance: float = 1e-11) -> None:
    """Every derivative to a share of the largest one up to its order."""
    assert len(found) == len(wanted)
    scale = np.maximum.accumulate(np.maximum(np.abs(wanted), 1e-3))
    assert np.all(np.abs(np.array(found) - wanted) <= tolerance * scale), (found, wanted)
