"""With one drive a point has a curve: its stretches over the drive's range, refined to a chord tolerance."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.kernels import Compiled
from linkwright.studies.workspace.mesh import RIM, halved
from linkwright.studies.workspace.sheet import ModeSheet

Array = NDArray[np.float64]

STEPS = 720
ROUNDS = 16


@dataclass(frozen=True)
class CurveStretch:
    """An unbroken piece of a curve: drive values (n,), places (2, n) in m; ``closed`` where its end is its start."""

    q: Array
    at: Array
    closed: bool

    @property
    def length(self) -> float:
        """Its length (m)."""
        return float(np.hypot(*np.diff(self.at)).sum())


@dataclass(frozen=True)
class CouplerCurve:
    """The curve of one assembly mode of a mechanism with one drive."""

    mode: str
    signs: tuple[float, ...]
    drive: str
    stretches: tuple[CurveStretch, ...]

    @property
    def length(self) -> float:
        """Its length (m)."""
        return sum(one.length for one in self.stretches)

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """Least x, least y, largest x, largest y (m)."""
        low = np.min([one.at.min(axis=1) for one in self.stretches], axis=0)
        high = np.max([one.at.max(axis=1) for one in self.stretches], axis=0)
        return float(low[0]), float(low[1]), float(high[0]), float(high[1])


def curve(
    compiled: Compiled,
    point: str,
    mode: str,
    signs: tuple[float, ...],
    parameters: Array,
    ends: tuple[float, float],
    turns: bool,
    chord: float,
) -> CouplerCurve:
    """The curve of a point over a drive's range."""
    (drive,) = compiled.graph.drives
    sheet: Any = ModeSheet(compiled, point, (drive,), signs, parameters)  # type: ignore[arg-type]

    def inside(q: Array) -> NDArray[np.bool_]:
        return np.asarray(sheet.place(q[None])[1] > RIM)

    q = np.linspace(*ends, STEPS + 1)
    known = inside(q)
    whole = bool(turns and known.all())
    if turns and not whole and known[0] and known[-1]:  # starts where it can't be assembled: no stretch is cut
        q = q + (q[np.flatnonzero(~known)[0]] - q[0])
        known = inside(q)
    edges = np.flatnonzero(np.diff(np.concatenate([[False], known, [False]]).astype(int))).reshape(-1, 2)
    stretches = []
    for first, after in edges.tolist():
        run = q[first:after]
        if first:
            run = np.concatenate([[_find_end(inside, q[first], q[first - 1])], run])
        if after < q.size:
            run = np.concatenate([run, [_find_end(inside, q[after - 1], q[after])]])
        stretches.append(_refined(sheet, run, chord, whole))
    return CouplerCurve(mode, signs, drive, tuple(stretches))


def _find_end(inside: Any, good: float, bad: float) -> float:
    return float(good + halved(lambda s: inside(good + s * (bad - good)), 1)[0] * (bad - good))


def _refined(sheet: Any, q: Array, chord: float, closed: bool) -> CurveStretch:
    """Steps halved until the middle of each lies within ``chord`` of its chord."""
    at = sheet.place(q[None])[0]
    for _ in range(ROUNDS):
        middle = (q[:-1] + q[1:]) / 2
        there = sheet.place(middle[None])[0]
        a, d = at[:, :-1], np.diff(at)
        square = (d * d).sum(axis=0)
        share = np.clip(((there - a) * d).sum(axis=0) / np.where(square > 0, square, 1.0), 0.0, 1.0)
        coarse = np.flatnonzero(np.hypot(*(there - a - share * d)) > chord)
        if not coarse.size:
            break
        q = np.insert(q, coarse + 1, middle[coarse])
        at = np.insert(at, coarse + 1, there[:, coarse], axis=1)
    return CurveStretch(q, at, closed)
