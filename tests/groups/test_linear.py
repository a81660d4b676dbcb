"""Systems factored on symbols: their determinants have the sign of those of numbers, up to one that never changes."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

from linkwright.groups.linear import Factor


@pytest.mark.parametrize("size", [1, 2, 3, 4, 6])
@pytest.mark.parametrize("holes", [0.0, 0.4])
def test_determinants_on_symbols_have_their_sign(size: int, holes: float) -> None:
    rng = np.random.default_rng([size, int(10 * holes)])
    kept = (rng.uniform(size=(size, size)) >= holes) | np.eye(size, dtype=bool)
    entries = ca.SX.sym("entries", size, size)
    rows = [[entries[i, j] if kept[i, j] else 0.0 for j in range(size)] for i in range(size)]
    of_symbols = ca.Function("determinant", [entries], [Factor(rows).determinant()])
    matrices = [rng.uniform(-1, 1, (size, size)) * kept for _ in range(40)]
    ratios = np.array([float(of_symbols(matrix)) / Factor(matrix.tolist()).determinant() for matrix in matrices])
    assert np.abs(ratios) == pytest.approx(1.0, rel=1e-9)
    assert len({*np.sign(ratios).tolist()}) == 1
