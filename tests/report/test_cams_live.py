"""Cams of a live report: the page's programs give the profiles and rollers that Python draws, at any parameters."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import linkwright as lw
from helpers.cams import FOLLOWERS, GUIDES, SIGNS, closed_pair, pair
from helpers.opened import OpenedDrawing, opened, written
from linkwright.cam.cams_of_mechanism import disc, frame
from linkwright.cam.followers import NoFollower
from linkwright.compilation import compile_mechanism
from linkwright.kernels import Compiled
from linkwright.kernels.page_programs import page_programs
from linkwright.model.document import Document
from linkwright.model.named_numbers import named_numbers
from linkwright.report.build import report_data
from linkwright.report.cam_shapes import cam_shapes, live_cam_shapes
from linkwright.report.outlines import LiveOutline

EXAMPLES = Path(__file__).parents[2] / "examples"
SETS = 6


def compiled_with_numbers(data: dict[str, Any]) -> Compiled:
    """With all numbers of the file as parameters, as for a page."""
    return compile_mechanism(named_numbers(Document.model_validate(data)).mechanism)


def at(one: LiveOutline, parameters: dict[str, float]) -> Any:
    """The lines of an outline (m): (lines, places, 2)."""
    p = np.array([parameters[name] for name in one.program.parameters])
    rows = [np.array(one.program.block.numbers(x, p)) for x in one.inputs]
    return np.array(rows).reshape(len(rows), -1, 2).swapaxes(0, 1)


def moved(compiled: Compiled, seed: int) -> dict[str, float]:
    """Parameters in which all that a page moves differ from the nominal ones by up to 4 %."""
    locked, rng = page_programs(compiled, []).locked, np.random.default_rng(seed)
    nominal = compiled.quantities.parameters
    return {n: v if n in locked else v * (1 + rng.uniform(-0.04, 0.04)) for n, v in nominal.items()}


@pytest.mark.parametrize("touch", FOLLOWERS)
@pytest.mark.parametrize("guide", GUIDES)
def test_profiles_are_those_of_python_at_random_parameters(guide: str, touch: str) -> None:
    for side, sense in SIGNS:
        data = pair(guide, touch, side, sense)
        compiled = compiled_with_numbers(data)
        (name,) = data["cams"]
        profile, *rollers = live_cam_shapes(compiled)
        assert profile.link == "disc" and len(rollers) == (touch == "roller")
        found = 0
        for seed in range(SETS):
            parameters = moved(compiled, seed)
            try:
                made, axes = disc(compiled, name, parameters), frame(compiled, name, parameters)
            except NoFollower:
                continue
            found += 1
            theta = profile.inputs[:, 0]
            expected = axes.placed(made.look(theta).offset(-made.follower.radius)).T
            size = np.abs(expected).max()
            assert np.abs(at(profile, parameters)[0] - expected).max() < 1e-9 * size
            assert np.ptp(np.hypot(*expected.T)) > 0.05 * size  # a cam, not a circle
        assert found > SETS / 2


def test_a_groove_has_both_flanks_and_pairs_of_discs_are_left_out() -> None:
    groove = compiled_with_numbers(pair("swinging", "roller", closed="groove"))
    assert [np.shape(at(one, groove.quantities.parameters))[0] for one in live_cam_shapes(groove)] == [2, 1]
    conjugate = compiled_with_numbers(closed_pair("swinging", "roller"))
    assert live_cam_shapes(conjugate) == []


@pytest.mark.parametrize("touch", ["roller", "face"])
def test_a_yoke_has_its_disc_and_both_rollers(touch: str) -> None:
    segments = [{"rise": 0.008, "over": 1.3, "law": "poly_4567"}, {"dwell": np.pi - 1.3}]
    segments += [{"fall": 0.008, "over": 1.3, "law": "poly_4567"}, {"dwell": np.pi - 1.3}]
    data = pair("sliding", touch, closed="yoke")
    data["laws"]["lift"]["segments"] = segments
    compiled = compiled_with_numbers(data)
    recorded, found = cam_shapes(compiled, 1.0), live_cam_shapes(compiled)
    assert [one.link for one in found] == [*recorded]
    for one in found:
        lines = at(one, compiled.quantities.parameters)
        assert np.abs(lines - np.array(recorded[one.link])).max() < 1e-12
    assert len(recorded.get("arm", ())) == (2 if touch == "roller" else 0)


@pytest.mark.parametrize("example", ["cam_linkage", "groove_cam"])
def test_they_are_what_a_report_shows(example: str) -> None:
    """At the nominal parameters: all that is recorded, in its order."""
    document = lw.load(EXAMPLES / f"{example}.yaml")
    compiled = compiled_with_numbers(document.model_dump(by_alias=True, exclude_unset=True))
    recorded = cam_shapes(compiled, 1.0)
    shown: dict[str, list[Any]] = {}
    for one in live_cam_shapes(compiled):
        shown.setdefault(one.link, []).extend(at(one, compiled.quantities.parameters))
    assert shown.keys() == recorded.keys()
    for link, lines in recorded.items():
        assert len(lines) == len(shown[link])
        for line, other in zip(lines, shown[link], strict=True):
            assert np.abs(np.array(line) - other).max() < 1e-12


@pytest.fixture
def show(browser: Any, tmp_path: Path) -> Iterator[Any]:
    yield from opened(browser, written(tmp_path), OpenedDrawing)


@pytest.mark.browser
def test_a_changed_cam_is_drawn(show: Any) -> None:
    """The page's profile and roller are those of the file with the changed numbers in Python."""
    document = lw.load(EXAMPLES / "cam_linkage.yaml")
    view = show(report_data(document, lw.run(document).outcomes))
    lines = """() => Object.fromEntries(linkwright.drawing.scene.links.filter(l => l.outlines)
      .map(l => [l.name, l.outlines]))"""
    before = view.page.evaluate(lines)
    view.change("pushing.base", 1.1)
    view.change("pushing.roller", 0.9)
    after = view.page.evaluate(lines)
    data = document.model_dump(by_alias=True, exclude_unset=True)
    data["cams"]["pushing"] |= {"base": 1.1 * 45, "roller": 0.9 * 15}  # mm
    expected = cam_shapes(compile_mechanism(Document.model_validate(data)), 1e-3)
    assert after.keys() == expected.keys() == before.keys()
    for link, shapes in expected.items():
        for line, shown, was in zip(shapes, after[link], before[link], strict=True):
            assert np.abs(np.array(line) - shown).max() < 1e-9 * np.abs(line).max()
            assert np.abs(np.array(line) - was).max() > 1
    assert view.picture.locator(".lw-original path").count() > 0
    view.page.wait_for_timeout(200)  # what the page says follows when the numbers rest
    assert "undercut" in view.page.locator(".live-line").inner_text()
    view.page.evaluate("linkwright.live.reset()")
    view.settle()
    assert view.page.evaluate(lines) == before
