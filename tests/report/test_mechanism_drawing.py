"""The still drawing of pages without script: its places, its size, and that it is the script's own picture."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
import shapely

from linkwright.report import ReportData, Scene, page
from linkwright.report.mechanism_drawing import drawing
from linkwright.report.mechanism_drawing.shapes import MOST_POINTS, hull, line, needed, outline, spring
from linkwright.words import say

STYLES = Path(__file__).parents[2] / "web" / "src" / "drawing" / "drawing.css"
POINT = re.compile(r"(-?[\d.]+) (-?[\d.]+)")


def read(scene: Scene) -> ElementTree.Element:
    return ElementTree.fromstring(drawing(scene))


def of_class(root: ElementTree.Element, name: str) -> list[ElementTree.Element]:
    return [one for one in root.iter() if name in one.get("class", "").split()]


def pins(root: ElementTree.Element) -> list[complex]:
    """The centres of the pins' circles, y up, in the order of the scene."""
    return [complex(float(one.get("cx", "")), -float(one.get("cy", ""))) for one in of_class(root, "lw-pin")]


@pytest.fixture
def scene(report: ReportData) -> Scene:
    return report["scene"]


def test_pins_are_at_their_places(scene: Scene, feeder: Any) -> None:
    """At the first pose; two ground pivots give scale and origin."""
    a, d, b, c, e = pins(read(scene))
    at = {name: feeder.points[name][0] for name in "ABCDE"}
    scale = (d - a) / (at["D"] - at["A"])
    assert abs(scale.imag) < 1e-9
    for found, name in ((b, "B"), (c, "C"), (e, "E")):
        assert abs(found - a - scale * (at[name] - at["A"])) < 0.2, name


def test_the_first_pose_that_can_be_assembled_is_drawn(scene: Scene, feeder: Any) -> None:
    whole = pins(read(scene))
    for link in scene["links"][1:]:
        for row in link["pose"].values():
            row[:30] = [None] * 30  # type: ignore[index]
    scene["traces"] = []
    a, d, b, *_ = pins(read(scene))
    scale = (d - a) / (feeder.points["D"][0] - feeder.points["A"][0])
    assert abs(b - a - scale * (feeder.points["B"][30] - feeder.points["A"][0])) < 0.2
    assert abs(b - whole[2]) > 5
    assert not of_class(read(scene), "lw-note")


@pytest.mark.parametrize("values", [[], [None] * 201])
def test_without_a_pose_it_says_so(scene: Scene, values: list[None]) -> None:
    for link in scene["links"][1:]:
        link["pose"] = dict.fromkeys("xycs", values)  # type: ignore[typeddict-item]
    scene["traces"] = []
    root = read(scene)
    assert [one.text for one in of_class(root, "lw-note")] == [say("report.not_assembled")]
    assert not of_class(root, "lw-body") and not of_class(root, "lw-ghost")
    assert len(of_class(root, "lw-pivot")) == 2


def test_it_is_light(scene: Scene) -> None:
    root = read(scene)
    assert len(drawing(scene).encode()) < 12_000
    lines = [one.get("d", "") for group in of_class(root, "lw-trace") for one in group.iter() if one.get("d")]
    assert len(lines) == 2
    assert all(1 < len(POINT.findall(d)) <= MOST_POINTS for d in lines)
    assert not re.search(r"\d\.\d\d", drawing(scene))


@pytest.mark.parametrize("unseen", [0.15, 0.5, 4.0])
@pytest.mark.parametrize("closed", [False, True])
@pytest.mark.parametrize("count", [2, 3, 5, 40, 300])
def test_thinned_lines_stay_close(count: int, closed: bool, unseen: float) -> None:
    """No place lies farther from the line through those that are needed, which are as few as GEOS finds; of a circle,
    on which many are equally far from a chord, about as few."""
    wild = np.cumsum(np.random.default_rng(count).normal(size=(count, 2)), axis=0)
    angles = np.linspace(0, 7, count)
    for places in (wild, 50 * np.column_stack([np.cos(angles), np.sin(angles)])):
        ring = np.concatenate([places, places[:1]]) if closed else places
        seen, whole = ring[needed(ring, unseen)], shapely.LineString(ring)
        assert shapely.distance(shapely.LineString(seen), shapely.points(ring)).max() <= unseen * (1 + 1e-12)
        few = shapely.get_coordinates(whole.simplify(unseen, preserve_topology=False))
        if places is wild:
            np.testing.assert_array_equal(seen, few)
        assert len(seen) <= 1.1 * len(few) + 1


def test_names_are_text(scene: Scene) -> None:
    scene["links"][1]["name"] = "<b>&\"'"
    scene["joints"][0]["links"] = ("frame", "<b>&\"'")
    scene["joints"][1]["links"] = ("<b>&\"'", "coupler")
    scene["length_unit"] = "<i>"
    texts = [*read(scene).itertext()]
    assert "<b>&\"'" in texts and any(text.endswith(" <i>") for text in texts)


@pytest.mark.parametrize("r", [3.0, 40.0])
@pytest.mark.parametrize("corners", [[[0, 0], [100, 0], [30, 80], [40, 20]], [[0, 0], [100, 50], [50, 25]]])
def test_an_outline_keeps_its_distance(corners: list[list[float]], r: float) -> None:
    """Each side of a plate or a bar ends r away from its corner and further from the others."""
    ring = hull(np.array(corners, float)) * [1, -1]
    assert len(ring) == min(len(corners) - 1, 3)
    ends = np.array(POINT.findall(re.sub(r"A\S+ \S+ 0 0 1 ", "L", outline(ring, r))), float)
    assert len(ends) == 2 * len(ring) + 1
    assert [np.hypot(*(ring - end).T).min() for end in ends] == pytest.approx([r] * len(ends), abs=0.1)


