"""The option ``calibrate`` of the accuracy study: actual dimensions from measured outputs."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from copy import copy
from typing import Annotated, Any

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from linkwright.elements.fields import freeze
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Frozen, Text
from linkwright.expressions.unknown import near
from linkwright.expressions.written import Fault, FrozenDict
from linkwright.findings import Finding, Joined, ModelError, raise_errors
from linkwright.kernels import Compiled
from linkwright.kernels.combined import expressed
from linkwright.kernels.parameter_batch import Varied
from linkwright.kernels.tangents import Tangents
from linkwright.model.actions import FileBeside
from linkwright.notation.angles import whole_turns
from linkwright.notation.duals import Dual, slope_of, value_of
from linkwright.results import Run
from linkwright.studies.accuracy.calibration_outcome import Calibration, Confounded, Estimate, Observed
from linkwright.studies.accuracy.calibration_solver import CalibrationFit, Measurements, TooFew, Unusable, fit, scaling
from linkwright.studies.accuracy.contributors import Contributors
from linkwright.studies.accuracy.measured import (
    PATH,
    MeasuredColumn,
    MeasuredRows,
    check_sigmas,
    read,
    read_file,
    sigmas,
    times,
)
from linkwright.studies.accuracy.outputs import OutputName, of_output
from linkwright.studies.accuracy.parameter_chain import derivatives, derived

Array = NDArray[np.float64]

UNLIKELY = 0.01
"""A chi square that is exceeded by chance less often than this is a warning."""


class Calibrate(Frozen):
    """Which measurements, which deviations to estimate from them, and how."""

    file: FileBeside | None = None
    points: tuple[Annotated[dict[OutputName, Expression], of_output(5), freeze], ...] | None = Field(
        None, min_length=1, max_length=10_000
    )
    at: Text | None = None
    parameters: tuple[Text, ...] | None = Field(None, min_length=1, max_length=1000)
    sigma: Annotated[dict[OutputName, Expression], of_output(4), freeze] = Field(default_factory=FrozenDict)
    prior: bool = False
    confidence: float = Field(0.95, gt=0, lt=1)
    threshold: float = Field(1e-6, gt=0, lt=1)

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        if ("file" in given) == ("points" in given):
            yield "accuracy.measured-source", {}


def check_calibrate(compiled: Compiled, options: Calibrate, contributors: Contributors, run: Run) -> Iterator[Finding]:
    """What is wrong with the options and with the measurements."""
    for i, name in enumerate(options.parameters or ()):
        if name not in contributors.names:
            data = {"name": name[:60], "near": near(name, contributors.names)}
            yield Finding("accuracy.no-contributor", (*PATH, "parameters", i), data)
    sheet, findings = _measured(compiled, options)
    yield from findings
    if sheet is not None:
        yield from _check_sheet(run, options, contributors, sheet)
    elif options.file is not None:
        yield from check_sigmas(compiled, options.sigma)


def _measured(compiled: Compiled, options: Calibrate) -> tuple[MeasuredRows | None, list[Finding]]:
    if options.file is not None:
        return read_file(compiled, options.file, options.at, compiled.folder)
    return read(compiled, options.points or (), options.at)


def _check_sheet(run: Run, options: Calibrate, contributors: Contributors, sheet: MeasuredRows) -> Iterator[Finding]:
    yield from times(run, sheet)[1]
    sigma, findings = sigmas(run.compiled, sheet, options.sigma)
    yield from findings
    chosen = len(set(options.parameters)) if options.parameters else len(contributors)
    count = int(np.isfinite(sheet.values).sum())
    least = 1 if options.prior else chosen + bool(np.isnan(sigma).any())
    if count < least:
        yield Finding("accuracy.few-measurements", sheet.path, {"count": count, "parameters": chosen, "least": least})


def calibrate(run: Run, options: Calibrate, contributors: Contributors) -> tuple[Calibration, list[Finding]]:
    """Estimate the deviations, and warnings. Raises ModelError where the measurements can't be used."""
    compiled = run.compiled
    raise_errors(check_calibrate(compiled, options, contributors, run))
    sheet, findings = _measured(compiled, options)
    raise_errors(findings)
    assert sheet is not None
    t, sigma = times(run, sheet)[0], sigmas(compiled, sheet, options.sigma)[0]
    names = contributors.names
    chosen = [names.index(name) for name in dict.fromkeys(options.parameters or names)]
    shifted = Shifted(run, contributors.directions[:, chosen], sheet.outputs, t)
    data = Measurements(sheet.values, sigma, np.array([column.dimension == u.ANGLE for column in sheet.outputs]))
    start, basis = _start_and_scale(contributors, chosen, options.prior)
    try:
        found = fit(shifted, data, start, basis, options.prior, options.confidence, options.threshold)
    except TooFew as error:
        column = sheet.outputs[error.args[0]]
        raise ModelError([Finding("accuracy.sigma-open", (*PATH, "sigma"), {"name": column.text})]) from None
    except Unusable:
        raise ModelError([Finding("accuracy.measured-without-value", sheet.path)]) from None
    made = _outcome(found, options, contributors, chosen, sheet, t, np.isfinite(sigma), shifted)
    return made, list(_warnings(made))


