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

    pressure_rise: Annotated[Expression | None, Quantity(u.ANGLE, Sign.POSITIVE)] = Field(
        None, description="largest pressure angle while the follower rises"
    )
    pressure_return: Annotated[Expression | None, Quantity(u.ANGLE, Sign.POSITIVE)] = Field(
        None, description="largest pressure angle while it returns"
    )
    pitch_over_roller: Annotated[Expression | None, Quantity(u.PURE, Sign.POSITIVE)] = Field(
        None, description="least convex radius of the pitch curve over the roller's; 1 (no undercut) unless given"
    )
    profile_radius: Annotated[Expression | None, Quantity(u.LENGTH, Sign.POSITIVE)] = Field(
        None, description="least convex radius of the profile"
    )
    continuity: int | None = Field(
        None, ge=2, le=3, description="of the law: 2 refuses jumps of the acceleration, 3 of the jerk too"
    )
    cutter: Annotated[Expression | None, Quantity(u.LENGTH, Sign.POSITIVE)] = Field(
        None, description="radius of the cutter, which the concave radii must exceed; that of nc unless given"
    )
    play: Annotated[Expression | None, Quantity(u.LENGTH, Sign.NOT_NEGATIVE)] = Field(
        None, description="largest play of a yoke over the turn; with closed: yoke"
    )


def _sign_of_length(c: Context) -> Sign:
    """Of the follower's lengths two lie to either side."""
    return Sign.ANY if c.path[-1] in ("offset", "face") else Sign.POSITIVE


class CamSize(Frozen):
    """The smallest base circle that keeps the limits; with one further length of the follower a map of both."""

    base: Annotated[Interval, Quantity(u.LENGTH, Sign.POSITIVE)] = Field(
        description="[low, high] of the base circle's radius"
    )
    against: Annotated[dict[NameField, Interval], Quantity(u.LENGTH, _sign_of_length), freeze] = Field(
        default_factory=FrozenDict,
        max_length=1,
        description="[low, high] of one other length of the follower: roller, distance, arm, offset or face",
    )
    steps: int = Field(10, ge=2, le=60, description="steps of the map along each length")


class CamBlank(Frozen):
    """The solid around the profile. All round parts by their radii."""

    thickness: Annotated[Expression, Quantity(u.LENGTH, Sign.POSITIVE)] = Field(description="of the plate")
    bore: Annotated[Expression | None, Quantity(u.LENGTH, Sign.POSITIVE)] = Field(
        None, description="radius of the bore"
    )
    hub: Annotated[Expression | None, Quantity(u.LENGTH, Sign.POSITIVE)] = Field(
        None, description="radius of the hub; with height"
    )
    height: Annotated[Expression | None, Quantity(u.LENGTH, Sign.POSITIVE)] = Field(
        None, description="of the hub above the plate"
    )
    key_width: Annotated[Expression | None, Quantity(u.LENGTH, Sign.POSITIVE)] = Field(
        None, description="width of the keyway; with key_depth and bore"
    )
    key_depth: Annotated[Expression | None, Quantity(u.LENGTH, Sign.POSITIVE)] = Field(
        None, description="how far the keyway reaches beyond the bore"
    )
    key_angle: Annotated[Expression, Quantity(u.ANGLE)] = Field(
        Expression(0), description="direction of the keyway in the cam's own frame"
    )
    radius: Annotated[Expression | None, Quantity(u.LENGTH, Sign.POSITIVE)] = Field(
        None, description="of the plate that a groove is milled into; with groove"
    )
    groove: Annotated[Expression | None, Quantity(u.LENGTH, Sign.POSITIVE)] = Field(
        None, description="depth of the groove"
    )

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        for some in (("hub", "height"), ("key_width", "key_depth"), ("radius", "groove")):
            if sum(key in given for key in some) == 1:
                yield "cam.together", {"keys": Joined(some)}
        if "key_width" in given and "bore" not in given:
            yield "cam.together", {"keys": "key_width, bore"}


