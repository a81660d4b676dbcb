"""The figures of measures with their derivatives, and the curves of signals with theirs."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright.kernels.varied import Varied
from linkwright.model.expressions import parse
from linkwright.results import Run
from linkwright.studies.accuracy.contributors import Contributors
from linkwright.studies.accuracy.deviations import Shift
from linkwright.studies.accuracy.derivatives import RULES, Derivative, Derivatives
from linkwright.studies.accuracy.outcome import Curve, Figure
from linkwright.studies.accuracy.slopes import Slopes
from linkwright.studies.accuracy.stacking import larger, shares, spread, worst
from linkwright.studies.figures import columns
from linkwright.studies.many import Measuring
from linkwright.studies.measures import measure_all

Array = NDArray[np.float64]

STEP = 0.02
"""Differences shift a deviation by this share of its tolerance."""


def curves(run: Run, slopes: Slopes, contributors: Contributors, texts: Sequence[str]) -> dict[str, Curve]:
    """The signals over the run; their figures are still open."""
    quantities, found = run.compiled.quantities, {}
    trees = [quantities.dimensions.bind(parse(text), None) for text in texts]
    for text, tree in zip(texts, trees, strict=True):
        here = slopes.at([tree], run.t, rates=False)
        coefficients = here.slope[0]
        limits = np.stack(worst(np.stack([coefficients, coefficients], axis=1), contributors))
        mean, sigma = spread(coefficients, contributors)
        dimension = quantities.dimensions.dimension(parse(text))
        unit, size = quantities.unit_of(dimension)
        width = np.nan_to_num(limits[1] - limits[0])
        found[text] = Curve(
            text, dimension, unit, size, run.t, here.value[0], coefficients, limits, mean, sigma, int(width.argmax())
        )
    return found


def figures(
    run: Run, slopes: Slopes, contributors: Contributors, varied: Varied, names: Sequence[str]
) -> dict[str, Figure]:
    """All figures of some measures by their names; a measure without a value has none."""
    results = {result.name: result for result in measure_all(run, names)[0] if result.found}
    derivatives, made = Derivatives(run, slopes, [*results]), {}
    for name, result in results.items():
        reduction = result.measure.reduction
        exact = reduction in RULES
        found = derivatives.of(name) if exact else differences(run, contributors, varied, name)
        for column, number, one in zip(columns(run.compiled, name), result.found, found, strict=True):
            coefficients = larger(one.sides)
            limits = worst(one.sides, contributors)
            mean, sigma = spread(coefficients, contributors)
            made[column.name] = Figure(
                column,
                number.value,
                number.time,
                one.sides,
                one.tie,
                not exact,
                (float(limits[0]), float(limits[1])),
                float(mean),
                float(sigma),
                shares(coefficients, contributors),
            )
    return made


def differences(run: Run, contributors: Contributors, varied: Varied, name: str) -> list[Derivative]:
    """The derivatives of a measure by differences of fourth order over a small share of each tolerance."""
    steps = STEP * np.maximum(np.abs(contributors.low), np.abs(contributors.high))
    offsets = np.array([-2.0, -1.0, 1.0, 2.0])
    count = len(contributors)
    deviations = (steps[:, None] * offsets)[None] * np.eye(count)[:, :, None]
    p = varied.parameters(Shift(run.compiled, contributors).values(deviations.reshape(count, -1)))
    values = Measuring(varied, run, [name]).of(p).figures[name]
    weights = np.array([1.0, -8.0, 8.0, -1.0]) / 12
    return [Derivative.smooth(found.values.reshape(count, -1) @ weights / steps) for found in values.values()]
