r"""Estimating deviations from measured outputs: least squares with the exact Jacobian.

With outputs :math:`y(d)` measured with standard deviations :math:`\sigma`, and :math:`d = d_0 + A z`, the estimate
minimises :math:`|(y(d_0 + A z) - y_m)/\sigma|^2`, plus :math:`|z|^2` where the tolerances count as prior knowledge:
:math:`d_0` and :math:`A A^T` are then their mean and covariance. Else A is diagonal and only scales. The Jacobian by z
is cut off where its singular values are below a threshold times the largest: what lies in its null space can't be
told, and the estimate is the one of least norm (Golub and Van Loan, Matrix Computations, 4th ed., 5.5). Covariance,
leverages and studentised residuals are those of the linear model at the estimate (Seber and Wild, Nonlinear Regression,
1989, 2.1 and 5.8; Cook and Weisberg, Residuals and Influence in Regression, 1982, 2.2).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass

Array = NDArray[np.float64]
Model = Callable[[Array], tuple[Array, Array]]
"""From deviations (n,) to outputs (outputs, positions) and their derivatives (outputs, n, positions); NaN where the
mechanism can't be put together."""

FLOOR = 1e-13
"""A standard deviation that is estimated isn't taken below this share of the output's size: round-off."""
EXACT = 1e-10
"""Residuals below this share of the output's size are round-off, among which none is an outlier."""
SETTLED = 1e-4
"""Relative change at which estimated standard deviations stand still."""
MOST_ROUNDS, MOST_STEPS = 40, 20
LEVERAGE = 1e-8
"""A residual whose own measurement decides all but this of it tells nothing."""
INVOLVED = 1e-6
"""A direction of unit length doesn't involve those whose part is below this."""
CHANCE = 0.05
"""Of no outlier being found though there are none (Bonferroni's bound over all measurements)."""


class TooFew(ValueError):
    """The measurements of an output (by index) don't suffice to estimate their standard deviation."""


class Unusable(ValueError):
    """The outputs can't be computed at the deviations to begin with."""


@dataclass(frozen=True, eq=False)
class Measurements:
    """``values`` (outputs, positions) in SI, NaN where nothing was measured; ``sigma`` (outputs,), NaN where it isn't
    known; ``turns`` (outputs,) which are angles, known but for whole turns."""

    values: Array
    sigma: Array
    turns: NDArray[np.bool_]


class CalibrationFit(NamedTuple):
    """Deviations, covariance (n, n) of what is identified, fitted outputs (outputs, positions), studentised residuals
    (measured less fitted) and which are outliers, standard deviations of the outputs, chi square, degrees of freedom
    and probability, singular values, directions (n, null) in deviations that can't be told, and which deviations aren't
    involved in them; the factor of the confidence interval; the step left."""

    deviations: Array
    covariance: Array
    fitted: Array
    studentised: Array
    outliers: NDArray[np.bool_]
    sigma: Array
    chi_square: float
    freedom: int
    probability: float | None
    singular: Array
    null: Array
    identified: NDArray[np.bool_]
    factor: float
    step: float


class _Weighted:
    """Residuals over sigma and their Jacobian by z, each evaluated once at a place."""

    def __init__(self, model: Model, data: Measurements, start: Array, basis: Array, prior: bool) -> None:
        self.model, self.data, self.start, self.basis, self.prior = model, data, start, basis, prior
        self.known = np.isfinite(data.values)
        self.owner = np.nonzero(self.known)[0]
        self.sigma = np.where(np.isfinite(data.sigma), data.sigma, 1.0)
        self._last: tuple[Array, Array, Array] | None = None

    def raw(self, z: Array) -> tuple[Array, Array]:
        """Fitted less measured values (m,) and their Jacobian by z (m, n)."""
        if self._last is None or not np.array_equal(self._last[0], z):
            # Evaluate the model only once per place; residuals and Jacobian are asked for separately.
            values, slopes = self.model(self.start + self.basis @ z)
            off = (values - self.data.values)[self.known]
            # Angles differ by less than half a turn.
            turns = self.data.turns[self.owner]
            off[turns] = (off[turns] + np.pi) % (2 * np.pi) - np.pi
            self._last = z.copy(), off, np.moveaxis(slopes, 1, 2)[self.known] @ self.basis
        return self._last[1], self._last[2]

    def residuals(self, z: Array) -> Array:
        """Over sigma; those of the prior behind."""
        off = self.raw(z)[0] / self.sigma[self.owner]
        return np.concatenate([off, z]) if self.prior else off

    def jacobian(self, z: Array) -> Array:
        """Of the residuals."""
        j = self.raw(z)[1] / self.sigma[self.owner, None]
        return np.concatenate([j, np.eye(z.size)]) if self.prior else j


