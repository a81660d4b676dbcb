"""Small linear systems on numbers or symbols: one factorisation serves rates, reactions and the determinant."""

from __future__ import annotations

import numpy as np

from linkwright.notation import Scalar
from linkwright.notation.jets import symbolic
from linkwright.symbols import OrthogonalFactors


class Factor:
    """A square matrix factored once: symbols orthogonally, numbers by LAPACK."""

    def __init__(self, rows: list[list[Scalar]]) -> None:
        self.size = len(rows)
        self.symbolic = any(symbolic(entry) for row in rows for entry in row)
        self.matrix = None if self.symbolic else np.array(rows, dtype=float)
        self.factors = OrthogonalFactors(rows) if self.symbolic else None

    def solve(self, right: list[Scalar], transposed: bool = False) -> list[Scalar]:
        """The solution of A x = right, or of the transposed system."""
        if self.factors is not None:
            return [*self.factors.solve(right, transposed)]
        assert self.matrix is not None
        matrix = self.matrix.T if transposed else self.matrix
        if any(map(symbolic, right)):  # a closure of fixed slopes, such as slides on the frame
            inverse = np.linalg.inv(matrix).tolist()
            return [sum((k * entry for k, entry in zip(row, right, strict=True)), 0.0) for row in inverse]
        return [float(v) for v in np.linalg.solve(matrix, right)]

    def determinant(self) -> Scalar:
        """The determinant."""
        if self.factors is not None:
            return self.factors.determinant()
        assert self.matrix is not None
        return float(np.linalg.det(self.matrix))
