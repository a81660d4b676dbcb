"""What keeps the follower of a cam on it, as the file states it, and what is wrong with a second disc."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from linkwright.cam.closing import Closing, groove, yoke
from linkwright.cam.contact import NoContact
from linkwright.cam.disc import Disc
from linkwright.cam.followers import NoFollower
from linkwright.cam.pairs import other_side, second
from linkwright.graph.cams import followings, seat, slant
from linkwright.graph.geometry import Geometry
from linkwright.kernels import Compiled
from linkwright.kernels.cams import SQUARE
from linkwright.model import units as u
from linkwright.model.findings import Finding

CLOSINGS: dict[str, Callable[[Compiled, str, Disc], Closing | None]] = {
    "force": lambda compiled, name, disc: None,
    "groove": lambda compiled, name, disc: groove(disc),
    "conjugate": lambda compiled, name, disc: second(compiled, name),
    "yoke": lambda compiled, name, disc: yoke(disc),
}
"""By the word of the file."""


def held(compiled: Compiled, name: str, disc: Disc) -> tuple[Closing | None, list[Finding]]:
    """What keeps the follower on, ``None`` for a force; or what is wrong with it."""
    if found := [*_misplaced(compiled, name)]:
        return None, found
    try:
        return CLOSINGS[compiled.mechanism.cams[name].closed](compiled, name, disc), []
    except (NoContact, NoFollower) as error:
        return None, [_unmade(compiled, name, disc, error)]


def _misplaced(compiled: Compiled, name: str) -> Iterator[Finding]:
    """A second face askew, a second contact on the follower's pivot."""
    drive = followings(compiled.quantities)[name]
    other = other_side(drive)
    if other is None:
        return
    geometry = Geometry(compiled.quantities, compiled.quantities.parameters)
    path = ("cams", name, "second")
    if other.joint is not None and other.cam.face is not None:
        with np.errstate(divide="ignore"):
            askew = float(slant(geometry, other))
        if not abs(askew) < SQUARE:
            unit, size = compiled.quantities.unit_of(u.ANGLE)
            yield Finding("cam.askew", (*path, "face"), {"angle": f"{askew / size:.6g}", "unit": unit})
    elif other.pivot is not None and other.cam.face is None and not seat(geometry, other).reach > 0:
        yield Finding("cam.no-arm", (*path, "at"), {"point": other.cam.touches})


def _unmade(compiled: Compiled, name: str, disc: Disc, error: NoContact | NoFollower) -> Finding:
    """A second disc that the follower doesn't reach."""
    cam, quantities = compiled.mechanism.cams[name], compiled.quantities
    unit, size = quantities.unit_of(u.LENGTH)
    stated = cam.second
    key = next((key for key in ("at", "face", "base") if stated is not None and getattr(stated, key) is not None), None)
    path = ("cams", name, *(() if stated is None else ("second",)), *(() if key is None else (key,)))
    if isinstance(error, NoContact):
        turning = disc.follower.turns and error.key == "cam.same-side"
        one, size = quantities.unit_of(u.ANGLE if turning else u.LENGTH)
        return Finding(error.key, path, {k: f"{v / size:.6g} {one}" for k, v in error.data.items()})
    d = error.data
    if error.key == "cam.reach":
        d = d | {"by": max(d["low"] - d["pitch"], d["pitch"] - d["high"])}
    data = {k: f"{v / size:.6g}" for k, v in d.items()}
    return Finding(error.key, path, {**data, "unit": unit, "follower": cam.follower})
