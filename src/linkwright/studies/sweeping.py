"""The sweep study: many samples of the parameters carried through a work, and what is made of what comes.

(:mod:`linkwright.studies.sweep` is another thing: one drive moved alone, for the limits.)
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from linkwright.blocks import UNIT, Carried, Threads, carry
from linkwright.blocks.runners import opened
from linkwright.blocks.work import Arrays
from linkwright.kernels import KERNELS, Compiled
from linkwright.kernels.choice import Choice, choose
from linkwright.model.findings import Finding, ModelError
from linkwright.results import Run
from linkwright.studies.cycle import span
from linkwright.studies.feasible import singular, unassembled
from linkwright.studies.measures import bound
from linkwright.studies.registry import register
from linkwright.studies.shares import Share, wilson
from linkwright.studies.site import Site
from linkwright.studies.sweep_kept import ROWS, STORE, Kept
from linkwright.studies.sweep_options import PATH, SweepOptions, check
from linkwright.studies.sweep_outcome import Statistics, SweepOutcome, Table, bands, histogram, widened
from linkwright.studies.sweep_work import FINE, SweepTask, SweepWork, table_files
from linkwright.studies.through import carried
from linkwright.words import say

Array = NDArray[np.float64]

MARGIN = 0.5
"""How far histograms of more samples reach beyond the first unit's figures, in their width."""


class Interrupted(KeyboardInterrupt):
    """A sweep was interrupted; what is finished is saved in ``out`` where there is one."""

    def __init__(self, carried: Carried, out: Path | None) -> None:
        super().__init__()
        self.carried, self.out = carried, out

    @property
    def what(self) -> str:
        """How far it came, and how to go on."""
        key = "sweep.not-kept" if self.out is None else "sweep.go-on"
        return say(
            "sweep.interrupted", atoms=self.carried.atoms, total=self.carried.total, rest=say(key, folder=self.out)
        )


@register
class SweepStudy:
    """Many samples of the parameters."""

    name = "sweep"
    options = SweepOptions

    def check(self, compiled: Compiled, options: SweepOptions) -> list[Finding]:
        """What is wrong with the options."""
        return list(check(compiled, options))

    def run(self, compiled: Compiled, options: SweepOptions, site: Site) -> SweepOutcome:
        """Perform the sweep, going on with an interrupted one in the site's folder.

        Raises :class:`Interrupted`, and :class:`ModelError` where it can't be carried on.
        """
        assert site.document is not None, "a sweep needs the file's document"
        nominal = Run(compiled, 0.0, span(compiled, options.cycle)[0], options.steps)
        choice = chosen(nominal, options)
        if found := _refused(nominal, options):
            return SweepOutcome(
                compiled, options, options.made(compiled), nominal, choice.kernel, choice.reason, failures=found
            )
        files = table_files(compiled.mechanism, site.folder)
        work = SweepWork(site.document, files, choice.kernel)
        task = opened(work)
        assert isinstance(task, SweepTask)
        if task.plan.samples > ROWS and task.figures.columns:
            work = SweepWork(site.document, files, choice.kernel, _reach(task))
            task = opened(work)
            assert isinstance(task, SweepTask)
        kept = Kept.begun(task, work.key, site)
        runner = site.runner or Threads(None if KERNELS[choice.kernel].scales else 1)
        result = carry(work, kept.sink, runner, site.progress)
        if result.error is not None:
            raise ModelError([result.error])
        if result.interrupted:
            raise Interrupted(result, site.out)
        outcome = _outcome(compiled, options, task, kept, choice)
        outcome.poses, outcome.seconds, outcome.state = result.poses, result.seconds, tuple(kept.files)
        return outcome


def _refused(nominal: Run, options: SweepOptions) -> list[Finding]:
    """Why nothing can be compared with the nominal motion: it can't be followed, or meets a change point."""
    found = unassembled(nominal) or singular(nominal)
    if found and options.cycle.through == "keep":
        names = ", ".join(options.vary)
        return carried(nominal)[1] or [Finding("varied.passage", (*PATH, "vary"), {"names": names})]
    return found


