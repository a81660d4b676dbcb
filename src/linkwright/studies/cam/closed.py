"""What keeps the follower of a cam on it, as the file states it."""

from __future__ import annotations

from collections.abc import Callable

from linkwright.cam.closing import Closing, groove, yoke
from linkwright.cam.disc import Disc
from linkwright.cam.pairs import second
from linkwright.kernels import Compiled

CLOSINGS: dict[str, Callable[[Compiled, str, Disc], Closing | None]] = {
    "force": lambda compiled, name, disc: None,
    "groove": lambda compiled, name, disc: groove(disc),
    "conjugate": lambda compiled, name, disc: second(compiled, name),
    "yoke": lambda compiled, name, disc: yoke(disc),
}
"""By the word of the file; ``None`` for a force."""


def closing(compiled: Compiled, name: str, disc: Disc) -> Closing | None:
    """What keeps the follower of a cam on."""
    return CLOSINGS[compiled.mechanism.cams[name].closed](compiled, name, disc)
