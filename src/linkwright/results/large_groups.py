"""The margin to singularity of groups of many equations, from the numbers of their matrix instead of by expressions.

As an expression it has a solution for each equation (:meth:`SolvedHigherGroup.margin`), which takes long to make for a
scissor lift of many stages; the matrix itself is sparse. For A with the column lengths l, B = A^-1 and S the sum of
(l_i |row i of B|)^2, the margin is sqrt(n/S) with the sign of the determinant. Its rate follows from dB = -B dA B.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright.graph.rows import Determinant, Row, Slope
from linkwright.kernels import Compiled

Array = NDArray[np.float64]

LARGE = 6
"""Groups of more equations are taken by numbers."""


def rows_with_rates(compiled: Compiled, rows: Sequence[Row], t: Array, rates: bool = True) -> tuple[Array, Array]:
    """Rows and their rates at times t (s): (rows, times) each; the rates are zero unless they are asked for."""
    large = {one.label: len(one.free) for one in compiled.structure.higher_groups if len(one.free) > LARGE}
    of_large = {i: row.group for i, row in enumerate(rows) if isinstance(row, Determinant) and row.group in large}
    asked: list[Row] = [row for i, row in enumerate(rows) if i not in of_large]
    for group in of_large.values():
        asked += [Slope(group, index) for index in range(large[group] ** 2)]
    if rates:
        found, slopes = compiled.rates(asked, t)
    else:
        found = compiled.evaluate(asked, t)
        slopes = np.zeros_like(found)
    values, changes = np.empty((2, len(rows), t.size))
    plain = [i for i in range(len(rows)) if i not in of_large]
    values[plain], changes[plain] = found[: len(plain)], slopes[: len(plain)]
    first = len(plain)
    for i, group in of_large.items():
        n = large[group]
        entries = (part[first : first + n * n].T.reshape(-1, n, n) for part in (found, slopes))
        values[i], changes[i] = _margins(*entries)
        first += n * n
    return values, changes


def _margins(matrix: Array, change: Array) -> tuple[Array, Array]:
    """The margins of matrices with their rates (poses, n, n); undefined where a matrix has no inverse."""
    n = matrix.shape[-1]
    signs = np.linalg.slogdet(matrix)[0]
    sound = np.isfinite(matrix).all(axis=(1, 2)) & (signs != 0)
    regular = np.where(sound[:, None, None], matrix, np.eye(n))
    inverse = np.linalg.inv(regular)
    moved = -inverse @ np.where(sound[:, None, None], change, 0.0) @ inverse
    lengths = (regular**2).sum(axis=1)  # squares, as their rates below
    longer = 2 * (regular * change).sum(axis=1)
    sizes, wider = (inverse**2).sum(axis=2), 2 * (inverse * moved).sum(axis=2)
    total = (lengths * sizes).sum(axis=1)
    grown = (longer * sizes + lengths * wider).sum(axis=1)
    margin = signs * np.sqrt(n / total)
    rate = -margin * grown / (2 * total)
    return np.where(sound, margin, np.nan), np.where(sound, rate, np.nan)
