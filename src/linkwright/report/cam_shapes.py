"""Cams in the drawing: the profile on the link that carries it, the roller on its follower."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from linkwright.cam.cams_of_mechanism import disc, frame, second
from linkwright.cam.contact import NoContact
from linkwright.cam.followers import NoFollower
from linkwright.elements.cam_contact import cam_followers
from linkwright.elements.cam_contact.contact import touch
from linkwright.elements.cam_contact.second import largest
from linkwright.elements.cam_contact.second import second as second_touch
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
    for name, drive in cam_followers(compiled.mechanism).items():
        try:
            made, axes = disc(compiled, name), frame(compiled, name)
            plates = [(made, axes)]
            if drive.cam.closed == "conjugate":
                plates.append((second(compiled, name).disc, axes.mirrored))
        except (NoFollower, NoContact):
            continue
        for plate, where in plates:
            for flank in (-1, 1) if drive.cam.closed == "groove" else (-1,):
                draw(drive.cam.cam, where.placed(plate.look(turn).offset(flank * plate.follower.radius)))
        touches = [touch(geometry, drive)]
        if drive.has_second_contact:
            touches.append(second_touch(geometry, drive, largest(drive, compiled.motions[drive.cam.law])))
        for contact, plate in zip(touches, [plate for plate, _ in (*plates, plates[0])], strict=False):
            if radius := plate.follower.radius:
                around = np.array([np.cos(turn[::3]), np.sin(turn[::3])])
                draw(drive.link, np.array([[float(contact.at.x)], [float(contact.at.y)]]) + radius * around)
    return found
