"""Inverse kinematics: from a wanted path p(u) of the working point to the motions of both drives.

A track is one solution q(u) of the drives along the path. Its derivatives are exact: differentiating x(q(u)) = p(u)
gives J q' = p' and J q'' = p'' - (the point's acceleration at the rates q' alone). With the motor at
constant speed w its own value gives the time, q1(u) = q1(0) + w t, hence u' = w / q1' and u'' = -q1'' u'^2 / q1'; the
servo's speed is q2' u', its acceleration q2'' u'^2 + q2' u''. With the path given in time, u(t) is known and both
drives follow it.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions import units as si
from linkwright.findings import Finding
from linkwright.results.stationary import bracketed, crossings
from linkwright.studies.workspace.efforts import Efforts, efforts
from linkwright.studies.workspace.path_continuation import NEWTON, SOLVED, SolutionTrack, divided, tracks
from linkwright.studies.workspace.regions import Region
from linkwright.studies.workspace.target_path import Path_, TargetPath

Array = NDArray[np.float64]

LOOKS = 2000
"""Places of a path that are held against the region before the ends of stretches outside are halved out."""
INSIDE = 1e-6
"""A path this near to the region (share of its extent) counts as inside: its edge is drawn to a chord."""
EDGE = 1e-3
"""A track that ends this near to a stretch outside ends for that reason."""
STILL = 1e-9
"""A servo that moves less than this share of what the motor does stands still; so does a path's point."""
ACROSS = 17
"""Places of a bridge at which the motor's sense is looked at."""
PERIOD = 1e-7
"""Drives that come back to within this (rad or m) have a periodic law."""

_CODES = {
    "outside": "workspace.path-outside",
    "singular": "workspace.path-singular",
    "modes": "workspace.path-modes",
    "limit": "workspace.path-limit",
    "turns": "workspace.path-turns",
}


@dataclass(frozen=True)
class BlockedStretch:
    """A stretch u = ``start`` .. ``stop`` of a path that can't be followed, and why: "outside" of the region, by ``by``
    (m) at the most; from ``start`` on: "singular", a singular curve is met; "modes", two assembly modes meet; "limit",
    the ``drive`` is at the end of its range; "turns", the motor would have to turn back."""

    kind: str
    start: float
    stop: float
    by: float = 0.0
    drive: str = ""


@dataclass(frozen=True, eq=False)
class ServoLaw:
    """How the drives move along the path, at ``samples`` times ``t`` (s): ``motor`` and ``servo`` (3, samples) are
    value, speed and acceleration (SI); ``u`` and ``point`` (2, samples), m, are the place on the path.

    ``residual`` (m) is how far the point lies off the path at the worst; ``determinant`` the least size of
    d(x, y)/d(drives) on the way (m² per product of the drives' units), ``closure`` that of the groups' determinants;
    ``reverses`` the times at which the servo's speed changes its sign, ``limit_positions`` those at which a limit
    position is passed. ``backward``: the path is run from u = 1 to 0. ``period``: the drives come back after it.
    ``efforts``: what motor and servo give, where asked for.
    """

    names: tuple[str, str]
    t: Array
    motor: Array
    servo: Array
    u: Array
    point: Array
    residual: float
    determinant: float
    closure: float
    reverses: Array
    limit_positions: Array
    backward: bool
    period: float | None
    at: Callable[[Array], tuple[Array, Array]]
    """Drives (3, 2, n), in the order of ``names``, and u (n,) at times (n,)."""
    efforts: Efforts | None = None


@dataclass(frozen=True)
class Way:
    """A law, or ``None`` where the path can't be followed from end to end; the ``stretches`` where it can't;
    ``solutions``: how many ways at the path's start there were to choose from; what is to be said of it."""

    law: ServoLaw | None
    stretches: tuple[BlockedStretch, ...]
    solutions: int
    findings: tuple[Finding, ...]


