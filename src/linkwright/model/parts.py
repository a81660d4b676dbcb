"""The bodies of a model as its file states them: units, parameters, links, pins and slides."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Annotated, Any, ClassVar, Literal, Self

from pydantic import (
    BeforeValidator,
    Discriminator,
    Field,
    GetJsonSchemaHandler,
    PlainSerializer,
    Tag,
)
from pydantic_core import CoreSchema

from linkwright.elements.distances import ByDistances
from linkwright.elements.entries import NumberFault
from linkwright.elements.fields import (
    INERTIA,
    Interval,
    TwoLines,
    TwoLinks,
    TwoPoints,
    freeze,
)
from linkwright.elements.mirror import Mirror
from linkwright.expressions import units as u
from linkwright.expressions.fields import (
    Expression,
    Frozen,
    FrozenDict,
    LongText,
    Name,
    Position,
    Shape,
    Text,
    Two,
)
from linkwright.expressions.typed_fields import DECLARED, Ends, Quantity, Ref, Sign, of_parameter
from linkwright.expressions.written import Fault, Shortened, plain_number, unexpected
from linkwright.findings import Joined
from linkwright.model.tolerances import Tolerance
from linkwright.notation import Pair, Scalar


class Units(Frozen):
    """What bare numbers mean: the unit of each quantity that the file gives without one."""

    length: Text | None = Field(None, examples=["mm", "m", "in"])
    angle: Text | None = Field(None, examples=["deg", "rad"])
    mass: Text | None = Field(None, examples=["kg", "g"])
    time: Text | None = Field(None, examples=["s", "ms", "min"])
    force: Text | None = Field(None, examples=["N", "kN"])
    torque: Text | None = Field(None, examples=["N*m", "N*mm"])
    pressure: Text | None = Field(None, examples=["bar", "MPa"])

    @property
    def declared(self) -> dict[str, str]:
        """The declared words by quantity."""
        return self.model_dump(exclude_none=True)


OWN = of_parameter(1)
"""What is of the dimension of the parameter that has it."""


class Parameter(Shortened):
    """A named value, that a study may vary or differentiate by. In a file mostly written as its value alone."""

    main = "value"

    value: Annotated[Expression, OWN]
    tolerance: Annotated[Tolerance | None, OWN] = None
    note: LongText | None = None


def _direction(raw: Any) -> Any:
    if not isinstance(raw, list | tuple) or len(raw) != 3:
        raise unexpected("direction", raw)
    numbers = tuple(float(plain_number(part, "direction")) for part in raw)
    if not any(numbers):
        raise unexpected("direction", raw)
    return numbers


class Plane(Shortened):
    """The plane of a sketch in the vehicle's coordinates. Mostly written as two axes alone."""

    main = "axes"

    axes: Literal["xy", "xz", "yz", "yx", "zx", "zy"] | None = None
    normal: Annotated[tuple[float, float, float], BeforeValidator(_direction)] | None = None
    within: Annotated[Expression | None, Quantity(u.LENGTH)] = None

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        if "axes" in given and "normal" in given:
            yield "sketch.plane-twice", {}


def _named(raw: Any) -> Any:
    """A list of names stands for points whose places are those of the sketch."""
    if not isinstance(raw, list | tuple) or not raw:
        return raw
    for name in raw:
        if not isinstance(name, str):
            raise unexpected("points", name)
    return dict.fromkeys(raw, "sketch")


def _way(raw: Any) -> str:
    """The branch of a place's union, by its looks: a mapping states distances, unless it is of ``x`` and ``y``."""
    stated = isinstance(raw, Mapping) and not raw.keys() <= {"x", "y"}
    return "distances" if stated or isinstance(raw, ByDistances) else "position"


PlaceOnLink = Annotated[
    Annotated[Position, Tag("position")] | Annotated[ByDistances, Tag("distances")], Discriminator(_way)
]


def _points_as_written(points: Mapping[str, PlaceOnLink]) -> Any:
    by_name = points and all(place.sketched for place in points.values())
    return [*points] if by_name else {name: place.raw for name, place in points.items()}


