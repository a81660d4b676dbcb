"""Joints in the drawing that have a shape of their own on links: slots, as wide as the pins in them, and outlines."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.elements.curves import Curve
from linkwright.elements.joint import kind
from linkwright.graph.geometry import Geometry
from linkwright.kernels import Compiled
from linkwright.notation import Pair
from linkwright.report.outlines import LiveOutline, Shapes, outline_program
from linkwright.results import Result
from linkwright.structure import FRAME
from linkwright.structure.topology import Topology

Array = NDArray[np.float64]

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
    compiled, found = result.run.compiled, Shapes()
    geometry = Geometry(compiled.quantities, compiled.quantities.parameters)
    for name, travels in _drawn(compiled):
        low = high = np.nan
        if travels:
            travel: Array = result[f"{name}.s"]
            low, high = float(np.nanmin(travel)), float(np.nanmax(travel))
        for curve in _outline(geometry, name, low, high):
            first, last = curve.ends
            at = first + (last - first) * _shares(curve)
            drawn = np.column_stack([value + 0.0 * at for value in curve.place(at)])
            if not curve.closed:
                drawn = _widened(drawn, WIDTH / 2 * extent)
            found.setdefault(curve.link, []).append((drawn / size).tolist())
    return found


def _widened(line: Array, half: float) -> Array:
    """The outline of all that lies within a distance of a line."""
    from shapely import LineString

    return np.array(LineString(line).buffer(half, quad_segs=ROUND).exterior.coords)[:-1]


def live_joint_shapes(compiled: Compiled) -> Iterator[LiveOutline]:
    """The same at any parameters, of joints with a travel and of lines that don't depend on one."""
    nominal = Geometry(compiled.quantities, compiled.quantities.parameters)
    for name, travels in _drawn(compiled):
        travel = f"{name}.s" if travels else ""
        for k, curve in enumerate(_outline(nominal, name, np.nan, np.nan)):
            program = outline_program(compiled, 3 if travel else 1, partial(_places, name, k))
            width = 0.0 if curve.closed else WIDTH * compiled.assembly.size()
            yield LiveOutline(curve.link, program, _shares(curve)[:, None], travel, width)


def _drawn(compiled: Compiled) -> Iterator[tuple[str, bool]]:
    """The joints and followers by name, and whether a travel tells how long their lines are."""
    yield from ((name, "s" in entry.signals) for name, entry in compiled.mechanism.joints_but_pins())
    yield from ((name, False) for name in compiled.mechanism.followers)


def _outline(geometry: Geometry, name: str, low: Any, high: Any) -> Sequence[Curve]:
    """The lines of one."""
    mechanism = geometry.mechanism
    if (follower := mechanism.followers.get(name)) is not None:
        return follower.outline(geometry)
    return kind(mechanism.joints[name].kind).outline(geometry, name, low, high)


def _places(name: str, number: int, geometry: Geometry, inputs: Sequence[Any]) -> list[Pair]:
    """A place of one of a joint's lines: the inputs are its share of the line, and the ends of the travel if it has
    one."""
    share, *reach = inputs
    curve = _outline(geometry, name, *(reach or (np.nan, np.nan)))[number]
    first, last = curve.ends
    return [curve.place(first + (last - first) * share)]


def _shares(curve: Curve) -> Array:
    """Where between the ends of a line places of it are drawn."""
    return np.linspace(0.0, 1.0, curve.points, endpoint=not curve.closed)
