"""The live report in a real browser: numbers are moved by slider, entry and drag, and all of the page follows."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from live_page import ROUND

import linkwright as lw
from helpers.examples import four_bar
from helpers.opened import Opened, opened
from linkwright.compilation import compile_mechanism
from linkwright.model.document import load
from linkwright.report.build import report_data
from linkwright.report.page import page
from linkwright.results import Run
from linkwright.words import in_language
from report.test_report_browser import HOSTILE

pytestmark = pytest.mark.browser
pytest.importorskip("playwright.sync_api")

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def pages(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Path]:
    """The report of an example, written once."""
    folder, made = tmp_path_factory.mktemp("live"), dict[str, Path]()

    def of(name: str) -> Path:
        if name not in made:
            file = EXAMPLES / f"{name}.yaml"
            job = lw.run(file)
            examined = job.examined
            data = report_data(
                load(file), job.outcomes, examined.findings, examined.origin, file.read_text(encoding="utf-8")
            )
            made[name] = folder / f"{name}.html"
            made[name].write_text(page(data), encoding="utf-8")
        return made[name]

    return of


@pytest.fixture
def show(browser: Any, pages: Callable[[str], Path]) -> Iterator[Callable[..., Opened]]:
    yield from opened(browser, pages)


def rested(view: Opened) -> None:
    """Two frames, and what waits until numbers rest."""
    view.page.wait_for_timeout(260)


def slide(view: Opened, label: str, value: float) -> None:
    """Move a slider to a value in its unit."""
    slider = view.page.locator(".dimension", has=view.page.get_by_label(label, exact=True)).locator("[type=range]")
    slider.evaluate("(s, v) => { s.value = v; s.dispatchEvent(new Event('input')) }", value)
    rested(view)


def state(view: Opened) -> str:
    text: str = view.page.locator(".live-line").inner_text()
    return text


def measure(view: Opened, name: str) -> tuple[list[float], str]:
    """The values of a measure as the page shows them, and its verdict."""
    row = view.page.locator("#measures tbody tr", has=view.page.get_by_text(name, exact=True))
    values = row.locator(".line.value b").all_inner_texts()
    mark = row.locator(".mark")
    return [float(v.replace("−", "-")) for v in values], mark.inner_text() if mark.count() else ""


def test_a_slider_moves_all_of_the_page(show: Callable[..., Opened]) -> None:
    """Signals at all times, measures, verdicts: as Python has them for the file with the changed line."""
    view = show("paper_feeder")
    before = view.page.locator("main").inner_text()
    slide(view, "AB", 150)
    changed = load(EXAMPLES / "paper_feeder.yaml").replace(AB=150)
    compiled = compile_mechanism(changed)
    times = np.array(view.page.evaluate("linkwright.live.data.times"))
    names = view.page.evaluate("linkwright.live.data.signals")
    found = view.page.evaluate("linkwright.live.data.signals.map(name => Array.from(linkwright.live.signal(name)))")
    true = Run(compiled, 0.0, float(times[-1]), 400).evaluate(names, times)
    scale = np.abs(true).max(axis=1, keepdims=True)
    scale = np.maximum(scale, 1e-6 * scale.max())  # some are zero but for round-off
    assert (np.abs(np.array(found, dtype=float) - true) / scale).max() < 1e-9
    job = lw.run(changed)
    for result in job.outcomes["cycle"].measures:
        values, verdict = measure(view, result.name)
        exact = [figure.value / result.size for figure in result.found]
        assert values == pytest.approx(exact, rel=1e-5, abs=1e-6 * max(map(abs, exact)))
        if result.verdict is not None:
            assert ("passed" in verdict) == result.verdict
    assert "failed" in measure(view, "stroke")[1]
    assert "Changed: not verified" in view.page.locator("#state").inner_text()
    assert "0 of 1" in view.page.locator("#requirements").inner_text()
    assert re.search(r"closure error \d\.\de-1\d", state(view))
    assert re.search(r"residual \d\.\de-1\d", state(view))
    view.page.get_by_role("button", name="Reset all").click()
    rested(view)
    after = view.page.locator("main").inner_text().replace("Undo", "")
    assert after.split() == before.split()
    assert not view.page.locator(".mark.changed").is_visible()


def test_the_copied_lines_give_the_same_figures(show: Callable[..., Opened], tmp_path: Path) -> None:
    """Only the digits of the changed numbers are others; put into the file, they give what the page showed."""
    view = show("loader")
    view.page.locator("#numbers summary").click() if not view.page.locator("#numbers details[open]").count() else None
    slide(view, "boom.points.M.x", 1250)
    slide(view, "bucket.mass", 330.5)
    lines = view.page.locator(".live-lines").inner_text().splitlines()
    text = (EXAMPLES / "loader.yaml").read_text(encoding="utf-8").splitlines()
    places = [
        next(
            i
            for i, line in enumerate(text)
            if re.sub(r"\d+", "", line) == re.sub(r"[\d.]+", "", new)
            or (line.split(":")[0] == new.split(":")[0] and line.strip())
        )
        for new in lines
    ]
    assert len(lines) == 2
    for i, line in zip(places, lines, strict=True):
        text[i] = line
    file = tmp_path / "loader.yaml"
    file.write_text("\n".join(text), encoding="utf-8")
    compiled = compile_mechanism(load(file))
    times = np.array(view.page.evaluate("linkwright.live.data.times"))
    for name in ("raise.force", "dump.force"):
        found = np.array(view.page.evaluate(f"Array.from(linkwright.live.signal('{name}'))"))
        (true,) = compiled.evaluate([name], times)
        assert np.abs(found - true).max() < 1e-9 * np.abs(true).max()


def place(view: Opened, name: str, pose: int) -> complex:
    """A point's place (m) at a pose, as the page's motion has it."""
    x, y = view.page.evaluate(f"['x', 'y'].map(axis => linkwright.live.signal('{name}.' + axis)[{pose}])")
    return complex(x, y)


def drag(view: Opened, name: str, by: complex, steps: int = 6) -> complex:
    """Drag a point by pixels (y up); the place in the world (m) where the pointer ends."""
    here = view.pin(name)
    view.page.mouse.move(here.real, -here.imag)
    view.page.mouse.down()
    for k in range(1, steps + 1):
        there = here + by * k / steps
        view.page.mouse.move(there.real, -there.imag)
        view.page.wait_for_timeout(30)
    x, y = view.page.evaluate("([x, y]) => linkwright.drawing.place(x, y)", [there.real, -there.imag])
    rested(view)
    view.page.mouse.up()
    length: float = view.page.evaluate("linkwright.live.data.length")
    return complex(x, y) * length


@pytest.mark.parametrize(("example", "point"), [("paper_feeder", "C"), ("jansen_leg", "P"), ("four_bar", "P")])
def test_a_joint_follows_the_pointer(show: Callable[..., Opened], example: str, point: str) -> None:
    """To a millionth of the mechanism; the time stands, and the numbers stay near their own."""
    view = show(example)
    view.page.evaluate("linkwright.drawing.setIndex(40)")
    names = view.page.evaluate("linkwright.live.data.program.points")
    point = point if point in names else names[-1]
    target = drag(view, point, 14 - 9j)
    size = view.page.evaluate("linkwright.live.data.program.size")
    assert abs(place(view, point, 40) - target) < 1e-6 * size
    values = np.array(view.page.evaluate("Array.from(linkwright.live.values)"))
    base = np.array(view.page.evaluate("linkwright.live.data.program.values"))
    assert 0 < np.abs(values - base).max() < 0.5 * size
    assert view.page.evaluate("linkwright.live.changed")
    assert "Reset all" in view.page.locator(".live-tools").inner_text()


def test_a_locked_number_stays(show: Callable[..., Opened]) -> None:
    view = show("paper_feeder")
    view.page.evaluate("linkwright.drawing.setIndex(60)")
    for label in ("AB", "AD"):
        view.page.locator(".dimension", has=view.page.get_by_label(label, exact=True)).locator(".hold").click()
    drag(view, "C", 10 + 10j)
    script = "linkwright.live.data.numbers.map((n, i) => [n.label, linkwright.live.value(i) - n.value])"
    moved = dict(view.page.evaluate(script))
    assert moved["AB"] == moved["AD"] == 0
    assert moved["BC"] != 0 or moved["CD"] != 0


def test_motion_is_dragged_too(show: Callable[..., Opened]) -> None:
    """With the other mode a drag looks for the time, and changes nothing."""
    view = show("paper_feeder")
    view.page.evaluate("linkwright.drawing.setIndex(30)")
    view.page.get_by_role("button", name="Motion").click()
    before = view.page.evaluate("linkwright.drawing.time")
    drag(view, "B", 25 + 25j)
    assert view.page.evaluate("linkwright.drawing.time") != before
    assert not view.page.evaluate("linkwright.live.changed")


def test_only_the_links_of_a_pin_change(show: Callable[..., Opened]) -> None:
    """Unless Alt is pressed; Escape brings all back, and so does a step back after a drag."""
    view = show("paper_feeder")
    view.page.evaluate("linkwright.drawing.setIndex(60)")
    script = "linkwright.live.data.numbers.filter((n, i) => linkwright.live.value(i) !== n.value).map(n => n.label)"
    drag(view, "C", 12 + 8j)
    assert set(view.page.evaluate(script)) == {"BC", "CD"}
    view.page.keyboard.press("Control+z")
    rested(view)
    assert view.page.evaluate(script) == []
    view.page.keyboard.down("Alt")
    drag(view, "C", 12 + 8j)
    view.page.keyboard.up("Alt")
    assert "AB" in view.page.evaluate(script)
    view.page.get_by_role("button", name="Undo").click()
    rested(view)
    here = view.pin("C")
    view.page.mouse.move(here.real, -here.imag)
    view.page.mouse.down()
    view.page.mouse.move(here.real + 9, -here.imag + 9)
    rested(view)
    assert view.page.evaluate(script) != []
    view.page.keyboard.press("Escape")
    view.page.mouse.up()
    rested(view)
    assert view.page.evaluate(script) == []


def test_out_of_reach(show: Callable[..., Opened]) -> None:
    """With all numbers but those of one point locked a drag says by how much it can't follow."""
    view = show("four_bar")
    view.page.evaluate("""document.querySelectorAll('.dimension').forEach(row =>
        row.querySelector('label').textContent.startsWith('coupler.points.P') || row.querySelector('.hold').click())""")
    here = view.pin("P")
    view.page.mouse.move(here.real, -here.imag)
    view.page.mouse.down()
    view.page.mouse.move(here.real + 160, -here.imag - 180)
    rested(view)
    hint = view.page.locator(".lw-hint")
    said = re.fullmatch(r"[\d.]+ mm out of reach: (.+) is at the end of its slider \(([-\d.]+) mm\)", hint.inner_text())
    assert said is not None
    slider = view.page.locator(".dimension", has=view.page.get_by_label(said[1], exact=True)).locator("[type=range]")
    ends = [float(slider.get_attribute(end)) for end in ("min", "max")]
    assert min(abs(float(said[2]) - end) for end in ends) < 1e-3 * (ends[1] - ends[0])
    view.page.mouse.up()
    assert not hint.is_visible()
    view.page.evaluate("document.querySelectorAll('.hold[aria-pressed=false]').forEach(hold => hold.click())")
    here = view.pin("P")
    view.page.mouse.move(here.real, -here.imag)
    view.page.mouse.down()
    view.page.mouse.move(here.real + 160, -here.imag - 180)
    rested(view)
    assert hint.inner_text().endswith("no number that moves this point is free")
    view.page.mouse.up()


