"""Geneva drives from a run's reports, in plain NumPy: where the wheel must stand, and what the contact does.

It uses neither the formula of the wheel's angle nor the contact's: a pin is in a slot where it lies within the wheel's
rim, and has to lie on a slot's middle line there; elsewhere two slots lie alike on both sides of the line of centres.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from linkwright.elements.joint import Applied, Miss, Restated
from linkwright.expressions import units as u

if TYPE_CHECKING:
    from linkwright.elements.follower import FollowerReports
    from linkwright.elements.geneva.follower import GenevaDrive

Array = NDArray[np.float64]

AT_EDGE = 1e-9
"""Nearer than this to the end of a stretch, over the centre distance, the report is believed whether a pin is in it."""


class Reported:
    """The places of a drive (2, times) that a run reports."""

    def __init__(self, reports: FollowerReports, drive: GenevaDrive, name: str) -> None:
        entry, point = drive.geneva, reports.geometry.point
        driver, wheel = entry.wheels
        self.shaft, self.centre = (
            reports.point_position(link, point(link, at)) for link, at in zip(entry.wheels, entry.centres, strict=True)
        )
        self.pins = [reports.point_position(driver, point(driver, pin)) for pin in entry.pins]
        self.slots, self.arc = reports.number(entry.slots, u.PURE), reports.number(entry.arc, u.LENGTH)
        heading = reports.number(entry.slot, u.ANGLE)
        self.slot = reports.rotated(wheel, (np.cos(heading), np.sin(heading)))
        self.line = self.centre - self.shaft
        self.distance = np.hypot(*self.line)
        told = reports.rows[f"{name}.engaged"] > 0.5
        self.engaged = [self._engaged(pin, told) for pin in self.pins]

    def _engaged(self, pin: Array, told: NDArray[np.bool_]) -> NDArray[np.bool_]:
        """When a pin is in a slot: on the driver's side of the chord that its circle has in common with the rim."""
        arm = pin - self.shaft
        beyond = (arm * self.line).sum(axis=0) / self.distance - np.hypot(*arm) * np.sin(np.pi / self.slots)
        return np.where(np.abs(beyond) < AT_EDGE * self.distance, told, beyond > 0)

    def turned(self) -> tuple[Array, Array]:
        """The cosine and sine of as many times the angle, as there are slots, by which a slot lies beside the direction
        from the wheel's centre to the driver's: 1 and 0 where a slot points there."""
        away = -self.line / self.distance
        angle = self.slots * np.arctan2(away[0] * self.slot[1] - away[1] * self.slot[0], (away * self.slot).sum(axis=0))
        return np.cos(angle), np.sin(angle)


def misses(reports: FollowerReports, drive: GenevaDrive, name: str) -> list[Miss]:
    """By what pins in slots lie beside the middle lines (m), and by what a locked wheel lies beside its place."""
    at = Reported(reports, drive, name)
    found, free = list[Miss](), np.ones(reports.count, dtype=bool)
    for pin, engaged in zip(at.pins, at.engaged, strict=True):
        out = pin - at.centre
        depth = np.hypot(*out)
        # As many times the angle from the slot, as there are slots, is a whole number of turns on any of them.
        angle = at.slots * np.arctan2(at.slot[0] * out[1] - at.slot[1] * out[0], (at.slot * out).sum(axis=0))
        beside = np.hypot(np.sin(angle), np.minimum(np.cos(angle), 0.0)) / at.slots * depth
        found.append(Miss(np.where(engaged, beside, 0.0), length=True))
        free &= ~engaged
    cosine, sine = at.turned()
    found.append(Miss(np.where(free, np.hypot(sine, np.maximum(cosine, 0.0)) / at.slots, 0.0), length=False))
    return found


def applied(reports: FollowerReports, drive: GenevaDrive, name: str) -> list[Applied]:
    """What the reported force does to wheel and driver: in a slot square to its middle line through the pin, else from
    the driver's centre through one of the two places where its disc meets the wheel's rim."""
    at, size = Reported(reports, drive, name), reports.rows[f"{name}.force"]
    place, normal = bearing(at, np.where(size < 0, -1.0, 1.0))
    force = np.abs(size) * normal
    return [(drive.link, force, place, 0.0), (drive.geneva.wheels[0], -force, place, 0.0)]


def restated(reports: FollowerReports, drive: GenevaDrive, name: str) -> dict[str, Restated]:
    """The arm is that of the line of the contact's force about the wheel's centre; a pin is in a slot or none is."""
    at = Reported(reports, drive, name)
    place, normal = bearing(at, np.ones(reports.count))
    out = place - at.centre
    engaged = np.logical_or.reduce(at.engaged)
    return {
        "arm": Restated(np.abs(out[0] * normal[1] - out[1] * normal[0])),
        "engaged": Restated(engaged.astype(float)),
    }


def bearing(at: Reported, sense: Array) -> tuple[Array, Array]:
    """Where driver and wheel touch as a moment on the wheel of some sense (1 or -1) is held, and the direction of the
    force on the wheel."""
    rim = at.distance * np.cos(np.pi / at.slots)
    along = at.line / at.distance
    across = np.array([-along[1], along[0]])
    # The common points of two circles: the disc about the driver's centre, and the rim about the wheel's.
    forward = (at.arc**2 - rim**2 + at.distance**2) / (2 * at.distance)
    aside = np.sqrt(at.arc**2 - forward**2)
    place = at.shaft + forward * along - sense * aside * across
    normal = (place - at.shaft) / at.arc
    for pin, engaged in zip(at.pins, at.engaged, strict=True):
        out = pin - at.centre
        flank = sense * np.array([-out[1], out[0]]) / np.hypot(*out)
        place, normal = np.where(engaged, pin, place), np.where(engaged, flank, normal)
    return place, normal
