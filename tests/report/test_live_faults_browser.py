"""Numbers that the model's own checks refuse: the page refuses them with the same words, in both languages."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import linkwright as lw
from helpers.examples import heavy_four_bar
from linkwright.findings import ModelError
from linkwright.model.document import dump, load
from linkwright.report.build import report_data
from linkwright.report.page import page
from linkwright.words import in_language
from report.test_live_browser import rested, state
from report.test_report_browser import Opened

pytestmark = pytest.mark.browser
pytest.importorskip("playwright.sync_api")


def gas_spring(**other: Any) -> dict[str, Any]:
    """A four-bar with a gas spring."""
    data: dict[str, Any] = heavy_four_bar(studies={"cycle": {"turns": "1 motor", "samples": 36}})
    data["links"]["frame"]["points"]["S"] = [1, -2]
    spring = {"from": "S", "to": "C", "in": ["frame", "rocker"], "gas": 300, "progression": 1.3, "length": [1, 9]}
    data["springs"] = {"gas": spring | other}
    return data


@pytest.mark.parametrize(
    ("label", "value", "other"),
    [
        ("gas.progression", "0.9", {"progression": 0.9}),
        ("gas.gas", "-300", {"gas": -300}),
        ("gas.length.0", "9.5", {"length": [9.5, 9]}),
    ],
)
@pytest.mark.parametrize("language", ["en", "zh"])
def test_it_says_what_the_command_line_says(
    browser: Any, tmp_path: Path, label: str, value: str, other: dict[str, Any], language: str
) -> None:
    file = tmp_path / "model.yaml"
    file.write_text(dump(lw.Document.model_validate(gas_spring())), encoding="utf-8")
    with in_language(language):
        with pytest.raises(ModelError) as refused:
            lw.run(lw.Document.model_validate(gas_spring(**other)))
        (finding, *_) = refused.value.findings
        path = tmp_path / "report.html"
        path.write_text(
            page(report_data(load(file), lw.run(file).outcomes, text=file.read_text(encoding="utf-8"))),
            encoding="utf-8",
        )
        said, colon = finding.what, ": " if language == "en" else "："
    view = Opened(browser, path)
    summary = view.page.locator("#numbers details:not([open]) summary")
    if summary.count():
        summary.click()
    entry = view.page.get_by_label(label, exact=True).and_(view.page.locator("[type=text]"))
    entry.fill(value)
    entry.press("Enter")
    rested(view)
    plain = state(view).replace("−", "-")
    assert plain.startswith(finding.element + colon)
    if finding.code == "value.not-rising":
        assert "9.5 m" in plain and "9 m" in plain
    else:
        assert plain == f"{finding.element}{colon}{said}"
    assert view.page.evaluate("linkwright.live.motion.failure.kind") == "number"
    # The last picture stays: nothing of it is said to be open.
    assert view.page.locator(".lw-gaps i").count() == 0
    assert view.page.locator(".lw-opening").filter(visible=True).count() == 0
    assert view.pin("C")
    entry.fill("1.3" if label == "gas.progression" else "300" if label == "gas.gas" else "1")
    entry.press("Enter")
    rested(view)
    assert view.page.evaluate("linkwright.live.motion.failure") is None
    assert view.complaints == []
    view.context.close()
