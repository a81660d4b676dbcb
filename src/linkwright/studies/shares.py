"""The share of samples that meet a requirement, with its confidence interval.

Wilson's score interval (Wilson, J. Am. Stat. Assoc. 22 (1927) 209-212), which keeps its promise for shares near 0 and
1 too (Brown, Cai and DasGupta, Statistical Science 16 (2001) 101-133, sec. 3.1.1). It is that of independent samples;
those of a Latin hypercube have at most n/(n - 1) times their variance (Owen, SIAM J. Numer. Anal. 34 (1997) 1884-1910).
"""

from __future__ import annotations

from math import sqrt

from linkwright.data_classes import dataclass

CONFIDENCE = 0.95


@dataclass(frozen=True)
class Share:
    """``met`` of ``samples``; ``low`` and ``high`` bound the share of all that might be made, ``None`` where the plan
    allows no such statement."""

    met: int
    samples: int
    low: float | None = None
    high: float | None = None

    @property
    def value(self) -> float:
        """The share of the samples."""
        return self.met / self.samples


def wilson(met: int, samples: int, confidence: float = CONFIDENCE) -> Share:
    """The share with its score interval."""
    from scipy.special import ndtri

    z, p, n = float(ndtri(0.5 + confidence / 2)), met / samples, samples
    middle = (p + z * z / (2 * n)) / (1 + z * z / n)
    half = z * sqrt(p * (1 - p) / n + z * z / (4 * n * n)) / (1 + z * z / n)
    low = 0.0 if met == 0 else middle - half
    high = 1.0 if met == n else middle + half
    return Share(met, samples, low, high)
