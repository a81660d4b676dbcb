"""What a kind of joint is: the contract that structure, motion, forces, proofs and exports ask.

A *kind* is one registered object. On the links of a mechanism it gives an :class:`Inner` joint: the closure that its
links have to meet, ``rows`` equations; and where it can place a link, an :class:`Outer` joint: the link's motion from
one coordinate. Both are generic over the scalar (numbers, arrays, symbols) and speak jets, so that the same lines give
position, velocity, acceleration and jerk, and by duality the equilibrium. Nobody asks a kind for its name or letter.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, ClassVar, Literal, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.elements.clearance import LooseJoint, StatedClearance
from linkwright.elements.curves import Curve
from linkwright.elements.entries import JointEntry, make_known
from linkwright.elements.kind_modules import of_contract
from linkwright.elements.touch import ReportedTouch, Touch
from linkwright.expressions.written import FaultWithin
from linkwright.findings import Term
from linkwright.notation import Body, Jet, Pair, Scalar, Vec, Wrench
from linkwright.notation.registry import Registry

Array = NDArray[np.float64]
RowUnit = Literal["length", "angle"]
Applied = tuple[str, Array, Array, Array | float]
"""A force (2, times) on a link at a place (2, times), with a moment (times,): (link, force, place, moment)."""


@dataclass(frozen=True)
class Twist:
    """The motion that a unit rate of a freedom gives a link: turning ``turn`` (1 or 0) about ``about``, while that
    place moves ``along`` (m per unit rate)."""

    turn: float
    about: Pair
    along: Pair

    def velocity(self, point: Pair) -> Pair:
        """Velocity of the link's point now at ``point`` (m per unit rate)."""
        if not self.turn:
            return self.along
        turned = point.minus(self.about).perp
        return Pair(self.along.x + turned.x, self.along.y + turned.y)

    def work(self, wrench: Wrench) -> Scalar:
        """Power of a wrench on this unit rate: the generalised force."""
        pushed = self.along.dot(wrench.force)
        return pushed + wrench.at(self.about).moment if self.turn else pushed


STILL = Twist(0.0, Pair(0.0, 0.0), Pair(0.0, 0.0))
"""The motion of a link that a freedom doesn't move."""


class Outer(Protocol):
    """An outer joint: places its link from a coordinate, and gives the freedom that it leaves."""

    def place(self, start: Any, rates: Jet) -> Body:
        """The link's motion from its coordinate, as dyads have it, and the rates (q', q'', ...)."""

    def place_at(self, start: Scalar, rates: Jet) -> Body:
        """The same from the coordinate as one number or symbol (rad or m)."""

    def driven_body(self, base: Body, law: Jet) -> Body:
        """The link where a drive prescribes its coordinate relative to the ``base`` link by a law (rad or m)."""

    def twist(self, body: Body) -> Twist:
        """The freedom of the placed link."""

    def coordinate(self, body: Body) -> float:
        """The coordinate of a placed link on plain numbers (rad or m)."""

    def nearest(self, places: Sequence[tuple[Pair, Pair]]) -> float | None:
        """The coordinate (rad or m) that brings places of the link, as they lie at 0, nearest to others; ``None``
        where they don't decide."""