@np.errstate(over="ignore", invalid="ignore")  # of measured values as large as numbers get
def fit(
    model: Model,
    data: Measurements,
    start: Array,
    basis: Array,
    prior: bool = False,
    confidence: float = 0.95,
    threshold: float = 1e-6,
) -> CalibrationFit:
    """Estimate the deviations d = start + basis z. Raises :class:`TooFew`, :class:`Unusable`."""
    # The nominal mechanism has to work, or there is nothing to start from.
    work = _Weighted(model, data, start, basis, prior)
    if not all(np.isfinite(part).all() for part in work.raw(np.zeros(start.size))):
        raise Unusable
    open_ = ~np.isfinite(data.sigma)
    if open_.any():  # to begin with, as far as a deviation of its tolerance's sigma moves the output
        j = work.raw(np.zeros(start.size))[1]
        size = np.array(
            [float(np.sqrt((j[work.owner == o] ** 2).sum(axis=1).mean() or 1.0)) for o in range(open_.size)]
        )
        work.sigma = np.where(open_, size, work.sigma)
    # Alternate: estimate the deviations with fixed weights, then the unknown standard deviations from the residuals,
    # until these settle.
    z = np.zeros(start.size)
    for turn in range(MOST_ROUNDS):
        z, step = _estimate(work, _near(work, z) if turn == 0 else z, threshold)
        if not open_.any():
            break
        last = work.sigma
        work.sigma = _sigmas(work, z, open_, threshold)
        if (np.abs(work.sigma / last - 1) < SETTLED).all() or open_.size == 1:
            break
    return _figures(work, z, step, bool(open_.any()), confidence, threshold)


def _near(work: _Weighted, z: Array) -> Array:
    """A minimum by a trust region: it takes shorter steps where the mechanism can't be put together."""
    from scipy.optimize import least_squares

    return np.asarray(least_squares(work.residuals, z, work.jacobian, ftol=1e-6, xtol=1e-6, max_nfev=200).x)


def _estimate(work: _Weighted, z: Array, threshold: float) -> tuple[Array, float]:
    """The estimate of least norm near a minimum, and the step that is left: steps of Gauss and Newton without what is
    in the null space."""
    left = np.inf
    for _ in range(MOST_STEPS):
        # Gauss-Newton step in the space of identifiable directions only (truncated SVD): the estimate of least norm.
        u, s, v, rank = _parts(work.jacobian(z), threshold)
        told = v[:, :rank]
        new = told @ (told.T @ z - (u[:, :rank].T @ work.residuals(z)) / s[:rank])
        step = float(np.abs(new - z).max())
        # Stop when steps no longer shrink: round-off is reached.
        if step >= left or not np.isfinite(work.residuals(new)).all():
            break
        z, left = new, step
        if step <= 1e-14 * max(1.0, float(np.abs(z).max())):
            break
    return z, min(left, step)


def _parts(j: Array, threshold: float) -> tuple[Array, Array, Array, int]:
    """Singular value decomposition and numerical rank."""
    u, s, vt = np.linalg.svd(j, full_matrices=False)
    if vt.shape[0] < vt.shape[1]:
        vt = np.linalg.svd(j, full_matrices=True)[2]
    return u, s, vt.T, int(np.sum(s > threshold * s[0])) if s.size and s[0] > 0 else 0


def _leverages(j: Array, threshold: float) -> Array:
    u, _, _, rank = _parts(j, threshold)
    return np.asarray((u[:, :rank] ** 2).sum(axis=1))


def _sigmas(work: _Weighted, z: Array, open_: NDArray[np.bool_], threshold: float) -> Array:
    """Standard deviations of the outputs whose own aren't known: residuals over the freedom that is left to each."""
    # Each output's share of the degrees of freedom follows from the leverages of its own residuals.
    off, sigma = work.raw(z)[0], work.sigma.copy()
    share = _leverages(work.jacobian(z), threshold)[: off.size]
    for o in np.flatnonzero(open_):
        mine = work.owner == o
        freedom = float((1 - share[mine]).sum())
        if freedom < 0.5:
            raise TooFew(int(o))
        size = float(np.abs(work.data.values[o][work.known[o]]).max())
        sigma[o] = max(np.sqrt((off[mine] ** 2).sum() / freedom), FLOOR * (size or 1.0))
    return sigma


