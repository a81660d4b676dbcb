"""Where the locking disc doesn't reach the horn that would have to bear, so that the wheel is hardly held.

The disc is cut out about each pin's arm as far as the pin is in a slot, so that its edge passes the line of centres
where the pin leaves a slot or enters the next one. From there until the edge has passed the horn on that side, the disc
holds a moment on the wheel of one sense by the other horn, but one of the other sense only by its edge, whose arm about
the wheel's centre begins at zero.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import pi
from typing import TYPE_CHECKING

import numpy as np

from linkwright.elements.geneva.contact import Dimensions, Indexing
from linkwright.expressions import units as u
from linkwright.expressions.typed_fields import Path
from linkwright.findings import Finding
from linkwright.notation import Jet

if TYPE_CHECKING:
    from linkwright.elements.follower import FollowedMotion
    from linkwright.elements.geneva.follower import GenevaDrive

SLIGHT = 1e-9
"""A force below this share of the largest one is none."""
INSIDE = 1e-9
"""Nearer than this (rad) to the ends of the stretch it isn't looked at."""


def unsupported(run: FollowedMotion, path: Path, drive: GenevaDrive) -> Iterator[Finding]:
    """A warning where a force at a horn is largest that the disc doesn't reach."""
    t, (size, turned) = run.rows([f"{path[-1]}.force", f"{drive.motor}.angle"])
    at = Dimensions.of(run.geometry, drive)
    cosine, sine = (float(part) for part in at.horn)
    horn, half = np.arctan2(sine, cosine), float(at.half)
    open_ = np.zeros(t.size, dtype=bool)
    locked = np.ones(t.size, dtype=bool)
    for psi in Indexing(drive, at).angles(at, Jet([turned])):
        here = np.mod(psi.d[0] + pi, 2 * pi) - pi
        beside = np.abs(here) - (pi / 2 - half)  # how far the disc's edge has passed the line of centres
        # A positive force is that of the horn at the negative angle, which the cut-out uncovers where the pin is there.
        open_ |= (beside > INSIDE) & (beside < horn - INSIDE) & (np.sign(here) != np.sign(size))
        locked &= beside > INSIDE
    found = np.where(open_ & locked, np.abs(size), 0.0)
    worst = int(np.argmax(found))
    if found[worst] > SLIGHT * np.abs(size).max(initial=0.0):
        data = {
            "joint": path[-1],
            "force": run.geometry.text_of(float(found[worst]), u.FORCE),
            "time": f"{t[worst]:.6g}",
            "arm": run.geometry.text_of(float(at.distance) * sine, u.LENGTH),
            "span": run.geometry.text_of(float(horn), u.ANGLE),
        }
        yield Finding("geneva.horn", path, data, severity="warning")
