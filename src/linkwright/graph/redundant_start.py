"""The pose from which a redundant mechanism is looked at: that of the mechanism without some of its parts, and these
fitted in, or one from sketched places."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.findings import Finding
from linkwright.graph.assembly import assemble
from linkwright.graph.constraints import Constraints
from linkwright.graph.standing import close_joints, keeps_rules, sketched_places, starts
from linkwright.model.mechanism import Mechanism
from linkwright.model.quantities import Quantities
from linkwright.notation import Pair
from linkwright.structure import FRAME, Structure, decompose_without
from linkwright.structure.refusals import EXCESS

Array = NDArray[np.float64]
ORIGIN = Pair(0.0, 0.0)

HOLDS = 1e-9
"""Joints that miss by less than this share of the size hold."""
PARTS, TRIES = 12, 150
"""The most parts that are left out to find a pose; how many structures are tried for that."""


@dataclass(frozen=True)
class Removable:
    """Something that may be left out for a pose: a link, or a joint that isn't a pin."""

    kind: str  # "links" or "joints", its section in the file
    name: str


# The pose to begin with.


def start_pose(
    quantities: Quantities, structure: Structure, system: Constraints, values: Mapping[str, float]
) -> Array | None:
    """A pose near one in which all joints hold: that of the mechanism without some parts, and these fitted in; or from
    sketched places alone."""
    left_out = _spare_parts(quantities.mechanism, list(structure.findings))
    if left_out is not None:
        parts, rest = left_out
        assembly = assemble(quantities, decompose_without(rest, ()), values)
        if assembly.start is not None and all(f.code == "assembly.unused" for f in assembly.findings):
            spare = [part.name for part in parts if part.kind == "links"]
            bodies = assembly.start.bodies
            known = {link: np.array(_pose(bodies[link])) for link in system.links if link in bodies}
            return _fitted_in(system, known, spare)
    return _from_sketch(quantities, system)


def _pose(body: Any) -> tuple[float, float, float]:
    """Where a body's origin is (m), and its angle (rad)."""
    at, axis = body.point(ORIGIN).now, body.axis.now
    return float(at.x), float(at.y), math.atan2(float(axis.y), float(axis.x))


def _from_sketch(quantities: Quantities, system: Constraints) -> Array | None:
    """The pose nearest to closing from sketched places, of those that keep the rules of sides."""
    best: tuple[float, Array] | None = None
    if any(c.kind.phased for c, _ in system.others):
        return None
    for sketched, start in starts(system, sketched_places(quantities, system)):
        z, miss = close_joints(system, start)
        if (best is None or miss < best[0]) and keeps_rules(quantities, system, z):
            best = miss, z
        if sketched or miss < HOLDS:
            break
    return best[1] if best else None


def _spare_parts(mechanism: Mechanism, findings: list[Finding]) -> tuple[list[Removable], Mechanism] | None:
    """The fewest parts, one for each finding at a time, without which the structure is sound."""
    tries = iter(range(TRIES))

    def search(rest: Mechanism, findings: list[Finding], most: int) -> tuple[list[Removable], Mechanism] | None:
        before = _excess(findings)
        for part in _candidates(rest, findings[0]) if most else ():
            if next(tries, None) is None:
                return None
            fewer = without(rest, part)
            left = list(decompose_without(fewer, ()).findings)
            if not left:
                return [part], fewer
            if all(finding.code in EXCESS for finding in left) and _excess(left) < before:
                deeper = search(fewer, left, most - 1)
                if deeper is not None:
                    return [part, *deeper[0]], deeper[1]
        return None

    return search(mechanism, findings, PARTS)


def _excess(findings: list[Finding]) -> int:
    return sum(int(finding.data.get("excess", 1)) for finding in findings)


def _candidates(mechanism: Mechanism, finding: Finding) -> Iterator[Removable]:
    """What may be left out to mend a finding: the joints in it but pins, then its links, the last in the file first."""
    links = [*finding.data["links"].parts]
    driven = {link for drive in mechanism.movers.values() for link in (drive.link, drive.on)}
    names = [name for name, joint in mechanism.joints_but_pins() if {*joint.links} & {*links}]
    if finding.code == "structure.redundant":
        names, links = [name for name in names if name == finding.data["joint"]], []
    yield from (Removable("joints", name) for name in reversed(names))
    yield from (Removable("links", link) for link in reversed(links) if link not in driven and link != FRAME)


def without(mechanism: Mechanism, part: Removable) -> Mechanism:
    """The mechanism without a link and its joints, or without a joint."""
    links = {name: link for name, link in mechanism.links.items() if (part.kind, part.name) != ("links", name)}
    joints = {
        name: joint
        for name, joint in mechanism.joints.items()
        if (part.kind, part.name) != ("joints", name) and all(link in links for link in joint.links)
    }
    return mechanism.model_copy(update={"links": links, "joints": joints})


def _fitted_in(system: Constraints, known: Mapping[str, Array], spare: list[str]) -> Array:
    """The pose of the known links (m, m, rad), with the spare ones one after the other where their joints hold best."""
    unit = np.array([system.size, system.size, 1.0])
    middle = np.mean([pose[:2] for pose in known.values()], axis=0) / system.size if known else np.zeros(2)
    z = np.concatenate([known.get(link, np.zeros(3)) / unit for link in system.links])
    pattern = system.jacobian(np.random.default_rng(0).uniform(1.0, 2.0, system.width)) != 0
    touched = {name: pattern[:, system.columns_of([name])].any(axis=1) for name in spare}
    for i, name in enumerate(spare):
        # Its joints but those to spare links that aren't placed yet.
        later = np.sum([touched[other] for other in spare[i + 1 :]], axis=0, dtype=bool)
        rows = touched[name] & ~later
        columns = system.columns_of([name])
        tries = [_fitted(system, z, rows, columns, np.array([*middle, k * math.pi / 6])) for k in range(12)]
        z = min(tries, key=lambda pose: float(np.abs(system.residual(pose)[rows]).max(initial=0.0)))
    return z


def _fitted(system: Constraints, z: Array, rows: Any, columns: list[int], start: Array) -> Array:
    """One link by Gauss-Newton on its joints."""
    pose = z.copy()
    pose[columns] = start
    for _ in range(30):
        rest, slopes = system.residual(pose)[rows], system.jacobian(pose)[rows][:, columns]
        step = np.linalg.lstsq(slopes, rest, rcond=1e-10)[0]
        pose[columns] -= step
        if np.abs(step).max() < 1e-13:
            break
    return pose
