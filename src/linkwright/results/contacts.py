"""The contacts of cams from a run's reports: where each acts, and its normal, in plain NumPy."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from linkwright.model import units as u
from linkwright.model.cams import Following

if TYPE_CHECKING:
    from linkwright.results.audit import Reports

Array = NDArray[np.float64]


def contact(r: Reports, drive: Following) -> tuple[Array, Array]:
    """A place on the common normal, and this as a unit vector from the cam to the follower: (2, times) each.

    It is square to the way of the follower's point past the cam; a face has its own.
    """
    cam = drive.cam
    number = r.compiled.quantities.value
    turn = r.rows[f"{drive.motor}.angle"] * drive.turned  # of the cam on its carrier
    forward = cam.sense or ("clockwise" if _backward(r, drive) else "counter-clockwise")
    forward_sign = 1.0 if forward == "counter-clockwise" else -1.0
    lift = r.compiled.motions[cam.law]
    slope = forward_sign * lift.at(forward_sign * turn + number(cam.phase, u.ANGLE), 1)  # by the cam's angle
    shaft = r.at(drive.on, r.geometry.point(drive.on, drive.shaft[1]))
    at = r.at(drive.link, r.geometry.point(drive.link, cam.touches))
    if drive.pivot is not None:
        pivot = r.at(drive.on, r.geometry.point(drive.on, drive.pivot[1]))
        moved = -drive.side * slope * _quarter(at - pivot)
    else:
        assert drive.joint is not None
        pivot, moved = at, drive.side * slope * r.line(drive.joint, drive.on)[1]
    if cam.face is None:
        past = moved - _quarter(at - shaft)
        normal = _quarter(past)
        return at, normal / np.hypot(*normal)
    heading = number(cam.face.angle, u.ANGLE)
    face = r.turned(drive.link, (np.cos(heading), np.sin(heading)))
    normal = -drive.side * _quarter(face) if drive.pivot else drive.side * r.line(str(drive.joint), drive.on)[1]
    # Where the face moves along itself past the cam: its points at `at + x face`, in both its turning and the cam's.
    spin = -drive.side * slope - 1.0 if drive.pivot is not None else -np.ones(r.count)
    past = moved - _quarter(at - shaft)
    along = -(past * normal).sum(axis=0) / (spin * (_quarter(face) * normal).sum(axis=0))
    return at + along * face, normal


def _backward(r: Reports, drive: Following) -> bool:
    speed = r.mechanism.drives[drive.motor].speed
    return (drive.turned < 0) != (speed is not None and r.compiled.quantities.value(speed, u.OMEGA) < 0)


def _quarter(vector: Array) -> Array:
    """Turned by +90 degrees."""
    return np.array([-vector[1], vector[0]])
