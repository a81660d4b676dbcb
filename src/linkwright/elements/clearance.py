"""What a kind of joint states of play: where its links may be displaced against each other, and by which force.

A kind gives what is held in it with a stated clearance, as :class:`LooseJoint` has it; :class:`OnFlank` is the
simplest. Its ``inner`` joint has the displacements as offsets, ``geometry.play(joint, name)``, which are 0 but for
derivatives.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, ClassVar, NamedTuple, Protocol

import numpy as np

from linkwright.data_classes import dataclass


class Axis(NamedTuple):
    """The ``cos`` or ``sin`` of a link's angle."""

    link: str
    part: str

    @classmethod
    def of(cls, link: str) -> tuple[Axis, Axis]:
        """Both of a link."""
        return cls(link, "cos"), cls(link, "sin")


Known = str | Axis
"""What of a pose is asked for: a signal, or a part of a link's direction."""
Rows = Mapping[Known, Any]
Seats = list[tuple[Any, ...]]
"""For each contact the components of a vector: arrays over poses, or jets of such."""


@dataclass(frozen=True)
class StatedClearance:
    """A clearance as a file states it, lengths in m: NaN where one is unsound, ``None`` what isn't given."""

    clearance: float
    length: float | None = None
    centre: str | None = None
    in_: str | None = None


class LooseJoint(Protocol):
    """A link held by another with a clearance (m). ``plays`` are the offsets of the joint by which the graph
    differentiates, ``rows`` what has to be known of each pose."""

    @property
    def kind(self) -> str:
        """The word for such a contact: ``contact.KIND-light``, ``-turned`` and ``-at-once`` say why it may be lost,
        ``workspace.errors.KIND`` how it is taken to lie."""

    @property
    def joint(self) -> str:
        """The joint's name."""

    @property
    def links(self) -> tuple[str, str]:
        """The link that holds, or the pin where there are three links or more; the link held."""

    @property
    def clearance(self) -> float:
        """The radial clearance, or half the play (m)."""

    @property
    def plays(self) -> tuple[str, ...]:
        """Names of the joint's offsets, ``JOINT/NAME``: as many as there are components at all contacts."""

    @property
    def round(self) -> bool:
        """Whether its two displacements are one vector of any direction; else each is one on its own."""

    @property
    def flank(self) -> int:
        """The sign of the displacement that a contact on one side keeps, +1 or -1; 0 where the force tells it."""

    @property
    def rows(self) -> tuple[Known, ...]:
        """What of a pose the methods need."""

    @property
    def places(self) -> tuple[Known, ...]:
        """Those of them that the gradients need: of positions alone."""

    def forces(self, rows: Rows) -> Seats:
        """Force (N) of the second of ``links`` on the first, or on the pin, at each contact."""

    def gradients(self, by: Sequence[Any], rows: Rows) -> Seats:
        """The derivative of an output by the second link's displacement from the first at each contact, from those
        ``by`` the plays."""

    def size(self, parts: Sequence[Any]) -> Any:
        """What the components at the contacts come to together: of forces what the joint transmits, of gradients the
        largest effect of unit displacements."""

    def displacement(self, seats: Seats) -> tuple[Any, ...]:
        """Displacements at the contacts as that of the second link from the first: of a pin in the frame (m), of a
        guide across it at its centre (m) and the tilt (rad), of a flank along its normal (m)."""


class AnyDirection:
    """What a joint with clearance shares with others whose displacement is one vector of any direction."""

    kind: ClassVar[str] = "pin"
    flank: ClassVar[int] = 0
    round: ClassVar[bool] = True

    def size(self, parts: Sequence[Any]) -> Any:
        x, y = parts
        return np.hypot(x, y)

    def displacement(self, seats: Seats) -> tuple[Any, ...]:
        ((x, y),) = seats
        return x, y


@dataclass(frozen=True)
class OnFlank:
    """A link that touches the other along a normal, on either flank or with ``flank`` on that of this sign alone.

    The offset ``JOINT/across`` is its displacement (m) from the first link along the normal; ``sense`` times the
    signal ``row`` its force (N) on the first link along it.
    """

    joint: str
    links: tuple[str, str]
    clearance: float
    row: str
    sense: int = 1
    flank: int = 0
    kind: ClassVar[str] = "flank"
    round: ClassVar[bool] = False
    places: ClassVar[tuple[Known, ...]] = ()

    @property
    def plays(self) -> tuple[str, ...]:
        return (f"{self.joint}/across",)

    @property
    def rows(self) -> tuple[Known, ...]:
        return (self.row,)

    def forces(self, rows: Rows) -> Seats:
        return [(rows[self.row] * self.sense,)]

    def gradients(self, by: Sequence[Any], rows: Rows) -> Seats:
        return [(by[0],)]

    def size(self, parts: Sequence[Any]) -> Any:
        return np.abs(parts[0])

    def displacement(self, seats: Seats) -> tuple[Any, ...]:
        return seats[0]
