"""Whether a motion can be followed: intervals in which a group can't be assembled, and singular poses."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import islice
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions import units as u
from linkwright.findings import Finding, Joined, Term
from linkwright.graph.assembly import shortfall_at, shortfall_data
from linkwright.graph.rows import Apart, Determinant, GroupRow, Named, ReachRow, change_rows
from linkwright.kernels import Compiled
from linkwright.kernels.laws import values_at
from linkwright.results import Run
from linkwright.results.claims import SINGULAR
from linkwright.results.margins import nearest
from linkwright.results.stationary import stationary
from linkwright.structure import Group

Array = NDArray[np.float64]

TOUCH = 1e-13
"""A reach within this of zero only touches: a singular pose, and the radicand's round-off decides its sign."""
MANY = 50
"""The most intervals of a group in which it can't be assembled that are told one by one."""
NEAR = 1e-3
"""A reach that turns below this passes a change point closely (the links come within 3 deg of being in line)."""
SMALL = 1e-3
"""A margin to singularity that isn't above this is worth a warning."""

BESIDE = (0.0, 1e-4, 1e-3)
"""The shares of the run at which a higher group is looked at from its start pose."""


def unassembled(run: Run) -> list[Finding]:
    """Each interval of the run in which a group can't be assembled, by the group that fails first."""
    findings: list[Finding] = stuck(run)
    taken: list[tuple[float, float]] = [(f.data["start"], f.data["stop"]) for f in findings]
    look_at(run, change_rows(run.compiled.structure))
    for group in run.compiled.structure.groups:
        if group.modes < 2:
            continue
        ends = [end for gap in taken for end in gap]
        found = gaps(run, ReachRow(group.label), ends)
        for start, stop, worst in islice(found, MANY):
            if not any(a <= start and stop <= b for a, b in taken):
                taken.append((start, stop))
                findings.append(_cannot_assemble(run, group, start, stop, worst))
        if next(found, None) is not None:  # the motion comes back to it turn by turn
            findings.append(Finding("motion.more-gaps", ("links", group.links[0]), {"count": MANY}))
    return findings


def stuck(run: Run) -> list[Finding]:
    """Where a higher group can't be followed any further: it has met a singular pose of its own."""
    run.compiled.inputs(np.array([run.stop]))  # lays the paths of all higher groups
    findings = []
    for follower in run.compiled.followers:
        end = follower.path.end
        if end is None or end >= run.stop:
            continue
        data: dict[str, Any] = {"group": follower.higher_group.label, "links": Joined(follower.higher_group.links)}
        data |= {"time": f"{end:.6g}", "start": end, "stop": run.stop}
        findings.append(
            Finding("motion.stuck", ("links", follower.higher_group.links[0]), data | drive_value(run, end))
        )
    return findings


def look_at(run: Run, rows: Sequence[Named]) -> None:
    """Look closely at rows, all at once, so that :func:`row_of` has them at hand: what many groups share is computed
    once."""
    rows = [row for row in rows if row not in run.rows]
    if not rows:
        return

    def rates(share: Array) -> tuple[Array, Array]:
        t, slope = run.place(share)
        values, slopes = run.compiled.rates(rows, t)
        with np.errstate(invalid="ignore"):  # an infinite rate where the run's pace is zero: no sign is known there
            return values, slopes * slope

    grid, turning = np.linspace(0.0, 1.0, max(run.grid, 200) + 1), stationary(rates, 0.0, 1.0, run.grid, alone=True)
    every = np.union1d(grid, np.concatenate(turning))
    t = run.place(every)[0]
    for row, own, values in zip(rows, turning, run.compiled.evaluate(rows, t), strict=True):
        at = np.searchsorted(every, np.union1d(grid, own))
        run.rows[row] = t[at], values[at]


