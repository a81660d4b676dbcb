"""The cycle study: motion and forces of a mechanism over a span of time, proven, with its measures."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from linkwright.expressions import units as u
from linkwright.findings import Finding, Joined, ModelError, Term
from linkwright.kernels import Compiled
from linkwright.measures import Measurer, enclose, misfit
from linkwright.presentation.blocks import FileOf, StudyReport
from linkwright.results import Result, Run, certify
from linkwright.studies.assembly_checks import (
    drive_value,
    near,
    singular,
    singular_before,
    singular_throughout,
    strokes,
    travels,
    unassembled,
)
from linkwright.studies.change_point_carry import carry_through_change_points, warnings
from linkwright.studies.cycle.options import CycleOptions, span
from linkwright.studies.cycle.outcome import CycleOutcome
from linkwright.studies.cycle.report import report
from linkwright.studies.follower_locking import locked
from linkwright.studies.friction_checks import FrictionLaws, self_locking, starts
from linkwright.studies.kept_values import too_many
from linkwright.studies.load_checks import contacts, outside, outside_tables, undefined
from linkwright.studies.output_dead_centres import powerless
from linkwright.studies.plausible import coincident, crossed
from linkwright.studies.redundant_mechanisms import with_redundant_joints
from linkwright.studies.registry import Study, register
from linkwright.studies.run_context import NOWHERE, RunContext


@register
class Cycle(Study):
    """Motion and forces over time."""

    name = "cycle"
    example = "{turns: 1 motor, samples: 360}"
    options = CycleOptions
    rank = 0
    redundant = True
    files = {
        "cycle.csv": FileOf(lambda outcome: outcome.result.to_csv()),
        "cycle.nc": FileOf(
            lambda outcome: outcome.result.dataset(warnings=outcome.warnings).netcdf(), "netcdf", asked=True
        ),
    }

    def check(self, compiled: Compiled, options: CycleOptions) -> list[Finding]:
        """What is wrong with the length of the run."""
        stop, findings = span(compiled, options)
        if not findings:
            t = np.linspace(0.0, stop, options.samples + 1)
            for law in compiled.laws.values():
                try:
                    law(t)
                except ModelError as error:
                    findings += error.findings
        return findings or too_many("cycle", "samples", options.samples, len(compiled.quantities.signals.by_text))

    def run(self, compiled: Compiled, options: CycleOptions, site: RunContext = NOWHERE) -> CycleOutcome:
        """Follow the motion, prove it, take the measures."""
        stop, _ = span(compiled, options)
        run = Run(compiled, 0.0, stop, options.samples)
        if always := singular_throughout(run):
            return CycleOutcome(Result(run, with_redundant_joints(run, always)))
        code = "motion.singular"
        if options.through == "keep":
            code = "motion.cannot-carry"
            run, kept = carry_through_change_points(run)
            if kept:
                return CycleOutcome(Result(run, with_redundant_joints(run, kept)))
        if gaps := unassembled(run):
            ends = [gap.data["start"] for gap in gaps if gap.code == "motion.stuck"]
            gaps = (singular_before(run, code, min(ends)) if ends else []) or gaps
            return CycleOutcome(Result(run, with_redundant_joints(run, gaps)))
        if poses := singular(run, code):
            return CycleOutcome(Result(run, with_redundant_joints(run, poses)))
        if stops := locked(run):
            return CycleOutcome(Result(run, stops))
        if dead := powerless(run):
            return CycleOutcome(Result(run, dead))
        if beyond := outside_tables(run):
            return CycleOutcome(Result(run, beyond))
        friction = FrictionLaws(run)
        if stuck := friction.jammed():
            return CycleOutcome(Result(run, stuck))
        if undecided := undefined(run):
            return CycleOutcome(Result(run, undecided))
        certificate = certify(run)
        result = Result(run, certificate=certificate)
        measurer = Measurer(run)
        measures = enclose(measurer, measurer.all())
        result.certificate = replace(certificate, measures=misfit(measurer, measures))
        measurer.findings += untracked_angles(run)
        faults = [finding for finding in measurer.findings if finding.severity == "error"]
        result.failures += [*unproven(result), *faults, *strokes(run), *travels(run)]
        warned = [finding for finding in measurer.findings if finding not in faults]
        warned += [*warnings(run), *near(run), *(not_periodic(run) if options.period is not None else [])]
        notes = [*coincident(run), *crossed(run), *self_locking(run), *starts(run)]
        warned += [*outside(run), *contacts(run), *friction.ambiguous()]
        return CycleOutcome(result, measures, [*warned, *notes], site.progress)

    def report(self, outcome: CycleOutcome) -> StudyReport:
        """Measures and what verifies them."""
        return report(outcome)


PATH = ("studies", "cycle")
CHECKS = {
    "closure": Term("closure"),
    "equilibrium": Term("equilibrium"),
    "power": Term("power"),
    "work": Term("work"),
    "starting": Term("starting"),
    "signals": Term("signals"),
    "measures": Term("measures"),
    "mobility": Term("mobility-by-rank"),
    "nearest": Term("margin-to-singularity"),
    "branches": Term("kept-modes"),
    "followed": Term("continuation-correction"),
}


def unproven(result: Result) -> list[Finding]:
    """A finding for each check of the certificate that fails: figures that can't be trusted."""
    assert result.certificate is not None
    found, residuals = unknown_values(result), result.certificate.residuals
    for claim in result.certificate.unproven().values():
        data: dict[str, Any] = {"check": CHECKS[claim.name], "figure": claim.figure}
        if claim.name in result.certificate.unknown:
            continue
        if claim.name in residuals:
            found.append(Finding("motion.unproven", PATH, data))
        else:
            data["required"] = claim.required
            found.append(Finding("motion.check-fails", PATH, data))
    return found