def chosen(nominal: Run, options: SweepOptions) -> Choice:
    """The kernel that computes it, and why. That doesn't depend on the runner, which may change no figure."""
    compiled, poses = nominal.compiled, options.made(nominal.compiled).samples * nominal.t.size
    quantities = compiled.quantities
    trees = [quantities.dimensions.bind(signal.node, None) for signal in options.signals(compiled)]
    trees += [tree for name in options.measures(compiled) for tree in bound(quantities, name).values()]
    program = compiled.graph.program(nominal.signals_of(trees), rates=bool(options.measures(compiled)))
    return choose(program, poses, wish=options.kernel)


def _reach(task: SweepTask) -> tuple[tuple[float, float], ...]:
    """The ends of histograms from the figures of the first samples: a function of the file alone."""
    figures, _ = task.figures.of(task.varied.parameters(task.plan.values(0)))
    ends = []
    for row in figures:
        known = row[np.isfinite(row)]
        low, high = (float(known.min()), float(known.max())) if known.size else (0.0, 0.0)
        low, high = widened(low, high)
        ends.append((low - MARGIN * (high - low), high + MARGIN * (high - low)))
    return tuple(ends)


def _outcome(compiled: Compiled, options: SweepOptions, task: SweepTask, kept: Kept, choice: Choice) -> SweepOutcome:
    failed = int(kept.samples.failed[:, 0].sum())
    outcome = SweepOutcome(compiled, options, task.plan, task.run, choice.kernel, choice.reason, failed=failed)
    if task.signals.texts:
        outcome.bands = bands(list(task.signals.texts), compiled, kept.signals.results()["moments"])
    if kept.held is not None:
        outcome.values = kept.held.values
    outcome.store = STORE if kept.stored is not None else None
    rows, figures = kept.samples.rows, len(task.figures.columns)
    if figures:
        reduced = kept.samples.results()
        outcome.measures = _statistics(task, reduced, rows)
        means, counts = (reduced["moments"][key][figures:] for key in ("mean", "count"))
        for name, mean, count in zip(task.figures.required, means, counts, strict=True):
            met = round(float(mean) * int(count))
            outcome.shares[name] = wilson(met, task.plan.samples) if task.plan.independent else Share(met, int(count))
    if rows is not None:
        values = np.concatenate([task.plan.values(unit) for unit in range(task.cut.units)], axis=1)
        lacking = kept.samples.cause != FINE
        outcome.table = Table(values, rows[:figures], rows[figures:] > 0.5, lacking, kept.samples.since)
    found = [*_failures(task, kept.samples.failed)]
    if outcome.failed == outcome.samples:
        outcome.failures = found
    else:
        outcome.warnings = [replace(finding, severity="warning") for finding in found]
    return outcome


def _statistics(task: SweepTask, found: dict[str, Arrays], rows: Array | None) -> list[Statistics]:
    moments = found["moments"]
    made = []
    for i, column in enumerate(task.figures.columns):
        mean, deviation, least, largest = (float(moments[k][i]) for k in ("mean", "deviation", "least", "largest"))
        count, least_at, largest_at = (int(moments[key][i]) for key in ("count", "least_at", "largest_at"))
        under = over = 0
        if rows is not None:
            edges, counts = histogram(rows[i], task.options.histogram)
        else:
            counted = found["histogram"]
            edges, counts = (
                np.linspace(task.reach[i][0], task.reach[i][1], task.options.histogram + 1),
                counted["counts"][i],
            )
            under, over = int(counted["under"][i]), int(counted["over"][i])
        made.append(
            Statistics(column, count, mean, deviation, least, largest, least_at, largest_at, edges, counts, under, over)
        )
    return made


def _failures(task: SweepTask, failed: Array) -> Iterator[Finding]:
    """Why samples lack values: a finding for each cause, with the first of its samples."""
    for cause, (count, first, time) in enumerate(failed.tolist()):
        sample = int(first)
        if not count:
            continue
        if cause < len(task.varied.causes):
            values = task.plan.values(sample // UNIT)[:, sample % UNIT]
            yield task.varied.finding(cause, int(count), task.plan.samples, sample, time, values)
        else:
            yield Finding("study.no-value", PATH, {"count": int(count), "samples": task.plan.samples, "sample": sample})
