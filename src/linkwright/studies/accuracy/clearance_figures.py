"""What clearances do to measures: the resting joints' deviation carried to each figure, and its bound."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.language import parse
from linkwright.findings import Finding, Term
from linkwright.measures import bound
from linkwright.reductions import Measure, kind_of
from linkwright.results import Run
from linkwright.studies.accuracy.clearance import PATH, Plays
from linkwright.studies.accuracy.derivatives import Derivatives, Deviated
from linkwright.studies.accuracy.options import AccuracyOptions
from linkwright.studies.accuracy.outcome import AccuracyOutcome, Figure, PlayEffect

Array = NDArray[np.float64]
Effects = dict[tuple[str, str], PlayEffect]


def state_plays(outcome: AccuracyOutcome, run: Run, options: AccuracyOptions, every: Mapping[str, Figure]) -> None:
    """Give figures of measures of ``run``, and an outcome's curves and joints, what the clearances do to them.

    Those whose measure isn't in the outcome's file stand for signals, which are warned of once.
    """
    if not options.clearances:
        return
    plays = Plays(run.compiled, run, options)
    effects, lacking = play_effects(plays, [*dict.fromkeys(figure.column.measure for figure in every.values())])
    for figure in every.values():
        figure.play = effects.get((figure.column.measure, figure.column.label))
    lacking = {name: why for name, why in lacking.items() if name in outcome.compiled.mechanism.measures}
    for text, curve in outcome.curves.items():
        tree = run.compiled.quantities.dimensions.bind(parse(text), None)
        if plays.fits([tree]):
            curve.play = plays.curve(tree, curve.t)
        else:
            lacking[text] = Term("play-no-position")
    outcome.joints = plays.joints()
    outcome.warnings += [*plays.warnings, *unaffected(lacking)]


def play_effects(plays: Plays, names: Sequence[str]) -> tuple[Effects, dict[str, Term]]:
    """The effects on measures that have a value, by name and label; why the others have none, by name."""
    known, found = plays.compiled.mechanism.measures, Effects()
    lacking = {name: why for name in names if (why := _lacks(plays, name, known[name]))}
    fitting = [name for name in names if name not in lacking]
    if fitting and plays.held:
        rested, moved = (Derivatives(plays.run, slopes, fitting) for slopes in (plays.resting, plays.gaps))
        for name in fitting:
            bounds = kind_of(known[name]).bound(Played(plays, moved.deviated(name)))
            for shift, worst in zip(rested.of(name), bounds, strict=True):
                shifts = shift.sides[:, 1]  # a place also moves as directions turn, which no held one shows
                found[name, shift.label] = plays.effect(shifts, np.maximum(worst, np.abs(shifts[1:])))
    return found, lacking


def unaffected(lacking: Mapping[str, Term]) -> list[Finding]:
    """Warnings that say for what there is no effect, one for each reason."""
    reasons: dict[Term, list[str]] = {}
    for name, why in lacking.items():
        reasons.setdefault(why, []).append(name)
    return [
        Finding("clearance.no-figure", PATH, {"names": ", ".join(names), "why": why}, severity="warning")
        for why, names in reasons.items()
    ]


def _lacks(plays: Plays, name: str, measure: Measure) -> Term | None:
    """Why a measure has no effect to state."""
    quantities, window = plays.compiled.quantities, plays.compiled.mechanism.windows.get(measure.window or "")
    edges = [] if window is None or isinstance(window, tuple) else [parse(text) for text in window]
    edges = [quantities.dimensions.bind(edge, None) for edge in edges]
    kind = kind_of(measure)
    if not kind.bounded:
        return Term("play-reduction")
    if not plays.fits([*bound(quantities, name).values(), *edges]):
        return Term("play-no-position")
    if kind.still and edges:
        still = plays.gaps.at(edges, plays.run.t, rates=False).slope
        return Term("play-window") if still.any() else None
    return None


@dataclass(frozen=True)
class Played:
    """One measure, as :class:`~linkwright.reductions.WithPlay` has it."""

    plays: Plays
    moved: Deviated

    @property
    def joints(self) -> int:
        """The number of joints with clearance."""
        return len(self.plays.held)

    def worst(self, slopes: Array) -> Array:
        """The most that each joint does over all directions."""
        return self.plays.gaps.worst(slopes)

    def panels(self, a: float, b: float) -> tuple[Array, Array]:
        """Times and weights of quadrature."""
        return self.plays.panels(a, b)
