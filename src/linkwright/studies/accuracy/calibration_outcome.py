"""What a calibration gives: the estimated deviations, how sure they are, and which can't be told apart."""

from __future__ import annotations

from dataclasses import field

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Estimate:
    """A contributor's estimated ``deviation`` from ``nominal``, with its standard ``error`` and ``interval``, all in
    SI; these are None where the measurements don't tell it from others: ``identified`` is then False, and the deviation
    is part of the smallest ones that fit."""

    name: str
    unit: str
    size: float
    nominal: float
    deviation: float
    error: float | None
    interval: tuple[float, float] | None
    identified: bool

    @property
    def value(self) -> float:
        """The estimated value."""
        return self.nominal + self.deviation


@dataclass(frozen=True)
class Confounded:
    """Deviations (SI, by contributor) that change no measured output when they come together; ``scaling`` where they
    are all in proportion to the nominal values. Where there are prior tolerances, these alone decide here."""

    deviations: dict[str, float]
    scaling: bool

    @property
    def names(self) -> list[str]:
        """The contributors involved."""
        return [*self.deviations]


@dataclass(frozen=True)
class Observed:
    """A measurement at time ``t`` (s) in SI: measured and fitted value of an output, and the studentised residual, 0
    where nothing else tells of it. ``outlier`` where it is too large to be one of as many random errors."""

    output: int
    row: int
    t: float
    measured: float
    fitted: float
    studentised: float
    outlier: bool

    @property
    def residual(self) -> float:
        """Measured less fitted value."""
        return self.measured - self.fitted


@dataclass(frozen=True)
class Calibration:
    """The calibration.

    ``correlation`` (parameters, parameters) is that of the estimates; rows of those that aren't identified are NaN.
    ``sigmas`` are those of the outputs, ``stated`` which of them the file gives. ``chi_square`` over
    ``freedom`` tells whether the residuals agree with them: ``probability`` is that of a larger one by chance, None
    where a sigma is estimated from the residuals themselves. ``singular`` are the singular values of the Jacobian,
    outputs over sigma by contributors over their tolerance's sigma; what is below ``threshold`` of the largest makes
    the ``confounded``. ``step`` is how far one more step of Gauss and Newton would go, in the same scale.
    """

    estimates: tuple[Estimate, ...]
    correlation: Array
    outputs: tuple[str, ...]
    units: tuple[tuple[str, float], ...]
    observed: tuple[Observed, ...]
    sigmas: tuple[float, ...]
    stated: tuple[bool, ...]
    chi_square: float
    freedom: int
    probability: float | None
    singular: Array
    threshold: float
    confounded: tuple[Confounded, ...]
    prior: bool
    confidence: float
    step: float
    at: str = "t"
    before: tuple[float, ...] = field(default=())
    """Root mean square of each output's residuals with the nominal parameters (SI); ``after`` with the estimates."""
    after: tuple[float, ...] = field(default=())

    @property
    def converged(self) -> bool:
        """Whether another step changes nothing of importance."""
        return self.step <= 1e-6
