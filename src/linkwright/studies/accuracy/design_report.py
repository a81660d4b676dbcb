"""Allocation and calibration of the accuracy study: as plain data in the file's units, as sentences and tables."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import Any

import numpy as np

from linkwright.findings import Joined, Said, Text
from linkwright.presentation.blocks import Table, table
from linkwright.presentation.cells import UNKNOWN, Cell, NumberCell, Numbers, Unit
from linkwright.presentation.json_numbers import known, listed
from linkwright.studies.accuracy.allocation_outcome import AllocatedTarget, Allocation, Allotted
from linkwright.studies.accuracy.calibration_outcome import Calibration, Estimate, Observed

THOUSANDTH = 1e-3
"""What a thousandth of a unit of width saves is shown: a micron, of millimetres."""


def allocation_entry(found: Allocation | None) -> dict[str, Any] | None:
    """The cheapest tolerances; half-widths in units of the file, prices in cost over these."""
    if found is None:
        return None
    now, cheapest, rounded = found.costs
    cost = {
        "now": known(now),
        "cheapest": known(cheapest),
        "rounded": _json_number(rounded),
        "loss": _json_number(found.loss),
    }
    return {
        "reached": found.reached,
        "loose": found.loose,
        "sigmas": found.sigmas,
        "cost": {**cost, "bound": _json_number(found.bound), "proven": found.proven},
        "tolerances": {one.name: _allotted(one) for one in found.items},
        "targets": {one.name: _target(one) for one in found.targets},
        "optimality": {
            key: known(getattr(found.optimality, key)) for key in ("stationarity", "feasibility", "complementarity")
        },
    }


def _allotted(one: Allotted) -> dict[str, Any]:
    widths = {"now": one.now, "cheapest": one.half, "least": one.low, "largest": one.high, "rounded": one.rounded}
    return {
        "unit": one.unit,
        **{key: _json_number(width, one.size) for key, width in widths.items()},
        "grade": one.grade,
        "cost": dict(zip(("now", "cheapest", "rounded"), map(_json_number, one.costs), strict=True)),
        "price": known(one.price * one.size),
        "fixed": one.fixed,
    }


def _target(one: AllocatedTarget) -> dict[str, Any]:
    widths = {"wanted": one.wanted, "now": one.now, "cheapest": one.after, "rounded": one.rounded}
    return {
        "unit": one.unit,
        "method": one.method,
        **{key: _json_number(width, one.size) for key, width in widths.items()},
        "met": one.passed,
        "price": known(one.price * one.size),
    }


def calibration_entry(found: Calibration | None) -> dict[str, Any] | None:
    """The estimated dimensions, how well they fit, and which can't be told apart."""
    if found is None:
        return None
    sizes = {one.name: one.size for one in found.estimates}
    names = [*sizes]
    pairs = np.argwhere(np.triu(np.isfinite(found.correlation), 1)).tolist()
    return {
        "parameters": {one.name: _estimate(one) for one in found.estimates},
        "confidence": found.confidence,
        "correlations": [{"of": [names[i], names[j]], "is": float(found.correlation[i, j])} for i, j in pairs],
        "outputs": {name: _fit(found, i) for i, name in enumerate(found.outputs)},
        "chi_square": known(found.chi_square),
        "freedom": found.freedom,
        "probability": _json_number(found.probability),
        "confounded": [
            {"deviations": {name: d / sizes[name] for name, d in one.deviations.items()}, "scaling": one.scaling}
            for one in found.confounded
        ],
        "outliers": [_observed(found, one) for one in found.observed if one.outlier],
        "singular": listed(found.singular),
        "threshold": found.threshold,
        "prior": found.prior,
        "converged": found.converged,
    }


def _estimate(one: Estimate) -> dict[str, Any]:
    interval = None if one.interval is None else [end / one.size for end in one.interval]
    figures = {"nominal": one.nominal, "value": one.value, "deviation": one.deviation, "error": one.error}
    shown = {key: _json_number(value, one.size) for key, value in figures.items()}
    return {"unit": one.unit, **shown, "interval": interval, "identified": one.identified}


