"""The contributors that a file states: tolerances of its parameters, the general one, changes of temperature."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from linkwright.expressions import units as u
from linkwright.findings import Finding, Joined, raise_errors
from linkwright.kernels import Compiled
from linkwright.model.references import option_faults
from linkwright.studies.accuracy.contributors import Contributor, Contributors
from linkwright.studies.accuracy.correlated import check as check_correlations
from linkwright.studies.accuracy.correlated import matrix
from linkwright.studies.accuracy.parameter_chain import derivatives
from linkwright.studies.accuracy.stated_options import DeviationOptions
from linkwright.studies.accuracy.thermal import thermal
from linkwright.studies.accuracy.tolerance_reader import PATH, Moving, ToleranceReader
from linkwright.studies.accuracy.toleranced import toleranced
from linkwright.tolerances import NoTolerance


def contributors(compiled: Compiled, options: DeviationOptions) -> Contributors:
    """All contributors and their correlations. Raises ModelError where :func:`check_contributors` finds something."""
    stated = _Stated(compiled, options)
    raise_errors(stated.findings)
    every = tuple(map(stated.contributor, stated.every))
    correlation = matrix([one.name for one in every], options.correlations)
    return Contributors(every, correlation, compiled.parameters.size)


def check_contributors(compiled: Compiled, options: DeviationOptions) -> Iterator[Finding]:
    """What is wrong with the tolerances and all else that makes contributors."""
    yield from _Stated(compiled, options).findings


def skipped(compiled: Compiled, options: DeviationOptions) -> list[Finding]:
    """A warning on the lengths that the general tolerance has nothing for."""
    names = _Stated(compiled, options).skipped
    data = {"names": Joined(names), "general": options.general.found.text if options.general else ""}
    return [Finding("tolerance.skipped", (*PATH, "general"), data, severity="warning")] if names else []


class _Stated(ToleranceReader):
    """All deviations of a study, and how the parameters follow them."""

    def __init__(self, compiled: Compiled, options: DeviationOptions) -> None:
        super().__init__(compiled, options)
        self.skipped: list[str] = []
        self.findings += option_faults(compiled.mechanism, options, PATH)
        if options.cp <= 0:
            self.note_fault("tolerance.cp", (*PATH, "cp"), cp=f"{options.cp:g}")
        names = self._named() if options.parameters is not None else self._all()
        read = [toleranced(self, name) for name in names]
        read += [thermal(self, name, entry) for name, entry in options.thermal.items()]
        self.every = [one for one in read if one is not None]
        moved = {name for one in self.every for name in one.moved}
        self.column = {name: i for i, name in enumerate(name for name in self.independent if name in moved)}
        self.derivatives = derivatives(self.quantities, [*self.column])
        for name, row in zip(self.quantities.parameters, self.derivatives, strict=True):
            if not np.isfinite(row).all():
                text = compiled.mechanism.parameters[name].value.text[:60]
                self.note_fault("tolerance.no-derivative", ("parameters", name), text=text)
        if options.deviating and not (read or self.findings):
            self.note_fault("tolerance.none", PATH)
        self.findings += check_correlations([*names, *options.thermal], options.correlations)

    def contributor(self, one: Moving) -> Contributor:
        """A deviation with the direction in which all parameters follow it."""
        unit, size = (one.unit, 1.0) if one.unit else self.quantities.unit_of(one.dimension)
        return Contributor(
            name=one.name,
            direction=self.derivatives[:, [self.column[name] for name in one.moved]] @ one.weights,
            nominal=one.nominal,
            low=one.limits[0],
            high=one.limits[1],
            mean=one.spread.mean,
            sigma=one.spread.sigma,
            quantile=one.spread.quantile,
            dimension=one.dimension,
            unit=unit,
            size=size,
            stated=one.stated,
            distribution=one.distribution,
        )

    def _all(self) -> list[str]:
        """The parameters that state limits, and those that get the general ones."""
        return [name for name, entry in self.tolerances.items() if entry.limits is not None or self._general(name)]

    def _named(self) -> list[str]:
        """The parameters that the study names."""
        kept: list[str] = []
        for i, name in enumerate(self.options.parameters or ()):
            path = (*PATH, "parameters", i)
            if name not in self.tolerances:  # told as a name
                continue
            if name in kept:
                self.note_fault("tolerance.named-twice", path, name=name)
            elif name not in self.independent:
                self.of_derived(name, path)
            elif self.tolerances[name].limits is None and not self._meant(name):
                self.note_fault("tolerance.missing", path, name=name)
            else:
                kept.append(name)
        return kept

    def _meant(self, name: str) -> bool:
        """Whether the general tolerance is meant for a parameter that states no limits."""
        dimension = self.quantities.dimensions.of(name)
        angle = dimension == u.ANGLE and self.tolerances[name].side is not None
        return self.options.general is not None and name in self.independent and (dimension == u.LENGTH or angle)

    def _general(self, name: str) -> bool:
        """Whether it has limits for it; lengths of a size that it has none for are skipped."""
        if not self._meant(name):
            return False
        assert self.options.general is not None
        if self.quantities.dimensions.of(name) == u.LENGTH:
            try:
                self.options.general.found.limits(abs(self.quantities.parameters[name]))
            except NoTolerance:
                self.skipped.append(name)
                return False
        return True
