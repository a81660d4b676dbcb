"""Intervals hold what exact arithmetic gives at their members."""

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from mpmath import mpf

from helpers.exact import BINARY, CONDITIONS, EXACT, arity
from linkwright.enclosures import intervals
from linkwright.enclosures.intervals import FUNCTIONS, Intervals

ends = st.floats(-20, 20) | st.sampled_from([0.0, 1.0, -1.0, 0.5, 1e-9, -1e-9, 1e-300, np.pi, np.pi / 2, -np.pi])
shares = st.floats(0, 1)


def interval(a: float, b: float) -> Intervals:
    return Intervals(np.array([min(a, b)]), np.array([max(a, b)]))


def member(of: Intervals, share: float) -> float:
    low, high = float(of.low[0]), float(of.high[0])
    return min(max(low + share * (high - low), low), high)


def holds(found: Intervals, value: object) -> bool:
    return bool(mpf(float(found.low[0])) <= value <= mpf(float(found.high[0])))


def test_every_registered_function_has_its_reference() -> None:
    assert set(FUNCTIONS) == set(EXACT)


@pytest.mark.parametrize("name", sorted(FUNCTIONS))
@given(data=st.data())
def test_function_holds_the_exact_value(name: str, data: st.DataObject) -> None:
    n = arity(name)
    logical = [name in CONDITIONS and (i == 0 or name.startswith("logical")) for i in range(n)]
    boxes = [interval(*data.draw(st.tuples(ends, ends))) if not flag else _flag(data) for flag in logical]
    points = [member(box, data.draw(shares)) for box in boxes]
    points = [float(point > 0.5) if flag else point for point, flag in zip(points, logical, strict=True)]
    found = FUNCTIONS[name](*boxes)
    assert not np.isnan(found.low).any()
    assert not np.isnan(found.high).any()
    value = EXACT[name](*map(mpf, points))
    if value is None:
        assert (found.low[0], found.high[0]) == (-np.inf, np.inf)
    else:
        assert holds(found, value)


def _flag(data: st.DataObject) -> Intervals:
    return Intervals(*(np.array([float(v)]) for v in data.draw(st.sampled_from([(0, 0), (1, 1), (0, 1)]))))


@pytest.mark.parametrize("name", sorted(BINARY))
@given(a=st.tuples(ends, ends), b=st.tuples(ends, ends), s=shares, r=shares)
@example(a=(0.1, 0.1), b=(0.2, 0.2), s=0.0, r=0.0)
@example(a=(1.0, 1.0), b=(3.0, 3.0), s=0.0, r=0.0)
def test_operator_holds_the_exact_value(name: str, a: tuple, b: tuple, s: float, r: float) -> None:
    x, y = interval(*a), interval(*b)
    p, q = member(x, s), member(y, r)
    found = BINARY[name](x, y)
    if name == "/" and y.contains(0.0).all():
        assert (found.low[0], found.high[0]) == (-np.inf, np.inf)
    else:
        assert holds(found, BINARY[name](mpf(p), mpf(q)))


@given(a=st.tuples(ends, ends), power=st.integers(-5, 7), s=shares)
def test_whole_powers(a: tuple, power: int, s: float) -> None:
    x = interval(*a)
    point = member(x, s)
    if power < 0 and point == 0:
        return
    assert holds(x**power, mpf(point) ** power)


@given(a=st.tuples(st.floats(0.01, 50), st.floats(0.01, 50)), power=st.floats(-3, 3), s=shares)
def test_powers(a: tuple, power: float, s: float) -> None:
    x = interval(*a)
    assert holds(x**power, mpf(member(x, s)) ** mpf(power))


def test_a_wrong_rounding_direction_is_caught(monkeypatch: pytest.MonkeyPatch) -> None:
    """The tests above would see ends that aren't rounded outward."""
    monkeypatch.setattr(intervals, "_rounded", lambda low, high: Intervals(low, high))
    third = 1.0 / Intervals(np.array([3.0]))
    assert not holds(third, mpf(1) / 3)


def test_large_angles_are_undecided_within_bounds() -> None:
    found = intervals.sin(Intervals(np.array([1e12]), np.array([1e12])))
    assert (found.low[0], found.high[0]) == (-1.0, 1.0)


def test_round_off_below_zero_is_not_cut_off() -> None:
    found = intervals.sqrt(Intervals(np.array([-1e-18]), np.array([4.0])))
    assert (found.low[0], found.high[0]) == (-np.inf, np.inf)