def row_of(run: Run, row: Named, more: Sequence[float] = ()) -> tuple[Array, Array]:
    """Times and values of a row, on a grid that holds its turning points and some more times."""
    look_at(run, [row])
    t, values = run.rows[row]
    if not len(more):
        return t, values
    t = np.union1d(t, [*more])
    return t, run.compiled.evaluate([row], t)[0]


def gaps(run: Run, row: ReachRow, ends: Sequence[float]) -> Iterator[tuple[float, float, float]]:
    """Intervals in which a reach is negative, with the time of its least value; each is looked at as it is asked for.

    ``ends`` are those of the gaps of earlier groups, where this one's reach may stop while it is negative.
    """
    t, reach = row_of(run, row, ends)
    bad = reach < -TOUCH
    if bad.any():  # where the outer pins meet, the reach is 0/0
        apart = run.compiled.evaluate([Apart(row.group)], t)[0]
        bad &= apart > TOUCH * apart.max()
    edges = np.flatnonzero(np.diff(np.concatenate([[False], bad, [False]]).astype(int)))
    for first, after in edges.reshape(-1, 2):
        start = _edge(run, row, t[first], t[first - 1]) if first else run.start
        stop = _edge(run, row, t[after - 1], t[after]) if after < t.size else run.stop
        yield start, stop, float(t[first + int(np.argmin(reach[first:after]))])


def _edge(run: Run, row: Named, bad: float, good: float, limit: float = 0.0, sign: int = 1) -> float:
    """The time at which a reach turns negative, or a row passes a limit (upwards with ``sign`` -1), by bisection to
    round-off."""
    for _ in range(60):
        middle = 0.5 * (bad + good)
        if sign * (run.compiled.evaluate([row], np.array([middle]))[0, 0] - limit) < 0:
            bad = middle
        else:
            good = middle
    return float(good)


def drive_value(run: Run, time: float) -> dict[str, Any]:
    """What the first drive prescribes at a time, in the model's unit: drive, value, unit.

    One with an output goes first, and the output stands for it.
    """
    drives = run.compiled.mechanism.drives
    name = next((name for name, drive in drives.items() if drive.output), run.compiled.graph.drives[0])
    unit, size = run.compiled.quantities.drive_unit(name)
    value = values_at(run.compiled.laws, time)[name]
    return {"drive": drives[name].output or name, "value": f"{value / size:.6g}", "unit": unit}


def shortfall(compiled: Compiled, group: Group, time: float) -> dict[str, Any]:
    """In words by how much a group fails to close at a time."""
    values, unknowns = values_at(compiled.laws, time), compiled.unknowns(time)
    distance, limit = shortfall_at(
        compiled.quantities, compiled.structure, compiled.branches(time), values, group, unknowns.__getitem__
    )
    data = shortfall_data(compiled.quantities, group, distance, limit)
    return data | {"length_unit": data["unit"]}


def _cannot_assemble(run: Run, group: Group, start: float, stop: float, worst: float) -> Finding:
    data = shortfall(run.compiled, group, worst)
    ends = [drive_value(run, time) for time in (start, stop)]
    data |= {"drive": ends[0]["drive"], "unit": ends[0]["unit"]}
    data |= {"from": ends[0]["value"], "to": ends[1]["value"], "start": start, "stop": stop}
    if any(drive.output for drive in run.compiled.mechanism.drives.values()):
        data |= {"worst": drive_value(run, worst)["value"], "time": f"{start:.6g}", "until": f"{stop:.6g}"}
        return Finding("motion.out-of-reach", ("links", group.links[0]), data)
    low, far, high = (float(value) for value in (data["from"], drive_value(run, worst)["value"], data["to"]))
    if not min(low, high) <= far <= max(low, high):  # the drive turns back on its way
        data["to"] = f"{far:.6g}"
    return Finding("motion.cannot-assemble", ("links", group.links[0]), data)


