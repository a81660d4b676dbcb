"""The report in a real browser, from disk and without network."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from helpers.accuracies import outcome
from helpers.opened import Opened, opened, written
from helpers.workspaces import five_bar, performed
from linkwright.presentation.blocks import Chart, Charts, Check, Checks, Copied, Measures, Section, Table
from linkwright.report import ReportData, Scene, page
from linkwright.report.build import report_data
from linkwright.studies.accuracy.report import report as accuracy_report
from linkwright.words import in_language, say

pytestmark = pytest.mark.browser
sync_api = pytest.importorskip("playwright.sync_api")

HOSTILE = "</script><img src=x onerror=\"document.title='owned'\">"


@pytest.fixture
def show(browser: Any, tmp_path: Path) -> Iterator[Any]:
    yield from opened(browser, written(tmp_path))


@pytest.fixture
def accuracy(report: ReportData) -> Section:
    """What an accuracy study shows, as a part of the report."""
    (section,) = accuracy_report(outcome(count=50)).sections
    report["sections"] = [*report["sections"], section]
    return section


def test_loads_silently_and_asks_for_nothing(show: Any, report: ReportData) -> None:
    view = show(report)
    view.settle()
    assert view.complaints == []
    assert [url.split(":")[0] for url in view.requests if not url.startswith("data:")] == ["file"]
    assert view.page.locator(".uplot canvas").count() == len(report["plots"])


@pytest.mark.parametrize("index", [0, 37, 120, 200])
def test_slider_moves_the_pins_to_their_computed_places(show: Any, report: ReportData, feeder: Any, index: int) -> None:
    view = show(report)
    view.slider.fill(str(index))
    # The ground pivots A and D give scale and origin: nothing is taken from the drawing's own figures.
    a, d = view.pin("A"), view.pin("D")
    world = feeder.points["D"][index] - feeder.points["A"][index]
    scale = (d - a) / world
    assert abs(scale.imag) < 1e-3 * scale.real
    for name in "BCEG":
        expected = a + scale * (feeder.points[name][index] - feeder.points["A"][index])
        assert abs(view.pin(name) - expected) < 0.3, name


def test_between_samples_the_drawing_stays_closed(show: Any, report: ReportData, coarse: tuple[Any, Scene]) -> None:
    """With 26 poses a cycle, chords would leave the crank's circle by 0.8 % of its radius."""
    feeder, report["scene"] = coarse
    report["time"] = {"values": feeder.t.tolist(), "unit": "s", "label": "time"}
    report["plots"] = []
    view = show(report)
    radii = view.page.evaluate(
        """() => { const at = n => { const c = document.querySelector(`#drawing [data-point="${n}"]`);
        return [Number(c.getAttribute("cx")), Number(c.getAttribute("cy"))]; };
        const r = []; for (let i = 0; i < 60; i++) { linkwright.drawing.setTime(i * 0.025);
          r.push(Math.hypot(at("B")[0] - at("A")[0], at("B")[1] - at("A")[1])); } return r; }"""
    )
    assert np.ptp(radii) < 0.05


def test_slider_ties_every_visible_plot(show: Any, report: ReportData) -> None:
    view = show(report)
    for plot in (0, 1):  # drawn once they are in view
        view.page.locator("figure.plot").nth(plot).scroll_into_view_if_needed()
        view.settle()
    view.slider.fill("60")
    view.settle()
    for plot in (0, 1):
        expected = [series["values"][60] for series in report["plots"][plot]["series"]]
        assert [float(text) for text in view.legend(plot)] == pytest.approx(expected, rel=1e-4)
        area = view.page.locator(".u-over").nth(plot).bounding_box()
        line = view.page.locator(".u-over .u-cursor-x").nth(plot).bounding_box()
        assert line["x"] + line["width"] == pytest.approx(area["x"] + area["width"] * 60 / 200, abs=2)


