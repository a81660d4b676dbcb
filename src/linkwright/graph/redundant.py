"""Mechanisms that are redundant and move all the same: a third crank on a parallelogram, a second guide of a platform.

Gruebler's count refuses such a mechanism. Its pose is found without some of its parts, and these are fitted in
(:mod:`.redundant_start`); from there on the states of self-stress tell which equations follow from the others
(:mod:`.spare_equations`). The groups are then those of the others alone. Along the motion that these leave
(:mod:`.redundant_motion`), what is left out is looked at: where it holds, the mechanism moves (the rank of the Jacobian
says so too: P. E. Nikravesh 1988, ch. 3); where it nearly does, its dimensions contradict each other by that much.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions.units import LENGTH
from linkwright.findings import CLAUSES, Finding, Joined, Term
from linkwright.graph.constraints import Constraints
from linkwright.graph.geometry import Geometry, extent
from linkwright.graph.redundant_motion import POSES, Values, closed_pose, followed, traced
from linkwright.graph.redundant_start import HOLDS, start_pose
from linkwright.graph.spare_equations import Candidate, SpareEquations
from linkwright.graph.standing import close_joints
from linkwright.graph.undetermined_reactions import UndeterminedReactions
from linkwright.model.mechanism import Mechanism
from linkwright.model.quantities import Quantities
from linkwright.structure import Structure, decompose_without
from linkwright.structure.refusals import EXCESS

Array = NDArray[np.float64]

AGREES = 1e-10
"""What is left out agrees where it misses by less than this share of the size: closures are proven to 1e-9 of one that
may be smaller."""
NEARLY = 0.02
"""Joints that miss by less than this share of the size were meant to hold, it seems."""
FAR = 0.1
"""The most by which closing the joints may move a pose (rad, or over the size)."""
REACHES = (1.0, 0.1, 0.01)
"""The shares of a full turn that are looked at, each where the longer one leads through a singular pose."""
SOUND = 0.03
"""The least share of the clearest force in the states of self-stress, over a full turn, that is clear of zero."""


@dataclass
class Agreement:
    """The equations left out of a redundant mechanism, and what each of them misses at worst (over the size, or rad)
    along the motion that the others leave; ``poses`` are those looked at, with their times (s)."""

    structure: Structure
    chosen: list[Candidate]
    misses: list[float]
    poses: list[tuple[float, Array]]
    spare: SpareEquations

    @property
    def worst(self) -> float:
        """The largest miss."""
        return max(self.misses, default=math.inf)


def redundant(quantities: Quantities, structure: Structure, values: Values) -> tuple[Structure, list[Finding]]:
    """The structure without the equations that follow from others, with a warning that names them; else the structure
    as it is, with its findings and what its dimensions miss for it to move."""
    findings = list(structure.findings)
    counted = decompose_without(quantities.mechanism, ())
    if not counted.findings or any(finding.code not in EXCESS for finding in counted.findings):
        return structure, findings
    try:
        with np.errstate(all="ignore"):
            found = _agreement(quantities, counted, values)
    except np.linalg.LinAlgError:
        found = None
    if found is None:
        return structure, findings
    if found.worst < AGREES and found.spare.on_drives < NEARLY * NEARLY:
        system = found.spare.system
        system.set_drive_values(values(0.0))
        left = UndeterminedReactions(system, found.poses[:: max(1, len(found.poses) // 6)], quantities.signals)
        if quantities.mechanism.stiffness and (following := left.following):
            return structure, [Finding("stiffness.separating", ("stiffness",), {"joints": Joined(following)})]
        if quantities.mechanism.stiffness and (open_joints := [*left.joints, *system.topology.closing_slides]):
            return structure, [Finding("stiffness.not-enough", ("stiffness",), {"joints": Joined(open_joints)})]
        return replace(found.structure, self_stress=left.self_stress), [_spared(found, left)]
    if found.worst < NEARLY:
        return structure, [*findings, *_nearly(found, quantities)]
    return structure, findings


def _agreement(quantities: Quantities, structure: Structure, values: Values) -> Agreement | None:
    """What may be left out, and how well it agrees with the rest."""
    geometry = Geometry(quantities, quantities.parameters)
    system = Constraints(structure.topology, geometry, extent(structure.topology, geometry))
    system.set_drive_values(values(0.0))
    near = start_pose(quantities, structure, system, values(0.0))
    if near is None:
        return None
    z, miss = close_joints(system, near)
    if not miss < NEARLY or np.abs(system.pose_difference(z, near)).max() > FAR:
        return None  # joints that miss, or that close in another assembly mode only
    for reach in REACHES if miss < HOLDS else ():
        if (over_turn := _over_turn(quantities, system, z, values, reach)) is not None:
            return over_turn
    # The states of self-stress at the start alone, then along the motion that the first choice leaves.
    for order in range(3):
        spare = SpareEquations(system, [z])
        if (found := _chosen(quantities, spare, order)) is None:
            continue
        chosen, reduced = found
        system.set_drive_values(values(0.0))
        poses = traced(system, chosen, z, values)
        if len(poses) < 3:
            continue
        along = SpareEquations(system, [pose for _, pose in poses[:: max(1, len(poses) // 6)]])
        if (found := _chosen(quantities, along, order)) is None:
            continue
        chosen, reduced = found
        # What is left out now may have been kept so far: only poses that the others give show what it misses.
        poses = traced(system, chosen, z, values)
        if len(poses) >= 3:
            return _agreeing(reduced, chosen, poses, along, values)
    return None


def _agreeing(
    reduced: Structure,
    chosen: list[Candidate],
    poses: list[tuple[float, Array]],
    spare: SpareEquations,
    values: Values,
) -> Agreement:
    misses = _misses(spare.system, chosen, poses, values)
    made = replace(reduced, drawn=_drawn(spare.system, poses[0][1]), spare_joints=_joints_of(chosen))
    return Agreement(made, chosen, misses, poses, spare)


def _over_turn(quantities: Quantities, system: Constraints, z: Array, values: Values, reach: float) -> Agreement | None:
    """What may be left out so that the rest stays away from singular poses over this share of a full turn of the
    drives, or as far as they go; ``None`` where nothing does."""
    poses = followed(system, z, values, reach)
    system.set_drive_values(values(0.0))
    if len(poses) < POSES:
        return None
    spare = SpareEquations(system, [pose for _, pose in poses], SOUND)
    for order in range(3):
        found = _chosen(quantities, spare, order)
        if found is not None and spare.clear_of_zero(found[0]):
            closed = _kept_closed(system, found[0], poses, values)
            if closed is None:
                return None
            agreement = _agreeing(found[1], found[0], closed, spare, values)
            agreement.structure = replace(agreement.structure, spare_joints=_named(quantities, system, poses, found[0]))
            return agreement
    return None


def _kept_closed(
    system: Constraints, chosen: list[Candidate], poses: list[tuple[float, Array]], values: Values
) -> list[tuple[float, Array]] | None:
    """The poses nearby at which what is kept holds exactly: in those by least squares, what the rest misses is spread
    over all joints. ``None`` where there are none."""
    found = []
    for time, z in poses:
        system.set_drive_values(values(time))
        closed = closed_pose(system, chosen, z)
        if closed is None:
            return None
        found.append((time, closed))
    return found


def _named(
    quantities: Quantities, system: Constraints, poses: list[tuple[float, Array]], chosen: list[Candidate]
) -> tuple[str, ...]:
    """The joints to be named as spare: those that may be taken off near the start, even where the equations left out
    over a full turn are of others."""
    near = SpareEquations(system, [pose for _, pose in poses[:3]])
    preferred = _chosen(quantities, near, 0)
    return _joints_of(chosen if preferred is None else preferred[0])


def _joints_of(chosen: list[Candidate]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(one.release.joint for one in chosen))


def _chosen(quantities: Quantities, spare: SpareEquations, order: int) -> tuple[list[Candidate], Structure] | None:
    """What is left out in an order of preference, and the structure of the rest; ``None`` where that isn't sound."""
    candidates = list(spare.orders())[order]
    if spare.states == 0 or (chosen := spare.choose(candidates)) is None:
        return None
    reduced = decompose_without(quantities.mechanism, tuple(one.release for one in chosen))
    return None if reduced.findings else (chosen, reduced)


