"""Plane vectors, bodies and wrenches: the identities of rigid-body mechanics, and rates against differences."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from helpers.differences import derivative
from linkwright.notation import Body, Jet, Pair, Vec, Wrench
from linkwright.notation.planar import turning_axis
from linkwright.symbols import ExpressionStage, Symbol

number = st.floats(-3.0, 3.0)
pairs = st.builds(Pair, number, number)
angles = st.floats(-7.0, 7.0)
wrenches = st.builds(Wrench, pairs, number, pairs)


def unit(angle: float) -> Pair:
    return Pair(math.cos(angle), math.sin(angle))


def close(a: Any, b: Any, tolerance: float = 1e-13) -> None:
    a, b = np.asarray(a, dtype=float), np.asarray(b, dtype=float)
    assert np.allclose(a, b, rtol=tolerance, atol=tolerance * max(1.0, float(np.abs(b).max(initial=0.0)))), (a, b)


@given(pairs, pairs, angles)
def test_pairs_are_complex_numbers(a: Pair, b: Pair, angle: float) -> None:
    za, zb, turn = complex(*a), complex(*b), complex(*unit(angle))
    close(a.dot(b), (za.conjugate() * zb).real)
    close(a.cross(b), (za.conjugate() * zb).imag)
    close([*a.rotated(unit(angle))], [(za * turn).real, (za * turn).imag])
    back = za * turn.conjugate()
    close([*a.rotated_back(unit(angle))], [back.real, back.imag])
    close([*a.perp], [(za * 1j).real, (za * 1j).imag])
    close([*a.minus(b)], [(za - zb).real, (za - zb).imag])


def test_a_pair_less_itself_is_a_structural_zero() -> None:
    x = Symbol.named("x")
    assert Pair(x, x).minus(Pair(x, x)) == (0.0, 0.0)


class Moving:
    """A link on a path of its own, with every derivative in closed form."""

    local = Pair(0.3, -0.2)

    @staticmethod
    def angle(t: float) -> float:
        return 0.4 + 1.3 * t + 0.2 * math.sin(2.0 * t)

    @staticmethod
    def turn(t: float, order: int) -> Jet:
        rates = [
            1.3 * (k == 0) + 0.2 * 2.0 ** (k + 1) * math.sin(2.0 * t + (k + 1) * math.pi / 2) for k in range(order)
        ]
        return Jet(rates)

    @staticmethod
    def anchor(t: float, order: int) -> Vec:
        x = [0.5 * 1.7**k * math.sin(1.7 * t + k * math.pi / 2) for k in range(order + 1)]
        y = [math.exp(-0.6 * t) * (-0.6) ** k for k in range(order + 1)]
        return Vec(Jet(x), Jet(y))

    def body(self, t: float, order: int = 4) -> Body:
        axis = turning_axis(unit(self.angle(t)), self.turn(t, order))
        return Body(self.anchor(t, order), self.local, axis, self.turn(t, order))


@pytest.mark.parametrize("t", [-0.7, 0.0, 0.9, 2.3])
def test_turning_axis_against_differences(t: float) -> None:
    axis = Moving().body(t).axis
    for k in range(1, 5):
        rate = derivative(lambda at, k=k: [axis_at(at).x.d[k - 1], axis_at(at).y.d[k - 1]], t, 0.02)
        close([axis.x.d[k], axis.y.d[k]], rate, 1e-9)


def axis_at(t: float) -> Vec:
    return Moving().body(t).axis


@settings(max_examples=30)
@given(angles, st.lists(number, min_size=4, max_size=4))
def test_turning_axis_in_closed_form(angle: float, rates: list[float]) -> None:
    """With e = exp(i phi): e' = i w e, e'' = (i a - w^2) e, e''' = (i j - 3 w a - i w^3) e and so on."""
    w, a, j, s = rates
    axis = turning_axis(unit(angle), Jet(rates))
    e = complex(*unit(angle))
    factors = [1, 1j * w, 1j * a - w**2, 1j * j - 3 * w * a - 1j * w**3]
    factors.append(1j * s - 4 * w * j - 3 * a**2 - 6j * w**2 * a + w**4)
    for k, factor in enumerate(factors):
        close([axis.x.d[k], axis.y.d[k]], [(factor * e).real, (factor * e).imag])


@settings(max_examples=20)
@given(angles, st.lists(number, min_size=3, max_size=3))
def test_turning_axis_stays_a_unit_vector(angle: float, rates: list[float]) -> None:
    axis = turning_axis(unit(angle), Jet(rates))
    close(axis.dot(axis).d, [1.0, 0.0, 0.0, 0.0], 1e-11)


def test_turning_axis_on_symbols() -> None:
    names = Symbol.several("x", 5)
    axis = turning_axis(Pair(names[0], names[1]), Jet([names[2], names[3], names[4]]))
    stage = ExpressionStage(names, [], [*axis.x.d, *axis.y.d])
    values = [math.cos(0.7), math.sin(0.7), 1.1, -0.4, 2.3]
    plain = turning_axis(Pair(*values[:2]), Jet(values[2:]))
    close(stage.numbers(values, []), [*plain.x.d, *plain.y.d])


@pytest.mark.parametrize("point", [Pair(0.0, 0.0), Pair(1.2, 0.7), Pair(0.3, -0.2)])
def test_points_of_a_body_against_differences(point: Pair) -> None:
    link, t = Moving(), 0.8

    def at(time: float, k: int) -> list[float]:
        vec = link.body(time).point(point)
        return [vec.x.d[k], vec.y.d[k]]

    for k in range(1, 5):
        close(at(t, k), derivative(lambda time, k=k: at(time, k - 1), t, 0.02), 1e-9)


@settings(max_examples=30)
@given(pairs, pairs, st.floats(-1.0, 3.0))
def test_distances_on_a_body_are_kept(a: Pair, b: Pair, t: float) -> None:
    body = Moving().body(t)
    between = body.point(a).minus(body.point(b))
    close(between.dot(between).d, [a.minus(b).dot(a.minus(b)), 0, 0, 0, 0], 1e-11)


@settings(max_examples=30)
@given(pairs, st.floats(-1.0, 3.0))
def test_velocity_and_acceleration_of_a_body(local: Pair, t: float) -> None:
    """v = v_O + w x r and a = a_O + alpha x r - w^2 r."""
    body = Moving().body(t)
    at, origin = body.point(local), body.anchor
    arm = at.minus(origin)
    w, alpha = body.turn.d[:2]
    r = Pair(arm.x.d[0], arm.y.d[0])
    velocity = [origin.x.d[1] - w * r.y, origin.y.d[1] + w * r.x]
    acceleration = [origin.x.d[2] - alpha * r.y - w * w * r.x, origin.y.d[2] + alpha * r.x - w * w * r.y]
    close([at.x.d[1], at.y.d[1]], velocity)
    close([at.x.d[2], at.y.d[2]], acceleration, 1e-12)


def test_the_anchor_is_given_back_as_it_is() -> None:
    link = Moving()
    body = link.body(0.3)
    assert body.point(link.local) is body.anchor


def test_the_frame_rests() -> None:
    frame = Body.fixed(3)
    assert frame.angle == 0.0
    assert frame.turn.d == (0.0, 0.0, 0.0)
    at = frame.point(Pair(2.0, 3.0))
    assert at.x.d == (2.0, 0.0, 0.0, 0.0)
    assert at.y.d == (3.0, 0.0, 0.0, 0.0)


@given(pairs, pairs)
def test_vectors_of_constants(a: Pair, b: Pair) -> None:
    va, vb = Vec.constant(a, 2), Vec.constant(b, 2)
    assert va.dot(vb).d[0] == a.dot(b)
    assert va.cross(vb).d[0] == a.cross(b)
    assert va.perp.now == a.perp
    close([*va.plus(vb).now], [a.x + b.x, a.y + b.y])
    close([*va.times(2.0).now], [2 * a.x, 2 * a.y])
    close([*va.times(Jet.constant(2.0, 2)).now], [2 * a.x, 2 * a.y])
    close([*va.carry(b).now], [*b.rotated(a)])


@given(wrenches, pairs, pairs)
def test_a_wrench_stated_elsewhere_is_the_same(w: Wrench, p: Pair, q: Pair) -> None:
    """M_q = M_p + (p - q) x F; the force stays, the way taken doesn't matter, and there and back is nothing."""
    moved = w.at(p)
    assert moved.force == w.force
    assert moved.about == p
    close(moved.moment, w.moment + (w.about.x - p.x) * w.force.y - (w.about.y - p.y) * w.force.x)
    close(moved.at(q).moment, w.at(q).moment, 1e-12)
    close(moved.at(w.about).moment, w.moment, 1e-12)


