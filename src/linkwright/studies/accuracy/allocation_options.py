"""The option ``allocate`` of the accuracy study: which accuracy is wanted, and what tolerances cost."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from typing import Annotated, Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from linkwright.elements.fields import freeze
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Frozen
from linkwright.expressions.typed_fields import Context, Quantity
from linkwright.expressions.unknown import near
from linkwright.expressions.written import Shortened
from linkwright.findings import Finding, Joined
from linkwright.model.quantities import Quantities
from linkwright.studies.accuracy.allocation_outcome import Allocation
from linkwright.studies.accuracy.allocation_problem import Demand, Item, Problem
from linkwright.studies.accuracy.allocation_solver import allocate
from linkwright.studies.accuracy.contributors import Contributor, Contributors
from linkwright.studies.accuracy.costs import AnyCost, Processes, Stepped
from linkwright.studies.accuracy.outputs import OutputName, of_output
from linkwright.studies.numbers import constant, positive
from linkwright.tolerances import NoTolerance, tolerance_class

Array = NDArray[np.float64]
Method = Literal["rss", "worst"]

PATH = ("studies", "accuracy", "allocate")
PROVEN = 1e-6
"""How far an optimum may be from the conditions that prove it, over the cost."""
FINEST, COARSEST = 5, 14
"""The grades, IT5 to IT14, within which the half-widths of lengths lie that state no others."""
DECADE = 10.0
"""Others lie between this part of what is stated and this multiple of it."""


class AllocationTarget(Shortened):
    """A target: the half-width of an output."""

    main = "within"

    within: Expression
    method: Method | None = None


def _of_contributor(c: Context) -> str | u.Dimension:
    """The dimension of the parameter or the change of temperature by whose name something stands."""
    name = str(c.path[4])
    return name if name in c.mechanism.parameters else u.PURE


class Allocate(Frozen):
    """The cheapest tolerances for a wanted accuracy."""

    targets: Annotated[dict[OutputName, AllocationTarget], of_output(4), freeze] = Field(min_length=1, max_length=100)
    method: Method = "rss"
    sigmas: float = Field(3.0, gt=0, le=100)
    costs: Annotated[dict[str, AnyCost], Quantity(_of_contributor), freeze] = Field(min_length=1, max_length=1000)
    grades: bool = False


class Output(NamedTuple):
    """What is known of an output: coefficients (rows, contributors) in SI, dimension, unit and its size in SI."""

    coefficients: Array
    dimension: u.Dimension
    unit: str
    size: float


def problem(
    quantities: Quantities, options: Allocate, contributors: Contributors, outputs: Mapping[str, Output]
) -> tuple[Problem | None, list[Finding]]:
    """The problem, or what is wrong with it."""
    demands: list[Demand] = []
    findings = [*_demanded(quantities, options, outputs, demands)]
    items, known = [], [*map(str, contributors.names)]
    for name in options.costs:
        if name not in known:
            data = {"name": name[:60], "near": near(name, known)}
            findings.append(Finding("accuracy.no-contributor", (*PATH, "costs", name), data))
    rounding = options.grades or any(isinstance(cost, Processes) for cost in options.costs.values())
    for one in contributors.every:
        half = (one.high - one.low) / 2
        spread = one.sigma / half if half else 0.0
        cost = options.costs.get(one.name)
        if cost is None:
            items.append(Item(one.name, half, spread, unit=one.unit, size=one.size))
            continue
        path = (*PATH, "costs", one.name)
        wrong = [*_no_grade(one, cost, path, rounding)]
        ends, more = _half_width_limits(quantities, one, half, cost, path)
        findings += [*wrong, *more]
        if wrong or more or ends is None:
            continue
        law = cost.law(one.size, partial(it_half, one))
        choices: tuple[tuple[str, float], ...] = ()
        if isinstance(law, Stepped):
            inside = [(label, float(d)) for label, d in zip(law.labels, law.halves, strict=True)]
            choices = tuple(inside) if cost.between is None else _within(inside, ends)
            ends = (choices[0][1], choices[-1][1]) if choices else ends
        elif rounding:
            choices = _within([(f"IT{n}", it_half(one, f"IT{n}") or np.nan) for n in range(1, 19)], ends)
        if rounding and not choices:
            low, high = (f"{end / one.size:.4g}" for end in ends)
            data = {"name": one.name, "low": low, "high": high, "unit": one.unit}
            findings.append(Finding("accuracy.no-grade-between", path, data))
            continue
        items.append(Item(one.name, half, spread, law, *ends, choices, one.unit, one.size))
    if findings:
        return None, findings
    return Problem(items, demands, contributors.correlation, options.sigmas), []


def allocated(problem: Problem) -> tuple[Allocation, list[Finding]]:
    """The allocation, and findings where the targets can't be reached or cost nothing."""
    found = allocate(problem)
    notes = []
    for target in found.targets:
        if not target.passed:
            data = {
                "name": target.name,
                "wanted": f"{target.wanted / target.size:.6g}",
                "best": f"{target.after / target.size:.6g}",
                "unit": target.unit,
            }
            notes.append(
                Finding("accuracy.target-unreachable", (*PATH, "targets", target.name), data, severity="warning")
            )
    if found.reached and found.optimality.worst > PROVEN:
        data = {"off": f"{found.optimality.worst:.2g}"}
        notes.append(Finding("accuracy.not-optimal", PATH, data, severity="warning"))
    if found.loose:
        notes.append(Finding("accuracy.targets-loose", (*PATH, "targets"), {}, severity="warning"))
    if found.reached and found.bound is not None and found.costs[2] is None:
        notes.append(Finding("accuracy.no-choice", (*PATH, "costs"), {}, severity="warning"))
    return found, notes


