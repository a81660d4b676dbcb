"""The sweep study: many samples of the parameters, with the measures and signals of each. Its options and their check.

(:mod:`linkwright.studies.sweep` is another thing: one drive moved alone, for the limits.)
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Annotated, Any, Literal

from pydantic import (
    BeforeValidator,
    Field,
    PrivateAttr,
    ValidationInfo,
    WithJsonSchema,
    model_validator,
)

from linkwright.kernels import Compiled
from linkwright.kernels.registry import KERNELS
from linkwright.kernels.varied import Varied
from linkwright.model import units as u
from linkwright.model.dimensions import DimensionError
from linkwright.model.expressions import Call, Name, is_signal, nodes
from linkwright.model.fields import Expression, Frozen, fault
from linkwright.model.fields import Name as NameField
from linkwright.model.findings import Finding, ModelError
from linkwright.model.names import Names
from linkwright.model.parts import freeze
from linkwright.model.places import Place, Scope
from linkwright.model.quantities import LARGEST
from linkwright.model.sampled import dependent
from linkwright.model.unknown import near
from linkwright.studies.cycle import TURNS, CycleOptions, beside, span
from linkwright.studies.distributions import Spread, Vary
from linkwright.studies.plans import PLANS, Plan

PATH = ("studies", "sweep")
SAMPLES = 4096
"""Samples of a plan that leaves their number open."""


def _one_of(key: str, known: Sequence[str]) -> Any:
    def check(raw: Any) -> str:
        if raw not in known:
            raise fault("study.choice", study="sweep", key=key, given=str(raw)[:40], known=", ".join(known))
        return str(raw)

    return Annotated[str, BeforeValidator(check), WithJsonSchema({"type": "string", "enum": [*known]})]


PlanName = _one_of("plan", [*PLANS])
KernelName = _one_of("kernel", ["auto", *KERNELS])


class SweepOptions(Frozen):
    """Which parameters take which values, and what is wanted of each sample."""

    vary: Annotated[dict[NameField, Vary], freeze] = Field(
        min_length=1, max_length=1000, description="what each varied parameter takes: steps, a list, a distribution"
    )
    plan: PlanName | None = Field(  # type: ignore[valid-type]
        None, description="how samples are chosen; grid, all combinations, where nothing is a distribution, else latin"
    )
    samples: int | None = Field(None, ge=1, description=f"how many samples, {SAMPLES} by default; a grid has its own")
    seed: int = Field(0, ge=0, le=2**63, description="another seed gives other samples")
    poses: int | None = Field(
        None, ge=1, le=100_000, description="equal steps at whose ends signals are taken; the cycle's by default"
    )
    outputs: tuple[Expression, ...] | None = Field(
        None, min_length=1, max_length=1000, description="measures by name, signals, expressions; else all measures"
    )
    keep: Literal["reduced", "all"] = Field(
        "reduced", description="of signals: mean, deviation and extremes at each pose, or every value of every sample"
    )
    histogram: int = Field(40, ge=2, le=1000, description="bins of the histogram of a measure")
    kernel: KernelName = Field("auto", description="what computes it: chosen by the size of the work, or one by name")  # type: ignore[valid-type]
    _cycle: CycleOptions | None = PrivateAttr(None)

    @model_validator(mode="after")
    def _beside(self, info: ValidationInfo) -> SweepOptions:
        """The span comes from the file's cycle."""
        if "cycle" not in (info.context or {}):
            raise fault("study.needs-cycle")
        self._cycle = beside(info)
        return self

    @property
    def cycle(self) -> CycleOptions:
        """The options of the file's cycle."""
        assert self._cycle is not None
        return self._cycle

    @property
    def steps(self) -> int:
        """The number of equal steps."""
        return self.cycle.samples if self.poses is None else self.poses

    def measures(self, compiled: Compiled) -> list[str]:
        """The measures wanted, by name."""
        known = compiled.mechanism.measures
        if self.outputs is None:
            return [*known]
        return list(dict.fromkeys(output.text for output in self.outputs if output.text in known))

    def signals(self, compiled: Compiled) -> list[Expression]:
        """The signals and expressions wanted."""
        known = compiled.mechanism.measures
        texts = {output.text: output for output in self.outputs or () if output.text not in known}
        return [*texts.values()]

    def spreads(self, compiled: Compiled) -> list[Spread]:
        """What the parameters take, in SI."""
        quantities = compiled.quantities
        return [
            entry.spread([quantities.value(part, quantities.dimensions.of(name)) for _, part in entry.parts()])
            for name, entry in self.vary.items()
        ]

    def planned(self, spreads: Sequence[Spread]) -> type[Plan]:
        """The plan, the given one or the one that fits."""
        fitting = "grid" if all(spread.points is not None for spread in spreads) else "latin"
        return PLANS[self.plan or fitting]

    def made(self, compiled: Compiled) -> Plan:
        """The plan with its samples."""
        spreads = self.spreads(compiled)
        return self.planned(spreads)(spreads, self.samples or SAMPLES, self.seed)


