"""The model: an immutable mechanism as its file states it. Expressions and written units are kept."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Annotated, Any, Self

from pydantic import BaseModel, Field, PrivateAttr

from linkwright.elements.cylinder import Cylinder
from linkwright.elements.drive import Drive
from linkwright.elements.fields import freeze
from linkwright.elements.follower import Follower
from linkwright.elements.force import Acting, acting
from linkwright.elements.mover import Mover
from linkwright.elements.points import FRAME
from linkwright.escape import line
from linkwright.expressions.fields import Frozen, FrozenDict, LongText, Name, Text
from linkwright.expressions.typed_fields import OWN_SCOPE
from linkwright.expressions.written import FaultWithin
from linkwright.model.actions import Table, Window
from linkwright.model.gravity import Gravity
from linkwright.model.motions import MotionLaw
from linkwright.model.parts import Joint, Link, Parameter, Plane, Units
from linkwright.model.sections import MAX_ENTRIES, MAX_LINKS, Sections, WhenThere, at_most
from linkwright.model.stiffness import Stiffnesses, stiffness_faults
from linkwright.reductions import Measure

if TYPE_CHECKING:
    from linkwright.elements.path import PointPath
    from linkwright.model.subassembly import Subassembly
else:  # imported by WhenThere
    Subassembly = BaseModel

__all__ = [
    "FRAME",
    "MAX_ENTRIES",
    "MAX_LINKS",
    "Cylinder",
    "Drive",
    "Joint",
    "Link",
    "Measure",
    "Mechanism",
    "MotionLaw",
    "Parameter",
    "Table",
    "Units",
    "Window",
    "at_most",
]

FOLLOWING = ("cams", "joints")
"""The sections in which joints stand that have a link follow a drive."""


_Subassembly = Annotated[Subassembly, WhenThere("model.subassembly.Subassembly")]


class Head(Frozen):
    """What a model file says of itself: its title, its units, where gravity points."""

    name: Text = "mechanism"
    note: LongText | None = None
    source: LongText | None = None
    author: Text | None = None
    revision: Text | None = None
    units: Units = Units()
    gravity: Gravity | None = None
    plane: Plane | None = None
    stiffness: Stiffnesses = Field(default_factory=FrozenDict)
    subassemblies: Annotated[dict[Name, _Subassembly], at_most(MAX_ENTRIES), freeze, OWN_SCOPE] = Field(
        default_factory=FrozenDict
    )


class Mechanism(Sections, Head):
    """Links, joints, drives, loads, parameters and measures of one planar mechanism.

    Made by the file format and by :class:`linkwright.Builder` alike; validated in itself when made, as a whole
    by :func:`linkwright.check`.
    """

    _followers: Mapping[str, Follower] = PrivateAttr(default_factory=FrozenDict)
    _turned: frozenset[str] = PrivateAttr(default=frozenset())

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[FaultWithin]:
        yield from super().faults(given)
        yield from stiffness_faults(given.get("stiffness"))

    @property
    def followers(self) -> Mapping[str, Follower]:
        """The joints that have a link follow a drive, where short forms are spelled out."""
        return self._followers

    @property
    def turned(self) -> frozenset[str]:
        """The links that stand in mirrored copies: what is drawn at 0 there is at half a turn."""
        return self._turned

    @property
    def movers(self) -> Mapping[str, Mover]:
        """Whatever prescribes a motion: the drives, then the followers."""
        return {**self.drives, **self._followers}

    def path_of(self, mover: str) -> tuple[str, str]:
        """The place in the file of a drive or follower: cams have a section of their own, all other followers stand
        among the joints."""
        return next((section, mover) for section in ("drives", *FOLLOWING) if mover in getattr(self, section))

    def with_followers(self, found: Mapping[str, Follower]) -> Self:
        """The same with these followers."""
        made = self.model_copy()
        made._followers = FrozenDict(found)
        return made

    def with_turned(self, links: frozenset[str]) -> Self:
        """The same with these links in mirrored copies."""
        if links == self._turned:
            return self
        made = self.model_copy()
        made._turned = links
        return made

    def without_mover(self, name: str) -> Self:
        """The same without a drive or follower."""
        made = self.model_copy(update={"drives": FrozenDict({n: d for n, d in self.drives.items() if n != name})})
        made._followers = FrozenDict({n: follower for n, follower in self._followers.items() if n != name})
        return made

    def prescribed(self, mover: str) -> Mover:
        """What prescribes a motion: of a drive with an output, the same law between the output's links."""
        entry = self.drives.get(mover)
        if entry is None or entry.output is None:
            return entry or self._followers[mover]
        if (path := self.paths.get(entry.output)) is not None:
            from linkwright.elements.path import Coordinate

            return Coordinate(path, entry.output, self.path_drives(entry.output).index(mover) > 0)
        if (joint := self.joints.get(entry.output)) is not None:
            on, link = joint.links
            return entry.of_links(slides=link, on=on)
        return entry.of_links(turns=entry.output, on=FRAME)

    def path_drives(self, path: str) -> list[str]:
        """The drives that move a point along a path: of two the first prescribes x, the second y."""
        return [name for name, drive in self.drives.items() if drive.output == path]

    def path_law(self, drive: str) -> PointPath | None:
        """The path that has the law of a drive, if it isn't the drive's own."""
        return self.paths.get(self.drives[drive].output or "")

    @property
    def title(self) -> str:
        """The name as results and other tools get it: in one line."""
        return line(self.name)

    def prismatic_joints(self) -> Iterator[tuple[str, Joint]]:
        """The prismatic joints by name."""
        return ((name, joint) for name, joint in self.joints.items() if joint.prismatic)

    def joints_but_pins(self) -> Iterator[tuple[str, Joint]]:
        """The joints that only the file's ``joints`` state, by name: all but the revolute ones, which are pins."""
        return ((name, joint) for name, joint in self.joints.items() if not joint.revolute and not joint.follows)

    def acting(self) -> Iterator[Acting]:
        """What acts on links or weighs, whatever its kind: loads, springs, counterweights, friction."""
        return acting(self)

    def has_mass(self, link: str) -> bool:
        """Whether a link has mass, its own or a counterweight's."""
        weights = (one.kind.weighs(one.entry) for one in self.acting())
        return self.links[link].mass is not None or any(weight.link == link for weight in weights if weight)


def mechanism_of(sections: Sections) -> Mechanism:
    """What a sub-assembly consists of, as a mechanism of its own; its ports are names that nothing is called by."""
    return Mechanism.model_construct(**{name: getattr(sections, name) for name in Sections.model_fields})


def scopes(m: Mechanism) -> Iterator[tuple[tuple[str, ...], Mechanism]]:
    """A mechanism and its sub-assemblies, in each of which names and numbers have a meaning of their own; with the
    place in the file."""
    yield (), m
    for name, stated in m.subassemblies.items():
        yield ("subassemblies", name), mechanism_of(stated)
