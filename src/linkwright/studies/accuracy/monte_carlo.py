"""Random mechanisms as they may be made: what their deviations do to each measure and signal.

The same work as a sweep's: atoms that any runner performs, to the same bits, and gone on with after an interruption.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import field, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.findings import Finding
from linkwright.kernels.kernel_selection import KernelChoice
from linkwright.measures import BoundMeasure
from linkwright.results import Run
from linkwright.studies.accuracy import intervals
from linkwright.studies.accuracy.contributors import Contributors
from linkwright.studies.accuracy.copula import copula
from linkwright.studies.accuracy.options import AccuracyOptions
from linkwright.studies.accuracy.outcome import MonteCarlo
from linkwright.studies.plans import PLANS
from linkwright.studies.run_context import RunContext
from linkwright.studies.sampling import Performed, choose_kernel, perform
from linkwright.studies.sampling_output import MARKS
from linkwright.studies.shares import wilson

Array = NDArray[np.float64]
PATH = ("studies", "accuracy")


@dataclass
class SampleStatistics:
    """What the random samples say: of ``figures`` by the name of their column, of ``curves`` by the signal's text, as
    :attr:`Curve.sampled` has them. ``state`` are files from which the same study would go on; it took ``seconds`` this
    time."""

    samples: int
    failed: int
    choice: KernelChoice
    figures: dict[str, MonteCarlo] = field(default_factory=dict)
    curves: dict[str, Array] = field(default_factory=dict)
    state: tuple[Path, ...] = ()
    seconds: float = 0.0
    warnings: list[Finding] = field(default_factory=list)


def check_monte_carlo(options: AccuracyOptions, contributors: Contributors) -> Iterator[Finding]:
    """What is wrong with the random samples that are asked for."""
    most = PLANS[options.plan].most
    if options.samples > most:
        data = {"plan": options.plan, "count": f"{options.samples:,}", "limit": f"{most:,}"}
        yield Finding("study.too-many-samples", (*PATH, "samples"), data)
    if options.samples and len(contributors):
        yield from copula(contributors).findings


def monte_carlo(
    nominal: Run, options: AccuracyOptions, site: RunContext, more: tuple[BoundMeasure, ...] = ()
) -> SampleStatistics:
    """Compute the random samples that the options ask for, with ``more`` measures of each.

    Raises :class:`Interrupted`, and :class:`ModelError` where it can't be carried on.
    """
    choice = choose_kernel(nominal, options, more)
    done = perform(nominal, options, choice.kernel, site, more)
    found = SampleStatistics(options.samples, done.failed, choice, state=tuple(done.kept.files), seconds=done.seconds)
    if done.task.figures.columns:
        found.figures = _figures(done)
    if done.task.signals.texts:
        found.curves = _curves(done)
    found.warnings = [*_warnings(done)]
    return found


def _figures(done: Performed) -> dict[str, MonteCarlo]:
    task, samples = done.task, done.kept.samples
    reduced, independent = samples.results(), task.plan.independent
    found = {}
    for i, column in enumerate(task.figures.columns):
        count, mean, sigma, least, largest = (
            reduced["moments"][key][i].item() for key in ("count", "mean", "deviation", "least", "largest")
        )
        shown, share, confidence = done.counted(i), MonteCarlo.coverage, MonteCarlo.confidence
        if samples.rows is not None:
            known = samples.rows[i][np.isfinite(samples.rows[i])]
            interval, kurtosis = intervals.coverage(known, share), intervals.kurtosis(known)
            convergence = intervals.convergence(samples.rows[i], MARKS)
        else:
            every, kurtosis = done.counted(i, whole=True), float(reduced["fourth"]["kurtosis"][i])
            interval = intervals.counted_coverage(every.edges, every.counts, (every.under, every.over), share)
            convergence = np.column_stack([samples.marks, samples.trail[:, 1:, i]])
        found[column.name] = MonteCarlo(
            samples=task.plan.samples,
            failed=task.plan.samples - count,
            mean=mean,
            sigma=sigma,
            least=least,
            largest=largest,
            interval=interval,
            mean_interval=intervals.of_mean(mean, sigma, count, confidence) if independent else None,
            sigma_interval=intervals.of_sigma(sigma, count, kurtosis, confidence) if independent else None,
            convergence=convergence,
            edges=shown.edges,
            counts=shown.counts,
        )
    return found


def _curves(done: Performed) -> dict[str, Array]:
    """Mean deviation from the nominal value, standard deviation, least, largest deviation, count: (5, poses) each."""
    task, moments = done.task, done.kept.signals.results()["moments"]
    p = task.compiled.parameters[:, None]
    nominal = task.signals.values(p, slice(0, task.run.t.size))[:, 0]
    rows = [moments["mean"] - nominal, moments["deviation"], moments["least"] - nominal, moments["largest"] - nominal]
    curves = np.stack([*rows, moments["count"]], axis=1)
    return dict(zip(task.signals.texts, curves, strict=True))


def _warnings(done: Performed) -> Iterator[Finding]:
    """That samples fail, which share of all that might be made it is, and why."""
    if not done.failed:
        return
    plan = done.task.plan
    share = wilson(done.failed, plan.samples)
    value, low, high = (f"{100 * (part or 0.0):.3g}" for part in (share.value, share.low, share.high))
    data = {"count": done.failed, "samples": plan.samples, "share": value, "low": low, "high": high}
    code = "accuracy.samples-fail" if plan.independent else "accuracy.points-fail"
    yield Finding(code, PATH, data, severity="warning")
    yield from (replace(finding, severity="warning") for finding in done.findings())
