"""What a file says of elements whose kinds are chosen by a key, and need not be of this package.

In each section the usual entries stand without such a key: pins and slides among the joints, springs among the springs.
A kind of another package is made known by a module that registers it (:mod:`linkwright.plugins`). Such modules are
loaded when a file names a kind that isn't known yet, and for the schema.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any, ClassVar, Protocol, Self

from pydantic import BaseModel

from linkwright.elements.kind_modules import chosen_in
from linkwright.elements.mirror import Mirror, NotMirroredError
from linkwright.expressions.fields import Expression, Frozen
from linkwright.expressions.typed_fields import Context, Quantity, Sign
from linkwright.expressions.units import Dimension
from linkwright.expressions.written import FaultWithin
from linkwright.notation import Pair
from linkwright.notation.registry import Registry
from linkwright.plugins import load
from linkwright.words import add

NumberFault = tuple[Any, Sign, FaultWithin]
"""A condition on numbers, as arithmetic on them: what must have the sign, and the fault of an entry where it hasn't."""


class UnknownPlaceError(LookupError):
    """A place was asked for that a file names but doesn't state: the check of names reports it."""


class StatedPlaces(Protocol):
    """Numbers of a file as conditions ask them: in SI, numbers, arrays of samples, or symbols."""

    @property
    def mechanism(self) -> Any:
        """The model."""

    def number(self, expression: Expression, dimension: Dimension) -> Any:
        """The value of an expression."""

    def point(self, link: str, name: str) -> Pair:
        """A named point of a link, in its frame (m). Raises :class:`UnknownPlaceError` where the file states none."""

    def text_of(self, value: Any, dimension: Dimension) -> str:
        """A value as the file has such ones, with its unit."""


class ElementEntry(Frozen):
    """Base of the entries of kinds of elements."""

    kind: ClassVar[str]
    """The name of the kind."""

    def mirrored(self, name: str, mirror: Mirror) -> Self:
        """The same element of that name seen in a mirror. Raises :class:`NotMirroredError` where that isn't told."""
        raise NotMirroredError

    def number_faults(self, value: Callable[[Expression, Dimension], Any]) -> Iterator[NumberFault]:
        """What may be wrong with its numbers together; ``value`` gives them in SI: numbers, arrays of samples, or
        symbols."""
        yield from ()


class JointEntry(ElementEntry):
    """Base of the entries of kinds beyond pins and slides. The key that is named after the kind has the links. Which
    of its texts name links and points say :class:`~linkwright.expressions.typed_fields.Ref` s, as for other entries."""

    signals: ClassVar[Mapping[str, Dimension]] = {}
    """The attributes of ``NAME.`` with their dimensions (SI)."""
    couple: ClassVar[bool] = False
    """Whether reactions have a moment about the place at which they are stated."""
    follows: ClassVar[bool] = False
    """Whether it has a link follow a drive (:mod:`linkwright.elements.follower`): then structure has no joint there."""
    lifts: ClassVar[Mapping[str, str]] = {}
    """The codes of warnings where a signal of :attr:`one_sided` has the other sign, if it isn't that of contacts."""
    prismatic: ClassVar[None] = None
    revolute: ClassVar[None] = None
    line: ClassVar[None] = None
    at: ClassVar[None] = None

    @property
    def links(self) -> tuple[str, ...]:
        """The links joined."""
        return tuple(getattr(self, self.kind))

    @property
    def joint_points(self) -> tuple[str, ...]:
        """The point of each link that the joint is stated by."""
        raise NotImplementedError

    @property
    def touching(self) -> tuple[str, str] | None:
        """The links that slide past each other at one place, if they do (:meth:`JointKind.touch`)."""
        return None

    @property
    def limits(self) -> tuple[Expression, Expression] | None:
        """The lowest and the highest value of ``NAME.s`` that it allows."""
        return None

    @property
    def one_sided(self) -> Mapping[str, int]:
        """Its forces that have one sign only, as contact can't pull: 1 for those that must not be negative, else -1."""
        return {}

    @property
    def kinks(self) -> tuple[str, ...]:
        """Those of its signals at whose changes of sign its forces have a kink."""
        return ()

    @property
    def joins(self) -> Mapping[str, tuple[Expression, ...]]:
        """The values of its signals at which curves of its closure join, so that the links' jerk jumps there."""
        return {}

    def name_faults(self, mechanism: Any) -> Iterator[FaultWithin]:
        """What is wrong with how it lies among the links and pins, besides names that no element has."""
        yield from ()

    def place_faults(self, places: StatedPlaces, nominal: bool) -> Iterator[NumberFault]:
        """What may be wrong with its numbers together with the places of points; ``nominal`` numbers are looked at more
        closely than those that vary about them by tolerances. Names are sound."""
        yield from ()


class ForceEntry(ElementEntry):
    """Base of the entries of what acts on links. Where another kind than the usual one of its section stands, a key is
    named after it."""

    def dimension(self, key: str) -> Dimension:
        """The dimension of one of its quantities, as its field says."""
        said = type(self).model_fields[key].metadata
        quantity = next(of for of in said if isinstance(of, Quantity))
        found = quantity.dimension_at(Context(None, entries=(self,)))
        assert isinstance(found, Dimension)
        return found


NOUNS = {"loads": "load", "springs": "spring", "counterweights": "counterweight", "friction": "friction"}
"""The sections of what acts on links, in the order in which it acts, and what one of each is called."""
SECTIONS = ("joints", *NOUNS)
"""The sections of a file in which elements of several kinds stand."""
ENTRIES: Mapping[str, Registry[type[JointEntry] | type[ForceEntry]]] = {
    section: Registry(chosen_in(section)) for section in SECTIONS
}
"""By section the entries that are chosen by a key, by the names of their kinds."""


def make_known(
    section: str, name: str, entry: type[JointEntry] | type[ForceEntry] | None, words: Mapping[str, Mapping[str, str]]
) -> None:
    """Make a kind's entry known under its name, where it is chosen by a key, and its texts, by language and key. The
    registry of the kind has refused a second one of the name: the same entry comes again after an interrupted import.
    """
    if entry is not None and ENTRIES[section].get(name) is not entry:
        ENTRIES[section][name] = entry
    for language, texts in words.items():
        add(language, texts)


def keys_of(entry: type[BaseModel]) -> set[str]:
    """The keys of an entry as files have them."""
    return {field.alias or name for name, field in entry.model_fields.items()}


def entries_by_key(keys: Iterable[Any], usual: type[BaseModel]) -> dict[Any, type[BaseModel]]:
    """The entries of the kinds, of any section, that the keys of one entry name; ``usual`` is that of no such key."""
    keys = {*keys}
    others = keys - keys_of(usual)

    def named_entries() -> dict[Any, type[BaseModel]]:
        return {key: of[key] for of in ENTRIES.values() for key in of if key in others}

    if keys.difference(*map(keys_of, named_entries().values() or [usual])):
        load("elements")
    return named_entries()
