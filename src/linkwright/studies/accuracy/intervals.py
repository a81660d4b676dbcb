"""What random samples say of a figure: coverage interval, confidence intervals, convergence.

The confidence intervals are those of independent samples. A Latin hypercube's mean of any function of the samples has
at most n/(n - 1) times the variance (Owen, SIAM J. Numer. Anal. 34 (1997) 1884-1910), and the variance of the samples
is such a mean: so both intervals hold there too, on the wide side. Of scrambled Sobol' points nothing is claimed.
"""

from __future__ import annotations

from math import isfinite, sqrt

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Interval = tuple[float, float]

LEAST = 8
"""Samples that a kurtosis is estimated of, at the least."""


def coverage(values: Array, share: float) -> Interval:
    """The interval that holds a share of finite values, with as many below as above: of order statistics (JCGM
    101:2008, 7.7.2). Of too few values it's their range."""
    n = values.size
    if not n:
        return np.nan, np.nan
    within = min(int(share * n + 0.5), n - 1)
    below = max((n - within + 1) // 2, 1)
    ordered = np.partition(values, [below - 1, below + within - 1])
    return float(ordered[below - 1]), float(ordered[below + within - 1])


def counted_coverage(edges: Array, counts: NDArray[np.int64], ends: tuple[int, int], share: float) -> Interval:
    """The same from a histogram, even inside its bins; ``ends`` are the values under and over its edges. NaN where
    these alone are more than lie outside."""
    total = int(counts.sum()) + sum(ends)
    below = np.concatenate([[ends[0]], ends[0] + np.cumsum(counts)])
    places = np.array([(1 - share) / 2, (1 + share) / 2]) * total
    found = np.interp(places, below, edges, left=np.nan, right=np.nan)
    return float(found[0]), float(found[1])


def of_mean(mean: float, sigma: float, n: int, confidence: float) -> Interval | None:
    """Student's interval of the mean of all that might be made; for any distribution where samples are many."""
    from scipy.special import stdtrit

    if n < 2:
        return None
    half = float(stdtrit(n - 1, 0.5 + confidence / 2)) * sigma / sqrt(n)
    return mean - half, mean + half


def of_sigma(sigma: float, n: int, kurtosis: float, confidence: float) -> Interval | None:
    """The interval of the standard deviation of all that might be made: sigma^2 nu / chi^2(nu), with as many degrees of
    freedom as give the variance of the samples' variance its size, 2 sigma^4/nu = sigma^4 (2/(n - 1) + (kurtosis -
    3)/n) (Mood, Graybill, Boes, Introduction to the Theory of Statistics, 3rd ed. 1974, VI.2.3, theorem 6).

    Of normal values it is the usual one, nu = n - 1; of others that one would be too narrow or too wide however many
    samples there are. A kurtosis of few samples is a poor guess: of fewer than :data:`LEAST` there is no interval.
    """
    from scipy.special import chdtri

    if n < LEAST or not isfinite(kurtosis):
        return (sigma, sigma) if n >= LEAST and sigma == 0 else None
    freedom = 2 / max(2 / (n - 1) + (kurtosis - 3) / n, 2 / n**2)
    tail = (1 - confidence) / 2
    low, high = (sigma * sqrt(freedom / float(chdtri(freedom, p))) for p in (tail, 1 - tail))
    return low, high


def kurtosis(values: Array) -> float:
    """The kurtosis of finite values; NaN where all are the same."""
    d = values - values.mean() if values.size else values
    second = float(np.mean(d**2)) if values.size else 0.0
    return float(np.mean(d**4)) / second**2 if second > 0 else np.nan


def convergence(values: Array, marks: int) -> Array:
    """Rows (samples, mean, standard deviation) as the samples grow in number; values that aren't finite don't count."""
    counts = np.unique(np.geomspace(min(16, values.size), values.size, marks).round().astype(int))
    rows = []
    for count in counts.tolist():
        known = values[:count][np.isfinite(values[:count])]
        mean = float(known.mean()) if known.size else np.nan
        rows.append((count, mean, float(known.std(ddof=1)) if known.size > 1 else np.nan))
    return np.array(rows, dtype=float).reshape(-1, 3)
