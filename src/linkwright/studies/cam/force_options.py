"""The options of the forces on a cam. All expressions, in the file's units unless they state their own."""

from __future__ import annotations

from pydantic import Field

from linkwright.model.fields import Expression, Frozen
from linkwright.model.parts import Interval


class CamSpring(Frozen):
    """The spring that presses the follower onto the cam; what is left out is sized over the speeds."""

    rate: Expression | None = Field(
        None, description="by the lift: force per length, or torque per angle; the least that does unless given"
    )
    preload: Expression | None = Field(
        None, description="force or torque at the lift 0; the least that does unless given; without both the rate is 0"
    )


class CamMaterial(Frozen):
    """An elastic material."""

    modulus: Expression = Field(description="Young's modulus")
    poisson: Expression = Field(description="Poisson's ratio")


class CamForceLimits(Frozen):
    """What must hold; each that isn't kept makes the study fail, with the place."""

    hertz: Expression | None = Field(None, description="largest Hertz pressure; with width")
    torque: Expression | None = Field(None, description="largest torque on the shaft, either way")


class CamForces(Frozen):
    """What acts along the lift: on a pinned follower moments about its pivot, on a sliding one forces."""

    inertia: Expression = Field(description="the follower's moment of inertia about its pivot, or its mass")
    speed: Expression | None = Field(None, description="of the cam; the motor's unless given")
    speeds: Interval | None = Field(
        None, description="[low, high] over which the follower must stay on, beside speed; from rest unless given"
    )
    spring: CamSpring | None = Field(None, description="what presses the follower onto the cam")
    load: Expression = Field(
        Expression(0),
        description="force or moment, positive onto the cam: constant, or over the cam's angle and the lift",
    )
    contact: Expression = Field(Expression(0), description="least contact force that is to be kept")
    width: Expression | None = Field(None, description="of the line of contact; without it no Hertz pressure")
    cam_material: CamMaterial | None = Field(None, description="of the cam; steel unless given")
    follower_material: CamMaterial | None = Field(None, description="of roller or face; steel unless given")
    limits: CamForceLimits = Field(default_factory=CamForceLimits, description="limits of pressure and torque")
