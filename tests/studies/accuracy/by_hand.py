"""Contributors made by hand, without a file's tolerances."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy import stats

import linkwright as lw
from linkwright.expressions import units as u
from linkwright.kernels import Compiled
from linkwright.studies.accuracy import study as module
from linkwright.studies.accuracy.contributors import Contributor, Contributors
from linkwright.studies.accuracy.options import AccuracyOptions

Array = NDArray[np.float64]
LAWS = {
    "normal": lambda half: stats.norm(0, half / 3),
    "uniform": lambda half: stats.uniform(-half, 2 * half),
    "triangular": lambda half: stats.triang(0.5, -half, 2 * half),
    "skew": lambda half: stats.triang(0.0, -half / 2, 1.5 * half),
}
"""Distributions by the half width of their limits, from SciPy."""


def contributor(compiled: Compiled, name: str, half: float, law: str = "normal") -> Contributor:
    """One parameter that deviates by ``half`` (SI), about its nominal value but for the skew law."""
    frozen, nominal = LAWS[law](half), compiled.quantities.parameters[name]
    direction = np.array([float(name == other) for other in compiled.graph.parameters])
    low, high = frozen.support() if law == "skew" else (-half, half)
    return Contributor(
        name, direction, nominal, low, high, frozen.mean(), frozen.std(), frozen.ppf, u.LENGTH, "mm", 1e-3, "-", law
    )


def contributors(compiled: Compiled, halves: Mapping[str, tuple[float, str]], correlation: Any = None) -> Contributors:
    every = tuple(contributor(compiled, name, *given) for name, given in halves.items())
    return Contributors(every, np.eye(len(every)) if correlation is None else np.array(correlation))


def stated(monkeypatch: pytest.MonkeyPatch, make: Callable[[Compiled], Contributors]) -> None:
    """Let every file state these contributors."""
    monkeypatch.setattr(module, "contributors", lambda compiled, options: make(compiled))


def options(document: lw.Document) -> AccuracyOptions:
    """A document's."""
    return AccuracyOptions.model_validate(document.studies["accuracy"], context=document.studies)
