"""A law for the drives as text for a model file: tables and positions by which the file moves along the path."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.laws import TableLaw
from linkwright.notation import Jet
from linkwright.studies.workspace.inverse_kinematics import ServoLaw

Array = NDArray[np.float64]

FIRST, MOST = 32, 4096
"""Pieces of a table: they are doubled until it is close enough."""


@dataclass(frozen=True)
class Pasted:
    """``tables`` and ``drives`` are entries of a model file; ``off`` is how far the tables lie off the law at the worst
    (rad or m), found between their points. Replace ``position``, ``speed`` and ``start`` of the drives by these."""

    tables: dict[str, Any]
    drives: dict[str, dict[str, Any]]
    off: float


def pasted(law: ServoLaw, units: tuple[str, str], constant: bool, close: float = 1e-8) -> Pasted:
    """The law as quintic tables over the time, within ``close`` (rad or m) of it.

    ``units`` are the SI units of both drives' values ("rad" or "m"). With ``constant`` the motor has its speed and
    start and only the servo a table. A law with a period becomes a periodic table beside a constant speed.
    """
    tables: dict[str, Any] = {}
    drives: dict[str, dict[str, Any]] = {}
    off = 0.0
    for k, (name, unit) in enumerate(zip(law.names, units, strict=True)):
        if k == 0 and constant:
            speed, start = float(law.motor[1, 0]), float(law.motor[0, 0])
            drives[name] = {"speed": f"{speed!r} {unit}/s", "start": f"{start!r} {unit}"}
            continue
        points, drift, worst = _table(law, k, close)
        off = max(off, worst)
        table = f"{name}_law"
        tables[table] = {
            "points": [[f"{x!r} s", f"{y!r} {unit}"] for x, y in points.tolist()],
            "between": "quintic",
            **({"period": f"{law.period!r} s"} if law.period else {}),
        }
        drives[name] = {"position": f"{table}(t) + t*({drift!r} {unit}/s)" if drift else f"{table}(t)"}
    return Pasted(tables, drives, off)


def _table(law: ServoLaw, k: int, close: float) -> tuple[Array, float, float]:
    """A table's points, the constant speed beside it, and how far it is off at the worst."""
    time = float(law.t[-1])
    ends = law.at(law.t[[0, -1]])[0][0, k]
    drift = float(ends[1] - ends[0]) / time if law.period else 0.0
    drift = 0.0 if abs(drift * time) < 1e-6 else drift
    pieces = FIRST
    while True:
        t = np.linspace(0.0, time, 2 * pieces + 1)
        y = law.at(t)[0][0, k] - drift * t
        if law.period:
            y[-1] = y[0]
        table = TableLaw(t[::2], y[::2], 5, law.period)
        off = float(np.abs(np.asarray(table(Jet([t])).d[0]) - y).max())
        if off <= close or 2 * pieces > MOST:
            return np.stack([t[::2], y[::2]], axis=1), drift, off
        pieces *= 2
