"""What a plate cam is held against: pressure angle, curvature of the pitch curve and of the flanks, each with its
limit, margin and place.

The roller follows the profile only while the pitch curve's convex radius exceeds the roller's: less is undercut, equal
a cusp. A concave stretch of the profile must have a larger radius than the cutter; than the roller it has by itself.
The profile's convex radius against the roller's, which is sometimes asked for, says nothing of undercut; it bounds the
contact stress. (Rothbart, Cam Design Handbook, 2004, ch. 3 and 7.)
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from linkwright.cam.disc import Disc
from linkwright.cam.extremes import CamExtreme, curvature, extremes, pressure, stretches
from linkwright.data_classes import dataclass


@dataclass(frozen=True)
class CamLimits:
    """What must hold, SI; ``None`` isn't asked for. Pressure angles on the rise and on the return; the least radius of
    the convex pitch curve over the roller's; the least convex radius of the profile; the cutter's radius. ``groove``:
    the roller runs between two flanks."""

    pressure_rise: float | None = None
    pressure_return: float | None = None
    pitch_over_roller: float | None = None
    profile_radius: float | None = None
    cutter: float | None = None
    groove: bool = False


@dataclass(frozen=True)
class CamCheck:
    """A figure at its worst: its name, value (SI) and cam angle; the limit, if any, and by how much it is kept."""

    name: str
    value: float
    theta: float
    limit: float | None = None
    margin: float | None = None

    @property
    def passed(self) -> bool:
        """Whether the limit is kept, or none was asked for."""
        return self.margin is None or self.margin >= 0


def checks(disc: Disc, limits: CamLimits | None = None, exact: bool = True) -> list[CamCheck]:
    """Each figure at its worst, those that the cam hasn't left out: no hollow, no flank. Not ``exact``: see
    :func:`linkwright.cam.extremes.extremes`."""
    return list(_checks(disc, limits or CamLimits(), exact))


def _checks(disc: Disc, limits: CamLimits, exact: bool, limited: bool = False) -> Iterator[CamCheck]:
    """All figures, or those alone that are ``limited``: what isn't asked for costs time where sizes are looked for."""
    for name, rising, most in (
        ("pressure_rise", True, limits.pressure_rise),
        ("pressure_return", False, limits.pressure_return),
    ):
        if not (limited and most is None) and (moving := stretches(disc, rising)):
            found = extremes(disc, pressure, moving, exact)[1]
            yield CamCheck(name, found.value, found.theta, most, None if most is None else most - found.value)
    yield from (_flat_face_checks if disc.follower.faced else _roller_checks)(disc, limits, exact, limited)


def _flat_face_checks(disc: Disc, limits: CamLimits, exact: bool, _: bool) -> Iterator[CamCheck]:
    """A flat face touches convex places only."""
    least = extremes(disc, lambda look: 1.0 / look.curvature, exact=exact)[0]
    limit = limits.profile_radius or 0.0
    yield CamCheck("profile_radius", least.value, least.theta, limit, least.value - limit)


def _roller_checks(disc: Disc, limits: CamLimits, exact: bool, limited: bool) -> Iterator[CamCheck]:
    roller = disc.follower.radius
    hollow, bulge = extremes(disc, curvature(), exact=exact)
    if bulge.value > 0:
        radius, least = 1.0 / bulge.value, roller * (limits.pitch_over_roller or 1.0)
        yield CamCheck("pitch_radius", radius, bulge.theta, least, radius - least)
    if roller * bulge.value >= 1:
        return  # undercut: there is no profile
    if not limited or limits.profile_radius is not None or limits.cutter is not None:
        yield from _profile(roller, limits, hollow, bulge)
    if limits.groove and hollow.value < 0:
        yield CamCheck("groove_radius", -1.0 / hollow.value, hollow.theta, roller, -1.0 / hollow.value - roller)


def _profile(roller: float, limits: CamLimits, hollow: CamExtreme, bulge: CamExtreme) -> Iterator[CamCheck]:
    """The profile is sharpest and deepest where the pitch curve is, its radius less by the roller's."""
    if bulge.value > 0:
        value, wanted = 1.0 / bulge.value - roller, limits.profile_radius
        yield CamCheck("profile_radius", value, bulge.theta, wanted, None if wanted is None else value - wanted)
    if hollow.value < 0:
        value, wanted = -1.0 / hollow.value + roller, limits.cutter
        yield CamCheck("hollow_radius", value, hollow.theta, wanted, None if wanted is None else value - wanted)


def undercut(disc: Disc) -> CamCheck | None:
    """The check that fails where there is no profile: the follower would cut into the cam that moves it."""
    name = "profile_radius" if disc.follower.faced else "pitch_radius"
    found = next((check for check in _checks(disc, CamLimits(), True, limited=True) if check.name == name), None)
    return found if found is not None and found.margin is not None and found.margin <= 0 else None


def worst(disc: Disc, limits: CamLimits, exact: bool = True) -> float:
    """The least margin of all limits, as shares: of a right angle, of the base circle's radius."""
    shares = [
        check.margin / (math.pi / 2 if check.name.startswith("pressure") else disc.follower.base)
        for check in _checks(disc, limits, exact, limited=True)
        if check.margin is not None
    ]
    return min(shares, default=math.inf)
