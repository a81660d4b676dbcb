"""The accuracy study as plain data in the file's units: what ``summary.json`` says of it."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.units import FORCE, LENGTH, TIME
from linkwright.findings import Said
from linkwright.presentation.json_numbers import known, listed
from linkwright.studies.accuracy.contributors import Contributor
from linkwright.studies.accuracy.design_report import allocation_entry, calibration_entry
from linkwright.studies.accuracy.disagreement import along, disagreement
from linkwright.studies.accuracy.outcome import (
    AccuracyOutcome,
    JointPlay,
    MonteCarlo,
    OutputDeviations,
    PlayEffect,
    SearchedWorstCase,
    SignalDeviations,
)
from linkwright.studies.figures import per

Array = NDArray[np.float64]

WIDE = 3
"""RSS limits lie so many standard deviations from the mean."""


def accuracy_entry(outcome: AccuracyOutcome) -> dict[str, Any]:
    """The outputs by name under ``accuracy``, all that isn't of a single one under ``accuracy_study``."""
    outputs = {name: _output(figure, outcome) for name, figure in outcome.figures.items()}
    outputs |= {text: _curve(curve, outcome) for text, curve in outcome.curves.items()}
    return {"accuracy": outputs, "accuracy_study": study_entry(outcome)}


def ranked(figure: OutputDeviations) -> list[int]:
    """The contributors of a figure, the one with the largest share first."""
    return [int(i) for i in np.argsort(-np.nan_to_num(figure.shares), kind="stable")]


def part(figure: OutputDeviations, index: int, contributor: Contributor) -> tuple[float, float]:
    """What one contributor alone does to a figure at its limit deviations, to first order: least and largest."""
    below, above = figure.coefficients[index]
    ends = [d * (below if d < 0 else above) for d in (contributor.low, contributor.high)]
    if contributor.low < 0 < contributor.high:
        ends.append(0.0)
    return min(ends), max(ends)


def _output(figure: OutputDeviations, outcome: AccuracyOutcome) -> dict[str, Any]:
    """One figure; limits are those of the output itself, deviations those from its nominal value."""
    size, quantities = figure.column.size, outcome.compiled.quantities
    time_unit, second = quantities.unit_of(TIME)
    low, high = figure.worst
    middle, wide = figure.nominal + figure.mean, WIDE * figure.sigma
    entry: dict[str, Any] = {
        "nominal": known(figure.nominal / size),
        "unit": figure.column.unit,
        "at": None if figure.time is None else figure.time / second,
        "at_unit": time_unit,
        "tie": figure.tie,
        "worst_case": {
            "low": known((figure.nominal + low) / size),
            "high": known((figure.nominal + high) / size),
            "deviation": [known(low / size), known(high / size)],
            "searched": None if figure.searched is None else _searched(figure.searched, figure, outcome),
        },
        "rss": {
            "mean": known(middle / size),
            "sigma": known(figure.sigma / size),
            "low": known((middle - wide) / size),
            "high": known((middle + wide) / size),
        },
        "monte_carlo": None if figure.monte_carlo is None else _monte_carlo(figure.monte_carlo, size),
        "play": None if figure.play is None else _play(figure.play, figure),
        "contributors": [_contribution(figure, i, outcome) for i in ranked(figure)],
    }
    parted = disagreement(figure, outcome)
    sentence = parted and parted.sentence(figure.title)
    return entry | {"disagreement": parted and {**parted.as_dict(), "sentence": sentence}}


def _curve(curve: SignalDeviations, outcome: AccuracyOutcome) -> dict[str, Any]:
    """A signal: its figure at the widest pose, those at named positions, and how many poses are far from linear."""
    entry = _output(curve.figure, outcome)
    entry["positions"] = {name: _output(figure, outcome) for name, figure in curve.positions.items()}
    parted = along(curve, outcome)
    return entry | {"poses": curve.t.size, "poses_parted": int(parted.sum())}


def _searched(found: SearchedWorstCase, figure: OutputDeviations, outcome: AccuracyOutcome) -> dict[str, Any]:
    size = figure.column.size
    at = {
        end: {c.name: known(float(d) / c.size) for c, d in zip(outcome.contributors.every, where, strict=True)}
        for end, where in (("low_at", found.low_at), ("high_at", found.high_at))
    }
    return {
        "low": known((figure.nominal + found.low) / size),
        "high": known((figure.nominal + found.high) / size),
        "off": known(found.off),
        "proven": found.proven,
        **at,
    }


