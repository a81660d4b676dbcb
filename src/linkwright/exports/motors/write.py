"""A drive as a motor, and motors as a sheet to type from, a table of expressions, a table of values."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from linkwright.exports.motors.dialect import line
from linkwright.exports.motors.evaluate import value
from linkwright.exports.motors.pieces import Piece
from linkwright.exports.motors.terms import number
from linkwright.kernels import Compiled
from linkwright.model import units as u
from linkwright.report.csv_text import cell, head, written
from linkwright.words import say

Array = NDArray[np.float64]

LOOKS = (1 - np.cos(np.pi * (np.arange(24) + 0.5) / 24)) / 2
"""Where in each piece its text is held to the law, as shares of it: closer at the ends, without these."""


@dataclass(frozen=True)
class Row:
    """One piece: a text that holds from ``start`` to ``stop``, times in s as text."""

    start: str
    stop: str
    text: str


@dataclass(frozen=True)
class Motor:
    """A drive as a motor: its pieces in a ``unit`` of this ``size``; the ``error`` of the texts, in the unit."""

    drive: str
    unit: str
    size: float
    rows: tuple[Row, ...]
    error: float

    @property
    def domains(self) -> list[str]:
        """The domain of each piece as Creo takes it; the last one has its end in it."""
        last = len(self.rows) - 1
        return [f"{r.start} <= t {'<=' if i == last else '<'} {r.stop}" for i, r in enumerate(self.rows)]


def unit_of(compiled: Compiled, drive: str) -> tuple[str, float]:
    """The unit of a drive's value: degrees, or the file's unit of length."""
    angle = compiled.quantities.drive_dimension(drive) == u.ANGLE
    return ("deg", np.pi / 180) if angle else compiled.quantities.unit_of(u.LENGTH)


def motor(compiled: Compiled, drive: str, pieces: Sequence[Piece], dialect: str, stop: float) -> Motor:
    """The texts of a drive's pieces, read again and held to its law."""
    unit, size = unit_of(compiled, drive)
    rows = tuple(Row(number(p.start), number(p.stop), line(p.formula, size, dialect, stop)) for p in pieces)
    error = 0.0
    for row in rows:
        t = float(row.start) + LOOKS * (float(row.stop) - float(row.start))
        with np.errstate(all="ignore"):
            off = np.abs(value(row.text, t, dialect == "creo") - compiled.laws[drive](t).d[0] / size)
        error = max(error, float(np.nan_to_num(off, nan=np.inf).max()))
    return Motor(drive, unit, size, rows, error)


def sheet(compiled: Compiled, motors: Sequence[Motor], dialect: str, stop: float) -> str:
    """All motors to be read, each line a domain and its expression."""
    name = compiled.mechanism.name
    lines = [say("motors.title", name=name), say("motors.time", stop=number(stop)), say(f"motors.dialect.{dialect}")]
    for made in motors:
        drive = compiled.mechanism.prescribed(made.drive)
        key = "output" if compiled.mechanism.drives[made.drive].output else "turns" if drive.turns else "slides"
        what = say(f"motors.{key}", link=drive.link, on=drive.on, drive=made.drive)
        error = f"{made.error:.1e}"
        lines += ["", say("motors.head", drive=made.drive, what=what, unit=made.unit, error=error)]
        wide = max(map(len, made.domains))
        lines += [f"  {d:{wide}}   {row.text}" for d, row in zip(made.domains, made.rows, strict=True)]
    return "\n".join(lines) + "\n"


def expressions(motors: Sequence[Motor]) -> str:
    """All pieces as a table."""
    rows = ([m.drive, m.unit, r.start, r.stop, r.text] for m in motors for r in m.rows)
    return written(["drive", "unit", head("from", "s"), head("to", "s"), "expression"], rows)


def values(compiled: Compiled, t: Array) -> str:
    """All drives' values over time as a table."""
    drives = list(compiled.mechanism.drives)
    units = [unit_of(compiled, drive) for drive in drives]
    columns = [
        np.broadcast_to(compiled.laws[d](t).d[0], t.shape) / size for d, (_, size) in zip(drives, units, strict=True)
    ]
    heads = [head("t", "s"), *(head(drive, unit) for drive, (unit, _) in zip(drives, units, strict=True))]
    return written(heads, ([cell(float(number)) for number in row] for row in np.vstack([t, *columns]).T))
