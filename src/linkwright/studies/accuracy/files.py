"""The numbers of the accuracy study, for its files."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.units import TIME
from linkwright.model.csv_text import cell, head, table_text
from linkwright.results.dataset import Dataset, Variable, described, si_unit, times
from linkwright.studies.accuracy.outcome import AccuracyOutcome, SignalDeviations
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
    return table_text(["output", "unit", "nominal", head("at", unit), *CONTRIBUTION], rows)


def dataset(outcome: AccuracyOutcome) -> Dataset:
    """Over ``time``: of each signal the nominal value, deviations from it (worst case, mean and standard deviation of
    RSS, those of the samples, shift and bound by clearances), and each coefficient. Over ``contributor``, whose names
    are among the facts: coefficients (above the nominal value) and shares of all outputs."""
    every = outcome.contributors.every
    made = [times(outcome.compiled.quantities, outcome.run.t)] if outcome.curves else []
    for curve in outcome.curves.values():
        si = si_unit(curve.dimension)
        for name, values in _rows(curve).items():
            made.append(Variable(f"{curve.text} {name}", "time", values, curve.unit, curve.size, si))
        if curve.sampled is not None:
            made.append(Variable(f"{curve.text} count", "time", curve.sampled[-1].astype(np.int64)))
        for one, values in zip(every, curve.coefficients, strict=True):
            units = (per(curve.unit, one.unit), curve.size / one.size, per(si, si_unit(one.dimension)))
            made.append(Variable(f"d({curve.text})/d({one.name})", "time", values, *units))
    for name, figure in outcome.every.items() if every else ():
        made.append(Variable(f"{name}: coefficients", "contributor", figure.coefficients[:, 1], si=None))
        made.append(Variable(f"{name}: shares", "contributor", figure.shares))
    facts = described(outcome.compiled, (*outcome.failures, *outcome.warnings))
    facts |= {"contributors": "\n".join(one.name for one in every), "kernel": outcome.kernel or "none"}
    return Dataset(made, facts)


def _rows(curve: SignalDeviations) -> dict[str, Array]:
    """What is known of a signal at each pose, by its name in tables."""
    rows = {"nominal": curve.nominal, "worst low": curve.worst[0], "worst high": curve.worst[1]}
    rows |= {"mean": curve.mean, "sigma": curve.sigma}
    if curve.sampled is not None:
        names = ("sampled mean", "sampled sigma", "sampled least", "sampled largest")
        rows |= dict(zip(names, curve.sampled, strict=False))
    if curve.play is not None:
        rows |= {"play shift": curve.play[0], "play bound": curve.play[1]}
    return rows
