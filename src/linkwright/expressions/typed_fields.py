"""Typed fields: what the numbers and names of a file are, stated in the annotations of the fields that hold them.

    mass: Annotated[Expression | None, Quantity(MASS, Sign.NOT_NEGATIVE, "mass")] = None
    window: Annotated[Name | None, Ref("window")] = None
    start: Annotated[Expression | None, Quantity(lambda c: ANGLE if c.entry.turns else LENGTH)] = None

What is said holds for all within that says nothing else: both ends of an interval, every number of a list, the values
of a mapping, the fields of an entry. The keys of a mapping have annotations of their own. Values with a spelling of
their own, such as positions, know what their numbers are (``quantities``). :mod:`linkwright.model.walk` finds them all.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import field
from enum import Enum
from typing import Any, NamedTuple

from pydantic import GetJsonSchemaHandler
from pydantic_core import CoreSchema

from linkwright.data_classes import dataclass
from linkwright.expressions.dimensions import Wanted
from linkwright.expressions.field_schema import with_kind, with_quantity
from linkwright.expressions.units import Dimension
from linkwright.expressions.written import FrozenDict

Path = tuple[str | int, ...]


class Scope(Enum):
    """What an expression may name besides parameters and functions."""

    CONSTANT = "constant"
    LOAD = "load"
    TIME = "time"
    SIGNALS = "signals"
    FORMULA = "formula"
    TURN = "turn"
    FOLLOWS = "follows"


class Sign(Enum):
    """Which values a quantity may have; of an interval, its lower end."""

    ANY = "any"
    NOT_NEGATIVE = "not negative"
    POSITIVE = "positive"


class Ends(Enum):
    """How the two ends of an interval must lie."""

    ANY = "any"
    RISING = "low < high"
    ORDERED = "low <= high"


class Context(NamedTuple):
    """Where a field stands: in which mechanism, at which path of the file, within which entries, outermost first."""

    mechanism: Any  # linkwright.model.mechanism.Mechanism, which is made of such fields
    path: Path = ()
    entries: tuple[Any, ...] = ()

    @property
    def entry(self) -> Any:
        """The entry that has the field."""
        return self.entries[-1]

    @property
    def name(self) -> str:
        """The name of the section's entry, such as that of a drive."""
        return str(self.path[1])

    def child(self, *keys: str | int) -> Context:
        """A place below."""
        return Context(self.mechanism, (*self.path, *keys), self.entries)


@dataclass(frozen=True)
class Quantity:
    """What an expression is: its ``dimension``, the ``sign`` that its value must have, and of which ``term`` a finding
    on that speaks; how its two ``ends`` must lie where it is an interval.

    ``names`` are what the place itself gives a meaning. Dimension, sign and names may depend on where the field stands;
    a dimension of ``None`` means that it can't be told.
    """

    dimension: Wanted | Callable[[Context], Wanted | None]
    sign: Sign | Callable[[Context], Sign] = Sign.ANY
    term: str = "number"
    scope: Scope = Scope.CONSTANT
    names: Mapping[str, Dimension] | Callable[[Context], Mapping[str, Dimension]] = field(default_factory=FrozenDict)
    ends: Ends = Ends.ANY
    choices: tuple[Dimension, ...] = ()
    """The dimensions that it may turn out to have, where that depends on where it stands."""
    whole: bool = False
    """Whether it counts something, such as teeth: no slider of a page moves it."""

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        known = (self.dimension,) if isinstance(self.dimension, Dimension) else self.choices
        return with_quantity(handler(schema), known)

    def dimension_at(self, context: Context) -> Wanted | None:
        """The dimension wanted at a place."""
        return self.dimension(context) if callable(self.dimension) else self.dimension

    def names_at(self, context: Context) -> Mapping[str, Dimension]:
        """What the place gives a meaning, with its dimension."""
        return self.names(context) if callable(self.names) else self.names

    def sign_at(self, context: Context) -> Sign:
        """The sign wanted at a place."""
        return self.sign(context) if callable(self.sign) else self.sign


def of_drive(
    turning: Dimension,
    sliding: Dimension,
    drive: Callable[[Context], str] = lambda c: str(c.path[-1]),
    scope: Scope = Scope.CONSTANT,
) -> Quantity:
    """A quantity of the motion that a ``drive`` prescribes, where that turns and where it slides; the drive is the one
    by whose name it stands, unless another is told."""

    def dimension(c: Context) -> Dimension | None:
        name = drive(c)
        if name not in c.mechanism.movers:
            return None
        return turning if c.mechanism.prescribed(name).turns else sliding

    return Quantity(dimension, scope=scope, choices=(turning, sliding))


def of_parameter(place: int) -> Quantity:
    """A value of the parameter whose name is this key of its path."""
    return Quantity(lambda c: str(c.path[place]) if c.path[place] in c.mechanism.parameters else None)


@dataclass(frozen=True)
class Ref:
    """That a text names an element of a ``kind`` ("link", "window", ...).

    ``of`` is the entry's attribute for the link on which a point lies, or for the two links of two points; or a
    function that tells the link. Without one, or where it gives ``None``, the point may lie on any link.
    """

    kind: str
    of: str | Callable[[Context], str | None] | None = None

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        return with_kind(handler(schema), self.kind)

    def link_at(self, context: Context) -> str | None:
        """The link on which a point that stands at a place must lie."""
        if self.of is None or callable(self.of):
            return self.of and self.of(context)
        links: str | tuple[str, ...] | None = getattr(context.entry, self.of)
        return links[int(context.path[-1])] if isinstance(links, tuple) else links


@dataclass(frozen=True)
class Elsewhere:
    """That what stands here is stated in another place too, and looked at there."""


ELSEWHERE = Elsewhere()


@dataclass(frozen=True)
class Named:
    """That a text is a name of a ``namespace``, or else has expressions of signals in it, from and to where ``parts``
    tells. Whether there is such an element is looked at by the entry."""

    namespace: str = ""
    parts: Callable[[str], Iterable[tuple[int, int]]] | None = None


@dataclass(frozen=True)
class OwnScope:
    """That the names and numbers within have a meaning there alone, and aren't found with those around."""


OWN_SCOPE = OwnScope()


@dataclass(frozen=True)
class Declared:
    """That the keys of a mapping are names of elements which it declares."""


DECLARED = Declared()
