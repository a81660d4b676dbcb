"""Moments in the drawing of a live report, in a real browser: sense and radius of their arrows follow the signals."""

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
SAMPLES = 120
STIFFNESS, FREE, BRAKE = 2.0, np.radians(-60), 1.5  # N m/rad, rad, N m
LID = f"""
linkwright: 1
name: Lid
units: {{length: mm, angle: deg, mass: kg, time: s, force: N, torque: N*m}}
gravity: [0, -9.81 m/s^2]
links:
  frame:   {{points: {{A: [0, 0], D: [300, 0]}}}}
  crank:   {{points: {{A: [0, 0], B: [80, 0]}}, mass: 0.5, shape: rod A-B}}
  coupler: {{points: {{B: [0, 0], C: [260, 0]}}, mass: 0.6, shape: rod B-C}}
  rocker:  {{points: {{C: [0, 0], D: [180, 0]}}, mass: 0.8, shape: rod C-D}}
drives:
  motor: {{turns: crank, on: frame, speed: 60 rpm, start: 20 deg}}
assembly: {{C: left of B-D}}
springs:
  hold: {{turns: rocker, on: frame, stiffness: {STIFFNESS} N*m/rad, free: -60 deg}}
  hinge: {{turns: coupler, on: crank, damping: 0.05 N*m*s/rad}}
loads:
  brake: {{on: rocker, torque: "{BRAKE}*sin(360 deg*t/(1 s))"}}
studies:
  cycle: {{turns: 1 motor, samples: {SAMPLES}}}
"""


@pytest.fixture(scope="module")
def lid(tmp_path_factory: pytest.TempPathFactory) -> tuple[ReportData, Any]:
    file = tmp_path_factory.mktemp("lid") / "lid.yaml"
    file.write_text(LID, encoding="utf-8")
    return reported(file)


@cache
def reported(file: Path) -> tuple[ReportData, Any]:
    """The report of a file, and the result behind it."""
    job = lw.run(file)
    assert job.cycle is not None
    return report_data(lw.load(file), job.outcomes), job.cycle.result


@pytest.fixture
def show(browser: Any, tmp_path: Path) -> Iterator[Any]:
    yield from opened(browser, written(tmp_path), OpenedDrawing)


ROUND = """path => {  // places along a part of the arc from its tail on, y up
    const at = share => path.getPointAtLength(share * path.getTotalLength());
    return Array.from({ length: 24 }, (_, i) => at((0.3 * i) / 23)).map(({ x, y }) => [x, -y]);
}"""


def turning(view: OpenedDrawing, name: str, about: complex) -> float:
    """The radius of a moment's arrow (px), positive where it runs counter-clockwise; 0 where there is none."""
    path = view.picture.locator(f'.lw-moment[data-arrow="{name}"]')
    if not path.get_attribute("d"):
        return 0.0
    arms = np.array([complex(*at) for at in path.evaluate(ROUND)]) - about
    assert np.ptp(np.abs(arms)) < 0.3  # a circle about the place
    swept = np.angle(arms[1:] / arms[:-1])
    assert (np.sign(swept) == np.sign(swept[0])).all()
    return float(np.abs(arms).mean() * np.sign(swept[0]))


def test_sense_and_radius_follow_the_signals(show: Any, lid: tuple[ReportData, Any]) -> None:
    data, result = lid
    view = show(data)
    assert view.picture.locator(".lw-moment").count() == 0
    view.show("Moments")
    assert view.picture.locator(".lw-moment").count() == 4
    t = result.t
    values = {
        ("motor.torque", "A"): result["motor.torque"],
        ("hold", "D"): -STIFFNESS * (result["rocker.angle"] - FREE),  # that on the rocker
        ("hinge", "B"): -0.05 * (result["coupler.omega"] - result["crank.omega"]),
        ("brake", "D"): BRAKE * np.sin(2 * np.pi * t),
    }
    most = max(np.abs(rows).max() for rows in values.values())
    width = float(view.picture.get_attribute("viewBox").split()[2])
    usual = min(max(width / 15, 22), 40)
    senses: dict[str, set[float]] = {}
    for index in (3, 20, 45, 59, 60, 61, 75, 100, 119):
        view.at(index)
        for (name, pin), rows in values.items():
            expected = usual * rows[index] / most
            radius = turning(view, name, view.pin(pin))
            assert radius == pytest.approx(expected, abs=0.05) or (radius == 0 and abs(expected) < 2.05)
            senses.setdefault(name, set()).add(np.sign(radius))
    assert senses["brake"] == {-1.0, 0.0, 1.0} and senses["motor.torque"] >= {-1.0, 1.0}


