"""The model: an immutable mechanism as its file states it. Expressions and written units are kept."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Annotated, Any, Self

from pydantic import (
    BaseModel,
    BeforeValidator,
    Field,
    GetCoreSchemaHandler,
    GetJsonSchemaHandler,
    PrivateAttr,
    SerializationInfo,
    SerializeAsAny,
    ValidationError,
    ValidatorFunctionWrapHandler,
)
from pydantic_core import CoreSchema, InitErrorDetails, core_schema

from linkwright.elements.cam_contact.entry import Cam
from linkwright.elements.counterweight import Counterweight
from linkwright.elements.cylinder import Cylinder
from linkwright.elements.drive import Drive
from linkwright.elements.entries import ENTRIES, entries_by_key, keys_of
from linkwright.elements.fields import freeze
from linkwright.elements.follower import Follower
from linkwright.elements.force import Acting, acting
from linkwright.elements.friction import Friction
from linkwright.elements.load import Load
from linkwright.elements.mover import Mover
from linkwright.elements.path import Coordinate, PointPath
from linkwright.elements.points import FRAME
from linkwright.elements.spring import Spring
from linkwright.escape import line
from linkwright.expressions.fields import (
    AssemblyRule,
    Frozen,
    FrozenDict,
    LongText,
    Name,
    Place,
    Requirement,
    Text,
    fault,
)
from linkwright.expressions.typed_fields import Ref
from linkwright.expressions.unknown import alike
from linkwright.expressions.written import FaultWithin, unexpected
from linkwright.findings import CLAUSES, Joined
from linkwright.model.actions import BOUND, Table, Window
from linkwright.model.gravity import Gravity
from linkwright.model.motions import MotionLaw
from linkwright.model.parts import Joint, Link, Parameter, Plane, Units
from linkwright.plugins import load
from linkwright.reductions import ENTRIES as MEASURES
from linkwright.reductions import Measure

__all__ = [
    "FRAME",
    "Cam",
    "Counterweight",
    "Cylinder",
    "Drive",
    "Friction",
    "Joint",
    "Link",
    "Load",
    "Measure",
    "Mechanism",
    "MotionLaw",
    "Parameter",
    "Spring",
    "Table",
    "Units",
    "Window",
]

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

FOLLOWING = ("cams", "joints")
"""The sections in which joints stand that have a link follow a drive."""


class _AnyKind:
    """An entry of any kind: one whose kind is among its keys, or the section's ``usual`` one with its ``own`` keys."""

    def __init__(self, section: str, usual: type[BaseModel], *own: str) -> None:
        self.entries, self.section, self.usual, self.own = ENTRIES[section], section, usual, {*own}

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        def read(raw: Any, usual: ValidatorFunctionWrapHandler) -> Any:
            if type(raw) in self.entries.values():
                return raw
            if not isinstance(raw, Mapping):
                return usual(raw)
            if len(kinds := self.entries_of(raw)) > 1:
                raise fault("file.kinds", keys=_distinct_keys(raw, kinds))
            if kind := self.entries.get(next(iter(kinds), "")):
                return kind.model_validate(raw)
            if (misspelled := self.misspelled(raw)) is not None:
                raise ValidationError.from_exception_data(self.section, [misspelled])
            return usual(raw)

        return core_schema.no_info_wrap_validator_function(
            read,
            handler(source),
            serialization=core_schema.plain_serializer_function_ser_schema(_dumped, info_arg=True),
        )

    def entries_of(self, raw: Mapping[str, Any]) -> dict[str, type[BaseModel]]:
        """The entries of the kinds that the keys of one speak of, by these keys; the usual one has none."""
        kinds = entries_by_key(raw, self.usual)
        if self.own.intersection(raw).difference(*map(keys_of, kinds.values())):
            kinds[""] = self.usual
        return kinds

    def kinds(self, raw: Any) -> list[type]:
        """The entries of which one may be, as far as its keys tell."""
        keys = raw.keys() if isinstance(raw, Mapping) else ()
        if chosen := [entry for kind, entry in self.entries.items() if kind in keys]:
            return chosen
        return [self.usual] if self.own & {*keys} else [self.usual, *self.entries.values()]

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        load("elements")
        others = [handler(entry.__pydantic_core_schema__) for entry in self.entries.values()]
        return {"anyOf": [handler(schema), *others]} if others else handler(schema)

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
        return [entry for name, entry in MEASURES.items() if name in keys] or [*MEASURES.values()]

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


_Joint = Annotated[Joint, _AnyKind("joints", Joint, "prismatic", "revolute")]
_Load = Annotated[Load, _AnyKind("loads", Load, "force", "torque")]
_Spring = Annotated[Spring, _AnyKind("springs", Spring, "from", "to", "turns")]
_Counterweight = Annotated[Counterweight, _AnyKind("counterweights", Counterweight, "mass")]
_Friction = Annotated[Friction, _AnyKind("friction", Friction, "pin", "slide")]


