"""Random deviations that are correlated as stated: a Gaussian copula.

Cario and Nelson, "Modeling and generating random vectors with arbitrary marginal distributions and correlation matrix",
Northwestern University (1997): normal scores z with correlations rho become shares Phi(z) of each distribution; rho is
chosen so that the *deviations* have the stated coefficients (Pearson's). It's what is stated for two normal ones,
2 sin(pi r/6) for two uniform ones, else found on E[F^-1(Phi(z1)) G^-1(Phi(z2))] by Gauss-Hermite quadrature.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import field
from functools import cache
from math import asin, pi, sin, sqrt

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.findings import Finding, Joined
from linkwright.studies.accuracy.contributors import Contributor, Contributors

Array = NDArray[np.float64]

PATH = ("studies", "accuracy", "correlations")
NODES = 100
"""Of the quadrature, along either axis. A coefficient is right to 1e-4 for a quantile with a kink, to 1e-9 else."""
CLOSE = 1e-4
"""A coefficient is taken for the largest that distributions can have where it's no further beyond."""
ZERO = 1e-10
"""What is no more than round-off in a correlation matrix."""
DIGITS = 12
"""To which a correlation of scores is rounded: machines that share a work differ in the last ones."""
TINY, NEARLY = 2.0**-54, 1 - 2.0**-53
"""The ends of shares."""


@dataclass(frozen=True, eq=False)
class Copula:
    """Turns independent shares into correlated ones. ``who`` (n,) are the contributors that are correlated, ``factor``
    (n, rank) makes their scores from independent ones; ``findings`` say what can't be had."""

    who: NDArray[np.intp]
    factor: Array
    findings: list[Finding] = field(default_factory=list)

    def shares(self, u: Array) -> Array:
        """Correlated shares from independent ones in (0, 1), both (contributors, samples)."""
        from scipy.special import ndtr, ndtri

        if not self.who.size:
            return u
        scores = ndtri(u[self.who[: self.factor.shape[1]]])
        correlated = u.copy()
        # Sums without a BLAS, whose order depends on the shapes and the machine.
        correlated[self.who] = np.clip(ndtr(np.einsum("ij,jn->in", self.factor, scores)), TINY, NEARLY)
        return correlated


def copula(contributors: Contributors) -> Copula:
    """The copula of some contributors. What can't be had is replaced by what comes next to it, with a finding."""
    stated, every = contributors.correlation, contributors.every
    off = np.abs(stated - np.diag(np.diag(stated))).max(axis=1, initial=0.0)
    who = np.flatnonzero((off > 0) & (contributors.sigma > 0))
    scores, findings = np.eye(who.size), []
    shapes = {a: _shape(every[a]) for a in who}
    known: dict[tuple[Shape, Shape, float], tuple[float, float]] = {}
    for i, a in enumerate(who):
        for j, b in enumerate(who[:i]):
            if not (r := float(stated[a, b])):
                continue
            key = shapes[a], shapes[b], r
            if key not in known:
                rho = normal(every[a], every[b], r)
                known[key] = rho, pearson(every[a], every[b], rho)
            scores[i, j] = scores[j, i] = known[key][0]
            if abs(known[key][1] - r) > CLOSE:
                names = Joined([every[b].name, every[a].name])
                data = {"names": names, "stated": f"{r:.4g}", "limit": f"{known[key][1]:.4g}"}
                findings.append(Finding("accuracy.correlation-limit", PATH, data))
    mended = definite(scores)
    if (change := float(np.abs(mended - scores).max(initial=0.0))) > CLOSE:
        findings.append(Finding("accuracy.correlation-adjusted", PATH, {"change": f"{change:.2g}"}, severity="warning"))
    return Copula(who, cholesky(mended), findings)


CLOSED: dict[tuple[str, str], tuple[Callable[[float], float], Callable[[float], float]]] = {
    ("normal", "normal"): (lambda r: r, lambda rho: rho),
    ("uniform", "uniform"): (lambda r: 2 * sin(pi * r / 6), lambda rho: 6 / pi * asin(rho / 2)),
}
"""Normal correlations of pairs of distributions in closed form, and the other way about."""


def normal(a: Contributor, b: Contributor, r: float) -> float:
    """The correlation of the normal scores of two contributors whose deviations have the coefficient r; 1 or -1 where
    they can't have so large a one."""
    from scipy.optimize import brentq

    if closed := CLOSED.get((a.distribution, b.distribution)):
        return closed[0](r)
    moment = _moment(a, b)
    end = 1.0 if r > 0 else -1.0
    if abs(r) > abs(moment(end)) - CLOSE / 2:
        return end
    return round(float(brentq(lambda rho: moment(rho) - r, 0.0, end, xtol=1e-13)), DIGITS)


def pearson(a: Contributor, b: Contributor, rho: float) -> float:
    """The coefficient of the deviations of two contributors whose normal scores have the correlation rho."""
    closed = CLOSED.get((a.distribution, b.distribution))
    return closed[1](rho) if closed else _moment(a, b)(rho)


Shape = tuple[float, ...]


def _shape(one: Contributor) -> Shape:
    """What is the same of distributions that differ in mean and width only: some quantiles."""
    places = (one.quantile(np.linspace(0.02, 0.98, 25)) - one.mean) / one.sigma
    return tuple(np.round(places, 9).tolist())


@cache
def _nodes() -> tuple[Array, Array]:
    """Places and weights of the quadrature over the standard normal distribution."""
    x, w = np.polynomial.hermite_e.hermegauss(NODES)
    return x, w / w.sum()


def _moment(a: Contributor, b: Contributor) -> Callable[[float], float]:
    from scipy.special import ndtr

    x, w = _nodes()
    weights = np.outer(w, w)

    def standard(one: Contributor, z: Array) -> Array:
        shares = np.clip(ndtr(z), TINY, NEARLY)
        return (one.quantile(shares) - one.mean) / one.sigma

    first = standard(a, x)

    def moment(rho: float) -> float:
        second = standard(b, rho * x[:, None] + sqrt(max(1 - rho * rho, 0.0)) * x)
        return float((weights * first[:, None] * second).sum())

    return moment


def definite(matrix: Array) -> Array:
    """A correlation matrix without negative eigenvalues near one that has some: these are set to 0, then the diagonal
    to 1 (Rebonato and Jaeckel, J. Risk 2 (1999) 17-27, sec. 3)."""
    values, vectors = np.linalg.eigh(matrix)
    if values.min(initial=0.0) >= -ZERO * len(matrix):
        return matrix
    made = (vectors * np.maximum(values, 0.0)) @ vectors.T
    size = np.sqrt(np.diag(made))
    return np.asarray(np.round(made / np.outer(size, size), DIGITS))


def cholesky(matrix: Array) -> Array:
    """A factor (n, rank) of a matrix without negative eigenvalues, whose product with its transpose it is: Cholesky's
    with diagonal pivots (Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed. 2002, sec. 10.3)."""
    rest, columns = matrix.astype(float), []
    for _ in range(len(matrix)):
        k = int(np.diag(rest).argmax())
        if rest[k, k] <= ZERO * len(matrix):
            break
        columns.append(rest[:, k] / sqrt(rest[k, k]))
        rest = rest - np.outer(columns[-1], columns[-1])
        rest[k, :] = rest[:, k] = 0.0
    return np.stack(columns, axis=1) if columns else np.empty((len(matrix), 0))