def unknown_values(result: Result) -> list[Finding]:
    """A finding for the checks that can't be made, because something reported isn't a finite number: the first signal
    that isn't at a sample, and when."""
    assert result.certificate is not None
    if not result.certificate.unknown:
        return []
    checks = Joined(CHECKS[name] for name in result.certificate.unknown)
    compiled, t = result.run.compiled, result.run.t[result.run.compiled.passages.bounded(result.run.t)]
    known = np.isfinite(compiled.possible_rows(result.names, t))
    if known.all():
        return [Finding("motion.unknown-between", PATH, {"checks": checks})]
    signal, sample = (int(i[0]) for i in np.nonzero(~known))
    unit, second = compiled.quantities.unit_of(u.TIME)
    data = {"signal": result.names[signal], "time": f"{t[sample] / second:.6g} {unit}", "checks": checks}
    return [Finding("motion.unknown-value", PATH, data | drive_value(result.run, float(t[sample])))]


def untracked_angles(run: Run) -> list[Finding]:
    """A finding for each angle that turns too often to be followed."""
    names = sorted(name.partition(".")[0] for name in run.lost)
    return [Finding("motion.too-many-turns", ("links", name), {"name": name}) for name in names]


def not_periodic(run: Run) -> list[Finding]:
    """A warning where a motion said to be periodic doesn't come back to where it began."""
    points = list(run.compiled.quantities.signals.links_of_points)
    names = [f"{point}.{axis}" for point in points for axis in "xy"]
    ends = run.evaluate(names, np.array([run.start, run.stop]))
    away = np.hypot(*(ends[:, 1] - ends[:, 0]).reshape(-1, 2).T)
    worst = int(np.argmax(away))
    if away[worst] < 1e-6 * (np.ptp(ends) or 1.0):
        return []
    unit, size = run.compiled.quantities.unit_of(u.LENGTH)
    time_unit, second = run.compiled.quantities.unit_of(u.TIME)
    data: dict[str, Any] = {"element": points[worst], "distance": f"{away[worst] / size:.4g}", "unit": unit}
    data["period"] = f"{(run.stop - run.start) / second:.6g} {time_unit}"
    return [Finding("motion.not-periodic", ("studies", "cycle", "period"), data, severity="warning")]