def test_pointing_into_a_plot_moves_the_mechanism_and_leaving_goes_back(show: Any, report: ReportData) -> None:
    view = show(report)
    view.slider.fill("20")
    over = view.page.locator(".u-over").first
    area = over.bounding_box()
    over.hover(position={"x": area["width"] * 0.75, "y": 50})
    assert view.slider.input_value() == "150"
    view.page.mouse.move(5, 5)
    assert view.slider.input_value() == "20"
    over.click(position={"x": area["width"] * 0.5, "y": 50})
    view.page.mouse.move(5, 5)
    assert view.slider.input_value() == "100"


def test_dragging_enlarges_a_span_in_all_plots(show: Any, report: ReportData) -> None:
    view = show(report)
    plot = view.page.locator(".u-over").first
    plot.scroll_into_view_if_needed()
    area = plot.bounding_box()
    y = area["y"] + 50
    view.page.mouse.move(area["x"] + area["width"] * 0.2, y)
    view.page.mouse.down()
    view.page.mouse.move(area["x"] + area["width"] * 0.6, y, steps=5)
    view.page.mouse.up()
    view.settle()
    spans = "() => linkwright.charts.map(c => [c.scales.x.min, c.scales.x.max])"
    for low, high in view.page.evaluate(spans):
        assert (low, high) == pytest.approx((0.3, 0.9), abs=0.01)
    view.page.get_by_role("button", name="Show the full time range").click()
    view.settle()
    assert view.page.evaluate(spans)[3] == pytest.approx([0, 1.5])
    assert view.complaints == []


def test_keyboard_steps_the_slider_and_plays(show: Any, report: ReportData) -> None:
    view = show(report)
    view.slider.focus()
    for _ in range(3):
        view.page.keyboard.press("ArrowRight")
    assert view.slider.input_value() == "3"
    assert view.slider.get_attribute("aria-valuetext") == "0.0225 s"
    view.page.get_by_role("button", name="Play").press("Enter")
    sync_api.expect(view.slider).not_to_have_value("3")
    view.page.get_by_role("button", name="Pause").press("Enter")
    at = view.slider.input_value()
    view.settle()
    assert view.slider.input_value() == at


def test_plays_by_itself_unless_reduced_motion_is_wished(show: Any, report: ReportData) -> None:
    assert show(report).page.get_by_role("button", name="Play").count() == 1
    lively = show(report, reduced_motion="no-preference")
    assert lively.page.get_by_role("button", name="Pause").count() == 1


def test_null_poses_leave_the_frame_and_a_note(show: Any, report: ReportData) -> None:
    for link in report["scene"]["links"]:
        if not link["fixed"]:
            for values in link["pose"].values():
                values[50:80] = [None] * len(values[50:80])
    view = show(report)
    note = view.page.locator("#drawing .lw-note")
    assert not note.is_visible()
    view.slider.fill("60")
    assert note.is_visible()
    assert "Can't be assembled here" in view.slider.get_attribute("aria-valuetext")
    assert view.page.locator('#drawing [data-point="A"]').is_visible()
    assert not view.page.locator('#drawing [data-point="B"]').is_visible()
    assert view.page.locator("#drawing .lw-body").first.is_hidden()
    view.slider.fill("100")
    assert not note.is_visible()
    assert view.complaints == []


def test_nothing_assembles_at_all(show: Any, report: ReportData) -> None:
    report["time"]["values"] = []
    report["scene"]["time"] = []
    report["scene"]["traces"] = []
    report["plots"] = []
    for link in report["scene"]["links"]:
        if not link["fixed"]:
            link["pose"] = {"x": [], "y": [], "c": [], "s": []}
    view = show(report)
    assert view.complaints == []
    assert view.page.locator("#drawing .lw-note").is_visible()


