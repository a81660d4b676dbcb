"""Charts of sweeps: bands with gaps where no sample has a value, histograms with their limits, coloured samples."""

from __future__ import annotations

from typing import Any

import numpy as np

import linkwright as lw
from helpers.charts import graph, only, plane, titled
from linkwright.presentation.charts import Band, Bars, Line, Spots
from linkwright.studies.sweep.charts import charts
from studies.models import CRANK, four_bar, slider_crank

CYCLE = {"cycle": {"turns": "1 motor", "samples": 24}}


def shown(data: dict[str, Any], *given: Any, **options: Any) -> dict[str, Any]:
    return titled(charts(lw.sweep(lw.Document.model_validate(data), *given, **options)))


def test_a_band_has_gaps_where_no_sample_has_a_value() -> None:
    data = four_bar(c=80, drives={"motor": {**CRANK, "start": "90 deg"}})
    outcome = lw.sweep(lw.Document.model_validate(data), {"c": [55, 56]}, ["B.x"], poses=90)
    found = graph(titled(charts(outcome))["B.x"])
    band, mean = only(Line, found.rows), outcome.bands["B.x"].mean
    assert np.isnan(mean).any()
    np.testing.assert_allclose(band.values, mean * 1e3)
    assert found.y.unit == "mm" and found.x.unit == "s"
    wide = next(row for row in found.rows if isinstance(row, Band) and not row.strong)
    np.testing.assert_allclose(wide.high, outcome.bands["B.x"].largest * 1e3)


def test_a_narrow_band_is_shown_about_its_mean_too() -> None:
    wide = shown(slider_crank(studies=CYCLE), {"r": [30, 60]}, ["B.x"])
    narrow = shown(slider_crank(studies=CYCLE), {"r": [49.9, 50.1]}, ["B.x"])
    assert [*wide] == ["B.x"] and [*narrow] == ["B.x", "B.x minus its mean"]
    about = only(Line, graph(narrow["B.x minus its mean"]).rows)
    assert not about.values.any()


def test_a_histogram_has_the_counts_and_the_limits() -> None:
    data = slider_crank(studies=CYCLE, measures={"stroke": {"span": "C.x"}}, require={"stroke": "100 mm .. 110 mm"})
    outcome = lw.sweep(lw.Document.model_validate(data), {"r": {"uniform": [48, 56]}}, ["stroke"], samples=50)
    found = graph(titled(charts(outcome))["stroke: samples"])
    bars = only(Bars, found.rows)
    assert bars.values.sum() == 50
    np.testing.assert_allclose(bars.edges[:, 0] / 1e3, outcome.measures[0].edges[:-1])
    assert [(one.value, one.upright) for one in found.limits] == [(100.0, True), (110.0, True)]
    assert "stroke 100 mm .. 110 mm" in str(found.limits[0].text)
    spots = only(Spots, plane(titled(charts(outcome))["stroke over r"]).layers)
    assert outcome.table is not None
    np.testing.assert_allclose(spots.y / 1e3, outcome.table.figures[0])


def test_samples_of_two_parameters_are_coloured_by_their_value() -> None:
    data = slider_crank(studies=CYCLE, measures={"stroke": {"span": "C.x"}})
    vary = {"r": {"uniform": [48, 56]}, "e": {"uniform": [0, 30]}}
    outcome = lw.sweep(lw.Document.model_validate(data), vary, ["stroke"], samples=30)
    spots = only(Spots, plane(titled(charts(outcome))["stroke over r and e"]).layers)
    assert outcome.table is not None and spots.values is not None and spots.scale is not None
    np.testing.assert_allclose(np.stack([spots.x, spots.y]) / 1e3, outcome.table.parameters)
    np.testing.assert_allclose(spots.values / 1e3, outcome.table.figures[0])
    assert (spots.scale.low, spots.scale.high) == (spots.values.min(), spots.values.max())
