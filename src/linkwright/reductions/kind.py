"""What a reduction of measures is: the contract that runs, many samples, tolerances, clearances and proofs ask.

A kind is one registered, stateless object with the entry that files give it. It says how its figures follow from what a
signal does: in one run, in many samples at once, by deviations, with play in joints. What it asks of these comes in
through the protocols of ``asked.py``, so that a kind knows nothing of graphs and kernels. Only the figures of one run
are a must.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from linkwright.notation.registry import Registry
from linkwright.reductions.derivative import Derivative
from linkwright.reductions.entry import ENTRIES, MODULES, Measure
from linkwright.reductions.figures import Figures, FoundFigure
from linkwright.reductions.protocols import InRun, InSamples, WithDeviations, WithPlay
from linkwright.reductions.samples import OnSamples, SampledFigures, SampledInputs
from linkwright.words import add

Array = NDArray[np.float64]


class MeasureKind(ABC):
    """A reduction; stateless."""

    entry: ClassVar[type[Measure]]
    """What a file says of it."""
    labels: ClassVar[tuple[str, ...]] = ("",)
    """The labels of its figures, in their order."""
    everywhere: ClassVar[bool] = True
    """Whether the signal must have a value all over the window."""
    power: ClassVar[int | None] = None
    """The power of the signal whose mean it needs of many samples."""
    averaged: ClassVar[tuple[str, ...]] = ("",)
    """The keys of the expressions ("" for the signal) whose means of this power it needs."""
    proven: ClassVar[tuple[float, ...]] = ()
    """The extremes of the signal that its figures state, 1 for the largest and -1 for the smallest: where intervals
    prove these, they prove the figures."""
    differentiable: ClassVar[bool] = False
    """Whether it gives a :meth:`derivative`; without one the accuracy study refuses it by name."""
    bounded: ClassVar[bool] = False
    """Whether its :meth:`clearance_bounds` holds; without one the effect of clearances on it stays open."""
    still: ClassVar[bool] = False
    """Whether its bound holds only where clearances don't move the window."""
    words: ClassVar[Mapping[str, Mapping[str, str]]] = {}
    """Texts that the catalogue lacks, by language and key; of a label ``measure.LABEL``, of the reduction's
    name ``reduction.NAME`` where it isn't shown as files have it."""

    @property
    def name(self) -> str:
        """As files have it."""
        return self.entry.reduction

    @abstractmethod
    def run_figures(self, run: InRun) -> tuple[FoundFigure, ...]:
        """The figures of a run, in the order of the labels. Raises :class:`Unmeasured` where there are none."""

    def needed_extremes(self, measure: Any) -> Sequence[tuple[str, float]] | None:
        """The extremes that :meth:`figures` asks for: key of the expression ("" for the signal) and sign. ``None``
        where samples have to be taken one after the other, each in a run of its own."""
        return None

    def figures(self, samples: InSamples) -> dict[str, Figures]:
        """The figures of many samples at once, by label; the same as those of runs, to round-off."""
        raise NotImplementedError

    def sampled_inputs(self, measure: Any) -> SampledInputs | None:
        """What its rule on samples asks of a measure. ``None``: it has no such rule, and pages that compute the motion
        themselves don't show the measure live, as those of other packages."""
        return None

    def sampled(self, samples: OnSamples) -> SampledFigures | None:
        """The figures on samples of a run, by label, by the rule that ``web/src/measures/`` has too; ``None`` where
        there are none."""
        raise NotImplementedError

    def derivative(self, found: WithDeviations) -> list[Derivative]:
        """The derivatives of the figures by the deviations, in the order of the labels."""
        raise NotImplementedError

    def clearance_bounds(self, found: WithPlay) -> list[Array]:
        """By how much each joint's clearance changes the figures at most, to first order: (joints,) each. Unless it
        says more, directions are held while the place is looked for."""
        return [found.worst(figure.sides).max(axis=1) for figure in self.derivative(found.deviations)]

    def beyond(self, reported: Mapping[str, float], low: float, high: float) -> float | None:
        """By how much values that reach from ``low`` to ``high`` contradict reported figures (by label); negative where
        they don't, ``None`` where values can't tell."""
        return None

    def contradiction(self, reported: Mapping[str, float], run: InRun) -> float:
        """By how much a second way to reported figures (by label) contradicts them, over the size of what they are made
        of; it may not be the way of :meth:`run_figures`."""
        return 0.0

    def mean_of(self, figure: float, length: float) -> float | None:
        """The root of the mean of the kind's ``power`` that a figure states of a window of this length (s)."""
        return None


REDUCTIONS: Registry[MeasureKind] = Registry(MODULES)
"""The kinds by their names."""


def register(cls: type[MeasureKind]) -> type[MeasureKind]:
    """Register a reduction under the key of its entry; a second one of the same name is an error."""
    REDUCTIONS[cls.entry.reduction] = cls()
    ENTRIES[cls.entry.reduction] = cls.entry
    for language, texts in cls.words.items():
        add(language, texts)
    return cls


def kind_of(measure: Measure) -> MeasureKind:
    """The reduction of a measure."""
    return REDUCTIONS[measure.reduction]
