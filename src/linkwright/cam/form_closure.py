"""Followers closed by form: a groove, a conjugate pair of discs, a yoke around one disc.

Each gives the second :class:`linkwright.cam.contact.ContactPlace`, with which :func:`linkwright.cam.loads.forces` says
when which side bears. (Rothbart, Cam Design Handbook, 2004; Norton, Cam Design and Manufacturing Handbook, 2nd ed.)
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.cam.checks import CamCheck, CamLimits, checks, undercut
from linkwright.cam.contact import ContactPlace, NoContact
from linkwright.cam.disc import Disc, DiscJets
from linkwright.cam.extremes import CamExtreme, extremes
from linkwright.data_classes import dataclass
from linkwright.notation import Jet

Array = NDArray[np.float64]


@dataclass(frozen=True)
class GrooveClosure:
    """A roller between two flanks, both offset from the pitch curve by its radius.

    ``checks`` are those of the inner flank (``pitch_radius``) and of the outer one (``groove_radius``), each with its
    limit, margin and place; a flank whose check isn't ``passed`` is undercut.
    """

    disc: Disc
    checks: tuple[CamCheck, ...]

    @property
    def second(self) -> ContactPlace:
        """The outer flank."""
        return ContactPlace(self.disc, flank=1)

    @property
    def figures(self) -> dict[str, CamExtreme]:
        """Sizes by name: none."""
        return {}

    @property
    def passed(self) -> bool:
        """Whether neither flank is undercut."""
        return all(check.passed for check in self.checks)


def groove(disc: Disc) -> GrooveClosure:
    """The groove of a cam with a roller. Raises :class:`NoContact` (``cam.groove``) for one without."""
    if not disc.follower.radius > 0:
        raise NoContact("cam.groove")
    found = checks(disc, CamLimits(groove=True))
    return GrooveClosure(disc, tuple(check for check in found if check.name in ("pitch_radius", "groove_radius")))


@dataclass(frozen=True)
class Conjugate:
    """A second disc on the same shaft that holds a second roller, edge or face of the same follower against the first.

    ``disc`` describes it in a mirrored world, in which y is -y and the shaft turns the other way: all that is a length,
    a curvature or a size of an angle holds as it stands, its lift is ``total`` - s (m or rad), the first one's lift
    being s. ``between`` is what the follower keeps: of a swinging one the angle (rad) between both arms or faces, which
    have the line of centres between them; of a translating one the distance (m) along the slide.
    """

    first: Disc
    disc: Disc
    total: float
    between: float

    @property
    def second(self) -> ContactPlace:
        """The second disc as a side."""
        return ContactPlace(self.disc, mirrored=True)

    @property
    def figures(self) -> dict[str, CamExtreme]:
        """Sizes by name: the second base circle (m), and what is between (m or rad)."""
        return {"second_base": CamExtreme(self.disc.follower.base, 0.0), "between": CamExtreme(self.between, 0.0)}

    def curve(self, theta: Array, by: float | None = None) -> Array:
        """The second disc's profile, or its curve ``by`` (m) outward of the pitch curve, in the frame of the first, at
        cam angles (n,): (2, n), m."""
        found = self.disc.look(theta).offset(-self.disc.follower.radius if by is None else by)
        mirrored: Array = found * np.array([[1.0], [-1.0]])
        return mirrored


def conjugate(disc: Disc, *, base: float | None = None, between: float | None = None, **lengths: float) -> Conjugate:
    """The disc that makes a pair with ``disc`` without play.

    Its size is the ``base`` circle (m), or what the follower keeps ``between`` its two arms or faces (rad) or its two
    rollers or faces (m); with neither, the base circle is the first one's. ``lengths`` (m) are those of the second
    contact that differ from the first's: ``roller``, ``arm``, ``offset``, ``face``.

    Raises :class:`NoContact` where the second disc can't be or would have no profile, ``cam.second-side``,
    ``cam.second-base`` or ``cam.undercut``, and :class:`linkwright.cam.followers.NoFollower`.
    """
    made = opposite(disc, base=base, between=between, **lengths)
    if (cut := undercut(made.disc)) is not None:
        raise NoContact("cam.undercut", theta=cut.theta)
    return made


def opposite(disc: Disc, *, base: float | None = None, between: float | None = None, **lengths: float) -> Conjugate:
    """The same, be the second disc undercut or not."""
    if "distance" in lengths:
        raise ValueError("both discs are on one shaft")
    total = extremes(disc, lambda look: look.lift)[1].value
    own: Any = disc.follower
    other: Any = replace(own, base=own.base if base is None else base, **lengths)
    if between is not None:
        other = _based(other, between, own.start + total)

    def lift(theta: Jet) -> Jet:
        return total - disc.lift(theta)

    return Conjugate(disc, Disc(other, lift, -disc.sense, disc.joins), total, own.start + other.start + total)


def _based(follower: Any, between: float, first: float) -> Any:
    """The follower with the base circle on which it rests, what is between and the first one's largest value given."""
    start = math.remainder(between - first, 2 * math.pi) if follower.turns else between - first
    low, high = follower.starts
    if not low < start < high:
        raise NoContact("cam.second-side", between=start + first, low=low + first)
    if not (base := follower.base_at(start)) > 0:
        raise NoContact("cam.second-base", base=base)
    return replace(follower, base=base)


@dataclass(frozen=True)
class Yoke:
    """Two parallel faces, or two rollers opposite each other, around one disc.

    ``narrowest`` and ``widest`` are the least and the largest distance (m) along the slide between the faces or the
    rollers' centres that the disc asks for, and where. A yoke fits without play only where they are one:
    s(theta) + s(theta + pi) is constant.
    """

    disc: Disc
    narrowest: CamExtreme
    widest: CamExtreme

    @property
    def play(self) -> float:
        """The largest play (m) of a yoke that passes."""
        return self.widest.value - self.narrowest.value

    @property
    def figures(self) -> dict[str, CamExtreme]:
        """Sizes by name (m)."""
        play = CamExtreme(self.play, self.widest.theta)
        return {"yoke_span_min": self.narrowest, "yoke_span_max": self.widest, "play": play}

    @property
    def second(self) -> ContactPlace:
        """The contact on the other side."""
        return ContactPlace(self.disc, shift=math.pi)


def yoke(disc: Disc) -> Yoke:
    """What a yoke around a disc with a translating follower must span. Rollers with an offset lie opposite each other
    about the cam's centre. Raises :class:`NoContact` (``cam.yoke``) for a swinging follower: it takes a conjugate disc.
    """
    follower = disc.follower
    if follower.turns:
        raise NoContact("cam.yoke")
    other = ContactPlace(disc, shift=math.pi)

    def span(look: DiscJets) -> Jet:
        return look.lift + other.look(look.theta).lift + 2 * follower.start

    both = replace(disc, joins=(*disc.joins, *other.joins))
    return Yoke(disc, *extremes(both, span))


Closing = GrooveClosure | Conjugate | Yoke
"""What keeps a follower on without a force."""
