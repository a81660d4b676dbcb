"""What a drawing needs to know once: poses of links, pins, guides, and the extents of all the motion."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.report.data import LinkData, Scene, Values
from linkwright.report.mechanism_drawing.joints import Guide, Pin, guides_of, in_cylinder, pins_of
from linkwright.report.mechanism_drawing.poses import Poses

Array = NDArray[np.float64]

PALETTE = 8
"""How many colours links and curves have; they repeat after that."""


@dataclass(frozen=True)
class Survey:
    """A scene with what is drawn of it. ``box``: least x, least y, largest x, largest y, of all that moves; ``sound``:
    the poses in which every link has its place."""

    scene: Scene
    poses: dict[str, Poses]
    pins: list[Pin]
    guides: list[Guide]
    box: tuple[float, float, float, float]
    sound: NDArray[np.intp]

    @property
    def moving(self) -> list[LinkData]:
        """The links but the fixed one."""
        return [link for link in self.scene["links"] if not link["fixed"]]

    def colour(self, link: str) -> str:
        """The class of a moving link's colour."""
        return f"lw-c{[one['name'] for one in self.moving].index(link) % PALETTE}"

    def trace_colour(self, i: int) -> str:
        """The class of a path's colour: those after the links' own."""
        return f"lw-c{(len(self.moving) + i) % PALETTE}"


def survey(scene: Scene) -> Survey:
    """Everything of a scene."""
    count = max(len(scene["time"]), 1)
    poses = {link["name"]: Poses.of(link, count) for link in scene["links"]}
    guides = guides_of(scene, poses)
    places = np.concatenate([np.empty((0, 2)), *_reached(scene, poses, guides)])
    places = places[np.isfinite(places).all(axis=1)]
    if not places.size:
        places = np.array([[-1.0, -1.0], [1.0, 1.0]])
    (x0, y0), (x1, y1) = places.min(axis=0).tolist(), places.max(axis=0).tolist()
    known = np.array([one.known for one in poses.values()]).all(axis=0) if poses else np.ones(count, bool)
    pins = [pin for pin in pins_of(scene) if pin.joined or not in_cylinder(guides, pin.places[0][0])]
    return Survey(scene, poses, pins, guides, (x0, y0, x1, y1), np.flatnonzero(known))


def _reached(scene: Scene, poses: dict[str, Poses], guides: Sequence[Guide]) -> Iterator[Array]:
    """All places in the world that links, guides, paths and areas reach."""
    for link in scene["links"]:
        for line in (list(link["points"].values()), *link.get("outlines", ())):
            if len(line):
                yield poses[link["name"]].places(line).reshape(-1, 2)
    for guide in guides:
        ends = [guide.guide.along(travel) for travel in (guide.low, guide.high)]
        yield poses[guide.guide.link].places(ends).reshape(-1, 2)
    for trace in scene["traces"]:
        yield rows(trace["x"], trace["y"])
    for area in scene.get("areas", ()):
        for ring in area["rings"]:
            yield np.array(ring, float).reshape(-1, 2)


def rows(x: Values, y: Values) -> Array:
    """Two rows as places, NaN where there is none."""
    return np.array([x, y], float).T
