"""The contributors that a file states: tolerances of its parameters, the general one, changes of temperature."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.kernels import Compiled
from linkwright.model import units as u
from linkwright.model.dimensions import DimensionError
from linkwright.model.fields import Expression
from linkwright.model.findings import Finding, Term, raise_errors
from linkwright.model.quantities import LARGEST
from linkwright.model.tolerances import ClassName, Spread, Stated, stated
from linkwright.model.units import Dimension
from linkwright.model.unknown import near
from linkwright.studies.accuracy.chained import derivatives, derived
from linkwright.studies.accuracy.contributors import Contributor, Contributors
from linkwright.studies.accuracy.correlated import check as check_correlations
from linkwright.studies.accuracy.correlated import matrix
from linkwright.studies.accuracy.options import AccuracyOptions
from linkwright.studies.accuracy.stated_options import Thermal
from linkwright.tolerances import DISTRIBUTIONS, EXPANSION, Deviation, NoTolerance

Array = NDArray[np.float64]
Limits = tuple[float, float]
AnyLimits = tuple[Expression, Expression] | ClassName | Expression
Path = tuple[str | int, ...]
PATH: Path = ("studies", "accuracy")


def contributors(compiled: Compiled, options: AccuracyOptions) -> Contributors:
    """All contributors and their correlations. Raises ModelError where :func:`check_contributors` finds something."""
    reader = _Reader(compiled, options)
    raise_errors(reader.findings)
    every = tuple(reader.made())
    return Contributors(every, matrix([one.name for one in every], options.correlations))


def check_contributors(compiled: Compiled, options: AccuracyOptions) -> Iterator[Finding]:
    """What is wrong with the tolerances and all else that makes contributors."""
    yield from _Reader(compiled, options).findings


def skipped(compiled: Compiled, options: AccuracyOptions) -> list[Finding]:
    """A warning on the lengths that the general tolerance has nothing for."""
    names = _Reader(compiled, options).skipped
    data = {"names": ", ".join(names), "general": options.general.found.text if options.general else ""}
    return [Finding("tolerance.skipped", (*PATH, "general"), data, severity="warning")] if names else []


@dataclass(frozen=True)
class _Deviation:
    """A deviation in SI: by how much all parameters follow those that ``moved`` names by ``weights``."""

    name: str
    nominal: float
    low: float
    high: float
    spread: Deviation
    distribution: str
    dimension: Dimension
    unit: str
    stated: str
    moved: tuple[str, ...]
    weights: Array


class _Reader:
    """Reads a study's deviations, and collects what is wrong with them."""

    def __init__(self, compiled: Compiled, options: AccuracyOptions) -> None:
        self.quantities, self.options = compiled.quantities, options
        self.findings: list[Finding] = []
        self.skipped: list[str] = []
        self.tolerances = {name: stated(p.tolerance) for name, p in compiled.mechanism.parameters.items()}
        self.independent = [name for name in self.tolerances if not derived(self.quantities, name)]
        if options.cp <= 0:
            self._wrong("tolerance.cp", (*PATH, "cp"), cp=f"{options.cp:g}")
        names = self._named() if options.parameters is not None else self._all()
        every = [self._parameter(name) for name in names]
        every += [self._thermal(name, entry, (*PATH, "thermal", name)) for name, entry in options.thermal.items()]
        self.every = [one for one in every if one is not None]
        self.moved = [name for name in self.independent if any(name in one.moved for one in self.every)]
        self.derivatives = derivatives(self.quantities, self.moved)
        for name, row in zip(self.quantities.parameters, self.derivatives, strict=True):
            if not np.isfinite(row).all():
                text = compiled.mechanism.parameters[name].value.text[:60]
                self._wrong("tolerance.no-derivative", ("parameters", name), text=text)
        if not every and not self.findings:
            self._wrong("tolerance.none", PATH)
        self.findings += check_correlations([*names, *options.thermal], options.correlations)

    def made(self) -> Iterator[Contributor]:
        """The contributors; there are no findings."""
        size = {name: i for i, name in enumerate(self.moved)}
        for one in self.every:
            direction = self.derivatives[:, [size[name] for name in one.moved]] @ one.weights
            spread, unit = one.spread, self.quantities.unit_of(one.dimension)
            yield Contributor(
                name=one.name,
                direction=direction,
                nominal=one.nominal,
                low=one.low,
                high=one.high,
                mean=spread.mean,
                sigma=spread.sigma,
                quantile=spread.quantile,
                dimension=one.dimension,
                unit=one.unit or unit[0],
                size=1.0 if one.unit else unit[1],
                stated=one.stated,
                distribution=one.distribution,
            )

    def _wrong(self, code: str, path: Path, **data: Any) -> None:
        self.findings.append(Finding(code, path, data))

    # Which parameters deviate.

    def _all(self) -> list[str]:
        return [name for name, entry in self.tolerances.items() if entry.limits is not None or self._general(name)]

    def _named(self) -> list[str]:
        kept = []
        for i, name in enumerate(self.options.parameters or ()):
            path = (*PATH, "parameters", i)
            if name not in self.tolerances:
                self._wrong("name.unknown-parameter", path, name=name, near=near(name, [*self.tolerances]))
            elif name in kept:
                self._wrong("tolerance.named-twice", path, name=name)
            elif name not in self.independent:
                self._derived(name, path)
            elif self.tolerances[name].limits is None and not self._of_general(name):
                self._wrong("tolerance.missing", path, name=name)
            else:
                kept.append(name)
        return kept

    def _derived(self, name: str, path: Path) -> None:
        text = self.quantities.mechanism.parameters[name].value.text[:60]
        self._wrong("tolerance.derived", path, name=name, text=text)

    def _of_general(self, name: str) -> bool:
        """Whether the general tolerance is meant for a parameter."""
        dimension = self.quantities.dimensions.of(name)
        angle = dimension == u.ANGLE and self.tolerances[name].side is not None
        return self.options.general is not None and name in self.independent and (dimension == u.LENGTH or angle)

    def _general(self, name: str) -> bool:
        """Whether it has limits for it; lengths that it has none for are noted."""
        if not self._of_general(name):
            return False
        assert self.options.general is not None
        if self.quantities.dimensions.of(name) == u.LENGTH:
            try:
                self.options.general.found.limits(abs(self.quantities.parameters[name]))
            except NoTolerance:
                self.skipped.append(name)
                return False
        return True

    # A parameter's deviation.

    def _parameter(self, name: str) -> _Deviation | None:
        path: Path = ("parameters", name, "tolerance")
        if name not in self.independent:
            self._derived(name, path)
            return None
        entry, dimension = self.tolerances[name], self.quantities.dimensions.of(name)
        limits = entry.limits if entry.limits is not None else self.options.general
        assert limits is not None
        nominal = self.quantities.parameters[name]
        found = self._class(name, limits, entry) if isinstance(limits, ClassName) else self._limits(name, limits)
        spread = self._spread(path, entry, found or (-1.0, 1.0), dimension)
        if found is None:
            return None
        if dimension in (u.LENGTH, u.MASS) and nominal and max(map(abs, found)) >= abs(nominal):
            unit, size = self.quantities.unit_of(dimension)
            data = {"limit": f"{max(found, key=abs) / size:.6g}", "nominal": f"{nominal / size:.6g}", "unit": unit}
            self._wrong("tolerance.too-large", path, **data)
        if spread is None:
            return None
        return _Deviation(name, nominal, *found, *spread, dimension, "", _text(limits), (name,), np.ones(1))

    def _limits(self, name: str, limits: Expression | tuple[Expression, Expression]) -> Limits | None:
        dimension = self.quantities.dimensions.of(name)
        if isinstance(limits, tuple):
            low, high = (self.quantities.value(part, dimension) for part in limits)
        else:
            high = self.quantities.value(limits, dimension)
            low = -high
        if not low < high:
            self._wrong("tolerance.limits", ("parameters", name, "tolerance"), given=_text(limits)[:60])
            return None
        return low, high

    def _class(self, name: str, limits: ClassName, entry: Stated) -> Limits | None:
        path: Path = ("parameters", name, "tolerance")
        q, found = self.quantities, limits.found
        dimension, (unit, size) = q.dimensions.of(name), q.unit_of(u.LENGTH)
        asked = abs(q.parameters[name])
        try:
            if dimension == u.LENGTH:
                return found.limits(asked)
            if dimension != u.ANGLE:
                raise NoTolerance("angle")
            if entry.side is None:
                self._wrong("tolerance.side", path, given=found.text)
                return None
            if (side := q.value(entry.side, u.LENGTH)) <= 0:
                data = {"what": Term("side"), "value": f"{side / size:.6g}", "unit": unit}
                self._wrong("value.too-small", (*path, "side"), **data)
                return None
            return found.angular(side)
        except NoTolerance as error:
            if error.reason == "size":
                ends = {end: f"{error.data[end] / size:g}" for end in ("low", "high")}
                self._wrong("tolerance.size", path, given=found.text, asked=f"{asked / size:.6g}", unit=unit, **ends)
            else:
                self._wrong("tolerance.class-dimension", path, given=found.text, name=name)
            return None

    def _spread(self, path: Path, entry: Spread, limits: Limits, dimension: Dimension) -> tuple[Deviation, str] | None:
        """How a deviation is distributed, and the name of that."""
        own = entry.cp or entry.sigma
        name = entry.distribution or self.options.distribution
        if own is not None and not DISTRIBUTIONS[name].free:
            name = "normal"
        general = self.options.cp if self.options.cp > 0 else 1.0
        cp = general if entry.cp is None else self._value(entry.cp, u.PURE, (*path, "cp"))
        sigma = None if entry.sigma is None else self._value(entry.sigma, dimension, (*path, "sigma"))
        if entry.cp is not None and cp is not None and cp <= 0:
            self._wrong("tolerance.cp", (*path, "cp"), cp=entry.cp.text[:40])
        elif entry.sigma is not None and sigma is not None and sigma <= 0:
            self._wrong("study.sigma", (*path, "sigma"), sigma=entry.sigma.text[:40])
        elif cp is not None and cp > 0 and (entry.sigma is None or sigma is not None):
            sigma = sigma or (limits[1] - limits[0]) / (6 * cp)
            return DISTRIBUTIONS[name].make(*limits, sigma), name
        return None

    # Temperature.

    def _thermal(self, name: str, entry: Thermal, path: Path) -> _Deviation | None:
        """All lengths expand together: each by its coefficient times its length and the change."""
        if name in self.tolerances:
            self._wrong("tolerance.thermal-name", path, name=name)
        low, high = (self._value(end, u.PURE, (*path, "change")) for end in entry.change)
        found = None if low is None or high is None else (low, high)
        if found and not found[0] < found[1]:
            data = dict(zip(("low", "high"), (end.text[:40] for end in entry.change), strict=True))
            self._wrong("value.not-rising", (*path, "change"), **data)
            found = None
        material, alpha = (entry.material or "").strip().lower(), None
        if entry.expansion is not None:
            alpha = self._value(entry.expansion, u.PURE, (*path, "expansion"))
        elif material in EXPANSION:
            alpha = EXPANSION[material]
        else:
            data = {"given": material[:40], "near": near(material, [*EXPANSION])}
            self._wrong("tolerance.material", (*path, "material"), **data)
        moved = self._expanding(entry, path)
        spread = self._spread(path, _uniform(entry), found or (-1.0, 1.0), u.PURE)
        if found is None or alpha is None or spread is None:
            return None
        weights = alpha * 1e-6 * np.array([self.quantities.parameters[name] for name in moved])
        text = f"{found[0]:g} .. {found[1]:g} K, {material or f'{alpha:g} 1e-6/K'}"
        return _Deviation(name, 0.0, *found, *spread, u.PURE, "K", text, tuple(moved), weights)

    def _expanding(self, entry: Thermal, path: Path) -> list[str]:
        """The lengths that expand."""
        lengths = [name for name in self.independent if self.quantities.dimensions.of(name) == u.LENGTH]
        if entry.parameters is None:
            if not lengths:
                self._wrong("tolerance.no-length", path)
            return lengths
        for i, name in enumerate(entry.parameters):
            at = (*path, "parameters", i)
            if name not in self.tolerances:
                self._wrong("name.unknown-parameter", at, name=name, near=near(name, lengths))
            elif name not in self.independent:
                self._derived(name, at)
            elif name not in lengths:
                self._wrong("tolerance.not-a-length", at, name=name)
        return [name for name in dict.fromkeys(entry.parameters) if name in lengths]

    def _value(self, expression: Expression, dimension: Dimension, path: Path) -> float | None:
        try:
            value = self.quantities.value(expression, dimension)
        except DimensionError as error:
            self._wrong(error.key, path, **self.quantities.spelt(error.data))
            return None
        if abs(value) < LARGEST:
            return value
        self._wrong("value.not-finite", path, text=expression.text[:60])
        return None


def _uniform(entry: Thermal) -> Thermal:
    """A change of temperature is uniform unless something else is said of it."""
    said = entry.distribution or entry.cp or entry.sigma
    return entry if said else entry.model_copy(update={"distribution": "uniform"})


def _text(limits: AnyLimits) -> str:
    """Limits as the file states them."""
    return f"[{limits[0].text}, {limits[1].text}]" if isinstance(limits, tuple) else str(limits.raw)
