"""Pictures for several values of parameters, as HTML."""

from __future__ import annotations

import re
from xml.etree import ElementTree

from linkwright.presentation.blocks import Chart, Slider
from linkwright.report.stacks import stacks

SVG = '<svg xmlns="http://www.w3.org/2000/svg" class="lw still workspace" viewBox="0 0 560 100"></svg>'


def chart(stack: str, *step: int) -> Chart:
    return Chart(f"{stack} <{step}>", lambda: SVG, stack, step)


def slider(name: str, *texts: str, start: int = 0) -> Slider:
    return Slider(name, texts, start)


def test_a_stack_has_a_picture_or_a_note_for_each_combination() -> None:
    sliders = [slider("a<", "0 deg", "60 deg", "90 deg", start=1), slider("b", "1 mm", "2 mm")]
    charts = [chart("one", i, k) for i in range(3) for k in range(2) if (i, k) != (2, 0)]
    page = stacks([*charts, Chart("law", lambda: SVG)], sliders)
    root = ElementTree.fromstring(page.replace(" hidden>", ">"))
    assert page.count('class="stack"') == 1 and page.count("<figure ") == 6
    assert re.findall(r'data-step="([^"]+)"', page) == ["0 0", "0 1", "1 0", "1 1", "2 0", "2 1"]
    (note,) = root.iter("p")
    assert note.get("data-step") == "2 0" and note.text
    ranges = [one for one in root.iter("input") if one.get("type") == "range"]
    assert [(one.get("max"), one.get("value"), one.get("aria-valuetext")) for one in ranges] == [
        ("2", "1", "60 deg"),
        ("1", "0", "1 mm"),
    ]
    assert [label.get("for") for label in root.iter("label")] == [one.get("id") for one in ranges]
    assert "a&lt;" in page and "(0, 0)&gt;" in page


def test_equal_values_have_one_picture() -> None:
    page = stacks([chart("one", 0), chart("one", 0), chart("one", 1)], [slider("a", "1", "2")])
    assert page.count("<figure ") == 2


def test_without_sliders_pictures_stand_as_they_are() -> None:
    assert stacks([], [slider("a", "1", "2")]) == ""
    page = stacks([chart("one"), chart("two")], [])
    assert "stack" not in re.sub(r"one|two", "", page) and page.count("<figure ") == 2


def test_many_values_have_marks_at_the_ends_alone() -> None:
    page = stacks([chart("one", k) for k in range(30)], [slider("a", *(f"{k} mm" for k in range(30)))])
    assert re.findall(r"<span[^>]*>([^<]+)</span>", page) == ["0", "29"]
    assert page.count("data-text-") == 30
