"""The text of a model file: what YAML makes of it, what is refused, and the lines of what is found."""

from __future__ import annotations

import time

import pytest

from linkwright.findings import Finding
from linkwright.model import yaml_text
from linkwright.model.document import read_document
from linkwright.model.yaml_text import MAX_BYTES, read_text
from model.given import changed, codes, findings


def data(text: str) -> object:
    source = read_text(text.encode())
    assert not source.findings
    return source.data


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("155", 155),
        ("-155", -155),
        ("1e3", 1000.0),
        (".5", 0.5),
        ("5.", 5.0),
        ("1.5E-2", 0.015),
        ("123456789012345678901234567890", 123456789012345678901234567890.0),
        ("007", 7),
        ("true", True),
        ("false", False),
        ("null", None),
        ("~", None),
        ("", None),
        # YAML 1.1 would make something else of these.
        ("yes", "yes"),
        ("on", "on"),
        ("off", "off"),
        ("1_000", "1_000"),
        ("0x10", "0x10"),
        ("0o7", "0o7"),
        ("1:30", "1:30"),
        ("2001-01-01", "2001-01-01"),
        ("nan", "nan"),
        ("'155'", "155"),
        ('"1e3"', "1e3"),
        ("'true'", "true"),
        ("'曲柄'", "曲柄"),
    ],
)
def test_scalars(text: str, value: object) -> None:
    assert data(f"a: {text}\n") == {"a": value}


def test_keys_are_names_whatever_yaml_thinks_of_them() -> None:
    assert data("on: 1\nyes: 2\n3: 4\nnull: 5\n") == {"on": 1, "yes": 2, "3": 4, "null": 5}


def test_a_byte_order_mark_and_windows_lines() -> None:
    assert data("\ufefflinkwright: 1\r\na: [1,\r\n  2]\r\n") == {"linkwright": 1, "a": [1, 2]}


def test_lines_of_entries() -> None:
    source = read_text(b"a: 1\nb:\n  c: [1,\n    2]\n")
    assert source.line(("b", "c")) == 3
    assert source.line(("b", "c", 1)) == 4
    assert source.line(("b", "x", "y")) == 2
    assert source.line(()) == 1


@pytest.mark.parametrize(
    ("text", "expected", "line"),
    [
        ("", "file.empty", 1),
        ("# only a comment\n", "file.empty", 1),
        ("---\n", "file.mapping", 1),
        ("- a\n- b\n", "file.mapping", 1),
        ("just text", "file.mapping", 1),
        ("a: 1\n---\nb: 2\n", "file.documents", 2),
        ("a: 1\n...\nb: 2\n", "file.documents", 3),
        ("a: 1\nb: [1, 2\n", "file.yaml", 3),
        ("a: {b: 1\n", "file.yaml", 2),
        ("a: 1\n b: 2\n", "file.yaml", 2),
        ("a: b: c\n", "file.yaml", 1),
        ("a: 'open\n", "file.yaml", 2),
        ("a: 1\nb:\n\tc: 2\n", "file.tab", 3),
        ("a: 1\nb: @c\n", "file.quote", 2),
        ("a: %c\n", "file.quote", 1),
        ("a: `c`\n", "file.quote", 1),
        ("a: >= 680 mm\n", "file.quote", 1),
        ("a: {b: >= 680 mm}\n", "file.quote", 1),
        ("a: [1, |x]\n", "file.quote", 1),
        ("a: 1\nb: *c\n", "file.alias", 2),
        ("a: &x 1\n", "file.alias", 1),
        ("a: &x {b: 1}\nc: {<<: *x}\n", "file.alias", 1),
        ("a: !!python/object:os.system 1\n", "file.tag", 1),
        ("a: !x 1\n", "file.tag", 1),
        ("a: 1\n? [b]\n: c\n", "file.key", 2),
        ("{{a}}: 1\n", "file.key", 1),
        ("a: 1\na: 2\n", "file.duplicate", 2),
        ("a: " + "[" * 40 + "]" * 40, "file.depth", 1),
        ('a: 1\nb: "\\0"\n', "file.character", 2),
        ('a: "\\ud800"\n', "file.character", 1),
        ('"\\u0007": 1\n', "file.character", 1),
        ("a: [hypot(BC, CD), 0]\n", "file.comma", 1),
        ("a: {b: force(x, y).x, c: 1}\n", "file.comma", 1),
        ("a: [step5(t, 0, 0, max(1, 2), 3), 0]\n", "file.comma", 1),
        ("%YAML 3.1\n---\na: 1\n", "file.yaml", 1),
        ("a: 1\n%b: 2\n", "file.yaml", None),
    ],
)
def test_what_is_refused(text: str, expected: str, line: int | None) -> None:
    found = findings(text)
    first = next(finding for finding in found if finding.code == expected)
    assert line is None or first.line == line


