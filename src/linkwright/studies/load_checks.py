"""Whether loads and springs have a value all along a run, springs stay within their lengths, contacts closed."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.elements.force import Acting
from linkwright.expressions import units as u
from linkwright.expressions.dimensions import argument
from linkwright.findings import Finding, Term
from linkwright.graph.geometry import Geometry
from linkwright.graph.rows import Named, TableArgument, effort
from linkwright.results import Run
from linkwright.results.stationary import stationary
from linkwright.studies.assembly_checks import drive_value

Array = NDArray[np.float64]

NEAR = 1e-9
"""Lengths closer than this share of the largest one count as equal."""


def undefined(run: Run) -> list[Finding]:
    """Loads, springs and the like that have no value somewhere, and those whose two ends meet."""
    if meeting := _meeting(run):
        return [finding_at(run, "spring.no-direction", one.path, t) for one, t in meeting]
    unknown = _without_value(run)
    return [
        _outside_table(run, one, bad) or finding_at(run, "load.not-finite", one.path, float(bad[0]))
        for one, bad in unknown
    ]


def outside_tables(run: Run) -> list[Finding]:
    """What has no value somewhere because a table of it is asked beyond its ends: of efforts that follow from reactions
    all are unknown there, whichever asks the table."""
    found = (_outside_table(run, one, bad) for one, bad in _without_value(run))
    return [finding for finding in found if finding is not None]


def outside_at_rest(run: Run) -> list[Finding]:
    """What resists, or loads, at standstill by a table that doesn't reach to speeds of 0: a warning for each."""
    compiled, found = run.compiled, []
    asked = [TableArgument(i) for i, lookup in enumerate(compiled.graph.actions.lookups) if lookup.at_rest]
    if not asked:
        return []
    t = telling_times(run, [])
    rows = compiled.evaluate(asked, t)
    for one in compiled.graph.actions.every:
        tables = compiled.graph.actions.needed_tables(one)
        own = [
            (index.index, row)
            for index, row in zip(asked, rows, strict=True)
            if compiled.graph.actions.lookups[index.index].table in tables
        ]
        found += [finding for index, row in own if (finding := _beyond_ends(run, one, index, row, t, "warning"))]
    return found


def _without_value(run: Run) -> list[tuple[Acting, Array]]:
    """What acts and has no value at some times (s), and these."""
    actions = run.compiled.graph.actions
    acting = [one for one in actions.every if one.kind.acts]
    if not acting:
        return []
    open_ = [i for i, k in enumerate(actions.lookups) if run.compiled.tables[k.table].period is None]
    t = telling_times(run, [TableArgument(i) for i in open_])
    values = run.compiled.evaluate([effort(one) for one in acting], t)
    unknown = ~np.isfinite(values)
    return [(one, t[bad]) for one, bad in zip(acting, unknown, strict=True) if bad.any()]


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
        t = telling_times(run, [signal])
        length = run.compiled.evaluate([signal], t)[0]
        over = np.maximum(low - length, length - high)
        worst = int(np.argmax(over))
        if over[worst] > NEAR * high:
            data = {"length": length[worst], "low": low, "high": high}
            shown = {key: f"{value / size:.6g}" for key, value in data.items()}
            findings.append(
                finding_at(run, "spring.outside-length", one.path, float(t[worst]), "warning", of=unit, **shown)
            )
    return findings


def contacts(run: Run) -> list[Finding]:
    """Warnings on contacts that would have to pull, and what kinds of followers find of themselves."""
    m, topology, findings = run.compiled.mechanism, run.compiled.structure.topology, list[Finding]()
    for name, follower in m.followers.items():
        codes = dict.fromkeys(follower.one_sided, follower.lifts)
        findings += _lifted(run, m.path_of(name), follower.one_sided, follower.title, codes)
    for name, follower in m.followers.items():
        findings += follower.findings(RunMotion(run), m.path_of(name))
    for name, joint in m.joints_but_pins():
        findings += _lifted(run, ("joints", name), joint.one_sided, topology.kind_of(name).title, joint.lifts)
    return findings