def test_it_turns_over_between_two_samples(show: Any, lid: tuple[ReportData, Any]) -> None:
    """At the time of the zero crossing there is no arrow; a little before and after they are opposite."""
    view = show(lid[0])
    view.show("Moments")
    view.drawing.get_by_label("Radius of arrows: Moments").fill("2")
    radii = []
    for time in (0.46, 0.497, 0.5, 0.503, 0.54):
        view.page.evaluate("t => linkwright.drawing.setTime(t)", time)
        radii.append(turning(view, "brake", view.pin("D")))
    assert radii[0] > 5 > 0 and radii[2] == 0 and radii[4] < -5
    assert radii[0] == pytest.approx(-radii[4], abs=0.1)
    assert abs(radii[1]) < 5 and abs(radii[3]) < 5


def test_the_moment_of_a_slides_reaction(show: Any) -> None:
    data, result = reported(EXAMPLES / "paper_feeder.yaml")
    view = show(data)
    view.show("Moments", "Reactions")
    name, moments = "force(frame, guide).moment", result["force(frame, guide).moment"]
    torques = result["motor.torque"]
    for index in (10, 60, 100, 160):
        view.at(index)
        start, _ = view.arrow("reaction", "force(frame, guide)")
        here, other = turning(view, name, start), turning(view, "motor.torque", view.pin("A"))
        if abs(here) > 4 and abs(other) > 4:
            assert here / other == pytest.approx(moments[index] / torques[index], rel=0.02)
        else:
            assert min(abs(moments[index]), abs(torques[index])) < 0.15 * np.abs(torques).max()


def test_a_changed_mechanism_keeps_the_scale(show: Any, lid: tuple[ReportData, Any]) -> None:
    view = show(lid[0])
    view.show("Moments")
    view.at(40)
    before = turning(view, "hold", view.pin("D"))
    view.change("hold.stiffness", 1.5)
    assert turning(view, "hold", view.pin("D")) == pytest.approx(1.5 * before, abs=0.05)


def test_values_are_shown_at_the_pin_and_at_the_arrow(show: Any, lid: tuple[ReportData, Any]) -> None:
    data, result = lid
    view = show(data)
    view.show("Moments")
    index = 40
    view.at(index)
    box = view.picture.locator('[data-point="A"]').bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    view.page.mouse.move(x, y)
    cells = view.readout()
    value, unit = cells[cells.index("motor.torque") + 1].split()
    assert unit == "N·m" and float(value) == pytest.approx(result["motor.torque"][index], rel=1e-3)
    view.drawing.get_by_label("Radius of arrows: Moments").fill("1.5")
    scale = view.picture.bounding_box()["width"] / float(view.picture.get_attribute("viewBox").split()[2])
    radius = abs(turning(view, "hold", view.pin("D"))) * scale
    box = view.picture.locator('[data-point="D"]').bounding_box()
    view.page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2 - radius)
    name, what, value = view.readout()
    assert (name, what) == ("hold", "moment")
    expected = -STIFFNESS * (result["rocker.angle"][index] - FREE)
    assert float(value.split()[0]) == pytest.approx(expected, rel=1e-3)
    before = value
    view.at(index + 20)
    assert view.readout()[2] != before  # it follows the time
    view.page.mouse.move(5, 5)
    assert view.readout() == []


def test_paper_shows_moments_with_their_key(show: Any, lid: tuple[ReportData, Any]) -> None:
    view = show(lid[0])
    view.show("Moments")
    view.page.emulate_media(media="print")
    view.settle()
    still = view.page.locator("#still")
    assert still.locator(".lw-arrows .lw-moment:visible").count() >= 2
    assert still.locator(".lw-key text").text_content().startswith("Moments: ")
    assert still.locator(".lw-key .lw-moment").get_attribute("d") != ""
