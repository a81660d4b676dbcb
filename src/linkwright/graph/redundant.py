"""Parts that hold what is held already, and move along all the same: a third crank on a parallelogram, a second guide.

Gruebler's count refuses such a mechanism. Without the part it can be solved; its curve of poses is followed, and the
part's joints are tried at poses all along it. Where they hold, the part is redundant and the mechanism movable: the
rank of the constraint Jacobian says so too (P. E. Nikravesh 1988, ch. 3).
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from itertools import islice
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions.units import LENGTH
from linkwright.findings import Finding
from linkwright.graph.assembly import assemble
from linkwright.graph.circuits import Tracer
from linkwright.graph.constraints import Constraints
from linkwright.graph.geometry import Geometry, extent
from linkwright.model.mechanism import Mechanism
from linkwright.model.quantities import Quantities
from linkwright.structure import FRAME, Structure, decompose

Array = NDArray[np.float64]
Pose = dict[str, Array]

HOLDS = 1e-9
"""Joints that miss by less than this share of the size all along hold."""
NEARLY = 0.02
"""A part that misses by less than this share of the size was meant to be redundant, it seems."""
POSES, PARTS, TRIES = 48, 4, 12
"""The poses tried on each curve; the most redundant parts looked for; the parts tried for each."""
EXCESS = ("structure.overconstrained", "structure.redundant")


@dataclass(frozen=True)
class Removable:
    """Something that may be left out: a link, or a slide between two links."""

    kind: str  # "links" or "joints", its section in the file
    name: str


def redundant(quantities: Quantities, structure: Structure, values: Mapping[str, float]) -> list[Finding]:
    """The structure's findings, those on too many constraints replaced where the mechanism moves all the same.

    ``values`` are the drives' at the start (rad or m).
    """
    findings = list(structure.findings)
    if not findings or any(finding.code not in EXCESS for finding in findings):
        return findings
    left_out = _spare(quantities.mechanism, findings, PARTS)
    if left_out is None:
        return findings
    parts, rest = left_out
    reduced = decompose(rest)
    try:
        with np.errstate(all="ignore"):
            poses = _poses(quantities, reduced, values)
            whole = _Whole(quantities, structure, parts, poses) if poses else None
    except np.linalg.LinAlgError:
        return findings
    if whole is None:
        return findings
    misses = {part: whole.miss(part) for part in parts}
    if max(misses.values()) < HOLDS:
        return [_movable(part, structure, whole) for part in parts]
    nearly = {part: miss for part, miss in misses.items() if HOLDS <= miss < NEARLY}
    return findings + [_nearly(part, miss * whole.system.size, quantities) for part, miss in nearly.items()]


def _spare(mechanism: Mechanism, findings: list[Finding], most: int) -> tuple[list[Removable], Mechanism] | None:
    """The fewest parts, one for each finding at a time, without which the structure is sound."""
    if most == 0:
        return None
    before = _excess(findings)
    for part in islice(_candidates(mechanism, findings[0]), TRIES):
        rest = without(mechanism, part)
        left = list(decompose(rest).findings)
        if not left:
            return [part], rest
        if all(finding.code in EXCESS for finding in left) and _excess(left) < before:
            deeper = _spare(rest, left, most - 1)
            if deeper is not None:
                return [part, *deeper[0]], deeper[1]
    return None


def _excess(findings: list[Finding]) -> int:
    return sum(int(finding.data.get("excess", 1)) for finding in findings)


def _candidates(mechanism: Mechanism, finding: Finding) -> Iterator[Removable]:
    """What may be left out to mend a finding: the slides in it, then its links, the last in the file first."""
    links = [*finding.data["links"].parts]
    driven = {link for drive in mechanism.movers.values() for link in (drive.link, drive.on)}
    names = [name for name, joint in mechanism.prismatic_joints() if {*joint.links} & {*links}]
    if finding.code == "structure.redundant":
        names, links = [name for name in names if name == finding.data["joint"]], []
    yield from (Removable("joints", name) for name in reversed(names))
    yield from (Removable("links", link) for link in reversed(links) if link not in driven and link != FRAME)


def without(mechanism: Mechanism, part: Removable) -> Mechanism:
    """The mechanism without a link and its joints, or without a slide."""
    links = {name: link for name, link in mechanism.links.items() if (part.kind, part.name) != ("links", name)}
    joints = {
        name: joint
        for name, joint in mechanism.joints.items()
        if (part.kind, part.name) != ("joints", name) and all(link in links for link in joint.links)
    }
    return mechanism.model_copy(update={"links": links, "joints": joints})


def _poses(quantities: Quantities, reduced: Structure, values: Mapping[str, float]) -> list[Pose]:
    """Poses of the links (x, y in m, angle in rad) all along the curves of each drive; none where it can't start."""
    assembly = assemble(quantities, reduced, values)
    if assembly.start is None or any(finding.code != "assembly.unused" for finding in assembly.findings):
        return []
    geometry = Geometry(quantities, quantities.parameters)
    size = extent(reduced.topology, geometry)
    found: list[Pose] = []
    for drive in values:
        system = Constraints(reduced.topology, geometry, size)
        system.set_drive_values({name: value for name, value in values.items() if name != drive})
        tracer = Tracer(system, drive)
        curve = None if tracer.too_large else tracer.follow(system.pose(assembly.start.bodies))
        if curve is None:
            return []
        step = max(1, len(curve.poses) // POSES)
        for z in curve.poses[::step]:
            rows = z.reshape(-1, 3) * [size, size, 1.0]
            found.append({FRAME: np.zeros(3)} | dict(zip(system.links, rows, strict=True)))
    return found


class _Whole:
    """The whole mechanism at the poses that it has without its spare parts, these put where their joints hold best."""

    def __init__(self, quantities: Quantities, structure: Structure, parts: list[Removable], poses: list[Pose]) -> None:
        geometry = Geometry(quantities, quantities.parameters)
        self.system = Constraints(structure.topology, geometry, extent(structure.topology, geometry), whole=True)
        pattern = self.system.jacobian(np.random.default_rng(0).uniform(1.0, 2.0, self.system.width)) != 0
        self.columns = {part.name: self.system.columns_of([part.name]) for part in parts if part.kind == "links"}
        touched = {name: pattern[:, of].any(axis=1) for name, of in self.columns.items()}
        named = np.array(self.system.rows)
        self.rows = {part: touched.get(part.name, named == part.name) for part in parts}
        shared = np.sum(list(touched.values()), axis=0) if touched else np.zeros(len(named))
        self.fit = {name: rows & (shared == 1) for name, rows in touched.items()}
        unit = [self.system.size, self.system.size, 1.0]
        self.poses: list[Array] = []
        for pose in poses:
            z = np.concatenate([pose.get(link, np.zeros(3)) / unit for link in self.system.links])
            self.poses.append(self.place_spare_links(z, self.poses[-1] if self.poses else None))

    def place_spare_links(self, z: Array, last: Array | None) -> Array:
        """The pose with the spare links where their joints hold best."""
        for name, columns in self.columns.items():
            middle = z.reshape(-1, 3)[:, :2].mean(axis=0)
            around = [np.array([*middle, k * math.pi / 6]) for k in range(12)]
            tries = [self.fitted(z, name, s) for s in (around if last is None else [last[columns]])]
            z = min(tries, key=lambda at: float(np.abs(self.system.residual(at)[self.fit[name]]).max(initial=0.0)))
        return z

    def fitted(self, z: Array, name: str, start: Array) -> Array:
        """One spare link by Gauss-Newton on its joints."""
        at, columns, rows = z.copy(), self.columns[name], self.fit[name]
        at[columns] = start
        for _ in range(30):
            rest, slopes = self.system.residual(at)[rows], self.system.jacobian(at)[rows][:, columns]
            step = np.linalg.lstsq(slopes, rest, rcond=1e-10)[0]
            at[columns] -= step
            if np.abs(step).max() < 1e-13:
                break
        return at

    def miss(self, part: Removable) -> float:
        """How far a part's joints are from holding, together, over the size, at the worst pose."""
        if any(self.system.opposed(z) for z in self.poses):
            return math.inf
        gaps = np.array([self.system.residual(z)[self.rows[part]].reshape(-1, 2) for z in self.poses])
        return float(np.hypot(gaps[:, :, 0], gaps[:, :, 1]).sum(axis=1).max())

    def rank(self) -> int:
        """The rank of all constraints, at that of some poses where it is largest."""
        some = self.poses[:: max(1, len(self.poses) // 7)]
        return max(int(np.linalg.matrix_rank(self.system.jacobian(z), tol=1e-7)) for z in some)


def _movable(part: Removable, structure: Structure, whole: _Whole) -> Finding:
    rank, followers = whole.rank(), len(structure.topology.mechanism.followers)
    data: dict[str, Any] = {"part": part.name, "rank": rank, "mobility": whole.system.width - rank - followers}
    data |= {"constraints": len(whole.system.rows), "gruebler": structure.topology.gruebler}
    return Finding("structure.redundant-movable", (part.kind, part.name), data)


def _nearly(part: Removable, miss: float, quantities: Quantities) -> Finding:
    unit, size = quantities.unit_of(LENGTH)
    data = {"part": part.name, "miss": f"{miss / size:.3g}", "unit": unit}
    return Finding("structure.nearly-redundant", (part.kind, part.name), data)
