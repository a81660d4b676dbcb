"""Jets against Taylor coefficients that mpmath finds with 50 digits, on floats, arrays and symbols alike."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from linkwright.laws import step5
from linkwright.notation import MAX_ORDER, Jet
from linkwright.notation.duals import Dual
from linkwright.symbols import ExpressionStage, Symbol
from notation.carriers import CARRIERS, assert_close, exact, on_floats, on_symbols

ORDER = MAX_ORDER + 1
carried = pytest.mark.parametrize("carrier", CARRIERS.values(), ids=CARRIERS)


def jets(low: float, high: float, order: int = ORDER) -> st.SearchStrategy[list[float]]:
    """Value in low .. high, derivatives of order one."""
    rates = st.lists(st.floats(-2.0, 2.0), min_size=order, max_size=order)
    return st.builds(lambda value, rest: [value, *rest], st.floats(low, high), rates)


# name: (with jets, with mpmath, the range of the argument)
ONE: dict[str, tuple[Callable[[Any], Any], Callable[[Any], Any], tuple[float, float]]] = {
    "sin": (Jet.sin, mpmath.sin, (-7.0, 7.0)),
    "cos": (Jet.cos, mpmath.cos, (-7.0, 7.0)),
    "tan": (Jet.tan, mpmath.tan, (-1.2, 1.2)),
    "exp": (Jet.exp, mpmath.exp, (-3.0, 3.0)),
    "log": (Jet.log, mpmath.log, (0.5, 9.0)),
    "sqrt": (Jet.sqrt, mpmath.sqrt, (0.5, 9.0)),
    "arcsin": (Jet.arcsin, mpmath.asin, (-0.7, 0.7)),
    "arccos": (Jet.arccos, mpmath.acos, (-0.7, 0.7)),
    "arctan": (Jet.arctan, mpmath.atan, (-5.0, 5.0)),
    "negative": (lambda f: -f, lambda f: -f, (-5.0, 5.0)),
    "number + jet": (lambda f: 1.5 + f, lambda f: 1.5 + f, (-5.0, 5.0)),
    "jet + number": (lambda f: f + 1.5, lambda f: f + 1.5, (-5.0, 5.0)),
    "number - jet": (lambda f: 1.5 - f, lambda f: 1.5 - f, (-5.0, 5.0)),
    "jet - number": (lambda f: f - 1.5, lambda f: f - 1.5, (-5.0, 5.0)),
    "number * jet": (lambda f: 1.5 * f, lambda f: 1.5 * f, (-5.0, 5.0)),
    "jet * zero": (lambda f: f * 0.0, lambda f: f * 0, (-5.0, 5.0)),
    "number / jet": (lambda f: 1.5 / f, lambda f: 1.5 / f, (0.5, 5.0)),
    "number / negative jet": (lambda f: 1.5 / f, lambda f: 1.5 / f, (-5.0, -0.5)),
    "jet / number": (lambda f: f / 1.6, lambda f: f / mpmath.mpf(1.6), (-5.0, 5.0)),
    "number ^ jet": (lambda f: 2.5**f, lambda f: mpmath.mpf(2.5) ** f, (-3.0, 3.0)),
    "jet ^ jet": (lambda f: f**f, lambda f: f**f, (0.5, 3.0)),
    "jet ^ constant jet": (lambda f: f ** Jet.constant(-1.5, f.order), lambda f: f ** mpmath.mpf(-1.5), (0.5, 3.0)),
    **{
        f"jet ^ {p}": (lambda f, p=p: f**p, lambda f, p=p: f ** mpmath.mpf(p), (0.5, 3.0))
        for p in (0, 1, 2, 3, 4, 5, 7, -1, -2, -5, 0.5, -0.5, 1 / 3, 2.5, -1.7, 2.0)
    },
    **{
        f"negative jet ^ {p}": (lambda f, p=p: f**p, lambda f, p=p: f**p, (-3.0, -0.5))
        for p in (1, 2, 3, 4, 5, 8, -1, -2, -3)
    },
    "composed": (
        lambda f: (f.sin() * f.exp() + 1.0).sqrt() / (f * f + 2.0),
        lambda f: mpmath.sqrt(mpmath.sin(f) * mpmath.exp(f) + 1) / (f * f + 2),
        (0.0, 2.0),
    ),
    "nested": (
        lambda f: (f.cos() * 0.5).arcsin().exp().log(),
        lambda f: mpmath.asin(mpmath.cos(f) / 2),
        (-3.0, 3.0),
    ),
}

TWO: dict[str, tuple[Callable[[Any, Any], Any], Callable[[Any, Any], Any]]] = {
    "sum": (lambda f, g: f + g, lambda f, g: f + g),
    "difference": (lambda f, g: f - g, lambda f, g: f - g),
    "product": (lambda f, g: f * g, lambda f, g: f * g),
    "quotient": (lambda f, g: f / g, lambda f, g: f / g),
    "hypot": (Jet.hypot, lambda f, g: mpmath.sqrt(f * f + g * g)),
    "arctan2": (Jet.arctan2, lambda f, g: mpmath.atan2(f, g)),
}


@carried
@pytest.mark.parametrize("name", ONE)
@settings(max_examples=8)
@given(st.data())
def test_function_of_one(name: str, carrier: Any, data: st.DataObject) -> None:
    with_jets, with_mpmath, (low, high) = ONE[name]
    row = data.draw(jets(low, high))
    assert_close(carrier(with_jets, row), exact(with_mpmath, row))


@carried
@pytest.mark.parametrize("name", TWO)
@settings(max_examples=10)
@given(st.data())
def test_function_of_two(name: str, carrier: Any, data: st.DataObject) -> None:
    with_jets, with_mpmath = TWO[name]
    f, g = data.draw(jets(-3.0, 3.0)), data.draw(jets(0.5, 3.0))
    assert_close(carrier(with_jets, f, g), exact(with_mpmath, f, g))


@carried
@pytest.mark.parametrize("quadrant", [(1, 1), (1, -1), (-1, -1), (-1, 1)])
@settings(max_examples=5)
@given(jets(0.5, 3.0), jets(0.5, 3.0))
def test_arctan2_in_every_quadrant(carrier: Any, quadrant: tuple[int, int], y: list[float], x: list[float]) -> None:
    y[0], x[0] = quadrant[0] * y[0], quadrant[1] * x[0]
    assert_close(carrier(Jet.arctan2, y, x), exact(lambda y, x: mpmath.atan2(y, x), y, x))


def test_arctan2_on_the_axes() -> None:
    for y, x in ((1.0, 0.0), (-1.0, 0.0), (0.0, 1.0)):
        found = on_floats(Jet.arctan2, [y, 0.3, 0.2], [x, -0.7, 0.4])
        assert_close(found, exact(lambda y, x: mpmath.atan2(y, x), [y, 0.3, 0.2], [x, -0.7, 0.4]))
    assert on_floats(Jet.arctan2, [0.0, 1.0], [-2.0, 0.0]) == [math.pi, -0.5]


@pytest.mark.parametrize("carrier", CARRIERS.values(), ids=CARRIERS)
@settings(max_examples=10)
@given(jets(0.1, 3.0))
def test_abs_away_from_its_kink(carrier: Any, row: list[float]) -> None:
    negated = [-d for d in row]
    assert carrier(abs, row) == row
    assert carrier(abs, negated) == row


def test_abs_at_its_kink_takes_the_side_of_growing_argument() -> None:
    assert on_floats(abs, [0.0, 2.0, 1.0]) == [0.0, 2.0, 1.0]


@carried
@settings(max_examples=10)
@given(jets(-3.0, 3.0), jets(-3.0, 3.0))
def test_minimum_and_maximum_take_one_jet_whole(carrier: Any, f: list[float], g: list[float]) -> None:
    less, more = (f, g) if f[0] <= g[0] else (g, f)
    assert carrier(Jet.minimum, f, g) == less
    if f[0] != g[0]:
        assert carrier(Jet.maximum, f, g) == more


def test_where_chooses_place_by_place() -> None:
    f, g = Jet([np.array([1.0, 2.0, 3.0]), np.array([4.0, 5.0, 6.0])]), Jet.constant(0.0, 1)
    chosen = f.where(np.array([True, False, True]), g)
    assert chosen.d[0].tolist() == [1.0, 0.0, 3.0]
    assert chosen.d[1].tolist() == [4.0, 0.0, 6.0]


@settings(max_examples=20)
@given(jets(0.5, 2.0), jets(0.5, 2.0), jets(0.5, 2.0))
def test_field_laws(f: list[float], g: list[float], h: list[float]) -> None:
    a, b, c = Jet(f), Jet(g), Jet(h)
    pairs = {
        "associative": (((a * b) * c), (a * (b * c))),
        "distributive": ((a + b) * c, a * c + b * c),
        "inverse": (a / b * b, a),
        "power": (a**-3, 1.0 / (a * a * a)),
        "root": (a.sqrt() * a.sqrt(), a),
        "half": (a**0.5, a.sqrt()),
        "exp of log": (a.log().exp(), a),
        "circle": (a.sin() * a.sin() + a.cos() * a.cos(), Jet.constant(1.0, ORDER)),
        "quarter": (a.arctan2(b) + b.arctan2(a), Jet.constant(math.pi / 2, ORDER)),
    }
    for left, right in pairs.values():
        assert_close(left.d, right.d)


def test_rate_and_cut() -> None:
    f = Jet([1.0, 2.0, 3.0, 4.0])
    assert f.rate().d == (2.0, 3.0, 4.0)
    assert f.truncated(1).d == (1.0, 2.0)
    assert (f.order, f.rate().order, f.truncated(0).order) == (3, 2, 0)


@settings(max_examples=20)
@given(jets(0.5, 2.0), jets(0.5, 2.0))
def test_leibniz_rule_commutes_with_rate(f: list[float], g: list[float]) -> None:
    a, b = Jet(f), Jet(g)
    low = ORDER - 1
    assert_close((a * b).rate().d, (a.rate() * b.truncated(low) + a.truncated(low) * b.rate()).d)


@pytest.mark.parametrize("operation", [lambda f, g: f + g, lambda f, g: f * g, lambda f, g: f / g, Jet.arctan2])
def test_the_lower_order_is_kept(operation: Callable[[Jet, Jet], Jet]) -> None:
    f, g = Jet([1.0, 2.0, 3.0]), Jet([4.0, 5.0])
    assert operation(f, g).order == operation(g, f).order == 1


def test_order_zero() -> None:
    f = Jet([0.5])
    for function in (Jet.sin, Jet.tan, Jet.exp, Jet.log, Jet.sqrt, Jet.arcsin, Jet.arccos, Jet.arctan):
        assert function(f).order == 0
    assert f.arctan2(f).d == (math.pi / 4,)


@pytest.mark.parametrize(
    "operation", [lambda a, j: a + j, lambda a, j: a - j, lambda a, j: a * j, lambda a, j: a / j, lambda a, j: j * a]
)
def test_an_array_on_either_side_does_not_take_the_jet_apart(operation: Callable[[Any, Jet], Jet]) -> None:
    a = np.array([1.0, 2.0])
    found = operation(a, Jet([a + 1.0, a]))
    for i in (0, 1):
        one = operation(float(a[i]), Jet([a[i] + 1.0, a[i]]))
        assert [float(d[i]) for d in found.d] == pytest.approx([float(d) for d in one.d], rel=1e-15)


def test_constants_stay_structural_zeros() -> None:
    """What doesn't move costs nothing: products with it make no terms."""
    x = Jet(Symbol.several("x", 3))
    assert (Jet.constant(0.0, 2) * x).d == (0.0, 0.0, 0.0)
    assert (x + Jet.constant(0.0, 2)).d == x.d
    stage = ExpressionStage(x.d, [], (Jet.constant(3.0, 2) * x).d)
    operations = [i.op for i in stage.instructions]
    assert operations.count("multiply") == 3
    assert "add" not in operations


