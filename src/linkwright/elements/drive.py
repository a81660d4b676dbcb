"""Drives: the prescribed motion of a link on another one that it is joined to."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import partial
from typing import Annotated, Any

import numpy as np
from pydantic import ConfigDict, Field

from linkwright.elements.fields import LinkName
from linkwright.elements.joint import Applied
from linkwright.elements.mover import TRAVEL, TURN, MoverReports, MoverSignals
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Frozen, Name
from linkwright.expressions.typed_fields import Ref, Scope, of_drive
from linkwright.expressions.written import Fault

_driven = partial(of_drive, drive=lambda c: c.name)


class Drive(MoverSignals, Frozen):
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
    def signals(self) -> Mapping[str, u.Dimension]:
        """Its signals: the value with its rates, what it exerts, its power."""
        value, effort = (TURN, u.TORQUE) if self.turns else (TRAVEL, u.FORCE)
        return {**value, self.effort: effort, "power": u.POWER}

    def uniform(self, angle: bool) -> list[tuple[Expression, u.Dimension]]:
        """Of one without ``position``: start, speed and acceleration, as far as they are given, with their dimensions
        where what is prescribed is an ``angle`` or else a length."""
        of = (u.ANGLE, u.OMEGA, u.ALPHA) if angle else (u.LENGTH, u.SPEED, u.ACCELERATION)
        given = zip((self.start, self.speed, self.acceleration), of, strict=True)
        return [(expression, dimension) for expression, dimension in given if expression is not None]

    def applied(self, reports: MoverReports, name: str) -> list[Applied]:
        """What it does to its two links, by its reported effort: its proof."""
        effort, none = reports.rows[f"{name}.{self.effort}"], np.zeros((2, reports.count))
        if self.turns:
            return [(self.link, none, none, effort), (self.on, none, none, -effort)]
        place, along = reports.line(reports.joint_of(name), self.on)
        return [(self.link, effort * along, place, 0.0), (self.on, -(effort * along), place, 0.0)]
