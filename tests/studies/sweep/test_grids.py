"""Sweeps over grids: the chart has at each of its places the value of the sample there, found by its parameters."""

from __future__ import annotations

from itertools import product
from typing import Any

import numpy as np
import pytest

import linkwright as lw
from helpers.charts import graph, only, plane, titled
from linkwright.presentation.blocks import Charts
from linkwright.presentation.charts import Dots, Field, Line, Spots
from linkwright.studies.sweep.charts import charts
from linkwright.studies.sweep.outcome import SweepOutcome
from studies.models import CRANK, four_bar, slider_crank

STROKE = {"studies": {"cycle": {"turns": "1 motor", "samples": 24}}, "measures": {"stroke": {"span": "C.x"}}}


def swept(data: dict[str, Any], vary: dict[str, Any], outputs: list[str]) -> SweepOutcome:
    return lw.sweep(lw.Document.model_validate(data), vary, outputs)


def of_sample(outcome: SweepOutcome, index: int, **parameters: float) -> float:
    """A measure of the sample with these parameters, from the table of all samples."""
    assert outcome.table is not None
    rows = [outcome.table.parameters[outcome.names.index(name)] for name in parameters]
    alike = np.all([np.isclose(row, value) for row, value in zip(rows, parameters.values(), strict=True)], axis=0)
    (found,) = outcome.table.figures[index][alike]
    return float(found)


def test_two_parameters_span_a_plane_in_any_order_of_their_values() -> None:
    outcome = swept(slider_crank(**STROKE), {"r": [50, 30, 40], "e": {"from": 0, "to": 30, "count": 4}}, ["stroke"])
    field = only(Field, plane(titled(charts(outcome))["stroke over r and e"]).layers)
    assert (field.x.tolist(), field.y.tolist()) == ([30, 40, 50], pytest.approx([0, 10, 20, 30]))
    assert field.values.shape == (4, 3) and field.family
    for (row, e), (column, r) in product(enumerate(field.y), enumerate(field.x)):
        assert field.values[row, column] == pytest.approx(1e3 * of_sample(outcome, 0, r=r / 1e3, e=e / 1e3))
    # With no offset the stroke is the crank's diameter.
    np.testing.assert_allclose(field.values[0], 2 * field.x)


def test_limits_of_the_requirement_are_lines() -> None:
    data = slider_crank(**STROKE, require={"stroke": ">= 80 mm"})
    outcome = swept(data, {"r": [30, 40, 50], "e": [0, 10]}, ["stroke"])
    field = only(Field, plane(titled(charts(outcome))["stroke over r and e"]).layers)
    assert [(str(one.text), one.value) for one in field.limits] == [("stroke >= 80 mm", 80.0)]


def test_samples_that_cannot_be_assembled_are_gaps_with_a_mark() -> None:
    data = four_bar(
        drives={"motor": {**CRANK}},
        studies={"cycle": {"turns": "1 motor", "samples": 24}},
        measures={"swing": {"span": "rocker.angle"}},
    )
    outcome = swept(data, {"c": [50, 80, 90], "b": [100, 120]}, ["swing"])
    layers = plane(titled(charts(outcome))["swing over c and b"]).layers
    field, marks = only(Field, layers), only(Spots, layers)
    missing = np.isnan(field.values)
    assert 0 < missing.sum() < missing.size and outcome.failed == missing.sum()
    rows, columns = np.nonzero(missing)
    assert marks.cross and sorted(zip(marks.x, marks.y, strict=True)) == sorted(
        zip(field.x[columns], field.y[rows], strict=True)
    )


def test_one_parameter_is_a_curve_with_its_samples() -> None:
    outcome = swept(slider_crank(e=0, **STROKE), {"r": [50, 30, 40]}, ["stroke"])
    found = graph(titled(charts(outcome))["stroke over r"])
    assert found.at.tolist() == [30, 40, 50]
    for kind in (Line, Dots):
        np.testing.assert_allclose(only(kind, found.rows).values, [60, 80, 100])


def test_further_parameters_have_sliders() -> None:
    vary = {"r": [30, 40], "e": [0, 10, 20], "l": [150, 165]}
    outcome = swept(slider_crank(**STROKE), vary, ["stroke"])
    planes, _ = charts(outcome)
    assert isinstance(planes, Charts)
    (slider,) = planes.sliders
    assert (slider.name, list(slider.texts), slider.start) == ("l", ["150 mm", "165 mm"], 1)  # the file has 160 mm
    assert [chart.step for chart in planes.charts] == [(0,), (1,)]
    for chart, length in zip(planes.charts, (0.15, 0.165), strict=True):
        field = only(Field, plane(chart.content).layers)
        assert field.values[2, 1] == pytest.approx(1e3 * of_sample(outcome, 0, r=0.04, e=0.02, l=length))
    assert len({tuple(only(Field, plane(chart.content).layers).levels) for chart in planes.charts}) == 1


@pytest.mark.parametrize("plan", ["latin", "random", "sobol"])
def test_other_plans_have_no_grid(plan: str) -> None:
    vary = {"r": {"from": 30, "to": 50, "count": 3}, "e": {"from": 0, "to": 10, "count": 3}}
    outcome = lw.sweep(lw.Document.model_validate(slider_crank(**STROKE)), vary, ["stroke"], plan=plan, samples=8)
    assert outcome.plan.axes is None
    assert not any(
        isinstance(layer, Field)
        for content in titled(charts(outcome)).values()
        for layer in getattr(content, "layers", ())
    )