class Mechanism(Frozen):
    """Links, joints, drives, loads, parameters and measures of one planar mechanism.

    Made by the file format and by :class:`linkwright.Builder` alike; validated in itself when made, as a whole
    by :func:`linkwright.check`.
    """

    name: Text = "mechanism"
    note: LongText | None = None
    source: LongText | None = None
    author: Text | None = None
    revision: Text | None = None
    units: Units = Units()
    gravity: Gravity | None = None
    parameters: Annotated[dict[Name, Parameter], _bound, freeze] = Field(default_factory=FrozenDict)
    sketch: Annotated[dict[Name, Place], _bound, freeze] = Field(default_factory=FrozenDict)
    plane: Plane | None = None
    links: Annotated[dict[Name, Link], at_most(MAX_LINKS), freeze]
    joints: Annotated[dict[Name, _Joint], _bound, freeze] = Field(default_factory=FrozenDict)
    cylinders: Annotated[dict[Name, Cylinder], _bound, freeze] = Field(default_factory=FrozenDict)
    assembly: Annotated[dict[Annotated[Name, Ref("pivot")], AssemblyRule], _bound, freeze] = Field(
        default_factory=FrozenDict
    )
    drives: Annotated[dict[Name, Drive], _bound, freeze] = Field(default_factory=FrozenDict)
    paths: Annotated[dict[Name, PointPath], _bound, freeze] = Field(default_factory=FrozenDict)
    tables: Annotated[dict[Name, Table], _bound, freeze] = Field(default_factory=FrozenDict)
    laws: Annotated[dict[Name, MotionLaw], _bound, freeze] = Field(default_factory=FrozenDict)
    cams: Annotated[dict[Name, Cam], _bound, freeze] = Field(default_factory=FrozenDict)
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

    _followers: Mapping[str, Follower] = PrivateAttr(default_factory=FrozenDict)

    @property
    def followers(self) -> Mapping[str, Follower]:
        """The joints that have a link follow a drive, where short forms are spelled out."""
        return self._followers

    @property
    def movers(self) -> Mapping[str, Mover]:
        """Whatever prescribes a motion: the drives, then the followers."""
        return {**self.drives, **self._followers}

    def path_of(self, mover: str) -> tuple[str, str]:
        """The place in the file of a drive or follower: cams have a section of their own, all other followers stand
        among the joints."""
        return next((section, mover) for section in ("drives", *FOLLOWING) if mover in getattr(self, section))

    def with_followers(self, found: Mapping[str, Follower]) -> Self:
        """The same with these followers."""
        made = self.model_copy()
        made._followers = FrozenDict(found)
        return made

    def without_mover(self, name: str) -> Self:
        """The same without a drive or follower."""
        made = self.model_copy(update={"drives": FrozenDict({n: d for n, d in self.drives.items() if n != name})})
        made._followers = FrozenDict({n: follower for n, follower in self._followers.items() if n != name})
        return made

    def prescribed(self, mover: str) -> Mover:
        """What prescribes a motion: of a drive with an output, the same law between the output's links."""
        entry = self.drives.get(mover)
        if entry is None or entry.output is None:
            return entry or self._followers[mover]
        if (path := self.paths.get(entry.output)) is not None:
            return Coordinate(path, entry.output, self.path_drives(entry.output).index(mover) > 0)
        if (joint := self.joints.get(entry.output)) is not None:
            on, link = joint.links
            return entry.model_copy(update={"turns": None, "slides": link, "on_": on})
        return entry.model_copy(update={"turns": entry.output, "slides": None, "on_": FRAME})

    def path_drives(self, path: str) -> list[str]:
        """The drives that move a point along a path: of two the first prescribes x, the second y."""
        return [name for name, drive in self.drives.items() if drive.output == path]

    def path_law(self, drive: str) -> PointPath | None:
        """The path that has the law of a drive, if it isn't the drive's own."""
        return self.paths.get(self.drives[drive].output or "")

    @property
    def title(self) -> str:
        """The name as results and other tools get it: in one line."""
        return line(self.name)

    def prismatic_joints(self) -> Iterator[tuple[str, Joint]]:
        """The prismatic joints by name."""
        return ((name, joint) for name, joint in self.joints.items() if joint.prismatic)

    def joints_but_pins(self) -> Iterator[tuple[str, Joint]]:
        """The joints that only the file's ``joints`` state, by name: all but the revolute ones, which are pins."""
        return ((name, joint) for name, joint in self.joints.items() if not joint.revolute and not joint.follows)

    def acting(self) -> Iterator[Acting]:
        """What acts on links or weighs, whatever its kind: loads, springs, counterweights, friction."""
        return acting(self)

    def has_mass(self, link: str) -> bool:
        """Whether a link has mass, its own or a counterweight's."""
        weights = (one.kind.weighs(one.entry) for one in self.acting())
        return self.links[link].mass is not None or any(weight.link == link for weight in weights if weight)
