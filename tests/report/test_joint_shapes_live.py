"""Slots and other lines of joints in a live report: what the page draws at other numbers is what Python draws."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import shapely

import linkwright as lw
from helpers.opened import OpenedDrawing, opened, written
from linkwright.report.build import report_data

pytestmark = pytest.mark.browser
pytest.importorskip("playwright.sync_api")

EXAMPLES = Path(__file__).parents[2] / "examples"
OUTLINES = """() => Object.fromEntries(linkwright.drawing.scene.links.filter(l => l.outlines)
  .map(l => [l.name, l.outlines]))"""
ARC = "arc: {centre: M, radius: radius, start: 180 deg}"
SPLINE = "curve: {along: M at 90 deg, through: [[-45, 3], [-10, 0], [radius/5, 1], [45, 6]]}"


@pytest.fixture
def show(browser: Any, tmp_path: Path) -> Iterator[Any]:
    yield from opened(browser, written(tmp_path), OpenedDrawing)


@pytest.mark.parametrize(
    ("example", "changes", "slot"),
    [
        ("curved_slot", {"r": 27, "radius": 55}, ARC),
        ("curved_slot", {"r": 28, "radius": 40}, SPLINE),
        ("scotch_yoke", {"r": 44}, ARC),
        ("slotted_lever", {"r": 80, "d": 250}, ARC),
    ],
)
def test_slots_follow_a_change(show: Any, tmp_path: Path, example: str, changes: dict[str, float], slot: str) -> None:
    """The page's edge is that of the changed file in Python, but that it stays as wide as in the original."""
    text = (EXAMPLES / f"{example}.yaml").read_text(encoding="utf-8").replace(ARC, slot)
    file = tmp_path / "model.yaml"
    file.write_text(text, encoding="utf-8")
    document = lw.load(file)
    view = show(report_data(document, lw.run(document).outcomes, text=text))
    before = view.page.evaluate(OUTLINES)
    for name, value in changes.items():
        view.set(name, value / 1e3)
    after = view.page.evaluate(OUTLINES)
    view.page.wait_for_timeout(200)  # what the page says follows when the numbers rest
    state = view.page.locator(".live-line").inner_text()
    assert "joints close" in state and "cam" not in state
    changed = document.replace(**changes)
    job = lw.run(changed)
    drawn = {
        link["name"]: link["outlines"]
        for link in report_data(changed, job.outcomes)["scene"]["links"]
        if "outlines" in link
    }
    assert after.keys() == drawn.keys() == before.keys()
    for link, lines in drawn.items():
        for line, shown, was in zip(lines, after[link], before[link], strict=True):
            edge, here, former = (shapely.LinearRing(each) for each in (line, shown, was))
            width = edge.length and 2 * shapely.Polygon(line).area / edge.length
            assert edge.hausdorff_distance(here) < 0.05 * width < 0.2 * edge.hausdorff_distance(former)
    view.page.evaluate("linkwright.live.reset()")
    view.settle()
    assert view.page.evaluate(OUTLINES) == before


def test_a_geneva_drive_follows_a_change(show: Any) -> None:
    """Wheel, locking disc and pin for another centre distance are those of Python, without a rest."""
    document = lw.load(EXAMPLES / "geneva_drive.yaml")
    document = document.model_copy(update={"studies": {"cycle": document.studies["cycle"]}})
    text = (EXAMPLES / "geneva_drive.yaml").read_text(encoding="utf-8")
    view = show(report_data(document, lw.run(document).outcomes, text=text))
    before = view.page.evaluate(OUTLINES)
    view.set("c", 0.115)
    after = view.page.evaluate(OUTLINES)
    changed = document.replace(c=115)
    links = report_data(changed, lw.run(changed).outcomes)["scene"]["links"]
    drawn = {link["name"]: link["outlines"] for link in links if "outlines" in link}
    assert after.keys() == drawn.keys() == before.keys() == {"driver", "table"}
    assert [len(lines) for lines in drawn.values()] == [2, 1]
    for link, lines in drawn.items():
        for line, shown, was in zip(lines, after[link], before[link], strict=True):
            edge, here, former = (shapely.LinearRing(each) for each in (line, shown, was))
            assert edge.is_valid
            assert edge.hausdorff_distance(here) < 1e-3 * edge.hausdorff_distance(former)