def test_hostile_names_show_as_text(show: Any, report: ReportData) -> None:
    def rename(text: str) -> str:
        return HOSTILE if text in ("B", "crank") else text

    scene = report["scene"]
    for link in scene["links"]:
        link["name"] = rename(link["name"])
        link["points"] = {rename(name): at for name, at in link["points"].items()}
    for joint in scene["joints"]:
        joint["name"] = rename(joint["name"])
        joint["links"] = [rename(name) for name in joint["links"]]
        joint["points"] = [rename(name) for name in joint["points"]]
    scene["traces"][0]["name"] = HOSTILE
    report["plots"][0]["title"] = HOSTILE
    report["plots"][0]["series"][0]["name"] = HOSTILE
    (measures,) = report["sections"][0].blocks
    assert isinstance(measures, Measures)
    first, *others = measures.measures
    report["sections"] = [Section("measures", [Measures([replace(first, name=HOSTILE), *others])])]
    report["title"] = report["model_text"] = HOSTILE
    view = show(report)
    view.settle()
    assert view.page.title() == HOSTILE
    assert view.page.locator("img").count() == 0
    assert view.page.locator("h1").inner_text() == HOSTILE
    assert HOSTILE in view.page.locator("#drawing .lw-labels text").all_text_contents()
    assert HOSTILE in view.page.locator(".legend").first.inner_text()
    assert view.complaints == []


def test_toggles_hide_paths_and_names(show: Any, report: ReportData) -> None:
    view = show(report)
    path = view.page.locator("#drawing .lw-trace").first
    label = view.page.locator("#drawing .lw-labels text", has_text="crank")
    assert path.is_visible()
    assert label.is_visible()
    view.page.get_by_label("E", exact=True).uncheck()
    view.page.get_by_label("Link names").uncheck()
    assert not path.is_visible()
    assert not label.is_visible()


def test_centrodes_are_switched_on_and_roll(show: Any, report: ReportData, feeder: Any) -> None:
    """The coupler's centre is where crank and rocker lines meet; there both centrodes touch."""
    p, a, d = feeder.points, 0j, feeder.points["D"]
    crank, rocker = p["B"] - a, p["C"] - d
    pole = a + crank * ((d - a).conj() * rocker).imag / (crank.conj() * rocker).imag
    local = (pole - p["B"]) * np.exp(-1j * feeder.coupler)
    pole, local = (np.where(np.abs(pole) < 1500, each, np.nan) for each in (pole, local))
    rows = {"x": pole.real, "y": pole.imag, "u": local.real, "v": local.imag}
    listed = {key: [None if v != v else v for v in row.tolist()] for key, row in rows.items()}
    report["scene"]["centrodes"] = [{"link": "coupler", **listed}]  # type: ignore[typeddict-item]
    index = int(np.nanargmin(np.abs(pole - 400)))
    view = show(report)
    view.slider.fill(str(index))
    group = view.page.locator("#drawing .lw-centrode")
    assert not group.locator(".lw-fixed").is_visible()
    before = abs(view.pin("D") - view.pin("A"))
    view.page.get_by_role("group", name="Centrodes").get_by_label("coupler", exact=True).check()
    assert group.locator(".lw-fixed").is_visible()
    left, right = view.pin("A"), view.pin("D")
    assert abs(right - left) < before  # more is in sight
    scale = (right - left) / p["D"][index]
    box = group.locator("circle").bounding_box()
    dot = complex(box["x"] + box["width"] / 2, -box["y"] - box["height"] / 2)
    assert abs(dot - (left + scale * pole[index])) < 0.5
    # The moving one is drawn in the link's axes: its point of this pose, carried by its transform, is the centre too.
    x, y = view.page.evaluate(
        """([u, v]) => { const path = document.querySelector("#drawing .lw-moving");
        const at = new DOMPoint(u, v).matrixTransform(path.getScreenCTM()); return [at.x, at.y]; }""",
        [abs(scale) * local[index].real, -abs(scale) * local[index].imag],
    )
    assert abs(complex(x, -y) - dot) < 0.7
    assert view.page.locator("#still .lw-centrode").count() == 0
    assert view.complaints == []


