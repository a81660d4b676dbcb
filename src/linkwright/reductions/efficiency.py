"""Efficiency: which part of the energy that a mechanism is given becomes useful work, and where the rest goes.

Over a window, the drives supply the work W, of which the energy dE is stored by masses, springs and gravity. What is
left, G = W - dE, is what all loads, dampers and friction take: the useful loads U, the others L. Where U > 0 the
efficiency is U/G, and the share of an element what it takes over G. Where U < 0 the useful loads drive it backwards:
the efficiency is what the drives get back (and masses and springs store) over what the loads give, G/U = 1 - L/|U|,
and shares are over |U|. The efficiency and the shares of all other elements add up to 1 over any window. A backward
efficiency is negative where the loads don't suffice to move the mechanism, which is self-locking then (as power
screws are: Shigley, Mechanical Engineering Design, 10th ed., sec. 8-2).
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Iterator, Mapping, Sequence
from math import nan
from typing import Annotated, Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray
from pydantic import BeforeValidator

from linkwright.elements.force import Use
from linkwright.expressions.fields import Expression, Name
from linkwright.expressions.typed_fields import Ref, Scope
from linkwright.expressions.units import ENERGY, POWER, PURE
from linkwright.expressions.written import Fault, unexpected
from linkwright.reductions.derivative import Derivative
from linkwright.reductions.entry import Measure
from linkwright.reductions.figures import Figures, FoundFigure, Unmeasured
from linkwright.reductions.interpolant import integral
from linkwright.reductions.kind import MeasureKind, register
from linkwright.reductions.protocols import InRun, InSamples, WithDeviations, WithPlay
from linkwright.reductions.samples import OnSamples, SampledFigure, SampledFigures, SampledInputs

Array = NDArray[np.float64]

NOTHING = 1e-9
"""Useful work below this share of the work that the useful loads exchange is none."""
GIVEN, SUPPLIED, STORED = (Expression(f"energy.{part}") for part in ("dissipated", "supplied", "stored"))


def _several(raw: Any) -> Any:
    if not isinstance(raw, list | tuple) or not raw:
        raise unexpected("element-names", raw)
    return tuple(raw)


Elements = Annotated[tuple[Annotated[Name, Ref("acting")], ...], BeforeValidator(_several)]
"""Loads, springs and friction by their names."""


def taken_by(names: Sequence[str]) -> Expression:
    """The power that elements take and don't store."""
    return Expression(" + ".join(f"power({name}).dissipated" for name in names))


class _OfEnergy(Measure):
    """Base of the entries of reductions that compare works."""

    dimension = PURE

    @property
    def elements(self) -> tuple[str, ...]:
        """The elements whose work is compared."""
        return tuple(getattr(self, self.reduction))

    @property
    def useful_elements(self) -> tuple[str, ...]:
        """Those whose work is useful."""
        raise NotImplementedError

    @property
    def signal(self) -> Expression:
        """The power that the elements take."""
        return taken_by(self.elements)

    @property
    def also(self) -> Mapping[str, Expression]:
        """The power that the useful loads take, that all elements take; of the drives; the energy stored."""
        return {"useful": taken_by(self.useful_elements), "given": GIVEN, "supplied": SUPPLIED, "stored": STORED}

    @property
    def subject(self) -> str:
        """The elements, for the reader."""
        return ", ".join(self.elements)

    def implied_expressions(self, mechanism: Any, name: str) -> Iterator[Use]:
        """Its signals, where there are such elements."""
        known = {one.name for one in mechanism.acting() if one.kind.acts}
        if known.issuperset((*self.elements, *self.useful_elements)):
            yield Use(self.reduction, self.signal, POWER, Scope.SIGNALS)
            for key, expression in self.also.items():
                yield Use(key, expression, ENERGY if key == "stored" else POWER, Scope.SIGNALS)


class EfficiencyEntry(_OfEnergy):
    """The efficiency, of the work of useful loads."""

    reduction = "efficiency"
    sentence = "measure.text.efficiency"
    efficiency: Elements

    @property
    def useful_elements(self) -> tuple[str, ...]:
        """Those whose work is useful."""
        return self.efficiency


class ShareEntry(_OfEnergy):
    """The share of some elements of the energy given."""

    reduction = "share"
    sentence = "measure.text.share"
    share: Elements
    useful: Elements

    @classmethod
    def key_faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        if ("share" in given) != ("useful" in given):
            yield "measure.useful", {}

    @property
    def useful_elements(self) -> tuple[str, ...]:
        """Those whose work is useful."""
        return self.useful


class Ratio(NamedTuple):
    """A quotient of means: the keys of what is above and below, and its sign."""

    top: str
    bottom: str
    sign: float = 1.0


