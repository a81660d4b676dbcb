"""Mechanisms that are redundant and move all the same: a third crank on a parallelogram, a second guide of a platform.

Gruebler's count refuses such a mechanism. Its pose is found without some of its parts, and these are fitted in; from
there on the states of self-stress tell which equations follow from the others (:mod:`.spare_equations`). The groups are
then those of the others alone. Along the motion that these leave, what is left out is looked at: where it holds, the
mechanism moves (the rank of the Jacobian says so too: P. E. Nikravesh 1988, ch. 3); where it nearly does, its
dimensions contradict each other by that much.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions.units import LENGTH
from linkwright.findings import CLAUSES, Finding, Joined, ModelError, Term
from linkwright.graph.assembly import assemble
from linkwright.graph.constraints import Constraints
from linkwright.graph.geometry import Geometry, extent
from linkwright.graph.spare_equations import Candidate, SpareEquations, kept_rows
from linkwright.graph.standing import close_joints, keeps_rules, sketched_places, starts
from linkwright.graph.undetermined_reactions import UndeterminedReactions
from linkwright.model.mechanism import Mechanism
from linkwright.model.quantities import Quantities
from linkwright.notation import Pair
from linkwright.structure import FRAME, Structure, decompose_without

Array = NDArray[np.float64]
ORIGIN = Pair(0.0, 0.0)
Values = Callable[[float], Mapping[str, float]]
"""The value of each drive and follower (rad or m) at a time (s)."""

HOLDS = 1e-9
"""Joints that miss by less than this share of the size hold."""
AGREES = 1e-10
"""What is left out agrees where it misses by less than this share of the size: closures are proven to 1e-9 of one that
may be smaller."""
NEARLY = 0.02
"""Joints that miss by less than this share of the size were meant to hold, it seems."""
PARTS, TRIES = 12, 150
"""The most parts that are left out to find a pose; how many structures are tried for that."""
FAR = 0.1
"""The most by which closing the joints may move a pose (rad, or over the size)."""
POSES, TURN, SHIFT = 12, 0.6, 0.2
"""The poses looked at along the motion; how far the drives go on it (rad, or lengths over the size)."""
FULL_TURN_POSES, HALVINGS = 25, 3
"""The poses looked at along a full turn of a drive; how often the step between two is halved."""
REACHES = (1.0, 0.1, 0.01)
"""The shares of a full turn that are looked at, each where the longer one leads through a singular pose."""
SOUND = 0.03
"""The least share of the clearest force in the states of self-stress, over a full turn, that is clear of zero."""
LONGEST = 1e4
"""The longest time (s) in which drives are waited for to go as far as that."""
EXCESS = ("structure.overconstrained", "structure.redundant")


@dataclass(frozen=True)
class Removable:
    """Something that may be left out for a pose: a link, or a joint that isn't a pin."""

    kind: str  # "links" or "joints", its section in the file
    name: str


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
    near = _start(quantities, structure, system, values(0.0))
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
        poses = _traced(system, chosen, z, values)
        if len(poses) < 3:
            continue
        along = SpareEquations(system, [pose for _, pose in poses[:: max(1, len(poses) // 6)]])
        if (found := _chosen(quantities, along, order)) is None:
            continue
        chosen, reduced = found
        # What is left out now may have been kept so far: only poses that the others give show what it misses.
        poses = _traced(system, chosen, z, values)
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
    poses = _followed(system, z, values, reach)
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
        closed = _closed(system, chosen, z)
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


def _followed(system: Constraints, z: Array, values: Values, reach: float) -> list[tuple[float, Array]]:
    """Poses along the motion at which all joints hold, with their times, by Gauss-Newton on all equations: these have
    full rank where the equations that are kept may not."""
    span = _span(system, values, 2 * math.pi) * reach
    times = np.linspace(0.0, span, FULL_TURN_POSES if reach == 1.0 else POSES)
    found = [(0.0, z)]
    for time in times[1:]:
        begun, (last, z) = len(found), found[-1]
        for halving in range(HALVINGS + 1):
            between = np.linspace(last, float(time), 2**halving + 1)[1:]
            pose: Array | None = z
            for t in between:
                pose = None if pose is None else _held(system, pose, float(t), values)
            if pose is not None:
                found.append((float(time), pose))
                break
        if len(found) == begun:
            break
    return found


def _held(system: Constraints, z: Array, time: float, values: Values) -> Array | None:
    """The pose nearby at which all joints hold at a time; ``None`` where Gauss-Newton doesn't shrink its steps."""
    try:
        system.set_drive_values(values(time))
    except ModelError:  # past the end of a table
        return None
    before = math.inf
    for _ in range(12):
        step = np.linalg.lstsq(system.jacobian(z), system.residual(z), rcond=1e-9)[0]
        size = float(np.abs(step).max(initial=0.0))
        if not size < min(0.6, max(0.4 * before, 1e-9)):
            return None
        z, before = z - step, size
        if size < 1e-13:
            break
    return z if float(np.abs(system.residual(z)).max(initial=0.0)) < HOLDS and not system.opposed(z) else None


def _chosen(quantities: Quantities, spare: SpareEquations, order: int) -> tuple[list[Candidate], Structure] | None:
    """What is left out in an order of preference, and the structure of the rest; ``None`` where that isn't sound."""
    candidates = list(spare.orders())[order]
    if spare.states == 0 or (chosen := spare.choose(candidates)) is None:
        return None
    reduced = decompose_without(quantities.mechanism, tuple(one.release for one in chosen))
    return None if reduced.findings else (chosen, reduced)


# The pose to begin with.


def _start(
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


# The motion from there.


def _traced(system: Constraints, chosen: list[Candidate], z: Array, values: Values) -> list[tuple[float, Array]]:
    """Poses along the motion that the equations leave which are kept, with their times; fewer where it ends."""
    found: list[tuple[float, Array]] = []
    for time in np.linspace(0.0, _span(system, values), POSES):
        try:
            system.set_drive_values(values(float(time)))
        except ModelError:  # past the end of a table
            break
        closed = _closed(system, chosen, z)
        if closed is None:
            break
        z = closed
        found.append((float(time), z))
    return found


def _closed(system: Constraints, chosen: list[Candidate], z: Array) -> Array | None:
    """The pose nearby at which what is kept holds, by Newton; ``None`` where there is none."""
    for _ in range(25):
        kept = kept_rows(system, z, chosen)
        rest = kept @ system.residual(z)
        step = np.linalg.lstsq(kept @ system.jacobian(z), rest, rcond=1e-12)[0]
        if not np.abs(step).max(initial=0.0) < 0.5:
            return None
        z = z - step
        if np.abs(step).max(initial=0.0) < 1e-14:
            break
    return z if np.abs(kept_rows(system, z, chosen) @ system.residual(z)).max(initial=0.0) < 1e-12 else None


def _span(system: Constraints, values: Values, turn: float = TURN) -> float:
    """The time (s) in which some drive goes as far as is looked at, or as far as it goes at all."""
    start = values(0.0)
    units = {
        name: turn if system.topology.mechanism.prescribed(name).turns is not None else SHIFT * system.size
        for name in start
    }
    farthest, best, time = 0.0, 0.0, 1e-4
    while time < LONGEST:
        try:
            gone = max((abs(value - start[name]) / units[name] for name, value in values(time).items()), default=0.0)
        except ModelError:
            break
        if gone > 1.0:
            return time / max(gone, 1.0)
        if gone > farthest:
            farthest, best = gone, time
        time *= 1.3
    return best


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
