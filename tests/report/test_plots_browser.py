"""Plots of a live report in a real browser: what a reader chooses, how it is shown, what is saved."""

from __future__ import annotations

import csv
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

import linkwright as lw
from helpers.longer import mostly_long
from linkwright.report import ReportData, page
from linkwright.report.build import report_data
from linkwright.results import Result

pytestmark = pytest.mark.browser
sync_api = pytest.importorskip("playwright.sync_api")

EXAMPLES = Path(__file__).parents[2] / "examples"
CHANGED = "Changed: not verified"
SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The paper feeder, with a limit of its feeding speed."""
    text = (EXAMPLES / "paper_feeder.yaml").read_text(encoding="utf-8")
    file = tmp_path_factory.mktemp("model") / "feeder.yaml"
    limit = '  stroke: ">= 680 mm"\n'
    assert limit in text
    file.write_text(text.replace(limit, f'{limit}  feed_speed_max: "<= 1300 mm/s"\n'), encoding="utf-8")
    return file


@pytest.fixture(scope="module")
def made(path: Path) -> tuple[ReportData, Result]:
    """The report's data and the result at the times of the page."""
    job = lw.run(path)
    data = report_data(lw.load(path), job.outcomes)
    assert job.cycle is not None and data["live"] is not None
    return data, job.cycle.result.at(np.array(data["live"]["times"]))


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
        self.first = self.page.locator("#first-plots figure")
        self.page.evaluate("document.querySelector('#plots, #motion').scrollIntoView()")
        self.settle()

    def settle(self) -> None:
        """Frames for what observers report, and for drawing."""
        self.page.evaluate(
            "async () => { for (let i = 0; i < 6; i++) await new Promise(r => requestAnimationFrame(r)); }"
        )

    def add(self, query: str) -> Any:
        """The plot that the first hit of a search adds."""
        self.page.get_by_role("combobox", name="Add a plot").fill(query)
        self.page.keyboard.press("Enter")
        self.settle()
        plot = self.first.last
        plot.scroll_into_view_if_needed()
        self.settle()
        return plot

    def overlay(self, plot: Any, query: str) -> None:
        plot.get_by_role("button", name="Overlay a signal").click()
        self.page.keyboard.type(query)
        self.page.keyboard.press("Enter")
        self.settle()

    def columns(self, title: str) -> list[Any]:
        """What a plot draws: the horizontal axis, then all curves."""
        js = "name => linkwright.charts.find(c => c.series.some(s => s.label === name)).data.map(row => [...row])"
        return [np.array(row, dtype=float) for row in self.page.evaluate(js, title)]

    def change(self, name: str, value: float) -> None:
        self.page.evaluate(
            """([name, value]) => { const { live } = linkwright;
            live.set(live.data.numbers.findIndex(n => n.name === name), value); }""",
            [name, value],
        )
        self.settle()

    def save(self, plot: Any, kind: str) -> Path:
        with self.page.expect_download() as waiting:
            plot.get_by_label("Save as a file").click()
            plot.get_by_role("button", name=kind).click()
        download = waiting.value
        assert download.suggested_filename.endswith(f".{kind.lower()}")
        return Path(download.path())

    def index(self) -> int:
        return int(self.page.get_by_role("slider", name="time").input_value())


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


@pytest.fixture
def view(show: Any, made: tuple[ReportData, Result]) -> Opened:
    opened: Opened = show(made[0])
    return opened


def test_four_plots_stand_first_and_the_others_show_their_values(view: Opened, made: tuple[ReportData, Result]) -> None:
    titles = [text.split("\n")[0] for text in view.first.locator(".fold").all_inner_texts()]
    assert titles == ["Drive torque N·m", "Force of frame on crank N", "Point E: velocity mm/s", "Point E: position mm"]
    folded = view.page.locator("#motion figure").first
    assert folded.locator("canvas").count() == 0
    view.page.get_by_role("slider", name="time").fill("30")
    view.settle()
    name, value = folded.locator(".entry").first.inner_text().split()
    assert float(value.replace("−", "-")) == pytest.approx(made[1].shown(name)[0][30], rel=1e-4)
    folded.get_by_role("button", name="Point B: position").click()
    view.settle()
    assert folded.locator("canvas").count() == 1


def test_a_search_adds_a_plot_whose_values_are_pythons(view: Opened, made: tuple[ReportData, Result]) -> None:
    entry = view.page.get_by_role("combobox", name="Add a plot")
    entry.fill("jerk crank")
    first = view.page.locator(".combobox [role='option']").first
    assert "crank.jerk" in first.inner_text() and "deg/s³ · link" in first.inner_text()
    plot = view.add("com(coupler).ay")
    assert plot.locator("figcaption").inner_text().startswith("com(coupler).ay mm/s²")
    times, values = view.columns("com(coupler).ay")
    assert times == pytest.approx(made[1].t, abs=1e-12)
    expected, _ = made[1].shown("com(coupler).ay")
    assert values == pytest.approx(expected, abs=1e-9 * np.abs(expected).max())
    plot.get_by_role("button", name="Remove the plot").click()
    assert view.first.count() == 4


