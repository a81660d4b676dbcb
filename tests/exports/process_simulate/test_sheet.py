"""The sheet: which text goes where, and what a reader of the drawing sees."""

from __future__ import annotations

import html
import re
from collections.abc import Iterator
from itertools import combinations
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from helpers.browsers import chromium
from linkwright.compilation import compile_mechanism
from linkwright.exports.process_simulate.facts import Facts, facts
from linkwright.exports.process_simulate.functions import JointFunctions, make
from linkwright.exports.process_simulate.options import ProcessSimulateOptions
from linkwright.exports.process_simulate.sheet import sheet
from linkwright.exports.process_simulate.sheet_drawing import anchors
from linkwright.kernels import Compiled
from linkwright.model.document import load

EXAMPLES = Path(__file__).parents[3] / "examples"
HINGE: dict[str, Any] = {"range": [-211.44, -141.44], "names": {"A": "j2", "B": "j3", "C": "j4", "D": "j1"}}
OUTLINE = [f"P{i}" for i in range(1, 9)]
PIN = re.compile(r'<circle class="pin" cx="(.*?)" cy="(.*?)"|<path class="pin" transform="translate\((\S+) (\S+)\)')
NAME = re.compile(r'<rect x="(.*?)" y="(.*?)" width="(.*?)" height="(.*?)" rx="3"/><text.*?>(.*?)</text>')


def made(name: str, options: dict[str, Any], told: dict[str, Any]) -> tuple[Compiled, JointFunctions, str]:
    compiled = compile_mechanism(load(EXAMPLES / f"{name}.yaml"), EXAMPLES)
    functions = make(compiled, ProcessSimulateOptions(**options).wish(compiled))
    found = facts(compiled, Facts(**told), *functions.range, functions.zero)
    return compiled, functions, sheet(compiled, functions, found)


@pytest.fixture(scope="module")
def hinge() -> tuple[Compiled, JointFunctions, str]:
    return made("bonnet_hinge", HINGE, {"handle": "H", "outline": OUTLINE})


@pytest.fixture(scope="module")
def feeder() -> tuple[Compiled, JointFunctions, str]:
    return made("paper_feeder", {"longest": 150}, {})


def pasted(page: str) -> list[str]:
    return [html.unescape(text) for text in re.findall(r"<code>(.*?)</code>", page)]


def test_every_text_stands_on_the_sheet_as_it_is(hinge: Any, feeder: Any) -> None:
    for _, functions, page in (hinge, feeder):
        assert pasted(page) == [function.text for function in functions.functions]
        cells = re.findall(r'<td class="name-cell">([^<]*)', page)
        assert cells == [function.name for function in (functions.driving, *functions.functions)]
        assert "http" not in page.replace("http-equiv", "")


def test_each_name_is_nearest_to_its_own_joint(hinge: Any, feeder: Any) -> None:
    """And no two names cover each other."""
    for compiled, functions, page in (hinge, feeder):
        pins = [complex(*(float(part) for part in found if part)) for found in PIN.findall(page)]
        at = dict(zip(anchors(compiled), pins, strict=True))
        told = {f.name: f.joint for f in (functions.driving, *functions.functions) if not f.helper}
        boxes = {}
        for left, top, wide, high, name in NAME.findall(page):
            x, y, w, h = (float(part) for part in (left, top, wide, high))
            boxes[name] = (complex(x + w / 2, y + h / 2), w / 2, h / 2)
        assert boxes.keys() == told.keys()
        for name, (middle, w, h) in boxes.items():

            def off(place: complex, middle: complex = middle, w: float = w, h: float = h) -> float:
                gap = place - middle
                return float(np.hypot(max(abs(gap.real) - w, 0.0), max(abs(gap.imag) - h, 0.0)))

            nearest = min(map(off, pins))
            assert off(at[told[name]]) == pytest.approx(nearest, abs=0.1)
        for (a, wa, ha), (b, wb, hb) in combinations(boxes.values(), 2):
            assert abs((a - b).real) >= wa + wb or abs((a - b).imag) >= ha + hb


