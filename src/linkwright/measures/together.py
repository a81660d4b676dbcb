"""Many expressions over one run, computed together: an evaluation of all rows costs little more than that of one.

The values among which extremes are, and the means of powers, are those of :class:`~linkwright.measures.probe.Probe`.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.language import Node
from linkwright.kernels.combined import combined
from linkwright.measures.probe import FEW, Probe
from linkwright.measures.round_off import LITTLE
from linkwright.results import Run
from linkwright.results.quadrature import panel_points

Array = NDArray[np.float64]
TIMES = 1 << 11
"""So many times are evaluated at once, which bounds the memory."""
CLOSE = 1e-13
"""How near a panel's integral is to be to those of its halves, over the integral of the magnitude."""
POINTS, FEWEST = 8, 16
"""Points of a panel; the fewest panels of an interval."""
HALVED = 5
"""So often panels are halved for all expressions; one whose mean still changes then is integrated by itself."""
MOST = 1 << 21
"""So many integrals of panels are kept at most (16 MB), for all expressions together."""


def look_ahead(probes: Sequence[Probe]) -> None:
    """Compute the values at which the extremes of all probes of one search are, at once."""
    run, asked = probes[0].run, [probe for probe in probes if probe.times.size <= FEW]
    wanted = [probe.times for probe in asked]
    found = [np.empty((2, t.size)) for t in wanted]
    every = np.unique(np.concatenate([*wanted, np.empty(0)]))
    for first in range(0, every.size, TIMES):
        some = every[first : first + TIMES]
        rates = run.all_rates([probe.node for probe in asked], some)
        for i, (t, rows) in enumerate(zip(wanted, found, strict=True)):
            low, high = np.searchsorted(t, some[0]), np.searchsorted(t, some[-1], side="right")
            at = np.searchsorted(some, t[low:high])
            rows[:, low:high] = [part[i, at] for part in rates]
    for probe, t, (values, slopes) in zip(asked, wanted, found, strict=True):
        probe.ahead = t, values, slopes


def mean_squares(probes: Sequence[Probe], squared: Sequence[bool], sizes: Sequence[float]) -> list[float]:
    """The mean square (SI) of each probe of one search; of one that is ``squared`` already, its mean.

    ``sizes`` are what is usual of the dimension of each before it is squared (SI): none is finer than their round-off.
    """
    powers = [1 if one else 2 for one in squared]
    zero = [probe.search.is_zero(probe.node) for probe in probes]
    together = np.array([i for i, probe in enumerate(probes) if not (zero[i] or probe.limits)], dtype=int)
    found, settled = _integrals([probes[i] for i in together], [powers[i] for i in together], np.array(sizes)[together])
    known = dict(zip(together[settled].tolist(), (found[settled] / probes[0].length()).tolist(), strict=True))
    known |= {i: 0.0 for i, one in enumerate(zero) if one}
    return [known[i] if i in known else probe.mean(powers[i]).value for i, probe in enumerate(probes)]


def _integrals(probes: Sequence[Probe], powers: Sequence[int], sizes: Array) -> tuple[Array, NDArray[np.bool_]]:
    """The integral of a power of each probe over its intervals on panels common to all; whether it has settled."""
    if not probes:
        return np.empty(0), np.empty(0, bool)
    run, nodes, length = probes[0].run, [probe.node for probe in probes], probes[0].length()

    def integrals(lows: Array, highs: Array) -> Array:
        """On each panel: (probes, panels)."""
        parts = []
        for first in range(0, lows.size, TIMES // POINTS):
            some = slice(first, first + TIMES // POINTS)
            t, weight = panel_points(lows[some], highs[some], POINTS)
            height = _values(run, nodes, t) ** np.array(powers)[:, None] * weight
            parts.append(height.reshape(len(nodes), -1, POINTS).sum(axis=2))
        return np.concatenate(parts, axis=1)

    lows, highs = _panels(probes)
    here, total = integrals(lows, highs), np.zeros(len(probes))
    for _ in range(HALVED):
        middle = (lows + highs) / 2
        halves = integrals(np.append(lows, middle), np.append(middle, highs))
        sums = halves[:, : lows.size] + halves[:, lows.size :]
        size = total + sums.sum(axis=1)
        # Values v off by e put the integral of their squares off by no more than 2 e sqrt(length * integral).
        enough = np.maximum(CLOSE * size, 2 * LITTLE * sizes * np.sqrt(length * np.maximum(size, 0.0)))
        off = np.abs(sums - here) > enough[:, None]
        stands = ~off.any(axis=0)
        total += sums[:, stands].sum(axis=1)
        more = np.tile(~stands, 2)
        lows, highs, here = np.append(lows, middle)[more], np.append(middle, highs)[more], halves[:, more]
        if not 0 < 4 * lows.size * len(nodes) <= MOST:
            break
    return total + here.sum(axis=1), ~off.any(axis=1)


def _panels(probes: Sequence[Probe]) -> tuple[Array, Array]:
    """The ends of the first panels of all intervals: equal parts, and ends at all cuts and narrow places."""
    probe, run = probes[0], probes[0].run
    every = {id(one): one for one in (probe.pieces for probe in probes)}.values()
    parts = [np.concatenate([(one.before + one.after) / 2, one.more]) for one in every]
    places = np.unique(np.concatenate([run.breaks, *parts]))
    lows, highs = [], []
    for a, b in probe.intervals:
        count = max(FEWEST, int(np.ceil(run.grid // 4 * (b - a) / (run.stop - run.start))))
        edges = np.union1d(np.linspace(a, b, count + 1), places[(a < places) & (places < b)])
        lows.append(edges[:-1])
        highs.append(edges[1:])
    return np.concatenate(lows), np.concatenate(highs)


def _values(run: Run, nodes: Sequence[Node], t: Array) -> Array:
    """Expressions at times: (nodes, times)."""
    names = run.signals_of(nodes)
    rows = {name: [row] for name, row in zip(names, run.possible_rows(names, t), strict=True)}
    return np.array([combined(run.compiled, node, t, rows, 0).d[0] for node in nodes])