def test_all_signals_can_be_found(view: Opened, made: tuple[ReportData, Result]) -> None:
    listed = view.page.evaluate("linkwright.live.data.signals")
    assert sorted(listed) == sorted(name for name in made[1].names if not name.endswith(".arm"))


def test_another_unit_gets_the_right_axis_and_a_third_is_not_offered(
    view: Opened, made: tuple[ReportData, Result]
) -> None:
    plot = view.first.first
    view.overlay(plot, "crank.omega")
    _, torque, omega = view.columns("crank.omega")
    assert torque == pytest.approx(made[1].shown("motor.torque")[0], rel=1e-9, abs=1e-9)
    assert omega == pytest.approx(made[1].shown("crank.omega")[0])
    scales = view.page.evaluate(
        "linkwright.charts.find(c => c.series.length === 3 && c.axes.length === 3).series.map(s => s.scale)"
    )
    assert scales == ["x", "y", "right"]
    plot.get_by_role("button", name="Overlay a signal").click()
    view.page.keyboard.type("E.x")
    assert view.page.locator(".combobox [role='option']").count() == 0
    assert view.page.get_by_text("No signal matches.").is_visible()
    view.page.keyboard.press("Escape")
    view.page.keyboard.press("Escape")
    assert plot.locator(".overlay").count() == 0
    plot.get_by_role("button", name="Remove crank.omega").click()
    view.settle()
    assert plot.locator(".entry").count() == 1


def test_choices_are_kept_for_the_next_visit(view: Opened) -> None:
    view.add("energy.kinetic")
    view.first.nth(1).get_by_label("Representation").select_option("polar")
    view.page.get_by_label("Horizontal axis").select_option("motor.angle")
    view.page.reload()
    view.page.evaluate("document.querySelector('#plots').scrollIntoView()")
    view.settle()
    assert view.first.count() == 5
    assert view.first.locator(".polar").count() == 1
    assert view.page.get_by_label("Horizontal axis").input_value() == "motor.angle"
    view.page.get_by_role("button", name="Default plots").click()
    view.settle()
    assert view.first.count() == 4
    assert view.first.locator(".polar").count() == 0


def test_over_the_drives_angle_cursor_and_drawing_stay_linked(view: Opened, made: tuple[ReportData, Result]) -> None:
    view.page.get_by_label("Horizontal axis").select_option("motor.angle")
    view.settle()
    angle, torque = view.columns("motor.torque")
    expected, unit = made[1].shown("motor.angle")
    assert unit == "deg"
    assert angle == pytest.approx(expected, rel=1e-9)
    assert torque == pytest.approx(made[1].shown("motor.torque")[0], rel=1e-9, abs=1e-9)
    view.page.get_by_role("slider", name="time").fill("60")
    view.settle()
    over = view.first.first.locator(".u-over")
    area, line = over.bounding_box(), over.locator(".u-cursor-x").bounding_box()
    share = (expected[60] - expected.min()) / np.ptp(expected)
    assert line["x"] + line["width"] == pytest.approx(area["x"] + area["width"] * share, abs=2)
    over.click(position={"x": area["width"] * 0.25, "y": 100})
    view.page.mouse.move(5, 5)
    wanted = int(np.argmin(np.abs(expected - (expected.min() + 0.25 * np.ptp(expected)))))
    assert abs(view.index() - wanted) <= 1


def test_a_polar_plot_shows_the_vector_of_the_moment(view: Opened, made: tuple[ReportData, Result]) -> None:
    plot = view.first.nth(1)
    plot.get_by_label("Representation").select_option("polar")
    view.page.get_by_role("slider", name="time").fill("50")
    view.settle()
    x, y = (made[1].shown(f"force(frame, crank).{axis}")[0] for axis in "xy")
    numbers = plot.locator(".arrow").get_attribute("d").replace("M", " ").replace("L", " ").replace("Z", "").split()
    ox, oy, tx, ty = map(float, numbers[:4])
    assert np.angle(complex(tx - ox, oy - ty)) == pytest.approx(np.angle(complex(x[50], y[50])), abs=0.01)
    # Equal axes: the lengths of two arrows are as the forces.
    first = abs(complex(tx - ox, ty - oy))
    view.page.get_by_role("slider", name="time").fill("12")
    view.settle()
    numbers = plot.locator(".arrow").get_attribute("d").replace("M", " ").replace("L", " ").replace("Z", "").split()
    ox, oy, tx, ty = map(float, numbers[:4])
    assert abs(complex(tx - ox, ty - oy)) / first == pytest.approx(
        abs(complex(x[12], y[12]) / complex(x[50], y[50])), rel=0.01
    )
    plot.get_by_label("Representation").select_option("magnitude")
    view.settle()
    _, size = view.columns("|force(frame, crank)|")
    assert size == pytest.approx(np.hypot(x, y), rel=1e-9)


