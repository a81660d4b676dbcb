"""Elementary functions for compiled kernels against mpmath, in Python and compiled, and that loops of them vectorise.

``python tests/kernels/test_elementary.py 20000`` measures the worst errors over that many arguments of each sort.
"""

from __future__ import annotations

import math
import re
import sys
from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple

import mpmath as mp
import numpy as np
import pytest

from helpers.emitted import RUNNERS, Runner
from linkwright.graph.program import Program
from linkwright.kernels.elementary import FARTHEST, FUNCTIONS
from linkwright.kernels.llvm_entries import text
from linkwright.kernels.llvm_kernel import LlvmKernel, PoseFunction
from linkwright.kernels.llvm_source import KernelSource
from linkwright.kernels.machine_code import Machine
from linkwright.symbols import OPERATIONS, ExpressionStage, Symbol

nan, inf, tiny = math.nan, math.inf, 5e-324
SORT = 600
"""Arguments of each sort in a test."""


# What each function has to give.


class Case(NamedTuple):
    exact: Callable[..., Any]
    """The function of mpmath numbers."""
    sorts: tuple[str, ...]
    """The arguments to try, by the names of ``ARGUMENTS``."""
    ulp: float
    """The allowed error, in units of the last place of the result."""
    edges: list[tuple[float, ...]]
    """Arguments and what they give, to the last bit: axes, ends of the range, infinities."""


def near_quarters(rng: np.random.Generator, n: int) -> Any:
    """Doubles next to multiples of pi/2, among them those that are nearest of all in the range."""
    with mp.workprec(200):
        counts = [*range(1, 40), *(int(k) for k in rng.integers(1, int(FARTHEST / 1.5708), n))]
        near = np.array([float(k * mp.pi / 2) for k in counts])
    nearest = [45.553093477052, 14461176.67027838, 28922353.34055676, 57844706.68111352]  # 2**-60.5 to 2**-57 away
    return np.concatenate([near, -near, np.nextafter(near, 0.0), nearest])


def sizes(rng: np.random.Generator, least: float, most: float, n: int) -> Any:
    return 10.0 ** rng.uniform(least, most, n) * rng.choice([-1.0, 1.0], n)


def powers(base: Any, logarithm: Any) -> Any:
    """Bases, and exponents whose power has a logarithm."""
    return np.array([base, logarithm / np.log(np.where(base == 1.0, 2.0, base))])


ARGUMENTS: dict[str, Callable[[np.random.Generator, int], Any]] = {
    "quarters": near_quarters,
    "few": lambda rng, n: rng.uniform(-4.0, 4.0, n),
    "angles": lambda rng, n: sizes(rng, -9, 8, n),
    "unit": lambda rng, n: rng.uniform(-1.0, 1.0, n),
    "ends": lambda rng, n: (1.0 - 10.0 ** rng.uniform(-16, -0.1, n)) * rng.choice([-1.0, 1.0], n),
    "halves": lambda rng, n: rng.uniform(0.45, 0.55, n) * rng.choice([-1.0, 1.0], n),
    "below 1": lambda rng, n: sizes(rng, -323.3, 0, n),
    "any": lambda rng, n: sizes(rng, -323.3, 308.25, n),
    "positive": lambda rng, n: np.abs(sizes(rng, -323.3, 308.25, n)),
    "around 1": lambda rng, n: np.concatenate([rng.uniform(0.5, 2.0, n), 1.0 + sizes(rng, -15, -2, n)]),
    "exponents": lambda rng, n: rng.uniform(-745.1, 709.78, n),
    "pairs": lambda rng, n: rng.uniform(-1.0, 1.0, (2, n)),
    "any pairs": lambda rng, n: np.array([sizes(rng, -323.3, 308.0, n), sizes(rng, -323.3, 308.0, n)]),
    "like pairs": lambda rng, n: sizes(rng, -323.3, 308.0, n) * np.array([np.ones(n), rng.uniform(0.2, 1.5, n)]),
}
ANGLES = ("quarters", "few", "angles", "below 1")
ARGUMENTS["powers"] = lambda rng, n: powers(np.abs(sizes(rng, -300, 300, n)), rng.uniform(-745, 709, n))
ARGUMENTS["small powers"] = lambda rng, n: powers(1.0 + sizes(rng, -15, -0.5, n), rng.uniform(-30, 30, n))
UNIT = ("unit", "ends", "halves", "below 1")
PAIRS = ("pairs", "any pairs", "like pairs")
FAR = [(inf, nan), (-inf, nan), (1.0000001 * FARTHEST, nan), (-1e300, nan)]
OUTSIDE = [(inf, nan), (-inf, nan), (float(np.nextafter(1.0, 2.0)), nan), (-1.5, nan)]
half = math.pi / 2
MISSING = [(nan, 1.0, 1.0), (1.0, nan, 1.0), (nan, nan, nan)]

