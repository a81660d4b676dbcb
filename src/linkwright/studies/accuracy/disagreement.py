"""Where the linear statistics (RSS) and the random samples (Monte Carlo) part ways, and by how much."""

from __future__ import annotations

from dataclasses import asdict
from statistics import NormalDist
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.findings import Said, Term, Text
from linkwright.presentation.json_numbers import known
from linkwright.results.run import ROUND_OFF
from linkwright.studies.accuracy.outcome import AccuracyOutcome, OutputDeviations, SignalDeviations

Array = NDArray[np.float64]

ERRORS = 5.0
"""So many standard errors are no accident."""


@dataclass(frozen=True)
class Disagreement:
    """``sigma_ratio`` is the samples' standard deviation over that of RSS, ``mean_shift`` how far their mean lies above
    that of RSS, in its standard deviations; ``..._errors`` are these differences in standard errors of the samples;
    ``None`` where one divides by zero. ``parted`` where one of them is more than the allowed share, and no accident."""

    sigma_ratio: float | None
    sigma_errors: float | None
    mean_shift: float | None
    mean_errors: float | None
    parted: bool

    def as_dict(self) -> dict[str, Any]:
        """The same as plain data."""
        return asdict(self)

    def sentence(self, name: Text) -> Said | None:
        """What to say of it; ``None`` where the two agree."""
        if not self.parted:
            return None
        if self.sigma_ratio is None or self.mean_shift is None:
            return Said("accuracy.parted.still", name=name)
        data = {"ratio": f"{self.sigma_ratio:.4g}", "shift": f"{self.mean_shift:+.3g}".replace("-", "−")}
        errors = {"ratio_errors": _rounded(self.sigma_errors), "shift_errors": _rounded(self.mean_errors)}
        significance = {"ratio_told": _significance(self.sigma_errors), "shift_told": _significance(self.mean_errors)}
        return Said("accuracy.parted", name=name, **data, **errors, **significance)


def disagreement(figure: OutputDeviations, outcome: AccuracyOutcome) -> Disagreement | None:
    """That of one figure; ``None`` without samples."""
    found = figure.monte_carlo
    if found is None:
        return None
    errors = _errors(found.sigma, found.samples - found.failed)
    if found.mean_interval is not None and found.sigma_interval is not None:
        wide = 2 * NormalDist().inv_cdf((1 + found.confidence) / 2)
        errors = np.array([np.ptp(found.mean_interval), np.ptp(found.sigma_interval)]) / wide
    mean = found.mean - figure.nominal - figure.mean
    rows = (np.array([value]) for value in (mean, found.sigma, figure.sigma, *errors))
    compared = _compared(*rows, least=max(ROUND_OFF * abs(figure.nominal), figure.round_off))
    ratio, shift, sigma_errors, mean_errors = (known(float(row[0])) for row in compared)
    return Disagreement(ratio, sigma_errors, shift, mean_errors, bool(_parted(compared, outcome)[0]))


def along(curve: SignalDeviations, outcome: AccuracyOutcome) -> NDArray[np.bool_]:
    """The poses (poses,) at which RSS and samples of a signal part ways."""
    if curve.sampled is None:
        return np.zeros(curve.t.size, dtype=bool)
    mean, sigma, _, _, count = curve.sampled
    errors = _errors(sigma, count)
    nominal = ROUND_OFF * float(np.nanmax(np.abs(curve.nominal), initial=0.0))
    least = max(nominal, outcome.run.round_off(curve.dimension))
    return _parted(_compared(mean - curve.mean, sigma, curve.sigma, *errors, least=least), outcome)


def _errors(sigma: Any, count: Any) -> Array:
    """Standard errors of the mean and the standard deviation of so many random samples, normally distributed."""
    with np.errstate(all="ignore"):
        return np.asarray(sigma) / np.sqrt([np.asarray(count, dtype=float), 2.0 * (np.asarray(count) - 1.0)])


def _compared(
    shift: Array, sampled: Array, sigma: Array, mean_error: Array, sigma_error: Array, *, least: float
) -> Array:
    """Ratio of the standard deviations and shift of the mean in one of them; both differences in standard errors. What
    is less than ``least`` is round-off, and no difference."""
    still = np.fmax(np.fmax(sampled, sigma), np.abs(shift)) < least
    with np.errstate(all="ignore"):
        rows = np.stack([sampled / sigma, shift / sigma, (sampled - sigma) / sigma_error, shift / mean_error])
    return np.where(still, [[1.0], [0.0], [0.0], [0.0]], rows)


def _parted(compared: Array, outcome: AccuracyOutcome) -> NDArray[np.bool_]:
    share = outcome.options.nonlinear
    ratio, shift, sigma_errors, mean_errors = compared
    with np.errstate(invalid="ignore"):
        wide = (np.abs(ratio - 1) > share) & (np.abs(sigma_errors) > ERRORS)
        return np.asarray(wide | (np.abs(shift) > share) & (np.abs(mean_errors) > ERRORS))


def _significance(errors: float | None) -> Term:
    """Whether a difference is more than random samples give, by its size in standard errors."""
    return Term("deviation-small" if errors is None or abs(errors) <= ERRORS else "deviation-significant")


def _rounded(errors: float | None) -> str:
    return "–" if errors is None else f"{abs(errors):.3g}"
