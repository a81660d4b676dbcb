"""Charts as data of pages: read back, numbers are what they were to the digits that count."""

from __future__ import annotations

import json
from typing import Any

import hypothesis.extra.numpy as arrays
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from helpers.charts import line, unpacked, values
from linkwright.findings import Said
from linkwright.presentation.blocks import Chart
from linkwright.presentation.chart_data import ChartData, coarse, numbers, path, pooled, steps
from linkwright.presentation.charts import (
    Axis,
    Band,
    Bars,
    ColouredLines,
    ColourScale,
    Dots,
    Field,
    Graph,
    Layer,
    Limit,
    Line,
    Lines,
    Plane,
    Region,
    Row,
    Spots,
)
from linkwright.words import LANGUAGES, in_language

FINITE = st.floats(-1e6, 1e6, allow_subnormal=False)
HOLED = arrays.arrays(float, st.integers(1, 40), elements=st.one_of(FINITE, st.just(np.nan)))
AT = np.linspace(0.0, 2.0, 5)
ROWS: list[Row] = [
    Line("a", AT**2, 1, dash=2),
    Dots("b", np.array([np.nan, 1.5, np.nan, np.nan, np.nan])),
    Band("c", AT - 1, AT + 1, strong=True),
    Bars("d", AT, np.stack([AT - 0.25, AT + 0.25], axis=1)),
]
RING = np.array([[0.0, 1.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 1.0, 0.0]])
SCALE = ColourScale(Axis("servo", "deg"), 0.0, 360.0, ["#000000", "#ffffff"])
LAYERS: list[Layer] = [
    Region(Said("sweep.chart.samples"), [RING]),
    Lines("edge", [RING], "ink", 1, 2.0),
    ColouredLines("ways", SCALE, [(90.0, [RING])]),
    Spots("dots", AT, AT, AT, SCALE),
    Spots("lost", AT[:1], AT[:1], colour="muted", cross=True),
    Field(Axis("f", "mm"), AT, AT[:2], np.ones((2, 5)), [0.5], ["#000000", "#ffffff"], [Limit("f >= 1", 1.0)], [RING]),
]


@given(HOLED)
def test_numbers_keep_six_digits_of_their_range(given: Any) -> None:
    made = numbers(given)
    json.dumps(made, allow_nan=False)
    found, known = values(made), np.isfinite(given)
    assert (np.isfinite(found) == known).all()
    if known.any():
        off = max(1e-5 * np.ptp(given[known]), 1e-8 * np.abs(given[known]).max())
        assert np.abs(found - given)[known].max() <= off


@given(FINITE, st.floats(1e-3, 1e3), st.integers(4, 400))
def test_even_axes_are_their_ends(start: float, step: float, count: int) -> None:
    axis = start + step * np.arange(count)
    made = steps(axis)
    assert set(made) == {"from", "to", "count"}
    np.testing.assert_allclose(values(made), axis, rtol=1e-8, atol=1e-8 * np.abs(axis).max())


@given(arrays.arrays(float, st.tuples(st.just(2), st.integers(1, 30)), elements=st.floats(-1e3, 1e3)))
def test_lines_lie_within_half_a_step(given: Any) -> None:
    found = line(path(given, 0.01), 0.01)
    ends = np.abs(found[:, [0, -1]] - given[:, [0, -1]])
    assert ends.max() <= 0.005 * (1 + 1e-9)
    rounded = np.rint(given / 0.01)
    kept = np.append(True, np.diff(rounded, axis=1).any(axis=0))
    np.testing.assert_allclose(found, rounded[:, kept] * 0.01, atol=1e-9)


@given(arrays.arrays(float, 60, elements=st.one_of(st.floats(1e-3, 1e6), st.just(np.nan))), st.booleans())
def test_coarse_fields_have_three_digits_or_lie_at_an_end(given: Any, shifted: bool) -> None:
    given = given - 10.0 * shifted
    made = coarse(given)
    found, known = unpacked(made), np.isfinite(given)
    assert (np.isfinite(found) == known).all()
    within = known & (given >= made["low"]) & (given <= made["high"])
    size = np.abs(given) if made["ratios"] else made["high"] - made["low"]
    assert (np.abs(found - given)[within] <= 3e-3 * np.broadcast_to(size, given.shape)[within] + 1e-12).all()


@pytest.mark.parametrize(
    "content",
    [
        Graph(
            Axis(Said("plot.time"), "s"), AT, Axis("v", "mm/s^2"), ROWS, [Limit("v <= 1", 1.0), Limit("t", 1.0, True)]
        ),
        Graph(Axis("who"), AT, Axis("share", "%"), ROWS, names=["a", "b", "c", "d", "e"]),
        Plane(Axis("x", "mm"), Axis("y", "mm"), LAYERS, fine=0.01, limits=[Limit("y <= 2", 2.0)], box=(0, 0, 1, 1)),
    ],
)
def test_data_are_json_without_words(content: Any) -> None:
    """Texts stand beside the numbers, by their number; the key of a chart is the same in all languages."""
    data = ChartData(content)
    text = json.dumps(data.plain, allow_nan=False)
    assert "mm/s^2" not in text
    for said in data.texts:
        assert str(said) not in text or len(str(said)) < 4
    keys = set()
    for language in LANGUAGES:
        with in_language(language):
            keys.add(Chart("title", shown=lambda: content).key)
    assert len(keys) == 1
    assert Chart("other", shown=lambda: content).key not in keys


def test_every_kind_of_row_and_layer_is_tried() -> None:
    assert {type(row) for row in ROWS} == {*Row.__args__}  # type: ignore[attr-defined]
    assert {type(layer) for layer in LAYERS} == {*Layer.__args__}  # type: ignore[attr-defined]


def test_lines_of_a_page_stand_once() -> None:
    plain = ChartData(Plane(Axis("x"), Axis("y"), LAYERS, fine=0.01)).plain
    made = pooled({"one": plain, "two": plain})
    assert made["paths"] == [path(RING, 0.01)]
    assert made["charts"]["one"] == made["charts"]["two"]
    kinds = {layer["kind"]: layer for layer in made["charts"]["one"]["layers"]}
    assert kinds["region"]["paths"] == kinds["coloured"]["groups"][0]["paths"] == kinds["field"]["paths"] == [0]


def test_few_dots_have_their_places() -> None:
    (row,) = ChartData(Graph(Axis("t"), AT, Axis("v"), ROWS[1:2])).plain["rows"]
    assert (row["values"], row["of"]) == ([1.5], [1])
