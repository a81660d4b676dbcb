"""What clearances do to measures: the resting joints' deviation carried to each figure, and its bound."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.language import parse
from linkwright.findings import Finding, Term
from linkwright.measures import bound
from linkwright.model.mechanism import Measure
from linkwright.results import Run
from linkwright.results.windows import intervals
from linkwright.studies.accuracy.clearance import PATH, Plays
from linkwright.studies.accuracy.derivatives import Derivatives
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
            bounds = BOUNDS[known[name].reduction](plays, moved, name)
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
    if measure.reduction not in BOUNDS:
        return Term("play-reduction")
    if not plays.fits([*bound(quantities, name).values(), *edges]):
        return Term("play-no-position")
    if measure.reduction in ("mean", "rms") and edges:
        still = plays.gaps.at(edges, plays.run.t, rates=False).slope
        return Term("play-window") if still.any() else None
    return None


def _at_place(plays: Plays, moved: Derivatives, name: str) -> list[Array]:
    """The bound of each joint for values at places: directions are held while the place is looked for."""
    return [plays.gaps.worst(figure.sides).max(axis=1) for figure in moved.of(name)]


def _of_span(plays: Plays, moved: Derivatives, name: str) -> list[Array]:
    """The directions at the two extremes are free of each other."""
    window = plays.compiled.mechanism.measures[name].window
    low, high = (plays.gaps.worst(moved.extreme(name, window, sign).sides).max(axis=1) for sign in (-1.0, 1.0))
    return [low + high]


def _of_mean(plays: Plays, moved: Derivatives, name: str) -> list[Array]:
    """The directions are free at each time."""
    measure = plays.compiled.mechanism.measures[name]
    power = {"mean": 1, "rms": 2}[measure.reduction]
    total, size, length = np.zeros(len(plays.held)), 0.0, 0.0
    for a, b in intervals(plays.run, measure.window):
        t, weight = plays.panels(a, b)
        here = plays.gaps.at([moved.trees[name]], t, rates=False)
        total += plays.gaps.worst(here.slope[0]) * np.abs(here.value[0]) ** (power - 1) @ weight
        size, length = size + float(here.value[0] ** 2 @ weight), length + b - a
    return [total / (length if power == 1 else np.sqrt(size * length))]


BOUNDS: dict[str, Callable[[Plays, Derivatives, str], list[Array]]] = {
    **dict.fromkeys(("max", "min", "extremes", "value"), _at_place),
    "span": _of_span,
    "mean": _of_mean,
    "rms": _of_mean,
}
"""The bound of each reduction that has one."""
