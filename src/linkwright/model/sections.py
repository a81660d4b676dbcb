"""The sections of a model file that hold elements by name, of a mechanism and of a sub-assembly alike."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property
from importlib import import_module
from typing import TYPE_CHECKING, Annotated, Any, cast

from pydantic import (
    BaseModel,
    BeforeValidator,
    Field,
    GetCoreSchemaHandler,
    GetJsonSchemaHandler,
    SerializationInfo,
    SerializeAsAny,
    ValidationError,
)
from pydantic_core import CoreSchema, InitErrorDetails, core_schema

from linkwright.elements.cylinder import Cylinder
from linkwright.elements.drive import Drive
from linkwright.elements.entries import ENTRIES, ElementEntry, entries_by_key, keys_of
from linkwright.elements.fields import freeze
from linkwright.expressions.fields import AssemblyRule, Frozen, FrozenDict, Name, Place, Requirement, fault
from linkwright.expressions.typed_fields import Ref
from linkwright.expressions.unknown import alike
from linkwright.expressions.written import FaultWithin, unexpected
from linkwright.findings import CLAUSES, Joined
from linkwright.model.actions import BOUND, Table, Window
from linkwright.model.copy_entry import Copy
from linkwright.model.motions import MotionLaw
from linkwright.model.parts import Joint, Link, Parameter
from linkwright.plugins import load
from linkwright.reductions import ENTRIES as MEASURES
from linkwright.reductions import Measure

if TYPE_CHECKING:
    from linkwright.elements.cam_contact.entry import Cam
    from linkwright.elements.counterweight import Counterweight
    from linkwright.elements.friction import Friction
    from linkwright.elements.load import Load
    from linkwright.elements.path import PointPath
    from linkwright.elements.spring import Spring
else:  # their classes are imported by WhenThere
    Cam = Counterweight = Friction = Load = PointPath = Spring = BaseModel

MAX_ENTRIES, MAX_LINKS = 1000, 200
"""The most entries that one section may hold; of links fewer, since their decomposition is searched for."""


def at_most(limit: int) -> BeforeValidator:
    """Refuses a section of more entries than that, and what is no mapping."""

    def check(raw: Any) -> Any:
        if not isinstance(raw, Mapping):
            raise unexpected("mapping", raw)
        if len(raw) > limit:
            raise fault("file.too-many", count=len(raw), limit=limit)
        return raw

    return BeforeValidator(check)


_bound = at_most(MAX_ENTRIES)


class WhenThere:
    """An entry whose class, at a ``place`` of this package such as ``model.copy_entry.Copy``, is imported and made
    ready by pydantic when a file has one: few files have all sections."""

    def __init__(self, place: str) -> None:
        self.place = place

    @cached_property
    def usual(self) -> type[BaseModel]:
        """The class."""
        module, _, name = self.place.rpartition(".")
        return cast(type[BaseModel], getattr(import_module(f"linkwright.{module}"), name))

    def kinds(self, raw: Any) -> list[type]:
        """The entries of which one may be, as far as its keys tell."""
        return [self.usual]

    def read(self, raw: Any) -> Any:
        """The entry from plain data, or as it is."""
        return self.usual.model_validate(raw)

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        return core_schema.no_info_plain_validator_function(
            self.read, serialization=core_schema.plain_serializer_function_ser_schema(_dumped, info_arg=True)
        )

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        """That of the class, once for all sections that have such entries."""
        ref = f"{self.usual.__module__}.{self.usual.__qualname__}:{id(self.usual)}"  # as pydantic names classes
        stated = cast(CoreSchema, {**self.usual.__pydantic_core_schema__, "ref": ref})
        return handler(core_schema.definitions_schema(core_schema.definition_reference_schema(ref), [stated]))


class _AnyKind(WhenThere):
    """An entry of any kind: one whose kind is among its keys, or the section's ``usual`` one with its ``own`` keys."""

    def __init__(self, section: str, usual: str, *own: str) -> None:
        super().__init__(usual)
        self.entries, self.section, self.own = ENTRIES[section], section, {*own}

    def read(self, raw: Any) -> Any:
        """The entry from plain data, or as it is."""
        if isinstance(raw, ElementEntry) and type(raw) is self.entries.get(raw.kind):
            return raw
        if not isinstance(raw, Mapping):
            return super().read(raw)
        if len(kinds := self.entries_of(raw)) > 1:
            raise fault("file.kinds", keys=_distinct_keys(raw, kinds))
        if kind := self.entries.get(next(iter(kinds), "")):
            return kind.model_validate(raw)
        if (misspelled := self.misspelled(raw)) is not None:
            raise ValidationError.from_exception_data(self.section, [misspelled])
        return super().read(raw)

    def entries_of(self, raw: Mapping[str, Any]) -> dict[str, type[BaseModel]]:
        """The entries of the kinds that the keys of one speak of, by these keys; the usual one has none."""
        kinds = entries_by_key(raw, self.usual)
        if self.own.intersection(raw).difference(*map(keys_of, kinds.values())):
            kinds[""] = self.usual
        return kinds

    def kinds(self, raw: Any) -> list[type]:
        keys = raw.keys() if isinstance(raw, Mapping) else ()
        if chosen := [self.entries[kind] for kind in self.entries if kind in keys]:
            return chosen
        return [self.usual] if self.own & {*keys} else [self.usual, *self.entries.values()]

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        load("elements")
        usual = super().__get_pydantic_json_schema__(schema, handler)
        others = [handler(entry.__pydantic_core_schema__) for entry in self.entries.values()]
        return {"anyOf": [usual, *others]} if others else usual

    def misspelled(self, raw: Mapping[str, Any]) -> InitErrorDetails | None:
        """The fault of a key that was to be a kind; what stands beside it is looked at once that is right."""
        if self.own & raw.keys():
            return None
        meant = next((key for key in raw if isinstance(key, str) and alike(key, [*self.entries])), None)
        return None if meant is None else InitErrorDetails(type="extra_forbidden", loc=(meant,), input=raw[meant])


