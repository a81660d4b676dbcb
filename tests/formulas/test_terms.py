"""Terms that fold: sums of like terms, numbers that go into sums, and what stays as it is."""

from __future__ import annotations

import pytest

from linkwright.expressions.language import Number, parse
from linkwright.formulas.terms import T, number, plain, scaled, text


@pytest.mark.parametrize(
    ("given", "folded"),
    [
        ("2*t + 3*t", "5*t"),
        ("sin(t) + 2 + t + 3*sin(t) - 2", "4*sin(t) + t"),
        ("t - t", "0"),
        ("2*(3*(t + sin(t)) - 1)", "6*t - 2 + 6*sin(t)"),
        ("-57*(0.5*t - 0.25*sin(60*t)) + 100", "100 - 28.5*t + 14.25*sin(60*t)"),
        ("2*(t - 18) + 3*sin(2*(t - 18))", "2*(t - 18) + 3*sin(2*(t - 18))"),
        ("(t + 1)*(sin(t) + 2)", "(1 + t)*(2 + sin(t))"),
        ("0.1*60*t + 0.2", "0.2 + 6*t"),
    ],
)
def test_a_sum_is_as_short_as_its_terms(given: str, folded: str) -> None:
    assert text(scaled(plain(parse(given), {"t": T}), 1.0)) == folded


def test_a_scale_goes_into_each_term() -> None:
    assert text(scaled(plain(parse("1 - 2*(t - 0.5*sin(t))"), {"t": T}), 10.0)) == "10 - 20*t + 10*sin(t)"


def test_round_off_is_not_written() -> None:
    assert text(Number(6.000000000000001)) == "6" and text(Number(12.000000000000002)) == "12"


@pytest.mark.parametrize(
    ("given", "written"),
    [(0.0, "0"), (-0.0, "0"), (1e-7, "0.0000001"), (-2.5e16, "-25000000000000000"), (1 / 3, "0.333333333333333")],
)
def test_numbers_have_no_exponent(given: float, written: str) -> None:
    assert number(given) == written