def free(
    region: Region,
    wanted: TargetPath,
    motor: str,
    speed: float,
    samples: int = 361,
    never_reverse: bool = False,
    forces: bool = True,
    off: float | None = None,
) -> Way:
    """The servo's law that keeps the point on the path while the motor turns at constant ``speed`` (rad/s or m/s).

    The path is run from u = 0, or backward where only that suits the motor's sense. Of several solutions the one is
    taken that follows furthest, then the one whose determinant stays largest. ``off`` (m): how far the point may be
    from the path where it passes a limit position.
    """
    m = region.sheet.drives.index(motor)
    u = np.linspace(0.0, 1.0, LOOKS + 1)
    # A path point that stands still would need the motor to stop: refuse it at once.
    pace = np.hypot(*wanted.of(u)[1])
    if pace.min() <= STILL * pace.max():
        return Way(None, (), 0, (Finding("workspace.path-rests", wanted.path, {"u": float(u[pace.argmin()])}),))
    best: tuple[tuple[float, float], SolutionTrack, float, bool] | None = None
    solutions, laps = 0, [wanted, wanted.backward()]
    # Follow the path forward from every solution at its start; if none can be followed to the end, try it backward.
    for backward, way in enumerate(laps):
        found = tracks(region, way, off)
        solutions = max(solutions, len(found))
        for track in found:
            # Rank the tracks: first by how far they lead before the motor would reverse, then by their distance from
            # singular positions.
            turn = _turned(track, m, speed)
            rank = (min(turn, float(track.u[-1])), track.least)
            if best is None or rank[0] > best[0][0] + 1e-9 or (rank[0] > best[0][0] - 1e-9 and rank[1] > best[0][1]):
                best = rank, track, turn, bool(backward)
        if best is not None and best[0][0] >= 1.0:
            break
    if best is None:
        stretches = _stretches(region, wanted, None, 1.0, False)
        return Way(None, stretches, 0, _stretch_findings(region, wanted.path, stretches, motor))
    _, track, turn, back = best
    # Report the obstacles, or build the law if there are none.
    stretches = _stretches(region, wanted, track, turn, back)
    if stretches:
        return Way(None, stretches, solutions, _stretch_findings(region, wanted.path, stretches, motor))
    # At constant speed the motor's own value is proportional to time, so the whole travel gives the duration.
    first, last = track.nodes[0, m, [0, -1]]
    time = float((last - first) / speed)

    def drives_at(t: Array) -> tuple[Array, Array]:
        motion, u = _timed(track, m, first + speed * t, speed)
        motion[1, m], motion[2, m] = speed, 0.0  # to round-off it is
        return motion, u

    return _way(region, wanted, track, drives_at, time, (m, 1 - m), samples, solutions, never_reverse, forces, back)


Timing = Callable[[Array], Array]
"""u with its first and second derivative by the time, (3, n), at times (n,); rising from 0 to 1."""


def timed(
    region: Region,
    wanted: TargetPath,
    motor: str,
    duration: float,
    timing: Timing | None = None,
    samples: int = 361,
    never_reverse: bool = False,
    forces: bool = True,
    off: float | None = None,
) -> Way:
    """The laws of both drives where the path is given in time: u = t / ``duration`` (s), or as ``timing`` has it;
    ``off`` as for :func:`free`."""
    m = region.sheet.drives.index(motor)
    # The time is given, so the motor may reverse: take the track that leads farthest, then the one farthest from
    # singular positions.
    found = sorted(tracks(region, wanted, off), key=lambda track: (-round(float(track.u[-1]), 9), -track.least))
    stretches = _stretches(region, wanted, found[0] if found else None, 1.0, False)
    if not found or stretches:
        return Way(None, stretches, len(found), _stretch_findings(region, wanted.path, stretches, motor))

    def drives_at(t: Array) -> tuple[Array, Array]:
        zero = np.zeros_like(t)
        u = timing(t) if timing else np.stack([t / duration, zero + 1 / duration, zero])
        return _ruled(found[0].at(u[0]), u[1], u[2]), u[0]

    return _way(
        region, wanted, found[0], drives_at, duration, (m, 1 - m), samples, len(found), never_reverse, forces, False
    )


def _ruled(nodes: Array, first: Array, second: Array) -> Array:
    """Drives with derivatives by u as ones by the time: (3, 2, n)."""
    return np.stack([nodes[0], nodes[1] * first, nodes[2] * first**2 + nodes[1] * second])


def _timed(track: SolutionTrack, m: int, value: Array, speed: float) -> tuple[Array, Array]:
    """Drives (3, 2, n) and u where the motor has a value: F(q1, q2) = p(u) solved for q2 and u; on a bridge q1(u) alone
    for u."""
    made, u = np.empty((3, 2, value.size)), np.empty(value.size)
    solved = np.ones(value.size, dtype=bool)
    # On bridges (across limit positions) the jacobian is singular: the motor's value is inverted along the
    # interpolated track.
    for start, stop in track.bridges:
        low, high = np.sort(track.near(np.array([start, stop]))[m])
        on = (value > low) & (value < high)
        rows, ends = np.flatnonzero(on), (np.full(on.sum(), start), np.full(on.sum(), stop))
        u[on] = bracketed(lambda u, row: track.near(u)[m] - value[row], rows, *ends)
        made[:, :, on] = track.along(u[on])
        solved &= ~on
    # Everywhere else solve exactly.
    made[:, :, solved], u[solved] = _solved(track, m, value[solved])
    # Chain rule: u' = w / q1', u'' = -q1'' u'^2 / q1'.
    first = speed / made[1, m]
    return _ruled(made, first, -made[2, m] * first**2 / made[1, m]), u