@pytest.mark.parametrize("by", ["the contents", "the header", "the address"])
def test_a_link_to_a_folded_part_opens_it(show: Any, report: ReportData, by: str) -> None:
    report["sections"] = [
        *report["sections"][:1],
        Section("certificate", [Checks([Check("closure", "3.1e-16", "Closed.", ok=True)])]),
    ]
    view = show(report)
    table = view.page.locator("table.certificate")
    assert not table.is_visible()
    if by == "the address":
        view.page.goto(f"{view.page.url}#certificate")
        view.page.reload()
    else:
        part = "nav:not(.languages)" if by == "the contents" else ".summary"
        view.page.locator(f"{part} a[href='#certificate']").click()
    assert table.is_visible()
    view.page.locator("#certificate summary").click()
    assert not table.is_visible()
    view.page.emulate_media(media="print")
    assert table.is_visible()


def test_prints_with_still_drawing_and_all_plots(show: Any, report: ReportData, tmp_path: Path) -> None:
    tables = [Table("t", "T", [str(i) for i in range(count)], [["1"] * count]) for count in (3, 8)]
    report["sections"] += [Section("cam", [Charts([Chart("one", lambda: "<svg/>", hint="click")]), *tables])]
    view = show(report, color_scheme="dark")
    on_screen = view.page.locator("#cam .note, footer, .hint")
    assert on_screen.count() == on_screen.locator("visible=true").count() == 3
    view.page.emulate_media(media="print")
    view.settle()
    assert on_screen.locator("visible=true").count() == 0
    shown = "cells => cells.map(cell => [getComputedStyle(cell).fontSize, getComputedStyle(cell).paddingTop].join())"
    assert len({*view.page.locator("#cam td").evaluate_all(shown)}) == 1  # wide tables are as small as others
    assert view.page.locator(".plots").first.evaluate("row => getComputedStyle(row).orphans") == "1"
    assert view.page.locator("h3").first.evaluate("head => getComputedStyle(head).breakAfter") == "avoid"
    assert view.page.locator("#still svg").is_visible()
    assert not view.page.locator("#drawing").is_visible()
    assert view.page.locator("#still .lw-ghost").count() == 8
    assert view.page.locator(".chart-paper canvas:visible").count() == len(report["plots"])
    assert view.page.locator("#model pre").is_visible()
    background = "getComputedStyle(document.querySelector('#still svg')).backgroundColor"
    assert view.page.evaluate(background) == "rgb(255, 255, 255)"
    view.page.emulate_media(media="screen")
    view.settle()
    assert view.page.locator(".chart-paper").count() == 0
    pdf = view.page.pdf(prefer_css_page_size=True)
    assert pdf.startswith(b"%PDF-")
    assert len(pdf) > 50_000
    assert view.complaints == []


@pytest.mark.usefixtures("accuracy")
def test_fits_a_phone(show: Any, report: ReportData) -> None:
    view = show(report, viewport={"width": 360, "height": 740})
    assert view.page.evaluate("document.documentElement.scrollWidth") == 360
    empty = view.page.locator("td:empty")
    assert empty.count() > 0 == empty.locator("visible=true").count()  # no heads of cells without anything in them


def test_a_drawing_review_is_copied_for_a_spreadsheet(show: Any, report: ReportData, accuracy: Section) -> None:
    view = show(report, permissions=["clipboard-read", "clipboard-write"])
    button = view.page.locator("button.copy").first
    button.click()
    view.page.wait_for_function("document.querySelector('button.copy').textContent === 'Copied'")
    first = next(block for block in accuracy.blocks if isinstance(block, Copied))
    assert view.page.evaluate("navigator.clipboard.readText()") == first.text
    assert view.complaints == []