def test_a_drag_over_the_drawing_selects_no_text(show: Callable[..., Opened]) -> None:
    """From a link's body and from empty ground, across the names of points and links."""
    view = show("four_bar")
    box = view.page.locator(".lw-stage svg").first.bounding_box()
    for x, y in ((0.5, 0.6), (0.05, 0.05)):
        view.page.mouse.move(box["x"] + x * box["width"], box["y"] + y * box["height"])
        view.page.mouse.down()
        view.page.mouse.move(box["x"] + 0.95 * box["width"], box["y"] + 0.95 * box["height"], steps=4)
        assert view.page.evaluate("getSelection().toString()") == ""
        view.page.mouse.up()


def test_what_cannot_be_assembled(show: Callable[..., Opened]) -> None:
    """It says where and draws the gap, as long as what is missing; one click leads back."""
    view = show("four_bar")
    slide(view, "b", 62)
    assert "can't be assembled" not in state(view)
    entry = view.page.get_by_label("b", exact=True).and_(view.page.locator("[type=text]"))
    entry.fill("30")
    entry.press("Enter")
    rested(view)
    assert re.match(
        r"coupler and rocker can't be assembled between motor = [\d.]+ and [\d.]+ deg: A and O4 are", state(view)
    )
    pose = view.page.evaluate("linkwright.live.motion.failure.pose")
    view.page.evaluate(f"linkwright.drawing.setIndex({pose})")
    assert view.page.locator(".lw-gaps i").count() == 1
    gap = view.page.locator(".lw-opening text").filter(visible=True)
    a, b, c, d = 40.0, 30.0, 80.0, 100.0
    angle = (
        view.page.evaluate(f"linkwright.live.motion.rows[3][{pose}]"),
        view.page.evaluate(f"linkwright.live.motion.rows[2][{pose}]"),
    )
    crank = a * complex(angle[1], angle[0])
    far = abs(complex(d) - crank)
    missing = max(far - b - c, abs(b - c) - far)
    assert float(gap.text_content().split()[0]) == pytest.approx(missing, rel=1e-3)
    view.page.get_by_role("button", name="Back to the last").click()
    rested(view)
    assert view.page.evaluate("linkwright.live.motion.failure") is None
    assert entry.input_value() == "62"
    assert view.page.locator(".lw-gaps i").count() == 0


