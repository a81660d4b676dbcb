"""Charts of studies in a real browser: what is read at the cursor, zoom, legend, files, paper, without scripts."""

from __future__ import annotations

import csv
import re
from collections.abc import Iterator
from functools import cache
from itertools import product
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

import linkwright as lw
from helpers.accuracies import outcome as accuracy_outcome
from helpers.charts import only, plane, titled
from helpers.heat_seal import heat_seal
from helpers.heat_seal import performed as cam_performed
from helpers.workspaces import arm, performed
from linkwright.presentation.charts import Field
from linkwright.report import ReportData, page
from linkwright.report.build import report_data
from linkwright.studies.registry import Outcomes
from linkwright.studies.sweep.charts import charts
from linkwright.studies.sweep.outcome import SweepOutcome
from linkwright.words import say
from studies.models import CRANK, four_bar, slider_crank

pytestmark = pytest.mark.browser
sync_api = pytest.importorskip("playwright.sync_api")

SVG = "{http://www.w3.org/2000/svg}"
CYCLE = {"turns": "1 motor", "samples": 24}
B, C = [100.0, 110.0, 120.0], [50.0, 60.0, 80.0, 90.0]
SWING = "swing over c and b"


@cache
def swept() -> tuple[lw.Document, SweepOutcome]:
    """A grid of two lengths of a four-bar; it can't be assembled all round with the shorter rockers."""
    data = four_bar(
        drives={"motor": CRANK},
        studies={"cycle": CYCLE},
        measures={"swing": {"span": "rocker.angle"}},
        require={"swing": ">= 70 deg"},
    )
    document = lw.Document.model_validate(data)
    return document, lw.sweep(document, {"c": C, "b": B}, ["swing", "B.x"])


@cache
def sweep_data() -> ReportData:
    document, outcome = swept()
    return report_data(document, Outcomes(sweep=outcome))


@cache
def accuracy_data() -> ReportData:
    return report_data(lw.Document.model_validate(slider_crank()), Outcomes(accuracy=accuracy_outcome(count=200)))


@cache
def workspace_data() -> ReportData:
    asked = {"steps": 40, "show": ["manipulability"], "levels": {"manipulability": [500, 1000]}}
    job = performed(arm(quality=asked, trajectories={"hold": "elbow", "steps": 12}))
    assert job.examined.document is not None
    return report_data(job.examined.document, job.outcomes)


@cache
def cam_data() -> ReportData:
    job = cam_performed(heat_seal(steps=90))
    assert job.examined.document is not None
    return report_data(job.examined.document, job.outcomes)


class Opened:
    """A page on screen with everything it complained about."""

    def __init__(self, browser: Any, path: Path, **settings: Any) -> None:
        settings = {"viewport": {"width": 1400, "height": 1200}, "reduced_motion": "reduce"} | settings
        self.context = browser.new_context(**settings)
        self.context.set_offline(True)
        self.page = self.context.new_page()
        self.complaints: list[str] = []
        self.page.on("console", lambda m: self.complaints.append(m.text))
        self.page.on("pageerror", lambda e: self.complaints.append(str(e)))
        self.page.goto(path.as_uri())

    def settle(self) -> None:
        """Frames for what observers report, and for drawing."""
        self.page.evaluate(
            "async () => { for (let i = 0; i < 6; i++) await new Promise(r => requestAnimationFrame(r)); }"
        )

    def chart(self, title: str) -> Any:
        """The chart of a title, in sight."""
        box = self.page.locator("figure.study").filter(
            has=self.page.locator("figcaption > span:first-child").filter(has_text=re.compile(f"^{re.escape(title)}"))
        )
        found = box.first
        found.scroll_into_view_if_needed()
        self.settle()
        return found

    def read(self, chart: Any) -> list[str]:
        """What is read at the cursor."""
        return [text.replace("−", "-") for text in chart.locator(".readout output").all_inner_texts()]

    def hover(self, chart: Any, x: float, y: float) -> list[str]:
        """Points at a place of a plane, by the numbers at its axes; gives what is read there."""
        px, py = self.pixel(chart, x, y)
        self.page.mouse.move(px, py)
        self.settle()
        return self.read(chart)

    def pixel(self, chart: Any, x: float, y: float) -> tuple[float, float]:
        """Where a place of a plane is on the screen, by the numbers of its axes."""
        js = """picture => {
          const of = axis => [...picture.querySelectorAll("g > text")]
            .filter(t => t.getAttribute("text-anchor") === axis && /^[−\\d.]+$/.test(t.textContent))
            .map(t => [Number(t.textContent.replace("−", "-")), t.getBoundingClientRect()]);
          return [of("middle").slice(0, 3).map(([v, r]) => [v, r.x + r.width / 2]),
                  of("end").map(([v, r]) => [v, r.y + r.height / 2])];
        }"""
        across, up = chart.locator(".plane-picture").evaluate(js)
        return _along(across[:2], x), _along([up[0], up[-1]], y)

    def save(self, chart: Any, kind: str) -> Path:
        with self.page.expect_download() as waiting:
            chart.get_by_label(say("report.plots.export")).click()
            chart.get_by_role("button", name=kind).click()
        assert waiting.value.suggested_filename.endswith(f".{kind.lower()}")
        return Path(waiting.value.path())

    def table(self, chart: Any) -> tuple[list[str], Any]:
        """Its CSV: the head, the numbers."""
        head, *rows = csv.reader(self.save(chart, "CSV").read_text(encoding="utf-8-sig").splitlines())
        return head, np.array([[float(cell or "nan") for cell in row] for row in rows])


