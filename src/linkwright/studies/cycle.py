"""The cycle study: motion and forces of a mechanism over a span of time, proven, with its measures."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field, replace
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import BeforeValidator, Field, ValidationError, ValidationInfo, model_validator

from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Frozen, fault
from linkwright.expressions.typed_fields import Quantity
from linkwright.expressions.unknown import unknown
from linkwright.expressions.written import unexpected
from linkwright.findings import Finding, ModelError, Term
from linkwright.kernels import Compiled
from linkwright.measures import Measurer, MeasureResult, enclose, misfit
from linkwright.results import Result, Run, certify
from linkwright.studies.acting import contacts, outside, undefined
from linkwright.studies.feasible import near, singular, strokes, travels, unassembled
from linkwright.studies.locked import locked
from linkwright.studies.numbers import constant
from linkwright.studies.outputs import powerless
from linkwright.studies.plausible import coincident, crossed
from linkwright.studies.registry import register
from linkwright.studies.site import NOWHERE, Site
from linkwright.studies.through import carried, warnings

LONGEST = 1e12
"""No run is longer (s)."""
TURNS = re.compile(r"\s*((?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s+(\w+)\s*")


def _counted(raw: Any) -> Any:
    if raw is not None and not isinstance(raw, str):
        raise unexpected("turns", raw)
    return raw


class CycleOptions(Frozen):
    """How long, and on how many steps. One of period, duration and turns says how long."""

    period: Annotated[Expression | None, Quantity(u.TIME)] = Field(
        None, description="the motion's period: it must close"
    )
    duration: Annotated[Expression | None, Quantity(u.TIME)] = Field(None, description="how long the run lasts")
    turns: Annotated[str | None, BeforeValidator(_counted)] = Field(
        None, description="'2 engine': so many turns of a drive of constant speed"
    )
    samples: int = Field(200, ge=2, le=100_000, description="number of equal steps; rows are samples + 1")
    through: Literal["keep", "stop"] = Field(
        "stop", description="at a change point: keep goes on smoothly through it, stop refuses the run"
    )

    @model_validator(mode="after")
    def _one_length(self) -> CycleOptions:
        given = [name for name in ("period", "duration", "turns") if getattr(self, name) is not None]
        if len(given) != 1:
            key = given[0] if given else "period"
            raise fault("study.options", study="cycle", key=key, reason=Term("one-length"))
        return self


def beside(info: ValidationInfo) -> CycleOptions | None:
    """The options of the cycle in the same file, for those of another study; None where it has none, or wrong ones, of
    which the cycle itself tells."""
    given = (info.context or {}).get("cycle")
    try:
        return None if given is None else CycleOptions.model_validate(given)
    except ValidationError:
        return None


@dataclass
class CycleOutcome:
    """What a cycle gives: its result, the measures, and notes that don't stop it."""

    result: Result
    measures: list[MeasureResult] = field(default_factory=list)
    warnings: list[Finding] = field(default_factory=list)

    @property
    def failures(self) -> list[Finding]:
        """Why the run is not whole."""
        return self.result.failures

    @property
    def done(self) -> bool:
        """Whether the motion could be followed and every requirement is met."""
        return not self.failures and all(measure.verdict is not False for measure in self.measures)