def _figures(
    work: _Weighted, z: Array, step: float, estimated: bool, confidence: float, threshold: float
) -> CalibrationFit:
    from scipy.special import chdtrc, stdtrit

    j, r, basis, count = work.jacobian(z), work.residuals(z), work.basis, work.owner.size
    # Rank of the measurements alone: its null space holds the directions that cannot be identified.
    _, s, v, rank = _parts(j[:count], threshold)
    null = basis @ v[:, rank:]
    size = np.linalg.norm(basis, axis=1)
    part = np.linalg.norm(null, axis=1) / np.where(size > 0, size, 1.0)
    unclear = part > INVOLVED
    _, whole, w, full = _parts(j, threshold)  # with the prior, everything is told
    # Covariance from the pseudoinverse, with the prior where there is one.
    root = basis @ (w[:, :full] / whole[:full])
    # Chi square test where standard deviations are known; Student's t for the intervals where they are estimated.
    freedom = r.size - full
    chi_square = float(r @ r)
    tail = (1 + confidence) / 2
    factor = float(stdtrit(freedom if estimated else np.inf, tail))
    probability = float(chdtrc(freedom, chi_square)) if not estimated and freedom > 0 else None
    studentised, outliers = _studentised(r[:count], _leverages(j, threshold)[:count], freedom, chi_square, estimated)

    # Residuals at round-off are no outliers, however large relative to a tiny sigma.
    size_of = np.abs(np.where(work.known, work.data.values, 0.0)).max(axis=1, initial=0.0)
    outliers &= (work.sigma > EXACT * size_of)[work.owner]

    def spread(flat: NDArray[Any]) -> NDArray[Any]:
        made = np.zeros(work.known.shape, dtype=flat.dtype)
        made[work.known] = flat
        return made

    return CalibrationFit(
        work.start + basis @ z,
        root @ root.T,
        work.data.values + np.where(work.known, spread(work.raw(z)[0]), np.nan),
        spread(studentised),
        spread(outliers),
        work.sigma,
        chi_square,
        freedom,
        probability,
        s,
        _plain(null, size),
        np.full(size.shape, True) if work.prior else ~unclear,
        factor,
        step,
    )


def _studentised(
    r: Array, share: Array, freedom: int, chi_square: float, estimated: bool
) -> tuple[Array, NDArray[np.bool_]]:
    """Residuals over their own standard deviation; where that is estimated, from all the others."""
    from scipy.special import ndtri, stdtrit

    # A residual with leverage 1 is zero whatever is measured and tells nothing.
    left = np.maximum(1 - share, LEVERAGE)
    plain = np.where(1 - share > LEVERAGE, r / np.sqrt(left), 0.0)
    tail = 1 - CHANCE / (2 * max(r.size, 1))
    if not estimated:
        return -plain, np.abs(plain) > ndtri(tail)
    if freedom < 2:
        return np.zeros_like(r), np.zeros(r.shape, dtype=bool)
    # Externally studentised: the variance is estimated without the residual itself.
    others = np.maximum(chi_square - plain**2, 1e-12 * chi_square) / (freedom - 1)
    outer = plain / np.sqrt(np.where(others > 0, others, 1.0))
    return -outer, np.abs(outer) > stdtrit(freedom - 1, tail)


def _plain(null: Array, size: Array) -> Array:
    """A basis of the same directions in which each has one deviation, of unit size, that no other one has."""
    from scipy.linalg import qr

    if not null.shape[1]:
        return null
    scaled = null / np.where(size > 0, size, 1.0)[:, None]
    # Pivoted QR picks as many independent deviations as there are directions; solving for them gives each direction
    # one of its own.
    _, _, order = qr(scaled.T, pivoting=True)
    made = scaled @ np.linalg.inv(scaled[order[: null.shape[1]]])
    made = np.where(np.abs(made) > INVOLVED * np.abs(made).max(axis=0), made, 0.0)
    return np.asarray(made * size[:, None])


def scaling(direction: Array, nominal: Sequence[float]) -> bool:
    """Whether the deviations of a direction are all in proportion to nominal values."""
    values = np.asarray(nominal)
    on = direction != 0
    if on.sum() < 2 or (values[on] == 0).any():
        return False
    ratio = direction[on] / values[on]
    return bool(np.ptp(ratio) <= 1e-4 * np.abs(ratio).max())