def _start_and_scale(contributors: Contributors, chosen: list[int], prior: bool) -> tuple[Array, Array]:
    """Where the deviations begin and what their scale is: with a prior, its mean and a root of its covariance."""
    if not prior:
        return np.zeros(len(chosen)), np.diag(contributors.sigma[chosen])
    values, vectors = np.linalg.eigh(contributors.correlation[np.ix_(chosen, chosen)])
    return contributors.mean[chosen], contributors.sigma[chosen][:, None] * vectors * np.sqrt(np.maximum(values, 0))


class Shifted:
    """Outputs at some times with their derivatives, at any deviations."""

    def __init__(self, run: Run, directions: Array, outputs: tuple[MeasuredColumn, ...], t: Array) -> None:
        self.run, self.t, self.compiled = run, t, run.compiled
        self.trees = [column.tree for column in outputs if column.tree is not None]
        quantities, names = self.compiled.quantities, self.compiled.graph.parameters
        moved = [i for i, name in enumerate(names) if directions[i].any()]
        self.bases = [names[i] for i in moved if not derived(quantities, names[i])]
        self.weights = np.stack([directions[names.index(name)] for name in self.bases])
        self.varied = Varied(self.compiled, self.bases)
        self.follows = len(self.bases) < len(moved)
        self.tangents = Tangents(self.compiled, directions)
        self.signals = run.signals_of(self.trees)
        self.near = run.evaluate(self.signals, t)

    def __call__(self, deviations: Array) -> tuple[Array, Array]:
        """(outputs, times) and (outputs, deviations, times) in SI; NaN where the mechanism can't be put together."""
        quantities = self.compiled.quantities
        nominal = np.array([quantities.parameters[name] for name in self.bases])
        p = self.varied.parameters((nominal + self.weights @ deviations)[:, None])[:, 0]
        shape = (len(self.trees), len(deviations), self.t.size)
        if np.isnan(p).any():
            return np.full((shape[0], shape[2]), np.nan), np.full(shape, np.nan)
        directions = None
        if self.follows:
            here = copy(quantities)
            here.parameters = dict(zip(self.compiled.graph.parameters, p.tolist(), strict=True))
            directions = derivatives(here, self.bases) @ self.weights
        tangents = self.tangents.at_parameters(p, directions)
        values, slopes = tangents.evaluate(self.signals, self.t)
        for i, name in enumerate(self.signals):
            if self.compiled.graph.wrapped(name):
                values[i] += 2 * np.pi * whole_turns(values[i], self.near[i])
        rows = {name: (Dual(v, s),) for name, v, s in zip(self.signals, values, slopes, strict=True)}
        y, j = np.empty((shape[0], shape[2])), np.empty(shape)
        for i, tree in enumerate(self.trees):
            found = expressed(self.compiled, tree, self.t, rows, 0, tangents.parameter_values()).d[0]
            y[i], j[i] = value_of(found), slope_of(found)
        return y, j


