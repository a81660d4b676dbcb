"""Blocks as HTML: what each kind becomes, texts escaped once, nothing of what is empty."""

from __future__ import annotations

import re
from xml.etree import ElementTree

import numpy as np
import pytest

from linkwright.findings import Said
from linkwright.presentation.blocks import (
    Block,
    Bullets,
    Card,
    Cards,
    Chart,
    Charts,
    Check,
    Checks,
    Copied,
    Measure,
    Measures,
    MeasureValue,
    Section,
    Sentences,
    Slider,
    Table,
)
from linkwright.presentation.cells import NumberCell
from linkwright.presentation.charts import Axis, Graph
from linkwright.report.html_blocks import html, of_file, section
from linkwright.report.prose import prose

HOSTILE = "<img src=x>&\"'"
SVG = "<svg/>"
HOSTILES: list[tuple[Block, int]] = [
    (Sentences([HOSTILE]), 1),
    (Bullets([HOSTILE]), 1),
    (Table("one", HOSTILE, [HOSTILE], [[HOSTILE], [NumberCell(None, unknown=HOSTILE)]]), 6),  # heads stand by cells too
    (Charts([Chart(HOSTILE, lambda: SVG)]), 1),
    (Charts([Chart("", lambda: SVG, HOSTILE, (0,))], [Slider(HOSTILE, [HOSTILE, "2 mm"], 0)]), 4),
    (Charts([Chart(HOSTILE, shown=lambda: Graph(Axis(""), np.zeros(1), Axis("", HOSTILE), []))]), 2),
    (Copied(HOSTILE, HOSTILE), 2),
    (Cards("assembly", ("", "", ""), [Card(HOSTILE, HOSTILE, lambda: SVG, [HOSTILE], "")]), 3),
    (Cards("assembly", ("", "", ""), [Card("", "", lambda: SVG, [], HOSTILE)]), 1),
    (Measures([Measure(HOSTILE, HOSTILE, [MeasureValue(HOSTILE, 1.0, "", HOSTILE, HOSTILE)], "", HOSTILE, True)]), 6),
    (Measures([Measure("", "", [MeasureValue(text=HOSTILE)], HOSTILE, None, None)]), 2),
    (Checks([Check(HOSTILE, HOSTILE, HOSTILE, ok=True)], [HOSTILE]), 4),
]


@pytest.mark.parametrize(("block", "least"), HOSTILES, ids=lambda given: type(given).__name__)
def test_texts_are_escaped_once(block: Block, least: int) -> None:
    """Read back, they are what they were: as texts of elements, or as attributes."""
    root = ElementTree.fromstring(f"<div>{html(block).replace(' hidden', '')}</div>")
    assert not [*root.iter("img")]
    attributes = [value for element in root.iter() for value in element.attrib.values()]
    assert sum(text.count(HOSTILE) for text in [*root.itertext(), *attributes]) >= least
    assert not any("&lt;" in text or "&amp;" in text for text in [*root.itertext(), *attributes])


def test_every_kind_of_block_is_tried() -> None:
    assert {type(block) for block, _ in HOSTILES} == {*Block.__args__}


def test_a_section_has_its_heading_and_what_is_filled() -> None:
    blocks = [Sentences([]), Sentences(["One."]), Table("one", "Title", ["a"], []), Bullets(["two"])]
    text = section(Section("limits", blocks))
    heading = str(Said("report.limits"))
    assert text == f'<section id="limits"><h2>{heading}</h2>{of_file()}<p>One.</p><ul><li>two</li></ul></section>'
    assert section(Section("limits", [Sentences([]), Table("one", "Title", ["a"], [])])) == ""


def test_details_and_notes_stand_on_the_page() -> None:
    assert (
        html(Sentences(["One.", "Two."], note=True, detail=True)) == '<p class="note">One.</p><p class="note">Two.</p>'
    )


def test_cells_bear_their_heads_and_lines() -> None:
    table = html(Table("one", "Title", ["a", "b"], [["x\ny", NumberCell(2.5, unit="mm")]]))
    assert '<td data-head="a">x<br>y</td><td data-head="b">2.5\u00a0mm</td>' in table
    assert "<h3>Title</h3>" in table and 'class="limits"' in table
    wide = Table("one", "Title", [str(i) for i in range(8)], [[*"0123456", "7 mm"]])
    assert 'class="limits wide"' in html(wide) and ">7 mm<" in html(wide)


