"""What is said of an accuracy study: figures that hang together, in the file's units, and texts that are safe."""

from __future__ import annotations

import csv
import io
import json
import re
from dataclasses import replace
from html import unescape
from typing import Any

import numpy as np
import pytest
from scipy.io import netcdf_file

import linkwright as lw
from helpers.accuracies import LIMITS, MM, NOMINAL, outcome, place, stroke
from helpers.charts import graph, only
from helpers.shown import heads, rows, told
from linkwright.app.job import summary_text
from linkwright.drawing.charts import MOST_POSES, thinned
from linkwright.presentation.blocks import Sentences, filled
from linkwright.presentation.charts import Band, Bars, Dots, Line
from linkwright.report.build import report_data
from linkwright.report.page import page
from linkwright.report.summary import worded
from linkwright.studies.accuracy.charts import curve_charts, figure_charts
from linkwright.studies.accuracy.disagreement import along, disagreement
from linkwright.studies.accuracy.files import contributors_csv
from linkwright.studies.accuracy.outcome import AccuracyOutcome
from linkwright.studies.accuracy.report import report, sentences
from linkwright.studies.accuracy.summary import accuracy_entry
from linkwright.studies.accuracy.tables import overview, review, review_text
from linkwright.studies.figures import per
from linkwright.studies.registry import Outcomes
from studies.models import slider_crank

SIZES = np.array([[low, high] for low, high, _ in LIMITS.values()])  # mm


@pytest.fixture(scope="module")
def made() -> AccuracyOutcome:
    return outcome()


@pytest.fixture(scope="module")
def entry(made: AccuracyOutcome) -> dict[str, Any]:
    plain: dict[str, Any] = json.loads(summary_text(worded(accuracy_entry(made))))
    return plain


def section_of(done: AccuracyOutcome) -> str:
    document = lw.Document.model_validate(slider_crank())
    found = re.search(
        r'<section id="accuracy">.*?</section>', page(report_data(document, Outcomes(accuracy=done))), re.DOTALL
    )
    assert found is not None
    return found[0]


# The summary.


def test_limits_are_those_of_the_closed_form_in_the_files_units(entry: dict[str, Any]) -> None:
    nominal, *slopes = stroke(*NOMINAL.values())
    found = entry["accuracy"]["stroke"]
    assert found["nominal"] == pytest.approx(nominal / MM, rel=1e-14)
    assert found["unit"] == "mm"
    reach = np.sort(np.array(slopes)[:, None] * SIZES, axis=1).sum(axis=0)
    assert found["worst_case"]["deviation"] == pytest.approx(reach, rel=1e-12)
    assert found["worst_case"]["low"] == pytest.approx(nominal / MM + reach[0], rel=1e-14)
    assert found["worst_case"]["high"] == pytest.approx(nominal / MM + reach[1], rel=1e-14)
    spread = np.array(slopes) * np.ptp(SIZES, axis=1) / 6
    sigma = np.sqrt((spread**2).sum() + 2 * 0.3 * spread[0] * spread[1])
    assert found["rss"]["sigma"] == pytest.approx(sigma, rel=1e-12)
    mean = nominal / MM + np.array(slopes) @ SIZES.mean(axis=1)
    assert [found["rss"][key] for key in ("mean", "low", "high")] == pytest.approx(
        [mean, mean - 3 * sigma, mean + 3 * sigma], rel=1e-14
    )
    assert found["monte_carlo"]["mean"] == pytest.approx(mean, abs=5 * sigma / 2000**0.5)
    low, high = found["monte_carlo"]["sigma_interval"]
    assert low < sigma < high
    assert found["worst_case"]["searched"] == {
        "low": pytest.approx(nominal / MM - 0.2),
        "high": pytest.approx(nominal / MM + 0.25),
        "off": 0.07,
        "proven": False,
        "low_at": {"r": -0.05, "l": -0.02, "e": -0.1},
        "high_at": pytest.approx({"r": 0.05, "l": 0.08, "e": 0.1}),
    }


def test_contributors_are_ranked_and_add_up(entry: dict[str, Any]) -> None:
    for found in entry["accuracy"].values():
        rows = found["contributors"]
        assert sorted(row["parameter"] for row in rows) == ["e", "l", "r"]
        shares = [row["share"] for row in rows]
        assert shares == sorted(shares, reverse=True)
        assert sum(shares) == pytest.approx(1, rel=1e-12)
        assert np.sum([row["worst"] for row in rows], axis=0) == pytest.approx(found["worst_case"]["deviation"])
        for row in rows:
            assert row["unit"] == "mm/mm"
            low, high = sorted(row["coefficient"] * end for end in row["tolerance"])
            assert row["worst"] == pytest.approx([low, high])


