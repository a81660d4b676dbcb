"""The sweep study: many samples of the parameters, with the measures and signals of each. Its options and their check.

(:mod:`linkwright.studies.drive_sweep` is another thing: one drive moved alone, for the limits.)
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Annotated, Literal

from pydantic import Field

from linkwright.elements.fields import ParameterName, freeze
from linkwright.expressions.typed_fields import of_parameter
from linkwright.findings import Finding, ModelError
from linkwright.kernels import Compiled
from linkwright.kernels.parameter_batch import Varied
from linkwright.kernels.registry import KERNELS
from linkwright.model.references import option_faults
from linkwright.studies.distributions import ParameterSpread, Vary
from linkwright.studies.numbers import constant
from linkwright.studies.plans import PLANS, Plan
from linkwright.studies.sampling_options import Sampling, check_outputs, check_span, one_of

PATH = ("studies", "sweep")
SAMPLES = 4096
"""Samples of a plan that leaves their number open."""


PlanName = one_of("sweep", "plan", [*PLANS])
KernelName = one_of("sweep", "kernel", ["auto", *KERNELS])


class SweepOptions(Sampling):
    """Which parameters take which values, and what is wanted of each sample."""

    study = "sweep"

    vary: Annotated[dict[ParameterName, Vary], of_parameter(3), freeze] = Field(min_length=1, max_length=1000)
    plan: PlanName | None = None  # type: ignore[valid-type]
    samples: int | None = Field(None, ge=1)
    seed: int = Field(0, ge=0, le=2**63)
    keep: Literal["reduced", "all"] = "reduced"
    kernel: KernelName = "auto"  # type: ignore[valid-type]

    @property
    def keeps_signals(self) -> bool:
        return self.keep == "all"

    def spreads(self, compiled: Compiled) -> list[ParameterSpread]:
        """What the parameters take, in SI."""
        quantities = compiled.quantities
        return [
            entry.spread([quantities.value(part, quantities.dimensions.of(name)) for _, part in entry.parts()])
            for name, entry in self.vary.items()
        ]

    def planned(self, spreads: Sequence[ParameterSpread]) -> type[Plan]:
        """The plan, the given one or the one that fits."""
        fitting = "grid" if all(spread.points is not None for spread in spreads) else "latin"
        return PLANS[self.plan or fitting]


def check(compiled: Compiled, options: SweepOptions) -> Iterator[Finding]:
    """What is wrong with options that are well-formed."""
    wrong = [*option_faults(compiled.mechanism, options, PATH), *_varied(compiled, options)]
    yield from wrong
    if not wrong:
        yield from _size(compiled, options)
        try:
            Varied(compiled, tuple(options.vary))
        except ModelError as error:
            yield from error.findings
    yield from check_outputs(compiled, options)
    yield from check_span(compiled, options, frozenset(options.vary), "vary")


def _varied(compiled: Compiled, options: SweepOptions) -> Iterator[Finding]:
    quantities = compiled.quantities
    for name, entry in options.vary.items():
        path = (*PATH, "vary", name)
        if name not in quantities.parameters:
            continue
        dimension, numbers, wrong = quantities.dimensions.of(name), list[float](), list[Finding]()
        for place, part in entry.parts():
            value, faults = constant(quantities, part, dimension, (*path, *place))
            wrong += faults
            numbers += [] if value is None else [value]
        yield from wrong or (Finding(code, path, data) for code, data in entry.number_faults(numbers))


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
