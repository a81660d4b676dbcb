"""What a joint is that has a link follow a drive: the contract of explicit joints, such as cams.

Such a joint states one constraint: the value of its link on another one, an angle about the pin or a length along the
line that these two share, is a function of a drive's value. No equation is left to be solved: the value is a prescribed
motion, as that of a drive, with all its rates. What a drive would exert there the joint exerts in its contact.

A kind is one registered class; an object of it is one joint of a mechanism, as it is read from its entry.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import field
from typing import Any, ClassVar, Protocol

from linkwright.data_classes import dataclass
from linkwright.elements.curves import Curve
from linkwright.elements.entries import JointEntry, make_known
from linkwright.elements.force import SignalChart
from linkwright.elements.joint import Applied, Array, JointGeometry, LinkPoses, Miss, Restated
from linkwright.elements.kind_modules import of_contract
from linkwright.elements.mover import TRAVEL, TURN, MoverReports, MoverSignals
from linkwright.elements.touch import ReportedTouch, Touch
from linkwright.expressions import units as u
from linkwright.expressions.language import Call, Node
from linkwright.expressions.typed_fields import Path
from linkwright.expressions.units import Dimension
from linkwright.findings import Finding, Term, Text
from linkwright.laws import Motion
from linkwright.notation import Jet, Pair, Scalar, Wrench
from linkwright.notation.registry import Registry

Motions = Mapping[str, Any]
"""The motion laws by name: of each ``given(parameters)`` is the :class:`~linkwright.laws.Motion` at some parameters."""
Value = Callable[[Any, Jet], Jet]
"""A follower's value (rad or m) with its rates, from the dimensions at some parameters and its motor's value."""


class FollowerGeometry(JointGeometry, Protocol):
    """The dimensions that a follower asks for."""

    @property
    def parameters(self) -> Mapping[str, Scalar]:
        """The values of the parameters."""

    @property
    def nominal(self) -> FollowerGeometry:
        """The same at the nominal parameters, without clearance."""

    def bind(self, expression: Any, dimension: Any) -> Node:
        """An expression as a tree in SI."""

    def pinned(self, link: str, point: str) -> Pair:
        """The place of a link that is put on the pin of one of its points, its clearance included."""


class PoseQuery(LinkPoses, Protocol):
    """What a follower asks for at a pose."""

    @property
    def geometry(self) -> FollowerGeometry:
        """The dimensions of the mechanism."""

    def unit(self, mover: str) -> dict[str, Wrench]:
        """What 1 N m or 1 N of a drive or follower would do at its own joint, by link."""


class FollowerReports(MoverReports, Protocol):
    """What a run reports."""

    @property
    def geometry(self) -> FollowerGeometry:
        """The model's dimensions."""

    @property
    def motions(self) -> Motions:
        """The motion laws."""

    def number(self, expression: Any, dimension: Any) -> float:
        """The value of an expression of the entry, in SI."""

    def value(self, expression: Any, dimension: Any) -> Array:
        """An expression in parameters, the time, tables and reported signals."""


class FollowedMotion(Protocol):
    """A motion that was followed to its end."""

    @property
    def geometry(self) -> FollowerGeometry:
        """The dimensions."""

    @property
    def motions(self) -> Motions:
        """The motion laws."""

    def row(self, signal: str) -> tuple[Array, Array]:
        """Times (s), those among them at which a signal is least and greatest, and its values there (SI)."""

    def rows(self, signals: Sequence[str]) -> tuple[Array, Array]:
        """The same of some signals: times, and the values of all there (signals, times)."""


class FollowerEntry(JointEntry):
    """Base of the entries of such joints that stand among the joints of a file."""

    follows = True

    @property
    def joint_points(self) -> tuple[str, ...]:
        """No points: the joint of its links is another one."""
        return ()


def joints_between(m: Any, links: Sequence[str], pins: Mapping[str, Any]) -> tuple[list[str], list[str]]:
    """The pins that hold both links, and the prismatic joints of both, by name."""
    pinned = [name for name, pin in pins.items() if {*links} <= {*pin.links}]
    return pinned, [name for name, joint in m.prismatic_joints() if {*joint.links} == {*links}]


