"""Pictures as one file: a row for each stack, each picture below its title."""

from __future__ import annotations

from xml.etree import ElementTree

from linkwright.drawing.tiled import tiled
from linkwright.presentation.blocks import Chart

SVG = '<svg xmlns="http://www.w3.org/2000/svg" class="lw still workspace" viewBox="0 0 560 {high}"></svg>'


def chart(stack: str, *step: int, high: int = 100) -> Chart:
    return Chart(f"{stack} <{step}>", lambda: SVG.format(high=high), stack, step)


def test_a_file_has_a_row_for_each_stack() -> None:
    text = tiled([chart("one", k, high=100 + k) for k in range(5)] + [chart("two", 0, high=40)])
    root = ElementTree.fromstring(text)
    space = "{http://www.w3.org/2000/svg}"
    places = [(float(one.get("x", "")), float(one.get("y", ""))) for one in root.findall(f"{space}svg")]
    assert [x for x, _ in places] == [0, 560, 1120, 1680, 0, 0]
    (head,) = {y for _, y in places[:4]}
    assert [y for _, y in places[4:]] == [head + 103 + head, 2 * (head + 103) + 1 + head]
    assert root.get("width") == "2240" and float(root.get("height", "")) == places[-1][1] + 40
    titles = [one.text for one in root.findall(f"{space}text")]
    assert titles == [*(f"one <({k},)>" for k in range(5)), "two <(0,)>"]
