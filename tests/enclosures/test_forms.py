"""Linear forms over a square hold what they say: against exact fractions, and against many digits at roots."""

from __future__ import annotations

import operator
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from linkwright.enclosures.forms import AffineForm
from linkwright.enclosures.program import BOXES, Stage
from linkwright.symbols import ExpressionStage, Symbol

DIGITS = 60
NUMBERS = st.one_of(
    st.floats(-8, 8).filter(lambda v: v == 0 or abs(v) > 1e-6), st.sampled_from([0.0, 1.0, -2.0, 1e-5, 1e5])
)
SPOTS = [*np.random.default_rng(0).uniform(-1, 1, (8, 2)).tolist(), [-1, -1], [1, -1], [-1, 1], [1, 1], [0, 0]]


@dataclass(frozen=True)
class Line:
    """value + u slope_u + v slope_v: as a form over a batch of one, and as its true value."""

    value: float
    u: float
    v: float

    def form(self) -> AffineForm:
        return AffineForm(np.array([self.value]), np.array([self.u]), np.array([self.v]), np.array([0.0]))

    def at(self, u: Any, v: Any, number: Callable[[float], Any]) -> Any:
        return number(self.value) + number(self.u) * u + number(self.v) * v


@dataclass(frozen=True)
class Fixed:
    """A number."""

    value: float

    def form(self) -> AffineForm:
        return AffineForm(self.value)

    def at(self, u: Any, v: Any, number: Callable[[float], Any]) -> Any:
        return number(self.value)


@dataclass(frozen=True)
class Made:
    """An operation on one or two expressions."""

    on_forms: Callable[..., AffineForm]
    on_numbers: Callable[..., Any]
    of: tuple[Any, ...]

    def form(self) -> AffineForm:
        with np.errstate(all="ignore"):
            return self.on_forms(*(one.form() for one in self.of))

    def at(self, u: Any, v: Any, number: Callable[[float], Any]) -> Any:
        return self.on_numbers(*(one.at(u, v, number) for one in self.of))


def both(a: Any, b: Any, op: Callable[..., Any]) -> Made:
    return Made(op, op, (a, b))


LINES = st.builds(Line, NUMBERS, NUMBERS, NUMBERS)
LEAVES = st.one_of(LINES, st.builds(Fixed, NUMBERS))
SMOOTH = [
    lambda some: st.builds(both, some, some, st.sampled_from([operator.add, operator.sub, operator.mul])),
    lambda some: some.map(lambda a: Made(AffineForm.square, lambda x: x * x, (a,))),
    lambda some: some.map(lambda a: Made(operator.neg, operator.neg, (a,))),
    lambda some: some.map(lambda a: Made(AffineForm.magnitude, abs, (a,))),
    lambda some: st.builds(both, some, some, st.just(operator.truediv)),
]
EXACT = st.recursive(LEAVES, lambda some: st.one_of(*(make(some) for make in SMOOTH)), max_leaves=8)
ROOTS = st.recursive(
    LEAVES,
    lambda some: st.one_of(
        *(make(some) for make in SMOOTH), some.map(lambda a: Made(AffineForm.sqrt, mpmath.sqrt, (a,)))
    ),
    max_leaves=8,
)


def holds(form: AffineForm, true: Any, u: Any, v: Any, number: Callable[[float], Any]) -> bool:
    """Whether a true value lies in a form's plane, in exact arithmetic."""
    value, slope, other, rest = (float(np.ravel(x)[0]) for x in (form.value, form.u, form.v, form.rest))
    if rest == np.inf or not np.isfinite([value, slope, other, rest]).all():
        return True
    low, high = (float(np.ravel(x)[0]) for x in form.bounds)
    plane = number(value) + number(slope) * u + number(other) * v
    between = (low == -np.inf or number(low) <= true) and (high == np.inf or true <= number(high))
    return bool(abs(true - plane) <= number(rest) and between)


@settings(max_examples=300, deadline=None)
@given(EXACT)
def test_what_follows_without_roots_lies_in_its_plane(made: Any) -> None:
    form = made.form()
    for spot in SPOTS:
        u, v = map(Fraction, spot)
        try:
            true = made.at(u, v, Fraction)
        except ZeroDivisionError:
            continue
        assert holds(form, true, u, v, Fraction)


@settings(max_examples=300, deadline=None)
@given(ROOTS)
def test_what_follows_with_roots_lies_in_its_plane_where_they_are_real(made: Any) -> None:
    form = made.form()
    with mpmath.workdps(DIGITS):
        for spot in SPOTS:
            u, v = map(mpmath.mpf, spot)
            try:
                known = real(made, u, v)
            except ZeroDivisionError:
                continue
            assert not known or holds(form, made.at(u, v, mpmath.mpf), u, v, mpmath.mpf)


def real(made: Any, u: Any, v: Any) -> bool:
    """Whether each root on the way is."""
    if not isinstance(made, Made):
        return True
    here = made.at(u, v, mpmath.mpf)
    return isinstance(here, mpmath.mpf) and all(real(one, u, v) for one in made.of)


def line(value: float, u: float, v: float = 0.0) -> AffineForm:
    return Line(value, u, v).form()