def _along(marks: list[list[float]], value: float) -> float:
    (a, pa), (b, pb) = marks
    return pa + (value - a) / (b - a) * (pb - pa)


@pytest.fixture
def show(browser: Any, tmp_path: Path) -> Iterator[Any]:
    opened: list[Opened] = []

    def open_(data: ReportData, **settings: Any) -> Opened:
        file = tmp_path / f"report{len(opened)}.html"
        file.write_text(page(data), encoding="utf-8")
        opened.append(Opened(browser, file, **settings))
        return opened[-1]

    yield open_
    for each in opened:
        assert each.complaints == []
        each.context.close()


def of_samples(c: float, b: float) -> float:
    """The swing (deg) of the sample with these lengths (mm), NaN where it has none."""
    table = swept()[1].table
    assert table is not None
    (found,) = table.figures[0][np.isclose(table.parameters[0], c / 1e3) & np.isclose(table.parameters[1], b / 1e3)]
    return float(np.degrees(found)) if np.isfinite(found) else np.nan


def test_a_contour_plot_reads_both_parameters_and_the_value(show: Any) -> None:
    view = show(sweep_data())
    chart = view.chart(SWING)
    c, b, swing = view.hover(chart, 80, 110)
    assert (float(c.split()[0]), float(b.split()[0])) == (pytest.approx(80, abs=0.2), pytest.approx(110, abs=0.2))
    assert (c.split()[1], b.split()[1], swing.split()[1]) == ("mm", "mm", "deg")
    assert float(swing.split()[0]) == pytest.approx(of_samples(80, 110), rel=0.02)
    assert "swing >= 70 deg" in chart.locator(".plane-picture text").all_text_contents()
    assert chart.locator(".plane-picture image").get_attribute("href").startswith("data:image/png;base64,")


def test_gaps_are_empty_and_marked(show: Any) -> None:
    view = show(sweep_data())
    chart = view.chart(SWING)
    lost = [(c, b) for c, b in product(C, B) if np.isnan(of_samples(c, b))]
    assert 0 < len(lost) < 12 and (C[0], B[-1]) in lost and (C[-1], B[0]) not in lost
    assert view.hover(chart, C[0] + 0.5, B[-1] - 0.5)[2] == "–"
    assert chart.locator(".entry", has_text=say("sweep.chart.missing")).is_visible()
    alpha = """async image => {
      const picture = new Image();
      picture.src = image.getAttribute("href");
      await picture.decode();
      const canvas = document.createElement("canvas");
      [canvas.width, canvas.height] = [picture.width, picture.height];
      const context = canvas.getContext("2d", { willReadFrequently: true });
      context.drawImage(picture, 0, 0);
      const at = (x, y) => context.getImageData(x, y, 1, 1).data[3];
      return [at(2, 2), at(canvas.width - 3, canvas.height - 3)];
    }"""
    assert chart.locator(".plane-picture image").evaluate(alpha) == [0, 255]


