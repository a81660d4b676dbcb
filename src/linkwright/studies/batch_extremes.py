"""Extremes of curves of many samples, each root-found on exact rates between places of a shared grid.

Not one with the search of a single run (:mod:`linkwright.measures.search`): that doubles its grid until nothing more
is found and takes limits at singular places from series, which is surer and too slow for thousands of samples. Both
find their roots by ``bracketed`` of :mod:`linkwright.results.stationary`.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright.reductions import Figures
from linkwright.results.batch_run import Bunch, What, Who
from linkwright.results.batch_windows import Spans
from linkwright.results.stationary import Changes, turns
from linkwright.studies.one_sided_limits import Candidates

Array = NDArray[np.float64]

OVER, HOLLOW = 2.0, 0.25
"""How far beyond the ends of a bracket an extreme in it may lie, over where their tangents meet; and besides, over what
the flatter one makes over the bracket."""
SLACK = 1e-9
"""Brackets are searched that may come so near to the best, over the curve's size."""


def peaks(
    bunch: Bunch,
    what: What,
    asks: Sequence[tuple[Spans, float]],
    gaps: Spans | None = None,
    beside: Candidates | None = None,
    scale: float = 0.0,
) -> list[Figures]:
    """The largest values of a curve in some spans, or with the sign -1 the smallest; NaN where it isn't finite. It may
    jump in ``gaps`` that the spans leave out, and between candidates from ``beside``. What is round-off beside its
    ``scale`` doesn't turn.

    Only brackets that may hold the extreme are searched: where it is concave a curve stays below its tangents.
    """
    value, rate = bunch.on_grid(what)
    found = turns(value, rate, bunch.length, scale)
    limits = {sign: _limit(bunch, found, value, rate, sign) for sign in {sign for _, sign in asks}}
    if gaps is not None:
        broken = gaps.touched(found.who, bunch.t[found.who, found.before], bunch.t[found.who, found.after])
        limits = {sign: np.where(broken, np.inf, limit) for sign, limit in limits.items()}
    ends, inside = {}, {}
    for spans in {id(spans): spans for spans, _ in asks}.values():
        who, a, b = spans.flat()
        who, t = np.concatenate([who, who]), np.concatenate([a, b])
        ends[id(spans)] = who, t, bunch.values(what, who, t)
        inside[id(spans)] = spans.grid(bunch.t)
    wanted, slack = np.zeros(found.who.size, dtype=bool), SLACK * np.abs(value).max(axis=1)
    for spans, sign in asks:
        best = np.where(inside[id(spans)], sign * value, -np.inf).max(axis=1)
        who, _, height = ends[id(spans)]
        np.fmax.at(best, who, sign * height)
        low, high = bunch.t[found.who, found.before], bunch.t[found.who, found.after]
        wanted |= spans.touched(found.who, low, high) & ~(limits[sign] < (best - slack)[found.who])
    who, t = bunch.turning(what, found, wanted)
    height = bunch.values(what, who, t)
    if beside is not None:
        who, t, height = (np.concatenate(part) for part in zip((who, t, height), beside, strict=True))
    figures = []
    for spans, sign in asks:
        own = spans.within(who, t)
        candidates = list(zip(ends[id(spans)], (who[own], t[own], height[own]), strict=True))
        figure = _highest(bunch.samples, sign, *(np.concatenate(part) for part in candidates))
        known = (np.isfinite(value) | ~inside[id(spans)]).all(axis=1)
        figures.append(Figures(np.where(known, figure.values, np.nan), np.where(known, figure.times, np.nan)))
    return figures


def _limit(bunch: Bunch, found: Changes, value: Array, rate: Array, sign: float) -> Array:
    """What the curve, times ``sign``, can't exceed in each bracket; -inf where it has its extreme the other way.

    Where it is concave it stays below its tangents at both ends. It may have a corner, with a little of a hollow
    before it; where an end lies above the other's tangent nothing is known.
    """
    who = found.who
    (a, f, df), (b, g, dg) = (
        (bunch.t[who, i], sign * value[who, i], sign * rate[who, i]) for i in (found.before, found.after)
    )
    with np.errstate(all="ignore"):
        width, ends = b - a, np.maximum(f, g)
        over = f + df * (g - f - dg * width) / (df - dg) - ends
        limit = ends + OVER * over + HOLLOW * width * np.minimum(df, -dg)
        hollow = ~((g <= f + df * width) & (f <= g - dg * width))
    return np.where(df > 0, np.where(hollow | np.isnan(limit), np.inf, limit), -np.inf)


def _highest(samples: int, sign: float, who: Who, t: Array, height: Array) -> Figures:
    """Each sample's largest candidate times ``sign``, the first of equals; NaN with one that isn't finite."""
    order = np.lexsort((t, -sign * height, who))
    owner, first = np.unique(who[order], return_index=True)
    figures = Figures(np.full(samples, np.nan), np.full(samples, np.nan))
    figures.values[owner], figures.times[owner] = height[order][first], t[order][first]
    bad = who[~np.isfinite(height)]
    figures.values[bad] = figures.times[bad] = np.nan
    return figures
