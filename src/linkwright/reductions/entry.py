"""What a file says of a measure. Each reduction has an entry of its own, chosen by the key that is named after it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Annotated, Any, ClassVar, Self

from pydantic import BeforeValidator, ModelWrapValidatorHandler, model_serializer, model_validator
from pydantic_core.core_schema import SerializerFunctionWrapHandler

from linkwright.elements.entries import keys_of
from linkwright.elements.fields import Interval
from linkwright.elements.force import Use
from linkwright.elements.points import links_of_points
from linkwright.expressions.dimensions import Wanted
from linkwright.expressions.fields import Expression, Frozen, Name, fault
from linkwright.expressions.typed_fields import Context, Ends, Quantity, Ref, Scope
from linkwright.expressions.units import Dimension, UnitError, unit
from linkwright.expressions.unknown_units import unknown_unit
from linkwright.expressions.written import Fault, FrozenDict, short_text
from linkwright.findings import Joined, Said, Text
from linkwright.notation.registry import Registry
from linkwright.plugins import load
from linkwright.words import known


def _unit(raw: Any) -> str:
    text = short_text(raw)
    try:
        unit(text)
    except UnitError as error:
        raise fault("units.unknown", **unknown_unit(text, error)) from None
    return text


def measured(name: str) -> Wanted:
    """The unknown dimension of a measure, which its bounds share."""
    return (f"measure {name}", 0)


def figure(name: str, measure: Measure) -> Wanted:
    """What a measure's figure is, and so its bounds, its wrap and its unit."""
    return measure.dimension or measured(name)


def reduced(name: str, measure: Measure) -> Wanted:
    """What a measure's signal is: of the kind of the figure, unless that has a dimension of its own."""
    return measured(name) if measure.dimension is None else (f"reduced {name}", 0)


def of_signal(context: Context) -> Wanted:
    """The dimension of a field that is of the kind of its measure's signal."""
    return reduced(context.name, context.entry)


SIGNAL = Quantity(of_signal, scope=Scope.SIGNALS)
"""The signal expression of a measure."""


class Measure(Frozen):
    """A named scalar of a run: one reduction of a signal expression, or of a point's path.

    Base of the entries of reductions. Read from plain data, it is the entry of the reduction whose key is given.
    """

    reduction: ClassVar[str]
    """The key that has the signal or the point: the name of the reduction."""
    sentence: ClassVar[str] = "measure.text"
    """The text that says what is asked for, of the reduction and the signal."""
    dimension: ClassVar[Dimension | None] = None
    """What the figure is, where it isn't of the kind of the signal."""

    window: Annotated[Name | None, Ref("window")] = None
    wrap: Annotated[Interval | None, Quantity(lambda c: figure(c.name, c.entry), ends=Ends.RISING)] = None
    unit: Annotated[str, BeforeValidator(_unit)] | None = None

    @classmethod
    def key_faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        """What is wrong with keys that stand together only, in a measure of any reduction."""
        yield from ()

    @model_validator(mode="wrap")
    @classmethod
    def _of_its_kind(cls, raw: Any, handler: ModelWrapValidatorHandler[Self]) -> Any:
        if cls is not Measure or not isinstance(raw, Mapping):
            return handler(raw)
        given = {key: value for key, value in raw.items() if value is not None}
        entries = entries_of(given)
        if len(entries) > 1:
            named = Joined(entry.reduction for entry in entries)
            raise fault("measure.reduction", given=named, known=Joined(ENTRIES))
        beyond = entries and given.keys() - keys_of(entries[0])
        for code, data in (wrong for of in (ENTRIES.values() if beyond else entries) for wrong in of.key_faults(given)):
            raise fault(code, **data)
        return entries[0].model_validate(raw) if entries else handler(raw)

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        if cls is Measure:
            yield "measure.reduction", {"given": "-", "known": Joined(ENTRIES)}

    @model_serializer(mode="wrap")
    def _reduction_first(self, handler: SerializerFunctionWrapHandler) -> dict[str, Any]:
        data: dict[str, Any] = handler(self)
        return {**{key: value for key, value in data.items() if key not in Measure.model_fields}, **data}

    @property
    def signal(self) -> Expression:
        """The expression that is reduced."""
        expression: Expression = getattr(self, self.reduction)
        return expression

    @property
    def also(self) -> Mapping[str, Expression]:
        """Other expressions of signals that the measure needs, by the key that tells them."""
        return FrozenDict()

    @property
    def point(self) -> str | None:
        """The point whose path is looked at."""
        return None

    @property
    def subject(self) -> str:
        """What is reduced, for the reader."""
        return self.signal.text

    @property
    def title(self) -> Text:
        """The name of the reduction for the reader; as files have it where a package brings no text."""
        key = f"reduction.{self.reduction}"
        return Said(key) if known(key) else self.reduction

    @property
    def description(self) -> Said:
        """What is asked for, for the reader."""
        what = Said(self.sentence, reduction=self.title, signal=self.subject)
        return Said("measure.text.window", what=what, window=self.window) if self.window else what

    def implied_expressions(self, mechanism: Any, name: str) -> Iterator[Use]:
        """The expressions that no field holds, of a measure of that name."""
        for key, expression in self.also.items():
            yield Use(key, expression, (f"{key} {name}", 0), Scope.SIGNALS)


class OfPath(Measure):
    """Base of the entries of reductions of a point's path, whose signal is known."""

    along: ClassVar[tuple[str, Dimension]]
    """The signal that is searched, with ``{0}`` for the point, and its dimension."""

    @property
    def point(self) -> str:
        """The point whose path is looked at."""
        return str(getattr(self, self.reduction))

    @property
    def signal(self) -> Expression:
        """The expression that is searched."""
        return Expression(self.along[0].format(self.point))

    @property
    def subject(self) -> str:
        """The point, for the reader."""
        return self.point

    def implied_expressions(self, mechanism: Any, name: str) -> Iterator[Use]:
        """Its signal, where there is such a point."""
        if self.point in links_of_points(mechanism):
            yield Use(self.reduction, self.signal, self.along[1], Scope.SIGNALS)


MODULES = {
    "dwell": "linkwright.reductions.dwell",
    "efficiency": "linkwright.reductions.efficiency",
    "share": "linkwright.reductions.efficiency",
    "span": "linkwright.reductions.extreme",
    "max": "linkwright.reductions.extreme",
    "min": "linkwright.reductions.extreme",
    "extremes": "linkwright.reductions.extreme",
    "mean": "linkwright.reductions.mean",
    "rms": "linkwright.reductions.mean",
    "path": "linkwright.reductions.mean",
    "straightness": "linkwright.reductions.straightness",
    "value": "linkwright.reductions.value",
}
"""The modules of this package's reductions, by the names of these; each is imported when it is first asked for."""
ENTRIES: Registry[type[Measure]] = Registry(MODULES)
"""The entries by the names of their reductions."""


def entries_of(raw: Mapping[str, Any]) -> list[type[Measure]]:
    """The entries whose keys are given."""
    if not ENTRIES.keys() & raw.keys() and raw.keys() - Measure.model_fields.keys():
        load("measures")
    return [ENTRIES[name] for name in ENTRIES if name in raw]