def test_a_family_has_a_curve_for_each_value_of_the_second_parameter(show: Any) -> None:
    view = show(sweep_data())
    chart = view.chart(SWING)
    chart.get_by_label(say("report.plots.view")).select_option("family")
    view.settle()
    names = [text.split("\n")[0] for text in chart.locator(".legend button").all_inner_texts()]
    assert names == ["b = 100 mm", "b = 110 mm", "b = 120 mm"]
    assert chart.locator(".level text").all_text_contents() == ["swing >= 70 deg"]
    over = chart.locator(".u-over")
    over.focus()
    view.page.keyboard.press("ArrowRight")
    for _ in range(4):
        view.page.keyboard.press("ArrowRight")
    assert view.read(chart) == ["90.000 mm"]
    values = [text.replace("−", "-") for text in chart.locator(".legend button output").all_inner_texts()]
    expected = [of_samples(90, b) for b in B]
    for text, value in zip(values, expected, strict=True):
        assert np.isnan(value) if text.startswith("–") else float(text.split()[0]) == pytest.approx(value, rel=1e-4)
    head, rows = view.table(chart)
    assert head == ["c [mm]", "b = 100 mm [deg]", "b = 110 mm [deg]", "b = 120 mm [deg]"]
    wanted = [[c, *(of_samples(c, b) for b in B)] for c in C]
    np.testing.assert_allclose(rows, wanted, rtol=1e-5)
    button = chart.get_by_role("button", name="b = 110 mm")
    button.click()
    assert button.get_attribute("aria-pressed") == "false"
    texts = [each.text for each in ElementTree.parse(view.save(chart, "SVG")).getroot().iter(f"{SVG}text")]
    assert "b = 100 mm" in texts and "b = 110 mm" not in texts
    chart.get_by_label(say("report.plots.view")).select_option("")
    view.settle()
    assert chart.locator(".plane-picture image").count() == 1


def test_tables_of_a_grid_have_the_samples(show: Any) -> None:
    view = show(sweep_data())
    head, rows = view.table(view.chart(SWING))
    assert head == ["c [mm]", "b [mm]", "swing [deg]"]
    np.testing.assert_allclose(rows, [[c, b, of_samples(c, b)] for b, c in product(B, C)], rtol=1e-5)
    head, rows = view.table(view.chart("B.x"))
    band = swept()[1].bands["B.x"]
    assert head[:3] == ["time [s]", "minimum to maximum min [mm]", "minimum to maximum max [mm]"]
    expected = [swept()[1].t, 1e3 * band.least, 1e3 * band.largest]
    for column, values in zip(rows.T, expected, strict=False):
        np.testing.assert_allclose(column, values, atol=1e-5 * np.nanmax(np.abs(values)))
    np.testing.assert_allclose(rows[:, -1], 1e3 * band.mean, atol=1e-3)


def test_zoom_by_drag_and_back(show: Any) -> None:
    view = show(sweep_data())
    chart = view.chart(SWING)
    back = chart.get_by_role("button", name=say("report.plots.reset_zoom"))
    assert not back.is_visible()
    ticks = chart.locator(".plane-picture text").all_inner_texts()
    from_, to = view.pixel(chart, 70, 104), view.pixel(chart, 80, 112)
    view.page.mouse.move(*from_)
    view.page.mouse.down()
    view.page.mouse.move(*to, steps=4)
    assert float(chart.locator(".plane-selection").get_attribute("width")) > 20
    view.page.mouse.up()
    view.settle()
    assert chart.locator(".plane-picture text").all_inner_texts() != ticks
    c, b, _ = view.hover(chart, 75, 108)
    assert (float(c.split()[0]), float(b.split()[0])) == (pytest.approx(75, abs=0.1), pytest.approx(108, abs=0.1))
    back.click()
    view.settle()
    assert chart.locator(".plane-picture text").all_inner_texts() == ticks and not back.is_visible()
    band = view.chart("B.x")
    over, area = band.locator(".u-over"), band.locator(".u-over").bounding_box()
    view.page.mouse.move(area["x"] + 60, area["y"] + 50)
    view.page.mouse.down()
    view.page.mouse.move(area["x"] + 160, area["y"] + 50, steps=4)
    view.page.mouse.up()
    view.settle()
    assert band.get_by_role("button", name=say("report.plots.reset_zoom")).is_visible()
    over.dblclick()
    assert not band.get_by_role("button", name=say("report.plots.reset_zoom")).is_visible()