def test_a_gap_ends_where_links_close_again(show: Callable[..., Opened]) -> None:
    """With a crank of 225 mm B and D are nearer than CD and BC differ by on 25.8 deg of the turn only; a change that
    belongs to earlier values doesn't stay beside an empty one."""
    view = show("paper_feeder")
    entry = view.page.get_by_label("AB", exact=True).and_(view.page.locator("[type=text]"))
    for value in ("165", "225"):
        entry.fill(value)
        entry.press("Enter")
        rested(view)
    # The law of cosines: |BD|^2 = AB^2 + AD^2 - 2 AB AD cos(angle) = (BC - CD)^2.
    half = np.degrees(np.arccos((225**2 + 300**2 - 95**2) / (2 * 225 * 300)))
    closed = np.array(view.page.evaluate("linkwright.live.motion.reaches[0].map(reach => reach >= 0)"), dtype=bool)
    assert np.mean(~closed) == pytest.approx(2 * half / 360, abs=2 / len(closed))
    width = view.page.locator(".lw-gaps i").evaluate_all(
        "all => all.reduce((sum, i) => sum + parseFloat(i.style.width), 0)"
    )
    assert width == pytest.approx(200 * half / 360, abs=1.5)
    for row in view.page.locator("#measures tbody tr").all():
        assert row.locator(".note.was").count() <= row.locator(".line.value b", has_text=re.compile(r"[0-9]")).count()
    assert view.page.locator("#certificate").count() == 1
    view.context.close()


