"""The farthest of sums of deviations and vectors of any direction, against corners, closed forms, fine directions."""

from __future__ import annotations

from itertools import product

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from linkwright.studies.workspace.farthest import farthest

Array = NDArray[np.float64]
FINE = np.linspace(0, 2 * np.pi, 7201)


def brute(slopes: Array, low: Array, high: Array, rounds: Array) -> Array:
    """The reach in 7201 directions, each 1e-7 of it from the greatest at the most."""
    normal = np.stack([np.cos(FINE), np.sin(FINE)])
    along = np.einsum("kin,kt->int", slopes, normal)
    reach = np.maximum(low[:, :, None] * along, high[:, :, None] * along).sum(axis=0)
    reach += np.hypot(*np.einsum("kcjn,kt->cjnt", rounds, normal)).sum(axis=0)
    return np.asarray(reach.max(axis=1))


def test_of_all_corners() -> None:
    rng = np.random.default_rng(3)
    slopes, ends = rng.normal(size=(2, 5, 40)), np.sort(rng.normal(size=(2, 5, 1)), axis=0)
    corners = [np.hypot(*(slopes * np.array(corner)[:, None]).sum(axis=1)) for corner in product(*ends[:, :, 0].T)]
    np.testing.assert_allclose(farthest(slopes, *ends), np.max(corners, axis=0), rtol=1e-12)


def test_circles_add_their_radii() -> None:
    rng = np.random.default_rng(4)
    slopes, half = rng.normal(size=(2, 3, 30)), np.ones((3, 1))
    turn, radii = rng.uniform(0, 7, 30), np.array([[0.2], [1.5]])
    cos, sin = radii * np.cos(turn), radii * np.sin(turn)
    rounds = np.array([[cos, sin], [-sin, cos]])
    expected = farthest(slopes, -half, half) + 1.7
    np.testing.assert_allclose(farthest(slopes, -half, half, rounds), expected, rtol=1e-12)


def test_an_ellipse_reaches_its_long_axis() -> None:
    rng = np.random.default_rng(5)
    rounds = rng.normal(size=(2, 2, 1, 50))
    nothing = np.zeros((0, 1))
    found = farthest(np.zeros((2, 0, 50)), nothing, nothing, rounds)
    long = np.linalg.svd(np.moveaxis(rounds[:, :, 0], 2, 0), compute_uv=False)[:, 0]
    assert (found >= long * (1 - 1e-15)).all()
    np.testing.assert_allclose(found, long, rtol=1e-4)


@settings(max_examples=60, deadline=None)
@given(st.integers(0, 6), st.integers(1, 4), st.integers(0, 2**32 - 1), st.floats(1e-9, 1.0))
def test_never_below_nor_far_above_the_truth(sides: int, vectors: int, seed: int, flat: float) -> None:
    rng = np.random.default_rng(seed)
    slopes, ends = rng.normal(size=(2, sides, 6)), np.sort(rng.normal(size=(2, sides, 1)), axis=0)
    rounds = rng.normal(size=(2, 2, vectors, 6)) * 10 ** rng.uniform(-2, 1, (vectors, 1))
    rounds[:, 1] = rounds[:, 0] * rng.normal(size=(vectors, 6)) + flat * rounds[:, 1]
    found, true = farthest(slopes, *ends, rounds), brute(slopes, *ends, rounds)
    assert (found >= true * (1 - 1e-12)).all()
    assert (found <= true * 1.001).all()


@settings(max_examples=60, deadline=None)
@given(st.integers(0, 5), st.integers(0, 2**32 - 1), st.floats(0, 10), st.floats(0, 10))
def test_grows_with_the_clearance_from_what_it_is_without(sides: int, seed: int, one: float, two: float) -> None:
    rng = np.random.default_rng(seed)
    slopes, ends = rng.normal(size=(2, sides, 6)), np.sort(rng.normal(size=(2, sides, 1)), axis=0)
    rounds = rng.normal(size=(2, 2, 1, 6))
    without, less, more = (farthest(slopes, *ends, c * rounds) for c in (0.0, min(one, two), max(one, two)))
    np.testing.assert_allclose(without, farthest(slopes, *ends), rtol=1e-12, atol=1e-300)
    assert (less >= without * (1 - 1e-12)).all()
    assert (more >= less * (1 - 1e-3)).all()  # both are up to that share above the truth