def test_keys_move_the_cursor_zoom_and_reset(show: Any) -> None:
    view = show(sweep_data())
    chart = view.chart(SWING)
    picture = chart.locator(".plane-picture")
    assert picture.get_attribute("aria-label") == SWING and picture.get_attribute("role") == "img"
    picture.focus()
    view.page.keyboard.press("ArrowUp")
    first = view.read(chart)
    view.page.keyboard.press("Shift+ArrowRight")
    moved = view.read(chart)
    assert float(moved[0].split()[0]) - float(first[0].split()[0]) == pytest.approx(4.0, rel=1e-3)  # a tenth of 40 mm
    view.page.keyboard.press("+")
    back = chart.get_by_role("button", name=say("report.plots.reset_zoom"))
    assert back.is_visible()
    view.page.keyboard.press("Escape")
    assert not back.is_visible()


def test_histograms_and_pareto_charts_of_an_accuracy_study(show: Any) -> None:
    view = show(accuracy_data())
    study = accuracy_outcome(count=200)
    figure = next(iter(study.every.values()))
    assert figure.monte_carlo is not None
    chart = view.chart(f"{figure.title}: samples")
    head, rows = view.table(chart)
    np.testing.assert_allclose(rows[:, 3], figure.monte_carlo.counts)
    np.testing.assert_allclose(rows[:, 1] * figure.column.size, figure.monte_carlo.edges[:-1], rtol=1e-5)
    assert head[1].endswith("min [mm]") and head[2].endswith("max [mm]")
    assert chart.locator(".level text").all_text_contents() == [say("accuracy.chart.worst")] * 2
    pareto = view.chart(f"{figure.title}: shares of variance")
    pareto.locator(".u-over").hover(position={"x": 40, "y": 60})
    view.settle()
    name = view.read(pareto)[0]
    assert name in study.contributors.names
    share = float(pareto.locator(".legend button output").first.inner_text().split()[0])
    assert share == pytest.approx(100 * figure.shares[list(study.contributors.names).index(name)], rel=1e-3)


def test_maps_of_a_workspace_are_read_within_their_region_alone(show: Any) -> None:
    """The arm's det J is a b sin(elbow), which follows from the distance to the shoulder."""
    view = show(workspace_data())
    chart = view.chart(say("workspace.map.manipulability", determinant="d(E.x, E.y)/d(shoulder, elbow)", point="E"))
    for place in ((40, 20), (-30, 35), (5, -50)):
        x, y, value = view.hover(chart, *place)
        far = np.hypot(float(x.split()[0]), float(y.split()[0]))
        exact = 40 * 30 * np.sqrt(1 - ((far**2 - 40**2 - 30**2) / (2 * 40 * 30)) ** 2)
        assert float(value.split()[0]) == pytest.approx(exact, rel=0.03), place
    assert view.hover(chart, 2, 2)[2] == "–"  # the hole


def test_lines_of_a_workspace_have_equal_axes_and_their_drives_values(show: Any) -> None:
    view = show(workspace_data())
    chart = view.chart("Trajectories of E")
    (ax, ay), (bx, by) = view.pixel(chart, 0, 0), view.pixel(chart, 40, 40)
    assert bx - ax == pytest.approx(ay - by, rel=0.02)
    held = view.hover(chart, 0, 50)[2]  # the elbow at 90 deg is a circle of that radius
    assert float(held.split()[0]) in (pytest.approx(90, abs=1e-6), pytest.approx(270, abs=1e-6))
    texts = [each.text for each in ElementTree.parse(view.save(chart, "SVG")).getroot().iter(f"{SVG}text")]
    assert any("Trajectories of E" in (text or "") for text in texts)
    assert view.save(chart, "PNG").read_bytes().startswith(b"\x89PNG")
    rows = view.save(chart, "CSV").read_text(encoding="utf-8-sig").splitlines()
    assert rows[0].startswith("curve,part,x [mm],y [mm],")
    places = np.array([[float(cell) for cell in row.rsplit(",", 3)[1:3]] for row in rows[1:] if row.endswith(",90")])
    np.testing.assert_allclose(np.hypot(*places.T), 50, rtol=2e-3)