@given(wrenches, wrenches, pairs)
def test_wrenches_add(a: Wrench, b: Wrench, p: Pair) -> None:
    total = a.plus(b)
    assert total.about == a.about
    close([*total.force], [a.force.x + b.force.x, a.force.y + b.force.y])
    close(total.at(p).moment, a.at(p).moment + b.at(p).moment, 1e-12)
    close(b.plus(a).at(p).moment, total.at(p).moment, 1e-12)


@given(wrenches, pairs)
def test_a_wrench_and_its_opposite_cancel(w: Wrench, p: Pair) -> None:
    rest = w.plus(w.opposite)
    assert rest.force == (0.0, 0.0)
    assert rest.moment == 0.0
    assert Wrench.zero(p).plus(w).at(w.about).moment == pytest.approx(w.moment, abs=1e-12)


@given(wrenches, pairs, angles, number)
def test_power_of_a_wrench_does_not_depend_on_the_point(w: Wrench, p: Pair, angle: float, omega: float) -> None:
    """F . v + M w with the velocity of the point that the moment is about."""
    v0 = unit(angle)

    def velocity(point: Pair) -> Pair:
        return Pair(v0.x - omega * point.y, v0.y + omega * point.x)

    here, there = w, w.at(p)
    powers = [x.force.dot(velocity(x.about)) + x.moment * omega for x in (here, there)]
    close(powers[0], powers[1], 1e-12)