CASES: dict[str, Case] = {
    "sin": Case(mp.sin, ANGLES, 1.0, [(0.0, 0.0), *FAR]),
    "cos": Case(mp.cos, ANGLES, 1.0, [(0.0, 1.0), *FAR]),
    "tan": Case(mp.tan, ANGLES, 1.75, [(0.0, 0.0), *FAR]),
    "asin": Case(mp.asin, UNIT, 1.0, [(0.0, 0.0), (1.0, half), (-1.0, -half), *OUTSIDE]),
    "acos": Case(mp.acos, UNIT, 1.5, [(0.0, half), (1.0, 0.0), (-1.0, math.pi), *OUTSIDE]),
    "atan": Case(mp.atan, ("few", "any"), 1.5, [(0.0, 0.0), (inf, half), (-inf, -half)]),
    "atan2": Case(
        mp.atan2, PAIRS, 1.75,
        [
            (0.0, 0.0, 0.0), (0.0, 1.0, 0.0), (-0.0, 1.0, 0.0), (1.0, 0.0, half), (-1.0, 0.0, -half),
            (1.0, -0.0, half), (-1.0, -0.0, -half), (0.0, -1.0, math.pi), (-0.0, -1.0, math.pi),
            (1.0, 1.0, half / 2), (1.0, -1.0, 1.5 * half), (-1.0, -1.0, -1.5 * half), (-1.0, 1.0, -half / 2),
            (tiny, -1.0, math.pi), (-tiny, -1.0, -math.pi), (tiny, tiny, half / 2), (1.7e308, 1.7e308, half / 2),
            (inf, 1.0, half), (-inf, 1.0, -half), (1.0, inf, 0.0), (1.0, -inf, math.pi), (inf, -inf, nan),
        ],
    ),
    "exp": Case(
        mp.exp, ("exponents", "few", "below 1"), 1.0,
        [(0.0, 1.0), (710.0, inf), (1e300, inf), (inf, inf), (-746.0, 0.0), (-1e300, 0.0), (-inf, 0.0)],
    ),
    "log": Case(
        mp.log, ("positive", "around 1"), 1.0,
        [(1.0, 0.0), (0.0, -inf), (-0.0, -inf), (inf, inf), (-1.0, nan), (-inf, nan)],
    ),
    "power": Case(
        mp.power, ("powers", "small powers"), 1.5,
        [
            (0.0, 0.0, 1.0), (0.0, 2.5, 0.0), (0.0, -1.0, inf), (0.0, inf, 0.0), (1.0, nan, 1.0), (nan, 0.0, 1.0),
            (-2.0, 3.0, -8.0), (-2.0, 2.0, 4.0), (-2.0, -1.0, -0.5), (-8.0, 1 / 3, nan), (-1.0, 1e300, 1.0),
            (3.0, 2.0**53, inf), (3.0, -(2.0**53), 0.0), (inf, 0.5, inf), (inf, -0.5, 0.0), (-inf, 3.0, -inf),
            (-inf, -0.5, 0.0), (0.5, inf, 0.0), (0.5, -inf, inf), (2.0, 1023.0, 2.0**1023), (2.0, -1074.0, tiny),
        ],
    ),
    "fmin": Case(min, PAIRS, 0.0, [(-inf, 1.0, -inf), (inf, 1.0, 1.0), (1.0, 1.0, 1.0), *MISSING]),
    "fmax": Case(max, PAIRS, 0.0, [(-inf, 1.0, 1.0), (inf, 1.0, inf), (1.0, 1.0, 1.0), *MISSING]),
    "sign": Case(mp.sign, ("any",), 0.0, [(0.0, 0.0), (-0.0, 0.0), (inf, 1.0), (-inf, -1.0)]),
    "copysign": Case(
        lambda x, y: -abs(x) if y < 0 else abs(x), PAIRS, 0.0,
        [(-2.0, 0.0, 2.0), (2.0, -0.0, 2.0), (2.0, -inf, -2.0), (inf, -1.0, -inf)],
    ),
    "hypot": Case(
        mp.hypot, PAIRS, 1.5,
        [(0.0, 0.0, 0.0), (tiny, 0.0, tiny), (3.0, 4.0, 5.0), (inf, 1.0, inf), (1.0, -inf, inf), (1.7e308, 1e308, inf)],
    ),
}  # fmt: skip
DROPS_NAN = {"fmin", "fmax", "power"}  # as in C
WAYS = ["python", "vector", "pose"]
CALLED = {"asin": "arcsin", "acos": "arccos", "atan": "arctan", "atan2": "arctan2"}


# The ways to run them.


