"""The links' masses as MuJoCo takes them: every moving body must have some."""

from __future__ import annotations

from linkwright.data_classes import dataclass
from linkwright.findings import Finding, Joined
from linkwright.graph.geometry import extent
from linkwright.kernels import Compiled

NO_SIZE = 1e-2
"""The radius of gyration of what has no moment of inertia, over the mechanism's size."""
LEAST = 1e-12
"""A moment of inertia below this (kg m^2) counts as none: MuJoCo refuses it near 1e-15."""


@dataclass(frozen=True)
class Mass:
    """Mass (kg), centre (m, in the link's frame) and moment of inertia about it (kg m^2) as they are written."""

    mass: float
    centre: tuple[float, float]
    inertia: float


def written_masses(compiled: Compiled, tiny: float) -> tuple[dict[str, Mass], list[Finding]]:
    """Each moving link's mass, ``tiny`` (kg) where it has none; warnings say what was added."""
    assert compiled.assembly.start is not None
    geometry, topology = compiled.assembly.start.geometry, compiled.structure.topology
    radius = NO_SIZE * extent(topology, geometry)
    masses, light, small = dict[str, Mass](), list[str](), list[str]()
    for link in topology.moving:
        mass, centre, inertia = geometry.mass(link)
        if not mass > 0:
            light.append(link)
            masses[link] = Mass(tiny, (0.0, 0.0), max(tiny * radius**2, LEAST))
            continue
        if inertia < LEAST:
            small.append(link)
            inertia = max(mass * radius**2, LEAST)
        masses[link] = Mass(float(mass), (float(centre.x), float(centre.y)), float(inertia))
    size, found = f"{radius:.3g} m", []
    if light:
        data = {"links": Joined(light), "mass": f"{tiny:.3g} kg", "radius": size}
        found.append(Finding("export.no-mass", ("links",), data, severity="warning"))
    if small:
        data = {"links": Joined(small), "radius": size}
        found.append(Finding("export.no-inertia", ("links",), data, severity="warning"))
    return masses, found
