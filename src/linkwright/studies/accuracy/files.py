"""The numbers of the accuracy study, for its files."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.units import TIME
from linkwright.model.csv_text import cell, head, table_text
from linkwright.studies.accuracy.outcome import AccuracyOutcome
from linkwright.studies.accuracy.summary import part, ranked

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
