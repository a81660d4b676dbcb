"""Margins of large groups by the numbers of their matrix, against the expressions and differences."""

from __future__ import annotations

import numpy as np
import pytest

from helpers.compiled import compiled_from
from helpers.lifts import lift
from linkwright.graph.rows import Determinant
from linkwright.results import large_groups
from linkwright.results.large_groups import rows_with_rates


@pytest.mark.parametrize("stages", [1, 2, 3])
def test_they_are_those_of_the_expressions(stages: int, monkeypatch: pytest.MonkeyPatch) -> None:
    compiled = compiled_from({"linkwright": 1, **lift(stages, "platform")})
    rows = [Determinant(group.label) for group in compiled.structure.higher_groups]
    assert rows and all(len(group.free) > 1 for group in compiled.structure.higher_groups)
    t = np.linspace(0.0, 1.0, 7)
    monkeypatch.setattr(large_groups, "LARGE", 100)
    expressions = rows_with_rates(compiled, rows, t)
    monkeypatch.setattr(large_groups, "LARGE", 1)
    numbers = rows_with_rates(compiled, rows, t)
    assert np.abs(numbers[0]) == pytest.approx(np.abs(expressions[0]), rel=1e-11)
    change = np.sign(numbers[0]) * numbers[1], np.sign(expressions[0]) * expressions[1]
    assert change[0] == pytest.approx(change[1], rel=1e-9, abs=1e-13)
    (value,), _ = rows_with_rates(compiled, rows, t, rates=False)
    assert value == pytest.approx(numbers[0][0], rel=1e-14)
