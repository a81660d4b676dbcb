"""Accuracy outcomes made by hand: of a slider-crank in closed form, so that all figures hang together."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from helpers.compiled import compiled_from
from linkwright.expressions.units import LENGTH
from linkwright.kernels import Compiled
from linkwright.results import Run
from linkwright.studies.accuracy.contributors import Contributor, Contributors
from linkwright.studies.accuracy.options import AccuracyOptions
from linkwright.studies.accuracy.outcome import (
    AccuracyOutcome,
    JointPlay,
    MonteCarlo,
    OutputDeviations,
    PlayEffect,
    SearchedWorstCase,
    SignalDeviations,
)
from linkwright.studies.figures import FigureColumn
from studies.models import TURN, slider_crank

Array = NDArray[np.float64]

MM = 1e-3
NOMINAL = {"r": 50 * MM, "l": 160 * MM, "e": 20 * MM}
LIMITS = {"r": (-0.05, 0.05, "0.05"), "l": (-0.02, 0.08, "[-0.02, 0.08]"), "e": (-0.1, 0.1, "ISO 2768-m")}


def place(angle: Any, r: Any, l: Any, e: Any) -> Any:  # noqa: E741
    """The slider's x and its derivatives by r, l, e: (4, ...)."""
    up = r * np.sin(angle) - e
    root = np.sqrt(l**2 - up**2)
    slopes = (np.cos(angle) - up * np.sin(angle) / root, l / root, up / root)
    return np.stack(np.broadcast_arrays(r * np.cos(angle) + root, *slopes))


def stroke(r: Any, l: Any, e: Any) -> Any:  # noqa: E741
    """The slider's stroke and its derivatives by r, l, e: (4, ...)."""
    out, back = np.sqrt((l + r) ** 2 - e**2), np.sqrt((l - r) ** 2 - e**2)
    slopes = ((l + r) / out + (l - r) / back, (l + r) / out - (l - r) / back, e / back - e / out)
    return np.stack(np.broadcast_arrays(out - back, *slopes))


def contributors(compiled: Compiled) -> Contributors:
    """Three lengths, normal, r and l somewhat alike."""
    order = [*compiled.quantities.parameters]
    every = []
    for name, (low, high, stated) in LIMITS.items():
        mean, sigma = (low + high) / 2 * MM, (high - low) / 6 * MM
        direction = np.array([float(other == name) for other in order])

        def quantile(shares: Array, mean: float = mean, sigma: float = sigma) -> Array:
            raise NotImplementedError

        limits = (low * MM, high * MM, mean, sigma)
        every.append(Contributor(name, direction, NOMINAL[name], *limits, quantile, LENGTH, "mm", MM, stated, "normal"))
    return Contributors(tuple(every), np.array([[1, 0.3, 0], [0.3, 1, 0], [0, 0, 1.0]]))


def samples_of(who: Contributors, count: int) -> Array:
    """(contributors, samples) deviations."""
    rng = np.random.default_rng(7)
    return rng.multivariate_normal(who.mean, who.covariance, count).T


def linear(slopes: Array, who: Contributors) -> dict[str, Any]:
    """Worst case and RSS from derivatives (contributors, ...)."""
    ends = np.stack([np.multiply.outer(end, np.ones(slopes.shape[1:])) * slopes for end in (who.low, who.high)])
    variance = np.einsum("i...,ij,j...->...", slopes, who.covariance, slopes)
    return {
        "worst": np.stack([ends.min(0).sum(0), ends.max(0).sum(0)]),
        "mean": np.tensordot(who.mean, slopes, 1),
        "sigma": np.sqrt(variance),
    }


def figure(
    column: FigureColumn, values: Array, who: Contributors, sampled: Array | None, **more: Any
) -> OutputDeviations:
    """A figure from its value and derivatives (4,) and those of samples."""
    slopes = values[1:]
    made = linear(slopes, who)
    shares = slopes * (who.covariance @ slopes) / made["sigma"] ** 2
    found = None if sampled is None else monte_carlo(sampled)
    return OutputDeviations(
        column,
        float(values[0]),
        more.pop("time", None),
        np.stack([slopes, slopes], axis=1),
        worst=(float(made["worst"][0]), float(made["worst"][1])),
        mean=float(made["mean"]),
        sigma=float(made["sigma"]),
        shares=shares,
        monte_carlo=found,
        **more,
    )


