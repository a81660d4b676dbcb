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

    rate: Annotated[Expression | None, along(lambda turns: along_lift(turns)[1], Sign.NOT_NEGATIVE)] = None
    preload: Annotated[Expression | None, along(lambda turns: along_lift(turns)[2], Sign.NOT_NEGATIVE)] = None


class CamMaterial(Frozen):
    """An elastic material."""

    modulus: Annotated[Expression, Quantity(u.PRESSURE, Sign.POSITIVE)]
    poisson: Annotated[Expression, Quantity(u.PURE, Sign.NOT_NEGATIVE)]


class CamForceLimits(Frozen):
    """What must hold; each that isn't kept makes the study fail, with the place."""

    hertz: Annotated[Expression | None, Quantity(u.PRESSURE, Sign.POSITIVE)] = None
    torque: Annotated[Expression | None, Quantity(u.TORQUE, Sign.POSITIVE)] = None


class CamForces(Frozen):
    """What acts along the lift: on a pinned follower moments about its pivot, on a sliding one forces."""

    inertia: Annotated[Expression, along(lambda turns: along_lift(turns)[0], Sign.NOT_NEGATIVE)]
    speed: Annotated[Expression | None, Quantity(u.OMEGA, Sign.POSITIVE)] = None
    speeds: Annotated[Interval | None, Quantity(u.OMEGA, Sign.NOT_NEGATIVE)] = None
    spring: CamSpring | None = None
    load: Annotated[Expression, _LOAD] = Expression(0)
    contact: Annotated[Expression, Quantity(u.FORCE, Sign.NOT_NEGATIVE)] = Expression(0)
    width: Annotated[Expression | None, Quantity(u.LENGTH, Sign.POSITIVE)] = None
    cam_material: CamMaterial | None = None
    follower_material: CamMaterial | None = None
    limits: CamForceLimits = Field(default_factory=CamForceLimits)