def _lifted(
    run: Run, path: tuple[str, str], one_sided: Mapping[str, int], kind: Term, codes: Mapping[str, str]
) -> Iterator[Finding]:
    """A warning for each contact of a joint whose links would have to pull each other, where they pull hardest."""
    for attribute, sign in one_sided.items():
        signal = f"{path[1]}.{attribute}"
        signals = run.compiled.quantities.signals
        if signals.undetermined and signal not in signals.by_text:
            continue  # by how much it presses isn't known
        t, force = RunMotion(run).row(signal)
        worst = int(np.argmin(sign * force))
        pull = -sign * float(force[worst])
        if pull > NEAR * np.abs(force).max():
            unit, size = run.compiled.quantities.unit_of(run.dimension(signal))
            data = {"joint": path[1], "kind": kind, "force": f"{pull / size:.6g}", "of": unit}
            yield finding_at(run, codes.get(attribute, "joint.lifts-off"), path, float(t[worst]), "warning", **data)


class RunMotion:
    """A motion that was followed, as kinds of followers ask for it."""

    def __init__(self, run: Run) -> None:
        self.run, self.motions = run, run.compiled.motions
        self.geometry = Geometry(run.compiled.quantities, run.compiled.quantities.parameters)

    def row(self, signal: str) -> tuple[Array, Array]:
        """Times (s), those among them at which a signal is least and greatest, and its values there (SI)."""
        t, (values,) = self.rows([signal])
        return t, values

    def rows(self, signals: Sequence[str]) -> tuple[Array, Array]:
        """The same of some signals: times, and the values of all there (signals, times)."""
        t = telling_times(self.run, signals)
        return t, self.run.compiled.evaluate(signals, t)


def _meeting(run: Run) -> list[tuple[Acting, float]]:
    """What acts along the line of two points that meet, and when."""
    found = []
    for one in run.compiled.graph.actions.every:
        if attribute := one.kind.distance(one.entry):
            t = telling_times(run, [f"{one.name}.{attribute}"])
            length = run.compiled.evaluate([f"{one.name}.{attribute}"], t)[0]
            if not length.min() > NEAR * length.max():
                found.append((one, float(t[np.argmin(length)])))
    return found


def telling_times(run: Run, rows: Sequence[Named]) -> Array:
    """Times that tell where rows are smallest and largest."""
    turning = stationary(partial(run.compiled.rates, rows), run.start, run.stop, run.grid) if rows else []
    grid = np.linspace(run.start, run.stop, run.grid + 1)
    return np.unique(np.concatenate([grid, run.t, run.jumps.ravel(), *turning]))


def _outside_table(run: Run, one: Acting, bad: Array) -> Finding | None:
    """A table that something asks for what it doesn't hold at some times (s)."""
    compiled = run.compiled
    tables = compiled.graph.actions.needed_tables(one)
    for i, lookup in enumerate(compiled.graph.actions.lookups):
        table = compiled.tables[lookup.table]
        if lookup.table not in tables or table.period is not None or lookup.at_rest:
            continue
        asked = compiled.evaluate([TableArgument(i)], bad)[0]
        if finding := _beyond_ends(run, one, i, asked, bad):
            return finding
    return None


def _beyond_ends(run: Run, one: Acting, index: int, asked: Array, t: Array, severity: str = "error") -> Finding | None:
    """Where a table without a period is asked furthest beyond its ends, of its arguments at times t (s)."""
    quantities, lookup = run.compiled.quantities, run.compiled.graph.actions.lookups[index]
    table = run.compiled.tables[lookup.table]
    over = np.maximum(table.x[0] - asked, asked - table.x[-1])
    if table.period is not None or not np.max(over, initial=0.0) > 0:
        return None
    worst = int(np.argmax(over))
    unit, size = quantities.unit_of(quantities.dimensions.of(argument(lookup.table)))
    values = zip(("at", "low", "high"), (float(asked[worst]), *table.x[[0, -1]]), strict=True)
    shown = {key: f"{value / size:.6g}" for key, value in values}
    code = "load.table-at-rest" if lookup.at_rest else "load.outside-table"
    return finding_at(run, code, one.path, float(t[worst]), severity, table=lookup.table, of=unit, **shown)


def finding_at(
    run: Run, code: str, path: tuple[str, str], time: float, severity: str = "error", **data: Any
) -> Finding:
    """A finding at a time, with the first drive's value there."""
    return Finding(code, path, data | {"time": f"{time:.6g}"} | drive_value(run, time), severity=severity)