class Inner(ABC):
    """A joint as closure between its links, in a fixed order.

    A kind states the :meth:`gap`; slopes and actions follow from it. The multiplier of an equation (N, of an angle
    N m) stands for a wrench on each link: the multiplier times the slope of the equation to the link's displacement.
    """

    @abstractmethod
    def gap(self, *bodies: Body) -> tuple[Jet, ...]:
        """What each equation misses: lengths (m) or angles (rad), with as many rates as the bodies have."""

    def rates(self, bodies: Sequence[Body], twists: Sequence[Twist]) -> list[Scalar]:
        """The slope of each equation to a freedom that moves the links by ``twists``."""
        moving = (_moving(body, twist) for body, twist in zip(bodies, twists, strict=True))
        return [gap.d[1] for gap in self.gap(*moving)]

    def actions(self, bodies: Sequence[Body], multipliers: Sequence[Scalar]) -> list[Wrench]:
        """The wrench on each link that the multipliers stand for, about its anchor."""
        found = []
        for i, body in enumerate(bodies):
            about = body.anchor.now
            units = [Twist(0.0, about, Pair(1.0, 0.0)), Twist(0.0, about, Pair(0.0, 1.0))]
            units.append(Twist(1.0, about, Pair(0.0, 0.0)))
            x, y, moment = (
                sum((m * s for m, s in zip(multipliers, self.rates(bodies, alone), strict=True)), 0.0)
                for alone in ([unit if k == i else STILL for k in range(len(bodies))] for unit in units)
            )
            found.append(Wrench(Pair(x, y), moment, about))
        return found

    def place(self, bodies: Sequence[Body]) -> Pair | None:
        """Where its force acts, of a closure of one point; ``None`` elsewhere."""
        return None

    def besides(self, bodies: Sequence[Body], multipliers: Sequence[Scalar]) -> list[Wrench]:
        """Wrenches on the links that come with the multipliers and do no work on any motion that the mechanism has,
        such as the force that separates two gears; none where the list is empty."""
        return []


def _moving(body: Body, twist: Twist) -> Body:
    """A body in its present pose with the velocity of a twist."""
    at, axis = body.anchor.now, body.axis.now
    speed, turn = twist.velocity(at), twist.turn
    turning = Vec(Jet([axis.x, -turn * axis.y]), Jet([axis.y, turn * axis.x]))
    return Body(Vec(Jet([at.x, speed.x]), Jet([at.y, speed.y])), body.local, turning, Jet([turn]), body.angle)


class JointGeometry(Protocol):
    """The dimensions that a kind asks for, of a mechanism at some parameters; lengths in m, in the links' frames."""

    @property
    def mechanism(self) -> Any:
        """The model: ``mechanism.joints[NAME]`` is the joint's entry in the file."""

    def number(self, expression: Any, dimension: Any) -> Scalar:
        """The value of an expression of the entry, in SI."""

    def point(self, link: str, name: str) -> Pair:
        """A named point of a link."""

    def pinned_place(self, pin: str, link: str) -> Pair:
        """The place of a link that is put on a pin, its clearance included."""

    def pin_point(self, pin: str, link: str) -> Pair:
        """The link's point on a pin, without clearance."""

    def line(self, joint: str, link: str) -> tuple[Pair, Pair]:
        """Point and heading of a prismatic joint's line on one of its links."""

    def seat(self, joint: str, link: str) -> tuple[Pair, Pair, Scalar]:
        """The same with the clearance included, and the heading's angle (rad)."""

    def play(self, joint: str, name: str) -> Scalar:
        """The offset of a joint of that name (see :class:`LooseJoint`), in SI."""

    def text_of(self, value: float, dimension: Any) -> str:
        """A value in SI as the file has such ones, with its unit."""

    def place(self, link: str, at: Any) -> Pair:
        """A place on a link, by the name of a point or by coordinates."""

    def phases(self, joint: str) -> tuple[float, ...] | None:
        """What the joint's kind has fixed at assembly; ``None`` before that."""


class LinkPoses(Protocol):
    """The links as they lie at a pose, with rates; numbers or symbols, in SI."""

    @property
    def geometry(self) -> JointGeometry:
        """The dimensions of the mechanism."""

    @property
    def bodies(self) -> Mapping[str, Body]:
        """The links by name."""


class ContactReaction(Protocol):
    """Where a reaction acts: ``link`` on ``on`` (a link, or the pin where three or more meet)."""

    @property
    def joint(self) -> str:
        """The joint's name."""

    @property
    def link(self) -> str:
        """The link that acts."""

    @property
    def on(self) -> str:
        """What it acts on."""