def test_joints_lie_as_in_the_vehicle(hinge: Any) -> None:
    """The drawing is the sketch to scale, front to the left, and the table has the axes' places."""
    compiled, _, page = hinge
    pins = np.array([complex(float(x), -float(y)) for x, y, *_ in PIN.findall(page)])
    sketch = load(EXAMPLES / "bonnet_hinge.yaml").sketch
    places = np.array(
        [complex(*(float(p.text) for p in (sketch[n].parts[0], sketch[n].parts[2]))) for n in anchors(compiled)]
    )
    (scale, _), rest, *_ = np.linalg.lstsq(np.stack([places, np.ones_like(places)], axis=1), pins, rcond=None)
    assert np.sqrt(rest[0].real / 4) < 0.1
    assert abs(scale.imag) < 1e-3 < scale.real
    assert 'data-head="At the zero pose, mm">500, 640, 860</td>' in page
    assert "(0, −1, 0)" in page


def test_links_are_numbered_in_the_file_s_order(hinge: Any) -> None:
    page = hinge[2]
    numbers = re.findall(r"<title>(\w+)</title><circle.*?/><text.*?>(\d)</text>", page)
    assert [name for name, _ in sorted(numbers, key=lambda pair: pair[1])] == [
        "frame",
        "front_strut",
        "panel",
        "rear_strut",
    ]
    assert "4 rear_strut" in page


def test_names_of_a_file_can_t_break_the_page() -> None:
    compiled = compile_mechanism(
        load(EXAMPLES / "four_bar.yaml").model_copy(update={"name": "<script>alert(1)</script>"})
    )
    functions = make(compiled, ProcessSimulateOptions().wish(compiled))
    page = sheet(compiled, functions, facts(compiled, Facts(samples=20), *functions.range, functions.zero))
    assert "<script>alert" not in page
    assert page.count("<script>") == 2  # its own, and the choice of languages


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    yield from chromium()


@pytest.mark.browser
def test_the_sheet_prints_on_one_page_and_copies(browser: Any, hinge: Any, tmp_path: Path) -> None:
    """Dark and light, on a telephone too, without a word in the console."""
    page_file = tmp_path / "sheet.html"
    page_file.write_text(hinge[2], encoding="utf-8")
    said: list[str] = []
    context = browser.new_context(viewport={"width": 390, "height": 800}, color_scheme="dark")
    context.set_offline(True)
    page = context.new_page()
    page.on("console", lambda message: said.append(message.text))
    page.on("pageerror", lambda error: said.append(str(error)))
    page.goto(page_file.as_uri())
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")
    heads = page.locator("tr.first td:not(:first-child)").evaluate_all(
        "cells => cells.map(cell => getComputedStyle(cell, '::before').content)"
    )
    assert heads[:4] == [f'"{text}"' for text in re.findall("<th>(.*?)</th>", hinge[2])[1:]]
    ground, ink = page.evaluate("(s => [s.backgroundColor, s.color])(getComputedStyle(document.body))")
    assert [sum(map(int, re.findall(r"\d+", colour))) < 380 for colour in (ground, ink)] == [True, False]
    button = page.get_by_role("button", name="Copy").first
    button.click()
    page.get_by_role("button", name="Copied").wait_for(timeout=5000)
    printed = page.pdf(prefer_css_page_size=True)
    assert len(re.findall(rb"/Type\s*/Page\b(?!s)", printed)) == 1
    assert said == []
    context.close()


@pytest.mark.parametrize("flipped", [[], ["A"]])
def test_facts_count_as_the_table_of_joints_does(flipped: list[str]) -> None:
    """Where the transmission angle is least, and the axis of the opening: values of the driving joint within its
    limits, in either sense; and each point of the picture of the panel's way has its name."""
    compiled, functions, page = made("bonnet_hinge", HINGE | {"flipped": flipped}, {"outline": OUTLINE})
    low, high = (np.degrees(limit) for limit in functions.driving.limits)
    (least,) = set(re.findall(r"at j2 = ([−\d.]+)\xa0deg", page))
    assert low - 1e-3 <= float(least.replace("−", "-")) <= high + 1e-3
    assert "j2, deg" in page and "motor" not in page.split('id="facts"')[1]
    named = re.findall(r'<text class="point"[^>]*>(.*?)</text>', page)
    assert sorted(named) == sorted(set(anchors(compiled).values()))
    assert page.count('<circle class="pivot"') == len(named)
