"""Functions given by points: linear, cubic or quintic splines, periodic or not."""

from __future__ import annotations

from dataclasses import field
from math import perm
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.laws.curve import composed, switched
from linkwright.notation import Jet
from linkwright.notation.duals import Dual, value_of
from linkwright.notation.jets import call, symbolic

Array = NDArray[np.float64]

DEGREES = {"linear": 1, "cubic": 3, "quintic": 5}


class OutsideTable(ValueError):
    """An argument beyond a table's range; ``at`` is that argument, ``low`` and ``high`` the range, in SI."""

    def __init__(self, at: float, low: float, high: float) -> None:
        super().__init__(f"{at} is outside {low} .. {high}")
        self.at, self.low, self.high = at, low, high


@dataclass(frozen=True)
class TableLaw:
    """An interpolant through points (x, y) with ascending x, exact with its derivatives.

    ``period`` closes it (the first y is repeated one period on); outside the range of an open table
    :class:`OutsideTable` is raised. The spline has ``degree - 1`` continuous derivatives. Raises LinAlgError where
    points lie so close together that none goes through them.
    """

    x: Array
    y: Array
    degree: int = 3
    period: float | None = None
    _spline: Any = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        from scipy.interpolate import make_interp_spline

        x, y = self.x, self.y
        if self.period is not None and not np.isclose(x[-1] - x[0], self.period, rtol=1e-12):
            x, y = np.append(x, x[0] + self.period), np.append(y, y[0])
        periodic = "periodic" if self.period is not None and self.degree > 1 else None
        spline = make_interp_spline(x, y, k=self.degree, bc_type=periodic)
        if not np.isfinite(spline.c).all():
            raise np.linalg.LinAlgError
        object.__setattr__(self, "_spline", spline)

    def __call__(self, x: Jet) -> Jet:
        """The value with its time derivatives, from those of the argument."""
        if hasattr(x.d[0], "along") or symbolic(x.d[0]):
            return self.or_nan(x)
        given = _number(x)
        at = self._within(given)
        outside = np.isnan(at) & ~np.isnan(given)
        if np.any(outside):
            raise OutsideTable(float(given[outside].flat[0]), float(self.x[0]), float(self.x[-1]))
        return self._compose(x, at, 0)

    def or_nan(self, x: Jet) -> Jet:
        """The same, NaN outside an open table; enclosures follow it by their own ``along``, symbols as expressions."""
        if symbolic(x.d[0]):
            return composed(x, self._expression)
        if hasattr(x.d[0], "along"):
            return composed(x, lambda places, order: places.along(self, order))
        return self._compose(x, self._within(_number(x)), 0)

    def integral(self, x: Jet) -> Jet:
        """The integral from the first point on, exact with its derivatives; NaN outside an open table."""
        if (own := getattr(x.d[0], "along", None)) is not None:
            return x.chain(own(self, 0, True), self.or_nan)
        given = _number(x)
        whole = self._spline.antiderivative()
        value = whole(self._within(given)) - whole(self.x[0])
        if self.period is not None:
            each = whole(self.x[0] + self.period) - whole(self.x[0])
            value = value + each * np.floor_divide(given - self.x[0], self.period)
        if isinstance(x.d[0], Dual):
            value = Dual(value, self._derivative_at(self._within(given), 0) * x.d[0].slope)
        return x.chain(value, self.or_nan)

    def powers(self) -> tuple[Array, Array]:
        """The spline as polynomials: its knots (n + 1,), and between each two of them the coefficients of the powers of
        what the argument is past the first, (n, degree + 1), lowest first."""
        from scipy.interpolate import PPoly

        made = PPoly.from_spline(self._spline)
        wide = np.diff(made.x) > 0
        first, last = self.x[0], self.x[0] + self.period if self.period is not None else self.x[-1]
        wide &= (made.x[:-1] >= first) & (made.x[1:] <= last)
        return np.append(made.x[:-1][wide], made.x[1:][wide][-1]), made.c[::-1, wide].T

    def _expression(self, x: Any, order: int) -> Any:
        """A derivative at a symbol."""
        first, last = float(self.x[0]), float(self.x[-1])
        if self.period is not None:
            within = x - call("floor", (x - first) / self.period) * self.period
        else:
            slack = 1e-12 * (last - first)
            inside = call("logical_and", x >= first - slack, x <= last + slack)
            within = call("where", inside, call("fmin", call("fmax", x, first), last), np.nan)
        knots, powers = self.powers()
        pieces = []
        for start, row in zip(knots[:-1].tolist(), powers.tolist(), strict=True):
            total = 0.0
            for i in range(len(row) - 1, order - 1, -1):
                total = total * (within - start) + perm(i, order) * row[i]
            pieces.append((start, total))
        return switched(within, pieces)

    def _within(self, at: Array) -> Array:
        """The arguments brought into the table by whole periods; NaN outside an open one."""
        if self.period is not None:
            return np.asarray(self.x[0] + np.mod(at - self.x[0], self.period))
        slack = 1e-12 * (self.x[-1] - self.x[0])
        inside = (at >= self.x[0] - slack) & (at <= self.x[-1] + slack)
        return np.where(inside, np.clip(at, self.x[0], self.x[-1]), np.nan)

    def _derivative_at(self, at: Array, order: int) -> Array:
        """A derivative by the argument."""
        return self._spline(at, nu=order) if order <= self.degree else np.zeros_like(at)

    def _compose(self, x: Jet, at: Array, order: int) -> Jet:
        value: Any = self._derivative_at(at, order)
        if isinstance(x.d[0], Dual):
            value = Dual(value, self._derivative_at(at, order + 1) * x.d[0].slope)
        return x.chain(value, lambda low: self._compose(low, at, order + 1))


def _number(x: Jet) -> Array:
    return np.asarray(value_of(x.d[0]), dtype=float)
