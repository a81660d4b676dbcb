"""The files of a sweep: tables as CSV in the file's units, netCDF in SI."""

from __future__ import annotations

import io

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.units import TIME
from linkwright.model.csv_text import cell, head, written
from linkwright.results.netcdf import described, stored, variable_name
from linkwright.results.result import si_unit
from linkwright.studies.sweep.outcome import SweepOutcome

Array = NDArray[np.float64]

BANDS = ("mean", "deviation", "least", "largest", "count")


def samples_csv(outcome: SweepOutcome) -> str | None:
    """A row a sample: its number, the varied parameters, the measures' figures (blank where there is none), whether
    each requirement is met (1 or 0), whether it lacks a value and since when; ``None`` where no rows are kept."""
    table, quantities = outcome.table, outcome.compiled.quantities
    if table is None:
        return None
    header, columns = ["sample"], []
    for name, values in zip(outcome.names, table.parameters, strict=True):
        unit, size = quantities.unit_of(quantities.dimensions.of(name))
        header.append(head(name, unit))
        columns.append(values / size)
    for found, values in zip(outcome.measures, table.figures, strict=True):
        header.append(head(found.column.name, found.column.unit))
        columns.append(values / found.column.size)
    for name, met in zip(outcome.shares, table.met, strict=True):
        header.append(f"{name} met")
        columns.append(met.astype(np.int64))
    unit, second = quantities.unit_of(TIME)
    header += ["failed", head("since", unit)]
    columns += [table.failed.astype(np.int64), table.since / second]
    rows = zip(*(column.tolist() for column in columns), strict=True)
    return written(header, ([str(k), *map(cell, row)] for k, row in enumerate(rows)))


def bands_csv(outcome: SweepOutcome) -> str | None:
    """A row a pose: the time, and of each signal mean, deviation, least and largest value and how many samples have
    one; ``None`` where there are no signals."""
    if not outcome.bands:
        return None
    unit, second = outcome.compiled.quantities.unit_of(TIME)
    header, columns = [head("t", unit)], [outcome.t / second]
    for text, band in outcome.bands.items():
        unit, size = outcome.compiled.quantities.unit_of(band.dimension)
        for kind in BANDS:
            values = getattr(band, kind)
            header.append(f"{text} count" if kind == "count" else head(f"{text} {kind}", unit))
            columns.append(values if kind == "count" else values / size)
    rows = zip(*(column.tolist() for column in columns), strict=True)
    return written(header, (list(map(cell, row)) for row in rows))


def netcdf_bytes(outcome: SweepOutcome) -> bytes:
    """The same figures as a netCDF file (classic, 64-bit offset), in SI: over ``sample`` where rows are kept, and the
    signals' bands over ``time``; NaN is the missing value."""
    from scipy.io import netcdf_file

    stream = io.BytesIO()
    file = netcdf_file(stream, "w", version=2)
    for key, text in _attributes(outcome).items():
        setattr(file, key, stored(text))

    def add(name: str, dimension: str, unit: str, values: Array) -> None:
        variable = file.createVariable(variable_name(name), "d", (dimension,))
        variable[:] = values
        variable.long_name, variable.units = stored(name), stored(unit or "1")

    dimensions, table = outcome.compiled.quantities.dimensions, outcome.table
    if table is not None:
        file.createDimension("sample", outcome.samples)
        for name, values in zip(outcome.names, table.parameters, strict=True):
            add(name, "sample", si_unit(dimensions.of(name)), values)
        for found, values in zip(outcome.measures, table.figures, strict=True):
            add(f"measure {found.column.name}", "sample", si_unit(found.column.dimension), values)
        for name, met in zip(outcome.shares, table.met, strict=True):
            add(f"{name} met", "sample", "", met.astype(float))
        add("failed", "sample", "", table.failed.astype(float))
    file.createDimension("time", outcome.t.size)
    add("time", "time", "s", outcome.t)
    for text, band in outcome.bands.items():
        for kind in BANDS:
            values = getattr(band, kind).astype(float)
            add(f"{text} {kind}", "time", "" if kind == "count" else si_unit(band.dimension), values)
    file.flush()
    return stream.getvalue()


def _attributes(outcome: SweepOutcome) -> dict[str, str]:
    facts = described(outcome.compiled, (*outcome.failures, *outcome.warnings))
    return {**facts, "plan": outcome.plan.name, "seed": str(outcome.options.seed), "kernel": outcome.kernel}
