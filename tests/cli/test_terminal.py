"""What an outcome shows on a terminal, block by block: everything as plain text, numbers set right."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from linkwright.cli import terminal
from linkwright.findings import Joined, Said
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
from linkwright.presentation.cells import NumberCell, Verdict
from linkwright.presentation.lettering import columns

HOSTILE = "[red]x[/red]\x1b[2J"
SEEN = "[red]x[/red]\\x1b[2J"
CHECKS = [
    Check("closure", "3.1e-16", "It closes.", ok=True),
    Check("conditioning", "0.031", "Near a dead centre.", ok=False),
]
Printed = Callable[..., list[str]]


def never() -> str:
    raise AssertionError("drawn, though nobody looks")


@pytest.fixture
def shown(capsys: pytest.CaptureFixture[str]) -> Printed:
    """The lines of blocks, without the blanks at their ends."""

    def printed(*blocks: Block, **how: bool) -> list[str]:
        terminal.show(Section("limits", blocks), **how)
        return [line.rstrip() for line in capsys.readouterr().out.splitlines()]

    return printed


def place(line: str, text: str) -> tuple[int, int]:
    """Where a text begins and ends in a line."""
    (start,) = (i for i in range(len(line)) if line.startswith(text, i))
    return start, start + len(text)


# Each kind of block.


def test_sentences_and_lists_are_lines(shown: Printed) -> None:
    long = "word " * 60
    assert shown(Sentences(["One.", Said("limits.full_turn")], note=True)) == ["One.", "Full rotation."]
    assert shown(Bullets(["One.", Joined(["two", "three"])])) == ["One.", "two, three"]
    assert shown(Sentences([long])) == [long.rstrip()]  # a terminal folds it itself


def test_a_table_has_its_title_heads_and_rows(shown: Printed) -> None:
    table = Table("one", "Title", ["name", "verdict"], [["a", Verdict(True, Said("cam.kept"))], ["b\nc", "-"]])
    title, head, *rows, blank = shown(table)
    assert (title, head.split(), blank) == ("Title", ["name", "verdict"], "")
    assert [row.split() for row in rows] == [["a", str(Said("cam.kept"))], ["b", "-"], ["c"]]


def test_numbers_are_set_right(shown: Printed) -> None:
    """What has its unit beside it, or a word among numbers, is set left."""
    rows = [
        ["a", NumberCell(1.5), NumberCell(2.0, unit="mm"), NumberCell(1.0)],
        ["a long name", NumberCell(-12345.678), NumberCell(30.25, unit="mm"), "none"],
        ["b", NumberCell(None), NumberCell(None, unit="mm"), NumberCell(100.0)],
    ]
    _, head, *lines, _ = shown(Table("one", "Title", ["name", "value", "at", "mixed"], rows))
    ends = {place(line, text)[1] for line, text in zip([head, *lines], ["value", "1.5", "-12345.68"], strict=False)}
    assert len(ends) == 1
    (end,) = ends
    assert lines[2][end - 1] == "–" and lines[2][end - 2] == " "
    starts = {place(line, text)[0] for line, text in zip([head, *lines], ["at", "2 mm", "30.25 mm"], strict=False)}
    assert starts == {lines[2].rindex("–")}
    assert {place(line, text)[0] for line, text in zip(lines, ["1", "none", "100"], strict=True) if text != "1"} == {
        place(head, "mixed")[0]
    }


def test_a_table_breaks_lines_between_hanzi(shown: Printed, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(terminal.wide, "_width", 30)
    text = "在全部 201 个位姿上，所有运动副均封闭。"
    rows = shown(Table("t", "T", ["a", "b"], [["[x]", text]]))[2:]
    assert [line.strip() for line in rows if line] == ["[x]  在全部 201 个位姿上，所", "有运动副均封闭。"]


def test_numbers_of_a_wide_table_stay_whole(shown: Printed, monkeypatch: pytest.MonkeyPatch) -> None:
    """In 80 columns texts fold, and the table is as low as it can be; where nothing fits it is as wide as it is."""
    heads = ["驱动", "信号", "最小", "位置", "最大", "位置", "行程", "单位", "急回系数"]
    values = (67.97569, 337.9757, 112.0243, 202.0243, 44.04863)
    cells = [NumberCell(value, unit="deg" * (i in (1, 3))) for i, value in enumerate(values)]
    row = ["给定运动", "lever.angle", *cells, "deg", NumberCell(1.648006)]
    table = Table("t", "T", heads, [row])
    monkeypatch.setattr(terminal.wide, "_width", 80)
    lines = shown(table)[1:-1]
    assert len(lines) == 3 and max(map(columns, lines)) <= 80
    for text in ("lever.angle", "337.9757", *(str(value) for value in values), "1.648006", "急回系数"):
        assert any(text in line.split() for line in lines), text
    monkeypatch.setattr(terminal.wide, "_width", 20)
    assert "".join("".join(line.split()) for line in shown(Table("t", "T", ["a"], [["x" * 30]]))[2:]) == "x" * 30


def test_cards_are_a_table_of_their_lines(shown: Printed) -> None:
    cards = [Card("First", "own", never, ["B: left of A-C", "C: left of B-D"], "none"), Card("", "", never, [], "none")]
    lines = shown(Cards("assembly", ("No.", "where", "lines"), cards))
    assert [line.split() for line in lines if line] == [
        ["No.", "where", "lines"],
        ["1", "own", "B:", "left", "of", "A-C"],
        ["C:", "left", "of", "B-D"],
        ["2", "none"],
    ]


def test_measures_have_a_line_for_each_of_their_numbers(shown: Printed) -> None:
    ends = [MeasureValue("min", -41.23456, at="t = 0.3 s", grade="certified"), MeasureValue("max", 97.5)]
    measures = [
        Measure("stroke", "span of E.x", [MeasureValue(value=680.27771)], "mm", ">= 680 mm", verdict=True),
        Measure("force", "extremes", ends, "N", "<= 90 N", verdict=False),
        Measure("far", "", [MeasureValue(text=Said("value.unbounded"))], "mm", None, None),
        Measure("none", "", [], "s", None, None),
    ]
    head, *lines, blank = shown(Measures(measures))
    assert blank == "" and head.split()[:3] == ["Measure", "Value", "Unit"]
    stroke, low, high, far, none = lines
    assert stroke.split() == ["stroke", "680.2777", "mm", ">=", "680", "mm", "passed"]
    assert "force min" in low and "t = 0.3 s" in low and "<= 90 N" in low and "FAILED" in low and "certified" in low
    assert high.split() == ["force", "max", "97.5", "N"]  # what is required stands on the first line
    assert str(Said("value.unbounded")) in far and none.split() == ["none", "-", "s"]
    numbers = zip((stroke, low, high), ("680.2777", "-41.23456", "97.5"), strict=True)
    edges = {place(line, text)[1] for line, text in numbers}
    assert len(edges) == 1


def test_checks_are_one_line_and_those_that_fail(shown: Printed) -> None:
    assert shown(Checks(CHECKS[:1], ["A remark."])) == [f"✓ {Said('cli.verified', passed=1, total=1)}", ""]
    first, *others = shown(Checks(CHECKS, ["A remark."]))
    assert first == f"✗ {Said('cli.verified', passed=1, total=2)}"
    (failed,) = [line for line in others if "✗" in line]
    assert failed.split() == ["conditioning", "0.031", "✗", "Near", "a", "dead", "centre."]
    assert not any("closure" in line or "remark" in line for line in others)


def test_all_checks_are_listed_where_details_are_asked_for(shown: Printed) -> None:
    lines = shown(Checks(CHECKS, ["A remark."]), verbose=True)
    assert ["closure" in line and "✓ It closes." in line for line in lines].count(True) == 1
    assert ["conditioning" in line and "✗ Near a dead centre." in line for line in lines].count(True) == 1
    assert "A remark." in lines
    (closure, dead) = (line for line in lines if "✓" in line or "✗" in line)
    assert place(closure, "3.1e-16")[1] == place(dead, "0.031")[1]


@pytest.mark.parametrize("verbose", [False, True])
def test_pictures_and_what_is_copied_have_nothing_here(shown: Printed, verbose: bool) -> None:
    pictures = Charts([Chart("one", never)], [Slider("l", ["1 mm", "2 mm"], 0)])
    assert shown(pictures, Copied("copy", "1\t2\n"), verbose=verbose) == []


# A section.


@pytest.mark.parametrize("verbose", [False, True])
def test_what_is_empty_is_not_shown(shown: Printed, verbose: bool) -> None:
    empty = [Sentences([]), Bullets([]), Table("", "Title", ["a"], []), Cards("s", ("a", "b", "c"), []), Measures([])]
    assert shown(*empty, Checks([]), verbose=verbose) == []


def test_details_are_shown_where_they_are_asked_for(shown: Printed) -> None:
    blocks = [
        Sentences(["Known."], detail=True),
        Table("one", "Title", ["a"], [["1"]], detail=True),
        Sentences(["Small."], note=True),
    ]
    assert shown(*blocks) == ["Small."]
    assert shown(*blocks, verbose=True) == ["Known.", "Title", "a", "1", "", "Small."]


def test_the_heading_is_for_pages(shown: Printed) -> None:
    assert str(Section("limits", []).title) not in shown(Sentences(["One."]))


# Texts of others.


@pytest.mark.parametrize(
    ("block", "count"),
    [
        (Sentences([HOSTILE]), 1),
        (Bullets([HOSTILE]), 1),
        (Table("one", HOSTILE, [HOSTILE], [[HOSTILE], [NumberCell(1.0, unit=HOSTILE)]]), 4),
        (
            Cards(
                "s", (HOSTILE, "b", "c"), [Card("", HOSTILE, never, [HOSTILE], ""), Card("", "", never, [], HOSTILE)]
            ),
            4,
        ),
        (Measures([Measure(HOSTILE, "", [MeasureValue(HOSTILE, 1.0, "", HOSTILE, HOSTILE)], "mm", HOSTILE, True)]), 5),
        (Measures([Measure("far", "", [MeasureValue(text=HOSTILE)], HOSTILE, None, None)]), 2),
        (Checks([Check(HOSTILE, HOSTILE, HOSTILE, ok=True)], [HOSTILE]), 4),
    ],
    ids=lambda given: type(given).__name__,
)
def test_texts_stay_text(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, block: Block, count: int
) -> None:
    monkeypatch.setattr(terminal, "wide", type(terminal.wide)(highlight=False, soft_wrap=True, width=400))
    monkeypatch.setattr(terminal, "out", terminal.wide)
    terminal.lines(block)
    assert capsys.readouterr().out.count(SEEN) == count


def test_a_name_between_colons_is_no_emoji(shown: Printed) -> None:
    assert shown(Sentences([":gear:"])) == [":gear:"]
    assert shown(Table("one", ":gear:", [":gear:"], [[":gear:"]])) == [":gear:"] * 3 + [""]
