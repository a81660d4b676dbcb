"""What a file says of a cam."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Annotated, Any, ClassVar, Literal, Self

from pydantic import Field

from linkwright.elements.mirror import HALF_TURN, Mirror
from linkwright.elements.points import FRAME
from linkwright.expressions.fields import AssemblyRule, Expression, Frozen, LineOn, Name
from linkwright.expressions.typed_fields import ELSEWHERE, Named, Quantity, Ref, Sign
from linkwright.expressions.units import ANGLE, LENGTH
from linkwright.expressions.written import Fault
from linkwright.findings import Joined

_RADIUS = Quantity(LENGTH, Sign.POSITIVE, "radius")
PointOfFollower = Annotated[Name | None, Named("element")]


class Second(Frozen):
    """What rides on the second disc of a conjugate pair, on the same follower and shaft; what is left out is as on the
    first. Its place gives the disc's base circle, or the other way round."""

    base: Annotated[Expression | None, _RADIUS] = None
    roller: Annotated[Expression | None, _RADIUS] = None
    at: PointOfFollower = None
    face: LineOn | None = None

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

    kind: ClassVar[str] = "cam"
    follows: ClassVar[bool] = True

    cam: Annotated[Name, Ref("link")]
    follower: Annotated[Name, Ref("link")]
    on_: Annotated[Name, Ref("link")] = Field(alias="on")
    base: Annotated[Expression, _RADIUS]
    law: Annotated[Name, Ref("law")]
    phase: Annotated[Expression, Quantity(ANGLE)] = Expression(0)
    sense: Literal["counter-clockwise", "clockwise"] | None = None
    roller: Annotated[Expression | None, _RADIUS] = None
    at: PointOfFollower = None
    knife: PointOfFollower = None
    face: LineOn | None = None
    side: Annotated[AssemblyRule | None, ELSEWHERE] = None
    closed: Literal["force", "groove", "conjugate", "yoke"] = "force"
    second: Second | None = None

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

    def mirrored(self, name: str, mirror: Mirror) -> Self:
        """The same cam seen in a mirror: it turns the other way round."""
        mirror.holds(self.cam, self.follower, self.on_)
        other = {"counter-clockwise": "clockwise", "clockwise": "counter-clockwise"}
        update: dict[str, Any] = {"sense": other.get(self.sense or "", self.sense)}
        if self.on_ == FRAME:
            update["phase"] = Expression(f"{self.phase.text} + {HALF_TURN}")
        if self.side is not None:
            update["side"] = self.side.mirrored(name, mirror)
        if self.face is not None:
            update["face"] = mirror.line(self.follower, self.face)
        if self.second is not None and self.second.face is not None:
            face = mirror.line(self.follower, self.second.face)
            update["second"] = self.second.model_copy(update={"face": face})
        return self.model_copy(update=update)

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
