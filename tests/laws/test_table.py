"""Splines through points: exact on polynomials of their degree, closed where periodic, loud outside."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.polynomial import Polynomial

from helpers.differences import derivatives
from linkwright.laws import DEGREES, OutsideTable, TableLaw
from linkwright.notation import Jet

every = pytest.mark.parametrize("degree", DEGREES.values(), ids=DEGREES)


def time_jet(t: np.ndarray, order: int = 4) -> Jet:
    return Jet([t, np.ones_like(t), *[np.zeros_like(t)] * (order - 1)])


@st.composite
def abscissae(draw: st.DrawFn, least: int) -> np.ndarray:
    """Ascending and uneven."""
    steps = draw(st.lists(st.floats(0.2, 1.5), min_size=least, max_size=least + 6))
    return draw(st.floats(-3.0, 3.0)) + np.concatenate([[0.0], np.cumsum(steps)])


def test_the_degrees_are_the_file_formats() -> None:
    assert DEGREES == {"linear": 1, "cubic": 3, "quintic": 5}


@every
@settings(max_examples=25)
@given(st.data())
def test_exact_on_polynomials_of_the_degree(degree: int, data: st.DataObject) -> None:
    x = data.draw(abscissae(degree))
    coefficients = data.draw(st.lists(st.floats(-2.0, 2.0), min_size=degree + 1, max_size=degree + 1))
    p = Polynomial(coefficients, domain=[x[0], x[-1]], window=[-1, 1])
    t = np.linspace(x[0], x[-1], 23)
    found = TableLaw(x, p(x), degree)(time_jet(t))
    scale = max(1.0, float(np.abs(p(t)).max()))
    for k in range(5):
        size = scale * (2.0 / (x[-1] - x[0])) ** k * math.perm(degree, min(k, degree)) * 4**k
        assert np.allclose(found.d[k], p.deriv(k)(t) if k else p(t), rtol=0, atol=1e-9 * size), k


@every
@settings(max_examples=10)
@given(st.data())
def test_composed_with_a_moving_argument(degree: int, data: st.DataObject) -> None:
    """The rates of p(x(t)) where the table holds p."""
    p = Polynomial(data.draw(st.lists(st.floats(-2.0, 2.0), min_size=degree + 1, max_size=degree + 1)))
    x = np.linspace(-2.0, 2.0, degree + 4)
    rows = [data.draw(st.floats(-1.9, 1.9)), *data.draw(st.lists(st.floats(-1.0, 1.0), min_size=4, max_size=4))]
    argument = Jet([np.array([row]) for row in rows])
    wanted = Jet.constant(np.array([p.coef[-1]]), 4)
    for c in p.coef[-2::-1]:
        wanted = wanted * argument + c
    found = TableLaw(x, p(x), degree)(argument)
    for k in range(5):
        assert np.allclose(found.d[k], wanted.d[k], rtol=1e-9, atol=1e-8), k


@every
def test_through_every_point(degree: int) -> None:
    x = np.array([0.0, 0.3, 1.0, 1.1, 2.0, 2.7, 3.0])
    y = np.array([1.0, -2.0, 0.5, 3.0, 3.0, -1.0, 2.0])
    assert np.allclose(TableLaw(x, y, degree)(time_jet(x)).d[0], y, atol=1e-12)


@every
def test_rates_against_differences(degree: int) -> None:
    x = np.linspace(0.0, 3.0, 8)
    law = TableLaw(x, np.sin(2 * x), degree)
    middles = (x[:-1] + x[1:]) / 2
    for k in range(1, 5):
        rates = derivatives(lambda at, k=k: law(time_jet(at)).d[k - 1], middles, 0.02)
        assert np.allclose(law(time_jet(middles)).d[k], rates, atol=1e-7)


@pytest.mark.parametrize("degree", [d for d in DEGREES.values() if d > 1])
def test_continuous_to_one_order_below_the_degree(degree: int) -> None:
    x = np.linspace(0.0, 3.0, 8)
    law = TableLaw(x, np.sin(2 * x) + np.cos(5 * x), degree)
    knots, h = x[1:-1], 1e-9
    before, after = law(time_jet(knots - h)), law(time_jet(knots + h))
    for k in range(min(degree, 5)):
        size = float(np.abs(law(time_jet(np.linspace(0, 3, 200))).d[min(k + 1, 4)]).max()) + 1.0
        assert np.allclose(before.d[k], after.d[k], rtol=0, atol=1e-6 * size), k


@pytest.mark.parametrize("degree", [d for d in DEGREES.values() if d > 1])
@pytest.mark.parametrize("closed", [False, True], ids=["open end", "end repeated"])
def test_periodic_closes(degree: int, closed: bool) -> None:
    """Value and all continuous rates run over the seam, on any turn; both ways of writing the points agree."""
    period, start = 2.0, -0.4
    x = start + np.linspace(0.0, period, 13)[: 13 if closed else 12]
    y = np.sin(np.pi * x) + 0.3 * np.cos(2 * np.pi * x)
    if closed:
        y[-1] = y[0]
    law = TableLaw(x, y, degree, period)
    h = 1e-9
    for turn in (-3, -1, 0, 1, 2):
        seam = np.array([start + turn * period])
        before, after = law(time_jet(seam - h)), law(time_jet(seam + h))
        for k in range(min(degree, 5)):
            assert np.allclose(before.d[k], after.d[k], rtol=0, atol=1e-5 * 10**k), (turn, k)
    t = np.linspace(start, start + period, 41)
    for k in range(5):
        assert np.allclose(law(time_jet(t)).d[k], law(time_jet(t + 7 * period)).d[k], atol=1e-9 * 30**k)
    other = TableLaw(start + np.linspace(0.0, period, 13)[:12], y[:12], degree, period)
    assert np.allclose(law(time_jet(t)).d[1], other(time_jet(t)).d[1], atol=1e-10)


def test_a_periodic_linear_table_closes_with_a_straight_line() -> None:
    law = TableLaw(np.array([0.0, 1.0, 2.0]), np.array([0.0, 1.0, 4.0]), 1, 4.0)
    t = np.array([0.5, 1.5, 2.5, 3.0, 3.999, 4.0, -1.0])
    assert law(time_jet(t)).d[0] == pytest.approx([0.5, 2.5, 3.0, 2.0, 0.002, 0.0, 2.0])
    assert law(time_jet(t)).d[1] == pytest.approx([1.0, 3.0, -2.0, -2.0, -2.0, 1.0, -2.0])


@pytest.mark.parametrize("degree", [d for d in DEGREES.values() if d > 1])
@pytest.mark.parametrize("closed", [False, True])
def test_periodic_through_the_fewest_points(degree: int, closed: bool) -> None:
    """As few points as a file may give: degree + 1."""
    x = np.arange(degree + 1.0)
    y = np.cos(2 * np.pi * x / (degree + (0 if closed else 1)))
    if closed:
        y[-1] = y[0]
    law = TableLaw(x, y, degree, float(degree + (0 if closed else 1)))
    assert np.allclose(law(time_jet(x)).d[0], y, atol=1e-12)


@pytest.mark.parametrize("degree", [d for d in DEGREES.values() if d > 1])
def test_converges_with_its_order(degree: int) -> None:
    """Halving the spacing divides the error by 2^(degree + 1), of the k-th rate by 2^(degree + 1 - k)."""
    t = np.linspace(0.0, 1.0, 1001)

    def errors(count: int) -> list[float]:
        x = np.arange(count) / count
        jet = TableLaw(x, np.sin(2 * np.pi * x), degree, 1.0)(time_jet(t))
        return [
            float(np.abs(jet.d[k] - (2 * np.pi) ** k * np.sin(2 * np.pi * t + k * np.pi / 2)).max()) for k in range(3)
        ]

    for k, (coarse, fine) in enumerate(zip(errors(16), errors(32), strict=True)):
        assert math.log2(coarse / fine) == pytest.approx(degree + 1 - k, abs=0.35)


@every
def test_outside_an_open_table_is_refused(degree: int) -> None:
    x = np.linspace(1.0, 3.0, 7)
    law = TableLaw(x, x**2, degree)
    assert law(time_jet(np.array([1.0, 3.0]))).d[0] == pytest.approx([1.0, 9.0])
    for at in (0.99, 3.01, -1e9, 1e9):
        with pytest.raises(OutsideTable) as caught:
            law(time_jet(np.array([2.0, at, 2.5])))
        assert (caught.value.at, caught.value.low, caught.value.high) == (at, 1.0, 3.0)


def test_round_off_at_an_end_is_not_outside() -> None:
    x = np.linspace(0.0, 3 * 0.1, 7)
    law = TableLaw(x, x, 3)
    assert law(time_jet(np.array([np.nextafter(x[-1], 1.0), -1e-16]))).d[0] == pytest.approx([0.3, 0.0], abs=1e-15)


@every
@pytest.mark.parametrize("period", [None, 2.5])
def test_the_integral_has_the_table_as_its_rate(degree: int, period: float | None) -> None:
    """Its rates are the table's value and rates; its value is that of Gauss quadrature, whole periods included."""
    x = np.array([-1.0, -0.4, 0.1, 0.5, 0.9, 1.2])
    table = TableLaw(x, np.array([0.3, 2.0, -1.0, 0.7, 1.5, 0.2]), degree, period)
    t = np.linspace(-1.0, 1.2, 9) if period is None else np.array([-9.1, -3.5, -1.0, -0.2, 1.4, 1.5, 7.3])
    found, value = table.integral(time_jet(t)), table(time_jet(t))
    for k in range(4):
        assert np.allclose(found.d[k + 1], value.d[k], rtol=1e-12, atol=1e-12)
    nodes, weights = np.polynomial.legendre.leggauss(8)
    knots = x if period is None else np.unique(np.concatenate([[*x + k * period] for k in range(-5, 5)]))
    for at, integral in zip(t, found.d[0], strict=True):
        low, high = sorted((x[0], at))
        edges = np.unique([low, *knots[(knots > low) & (knots < high)], high])
        h = np.diff(edges)[:, None]
        by_hand = float((table(Jet([(edges[:-1, None] + h * (nodes + 1) / 2)])).d[0] * weights * h / 2).sum())
        assert integral == pytest.approx(by_hand if at >= x[0] else -by_hand, rel=1e-11, abs=1e-12)


@every
def test_not_a_number_outside_where_that_is_asked_for(degree: int) -> None:
    x = np.linspace(0.0, 1.0, 8)
    table, t = TableLaw(x, x**2, degree), np.array([-0.1, 0.0, 0.5, 1.0, 1.1])
    for law in (table.or_nan, table.integral):
        assert [*np.isnan(law(time_jet(t, 1)).d[0])] == [True, False, False, False, True]
    with pytest.raises(OutsideTable):
        table(time_jet(t))
