"""Whether a motion can be followed: intervals in which a group can't be assembled, and singular poses."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.graph.assembly import shortfall_at, shortfall_data
from linkwright.model import units as u
from linkwright.model.findings import Finding
from linkwright.results import Run
from linkwright.results.certificate import Nearest
from linkwright.results.stationary import stationary
from linkwright.structure import Group

Array = NDArray[np.float64]

SINGULAR = 1e-7
"""A normalised group determinant below this is a singular pose: rates and forces lose all their digits there."""


def unassembled(run: Run) -> list[Finding]:
    """Each interval of the run in which a group can't be assembled, by the group that fails first."""
    findings: list[Finding] = []
    taken: list[tuple[float, float]] = []
    for group in run.compiled.structure.groups:
        if group.modes < 2:
            continue
        for start, stop, worst in _gaps(run, f"reach:{group.label}"):
            if not any(a <= start and stop <= b for a, b in taken):
                taken.append((start, stop))
                findings.append(_cannot_assemble(run, group, start, stop, worst))
    return findings


def _gaps(run: Run, row: str) -> list[tuple[float, float, float]]:
    """Intervals in which a reach is negative, with the time of its least value."""

    def rates(t: Array) -> tuple[Array, Array]:
        y = run.compiled.evaluate([row], t, rates=True)
        return y[:, 0], y[:, 1]

    turning = stationary(rates, run.start, run.stop, run.steps)[0]
    t = np.union1d(np.linspace(run.start, run.stop, max(run.steps, 200) + 1), turning)
    reach = run.compiled.evaluate([row], t)[0]
    bad = reach < 0
    edges = np.flatnonzero(np.diff(np.concatenate([[False], bad, [False]]).astype(int)))
    gaps = []
    for first, after in edges.reshape(-1, 2):
        start = _edge(run, row, t[first], t[first - 1]) if first else run.start
        stop = _edge(run, row, t[after - 1], t[after]) if after < t.size else run.stop
        gaps.append((start, stop, float(t[first + int(np.argmin(reach[first:after]))])))
    return gaps


def _edge(run: Run, row: str, bad: float, good: float) -> float:
    """The time at which a reach turns negative, by bisection to round-off."""
    for _ in range(60):
        middle = 0.5 * (bad + good)
        if run.compiled.evaluate([row], np.array([middle]))[0, 0] >= 0:
            good = middle
        else:
            bad = middle
    return good


def drive_value(run: Run, time: float) -> dict[str, Any]:
    """The first drive's value at a time, in the model's unit: drive, value, unit."""
    name = run.compiled.graph.drives[0]
    dimension = u.ANGLE if run.compiled.mechanism.drives[name].turns else u.LENGTH
    unit, size = run.compiled.quantities.unit_of(dimension)
    value = float(np.asarray(run.compiled.laws[name](np.array([time])).d[0]).flat[0])
    return {"drive": name, "value": f"{value / size:.6g}", "unit": unit}


def _cannot_assemble(run: Run, group: Group, start: float, stop: float, worst: float) -> Finding:
    compiled = run.compiled
    values = {name: float(np.asarray(law(np.array([worst])).d[0]).flat[0]) for name, law in compiled.laws.items()}
    distance, limit = shortfall_at(compiled.quantities, compiled.structure, compiled.assembly.branches, values, group)
    data = shortfall_data(compiled.quantities, group, distance, limit)
    ends = [drive_value(run, time) for time in (start, stop)]
    data |= {"length_unit": data["unit"], "drive": ends[0]["drive"], "unit": ends[0]["unit"]}
    data |= {"from": ends[0]["value"], "to": ends[1]["value"], "start": start, "stop": stop}
    return Finding("motion.cannot-assemble", ("links", group.links[0]), data)


def singular(run: Run, nearest: Nearest | None) -> list[Finding]:
    """A finding where the run passes through a singular pose of a group."""
    if nearest is None or nearest.determinant > SINGULAR:
        return []
    data = {
        "group": nearest.group,
        "time": f"{nearest.time:.6g}",
        "determinant": f"{nearest.determinant:.2g}",
    }
    link = nearest.group.split("-")[0]
    return [Finding("motion.singular", ("links", link), data | drive_value(run, nearest.time))]
