"""Functions in pieces, motion laws and tables, of Taylor models: the piece in the panel's middle, and by how much those
beside it differ where the panel reaches into them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import perm
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.enclosures.taylor import ZERO, TaylorModel
from linkwright.laws import Motion, TableLaw
from linkwright.laws.pieces import Formula, Part
from linkwright.notation import Jet

Array = NDArray[np.float64]
Asked = Callable[[int, TaylorModel, int], Any]
"""A derivative of a piece (by its number) at a place within one period."""


@dataclass(frozen=True)
class Pieces:
    """Pieces between ascending ``edges`` (n + 1,), with ``period`` over and over, each time higher by ``advance``."""

    edges: Array
    asked: Asked
    period: float | None = None
    advance: float = 0.0
    slack: float = 0.0  # how far beyond the outer edges the outer values are held

    def at(self, x: TaylorModel, order: int) -> TaylorModel:
        """A derivative at the values of a model; undecided on panels that reach over more than three pieces, or out of
        the outer ones."""
        n = len(self.edges) - 1
        places = x.c[0]
        whole = np.zeros_like(places)
        if self.period is not None:
            with np.errstate(invalid="ignore"):
                whole = np.floor((places - self.edges[0]) / self.period)
        which = np.searchsorted(self.edges[1:-1], places - whole * (self.period or 0.0), side="right")
        number = (whole * n + which).astype(np.int64) if np.isfinite(whole).all() else np.zeros(places.shape, int)
        c, r, terms = [], [], 1
        order_of = np.argsort(number, kind="stable")
        cuts = np.flatnonzero(np.diff(number[order_of])) + 1
        for some in np.split(order_of, cuts):
            part = self._near(int(number[some[0]]), _some(x, some), order)
            terms = max(terms, len(part.c))
            c.append(np.broadcast_to(part.c, (len(part.c), some.size)))
            r.append(np.broadcast_to(part.r, some.shape))
        merged = np.zeros((terms, places.size), dtype=np.result_type(*c))
        bounds = np.empty(places.size, dtype=np.result_type(*r))
        for some, one, off in zip(np.split(order_of, cuts), c, r, strict=True):
            merged[: len(one), some] = one
            bounds[some] = off
        bounds[~np.isfinite(places)] = np.nan
        return TaylorModel(merged, bounds, x.on)

    def _near(self, number: int, x: TaylorModel, order: int) -> TaylorModel:
        """On panels whose middles lie in one piece."""
        n = len(self.edges) - 1
        found = self._one(number, x, order)
        r = np.broadcast_to(found.r, x.c[0].shape).copy()
        shift, piece = divmod(number, n)
        low, high = (self.edges[piece + k] + shift * (self.period or 0.0) for k in (0, 1))
        for beside, away in ((number - 1, x - low), (number + 1, high - x)):
            over = away.sign() <= 0
            if not over.any():
                continue
            last = self.period is None and not 0 <= beside < n
            if last:
                near = (away + self.slack).sign() > 0
                held = self._one(number, x, order + 1).bound * (2 * self.slack)
                r = np.where(over, np.where(near, r + held, np.nan), r)
                continue
            other = self._one(beside, x, order) - found
            r = np.where(over, r + other.bound, r)
            # Nor may it reach over the piece beside.
            k, one = divmod(beside, n)
            ends = [self.edges[one + i] + k * (self.period or 0.0) for i in (0, 1)]
            clear = ((x - ends[0]).sign() > 0) if beside < number else ((ends[1] - x).sign() > 0)
            r[over & ~clear & np.full_like(clear, not (self.period is None and one in (0, n - 1)))] = np.nan
        return TaylorModel(found.c, r, x.on)

    def _one(self, number: int, x: TaylorModel, order: int) -> TaylorModel:
        shift, piece = divmod(number, len(self.edges) - 1)
        found = self.asked(piece, x - shift * self.period if self.period is not None else x, order)
        found = found if isinstance(found, TaylorModel) else TaylorModel.number(found)
        return found + shift * self.advance if order == 0 else found


def _some(x: TaylorModel, which: NDArray[np.intp]) -> TaylorModel:
    on = x.on.some(which) if x.on is not None else None
    r = np.broadcast_to(x.r, x.c[0].shape)
    return TaylorModel(x.c[:, which], r[which], on)


def along(function: Motion | TableLaw, x: TaylorModel, order: int, integral: bool = False) -> TaylorModel:
    """A derivative of a motion law or a table, or a table's integral, at the values of a model."""
    pieces = of_motion(function) if isinstance(function, Motion) else of_table(function, integral)
    return pieces.at(x, order)


def of_motion(motion: Motion) -> Pieces:
    """The pieces of a motion law."""
    parts = motion.curve.parts
    edges = [part.start for part in parts] + [motion.period]
    if motion.beyond == "hold":
        first, last = float(parts[0].at(np.zeros(1), 0)[0]), float(parts[-1].at(np.array([motion.period]), 0)[0])

        def held(piece: int, x: TaylorModel, order: int) -> Any:
            if piece in (0, len(parts) + 1):
                return 0.0 if order else (first if piece == 0 else last)
            return _part(parts[piece - 1], x, order)

        return Pieces(np.array([-np.inf, *edges, np.inf]), held)
    advance = motion.advance if motion.beyond == "advance" else 0.0
    return Pieces(np.array(edges), lambda i, x, order: _part(parts[i], x, order), float(motion.period), advance)


def _part(part: Part, x: TaylorModel, order: int) -> Any:
    if not isinstance(part, Formula):
        return part.at(x, order)
    u = (x - part.offset) / part.width
    value = part.function(Jet([u, 1.0, *[0.0] * max(0, order - 1)]).cut(order)).d[order]
    found = part.scale / part.width**order * value
    return found + part.base if order == 0 else found


def of_table(table: TableLaw, integral: bool = False) -> Pieces:
    """The pieces of a table's spline, or of its integral."""
    knots, powers = table.powers()
    advance = 0.0
    if integral:
        whole = table._spline.antiderivative()
        rows = powers / np.arange(1, powers.shape[1] + 1)
        starts = whole(knots[:-1]) - whole(table.x[0])
        powers = np.column_stack([starts, rows])
        if table.period is not None:
            advance = float(whole(table.x[0] + table.period) - whole(table.x[0]))

    def asked(piece: int, x: TaylorModel, order: int) -> Any:
        z, total = x - knots[piece], ZERO
        for i in range(powers.shape[1] - 1, order - 1, -1):
            total = total * z + perm(i, order) * float(powers[piece, i])
        return total

    return Pieces(knots, asked, table.period, advance, 1e-12 * float(table.x[-1] - table.x[0]))