def it_half(one: Contributor, grade: str) -> float | None:
    """The half-width (m) of a grade such as IT7 at a length's size; None where the standard has none."""
    found = tolerance_class(grade)
    if one.dimension != u.LENGTH or found is None:
        return None
    try:
        return float(found.limits(abs(one.nominal))[1])
    except NoTolerance:
        return None


def _within(choices: Sequence[tuple[str, float]], ends: tuple[float, float]) -> tuple[tuple[str, float], ...]:
    low, high = ends[0] * (1 - 1e-9), ends[1] * (1 + 1e-9)
    return tuple((label, half) for label, half in choices if low <= half <= high)


def _demanded(
    quantities: Quantities, options: Allocate, outputs: Mapping[str, Output], demands: list[Demand]
) -> Iterator[Finding]:
    for name, target in options.targets.items():
        path = (*PATH, "targets", name)
        if name not in outputs:
            yield Finding("accuracy.no-target", path, {"name": name[:60], "near": near(name, [*outputs])})
            continue
        coefficients, dimension, unit, size = outputs[name]
        text = target.within.text[:40]
        wanted, wrong = positive(quantities, target.within, dimension, path, "accuracy.target", text=text)
        yield from wrong
        if wanted is not None:
            demands.append(Demand(name, wanted, coefficients, target.method or options.method, unit, size))


def _no_grade(one: Contributor, cost: Any, path: tuple[str, ...], rounding: bool) -> Iterator[Finding]:
    """Grades that the standard has no value of for this parameter."""
    lacking = cost.unknown(partial(it_half, one))
    if rounding and not isinstance(cost, Processes) and it_half(one, f"IT{FINEST}") is None:
        lacking = [f"IT{FINEST}"]
    if lacking:
        yield Finding("accuracy.no-grade", path, {"name": one.name, "grades": Joined(lacking), "unit": one.unit})


def _half_width_limits(
    quantities: Quantities, one: Contributor, half: float, cost: Any, path: tuple[str, ...]
) -> tuple[tuple[float, float] | None, list[Finding]]:
    """The least and the largest half-width of a parameter."""
    if cost.between is None:
        low, high = (it_half(one, f"IT{grade}") for grade in (FINEST, COARSEST))
        return ((low, high) if low and high else (half / DECADE, half * DECADE)), []
    at = (*path, "between")
    (low, wrong), (high, more) = (
        constant(quantities, part, one.dimension, (*at, i)) for i, part in enumerate(cost.between)
    )
    if low is None or high is None:
        return None, [*wrong, *more]
    if not 0 < low < high:
        data = {"low": cost.between[0].text[:40], "high": cost.between[1].text[:40]}
        return None, [Finding("accuracy.half-widths", at, data)]
    return (low, high), []
