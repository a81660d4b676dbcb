"""What reductions ask of runs, of many samples, of deviations and of clearances: a protocol each."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.fields import Expression
from linkwright.reductions.derivative import Derivative, Local
from linkwright.reductions.figures import Figures, FoundFigure, Peak
from linkwright.reductions.grades import Grade

Array = NDArray[np.float64]
Interval = tuple[float, float]


class InRun(Protocol):
    """A measure's signal over the ``intervals`` (s) of its window in one run; values in SI, arrays (times,)."""

    @property
    def measure(self) -> Any:
        """The entry."""

    @property
    def intervals(self) -> list[Interval]:
        """Where it is measured, ascending; there is one."""

    @property
    def length(self) -> float:
        """How long the intervals are together (s)."""

    @property
    def stationary(self) -> Array:
        """The times at which the signal turns or may have a kink, over the whole run; in between it is monotone."""

    @property
    def searched(self) -> Grade:
        """The grade of what a search gives."""

    def values(self, t: Array) -> Array:
        """The signal at times."""

    def value_at(self, time: float) -> Peak:
        """The signal at one time; where only one of its sides has a value, that. Raises :class:`Unmeasured`."""

    def top(self) -> Peak:
        """The largest value, the first of equals."""

    def bottom(self) -> Peak:
        """The smallest value, the first of equals."""

    def mean(self, power: int = 1, rule: int = 0) -> float:
        """The mean over time of a power of the signal; by ``rule`` 1 on other nodes. Raises :class:`Unmeasured` where
        it grows without bound."""

    def magnitude(self) -> float:
        """The mean over time of the signal's magnitude."""

    def number(self, expression: Expression) -> float:
        """An expression of parameters of the kind of the signal."""

    def graded_figure(self, label: str, value: float, time: float | None = None, side: str = "") -> FoundFigure:
        """A figure as a search gives it."""

    def other(self, key: str) -> InRun:
        """Another of the measure's expressions (``also``) over the same intervals, sound all along."""

    def zeros(self, key: str) -> Array:
        """The times at which another expression is zero, of an angle modulo whole turns; ascending."""

    def inner(self, edge: float, side: int) -> float:
        """An end of an interval, moved off a jump there to the interval's side (0 before, 1 after)."""

    def signals(self, names: Sequence[str], t: Array) -> Array:
        """Signals by their names at times: (names, times)."""

    @property
    def grid(self) -> Array:
        """Times all over the intervals, ends included, as close as the run is looked at."""

    def turning(self, curve: Callable[[Array], tuple[Array, Array]]) -> Array:
        """The times at which a curve turns that is given by its value and rate at times, with the ends of the
        intervals."""


class InSamples(Protocol):
    """A measure's signal in many samples at once; values in SI, times in s, arrays (samples,), NaN where there is
    none."""

    @property
    def measure(self) -> Any:
        """The entry."""

    @property
    def length(self) -> Array:
        """How long each one's window is."""

    @property
    def window_ends(self) -> tuple[Array, Array]:
        """Where each one's window begins and ends."""

    def extreme(self, sign: float, key: str = "") -> Figures:
        """The largest values, or with the sign -1 the smallest, among the kind's ``needed_extremes``."""

    def mean(self, key: str = "") -> Array:
        """The mean over time of the kind's ``power`` of the signal, or of another expression among its ``averaged``."""

    def magnitude(self, key: str = "") -> Array:
        """The mean over time of the magnitude of that power."""

    def values(self, times: Array) -> Array:
        """The signal of each at a time of its own."""


class WithDeviations(Protocol):
    """A measure's signal with its exact derivatives by ``count`` deviations, about the ``nominal_run``."""

    @property
    def nominal_run(self) -> InRun:
        """The nominal run."""

    @property
    def count(self) -> int:
        """The number of deviations."""

    def extreme(self, sign: float) -> Derivative:
        """That of the largest value, or with the sign -1 of the smallest."""

    def integral(self, power: int, key: str = "") -> tuple[float, Array, float, Array]:
        """The integral of a power of the signal, or of another expression, with its derivative (deviations,); the
        window's length likewise."""

    def values_at(self, times: Sequence[float] | Array, key: str = "", rates: bool = True) -> Local:
        """The signal, or another expression, at times: one row."""

    def moves(self, time: float) -> Array | None:
        """How a time moves that is an end of the window or of a load (s per deviation); ``None`` where it is none."""

    def turns(self, time: float, key: str) -> Array:
        """How a time moves at which another expression turns or has a kink."""

    def number(self, expression: Expression) -> tuple[float, Array]:
        """An expression of parameters of the kind of the signal, with its derivative."""

    def signals(self, names: Sequence[str], times: Array) -> tuple[Array, Array]:
        """Signals by their names (names, times), and their derivatives (names, deviations, times)."""

    def same(self, a: float, b: float) -> bool:
        """Whether two times are one place."""


class WithPlay(Protocol):
    """A measure's signal by displacements in the joints with clearance, which may have any direction."""

    @property
    def deviations(self) -> WithDeviations:
        """By the displacements, whose directions are held."""

    @property
    def joints(self) -> int:
        """The number of joints."""

    def worst(self, slopes: Array) -> Array:
        """The most that each joint does, over all directions, to what has these slopes (displacements, n):
        (joints, n)."""

    def panels(self, a: float, b: float) -> tuple[Array, Array]:
        """Times and weights of quadrature over an interval."""
