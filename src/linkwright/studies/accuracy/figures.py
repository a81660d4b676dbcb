"""The figures of measures with their derivatives, and the curves of signals with theirs."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.language import parse
from linkwright.expressions.units import Dimension
from linkwright.measures import BoundMeasure, measure_all
from linkwright.results import Run
from linkwright.studies.accuracy.contributors import Contributors
from linkwright.studies.accuracy.derivatives import Derivatives
from linkwright.studies.accuracy.outcome import OutputDeviations, SignalDeviations
from linkwright.studies.accuracy.signal_sensitivities import Slopes
from linkwright.studies.accuracy.stackup import larger, shares, spread, worst
from linkwright.studies.figures import columns

Array = NDArray[np.float64]


def reach(contributors: Contributors) -> Array:
    """The largest deviation of each contributor: (contributors,)."""
    return np.maximum(np.abs(contributors.low), np.abs(contributors.high))


def least(run: Run, dimension: Dimension) -> float:
    """The least change (SI) of a figure of some dimension that is more than round-off."""
    return run.round_off(dimension)


def curves(run: Run, slopes: Slopes, contributors: Contributors, texts: Sequence[str]) -> dict[str, SignalDeviations]:
    """The signals over the run; their figures are still open."""
    quantities, found = run.compiled.quantities, {}
    trees = [quantities.dimensions.bind(parse(text), None) for text in texts]
    for text, tree in zip(texts, trees, strict=True):
        here = slopes.at([tree], run.t, rates=False)
        dimension = quantities.dimensions.dimension(parse(text))
        coefficients = here.slope[0]
        most = np.nan_to_num(np.abs(coefficients)).max(axis=1, initial=0.0)
        coefficients[most * reach(contributors) < least(run, dimension)] = 0.0
        limits = np.stack(worst(coefficients, contributors))
        mean, sigma = spread(coefficients, contributors)
        unit, size = quantities.unit_of(dimension)
        width = np.nan_to_num(limits[1] - limits[0])
        found[text] = SignalDeviations(
            text, dimension, unit, size, run.t, here.value[0], coefficients, limits, mean, sigma, int(width.argmax())
        )
    return found


def figures(
    run: Run, slopes: Slopes, contributors: Contributors, measures: Sequence[BoundMeasure]
) -> dict[str, OutputDeviations]:
    """All figures of some measures by their names; a measure without a value, or with an unbounded one, has none."""
    taken = zip(measures, measure_all(run, measures)[0], strict=True)
    results = [(m, result) for m, result in taken if result.found and not any(f.unbounded for f in result.found)]
    derivatives, made = Derivatives(run, slopes, [measure for measure, _ in results]), dict[str, OutputDeviations]()
    for measure, result in results:
        pairs = list(zip(columns(run.compiled, measure), result.found, strict=True))
        if not len(contributors):
            made |= {c.name: OutputDeviations(c, number.value, number.time, np.empty((0, 2))) for c, number in pairs}
            continue
        for (column, number), derivative in zip(pairs, derivatives.of(measure.name), strict=True):
            round_off = least(run, column.dimension)
            one = derivative.without_round_off(reach(contributors), round_off)
            coefficients = larger(one.sides)
            limits = one.limits(contributors.low, contributors.high)
            mean, sigma = spread(coefficients, contributors)
            made[column.name] = OutputDeviations(
                column,
                number.value,
                number.time,
                one.sides,
                one.tie,
                limits,
                float(mean),
                float(sigma),
                shares(coefficients, contributors),
                round_off=round_off,
            )
    return made
