"""Drives: the prescribed motion of a link on another one that it is joined to."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import partial
from typing import Annotated, Any, Self

from pydantic import ConfigDict, Field

from linkwright.elements.fields import LinkName
from linkwright.elements.joint import Applied, JointGeometry
from linkwright.elements.mirror import Mirror, Reflection
from linkwright.elements.mover import TRAVEL, TURN, MoverReports, MoverSignals, exerted
from linkwright.elements.points import FRAME
from linkwright.elements.prescribed import Track
from linkwright.elements.stated_law import StatedLaw
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Frozen, LineOn, Name
from linkwright.expressions.typed_fields import Ref, Scope, of_drive
from linkwright.expressions.written import Fault

_driven = partial(of_drive, drive=lambda c: c.name)


class Drive(MoverSignals, StatedLaw, Frozen):
    """A prescribed relative motion of two links: of ``turns``/``slides`` against ``on``, of a slide, or of the point
    ``at`` of ``moves`` ``along`` a line of ``on``."""

    # Said for editors here, by `faults` to the reader: either on which link, or what is extended.
    model_config = ConfigDict(json_schema_extra={"anyOf": [{"required": ["on"]}, {"required": ["extends"]}]})

    turns: LinkName | None = None
    slides: LinkName | None = None
    extends: Annotated[Name | None, Ref("extended")] = None
    moves: LinkName | None = None
    at: Annotated[Name | None, Ref("point", of="moves")] = None
    along: Annotated[LineOn | None, Ref("point", of="on_")] = None
    on_: LinkName | None = Field(None, alias="on")
    speed: Annotated[Expression | None, _driven(u.OMEGA, u.SPEED)] = None
    start: Annotated[Expression | None, _driven(u.ANGLE, u.LENGTH)] = None
    acceleration: Annotated[Expression | None, _driven(u.ALPHA, u.ACCELERATION)] = None
    position: Annotated[Expression | None, _driven(u.ANGLE, u.LENGTH, scope=Scope.TIME)] = None
    output: Annotated[Name | None, Ref("output")] = None

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        kinds = [key for key in ("turns", "slides", "extends", "moves") if key in given]
        if len(kinds) != 1:
            yield "drive.kind", {}
        elif ("on" in given) == ("extends" in given):
            yield "drive.on", {}
        if len({key in given for key in ("moves", "at", "along")}) > 1:
            yield "drive.point", {}
        if "output" not in given or given.keys() & {"speed", "start", "acceleration", "position"}:
            yield from cls.law_faults(given)  # of one whose output is a path, the path has the law

    def mirrored(self, name: str, mirror: Mirror) -> Self:
        """The same drive seen in a mirror: an angle counts the other way round, a value along a line stays."""
        mirror.holds(*filter(None, (self.turns, self.slides, self.moves, self.on_)))
        made = self
        if self.along is not None:
            made = self.model_copy(update={"along": mirror.line(self.on, self.along)})
        turning, on = (self.turns, self.on) if self.output is None else (self.output, FRAME)
        if turning is None or (self.output is not None and self.output not in mirror.links):
            return made  # the law is that of a travel
        value, rate = mirror.angle(turning, on), Reflection(True)
        seen = {"start": value, "position": value, "speed": rate, "acceleration": rate}
        laws = {key: law for key in seen if (law := getattr(self, key)) is not None}
        return made.model_copy(update={key: seen[key].image(law) for key, law in laws.items()})

    @property
    def on(self) -> str:
        """The link against which the motion is measured."""
        return self.on_ or ""

    @property
    def link(self) -> str:
        """The link that is moved."""
        name = self.turns or self.slides or self.moves
        assert name is not None
        return name

    @property
    def signals(self) -> Mapping[str, u.Dimension]:
        """Its signals: the value with its rates, what it exerts, its power."""
        value, effort = (TURN, u.TORQUE) if self.turns else (TRAVEL, u.FORCE)
        return {**value, self.effort: effort, "power": u.POWER}

    def of_links(self, on: str, turns: str | None = None, slides: str | None = None) -> Self:
        """The same law between other links: nothing else of what this one moves is left."""
        own = dict.fromkeys(("extends", "moves", "at", "along"))
        return self.model_copy(update={**own, "turns": turns, "slides": slides, "on_": on})

    def track(self, geometry: JointGeometry) -> Track:
        """Of one that moves a point this point, and the line along which its place counts."""
        assert self.at is not None
        assert self.along is not None
        base = geometry.point(self.on, self.along.point)
        return Track(geometry.point(self.link, self.at), base, geometry.number(self.along.angle, u.ANGLE))

    def applied(self, reports: MoverReports, name: str) -> list[Applied]:
        """What it does to its two links, by its reported effort: its proof."""
        return exerted(self, reports, name, reports.rows[f"{name}.{self.effort}"])
