"""The bodies of a model as its file states them: units, parameters, links, joints and their drives."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import partial
from typing import Annotated, Any, ClassVar, Literal

from pydantic import (
    BeforeValidator,
    ConfigDict,
    Field,
    GetJsonSchemaHandler,
    PlainSerializer,
)
from pydantic_core import CoreSchema

from linkwright.elements.fields import (
    INERTIA,
    PART_LENGTH,
    Interval,
    LinkName,
    PointName,
    TwoLines,
    TwoLinks,
    TwoPoints,
    freeze,
)
from linkwright.elements.mover import TRAVEL, TURN
from linkwright.expressions import units as u
from linkwright.expressions.fields import (
    Expression,
    Frozen,
    LongText,
    Name,
    Position,
    Shape,
    Text,
    Two,
)
from linkwright.expressions.typed_fields import ELSEWHERE, Ends, Quantity, Ref, Scope, Sign, of_drive, of_parameter
from linkwright.expressions.written import Fault, FaultWithin, Shortened, plain_number, unexpected
from linkwright.model.tolerances import Tolerance


class Units(Frozen):
    """What bare numbers mean: the unit of each quantity that the file gives without one."""

    length: Text | None = Field(None, description="unit of bare lengths", examples=["mm", "m", "in"])
    angle: Text | None = Field(None, description="unit of bare angles", examples=["deg", "rad"])
    mass: Text | None = Field(None, description="unit of bare masses", examples=["kg", "g"])
    time: Text | None = Field(None, description="unit of bare times", examples=["s", "ms", "min"])
    force: Text | None = Field(None, description="unit of bare forces", examples=["N", "kN"])
    torque: Text | None = Field(
        None, description="unit of bare torques; force times length where left out", examples=["N*m", "N*mm"]
    )
    pressure: Text | None = Field(None, description="unit of bare pressures", examples=["bar", "MPa"])

    @property
    def declared(self) -> dict[str, str]:
        """The declared words by quantity."""
        return self.model_dump(exclude_none=True)


OWN = of_parameter(1)
"""What is of the dimension of the parameter that has it."""


class Parameter(Shortened):
    """A named value, that a study may vary or differentiate by. In a file mostly written as its value alone."""

    main = "value"
    alone = "the value alone"

    value: Annotated[Expression, OWN] = Field(
        description="a number, with or without unit, or arithmetic on other parameters"
    )
    tolerance: Annotated[Tolerance | None, OWN] = Field(
        None,
        description="deviation in manufacture: one number for plus and minus, [lower, upper], a class such as "
        "ISO 2768-m, h7 or IT8, or a mapping that says more",
    )
    note: LongText | None = Field(None, description="free text")


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
    alone = "the two axes alone"

    axes: Literal["xy", "xz", "yz", "yx", "zx", "zy"] | None = Field(
        None, description="the vehicle's axes that the plane's own x and y are along, e.g. xz"
    )
    normal: Annotated[tuple[float, float, float], BeforeValidator(_direction)] | None = Field(
        None, description="instead of axes: the direction of the joints' axes, [nx, ny, nz], to either side"
    )
    within: Annotated[Expression | None, Quantity(u.LENGTH)] = Field(
        None, description="how far pinned points may be off the plane; beyond is an error"
    )

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


def _points_as_written(points: Mapping[str, Position]) -> Any:
    by_name = points and all(place.sketched for place in points.values())
    return [*points] if by_name else {name: place.raw for name, place in points.items()}


class _ByName:
    """The schema of points: also a list of names."""

    @classmethod
    def __get_pydantic_json_schema__(cls, schema: CoreSchema, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        return {"anyOf": [handler(schema), {"type": "array", "items": {"type": "string"}}]}


Points = Annotated[
    dict[Name, Position],
    BeforeValidator(_named),
    freeze,
    PlainSerializer(_points_as_written),
    _ByName,
]


MASS = Quantity(u.MASS, Sign.NOT_NEGATIVE, "mass")


class Link(Frozen):
    """A rigid link: its points in its own frame, and its mass if it has one."""

    points: Points = Field(
        description="named points, [x, y] or 'r at angle' in the link's frame, or a list of the names of sketched "
        "points; a name that several links share is a pin between them"
    )
    mass: Annotated[Expression | None, MASS] = Field(None, description="mass; with com and inertia, or with shape")
    com: Position | None = Field(None, description="centre of mass in the link's frame")
    inertia: Annotated[Expression | None, INERTIA] = Field(
        None, description="moment of inertia about the centre of mass"
    )
    shape: Annotated[Shape | None, Ref("point", of=lambda c: c.name)] = Field(
        None, description="'rod A-B', 'disc RADIUS at A' or 'point A', instead of com and inertia"
    )

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        about = [key for key in ("com", "inertia") if key in given]
        if "shape" in given and about:
            yield "mass.shape-and-com", {"given": ", ".join(about)}
        elif "mass" in given and "shape" not in given and len(about) < 2:
            missing = [key for key in ("com", "inertia") if key not in given]
            yield "mass.incomplete", {"missing": ", ".join(missing)}
        if "mass" not in given and (about or "shape" in given):
            yield "mass.missing", {"given": ", ".join([*about, *(["shape"] if "shape" in given else [])])}


class Joint(Frozen):
    """A prismatic joint (a line on each of two links), or a revolute one between points of different names."""

    prismatic: TwoLinks | None = Field(None, description="the two links that slide on each other; with line")
    line: Annotated[TwoLines | None, Ref("point", of="prismatic")] = Field(
        None, description="the line on each of the two links, e.g. [H at 0 deg, G at 0 deg]"
    )
    travel: Annotated[Interval | None, Quantity(u.LENGTH, ends=Ends.RISING)] = Field(
        None, description="[lowest, highest] travel (the signal NAME.s) of a prismatic joint; a run beyond is an error"
    )
    revolute: TwoLinks | None = Field(None, description="the two links that are pinned; with at")
    at: Annotated[TwoPoints | None, Ref("point", of="revolute")] = Field(
        None, description="the pinned point of each of the two links"
    )

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
    one_sided: ClassVar[Mapping[str, int]] = {}
    joins: ClassVar[Mapping[str, tuple[Expression, ...]]] = {}

    @property
    def limits(self) -> Two | None:
        """The lowest and the highest travel that it allows."""
        return self.travel

    def wrong(self, value: Any) -> Iterator[FaultWithin]:
        """What is wrong with the values of its numbers together: nothing that the fields don't say."""
        yield from ()

    @property
    def ends(self) -> tuple[str, ...]:
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


