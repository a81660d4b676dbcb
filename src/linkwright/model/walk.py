"""One walk over any part of a file: the quantities and the names that its typed fields hold.

It gives :class:`QuantityPlace` s, quantities as they are written, and :class:`Reference` s, names of elements. All
else follows from these: the places from which dimensions are inferred, checks of signs, intervals and names, options
of studies.
"""

from __future__ import annotations

import types
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from functools import cache, partial
from typing import TYPE_CHECKING, Annotated, Any, Literal, NamedTuple, Union, get_args, get_origin

from pydantic import BaseModel, RootModel

from linkwright.data_classes import dataclass
from linkwright.expressions.dimensions import Wanted
from linkwright.expressions.fields import Expression, FrozenDict, Written
from linkwright.expressions.typed_fields import (
    Context,
    Declared,
    Elsewhere,
    Named,
    OwnScope,
    Path,
    Quantity,
    Ref,
    Scope,
)
from linkwright.expressions.units import Dimension
from linkwright.expressions.written import Shortened

if TYPE_CHECKING:
    from linkwright.model.mechanism import Mechanism


class ExpressionPlace(NamedTuple):
    """One expression of a file: its path, the dimension wanted there, and what it may name; ``names`` has what the
    place itself gives a meaning, with its dimension."""

    path: Path
    expression: Expression
    wanted: Wanted
    scope: Scope = Scope.CONSTANT
    names: Mapping[str, Dimension] = FrozenDict()


class QuantityPlace(NamedTuple):
    """A quantity as it is written at one place: an expression, or the two of an interval or a position."""

    context: Context
    parts: tuple[tuple[Expression, Quantity], ...]
    written: Written | None = None
    """The value that has a spelling of its own, such as a position, in which the expressions stand."""

    @property
    def path(self) -> Path:
        """Its place in the file."""
        return self.context.path

    def places(self) -> Iterator[ExpressionPlace]:
        """Its expressions, each with its dimension, as far as that can be told."""
        for expression, of in self.parts:
            if (wanted := of.dimension_at(self.context)) is not None:
                yield ExpressionPlace(self.path, expression, wanted, of.scope, of.names_at(self.context))


class Reference(NamedTuple):
    """A name of an element where it is written."""

    context: Context
    name: str
    ref: Ref


@dataclass(frozen=True)
class Spec:
    """What an annotation says: of the values of these ``kinds``, of the keys and the values within them."""

    kinds: tuple[type, ...] = ()
    quantity: Quantity | None = None
    ref: Ref | None = None
    key: Spec | None = None
    inner: tuple[Spec, ...] = ()
    form: Literal["value", "union", "items", "list", "mapping"] = "value"
    elsewhere: bool = False
    declared: bool = False
    named: Named | None = None

    @property
    def has_typed_values(self) -> bool:
        """Whether what it describes may hold quantities or names."""
        if any(said is not None for said in (self.ref, self.quantity, self.key, self.named)) or self.declared:
            return True
        return any(issubclass(kind, BaseModel | Written) for kind in self.kinds) or any(
            s.has_typed_values for s in self.inner
        )

    def branch(self, value: Any) -> Spec:
        """Of a union, what it says of a value of that kind."""
        return next((spec for spec in self.inner if isinstance(value, spec.kinds)), _NOTHING)

    def item(self, index: int) -> Spec:
        """What it says of an item."""
        return self.inner[index if self.form == "items" else 0] if self.inner else _NOTHING


_NOTHING = Spec()


def _spec(annotation: Any, metadata: Any = ()) -> Spec:
    origin, args = get_origin(annotation), get_args(annotation)
    if origin is Annotated:
        return _spec(args[0], (*metadata, *args[1:]))
    said = {type(one): one for one in metadata}
    if OwnScope in said:
        return _NOTHING
    made = partial(
        Spec,
        quantity=said.get(Quantity),
        ref=said.get(Ref),
        elsewhere=Elsewhere in said,
        declared=Declared in said,
        named=said.get(Named),
    )
    if origin in (Union, types.UnionType):
        inner = tuple(_spec(arg) for arg in args if arg is not type(None))
        return made(tuple(kind for spec in inner for kind in spec.kinds), inner=inner, form="union")
    if origin is tuple:
        every = args[-1] is Ellipsis
        inner = tuple(_spec(arg) for arg in (args[:1] if every else args))
        return made((tuple,), inner=inner, form="list" if every else "items")
    if origin is dict:
        key = _spec(args[0])
        return made((dict,), key=key if key.has_typed_values else None, inner=(_spec(args[1]),), form="mapping")
    return made((annotation,) if isinstance(annotation, type) else ())


