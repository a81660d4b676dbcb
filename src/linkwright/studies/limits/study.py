"""The limits study: how far each drive and each output can go, where they turn round, how well forces get through."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Annotated

import numpy as np
from pydantic import Field, PrivateAttr, ValidationInfo, model_validator

from linkwright.elements.fields import Interval, freeze
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Frozen, FrozenDict
from linkwright.expressions.fields import Name as NameField
from linkwright.expressions.language import Call, Name, is_signal, nodes, parse, signal_text
from linkwright.expressions.typed_fields import Ref, of_drive
from linkwright.findings import Finding, Joined
from linkwright.kernels import Compiled
from linkwright.kernels.laws import values_at
from linkwright.model.places import Path
from linkwright.presentation.blocks import StudyReport
from linkwright.results import Run
from linkwright.studies.assembly_checks import overrun, singular_throughout, unassembled
from linkwright.studies.change_point_carry import carry_through_change_points
from linkwright.studies.cycle.options import CycleOptions, beside, span
from linkwright.studies.drive_sweep import Sweep
from linkwright.studies.limits.extremes import Signals, courses, touches, transmission
from linkwright.studies.limits.four_links import four_links
from linkwright.studies.limits.outcome import DriveLimits, LimitsOutcome, RunLimits
from linkwright.studies.limits.ranges import Range, ranges
from linkwright.studies.limits.report import report
from linkwright.studies.numbers import interval
from linkwright.studies.output_signals import output_signals
from linkwright.studies.registry import Command, Study, register
from linkwright.studies.run_context import NOWHERE, RunContext
from linkwright.studies.sampling_options import name_faults, unit_faults

WIDEST = {True: 200 * math.pi, False: 1000.0}
"""The widest range of a drive that is looked at: a hundred turns, or so many times the mechanism's size."""


Motor = Annotated[NameField, Ref("motor")]


class LimitsOptions(Frozen):
    """Which drives are moved alone, over which values, and which signals are looked at."""

    drives: tuple[Motor, ...] | None = None
    ranges: Annotated[dict[Motor, Interval], of_drive(u.ANGLE, u.LENGTH), freeze] = Field(default_factory=FrozenDict)
    signals: tuple[Expression, ...] = Field((), max_length=200)
    samples: int = Field(360, ge=16, le=20_000)
    _cycle: CycleOptions | None = PrivateAttr(None)

    @model_validator(mode="after")
    def _beside(self, info: ValidationInfo) -> LimitsOptions:
        """The motion of the file's cycle is looked at too."""
        self._cycle = beside(info)
        return self

    @property
    def cycle(self) -> CycleOptions | None:
        """The options of the file's cycle, where it asks for one."""
        return self._cycle


@register
class Limits(Study):
    """Ranges, limit positions, strokes, transmission angles, types of four-bars."""

    name = "limits"
    example = "{signals: [rocker.angle]}"
    options = LimitsOptions
    rank = 1
    command = Command(writes=False)

    def check(self, compiled: Compiled, options: LimitsOptions) -> list[Finding]:
        """What is wrong with ranges and signals; drives of a path can't be moved each alone."""
        if (paths := compiled.mechanism.paths) and any(map(compiled.mechanism.path_drives, paths)):
            drives = Joined(drive for path in paths for drive in compiled.mechanism.path_drives(path))
            return [Finding("study.paths", ("studies", self.name), {"drives": drives, "names": Joined(paths)})]
        return [*_ranges(compiled, options), *_signals(compiled, options)]

    def run(self, compiled: Compiled, options: LimitsOptions, site: RunContext = NOWHERE) -> LimitsOutcome:
        """Move each drive alone, then follow the file's motion."""
        outcome = LimitsOutcome(compiled, options.samples, loops=four_links(compiled))
        signals = _bound_signals(compiled, options)
        for drive in options.drives if options.drives is not None else compiled.graph.motors:
            window = options.ranges.get(drive)
            edges = None if window is None else (_value(compiled, drive, window[0]), _value(compiled, drive, window[1]))
            found = ranges(compiled, drive, edges, options.samples)
            forward = _forward(compiled, drive)
            outcome.drives.append(DriveLimits(drive, [(r, _swept(r, signals, forward)) for r in found]))
            outcome.warnings += [finding for r in found for finding in _overrun(r.sweep)]
        if options.cycle is not None:
            _follow(outcome, options.cycle, signals)
        return outcome

    def report(self, outcome: LimitsOutcome) -> StudyReport:
        """Tables of what was found."""
        return report(outcome)


def _swept(found: Range, signals: Signals, forward: bool) -> RunLimits:
    ends = [end for end in (found.low, found.high) if end.group is not None and end.kind != "cluster"]
    flat = [(str(end.group), end.value - found.sweep.origin) for end in ends]
    return _stretch(found.sweep, signals, flat, found.full, forward)


