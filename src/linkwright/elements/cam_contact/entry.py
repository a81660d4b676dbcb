"""What a file says of a cam."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Annotated, Any, Literal

from pydantic import Field

from linkwright.expressions.fields import AssemblyRule, Expression, Frozen, LineOn, Name
from linkwright.expressions.typed_fields import ELSEWHERE, Quantity, Ref, Sign
from linkwright.expressions.units import ANGLE, LENGTH
from linkwright.expressions.written import Fault
from linkwright.findings import Joined

_RADIUS = Quantity(LENGTH, Sign.POSITIVE, "radius")


class Second(Frozen):
    """What rides on the second disc of a conjugate pair, on the same follower and shaft; what is left out is as on the
    first. Its place gives the disc's base circle, or the other way round."""

    base: Annotated[Expression | None, _RADIUS] = Field(
        None, description="radius of its base circle; the first one's unless at is given"
    )
    roller: Annotated[Expression | None, _RADIUS] = Field(
        None, description="radius of its roller; the first one's unless given"
    )
    at: Name | None = Field(None, description="the second roller's centre, or the second edge: a point of the follower")
    face: LineOn | None = Field(None, description="the follower's second face, on the other side of the cam")

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        places = [key for key in ("base", "at", "face") if key in given]
        if len(places) > 1:
            yield "cam.second-twice", {"given": Joined(places)}

    @property
    def touches(self) -> str | None:
        """The follower's point that says where it touches, if one does."""
        return self.at or (self.face.point if self.face else None)


class Cam(Frozen):
    """A plate cam on a link that a drive turns, and the follower that rides on it by a law over the cam's angle."""

    cam: Annotated[Name, Ref("link")] = Field(
        description="the link that carries the cam; a drive turns it on the link named by on"
    )
    follower: Annotated[Name, Ref("link")] = Field(
        description="the link that rides on the cam, pinned to or sliding on the same link"
    )
    on_: Annotated[Name, Ref("link")] = Field(
        alias="on", description="the link on which both the cam and the follower are carried"
    )
    base: Annotated[Expression, _RADIUS] = Field(
        description="radius of the cam's base circle, on which the law's lift is 0"
    )
    law: Annotated[Name, Ref("law")] = Field(
        description="the motion law, over an angle; its value is an angle for a follower on a pin, a length on a slide"
    )
    phase: Annotated[Expression, Quantity(ANGLE)] = Field(
        Expression(0), description="where in the law the cam stands at the motor's value 0"
    )
    sense: Literal["counter-clockwise", "clockwise"] | None = Field(
        None,
        description="the sense of turn in which the cam runs through the law; that of the motor's speed unless given",
    )
    roller: Annotated[Expression | None, _RADIUS] = Field(None, description="radius of the follower's roller; with at")
    at: Name | None = Field(None, description="the roller's centre, a point of the follower")
    knife: Name | None = Field(None, description="the point of the follower that slides on the cam as a knife edge")
    face: LineOn | None = Field(
        None, description="the follower's flat face, e.g. F at 0 deg; on a pin the direction points to its free end"
    )
    side: Annotated[AssemblyRule | None, ELSEWHERE] = Field(
        None,
        description="where the follower lies: 'left of O-A' (shaft-pivot), or 'ahead of O along SLIDE' (unless given)",
    )
    closed: Literal["force", "groove", "conjugate", "yoke"] = Field(
        "force",
        description="what keeps the follower on the cam: a force such as a spring's, a groove for the roller, a second "
        "disc on the shaft, or a yoke around the disc (sliding followers)",
    )
    second: Second | None = Field(
        None, description="with closed: conjugate, what rides on the second disc; as the first unless given"
    )

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        contacts = [key for key in ("roller", "knife", "face") if key in given]
        if len(contacts) != 1 or ("at" in given) != ("roller" in given):
            yield "cam.contact", {"given": Joined([*contacts, *(["at"] if "at" in given else [])]) or "-"}
        closed, second = given.get("closed"), given.get("second")
        if closed == "groove" and "roller" not in given:
            yield "cam.groove", {}
        if second is not None and closed != "conjugate":
            yield "cam.second", {"closed": str(closed or "force")[:40]}
        others = {"roller": {"face"}, "face": {"at", "roller"}, "knife": {"face", "roller"}}
        wrong = {*second} & others[contacts[0]] if isinstance(second, Mapping) and len(contacts) == 1 else ()
        if wrong:
            yield "cam.second-other", {"given": Joined(sorted(wrong)), "first": contacts[0]}

    def contacts(self, path: tuple[str | int, ...]) -> Iterator[tuple[tuple[str | int, ...], Cam | Second]]:
        """What states a contact, with its path: the cam itself, and what is stated of the second disc."""
        yield path, self
        if self.second is not None:
            yield (*path, "second"), self.second

    @property
    def on(self) -> str:
        """The link on which both are carried."""
        return self.on_

    @property
    def touches(self) -> str:
        """The follower's point that says where it touches: the roller's centre, the edge, a point of the face."""
        name = self.at or self.knife or (self.face.point if self.face else None)
        assert name is not None
        return name

    @property
    def one_sided(self) -> Mapping[str, int]:
        """Where force alone holds the follower on the cam, the contact can't pull."""
        return {"force": 1} if self.closed == "force" else {}
