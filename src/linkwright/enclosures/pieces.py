"""Functions in pieces, motion laws and tables, of Taylor models: the piece in each panel's middle, and by how much the
one beside it differs where the panel reaches into it."""

from __future__ import annotations

from collections.abc import Callable
from math import perm
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.enclosures.functions import wave
from linkwright.enclosures.taylor import TaylorModel, along, lift
from linkwright.laws import Motion, TableLaw
from linkwright.laws.pieces import Formula, Piece
from linkwright.notation import Jet

Array = NDArray[np.float64]
Whole = NDArray[np.int64]
PieceDerivative = Callable[[Whole, TaylorModel, int], TaylorModel]
"""A derivative of a piece, of each panel the one of a number (panels,), at a place within one period."""

AWAY = 1e100
"""The edge of what goes on for ever."""


@dataclass(frozen=True)
class Pieces:
    """Pieces between ascending ``edges`` (n + 1,), with a ``period`` over and over, each time higher by ``advance``;
    without one the outer values are held up to ``slack`` beyond the outer edges."""

    edges: Array
    derivative: PieceDerivative
    period: float | None = None
    advance: float = 0.0
    slack: float = 0.0

    def at(self, x: TaylorModel, order: int) -> TaylorModel:
        """A derivative at the values of a model; undecided on panels that reach over more than two pieces, or out of
        the outer ones."""
        n, places = len(self.edges) - 1, x.c[0].astype(float)
        sound = np.isfinite(places)
        places = np.where(sound, places, self.edges[0])
        whole = np.floor((places - self.edges[0]) / self.period) if self.period is not None else np.zeros(places.shape)
        which = np.searchsorted(self.edges[1:-1], places - whole * (self.period or 0.0), side="right")
        number = (whole * n + which).astype(np.int64)
        found = self._piece_derivative(number, x, order)
        r = np.where(sound, found.r, np.nan)
        for side in (-1, 1):
            inside = side * (self._edge(number, side, x) - x)
            over = np.flatnonzero(inside.sign() <= 0)
            if over.size:
                some = _selected_panels(x, over)
                r[over] = r[over] + self._beyond(number[over], side, some, order, _selected_panels(found, over))
        return TaylorModel(found.c, r, x.on)

    def _beyond(self, number: Whole, side: int, x: TaylorModel, order: int, found: TaylorModel) -> Array:
        """By how much the function may differ from a piece on panels that reach over one of its edges."""
        n, beside = len(self.edges) - 1, number + side
        outer = (self.period is None) & ((beside < 0) | (beside >= n))
        inner = np.where(outer, number, beside)
        other = np.broadcast_to((self._piece_derivative(inner, x, order) - found).magnitude_bound, number.shape)
        clear = (side * (self._edge(inner, side, x) - x)).sign() > 0
        off = np.where(clear, other, np.nan)
        if outer.any():
            near = (side * (self._edge(number, side, x) - x) + self.slack).sign() > 0
            off = np.where(
                outer,
                np.where(near, self._piece_derivative(number, x, order + 1).magnitude_bound * (2 * self.slack), np.nan),
                off,
            )
        return off

    def _edge(self, number: Whole, side: int, x: TaylorModel) -> TaylorModel:
        """The lower (-1) or upper (1) edge of pieces."""
        shift, piece = np.divmod(number, len(self.edges) - 1)
        return panel_numbers(self.edges[piece + (side > 0)] + shift * (self.period or 0.0), x)

    def _piece_derivative(self, number: Whole, x: TaylorModel, order: int) -> TaylorModel:
        shift, piece = np.divmod(number, len(self.edges) - 1)
        if self.period is not None:
            x = x - panel_numbers(shift * self.period, x)
        found = self.derivative(piece, x, order)
        return found + panel_numbers(shift * self.advance, x) if order == 0 and self.advance else found


def panel_numbers(values: Array, like: TaylorModel) -> TaylorModel:
    """A number of each panel."""
    return TaylorModel(np.asarray(values, dtype=float)[None], np.zeros(np.shape(values)), like.on)


def _selected_panels(x: TaylorModel, which: NDArray[np.intp]) -> TaylorModel:
    on = x.on.select(which) if x.on is not None else None
    wide = max(x.c.shape[1], x.r.size)
    return TaylorModel(np.broadcast_to(x.c, (len(x.c), wide))[:, which], np.broadcast_to(x.r, wide)[which], on)