class CylinderPart(Frozen):
    """The mass of a cylinder's barrel or rod."""

    # Its numbers are those of the link that it becomes, and looked at there.

    mass: Expression = Field(description="mass")
    com: Expression = Field(description="distance of the centre of mass from the part's own pin, towards the other")
    inertia: Expression | None = Field(
        None, description="moment of inertia about the centre of mass; that of a slender uniform rod where left out"
    )


class Cylinder(Frozen):
    """A cylinder or linear actuator between two points: barrel, rod and their slide, whose value is the distance."""

    from_: PointName = Field(alias="from", description="the point at which the barrel is pinned")
    to: PointName = Field(description="the point at which the rod is pinned")
    length: Annotated[Interval | None, PART_LENGTH] = Field(
        None, description="[shortest, longest] distance of the two pins; a run beyond is a finding"
    )
    barrel: Annotated[CylinderPart | None, ELSEWHERE] = Field(
        None, description="mass of the barrel; massless where left out"
    )
    rod: Annotated[CylinderPart | None, ELSEWHERE] = Field(None, description="mass of the rod; massless where left out")


_driven = partial(of_drive, drive=lambda c: c.name)


class Drive(Frozen):
    """A prescribed relative motion of two joined links: of ``turns``/``slides`` against ``on``, or of a slide."""

    # Said for editors here, by `faults` to the reader: either on which link, or what is extended.
    model_config = ConfigDict(json_schema_extra={"anyOf": [{"required": ["on"]}, {"required": ["extends"]}]})

    turns: LinkName | None = Field(None, description="the link that is turned, about the pin that it shares with on")
    slides: LinkName | None = Field(None, description="the link that is moved along the line that it shares with on")
    extends: Annotated[Name | None, Ref("extended")] = Field(
        None, description="the cylinder or prismatic joint whose value the drive prescribes"
    )
    on_: LinkName | None = Field(
        None, alias="on", description="the link against which the motion is measured, e.g. frame; not with extends"
    )
    speed: Annotated[Expression | None, _driven(u.OMEGA, u.SPEED)] = Field(
        None, description="constant speed, e.g. 60 rpm, or with acceleration the speed at t = 0; with start"
    )
    start: Annotated[Expression | None, _driven(u.ANGLE, u.LENGTH)] = Field(
        None, description="value at t = 0; with speed. In a model with a sketch, as drawn where left out"
    )
    acceleration: Annotated[Expression | None, _driven(u.ALPHA, u.ACCELERATION)] = Field(
        None, description="constant acceleration; speed is then that at t = 0"
    )
    position: Annotated[Expression | None, _driven(u.ANGLE, u.LENGTH, scope=Scope.TIME)] = Field(
        None, description="value as an expression in t, e.g. 20 deg*sin(180 deg*t/(1 s)); may call tables"
    )
    output: Annotated[Name | None, Ref("output")] = Field(
        None,
        description="the prismatic joint, or the link hinged on the frame, that is to follow the law; "
        "the drive's own motion and effort follow from it",
    )

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        kinds = [key for key in ("turns", "slides", "extends") if key in given]
        if len(kinds) != 1:
            yield "drive.kind", {}
        elif ("on" in given) == ("extends" in given):
            yield "drive.on", {}
        if ("speed" in given) == ("position" in given):
            yield "drive.law", {}
        elif "start" in given and "speed" not in given:
            yield "drive.start", {}
        if "acceleration" in given and "speed" not in given:
            yield "drive.acceleration", {}

    @property
    def on(self) -> str:
        """The link against which the motion is measured."""
        return self.on_ or ""

    @property
    def link(self) -> str:
        """The link that is moved."""
        name = self.turns or self.slides
        assert name is not None
        return name

    @property
    def effort(self) -> str:
        """The signal of what it exerts: ``torque`` or ``force``."""
        return "torque" if self.turns else "force"

    @property
    def rate(self) -> str:
        """The signal of its speed: ``omega`` or ``v``."""
        return "omega" if self.turns else "v"

    @property
    def signals(self) -> Mapping[str, u.Dimension]:
        """Its signals: the value with its rates, what it exerts, its power."""
        value, effort = (TURN, u.TORQUE) if self.turns else (TRAVEL, u.FORCE)
        return {**value, self.effort: effort, "power": u.POWER}