def test_entries_take_numbers_alone(show: Callable[..., Opened]) -> None:
    view = show("four_bar")
    entry = view.page.get_by_label("b", exact=True).and_(view.page.locator("[type=text]"))
    for text in ("a lot", "", "1e999", "120; alert(1)"):
        entry.fill(text)
        entry.press("Enter")
        assert entry.input_value() == "120"
        assert not view.page.evaluate("linkwright.live.changed")
        wrong = view.page.locator(".dimension output").filter(visible=True)
        assert wrong.all_inner_texts() == [f"“{text}” isn't a value in mm; {wrong.inner_text().split('; ')[-1]}"]
    for text, value in (("119,5", 0.1195), ("118 mm", 0.118), ("11.7 cm", 0.117), ("2*58", 0.116)):
        entry.fill(text)
        entry.press("Enter")
        assert view.page.evaluate("linkwright.live.value(1)") == pytest.approx(value)
        assert view.page.locator(".dimension output").filter(visible=True).count() == 0


def test_the_search_of_signals_knows_what_plots_call_them(show: Callable[..., Opened]) -> None:
    """The list begins at its first signal, and nothing of it is chosen before something is asked for."""
    view = show("paper_feeder")
    search = view.page.locator("#plot-bar input[role=combobox]").first
    options = view.page.locator("#plot-bar [role=option]")
    search.click()
    assert view.page.locator("#plot-bar [role=option][aria-selected=true]").count() == 0
    assert view.page.locator("#plot-bar ul").first.evaluate("list => list.scrollTop") == 0
    for query, name in (("acceleration E", "E.ax"), ("force(slider, guide).x", "force(guide, slider).x")):
        search.fill(query)
        assert name in options.first.inner_text()