def check(compiled: Compiled, options: SweepOptions) -> Iterator[Finding]:
    """What is wrong with options that are well-formed."""
    varied = list(_varied(compiled, options))
    yield from varied
    if not varied:
        yield from _size(compiled, options)
        try:
            Varied(compiled, tuple(options.vary))
        except ModelError as error:
            yield from error.findings
    yield from _outputs(compiled, options)
    yield from _span(compiled, options)


def _varied(compiled: Compiled, options: SweepOptions) -> Iterator[Finding]:
    quantities = compiled.quantities
    for name, entry in options.vary.items():
        path = (*PATH, "vary", name)
        if name not in quantities.parameters:
            data = {"name": name, "near": near(name, [*quantities.parameters])}
            yield Finding("name.unknown-parameter", path, data)
            continue
        numbers, sound = [], True
        for place, part in entry.parts():
            try:
                numbers.append(quantities.value(part, quantities.dimensions.of(name)))
            except DimensionError as error:
                yield Finding(error.key, (*path, *place), quantities.spelt(error.data))
                sound = False
                continue
            if not abs(numbers[-1]) < LARGEST:
                yield Finding("value.not-finite", (*path, *place), {"text": part.text[:60]})
                sound = False
        if sound:
            yield from (Finding(code, path, data) for code, data in entry.wrong(numbers))


def _size(compiled: Compiled, options: SweepOptions) -> Iterator[Finding]:
    spreads = options.spreads(compiled)
    plan = options.planned(spreads)
    if not plan.chosen:
        for name, spread in zip(options.vary, spreads, strict=True):
            if spread.points is None:
                yield Finding("study.plan", (*PATH, "vary", name), {"name": name, "plan": plan.name})
        if options.samples is not None:
            yield Finding("study.grid-samples", (*PATH, "samples"), {"plan": plan.name})
    count = plan.count(spreads, options.samples or SAMPLES)
    if count > plan.most:
        data = {"plan": plan.name, "count": f"{count:,}", "limit": f"{plan.most:,}"}
        yield Finding("study.too-many-samples", (*PATH, "samples") if plan.chosen else PATH, data)


def _outputs(compiled: Compiled, options: SweepOptions) -> Iterator[Finding]:
    quantities, known = compiled.quantities, compiled.mechanism.measures
    names = Names(compiled.mechanism, quantities.signals)
    if options.outputs is None and not known:
        yield Finding("study.no-outputs", PATH)
    for i, output in enumerate(options.outputs or ()):
        if output.text in known:
            continue
        path = (*PATH, "outputs", i)
        parts = [part for part in nodes(output.node) if isinstance(part, Name | Call)]
        if not any(is_signal(part) for part in parts):
            data = {"text": output.text[:60], "near": near(output.text, [*known])}
            yield Finding("study.no-output", path, data)
            continue
        place = Place(path, output, u.PURE, Scope.SIGNALS)
        wrong = [*names.unknown(place), *names.misplaced(place)]
        yield from wrong
        if not wrong:
            try:
                quantities.dimensions.bind(output.node, None)
            except DimensionError as error:
                yield Finding(error.key, path, quantities.spelt(error.data))


def _span(compiled: Compiled, options: SweepOptions) -> Iterator[Finding]:
    """The run is as long for all samples, so nothing that is varied may change that."""
    cycle, m = options.cycle, compiled.mechanism
    length = cycle.period if cycle.period is not None else cycle.duration
    if cycle.turns is not None and (match := TURNS.match(cycle.turns)) and match[2] in m.drives:
        length = m.drives[match[2]].speed
    if findings := span(compiled, cycle)[1]:
        yield from findings
        return
    assert length is not None
    varying = dependent(compiled.quantities, frozenset(options.vary))
    for node in nodes(length.node):
        if isinstance(node, Name) and node.text in varying:
            yield Finding("study.varied-span", (*PATH, "vary"), {"name": node.text})