def test_the_outline_of_a_point_is_a_circle() -> None:
    assert outline(np.array([[5.0, 5.0]]), 3.0) == "M2 5a3 3 0 1 1 6 0a3 3 0 1 1-6 0Z"
    assert outline(np.empty((0, 2)), 3.0) == ""


def test_lines_are_thinned_and_interrupted() -> None:
    turn = np.linspace(0, 2 * np.pi, 1000)
    circle = np.array([300 * np.cos(turn), 300 * np.sin(turn)]).T
    thin = np.array(POINT.findall(line(circle)), float)
    assert 20 < len(thin) <= MOST_POINTS
    assert np.abs(np.hypot(*thin.T) - 300).max() < 0.1
    assert len(POINT.findall(line(np.random.default_rng(1).normal(size=(1000, 2)) * 90))) == MOST_POINTS
    circle[500] = np.nan
    assert line(circle).count("M") == 2
    assert line(circle[:1]) == ""


def test_springs_and_cylinders_have_their_symbols(scene: Scene) -> None:
    (rail, slide) = scene["joints"][-2:]
    scene["springs"] = [
        {"name": look, "links": ["frame", "rocker"], "points": ["A", "E"], "look": look}  # type: ignore[typeddict-item]
        for look in ("coil", "strut")
    ]
    slide["look"] = rail["look"] = "cylinder"  # that of the frame stays a rail
    root = read(scene)
    coil, strut = (one.get("d", "") for one in of_class(root, "lw-spring"))
    assert (coil.count("L"), strut.count("M")) == (15, 3)
    assert len(of_class(root, "lw-rod")) == len(of_class(root, "lw-piston")) == len(of_class(root, "lw-centre")) == 1
    assert spring(np.zeros(2), np.zeros(2), "coil", 5)  # of no length


def test_an_area_lies_behind_the_mechanism(scene: Scene) -> None:
    scene["areas"] = [
        {"name": "reach", "rings": [[[0, 0], [900, 0], [900, 900]], [[500, 100], [600, 100], [600, 200]]]}
    ]
    text = drawing(scene)
    assert text.index("lw-area") < text.index("lw-body")
    (area,) = of_class(read(scene), "lw-area")
    assert area[0].get("d", "").count("Z") == 2


def test_all_that_it_draws_has_looks(report: ReportData) -> None:
    """The one style sheet of drawings knows each of its classes."""
    css = STYLES.read_text("utf-8")
    used = {name for names in re.findall(r'class="([^"]*)"', page(report)) for name in names.split()}
    drawn = {name for name in used if name.startswith("lw-")}
    assert len(drawn) > 12
    assert {name for name in drawn if not re.search(rf"\.{name}\b", css)} <= WITHOUT_LOOKS


WITHOUT_LOOKS = {"lw-labels"}
"""Groups only."""


@pytest.fixture
def shown(browser: Any, report: ReportData, tmp_path: Path, request: pytest.FixtureRequest) -> Iterator[Any]:
    (tmp_path / "report.html").write_text(page(report), encoding="utf-8")
    context = browser.new_context(java_script_enabled=getattr(request, "param", False))
    view = context.new_page()
    view.goto((tmp_path / "report.html").as_uri())
    yield view
    context.close()


@pytest.mark.browser
def test_without_script_the_page_shows_drawing_and_tables(shown: Any) -> None:
    assert shown.locator("noscript svg.lw-drawing").is_visible()
    assert shown.locator("noscript .lw-label", has_text="coupler").is_visible()
    assert shown.locator("table.measures").is_visible()
    assert shown.locator("noscript p").all_inner_texts() == [say("report.no_script")] * 2  # of motion and of forces
    for empty in ("#drawing", "figure.plot", ".hint", ".paper"):
        assert not shown.locator(empty).first.is_visible(), empty
    shown.emulate_media(media="print")
    assert shown.locator("noscript svg.lw-drawing").is_visible()
    assert not shown.locator(".paper").is_visible()


@pytest.mark.browser
@pytest.mark.parametrize("shown", [True], indirect=True)
def test_it_has_the_parts_of_the_script_s_drawing(shown: Any, report: ReportData) -> None:
    assert not shown.locator("noscript").first.is_visible()
    classes = shown.evaluate(
        """[...document.querySelectorAll("#still svg *")].filter(node => !node.closest(".lw-ghost"))
        .flatMap(node => [...node.classList])"""
    )
    ours = ElementTree.fromstring(drawing(report["scene"]))
    for ghost in of_class(ours, "lw-ghost"):
        ours.remove(ghost)
    found = Counter(name for one in ours.iter() for name in one.get("class", "").split())
    theirs = Counter(classes)
    same = (
        "body",
        "slot",
        "block",
        "pin",
        "point",
        "label",
        "name",
        "trace",
        "ground",
        "pivot",
        "centre",
        "scale",
        "grid",
    )
    assert {name: found[f"lw-{name}"] for name in same} == {name: theirs[f"lw-{name}"] for name in same}