@pytest.mark.parametrize(
    ("language", "query", "name"),
    [
        ("zh", "加速度", "B.ax"),
        ("zh", "速度 E", "E.vx"),
        ("zh", "位移", "B.x"),
        ("zh", "转角", "crank.angle"),
        ("zh", "转速", "crank.omega"),
        ("zh", "力矩", "motor.torque"),
        ("zh", "扭矩", "motor.torque"),
        ("zh", "约束反力", "force(frame, crank).x"),
        ("zh", "reaction", "force(frame, crank).x"),
        ("zh", "force(rocker, coupler)", "force(coupler, rocker).x"),
        ("en", "displacement", "B.x"),
        ("en", "rotation", "crank.angle"),
        ("en", "reaction", "force(frame, crank).x"),
    ],
)
def test_signals_are_found_by_the_terms_of_the_field(
    show: Callable[..., Opened], language: str, query: str, name: str
) -> None:
    view = show("paper_feeder")
    if language == "zh":
        view.page.get_by_text("简体中文").click()
        view.page.wait_for_selector("#plot-bar input[role=combobox]")
    view.page.locator("#plot-bar input[role=combobox]").first.fill(query)
    assert view.page.locator("#plot-bar [role=option]").first.inner_text().startswith(name)


def test_paper_says_that_it_was_changed(show: Callable[..., Opened]) -> None:
    view = show("paper_feeder")
    drawn = view.page.locator("#still").inner_html()
    slide(view, "AB", 165)
    view.page.emulate_media(media="print")
    rested(view)
    assert view.page.locator("#still").inner_html() != drawn
    assert "Changed: not verified" in view.page.locator("figure.paper figcaption").inner_text()
    assert view.page.locator(".mark.changed").is_visible()
    assert view.page.locator(".live-lines").inner_text().strip().startswith("parameters: {AB: 165")
    assert not view.page.get_by_role("button", name="Reset all").is_visible()


def test_a_hostile_model(browser: Any, tmp_path: Path) -> None:
    """Its texts, and what a reader types, are texts of the panel, the lines and the messages; nothing of them runs."""
    data: dict[str, Any] = four_bar(parameters={"a": {"value": 1, "note": HOSTILE}})
    data |= {"name": HOSTILE, "note": HOSTILE, "studies": {"cycle": {"turns": "1 motor", "samples": 60}}}
    data["links"]["crank"]["points"]["B"] = ["a", 0]
    document = lw.Document.model_validate(data)
    path = tmp_path / "hostile.html"
    path.write_text(page(report_data(document, lw.run(document).outcomes)), encoding="utf-8")
    view = Opened(browser, path)
    slide(view, "a", 1.2)
    entry = view.page.get_by_label("a", exact=True).and_(view.page.locator("[type=text]"))
    entry.fill("400")
    entry.press("Enter")
    rested(view)
    assert "can't be assembled" in state(view)
    assert view.complaints == []
    assert view.page.title() != "owned"
    assert view.page.locator("img").count() == 0
    view.context.close()


