"""Springs that keep a follower on its cam over a range of speeds, and the speed up to which a given one does.

The follower stays on where I s'' w^2 + c s + p + load >= N n . a at all cam angles, N being the least contact force
that is wanted. That is linear in the preload p, in the rate c and in w^2, so over a range of speeds its ends decide;
the least preload and the highest speed are an extreme over the turn, and the least rate is the root of a convex
function, which Newton's rule reaches from below: each step keeps the follower on at the cam angle that was worst.
(Norton, Cam Design and Manufacturing Handbook, 2nd ed.)
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from linkwright.cam.contact import ContactPlace, contact_lever, drivable, rows
from linkwright.cam.disc import Disc, DiscJets
from linkwright.cam.extremes import extremes
from linkwright.cam.loads import FollowerLoads
from linkwright.data_classes import dataclass
from linkwright.notation import Jet

Array = NDArray[np.float64]
Speeds = tuple[float, float]
"""The lowest and the highest speed of the cam (rad/s)."""

CLOSE = 1e-12
"""What is missing may be this share of the largest force along the lift."""
MOST_STEPS = 60


@dataclass(frozen=True)
class Sized:
    """A size (SI), and the cam angle ``theta`` (rad) and speed ``omega`` (rad/s) that ask for it."""

    value: float
    theta: float
    omega: float


def least_preload(disc: Disc, loads: FollowerLoads, speeds: Speeds, contact: float = 0.0) -> Sized:
    """The least preload (N or N m) at the lift 0 with the given rate that keeps ``contact`` (N) or more; that of
    ``loads`` doesn't count. 0 where none is needed."""
    drivable(ContactPlace(disc))
    found = _wanting(disc, replace(loads, preload=0.0), speeds, contact)
    return replace(found, value=max(0.0, found.value))


def least_rate(disc: Disc, loads: FollowerLoads, speeds: Speeds, contact: float = 0.0) -> Sized | None:
    """The least rate (N/m or N m/rad) with the given preload that keeps ``contact`` (N) or more; that of ``loads``
    doesn't count. ``None`` where no rate does, as on the base circle; 0 where none is needed."""
    drivable(ContactPlace(disc))
    tried = replace(loads, rate=0.0)
    scale = abs(loads.preload)
    for _ in range(MOST_STEPS):
        found = _wanting(disc, tried, speeds, contact)
        scale = max(scale, abs(found.value))
        if found.value <= CLOSE * scale:
            return replace(found, value=tried.rate)
        lift = float(rows(disc.look(np.array([found.theta])).lift.d[0], 1)[0])
        if not lift > 0:
            return None
        tried = replace(tried, rate=tried.rate + found.value / lift)
    return None


def line(disc: Disc, loads: FollowerLoads, speeds: Speeds, rates: Array, contact: float = 0.0) -> Array:
    """The least preload (N or N m) for each of several rates: (n,). What lies above this convex line keeps the follower
    on."""
    return np.array([least_preload(disc, replace(loads, rate=float(rate)), speeds, contact).value for rate in rates])


def highest_speed(disc: Disc, loads: FollowerLoads, contact: float = 0.0) -> Sized | None:
    """The speed (rad/s) up to which ``contact`` (N) or more is kept from rest on; infinite where always, ``None`` where
    not at rest."""
    drivable(ContactPlace(disc))
    if _wanting(disc, loads, (0.0, 0.0), contact).value > CLOSE * abs(loads.preload):
        return None
    if not loads.inertia:
        return Sized(math.inf, 0.0, math.inf)

    def inertia_share(look: DiscJets) -> Jet:
        """The inertia's share of what holds the follower at rest, over w^2."""
        held = loads.along(look, 0.0) - contact_lever(look) * contact
        held = held.maximum(0.0 * held)  # where all is used up, round-off may pull
        return look.lift.rate().rate() * -loads.inertia / held

    with np.errstate(divide="ignore", invalid="ignore"):  # nothing presses at rest in a dwell
        most = extremes(loads.over(disc), inertia_share)[1]
    speed = 1.0 / math.sqrt(most.value) if most.value > 0 else math.inf
    return Sized(speed, most.theta, speed)


def _wanting(disc: Disc, loads: FollowerLoads, speeds: Speeds, contact: float) -> Sized:
    """How much the force along the lift (N or N m) falls short of what ``contact`` (N) needs, at its worst; negative
    where it has more everywhere."""
    found = []
    for omega in sorted(set(speeds)):

        def short(look: DiscJets, omega: float = omega) -> Jet:
            return contact_lever(look) * contact - loads.along(look, omega)

        worst = extremes(loads.over(disc), short)[1]
        found.append(Sized(worst.value, worst.theta, omega))
    return max(found, key=lambda size: size.value)
