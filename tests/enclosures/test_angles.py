"""Stretches of angles hold all zeros of polynomials over cells: against the zeros at random places."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from linkwright.enclosures.angles import Polynomials, Stretches, cosine_and_sine, stretches
from linkwright.enclosures.forms import AffineForm
from linkwright.notation.harmonics import ANGLES, basis, zeros

Array = NDArray[np.float64]
COUNT = 60


def told(value: Array, u: Array, v: Array) -> Stretches:
    """The stretches of polynomials of coefficients (7, n) that depend on u and v."""

    def at(phi: Array, of: slice | Array, order: int) -> AffineForm:
        row = basis(phi, order) if np.ndim(phi) else basis(np.array([phi]), order)
        parts = [(row * part[:, of]).sum(axis=0) for part in (value, u, v)]
        return AffineForm(*parts, np.full(parts[0].size, 1e-15))

    values = [at(phi, slice(None), 0) for phi in ANGLES]
    return stretches(Polynomials(values, lambda of, phi: [at(phi, of, order) for order in (0, 1)]))


@given(st.integers(0, 2**32 - 1), st.floats(-6, -0.5))
@settings(max_examples=25, deadline=None)
def test_all_zeros_lie_in_stretches_and_no_more_than_these_can_hold(seed: int, size: float) -> None:
    rng = np.random.default_rng(seed)
    value, u, v = (rng.normal(size=(7, COUNT)) * scale for scale in (1.0, 10.0**size, 10.0**size))
    if seed % 2:  # double zeros in the middles of the cells
        value[0] -= (basis(np.full(COUNT, 0.3)) * value).sum(axis=0)
        value[1] -= (basis(np.full(COUNT, 0.3), 1) * value).sum(axis=0) / -np.sin(0.3)
        value[0] -= (basis(np.full(COUNT, 0.3)) * value).sum(axis=0)
    found = told(value, u, v)
    low, high = found.room.bounds
    for a, b in rng.uniform(-1, 1, (8, 2)):
        number = np.zeros(found.of.size, dtype=int)
        for row in zeros(value + a * u + b * v):
            some = np.flatnonzero(np.isfinite(row))
            inside = (found.of == some[:, None]) & (
                (row[some, None] - found.low) % (2 * np.pi) <= found.high - found.low
            )
            near = np.abs((row[some, None] - found.middle + np.pi) % (2 * np.pi) - np.pi) <= found.half + 1e-12
            assert (inside & near).any(axis=1).all()
            number += (inside & near).sum(axis=0)
        known = found.most > 0
        assert (number[known] <= found.most[known]).all()
        assert (number[low > 0] >= 1).all() and (number[high < 0] == 0).all()


def test_small_cells_tell_nearly_all() -> None:
    rng = np.random.default_rng(1)
    value, u, v = (rng.normal(size=(7, 500)) * scale for scale in (1.0, 1e-5, 1e-5))
    found = told(value, u, v)
    assert (found.most == 0).sum() <= 1 and (found.most == 1).mean() > 0.9


def test_what_has_no_bound_tells_nothing() -> None:
    none = np.zeros((7, 1))
    value = np.array([[1.0], [0.5], [0], [0], [0], [0], [0]])
    values = [AffineForm((basis(np.array([phi])) * value).sum(axis=0), rest=np.array([np.inf])) for phi in ANGLES]
    found = stretches(Polynomials(values, lambda of, phi: [AffineForm(np.zeros(of.size), rest=np.inf)] * 2))
    assert found.of.tolist() == [0] and found.most.tolist() == [0] and found.half[0] >= np.pi - 1e-9
    assert told(value, none, none).of.size == 0  # 1 + cos(phi) / 2 has no zero


@pytest.mark.parametrize("size", [1e-3, 0.3, 2.0])
def test_cosine_and_sine_of_angles_that_depend_on_the_place(size: float) -> None:
    phi, rng = np.array([-2.0, 0.1, 3.0]), np.random.default_rng(0)
    away = AffineForm(
        0.1 * size * np.ones(3), 0.3 * size * np.ones(3), -0.2 * size * np.ones(3), 0.1 * size * np.ones(3)
    )
    c, s = cosine_and_sine(phi, away)
    for u, v, w in rng.uniform(-1, 1, (200, 3)):
        angle = phi + away.value + u * away.u + v * away.v + w * away.rest
        for form, true in ((c, np.cos(angle)), (s, np.sin(angle))):
            assert (np.abs(true - form.value - u * form.u - v * form.v) <= form.rest + 1e-15).all()
    if size < 1e-2:
        assert max(c.rest.max(), s.rest.max()) < 0.15 * size
