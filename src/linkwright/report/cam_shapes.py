"""Cams in the drawing: the profile on the link that carries it, the roller on its follower."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from linkwright.cam.contact import NoContact
from linkwright.cam.followers import NoFollower
from linkwright.cam.pairs import disc, frame, opposite_place, second
from linkwright.graph.cams import followings
from linkwright.graph.geometry import Geometry
from linkwright.kernels import Compiled

Array = NDArray[np.float64]

POINTS = 180
"""Points of a profile: enough for a screen."""

Shapes = dict[str, list[list[list[float]]]]
"""Closed lines by link: points in the link's axes."""


def cam_shapes(compiled: Compiled, size: float) -> Shapes:
    """What is drawn of cams on each link, in a unit of ``size`` m."""
    found: Shapes = {}
    turn = np.linspace(0.0, 2 * np.pi, POINTS, endpoint=False)

    def draw(link: str, line: Array) -> None:
        found.setdefault(link, []).append((line.T / size).tolist())

    geometry = Geometry(compiled.quantities, compiled.quantities.parameters)
    for name, drive in followings(compiled.quantities).items():
        try:
            made, axes = disc(compiled, name), frame(compiled, name)
            first = geometry.point(drive.link, drive.cam.touches)
            plates = [(made, axes, np.array([float(first.x), float(first.y)]))]
            if drive.cam.closed == "conjugate":
                pair = second(compiled, name)
                plates.append((pair.disc, axes.mirrored, opposite_place(compiled, name, pair)))
        except (NoFollower, NoContact):
            continue
        for plate, where, at in plates:
            radius = plate.follower.radius
            draw(drive.cam.cam, where.placed(plate.look(turn).offset(-radius)))
            if radius:
                draw(drive.link, at[:, None] + radius * np.array([np.cos(turn[::3]), np.sin(turn[::3])]))
    return found
