"""Reductions over samples: against exact sums, and twins held to each other bit by bit."""

from __future__ import annotations

from functools import reduce
from typing import Any

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from linkwright.blocks import UNIT, Reduction, Tallies
from linkwright.blocks.histogram import Histogram
from linkwright.blocks.moments import Moments
from linkwright.blocks.reductions import part

State = dict[str, Any]
EDGES = [[-2.0, -1.0, 0.5, 0.75, 2.0], [0.0, 1e-3, 1.0, 1.5, 9.0]]


def state(reduction: Reduction, y: Any, first: int = 0, strip: int = UNIT) -> State:
    """The state of one atom, its samples handed over in strips."""
    tally = reduction.tally(y.shape[0], y.shape[2])
    for start in range(0, y.shape[1], strip):
        tally.add(y[:, start : start + strip], first + start)
    return tally.state()


def reduced(reduction: Reduction, y: Any, unit: int = UNIT) -> State:
    """The figures of all samples, folded unit by unit."""
    states = [state(reduction, y[:, start : start + unit], start) for start in range(0, y.shape[1], unit)]
    return reduction.result(reduce(reduction.fold, states))


def same_bits(a: State, b: State) -> bool:
    return a.keys() == b.keys() and all(
        a[k].tobytes() == b[k].tobytes() and (a[k].dtype, a[k].shape) == (b[k].dtype, b[k].shape) for k in a
    )


def values(outputs: int, samples: int, poses: int, missing: float, seed: int = 0) -> Any:
    rng = np.random.default_rng(seed)
    y = rng.normal(rng.normal(size=(outputs, 1, poses)) * 3, 1.0, (outputs, samples, poses))
    y[rng.random(y.shape) < missing] = np.nan
    return y


def exact(column: Any) -> tuple[float, float]:
    """Mean and sample deviation of finite values, in 60 digits."""
    with mpmath.workdps(60):
        x = [mpmath.mpf(float(v)) for v in column if np.isfinite(v)]
        mean = mpmath.fsum(x) / len(x)
        return float(mean), float(mpmath.sqrt(mpmath.fsum((v - mean) ** 2 for v in x) / (len(x) - 1)))


@pytest.mark.parametrize(
    ("mean", "deviation", "tolerance"),
    [
        (0.0, 1.0, 1e-14),
        (1e6, 1.0, 1e-14),
        (1e6, 1e-6, 1e-14),  # 1e-12 of the mean; the values themselves are rounded to 1e-4 deviations
        (-1e12, 1e-3, 1e-14),
        (1e-200, 1e-150, 1e-14),
    ],
)
def test_moments_keep_their_digits(mean: float, deviation: float, tolerance: float) -> None:
    """The exact moments of the doubles given, however small the deviation is beside the mean."""
    y = mean + deviation * np.random.default_rng(3).standard_normal((1, 3000, 2))
    figures = reduced(Moments(), y, unit=512)
    for pose in range(2):
        m, s = exact(y[0, :, pose])
        assert abs(figures["mean"][0, pose] - m) <= np.spacing(abs(m)) + tolerance * deviation
        assert figures["deviation"][0, pose] == pytest.approx(s, rel=tolerance)


def test_an_outlier_in_front_costs_few_digits() -> None:
    """The shift is the first value: one far off the rest is the worst that can come, and bounded (see moments.py)."""
    y = np.random.default_rng(4).standard_normal((1, UNIT, 1))
    y[0, 0, 0] = 1e9
    figures = reduced(Moments(), y)
    m, s = exact(y[0, :, 0])
    assert abs(figures["mean"][0, 0] - m) <= 1e-12 * s
    assert figures["deviation"][0, 0] == pytest.approx(s, rel=1e-9)


def test_figures_of_values_with_gaps() -> None:
    """Against NumPy's own, which skip NaN; infinite values are no values either."""
    y = values(3, 1000, 7, 0.2)
    y[1, 3, 2], y[1, 4, 2] = np.inf, -np.inf
    y[:, :, 4] = np.nan  # never assembled
    y[2, 1:, 5] = np.nan  # once
    figures = reduced(Moments(), y, unit=300)
    plain = np.where(np.isfinite(y), y, np.nan)
    some = np.isfinite(y).any(axis=1)
    assert np.array_equal(figures["count"], np.isfinite(y).sum(axis=1))
    assert np.array_equal(figures["count"] + figures["missing"], np.full((3, 7), 1000))
    low, high = np.fmin.reduce(plain, axis=1), np.fmax.reduce(plain, axis=1)
    assert np.array_equal(figures["least"], low, equal_nan=True)
    assert np.array_equal(figures["largest"], high, equal_nan=True)
    for o, p in np.argwhere(some):
        assert figures["least_at"][o, p] == np.flatnonzero(plain[o, :, p] == low[o, p])[0]
        assert figures["largest_at"][o, p] == np.flatnonzero(plain[o, :, p] == high[o, p])[0]
        assert figures["mean"][o, p] == pytest.approx(np.nanmean(plain[o, :, p]), rel=1e-12)
    assert (figures["least_at"][:, 4] == -1).all()
    assert (figures["largest_at"][:, 4] == -1).all()
    assert np.isnan(figures["mean"][:, 4]).all()
    assert np.isnan(figures["deviation"][2, 5])
    assert figures["mean"][2, 5] == y[2, 0, 5]


