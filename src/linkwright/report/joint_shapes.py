"""Joints in the drawing that have a shape of their own on links: slots, as wide as the pins in them, and outlines."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from linkwright.graph.geometry import Geometry
from linkwright.report.cam_shapes import Shapes
from linkwright.results import Result
from linkwright.structure import FRAME
from linkwright.structure.topology import Topology

WIDTH = 0.03
"""Width of a slot over the size of what is drawn."""
ROUND = 6
"""Pieces of a quarter of its rounded ends."""


def is_cylinder(topology: Topology, slide: str) -> bool:
    """Whether a slide lies between a barrel and a rod: two moving links, each held by one pin and nothing else."""
    _, links = topology.joints[slide]
    if len(links) != 2 or FRAME in links:
        return False
    holding = [[name for name, (_, joined) in topology.joints.items() if link in joined] for link in links]
    return all(len(names) == 2 and any(name in topology.pins for name in names) for names in holding)


def joint_shapes(result: Result, size: float, extent: float) -> Shapes:
    """What is drawn of joints on each link, in a unit of ``size`` m; ``extent`` (m) is the size of the drawing."""
    import shapely

    compiled, found = result.run.compiled, Shapes()
    geometry = Geometry(compiled.quantities, compiled.quantities.parameters)
    for name, entry in compiled.mechanism.joints_but_pins():
        low = high = np.nan
        if "s" in entry.signals:
            travel: NDArray[np.float64] = result[f"{name}.s"]
            low, high = float(np.nanmin(travel)), float(np.nanmax(travel))
        kind = compiled.structure.topology.kind_of(name)
        for link, line in kind.outline(geometry, name, low, high):
            drawn = line.T
            if not np.array_equal(drawn[0], drawn[-1]):
                ring = shapely.LineString(drawn).buffer(WIDTH / 2 * extent, quad_segs=ROUND).exterior
                drawn = np.array(ring.coords)
            found.setdefault(link, []).append((drawn[:-1] / size).tolist())
    return found
