"""The sweep study: many samples of the parameters carried through a work, and what is made of what comes.

(:mod:`linkwright.studies.drive_sweep` is another thing: one drive moved alone, for the limits.)
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from linkwright.blocks.work import Arrays
from linkwright.findings import Finding
from linkwright.kernels import Compiled
from linkwright.kernels.kernel_selection import KernelChoice
from linkwright.presentation.blocks import FileOf, StudyReport
from linkwright.results import Run
from linkwright.studies.cycle.options import span
from linkwright.studies.plans import Plan
from linkwright.studies.registry import Command, Setting, Study, register
from linkwright.studies.run_context import RunContext
from linkwright.studies.sampling import Performed, choose_kernel, perform, refused
from linkwright.studies.sampling_state import store
from linkwright.studies.sampling_task import FINE
from linkwright.studies.shares import Share, wilson
from linkwright.studies.sweep.options import SAMPLES, SweepOptions, check
from linkwright.studies.sweep.outcome import SampleTable, Statistics, SweepOutcome, bands
from linkwright.studies.sweep.report import report


@register
class SweepStudy(Study):
    """Many samples of the parameters."""

    name = "sweep"
    example = "{vary: {AB: {from: 150, to: 160, count: 11}}}"
    options = SweepOptions
    rank = 3
    command = Command([Setting("kernel", ("kernel",))], work=True, fresh=True)
    files = {
        "sweep.csv": FileOf(lambda outcome: outcome.dataset.csv("sample")),
        "sweep_bands.csv": FileOf(lambda outcome: outcome.dataset.csv("time")),
        "sweep.nc": FileOf(lambda outcome: outcome.dataset.netcdf(), "netcdf", asked=True),
    }

    def check(self, compiled: Compiled, options: SweepOptions) -> list[Finding]:
        """What is wrong with the options."""
        return list(check(compiled, options)) if options.spanned else []

    def sampled_mechanism(self, compiled: Compiled) -> Compiled:
        """The mechanism of which the samples are taken: the file's own."""
        return compiled

    def draws(self, compiled: Compiled, options: SweepOptions) -> Plan:
        """The samples, by the plan."""
        return _plan(compiled, options)

    def run(self, compiled: Compiled, options: SweepOptions, site: RunContext) -> SweepOutcome:
        """Perform the sweep, going on with an interrupted one in the site's folder.

        Raises :class:`Interrupted`, and :class:`ModelError` where it can't be carried on.
        """
        nominal = Run(compiled, 0.0, span(compiled, options.cycle)[0], options.steps)
        choice = choose_kernel(nominal, options)
        if found := refused(nominal, options, options.vary):
            plan = self.draws(compiled, options)
            return SweepOutcome(compiled, options, plan, nominal, choice.kernel, choice.reason, failures=found)
        done = perform(nominal, options, choice.kernel, site)
        outcome = _outcome(compiled, options, done, choice)
        outcome.poses, outcome.seconds, outcome.state = done.poses, done.seconds, tuple(done.kept.files)
        return outcome

    def report(self, outcome: SweepOutcome) -> StudyReport:
        """Tables and charts of the samples."""
        return report(outcome)

    def stores(self, options: SweepOptions) -> Sequence[str]:
        """Where all values go, where they are kept."""
        return [store("sweep")] if options.keeps_signals else []

    def settle(self, outcome: SweepOutcome) -> None:
        """The state from which the same study would go on isn't needed any more."""
        outcome.settle()


def _plan(compiled: Compiled, options: SweepOptions) -> Plan:
    spreads = options.spreads(compiled)
    return options.planned(spreads)(spreads, options.samples or SAMPLES, options.seed, tuple(options.vary))


def _outcome(compiled: Compiled, options: SweepOptions, done: Performed, choice: KernelChoice) -> SweepOutcome:
    task, kept = done.task, done.kept
    plan = _plan(compiled, options)
    outcome = SweepOutcome(compiled, options, plan, task.run, choice.kernel, choice.reason, failed=done.failed)
    if task.signals.texts:
        outcome.bands = bands(list(task.signals.texts), compiled, kept.signals.results()["moments"])
    if kept.held is not None:
        outcome.values = kept.held.values
    outcome.store = store(options.study) if kept.stored is not None else None
    rows, figures = kept.samples.rows, len(task.figures.columns)
    if figures:
        reduced = kept.samples.results()
        outcome.measures = _statistics(done, reduced["moments"])
        means, counts = (reduced["moments"][key][figures:] for key in ("mean", "count"))
        for name, mean, count in zip(task.figures.required, means, counts, strict=True):
            met = round(float(mean) * int(count))
            outcome.shares[name] = wilson(met, task.plan.samples) if task.plan.independent else Share(met, int(count))
    if rows is not None:
        values = np.concatenate([task.plan.values(unit) for unit in range(task.cut.units)], axis=1)
        lacking = kept.samples.cause != FINE
        outcome.table = SampleTable(values, rows[:figures], rows[figures:] > 0.5, lacking, kept.samples.since)
    found = [*done.findings()]
    if outcome.failed == outcome.samples:
        outcome.failures = found
    else:
        outcome.warnings = [replace(finding, severity="warning") for finding in found]
    return outcome


def _statistics(done: Performed, moments: Arrays) -> list[Statistics]:
    made = []
    for i, column in enumerate(done.task.figures.columns):
        mean, deviation, least, largest = (float(moments[k][i]) for k in ("mean", "deviation", "least", "largest"))
        count, least_at, largest_at = (int(moments[key][i]) for key in ("count", "least_at", "largest_at"))
        of = done.counted(i)
        made.append(
            Statistics(
                column, count, mean, deviation, least, largest, least_at, largest_at,
                of.edges, of.counts, of.under, of.over,
            )
        )  # fmt: skip
    return made