def test_the_picture_of_a_cam_zooms_and_is_saved(show: Any) -> None:
    view = show(cam_data())
    figure = view.page.locator("#cam .chart-still")
    figure.scroll_into_view_if_needed()
    picture = figure.locator("svg.cam")
    whole, box = picture.get_attribute("viewBox"), picture.bounding_box()
    origin = picture.locator("circle.base").bounding_box()
    x, y = origin["x"] + origin["width"] / 2, origin["y"] + origin["height"] / 2
    view.page.mouse.move(x, y)
    assert [abs(float(text.split()[0].replace("−", "-"))) < 0.5 for text in view.read(figure)] == [True, True]
    view.page.mouse.move(box["x"] + box["width"] * 0.4, box["y"] + box["height"] * 0.2)
    view.page.mouse.down()
    view.page.mouse.move(x, y, steps=4)
    view.page.mouse.up()
    assert picture.get_attribute("viewBox") != whole
    root = ElementTree.parse(view.save(figure, "SVG")).getroot()
    assert root.get("width") == "560" and root.find(f"{SVG}style") is not None
    picture.dblclick()
    assert picture.get_attribute("viewBox").split() == whole.split()


@pytest.mark.parametrize("data", [sweep_data, accuracy_data, workspace_data, cam_data])
@pytest.mark.parametrize("settings", [{"viewport": {"width": 390, "height": 800}}, {"color_scheme": "dark"}])
def test_pages_fit_a_phone_and_paper_has_all_charts_in_light(show: Any, data: Any, settings: dict[str, Any]) -> None:
    made = data()
    view = show(made, **settings)
    for figure in view.page.locator("figure.study").all():
        figure.scroll_into_view_if_needed()
        view.settle()
    width = view.page.viewport_size["width"]
    assert view.page.evaluate("document.documentElement.scrollWidth") <= width
    labels = view.page.locator(".plane-picture text").first
    if settings.get("color_scheme") == "dark" and labels.count():
        assert labels.evaluate("text => getComputedStyle(text).fill") == "rgb(154, 167, 180)"
    view.page.emulate_media(media="print")
    view.settle()
    paper = view.page.locator("figure.study .chart-paper:visible")
    assert paper.count() == view.page.locator("figure.study").count() > 2
    text = view.page.locator(".plane-paper text")
    if text.count():
        assert text.first.get_attribute("fill") == "#5b6876"
    view.page.emulate_media(media="screen")
    view.settle()
    assert view.page.locator(".chart-paper").count() == 0


@pytest.mark.parametrize("data", [sweep_data, accuracy_data, workspace_data, cam_data])
def test_without_scripts_a_sentence_stands_for_the_charts(show: Any, data: Any) -> None:
    view = show(data(), java_script_enabled=False)
    assert view.page.locator("noscript p").all_inner_texts().count(say("report.no_script_charts")) == 1
    assert view.page.locator("figure.study:visible, .charts-hint:visible, .sliders:visible").count() == 0
    assert view.page.locator("table:visible").count() > 0


def test_legends_are_in_the_language_of_the_page(show: Any) -> None:
    view = show(sweep_data())
    view.page.goto(f"{view.page.url}?lang=zh-CN")
    chart = view.page.locator("figure.study.graph").last
    chart.scroll_into_view_if_needed()
    view.settle()
    assert "均值" in chart.locator(".legend").inner_text()
    assert "时间" in chart.locator(".readout").inner_text()
    assert view.page.get_by_label("显示方式").first.locator("option").all_inner_texts() == ["等值线图", "曲线族"]


def test_the_field_of_the_page_is_that_of_the_study() -> None:
    """The samples that the other tests look up are those of the chart."""
    field = only(Field, plane(titled(charts(swept()[1]))[SWING]).layers)
    for (row, b), (column, c) in product(enumerate(field.y), enumerate(field.x)):
        np.testing.assert_allclose(field.values[row, column], of_samples(c, b))
