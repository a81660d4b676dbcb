"""What clearances do to measures: the resting joints' deviation carried to each figure, and its bound."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions.language import parse
from linkwright.findings import Finding, Joined, Term
from linkwright.measures import BoundMeasure
from linkwright.studies.accuracy.clearance import PATH, Plays
from linkwright.studies.accuracy.derivatives import Derivatives, Deviated
from linkwright.studies.accuracy.options import AccuracyOptions
from linkwright.studies.accuracy.outcome import AccuracyOutcome, OutputDeviations, PlayEffect

Array = NDArray[np.float64]
Effects = dict[tuple[str, str], PlayEffect]


def state_plays(
    outcome: AccuracyOutcome,
    options: AccuracyOptions,
    measures: Sequence[BoundMeasure],
    every: Mapping[str, OutputDeviations],
) -> None:
    """Give figures of measures, and an outcome's curves and joints, what the clearances do to them.

    Those whose measure isn't in the file stand for signals, which are warned of once.
    """
    if not options.clearances:
        return
    run = outcome.run
    plays, valued = Plays(run.compiled, run, options), {figure.column.measure for figure in every.values()}
    effects, lacking = play_effects(plays, [measure for measure in measures if measure.name in valued])
    for figure in every.values():
        figure.play = effects.get((figure.column.measure, figure.column.label))
    lacking = {name: why for name, why in lacking.items() if name in run.compiled.mechanism.measures}
    for text, curve in outcome.curves.items():
        tree = run.compiled.quantities.dimensions.bind(parse(text), None)
        if plays.fits([tree]):
            curve.play = plays.curve(tree, curve.t)
        else:
            lacking[text] = Term("play-no-position")
    outcome.joints = plays.joints()
    outcome.warnings += [*plays.warnings, *unaffected(lacking)]


def play_effects(plays: Plays, measures: Sequence[BoundMeasure]) -> tuple[Effects, dict[str, Term]]:
    """The effects on measures that have a value, by name and label; why the others have none, by name."""
    lacking = {measure.name: why for measure in measures if (why := _lacks(plays, measure))}
    fitting, found = [measure for measure in measures if measure.name not in lacking], Effects()
    if fitting and plays.held:
        rested, moved = (Derivatives(plays.run, slopes, fitting) for slopes in (plays.resting, plays.gaps))
        for measure in fitting:
            bounds = measure.kind.clearance_bounds(Played(plays, moved.deviated(measure.name)))
            for shift, worst in zip(rested.of(measure.name), bounds, strict=True):
                shifts = shift.sides[:, 1]  # a place also moves as directions turn, which no held one shows
                found[measure.name, shift.label] = plays.effect(shifts, np.maximum(worst, np.abs(shifts[1:])))
    return found, lacking


def unaffected(lacking: Mapping[str, Term]) -> list[Finding]:
    """Warnings that say for what there is no effect, one for each reason."""
    reasons: dict[Term, list[str]] = {}
    for name, why in lacking.items():
        reasons.setdefault(why, []).append(name)
    return [
        Finding("clearance.no-figure", PATH, {"names": Joined(names), "why": why}, severity="warning")
        for why, names in reasons.items()
    ]


def _lacks(plays: Plays, measure: BoundMeasure) -> Term | None:
    """Why a measure has no effect to state."""
    if not measure.kind.bounded:
        return Term("play-reduction")
    if not plays.fits(measure.nodes):
        return Term("play-no-position")
    edges = measure.window.nodes if measure.window is not None else []
    if measure.kind.still and edges:
        still = plays.gaps.at(edges, plays.run.t, rates=False).slope
        return Term("play-window") if still.any() else None
    return None


@dataclass(frozen=True)
class Played:
    """One measure, as :class:`~linkwright.reductions.WithPlay` has it."""

    plays: Plays
    deviations: Deviated

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