class JointReports(Protocol):
    """What a run reports of poses and reactions at some times; vectors have shape (2, times)."""

    @property
    def geometry(self) -> JointGeometry:
        """The model's dimensions."""

    def point_position(self, link: str, local: Any) -> Array:
        """A link's point in the frame (m)."""

    def rotated(self, link: str, local: Any) -> Array:
        """A vector fixed in a link, in the frame."""

    def line(self, joint: str, link: str) -> tuple[Array, Array]:
        """Point and direction of a prismatic joint's line on one of its links."""

    def reaction(self, contact: Any) -> tuple[Array, Array | float]:
        """The reported force (N) of a contact's link on the other side, and its moment (N m; 0 where none is)."""

    def contact(self, joint: str, link: str) -> Any:
        """The contact of a link in a joint."""

    def law(self, drive: str) -> Array:
        """What a drive prescribes (rad or m), by its law alone."""

    def turned(self, link: str) -> Array:
        """A link's angle (rad) over all turns since the first time, by its reported directions and rates."""

    def velocity(self, link: str, place: Array) -> Array:
        """The velocity of a link where it is at a place (m/s)."""

    def omega(self, link: str) -> Array:
        """A link's angular velocity (rad/s)."""


class Miss(NamedTuple):
    """What a joint's links miss each other by, at some times: lengths (m) or pure numbers."""

    value: Array
    length: bool


class Restated(NamedTuple):
    """A signal once more from raw geometry, at some times (SI); NaN where the formula says nothing. Values that are
    ``period`` apart are the same, such as angles a full turn apart; 0 of others."""

    value: Array
    period: float = 0.0


class Rate(NamedTuple):
    """A part of a constraint on velocities: that of a link at a ``place`` along a ``direction`` (2, times), or where
    there is no place its angular velocity; times ``factor``."""

    link: str
    factor: float
    place: Array | None = None
    direction: Array | None = None


Reaction = Callable[[str], Wrench]


