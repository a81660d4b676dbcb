"""Many samples of a run at once: expressions of signals on a grid that they share, and at times of each sample's own.

Whatever is asked of a sample is computed in the same way whichever others are asked with it, so that its figures
don't depend on them to the last bit. ``who`` (n,) are the samples that some times ``t`` (n,) belong to.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.language import Node
from linkwright.graph.rows import Named
from linkwright.kernels.combined import combined
from linkwright.kernels.parameter_batch import Varied
from linkwright.model.sampled import Sampled
from linkwright.notation import angles
from linkwright.notation.angles import whole_turns
from linkwright.results.run import Run
from linkwright.results.stationary import Changes, bracketed, changes

Array = NDArray[np.float64]
Who = NDArray[np.intp]
What = Node | Named
"""An expression bound to SI, or a row of the program."""

MOST_TURN = 1.5
"""A sample of which an angle turns further (rad) between two places of the grid can't be made continuous on it."""
TOUCH = 1e-9
"""How far beyond its places a root between them is looked for, over their distance."""


class Bunch:
    """Samples ``p`` (parameters, samples) of a run, on ``steps`` equal steps of its span.

    ``stop`` (samples,) are the ends of their spans (s) where these differ.
    """

    def __init__(
        self, varied: Varied, run: Run, p: Array, steps: int, stop: Array | None = None, kernel: str = "numpy"
    ) -> None:
        self.varied, self.run, self.p, self.steps, self.kernel = varied, run, p, steps, kernel
        self.samples = p.shape[1]
        self.start = run.start
        self.stop = np.full(self.samples, run.stop) if stop is None else stop
        self.shared = stop is None
        share = np.linspace(0.0, 1.0, steps + 1)
        self.t = np.broadcast_to(
            np.linspace(run.start, run.stop, steps + 1)
            if stop is None
            else np.where(share < 1.0, run.start + (stop - run.start)[:, None] * share, stop[:, None]),
            (self.samples, steps + 1),
        )
        rows = dict(zip(varied.graph.parameters, p, strict=True))
        self.quantities = Sampled(
            varied.compiled.quantities, {n: rows[n] for n in rows if n in varied.varying}, self.samples
        )
        self.quantities.parameters |= varied.joins(p)  # type: ignore[arg-type]
        self._rows: dict[Named, tuple[Array, Array]] = {}
        self._angles: dict[Named, Array] = {}
        self._crossed: dict[What, tuple[Who, Array]] = {}
        self.fast = np.zeros(self.samples, dtype=bool)
        """Which samples turn further than :data:`MOST_TURN`: their angles are NaN."""

    # Values.

    def watch(self, what: Sequence[What]) -> None:
        """Look at all signals of some curves on the grid, together."""
        names = [name for name in self.names(what) if name not in self._rows]
        if not names:
            return
        shape = (len(names), 2, self.samples, self.steps + 1)
        if self.shared:
            y = self.varied.evaluate(names, self.p, self.t[0], True, self.kernel).reshape(shape)
        else:
            y = self.varied.signals_at(names, self.p, np.ascontiguousarray(self.t), True, self.kernel)
        for name, (value, rate) in zip(names, y, strict=True):
            if self.varied.graph.wrapped(name):
                value = self._track(name, value, rate)
            self._rows[name] = value, rate

    def on_grid(self, what: What) -> tuple[Array, Array]:
        """A curve and its rate on the grid: (samples, steps + 1) each."""
        self.watch([what])
        own = self.quantities.parameters.items()
        given = {name: value[:, None] if isinstance(value, np.ndarray) else value for name, value in own}
        value, rate = self._combined(what, self.t, self._rows, given, 1)
        return value, rate

    def rates(self, what: What, who: Who, t: Array) -> tuple[Array, Array]:
        """A curve and its rate at times of some samples: (n,) each."""
        value, rate = self._values_at(what, who, t, 1)
        return value, rate

    def all_rates(self, what: Sequence[What], who: Who, t: Array) -> list[tuple[Array, Array]]:
        """The same of several curves, whose signals are computed together."""
        rows, given = self._looked(what, who, t, 1), self._parameters_of(who)
        return [(y[0], y[1]) for y in (self._combined(one, t, rows, given, 1) for one in what)]

    def values(self, what: What, who: Who, t: Array) -> Array:
        """A curve at times of some samples: (n,)."""
        return self._values_at(what, who, t, 0)[0]

    def _values_at(self, what: What, who: Who, t: Array, order: int) -> tuple[Array, ...]:
        if not t.size:
            return (t,) * (order + 1)
        return self._combined(what, t, self._looked([what], who, t, order), self._parameters_of(who), order)

    def _looked(self, what: Sequence[What], who: Who, t: Array, order: int) -> dict[Named, tuple[Array, ...]]:
        """The rows that some curves are made of, at times of some samples."""
        names, rows = self.names(what), dict[Named, tuple[Array, ...]]()
        if names:
            for name, row in zip(names, self._evaluated(names, who, t, bool(order)), strict=True):
                if self.varied.graph.wrapped(name):
                    row[0] += 2 * np.pi * whole_turns(row[0], self._near(name, who, t))
                rows[name] = tuple(row)
        return rows

    def _parameters_of(self, who: Who) -> dict[str, Any]:
        """The parameters of some samples."""
        own = self.quantities.parameters.items()
        return {name: value[who] if isinstance(value, np.ndarray) else value for name, value in own}

    def _evaluated(self, names: Sequence[Named], who: Who, t: Array, rates: bool) -> Array:
        """Rows at times of some samples: (names, 1 or 2, n)."""
        shape = (len(names), 2 if rates else 1, -1)
        if not self._pursued:
            return self.varied.signals_at(names, self.p[:, who], t[:, None], rates, self.kernel).reshape(shape)
        # What is followed from the start is followed once for all samples if they stay together.
        order = np.argsort(who, kind="stable")
        counts = np.bincount(who, minlength=self.samples)
        column = np.empty_like(who)
        column[order] = np.arange(who.size) - np.repeat(np.cumsum(counts) - counts, counts)
        times = np.repeat(self.stop[:, None], counts.max() + 1, axis=1)
        times[who, column] = t
        return self.varied.signals_at(names, self.p, times, rates, self.kernel).reshape(*shape[:2], *times.shape)[
            :, :, who, column
        ]

    @cached_property
    def _pursued(self) -> bool:
        """Whether some of the motion is followed from its start on."""
        compiled = self.run.compiled
        return bool(compiled.structure.higher_groups) or bool(compiled.graph.actions.turning)

    def names(self, what: Sequence[What]) -> list[Named]:
        """The rows that some curves are made of."""
        trees = [one for one in what if not isinstance(one, Named)]
        return list(dict.fromkeys([*(one for one in what if isinstance(one, Named)), *self.run.signals_of(trees)]))

    def _combined(
        self, what: What, t: Array, rows: Mapping[Any, tuple[Array, ...]], given: Mapping[str, Any], order: int
    ) -> tuple[Array, ...]:
        return rows[what] if isinstance(what, Named) else combined(self.run.compiled, what, t, rows, order, given).d

    # Continuous angles.

    def _track(self, name: Named, angle: Array, rate: Array) -> Array:
        """An angle on the grid without jumps from its value at the start; NaN of a sample that turns too fast."""
        turned, _ = angles.steps(self.t, angle, rate)
        near = np.concatenate([angle[:, :1], angle[:, :1] + np.cumsum(turned, axis=1)], axis=1)
        fast = np.abs(rate).max(axis=1) * (self.stop - self.start) > MOST_TURN * self.steps
        self.fast |= fast
        self._angles[name] = np.where(fast[:, None], np.nan, near)
        return np.asarray(angle + 2 * np.pi * whole_turns(angle, self._angles[name]))

    def _near(self, name: Named, who: Who, t: Array) -> Array:
        """A continuous angle between the places of the grid."""
        self.watch([name])
        at = (t - self.start) / (self.stop[who] - self.start) * self.steps
        i = np.clip(np.nan_to_num(at).astype(int), 0, self.steps - 1)
        near = self._angles[name]
        a, b = near[who, i], near[who, i + 1]
        return np.asarray(a + (b - a) * (at - i))

    # Where something happens.

    def turning(self, what: What, found: Changes, some: NDArray[np.bool_] | slice = slice(None)) -> tuple[Who, Array]:
        """Samples and times at which a curve turns, from changes of its rate's sign, or some of them."""
        who, i, j = found.who[some], found.before[some], found.after[some]
        value, rate = self.on_grid(what)
        width = self.t[who, j] - self.t[who, i]
        first = _turn(value[who, j] - value[who, i], width * rate[who, i], width * rate[who, j])
        return who, self._roots(lambda t, row: self.rates(what, row, t)[1], who, i, j, first)

    def crossings(self, what: What, f: Callable[[Array, Who | None], Array] | None = None) -> tuple[Who, Array]:
        """Samples and times at which a curve changes sign, or ``f(values, samples)`` of it; of the whole grid where
        the samples are None."""
        if f is None:
            if what not in self._crossed:  # several means ask for the same kinks
                self._crossed[what] = self.crossings(what, lambda values, _: values)
            return self._crossed[what]
        found = changes(f(self.on_grid(what)[0], None))
        who = found.who
        return who, self._roots(lambda t, row: f(self.values(what, row, t), row), who, found.before, found.after)

    def _roots(
        self, f: Callable[[Array, Who], Array], who: Who, before: Who, after: Who, first: Array | float = 0.5
    ) -> Array:
        """Roots between places of the grid, and a touch further: a jump at a place may lie on either side of it."""
        low, high = self.t[who, before], self.t[who, after]
        touch = TOUCH * (high - low)
        low, high = np.maximum(low - touch, self.start), np.minimum(high + touch, self.stop[who])
        return bracketed(f, who, low, high, first) if who.size else low

    @cached_property
    def length(self) -> Array:
        """How long each sample's run lasts (s)."""
        return self.stop - self.start


def _turn(rise: Array, before: Array, after: Array) -> Array:
    """Where the cubic that rises so over a bracket of width 1, with these slopes at its ends, turns."""
    a, b = 3 * (before + after - 2 * rise), 6 * rise - 4 * before - 2 * after
    with np.errstate(all="ignore"):
        return np.asarray(2 * before / (np.copysign(np.sqrt(b * b - 4 * a * before), before) - b))
