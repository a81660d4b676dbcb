"""The files of wanted paths: the laws of the drives as CSV, and as text to paste into the model file."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator
from typing import Any

import numpy as np

from linkwright.escape import line
from linkwright.expressions import units as u
from linkwright.findings import Said
from linkwright.model.csv_text import cell, head, table_text
from linkwright.model.yaml_write import write_text
from linkwright.studies.workspace.inverse_kinematics import ServoLaw
from linkwright.studies.workspace.outcome import WorkspaceOutcome, in_units, values_text
from linkwright.studies.workspace.path_outcome import Attempt, PathsOutcome
from linkwright.studies.workspace.yaml_snippet import pasted

CLOSE = 1e-8
"""How near tables come to the law (rad or m)."""
MOVED = {"turns", "slides", "extends", "on_"}
"""The fields of a drive that say what it moves."""
TURNING, SLIDING = ("angle", "omega", "alpha", "torque", "power"), ("s", "v", "a", "force", "power")


def laws_csv(outcome: WorkspaceOutcome) -> str | None:
    """Both drives over the time for each path in each region that lets it be followed."""
    part: PathsOutcome = outcome.parts["paths"]
    found = [(one, one.law) for one in part.attempts if one.law is not None]
    if not found:
        return None
    quantities = outcome.compiled.quantities
    unit, time_unit = quantities.unit_of(u.LENGTH)[0], quantities.unit_of(u.TIME)[0]
    names = [*outcome.options.for_]
    heads = ["path", *(head(n, quantities.unit_of(quantities.dimensions.of(n))[0]) for n in names), "mode"]
    heads += [head("t", time_unit), "u", head(f"{outcome.point}.x", unit), head(f"{outcome.point}.y", unit)]
    for drive in outcome.compiled.graph.drives:
        rows = TURNING if outcome.compiled.mechanism.prescribed(drive).turns else SLIDING
        units = [its for its, _ in part.units(drive).values()]
        heads += [head(f"{drive}.{row}", its) for row, its in zip(rows, units, strict=False)]
    return table_text(heads, _rows(part, found, names))


def _rows(part: PathsOutcome, found: list[tuple[Attempt, ServoLaw]], names: list[str]) -> Iterator[list[str]]:
    quantities = part.compiled.quantities
    size, second = quantities.unit_of(u.LENGTH)[1], quantities.unit_of(u.TIME)[1]
    for one, law in found:
        values = in_units(part.compiled, one.workspace.values)
        front = [one.name, *(cell(values[name]) for name in names), one.reached.mode]
        columns = [law.t / second, law.u, *(law.point / size)]
        for drive in part.compiled.graph.drives:
            k = law.names.index(drive)
            rows = [*(law.motor, law.servo)[k]]
            if law.efforts is not None:
                rows += [law.efforts.effort[k], law.efforts.power[k]]
            scales = [scale for _, scale in part.units(drive).values()]
            columns += [row / scale for row, scale in zip(rows, scales, strict=False)]
        for row in np.stack(columns, axis=1).tolist():
            yield [*front, *map(cell, row)]


def drives_yaml(outcome: WorkspaceOutcome) -> str | None:
    """For the best way of each path that can be followed, a document with the entries of a model file by which its
    point moves along the path."""
    part: PathsOutcome = outcome.parts["paths"]
    texts = [_entries(part, one, one.law) for one in part.best.values() if one.law is not None]
    return "---\n".join(texts) or None


def _entries(part: PathsOutcome, one: Attempt, law: ServoLaw) -> str:
    compiled = part.compiled
    mechanism = compiled.mechanism
    units = tuple("rad" if mechanism.prescribed(name).turns else "m" for name in law.names)
    made = pasted(law, (units[0], units[1]), constant=one.constant, close=CLOSE)
    drives: dict[str, Any] = {}
    for name, entry in made.drives.items():
        stated = mechanism.drives[name].model_dump(by_alias=True, exclude_none=True, include=MOVED)
        drives[name] = stated | entry
    rules = dict(rule.split(": ", 1) for rule in one.reached.mode.split("; ") if ": " in rule)
    values = {
        name: f"{value!r} {compiled.quantities.unit_of(compiled.quantities.dimensions.of(name))[0]}".strip()
        for name, value in in_units(compiled, one.workspace.values).items()
    }
    sections = {"parameters": values, "assembly": rules, "tables": made.tables, "drives": drives}
    about = [Said("paths.pasted", point=part.point, path=one.name), one.reached.mode]
    about.append(values_text(compiled, one.workspace.values))
    time, unit = f"{law.t[-1]:.9g}", " / ".join(dict.fromkeys(units))
    about.append(Said("paths.pasted.off", off=f"{made.off:.2g}", unit=unit, time=time))
    about.append(Said("paths.pasted.period", time=time) if law.period else "")
    comment = "\n".join(f"# {row}" for text in about if text for row in textwrap.wrap(line(str(text)), 110))
    return f"{comment}\n{write_text({key: entries for key, entries in sections.items() if entries})}"
