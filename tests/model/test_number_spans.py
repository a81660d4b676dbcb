"""Numbers are replaced in the text of a file: only their digits change, and the file is read with just these values."""

from __future__ import annotations

import math
from functools import cache
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from helpers.longer import mostly_long
from helpers.models import CHINESE, EXAMPLES, GALLERY, identity
from linkwright.model.document import Document, dump, load, read_document
from linkwright.model.named_numbers import NamedNumbers, named_numbers
from linkwright.model.number_spans import NumberRefusedError, NumberSpan, NumberSpans, number_spans

FILES = [*EXAMPLES, *GALLERY, *CHINESE]

TEXT = """linkwright: 1
units: {length: mm, angle: deg, mass: kg, time: s, force: N}
gravity: [0, -9.81 m/s^2]
parameters:
  AD: 400               # 400 is said twice
  BC: {value: 300, tolerance: 0.1}
  half: AD/2
  q: "155"
  e: 1.55e2
  f: 2.0e2 mm
  plus: +5
  round: (30 mm)
links:
  frame:
    points: {A: [0, 0], D: [AD, 0], G: '70 at -30 deg', 孔: [10,20], Q: [q, e], R: [plus, f]}   # 孔 𝕏
  crank: {points: {A: [0, 0], B: [30 cm, 0]}, mass: 0.5, shape: disc 40 mm at A}
  coupler: {points: {B: [0, 0], C: [BC, 0]}}
  rocker: {points: {D: [0, 0], C: [half, 0]}}
assembly: {C: left of B-D}
drives: {motor: {turns: crank, on: frame, speed: 60 rpm, start: -5}}
loads:
  push: {on: rocker, at: [2, "3"], force: [0, -50 N]}
"""


def read(text: str) -> Document:
    document, source = read_document(text.encode())
    assert document is not None, source.findings
    return document


def spans_of(text: str) -> tuple[NamedNumbers, NumberSpans]:
    named = named_numbers(read(text))
    return named, number_spans(named, text)


def by_path(named: NamedNumbers, spans: NumberSpans) -> dict[str, tuple[str, NumberSpan]]:
    return {".".join(map(str, span.path)): (name, span) for name, span in spans.spans.items()}


def written(path: str, value: float, resolution: float | None = None, text: str = TEXT) -> list[tuple[str, str]]:
    """The lines that change where a number gets a value (SI): before and after."""
    named, spans = spans_of(text)
    new = spans.rewritten({by_path(named, spans)[path][0]: value}, resolution)
    pairs = zip(text.split("\n"), new.split("\n"), strict=True)
    return [(old.strip(), line.strip()) for old, line in pairs if old != line]


# The table of edits.


@pytest.mark.parametrize(
    ("path", "value", "old", "new"),
    [
        (
            "parameters.AD",
            0.412,
            "AD: 400               # 400 is said twice",
            "AD: 412               # 400 is said twice",
        ),
        ("parameters.BC", 0.312, "BC: {value: 300, tolerance: 0.1}", "BC: {value: 312, tolerance: 0.1}"),
        ("parameters.q", 0.1605, 'q: "155"', 'q: "160.5"'),
        ("parameters.e", 0.16, "e: 1.55e2", "e: 1.6e2"),
        ("parameters.f", 0.3, "f: 2.0e2 mm", "f: 3.0e2 mm"),
        ("parameters.plus", 0.006, "plus: +5", "plus: +6"),
        ("parameters.plus", -0.006, "plus: +5", "plus: -6"),
        ("drives.motor.speed", math.pi, "speed: 60 rpm, start: -5", "speed: 30 rpm, start: -5"),
        ("drives.motor.start", math.radians(-7), "speed: 60 rpm, start: -5", "speed: 60 rpm, start: -7"),
        ("drives.motor.start", math.radians(7), "speed: 60 rpm, start: -5", "speed: 60 rpm, start: 7"),
        ("links.frame.points.G.radius", 0.0712, "'70 at -30 deg'", "'71.2 at -30 deg'"),
        ("links.frame.points.G.angle", math.radians(-31), "'70 at -30 deg'", "'70 at -31 deg'"),
        ("links.frame.points.A.x", -0.001, "A: [0, 0], D: [AD, 0]", "A: [-1, 0], D: [AD, 0]"),
        ("links.frame.points.D.y", 0.002, "A: [0, 0], D: [AD, 0]", "A: [0, 0], D: [AD, 2]"),
        ("links.frame.points.孔.y", 0.021, "孔: [10,20], Q", "孔: [10,21], Q"),
        ("links.crank.points.B.x", 0.312, "B: [30 cm, 0]", "B: [31.2 cm, 0]"),
        ("links.crank.shape", 0.045, "disc 40 mm at A", "disc 45 mm at A"),
        ("loads.push.at.y", 0.004, '[2, "3"]', '[2, "4"]'),
        ("loads.push.force.1", 25.0, "[0, -50 N]", "[0, 25 N]"),
        ("gravity.y", -1.62, "[0, -9.81 m/s^2]", "[0, -1.62 m/s^2]"),
    ],
)
def test_only_the_digits_change(path: str, value: float, old: str, new: str) -> None:
    ((before, after),) = written(path, value)
    assert old in before
    assert after == before.replace(old, new)