@register
class Cycle:
    """Motion and forces over time."""

    name = "cycle"
    example = "{turns: 1 motor, samples: 360}"
    options = CycleOptions

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
        return findings

    def run(self, compiled: Compiled, options: CycleOptions, site: Site = NOWHERE) -> CycleOutcome:
        """Follow the motion, prove it, take the measures."""
        stop, _ = span(compiled, options)
        run = Run(compiled, 0.0, stop, options.samples)
        code = "motion.singular"
        if options.through == "keep":
            code = "motion.cannot-carry"
            run, kept = carried(run)
            if kept:
                return CycleOutcome(Result(run, kept))
        if gaps := unassembled(run):
            return CycleOutcome(Result(run, gaps))
        if poses := singular(run, code):
            return CycleOutcome(Result(run, poses))
        if stops := locked(run):
            return CycleOutcome(Result(run, stops))
        if dead := powerless(run):
            return CycleOutcome(Result(run, dead))
        if undecided := undefined(run):
            return CycleOutcome(Result(run, undecided))
        certificate = certify(run)
        result = Result(run, certificate=certificate)
        measurer = Measurer(run, [*compiled.mechanism.measures])
        measures = enclose(measurer, measurer.all())
        result.certificate = replace(certificate, measures=misfit(measurer, measures))
        measurer.findings += lost(run)
        faults = [finding for finding in measurer.findings if finding.severity == "error"]
        result.failures += [*unproven(result), *faults, *strokes(run), *travels(run)]
        warned = [finding for finding in measurer.findings if finding not in faults]
        warned += [*warnings(run), *near(run), *(not_periodic(run) if options.period is not None else [])]
        notes = [*coincident(run), *crossed(run)]
        warned += [*outside(run), *contacts(run)]
        return CycleOutcome(result, measures, [*warned, *notes])


CHECKS = {
    "closure": Term("closure"),
    "equilibrium": Term("equilibrium"),
    "power": Term("power"),
    "work": Term("work"),
    "measures": Term("measures"),
}


def unproven(result: Result) -> list[Finding]:
    """A finding for each proof of the certificate that fails: figures that can't be trusted."""
    assert result.certificate is not None
    found = []
    for name, figure in result.certificate.unproven().items():
        data = {"check": CHECKS[name], "figure": f"{figure:.1e}" if figure == figure else Term("unknown-share")}
        found.append(Finding("motion.unproven", ("studies", "cycle"), data))
    return found


def lost(run: Run) -> list[Finding]:
    """A finding for each angle that turns too often to be followed."""
    names = sorted(name.partition(".")[0] for name in run.lost)
    return [Finding("motion.too-many-turns", ("links", name), {"name": name}) for name in names]


def span(compiled: Compiled, options: CycleOptions) -> tuple[float, list[Finding]]:
    """The length of the run (s), and what is wrong with it."""
    if options.turns is not None:
        return _turns(compiled, options.turns)
    key, length = ("period", options.period) if options.period is not None else ("duration", options.duration)
    assert length is not None
    path = ("studies", "cycle", key)
    seconds, found = constant(compiled.quantities, length, u.TIME, path, math.inf)
    if seconds is None:
        return 0.0, found
    if seconds <= 0:
        return _wrong(key, Term("length-positive"))
    return (seconds, []) if seconds < LONGEST else _wrong(key, _too_long(seconds))


def _wrong(key: str, reason: Term) -> tuple[float, list[Finding]]:
    data = {"study": "cycle", "key": key, "reason": reason}
    return 0.0, [Finding("study.options", ("studies", "cycle", key), data)]


def _too_long(seconds: float) -> Term:
    return Term("length-limit", seconds=f"{seconds:.3g}", limit=f"{LONGEST:.3g}")


def _turns(compiled: Compiled, text: str) -> tuple[float, list[Finding]]:
    m, match = compiled.mechanism, TURNS.fullmatch(text)
    if match is None:
        return _wrong("turns", Term("turns-form", text=text[:60], drive=compiled.graph.drives[0]))
    count, name = float(match[1]), match[2]
    if name not in m.movers:
        return 0.0, [unknown("drive", ("studies", "cycle", "turns"), name, m.movers)]
    drive = m.drives.get(name)
    if (
        drive is None
        or drive.speed is None
        or drive.output is not None
        or drive.acceleration is not None
        or not drive.turns
    ):
        return _wrong("turns", Term("turns-constant", drive=name))
    speed = compiled.quantities.value(drive.speed, u.OMEGA)
    if speed == 0 or count == 0:
        return _wrong("turns", Term("turns-none", drive=name))
    seconds = 2 * np.pi * count / abs(speed)
    return (seconds, []) if seconds < LONGEST else _wrong("turns", _too_long(seconds))


def not_periodic(run: Run) -> list[Finding]:
    """A warning where a motion said to be periodic doesn't come back to where it began."""
    points = list(run.compiled.quantities.signals.homes)
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
