"""A cam as a solid: the plate with its hub, bore and keyway, as a STEP file (build123d, Open CASCADE)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from linkwright._machine import needed
from linkwright.cam.nc.path import Element
from linkwright.data_classes import dataclass
from linkwright.model.temporary import temporary_folder


@dataclass(frozen=True)
class Blank:
    """All in mm. The plate reaches from z = 0 to ``thickness``; the hub, of radius ``hub``, on beyond it to ``height``
    above the plate. The keyway is ``key_width`` wide and reaches ``key_depth`` beyond the bore, in the direction
    ``key_angle`` (rad) of the cam's frame. A ``groove`` is so deep, on the side of the hub, in a plate of the radius
    ``radius``. 0 is for what there isn't."""

    thickness: float
    bore: float = 0.0
    hub: float = 0.0
    height: float = 0.0
    key_width: float = 0.0
    key_depth: float = 0.0
    key_angle: float = 0.0
    radius: float = 0.0
    groove: float = 0.0

    @property
    def hollow(self) -> float:
        """The area (mm2) of bore and keyway."""
        if not self.bore:
            return 0.0
        if not self.key_width:
            return math.pi * self.bore**2
        half, reach = self.key_width / 2, self.bore + self.key_depth
        corner = math.sqrt(self.bore**2 - half**2)
        sector = self.bore**2 * math.asin(half / self.bore)
        return math.pi * self.bore**2 + self.key_width * reach - (half * corner + sector)

    @property
    def keyed_bore(self) -> list[Element]:
        """Bore and keyway as one closed contour (mm), counter-clockwise about the centre; empty without a keyway."""
        if not self.bore or not self.key_width:
            return []
        half, reach = self.key_width / 2, self.bore + self.key_depth
        corner = math.sqrt(self.bore**2 - half**2)
        cos, sin = math.cos(self.key_angle), math.sin(self.key_angle)

        def place(x: float, y: float) -> tuple[float, float]:
            return x * cos - y * sin, x * sin + y * cos

        inner, back = [place(corner, y) for y in (-half, half)], place(-self.bore, 0.0)
        outer = [place(reach, y) for y in (-half, half)]
        key = [Element(inner[0], outer[0]), Element(outer[0], outer[1]), Element(outer[1], inner[1])]
        return [*key, Element(inner[1], back, (0.0, 0.0), 1), Element(back, inner[0], (0.0, 0.0), 1)]

    def volume(self, area: float, outer: float | None = None) -> float:
        """The volume (mm3) of a cam whose profile has an area (mm2) and holds the hub; of a groove cam with that within
        the ``outer`` flank."""
        hub = (math.pi * self.hub**2 - self.hollow) * self.height * bool(self.hub)
        if outer is None:
            return (area - self.hollow) * self.thickness + hub
        return (math.pi * self.radius**2 - self.hollow) * self.thickness - (outer - area) * self.groove + hub


def solid(elements: Sequence[Element], blank: Blank, outer: Sequence[Element] = ()) -> Any:
    """The solid (a build123d ``Part``) within a closed contour, or with a groove from there to an ``outer`` one. Raises
    ModelError where build123d isn't installed."""
    b = needed("build123d", "cad")

    def plate(elements: Sequence[Element], thick: float) -> Any:
        return b.extrude(b.make_face(b.Wire([_edge(b, element) for element in elements])), thick, dir=(0, 0, 1))

    high = blank.thickness
    if outer:
        slot = plate(outer, blank.groove) - plate(elements, blank.groove)
        made = b.extrude(b.Circle(blank.radius), amount=high) - b.Pos(0, 0, high - blank.groove) * slot
    else:
        made = plate(elements, high)
    if blank.hub and blank.height:
        made += b.Pos(0, 0, high) * b.extrude(b.Circle(blank.hub), amount=blank.height)
        high += blank.height
    if blank.keyed_bore:
        made -= plate(blank.keyed_bore, high)
    elif blank.bore:
        made -= b.extrude(b.Circle(blank.bore), amount=high)
    return made


def _edge(b: Any, element: Element) -> Any:
    start, end = ((float(x), float(y), 0.0) for x, y in (element.start, element.end))
    if element.centre is None:
        return b.Edge.make_line(start, end)
    (sx, sy), (cx, cy) = element.start, element.centre
    middle, radius = math.atan2(sy - cy, sx - cx) + element.turn * element.swept / 2, math.hypot(sx - cx, sy - cy)
    through = (cx + radius * math.cos(middle), cy + radius * math.sin(middle), 0.0)
    return b.Edge.make_three_point_arc(start, through, end)


def step(made: Any) -> bytes:
    """A solid as a STEP file (mm)."""
    b = needed("build123d", "cad")
    with temporary_folder() as folder:
        file = folder / "cam.step"
        b.export_step(made, str(file))
        return file.read_bytes()
