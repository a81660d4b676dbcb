"""Forces on a cam: its spring against lift-off, contact force, torque, Hertz pressure, the roller's speed."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from functools import cached_property

from linkwright.cam.checks import CamCheck
from linkwright.cam.disc import Disc
from linkwright.cam.extremes import CamExtreme
from linkwright.cam.hertz import Pressure, pressure, rolling
from linkwright.cam.loads import CamForces, FollowerLoads, forces
from linkwright.cam.springs import Sized, highest_speed, least_preload, least_rate
from linkwright.data_classes import dataclass
from linkwright.studies.cam.force_numbers import FollowerForces

SHORT = 1e-6
"""A preload may be short by this share: what is told to seven digits does."""

MORE = 1 + 1e-9
"""A sized spring is so much stronger, so that round-off doesn't count against what it was sized for."""


@dataclass(frozen=True)
class Pressed:
    """A follower under load: its ``loads`` with the spring as given or sized. ``preload`` and ``rate`` are the least
    ones with the other one as it is (no ``rate`` may do), ``highest`` the speed up to which it stays on (``None``: not
    even at rest); ``None`` all three where form holds it without a spring."""

    asked: FollowerForces
    disc: Disc
    loads: FollowerLoads
    preload: Sized | None = None
    rate: Sized | None = None
    highest: Sized | None = None

    @cached_property
    def forces(self) -> CamForces:
        """At the speed."""
        return forces(self.disc, self.loads, self.asked.omega, second=self.asked.second)

    @cached_property
    def pressures(self) -> list[Pressure]:
        """Of each side; none without a width."""
        a = self.asked
        if a.width is None:
            return []
        sides = [False] if a.second is None else [False, True]
        return [pressure(self.forces, a.width, a.cam, a.follower, second) for second in sides]

    @cached_property
    def torque(self) -> CamExtreme:
        """The largest, either way."""
        return max(self.forces.torque_range, key=lambda one: abs(one.value))

    @cached_property
    def hertz(self) -> CamExtreme | None:
        """The largest pressure (Pa) of all sides."""
        return max((one.highest for one in self.pressures), key=lambda one: one.value, default=None)

    @property
    def has_second_contact(self) -> bool:
        """Whether the second side has a contact of its own: a second roller, edge or face."""
        return self.asked.second is not None and self.asked.second.flank < 0

    def spin(self, second: bool = False) -> CamExtreme | None:
        """The roller's largest speed (rad/s) against its pin, either way; of a groove on the flanks that bear."""
        if not self.disc.follower.radius > 0:
            return None
        f = self.forces
        sides = [f.first]
        if second:
            assert f.second is not None
            sides = [f.second]
        elif f.second is not None and not self.has_second_contact:
            bear = {part.side for part in f.bearing}
            sides = [side for side, sign in ((f.first, 1), (f.second, -1)) if sign in bear] or sides
        found = [one for side in sides for one in rolling(side, f.omega, f.theta).spin_range]
        return max((CamExtreme(abs(one.value), one.theta) for one in found), key=lambda one: one.value)

    @property
    def short(self) -> bool:
        """Whether the contact force falls below the least within the speeds."""
        if self.asked.second is not None or self.preload is None:
            return False
        need, have = self.preload.value, self.loads.preload
        return need - have > SHORT * max(need, have)

    @cached_property
    def least(self) -> CamExtreme:
        """The contact force (N) where it is least at the speed that asks for most."""
        assert self.preload is not None
        return forces(self.disc, self.loads, self.preload.omega).contact_range[0]

    def figures(self) -> Iterator[tuple[str, CamExtreme]]:
        """By name, SI; infinite where there is no bound."""
        low, high = self.forces.contact_range
        yield "contact_force_min", replace(low, value=max(low.value, 0.0)) if self.has_second_contact else low
        yield "contact_force_max", high
        yield "shaft_torque_max", CamExtreme(abs(self.torque.value), self.torque.theta)
        if self.hertz is not None:
            yield "hertz_pressure_max", self.pressures[0].highest if self.has_second_contact else self.hertz
        if (spin := self.spin()) is not None:
            yield "roller_speed_max", spin
        if self.has_second_contact:
            yield from self._second()
        if self.preload is not None:
            at = self.preload.theta
            highest, rate = self.highest or Sized(0.0, at, 0.0), self.rate or Sized(math.inf, at, 0.0)
            yield "lift_off_speed", CamExtreme(highest.value, highest.theta)
            yield "spring_preload_min", CamExtreme(self.preload.value, at)
            yield "spring_rate_min", CamExtreme(rate.value, rate.theta)

    def _second(self) -> Iterator[tuple[str, CamExtreme]]:
        """Those of the second contact."""
        found = self.forces.second_range
        assert found is not None
        yield "second_contact_force_max", replace(found[1], value=max(found[1].value, 0.0))
        if self.pressures:
            yield "second_hertz_pressure_max", self.pressures[1].highest
        if (spin := self.spin(second=True)) is not None:
            yield "second_roller_speed_max", spin

    def checks(self) -> Iterator[CamCheck]:
        """Against the limits that are stated."""
        for name, found, limit in (
            ("hertz_pressure", self.hertz, self.asked.hertz),
            ("shaft_torque", self.torque, self.asked.torque),
        ):
            if found is not None and limit is not None:
                yield CamCheck(name, abs(found.value), found.theta, limit, limit - abs(found.value))


def pressed(disc: Disc, asked: FollowerForces) -> Pressed:
    """A follower under load, with what of its spring isn't given sized.

    Raises :class:`linkwright.cam.contact.NoContact`.
    """
    loads, speeds, contact = asked.loads, asked.speeds, asked.contact
    if not asked.sprung:
        return Pressed(asked, disc, loads)
    if asked.preload is None:
        loads = replace(loads, preload=MORE * least_preload(disc, loads, speeds, contact).value)
    rate = least_rate(disc, loads, speeds, contact)
    if asked.rate is None and asked.preload is not None and rate is not None:
        loads = replace(loads, rate=MORE * rate.value)
    preload = least_preload(disc, loads, speeds, contact)
    return Pressed(asked, disc, loads, preload, rate, highest_speed(disc, loads, contact))
