"""The pieces of a curve of many samples side by side: each place picks the numbers of its own piece."""

from __future__ import annotations

from collections.abc import Sequence
from math import perm

import numpy as np
from numpy.typing import NDArray

from linkwright.laws.pieces import Piece, Wave

Array = NDArray[np.float64]


class Stack:
    """Pieces of floats and arrays (samples, 1): the same sums in the same order as :meth:`Piece.at` gives them."""

    def __init__(self, pieces: Sequence[Piece]) -> None:
        self.origin = _rows([piece.origin for piece in pieces])
        degree = max(len(piece.powers) for piece in pieces)
        self.powers = [_rows([_nth(piece.powers, i) for piece in pieces]) for i in range(degree)]
        self.waves: list[tuple[bool, Array, Array]] = []
        for even in (True, False):
            rows = [[wave for wave in piece.waves if wave.even == even] for piece in pieces]
            for i in range(max(map(len, rows))):
                some = [row[i] if i < len(row) else Wave(0.0, 0.0) for row in rows]
                self.waves.append((even, _rows([w.amplitude for w in some]), _rows([w.rate for w in some])))

    def at(self, x: Array, which: NDArray[np.intp], order: int) -> Array:
        """A derivative at places ``x``, (places,) or (samples, places), in the pieces ``which``."""

        def pick(rows: Array) -> Array:
            if rows.shape[1] == 1:
                return np.asarray(rows[which, 0])
            return np.asarray(rows[which, np.arange(rows.shape[1])[:, None]])

        z = x - pick(self.origin)
        total = np.zeros_like(z)
        for i in range(len(self.powers) - 1, order - 1, -1):
            total = total * z + perm(i, order) * pick(self.powers[i])
        for even, amplitude, rate in self.waves:
            quarter = (order + even) % 4
            factor = pick(rate)
            size = pick(amplitude) * (factor * np.pi) ** order
            function = np.cos if quarter % 2 else np.sin
            total = total + (-size if quarter > 1 else size) * function(np.pi * (factor * z))
        return total


def _nth(numbers: Sequence[Array], i: int) -> Array | float:
    return numbers[i] if i < len(numbers) else 0.0


def _rows(numbers: Sequence[Array | float]) -> Array:
    """Numbers of pieces as (pieces, samples), or (pieces, 1) where all samples have the same."""
    return np.stack(np.broadcast_arrays(*(np.ravel(number) for number in numbers))).astype(float)
