"""Small linear systems on numbers or symbols: one factorisation serves rates, reactions and the determinant."""

from __future__ import annotations

from typing import Any

import numpy as np

from linkwright.notation import Scalar
from linkwright.notation.jets import symbolic


class Factor:
    """A square matrix factored once. Symbols by CasADi's sparse QR (it keeps its digits where plain symbolic
    elimination loses them), numbers by LAPACK."""

    def __init__(self, rows: list[list[Scalar]]) -> None:
        self.size = len(rows)
        self.symbolic = any(symbolic(entry) for row in rows for entry in row)
        if not self.symbolic:
            self.matrix: Any = np.array(rows, dtype=float)
            return
        import casadi as ca

        self.matrix = ca.sparsify(ca.vertcat(*(ca.horzcat(*row) for row in rows)))
        self.qr: Any = ca.qr_sparse(self.matrix)

    def solve(self, right: list[Scalar], transposed: bool = False) -> list[Scalar]:
        """The solution of A x = right, or of the transposed system."""
        if not self.symbolic:
            matrix = self.matrix.T if transposed else self.matrix
            if any(map(symbolic, right)):  # a closure of fixed slopes, such as slides on the frame
                inverse = np.linalg.inv(matrix).tolist()
                return [sum((k * entry for k, entry in zip(row, right, strict=True)), 0.0) for row in inverse]
            return [float(v) for v in np.linalg.solve(matrix, right)]
        import casadi as ca

        v, r, beta, prinv, pc = self.qr
        x = ca.qr_solve(ca.densify(ca.vertcat(*right)), v, r, beta, prinv, pc, transposed)
        return [x[i] for i in range(self.size)]

    def determinant(self) -> Scalar:
        """The determinant, up to a sign that never changes."""
        if not self.symbolic:
            return float(np.linalg.det(self.matrix))
        import casadi as ca

        # CasADi's diagonal of R is not negative: the sign is that of the reflections I - beta v v', of which each has
        # the determinant 1 - beta v'v, which is -1, or 1 where there was nothing to reflect.
        (v, r, beta), product = self.qr[:3], 1.0
        for i in range(self.size):
            product = product * r[i, i] * (1.0 - beta[i] * ca.sumsqr(v[:, i]))
        return product