def singular(run: Run, code: str = "motion.singular") -> list[Finding]:
    """A finding for each pose in which a group with two modes has them meet, else for the worst other one.

    Poses through which the run is carried (``run.compiled.passages``) are none.
    """
    findings = [_singular(run, code, group, time, 0.0) for group, time in _meetings(run)]
    worst = None if findings else nearest(run)
    if worst is not None and not worst.determinant > SINGULAR:
        findings.append(_singular(run, code, worst.group, worst.time, worst.determinant))
    return findings


def singular_before(run: Run, code: str, end: float) -> list[Finding]:
    """The same before a time at which a higher group can't be followed any further: past a change point the run may
    have been in another mode, in which it isn't meant to be."""
    return [_singular(run, code, group, time, 0.0) for group, time in _meetings(run) if time < end]


def _meetings(run: Run) -> Iterator[tuple[str, float]]:
    """The groups whose two modes meet, with the times, but those through which the run is carried."""
    rows = change_rows(run.compiled.structure)
    look_at(run, rows)
    for group in run.compiled.structure.groups:
        touches = {time for row in rows if row.group == group.label for time, _ in touching(run, row)}
        yield from ((group.label, time) for time in sorted(touches) if not _passed(run, group.label, time))


def singular_throughout(run: Run) -> list[Finding]:
    """A finding for each group whose two modes coincide, or whose outer pins do, in all poses of the run: neither its
    motion nor its forces are determined. Of a higher group at the start and a little later, as it can't be followed."""
    findings, size = [], run.compiled.assembly.size()
    for row in change_rows(run.compiled.structure):
        _, values = row_of(run, row)
        if values.size and (np.abs(values) <= TOUCH * (size**2 if isinstance(row, Apart) else 1.0)).all():
            path = ("links", row.group.split("-")[0])
            findings.append(Finding("motion.singular-throughout", path, {"group": row.group}))
    times = run.start + np.array(BESIDE) * (run.stop - run.start)
    inputs = run.compiled.inputs(times) if run.compiled.followers else np.empty((0, 0))
    for follower in run.compiled.followers:
        poses = [inputs[:, [i]] for i in range(times.size)]
        if all(follower.has_double_root(pose, follower.start, run.compiled.parameters) for pose in poses):
            group = follower.higher_group
            findings.append(Finding("motion.singular-throughout", ("links", group.links[0]), {"group": group.label}))
    return findings


def near(run: Run) -> list[Finding]:
    """A warning for each pose in which a group comes near to a change point, but doesn't meet it, and for the smallest
    margin of all where it is small for another reason."""
    found = []
    for group in run.compiled.structure.groups:
        if group.modes > 1:
            times = [time for time, reach in touching(run, ReachRow(group.label), NEAR) if reach > TOUCH]
            inner = [time for time in times if run.start < time < run.stop]
            found += [_near(run, group.label, time) for time in inner if not _passed(run, group.label, time)]
    worst, told = nearest(run), {finding.data["group"] for finding in found}
    if worst is not None and worst.group not in told and not worst.determinant > SMALL:
        data = {"group": worst.group, "time": f"{worst.time:.6g}", "margin": f"{worst.determinant:.2g}"}
        path = ("links", worst.group.split("-")[0])
        found.append(Finding("motion.small-margin", path, data | drive_value(run, worst.time), severity="warning"))
    return found


def strokes(run: Run) -> list[Finding]:
    """A finding for each cylinder that is shorter or longer in the run than it can be, at its worst."""
    return [
        Finding("motion.cylinder-length", path, data | {"time": f"{time:.6g}"} | drive_value(run, time))
        for path, time, data in overrun(run)
    ]