def test_the_first_of_equal_extremes_is_named() -> None:
    y = np.tile([[[1.0], [2.0], [2.0], [1.0]]], (1, 3, 1))
    figures = reduced(Moments(), y, unit=5)
    assert (figures["least_at"][0, 0], figures["largest_at"][0, 0]) == (0, 1)


def test_counts_between_edges() -> None:
    """Against numpy.histogram, whose convention it is."""
    y = values(2, 900, 5, 0.1)
    y[0, :4, 0], y[1, :2, 1] = [-2.0, 2.0, 0.5, np.nextafter(2.0, 3.0)], [9.0, -1e-300]
    figures = reduced(Histogram(EDGES), y, unit=256)
    for o in range(2):
        for p in range(5):
            column = y[o, :, p][np.isfinite(y[o, :, p])]
            assert np.array_equal(figures["counts"][o, :, p], np.histogram(column, EDGES[o])[0])
            assert figures["under"][o, p] == (column < EDGES[o][0]).sum()
            assert figures["over"][o, p] == (column > EDGES[o][-1]).sum()
            assert figures["missing"][o, p] == 900 - len(column)


REDUCTIONS = {
    "moments": lambda outputs, fast: Moments(fast=fast),
    "histogram": lambda outputs, fast: Histogram([EDGES[i % 2] for i in range(outputs)]),
    "even": lambda outputs, fast: Histogram([np.linspace(-2, 2, 31)] * outputs),
}


@pytest.mark.parametrize("name", REDUCTIONS)
@pytest.mark.parametrize("fast", [False, True])
@pytest.mark.parametrize(
    "shape",
    [(1, 700, 1), (2, 700, 1), (3, 513, 2), (1, 129, 3), (2, 301, 23), (1, 300, 24), (2, 301, 65), (1, 5, 40_000)],
)
@pytest.mark.parametrize("missing", [0.0, 0.3, 1.0])
def test_strips_change_no_bit(name: str, fast: bool, shape: tuple[int, int, int], missing: float) -> None:
    """However an atom's samples are handed over, and whichever twin takes them."""
    if fast:
        pytest.importorskip("llvmlite")
    y = values(*shape, missing)
    whole = state(REDUCTIONS[name](shape[0], False), y, 17)
    for strip in (1, 7, 256, 5000):
        if shape[1] // strip < 600 or fast:
            assert same_bits(state(REDUCTIONS[name](shape[0], fast), y, 17, strip), whole)


@given(st.integers(1, 3), st.integers(1, 40), st.integers(1, 9), st.data())
def test_poses_are_reduced_each_on_its_own(outputs: int, samples: int, poses: int, data: st.DataObject) -> None:
    y = values(outputs, samples, poses, data.draw(st.sampled_from([0.0, 0.5])), data.draw(st.integers(0, 99)))
    together = state(Moments(), y)
    for pose in range(poses):
        alone = state(Moments(), y[:, :, pose : pose + 1])
        assert all(alone[key].tobytes() == together[key][:, pose : pose + 1].tobytes() for key in together)


def test_sums_are_taken_one_after_the_other() -> None:
    """What the compiled twin does by its loop, the plain one must do too; a pairwise sum gives other bits."""
    y = values(1, UNIT, 1, 0.0)
    d = y[0, :, 0] - y[0, 0, 0]
    assert state(Moments(), y)["offset"][0, 0] == reduce(lambda a, b: a + b, d.tolist()) / UNIT != d.sum() / UNIT


@pytest.mark.parametrize(
    "edges", [np.linspace(0, 1, 11), np.linspace(-1e-3, 7e5, 1001), [0.0, 1e-9, 1.0], [0.0, 3e-310]]
)
def test_values_on_edges_and_beside_them(edges: Any) -> None:
    """Each edge, and the doubles next to it, counts where NumPy counts it."""
    e = np.asarray(edges)
    y = np.concatenate([e, np.nextafter(e, -np.inf), np.nextafter(e, np.inf), [-1e300, 1e300]]).reshape(1, -1, 1)
    found = Histogram([e]).result(state(Histogram([e]), y))
    assert np.array_equal(found["counts"][0, :, 0], np.histogram(y, e)[0])


def test_tallies_keep_several_apart() -> None:
    y = values(2, 50, 4, 0.1)
    both = {"m": Moments(), "h": Histogram(EDGES)}
    tallies = Tallies(both, 2, 4)
    tallies.add(y, 0)
    for name, reduction in both.items():
        assert same_bits(part(tallies.state(), name), state(reduction, y))


@pytest.mark.parametrize("edges", [[], [[1.0]], [[1.0, 1.0]], [[2.0, 1.0]], [[0.0, np.inf]], [[0.0, np.nan]]])
def test_edges_that_bound_nothing_are_refused(edges: Any) -> None:
    with pytest.raises(ValueError, match="edges"):
        Histogram(edges)


def test_edges_must_be_the_outputs() -> None:
    with pytest.raises(ValueError, match="edges for 2"):
        Histogram(EDGES).tally(3, 1)
