"""Where results go: folded into figures, or to several sinks at once."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from linkwright.blocks.checkpoint import Checkpoint
from linkwright.blocks.reductions import Reduction, part
from linkwright.blocks.work import Arrays, Cut, Sink


class Folding:
    """Folds the states that atoms give (those of :class:`~linkwright.blocks.reductions.Tallies`), unit after unit.

    With a checkpoint it goes on where that one stands; without, it starts at the first atom and saves nothing. The
    checkpoint's key must tell of the reductions too. Their names have no points.
    """

    def __init__(self, cut: Cut, reductions: Mapping[str, Reduction], checkpoint: Checkpoint | None = None) -> None:
        self.next = 0
        self._cut, self._reductions, self._checkpoint = cut, dict(reductions), checkpoint
        self._states: dict[int, Arrays] = {}
        if checkpoint is not None and (saved := checkpoint.read()) is not None:
            self.next = saved.next
            self._states = {r: part(saved.arrays, str(r)) for r in range(min(cut.ranges, saved.next))}

    def take(self, atom: int, result: Arrays) -> None:
        """Fold in the states of atom ``next``; what else there is in the result is passed over."""
        r = self._cut.range(atom)
        if self._cut.unit(atom) == 0:
            self._states[r] = {k: v for n in self._reductions for k, v in result.items() if k.startswith(f"{n}.")}
        else:
            self._states[r] = {
                f"{name}.{key}": value
                for name, reduction in self._reductions.items()
                for key, value in reduction.fold(part(self._states[r], name), part(result, name)).items()
            }
        self.next = atom + 1

    def save(self) -> None:
        """Write the checkpoint."""
        if self._checkpoint is not None:
            flat = {f"{r}.{key}": value for r, state in self._states.items() for key, value in state.items()}
            self._checkpoint.write(self.next, flat)

    def results(self) -> dict[str, Arrays]:
        """The figures of each reduction over what was taken, all poses on the last axis.

        Raises :class:`ValueError` before the first unit is done.
        """
        if len(self._states) < self._cut.ranges or not self._states:
            raise ValueError("there are poses without a sample yet")
        results: dict[str, Arrays] = {}
        for name, reduction in self._reductions.items():
            parts = [reduction.result(part(self._states[r], name)) for r in range(self._cut.ranges)]
            results[name] = {key: np.concatenate([p[key] for p in parts], axis=-1) for key in parts[0]}
        return results


class Together:
    """Several sinks of one study; each goes on where it stands."""

    def __init__(self, sinks: Sequence[Sink]) -> None:
        self._sinks = tuple(sinks)

    @property
    def next(self) -> int:
        """The first atom that one of them lacks."""
        return min(sink.next for sink in self._sinks)

    def take(self, atom: int, result: Arrays) -> None:
        """Hand the result to those that lack it."""
        for sink in self._sinks:
            if sink.next == atom:
                sink.take(atom, result)

    def save(self) -> None:
        """Save all."""
        for sink in self._sinks:
            sink.save()
