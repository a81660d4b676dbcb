"""The options of the cam study. All expressions, in the file's units unless they state their own."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Annotated, Any

from pydantic import BeforeValidator, Field, WithJsonSchema

from linkwright.cam.nc.posts import POSTS
from linkwright.elements.fields import Interval, freeze
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Frozen, FrozenDict, Requirement
from linkwright.expressions.fields import Name as NameField
from linkwright.expressions.typed_fields import Context, Quantity, Ref, Sign
from linkwright.expressions.unknown import near
from linkwright.expressions.written import Fault, fault
from linkwright.findings import Joined
from linkwright.studies.cam.figures import every, of_forces
from linkwright.studies.cam.force_options import CamForces
from linkwright.studies.cam.lift import along, turning
from linkwright.studies.sampling_options import one_of

PATH = ("studies", "cam")
Drawing = one_of("cam", "drawing", ["arcs", "splines"])
Path_ = tuple[str | int, ...]


def _posts(raw: Any) -> Any:
    names = [raw] if isinstance(raw, str) else raw
    if isinstance(names, list | tuple):
        if wrong := [str(name)[:40] for name in names if name not in POSTS]:
            hint = near(wrong[0], POSTS, listed=True)
            raise fault("study.choice", study="cam", key="post", given=Joined(wrong[:9]), near=hint)
        if not names:
            raise fault("nc.no-post", known=Joined(POSTS))
        return tuple(dict.fromkeys(names))
    return raw


CONTROL = {"type": "string", "enum": [*POSTS]}
POST = {"anyOf": [CONTROL, {"type": "array", "items": CONTROL}]}
"""The schema of one control or a list of them."""


class CamLimits(Frozen):
    """What must hold; each that isn't kept makes the study fail, with the place."""

    pressure_rise: Annotated[Expression | None, Quantity(u.ANGLE, Sign.POSITIVE)] = None
    pressure_return: Annotated[Expression | None, Quantity(u.ANGLE, Sign.POSITIVE)] = None
    pitch_over_roller: Annotated[Expression | None, Quantity(u.PURE, Sign.POSITIVE)] = None
    profile_radius: Annotated[Expression | None, Quantity(u.LENGTH, Sign.POSITIVE)] = None
    continuity: int | None = Field(None, ge=2, le=3)
    cutter: Annotated[Expression | None, Quantity(u.LENGTH, Sign.POSITIVE)] = None
    play: Annotated[Expression | None, Quantity(u.LENGTH, Sign.NOT_NEGATIVE)] = None


def _sign_of_length(c: Context) -> Sign:
    """Of the follower's lengths two lie to either side."""
    return Sign.ANY if c.path[-1] in ("offset", "face") else Sign.POSITIVE


class CamSize(Frozen):
    """The smallest base circle that keeps the limits; with one further length of the follower a map of both."""

    base: Annotated[Interval, Quantity(u.LENGTH, Sign.POSITIVE)]
    against: Annotated[dict[NameField, Interval], Quantity(u.LENGTH, _sign_of_length), freeze] = Field(
        default_factory=FrozenDict, max_length=1
    )
    steps: int = Field(10, ge=2, le=60)


class CamBlank(Frozen):
    """The solid around the profile. All round parts by their radii."""

    thickness: Annotated[Expression, Quantity(u.LENGTH, Sign.POSITIVE)]
    bore: Annotated[Expression | None, Quantity(u.LENGTH, Sign.POSITIVE)] = None
    hub: Annotated[Expression | None, Quantity(u.LENGTH, Sign.POSITIVE)] = None
    height: Annotated[Expression | None, Quantity(u.LENGTH, Sign.POSITIVE)] = None
    key_width: Annotated[Expression | None, Quantity(u.LENGTH, Sign.POSITIVE)] = None
    key_depth: Annotated[Expression | None, Quantity(u.LENGTH, Sign.POSITIVE)] = None
    key_angle: Annotated[Expression, Quantity(u.ANGLE)] = Expression(0)
    radius: Annotated[Expression | None, Quantity(u.LENGTH, Sign.POSITIVE)] = None
    groove: Annotated[Expression | None, Quantity(u.LENGTH, Sign.POSITIVE)] = None

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        for some in (("hub", "height"), ("key_width", "key_depth"), ("radius", "groove")):
            if sum(key in given for key in some) == 1:
                yield "cam.together", {"keys": Joined(some)}
        if "key_width" in given and "bore" not in given:
            yield "cam.together", {"keys": "key_width, bore"}


class CamNc(Frozen):
    """How the cam is milled, and for which controls."""

    post: Annotated[tuple[str, ...], BeforeValidator(_posts), WithJsonSchema(POST)]
    cutter: Annotated[Expression, Quantity(u.LENGTH, Sign.POSITIVE)]
    depth: Annotated[Expression, Quantity(u.LENGTH, Sign.POSITIVE)]
    tolerance: Annotated[Expression, along(lambda turns: u.ANGLE if turns else u.LENGTH, Sign.POSITIVE)]
    feed: Annotated[Expression, Quantity(u.SPEED, Sign.POSITIVE)]
    speed: Annotated[Expression, Quantity(u.OMEGA, Sign.POSITIVE)]
    plunge: Annotated[Expression | None, Quantity(u.SPEED, Sign.POSITIVE)] = None
    step: Annotated[Expression | None, Quantity(u.LENGTH, Sign.POSITIVE)] = None
    start: Annotated[Expression | None, Quantity(u.ANGLE)] = None
    allowance: Annotated[Expression, Quantity(u.LENGTH, Sign.NOT_NEGATIVE)] = Expression(0)
    lead: Annotated[Expression, Quantity(u.LENGTH, Sign.POSITIVE)] = Expression("5 mm")
    overlap: Annotated[Expression, Quantity(u.LENGTH, Sign.NOT_NEGATIVE)] = Expression("2 mm")
    clear: Annotated[Expression, Quantity(u.LENGTH, Sign.POSITIVE)] = Expression("5 mm")
    blend: Annotated[Expression, Quantity(u.LENGTH, Sign.POSITIVE)] = Expression("1 um")
    spring: bool = True
    climb: bool = True
    compensation: bool = False
    arcs: bool = True
    decimals: int = Field(4, ge=2, le=6)
    tool: int = Field(1, ge=1, le=9999)
    number: int = Field(1000, ge=1, le=9999)


def _figure(c: Context) -> u.Dimension | None:
    """The dimension of the figure by whose name a requirement stands."""
    turns = turning(c)
    return None if turns is None else (every(turns) | of_forces(turns)).get(str(c.path[-1]))


class CamOptions(Frozen):
    """Which cam, what it is held against, and what is made of it."""

    cam: Annotated[NameField | None, Ref("cam")] = None
    limits: CamLimits = Field(default_factory=CamLimits)
    require: Annotated[dict[str, Requirement], Quantity(_figure), freeze] = Field(default_factory=FrozenDict)
    size: CamSize | None = None
    forces: CamForces | None = None
    tolerance: Annotated[Expression, Quantity(u.LENGTH, Sign.POSITIVE)] = Expression("1e-4 mm")
    drawing: Drawing = "arcs"  # type: ignore[valid-type]
    blank: CamBlank | None = None
    nc: CamNc | None = None
    period: Annotated[Expression, Quantity(u.TIME, Sign.POSITIVE)] = Expression("1 s")
    steps: int = Field(720, ge=36, le=36_000)