class CamNc(Frozen):
    """How the cam is milled, and for which controls."""

    post: Annotated[tuple[str, ...], BeforeValidator(_posts), WithJsonSchema(POST)] = Field(
        description=f"the control or a list of them: {', '.join(POSTS)}"
    )
    cutter: Annotated[Expression, Quantity(u.LENGTH, Sign.POSITIVE)] = Field(
        description="radius of the cutter; of a groove the roller's at the most"
    )
    depth: Annotated[Expression, Quantity(u.LENGTH, Sign.POSITIVE)] = Field(
        description="thickness of the cam, with what the cutter goes beyond it; depth of a groove"
    )
    tolerance: Annotated[Expression, along(lambda turns: u.ANGLE if turns else u.LENGTH, Sign.POSITIVE)] = Field(
        description="how far the follower's lift may be off: an angle or a length"
    )
    feed: Annotated[Expression, Quantity(u.SPEED, Sign.POSITIVE)] = Field(description="at the contour, e.g. 400 mm/min")
    speed: Annotated[Expression, Quantity(u.OMEGA, Sign.POSITIVE)] = Field(description="of the spindle, e.g. 6000 rpm")
    plunge: Annotated[Expression | None, Quantity(u.SPEED, Sign.POSITIVE)] = Field(
        None, description="feed while going down; a quarter of feed unless given"
    )
    step: Annotated[Expression | None, Quantity(u.LENGTH, Sign.POSITIVE)] = Field(
        None, description="the deepest pass; all in one unless given"
    )
    start: Annotated[Expression | None, Quantity(u.ANGLE)] = Field(
        None, description="cam angle at which the path is entered; the middle of the longest dwell unless given"
    )
    allowance: Annotated[Expression, Quantity(u.LENGTH, Sign.NOT_NEGATIVE)] = Field(
        Expression(0), description="left by the passes for a last one at full depth"
    )
    lead: Annotated[Expression, Quantity(u.LENGTH, Sign.POSITIVE)] = Field(
        Expression("5 mm"), description="radius of the quarter circles of entry and exit"
    )
    overlap: Annotated[Expression, Quantity(u.LENGTH, Sign.NOT_NEGATIVE)] = Field(
        Expression("2 mm"), description="how far the path goes on beyond its start"
    )
    clear: Annotated[Expression, Quantity(u.LENGTH, Sign.POSITIVE)] = Field(
        Expression("5 mm"), description="height at which the cutter moves over the blank"
    )
    blend: Annotated[Expression, Quantity(u.LENGTH, Sign.POSITIVE)] = Field(
        Expression("1 um"), description="how far the control may round corners"
    )
    spring: bool = Field(True, description="whether the last pass is repeated")
    climb: bool = Field(True, description="climb milling; else conventional")
    compensation: bool = Field(False, description="program the profile, and let the control offset the cutter")
    arcs: bool = Field(True, description="arcs; else chords alone")
    decimals: int = Field(4, ge=2, le=6, description="digits after the point, in mm")
    tool: int = Field(1, ge=1, le=9999, description="number of the tool")
    number: int = Field(1000, ge=1, le=9999, description="number of the program, where a control wants one")


def _figure(c: Context) -> u.Dimension | None:
    """The dimension of the figure by whose name a requirement stands."""
    turns = turning(c)
    return None if turns is None else (every(turns) | of_forces(turns)).get(str(c.path[-1]))


class CamOptions(Frozen):
    """Which cam, what it is held against, and what is made of it."""

    cam: Annotated[NameField | None, Ref("cam")] = Field(
        None, description="the entry of cams; may be left out where there is one"
    )
    limits: CamLimits = Field(default_factory=CamLimits, description="limits of the checks")
    require: Annotated[dict[str, Requirement], Quantity(_figure), freeze] = Field(
        default_factory=FrozenDict, description="requirements on the study's figures by name, e.g. '>= 22 mm'"
    )
    size: CamSize | None = Field(None, description="look for the smallest base circle that keeps the limits")
    forces: CamForces | None = Field(None, description="forces between cam and follower at a speed, and its spring")
    tolerance: Annotated[Expression, Quantity(u.LENGTH, Sign.POSITIVE)] = Field(
        Expression("1e-4 mm"), description="how far drawing and solid may lie off the exact profile"
    )
    drawing: Drawing = Field("arcs", description="the profile in the drawing: arcs and lines, or splines")  # type: ignore[valid-type]
    blank: CamBlank | None = Field(None, description="the solid: written as cam.step where build123d is installed")
    nc: CamNc | None = Field(None, description="NC code, read back and proven before it is written")
    period: Annotated[Expression, Quantity(u.TIME, Sign.POSITIVE)] = Field(
        Expression("1 s"), description="of a turn of the cam, in cam_motion.txt, for a CAD simulator's motor"
    )
    steps: int = Field(720, ge=36, le=36_000, description="equal steps of the cam's turn in tables and the read-back")
