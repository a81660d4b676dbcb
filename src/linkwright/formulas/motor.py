"""A motion as the motor of a CAD simulator: pieces with their texts, read again and held to the motion."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import pi

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions import units as u
from linkwright.formulas.dialect import line
from linkwright.formulas.evaluate import value
from linkwright.formulas.pieces import FormulaPiece
from linkwright.formulas.terms import number
from linkwright.model.quantities import Quantities

Array = NDArray[np.float64]

LOOKS = (1 - np.cos(np.pi * (np.arange(24) + 0.5) / 24)) / 2
"""Where in each piece its text is held to the law, as shares of it: closer at the ends, without these."""


@dataclass(frozen=True)
class MotorPiece:
    """One piece: a text that holds from ``start`` to ``stop``, times in s as text."""

    start: str
    stop: str
    text: str


@dataclass(frozen=True)
class MotorProgram:
    """A motion as a motor: its pieces in a ``unit`` of this ``size``; the ``error`` of the texts, in the unit."""

    unit: str
    size: float
    rows: tuple[MotorPiece, ...]
    error: float

    @property
    def domains(self) -> list[str]:
        """The domain of each piece as Creo takes it; the last one has its end in it."""
        last = len(self.rows) - 1
        return [f"{r.start} <= t {'<=' if i == last else '<'} {r.stop}" for i, r in enumerate(self.rows)]

    @property
    def lines(self) -> list[str]:
        """A line for each piece, to be typed: its domain and its text."""
        wide = max(map(len, self.domains))
        return [f"  {d:{wide}}   {row.text}" for d, row in zip(self.domains, self.rows, strict=True)]


def unit_of(quantities: Quantities, dimension: u.Dimension) -> tuple[str, float]:
    """The unit of a motor's value and its size: degrees, or the file's unit of length."""
    return ("deg", pi / 180) if dimension == u.ANGLE else quantities.unit_of(u.LENGTH)


def motor(
    pieces: Sequence[FormulaPiece], unit: tuple[str, float], motion: Callable[[Array], Array], dialect: str, stop: float
) -> MotorProgram:
    """The texts of a motion's pieces over 0 .. ``stop`` (s) in a unit; ``motion`` gives its values (SI)."""
    name, size = unit
    rows = tuple(MotorPiece(number(p.start), number(p.stop), line(p.formula, size, dialect, stop)) for p in pieces)
    error = 0.0
    for row in rows:
        t = float(row.start) + LOOKS * (float(row.stop) - float(row.start))
        with np.errstate(all="ignore"):
            off = np.abs(value(row.text, t, dialect == "creo") - motion(t) / size)
        error = max(error, float(np.nan_to_num(off, nan=np.inf).max()))
    return MotorProgram(name, size, rows, error)