@pytest.mark.parametrize(
    "raw",
    [b"\x00\x01\x02", b"\x89PNG\r\n\x1a\n", b"a: \x1b[31m", b"a: \x81\x20"],
)
def test_binary_files(raw: bytes) -> None:
    assert codes(raw) == ["file.binary"]


def test_large_files_are_refused_at_once() -> None:
    start = time.perf_counter()
    assert codes(b"a: 1\n" * (MAX_BYTES // 5 + 1)) == ["file.too-large"]
    assert time.perf_counter() - start < 0.1


@pytest.mark.parametrize(
    "text",
    ["[" * 300_000, "{" * 300_000, "- " * 200_000, "? " * 200_000, "a: " + "9" * 500_000 + "x", "a: '" + " " * 500_000],
)
def test_hostile_texts_don_t_hang(text: str) -> None:
    start = time.perf_counter()
    assert codes(text)
    assert time.perf_counter() - start < 3


def test_too_many_values_are_refused() -> None:
    assert codes("a: [" + "1," * 150_000 + "1]") == ["file.too-many"]


@pytest.mark.parametrize("text", ["rod A-" + " " * 1990, "disc " + " x" * 900, "disc x" + " at" * 600])
def test_no_pattern_is_slow(text: str) -> None:
    start = time.perf_counter()
    assert codes(changed(("shape: rod A-B", f"shape: '{text}'")))
    assert time.perf_counter() - start < 1


def test_all_values_that_must_be_quoted_are_told_at_once() -> None:
    text = "linkwright: 1\na: @b\nc: '@ fine'\nd: [1, %e]\nf: >= 3\nnote: >\n  fine\n"
    assert [(f.code, f.line, f.data["value"]) for f in findings(text)] == [
        ("file.quote", 2, "@b"),
        ("file.quote", 4, "%e"),
        ("file.quote", 5, ">= 3"),
    ]


def test_all_tabs_are_told_at_once() -> None:
    assert [f.line for f in findings("a:\n\tb: 1\n\tc: 2\n")] == [2, 3]


def test_a_split_expression_is_put_together_again() -> None:
    """The finding names the whole expression, and nothing else is said about its parts."""
    text = changed(
        ("D: [AD, 0]", "D: [hypot(AD, 0), 0]"),
        ('"force(frame, crank).x"', "force(frame, crank).x"),
    )
    found = findings(text)
    assert [(f.code, f.data["text"]) for f in found] == [
        ("file.comma", "hypot(AD, 0)"),
        ("file.comma", "force(frame, crank).x"),
    ]
    assert found[0].element == "links.frame.points.D.0"
    assert '"hypot(AD, 0)"' in found[0].mend


def test_a_bracket_that_is_never_closed_is_a_fault_of_the_expression() -> None:
    assert codes(changed(("D: [AD, 0]", "D: [(AD, 0]"))) == ["expression.syntax"]


def test_faults_of_the_text_and_of_the_form_are_told_together() -> None:
    text = changed(("AB: 155", "AB: &x 155"), ("mass: 0.6", "mass: true"), ("DE: 500", "AB: 500"))
    assert sorted(codes(text)) == ["file.alias", "file.duplicate", "file.expected"]


def test_long_lists_and_very_many_faults_are_read_in_linear_time(monkeypatch: pytest.MonkeyPatch) -> None:
    """What a fault may mean is sought for some of them alone; brackets are counted once, and no farther than an
    expression goes."""
    calls: list[object] = []
    monkeypatch.setattr("linkwright.model.faults._finding", lambda *given: calls.append(given) or Finding("a.b"))
    read_document(b"linkwright: 1\n" + b"".join(b"key%d: 1\n" % i for i in range(700)))
    assert len(calls) == 500
    counted: list[str] = []
    opened = yaml_text._opened
    monkeypatch.setattr(yaml_text, "_opened", lambda text: counted.append(text) or opened(text))
    read_text(b"a: [(1" + b",1" * 3000 + b"]")
    assert len(counted) < 3 * 3000