def test_a_signal_has_its_widest_pose_and_its_positions(made: AccuracyOutcome, entry: dict[str, Any]) -> None:
    found, curve = entry["accuracy"]["C.x"], made.curves["C.x"]
    assert found["at"] == pytest.approx(curve.t[curve.widest])
    assert found["at_unit"] == "s"
    assert set(found["positions"]) == {"far", "out"}
    out = found["positions"]["out"]
    assert (out["at"], out["nominal"]) == pytest.approx((0.5, place(np.pi, *NOMINAL.values())[0] / MM))
    assert (found["poses"], found["poses_parted"]) == (61, 0)


def test_what_is_not_of_one_output(entry: dict[str, Any]) -> None:
    assert set(entry) == {"accuracy", "accuracy_study"}
    study = entry["accuracy_study"]
    assert study["contributors"]["l"] == {
        "stated": "[-0.02, 0.08]",
        "nominal": pytest.approx(160),
        "unit": "mm",
        "tolerance": pytest.approx([-0.02, 0.08]),
        "distribution": "normal",
        "mean": pytest.approx(0.03),
        "sigma": pytest.approx(0.1 / 6),
    }
    assert study["correlations"] == [{"of": ["r", "l"], "is": 0.3}]
    (joint,) = study["joints"]
    assert joint["clearance"] == pytest.approx(0.02)
    assert joint["contact_lost"] == [{"from": 0.24, "to": 0.26, "unit": "s", "cause": "max"}]
    assert (study["samples"], study["failed"], study["allocation"]) == (2000, 0, None)


def test_without_samples() -> None:
    done = outcome(count=0)
    found = accuracy_entry(done)["accuracy"]
    assert found["stroke"]["monte_carlo"] is None
    assert found["stroke"]["disagreement"] is None
    assert "no random samples" in str(sentences(done)[0])
    assert "NaN" not in summary_text(worded(accuracy_entry(done)))
    assert rows(overview(done)[0])[0][5] == "–"


def test_what_clearances_add_stands_with_the_outputs_where_there_are_any(made: AccuracyOutcome) -> None:
    (with_play,), (without,) = overview(made), overview(replace(made, joints=[]))
    assert heads(with_play)[6] == "Clearances"
    assert rows(with_play)[0][6] == "±0.040"
    assert heads(without) == [*heads(with_play)[:6], heads(with_play)[7]]
    assert rows(without) == [[*row[:6], row[7]] for row in rows(with_play)]


def test_a_number_that_is_none_is_null(made: AccuracyOutcome) -> None:
    figure = replace(made.figures["stroke"], nominal=np.nan, shares=np.full(3, np.nan))
    entry = accuracy_entry(replace(made, figures={"stroke": figure}))
    assert entry["accuracy"]["stroke"]["nominal"] is None
    assert "NaN" not in summary_text(worded(entry))
    assert "nan" not in str(rows(overview(replace(made, figures={"stroke": figure}))[0]))


def test_failed_samples_are_told() -> None:
    done = outcome(count=500, failed=25)
    assert accuracy_entry(done)["accuracy_study"]["failed_share"] == 25 / 525
    assert "25 of 525 samples (4.76 %)" in " ".join(map(str, sentences(done)))


@pytest.mark.parametrize(
    ("unit", "other", "expected"),
    [
        ("mm", "deg", "mm/deg"),
        ("N*m", "mm", "N*m/mm"),
        ("", "mm", "1/mm"),
        ("mm", "", "mm"),
        ("mm", "N/mm", "mm/(N/mm)"),
    ],
)
def test_units_of_coefficients(unit: str, other: str, expected: str) -> None:
    assert per(unit, other) == expected


# Where RSS and Monte Carlo disagree.


def test_they_agree_where_samples_are_as_wide_as_they_should_be(made: AccuracyOutcome) -> None:
    for figure in made.every.values():
        found = disagreement(figure, made)
        assert found is not None
        assert found.sigma_ratio == pytest.approx(1, abs=0.1)
        assert (found.parted, found.sentence("it")) == (False, None)
    assert not along(made.curves["C.x"], made).any()