@pytest.mark.parametrize("x", [-1.2, 0.3, 0.9])
def test_functions_with_corners_on_symbols(x: float) -> None:
    """min, max, abs and step5 of a jet of symbols, as on floats."""
    for f in (
        lambda j: j.minimum(j * j),
        lambda j: j.maximum(0.5 * j),
        abs,
        lambda j: step5(j, 0.0, 1.0, 0.8, 3.0),
    ):
        row = [x, 0.7, -0.4]
        assert_close(on_symbols(f, row), on_floats(f, row))


def test_a_power_with_a_slope() -> None:
    """d/dn u^n = u^n log u, and its derivatives; 0 at u = 0, where it may grow without bound in the higher ones."""
    jet = Jet([np.array([0.0, 0.4, 1.3]), np.ones(3), np.zeros(3), np.zeros(3)])
    with np.errstate(all="ignore"):
        found = (jet ** Dual(2.5, 1.0)).d
    for order, entry in enumerate(found):
        for i, u in enumerate((0.4, 1.3), start=1):
            wanted = mpmath.diff(lambda v: v**2.5 * mpmath.log(v), u, order)
            assert float(entry.slope[i]) == pytest.approx(float(wanted), rel=1e-10)
            assert float(entry.value[i]) == pytest.approx(float(mpmath.diff(lambda v: v**2.5, u, order)), rel=1e-10)
    assert [float(entry.slope[0]) for entry in found[:3]] == [0.0, 0.0, 0.0]
    assert np.isnan(found[3].slope[0])