@cache
def compiled(name: str, way: str) -> LlvmKernel | PoseFunction | Runner:
    """The function as written by the LLVM emitter: over vectors, or of one pose; or for another machine."""
    if way not in RUNNERS:
        pytest.importorskip("llvmlite", reason="compiled functions need llvmlite")
    x = Symbol.several("x", operands(name))
    operation = next(each for each in OPERATIONS if each in (name, CALLED.get(name)))
    stage = ExpressionStage(x, [], [x[0].do(operation, *x[1:])])
    program = Program((), stage, ("x", "y")[: operands(name)], (), (name,))
    if way in RUNNERS:
        return RUNNERS[way](program)
    return LlvmKernel(program) if way == "vector" else PoseFunction(program)


def operands(name: str) -> int:
    return FUNCTIONS[name].__code__.co_argcount


def results(way: str, name: str, arguments: Any) -> Any:
    """Values at ``arguments`` (operands, n)."""
    if way == "python":
        return np.array([FUNCTIONS[name](*map(float, point)) for point in arguments.T])
    made = compiled(name, way)
    if isinstance(made, LlvmKernel | Runner):
        return made.run(np.ascontiguousarray(arguments), np.zeros(0))[0]
    return np.array([made(point, np.zeros(0))[0] for point in arguments.T])


@cache
def exact(name: str, n: int) -> tuple[Any, list[Any]]:
    """Arguments of all sorts (operands, points), and the true values at them."""
    rng = np.random.default_rng(7)
    case = CASES[name]
    made = [np.atleast_2d(ARGUMENTS[sort](rng, n)) for sort in case.sorts]
    arguments = np.concatenate(made, axis=1)
    with mp.workprec(200):
        return arguments, [case.exact(*map(mp.mpf, map(float, point))) for point in arguments.T]


def errors(way: str, name: str, n: int) -> tuple[Any, Any]:
    """The arguments, and the errors at them in units of the last place of the true value (its double's)."""
    arguments, truth = exact(name, n)
    found = results(way, name, arguments)
    with mp.workprec(200):
        off = [
            (0.0 if f == float(t) else inf) if not math.isfinite(f) else float(abs(mp.mpf(f) - t) / math.ulp(float(t)))
            for f, t in zip(found.tolist(), truth, strict=True)
        ]
    return arguments, np.array(off)


# Values.


def test_every_function_has_its_case() -> None:
    assert CASES.keys() == FUNCTIONS.keys()


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("name", CASES)
def test_values(name: str, way: str) -> None:
    arguments, off = errors(way, name, SORT)
    worst = off.argmax()
    assert off[worst] <= CASES[name].ulp, (arguments[:, worst].tolist(), off[worst])


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("name", CASES)
def test_values_at_the_ends(name: str, way: str) -> None:
    *arguments, expected = np.array(CASES[name].edges).T
    np.testing.assert_array_equal(results(way, name, np.array(arguments)), expected)


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("name", sorted(CASES.keys() - DROPS_NAN))
def test_nan_stays(name: str, way: str) -> None:
    """Of either sign, as x86's own NaN of sqrt(-1) has its sign bit set, and beside any other operand."""
    others = [0.0, 1.0, -3.0, inf, -inf, nan]
    points = [(nan,), (-nan,)] if operands(name) == 1 else [p for o in others for p in [(nan, o), (o, nan), (o, -nan)]]
    assert np.isnan(results(way, name, np.array(points).T)).all()


@pytest.mark.parametrize("name", CASES)
def test_all_ways_give_the_same_bits(name: str) -> None:
    """Python, vectors of any lanes, one pose, other machines: but for the bits of NaN and the sign of zero."""
    ends = np.array(CASES[name].edges).T[:-1]
    arguments = np.concatenate([exact(name, SORT)[0][:, ::9], ends], axis=1)
    elsewhere = [way for way, runner in RUNNERS.items() if runner.available()]
    python, *others = (results(way, name, arguments) + 0.0 for way in [*WAYS, *elsewhere])
    for found in others:
        np.testing.assert_array_equal(found, python)
        assert found[~np.isnan(found)].tobytes() == python[~np.isnan(python)].tobytes()


def test_no_function_of_the_library_is_called() -> None:
    """All are written out: the text has no other calls than of square roots, magnitudes and its own functions."""
    symbols = Symbol.several("x", 4)
    rows = [symbol.do(name) for symbol, name in zip(symbols, ("sin", "exp", "log", "arctan"), strict=True)]
    stage = ExpressionStage(symbols, [], rows)
    program = Program((), stage, tuple("abcd"), (), tuple("abcd"))
    made = text(KernelSource(program, "apart", Machine(8, False, "", "")))
    called = set(re.findall(r"call \S+(?: x double>)? @([\w.]+)", made))
    assert called <= {"llvm.fabs.v8f64", "llvm.sqrt.v8f64", "load", "save", "single", "stream", "block_own0"}


if __name__ == "__main__":
    for name in CASES:
        for way in WAYS:
            arguments, off = errors(way, name, int(sys.argv[1]))
            print(f"{name:8s} {way:8s} {off.max():.3f} at {arguments[:, off.argmax()].tolist()}")
