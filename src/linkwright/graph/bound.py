"""How far from the frame's origin a point of a mechanism can get at most, by the lengths of its links."""

from __future__ import annotations

import heapq
import math
from collections import defaultdict
from collections.abc import Mapping

from linkwright.graph.geometry import Geometry
from linkwright.graph.graph import Graph
from linkwright.structure import FRAME

Place = tuple[str, str]


def farthest(graph: Graph, point: str, parameters: Mapping[str, float], travels: Mapping[str, float]) -> float:
    """The farthest (m) that a point gets from the frame's origin: along the shortest way over links and joints.

    ``travels`` are the greatest distances (m) of the points of slides on both links; slides that it doesn't name lead
    nowhere. Infinite where no way leads to the frame.
    """
    geometry, topology = Geometry(graph.quantities, parameters), graph.structure.topology
    at: dict[str, dict[str, tuple[float, float]]] = defaultdict(dict)
    for link, entry in topology.mechanism.links.items():
        for name in entry.points:
            x, y = geometry.point(link, name)
            at[link][name] = float(x), float(y)
    joined: dict[Place, list[tuple[Place, float]]] = defaultdict(list)
    for pin in topology.pins.values():
        for one in pin.members:
            joined[one] += [(other, 0.0) for other in pin.members if other != one]
    for name, joint in topology.mechanism.prismatic_joints():
        if name in travels and joint.line is not None:
            ends = [(link, line.point) for link, line in zip(joint.links, joint.line, strict=True)]
            joined[ends[0]].append((ends[1], travels[name]))
            joined[ends[1]].append((ends[0], travels[name]))
    start = next((link, point) for link in topology.mechanism.links if point in topology.mechanism.links[link].points)
    ways, seen = [(0.0, start)], set()
    while ways:
        far, (link, name) = heapq.heappop(ways)
        if link == FRAME:
            return far + math.hypot(*at[link][name])
        if (link, name) in seen:
            continue
        seen.add((link, name))
        for other, place in at[link].items():
            heapq.heappush(ways, (far + math.dist(at[link][name], place), (link, other)))
        for there, more in joined[link, name]:
            heapq.heappush(ways, (far + more, there))
    return math.inf
