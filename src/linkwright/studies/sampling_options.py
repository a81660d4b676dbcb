"""What studies of many samples share in their options: the span of the file's cycle, and the outputs wanted."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Self

from pydantic import BeforeValidator, Field, PrivateAttr, ValidationInfo, WithJsonSchema, model_validator

from linkwright.expressions import units as u
from linkwright.expressions.dimensions import DimensionError
from linkwright.expressions.fields import Expression, Frozen, fault
from linkwright.expressions.language import Name, nodes, signals_in
from linkwright.expressions.unknown import near
from linkwright.expressions.written import describe
from linkwright.findings import Finding
from linkwright.kernels import Compiled
from linkwright.model.names import Names
from linkwright.model.places import ExpressionPlace, Scope
from linkwright.model.sampled import dependent
from linkwright.studies.cycle.options import TURNS, CycleOptions, beside, span


def one_of(study: str, key: str, known: Sequence[str], code: str = "study.choice") -> Any:
    """The type of an option, of a study or what else ``code`` speaks of, that is one of some words."""

    def check(raw: Any) -> str:
        if raw not in known:
            guess = near(str(raw)[:40], known, listed=True)
            raise fault(code, study=study, key=key, given=describe(raw), near=guess)
        return str(raw)

    return Annotated[str, BeforeValidator(check), WithJsonSchema({"type": "string", "enum": [*known]})]


class Sampling(Frozen):
    """The options of a study of many samples: the outputs that are wanted of each, over the run of the file's cycle."""

    study: ClassVar[str]
    if TYPE_CHECKING:
        kernel: str  # a field of each study, since its faults name the study

    poses: int | None = Field(None, ge=1, le=100_000)
    outputs: tuple[Expression, ...] | None = Field(None, min_length=1, max_length=1000)
    histogram: int = Field(40, ge=2, le=1000)
    _cycle: CycleOptions | None = PrivateAttr(None)

    @model_validator(mode="after")
    def _beside(self, info: ValidationInfo) -> Self:
        """The span comes from the file's cycle."""
        if "cycle" not in (info.context or {}):
            raise fault("study.needs-cycle", study=self.study)
        self._cycle = beside(info)
        return self

    @property
    def spanned(self) -> bool:
        """Whether the file's cycle is sound; of a wrong one the cycle itself tells."""
        return self._cycle is not None

    @property
    def cycle(self) -> CycleOptions:
        """The options of the file's cycle, which is sound."""
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

    @property
    def keeps_signals(self) -> bool:
        """Whether every value of every signal is kept."""
        return False


def check_outputs(compiled: Compiled, options: Sampling) -> Iterator[Finding]:
    """What is wrong with the outputs."""
    known = compiled.mechanism.measures
    if options.outputs is None and not known:
        yield Finding("study.no-outputs", ("studies", options.study))
    for i, output in enumerate(options.outputs or ()):
        if output.text in known:
            continue
        path = ("studies", options.study, "outputs", i)
        if of_signals(output):
            yield from signal_faults(compiled, output, path)
        else:
            yield Finding("study.no-output", path, {"text": output.text[:60], "near": near(output.text, [*known])})


def of_signals(expression: Expression) -> bool:
    """Whether it names any signal."""
    return bool(signals_in(expression.node))


def signal_faults(compiled: Compiled, expression: Expression, path: tuple[str | int, ...]) -> list[Finding]:
    """What is wrong with the names of an expression of signals, or else with its dimensions."""
    return name_faults(compiled, expression, path) or unit_faults(compiled, expression, path)


def name_faults(compiled: Compiled, expression: Expression, path: tuple[str | int, ...]) -> list[Finding]:
    """What is wrong with the names of an expression of signals."""
    place, names = (
        ExpressionPlace(path, expression, u.PURE, Scope.SIGNALS),
        Names(compiled.mechanism, compiled.quantities.signals),
    )
    return [*names.unknown(place), *names.misplaced(place)]


def unit_faults(compiled: Compiled, expression: Expression, path: tuple[str | int, ...]) -> list[Finding]:
    """What is wrong with its dimensions, where its names are known."""
    quantities = compiled.quantities
    try:
        quantities.dimensions.bind(expression.node, None)
    except DimensionError as error:
        return [Finding(error.key, path, quantities.spelt(error.data))]
    return []


def check_span(compiled: Compiled, options: Sampling, varied: frozenset[str], at: str) -> Iterator[Finding]:
    """The run is as long for all samples, so no parameter that is ``varied`` may change that; ``at`` is the option
    that names these."""
    cycle, m = options.cycle, compiled.mechanism
    length = cycle.period if cycle.period is not None else cycle.duration
    if cycle.turns is not None and (match := TURNS.fullmatch(cycle.turns)) and match[2] in m.drives:
        length = m.drives[match[2]].speed
    if findings := span(compiled, cycle)[1]:
        yield from findings
        return
    assert length is not None
    varying = dependent(compiled.quantities, varied)
    for node in nodes(length.node):
        if isinstance(node, Name) and node.text in varying:
            yield Finding("study.varied-span", ("studies", options.study, at), {"name": node.text})
