"""What is emitted for other machines: the bits of the LLVM emitter's poses, in every form; faults are seen.

Only the bits of NaN and the sign of zero have no meaning.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import scaling

from helpers.emitted import RUNNERS, runners
from helpers.programs import EVERY, every_operation, nested, random_program, rows_of
from linkwright.compilation import compile_mechanism
from linkwright.graph.program import Program
from linkwright.kernels import (
    division,
    javascript_code,
    javascript_source,
    webassembly_code,
    webassembly_module,
)
from linkwright.kernels.javascript_source import labels
from linkwright.kernels.llvm_kernel import PoseFunction
from linkwright.kernels.straight_line import PRIMITIVES, Code, written
from linkwright.model.document import load
from linkwright.symbols import OPERATIONS

pytest.importorskip("llvmlite")

EXAMPLES = Path(__file__).parents[2] / "examples"
Array = np.ndarray
Case = tuple[Program, Array, Array]


def bits(found: Array) -> bytes:
    """All bits that have a meaning."""
    return np.where(np.isnan(found), np.nan, found + 0.0).tobytes()


def expected(case: Case) -> Array:
    """By the machine code of one pose."""
    program, x, p = case
    function = PoseFunction(program)
    return np.array([function(pose, p) for pose in x.T]).T


def same(runner: str, *cases: Case) -> bool:
    """Whether a runner gives the same bits."""
    return all(bits(RUNNERS[runner](case[0]).run(case[1], case[2])) == bits(expected_once(case)) for case in cases)


_EXPECTED: dict[int, Array] = {}


def expected_once(case: Case) -> Array:
    """Kept, as cases are: they are made once."""
    if id(case) not in _EXPECTED:
        _EXPECTED[id(case)] = expected(case)
    return _EXPECTED[id(case)]


def seen(runner: str, *cases: Case) -> bool:
    """Whether a fault is seen: other bits, or code that is refused."""
    try:
        return not same(runner, *cases)
    except AssertionError as refused:
        return "SyntaxError" in str(refused)


# Cases.

HARD = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    2.0,
    np.inf,
    -np.inf,
    np.nan,
    5e-324,
    -1e-310,
    1e300,
    -1.7e308,
    3e7,
    2e8,
    -2.5,
    2**0.5,
]
"""Operands of every operation, in pairs; the last is where a logarithm goes on to the next power of two."""


@cache
def operations() -> Case:
    random = np.random.default_rng(11)
    pairs = np.array([(a, b) for a in HARD for b in HARD]).T
    some = random.normal(0.0, 2.0, (2, 200)) * 10.0 ** random.integers(-3, 4, (2, 200))
    return every_operation(), np.concatenate([pairs, some], axis=1), np.zeros(0)


@cache
def instructions() -> Case:
    """All that a program may hold, of parameters alone too."""
    x = np.random.default_rng(5).normal(0.0, 3.0, (1, 60))
    return rows_of(*EVERY), x, np.array([1.3])


@cache
def newton(name: str) -> Case:
    """A group beyond the dyads from starts that are 0.1 % off; two that lead nowhere."""
    compiled = compile_mechanism(load(EXAMPLES / f"{name}.yaml"))
    program = compiled.graph.solving(compiled.structure.higher_groups[0])
    x = compiled.inputs(np.linspace(0.0, 0.7, 40))
    rows, scale = list(program.solves[0].rows), np.array(program.solves[0].scale)[:, None]
    x[rows] += 1e-3 * scale * np.random.default_rng(0).standard_normal((len(rows), x.shape[1]))
    x[rows[0], 7], x[rows[0], 9], x[rows[0], 11] = np.nan, np.inf, 1e3
    return program, x, compiled.parameters


@cache
def random_case(seed: int) -> Case:
    random = np.random.default_rng(seed)
    return random_program(seed), random.normal(0.0, 1.5, (3, 40)), random.uniform(0.5, 2.0, 2)


@cache
def brackets() -> Case:
    return nested(), np.random.default_rng(4).normal(0.0, 2.0, (3, 12)), np.zeros(0)


@cache
def chain() -> Case:
    compiled = compile_mechanism(scaling.chain(6))
    x = compiled.inputs(np.linspace(0.0, 1.0, 9))
    return compiled.graph.program(scaling.outputs(6)), x, compiled.parameters


SEEDS = range(6)


# Agreement.


@pytest.mark.parametrize("runner", runners())
def test_every_operation(runner: str) -> None:
    assert same(runner, operations(), instructions(), brackets())


@pytest.mark.parametrize("runner", runners())
def test_every_instruction_in_all_forms(runner: str) -> None:
    """One set of parameters, one of each pose, samples: against CasADi to 4 units in the last place."""
    program, made = rows_of(*EVERY), RUNNERS[runner](rows_of(*EVERY))
    x = np.array([[-7.5, -3.0, -1.0, -0.25, 1e-3, 0.5, 1.0, 2.0, 3.25, 8.0]])
    p = np.array([[2.0, 0.7]])
    true = np.array([[program(x[:, i], p[:, s]) for i in range(x.shape[1])] for s in range(2)]).transpose(2, 0, 1)
    over = made.over(x, p)
    each = made.run(np.tile(x, 2), np.repeat(p, x.shape[1], axis=1)).reshape(true.shape)
    assert bits(over) == bits(each) == bits(made.over(np.repeat(x[:, None], 2, axis=1), p))
    assert np.array_equal(np.isnan(over), np.isnan(true))
    known = np.isfinite(true)
    assert np.array_equal(over[~known], true[~known], equal_nan=True)
    assert (np.abs(over[known] - true[known]) <= 4 * np.spacing(np.abs(true[known]))).all()


@pytest.mark.parametrize("name", ["sauer_platform", "class_four"])
@pytest.mark.parametrize("runner", runners())
def test_newton(runner: str, name: str) -> None:
    case = newton(name)
    assert same(runner, case)
    lost = np.isnan(expected_once(case)).all(axis=0)
    assert lost[[7, 9]].all()
    assert lost.sum() < 5


@pytest.mark.parametrize("runner", runners())
def test_random_programs(runner: str) -> None:
    assert same(runner, *map(random_case, SEEDS))


def test_random_programs_are_worth_running() -> None:
    """Together they have every operation, and most of their figures are numbers that differ from pose to pose."""
    cases = [random_case(seed) for seed in SEEDS]
    assert {*OPERATIONS} <= {instruction.op for program, _, _ in cases for instruction in program.block.instructions}
    found = np.concatenate([expected_once(case) for case in cases])
    assert np.isfinite(found).mean() > 0.6
    assert (np.nanmax(found, axis=1, initial=-np.inf) != np.nanmin(found, axis=1, initial=np.inf)).mean() > 0.5


@pytest.mark.parametrize("longest", [1, 7, 60])
@pytest.mark.parametrize("runner", runners())
def test_the_length_of_functions_has_no_say(runner: str, longest: int, monkeypatch: pytest.MonkeyPatch) -> None:
    for module in (javascript_source, webassembly_module):
        monkeypatch.setattr(module, "LONGEST", longest)
    assert same(runner, chain(), newton("sauer_platform"), random_case(0))


HOSTILE = ("</script><script>alert(1)</script>", "a\"b'c`${d}", "line\nbreak\u2028\\", "*/ eval(name) //", "名")


@pytest.mark.parametrize("runner", runners())
def test_no_name_of_a_model_enters_code(runner: str) -> None:
    """Names that would end a script or a text leave the code as it is, byte for byte; they stand beside it, as data."""
    program, x, p = chain()
    named = {
        key: tuple(f"{HOSTILE[k % len(HOSTILE)]}{k}" for k in range(len(getattr(program, key))))
        for key in ("inputs", "parameters", "outputs")
    }
    hostile = replace(program, **named)
    made, plain = RUNNERS[runner](hostile), RUNNERS[runner](program)
    assert made.code == plain.code
    assert bits(made.run(x, p)) == bits(expected_once(chain()))
    assert {key: tuple(names) for key, names in json.loads(json.dumps(labels(hostile))).items()} == named


# Faults.

TABLES: dict[str, dict[str, Any]] = {"javascript": javascript_code.WORDS, "webassembly": webassembly_code.WORDS}
SWAPPED = {
    "add": "subtract", "subtract": "add", "multiply": "divide", "divide": "multiply", "negative": "fabs",
    "sqrt": "fabs", "fabs": "sqrt", "floor": "fabs", "less": "less_equal", "less_equal": "less", "greater": "less",
    "greater_equal": "greater", "equal": "not_equal", "not_equal": "equal", "and": "or", "or": "and",
}  # fmt: skip
"""Of each primitive that is a word, another that is nearly right."""


@pytest.mark.parametrize("primitive", SWAPPED)
@pytest.mark.parametrize("runner", runners())
def test_a_wrong_word_is_seen(runner: str, primitive: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(TABLES[runner], primitive, TABLES[runner][SWAPPED[primitive]])
    assert seen(runner, operations())


WRONG: list[tuple[str, Any, str, Any]] = [
    ("javascript", javascript_code.WORDS, "select", javascript_code.Word("{0}?{2}:{1}", 1, (2, 1, 1))),
    ("javascript", javascript_code.WORDS, "subtract", javascript_code.Word("{}-{}", 6, (6, 6))),
    ("javascript", javascript_code.WORDS, "divide", javascript_code.Word("{}/{}", 7, (7, 7))),
    ("javascript", javascript_code.WORDS, "negative", javascript_code.Word("-{}", 8, (0,))),
    *(
        ("javascript", javascript_code.SUPPORT, name, javascript_code.SUPPORT[name].replace(right, wrong))
        for name, right, wrong in (
            ("power_of_two", "+1023", "+1022"),
            ("power_of_two", "U[L]=0;", ""),
            ("binary_exponent", "?1:0", "?0:0"),  # the lower half's carry
            ("binary_fraction", "h++}", "}"),
            ("binary_fraction", "h++;U", ";U"),
            ("binary_fraction", "-1}", "}"),
        )
    ),
    ("webassembly", webassembly_code.BIT_WORDS, "add", 0x7D),
    ("webassembly", webassembly_code.BIT_WORDS, "shift left", webassembly_code.BIT_WORDS["shift right"]),
    ("webassembly", webassembly_code.BIT_WORDS, "shift right", webassembly_code.BIT_WORDS["shift left"]),
    ("webassembly", webassembly_code.BIT_WORDS, "and", webassembly_code.BIT_WORDS["or"]),
    ("webassembly", webassembly_code.BIT_WORDS, "or", webassembly_code.BIT_WORDS["and"]),
]
"""Faults that are no swap of two words: the table, the key, what stands there then."""


@pytest.mark.parametrize(
    ("runner", "table", "key", "wrong"), WRONG, ids=[f"{w[0]}-{w[2]}{k}" for k, w in enumerate(WRONG)]
)
def test_another_fault_is_seen(runner: str, table: Any, key: str, wrong: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    if not RUNNERS[runner].available():
        pytest.skip(f"a package that {runner} needs is missing")
    assert table[key] != wrong
    monkeypatch.setitem(table, key, wrong)
    assert seen(runner, operations(), brackets())


@pytest.mark.parametrize("name", sorted({*OPERATIONS} - {"positive"}))
@pytest.mark.parametrize("runner", runners())
def test_a_fault_of_each_operation_is_seen(runner: str, name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Off by a thousandth in one operation, in its own rows alone, as CasADi's evaluation shows. (CasADi never writes
    ``positive``.)"""

    def off(code: Code, operation: str, operands: Sequence[str]) -> str:
        found = written(code, operation, operands)
        return code.do("add", found, code.number(1e-3)) if operation == name else found

    monkeypatch.setattr(division, "written", off)
    program, place = every_operation(), np.array([0.3, 0.7])
    found, true = RUNNERS[runner](program).run(place[:, None], np.zeros(0))[:, 0], program(place, np.zeros(0))
    late = np.abs(found - true) > 1e-6
    rows = {row.split()[0] for row, wrong in zip(program.outputs, late, strict=True) if wrong}
    assert rows == {name}


@pytest.mark.parametrize("fault", ["SOLVED", "ACCEPTED", "MOST_STEPS"])
@pytest.mark.parametrize("runner", runners())
def test_other_rules_of_newton_are_seen(runner: str, fault: str, monkeypatch: pytest.MonkeyPatch) -> None:
    for module in (javascript_source, webassembly_module):
        monkeypatch.setattr(module, fault, {"SOLVED": 1e-3, "ACCEPTED": 1e-30, "MOST_STEPS": 2}[fault])
    assert not same(runner, newton("class_four"))


def test_the_faults_are_of_every_primitive() -> None:
    assert {*SWAPPED} | {"select", *javascript_code.BITS} == {*PRIMITIVES}
    assert {*javascript_code.WORDS} == {*PRIMITIVES}
    assert {*webassembly_code.WORDS, *javascript_code.BITS} == {*PRIMITIVES}