class JointKind(ABC):
    """A kind of joint; stateless. ``bodies`` are those of the links, by name.

    The methods from :meth:`misses` on are its proof: they know the model's dimensions and what a run reports, and ask
    none of the kind's other methods.
    """

    name: ClassVar[str]
    """As files have it."""
    letter: ClassVar[str]
    """As signatures of groups spell it: R, P."""
    row_units: ClassVar[tuple[RowUnit, ...]]
    """What each constraint that it states is a gap of; two links keep three freedoms less so many."""
    shared: ClassVar[bool] = False
    """Whether any number of links meet in one: of k links it counts k - 1 times."""
    parallel: ClassVar[bool] = False
    """Whether it keeps the directions of its links to each other."""
    angular: ClassVar[bool | None] = None
    """Whether the coordinate by which it places a link is an angle (else a length); ``None`` where it places none."""
    drive: ClassVar[str] = ""
    """The key of drives that act in it."""
    prescribed: ClassVar[bool] = False
    """Whether it is no joint but what the drive of its name prescribes: its closure gives a value, which has to be that
    of the drive's law."""
    entry: ClassVar[type[JointEntry] | None] = None
    """What a file says of it; pins and slides have entries of their own."""
    orders: ClassVar[Mapping[str, int]] = {}
    """The derivatives of the motion that each of its signals needs."""
    floating: ClassVar[bool] = False
    """Whether it is no joint but a coordinate of a link that no joint places (:mod:`.floating`)."""
    phased: ClassVar[bool] = False
    """Whether the pose in which it is drawn fixes constants of its closure (:meth:`phase`)."""
    winds: ClassVar[bool] = False
    """Whether it asks the angles of its links (``Body.angle``), over any number of turns: groups whose closed forms
    know no more than the directions of such links are solved by Newton, which follows their angles. A kind that asks an
    angle without saying so is refused (``joint.winds``) where that isn't known."""
    plays: ClassVar[tuple[str, ...] | None] = None
    """What clearances in it say besides their size (``length``, ``centre``, ``in``); ``None`` where they are refused,
    as it isn't known where its links would rest."""
    words: ClassVar[Mapping[str, Mapping[str, str]]] = {}
    """Texts that the catalogue lacks, by language and key; ``term.kind-NAME`` is what it is called."""

    @property
    def title(self) -> Term:
        """What it is called."""
        return Term(f"kind-{self.name}")

    @property
    def rows(self) -> int:
        """The constraints that it states."""
        return len(self.row_units)

    @property
    def places(self) -> bool:
        """Whether it can place a link on a known one."""
        return self.angular is not None

    def __reduce__(self) -> tuple[Any, ...]:
        return kind, (self.name,)

    def outer(self, geometry: JointGeometry, joint: str, link: str, base: str, body: Body) -> Outer:
        """The joint by which a link hangs on the known ``base``, which lies as ``body`` says."""
        raise NotImplementedError

    @abstractmethod
    def inner(self, geometry: JointGeometry, joint: str, links: Sequence[str]) -> Inner:
        """The joint as closure between links, in this order."""

    def phase(self, geometry: JointGeometry, joint: str, bodies: Mapping[str, Body]) -> tuple[float, ...]:
        """Of a kind that is ``phased`` the angles and travels that its closure counts from, such as how two gears mesh,
        from the pose in which its links are drawn at the nominal dimensions; :meth:`JointGeometry.phases` has them from
        then on, for samples of other dimensions too. Sums with radii, which samples vary, are made of them later: else
        they would depend on how the axes of links are drawn."""
        raise NotImplementedError

    def play(
        self, geometry: JointGeometry, joint: str, links: Sequence[str], stated: StatedClearance
    ) -> Sequence[LooseJoint]:
        """Of a kind with ``plays`` what is held in a joint, on its ``links``, with a clearance without faults."""
        raise NotImplementedError

    def play_faults(
        self, geometry: JointGeometry, joint: str, links: Sequence[str], stated: StatedClearance
    ) -> Iterator[FaultWithin]:
        """What is wrong with a clearance."""
        yield from ()

    @abstractmethod
    def reference(self, geometry: JointGeometry, joint: str, link: str, bodies: Mapping[str, Body]) -> Pair:
        """The place (m) about which the moment of a link's reaction is stated."""

    def signal(
        self, geometry: JointGeometry, joint: str, attribute: str, bodies: Mapping[str, Body], reaction: Reaction
    ) -> Scalar:
        """One of its signals; ``reaction`` gives the wrench of one of its links on the joint."""
        raise NotImplementedError

    def outline(self, geometry: JointGeometry, joint: str, low: Scalar, high: Scalar) -> Sequence[Curve]:
        """What is drawn of it: lines on links, between the lowest and the highest travel (m; NaN without a signal
        ``s``). A page asks with symbols, so that the lines follow when a number of the file is changed."""
        return ()

    def touch(self, geometry: JointGeometry, joint: str, bodies: Mapping[str, Body]) -> Touch:
        """Where the first of the entry's ``touching`` links touches the second."""
        raise NotImplementedError

    def reported_touch(self, reports: JointReports, joint: str) -> ReportedTouch:
        """The same from reported numbers: a part of the proof."""
        raise NotImplementedError

    @abstractmethod
    def misses(self, reports: JointReports, joint: str, links: Sequence[str]) -> list[Miss]:
        """By what the links miss each other."""

    @abstractmethod
    def constraints(self, reports: JointReports, joint: str, links: Sequence[str]) -> list[list[Rate]]:
        """The constraints on velocities, each a sum that vanishes."""

    @abstractmethod
    def applied(self, reports: JointReports, contact: ContactReaction) -> Applied:
        """What a reported reaction does: (link, force on it in N, place, moment)."""

    def restated(self, reports: JointReports, joint: str) -> Mapping[str, Restated]:
        """Its signals by attribute once more, from reported poses, velocities and reactions alone, each by another
        formula than :meth:`signal`'s; rates of signals are proven by their integrals."""
        return {}

    def misfits(self, reports: JointReports, joint: str) -> list[Array]:
        """By what reported reactions miss the law that they follow besides the closure (N), such as the pressure angle
        of teeth."""
        return []


KINDS: Registry[JointKind] = Registry(of_contract("joint"))
"""The kinds of joints by name."""


def register(cls: type[JointKind]) -> type[JointKind]:
    """Register a kind of joint under its name; a second one of the same name is an error."""
    KINDS[cls.name] = cls()
    make_known("joints", cls.name, cls.entry, cls.words)
    return cls


def kind(name: str) -> JointKind:
    """A registered kind."""
    return KINDS[name]
