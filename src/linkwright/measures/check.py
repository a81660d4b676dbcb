"""The check of measures: what can refute reported numbers, from values that their search didn't use.

Values at the run's samples and on a second, incommensurate grid have to lie within reported extremes; means lie between
the extremes, and no root mean square is larger than the largest magnitude; means by another rule on other nodes agree.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright.measures.found import MeasureResult
from linkwright.measures.measure import Measurer
from linkwright.reductions import kind_of

Array = NDArray[np.float64]

GOLDEN = (np.sqrt(5.0) - 1) / 2
ROUND_OFF = 64 * float(np.finfo(float).eps)
"""Values this near, over what is usual of their dimension, are the same."""
LOST = 4.0
"""Right outside the band of a change point, values may be off by so many times what limits and closed forms differ by
inside of it."""
LEAST = 1000
"""The fewest points of the second grid."""


def misfit(measurer: Measurer, results: Sequence[MeasureResult]) -> float | None:
    """The worst contradiction to reported measures, relative to their range or size; ``None`` without measures."""
    run, known = measurer.run, [result for result in results if result.found and result.measure.wrap is None]
    if not known:
        return None
    count = max(LEAST, 2 * run.steps)
    second = run.start + (run.stop - run.start) * np.mod(GOLDEN * np.arange(1, count + 1), 1.0)
    t = np.sort(np.concatenate([run.t, second]))
    trees = [measurer.by_name[result.name].signal for result in known]
    values = run.all_rates(trees, t)[0]
    worst = [0.0]
    for result, row in zip(known, values, strict=True):
        reported = {found.label: found.value for found in result.found}
        reading = measurer.reading(measurer.by_name[result.name])
        worst += [_extremes(measurer, result, t, row), _mean(measurer, result)]
        worst.append(kind_of(result.measure).contradiction(reported, reading))
    return max(worst)


def _extremes(measurer: Measurer, result: MeasureResult, t: Array, row: Array) -> float:
    """By how much values exceed reported extremes beyond their round-off, over the range.

    The closed forms of a motion carried through change points lose digits beside them, rates the most. What they lose
    is measured: by it limits from outside of the bands and closed forms inside of them differ.
    """
    probe = measurer.probe(measurer.by_name[result.name])
    some = row[probe.counting(t) & np.isfinite(row)]
    if not some.size:
        return 0.0
    reported = {found.label: found.value for found in result.found}
    over = kind_of(result.measure).beyond(reported, float(some.min()), float(some.max()))
    if over is None or over <= 0:
        return 0.0
    (usual,) = measurer.run.usual([result.dimension])
    over -= ROUND_OFF * max(float(np.abs(some).max()), usual)
    over -= LOST * measurer.search.passage_error(probe.node)
    return max(over, 0.0) / (float(np.ptp(some)) or 1.0)


def _mean(measurer: Measurer, result: MeasureResult) -> float:
    """How far a mean lies outside the extremes of what is averaged, and from that of another rule, over its size."""
    kind, probe = kind_of(result.measure), measurer.probe(measurer.by_name[result.name])
    reported, power = kind.mean_of(result.found[0].value, probe.length()), kind.power
    if reported is None or power is None:
        return 0.0
    other = probe.mean(power, rule=1)
    off = abs(reported**power - other.value) / other.size if other.size > 0 else 0.0
    low, high = probe.bottom().value, probe.top().value
    if power == 2:
        low, high = 0.0, max(abs(low), abs(high))
    size = max(abs(low), abs(high))
    outside = max(low - reported, reported - high, 0.0) / size if 0 < size < np.inf else 0.0
    return max(off, outside)
