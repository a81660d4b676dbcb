"""What keeps the follower of a cam on it, as the file states it."""

from __future__ import annotations

from collections.abc import Callable

from linkwright.cam.cams_of_mechanism import disc as disc_of
from linkwright.cam.cams_of_mechanism import second
from linkwright.cam.disc import Disc
from linkwright.cam.form_closure import Closing, groove, yoke
from linkwright.kernels import Compiled

CLOSINGS: dict[str, Callable[[Compiled, str, Disc], Closing | None]] = {
    "force": lambda compiled, name, disc: None,
    "groove": lambda compiled, name, disc: groove(disc),
    "conjugate": lambda compiled, name, disc: second(compiled, name),
    "yoke": lambda compiled, name, disc: yoke(disc),
}
"""By the word of the file; ``None`` for a force."""


def cam_and_closing(compiled: Compiled, name: str) -> tuple[Disc, Closing | None]:
    """A cam and what keeps its follower on, made once: the check of a study and its run look for the same extremes."""

    def make_disc() -> tuple[Disc, Closing | None]:
        disc = disc_of(compiled, name)
        return disc, CLOSINGS[compiled.mechanism.cams[name].closed](compiled, name, disc)

    return compiled.cached((cam_and_closing, name), make_disc)