@pytest.mark.parametrize(
    ("value", "resolution", "digits"),
    [
        (0.3123456, 1e-3, "312"),
        (0.3123456, 9.9e-4, "312.3"),
        (0.3123456, 1e-4, "312.3"),
        (0.3123456, 1e-2, "310"),
        (0.3123456, 1e-6, "312.346"),
        (0.3123456, None, "312.3456"),
        (0.0001, 1e-2, "0"),
        (-0.0001, 1e-2, "0"),
        (1e-9, None, "0.000001"),
        (1e12, None, "1000000000000000"),
    ],
)
def test_the_step_that_is_written(value: float, resolution: float | None, digits: str) -> None:
    ((before, after),) = written("parameters.AD", value, resolution)
    assert after == before.replace("400", digits, 1)


def test_what_a_span_says() -> None:
    named, spans = spans_of(TEXT)
    found = by_path(named, spans)
    _, span = found["parameters.BC"]
    assert (span.digits, span.unit, span.size, span.line, span.column) == ("300", "mm", 1e-3, 6, 14)
    assert (span.text, span.quote, span.keyed) == ("  BC: {value: 300, tolerance: 0.1}", "", True)
    assert TEXT[span.start : span.end] == "300"
    _, span = found["links.frame.points.G.angle"]
    assert (span.digits, span.unit, span.quote, span.keyed) == ("-30", "deg", "'", False)
    _, span = found["loads.push.at.y"]
    assert (span.digits, span.unit, span.quote) == ("3", "mm", '"')
    _, span = found["links.crank.mass"]
    assert (span.digits, span.unit, span.size) == ("0.5", "kg", 1.0)


def test_what_is_refused() -> None:
    named, spans = spans_of(TEXT)
    assert spans.refused == {"half": "expression", "round": "form"}
    for name, reason in (("half", "expression"), ("round", "form"), ("other", "not-found")):
        with pytest.raises(NumberRefusedError) as caught:
            spans.rewritten({name: 1.0})
        assert (caught.value.name, caught.value.reason) == (name, reason)
    with pytest.raises(ValueError, match="finite"):
        spans.rewritten({"AD": math.nan})
    other = number_spans(named, TEXT.replace("AD: 400", "AD: 4000"))  # of another model
    assert other.refused["AD"] == "not-found"
    assert number_spans(named, "a: [").refused.keys() == named.quantities.parameters.keys()


def test_escapes_folds_and_units_that_nobody_declares() -> None:
    text = TEXT.replace('q: "155"', 'q: "15\\x35"').replace("'70 at", "'70\n      at")
    named, spans = spans_of(text)
    assert spans.refused["q"] == "form"
    assert {spans.refused[n] for n, number in named.numbers.items() if number.path[3:4] == ("G",)} == {"form"}
    text = TEXT.replace(", time: s, force: N}", "}")
    named, spans = spans_of(text)
    (name,) = (name for name, number in named.numbers.items() if number.path == ("gravity", "x"))
    assert spans.refused[name] == "unit"


def test_numbers_of_a_sketch_and_the_lengths_that_follow() -> None:
    path = next(path for path in EXAMPLES if path.stem == "sketched_six_bar")
    text = path.read_text("utf-8")
    named, spans = spans_of(text)
    assert spans.refused["AB"] == "derived"
    name, span = by_path(named, spans)["sketch.C.y"]
    assert read(spans.rewritten({name: 0.0785})).sketch["C"].second.raw == 78.5
    assert span.digits == "75"