def test_a_linear_form_keeps_its_slopes() -> None:
    made = (line(1, 2, 3) + line(4, -1, 0.5)) * AffineForm(2.0) - line(0, 1, 1)
    assert (made.value[0], made.u[0], made.v[0]) == (10, 1, 6)
    assert made.rest[0] < 1e-12


def test_what_cancels_leaves_next_to_nothing() -> None:
    """Intervals would leave 2."""
    one = line(3, 1, 0)
    made = one - one
    assert made.value[0] == made.u[0] == 0 and made.rest[0] < 1e-13


def test_a_root_over_a_range_from_zero_holds_at_both_ends() -> None:
    """Of 1 + u: the root of a range from 0 to 2 is off its line by an eighth of it, to either side."""
    root = line(1, 1).sqrt()
    assert root.rest[0] == pytest.approx(np.sqrt(2) / 8, rel=1e-9)
    for u in np.linspace(-1, 1, 41):
        assert abs(np.sqrt(1 + u) - root.value[0] - root.u[0] * u) <= root.rest[0]


def test_a_root_across_zero_holds_where_it_is_real() -> None:
    root = line(0.5, 1, 1).sqrt()
    assert np.isfinite(root.rest[0])
    for u in np.linspace(-1, 1, 21):
        for v in np.linspace(-1, 1, 21):
            if 0.5 + u + v >= 0:
                assert abs(np.sqrt(0.5 + u + v) - root.value[0] - root.u[0] * u - root.v[0] * v) <= root.rest[0]


@pytest.mark.parametrize("ends", [(-1.0, 3.0), (0.0, 2.0), (-2.0, 0.0)])
def test_a_reciprocal_of_a_range_with_zero_has_no_bound(ends: tuple[float, float]) -> None:
    low, high = ends
    made = line((low + high) / 2, (high - low) / 2).inverse()
    assert made.rest[0] == np.inf
    assert made.bounds[0][0] == -np.inf and made.bounds[1][0] == np.inf


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_reciprocal_is_the_line_of_least_error(sign: float) -> None:
    """Of a range from 1 to 4: the chord 5/4 - x/4 lies 1/4 over the line that touches 1/x at 2."""
    made = line(2.5 * sign, 1.5).inverse()
    assert made.rest[0] == pytest.approx(0.125, rel=1e-9)
    assert made.u[0] == pytest.approx(-0.375)


def test_a_square_lies_over_the_tangent() -> None:
    made = line(0, 1).square()
    assert (made.value[0], made.u[0]) == (0.5, 0) and made.rest[0] == pytest.approx(0.5)


def test_a_magnitude_of_one_sign_is_exact() -> None:
    for sign in (1.0, -1.0):
        made = line(3 * sign, 2).magnitude()
        assert (made.value[0], made.u[0], made.rest[0]) == (3, 2 * sign, 0)
    across = line(1, 2).magnitude()
    assert across.bounds[0][0] <= 0 and across.bounds[1][0] >= 3


def test_numbers_are_constant_and_known_to_a_few_roundings() -> None:
    made = AffineForm(3.0) * AffineForm(0.1) + AffineForm(2.0) / AffineForm(7.0)
    assert made.constant
    assert abs(made.value - (0.3 + 2 / 7)) <= made.rest < 1e-14
    assert not line(1, 1).constant


def test_a_batch_is_done_all_at_once() -> None:
    """Each as by itself, those without bound among them."""
    value, slope = np.array([2.0, 0.5, -3.0, 0.0]), np.array([1.0, 1.0, 1.0, 0.0])
    many = AffineForm(value, slope, 0 * slope, 0 * slope).inverse()
    for k in range(value.size):
        one = line(value[k], slope[k]).inverse()
        assert [x[k] for x in (many.value, many.u, many.rest)] == [x[0] for x in (one.value, one.u, one.rest)]
    assert np.isinf(many.rest).tolist() == [False, True, False, True]


def test_a_program_runs_on_boxes() -> None:
    """Functions of parameters alone are numbers; of places only sums, products, quotients, roots and magnitudes are."""
    x, p = Symbol.several("x", 2), Symbol.several("p", 1)
    rows = [(x[0] ** 2 + x[1] ** 2).do("sqrt") * p[0].do("cos"), abs(x[0]) / (3 + x[1])]
    stage = Stage(ExpressionStage(x, p, rows), np.array([0.3]), [0, 1], BOXES)
    centre, half = (1.0, 2.0), 0.25
    boxes = [
        AffineForm(np.array([centre[0]]), np.array([half]), np.zeros(1)),
        AffineForm(np.array([centre[1]]), np.zeros(1), np.array([half])),
    ]
    first, second = stage(boxes.__getitem__)
    for u, v in SPOTS:
        a, b = centre[0] + half * u, centre[1] + half * v
        for form, true in ((first, np.hypot(a, b) * np.cos(0.3)), (second, abs(a) / (3 + b))):
            assert abs(true - form.value[0] - form.u[0] * u - form.v[0] * v) <= form.rest[0] + 1e-14
            assert form.rest[0] < 0.05


def test_a_function_of_places_without_an_enclosure_is_refused() -> None:
    x, p = Symbol.several("x", 2), Symbol.several("p", 1)
    stage = Stage(ExpressionStage(x, p, [x[0].do("sin")]), np.array([0.3]), [0], BOXES)
    with pytest.raises(NotImplementedError, match="no enclosure"):
        stage([line(0, 1), line(0, 0, 1)].__getitem__)
