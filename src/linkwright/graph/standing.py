"""The pose of a structure: of links that nothing drives, held by as many constraints as they have freedoms, or by more.

Where its groups can be placed one after the other, the file's assembly rules say how. Else all joints are closed at
once: by Gauss-Newton steps from the sketched places of points, or from starts all round where nothing is sketched.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.units import LENGTH
from linkwright.findings import Finding
from linkwright.graph.assembly import assemble
from linkwright.graph.constraints import Constraints
from linkwright.graph.geometry import Geometry, extent
from linkwright.model.quantities import Quantities
from linkwright.notation import Pair
from linkwright.structure import FRAME, Structure

Array = NDArray[np.float64]
Places = dict[str, Array]

CLOSED = 1e-10
"""Joints that miss by less than this share of the size are closed."""
SAME = 1e-6
"""Poses that differ by less than this (rad, or over the size) are the same."""
ALL_AT_ONCE = ("assembly.no-sketch", "assembly.not-found", "assembly.singular-start")
"""Groups that aren't placed alone may be placed with all others."""
STARTS, STEPS = 60, 60
"""Starts all round where nothing is sketched; the most steps from each."""


def standing(quantities: Quantities, structure: Structure) -> tuple[Constraints, Array | None, list[Finding]]:
    """The equations of all joints, the pose at which they hold (``None`` where there is none), and what is wrong."""
    geometry = Geometry(quantities, quantities.parameters)
    size = extent(structure.topology, geometry)
    assembly = None if structure.findings else assemble(quantities, structure, {})
    # Only now, as the assembly fixes constants of some kinds of joints.
    system = Constraints(structure.topology, geometry, size, whole=True)
    if assembly is not None and assembly.start is not None and not assembly.findings:
        return system, close_joints(system, system.pose(assembly.start.bodies))[0], []
    if assembly is not None and any(finding.code not in ALL_AT_ONCE for finding in assembly.findings):
        return system, None, assembly.findings
    for c, _ in system.others:
        if c.kind.phased:  # what it fixes where it is drawn needs groups that are placed one after the other
            data = {"name": c.joint, "kind": c.kind.title}
            return system, None, [Finding("reactions.phased", ("joints", c.joint), data)]
    return system, *_closing(quantities, system)


def close_joints(system: Constraints, z: Array) -> tuple[Array, float]:
    """The pose at which all joints close best near a start, and what they miss there over the size."""
    for _ in range(STEPS):
        step = np.linalg.lstsq(system.jacobian(z), system.residual(z), rcond=1e-9)[0]
        z = z - step * min(1.0, 0.5 / max(np.abs(step).max(initial=0.0), 1e-300))
        if np.abs(step).max(initial=0.0) < 1e-14:
            break
    miss = math.inf if system.opposed(z) else float(np.abs(system.residual(z)).max(initial=0.0))
    return z, miss


def _closing(quantities: Quantities, system: Constraints) -> tuple[Array | None, list[Finding]]:
    """The pose at which all joints close at once."""
    places = sketched_places(quantities, system)
    found: list[Array] = []
    nearest = math.inf
    for sketched, start in starts(system, places):
        z, miss = close_joints(system, start)
        nearest = min(nearest, miss)
        if miss > CLOSED or not keeps_rules(quantities, system, z):
            continue
        if sketched:
            return z, []
        if all(np.abs(system.pose_difference(z, other)).max() > SAME for other in found):
            found.append(z)
    if len(found) == 1:
        return found[0], []
    if found:
        return None, [Finding("reactions.several-poses", ("assembly",), {"count": len(found)})]
    unit, size = quantities.unit_of(LENGTH)
    data = {"miss": f"{nearest * system.size / size:.3g}", "unit": unit}
    return None, [Finding("reactions.not-closed", ("links",), data)]


def sketched_places(quantities: Quantities, system: Constraints) -> Places:
    """The places of points that the file states (m): those of the frame, and sketched ones."""
    m, geometry = quantities.mechanism, system.geometry
    places = {name: np.array(geometry.point(FRAME, name), dtype=float) for name in m.links[FRAME].points}
    rules = {name: rule.sketch for name, rule in m.assembly.items() if rule.sketch is not None}
    return places | {name: np.array(geometry.position(at), dtype=float) for name, at in rules.items()}


def starts(system: Constraints, places: Mapping[str, Array]) -> Iterator[tuple[bool, Array]]:
    """Poses to begin with, and whether the stated places tell all of one."""
    geometry, random = system.geometry, np.random.default_rng(0)
    fits = []
    for link in system.links:
        names = [name for name in geometry.mechanism.links[link].points if name in places]
        local = np.array([geometry.point(link, name) for name in names], dtype=float).reshape(-1, 2)
        goals = np.array([places[name] for name in names]).reshape(-1, 2)
        fits.append((local, goals))
    whole = all(len(np.unique(local, axis=0)) > 1 for local, _ in fits)
    middle = np.mean([*places.values()], axis=0) if places else np.zeros(2)
    for i in range(1 if whole else STARTS):
        rows = []
        for local, goals in fits:
            angle = _turned(local, goals)
            angle = random.uniform(-math.pi, math.pi) * (i > 0) if angle is None else angle
            turn = np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
            around = middle + random.normal(size=2) * system.size * (i > 0)
            at = (goals - local @ turn.T).mean(axis=0) if len(local) else around
            rows.append([*at / system.size, angle])
        yield whole, np.array(rows).ravel()


def _turned(local: Array, goals: Array) -> float | None:
    """The angle (rad) by which some points come nearest to their places."""
    arms, there = (
        local - local.mean(axis=0) if len(local) else local,
        goals - goals.mean(axis=0) if len(goals) else goals,
    )
    sine = float((arms[:, 0] * there[:, 1] - arms[:, 1] * there[:, 0]).sum())
    cosine = float((arms * there).sum())
    return math.atan2(sine, cosine) if math.hypot(sine, cosine) > 0 else None


def keeps_rules(quantities: Quantities, system: Constraints, z: Array) -> bool:
    """Whether a pose keeps the assembly rules that name a side."""
    m, links_of_points = quantities.mechanism, quantities.signals.links_of_points

    def rotated(link: str, local: Pair) -> Array:
        angle = 0.0 if link == FRAME else float(z[system.columns_of([link])[2]])
        return np.array(local.rotated(Pair(math.cos(angle), math.sin(angle))), dtype=float)

    def point_position(point: str) -> Array:
        link = links_of_points[point]
        start = np.zeros(2) if link == FRAME else z[system.columns_of([link])[:2]] * system.size
        return np.asarray(start + rotated(link, system.geometry.point(link, point)))

    for name, rule in m.assembly.items():
        if not rule.reference or not {name, *rule.reference} <= links_of_points.keys():
            continue
        arm = point_position(name) - point_position(rule.reference[0])
        if rule.along:
            first = m.joints[rule.along].links[0]
            side = float(arm @ rotated(first, system.geometry.line(rule.along, first)[1]))
        else:
            line = point_position(rule.reference[1]) - point_position(rule.reference[0])
            side = float(line[0] * arm[1] - line[1] * arm[0])
        if side * (1.0 if rule.word in ("left", "ahead") else -1.0) < 0:
            return False
    return True