def test_a_value_that_stands_several_times_in_one_text() -> None:
    """The angle is replaced, not the digit in the point's name."""
    text = TEXT.replace("disc 40 mm at A", "disc 1 at A1").replace(
        "A: [0, 0], B: [30 cm, 0]", "A: [0, 0], B: [30 cm, 0], A1: [2, 2]"
    )
    ((_, after),) = written("links.crank.shape", 0.003, text=text)
    assert "disc 3 at A1" in after


# All files.


@cache
def prepared(path: Path) -> tuple[NamedNumbers, str]:
    return named_numbers(load(path)), path.read_bytes().decode("utf-8")


@pytest.mark.parametrize("path", mostly_long(FILES, FILES[::3].__contains__), ids=identity)
def test_every_number_stands_in_its_file(path: Path) -> None:
    """In the file as it is, with line ends and the mark of Windows, and as the document would be saved."""
    named, text = prepared(path)
    assert isinstance(named.written, Document)
    for each in (text, "\ufeff" + text.replace("\n", "\r\n"), dump(named.written)):
        spans = number_spans(named, each)
        assert {*spans.refused.values()} <= {"expression", "derived", *(["shared"] if "copies:" in text else [])}
        assert spans.spans.keys() | spans.refused.keys() == named.quantities.parameters.keys()
        lines = each.removeprefix("\ufeff").split("\n")
        for name, span in spans.spans.items():
            assert span.value == named.quantities.parameters[name]
            assert span.text == lines[span.line - 1].rstrip("\r")
            assert span.text[span.column :].startswith(span.digits)
            assert each[span.start : span.end] == span.digits


NUMBERS = st.one_of(
    st.floats(-1e4, 1e4, allow_subnormal=False),
    st.integers(-10_000, 10_000).map(float),
    st.decimals(-100, 100, places=3).map(float),
)


@pytest.mark.parametrize("path", mostly_long(FILES, FILES[::3].__contains__), ids=identity)
@settings(max_examples=3, deadline=None)
@given(data=st.data())
def test_just_the_changed_values_change(path: Path, data: st.DataObject) -> None:
    """Some numbers are written into the text; read again, these have the values that were written, all others their
    own, and the text is the same everywhere else."""
    named, text = prepared(path)
    mark, ends = data.draw(st.sampled_from(["", "\ufeff"])), data.draw(st.sampled_from(["\n", "\r\n"]))
    text = mark + text.replace("\n", ends)
    spans = number_spans(named, text)
    names = data.draw(st.lists(st.sampled_from(sorted(spans.spans)), min_size=1, max_size=4, unique=True))
    changes = {name: data.draw(NUMBERS) * spans.spans[name].size for name in names}
    resolution = data.draw(st.sampled_from([None, 1e-6, 1e-3]))
    new = spans.rewritten(changes, resolution)
    # The text outside of the digits.
    kept, other, at, moved = "", "", 0, 0
    wanted = {}
    for name in sorted(names, key=lambda name: spans.spans[name].start):
        span = spans.spans[name]
        digits = span.written(changes[name], resolution)
        wanted[name] = span.read(digits)
        kept, other = kept + text[at : span.start], other + new[at + moved : span.start + moved]
        assert new[span.start + moved :].startswith(digits)
        at, moved = span.end, moved + len(digits) - len(span.digits)
    assert kept + text[at:] == other + new[at + moved :]
    # The values, read anew. Where the mechanism makes sense with them or not, the numbers are read.
    document, source = read_document(new.encode())
    assert document is not None, source.findings
    again = number_spans(NamedNumbers(document, named.mechanism, named.numbers, named.quantities), new)
    for name, span in again.spans.items():
        assert span.value == wanted.get(name, named.quantities.parameters[name])
        if resolution is None and name in wanted:
            assert abs(span.value - changes[name]) <= 2 * math.ulp(changes[name])


@settings(max_examples=200, deadline=None)
@given(
    value=NUMBERS, resolution=st.sampled_from([None, 1e-7, 2e-4, 1.0]), digits=st.sampled_from(["155", "-3.5e1", "+2"])
)
def test_digits_say_what_they_are_made_for(value: float, resolution: float | None, digits: str) -> None:
    span = NumberSpan(("a",), digits, 0, len(digits), 1, 0, digits, "deg", math.pi / 180)
    found = span.read(span.written(value, resolution))
    step = 10 ** math.floor(math.log10((resolution or 1e-300) / span.size) + 1e-9) * span.size
    assert abs(found - value) <= step / 2 * (1 + 1e-9) + 4e-16 * abs(value)
