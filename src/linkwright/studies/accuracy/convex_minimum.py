"""The minimum of a smooth convex function under convex conditions, with its multipliers, by an interior point method.

Newton's method on the conditions of Karush, Kuhn and Tucker with slacks, whose products with the multipliers are
driven to zero together (Boyd and Vandenberghe, *Convex Optimization*, 2004, 11.7; Nocedal and Wright, *Numerical
Optimization*, 2nd ed., 19.3). Problems are small: matrices are dense.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

SOLVED = 1e-13
"""Residuals below this share of the largest that was met are round-off."""
MOST_STEPS = 200
KEPT_BACK = 0.995
"""The share of the way to the nearest boundary that a step may go."""
CENTRED = 0.1
"""The share of the products of slacks and multipliers that a step aims at."""
DECREASE = 0.01
SHORTEST = 1e-12


class Values(NamedTuple):
    """The function and its conditions ``g(x) <= 0`` at a place: gradient (n,), g (m,) and its slopes (m, n); with
    multipliers the curvature of their sum (n, n)."""

    gradient: Array
    g: Array
    slopes: Array


class Convex(NamedTuple):
    """A convex function with conditions: its ``values`` at a place, and the curvature (n, n) of f + multipliers . g.

    ``start`` keeps all linear conditions with room to spare; these are then kept all the way.
    """

    start: Array
    values: Callable[[Array], Values]
    curvature: Callable[[Array, Array], Array]


class _Point(NamedTuple):
    """A place with its slacks and multipliers, and what is there."""

    x: Array
    slack: Array
    multipliers: Array
    values: Values

    def residuals(self, aim: float) -> tuple[Array, Array, Array]:
        """What is missed of stationarity, of the conditions, and of the products aimed at."""
        stationary = self.values.gradient + self.values.slopes.T @ self.multipliers
        return stationary, self.values.g + self.slack, self.slack * self.multipliers - aim

    def off(self, aim: float) -> float:
        """The size of all that is missed."""
        return float(np.sqrt(sum(float(part @ part) for part in self.residuals(aim))))


def minimum(problem: Convex) -> tuple[Array, Array]:
    """The place of the minimum (n,), and the multipliers (m,), as closely as round-off lets."""
    first = problem.values(problem.start)
    slack = np.where(first.g < 0, -first.g, 1.0)
    at = _Point(problem.start, slack, 1.0 / slack, first)
    largest = at.off(0.0)
    for _ in range(MOST_STEPS):
        largest = max(largest, float(np.abs(at.values.gradient).max(initial=0.0)))
        if at.off(0.0) <= SOLVED * largest:
            break
        aim = CENTRED * float(at.slack @ at.multipliers) / at.slack.size
        new = _stepped(problem, at, aim)
        if new is None:  # round-off leaves nothing to be gained
            break
        at = new
    return at.x, at.multipliers


def _stepped(problem: Convex, at: _Point, aim: float) -> _Point | None:
    """One step of Newton's method, halved until less is missed; ``None`` where no step does that."""
    stationary, missed, products = at.residuals(aim)
    ratio = at.multipliers / at.slack
    slopes = at.values.slopes
    matrix = problem.curvature(at.x, at.multipliers) + slopes.T @ (ratio[:, None] * slopes)
    right = -stationary - slopes.T @ ((at.multipliers * missed - products) / at.slack)
    move = np.linalg.lstsq(matrix, right, rcond=None)[0]
    slack_move = -missed - slopes @ move
    multiplier_move = -(products + at.multipliers * slack_move) / at.slack
    length = min(1.0, _reach(at.slack, slack_move), _reach(at.multipliers, multiplier_move))
    before = at.off(aim)
    while length > SHORTEST:
        x = at.x + length * move
        new = _Point(x, at.slack + length * slack_move, at.multipliers + length * multiplier_move, problem.values(x))
        if new.off(aim) <= (1 - DECREASE * length) * before:
            return new
        length /= 2
    return None


def _reach(values: Array, moves: Array) -> float:
    """How far positive values may go on along their moves."""
    falling = moves < 0
    return float((KEPT_BACK * values[falling] / -moves[falling]).min(initial=np.inf))
