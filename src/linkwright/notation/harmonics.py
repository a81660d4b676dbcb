"""Trigonometric polynomials of degree three: a + b1 cos phi + c1 sin phi + ... + b3 cos 3 phi + c3 sin 3 phi.

Their coefficients are arrays (7, n) in this order. With phi = r + 2 arctan t such a polynomial is one of degree six in
t over (1 + t^2)^3, so that it has six zeros and six extrema at most.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.polynomial import polynomial
from numpy.typing import NDArray

Array = NDArray[np.float64]

ORDERS = np.array([0, 1, 1, 2, 2, 3, 3])
"""The harmonic of each coefficient."""
MOST = 6
"""No more zeros or extrema than these."""
COUNT = 8
ANGLES = 2 * np.pi * np.arange(COUNT) / COUNT
"""Equally spaced angles (rad) whose values tell the coefficients ..."""
_SHIFTS = np.array([0.0, *[0.0, -np.pi / 2] * 3])


def basis(phi: Any, derivative: int = 0) -> Array:
    """What each coefficient adds at angles (n,), or to a derivative of some order there: (7, n)."""
    phi = np.asarray(phi, dtype=float)
    k = ORDERS.reshape(-1, *[1] * phi.ndim)
    shift = (_SHIFTS + derivative * np.pi / 2).reshape(k.shape)
    return np.asarray(np.cos(k * phi + shift) * (k**derivative if derivative else 1.0))


WEIGHTS = basis(ANGLES) * np.where(ORDERS == 0, 1.0, 2.0)[:, None] / COUNT
"""... by these weights: (7, 8)."""


def derivative(coefficients: Array) -> Array:
    """The coefficients of the derivative by the angle."""
    found = np.zeros_like(coefficients)
    k = ORDERS[1::2, None]
    found[1::2], found[2::2] = k * coefficients[2::2], -k * coefficients[1::2]
    return found


def _powers() -> NDArray[np.complex128]:
    """(1 + i t)^2k (1 + t^2)^(3 - k), the k-th harmonic times (1 + t^2)^3, by powers of t: (4, 7)."""
    rows = []
    for k in range(4):
        row = np.array([1.0 + 0j])
        for factor in [[1.0, 1j]] * (2 * k) + [[1.0, 0.0, 1.0]] * (3 - k):
            row = polynomial.polymul(row, factor)
        rows.append(np.pad(row, (0, MOST + 1 - row.size)))
    return np.array(rows)


_POWERS = _powers()


def zeros(coefficients: Array) -> Array:
    """All real zeros of polynomials, rising in half-open turns of their own: (6, n), infinite where there are fewer."""
    size = np.abs(coefficients).max(axis=0)
    flat = ~(size > 0) | ~np.isfinite(size)
    scaled = np.where(flat, 0.0, coefficients) / np.where(flat, 1.0, size)
    scaled[1, flat] = 1.0
    # About the angle opposite to that at which the polynomial is largest no zero is near to t = infinity.
    turn = ANGLES[np.abs(basis(ANGLES).T @ scaled).argmax(axis=0)] - np.pi
    harmonics = np.concatenate([scaled[:1] + 0j, scaled[1::2] - 1j * scaled[2::2]])
    harmonics *= np.exp(1j * np.arange(4)[:, None] * turn)
    powers = (_POWERS.T @ harmonics).real
    companion = np.zeros((flat.size, MOST, MOST))
    companion[:, np.arange(1, MOST), np.arange(MOST - 1)] = 1.0
    companion[:, :, -1] = (-powers[:-1] / powers[-1]).T
    t = np.linalg.eigvals(companion).T
    found = np.where(t.imag == 0, turn + 2 * np.arctan(t.real), np.inf)
    found[:, flat] = np.inf
    return np.sort(found, axis=0)
