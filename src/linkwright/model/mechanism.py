"""The model: an immutable mechanism as its file states it. Expressions and written units are kept."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Any, Literal

from pydantic import AfterValidator, Field, model_validator

from linkwright.model.fields import (
    AssemblyRule,
    Expression,
    Frozen,
    FrozenDict,
    LineOn,
    Position,
    Requirement,
    Shape,
    check_name,
    fault,
)

Name = Annotated[str, AfterValidator(check_name)]
_freeze = AfterValidator(FrozenDict)


class Units(Frozen):
    """What bare numbers mean."""

    length: str | None = None
    angle: str | None = None
    mass: str | None = None
    time: str | None = None
    force: str | None = None
    torque: str | None = None
    pressure: str | None = None

    @property
    def declared(self) -> dict[str, str]:
        """The declared words by quantity."""
        return self.model_dump(exclude_none=True)


class Parameter(Frozen):
    """A named value; a study varies and differentiates by parameters. The tolerance is kept for accuracy studies."""

    value: Expression
    tolerance: Any = None
    note: str | None = None


class Link(Frozen):
    """A rigid link: its points in its own frame, and its mass if it has one."""

    points: Annotated[dict[Name, Position], _freeze]
    mass: Expression | None = None
    com: Position | None = Field(None, description="centre of mass in the link's frame")
    inertia: Expression | None = Field(None, description="moment of inertia about the centre of mass")
    shape: Shape | None = Field(None, description="'rod A-B', 'disc RADIUS at A' or 'point A', instead of com and inertia")

    @model_validator(mode="after")
    def _mass_is_whole(self) -> Link:
        if self.shape is not None and (self.com is not None or self.inertia is not None):
            raise fault("mass.shape-and-com")
        if self.mass is None and (self.shape or self.com or self.inertia):
            raise fault("mass.missing")
        if self.mass is not None and self.shape is None and (self.com is None or self.inertia is None):
            raise fault("mass.incomplete")
        return self


class Joint(Frozen):
    """A prismatic joint (a line on each of two links), or a revolute one between points of different names."""

    prismatic: tuple[Name, Name] | None = None
    line: tuple[LineOn, LineOn] | None = None
    revolute: tuple[Name, Name] | None = None
    at: tuple[Name, Name] | None = Field(None, description="the pinned point of each of the two links")

    @model_validator(mode="after")
    def _one_kind(self) -> Joint:
        if (self.prismatic is None) == (self.revolute is None):
            raise fault("joint.kind")
        if self.prismatic is not None and (self.line is None or self.at is not None):
            raise fault("joint.line")
        if self.revolute is not None and (self.at is None or self.line is not None):
            raise fault("joint.at")
        return self

    @property
    def links(self) -> tuple[str, str]:
        """The two links joined."""
        pair = self.prismatic or self.revolute
        assert pair is not None
        return pair


class Drive(Frozen):
    """A prescribed relative motion of two joined links: of ``turns``/``slides`` against ``on``."""

    turns: Name | None = None
    slides: Name | None = None
    on: Name
    speed: Expression | None = Field(None, description="constant speed; with start")
    start: Expression | None = Field(None, description="value at t = 0")
    position: Expression | None = Field(None, description="value as an expression in t; tables may be called")

    @model_validator(mode="after")
    def _one_law(self) -> Drive:
        if (self.turns is None) == (self.slides is None):
            raise fault("drive.kind")
        if (self.speed is None) == (self.position is None):
            raise fault("drive.law")
        if (self.speed is None) != (self.start is None):
            raise fault("drive.start")
        return self

    @property
    def link(self) -> str:
        """The link that is moved."""
        name = self.turns or self.slides
        assert name is not None
        return name


class Table(Frozen):
    """A function given by points, inline or in a CSV file beside the model."""

    file: str | None = None
    points: list[tuple[Expression, Expression]] | None = None
    x: str | None = Field(None, description="'COLUMN UNIT' of the argument in the file, e.g. 'angle deg'")
    y: str | None = Field(None, description="'COLUMN UNIT' of the value in the file")
    period: Expression | None = None
    between: Literal["linear", "cubic", "quintic"] = "cubic"

    @model_validator(mode="after")
    def _one_source(self) -> Table:
        if (self.file is None) == (self.points is None):
            raise fault("table.source")
        if self.file is not None and (self.x is None or self.y is None):
            raise fault("table.columns")
        return self


class Load(Frozen):
    """A constant force at a point, or a torque, on a link."""

    on: Name
    at: Name | Position | None = None
    force: tuple[Expression, Expression] | Expression | None = None
    along: Name | None = Field(None, description="a prismatic joint whose line a scalar force follows")
    torque: Expression | None = None
    in_: Name | None = Field(None, alias="in", description="frame (default), or the link with which the force turns")

    @model_validator(mode="after")
    def _whole(self) -> Load:
        if self.force is None and self.torque is None:
            raise fault("load.empty")
        if self.force is not None and self.at is None:
            raise fault("load.at")
        if self.force is not None and isinstance(self.force, tuple) == (self.along is not None):
            raise fault("load.direction")
        return self


Window = tuple[Expression, Expression]


class Measure(Frozen):
    """A named scalar of a run: one reduction of a signal expression."""

    span: Expression | None = None
    max: Expression | None = None
    min: Expression | None = None
    extremes: Expression | None = None
    mean: Expression | None = None
    rms: Expression | None = None
    value: Expression | None = None
    where: str | None = Field(None, description="place of a value: 'max E.x', 'min E.x', 'start' or 'end'")
    window: Name | None = None
    wrap: tuple[Expression, Expression] | None = None
    unit: str | None = None

    @model_validator(mode="after")
    def _one_reduction(self) -> Measure:
        given = [name for name in REDUCTIONS if getattr(self, name) is not None]
        if len(given) != 1:
            raise fault("measure.reduction", given=", ".join(given) or "none", known=", ".join(REDUCTIONS))
        if (self.value is None) != (self.where is None):
            raise fault("measure.where")
        return self

    @property
    def reduction(self) -> str:
        """The name of the reduction."""
        return next(name for name in REDUCTIONS if getattr(self, name) is not None)

    @property
    def signal(self) -> Expression:
        """The expression that is reduced."""
        expression: Expression = getattr(self, self.reduction)
        return expression


REDUCTIONS = ("span", "max", "min", "extremes", "mean", "rms", "value")


def _as_parameter(raw: Any) -> Any:
    return raw if isinstance(raw, dict | Parameter) else {"value": raw}


class Mechanism(Frozen):
    """Links, joints, drives, loads, parameters and measures of one planar mechanism.

    Made by the file format and by :class:`linkwright.Builder` alike; validated in itself when made, as a whole
    by :func:`linkwright.check`.
    """

    name: str = "mechanism"
    note: str | None = None
    units: Units = Units()
    gravity: tuple[Expression, Expression] | None = None
    parameters: Annotated[dict[Name, Parameter], _freeze] = Field(default_factory=FrozenDict)
    links: Annotated[dict[Name, Link], _freeze]
    joints: Annotated[dict[Name, Joint], _freeze] = Field(default_factory=FrozenDict)
    assembly: Annotated[dict[Name, AssemblyRule], _freeze] = Field(default_factory=FrozenDict)
    drives: Annotated[dict[Name, Drive], _freeze] = Field(default_factory=FrozenDict)
    tables: Annotated[dict[Name, Table], _freeze] = Field(default_factory=FrozenDict)
    loads: Annotated[dict[Name, Load], _freeze] = Field(default_factory=FrozenDict)
    windows: Annotated[dict[Name, Window | dict[str, Window]], _freeze] = Field(default_factory=FrozenDict)
    measures: Annotated[dict[Name, Measure], _freeze] = Field(default_factory=FrozenDict)
    require: Annotated[dict[Name, Requirement], _freeze] = Field(default_factory=FrozenDict)

    @model_validator(mode="before")
    @classmethod
    def _bare_parameters(cls, raw: Any) -> Any:
        if isinstance(raw, dict) and isinstance(raw.get("parameters"), dict):
            return {**raw, "parameters": {k: _as_parameter(v) for k, v in raw["parameters"].items()}}
        return raw

    def prismatic_joints(self) -> Iterator[tuple[str, Joint]]:
        """The prismatic joints by name."""
        return ((name, joint) for name, joint in self.joints.items() if joint.prismatic)


class Document(Mechanism):
    """A model file: a mechanism and the raw options of its studies."""

    linkwright: Literal[1] = 1
    studies: Annotated[dict[Name, dict[str, Any]], _freeze] = Field(default_factory=FrozenDict)