def _monte_carlo(found: MonteCarlo, size: float) -> dict[str, Any]:
    def both(ends: tuple[float, float] | None) -> list[float | None] | None:
        return None if ends is None else [known(end / size) for end in ends]

    return {
        "samples": found.samples,
        "failed": found.failed,
        "mean": known(found.mean / size),
        "sigma": known(found.sigma / size),
        "min": known(found.least / size),
        "max": known(found.largest / size),
        "interval": both(found.interval),
        "coverage": found.coverage,
        "mean_interval": both(found.mean_interval),
        "sigma_interval": both(found.sigma_interval),
        "confidence": found.confidence,
        "convergence": [
            {"samples": int(count), "mean": known(mean / size), "sigma": known(sigma / size)}
            for count, mean, sigma in found.convergence.tolist()
        ],
        "histogram": {"edges": listed(found.edges / size), "counts": found.counts.tolist()},
    }


def _play(found: PlayEffect, figure: OutputDeviations) -> dict[str, Any]:
    """``low`` and ``high`` are limits of the output with worst tolerances and worst directions of all clearances."""
    size = figure.column.size
    return {
        "shift": known(found.shift / size),
        "bound": known(found.bound / size),
        "low": known((figure.nominal + figure.worst[0] - found.bound) / size),
        "high": known((figure.nominal + figure.worst[1] + found.bound) / size),
        "joints": {
            joint: {"shift": known(shift / size), "bound": known(found.bounds[joint] / size)}
            for joint, shift in found.shifts.items()
        },
    }


def _contribution(figure: OutputDeviations, index: int, outcome: AccuracyOutcome) -> dict[str, Any]:
    contributor, size = outcome.contributors.every[index], figure.column.size
    below, above = (float(c) * contributor.size / size for c in figure.coefficients[index])
    entry: dict[str, Any] = {
        "parameter": contributor.name,
        "coefficient": known((below + above) / 2),
        "unit": per(figure.column.unit, contributor.unit),
    }
    if figure.tie:
        entry["coefficients"] = [known(below), known(above)]
    return entry | {
        "tolerance": _limits(contributor),
        "tolerance_unit": contributor.unit,
        "sigma": known(contributor.sigma / contributor.size),
        "share": known(float(figure.shares[index])),
        "worst": [known(end / size) for end in part(figure, index, contributor)],
    }


def _limits(contributor: Contributor) -> list[float | None]:
    return [known(contributor.low / contributor.size), known(contributor.high / contributor.size)]


def study_entry(outcome: AccuracyOutcome) -> dict[str, Any]:
    """What isn't of a single output."""
    every, correlation = outcome.contributors.every, outcome.contributors.correlation
    pairs = np.argwhere(np.triu(correlation, 1)).tolist()
    return {
        "samples": outcome.samples,
        "failed": outcome.failed,
        "failed_share": outcome.failed / outcome.samples if outcome.samples else None,
        "kernel": outcome.kernel,
        "contributors": {one.name: _contributor_entry(one) for one in every},
        "correlations": [{"of": [every[i].name, every[j].name], "is": float(correlation[i, j])} for i, j in pairs],
        "joints": [_joint(joint, outcome) for joint in outcome.joints],
        "allocation": allocation_entry(outcome.allocation),
        "calibration": calibration_entry(outcome.calibration),
    }


def _contributor_entry(contributor: Contributor) -> dict[str, Any]:
    return {
        "stated": contributor.stated,
        "nominal": known(contributor.nominal / contributor.size),
        "unit": contributor.unit,
        "tolerance": _limits(contributor),
        "distribution": contributor.distribution,
        "mean": known(contributor.mean / contributor.size),
        "sigma": known(contributor.sigma / contributor.size),
    }


def _joint(joint: JointPlay, outcome: AccuracyOutcome) -> dict[str, Any]:
    quantities = outcome.compiled.quantities
    (length, metre), (force, newton), (time, second) = map(quantities.unit_of, (LENGTH, FORCE, TIME))
    return {
        "joint": joint.joint,
        "links": list(joint.links),
        "clearance": known(joint.clearance / metre),
        "unit": length,
        "reaction_min": known(float(np.fmin.reduce(joint.reaction)) / newton),
        "reaction_max": known(float(np.fmax.reduce(joint.reaction)) / newton),
        "reaction_unit": force,
        "contact_lost": [
            {"from": start / second, "to": end / second, "unit": time, "cause": Said(cause)}
            for start, end, cause in dict.fromkeys(joint.lost)  # both ends of a guide may lose it at once
        ],
    }