def test_drawing_works_alone_as_a_notebook_widget(browser: Any, report: ReportData) -> None:
    """As an ES module, given a widget's model: draws its scene, redraws a new one, tidies up."""
    source = files("linkwright.report").joinpath("assets", "mechanism.js").read_text("utf-8")
    shown = browser.new_page()
    shown.set_content('<div id="el"></div>')
    counts = shown.evaluate(
        """async ([source, scene]) => {
          const el = document.getElementById("el");
          const count = () => el.querySelectorAll(".lw-body, .lw-block").length;
          const url = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
          const module = await import(url);
          const heard = {};
          const state = { scene };
          const model = { get: k => state[k], on: (k, f) => (heard[k] = f), off: k => delete heard[k] };
          const cleanup = module.default.render({ model, el });
          const counts = [count()];
          state.scene = { ...scene, links: scene.links.slice(0, 2), joints: [], traces: [] };
          heard["change:scene"]();
          counts.push(count());
          cleanup();
          return [...counts, el.childElementCount, Object.keys(heard).length];
        }""",
        [source, report["scene"]],
    )
    shown.close()
    assert counts == [5, 1, 0, 0]


@cache
def one_pose() -> Any:
    """A workspace without a cycle."""
    return performed(five_bar(drives={"motor": [80, 120], "servo": [40, 100]}))


@pytest.mark.parametrize("width", [390, 1100, 1200])
def test_one_pose_of_a_workspace_stands_still_before_its_regions(show: Any, width: int) -> None:
    job = one_pose()
    view = show(report_data(job.examined.document, job.outcomes), viewport={"width": width, "height": 900})
    assert view.complaints == []
    assert view.page.evaluate("document.documentElement.scrollWidth") == width
    first, row = (view.page.locator(f"#workspace .plots{part}").first.bounding_box() for part in (" > figure", ""))
    assert first["width"] == row["width"]  # wide enough for the letters of its legend
    drawing = view.page.locator("#drawing")
    assert not drawing.locator(".lw-bar").is_visible() and not drawing.locator("select").is_visible()
    frame = drawing.locator("svg.lw-drawing").bounding_box()
    assert frame is not None
    for shape in drawing.locator(".lw-area, .lw-bodies, .lw-pin").all():
        box = shape.bounding_box()
        assert box is not None and box["x"] >= frame["x"] and box["y"] >= frame["y"]
        assert box["x"] + box["width"] <= frame["x"] + frame["width"]
        assert box["y"] + box["height"] <= frame["y"] + frame["height"]
    own = drawing.locator(".lw-area").first
    # C, the working point, lies in the region of the file's own mode: cranks at 100 and 80 deg, 12 mm couplers.
    pin, reach = drawing.locator('[data-point="C"]').bounding_box(), own.bounding_box()
    assert pin is not None and reach is not None
    assert reach["x"] < pin["x"] < reach["x"] + reach["width"] and reach["y"] < pin["y"] < reach["y"] + reach["height"]
    drawing.get_by_label(job.summary["workspace"]["regions"][0]["mode"]).uncheck()
    assert not own.is_visible() and drawing.locator(".lw-area").nth(1).is_visible()


@cache
def stepped() -> ReportData:
    """A workspace for several values of two parameters, coarse; tests don't change it."""
    values: dict[str, Any] = {"for": {"l": [12, 11, 13], "base": [10, 12]}, "chord": 1e-2}
    values["trajectories"] = {"hold": "servo", "steps": 6}
    job = performed(five_bar(drives={"motor": [80, 120], "servo": [40, 100]}, **values))
    document = job.examined.document
    assert document is not None
    return report_data(document, job.outcomes)


def seen(view: Opened) -> list[str]:
    """The captions of the pictures that are seen."""
    captions: list[str] = view.page.locator("#workspace .stack figure:visible figcaption").all_inner_texts()
    return captions


