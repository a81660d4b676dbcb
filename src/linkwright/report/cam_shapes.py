"""Cams in the drawing: the profile on the link that carries it, the roller on its follower."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from linkwright.cam.cams_of_mechanism import disc, frame, outline, second
from linkwright.cam.contact import NoContact
from linkwright.cam.followers import NoFollower
from linkwright.elements.cam_contact import cam_followers
from linkwright.elements.cam_contact.contact import seat, touch
from linkwright.elements.cam_contact.second import largest
from linkwright.elements.cam_contact.second import second as second_touch
from linkwright.graph.geometry import Geometry
from linkwright.kernels import Compiled
from linkwright.notation import Jet
from linkwright.notation.jets import call
from linkwright.report.outlines import LiveOutline, Shapes, outline_program
from linkwright.symbols import Symbol

Array = NDArray[np.float64]

POINTS = 180
"""Points of a profile: enough for a screen."""


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


def live_cam_shapes(compiled: Compiled) -> list[LiveOutline]:
    """The cams and rollers of :func:`cam_shapes` at any parameters. Lifts don't depend on parameters that a page moves.

    Without pairs of discs: the second one has to be solved for.
    """
    return [one for name in cam_followers(compiled.mechanism) for one in _outlines(compiled, name)]


def _outlines(compiled: Compiled, name: str) -> Iterator[LiveOutline]:
    drive = cam_followers(compiled.mechanism)[name]
    if drive.cam.closed == "conjugate":
        return
    try:
        lifts = disc(compiled, name).lift
    except (NoFollower, NoContact):
        return
    turn = np.linspace(0.0, 2 * np.pi, POINTS, endpoint=False)
    flanks = (-1, 1) if drive.cam.closed == "groove" else (-1,)

    def profile(geometry: Geometry, x: list[Symbol]) -> list[tuple[Symbol, Symbol]]:
        return outline(geometry, drive, Jet([x[0], 1.0, 0.0]), Jet([x[1], x[2], x[3]]), flanks)

    lift = lifts(Jet([turn, np.ones(POINTS), np.zeros(POINTS)]))
    inputs = np.column_stack([turn, *(lift.d[k] + 0 * turn for k in range(3))])
    yield LiveOutline(drive.cam.cam, outline_program(compiled, 4, profile), inputs)
    if drive.cam.roller is None:
        return

    def rollers(geometry: Geometry, x: list[Symbol]) -> list[tuple[Symbol, Symbol]]:
        touches = [touch(geometry, drive)]
        if drive.has_second_contact:
            touches.append(second_touch(geometry, drive, largest(drive, compiled.motions[drive.cam.law])))
        radius = seat(geometry, drive).roller
        return [(one.at.x + radius * call("cos", x[0]), one.at.y + radius * call("sin", x[0])) for one in touches]

    yield LiveOutline(drive.link, outline_program(compiled, 1, rollers), turn[::3, None])
