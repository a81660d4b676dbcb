"""Germs: orders, limits and errors against series known by hand."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from linkwright.expressions.language import FUNCTIONS
from linkwright.measures.germs import EPS, TERMS, Germ, Undecided


def s(value: float = 0.0, slope: float = 1.0) -> Germ:
    """``value + slope s``."""
    c, e = np.zeros(TERMS), np.zeros(TERMS)
    c[:2], e[0] = (value, slope), EPS * abs(value)
    return Germ(c, e)


def f(name: str, *args: Any) -> Germ:
    found = FUNCTIONS[name].apply(*args)
    assert isinstance(found, Germ)
    return found


LIMITS: list[tuple[str, Callable[[], Germ], float, Fraction]] = [
    ("1/s", lambda: 1.0 / s(), math.inf, Fraction(-1)),
    ("-1/s^2", lambda: -1.0 / s() ** 2, -math.inf, Fraction(-2)),
    ("s^-0.5", lambda: s() ** -0.5, math.inf, Fraction(-1, 2)),
    ("s^(1/3)/s", lambda: s() ** (1 / 3) / s(), math.inf, Fraction(-2, 3)),
    ("sin(s)/s", lambda: f("sin", s()) / s(), 1.0, Fraction(0)),
    ("(1 - cos s)/s^2", lambda: (1.0 - f("cos", s())) / s() ** 2, 0.5, Fraction(0)),
    ("(exp(2 s) - 1)/s", lambda: (f("exp", s(0, 2)) - 1.0) / s(), 2.0, Fraction(0)),
    ("tan(pi/2 + s)", lambda: f("tan", s(math.pi / 2)), -math.inf, Fraction(-1)),
    ("s/abs(-s)", lambda: s() / f("abs", -s()), 1.0, Fraction(0)),
    ("atan2(-s, -1)", lambda: f("atan2", -s(), Germ.constant(-1.0)), -math.pi, Fraction(0)),
    ("atan2(s, -1)", lambda: f("atan2", s(), Germ.constant(-1.0)), math.pi, Fraction(0)),
    ("atan2(s, s)", lambda: f("atan2", s(), s()), math.pi / 4, Fraction(0)),
    ("atan(1/s)", lambda: f("atan2", Germ.constant(1.0), s()), math.pi / 2, Fraction(0)),
    ("acos(1 - s)/sqrt(s)", lambda: f("acos", s(1, -1)) / f("sqrt", s()), math.sqrt(2), Fraction(0)),
    ("asin(1 - s)", lambda: f("asin", s(1, -1)), math.pi / 2, Fraction(0)),
    ("exp(-1/s)", lambda: f("exp", -1.0 / s()), 0.0, Fraction(0)),
    ("min(1/s, 3)", lambda: f("min", 1.0 / s(), Germ.constant(3.0)), 3.0, Fraction(0)),
    ("max(s, -s)/s", lambda: f("max", s(), -s()) / s(), 1.0, Fraction(0)),
    ("hypot(s, 2 s)/s", lambda: f("hypot", s(), s(0, 2)) / s(), math.sqrt(5), Fraction(0)),
    ("2^s", lambda: 2.0 ** s(), 1.0, Fraction(0)),
]


@pytest.mark.parametrize(("text", "make", "value", "exponent"), LIMITS, ids=[text for text, *_ in LIMITS])
def test_limits(text: str, make: Callable[[], Germ], value: float, exponent: Fraction) -> None:
    found, order = make().limit()
    assert found == pytest.approx(value, abs=1e-14)
    assert min(order, Fraction(0)) == exponent


def test_round_off_is_no_pole() -> None:
    """(a + s - a)/s is 1 although a is not exact, and 1/(a + s - a - 1e-3) is finite."""
    a, b = s(0.7), Germ.constant(0.7, EPS)
    assert ((a - b) / s()).limit()[0] == pytest.approx(1.0, abs=1e-12)
    assert (1.0 / (a - b - 1e-3)).limit()[0] == pytest.approx(-1e3, rel=1e-9)


def test_what_round_off_hides_is_said_to_be_undecided() -> None:
    c, e = np.zeros(TERMS), np.zeros(TERMS)
    c[0], e[0] = 1e-15, 2e-16
    with pytest.raises(Undecided):
        (1.0 / Germ(c, e)).limit()
    with pytest.raises(Undecided):
        1.0 / (s() - s())


@given(st.lists(st.floats(-3, 3), min_size=3, max_size=3), st.lists(st.floats(-3, 3), min_size=3, max_size=3))
def test_quotients_times_their_divisors_are_what_was_divided(a: list[float], b: list[float]) -> None:
    def germ(head: list[float]) -> Germ:
        c = np.zeros(TERMS)
        c[:3] = head
        return Germ(c, EPS * np.abs(c))

    b = [value if abs(value) > 1e-3 else 0.0 for value in b]
    divisor = germ(b)
    if not any(b):
        return
    whole = germ(a) / divisor * divisor
    at = np.array([0.01, 0.02])
    assert whole(at) == pytest.approx(germ(a)(at), abs=1e-6 * (1 + max(map(abs, a))) * 1e3)