def _misses(
    system: Constraints, chosen: list[Candidate], poses: list[tuple[float, Array]], values: Values
) -> list[float]:
    """What each part left out misses at the worst of some poses."""
    found = [0.0] * len(chosen)
    for time, z in poses:
        system.set_drive_values(values(time))
        rest = system.residual(z)
        for i, one in enumerate(chosen):
            found[i] = max(found[i], float(np.linalg.norm(one.weights(system, z) @ rest)))
        if system.opposed(z):
            return [math.inf] * len(chosen)
    system.set_drive_values(values(0.0))
    return found


def _drawn(system: Constraints, z: Array) -> dict[str, tuple[float, float, float]]:
    rows = (z.reshape(-1, 3) * [system.size, system.size, 1.0]).tolist()
    return {link: (x, y, turn) for link, (x, y, turn) in zip(system.links, rows, strict=True)}


# What is said of it.


def _spared(found: Agreement, left: UndeterminedReactions) -> Finding:
    """The warning that names what is redundant, and which reactions that leaves undetermined."""
    system, topology = found.spare.system, found.structure.topology
    rank = len(system.names) - found.spare.states
    names = list(found.structure.spare_joints)
    data: dict[str, Any] = {"joints": Joined(names), "states": found.spare.states, "rank": rank}
    mobility = system.width - rank - len(topology.mechanism.followers)
    data |= {"constraints": len(system.names), "gruebler": topology.gruebler, "mobility": mobility}
    data["reactions"] = _reactions(topology.mechanism, left)
    return Finding("structure.redundant-joints", ("joints", names[0]), data, severity="warning")


def _reactions(mechanism: Mechanism, left: UndeterminedReactions) -> Term:
    """The sentence on what is known of the reactions."""
    if left.components:
        joints, sums = Joined(left.joints), Joined(left.sums(), CLAUSES)
        return Term("redundant-sums" if sums.parts else "redundant-open", joints=joints, sums=sums)
    if not mechanism.stiffness:
        return Term("redundant-determined")
    equal = any(entry.equal for entry in mechanism.stiffness.values())
    return Term("redundant-equal" if equal else "redundant-shared")


def _nearly(found: Agreement, quantities: Quantities) -> Iterator[Finding]:
    """By what each spare joint misses."""
    unit, size = quantities.unit_of(LENGTH)
    for one, miss in zip(found.chosen, found.misses, strict=True):
        if miss >= AGREES:
            data = {"joint": one.release.joint, "miss": f"{miss * found.spare.system.size / size:.3g}", "unit": unit}
            yield Finding("structure.nearly-redundant", ("joints", one.release.joint), data)