def _stretch(
    run: Run, signals: Signals, ends: Sequence[tuple[str, float]] = (), full: bool = False, forward: bool = True
) -> RunLimits:
    """What a run comes to. ``ends``: groups that are stretched or folded at its ends, and when."""
    meeting = touches(run)
    carried = run.compiled.passages
    run.change_points = tuple(
        touch.time for touch in meeting if carried.outside(np.array([touch.time]), touch.group).all()
    )
    flat = [*((touch.group, touch.time) for touch in meeting), *ends]
    return RunLimits(run, courses(run, signals, full, forward), transmission(run, flat), meeting)


def _overrun(sweep: Sweep) -> Iterator[Finding]:
    """A warning for each cylinder that a drive takes beyond its stroke: the range is that of the links alone."""
    unit, size = sweep.compiled.quantities.drive_unit(sweep.drive)
    for path, time, data in overrun(sweep):
        data |= {"drive": sweep.drive, "value": f"{(sweep.origin + time) / size:.6g}", "unit": unit}
        yield Finding("study.cylinder-length", path, data, severity="warning")


def _follow(outcome: LimitsOutcome, cycle: CycleOptions, signals: Signals) -> None:
    """The same over the file's motion, where it can be followed."""
    stop, findings = span(outcome.compiled, cycle)
    if findings:
        return
    run = Run(outcome.compiled, 0.0, stop, max(cycle.samples, outcome.samples))
    refused = singular_throughout(run)
    if cycle.through == "keep" and not refused:
        run, refused = carry_through_change_points(run)
    if gaps := refused or [*unassembled(run)] or [*_too_far(run)]:
        outcome.warnings += [replace(gap, severity="warning") for gap in gaps]
    else:
        outcome.motion = _stretch(run, signals)


def _too_far(run: Run) -> Iterator[Finding]:
    """The drives that go so far over a motion that what it passes can't all be looked for."""
    for name in run.compiled.graph.motors:
        travel, widest = run.travel(name), _widest(run.compiled, name)
        if travel > widest:
            unit, size = run.compiled.quantities.drive_unit(name)
            data = {"drive": name, "travel": f"{travel / size:.4g}", "limit": f"{widest / size:.4g}", "unit": unit}
            yield Finding("study.long-motion", ("studies", "cycle"), data)


def _bound_signals(compiled: Compiled, options: LimitsOptions) -> Signals:
    quantities = compiled.quantities
    texts = dict.fromkeys([*output_signals(compiled), *(signal.text for signal in options.signals)])
    return {
        text: (quantities.bind(Expression(text), None), quantities.dimensions.dimension(parse(text))) for text in texts
    }


def _value(compiled: Compiled, drive: str, edge: Expression) -> float:
    return compiled.quantities.value(edge, compiled.quantities.drive_dimension(drive))


def _forward(compiled: Compiled, drive: str) -> bool:
    """Whether the drive's value rises over the first while of its motion."""
    early = values_at(compiled.laws, 1e-3)[drive] - values_at(compiled.laws, 0.0)[drive]
    return early >= 0


def _widest(compiled: Compiled, drive: str) -> float:
    """The longest way of a drive (rad or m) over which limits are looked for."""
    turns = compiled.mechanism.prescribed(drive).turns is not None
    return WIDEST[turns] * (1.0 if turns else compiled.assembly.size())


def _ranges(compiled: Compiled, options: LimitsOptions) -> Iterator[Finding]:
    for name, edges in options.ranges.items():
        path = ("studies", "limits", "ranges", name)
        if name not in compiled.graph.motors:
            continue
        ends, found = interval(compiled.quantities, edges, compiled.quantities.drive_dimension(name), path)
        yield from found
        if ends is not None and ends[1] - ends[0] > (widest := _widest(compiled, name)):
            unit, size = compiled.quantities.drive_unit(name)
            yield Finding("study.wide-range", path, {"drive": name, "limit": f"{widest / size:.4g}", "unit": unit})


def _signals(compiled: Compiled, options: LimitsOptions) -> Iterator[Finding]:
    for i, expression in enumerate(options.signals):
        path = ("studies", "limits", "signals", i)
        yield from name_faults(compiled, expression, path) or _unmoved(compiled, expression, path)


def _unmoved(compiled: Compiled, expression: Expression, path: Path) -> list[Finding]:
    """What an expression of known names has that isn't there where a drive is moved alone, or else is wrong with its
    dimensions."""
    dynamic = dict.fromkeys(name for name in _names(compiled, expression) if name is not None)
    found = [Finding("study.not-in-sweep", path, {"name": name}) for name in dynamic]
    return found or unit_faults(compiled, expression, path)


def _names(compiled: Compiled, expression: Expression) -> Iterator[str | None]:
    """The names in an expression that mean nothing where a drive moves at unit speed without forces."""
    for part in nodes(expression.node):
        if isinstance(part, Name | Call) and is_signal(part):
            signal = compiled.quantities.signals.find(part)
            dynamic = signal.kind in ("force", "shaking", "energy") or bool(signal.dimension.mass)
            yield signal_text(part) if dynamic else None
        elif isinstance(part, Name) and part.text == "t":
            yield part.text
