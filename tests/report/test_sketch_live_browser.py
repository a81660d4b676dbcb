"""Lengths of a sketched mechanism in a live report: offered first, changed as a file does it, and copied."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

import linkwright as lw
from helpers.opened import Opened, opened
from linkwright.model.document import load
from linkwright.report.build import report_data
from linkwright.report.page import page

pytestmark = pytest.mark.browser
pytest.importorskip("playwright.sync_api")

WIPER = """\
linkwright: 1
units: {length: mm, angle: deg, mass: kg, time: s, force: N, torque: N*m}
PARAMETERSsketch: {A: [0, 0], B: [0, 40], C: [305, 55], D: [305, 0], T: [305, 450]}
links:
  frame: {points: [A, D]}
  crank: {points: [A, B]}
  rod: {points: [B, C], mass: 0.3, shape: rod B-C}
  arm: {points: [D, C, T], mass: 0.5, shape: rod D-T}
drives:
  motor: {turns: crank, on: frame, speed: 45 rpm}
measures:
  sweep: {span: arm.angle}
  torque: {extremes: motor.torque}
require:
  sweep: ">= 90 deg"
studies:
  cycle: {turns: 1 motor}
"""
FORMS = {
    "none": ("", ["parameters: {AB: 44, BC: 300}"]),
    "braces": ("parameters: {DC: 55}\n", ["parameters: {AB: 44, BC: 300, DC: 55}"]),
    "block": ("parameters:\n  DC: 55\n", ["parameters:", "  AB: 44", "  BC: 300"]),
}
"""What a file says of its parameters, and the lines with the lengths of the crank and of the rod."""


@pytest.fixture
def show(browser: Any, tmp_path: Path) -> Iterator[Callable[..., Opened]]:
    def report(text: str) -> Path:
        file = tmp_path / "wiper.yaml"
        file.write_text(text, encoding="utf-8")
        job = lw.run(file)
        found = tmp_path / "wiper.html"
        data = report_data(load(file), job.outcomes, job.examined.findings, job.examined.origin, text)
        found.write_text(page(data), encoding="utf-8")
        return found

    yield from opened(browser, report)


def enter(view: Opened, label: str, value: str) -> None:
    entry = view.page.get_by_label(label, exact=True).and_(view.page.locator("[type=text]"))
    entry.fill(value)
    entry.press("Enter")
    view.page.wait_for_timeout(250)


def figures(view: Opened) -> list[float]:
    texts = view.page.locator("#measures tbody .line.value b").all_inner_texts()
    return [float(text.replace("−", "-")) for text in texts]


@pytest.mark.parametrize("form", FORMS)
def test_lengths_are_changed_as_a_file_does_it(show: Callable[..., Opened], tmp_path: Path, form: str) -> None:
    """The lengths of links are seen, coordinates of the sketch are folded. With two of them changed the page offers the
    lines with these as parameters, and a run of the file with these lines has the page's figures."""
    before, expected = FORMS[form]
    text = WIPER.replace("PARAMETERS", before)
    view = show(text)
    seen = view.page.locator("#numbers > .numbers .dimension label").all_inner_texts()
    assert seen == (["AB", "BC", "DC"] if form == "none" else ["DC", "AB", "BC"])
    assert not view.page.locator("#numbers details").get_attribute("open")
    assert view.page.locator("#numbers details label").filter(has_text="B.").count() == 2
    enter(view, "AB", "44")
    enter(view, "BC", "300")
    lines = view.page.locator(".live-lines").inner_text().splitlines()
    assert lines == expected
    first = before.splitlines()[:1]
    changed = text.replace("\n".join(first), "\n".join(lines), 1) if first else f"{text}{lines[0]}\n"
    file = tmp_path / "changed.yaml"
    file.write_text(changed, encoding="utf-8")
    measures = lw.run(file).cycle.measures
    true = [figure.value / measure.size for measure in measures for figure in measure.found]
    assert figures(view) == pytest.approx(true, rel=2e-5)
    view.page.get_by_role("button", name="Reset all").click()
    view.page.wait_for_timeout(250)
    assert not view.page.locator(".dimension.changed").count()
    assert view.page.locator("#numbers > .numbers [type=text]").first.input_value() in ("40", "55")


def test_a_length_follows_its_points_until_it_is_stated(show: Callable[..., Opened]) -> None:
    """The height of B moves AB; of a stated AB it only turns the drawn crank, and the button brings the drawn length
    back."""
    view = show(WIPER.replace("PARAMETERS", ""))
    view.page.locator("#numbers summary").click()
    length = view.page.get_by_label("AB", exact=True).and_(view.page.locator("[type=text]"))
    enter(view, "B.y", "50")
    assert length.input_value() == "50"
    assert view.page.locator(".live-lines").inner_text().splitlines()[0].startswith("sketch: {A: [0, 0], B: [0, 50]")
    assert "parameters" not in view.page.locator(".live-lines").inner_text()
    enter(view, "AB", "44")
    enter(view, "B.y", "60")
    assert length.input_value() == "44"
    row = view.page.locator(".dimension", has=length)
    row.locator(".back").click()
    view.page.wait_for_timeout(250)
    assert length.input_value() == "60"