@cache
def _fields(entry: type[BaseModel]) -> dict[str, tuple[str, Spec]]:
    """The fields of an entry that may hold quantities or names: by their keys in the file the attribute, and what they
    hold."""
    return {key: held for key, held in all_fields(entry).items() if not held[1].elsewhere}


@cache
def all_fields(entry: type[BaseModel]) -> dict[str, tuple[str, Spec]]:
    """The same with those whose values are stated elsewhere too."""
    every = {of.alias or name: (name, _spec(of.annotation, of.metadata)) for name, of in entry.model_fields.items()}
    return {key: (name, spec) for key, (name, spec) in every.items() if spec.has_typed_values}


Found = QuantityPlace | Reference


class _Everything(list[Found]):
    """What is found, also in fields whose values are stated elsewhere too."""


def walk(entry: BaseModel, context: Context, *keys: str) -> list[Found]:
    """All quantities and names of an entry that stands at ``context``, in the order of its fields; with ``keys``, those
    of these alone, in their order."""
    found: list[Found] = []
    _entry(entry, context, None, found, keys)
    return found


def sites(entry: BaseModel, context: Context, *keys: str) -> Iterator[QuantityPlace]:
    """The quantities alone."""
    return (found for found in walk(entry, context, *keys) if isinstance(found, QuantityPlace))


def written_sites(entry: BaseModel, context: Context, *keys: str) -> Iterator[QuantityPlace]:
    """The quantities as they are written: also those of fields whose values are stated elsewhere too."""
    found = _Everything()
    _entry(entry, context, None, found, keys)
    return (one for one in found if isinstance(one, QuantityPlace))


def references(entry: BaseModel, context: Context, *keys: str) -> Iterator[Reference]:
    """The names alone."""
    return (found for found in walk(entry, context, *keys) if isinstance(found, Reference))


def _entry(entry: BaseModel, at: Context, of: Quantity | None, found: list[Found], keys: Sequence[str] = ()) -> None:
    inside = Context(at.mechanism, at.path, (*at.entries, entry))
    fields = (all_fields if isinstance(found, _Everything) else _fields)(type(entry))
    for key in keys or fields:
        name, spec = fields[key]
        if (value := getattr(entry, name)) is not None:
            # In a file mostly, or always, without its key.
            main = isinstance(entry, RootModel) or (isinstance(entry, Shortened) and key == entry.main)
            _walk(value, inside if main else inside.child(key), spec, of, None, found)


def _walk(value: Any, at: Context, spec: Spec, of: Quantity | None, ref: Ref | None, found: list[Found]) -> None:
    """Add what a value holds; ``of`` and ``ref`` are what is said around it."""
    while spec.form == "union":
        of, ref, spec = spec.quantity or of, spec.ref or ref, spec.branch(value)
    of, ref = spec.quantity or of, spec.ref or ref
    if isinstance(value, Written):
        found += (Reference(at, name, said) for name, own in value.names() if (said := own or ref) is not None)
        _site(at, value.quantities(), of, found, value)
    elif isinstance(value, str):
        if ref is not None:
            found.append(Reference(at, value, ref))
        if of is not None:
            with suppress(ValueError):  # told by the one who reads it
                found.append(QuantityPlace(at, ((Expression(value), of),)))
    elif isinstance(value, BaseModel):
        _entry(value, at, of, found)
    elif isinstance(value, Mapping):
        item = spec.item(0)
        for key, held in value.items():
            below = at.child(key)
            if spec.key is not None:
                _walk(key, below, spec.key, None, None, found)
            _walk(held, below, item, of, ref, found)
    elif isinstance(value, tuple) and spec.form == "items" and all(isinstance(part, Expression) for part in value):
        _site(at, [(part, spec.item(i).quantity) for i, part in enumerate(value)], of, found)
    elif isinstance(value, tuple):
        for i, part in enumerate(value):
            _walk(part, at.child(i), spec.item(i), of, ref, found)


def _site(
    at: Context,
    parts: Iterable[tuple[Expression, Quantity | None]],
    around: Quantity | None,
    found: list[Found],
    written: Written | None = None,
) -> None:
    """Add the site of some expressions, as far as it is said what they are."""
    known = tuple((part, said) for part, own in parts if (said := own or around) is not None)
    if known:
        found.append(QuantityPlace(at, known, written))


Options = Sequence[tuple[Path, BaseModel]]
"""What studies and exports want of a mechanism, each with its place in the file."""


def option_places(mechanism: Mechanism, options: Options) -> list[ExpressionPlace]:
    """The expressions among options, which tell the units of what the mechanism leaves open."""
    every = (site for path, given in options for site in sites(given, Context(mechanism, path)))
    return [place for site in every for place in site.places()]
