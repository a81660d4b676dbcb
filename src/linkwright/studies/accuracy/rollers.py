"""Rollers of cams' followers on their own pins: where they rest, and how an output changes with them.

The roller stays on the cam, so that only its displacement along their common normal moves the follower, as a roller of
another radius does.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from linkwright.data_classes import dataclass
from linkwright.elements.cam_contact import cam_followers
from linkwright.elements.cam_contact.contact import seat, sense
from linkwright.elements.clearance import AnyDirection, Axis, Known, Rows
from linkwright.expressions.language import FUNCTIONS
from linkwright.graph.geometry import Geometry
from linkwright.kernels import Compiled


def rollers(compiled: Compiled) -> dict[str, str]:
    """The points of followers at which nothing but a roller turns, with the cam that it rolls on."""
    pins, drives = compiled.quantities.signals.pins.values(), cam_followers(compiled.mechanism)
    pinned = {member for pin in pins for member in pin.members}
    return {
        drive.cam.touches: cam
        for cam, drive in drives.items()
        if drive.cam.roller is not None and (drive.link, drive.cam.touches) not in pinned
    }


@dataclass(frozen=True)
class OnRoller(AnyDirection):
    """The roller of a follower on its own pin, at the point ``joint``; ``links`` are the follower and the cam pair.
    ``forward`` is +1 where the cam's law runs with the sense of the carrier's angles, ``lift`` the follower's pivot, or
    the direction (link, x, y) in which it slides as it rises; ``side`` +1 where a pinned one lies left of the line from
    shaft to pivot."""

    joint: str
    links: tuple[str, str]
    clearance: float
    forward: int
    side: int
    lift: str | tuple[str, float, float]

    @property
    def plays(self) -> tuple[str, str]:
        return f"{self.joint}/roller", f"{self.joint}/-"  # the second one moves nothing

    @property
    def rows(self) -> tuple[Known, ...]:
        ends = [self.joint, self.lift] if isinstance(self.lift, str) else []
        turned = [] if isinstance(self.lift, str) else [*Axis.of(self.lift[0])]
        where = (f"{point}.{axis}" for point in ends for axis in "xy")
        return f"{self.links[1]}.force", f"{self.links[1]}.pressure", *turned, *where

    @property
    def places(self) -> tuple[Known, ...]:
        return self.rows[1:]

    def normal(self, rows: Rows) -> tuple[Any, Any]:
        """From the cam to the follower: the follower's way as the lift grows, turned back by the pressure angle."""
        _, pressure, *where = (rows[name] for name in self.rows)
        if isinstance(self.lift, str):
            x, y, at_x, at_y = where
            x, y = (x - at_x) * self.side, (y - at_y) * self.side
            size = FUNCTIONS["hypot"].apply(x, y)
            x, y = y / size, -(x / size)
        else:
            (cos, sin), (_, a, b) = where, self.lift
            x, y = cos * a - sin * b, sin * a + cos * b
        c, s = FUNCTIONS["cos"].apply(pressure), FUNCTIONS["sin"].apply(pressure) * self.forward
        return c * x - s * y, s * x + c * y

    def forces(self, rows: Rows) -> list[tuple[Any, ...]]:
        force, (x, y) = rows[self.rows[0]], self.normal(rows)
        return [(force * x, force * y)]

    def gradients(self, by: Sequence[Any], rows: Rows) -> list[tuple[Any, ...]]:
        # A roller that goes towards the follower lets this down on the cam, as a smaller one does.
        x, (across, up) = by[0], self.normal(rows)
        return [(-(x * across), -(x * up))]


def on_roller(compiled: Compiled, cam: str, clearance: float) -> OnRoller:
    """The roller of a cam's follower on its pin, with a clearance (m)."""
    quantities = compiled.quantities
    drive, geometry = cam_followers(quantities.mechanism)[cam], Geometry(quantities, quantities.parameters)
    lift: str | tuple[str, float, float]
    if drive.pivot is not None:
        lift = drive.pivot[0]
    else:
        way = seat(geometry, drive).way
        lift = drive.on, float(way.x), float(way.y)
    links = drive.link, cam
    return OnRoller(drive.cam.touches, links, clearance, sense(geometry, drive), drive.side, lift)
