"""Whether loads and springs have a value all along a run, springs stay within their lengths, followers on cams."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.elements.cam_contact.second import sums
from linkwright.elements.force import Acting
from linkwright.expressions import units as u
from linkwright.expressions.dimensions import argument
from linkwright.findings import Finding
from linkwright.graph.rows import Named, TableArgument, effort
from linkwright.results import Run
from linkwright.results.stationary import stationary
from linkwright.studies.feasible import drive_value

Array = NDArray[np.float64]

NEAR = 1e-9
"""Lengths closer than this share of the largest one count as equal."""


def undefined(run: Run) -> list[Finding]:
    """Loads, springs and the like that have no value somewhere, and those whose two ends meet."""
    actions = run.compiled.graph.actions
    findings = [_at(run, "spring.no-direction", one.path, t) for one, t in _meeting(run)]
    acting = [one for one in actions.every if one.kind.acts]
    if findings or not acting:
        return findings
    open_ = [i for i, k in enumerate(actions.lookups) if run.compiled.tables[k.table].period is None]
    t = _times(run, [TableArgument(i) for i in open_])
    for one, values in zip(acting, run.compiled.evaluate([effort(one) for one in acting], t), strict=True):
        bad = t[~np.isfinite(values)]
        if bad.size:
            findings.append(_explained(run, one, bad))
    return findings


def outside(run: Run) -> list[Finding]:
    """A warning for each part that leaves the lengths that it allows, where it does so furthest."""
    quantities = run.compiled.quantities
    unit, size = quantities.unit_of(u.LENGTH)
    findings = []
    for one in run.compiled.graph.actions.every:
        if (limits := one.kind.limits(one.entry)) is None:
            continue
        low, high = (quantities.value(edge, u.LENGTH) for edge in limits.edges)
        signal = f"{one.name}.{limits.attribute}"
        t = _times(run, [signal])
        length = run.compiled.evaluate([signal], t)[0]
        over = np.maximum(low - length, length - high)
        worst = int(np.argmax(over))
        if over[worst] > NEAR * high:
            data = {"length": length[worst], "low": low, "high": high}
            shown = {key: f"{value / size:.6g}" for key, value in data.items()}
            findings.append(_at(run, "spring.outside-length", one.path, float(t[worst]), "warning", of=unit, **shown))
    return findings


def lifted(run: Run) -> list[Finding]:
    """A warning for each cam closed by force whose follower would have to be pulled, where it is pulled hardest."""
    unit, size = run.compiled.quantities.unit_of(u.FORCE)
    findings = []
    for name, cam in run.compiled.mechanism.cams.items():
        if cam.closed != "force":
            continue
        if (pulled := _pulled(run, f"{name}.force")) is not None:
            time, force = pulled
            data = {"cam": name, "force": f"{force / size:.6g}", "of": unit}
            findings.append(_at(run, "cam.lifts-off", ("cams", name), time, "warning", **data))
    return findings


def _pulled(run: Run, signal: str, sign: int = 1) -> tuple[float, float] | None:
    """When (s) a contact force, positive where it presses times ``sign``, would have to pull hardest, and with how much
    (N); ``None`` where it always presses."""
    t = _times(run, [signal])
    force = sign * run.compiled.evaluate([signal], t)[0]
    worst = int(np.argmin(force))
    pulls = force[worst] < -NEAR * np.abs(force).max()
    return (float(t[worst]), -float(force[worst])) if pulls else None


def unseated(run: Run) -> list[Finding]:
    """A warning for each joint with one flank whose links would have to pull each other, where they pull hardest."""
    unit, size = run.compiled.quantities.unit_of(u.FORCE)
    findings = []
    for name, joint in run.compiled.mechanism.joints_but_pins():
        for attribute, sign in joint.one_sided.items():
            if (pulled := _pulled(run, f"{name}.{attribute}", sign)) is not None:
                time, force = pulled
                kind = run.compiled.structure.topology.kind_of(name).title
                data = {"joint": name, "kind": kind, "force": f"{force / size:.6g}", "of": unit}
                findings.append(_at(run, "joint.lifts-off", ("joints", name), time, "warning", **data))
    return findings


def loose(run: Run) -> list[Finding]:
    """A warning for each yoke with play, in which the second contact would bear elsewhere."""
    unit, size = run.compiled.quantities.unit_of(u.LENGTH)
    findings = []
    for name, cam in run.compiled.mechanism.cams.items():
        if cam.closed != "yoke":
            continue
        spans = sums(run.compiled.motions[cam.law])
        if (play := float(np.ptp(spans))) > NEAR * np.abs(spans).max():
            data = {"cam": name, "play": f"{play / size:.6g}", "unit": unit}
            findings.append(Finding("cam.loose", ("cams", name), data, severity="warning"))
    return findings


def _meeting(run: Run) -> list[tuple[Acting, float]]:
    """What acts along the line of two points that meet, and when."""
    found = []
    for one in run.compiled.graph.actions.every:
        if attribute := one.kind.distance(one.entry):
            t = _times(run, [f"{one.name}.{attribute}"])
            length = run.compiled.evaluate([f"{one.name}.{attribute}"], t)[0]
            if not length.min() > NEAR * length.max():
                found.append((one, float(t[np.argmin(length)])))
    return found


def _times(run: Run, rows: Sequence[Named]) -> Array:
    """Times that tell where rows are smallest and largest."""
    turning = stationary(partial(run.compiled.rates, rows), run.start, run.stop, run.grid) if rows else []
    grid = np.linspace(run.start, run.stop, run.grid + 1)
    return np.unique(np.concatenate([grid, run.t, run.jumps.ravel(), *turning]))


def _explained(run: Run, one: Acting, bad: Array) -> Finding:
    """Why something has no value at some times: a table asked for what it doesn't hold, or else."""
    compiled, quantities = run.compiled, run.compiled.quantities
    tables = compiled.graph.actions.asked(one)
    for i, lookup in enumerate(compiled.graph.actions.lookups):
        table = compiled.tables[lookup.table]
        if lookup.table not in tables or table.period is not None:
            continue
        asked = compiled.evaluate([TableArgument(i)], bad)[0]
        over = np.maximum(table.x[0] - asked, asked - table.x[-1])
        if np.max(over, initial=0.0) > 0:
            worst = int(np.argmax(over))
            at, time = float(asked[worst]), float(bad[worst])
            unit, size = quantities.unit_of(quantities.dimensions.of(argument(lookup.table)))
            shown = {
                key: f"{value / size:.6g}"
                for key, value in zip(("at", "low", "high"), (at, *table.x[[0, -1]]), strict=True)
            }
            return _at(run, "load.outside-table", one.path, time, table=lookup.table, of=unit, **shown)
    return _at(run, "load.not-finite", one.path, float(bad[0]))


def _at(run: Run, code: str, path: tuple[str, str], time: float, severity: str = "error", **data: Any) -> Finding:
    """A finding at a time, with the first drive's value there."""
    return Finding(code, path, data | {"time": f"{time:.6g}"} | drive_value(run, time), severity=severity)