def monte_carlo(values: Array, failed: int = 0) -> MonteCarlo:
    """The figures of samples."""
    n, mean, sigma = values.size, float(values.mean()), float(values.std(ddof=1))
    counts, edges = np.histogram(values, 20)
    steps = [k for k in (100, 200, 500, 1000, 2000) if k <= n]
    low, high = np.quantile(values, [0.00135, 0.99865])
    return MonteCarlo(
        samples=n + failed,
        failed=failed,
        mean=mean,
        sigma=sigma,
        least=float(values.min()),
        largest=float(values.max()),
        interval=(float(low), float(high)),
        mean_interval=(mean - 1.96 * sigma / n**0.5, mean + 1.96 * sigma / n**0.5),
        sigma_interval=(sigma * (1 - 1.96 / (2 * n) ** 0.5), sigma * (1 + 1.96 / (2 * n) ** 0.5)),
        convergence=np.array([[k, values[:k].mean(), values[:k].std(ddof=1)] for k in steps]),
        edges=edges,
        counts=counts.astype(np.int64),
    )


def outcome(count: int = 2000, failed: int = 0, name: str = "C.x", stretch: float = 1.0) -> AccuracyOutcome:
    """The stroke and the signal C.x of a slider-crank over a turn, with all that an outcome may have; ``stretch``
    makes the samples wider than they should be."""
    data = slider_crank(measures={"stroke": {"span": "guide.s"}})
    compiled = compiled_from(data)
    options = AccuracyOptions.model_validate({"outputs": ["stroke", "C.x"]}, context={"cycle": TURN})
    run, who = Run(compiled, 0.0, 1.0, 60), contributors(compiled)
    deviations = stretch * samples_of(who, count) if count else np.zeros((3, 0))
    given = [NOMINAL[key] + row for key, row in zip(NOMINAL, deviations, strict=True)]
    angle = 2 * np.pi * run.t
    values = place(angle, *NOMINAL.values())
    sampled = place(angle, *(row[:, None] for row in given))[0] - values[0]
    made = linear(values[1:], who)
    widest = int(np.argmax(made["worst"][1] - made["worst"][0]))

    def at(pose: int, label: str) -> OutputDeviations:
        column = FigureColumn(label, "", LENGTH, "mm", MM)
        drawn = sampled[:, pose] + values[0, pose] if count else None
        return figure(column, values[:, pose], who, drawn, time=float(run.t[pose]))

    column = FigureColumn("stroke", "", LENGTH, "mm", MM)
    play = PlayEffect(12e-6, 40e-6, {"B": 12e-6}, {"B": 40e-6})
    searched = SearchedWorstCase(-0.2 * MM, 0.25 * MM, who.low, who.high, 0.07, proven=False)
    exact = stroke(*NOMINAL.values())
    drawn = stroke(*given)[0] if count else None
    curve = SignalDeviations(
        name,
        LENGTH,
        "mm",
        MM,
        run.t,
        values[0],
        values[1:],
        made["worst"],
        made["mean"],
        made["sigma"],
        widest,
        positions={"far": at(5, f"{name} at far"), "out": at(30, f"{name} at out")},
        sampled=np.stack([sampled.mean(0), sampled.std(0, ddof=1), sampled.min(0), sampled.max(0), np.full(61, count)])
        if count
        else None,
        play=np.stack([12e-6 * np.sin(angle), np.full(61, 30e-6)]),
    )
    curve.figure = at(widest, name)
    reaction = np.abs(40 * np.cos(angle))
    joint = JointPlay("B", ("crank", "rod"), 20e-6, run.t, reaction, np.zeros((2, 61)), ((0.24, 0.26, "measure.max"),))
    return AccuracyOutcome(
        compiled,
        options,
        run,
        who,
        figures={"stroke": figure(column, exact, who, drawn, searched=searched, play=play)},
        curves={name: curve},
        joints=[joint],
        kernel="numpy" if count else "",
        samples=count + failed,
        failed=failed,
    )
