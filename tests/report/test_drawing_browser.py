"""The drawing of a live report in a real browser: arrows, dimensions, the view, readouts."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import linkwright as lw
from helpers.opened import OpenedDrawing, opened, written
from linkwright.report import ReportData
from linkwright.report.build import report_data

pytestmark = pytest.mark.browser
pytest.importorskip("playwright.sync_api")

EXAMPLES = Path(__file__).parents[2] / "examples"


@cache
def ran(example: str) -> Any:
    return lw.run(EXAMPLES / f"{example}.yaml")


@cache
def reported(example: str) -> ReportData:
    return report_data(lw.load(EXAMPLES / f"{example}.yaml"), ran(example).outcomes)


@pytest.fixture
def show(browser: Any, tmp_path: Path) -> Iterator[Any]:
    yield from opened(browser, written(tmp_path), OpenedDrawing)


def complex_row(result: Any, name: str) -> Any:
    return result[f"{name}x"] + 1j * result[f"{name}y"]


def test_arrows_are_what_python_computes(show: Any) -> None:
    """Each kind by one scale, at the place where it acts, at several times."""
    result = ran("paper_feeder").cycle.result
    view = show(reported("paper_feeder"))
    assert view.picture.locator(".lw-arrow").count() == 0
    view.show("Velocities", "Accelerations", "Reactions", "Weights")
    assert view.drawing.get_by_label("Loads", exact=True).count() == 0  # there are none
    scales: dict[str, list[float]] = {}
    for index in (12, 25, 50, 77, 120, 160):
        view.at(index)
        for kind, name, at, row in (
            ("velocity", "E", "E", "E.v"),
            ("velocity", "B", "B", "B.v"),
            ("acceleration", "C", "C", "C.a"),
            ("reaction", "force(frame, crank)", "A", "force(frame, crank)."),
            ("reaction", "force(coupler, rocker)", "C", "force(coupler, rocker)."),
        ):
            start, vector = view.arrow(kind, name)
            values = complex_row(result, row)
            if not vector:  # less than a pixel of the longest one
                assert abs(values[index]) < 0.05 * np.abs(values).max()
                continue
            assert abs(start - view.pin(at)) < 0.05
            scale = vector / values[index]
            assert abs(scale.imag) * abs(values[index]) < 0.05  # it points where it should
            if abs(vector) > 5:
                scales.setdefault(kind, []).append(scale.real)
    for found in scales.values():
        assert len(found) > 2 and np.ptp(found) < 0.01 * max(found)
    # A weight hangs from the centre of mass, straight down.
    start, vector = view.arrow("weight", "rocker")
    assert abs(vector.real) < 0.02 and vector.imag < 0
    world = complex_row(result, "com(rocker).")[160]
    a, d = view.pin("A"), view.pin("D")
    ends = [complex_row(result, f"{name}.")[160] for name in "AD"]
    assert abs(start - (a + (d - a) / (ends[1] - ends[0]) * (world - ends[0]))) < 0.05


def test_the_longest_arrow_has_its_usual_length_and_a_slider_changes_it(show: Any) -> None:
    view = show(reported("paper_feeder"))
    view.show("Velocities")
    result = ran("paper_feeder").cycle.result
    width = float(view.picture.get_attribute("viewBox").split()[2])
    usual = min(max(width / 9, 36), 70)
    speeds = {name: np.abs(complex_row(result, f"{name}.v")) for name in "BCEG"}
    fastest = max(speeds, key=lambda name: float(speeds[name].max()))
    index = int(speeds[fastest].argmax())
    view.at(index)
    _, vector = view.arrow("velocity", fastest)
    assert abs(vector) == pytest.approx(usual, abs=0.3)
    slider = view.drawing.get_by_label("Length of arrows: Velocities")
    slider.fill("1")
    _, longer = view.arrow("velocity", fastest)
    assert longer == pytest.approx(2 * vector, abs=0.05)


def test_loads_act_at_their_points(show: Any) -> None:
    """The gas pushes the piston: along the bore, by the force of its table."""
    result = ran("slider_crank_gas").cycle.result
    view = show(reported("slider_crank_gas"))
    view.show("Loads")
    index = int(np.abs(result["gas(engine.angle)"]).argmax()) if "gas" in result.names else 365
    view.at(index)
    start, vector = view.arrow("load", "gas")
    assert abs(start - view.pin("C")) < 0.05
    assert vector.real < -5 and abs(vector.imag) < 0.02


def test_arrows_follow_changes_and_keep_their_scale(show: Any) -> None:
    view = show(reported("paper_feeder"))
    view.show("Velocities")
    view.at(40)
    _, before = view.arrow("velocity", "B")
    view.change("AB", 1.1)
    start, after = view.arrow("velocity", "B")
    assert abs(start - view.pin("B")) < 0.05
    assert after == pytest.approx(1.1 * before, abs=0.05)  # the crank turns as before


def test_dimensions_show_lengths_and_what_they_were(show: Any) -> None:
    view = show(reported("paper_feeder"))
    assert view.picture.locator(".lw-measure").count() == 0
    view.drawing.get_by_label("Dimensions", exact=True).check()
    texts = view.picture.locator(".lw-measure")
    assert {"395", "300", "155"} <= set(texts.all_text_contents())
    view.change("AB", 1.02)
    assert "155 → 158.1" in texts.all_text_contents()
    crank = np.degrees(ran("paper_feeder").cycle.result["crank.angle"][0])
    view.at(0)
    (angle,) = [text for text in texts.all_text_contents() if text.endswith("°")]
    assert float(angle.strip("°").replace("−", "-")) == pytest.approx(crank, abs=0.01)


def test_zooming_keeps_the_place_under_the_pointer_and_fit_goes_back(show: Any) -> None:
    view = show(reported("paper_feeder"))
    home = {name: view.pin(name) for name in "AD"}
    box = view.picture.bounding_box()
    x, y = int(box["x"] + 0.3 * box["width"]), int(box["y"] + 0.4 * box["height"])
    place = "([x, y]) => linkwright.drawing.place(x, y)"
    before = view.page.evaluate(place, [x, y])
    view.page.mouse.move(x, y)
    view.page.mouse.wheel(0, -100)  # scrolls the page alone
    view.settle()
    assert view.pin("A") == home["A"]
    view.page.evaluate("scrollTo(0, 0)")
    view.settle()
    view.page.keyboard.down("Control")
    view.page.mouse.wheel(0, -100)
    view.page.mouse.wheel(0, -100)
    view.page.keyboard.up("Control")
    view.settle()
    assert view.page.evaluate(place, [x, y]) == pytest.approx(before, abs=0.01)
    zoom = abs(view.pin("D") - view.pin("A")) / abs(home["D"] - home["A"])
    assert zoom == pytest.approx(np.exp(0.6), rel=1e-3)
    # The empty ground is dragged.
    a = view.pin("A")
    view.page.mouse.move(box["x"] + 10, box["y"] + 60)
    view.page.mouse.down()
    view.page.mouse.move(box["x"] + 40, box["y"] + 45, steps=3)
    view.page.mouse.up()
    view.settle()
    assert view.pin("A") == pytest.approx(a + (30 + 15j) * float(1), abs=0.1)
    view.drawing.get_by_role("button", name="Fit").click()
    assert view.pin("A") == home["A"] and view.pin("D") == home["D"]
    view.drawing.get_by_role("button", name="Zoom in").press("Enter")
    view.settle()
    assert abs(view.pin("D") - view.pin("A")) == pytest.approx(1.4 * abs(home["D"] - home["A"]), rel=1e-3)
    view.picture.dblclick(position={"x": 12, "y": 60})
    assert view.pin("A") == home["A"]


def test_keys_pan_and_zoom_while_the_drawing_has_the_focus(show: Any) -> None:
    view = show(reported("paper_feeder"))
    keys, home = view.page.keyboard, {name: view.pin(name) for name in "AD"}
    view.at(20)
    slider, hint = view.drawing.get_by_role("slider", name="time"), view.drawing.locator(".lw-keys")
    assert not hint.is_visible()
    view.picture.focus()
    keys.press("Shift+Tab")
    keys.press("Tab")
    assert hint.is_visible() and hint.get_attribute("id") == view.picture.get_attribute("aria-describedby")
    assert all(key in hint.inner_text() for key in "+−0")
    scroll = view.page.evaluate("scrollY")
    for pressed, by in (("ArrowRight", -40), ("ArrowDown", 40j), ("Shift+ArrowLeft", 160), ("Shift+ArrowUp", -160j)):
        before = view.pin("A")
        keys.press(pressed)
        view.settle()
        assert view.pin("A") - before == pytest.approx(by, abs=0.05)
    assert view.page.evaluate("scrollY") == scroll and slider.input_value() == "20"  # neither page nor time moved
    keys.press("0")
    view.settle()
    assert {name: view.pin(name) for name in "AD"} == home
    for pressed, factor in (("+", 1.4), ("-", 1.0), ("-", 1 / 1.4), ("=", 1.0)):
        keys.press(pressed)
        view.settle()
        assert abs(view.pin("D") - view.pin("A")) == pytest.approx(factor * abs(home["D"] - home["A"]), rel=1e-3)
    for pressed in ("Control+0", "a", "Alt+ArrowUp"):
        before = view.pin("A")
        keys.press(pressed)
        view.settle()
        assert view.pin("A") == before
    slider.focus()
    before = view.pin("A")
    keys.press("ArrowRight")
    view.settle()
    assert slider.input_value() == "21" and view.pin("A") == before  # the time has its own keys


def test_without_a_zoom_the_ground_is_not_dragged(show: Any) -> None:
    view = show(reported("paper_feeder"))
    box, a = view.picture.bounding_box(), view.pin("A")
    for keys, moved in (((), False), (("Shift",), True)):
        for key in keys:
            view.page.keyboard.down(key)
        view.page.mouse.move(box["x"] + 10, box["y"] + 60)
        view.page.mouse.down()
        view.page.mouse.move(box["x"] + 30, box["y"] + 60, steps=3)
        view.page.mouse.up()
        for key in keys:
            view.page.keyboard.up(key)
        view.settle()
        assert (view.pin("A") != a) == moved


def test_fit_makes_room_for_a_changed_mechanism(show: Any) -> None:
    view = show(reported("paper_feeder"))
    scale = abs(view.pin("D") - view.pin("A"))
    view.change("AB", 1.2)
    assert abs(view.pin("D") - view.pin("A")) == pytest.approx(scale)
    view.drawing.get_by_role("button", name="Fit").click()
    assert abs(view.pin("D") - view.pin("A")) < scale
    view.page.evaluate("linkwright.live.reset()")
    view.settle()
    view.drawing.get_by_role("button", name="Fit").click()
    assert abs(view.pin("D") - view.pin("A")) == pytest.approx(scale)


def test_the_drawing_fills_the_screen_with_its_controls(show: Any) -> None:
    view = show(reported("paper_feeder"))
    before = view.picture.bounding_box()["height"]
    button = view.drawing.get_by_role("button", name="Full screen")
    assert button.get_attribute("aria-pressed") == "false"
    button.click()
    view.page.wait_for_function("document.fullscreenElement !== null")
    view.settle()
    assert button.get_attribute("aria-pressed") == "true"
    assert view.picture.bounding_box()["height"] > before
    assert view.drawing.get_by_role("button", name="Play").is_visible()
    button.click()
    view.page.wait_for_function("document.fullscreenElement === null")


def test_a_readout_beside_a_point_has_its_values(show: Any) -> None:
    result = ran("paper_feeder").cycle.result
    view = show(reported("paper_feeder"))
    index = 60
    view.at(index)
    box = view.picture.locator('[data-point="C"]').bounding_box()
    view.page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    name, *cells = view.readout()
    assert name == "C"
    values = dict(zip(cells[::2], cells[1::2], strict=True))
    figures = {key: (float(text.split()[0]), text.split()[1]) for key, text in values.items()}
    speed = abs(complex_row(result, "C.v")[index])
    force = abs(complex_row(result, "force(coupler, rocker).")[index])
    expected = {
        "x": (result["C.x"][index] * 1e3, "mm"),
        "y": (result["C.y"][index] * 1e3, "mm"),
        "speed": (speed * 1e3, "mm/s"),
        "largest reaction": (force, "N"),
    }
    assert {key: unit for key, (_, unit) in figures.items()} == {key: unit for key, (_, unit) in expected.items()}
    for key, (value, _) in expected.items():
        assert figures[key][0] == pytest.approx(value, rel=1e-3)
    assert view.drawing.locator(".lw-hover").get_attribute("aria-hidden") == "true"
    view.at(index + 30)
    assert view.readout()[2] != cells[1]  # it follows the time
    view.page.mouse.move(5, 5)
    assert view.readout() == []


def test_a_tap_shows_the_readout_and_two_fingers_zoom(show: Any) -> None:
    view = show(reported("paper_feeder"), viewport={"width": 390, "height": 844}, has_touch=True, is_mobile=True)
    view.picture.scroll_into_view_if_needed()
    box = view.picture.locator('[data-point="D"]').bounding_box()
    view.page.touchscreen.tap(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    assert view.readout()[0] == "D"
    before = abs(view.pin("D") - view.pin("A"))
    frame = view.picture.bounding_box()
    cdp = view.context.new_cdp_session(view.page)
    middle = (frame["x"] + frame["width"] / 2, frame["y"] + frame["height"] / 2)
    for kind, apart in (("touchStart", 40), ("touchMove", 60), ("touchMove", 80), ("touchEnd", None)):
        ends = [] if apart is None else [{"x": middle[0] + side * apart, "y": middle[1]} for side in (-1, 1)]
        points = [{**end, "id": i} for i, end in enumerate(ends)]
        cdp.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
    view.settle()
    assert abs(view.pin("D") - view.pin("A")) == pytest.approx(2 * before, rel=0.05)


def test_names_make_way_for_one_another(show: Any) -> None:
    """No two texts that are seen overlap, however small the drawing, and there are at most forty."""
    view = show(reported("loader"), viewport={"width": 390, "height": 844})
    view.drawing.get_by_label("Dimensions", exact=True).check()
    for index in (0, 90, 200):
        view.at(index)
        texts = view.picture.locator(".lw-label:visible, .lw-measure:visible")
        boxes = texts.evaluate_all("all => all.map(each => each.getBoundingClientRect().toJSON())")
        assert 8 < len(boxes) <= 40
        overlaps = [  # but for what is free above and below letters, and around them
            (one, other)
            for i, one in enumerate(boxes)
            for other in boxes[:i]
            if min(one["x"] + one["width"], other["x"] + other["width"]) - max(one["x"], other["x"]) > 6
            and min(one["y"] + one["height"], other["y"] + other["height"]) - max(one["y"], other["y"]) > 10
        ]
        assert overlaps == []
    assert view.picture.locator(".lw-label:visible", has_text="tip").count() == 1


def test_cylinders_are_barrel_and_rod(show: Any) -> None:
    view = show(reported("loader"))
    assert view.picture.locator(".lw-piston").count() == view.picture.locator(".lw-rod").count() == 2
    assert view.picture.locator(".lw-block").count() == 0
    assert view.picture.locator('[data-point*="_end"]').count() == 0
    # At both ends of the stroke the piston stays within the barrel.
    inside = """() => { const of = c => [...document.querySelectorAll("#drawing " + c)];
      const at = e => { const b = e.getBBox(), m = e.getScreenCTM();
        return new DOMPoint(b.x + b.width / 2, b.y + b.height / 2).matrixTransform(m); };
      return of(".lw-piston").every(p => of("rect.lw-body").some(b => {
        const q = at(p).matrixTransform(b.getScreenCTM().inverse()), box = b.getBBox();
        return q.x >= box.x - 1 && q.x <= box.x + box.width + 1 && Math.abs(q.y) < 2; })); }"""
    for index in (0, 200):
        view.at(index)
        assert view.page.evaluate(inside)


@pytest.mark.parametrize(
    ("name", "changes"),
    [("paper_feeder", {"AB": 144, "AD": 321}), ("slider_crank", {"e": 30}), ("jansen_leg", {"m": 15.3})],
)
def test_centrodes_of_a_changed_mechanism(show: Any, name: str, changes: dict[str, float]) -> None:
    """The page finds and cuts them as Python does those of the changed model."""
    view = show(reported(name))
    stated = lw.load(EXAMPLES / f"{name}.yaml")
    model, outcomes = stated, ran(name).outcomes
    for _ in range(2):
        found = view.page.evaluate(
            """() => linkwright.drawing.scene.centrodes.map(
              ({ link, ...rows }) => [link, ["x", "y", "u", "v"].map(key => Array.from(rows[key]))])"""
        )
        true = {one["link"]: one for one in report_data(model, outcomes)["scene"].get("centrodes", ())}
        assert [link for link, _ in found] == [*true] and found
        for link, rows in found:
            here = np.array(rows, dtype=float)
            there = np.array([true[link][key] for key in "xyuv"], dtype=float)  # type: ignore[literal-required]
            assert (np.isfinite(here) == np.isfinite(there)).all()
            assert np.nanmax(np.abs(here - there)) < 1e-6 * np.nanmax(np.abs(there))
        for label, value in changes.items():
            view.set(label, value / 1e3)
        model = stated.replace(**changes)
        outcomes = lw.run(model).outcomes


def test_centrodes_follow_a_change(show: Any) -> None:
    view = show(reported("paper_feeder"))
    path = view.picture.locator(".lw-centrode .lw-fixed")
    assert path.count() == 0
    view.drawing.get_by_role("group", name="Centrodes").get_by_label("coupler", exact=True).check()
    before = path.get_attribute("d")
    view.change("AB", 1.02)
    assert path.is_visible() and path.get_attribute("d") != before
    view.page.evaluate("linkwright.live.reset()")
    view.settle()
    assert path.get_attribute("d") == before


def test_many_paths_are_chosen_by_name(show: Any) -> None:
    data = reported("paper_feeder")
    scene = data["scene"]
    extra = {f"T{i}": [10.0 * i, 20.0] for i in range(9)}
    recorded = {**data, "live": None}
    link = {**scene["links"][2], "points": {**scene["links"][2]["points"], **extra}}
    rows = [{**scene["traces"][0], "name": name} for name in extra]
    recorded["scene"] = {
        **{key: value for key, value in scene.items() if key != "arrows"},
        "links": [link if i == 2 else each for i, each in enumerate(scene["links"])],
        "traces": [*scene["traces"], *rows],
    }
    view = show(recorded)
    summary = view.drawing.locator(".lw-chooser summary")
    assert summary.inner_text() == f"Paths 9/{len(scene['traces']) + 9}"  # those of points that no joint holds
    summary.click()
    view.drawing.get_by_role("searchbox").fill("t3")
    boxes = view.drawing.locator(".lw-chooser input[type=checkbox]:visible")
    assert boxes.count() == 1
    boxes.uncheck()
    assert summary.inner_text() == f"Paths 8/{len(scene['traces']) + 9}"
    view.drawing.get_by_role("searchbox").fill("")
    view.drawing.get_by_role("button", name="None").click()
    assert view.picture.locator(".lw-trace:visible").count() == 0
    view.page.keyboard.press("Escape")
    assert not boxes.first.is_visible()


def test_paper_shows_what_the_screen_does(show: Any) -> None:
    view = show(reported("paper_feeder"), color_scheme="dark")
    view.show("Reactions")
    view.drawing.get_by_label("Dimensions", exact=True).check()
    view.page.emulate_media(media="print")
    view.settle()
    still = view.page.locator("#still")
    assert still.locator(".lw-reaction:visible").count() > 3 and still.locator(".lw-measure:visible").count() > 2
    colour = still.locator(".lw-reaction").first.evaluate("path => getComputedStyle(path).fill")
    assert colour == "rgb(194, 24, 91)"  # that on light ground


def test_without_a_program_there_are_no_arrows(show: Any) -> None:
    view = show(reported("parallelogram"))
    assert view.drawing.get_by_label("Velocities", exact=True).count() == 0
    view.drawing.get_by_label("Dimensions", exact=True).check()
    assert view.picture.locator(".lw-measure").count() > 0