class _Works(MeasureKind):
    """A reduction that compares the works of elements over the window."""

    power: ClassVar[int] = 1
    averaged = ("", "useful", "given")
    differentiable = True
    bounded = True
    still = True
    forward: ClassVar[Ratio]
    """Where the useful loads take work."""
    backward: ClassVar[Ratio]
    """Where they give work."""

    @abstractmethod
    def rows(self, measure: Any) -> Mapping[str, Expression]:
        """What samples of a page need, by key."""

    def ratio(self, useful: float) -> Ratio:
        """That which holds at some useful work."""
        return self.forward if useful > 0 else self.backward

    def needed_extremes(self, measure: Any) -> Sequence[tuple[str, float]]:
        return ()

    def run_figures(self, run: InRun) -> tuple[FoundFigure, ...]:
        """The quotient. Raises :class:`Unmeasured` without useful work, or where other elements give more energy than
        is lost, so that what drives the mechanism isn't known."""
        parts = {"": run, "useful": run.other("useful"), "given": run.other("given")}
        means = {key: part.mean() for key, part in parts.items()}
        useful, given = means["useful"], means["given"]
        if not abs(useful) > NOTHING * parts["useful"].magnitude():
            raise Unmeasured("measure.useless")
        if given - useful < -NOTHING * max(abs(given), abs(useful)):
            raise Unmeasured("measure.energy-from-others")
        return (run.graded_figure("", _quotient(means, self.ratio(useful))),)

    def figures(self, samples: InSamples) -> dict[str, Figures]:
        means = {key: samples.mean(key) for key in self.averaged}
        useful, given = means["useful"], means["given"]
        with np.errstate(all="ignore"):
            values = np.where(useful > 0, *(_quotient(means, ratio) for ratio in (self.forward, self.backward)))
            known = np.abs(useful) > NOTHING * samples.magnitude("useful")
            known &= given - useful >= -NOTHING * np.maximum(np.abs(given), np.abs(useful))
        return {"": Figures.anywhere(np.where(known, values, np.nan))}

    def sampled_inputs(self, measure: Any) -> SampledInputs:
        return SampledInputs(self.rows(measure))

    def sampled(self, samples: OnSamples) -> SampledFigures:
        """The integrals of the cubics are exact."""
        works = {key: integral(samples.stretches, row, row.at) for key, row in samples.rows.items()}
        works.setdefault("useful", works[""])
        useful, given = works["useful"], works["given"]
        row = samples.rows.get("useful", samples.signal)
        size = integral(samples.stretches, row, lambda i, s: abs(row.at(i, s)))
        if not abs(useful) > NOTHING * size or given - useful < -NOTHING * max(abs(given), abs(useful)):
            return {"": SampledFigure(nan)}
        return {"": SampledFigure(float(_quotient(works, self.ratio(useful))))}

    def derivative(self, found: WithDeviations) -> list[Derivative]:
        """By the rule of quotients, with windows that move."""
        ratio = self._nominal(found)
        (top, rising, *_), (bottom, growing, *_) = (found.integral(1, key) for key in (ratio.top, ratio.bottom))
        return [Derivative.smooth(ratio.sign * (rising - top / bottom * growing) / bottom)]

    def clearance_bounds(self, found: WithPlay) -> list[Array]:
        """The directions are free at each time."""
        deviations = found.deviations
        ratio = self._nominal(deviations)
        top, bottom = (deviations.integral(1, key)[0] for key in (ratio.top, ratio.bottom))
        total = np.zeros(found.joints)
        for a, b in deviations.nominal_run.intervals:
            t, weight = found.panels(a, b)
            above, below = (deviations.values_at(t, key, rates=False).slope[0] for key in (ratio.top, ratio.bottom))
            total += found.worst(above - top / bottom * below) @ weight
        return [total / abs(bottom)]

    def contradiction(self, reported: Mapping[str, float], run: InRun) -> float:
        """The energy given once more from the drives' power and the energy stored, on other nodes."""
        parts = {key: run.other(key) for key in ("useful", "supplied", "stored")}
        means = {"": run.mean(rule=1), **{key: parts[key].mean(rule=1) for key in ("useful", "supplied")}}
        ends = [parts["stored"].values(np.array(ends)) for ends in run.intervals]
        means["given"] = means["supplied"] - sum(float(after - before) for before, after in ends) / run.length
        ratio = self.ratio(means["useful"])
        size = max(parts["supplied"].magnitude(), parts["useful"].magnitude()) / abs(means[ratio.bottom])
        return float(abs(_quotient(means, ratio) - reported[""]) / max(size, 1.0))

    def _nominal(self, found: WithDeviations) -> Ratio:
        return self.ratio(found.integral(1, "useful")[0])


@register
class Efficiency(_Works):
    """Useful work over the energy given; where the useful loads drive, what is recovered over what they give."""

    entry = EfficiencyEntry
    forward, backward = Ratio("", "given"), Ratio("given", "")

    def rows(self, measure: EfficiencyEntry) -> Mapping[str, Expression]:
        return {"": measure.signal, "given": GIVEN}


@register
class Share(_Works):
    """What some elements take of the energy given."""

    entry = ShareEntry
    forward, backward = Ratio("", "given"), Ratio("", "useful", -1.0)

    def rows(self, measure: ShareEntry) -> Mapping[str, Expression]:
        return {"": measure.signal, "useful": taken_by(measure.useful), "given": GIVEN}


def _quotient(works: Mapping[str, Any], ratio: Ratio) -> Any:
    """Numbers or arrays."""
    return ratio.sign * works[ratio.top] / works[ratio.bottom]
