"""The numbers of a sweep, for its files."""

from __future__ import annotations

import numpy as np

from linkwright.expressions.units import TIME
from linkwright.results.dataset import Dataset, Variable, described, times, variable_of
from linkwright.studies.sweep.outcome import SweepOutcome

BANDS = ("mean", "deviation", "least", "largest")


def dataset(outcome: SweepOutcome) -> Dataset:
    """Over ``sample``, where rows are kept: its number, the varied parameters, the measures' figures, whether each
    requirement is met, whether the sample lacks a value and since when. Over ``time``: of each signal mean, deviation,
    least and largest value and how many samples have one."""
    quantities, table = outcome.compiled.quantities, outcome.table
    made: list[Variable] = []
    if table is not None:
        made.append(Variable("sample", "sample", np.arange(outcome.samples)))
        for name, values in zip(outcome.names, table.parameters, strict=True):
            made.append(variable_of(quantities, name, "sample", values, quantities.dimensions.of(name)))
        for measure, values in zip(outcome.measures, table.figures, strict=True):
            made.append(measure.column.variable(values))
        made += [Variable(f"{name} met", "sample", met) for name, met in zip(outcome.shares, table.met, strict=True)]
        made.append(Variable("failed", "sample", table.failed))
        made.append(variable_of(quantities, "since", "sample", table.since, TIME))
    if outcome.bands:
        made.append(times(quantities, outcome.t))
    for text, band in outcome.bands.items():
        for kind in BANDS:
            made.append(variable_of(quantities, f"{text} {kind}", "time", getattr(band, kind), band.dimension))
        made.append(Variable(f"{text} count", "time", band.count))
    facts = described(outcome.compiled, (*outcome.failures, *outcome.warnings))
    facts |= {"plan": outcome.plan.name, "seed": str(outcome.options.seed), "kernel": outcome.kernel}
    return Dataset(made, facts)