def test_in_chinese(browser: Any, tmp_path: Path) -> None:
    file = EXAMPLES / "chinese_names.yaml"
    with in_language("zh"):
        path = tmp_path / "zh.html"
        path.write_text(page(report_data(load(file), lw.run(file).outcomes)), encoding="utf-8")
    view = Opened(browser, path)
    slide(view, "曲柄长", 70)
    assert "已修改：未验证" in view.page.locator("#state").inner_text()
    assert "封闭" in state(view)
    assert view.complaints == []
    view.context.close()


@pytest.mark.parametrize(
    ("example", "why"),
    [("parallelogram", "change points"), ("guided_scissor_lift", "redundant"), ("bracket", "single pose")],
)
def test_a_recorded_report_says_why(show: Callable[..., Opened], example: str, why: str) -> None:
    """There are no dimensions, and a line tells the reason."""
    view = show(example)
    assert not view.page.locator("#dimensions").count()
    assert why in view.page.locator("#recorded").inner_text()


def test_a_motion_through_change_points_is_recorded(show: Callable[..., Opened]) -> None:
    view = show("parallelogram")
    assert view.page.evaluate("linkwright.live") is None
    assert view.page.locator("#dimensions").count() == 0
    assert view.page.locator(".lw-body").count() > 2


def test_a_phone(show: Callable[..., Opened]) -> None:
    view = show("paper_feeder", viewport={"width": 390, "height": 844}, has_touch=True, is_mobile=True)
    slide(view, "AB", 165)
    assert view.page.evaluate("document.documentElement.scrollWidth") == 390
    assert "Changed" in view.page.locator("#state").inner_text()


MADE, WRITTEN = 15, 200
"""Elements of the drawing that a frame may make, and changes of the document (9 and 60 to 130 were counted)."""
RECORDED = """() => {
  window.records = [];
  window.observer = new MutationObserver(changes => records.push(...changes));
  observer.observe(document.body, {subtree: true, childList: true, attributes: true, characterData: true});
}"""
COUNTED = """() => {
  records.push(...observer.takeRecords());
  observer.disconnect();
  const made = records.filter(each => each.type === "childList");
  const drawn = made.filter(each => each.target.closest("#drawing"));
  const elements = of => of.flatMap(each => [...each.addedNodes]).filter(node => node.nodeType === Node.ELEMENT_NODE);
  return {drawn: elements(drawn).length, made: elements(made).length, all: records.length};
}"""


@pytest.mark.parametrize(("example", "point"), [("paper_feeder", "C"), ("jansen_leg", "D"), ("loader", "S")])
def test_a_drag_writes_what_changes(show: Callable[..., Opened], example: str, point: str) -> None:
    """A frame of a drag reuses the drawing's elements and writes an attribute only where it changes.

    How long that takes is measured by ``benchmarks/live_page.py``.
    """
    view = show(example).page
    frames = 40
    view.evaluate("linkwright.drawing.setIndex(40)")
    box = view.locator(f'#drawing [data-point="{point}"]').bounding_box()
    assert box
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    view.mouse.move(x, y)
    view.mouse.down()
    view.evaluate(ROUND, [x, y, frames])
    view.evaluate(RECORDED)
    view.evaluate(ROUND, [x, y, frames])
    counted = view.evaluate(COUNTED)
    view.mouse.up()
    assert 0 < counted["drawn"] / frames < MADE
    assert counted["all"] / frames < WRITTEN