def test_marks_of_measures_lead_to_their_times_and_limits_are_lines(
    view: Opened, made: tuple[ReportData, Result]
) -> None:
    plot = view.first.nth(2)
    assert plot.locator(".level text").count() == 2
    assert set(plot.locator(".level text").all_text_contents()) == {"feed_speed_max <= 1300 mm/s"}
    dot = plot.get_by_role("button", name="feed_speed_max")
    dot.click()
    view.page.mouse.move(5, 5)
    at = view.page.evaluate("linkwright.drawing.time")
    assert at == pytest.approx(1.17931, abs=2e-3)
    before = dot.bounding_box()
    view.change("AB", 0.17)
    after = dot.bounding_box()
    assert (before["x"], before["y"]) != (after["x"], after["y"])


def test_tables_have_the_values_of_python(view: Opened, made: tuple[ReportData, Result]) -> None:
    text = view.save(view.first.nth(1), "CSV").read_text(encoding="utf-8")
    head, *rows = csv.reader(text.splitlines())
    assert head == ["t [s]", "force(frame, crank).x [N]", "force(frame, crank).y [N]"]
    expected = [made[1].t, *(made[1].shown(f"force(frame, crank).{axis}")[0] for axis in "xy")]
    for column, values in zip(np.array(rows, dtype=float).T, expected, strict=True):
        assert column == pytest.approx(values, abs=1e-9 * np.abs(values).max())


def test_files_of_a_changed_model_say_so(view: Opened) -> None:
    view.page.get_by_label("Horizontal axis").select_option("motor.angle")
    view.change("AB", 0.17)
    plot = view.first.first
    comment, head, *_ = view.save(plot, "CSV").read_text(encoding="utf-8").splitlines()
    assert (comment, head) == (f"# {CHANGED}", "t [s],motor.angle [deg],motor.torque [N*m]")
    root = ElementTree.parse(view.save(plot, "SVG")).getroot()
    assert CHANGED in root.findtext(f"{SVG}title", "")
    assert CHANGED in [each.text for each in root.iter(f"{SVG}text")]
    picture = view.save(plot, "PNG").read_bytes()
    assert picture.startswith(b"\x89PNG")
    assert len(picture) > 4000


def test_pictures_are_light_on_a_dark_page_and_leave_hidden_curves_out(
    show: Any, made: tuple[ReportData, Result]
) -> None:
    view = show(made[0], color_scheme="dark")
    plot = view.first.nth(3)
    plot.scroll_into_view_if_needed()
    plot.get_by_role("button", name="E.y", exact=False).first.click()
    root = ElementTree.parse(view.save(plot, "SVG")).getroot()
    assert root.find(f"{SVG}rect").get("fill") == "#fff"
    texts = [each.text for each in root.iter(f"{SVG}text")]
    assert "E.x" in texts
    assert "E.y" not in texts
    assert "Point E: position, mm" in texts


def test_the_original_is_drawn_behind_a_changed_model(view: Opened) -> None:
    plot = view.first.first
    assert ElementTree.parse(view.save(plot, "SVG")).getroot().findall(".//*[@opacity='0.75']") == []
    view.change("AB", 0.17)
    assert len(ElementTree.parse(view.save(plot, "SVG")).getroot().findall(".//*[@opacity='0.75']")) == 1


def test_recorded_reports_keep_their_plots_and_save_them(show: Any) -> None:
    model = EXAMPLES / "parallelogram.yaml"
    data = report_data(lw.load(model), lw.run(model).outcomes)
    assert data["live"] is None
    view = show(data)
    plots = view.page.locator("figure.plot")
    assert plots.locator("canvas").count() == len(data["plots"])
    assert view.page.locator("#plot-bar").count() == 0
    head = view.save(plots.first, "CSV").read_text(encoding="utf-8").splitlines()[0]
    assert head.startswith("t [s],")


@pytest.mark.parametrize(
    "name",
    mostly_long(["platform", "heat_seal_cam", "press_law", "two_cylinder_workspace", "tailgate"], "tailgate".__eq__),
)
def test_every_signal_of_other_mechanisms_is_pythons(show: Any, name: str) -> None:
    """The page compares a value of each with the recorded one."""
    model = EXAMPLES / f"{name}.yaml"
    view = show(report_data(lw.load(model), lw.run(model).outcomes))
    assert view.page.evaluate("linkwright.live.sound")
    assert 2 <= view.first.count() <= 4


def test_plots_fit_a_phone_and_paper_has_them_all(show: Any, made: tuple[ReportData, Result]) -> None:
    view = show(made[0], viewport={"width": 390, "height": 800})
    assert view.page.evaluate("document.documentElement.scrollWidth") <= 390
    view.page.emulate_media(media="print")
    view.settle()
    assert view.page.locator(".chart-paper canvas").count() == len(made[0]["plots"])