def test_no_line_begins_with_a_unit() -> None:
    """Figures stay with their units and percent signs; other words may begin a line."""
    for text in ("从 10.8 N 至 -0.3 N·m 之间", "0.001 deg/deg²；0.5 1/mm", "l2 22 %、l1 17 %", "is 99.73 %."):
        shown = prose(text)
        assert shown.replace("\u00a0", " ") == text
        assert not re.search(r"\d (?:N|deg|1/mm|%)", shown), shown
    assert prose("9 个位姿, 5 contributors <b>, 3 mm_long") == "9 个位姿, 5 contributors &lt;b&gt;, 3 mm_long"


def test_what_one_can_do_with_a_picture_isn_t_printed() -> None:
    text = html(Charts([Chart("A < B", lambda: SVG, hint="click")]))
    assert f'<figcaption>A &lt; B<span class="note screen">click</span></figcaption>{SVG}' in text


def test_a_card_has_lines_for_the_file_or_says_that_there_are_none() -> None:
    with_lines = Card("First", "own", lambda: SVG, ["B: left of A-C"], "can't be told")
    text = html(Cards("assembly", ("", "", ""), [with_lines, Card("Second", "", lambda: SVG, [], "unknown")]))
    assert text.count(SVG) == 2
    assert "<pre>assembly:\n  B: left of A-C</pre>" in text and "<pre>unknown</pre>" in text


def test_what_verifies_is_one_line_until_it_is_opened() -> None:
    """Where a check fails it is open; a section that is nothing else has this line as its heading."""
    good, bad = Check("closure", "1e-16", "", ok=True), Check("power", "1e-3", "", ok=False)
    text = section(Section("certificate", [Checks([good, good])]))
    assert text.startswith(f'<section id="certificate">{of_file()}<details><summary><h2><span class="mark ok">')
    assert "Verification: 2 of 2 checks passed</span></h2></summary><table" in text
    assert text.count("Verification") == 1
    assert "<details open><summary><h2>" in section(Section("certificate", [Checks([good, bad])]))
    mixed = section(Section("certificate", [Sentences(["One."]), Checks([good])]))
    assert mixed.count("<h2>") == 1 and "<summary><span>" in mixed


def measure(at: str = "", requirement: str | None = None, verdict: bool | None = None) -> Measure:
    return Measure("stroke", "span of E.x", [MeasureValue(value=1.0, at=at)], "mm", requirement, verdict)


@pytest.mark.parametrize(
    ("measures", "heads"),
    [
        ([measure()], ["Measure", "Value"]),
        ([measure("t = 1 s"), measure()], ["Measure", "Value", "Where"]),
        ([measure(), measure("", ">= 1 mm", True)], ["Measure", "Value", "Requirement", "Result"]),
        ([measure("", ">= 1 mm")], ["Measure", "Value", "Requirement"]),
        ([measure("t = 1 s", ">= 1 mm", False)], ["Measure", "Value", "Where", "Requirement", "Result"]),
    ],
)
def test_measures_have_no_empty_columns(measures: list[Measure], heads: list[str]) -> None:
    text = html(Measures(measures))
    assert re.findall(r'<th scope="col">(.*?)</th>', text) == heads
    assert re.findall(r'data-head="(.*?)"', text) == heads * len(measures)
    assert all(len(re.findall("<td", row)) == len(heads) for row in text.split("<tr>")[2:])


def test_measures_read_without_colour() -> None:
    values = [MeasureValue("min", -41.23456, grade="sampled"), MeasureValue("max", None, grade="sampled")]
    text = html(Measures([Measure("force", "", values, "N*m", "<= 90 N", False), Measure("x", "", [], "", None, None)]))
    assert "−41.2346" in text and "<b>–</b>" in text and "✗</span> failed" in text and "N·m" in text
    assert text.count("sampled") == 1  # what is the same of both ends is said once