def places(view: Opened) -> list[list[float]]:
    """Where the stacks are on the page, and how high."""
    script = "all => all.map(e => e.getBoundingClientRect()).map(r => [r.x, r.top + scrollY, r.height])"
    found: list[list[float]] = view.page.locator("#workspace .stack").evaluate_all(script)
    return found


@pytest.mark.parametrize(("width", "scheme"), [(390, "dark"), (1400, "light")])
def test_sliders_step_through_the_pictures_of_a_workspace(show: Any, width: int, scheme: str) -> None:
    view = show(
        stepped(),
        viewport={"width": width, "height": 900},
        color_scheme=scheme,
    )
    assert view.complaints == []
    assert view.page.evaluate("document.documentElement.scrollWidth") == width
    first, second = (view.page.get_by_role("slider", name=name, exact=True) for name in ("l", "base"))
    assert [one.get_attribute("aria-valuetext") for one in (first, second)] == ["12 mm", "10 mm"]  # the file's own
    assert len(seen(view)) == 3  # the regions, and a cloud for each mode
    assert all("l = 12 mm, base = 10 mm" in text for text in seen(view))
    before = places(view)
    first.press("ArrowRight")
    second.press("End")
    assert all("l = 13 mm, base = 12 mm" in text for text in seen(view)) and len(seen(view)) == 3
    assert view.page.locator("#workspace .sliders output").all_inner_texts() == ["13 mm", "12 mm"]
    first.fill("0")
    assert all("l = 11 mm, base = 12 mm" in text for text in seen(view))
    assert places(view) == before  # nothing jumps


def test_the_slider_stays_in_sight_and_pictures_keep_their_axes(show: Any) -> None:
    view = show(stepped(), viewport={"width": 1000, "height": 700})
    slider = view.page.get_by_role("slider", name="l", exact=True)
    view.page.locator("#workspace .stack").last.scroll_into_view_if_needed()
    box = slider.bounding_box()
    assert box is not None and 0 < box["y"] < 200
    axes = []
    for value in "012":
        slider.fill(value)
        view.settle()
        picture = view.page.locator("#workspace .stack").last.locator(".shown .plane-picture")
        axes.append(picture.locator("text").all_inner_texts())
    assert axes[0] == axes[1] == axes[2] and len(axes[0]) > 10


def test_on_paper_all_pictures_are_seen_and_without_scripts_a_sentence(show: Any) -> None:
    data = stepped()
    silent = show(data, java_script_enabled=False)
    assert seen(silent) == []
    assert silent.page.locator("#workspace noscript p").inner_text() == say("report.no_script_charts")
    assert silent.page.locator("#workspace table").first.is_visible()
    assert not silent.page.locator(".sliders, #workspace .hint").first.is_visible()
    view = show(data)
    assert len(seen(view)) == 3
    view.page.emulate_media(media="print")
    assert len(seen(view)) == 18
    assert not view.page.locator(".sliders").is_visible()
    boxes = [one.bounding_box() for one in view.page.locator("#workspace .stack figure").all()]
    corners = {(box["x"], box["y"]) for box in boxes if box is not None}
    assert len(corners) == 18


SAID = """() => {
  const texts = [];
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) {
    const { data, parentNode } = walker.currentNode;
    if (!["script", "style", "noscript"].includes(parentNode.localName) && data.trim()) texts.push(data.trim());
  }
  for (const element of document.body.querySelectorAll("[aria-label], [data-head], [title]"))
    for (const name of ["aria-label", "data-head", "title"]) texts.push(element.getAttribute(name));
  return [document.documentElement.lang, document.title, ...texts];
}"""


