"""What is wrong with a cam's lengths and with its law."""

from __future__ import annotations

from collections.abc import Iterator
from math import isnan, pi
from typing import TYPE_CHECKING, Any

import numpy as np

from linkwright.elements.cam_contact.contact import CamPair, seat, slant
from linkwright.elements.cam_contact.second import (
    base_circle_position,
    contact_range,
    largest,
    other_side,
    second_seat,
    sums,
)
from linkwright.elements.follower import FollowedMotion, FollowerGeometry
from linkwright.expressions import units as u
from linkwright.expressions.typed_fields import Path
from linkwright.findings import Finding
from linkwright.laws import Motion
from linkwright.laws.numbers import first

if TYPE_CHECKING:
    from linkwright.elements.cam_contact.follower import CamFollower

SQUARE = 1e-9
"""How closely (rad) a face must be square to its slide."""
CLOSE = 1e-9


def faults(
    quantities: Any, geometry: FollowerGeometry, path: Path, drive: CamFollower, motion: Motion | None
) -> list[Finding]:
    """Followers that can't stand on the base circle, faces askew, second contacts that can't be placed."""
    with np.errstate(all="ignore"):
        found = [*_askew(quantities, geometry, path, drive)]
        found += _base_circle_faults(quantities, path, drive, seat(geometry, drive))
        if drive.has_second_contact and motion is not None and not found:
            found = [*_second_faults(quantities, geometry, path, drive, motion)]
        return found


def not_whole(quantities: Any, law: str, motion: Motion, path: Path) -> Iterator[tuple[Finding, Any]]:
    """That a law doesn't go over a turn in whole periods, and in which samples."""
    turns = 2 * pi / motion.period
    wrong = (np.abs(turns - np.round(turns)) > CLOSE * turns) | (np.round(turns) == 0)
    if np.any(wrong):
        unit, size = quantities.unit_of(u.ANGLE)
        period = f"{first(motion.period, wrong) / size:.6g}"
        yield Finding("cam.period", path, {"law": law, "period": period, "unit": unit}), wrong


def loose(run: FollowedMotion, path: Path, drive: CamFollower) -> Iterator[Finding]:
    """A warning on a yoke with play, in which the second contact would bear elsewhere."""
    spans = sums(run.motions[drive.cam.law]) if drive.cam.closed == "yoke" else np.zeros(1)
    if (play := float(np.ptp(spans))) > CLOSE * np.abs(spans).max():
        data = {"cam": path[-1], "play": run.geometry.text_of(play, u.LENGTH)}
        yield Finding("cam.loose", path, data, severity="warning")


def _second_faults(
    quantities: Any, geometry: FollowerGeometry, path: Path, drive: CamFollower, motion: Motion
) -> Iterator[Finding]:
    """What is wrong with a second contact; the first has no fault."""
    path = path if drive.cam.second is None else (*path, "second")
    if drive.derived:
        found = [*_base_circle_faults(quantities, path, drive, second_seat(geometry, drive))]
    else:
        found = [*_askew(quantities, geometry, path, other_side(drive))]
    yield from found or _misplaced(quantities, geometry, path, drive, motion)


def _askew(quantities: Any, geometry: FollowerGeometry, path: Path, drive: CamFollower) -> Iterator[Finding]:
    """A sliding follower's face that isn't square to the slide."""
    if drive.joint is None or drive.cam.face is None:
        return
    askew = float(slant(geometry, drive))
    if not abs(askew) < SQUARE:
        unit, size = quantities.unit_of(u.ANGLE)
        yield Finding("cam.askew", (*path, "face"), {"angle": f"{askew / size:.6g}", "unit": unit})


def _base_circle_faults(quantities: Any, path: Path, drive: CamFollower, here: CamPair) -> Iterator[Finding]:
    """A follower that doesn't reach the base circle; what has no value is told by itself."""
    if np.isnan(here.level):
        return
    unit, size = quantities.unit_of(u.LENGTH)

    def sized_fault(code: str, **lengths: Any) -> Finding:
        shown = {key: f"{float(length) / size:.6g}" for key, length in lengths.items()}
        return Finding(code, path, {**shown, "unit": unit, "follower": drive.link})

    if not here.turns:
        pitch = here.base + here.roller
        if not here.faced and not abs(here.aside) < pitch:
            yield sized_fault("cam.offset", offset=abs(here.aside), limit=pitch)
        return
    if not here.distance > 0:
        yield Finding("cam.no-distance", path, {"follower": drive.link})
    elif here.faced and not abs(here.level) < 1:
        yield sized_fault("cam.face", base=here.base, face=here.reach, distance=here.distance)
    elif not here.faced and not here.reach > 0:
        yield Finding("cam.no-arm", path, {"point": drive.cam.touches})
    elif not here.faced and not abs(here.level) < 1:
        low, high = abs(here.distance - here.reach), here.distance + here.reach
        pitch = here.base + here.roller
        by = max(low - pitch, pitch - high)
        yield sized_fault("cam.reach", distance=here.distance, arm=here.reach, pitch=pitch, low=low, high=high, by=by)


def _misplaced(
    quantities: Any, geometry: FollowerGeometry, path: Path, drive: CamFollower, motion: Motion
) -> Iterator[Finding]:
    """A second contact that doesn't stay on the other side, or leaves its disc no base circle; numbers without a value
    are told by themselves."""
    start, base = base_circle_position(geometry, drive, largest(drive, motion))
    if isnan(start + base):
        return
    least, most = (extreme.value for extreme in motion.extremes(0))
    stop, (low, high) = start + most - least, contact_range(drive)

    def sized_fault(code: str, dimension: u.Dimension, **data: float) -> Finding:
        unit, size = quantities.unit_of(dimension)
        shown = {key: f"{value / size:.6g}" for key, value in data.items()}
        return Finding(code, path, {"follower": drive.link, "unit": unit, **shown})

    if drive.pivot is not None and drive.cam.face is None and not second_seat(geometry, drive).reach > 0:
        assert drive.cam.second is not None
        yield Finding("cam.no-arm", path, {"point": drive.cam.second.touches})
    elif not low < start < stop < high:
        if drive.pivot is None:
            yield sized_fault("cam.second-height", u.LENGTH, height=-start)
        else:
            yield sized_fault("cam.second-side", u.ANGLE, low=start, high=stop, least=low, most=high)
    elif not drive.derived and not base > 0:
        yield sized_fault("cam.second-base", u.LENGTH, base=base)
