"""What a page says of a file that can't be assembled, before and after it is mended there; what it marks as the file's
once numbers are changed; and what is still read on paper and on a phone."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import linkwright as lw
from helpers.examples import feeder, four_bar
from linkwright.model.document import dump, load
from linkwright.report.build import report_data
from linkwright.report.page import page
from report.test_live_browser import measure, rested, state
from report.test_report_browser import Opened

pytestmark = pytest.mark.browser
pytest.importorskip("playwright.sync_api")

CYCLE = {"turns": "1 motor", "samples": 120}


def written(folder: Path, data: dict[str, Any]) -> tuple[Path, lw.Job]:
    """The page of a model, and what it was made of."""
    file, path = folder / "model.yaml", folder / "report.html"
    file.write_text(dump(lw.Document.model_validate(data)), encoding="utf-8")
    job = lw.run(file)
    path.write_text(page(report_data(load(file), job.outcomes, text=file.read_text("utf-8"))), encoding="utf-8")
    return path, job


def put(view: Opened, label: str, value: str) -> None:
    entry = view.page.get_by_label(label, exact=True).and_(view.page.locator("[type=text]"))
    entry.fill(value)
    entry.press("Enter")
    rested(view)


def paper_feeder(crank: float, **more: Any) -> dict[str, Any]:
    """The feeder with a crank of a length (mm)."""
    data = feeder() | {"parameters": {"AB": crank}, "studies": {"cycle": CYCLE}} | more
    data["links"]["crank"]["points"]["B"] = ["AB", 0]
    data["measures"] = {"stroke": {"span": "E.x"}, "torque": {"extremes": "motor.torque"}}
    return data | {"require": {"stroke": ">= 680 mm"}}


def test_a_file_that_cannot_be_assembled_is_mended_on_its_page(browser: Any, tmp_path: Path) -> None:
    """Nothing is said against the browser; the measures, which the file's run couldn't take, come with the repair."""
    path, job = written(tmp_path, paper_feeder(225))
    (finding,) = job.outcomes["cycle"].failures
    view = Opened(browser, path)
    rested(view)
    assert state(view) == f"{finding.what}\n{finding.mend}"
    assert view.page.evaluate("linkwright.live.sound")
    problems = view.page.locator("#count-errors")
    assert problems.inner_text() == "✗ Errors: 1"
    back = view.page.get_by_role("button", name="Back to the last")
    assert back.is_hidden()  # there are none
    row = view.page.locator("#measures tbody tr", has_text="stroke")
    assert row.locator(".line.value b").all_inner_texts() == ["–"]
    assert "can't be followed" in row.locator(".grade").inner_text()
    assert row.locator(".mark").inner_text() == "✗ failed"

    put(view, "AB", "155")
    assert state(view).startswith("All joints close at every pose")
    assert problems.is_hidden() and back.is_hidden()
    _, mended = written(tmp_path, paper_feeder(155))
    (stroke, torque) = mended.outcomes["cycle"].measures
    (shown,), verdict = measure(view, "stroke")
    assert (shown, verdict) == (pytest.approx(stroke.shown(), rel=1e-5), "✓ passed")
    assert view.page.locator("#requirements").inner_text() == "✓ Requirements: 1 of 1 passed"
    lowest, highest = measure(view, "torque")[0]
    assert lowest == pytest.approx(torque.shown("min"), rel=1e-3)
    assert highest == pytest.approx(torque.shown("max"), rel=1e-3)
    assert view.page.locator(".note.was").count() == 0  # no values that others could be compared with

    put(view, "AB", "230")
    assert back.is_visible()
    back.click()
    rested(view)
    assert view.page.evaluate("linkwright.live.motion.failure") is None
    view.page.get_by_role("button", name="Reset all").click()
    rested(view)
    assert problems.is_visible() and "can't be assembled" in state(view)
    view.close()


def test_a_verdict_that_turns_moves_nothing(browser: Any, tmp_path: Path) -> None:
    """A badge that fails is as large as one that passes: the drawing stays under the pointer."""
    path, _ = written(tmp_path, paper_feeder(155))
    view = Opened(browser, path)
    top = "document.querySelector('#drawing').getBoundingClientRect().top"
    before = view.page.evaluate(top)
    put(view, "AB", "140")
    assert view.page.locator("#requirements").inner_text() == "✗ Requirements: 0 of 1 passed"
    assert view.page.evaluate(top) == before
    view.close()


def test_what_a_change_does_not_reach_is_marked(browser: Any, tmp_path: Path) -> None:
    """Every section with results but the measures, which follow."""
    studies: dict[str, Any] = {"cycle": CYCLE, "limits": {"signals": ["rocker.angle"]}}
    data = four_bar(
        b="b",
        parameters={"b": {"value": 3, "tolerance": 0.01}},
        measures={"swing": {"span": "rocker.angle"}},
        studies=studies,
    )
    studies["accuracy"] = {"outputs": ["rocker.angle"], "positions": {"middle": "1 s"}, "samples": 100, "seed": 1}
    path, job = written(tmp_path, data)
    view = Opened(browser, path)
    live = {"mechanism", "dimensions", "measures", "plots", "motion", "force", "model"}
    sections = view.page.locator("main section[id]").evaluate_all("all => all.map(each => each.id)")
    kept = [name for name in sections if name not in live]
    assert {"limits", "accuracy", "certificate", "structure"} <= {*kept}
    assert len(job.outcomes) == 3
    visible = "all => all.filter(each => each.offsetParent).map(each => each.parentElement.id)"
    assert view.page.locator(".of-file").evaluate_all(visible) == []
    put(view, "b", "3.1")
    assert sorted(view.page.locator(".of-file").evaluate_all(visible)) == sorted(kept)
    for name in kept:
        inside = view.page.locator(f"#{name} > :not(h2, .of-file)").first
        assert float(inside.evaluate("each => getComputedStyle(each).opacity")) < 1
    view.page.get_by_role("button", name="Reset all").click()
    rested(view)
    assert view.page.locator(".of-file").evaluate_all(visible) == []
    view.close()


def test_on_paper_each_plot_has_its_legend(browser: Any, tmp_path: Path) -> None:
    """Those that were never on screen, too."""
    path, _ = written(tmp_path, paper_feeder(155))
    view = Opened(browser, path, viewport={"width": 1400, "height": 500})
    named = "all => all.map(each => each.querySelector('.legend').innerText.trim() !== '')"
    figures = view.page.locator("figure.plot")
    assert not all(figures.evaluate_all(named))
    view.page.emulate_media(media="print")
    view.page.evaluate("window.dispatchEvent(new Event('beforeprint'))")
    assert all(figures.evaluate_all(named)) and figures.count() > 10
    for figure in figures.all():
        names = figure.locator(".legend").inner_text()
        assert any(part in names for part in ("x", "y", "s", "angle", "omega", "alpha", "moment", "torque", "power"))
    view.context.close()


@pytest.mark.parametrize("width", [360, 390, 600])
def test_on_a_phone_the_names_of_numbers_are_whole(browser: Any, tmp_path: Path, width: int) -> None:
    data = paper_feeder(155)
    data["links"]["frame"]["points"]["a_long_name_of_a_point"] = [10, 20]
    path, _ = written(tmp_path, data)
    view = Opened(browser, path, viewport={"width": width, "height": 800})
    view.page.evaluate("document.querySelectorAll('#numbers details').forEach(each => each.open = true)")
    labels = view.page.locator(".dimension label")
    assert labels.count() > 10
    assert "a_long_name_of_a_point" in "".join(labels.all_inner_texts())
    cut = "all => all.filter(each => each.scrollWidth > each.clientWidth + 1).map(each => each.textContent)"
    assert labels.evaluate_all(cut) == []
    # A name stands in full width, and its slider has room to be moved.
    assert min(labels.evaluate_all("all => all.map(each => each.getBoundingClientRect().width)")) > 0.5 * width
    sliders = view.page.locator(".dimension [type=range]")
    assert min(sliders.evaluate_all("all => all.map(each => each.getBoundingClientRect().width)")) > 60
    assert view.page.evaluate("document.documentElement.scrollWidth") == width
    view.close()
