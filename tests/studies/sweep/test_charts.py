"""Charts of sweeps: round numbers on the axes, gaps where no sample has a value."""

from __future__ import annotations

import re
from typing import Any

import linkwright as lw
from linkwright.studies.sweep.charts import charts
from studies.models import CRANK, four_bar, slider_crank


def drawn(data: dict[str, Any], *given: Any, **options: Any) -> list[str]:
    return [chart.drawing for chart in charts(lw.sweep(lw.Document.model_validate(data), *given, **options))]


def test_a_band_has_gaps_where_no_sample_has_a_value() -> None:
    data = four_bar(c=80, drives={"motor": {**CRANK, "start": "90 deg"}})
    band, *_ = drawn(data, {"c": [55, 56]}, ["B.x"], poses=90)
    assert len(re.findall('class="mean"', band)) == 2
    assert "nan" not in band


def test_a_narrow_band_is_shown_about_its_mean_too() -> None:
    studies = {"cycle": {"turns": "1 motor", "samples": 24}}
    wide = drawn(slider_crank(studies=studies), {"r": [30, 60]}, ["B.x"])
    narrow = drawn(slider_crank(studies=studies), {"r": [49.9, 50.1]}, ["B.x"])
    assert (len(wide), len(narrow)) == (1, 2)
    span = [float(y) for y in re.findall(r",([0-9.]+)", narrow[1])]
    assert max(span) - min(span) > 100


def test_texts_are_escaped() -> None:
    data = slider_crank(studies={"cycle": {"turns": "1 motor", "samples": 24}})
    (band,) = drawn(data, {"r": [30, 60]}, ["min(B.x, B.y)"])
    assert 'aria-label="min(B.x, B.y), mm"' in band