def test_they_part_ways_by_how_much() -> None:
    done = outcome(stretch=1.5)
    entry = accuracy_entry(done)["accuracy"]["stroke"]["disagreement"]
    assert entry["parted"]
    assert entry["sigma_ratio"] == pytest.approx(1.5, abs=0.1)
    assert entry["sigma_errors"] == pytest.approx(0.5 / 1.5 * (2 * 2000) ** 0.5, rel=0.1)
    assert f"{entry['sigma_ratio']:.4g} times that of RSS" in str(entry["sentence"])
    assert along(done.curves["C.x"], done).all()
    assert any("disagree" in str(text) for text in sentences(done))


def test_few_samples_prove_nothing() -> None:
    found = disagreement(outcome(count=30, stretch=1.5).figures["stroke"], outcome())
    assert found is not None
    assert found.sigma_ratio is not None
    assert found.sigma_ratio > 1.2
    assert not found.parted


def test_round_off_is_no_disagreement(made: AccuracyOutcome) -> None:
    figure = made.figures["stroke"]
    assert figure.monte_carlo is not None
    ends = (figure.nominal, figure.nominal + 1e-19)
    still = replace(figure.monte_carlo, mean=figure.nominal, sigma=1e-17, mean_interval=ends, sigma_interval=(0, 2e-17))
    found = disagreement(replace(figure, mean=0.0, sigma=1e-19, monte_carlo=still), made)
    assert found is not None
    assert (found.parted, found.sigma_ratio, found.mean_shift) == (False, 1, 0)
    scattered = disagreement(replace(figure, sigma=0.0), made)
    assert scattered is not None
    assert "scatter" in str(scattered.sentence("it"))


# Tables.


def test_the_review_for_a_spreadsheet_adds_up(made: AccuracyOutcome) -> None:
    figure = made.figures["stroke"]
    head, *lines = csv.reader(io.StringIO(review_text(figure, made)), delimiter="\t")
    assert all(len(row) == len(head) == 12 for row in lines)
    assert [row[0] for row in lines[:3]] == ["r", "e", "l"]
    parts = np.array([[float(cell) for cell in row[9:11]] for row in lines])
    np.testing.assert_allclose(parts[:3].sum(axis=0), parts[3], rtol=1e-8)
    np.testing.assert_allclose(parts[3], np.array(figure.worst) / MM, rtol=1e-8)
    lower, upper, slope = (float(cell) for cell in lines[0][4:7])
    np.testing.assert_allclose([slope * lower, slope * upper], parts[0], rtol=1e-8)
    assert lines[2][3] == "[-0.02, 0.08]"


def test_a_tie_shows_both_sides(made: AccuracyOutcome) -> None:
    figure = made.figures["stroke"]
    slopes = np.array([[-1.0, 1.0], [0.5, 0.5], [0, 0]])
    tied = replace(made, figures={"stroke": replace(figure, coefficients=slopes, tie=True)}, curves={})
    lines = {row[0]: row for row in rows(review(tied.figures["stroke"], tied))}
    assert lines["r"][4] == "-1 / 1 mm/mm"
    first = next(row for row in accuracy_entry(tied)["accuracy"]["stroke"]["contributors"] if row["parameter"] == "r")
    assert (first["coefficients"], first["worst"]) == ([-1, 1], pytest.approx([0, 0.05]))
    assert "two places" in section_of(tied)


def test_a_csv_row_for_each_output_and_contributor(made: AccuracyOutcome) -> None:
    lines = list(csv.DictReader(io.StringIO(contributors_csv(made) or "")))
    assert len(lines) == 4 * 3
    assert [row["output"] for row in lines[::3]] == ["stroke", "C.x", "C.x at far", "C.x at out"]
    for row in lines:
        index = made.contributors.names.index(row["parameter"])
        exact = made.every[row["output"]].coefficients[index]
        assert (float(row["coefficient below"]), float(row["coefficient above"])) == pytest.approx(tuple(exact))
        assert float(row["upper deviation"]) == pytest.approx(SIZES[index, 1])


