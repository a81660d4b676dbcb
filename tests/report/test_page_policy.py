"""Every kind of page in a real browser: its own scripts run, and no other."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from linkwright.compilation import compile_mechanism
from linkwright.exports.process_simulate.facts import Facts, facts
from linkwright.exports.process_simulate.functions import make
from linkwright.exports.process_simulate.options import ProcessSimulateOptions
from linkwright.exports.process_simulate.sheet import sheet
from linkwright.model.document import load
from linkwright.model.origin import Origin
from linkwright.report import ReportData, page
from linkwright.report.batch import BatchRow, batch_page

pytestmark = pytest.mark.browser

EXAMPLES = Path(__file__).parents[2] / "examples"
VIOLATIONS = """
globalThis.violations = [];
document.addEventListener("securitypolicyviolation", event => violations.push(event.effectiveDirective));
"""
OWN = "document.title = 'owned'"
INJECTED = f"""<script>{OWN}</script><script type="module">{OWN}</script><script src="data:,{OWN}"></script>
<img src="data:," onerror="{OWN}"><a id="bait" href="javascript:{OWN}">x</a>"""


def hinge_sheet() -> str:
    compiled = compile_mechanism(load(EXAMPLES / "bonnet_hinge.yaml"), EXAMPLES)
    functions = make(compiled, ProcessSimulateOptions(range=[-211.44, -141.44]).wish(compiled))
    return sheet(compiled, functions, facts(compiled, Facts(), *functions.range, functions.zero))


def batch_index() -> str:
    exported = SimpleNamespace(files=["sheet.html"], sentences=["Done."], warnings=[])
    origin = Origin("a.csv", "0" * 64, date="2026-01-01T00:00:00+00:00")
    return batch_page("a.csv", "mjcf", ["AB"], [BatchRow("one", "a.yaml", ["3"], exported)], origin)


@pytest.fixture(params=["report", "sheet", "batch"])
def text(request: Any, report: ReportData) -> str:
    """The text of a page of each kind."""
    if request.param == "report":
        return page(report)
    return hinge_sheet() if request.param == "sheet" else batch_index()


class Opened:
    """A page on screen, with what the browser said of it."""

    def __init__(self, browser: Any, path: Path, query: str = "") -> None:
        self.said: list[str] = []
        self.page = browser.new_page()
        self.page.on("console", lambda message: self.said.append(message.text))
        self.page.on("pageerror", lambda error: self.said.append(str(error)))
        self.page.add_init_script(VIOLATIONS)
        self.page.goto(path.as_uri() + query)
        self.page.evaluate("() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")

    def violations(self) -> list[str]:
        return list(self.page.evaluate("violations"))


@pytest.mark.parametrize("query", ["", "?lang=zh-CN"])
def test_own_scripts_run_without_a_word(browser: Any, text: str, tmp_path: Path, query: str) -> None:
    (tmp_path / "page.html").write_text(text, encoding="utf-8", newline="\r\n")  # a file of Windows has the same hashes
    opened = Opened(browser, tmp_path / "page.html", query)
    assert opened.violations() == opened.said == []
    assert opened.page.evaluate("document.documentElement.lang") == ("zh-CN" if query else "en")
    assert not opened.page.evaluate("document.querySelector('nav.languages').hidden")
    assert opened.page.locator("button.copy[hidden]").count() == 0
    assert opened.page.evaluate("document.querySelector('#drawing') === null || linkwright.drawing.playing")
    opened.page.close()


def test_what_gets_into_a_page_does_not_run(browser: Any, text: str, tmp_path: Path) -> None:
    """As markup in the file, and added later; nor does text become code."""
    (tmp_path / "page.html").write_text(text.replace("</body>", INJECTED + "</body>"), encoding="utf-8")
    opened = Opened(browser, tmp_path / "page.html")
    opened.page.locator("#bait").click()
    opened.page.evaluate(
        """async own => {
          document.body.append(Object.assign(document.createElement("script"), { textContent: own }));
          document.body.insertAdjacentHTML("beforeend", `<img src="data:," onerror="${own}">`);
          setTimeout(own);
          await new Promise(done => setTimeout(done, 100));
        }""",
        OWN,
    )
    assert opened.page.title() != "owned"
    assert sorted(set(opened.violations())) == ["script-src", "script-src-attr", "script-src-elem"]
    assert len(opened.violations()) >= 7
    opened.page.close()
