"""Where the figures of samples go: a row a sample while these are few, statistics over all of them."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from linkwright.blocks import Checkpoint, Cut, Reduction, Tallies
from linkwright.blocks.reductions import part
from linkwright.blocks.work import UNIT, Arrays
from linkwright.studies.sampling_task import FINE

Array = NDArray[np.float64]

FOLDED = "folded"
MARKS = 12
"""How often it is noted how far figures have settled."""


class Samples:
    """Takes what atoms say of whole samples, unit after unit: figures and verdicts folded, and kept where ``table``.

    ``rows`` (figures and verdicts, samples) holds them, ``cause`` and ``since`` (samples,) say which lack a value, why,
    since when (:class:`~linkwright.studies.sampling_task.SampleTask`). ``failed`` (causes, 3) says of each cause, the
    last being none, how many samples it has, which the first of them is, and since when that one lacks a value.
    ``trail`` (marks, 3, rows) are count, mean and deviation after the ``marks`` first samples, where no rows are kept.
    """

    def __init__(
        self,
        cut: Cut,
        rows: int,
        causes: int,
        reductions: Mapping[str, Reduction],
        table: bool,
        checkpoint: Checkpoint | None = None,
    ) -> None:
        self.next = 0
        self.failed = np.zeros((causes + 1, 3))
        self._cut, self._reductions, self._checkpoint = cut, dict(reductions), checkpoint
        self.rows = np.full((rows, cut.samples), np.nan) if table else None
        kept = cut.samples if table else 0
        self.cause, self.since = np.full(kept, FINE), np.full(kept, np.nan)
        units = np.empty(0) if table else np.geomspace(1, max(cut.units, 1), MARKS).round()
        self.marks = np.minimum(np.unique(units).astype(np.int64) * UNIT, cut.samples)
        self.trail = np.full((self.marks.size, 3, rows), np.nan)
        self._state: Arrays = {}
        self._unit: Arrays = {}
        if checkpoint is not None and (saved := checkpoint.read()) is not None:
            self.next = saved.next
            self._restore(saved.arrays)

    def _restore(self, arrays: Arrays) -> None:
        self._state = part(arrays, FOLDED)
        self.failed, self.trail = arrays["failed"], arrays["trail"]
        if self.rows is not None:
            done = slice(arrays["rows"].shape[1])
            self.rows[:, done], self.cause[done], self.since[done] = (arrays[k] for k in ("rows", "cause", "since"))

    @property
    def _complete_samples(self) -> int:
        """The samples of whole units."""
        return min(self.next // self._cut.ranges * UNIT, self._cut.samples)

    def take(self, atom: int, result: Arrays) -> None:
        """Take the result of atom ``next``; the last one of a unit completes it."""
        if self._cut.range(atom) == 0:
            self._unit = {key: result[key] for key in ("figures", "verdicts", "cause", "since")}
        else:
            fine = self._unit["cause"] == FINE
            self._unit |= {key: np.where(fine, result[key], self._unit[key]) for key in ("cause", "since")}
        if self._cut.range(atom) == self._cut.ranges - 1:
            self._complete(self._cut.sample_slice(atom))
        self.next = atom + 1

    def _complete(self, some: slice) -> None:
        figures, cause, since = (self._unit[key] for key in ("figures", "cause", "since"))
        rows = np.concatenate([figures, self._unit["verdicts"]])
        for k in np.unique(cause[cause != FINE]).tolist():
            count, first, time = self.failed[k]  # no cause, -1, is the last one
            at = int(np.argmax(cause == k))
            first, time = (first, time) if count else (some.start + at, since[at])
            self.failed[k] = count + np.count_nonzero(cause == k), first, time
        if self.rows is not None:
            self.rows[:, some], self.cause[some], self.since[some] = rows, cause, since
        for name, reduction in self._reductions.items():
            values = rows if name == "moments" else figures
            tallies = Tallies({name: reduction}, len(values), 1)
            tallies.add(values[:, :, None], some.start)
            state = part(tallies.state(), name)
            if some.start:
                state = reduction.fold(part(self._state, name), state)
            self._state |= {f"{name}.{key}": value for key, value in state.items()}
        for k in np.flatnonzero(self.marks == some.stop) if self._reductions else ():
            found = self.results()["moments"]
            self.trail[k] = [found[key] for key in ("count", "mean", "deviation")]

    def save(self) -> None:
        """Write the checkpoint: whole units only."""
        if self._checkpoint is None:
            return
        arrays = {f"{FOLDED}.{key}": value for key, value in self._state.items()}
        arrays |= {"failed": self.failed, "trail": self.trail}
        if self.rows is not None:
            done = slice(self._complete_samples)
            arrays |= {"rows": self.rows[:, done], "cause": self.cause[done], "since": self.since[done]}
        self._checkpoint.write(self.next // self._cut.ranges * self._cut.ranges, arrays)

    def results(self) -> dict[str, Arrays]:
        """The figures of each reduction, one for each row."""
        return {
            name: {key: value[..., 0] for key, value in reduction.result(part(self._state, name)).items()}
            for name, reduction in self._reductions.items()
        }