def _outcome(
    found: CalibrationFit,
    options: Calibrate,
    contributors: Contributors,
    chosen: list[int],
    sheet: MeasuredRows,
    t: Array,
    stated: NDArray[np.bool_],
    shifted: Shifted,
) -> Calibration:
    every = [contributors.every[i] for i in chosen]
    error = np.sqrt(np.maximum(np.diag(found.covariance), 0.0))
    estimates = []
    for i, one in enumerate(every):
        value, half, known = float(found.deviations[i]), float(found.factor * error[i]), bool(found.identified[i])
        estimates.append(
            Estimate(
                one.name, one.unit, one.size, one.nominal, value,
                float(error[i]) if known else None, (value - half, value + half) if known else None, known,
            )
        )  # fmt: skip
    scale = np.where(found.identified & (error > 0), error, np.nan)
    values = [estimate.value for estimate in estimates]
    confounded = tuple(
        Confounded(
            {one.name: float(part) for one, part in zip(every, column, strict=True) if part},
            scaling(column, values)
            and all(one.dimension == u.LENGTH for one, part in zip(every, column, strict=True) if part),
        )
        for column in found.null.T
    )
    rows = [(o, r) for o, r in np.argwhere(np.isfinite(sheet.values)).tolist()]
    observed = tuple(
        Observed(
            o, sheet.numbers[r], float(t[r]), float(sheet.values[o, r]), float(found.fitted[o, r]),
            float(found.studentised[o, r]), bool(found.outliers[o, r]),
        )
        for o, r in rows
    )  # fmt: skip
    return Calibration(
        tuple(estimates),
        found.covariance / np.outer(scale, scale),
        tuple(column.text for column in sheet.outputs),
        tuple((column.unit, column.size) for column in sheet.outputs),
        observed,
        tuple(found.sigma.tolist()),
        tuple(stated.tolist()),
        found.chi_square,
        found.freedom,
        found.probability,
        found.singular,
        options.threshold,
        confounded,
        options.prior,
        options.confidence,
        found.step,
        sheet.place.text,
        _rms(sheet, shifted(np.zeros(len(chosen)))[0]),
        _rms(sheet, found.fitted),
    )


def _rms(sheet: MeasuredRows, values: Array) -> tuple[float, ...]:
    """Root mean square of each output's residuals."""
    off = values - sheet.values
    for o, column in enumerate(sheet.outputs):
        if column.dimension == u.ANGLE:
            off[o] = (off[o] + np.pi) % (2 * np.pi) - np.pi
    return tuple(float(np.sqrt(np.mean(row[np.isfinite(row)] ** 2))) if np.isfinite(row).any() else 0.0 for row in off)


def _warnings(made: Calibration) -> Iterator[Finding]:
    def note(code: str, **data: Any) -> Finding:
        return Finding(code, PATH, data, severity="warning")

    for one in made.confounded:
        if len(one.names) == 1:
            yield note("accuracy.no-effect", name=one.names[0])
            continue
        yield note("accuracy.scale-open" if one.scaling else "accuracy.not-identifiable", names=Joined(one.names))
    if made.probability is not None and made.probability < UNLIKELY:
        ratio, share = made.chi_square / made.freedom, made.probability
        yield note("accuracy.poor-fit", ratio=f"{ratio:.3g}", share=f"{share:.2g}")
    if wrong := [one for one in made.observed if one.outlier]:
        rows = Joined(dict.fromkeys(str(one.row) for one in wrong[:10]))
        yield note("accuracy.outliers", count=len(wrong), rows=rows)
    if not made.converged:
        yield note("accuracy.not-settled", step=f"{made.step:.2g}")