@along.register
def _(function: Motion, x: TaylorModel, order: int, integral: bool = False) -> TaylorModel:
    """A derivative of a motion law at the values of a model."""
    return of_motion(function).at(x, order)


@along.register
def _(function: TableLaw, x: TaylorModel, order: int, integral: bool = False) -> TaylorModel:
    """A derivative of a table, or its integral, at the values of a model."""
    return of_table(function, integral).at(x, order)


def of_motion(motion: Motion) -> Pieces:
    """The pieces of a motion law."""
    parts: list[Any] = [*motion.curve.parts]
    edges = [part.start for part in parts] + [motion.period]
    if motion.beyond == "hold":
        first, last = (float(parts[i].at(np.array([at]), 0)[0]) for i, at in ((0, 0.0), (-1, motion.period)))
        parts = [Piece(-AWAY, 0.0, (first,)), *parts, Piece(motion.period, AWAY, (last,))]
        return Pieces(np.array([-AWAY, *edges, AWAY]), _part_derivatives(parts))
    advance = float(motion.advance) if motion.beyond == "advance" else 0.0
    return Pieces(np.array(edges), _part_derivatives(parts), float(motion.period), advance)


def _part_derivatives(parts: list[Any]) -> PieceDerivative:
    """The parts of a motion law: all panels at once where they have closed forms, formulas one by one."""
    closed = [part if isinstance(part, Piece) else Piece(part.start, part.stop) for part in parts]
    origins = np.array([part.origin for part in closed])
    powers = np.zeros((len(parts), max(len(part.powers) for part in closed)))
    waves = np.zeros((max(len(part.waves) for part in closed), 3, len(parts)))
    for i, part in enumerate(closed):
        powers[i, : len(part.powers)] = part.powers
        for k, one in enumerate(part.waves):
            waves[k, :, i] = one
    formulas = [i for i, part in enumerate(parts) if isinstance(part, Formula)]

    def derivative(which: Whole, x: TaylorModel, order: int) -> TaylorModel:
        z = x - panel_numbers(origins[which], x)
        total = _polynomial(powers[which], z, order)
        for amplitude, rate, even in waves[:, :, which]:
            size = amplitude * (rate * np.pi) ** order
            turned = wave(np.pi * (panel_numbers(rate, x) * z), order + even.astype(int))
            total = total + panel_numbers(size, x) * turned
        for i in formulas:
            here = np.flatnonzero(which == i)
            if here.size:
                total = _with_panels(total, here, _formula(parts[i], _selected_panels(x, here), order), which.size)
        return total

    return derivative


def _polynomial(powers: Array, z: TaylorModel, order: int) -> TaylorModel:
    """A derivative of polynomials (panels, powers)."""
    total = panel_numbers(np.zeros(len(powers)), z)
    for i in range(powers.shape[1] - 1, order - 1, -1):
        total = total * z + panel_numbers(perm(i, order) * powers[:, i], z)
    return total


def _formula(part: Formula, x: TaylorModel, order: int) -> TaylorModel:
    u = (x - part.offset) / part.width
    value = part.function(Jet([u, 1.0, *[0.0] * max(0, order - 1)]).truncated(order)).d[order]
    found = lift(part.scale / part.width**order * value)
    return found + part.base if order == 0 else found


def _with_panels(into: TaylorModel, here: NDArray[np.intp], one: TaylorModel, count: int) -> TaylorModel:
    """One model's panels within another."""
    c = np.zeros((max(len(into.c), len(one.c)), count), dtype=np.result_type(into.c, one.c))
    c[: len(into.c)] = into.c
    c[:, here] = 0.0
    c[: len(one.c), here] = one.c
    r = np.broadcast_to(into.r, count).copy()
    r[here] = one.r
    return TaylorModel(c, r, into.on)


def of_table(table: TableLaw, integral: bool = False) -> Pieces:
    """The pieces of a table's spline, or of its integral."""
    knots, powers = table.powers()
    advance = 0.0
    if integral:
        whole = table._spline.antiderivative()
        rows = powers / np.arange(1, powers.shape[1] + 1)
        powers = np.column_stack([whole(knots[:-1]) - whole(table.x[0]), rows])
        if table.period is not None:
            advance = float(whole(table.x[0] + table.period) - whole(table.x[0]))

    def derivative(which: Whole, x: TaylorModel, order: int) -> TaylorModel:
        return _polynomial(powers[which], x - panel_numbers(knots[which], x), order)

    return Pieces(knots, derivative, table.period, advance, 1e-12 * float(table.x[-1] - table.x[0]))
