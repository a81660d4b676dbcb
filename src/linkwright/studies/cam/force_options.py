"""The options of the forces on a cam. All expressions, in the file's units unless they state their own."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Annotated

from pydantic import Field

from linkwright.elements.fields import Interval
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Frozen, FrozenDict
from linkwright.expressions.typed_fields import Quantity, Scope, Sign
from linkwright.studies.cam.figures import along_lift
from linkwright.studies.cam.lift import along, turning

ANGLE, LIFT = "angle", "lift"
"""What a load may name besides parameters: the angle of the cam in its law, and the value of the law."""


def load_names(turns: bool) -> Mapping[str, u.Dimension]:
    """What a load may name besides parameters, with its dimension."""
    return FrozenDict({ANGLE: u.ANGLE, LIFT: u.ANGLE if turns else u.LENGTH})


_LOAD = replace(
    along(lambda turns: along_lift(turns)[2]), scope=Scope.TURN, names=lambda c: load_names(bool(turning(c)))
)


class CamSpring(Frozen):
    """The spring that presses the follower onto the cam; what is left out is sized over the speeds."""

    rate: Annotated[Expression | None, along(lambda turns: along_lift(turns)[1], Sign.NOT_NEGATIVE)] = Field(
        None, description="by the lift: force per length, or torque per angle; the least that does unless given"
    )
    preload: Annotated[Expression | None, along(lambda turns: along_lift(turns)[2], Sign.NOT_NEGATIVE)] = Field(
        None, description="force or torque at the lift 0; the least that does unless given; without both the rate is 0"
    )


class CamMaterial(Frozen):
    """An elastic material."""

    modulus: Annotated[Expression, Quantity(u.PRESSURE, Sign.POSITIVE)] = Field(description="Young's modulus")
    poisson: Annotated[Expression, Quantity(u.PURE, Sign.NOT_NEGATIVE)] = Field(description="Poisson's ratio")


class CamForceLimits(Frozen):
    """What must hold; each that isn't kept makes the study fail, with the place."""

    hertz: Annotated[Expression | None, Quantity(u.PRESSURE, Sign.POSITIVE)] = Field(
        None, description="largest Hertz pressure; with width"
    )
    torque: Annotated[Expression | None, Quantity(u.TORQUE, Sign.POSITIVE)] = Field(
        None, description="largest torque on the shaft, either way"
    )


class CamForces(Frozen):
    """What acts along the lift: on a pinned follower moments about its pivot, on a sliding one forces."""

    inertia: Annotated[Expression, along(lambda turns: along_lift(turns)[0], Sign.NOT_NEGATIVE)] = Field(
        description="the follower's moment of inertia about its pivot, or its mass"
    )
    speed: Annotated[Expression | None, Quantity(u.OMEGA, Sign.POSITIVE)] = Field(
        None, description="of the cam; the motor's unless given"
    )
    speeds: Annotated[Interval | None, Quantity(u.OMEGA, Sign.NOT_NEGATIVE)] = Field(
        None, description="[low, high] over which the follower must stay on, beside speed; from rest unless given"
    )
    spring: CamSpring | None = Field(None, description="what presses the follower onto the cam")
    load: Annotated[Expression, _LOAD] = Field(
        Expression(0),
        description="force or moment, positive onto the cam: constant, or over the cam's angle and the lift",
    )
    contact: Annotated[Expression, Quantity(u.FORCE, Sign.NOT_NEGATIVE)] = Field(
        Expression(0), description="least contact force that is to be kept"
    )
    width: Annotated[Expression | None, Quantity(u.LENGTH, Sign.POSITIVE)] = Field(
        None, description="of the line of contact; without it no Hertz pressure"
    )
    cam_material: CamMaterial | None = Field(None, description="of the cam; steel unless given")
    follower_material: CamMaterial | None = Field(None, description="of roller or face; steel unless given")
    limits: CamForceLimits = Field(default_factory=CamForceLimits, description="limits of pressure and torque")
