"""The drives' motors as a sheet to type from, a table of expressions, a table of values."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from linkwright.elements.points import AXES
from linkwright.findings import Joined
from linkwright.formulas.motor import MotorProgram, unit_of
from linkwright.formulas.terms import number
from linkwright.kernels import Compiled
from linkwright.model.csv_text import head, numbers_text, table_text
from linkwright.words import say

Array = NDArray[np.float64]


def sheet(compiled: Compiled, motors: Mapping[str, MotorProgram], dialect: str, stop: float) -> str:
    """All motors, by their drives, to be read: each line a domain and its expression."""
    name = compiled.mechanism.title
    lines = [say("motors.title", name=name), say("motors.time", stop=number(stop)), say(f"motors.dialect.{dialect}")]
    for of, made in motors.items():
        lines += [
            "",
            say("motors.head", drive=of, what=_subject(compiled, of), unit=made.unit, error=f"{made.error:.1e}"),
            *made.lines,
        ]
    return "\n".join(lines) + "\n"


def _subject(compiled: Compiled, of: str) -> str:
    """What the law of a drive prescribes."""
    m, drive = compiled.mechanism, compiled.mechanism.prescribed(of)
    if of in m.drives and (path := m.path_law(of)) is not None:
        drives = m.path_drives(str(drive.output))
        axis = AXES[drives.index(of)]
        return say("motors.path", axis=axis, point=path.at, link=drive.link, on=drive.on, drives=Joined(drives))
    key = "output" if m.movers[of].output else "turns" if drive.turns else "point" if drive.moves else "slides"
    return say(f"motors.{key}", link=drive.link, on=drive.on, drive=of)


def expressions(motors: Mapping[str, MotorProgram]) -> str:
    """All pieces as a table; a blank keeps a spreadsheet from computing what begins with a sign."""
    rows = (
        [drive, m.unit, r.start, r.stop, " " * (r.text[0] in "+-") + r.text]
        for drive, m in motors.items()
        for r in m.rows
    )
    return table_text(["drive", "unit", head("from", "s"), head("to", "s"), "expression"], rows)


def values(compiled: Compiled, t: Array) -> str:
    """All drives' values over time as a table."""
    drives = list(compiled.mechanism.movers)
    units = [unit_of(compiled.quantities, compiled.quantities.drive_dimension(drive)) for drive in drives]
    columns = [
        np.broadcast_to(compiled.laws[d](t).d[0], t.shape) / size for d, (_, size) in zip(drives, units, strict=True)
    ]
    heads = [head("t", "s"), *(head(drive, unit) for drive, (unit, _) in zip(drives, units, strict=True))]
    return numbers_text(heads, np.vstack([t, *columns]))
