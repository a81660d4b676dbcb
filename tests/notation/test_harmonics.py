"""Trigonometric polynomials: against sums of cosines and sines, and signs on fine grids."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from linkwright.notation.harmonics import ANGLES, MOST, WEIGHTS, basis, derivative, zeros

FINE = np.linspace(-np.pi, np.pi, 20_001)


@pytest.mark.parametrize("order", range(5))
def test_derivatives_of_the_basis(order: int) -> None:
    phi = np.array([-2.0, 0.0, 0.3, 3.0])
    rows = [np.cos(order * np.pi / 2) * (order == 0) * np.ones(4)]
    for k in (1, 2, 3):
        rows += [k**order * np.cos(k * phi + order * np.pi / 2), k**order * np.sin(k * phi + order * np.pi / 2)]
    np.testing.assert_allclose(basis(phi, order), rows, atol=1e-12)
    coefficients = np.random.default_rng(0).normal(size=(7, 3))
    np.testing.assert_allclose(
        basis(phi, order + 1).T @ coefficients, basis(phi, order).T @ derivative(coefficients), atol=1e-11
    )


def test_values_at_equal_steps_tell_the_coefficients() -> None:
    coefficients = np.random.default_rng(0).normal(size=(7, 5))
    np.testing.assert_allclose(WEIGHTS @ (basis(ANGLES).T @ coefficients), coefficients, atol=1e-14)


@given(st.integers(0, 2**32 - 1))
@settings(max_examples=20, deadline=None)
def test_all_zeros_are_found(seed: int) -> None:
    """As many as signs change on a fine grid, and each is one."""
    coefficients = np.random.default_rng(seed).normal(size=(7, 40))
    found = zeros(coefficients)
    values = basis(FINE).T @ coefficients
    known = np.isfinite(found)
    np.testing.assert_array_equal(known.sum(axis=0), (values[1:] * values[:-1] < 0).sum(axis=0))
    assert (np.diff(np.where(known, found, 1e3), axis=0) >= 0).all() and len(found) == MOST
    slot, of = np.nonzero(known)
    assert np.abs((basis(found[slot, of]) * coefficients[:, of]).sum(axis=0)).max() < 1e-12


def test_lower_degrees_and_nothing_at_all() -> None:
    first = np.zeros((7, 3))
    first[1, 0] = 1.0  # cos phi
    first[4, 1] = 1.0  # sin 2 phi
    found = zeros(first)
    assert np.isfinite(found).sum(axis=0).tolist() == [2, 4, 0]
    np.testing.assert_allclose(np.cos(found[:2, 0]), 0, atol=1e-12)
    np.testing.assert_allclose(np.sin(2 * found[:4, 1]), 0, atol=1e-12)
