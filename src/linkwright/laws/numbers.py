"""The numbers of which laws are made: floats; arrays (samples, 1), one for each of many samples; duals, whose slopes
are (directions, 1); symbols.

A law of floats is what a file states. Laws of arrays and duals come from the same formulas at other values of the
parameters, and with exact derivatives by these; those of symbols are expressions. NaN stands for a sample that makes no
sense: it is never wrong again.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import reduce
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.notation import Scalar
from linkwright.notation.duals import Dual, slope_of, value_of
from linkwright.notation.jets import call, symbolic
from linkwright.symbols import OrthogonalFactors

Array = NDArray[np.float64]


def plain(*numbers: Scalar) -> bool:
    """Whether all are single numbers without slopes."""
    return all(isinstance(number, int | float) for number in numbers)


def settled(number: Any) -> Scalar:
    """What came out of arithmetic, as a float where it is a single one."""
    return number if isinstance(number, Dual) or symbolic(number) or np.ndim(number) else float(number)


def zero(like: Any) -> Any:
    """0 in the shape of some places."""
    if symbolic(like) or isinstance(like, float):
        return 0.0
    return Dual(np.zeros_like(like.value), 0.0) if isinstance(like, Dual) else np.zeros_like(like)


def backward(width: Scalar) -> bool:
    """Whether a width runs backwards; that of a symbol is a length, which doesn't."""
    return not symbolic(width) and bool(np.any(value_of(width) < 0))


def possible(condition: Any) -> bool:
    """Whether a condition holds for some sample; of a symbol it may."""
    return not condition.is_zero() if symbolic(condition) else bool(np.any(condition))


def either(*conditions: Any) -> Any:
    """Whether one of some conditions holds, of each sample."""
    return reduce(lambda a, b: call("logical_or", a, b), conditions)


def first(number: Scalar, wrong: Any) -> float:
    """A number as it is told: of many samples that of the first that is wrong, of a symbol NaN."""
    if symbolic(number) or symbolic(wrong):
        return float("nan")
    value = value_of(number)
    return float(value) if np.ndim(wrong) == 0 else float(np.extract(wrong, np.broadcast_to(value, np.shape(wrong)))[0])


def largest_of(numbers: Iterable[Any]) -> Any:
    """The largest of some numbers, of each sample."""
    return reduce(lambda a, b: call("maximum", a, b), numbers)


def largest(number: Scalar) -> float:
    """The largest of all samples, 0 where none has a value."""
    return float(np.nan_to_num(np.max(value_of(number), initial=0.0, where=~np.isnan(value_of(number)))))


def off(number: Scalar, size: Scalar, close: float, among: Sequence[Scalar]) -> Any:
    """Whether a number that should be 0 isn't, ``close`` over a ``size``. A dual must stay 0: its slope counts over
    the slopes of those ``among`` which it comes."""
    wrong = call("abs", value_of(number)) > close * call("abs", value_of(size))
    if isinstance(number, Dual):
        return wrong | np.any(np.abs(number.slope) > close * sum(np.abs(slope_of(other)) for other in among))
    return wrong


def solve(rows: Sequence[Sequence[Scalar]], given: Sequence[Scalar]) -> list[Scalar]:
    """The solution of linear equations: of each sample, and differentiated: A dx = db - dA x; of symbols as
    expressions, for few unknowns."""
    if any(symbolic(n) for row in (*rows, given) for n in row):
        return _expressed(rows, given)
    if plain(*given) and all(plain(*row) for row in rows):
        return [float(x) for x in np.linalg.solve(np.array(rows, dtype=float), np.array(given, dtype=float))]
    matrix, right = _stacked([value_of(n) for row in rows for n in row]), _stacked([value_of(n) for n in given])
    matrix = matrix.reshape(*matrix.shape[:-1], len(given), len(given))
    x = _solved(matrix, right)
    found = [x[..., i] if x.ndim > 1 else float(x[i]) for i in range(len(given))]
    if not any(isinstance(n, Dual) for row in (*rows, given) for n in row):
        return found
    slopes = [
        slope_of(b) - sum(slope_of(n) * v for n, v in zip(row, found, strict=True))
        for row, b in zip(rows, given, strict=True)
    ]
    slope = _solved(matrix, _stacked(slopes))
    return [Dual(v, slope[..., i]) for i, v in enumerate(found)]


def _expressed(rows: Sequence[Sequence[Scalar]], given: Sequence[Scalar]) -> list[Scalar]:
    """The solution as expressions: by the inverse of a matrix of numbers, by orthogonal factors of one of symbols,
    which keep the digits that symbolic elimination loses."""
    if all(plain(*row) for row in rows):
        inverse = np.linalg.inv(np.array(rows, dtype=float)).tolist()
        return [sum((k * n for k, n in zip(row, given, strict=True) if k), 0.0) for row in inverse]
    return [*OrthogonalFactors(rows).solve(given)]


def _stacked(numbers: Sequence[Any]) -> Array:
    return np.stack(np.broadcast_arrays(*numbers), axis=-1).astype(float)


def _solved(matrix: Array, right: Array) -> Array:
    """NaN where a matrix is singular."""
    lead = np.broadcast_shapes(matrix.shape[:-2], right.shape[:-1])
    matrix, right = (
        np.broadcast_to(matrix, (*lead, *matrix.shape[-2:])),
        np.broadcast_to(right, (*lead, right.shape[-1])),
    )
    try:
        return np.asarray(np.linalg.solve(matrix, right[..., None])[..., 0])
    except np.linalg.LinAlgError:
        singular = np.linalg.matrix_rank(np.nan_to_num(matrix)) < matrix.shape[-1]
        return np.asarray(
            np.linalg.solve(np.where(singular[..., None, None], np.nan, matrix), right[..., None])[..., 0]
        )