def test_a_csv_row_for_each_pose(made: AccuracyOutcome) -> None:
    header, *lines = csv.reader(io.StringIO(made.dataset.csv("time") or ""))
    columns = dict(zip(header, np.array(lines, dtype=float).T, strict=True))
    curve = made.curves["C.x"]
    angle = 2 * np.pi * columns["t [s]"]
    exact = place(angle, *NOMINAL.values())
    np.testing.assert_allclose(columns["C.x nominal [mm]"] * MM, exact[0], rtol=1e-14)
    for name, slope in zip(NOMINAL, exact[1:], strict=True):
        np.testing.assert_allclose(columns[f"d(C.x)/d({name}) [mm/mm]"], slope, atol=1e-14)
    assert curve.sampled is not None
    np.testing.assert_allclose(columns["C.x sampled sigma [mm]"] * MM, curve.sampled[1], rtol=1e-14)
    assert lines[0][header.index("C.x count")] == "2000"
    assert {"C.x play shift [mm]", "C.x play bound [mm]", "C.x worst low [mm]"} <= set(header)


def test_netcdf_is_in_si(made: AccuracyOutcome) -> None:
    with netcdf_file(io.BytesIO(made.dataset.netcdf()), mmap=False) as file:
        v, curve = file.variables, made.curves["C.x"]
        np.testing.assert_array_equal(v["C.x sigma"][:], curve.sigma)
        assert v["C.x sigma"].units == b"m"
        np.testing.assert_array_equal(v["d(C.x)_u002fd(e)"][:], curve.coefficients[2])
        np.testing.assert_array_equal(v["stroke: shares"][:], made.figures["stroke"].shares)
        assert file.contributors.split() == [b"r", b"l", b"e"]


# The page.


def test_the_section(made: AccuracyOutcome) -> None:
    text = section_of(made)
    assert text.count('class="plot study graph"') == 3 + 4 * 4
    assert "nan" not in re.sub('data-copy="[^"]*"', "", text).lower()
    copied = re.findall('data-copy="([^"]*)"', text)
    assert [unescape(each) for each in copied] == [review_text(figure, made) for figure in made.every.values()]
    assert "lower bound of the worst case" in text
    assert 'href="#accuracy"' in page(report_data(lw.Document.model_validate(slider_crank()), Outcomes(accuracy=made)))


def test_names_are_escaped() -> None:
    text = section_of(outcome(count=50, name='max(C.x, 1)<b>"'))
    assert "<b>" not in text
    assert "&lt;b&gt;&quot;" in text


def test_a_gap_in_a_signal_is_a_gap_in_its_band(made: AccuracyOutcome) -> None:
    curve = made.curves["C.x"]
    gone = np.where((curve.t > 0.4) & (curve.t < 0.6), np.nan, 1.0)
    some = {"nominal": curve.nominal * gone, "coefficients": curve.coefficients * gone, "worst": curve.worst * gone}
    some |= {"mean": curve.mean * gone, "sigma": curve.sigma * gone}
    whole, holed = (graph(curve_charts(each, made)[0].content) for each in (curve, replace(curve, **some)))
    lost = np.isnan(gone)[thinned(curve.t.size, MOST_POSES)]
    for one, expected in ((whole, 0 * lost), (holed, lost)):
        for row in one.rows:
            if not isinstance(row, Dots):
                high = row.high if isinstance(row, Band) else row.values
                assert (np.isnan(high) == expected).all()


def test_what_does_not_scatter_has_no_pareto_chart(made: AccuracyOutcome) -> None:
    figure = replace(made.figures["stroke"], shares=np.zeros(3), monte_carlo=None)
    assert figure_charts(figure, made) == []


def test_many_contributors_are_gathered(made: AccuracyOutcome) -> None:
    many = replace(made.contributors, every=made.contributors.every * 5, correlation=np.eye(15))
    figure = replace(made.figures["stroke"], shares=np.full(15, 1 / 15), monte_carlo=None)
    (chart,) = figure_charts(figure, replace(made, contributors=many))
    found = graph(chart.content)
    assert len(found.names) == only(Bars, found.rows).values.size == 9
    assert str(found.names[-1]) == "7 others"
    assert only(Line, found.rows).values[-1] == pytest.approx(100)


def test_nothing_computed_is_said(made: AccuracyOutcome) -> None:
    empty = replace(made, figures={}, curves={}, joints=[])
    (section,) = report(empty).sections
    assert told(section) == "Nothing was computed."
    kinds = [getattr(block, "name", type(block)) for block in section.blocks if filled(block)]
    assert kinds == [Sentences, "correlations"]  # neither outputs nor anything of one
    assert accuracy_entry(empty)["accuracy"] == {}
    assert (contributors_csv(empty), empty.dataset.csv("time")) == (None, None)