def _fit(found: Calibration, i: int) -> dict[str, Any]:
    """How far the measured values of one output lie from the computed ones: root mean square before and after."""
    unit, size = found.units[i]
    rest = {"before": found.before[i] / size, "after": found.after[i] / size} if found.after else {}
    return {"unit": unit, "sigma": known(found.sigmas[i] / size), "sigma_stated": found.stated[i], **rest}


def _observed(found: Calibration, one: Observed) -> dict[str, Any]:
    size = found.units[one.output][1]
    values = {"measured": known(one.measured / size), "fitted": known(one.fitted / size)}
    return {"output": found.outputs[one.output], "row": one.row, **values, "studentised": known(one.studentised)}


def design_sentences(allocation: Allocation | None, calibration: Calibration | None) -> Iterator[Text]:
    """What came out of them, in sentences."""
    if allocation is not None:
        now, cheapest, rounded = allocation.costs
        key = "loose" if allocation.loose else "reached" if allocation.reached else "missed"
        yield Said(f"accuracy.allocation.{key}", now=_number_cell(now), cheapest=_number_cell(cheapest))
        if rounded is not None:
            proven = "proven" if allocation.proven else "found"
            yield Said(f"accuracy.allocation.{proven}", cost=_number_cell(rounded), loss=_number_cell(allocation.loss))
    if calibration is not None:
        yield Said("accuracy.calibration", measured=len(calibration.observed), count=len(calibration.estimates))
        for same in calibration.confounded:
            yield Said(f"accuracy.confounded{'.scaling' if same.scaling else ''}", names=Joined(same.names))
        for one in calibration.observed:
            if one.outlier:
                name, size = calibration.outputs[one.output], calibration.units[one.output][1]
                yield Said("accuracy.outlier", row=one.row, name=name, rest=_number_cell(one.residual, size))


def design_tables(allocation: Allocation | None, calibration: Calibration | None) -> Iterator[Table]:
    """Their tables."""
    widths, made = ("width", "cheapest", "rounded"), partial(table, "accuracy")
    if allocation is not None:
        yield made("allocation", ("dimension", *widths, "grade", "saves", "unit"), map(_tolerance, allocation.items))
        yield made("targets", ("output", "wanted", *widths, "saves", "unit"), map(_demand, allocation.targets))
    if calibration is not None:
        heads = ("dimension", "nominal", "estimate", "estimated", "interval", "error", "unit")
        yield made("calibration", heads, map(_estimated, calibration.estimates))
        if calibration.after:
            rows = (_fitted(calibration, i) for i in range(len(calibration.outputs)))
            yield made("fit", ("output", "sigma", "before", "after", "unit"), rows)


def _tolerance(one: Allotted) -> list[Cell]:
    widths = (_number_cell(width, one.size) for width in (one.now, one.half, one.rounded))
    grade = Said("accuracy.fixed") if one.fixed else one.grade or UNKNOWN
    return [one.name, *widths, grade, _number_cell(one.price * one.size * THOUSANDTH), Unit(one.unit)]


def _demand(one: AllocatedTarget) -> list[Cell]:
    widths = (_number_cell(width, one.size) for width in (one.wanted, one.now, one.after, one.rounded))
    return [one.name, *widths, _number_cell(one.price * one.size * THOUSANDTH), Unit(one.unit)]


def _estimated(one: Estimate) -> list[Cell]:
    figures = (_number_cell(value, one.size) for value in (one.nominal, one.value, one.deviation))
    ends = Numbers([_number_cell(end, one.size) for end in one.interval or ()])
    told = ends if one.identified else Said("accuracy.parameter-not-identifiable")
    return [one.name, *figures, told, _number_cell(one.error, one.size), Unit(one.unit)]


def _fitted(found: Calibration, i: int) -> list[Cell]:
    unit, size = found.units[i]
    return [
        found.outputs[i],
        *(_number_cell(row[i], size) for row in (found.sigmas, found.before, found.after)),
        Unit(unit),
    ]


def _json_number(value: float | None, size: float = 1.0) -> float | None:
    return None if value is None else known(value / size)


def _number_cell(value: float | None, size: float = 1.0) -> NumberCell:
    return NumberCell(_json_number(value, size), 5)
