"""What all that states deviations is read with: numbers of a file, distributions, and the findings on them."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression
from linkwright.expressions.units import Dimension
from linkwright.findings import Finding
from linkwright.kernels import Compiled
from linkwright.model.tolerances import Spread, full_tolerance
from linkwright.studies.accuracy.parameter_chain import derived
from linkwright.studies.accuracy.stated_options import DeviationOptions
from linkwright.studies.numbers import constant
from linkwright.tolerances import DISTRIBUTIONS, Deviation, Limits

Array = NDArray[np.float64]
Path = tuple[str | int, ...]
PATH: Path = ("studies", "accuracy")


@dataclass(frozen=True)
class Moving:
    """A deviation in SI: the parameters ``moved`` follow it by ``weights``. Without a ``unit`` it is that of the
    dimension."""

    name: str
    nominal: float
    limits: Limits
    spread: Deviation
    distribution: str
    dimension: Dimension
    stated: str
    moved: tuple[str, ...]
    weights: Array
    unit: str = ""


class ToleranceReader:
    """Reads the deviations of a study, and collects what is wrong with them."""

    def __init__(self, compiled: Compiled, options: DeviationOptions) -> None:
        self.quantities, self.options = compiled.quantities, options
        self.findings: list[Finding] = []
        self.tolerances = {name: full_tolerance(p.tolerance) for name, p in compiled.mechanism.parameters.items()}
        self.independent = [name for name in self.tolerances if not derived(self.quantities, name)]

    def note_fault(self, code: str, path: Path, **data: Any) -> None:
        """Note a finding."""
        self.findings.append(Finding(code, path, data))

    def of_derived(self, name: str, path: Path) -> None:
        """Note that a parameter follows from others."""
        text = self.quantities.mechanism.parameters[name].value.text[:60]
        self.note_fault("tolerance.derived", path, name=name, text=text)

    def value(self, expression: Expression, dimension: Dimension, path: Path) -> float | None:
        """The value of an expression of the study, ``None`` with a finding where it has none."""
        value, faults = constant(self.quantities, expression, dimension, path)
        self.findings += faults
        return value

    def spread(
        self, path: Path, entry: Spread, default: str, limits: Limits, dimension: Dimension
    ) -> tuple[Deviation, str] | None:
        """How a deviation is distributed, and the name of that; one that states its width is normal by default."""
        name = entry.distribution or default
        if (entry.cp or entry.sigma) is not None and not DISTRIBUTIONS[name].free:
            name = "normal"
        if entry.sigma is not None:
            sigma = self.value(entry.sigma, dimension, (*path, "sigma"))
            if sigma is not None and sigma <= 0:
                self.note_fault("study.sigma", (*path, "sigma"), sigma=entry.sigma.text[:40])
                sigma = None
        else:
            cp = self.options.cp if entry.cp is None else self.value(entry.cp, u.PURE, (*path, "cp"))
            if entry.cp is not None and cp is not None and cp <= 0:
                self.note_fault("tolerance.cp", (*path, "cp"), cp=entry.cp.text[:40])
            sigma = (limits[1] - limits[0]) / (6 * cp) if cp is not None and cp > 0 else None
        return None if sigma is None else (DISTRIBUTIONS[name].make(*limits, sigma), name)
