"""Histograms of each output at each pose, over samples."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from linkwright.blocks.reductions import Array
from linkwright.blocks.work import Arrays
from linkwright.data_classes import dataclass


@dataclass(frozen=True)
class Histogram:
    """Counts between fixed ``edges``, a rising row for each output.

    A value counts in the bin whose lower edge it isn't below and whose upper edge it is below; the last bin has its
    upper edge too. Figures: ``counts`` (outputs, bins, poses); ``under``, ``over`` and ``missing`` (outputs, poses).
    """

    edges: Sequence[Sequence[float]]

    def __post_init__(self) -> None:
        edges = np.array(self.edges, dtype=np.float64)
        if edges.ndim != 2 or edges.shape[1] < 2 or not (np.diff(edges) > 0).all() or not np.isfinite(edges).all():
            raise ValueError("a histogram has for each output the same number of rising, finite edges")
        object.__setattr__(self, "edges", tuple(map(tuple, edges.tolist())))

    def tally(self, outputs: int, poses: int) -> HistogramTally:
        """A fresh tally."""
        edges = np.array(self.edges)
        if len(edges) != outputs:
            raise ValueError(f"{outputs} outputs, but edges for {len(edges)}")
        return HistogramTally(edges, poses)

    def fold(self, state: Arrays, later: Arrays) -> Arrays:
        """The state of both."""
        return {key: value + later[key] for key, value in state.items()}

    def result(self, state: Arrays) -> Arrays:
        """The figures."""
        slots = state["slots"]
        return {"counts": slots[:, 1:-1], "under": slots[:, 0], "over": slots[:, -1], "missing": state["missing"]}


class HistogramTally:
    """Counts of one atom: slot 0 lies below the edges, the last one above them."""

    def __init__(self, edges: Array, poses: int) -> None:
        self._edges = edges
        self._inner = edges.copy()  # with the last edge just above its value, which then counts in the last bin
        self._inner[:, -1] = np.nextafter(edges[:, -1], np.inf)
        self.slots = np.zeros((len(edges), edges.shape[1] + 1, poses), np.int64)
        self.missing = np.zeros((len(edges), poses), np.int64)

    def add(self, y: Array, first: int) -> None:
        """Count in ``y`` (outputs, samples, poses)."""
        slots, poses = self.slots.shape[1:]
        pose = np.arange(poses)
        for output, (values, edges) in enumerate(zip(y, self._inner, strict=True)):
            finite = np.isfinite(values)
            place = np.searchsorted(edges, values, side="right") * poses + pose
            self.slots[output] += np.bincount(place[finite], minlength=slots * poses).reshape(slots, poses)
            self.missing[output] += (~finite).sum(axis=0)

    def state(self) -> Arrays:
        """What was counted."""
        return {"slots": self.slots, "missing": self.missing}
