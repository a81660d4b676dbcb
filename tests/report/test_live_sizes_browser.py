"""The live report in a browser at its limits: as many links as a file may have, nothing that drives, no numbers, and a
drag that loses the assembly."""

from __future__ import annotations

import re
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import linkwright as lw
from helpers.examples import four_bar
from linkwright.model.document import dump, load
from linkwright.report.build import report_data
from linkwright.report.page import page
from linkwright.results import Run
from report.test_live_browser import rested, slide, state
from report.test_report_browser import Opened

pytestmark = pytest.mark.browser
pytest.importorskip("playwright.sync_api")


def written(folder: Path, data: dict[str, Any]) -> Path:
    """The report of a model."""
    file = folder / "model.yaml"
    file.write_text(dump(lw.Document.model_validate(data)), encoding="utf-8")
    path = folder / "report.html"
    job = lw.run(file)
    text = file.read_text(encoding="utf-8")
    path.write_text(page(report_data(load(file), job.outcomes, text=text)), encoding="utf-8")
    return path


def chain(dyads: int) -> dict[str, Any]:
    """Parallelograms in a row, each driven by the rocker before it, which rocks about upright."""
    radius, pitch = 0.3, 0.4
    links: dict[str, Any] = {"frame": {"points": {f"A{i}": [f"{i}*p", 0] for i in range(dyads + 1)}}}
    links["L0"] = {"points": {"A0": [0, 0], "B0": ["r", 0]}, "mass": 1, "shape": "rod A0-B0"}
    assembly = {}
    for i in range(1, dyads + 1):
        bar = f"rod B{i - 1}-B{i}"
        links[f"K{i}"] = {"points": {f"B{i - 1}": [0, 0], f"B{i}": ["p", 0]}, "mass": 0.5, "shape": bar}
        links[f"L{i}"] = {"points": {f"A{i}": [0, 0], f"B{i}": ["r", 0]}, "mass": 1, "shape": f"rod A{i}-B{i}"}
        assembly[f"B{i}"] = f"left of B{i - 1}-A{i}"
    return {
        "linkwright": 1,
        "units": {"length": "m", "angle": "rad", "mass": "kg"},
        "gravity": [0, "-9.81 m/s^2"],
        "parameters": {"r": radius, "p": pitch},
        "links": links,
        "assembly": assembly,
        "drives": {"motor": {"turns": "L0", "on": "frame", "position": "1.57 rad + 0.5 rad*sin(6.28 rad/s*t)"}},
        "measures": {"height": {"max": f"B{dyads}.y"}},
        "studies": {"cycle": {"duration": "1 s", "samples": 24}},
    }


@pytest.mark.parametrize("dyads", [29, pytest.param(99, marks=pytest.mark.long)])
def test_many_links(browser: Any, tmp_path: Path, dyads: int) -> None:
    """The page is alive, with 60 links and with 200, the most of a file: it opens, confirms the recorded values,
    and computes a change as Python does."""
    data = chain(dyads)
    assert len(data["links"]) == 2 * dyads + 2
    path = written(tmp_path, data)
    assert path.stat().st_size < 3e6
    start = time.monotonic()
    view = Opened(browser, path)
    assert view.page.evaluate("linkwright.live.sound")
    assert time.monotonic() - start < 20  # some two seconds on a free machine
    slide(view, "r", 0.36)
    found = np.array(view.page.evaluate(f"Array.from(linkwright.live.signal('B{dyads}.y'))"))
    times = np.array(view.page.evaluate("linkwright.live.data.times"))
    compiled = lw.compile(lw.Document.model_validate(data).replace(r=0.36))
    true = Run(compiled, 0.0, 1.0, 24).evaluate([f"B{dyads}.y"], times)[0]
    assert np.abs(found - true).max() < 1e-9
    assert found.max() == pytest.approx(0.36, rel=1e-3)  # in closed form
    assert re.search(r"closure error \d(\.\d)?e-1\d", state(view))
    assert "Changed" in view.page.locator("#state").inner_text()
    took = view.page.evaluate(
        "(() => { const start = performance.now(); linkwright.live.set(0, 0.31); return performance.now() - start; })()"
    )
    assert took < 5000
    assert view.complaints == []
    view.context.close()


def test_a_model_without_a_drive(browser: Any, tmp_path: Path) -> None:
    """A structure that stands has one pose: nothing to move, and no panel that says so."""
    data = four_bar(
        assembly={"B": "left of A-D", "C": "left of B-D"},
        studies={"reactions": {}},
        loads={"push": {"on": "rocker", "at": "C", "force": [10, 0]}},
    )
    data.pop("drives")
    data["links"]["tie"] = {"points": {"B": [0, 0], "D": [3.5, 0]}}
    view = Opened(browser, written(tmp_path, data))
    assert view.page.evaluate("linkwright.live") is None
    assert view.page.locator("#dimensions").count() == 0
    assert view.page.locator("#drawing .lw-body").count() > 2
    assert view.complaints == []
    view.context.close()


def test_a_model_without_numbers(browser: Any, tmp_path: Path) -> None:
    """Where no number stands as such in the file there is nothing to move; the page plays all the same."""
    data = four_bar(studies={"cycle": {"turns": "1 motor", "samples": 24}})
    for link in data["links"].values():
        for place in link["points"].values():
            place[:] = [f"{value} m + 0 m" for value in place]
    data["drives"]["motor"] |= {"speed": "1 rad/s + 0 rad/s", "start": "0.5 rad + 0 rad"}
    view = Opened(browser, written(tmp_path, data))
    assert view.page.evaluate("linkwright.live?.data.numbers ?? []") == []
    assert view.page.locator(".dimension").count() == 0
    before = view.pin("B")
    view.page.evaluate("linkwright.drawing.setIndex(12)")
    view.settle()
    assert abs(view.pin("B") - before) > 5
    assert view.complaints == []
    view.context.close()


def test_a_drag_that_loses_the_assembly(browser: Any, tmp_path: Path) -> None:
    """Where the point goes the links close, at other times they don't: the page says when, and how to come back."""
    data = four_bar(b=2.6, c=2.6, parameters={"a": 1}, studies={"cycle": {"turns": "1 motor", "samples": 60}})
    data["links"]["crank"]["points"]["B"] = ["a", 0]
    view = Opened(browser, written(tmp_path, data))
    here, centre = view.pin("B"), view.pin("A")
    goal = centre + 1.45 * (here - centre)
    view.page.mouse.move(here.real, -here.imag)
    view.page.mouse.down()
    for share in (0.3, 0.6, 1.0):
        at = here + share * (goal - here)
        view.page.mouse.move(at.real, -at.imag)
        rested(view)
    view.page.mouse.up()
    rested(view)
    assert re.match(
        r"coupler and rocker can't be assembled between motor = [\d.]+ and [\d.]+ rad: B and D are", state(view)
    )
    failed = view.page.evaluate("linkwright.live.motion.failure")
    assert failed["kind"] == "group" and failed["pose"] > 0
    a = view.page.evaluate("linkwright.live.values[linkwright.live.data.program.free.indexOf('a')]")
    assert a > 1.2  # shortest and longest are longer than the two others
    view.page.get_by_role("button", name="Back to the last").click()
    rested(view)
    assert view.page.evaluate("linkwright.live.motion.failure") is None
    assert "can't be assembled" not in state(view)
    assert view.complaints == []
    view.context.close()
