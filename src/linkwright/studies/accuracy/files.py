"""The files of the accuracy study: tables as CSV in the file's units, netCDF in SI."""

from __future__ import annotations

import io

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.units import TIME
from linkwright.model.csv_text import cell, head, written
from linkwright.results.netcdf import described, stored, variable_name
from linkwright.results.result import si_unit
from linkwright.studies.accuracy.outcome import AccuracyOutcome, Curve
from linkwright.studies.accuracy.summary import part, per, ranked

Array = NDArray[np.float64]

CONTRIBUTION = (
    "parameter", "parameter unit", "parameter value", "tolerance", "distribution", "lower deviation", "upper deviation",
    "sigma", "coefficient below", "coefficient above", "share", "worst low", "worst high",
)  # fmt: skip


def contributors_csv(outcome: AccuracyOutcome) -> str | None:
    """A row for each output and contributor, ranked: the parameter and its tolerance in its unit, coefficients in the
    output's unit over that, its share in the variance, its part of the worst case in the output's unit."""
    if not outcome.every:
        return None
    unit, second = outcome.compiled.quantities.unit_of(TIME)
    rows = []
    for name, figure in outcome.every.items():
        column = figure.column
        time = "" if figure.time is None else cell(figure.time / second)
        known = [name, column.unit, cell(figure.nominal / column.size), time]
        for i in ranked(figure):
            one = outcome.contributors.every[i]
            below, above = (figure.coefficients[i] * one.size / column.size).tolist()
            worst = (end / column.size for end in part(figure, i, one))
            deviations = (one.low / one.size, one.high / one.size, one.sigma / one.size)
            figures = (*deviations, below, above, float(figure.shares[i]), *worst)
            stated = [one.name, one.unit, cell(one.nominal / one.size), one.stated, one.distribution]
            rows.append([*known, *stated, *(cell(float(value)) for value in figures)])
    return written(["output", "unit", "nominal", head("at", unit), *CONTRIBUTION], rows)


def bands_csv(outcome: AccuracyOutcome) -> str | None:
    """A row a pose: the time, and of each signal the nominal value, deviations from it (worst case, mean and standard
    deviation of RSS, those of the samples, shift and bound by clearances), and each coefficient."""
    if not outcome.curves:
        return None
    unit, second = outcome.compiled.quantities.unit_of(TIME)
    header, columns = [head("t", unit)], [outcome.run.t / second]
    for curve in outcome.curves.values():
        for name, values in _rows(curve).items():
            counted = name == "count"
            header.append(f"{curve.text} {name}" if counted else head(f"{curve.text} {name}", curve.unit))
            columns.append(values.astype(np.int64) if counted else values / curve.size)
        for one, values in zip(outcome.contributors.every, curve.coefficients, strict=True):
            header.append(head(f"d({curve.text})/d({one.name})", per(curve.unit, one.unit)))
            columns.append(values * one.size / curve.size)
    rows = zip(*(column.tolist() for column in columns), strict=True)
    return written(header, (list(map(cell, row)) for row in rows))


def _rows(curve: Curve) -> dict[str, Array]:
    """What is known of a signal at each pose, by its name in tables."""
    rows = {"nominal": curve.nominal, "worst low": curve.worst[0], "worst high": curve.worst[1]}
    rows |= {"mean": curve.mean, "sigma": curve.sigma}
    if curve.sampled is not None:
        names = ("sampled mean", "sampled sigma", "sampled least", "sampled largest", "count")
        rows |= dict(zip(names, curve.sampled, strict=True))
    if curve.play is not None:
        rows |= {"play shift": curve.play[0], "play bound": curve.play[1]}
    return rows


def netcdf_bytes(outcome: AccuracyOutcome) -> bytes:
    """The same as a netCDF file (classic, 64-bit offset), in SI: signals over ``time``, coefficients (above the nominal
    value) and shares of all outputs over ``contributor``, whose names are an attribute; NaN is the missing value."""
    from scipy.io import netcdf_file

    every = outcome.contributors.every
    stream = io.BytesIO()
    file = netcdf_file(stream, "w", version=2)
    facts = described(outcome.compiled, (*outcome.failures, *outcome.warnings))
    facts |= {"contributors": "\n".join(one.name for one in every), "kernel": outcome.kernel or "none"}
    for key, text in facts.items():
        setattr(file, key, stored(text))

    def add(name: str, dimension: str, unit: str | None, values: Array) -> None:
        variable = file.createVariable(variable_name(name), "d", (dimension,))
        variable[:] = values
        variable.long_name = stored(name)
        if unit is not None:
            variable.units = stored(unit or "1")

    file.createDimension("time", outcome.run.t.size)
    if every:
        file.createDimension("contributor", len(every))
    add("time", "time", "s", outcome.run.t)
    for curve in outcome.curves.values():
        for name, values in _rows(curve).items():
            add(f"{curve.text} {name}", "time", "" if name == "count" else si_unit(curve.dimension), values)
        for one, values in zip(every, curve.coefficients, strict=True):
            unit = per(si_unit(curve.dimension), si_unit(one.dimension))
            add(f"d({curve.text})/d({one.name})", "time", unit, values)
    for name, figure in outcome.every.items() if every else ():
        add(f"{name}: coefficients", "contributor", None, figure.coefficients[:, 1])
        add(f"{name}: shares", "contributor", "", figure.shares)
    file.flush()
    return stream.getvalue()
