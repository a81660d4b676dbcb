"""What lies in the plane of a workspace, as layers of a chart: regions by mode, curves by kind, what lies over them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.drawing.charts import round_below
from linkwright.drawing.plane import Bounds
from linkwright.expressions import units as u
from linkwright.findings import CLAUSES, Joined, Said, Text
from linkwright.presentation.charts import Axis, Colour, Layer, Lines, Plane, Region
from linkwright.studies.workspace.curve_lines import places
from linkwright.studies.workspace.outcome import Reached, Workspace, WorkspaceOutcome
from linkwright.studies.workspace.overlay import Overlay
from linkwright.studies.workspace.shapes import pieces

Array = NDArray[np.float64]

STEPS = 4000
"""Lines are rounded to about such a share of the largest extent, finer than a screen shows them as a whole."""
REGIONS = 4
"""Regions have so many colours."""
KINDS: dict[str, tuple[Colour, int, float]] = {
    "singular": ("ink", 0, 1.0),
    "modes": ("ink", 1, 1.6),
    "pins": ("ink", 2, 2.0),
    "limit": ("muted", 0, 2.0),
}
"""Colour, dash and width of the curves by their kind."""
OVER: dict[str, tuple[Colour, int, float]] = {
    "wanted": (3, 0, 2.0),
    "blocked": ("warn", 0, 3.5),
    "misses": ("warn", 0, 2.0),
    "fits": (2, 0, 2.0),
}
"""The same of what lies over them."""


class PlaneLayers:
    """Layers in the file's unit, all lines of a study in the same whole steps."""

    def __init__(self, outcome: WorkspaceOutcome) -> None:
        self.outcome = outcome
        self.unit, self.size = outcome.compiled.quantities.unit_of(u.LENGTH)
        shapes = [shape for one in outcome.workspaces for shape in (*(r.shape for r in one.regions), *one.curves)]
        edges = np.array([shape.bounds for shape in shapes if np.isfinite(shape.bounds).all()]).reshape(-1, 4)
        span = (edges[:, 2:].max(axis=0) - edges[:, :2].min(axis=0)).max() if edges.size else 1.0
        self.fine = round_below(float(span) / self.size / STEPS)

    def rings(self, shape: Any) -> list[Array]:
        """All rings of a shape (m), thinned to the step."""
        polygons = pieces(shape.simplify(self.fine * self.size))
        rings = (ring for polygon in polygons for ring in (polygon.exterior, *polygon.interiors))
        return [np.array(ring.coords).T / self.size for ring in rings]

    def region(self, reached: Reached, colour: Colour) -> Region:
        """What a mode reaches."""
        name = Said("workspace.kind.region", mode=reached.mode or Said("workspace.one-mode"))
        return Region(name, self.rings(reached.shape), colour)

    def loci(self, some: Sequence[Reached], kinds: Iterable[str], colour: Colour | None = None) -> Iterator[Lines]:
        """The curves of regions by their kind."""
        graph = self.outcome.compiled.graph
        data: dict[str, Text] = {"point": self.outcome.point, "drives": ", ".join(graph.drives)}
        data["groups"] = Joined((group.label for group in graph.branched), CLAUSES)
        for kind in kinds:
            ours, dash, width = KINDS[kind]
            found = [
                line
                for one in some
                for line in places(one.region.sheet, one.region.segments, kind, self.fine * self.size, self.size)
            ]
            if found:
                name = Said(f"workspace.kind.{kind}", **data)
                yield Lines(name, found, ours if colour is None else colour, dash, width)

    def workspace(self, one: Workspace, over: Sequence[Overlay]) -> list[Layer]:
        """The regions or curves of all modes, with what lies over them."""
        layers: list[Layer] = [self.region(reached, number % REGIONS) for number, reached in enumerate(one.regions)]
        for number, curve in enumerate(one.curves):
            name = Said("workspace.kind.curve", mode=curve.mode or Said("workspace.one-mode"))
            stretches = [self.thin(stretch.at) for stretch in curve.stretches]
            layers.append(Lines(name, stretches, number % REGIONS, width=1.6))
        layers += self.loci(one.regions, KINDS)
        for overlay in over:
            colour, dash, width = OVER[overlay.kind]
            layers.append(Lines(overlay.text, [self.thin(line) for line in overlay.lines], colour, dash, width))
        return layers

    def thin(self, line: Array, steps: float = 1.0) -> Array:
        """A line (m) thinned to so many steps, in the file's unit."""
        import shapely

        if line.shape[1] < 2:
            return line / self.size
        return np.asarray(
            shapely.get_coordinates(shapely.simplify(shapely.linestrings(line.T), steps * self.fine * self.size)).T
            / self.size
        )

    def plane(self, layers: Sequence[Layer], box: Bounds) -> Plane:
        """Layers in a ``box`` (m)."""
        low_x, low_y, high_x, high_y = (edge / self.size for edge in box)
        return Plane(
            Axis("x", self.unit), Axis("y", self.unit), layers, fine=self.fine, box=(low_x, low_y, high_x, high_y)
        )


@lru_cache(maxsize=2)
def layers_of(outcome: WorkspaceOutcome) -> PlaneLayers:
    """The layers of a study, whose step is found once."""
    return PlaneLayers(outcome)
