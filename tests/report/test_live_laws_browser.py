"""The numbers of a motion law on the page: a law that isn't valid is refused by name, one that is moves the drive."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import linkwright as lw
from linkwright.model.document import load
from linkwright.report.build import report_data
from linkwright.report.page import page
from report.test_live_browser import rested, state
from report.test_report_browser import Opened

pytestmark = pytest.mark.browser
pytest.importorskip("playwright.sync_api")

FILE = Path(__file__).parents[2] / "examples/dwell_drive.yaml"


def enter(view: Opened, label: str, value: str) -> None:
    entry = view.page.get_by_label(label, exact=True).and_(view.page.locator("[type=text]"))
    entry.fill(value)
    entry.press("Enter")
    rested(view)


def test_a_rise_and_its_return(browser: Any, tmp_path: Path) -> None:
    path = tmp_path / "report.html"
    text = FILE.read_text(encoding="utf-8")
    path.write_text(page(report_data(load(FILE), lw.run(FILE).outcomes, text=text)), encoding="utf-8")
    view = Opened(browser, path)
    view.page.locator("#numbers details:not([open]) summary").click()
    enter(view, "swing.segments.0.rise", "15")
    assert state(view).startswith("laws.swing: ")
    assert "don't return to the start" in state(view)
    assert view.page.evaluate("linkwright.live.motion.failure.kind") == "number"
    enter(view, "swing.segments.2.fall", "15")
    assert view.page.evaluate("linkwright.live.motion.failure") is None
    found = np.array(view.page.evaluate("Array.from(linkwright.live.signal('lever.angle'))"))
    assert np.degrees(np.ptp(found)) == pytest.approx(15, rel=1e-9)
    times = np.array(view.page.evaluate("linkwright.live.data.times"))
    changed = text.replace("rise: 12 deg", "rise: 15 deg").replace("fall: 12 deg", "fall: 15 deg")
    other = tmp_path / "other.yaml"
    other.write_text(changed, encoding="utf-8")
    true = lw.compile(load(other)).evaluate(["lever.angle"], times)[0]
    assert np.abs(found - true).max() < 1e-9
    lines = view.page.locator(".live-lines").inner_text()
    assert "rise: 15 deg" in lines
    assert "fall: 15 deg" in lines
    assert view.complaints == []
    view.context.close()