class _AnyReduction:
    """A measure of any reduction, which its keys tell."""

    def kinds(self, raw: Any) -> list[type]:
        """The entries of which one may be, as far as its keys tell."""
        keys = raw.keys() if isinstance(raw, Mapping) else ()
        return [MEASURES[name] for name in MEASURES if name in keys] or [*MEASURES.values()]

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        """All keys in one mapping: editors complete them as one writes."""
        load("measures")
        whole = handler.resolve_ref_schema(handler(schema))
        every = [handler.resolve_ref_schema(handler(e.__pydantic_core_schema__)) for e in MEASURES.values()]
        said = {key: value for one in (*every, whole) for key, value in one["properties"].items()}
        return {**whole, "properties": said}


def _distinct_keys(raw: Mapping[str, Any], kinds: Mapping[str, type[BaseModel]]) -> Joined:
    """The keys of an entry of several kinds, those of each for itself, without what they share."""
    known = {kind: keys_of(entry) for kind, entry in kinds.items()}
    others = {kind: set().union(*(known[other] for other in known if other != kind)) for kind in known}
    own = (Joined(key for key in raw if key in known[kind] - others[kind]) for kind in known)
    return Joined(own, CLAUSES)


def _dumped(entry: Any, info: SerializationInfo) -> Any:
    """An entry as plain data, as the whole is asked for."""
    return entry.model_dump(exclude_defaults=info.exclude_defaults, by_alias=bool(info.by_alias))


_Cam = Annotated[Cam, WhenThere("elements.cam_contact.entry.Cam")]
_Copy = Annotated[Copy, WhenThere("model.copy_entry.Copy")]
_Cylinder = Annotated[Cylinder, WhenThere("elements.cylinder.Cylinder")]
_Law = Annotated[MotionLaw, WhenThere("model.motions.MotionLaw")]
_Path = Annotated[PointPath, WhenThere("elements.path.PointPath")]
_Table = Annotated[Table, WhenThere("model.actions.Table")]
_Joint = Annotated[Joint, _AnyKind("joints", "model.parts.Joint", "prismatic", "revolute")]
_Load = Annotated[Load, _AnyKind("loads", "elements.load.Load", "force", "torque")]
_Spring = Annotated[Spring, _AnyKind("springs", "elements.spring.Spring", "from", "to", "turns")]
_Counterweight = Annotated[Counterweight, _AnyKind("counterweights", "elements.counterweight.Counterweight", "mass")]
_Friction = Annotated[Friction, _AnyKind("friction", "elements.friction.Friction", "pin", "slide")]


class Sections(Frozen):
    """The elements of a mechanism, or of a sub-assembly that it places, by section and name."""

    parameters: Annotated[dict[Name, Parameter], _bound, freeze] = Field(default_factory=FrozenDict)
    sketch: Annotated[dict[Name, Place], _bound, freeze] = Field(default_factory=FrozenDict)
    links: Annotated[dict[Name, Link], at_most(MAX_LINKS), freeze]
    copies: Annotated[dict[Name, _Copy], _bound, freeze] = Field(default_factory=FrozenDict)
    joints: Annotated[dict[Name, _Joint], _bound, freeze] = Field(default_factory=FrozenDict)
    cylinders: Annotated[dict[Name, _Cylinder], _bound, freeze] = Field(default_factory=FrozenDict)
    assembly: Annotated[dict[Annotated[Name, Ref("pivot")], AssemblyRule], _bound, freeze] = Field(
        default_factory=FrozenDict
    )
    drives: Annotated[dict[Name, Drive], _bound, freeze] = Field(default_factory=FrozenDict)
    paths: Annotated[dict[Name, _Path], _bound, freeze] = Field(default_factory=FrozenDict)
    tables: Annotated[dict[Name, _Table], _bound, freeze] = Field(default_factory=FrozenDict)
    laws: Annotated[dict[Name, _Law], _bound, freeze] = Field(default_factory=FrozenDict)
    cams: Annotated[dict[Name, _Cam], _bound, freeze] = Field(default_factory=FrozenDict)
    loads: Annotated[dict[Name, _Load], _bound, freeze] = Field(default_factory=FrozenDict)
    springs: Annotated[dict[Name, _Spring], _bound, freeze] = Field(default_factory=FrozenDict)
    counterweights: Annotated[dict[Name, _Counterweight], _bound, freeze] = Field(default_factory=FrozenDict)
    friction: Annotated[dict[Name, _Friction], _bound, freeze] = Field(default_factory=FrozenDict)
    windows: Annotated[dict[Name, Window], _bound, freeze] = Field(default_factory=FrozenDict)
    measures: Annotated[dict[Name, Annotated[SerializeAsAny[Measure], _AnyReduction()]], _bound, freeze] = Field(
        default_factory=FrozenDict
    )
    require: Annotated[dict[Annotated[Name, Ref("measure")], Annotated[Requirement, BOUND]], _bound, freeze] = Field(
        default_factory=FrozenDict
    )

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[FaultWithin]:
        drives = given.get("drives")
        for name, drive in drives.items() if isinstance(drives, Mapping) and not given.get("sketch") else ():
            laws = [key for key in ("start", "position") if isinstance(drive, Mapping) and drive.get(key) is not None]
            if isinstance(drive, Mapping) and drive.get("speed") is not None and not laws:
                yield "drive.start", {}, "drives", str(name)