def _solved(track: SolutionTrack, m: int, value: Array) -> tuple[Array, Array]:
    """Drives by u (3, 2, n) and u at values of the motor off all bridges."""
    s, mover = 1 - m, track.mover
    # Start values by inverse interpolation of the motor's value along the track.
    line = np.linspace(0.0, 1.0, 8 * track.u.size)
    along = track.near(line)[m]
    order = np.argsort(along)
    u = np.interp(value, along[order], line[order])
    q = track.near(u)
    q[m] = value
    # Newton for the servo's value and u together, with the motor's value held: two equations, the point lies on the
    # path.
    for _ in range(NEWTON):
        look, path = mover.sheet.look(q), track.wanted.of(u)
        step = divided(np.stack([look.jacobian[:, s], -path[1]], axis=1), look.at - path[0])
        q[s] -= step[0]
        u = np.clip(u - step[1], 0.0, 1.0)
        if (np.abs(step) <= SOLVED * (1.0 + np.abs(q[s]))).all():
            break
    return mover.along(q, track.wanted.of(u))[0], u


def _turned(track: SolutionTrack, m: int, speed: float) -> float:
    """The u from which on the motor would have to turn back; 1 where it needn't."""
    if track.u.size == 1:  # it ends where it begins
        return 0.0
    # Check the sign of the motor's rate at the nodes and densely on bridges.
    inner = [np.linspace(*bridge, ACROSS) for bridge in track.bridges]
    places = np.unique(np.concatenate([track.u, *inner]))
    rate = np.sign(speed) * track.along(places)[1, m]
    bad = np.flatnonzero(rate <= 0)
    if not bad.size:
        return 1.0
    if bad[0] == 0:
        return 0.0
    # Locate the reversal between the last good place and the first bad one.
    low, high = places[[bad[0] - 1]], places[[bad[0]]]
    return float(bracketed(lambda u, _: track.at(u)[1, m], np.zeros(1, dtype=np.intp), low, high)[0])


def _way(
    region: Region,
    wanted: TargetPath,
    track: SolutionTrack,
    at: Callable[[Array], tuple[Array, Array]],
    time: float,
    order: tuple[int, int],
    samples: int,
    solutions: int,
    never_reverse: bool,
    forces: bool,
    backward: bool,
) -> Way:
    sheet = region.sheet
    names = (sheet.drives[order[0]], sheet.drives[order[1]])

    def ordered(t: Array) -> tuple[Array, Array]:
        # Evaluate the law at the sample times, and measure how far the point really lies off the path.
        motion, u = at(t)
        return motion[:, list(order)], 1.0 - u if backward else u

    t = np.linspace(0.0, time, samples)
    motion, u = at(t)
    look = track.mover.look(motion[0], motion[1])
    off = np.hypot(*(look.at - track.wanted.of(u)[0]))
    moves = np.abs(track.nodes[1]).max(axis=1)
    # Reversals of the servo, unless it stands still throughout; limit positions from the track. Both as times.
    still = moves[order[1]] <= STILL * moves.max()
    turned = np.empty(0) if still else crossings(lambda s: track.at(s)[1, order[1]], 0.0, 1.0, track.u.size)
    passages = (turned, track.limit_positions)
    times, limit_positions = (np.array([_time_at(at, one, time) for one in some]) for some in passages)
    law = ServoLaw(
        names,
        t,
        motion[:, order[0]],
        motion[:, order[1]],
        1.0 - u if backward else u,
        look.at,
        float(off.max()),
        min(track.least, float(np.abs(look.determinant).min())),
        float(np.abs(look.closure).min()),
        times,
        limit_positions,
        backward,
        time if _comes_back(region, wanted, motion) else None,
        ordered,
    )
    if forces:
        law = replace(law, efforts=efforts(sheet, names, law.at, t))
    findings = []
    if wanted.corners:
        data: dict[str, Any] = {"count": len(wanted.corners), "u": wanted.corners[0]}
        findings.append(Finding("workspace.path-corner", wanted.path, data, severity="warning"))
    if limit_positions.size:
        passed = {"count": limit_positions.size, "time": float(limit_positions[0]), "point": sheet.point}
        findings.append(Finding("workspace.path-dead", wanted.path, passed, severity="warning"))
    if never_reverse and times.size:
        reversal = {"servo": names[1], "count": times.size, "time": float(times[0])}
        findings.append(Finding("workspace.servo-reverses", wanted.path, reversal))
    return Way(law, (), solutions, tuple(findings))


