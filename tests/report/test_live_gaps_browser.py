"""Where a mechanism can't be assembled: the page says what the command line says of the same numbers, in all figures,
whichever dyad it is, and however it misses."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import linkwright as lw
from helpers.examples import UNITS, four_bar, slider_crank
from linkwright.model.document import dump, load
from linkwright.report.build import report_data
from linkwright.report.page import page
from linkwright.words import in_language
from report.test_live_browser import rested, state
from report.test_report_browser import Opened

pytestmark = pytest.mark.browser
pytest.importorskip("playwright.sync_api")

LATER = {"motor": {"turns": "crank", "on": "frame", "speed": 1, "start": 2.5}}
CYCLE = {"cycle": {"turns": "1 motor", "samples": 90}}


def slotted_lever(**more: Any) -> dict[str, Any]:
    """A crank AB whose pin carries a block on a lever about D, by e aside of the line through the pin D (m)."""
    data = {
        "linkwright": 1,
        "units": dict(UNITS),
        "links": {
            "frame": {"points": {"A": [0, 0], "D": [0, -3]}},
            "crank": {"points": {"A": [0, 0], "B": ["r", 0]}},
            "block": {"points": {"B": [0, 0]}},
            "lever": {"points": {"D": [0, 0], "E": [0, "e"]}},
        },
        "joints": {"slot": {"prismatic": ["lever", "block"], "line": ["E at 0", "B at 0"]}},
        "assembly": {"B": "ahead of D along slot"},
        "drives": {"motor": {"turns": "crank", "on": "frame", "speed": 1, "start": 0.5}},
    }
    return data | more


CASES = {
    "RRR, too far apart": (four_bar(b="b", parameters={"b": 3}), "b", "1.7"),
    "RRR, too near": (four_bar(c="c", parameters={"c": 3}, drives=LATER), "c", "6.4"),
    "RRP, too far apart": (slider_crank(e="e", parameters={"e": 0.5}), "e", "2.3"),
    "RPR, too near": (slotted_lever(parameters={"r": 1, "e": 0.4}), "e", "2.2"),
}


@pytest.mark.parametrize("case", CASES)
def test_the_page_says_what_the_command_line_says(browser: Any, tmp_path: Path, case: str) -> None:
    data, label, value = CASES[case]
    data |= {"studies": CYCLE}
    file = tmp_path / "model.yaml"
    file.write_text(dump(lw.Document.model_validate(data)), encoding="utf-8")
    changed = lw.Document.model_validate(data | {"parameters": data["parameters"] | {label: float(value)}})
    for language in ("en", "zh"):
        with in_language(language):
            (finding, *_) = lw.run(changed).outcomes["cycle"].failures
            assert finding.code == "motion.cannot-assemble"
            said = f"{finding.what}\n{finding.mend}"
            path = tmp_path / f"{language}.html"
            text = file.read_text(encoding="utf-8")
            path.write_text(page(report_data(load(file), lw.run(file).outcomes, text=text)), encoding="utf-8")
        view = Opened(browser, path)
        entry = view.page.get_by_label(label, exact=True).and_(view.page.locator("[type=text]"))
        entry.fill(value)
        entry.press("Enter")
        rested(view)
        assert state(view).replace("−", "-") == said.replace("−", "-")
        assert view.complaints == []
        view.context.close()
