"""Reductions to means of a signal over time: mean, root mean square, and the length of a path, its mean speed."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Sequence
from math import sqrt
from typing import Annotated, Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.fields import Expression, Name
from linkwright.expressions.typed_fields import Ref
from linkwright.expressions.units import LENGTH, SPEED
from linkwright.reductions.derivative import Derivative
from linkwright.reductions.entry import SIGNAL, Measure, OfPath
from linkwright.reductions.figures import Figures, FoundFigure
from linkwright.reductions.interpolant import integral
from linkwright.reductions.kind import MeasureKind, register
from linkwright.reductions.protocols import InRun, InSamples, WithDeviations, WithPlay
from linkwright.reductions.samples import OnSamples, SampledFigure, SampledFigures, SampledInputs

Array = NDArray[np.float64]

PANELS = 32
"""Panels of an interval on which squares of slopes are integrated, by Gauss and Legendre's rule."""
POINTS, WEIGHTS = np.polynomial.legendre.leggauss(8)


class _OfMean(MeasureKind):
    """A reduction that follows from the mean of a power of the signal."""

    power: ClassVar[int]
    differentiable = True

    @abstractmethod
    def figure(self, mean: Any, length: Any) -> Any:
        """The figure from the mean of the power over a window of this length (s); numbers or arrays."""

    def needed_extremes(self, measure: Any) -> Sequence[tuple[str, float]]:
        return ()

    def run_figures(self, run: InRun) -> tuple[FoundFigure, ...]:
        return (run.graded_figure("", float(self.figure(run.mean(self.power), run.length))),)

    def figures(self, samples: InSamples) -> dict[str, Figures]:
        return {"": Figures.anywhere(self.figure(samples.mean(), samples.length))}

    def sampled_inputs(self, measure: Any) -> SampledInputs:
        return SampledInputs({"": measure.signal})

    def sampled(self, samples: OnSamples) -> SampledFigures:
        """The integral of the cubics, or of their squares, is exact."""
        signal, square = samples.signal, self.power == 2

        def value(i: int, s: float) -> float:
            here = signal.at(i, s)
            return here * here if square else here

        mean = integral(samples.stretches, signal, value) / samples.length
        return {"": SampledFigure(float(self.figure(mean, samples.length)))}

    def clearance_bounds(self, found: WithPlay) -> list[Array]:
        """The directions are free at each time."""
        total, squares, size, length = np.zeros(found.joints), np.zeros(found.joints), 0.0, 0.0
        for a, b in found.deviations.nominal_run.intervals:
            t, weight = found.panels(a, b)
            here = found.deviations.values_at(t, rates=False)
            worst = found.worst(here.slope[0])
            total += worst * np.abs(here.value[0]) ** (self.power - 1) @ weight
            squares += worst**2 @ weight
            size, length = size + float(here.value[0] ** 2 @ weight), length + b - a
        if self.power == 1:
            return [total / length]
        # Of a signal that is zero only the displacements make a root mean square.
        return [total / np.sqrt(size * length) if size > 0 else np.sqrt(squares / length)]


class MeanEntry(Measure):
    """The mean of a signal."""

    reduction = "mean"
    mean: Annotated[Expression, SIGNAL]


class RmsEntry(Measure):
    """The root mean square of a signal."""

    reduction = "rms"
    rms: Annotated[Expression, SIGNAL]


class PathEntry(OfPath):
    """The length of a point's path."""

    reduction = "path"
    dimension = LENGTH
    along = ("hypot({0}.vx, {0}.vy)", SPEED)
    path: Annotated[Name, Ref("point")]


@register
class Mean(_OfMean):
    """The mean over time."""

    entry = MeanEntry
    power = 1
    bounded = True
    still = True

    def figure(self, mean: Any, length: Any) -> Any:
        return mean

    def mean_of(self, figure: float, length: float) -> float:
        return figure

    def derivative(self, found: WithDeviations) -> list[Derivative]:
        total, slope, length, grows = found.integral(1)
        return [Derivative.smooth((slope - total / length * grows) / length)]


@register
class Rms(_OfMean):
    """The root of the mean square."""

    entry = RmsEntry
    power = 2
    bounded = True
    still = True

    def figure(self, mean: Any, length: Any) -> Any:
        return np.sqrt(mean)

    def mean_of(self, figure: float, length: float) -> float:
        return figure

    def derivative(self, found: WithDeviations) -> list[Derivative]:
        """Of a signal that is zero all along, that of the size of each deviation: it has a corner at zero."""
        total, slope, length, grows = found.integral(2)
        if total > 0:
            return [Derivative.smooth((slope - total / length * grows) / length / (2 * np.sqrt(total / length)))]
        squares = np.zeros(found.count)
        for a, b in found.nominal_run.intervals:
            edges = np.linspace(a, b, PANELS + 1)
            half = np.diff(edges) / 2
            t = (edges[:-1] + half)[:, None] + half[:, None] * POINTS
            steep = found.values_at(t.ravel(), rates=False).slope[0]
            squares += steep**2 @ (half[:, None] * WEIGHTS).ravel()
        size = np.sqrt(squares / length)
        return [Derivative("", None, np.stack([size, -size])) if size.any() else Derivative.smooth(size)]


@register
class Path(_OfMean):
    """The length of a path: the mean speed times the time."""

    entry = PathEntry
    power = 1

    def figure(self, mean: Any, length: Any) -> Any:
        return mean * length

    def sampled_inputs(self, measure: PathEntry) -> SampledInputs:
        return SampledInputs({axis: Expression(f"{measure.point}.{axis}") for axis in ("vx", "vy")})

    def sampled(self, samples: OnSamples) -> SampledFigures:
        """The components of the velocity are smooth where the speed isn't: it is made of their cubics."""
        along, across = samples.rows["vx"], samples.rows["vy"]

        def speed(i: int, s: float) -> float:
            vx, vy = along.at(i, s), across.at(i, s)
            return sqrt(vx * vx + vy * vy)

        return {"": SampledFigure(integral(samples.stretches, along, speed))}

    def mean_of(self, figure: float, length: float) -> float:
        return figure / length

    def derivative(self, found: WithDeviations) -> list[Derivative]:
        return [Derivative.smooth(found.integral(1)[1])]
