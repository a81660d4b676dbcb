"""Lengths of a sketch that a page moves: their values by hand, and where each form of a file takes them."""

from __future__ import annotations

import math

import pytest

import linkwright as lw
from linkwright.model.document import Document, read_document
from linkwright.model.drawn_numbers import EntryPlace, drawn_numbers, entry_place
from linkwright.model.named_numbers import named_numbers
from linkwright.model.yaml_text import Source, read_text

SKETCH = """\
linkwright: 1
{units}{before}sketch: {{A: [0{mm}, 0{mm}], B: [0{mm}, 40{mm}], C: [305{mm}, 55{mm}], D: [305{mm}, 0{mm}],
  T: [305{mm}, 450{mm}]}}
links:
  frame: {{points: [A, D]}}
  crank: {{points: [A, B]}}
  rod: {{points: [B, C]}}
  arm: {{points: [D, C, T]}}
drives:
  motor: {{turns: crank, on: frame, speed: 45 rpm}}
measures:
  sweep: {{span: arm.angle}}
{after}"""
UNITS = "units: {length: mm, angle: deg}\n"


def text_of(before: str = "", after: str = "", declared: bool = True) -> str:
    units, mm = (UNITS, "") if declared else ("", " mm")
    return SKETCH.format(before=before, after=after, units=units, mm=mm)


FORMS = {
    "no section": (text_of(), EntryPlace(None, 0, "", "")),
    "braces": (text_of("parameters: {k: 3}\n"), EntryPlace(3, 13, "", "")),
    "braces over lines": (text_of("parameters: { k: 3,\n  l: 4 }   # more\n"), EntryPlace(3, 14, "", "")),
    "block": (text_of("parameters:\n  k: 3\n"), EntryPlace(3, 0, "  ", "")),
    "block with remarks": (text_of("parameters:   # k\n\n    # of k\n    k: 3\n"), EntryPlace(3, 0, "    ", "")),
    "at the end": (text_of(after="parameters:\n  k: {value: 3, tolerance: 0.1}"), EntryPlace(14, 0, "  ", "")),
    "units with numbers": (text_of(declared=False), EntryPlace(None, 0, "", " m")),
    "CRLF": (text_of("parameters:\n  k: 3\n").replace("\n", "\r\n"), EntryPlace(3, 0, "  ", "")),
}
"""Files, and where each of them takes a parameter."""


def document(text: str) -> Document:
    read, source = read_document(text.encode())
    assert read is not None, source.findings
    return read


def found(text: str) -> tuple[Source, list[tuple[str, float, bool]], EntryPlace | None]:
    source, named = read_text(text.encode()), named_numbers(document(text))
    numbers = [(one.name, one.value, one.is_length) for one in drawn_numbers(named)]
    return source, numbers, entry_place(named, source)


@pytest.mark.parametrize("form", FORMS)
def test_each_form_of_a_file_takes_a_length(form: str) -> None:
    """With the entry written as the page writes it, the file reads back with this parameter alone more, and its length
    is that."""
    text, expected = FORMS[form]
    source, _, place = found(text)
    assert place == expected
    entry = "AB: 0.044 m" if place.unit else "AB: 44"
    lines = text.splitlines()
    if place.line is None:
        lines.append(f"parameters: {{{entry}}}")
    elif place.indent:
        lines.insert(place.line, place.indent + entry)
    else:
        line = lines[place.line - 1]
        lines[place.line - 1] = f"{line[: place.column]}{entry}, {line[place.column :]}"
    other = "\n".join(lines)
    read = read_text(other.encode()).data
    assert read["parameters"].keys() - source.data.get("parameters", {}).keys() == {"AB"}
    assert {**read, "parameters": {}} == {**source.data, "parameters": {}}
    assert [f for f in lw.check(document(other)) if f.severity == "error"] == []
    assert document(other).parameters["AB"].value.text == entry.removeprefix("AB: ")


def test_lengths_and_coordinates_by_hand() -> None:
    """Lengths of links first; a third point of a link has its coordinates in the link's axes."""
    _, numbers, _ = found(text_of())
    expected = [("AB", 0.04, True), ("BC", math.hypot(0.305, 0.015), True), ("DC", 0.055, True)]
    expected += [("arm_T_x", 0.45, False), ("arm_T_y", 0.0, False)]
    assert [(name, is_length) for name, _, is_length in numbers] == [
        (name, is_length) for name, _, is_length in expected
    ]
    assert [value for _, value, _ in numbers] == pytest.approx([value for _, value, _ in expected], abs=1e-15)


def test_a_stated_length_is_no_longer_one_of_the_sketch() -> None:
    _, numbers, _ = found(text_of("parameters: {AB: 38}\n"))
    assert "AB" not in [name for name, _, _ in numbers] and "BC" in [name for name, _, _ in numbers]


@pytest.mark.parametrize("text", ['{"linkwright": 1}', "parameters:\nlinkwright: 1\n", "? parameters\n: {k: 3}\n"])
def test_a_text_without_a_plain_place_has_none(text: str) -> None:
    named = named_numbers(document(text_of()))
    assert entry_place(named, read_text(text.encode())) is None
    assert entry_place(named, Source()) is None
