"""Blocks: numbers as they are shown, texts that become words only where they are, what is filled."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

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
    Section,
    Sentences,
    Slider,
    Table,
    filled,
)
from linkwright.presentation.cells import NumberCell, Verdict
from linkwright.words import catalogue


def never() -> str:
    raise AssertionError("drawn, though nobody looks")


FILLED: list[Block] = [
    Sentences(["one"]),
    Bullets(["one"]),
    Table("", "", ["a"], [["1"]]),
    Charts([Chart("one", never)]),
    Copied("copy", "1\t2\n"),
    Cards("assembly", ("a", "b", "c"), [Card("one", "", never, [], "-")]),
    Measures([Measure("one", "", [], "mm", None, None)]),
    Checks([Check("closure", "1e-16", "It closes.", ok=True)]),
]
EMPTY: list[Block] = [
    Sentences([], note=True, detail=True),
    Bullets([]),
    Table("name", "title", ["a", "b"], []),
    Charts([], [Slider("l", ["1 mm", "2 mm"], 0)]),
    Copied("", ""),
    Cards("assembly", ("a", "b", "c"), []),
    Measures([]),
    Checks([], ["No forces."]),
]


@pytest.fixture
def made_up() -> Iterator[dict[str, str]]:
    """The catalogue, in which a test may change texts."""
    words, before = catalogue(), dict(catalogue())
    yield words
    words.clear()
    words.update(before)


@pytest.mark.parametrize(
    ("number", "text"),
    [
        (NumberCell(680.27771234), "680.2777"),
        (NumberCell(680.27771234, 3), "680"),
        (NumberCell(680.27771234, 9, "mm"), "680.277712 mm"),
        (NumberCell(-0.0625, unit="kN"), "-0.0625 kN"),
        (NumberCell(0.0, unit="mm"), "0 mm"),
        (NumberCell(1.26e-15, 1, form="e"), "1.3e-15"),
        (NumberCell(12.5, 2, form="f"), "12.50"),
        (NumberCell(None), "–"),
        (NumberCell(None, unit="mm"), "–"),
        (NumberCell(None, unknown=Said("limits.without_limit")), "unlimited"),
    ],
)
def test_numbers(number: NumberCell, text: str) -> None:
    assert str(number) == f"{number}" == text


def test_a_verdict_is_its_word() -> None:
    assert str(Verdict(True, Said("cam.kept"))) == catalogue()["cam.kept"]
    assert str(Verdict(False, "no")) == "no"


def test_a_text_is_worded_where_it_is_shown(made_up: dict[str, str]) -> None:
    said = Said("made.up", name="crank", count=3)
    joined = Joined([said, "and", Said("made.up", name="rod", count=4)], " ")
    table = Table("one", said, [said], [[joined]])
    assert repr(said) == "Said('made.up')"
    with pytest.raises(KeyError):
        str(said)
    made_up["made.up"] = "{count} of {name}"
    assert str(said) == "3 of crank" and f"{said:>12}" == "  3 of crank"
    assert str(table.rows[0][0]) == "3 of crank and 4 of rod"
    made_up["made.up"] = "{name}: {count}"
    assert [str(table.title), *map(str, table.heads)] == ["crank: 3"] * 2
    assert str(joined) == "crank: 3 and rod: 4"


def test_a_text_within_another_is_worded_with_it(made_up: dict[str, str]) -> None:
    made_up |= {"made.outer": "({inner})", "made.inner": "{name}"}
    outer = Said("made.outer", inner=Said("made.inner", name="a\nb"))
    assert str(outer) == "(a b)"  # what is quoted stands in one line
    assert str(Said("made.outer", inner=Joined(map(str, range(3))))) == "(0, 1, 2)"


def test_texts_are_values() -> None:
    assert Said("made.up", name="a") == Said("made.up", name="a") != Said("made.up", name="b")
    assert len({Said("made.up", name="a"), Said("made.up", name="a"), Said("made.other", name="a")}) == 2
    assert Joined(["a", "b"]) == Joined(iter(["a", "b"])) != Joined(["a", "b"], " ")
    assert Said("made.up") != "made.up"


def test_a_chart_is_drawn_once_and_only_when_it_is_looked_at() -> None:
    drawn: list[int] = []

    def draw() -> str:
        drawn.append(1)
        return "<svg/>"

    chart = Chart("one", draw)
    assert filled(Charts([chart])) and drawn == []
    assert chart.drawing == chart.drawing == "<svg/>" and drawn == [1]


@pytest.mark.parametrize(
    ("block", "shown"),
    [*((block, True) for block in FILLED), *((block, False) for block in EMPTY)],
    ids=lambda given: type(given).__name__,
)
def test_what_is_filled(block: Block, shown: bool) -> None:
    assert filled(block) is shown
    assert Section("limits", [block]).shown is shown


def test_every_kind_of_block_is_tried() -> None:
    kinds = {*Block.__args__}
    assert {type(block) for block in FILLED} == {type(block) for block in EMPTY} == kinds


def test_a_section_is_shown_where_one_block_is_filled() -> None:
    assert not Section("limits", []).shown and not Section("limits", EMPTY).shown
    assert Section("limits", [*EMPTY, *FILLED]).shown


def test_a_section_has_the_heading_of_its_name() -> None:
    assert str(Section("limits", []).title) == catalogue()["report.limits"]