@dataclass(frozen=True)
class MotorRelation:
    """How a follower's ``value`` follows, and what ``total`` of its law places a second contact (rad or m)."""

    value: Value
    total: float = 0.0


@dataclass(frozen=True)
class UnitEffort:
    """What 1 N (1 N m) of a follower's effort does: the ``wrenches`` on the links, of which the sum is none; the work
    ``reach`` that it does for a unit of the follower's value; and the ``signals`` of the contact."""

    wrenches: Mapping[str, Wrench]
    reach: Scalar = 1.0
    signals: Mapping[str, Scalar] = field(default_factory=dict)


@dataclass(frozen=True)
class Follower(MoverSignals, ABC):
    """A joint that has ``link`` follow the drive ``motor``: ``turning`` about its pin on the link ``on``, or along the
    slide ``joint`` of both. ``motor_sign`` is the sign by which the motor's value counts where its law is asked."""

    entry: Any
    link: str
    on: str
    turning: bool
    motor: str
    joint: str | None = None
    motor_sign: int = 1

    kind: ClassVar[str]
    """As files have it."""
    stated: ClassVar[type[Any]]
    """What a file says of one."""
    words: ClassVar[Mapping[str, Mapping[str, str]]] = {}
    """Texts that the catalogue lacks, by language and key; ``term.kind-NAME`` is what it is called."""
    lifts: ClassVar[str] = "joint.lifts-off"
    """The code of the warning that its contact would have to pull."""
    locks: ClassVar[str] = "joint.locks"
    """The code of the finding that its contact holds the link fast."""
    output: ClassVar[None] = None
    moves: ClassVar[None] = None
    at: ClassVar[None] = None

    @property
    def title(self) -> Term:
        """What it is called."""
        return Term(f"kind-{self.kind}")

    @classmethod
    @abstractmethod
    def read(cls, m: Any, name: str, pins: Mapping[str, Any]) -> Follower | list[Finding]:
        """The joint of an entry of the mechanism ``m``, or what is wrong with it; that there are such links and
        drives as its fields name is known. ``pins`` are those of the mechanism."""

    @property
    def turns(self) -> str | None:
        """The link where its value is an angle."""
        return self.link if self.turning else None

    @property
    def slides(self) -> str | None:
        """The link where its value is a length."""
        return None if self.turning else self.link

    @property
    def extra(self) -> Mapping[str, Dimension]:
        """The signals of its contact, which the poses alone give."""
        return {}

    @property
    def signals(self) -> Mapping[str, Dimension]:
        """Its signals: the value with its rates, what it exerts, those of its contact."""
        effort = {self.effort: u.TORQUE if self.effort == "torque" else u.FORCE}
        return {**(TURN if self.turning else TRAVEL), **effort, **self.extra}

    @property
    def charts(self) -> Sequence[SignalChart]:
        """How its effort and the signals of its contact are shown."""
        return [SignalChart("follower", "force", attribute) for attribute in (self.effort, *self.extra)]

    @property
    def one_sided(self) -> Mapping[str, int]:
        """Its forces that have one sign only, as :attr:`JointEntry.one_sided` has them; what its entry says."""
        found: Mapping[str, int] = self.entry.one_sided
        return found

    @property
    def touching(self) -> tuple[str, str] | None:
        """The links that slide past each other in its contact, if that is known (:meth:`touch`): the one that follows,
        and the other."""
        return None

    @property
    def roller(self) -> Any:
        """The radius of the roller that rolls in its contact, as its entry states it; ``None`` where links slide."""
        return None

    def touch(self, name: str, poses: PoseQuery, acting: UnitEffort) -> Touch:
        """Where its links touch; ``acting`` is what its effort does."""
        raise NotImplementedError

    def reported_touch(self, reports: FollowerReports, name: str) -> ReportedTouch:
        """The same from reported numbers: a part of the proof."""
        raise NotImplementedError

    @property
    def pressures(self) -> Sequence[str]:
        """The signals of its contact that are pressure angles: where the cosine of one isn't positive, the contact
        holds the link fast, or would have to draw it."""
        return ()

    @property
    def laws(self) -> Mapping[str, str]:
        """The motion laws that it asks, by the entry's keys."""
        return {}

    @property
    def has_second_contact(self) -> bool:
        """Whether a second contact holds the link where the first one would have to pull."""
        return False

    @property
    def derived(self) -> bool:
        """Whether the place of this second contact follows from the first and the law."""
        return False

    @abstractmethod
    def relation(self, geometry: FollowerGeometry, motions: Motions) -> MotorRelation:
        """How its value follows from that of its motor; ``geometry`` is at the nominal parameters."""

    def acting(self, name: str, poses: PoseQuery, ratio: Scalar) -> UnitEffort:
        """What its effort does, where the value changes by ``ratio`` with the motor's (which counts as ``motor_sign``).

        Unless a kind knows where its links touch: by duality. The effort acts at the joint of link and ``on`` and,
        times the ratio and the other way round, at that of the motor, so that the two do no work together.
        """
        found = dict(poses.unit(name))
        for link, wrench in poses.unit(self.motor).items():
            geared = wrench.times(-(self.motor_sign * ratio))
            found[link] = found[link].plus(geared) if link in found else geared
        return UnitEffort(found)

    def second(self, name: str, poses: PoseQuery, ratio: Scalar, total: Scalar) -> UnitEffort | None:
        """The same of its second contact, if it has one."""
        return None

    def tree(self, geometry: FollowerGeometry, motor: Node) -> Node | None:
        """Its value at the nominal lengths, as a tree in SI of what its motor's value is, for tools that take formulas;
        ``None`` where there is none."""
        return None

    def calls(self, geometry: FollowerGeometry) -> list[Call]:
        """The calls of motion laws, of signals: where these have joins, so has the value."""
        return []

    def joins(self, geometry: FollowerGeometry) -> Sequence[Node]:
        """Expressions of signals that change their sign where parts of its value meet, besides the joins of laws: its
        value and rate run on there, its acceleration and its contact may jump."""
        return ()

    def sentence(self, geometry: FollowerGeometry) -> Text | None:
        """What its motion is, for the reader, where it follows no motion law."""
        return None

    def outline(self, geometry: FollowerGeometry) -> Sequence[Curve]:
        """What is drawn of it: closed lines on links, as :meth:`JointKind.outline` has them."""
        return ()

    def step(self, motions: Motions) -> float:
        """By how much (of the motor's value) one may go so that the value hardly bends."""
        return 0.1

    def faults(self, quantities: Any, geometry: FollowerGeometry, motions: Motions, path: Path) -> Iterator[Finding]:
        """What is wrong with its numbers; ``path`` is its place in the file."""
        yield from ()

    def law_faults(self, quantities: Any, law: str, motion: Motion, path: Path) -> Iterator[tuple[Finding, Any]]:
        """What is wrong with a motion law where this joint asks it, and in which samples."""
        yield from ()

    def findings(self, run: FollowedMotion, path: Path) -> Iterator[Finding]:
        """What is to be told of a motion that was followed; ``path`` is its place in the file."""
        yield from ()

    @property
    def reported(self) -> Sequence[str]:
        """Its signals that its proof needs, besides its effort and its rate."""
        return ()

    def misses(self, reports: FollowerReports, name: str) -> list[Miss]:
        """By what its links miss each other in the contact, where that can be told from reported poses: a part of the
        proof."""
        return []

    def restated(self, reports: FollowerReports, name: str) -> Mapping[str, Restated]:
        """Its signals by attribute once more, from reported poses alone, each by another formula than those of the
        program: those of its contact, and its value by the drive's. A part of the proof."""
        return {}

    @abstractmethod
    def applied(self, reports: FollowerReports, name: str) -> list[Applied]:
        """What the reported effort does to the links: its proof, which asks none of the other methods."""


FOLLOWERS: Registry[type[Follower]] = Registry(of_contract("follower"))
"""The kinds of followers by name."""


def register_follower(cls: type[Follower]) -> type[Follower]:
    """Register a kind of follower under its name; a second one of the same name is an error."""
    FOLLOWERS[cls.kind] = cls
    make_known("joints", cls.kind, cls.stated if issubclass(cls.stated, FollowerEntry) else None, cls.words)
    return cls
