"""Elementary functions for compiled kernels against mpmath, in Python and compiled, and that loops of them vectorise.

``python tests/kernels/test_elementary.py 20000`` measures the worst errors over that many arguments of each sort.
"""

from __future__ import annotations

import math
import platform
import re
import sys
from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple

import mpmath as mp
import numpy as np
import pytest

from linkwright.kernels.elementary import FARTHEST, FUNCTIONS, source

nan, inf, tiny = math.nan, math.inf, 5e-324
OPTIONS = "fastmath={'contract', 'arcp', 'nsz'}, error_model='numpy'"
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
DROPS_NAN = {"fmin", "fmax"}  # as in C
WAYS = ["python", "compiled"]


# The two ways to run them.


@cache
def compiled(name: str) -> Any:
    """A compiled loop ``(x, out)`` or ``(x, y, out)``, made as a kernel would be."""
    pytest.importorskip("numba", reason="compiled functions need numba")
    text = source([name], f"@njit(forceinline=True, {OPTIONS})")
    return looped(text, f"{name}(x[i])" if operands(name) == 1 else f"{name}(x[i], y[i])", operands(name))


def looped(text: str, call: str, count: int) -> Any:
    from numba import njit

    space: dict[str, Any] = {"math": math, "np": np, "njit": njit}
    loop = f"""
@njit({OPTIONS})
def loop({"x, y"[: 3 * count - 2]}, out):
    for i in range(out.size):
        out[i] = {call}
"""
    exec(text + loop, space)
    return space["loop"]


def operands(name: str) -> int:
    return FUNCTIONS[name].__code__.co_argcount


def results(way: str, name: str, arguments: Any) -> Any:
    """Values at ``arguments`` (operands, n)."""
    if way == "python":
        return np.array([FUNCTIONS[name](*map(float, point)) for point in arguments.T])
    out = np.empty(arguments.shape[1])
    compiled(name)(*np.ascontiguousarray(arguments), out)
    return out


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
def test_a_compiled_value_does_not_depend_on_how_many_are_computed(name: str) -> None:
    """Some fall into the vector loop, some into what is left over, one alone always there: the same to the last bit."""
    arguments = exact(name, SORT)[0][:, ::9]
    alone = [results("compiled", name, arguments[:, i : i + 1])[0] for i in range(arguments.shape[1])]
    np.testing.assert_array_equal(results("compiled", name, arguments), alone)


# Text and machine code.


def packed(loop: Any) -> int:
    """Instructions of a compiled loop that compute on several doubles at once."""
    found = r"\tv?(?:add|sub|mul|div|sqrt|min|max|cmp\w*|blend\w*|fn?m(?:add|sub)\w+)pd\t"
    return sum(len(re.findall(found, text)) for text in loop.inspect_asm().values())


@pytest.fixture
def avx2() -> None:
    """With the two doubles of SSE2 a compiler finds some loops not worth it, and other machines have other names."""
    pytest.importorskip("numba", reason="compiled functions need numba")
    from llvmlite import binding

    if platform.machine() not in ("x86_64", "AMD64") or not binding.get_host_cpu_features().get("avx2"):
        pytest.skip("reads machine code of x86 with AVX2")


on_avx2 = pytest.mark.usefixtures("avx2")


@on_avx2
@pytest.mark.parametrize("name", CASES)
def test_a_loop_vectorises(name: str) -> None:
    loop = compiled(name)
    loop(*np.ones((operands(name), 3)), np.empty(3))
    assert packed(loop) >= 2


@on_avx2
def test_a_loop_of_the_library_does_not() -> None:
    loop = looped("", "math.sin(x[i])", 1)
    loop(np.ones(3), np.empty(3))
    assert packed(loop) == 0


@on_avx2
def test_sine_and_cosine_of_an_angle_share_their_work() -> None:
    one = compiled("sin")
    one(np.ones(3), np.empty(3))
    text = source(["sin", "cos"], f"@njit(forceinline=True, {OPTIONS})")
    both = looped(text, "sin(x[i]) * cos(x[i])", 1)
    both(np.ones(3), np.empty(3))
    assert packed(both) < 1.2 * packed(one)


def test_source_is_what_is_needed_and_no_more() -> None:
    needed = ["FARTHEST", "ROUNDER", "_quadrant", "_sine", "_cosine", "sin"]
    assert re.findall(r"^(?:def )?(\w+)", source(["sin"]), re.M) == needed
    assert source(["sign"], "@here").startswith("@here\ndef sign(")
    assert source(["tan", "log", "atan"]) == source(["atan", "tan", "log", "tan"])
    assert source([]) == ""


def test_source_stands_alone() -> None:
    space: dict[str, Any] = {"math": math, "np": np}
    exec(source(FUNCTIONS), space)
    for name, function in FUNCTIONS.items():
        point = (0.5, 0.25)[: operands(name)]
        assert space[name](*point) == function(*point)


if __name__ == "__main__":
    for name in CASES:
        for way in WAYS:
            arguments, off = errors(way, name, int(sys.argv[1]))
            print(f"{name:8s} {way:8s} {off.max():.3f} at {arguments[:, off.argmax()].tolist()}")