def _time_at(at: Callable[[Array], tuple[Array, Array]], u: float, time: float) -> float:
    """When a path's u is passed."""
    ends = np.zeros(1), np.full(1, time)
    return float(bracketed(lambda t, _: at(t)[1] - u, np.zeros(1, dtype=np.intp), *ends)[0])


def _comes_back(region: Region, wanted: TargetPath, motion: Array) -> bool:
    turn = np.where(region.box.turns, 2 * np.pi, np.inf)
    moved = motion[0, :, -1] - motion[0, :, 0]
    whole = np.where(np.isfinite(turn), np.round(moved / np.where(np.isfinite(turn), turn, 1.0)) * 2 * np.pi, 0.0)
    return wanted.closed and bool((np.abs(moved - whole) <= PERIOD).all())


def _stretches(
    region: Region, wanted: TargetPath, track: SolutionTrack | None, turn: float, backward: bool
) -> tuple[BlockedStretch, ...]:
    """Where the path can't be followed. A track that is whole proves that the path is inside, whatever the polygon's
    chords say."""
    found = () if track is not None and not track.end else outside(region, wanted)
    if track is None:
        return found or (BlockedStretch("singular", 0.0, 1.0),)

    def beyond(kind: str, u: float, drive: str = "") -> BlockedStretch:
        return (
            BlockedStretch(kind, 0.0, 1.0 - u, drive=drive) if backward else BlockedStretch(kind, u, 1.0, drive=drive)
        )

    more: tuple[BlockedStretch, ...] = ()
    at = 1.0 - float(track.u[-1]) if backward else float(track.u[-1])
    if turn < track.u[-1]:
        more = (beyond("turns", turn),)
    elif track.end and not any(abs(end - at) < EDGE for one in found for end in (one.start, one.stop)):
        more = (beyond(track.end, float(track.u[-1]), track.drive),)
    return (*found, *more)


def outside(region: Region, wanted: TargetPath) -> tuple[BlockedStretch, ...]:
    """The stretches of a path outside a region, and by how much."""
    import shapely

    shape: Any = region.shape
    if shape.is_empty:
        return (BlockedStretch("outside", 0.0, 1.0),)
    low, high = np.array(shape.bounds).reshape(2, 2)
    # The polygon is drawn to a chord tolerance, so points slightly outside of it count as inside.
    slack = INSIDE * float((high - low).max())
    shapely.prepare(shape)

    def away(u: Array) -> Array:
        return np.asarray(shapely.distance(shape, shapely.points(wanted.of(u)[0].T))) - slack

    u = np.linspace(0.0, 1.0, LOOKS + 1)
    far = away(u)
    out = far > 0
    # Sample the distance along the path and locate each change between inside and outside by root finding.
    change = np.flatnonzero(out[1:] != out[:-1])
    rows = np.zeros(change.size, dtype=np.intp)
    ends = bracketed(lambda s, _: away(s), rows, u[change], u[change + 1]) if change.size else np.empty(0)
    # A stretch that begins or ends with the path has its end there.
    if out[0]:
        ends = np.concatenate([[0.0], ends])
    if out[-1]:
        ends = np.concatenate([ends, [1.0]])
    found = []
    for start, stop in ends.reshape(-1, 2):
        # The largest distance over the stretch, from the samples and a finer look.
        inside = far[(u >= start) & (u <= stop)]
        by = float(np.concatenate([inside, away(np.linspace(start, stop, 65))]).max()) + slack
        found.append(BlockedStretch("outside", float(start), float(stop), by))
    return tuple(found)


def _stretch_findings(
    region: Region, path: Path_, stretches: tuple[BlockedStretch, ...], motor: str
) -> tuple[Finding, ...]:
    """What is to be said of stretches that can't be followed."""
    unit, size = region.sheet.compiled.quantities.unit_of(si.LENGTH)
    findings = []
    for one in stretches:
        data = {
            "start": f"{one.start:.6g}",
            "stop": f"{one.stop:.6g}",
            "by": f"{one.by / size:.4g} {unit}",
            "point": region.sheet.point,
            "drive": one.drive or motor,
        }
        findings.append(Finding(_CODES[one.kind], path, data))
    return tuple(findings)