def travels(run: Run) -> Iterator[Finding]:
    """A finding for each end of a slide's travel that the run goes beyond: where first, and where furthest."""
    quantities = run.compiled.quantities
    unit, size = quantities.unit_of(u.LENGTH)
    for name, joint in run.compiled.mechanism.joints_but_pins():
        if joint.limits is None:
            continue
        row, (low, high) = f"{name}.s", (quantities.value(edge, u.LENGTH) for edge in joint.limits)
        t, travel = row_of(run, row)
        for limit, sign, end in ((low, 1, Term("below")), (high, -1, Term("above"))):
            inside = sign * (travel - limit)
            worst, beyond = int(np.argmin(inside)), inside < -1e-9 * max(abs(low), abs(high))
            if not beyond[worst]:
                continue
            first = int(np.argmax(beyond))
            leaves = _edge(run, row, t[first], t[first - 1], limit, sign) if first else run.start
            data: dict[str, Any] = {"name": name, "length_unit": unit, "by": f"{-inside[worst] / size:.4g}", "end": end}
            data |= {"low": f"{low / size:.6g}", "high": f"{high / size:.6g}", "travel": f"{travel[worst] / size:.6g}"}
            data |= {"leaves": f"{leaves:.6g}", "leaves_value": drive_value(run, leaves)["value"]}
            data |= {"time": f"{t[worst]:.6g}"} | drive_value(run, float(t[worst]))
            yield Finding("motion.travel", ("joints", name, "travel"), data)


def overrun(run: Run) -> Iterator[tuple[tuple[str, ...], float, dict[str, Any]]]:
    """The length of each cylinder that a run takes beyond its stroke: its place in the file, the worst time, by how
    much."""
    quantities = run.compiled.quantities
    unit, size = quantities.unit_of(u.LENGTH)
    for name, cylinder in run.compiled.mechanism.cylinders.items():
        if cylinder.length is None:
            continue
        low, high = (quantities.value(edge, u.LENGTH) for edge in cylinder.length)
        t, length = row_of(run, f"{name}.s")
        for at, over, limit in (
            (int(np.argmin(length)), low - length.min(), low),
            (int(np.argmax(length)), length.max() - high, high),
        ):
            if over > 1e-9 * high:
                data: dict[str, Any] = {"name": name, "length_unit": unit, "by": f"{over / size:.4g}"}
                data |= {"length": f"{length[at] / size:.6g}", "limit": f"{limit / size:.6g}"}
                data["end"] = Term("shorter" if limit == low else "longer")
                yield ("cylinders", name, "length"), float(t[at]), data


def _passed(run: Run, group: str, time: float) -> bool:
    """Whether the run is carried through this change point of the group."""
    return not run.compiled.passages.outside(np.array([time]), group)[0]


def touching(run: Run, row: GroupRow, limit: float = TOUCH) -> list[tuple[float, float]]:
    """Where a reach, or a distance of outer pins over its largest, comes within a limit of zero: time and value at the
    lowest place of each such stretch."""
    t, values = row_of(run, row)
    size = float(np.nanmax(values)) if isinstance(row, Apart) else 1.0
    return [(float(t[i]), float(values[i]) / size) for i in _lowest(values, limit * size)]


def _lowest(values: Array, limit: float) -> list[int]:
    """The index of the least magnitude in each stretch of values within a limit of zero."""
    low = np.concatenate([[False], np.abs(values) <= limit, [False]])
    stretches = np.flatnonzero(np.diff(low.astype(int))).reshape(-1, 2)
    return [int(first + np.argmin(np.abs(values[first:after]))) for first, after in stretches]


def _near(run: Run, group: str, time: float) -> Finding:
    determinant = abs(float(run.compiled.evaluate([Determinant(group)], np.array([time]))[0, 0]))
    data = {"group": group, "time": f"{time:.6g}", "determinant": f"{determinant:.2g}"}
    path = ("links", group.split("-")[0])
    return Finding("motion.near-change-point", path, data | drive_value(run, time), severity="warning")


def _singular(run: Run, code: str, group: str, time: float, determinant: float) -> Finding:
    data = {"group": group, "time": f"{time:.6g}", "determinant": f"{determinant:.2g}"}
    return Finding(code, ("links", group.split("-")[0]), data | drive_value(run, time))
