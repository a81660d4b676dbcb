"""What of a law places a cam's second contact, and what is wrong with this place."""

from __future__ import annotations

from collections.abc import Iterator
from math import isnan, pi

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions import units as u
from linkwright.findings import Finding
from linkwright.graph.geometry import Geometry
from linkwright.graph.seconds import rest, room, second_seat
from linkwright.laws import Motion
from linkwright.model.cams import Following

SAMPLES = 3600
"""Places of half a turn at which sums of two lifts are looked at, besides the law's joins."""


def largest(drive: Following, motion: Motion) -> float:
    """The largest lift (rad or m), or of a yoke the largest sum of two lifts half a turn apart."""
    return float(sums(motion).max()) if drive.cam.closed == "yoke" else motion.extremes(0)[1].value


def sums(motion: Motion) -> NDArray[np.float64]:
    """Sums of two lifts (m) half a turn apart, all over a turn: one number where a yoke fits without play."""
    places = np.concatenate([np.linspace(0.0, pi, SAMPLES), motion.breaks])
    return np.asarray(motion.at(places) + motion.at(places + pi))


def misplaced(geometry: Geometry, path: tuple[str, ...], drive: Following, motion: Motion) -> Iterator[Finding]:
    """A second contact that doesn't stay on the other side, or leaves its disc no base circle; numbers without a value
    are told by themselves."""
    q, (start, base) = geometry.quantities, rest(geometry, drive, largest(drive, motion))
    if isnan(start + base):
        return
    least, most = (extreme.value for extreme in motion.extremes(0))
    stop, (low, high) = start + most - least, room(drive)

    def told(code: str, dimension: u.Dimension, **data: float) -> Finding:
        unit, size = q.unit_of(dimension)
        shown = {key: f"{value / size:.6g}" for key, value in data.items()}
        return Finding(code, path, {"follower": drive.link, "unit": unit, **shown})

    if drive.pivot is not None and drive.cam.face is None and not second_seat(geometry, drive).reach > 0:
        assert drive.cam.second is not None
        yield Finding("cam.no-arm", path, {"point": drive.cam.second.touches})
    elif not low < start < stop < high:
        if drive.pivot is None:
            yield told("cam.second-height", u.LENGTH, height=-start)
        else:
            yield told("cam.second-side", u.ANGLE, low=start, high=stop, least=low, most=high)
    elif not drive.derived and not base > 0:
        yield told("cam.second-base", u.LENGTH, base=base)
