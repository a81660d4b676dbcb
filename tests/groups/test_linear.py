"""Systems factored on symbols: their determinants are those of numbers, with their sign."""

from __future__ import annotations

import numpy as np
import pytest

from linkwright.groups.linear import Factor
from linkwright.symbols import ExpressionStage, Symbol


@pytest.mark.parametrize("size", [1, 2, 3, 4, 6])
@pytest.mark.parametrize("holes", [0.0, 0.4])
def test_determinants_on_symbols_have_their_sign(size: int, holes: float) -> None:
    rng = np.random.default_rng([size, int(10 * holes)])
    kept = (rng.uniform(size=(size, size)) >= holes) | np.eye(size, dtype=bool)
    entries = [Symbol.several(f"row{i}", size) for i in range(size)]
    rows = [[entries[i][j] if kept[i, j] else 0.0 for j in range(size)] for i in range(size)]
    free = [symbol for row in entries for symbol in row]
    of_symbols = ExpressionStage(free, [], [Factor(rows).determinant()])
    matrices = [rng.uniform(-1, 1, (size, size)) * kept for _ in range(40)]
    found = [of_symbols.numbers(matrix.ravel(), [])[0] for matrix in matrices]
    assert found == pytest.approx([Factor(matrix.tolist()).determinant() for matrix in matrices], rel=1e-9, abs=1e-14)


@pytest.mark.parametrize("transposed", [False, True])
@pytest.mark.parametrize("size", [1, 2, 3, 4, 6])
@pytest.mark.parametrize("holes", [0.0, 0.4])
def test_solutions_on_symbols_are_those_of_numbers(size: int, holes: float, transposed: bool) -> None:
    rng = np.random.default_rng([size, int(10 * holes), 1])
    kept = (rng.uniform(size=(size, size)) >= holes) | np.eye(size, dtype=bool)
    entries = [Symbol.several(f"row{i}", size) for i in range(size)]
    right = Symbol.several("right", size)
    rows = [[entries[i][j] if kept[i, j] else 0.0 for j in range(size)] for i in range(size)]
    free = [symbol for row in entries for symbol in row]
    of_symbols = ExpressionStage(free, right, Factor(rows).solve(right, transposed))
    for _ in range(40):
        matrix, given = rng.uniform(-1, 1, (size, size)) * kept, rng.uniform(-1, 1, size)
        solution = np.linalg.solve(matrix.T if transposed else matrix, given)
        close = 1e-13 * np.linalg.cond(matrix) * np.abs(solution).max()
        assert of_symbols.numbers(matrix.ravel(), given) == pytest.approx(solution, abs=close)
