"""Cams in the drawing: the profile on the link that carries it, the roller on its follower."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import casadi as ca
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
from linkwright.graph.program import ExpressionStage, Program
from linkwright.kernels import Compiled
from linkwright.notation import Jet
from linkwright.report.data import LiveOutline as LiveOutlineData

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


class LiveOutline(NamedTuple):
    """Closed lines on a link as a page computes them: the program's inputs at each place (places, inputs); its outputs
    are the places of all lines (m), two a line."""

    link: str
    program: Program
    inputs: Array

    def data(self) -> LiveOutlineData:
        """What the page gets of it, besides its program."""
        inputs = [[float(f"{value:.15g}") for value in at] for at in self.inputs.tolist()]
        return {"link": self.link, "lines": len(self.program.outputs) // 2, "inputs": inputs}


def live_outlines(compiled: Compiled) -> list[LiveOutline]:
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
    names = compiled.graph.parameters
    symbols = [ca.SX.sym(each) for each in names]
    geometry, p = Geometry(compiled.quantities, dict(zip(names, symbols, strict=True))), ca.vertcat(*symbols)
    turn = np.linspace(0.0, 2 * np.pi, POINTS, endpoint=False)

    def program(x: ca.SX, places: list[tuple[ca.SX, ca.SX]]) -> Program:
        rows = [coordinate for place in places for coordinate in place]
        inputs, outputs = (tuple(map(str, range(count))) for count in (x.numel(), len(rows)))
        return Program((), ExpressionStage.from_rows(x, p, rows), inputs, names, outputs)

    x = ca.SX.sym("x", 4)
    flanks = (-1, 1) if drive.cam.closed == "groove" else (-1,)
    places = outline(geometry, drive, Jet([x[0], 1.0, 0.0]), Jet([x[1], x[2], x[3]]), flanks)
    lift = lifts(Jet([turn, np.ones(POINTS), np.zeros(POINTS)]))
    yield LiveOutline(
        drive.cam.cam, program(x, places), np.column_stack([turn, *(lift.d[k] + 0 * turn for k in range(3))])
    )
    if drive.cam.roller is None:
        return
    touches = [touch(geometry, drive)]
    if drive.has_second_contact:
        touches.append(second_touch(geometry, drive, largest(drive, compiled.motions[drive.cam.law])))
    radius, angle = seat(geometry, drive).roller, ca.SX.sym("angle")
    circles = [(one.at.x + radius * ca.cos(angle), one.at.y + radius * ca.sin(angle)) for one in touches]
    yield LiveOutline(drive.link, program(angle, circles), turn[::3, None])
