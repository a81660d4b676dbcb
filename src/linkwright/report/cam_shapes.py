"""Cams in the drawing: the profile on the link that carries it, the roller on its follower."""

from __future__ import annotations

import numpy as np

from linkwright.cam.followers import NoFollower
from linkwright.cam.pairs import disc, frame
from linkwright.graph.cams import followings
from linkwright.graph.geometry import Geometry
from linkwright.kernels import Compiled

POINTS = 180
"""Points of a profile: enough for a screen."""

Shapes = dict[str, list[list[list[float]]]]
"""Closed lines by link: points in the link's axes."""


def cam_shapes(compiled: Compiled, size: float) -> Shapes:
    """What is drawn of cams on each link, in a unit of ``size`` m."""
    found: Shapes = {}
    turn = np.linspace(0.0, 2 * np.pi, POINTS, endpoint=False)
    geometry = Geometry(compiled.quantities, compiled.quantities.parameters)
    for name, drive in followings(compiled.quantities).items():
        try:
            made = disc(compiled, name)
        except NoFollower:
            continue
        radius = made.follower.radius
        profile = frame(compiled, name).placed(made.look(turn).offset(-radius))
        found.setdefault(drive.cam.cam, []).append((profile.T / size).tolist())
        if radius:
            at = geometry.point(drive.link, drive.cam.touches)
            circle = np.array([float(at.x) + radius * np.cos(turn[::3]), float(at.y) + radius * np.sin(turn[::3])])
            found.setdefault(drive.link, []).append((circle.T / size).tolist())
    return found