def test_a_page_in_another_language_is_the_page_of_that_language(
    browser: Any, report: ReportData, accuracy: Section, tmp_path: Path
) -> None:
    """Written in English and switched, or written in Chinese: the same texts, labels, words of drawing and plots."""
    for name in ("en", "zh"):
        with in_language(name):
            (tmp_path / f"{name}.html").write_text(page(report), encoding="utf-8")
    english = Opened(browser, tmp_path / "en.html")
    before = english.page.evaluate(SAID)
    english.page.get_by_role("link", name="简体中文").click()
    english.page.wait_for_url("**?lang=zh-CN")
    english.settle()
    chinese = Opened(browser, tmp_path / "zh.html")
    assert english.page.evaluate(SAID) == chinese.page.evaluate(SAID) != before
    chinese.page.get_by_role("link", name="English").click()
    chinese.page.wait_for_url("**?lang=en")
    chinese.settle()
    assert chinese.page.evaluate(SAID) == before
    assert english.complaints == chinese.complaints == []
    for each in (english, chinese):
        each.context.close()


def test_hanzi_are_not_slanted(show: Any, report: ReportData) -> None:
    moving = next(link for link in report["scene"]["links"] if not link["fixed"])
    for joint in report["scene"]["joints"]:
        joint["links"] = ["曲柄" if name == moving["name"] else name for name in joint["links"]]
    moving["name"] = "曲柄"
    view = show(report)
    styles = view.page.locator("#drawing .lw-name").evaluate_all(
        "names => names.map(name => [name.textContent, getComputedStyle(name).fontStyle])"
    )
    assert dict(styles)["曲柄"] == "normal"
    assert {style for name, style in styles if name.isascii()} == {"italic"}


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("width", [390, 1400])
@pytest.mark.parametrize("severity", ["error", "warning", "note"])
def test_only_errors_are_red(show: Any, report: ReportData, severity: str, width: int, scheme: str) -> None:
    """No text, border or ground of a banner and its badge is red but of errors, on a phone and in the dark too."""
    what = "The mechanism is redundant: constraints of guide follow from those of the other joints. " * 3
    report["problems"] = [{"code": "some.code", "severity": severity, "what": what, "mend": "No change is needed."}]
    report["sections"] = []
    view = show(report, color_scheme=scheme, viewport={"width": width, "height": 800})
    colours = view.page.locator(f"#{severity}s, #{severity}s *, #state, #state *").evaluate_all(
        """shown => shown.flatMap(e => { const s = getComputedStyle(e);
        return [s.color, s.backgroundColor, s.borderTopColor, s.borderLeftColor]; })"""
    )
    parts = [[float(part) for part in colour[colour.index("(") + 1 : -1].split(",")] for colour in set(colours)]
    red = [part for part in parts if len(part) == 3 and part[0] > 1.75 * max(part[1], part[2])]  # amber: 1.66
    assert bool(red) == (severity == "error")
    assert view.page.evaluate("document.documentElement.scrollWidth") <= width


def test_on_a_phone_each_card_says_what_its_first_number_is(show: Any) -> None:
    """Rows of studies' tables are cards: the value of a parameter alone would be no heading."""
    view = show(stepped(), viewport={"width": 390, "height": 800})
    cells = view.page.locator("#workspace table.limits td:first-child")
    heads = cells.evaluate_all("""all => all.map(e => [getComputedStyle(e, '::before').content, e.dataset.head])""")
    assert heads and all(content.replace('"', "").strip() == head for content, head in heads)


def test_the_last_label_of_an_axis_is_whole(show: Any, report: ReportData) -> None:
    """Where the axis ends at a number of many digits, half of its label lies beyond the axis, within the picture."""
    report["plots"] = [
        {"title": "long", "group": "motion", "unit": "mm", "series": [{"name": "B.x", "values": [*range(201)]}]}
    ]
    report["time"] = {"values": [100.0 * k for k in range(201)], "unit": "s", "label": "time"}
    view = show(report)
    view.settle()
    over, canvas = (
        view.page.locator(f".uplot {part}").first.evaluate("e => e.getBoundingClientRect().right")
        for part in (".u-over", "canvas")
    )
    assert canvas - over >= 0.5 * 6.1 * len("20000")
