"""Lists of instructions: what rows need, each part once, in few slots."""

from __future__ import annotations

import numpy as np

from linkwright.symbols import INPUT, OUTPUT, ExpressionStage, Symbol, as_symbol


def test_common_parts_are_done_once_and_others_not_at_all() -> None:
    x, y, unused = Symbol.several("x", 3)
    shared = x.do("sin") * y
    stage = ExpressionStage([x, y, unused], [], [shared + 1.0, shared - y, shared])
    operations = [i.op for i in stage.instructions]
    assert operations.count("sin") == operations.count("multiply") == 1
    assert operations.count(INPUT) == 2
    assert operations.count(OUTPUT) == stage.rows == 3
    assert stage.used == (frozenset({0, 1}), frozenset())


def test_slots_are_used_again() -> None:
    """A sum of a hundred products never needs more than three values at once."""
    x, p = Symbol.several("x", 100), Symbol.several("p", 100)
    total = as_symbol(0.0)
    for a, b in zip(x, p, strict=True):
        total = total + a * b
    stage = ExpressionStage(x, p, [total])
    assert stage.slots <= 3
    values = np.random.default_rng(1).uniform(-1, 1, (2, 100))
    assert abs(stage.numbers(values[0], values[1])[0] - values[0] @ values[1]) < 1e-13


def test_a_row_may_be_an_input_a_number_or_another_row() -> None:
    x, p = Symbol.named("x"), Symbol.named("p")
    stage = ExpressionStage([x], [p], [x, p, 7.25, x, x + p])
    assert stage.numbers([2.0], [3.0]) == [2.0, 3.0, 7.25, 2.0, 5.0]
    assert stage.arrays([np.array([1.0, 2.0])], [3.0]).tolist() == [[1, 2], [3, 3], [7.25, 7.25], [1, 2], [4, 5]]


def test_rows_at_other_symbols() -> None:
    x, p, q = Symbol.several("x", 3)
    stage = ExpressionStage([x], [p], [x * p, x.do("cos")])
    assert stage.symbols([q + 1.0], [q]) == [(q + 1.0) * q, (q + 1.0).do("cos")]