class _ByName:
    """The schema of points: also a list of names."""

    @classmethod
    def __get_pydantic_json_schema__(cls, schema: CoreSchema, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        return {"anyOf": [handler(schema), {"type": "array", "items": {"type": "string"}}]}


Points = Annotated[
    dict[Annotated[Name, DECLARED], PlaceOnLink],
    BeforeValidator(_named),
    freeze,
    PlainSerializer(_points_as_written),
    _ByName,
]


MASS = Quantity(u.MASS, Sign.NOT_NEGATIVE, "mass")


class Link(Frozen):
    """A rigid link: its points in its own frame, and its mass if it has one."""

    points: Points
    mass: Annotated[Expression | None, MASS] = None
    com: Position | None = None
    inertia: Annotated[Expression | None, INERTIA] = None
    shape: Annotated[Shape | None, Ref("point", of=lambda c: c.name)] = None

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        about = [key for key in ("com", "inertia") if key in given]
        if "shape" in given and about:
            yield "mass.shape-and-com", {"given": Joined(about)}
        elif "mass" in given and "shape" not in given and len(about) < 2:
            missing = [key for key in ("com", "inertia") if key not in given]
            yield "mass.incomplete", {"missing": Joined(missing)}
        if "mass" not in given and (about or "shape" in given):
            yield "mass.missing", {"given": Joined([*about, *(["shape"] if "shape" in given else [])])}

    def mirrored(self, name: str, mirror: Mirror) -> Self:
        """The same link seen in a mirror."""
        points = {
            point: at.mirrored() if isinstance(at, ByDistances) else mirror.position(name, at)
            for point, at in self.points.items()
        }
        com = None if self.com is None else mirror.position(name, self.com)
        return self.model_copy(update={"points": FrozenDict(points), "com": com})

    def place(self, number: Callable[[Expression, u.Dimension], Scalar], point: str) -> Pair:
        """The coordinates (m) of a point in the link's frame; ``number`` gives values in SI."""
        found: Pair = self.points[point].coordinates(number, lambda other: self.place(number, other))
        return found


class Joint(Frozen):
    """A prismatic joint (a line on each of two links), or a revolute one between points of different names."""

    prismatic: TwoLinks | None = None
    line: Annotated[TwoLines | None, Ref("point", of="prismatic")] = None
    travel: Annotated[Interval | None, Quantity(u.LENGTH, ends=Ends.RISING)] = None
    revolute: TwoLinks | None = None
    at: Annotated[TwoPoints | None, Ref("point", of="revolute")] = None

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        if ("prismatic" in given) == ("revolute" in given):
            yield "joint.kind", {}
        elif "prismatic" in given and ("line" not in given or "at" in given):
            yield "joint.line", {}
        elif "revolute" in given and ("at" not in given or "line" in given):
            yield "joint.at", {}
        elif "revolute" in given and "travel" in given:
            yield "joint.travel", {}

    signals: ClassVar[Mapping[str, u.Dimension]] = {}  # slides have theirs in model/signals.py
    couple: ClassVar[bool] = False
    follows: ClassVar[bool] = False
    one_sided: ClassVar[Mapping[str, int]] = {}
    touching: ClassVar[None] = None
    joins: ClassVar[Mapping[str, tuple[Expression, ...]]] = {}
    kinks: ClassVar[tuple[str, ...]] = ()
    lifts: ClassVar[Mapping[str, str]] = {}

    def mirrored(self, name: str, mirror: Mirror) -> Self:
        """The same joint seen in a mirror: along its lines the travel stays as it is."""
        if self.line is None:
            return self
        lines = tuple(mirror.line(link, line) for link, line in zip(self.links, self.line, strict=True))
        return self.model_copy(update={"line": lines})

    @property
    def limits(self) -> Two | None:
        """The lowest and the highest travel that it allows."""
        return self.travel

    def number_faults(self, value: Any) -> Iterator[NumberFault]:
        """What may be wrong with the values of its numbers together: nothing that the fields don't say."""
        yield from ()

    def place_faults(self, places: Any, nominal: bool) -> Iterator[NumberFault]:
        """The same with the places of points."""
        yield from ()

    @property
    def joint_points(self) -> tuple[str, ...]:
        """The point of each link that the joint is stated by."""
        return self.at or tuple(line.point for line in self.line or ())

    @property
    def kind(self) -> str:
        """The name of its kind: the key that names its links."""
        return "prismatic" if self.prismatic else "revolute"

    @property
    def links(self) -> tuple[str, ...]:
        """The two links joined."""
        pair = self.prismatic or self.revolute
        assert pair is not None
        return pair
