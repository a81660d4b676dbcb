"""File to object to file: expressions, written units and order stand as they were; files are written whole."""

from __future__ import annotations

import stat
from pathlib import Path
from string import ascii_letters, digits
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from linkwright.expressions.language import text_of
from linkwright.model.document import Document, dump, load, parse_document, plain, read_document, save
from linkwright.model.output_files import write_aside
from linkwright.model.yaml_text import read_text
from linkwright.model.yaml_write import write_text
from model.given import DATA, FEEDER, four_bar

EXAMPLES = ["five_bar", "paper_feeder", "slider_crank_gas"]


def again(document: Document) -> Document:
    """The document after a way through a file's text."""
    read, source = read_document(dump(document).encode())
    assert read is not None, [str(finding) for finding in source.findings]
    return read


@pytest.mark.parametrize("name", EXAMPLES)
def test_the_examples_come_back_equal(name: str) -> None:
    document = load(DATA / f"{name}.yaml")
    assert again(document) == document
    assert dump(again(document)) == dump(document)


@pytest.mark.parametrize("name", EXAMPLES)
def test_what_is_written_stands_unchanged(name: str) -> None:
    """All of the file's data but what it says by default, down to the spelling of numbers and units."""
    data = read_text((DATA / f"{name}.yaml").read_bytes()).data
    assert plain(load(DATA / f"{name}.yaml")) == data


def test_the_text_reads_like_one_written_by_hand() -> None:
    lines = dump(load(DATA / "paper_feeder.yaml")).splitlines()
    assert lines[0] == "linkwright: 1"
    assert "parameters: {AB: 155, BC: 395, CD: 300, DE: 500, AD: 300, AH: 580}" in lines
    assert "  rocker: {points: {D: [0, 0], C: [CD, 0], E: [DE, 0]}, mass: 2, shape: rod D-E}" in lines
    assert "gravity: [0, -9.80665 m/s^2]" in lines
    sections = [line.split(":")[0] for line in lines if line[0] != " "]
    assert sections == [line.split(":")[0] for line in FEEDER.splitlines() if line[0] != " "]


def test_entries_keep_their_order() -> None:
    data = four_bar(parameters=dict.fromkeys("qzam", 1))
    assert list(plain(again(Document.model_validate(data)))["parameters"]) == list("qzam")


def test_a_document_lays_out_long_entries_in_lines() -> None:
    points = {f"P{i}": [f"a*{i} + 1 mm", "2 mm*sin(30 deg)"] for i in range(12)}
    data = four_bar(parameters={"a": 1})
    data["links"]["coupler"]["points"].update(points)
    document = Document.model_validate(data)
    assert max(map(len, dump(document).splitlines())) <= 120
    assert again(document) == document


LETTERS = f"{ascii_letters}_曲柄é"
names = (
    st.tuples(st.sampled_from(LETTERS), st.text(LETTERS + digits, max_size=8))
    .map("".join)
    .filter(lambda name: name not in ("t", "pi", "start", "end"))
)
numbers = st.one_of(
    st.integers(-(10**16), 10**16),
    st.floats(-1e12, 1e12),
    st.floats(min_value=1e-12, max_value=1e-3),
)
expressions = st.one_of(
    numbers,
    numbers.map(lambda value: f"{abs(value)!r} mm"),
    names,
    st.tuples(names, numbers).map(lambda p: f"2*({p[0]} - {p[1]!r} mm)^2/hypot({p[0]}, 3)"),
)
positions = st.one_of(
    st.lists(expressions, min_size=2, max_size=2),
    st.tuples(expressions, expressions).map(lambda p: f"{p[0]} at {p[1]}"),
)
points = st.dictionaries(names, positions, max_size=4)
texts = st.text(
    st.characters(codec="utf-8", exclude_categories=["Cs", "Cc"], exclude_characters="\ufffe\uffff")
    | st.sampled_from("\t\n\r\x85 "),
    max_size=80,
)
documents = st.fixed_dictionaries(
    {
        "linkwright": st.just(1),
        "links": st.dictionaries(names, st.fixed_dictionaries({"points": points}), min_size=1, max_size=4),
    },
    optional={
        "name": texts,
        "source": texts,
        "note": texts | st.lists(texts, min_size=2, max_size=3).map("\n".join),
        "gravity": st.lists(expressions, min_size=2, max_size=2),
        "units": st.fixed_dictionaries(
            {}, optional={"length": st.sampled_from(["mm", "in"]), "torque": st.just("N*m")}
        ),
        "parameters": st.dictionaries(
            names,
            expressions
            | st.fixed_dictionaries({"value": expressions, "tolerance": expressions, "note": texts})
            | st.fixed_dictionaries({"value": expressions, "tolerance": st.lists(expressions, min_size=2, max_size=2)}),
            max_size=5,
        ),
        "assembly": st.dictionaries(
            names,
            st.sampled_from(["left of B-D", "open", "behind B along s"])
            | st.lists(expressions, min_size=2, max_size=2),
            max_size=3,
        ),
        "tables": st.dictionaries(
            names,
            st.fixed_dictionaries({"points": st.lists(st.lists(expressions, min_size=2, max_size=2), min_size=1)}),
            max_size=2,
        ),
        "measures": st.dictionaries(names, st.fixed_dictionaries({"max": expressions}), max_size=3),
        "require": st.dictionaries(names, expressions.map(lambda e: f">= {e}"), max_size=2),
        "windows": st.dictionaries(
            names,
            st.lists(expressions, min_size=2, max_size=2)
            | st.lists(expressions, min_size=2, max_size=2).map(lambda pair: {"motor.angle": pair}),
            max_size=2,
        ),
        "studies": st.dictionaries(
            names,
            st.dictionaries(names, st.one_of(numbers, texts, st.booleans(), st.none(), st.lists(numbers, max_size=3))),
            max_size=2,
        ),
    },
)


@given(documents)
@settings(max_examples=150)
def test_any_document_comes_back_equal(data: dict[str, Any]) -> None:
    document = Document.model_validate(data)
    assert again(document) == document
    assert plain(again(document)) == plain(document)


whole = st.integers(-(10**14), 10**14)


@given(st.recursive(texts | whole | st.booleans() | st.none(), lambda s: st.lists(s) | st.dictionaries(names, s)))
@settings(max_examples=150)
def test_any_plain_data_comes_back_equal(value: Any) -> None:
    source = read_text(write_text({"a": value}).encode())
    assert not source.findings
    assert source.data == {"a": value}


def test_line_breaks_and_odd_texts_come_back() -> None:
    for note in [
        "two\nlines",
        "ends in a break\n",
        " spaces ",
        "a: b",
        "- x",
        "# y",
        "155",
        "true",
        "null",
        "~",
        "",
        "'q'",
    ]:
        document = Document.model_validate(four_bar(note=note))
        assert again(document).note == note


def test_an_expression_keeps_its_spelling() -> None:
    for raw in [155, 155.0, "155", "155 mm", "155mm", " AB+ 2 ", "1e-3 m", "2**3", ".5", 1e-7, 0.1]:
        document = Document.model_validate(four_bar(parameters={"AB": 1, "x": raw}))
        value = again(document).parameters["x"].value
        assert value.raw == raw
        assert type(value.raw) is type(raw)
        assert text_of(value.node) == text_of(document.parameters["x"].value.node)


def test_saving_writes_whole_files(tmp_path: Path) -> None:
    document = load(DATA / "paper_feeder.yaml")
    path = tmp_path / "model.yaml"
    save(document, path)
    assert load(path) == document
    assert [entry.name for entry in tmp_path.iterdir()] == ["model.yaml"]


def test_a_failed_write_leaves_the_old_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "model.yaml"
    path.write_text("old")

    def fail(self: Path, target: Path) -> None:
        raise OSError("disk full")

    monkeypatch.setattr(Path, "replace", fail)
    with pytest.raises(OSError, match="disk full"):
        write_aside(path, "new")
    monkeypatch.undo()
    assert path.read_text() == "old"
    assert [entry.name for entry in tmp_path.iterdir()] == ["model.yaml"]


def test_writing_keeps_permissions_and_replaces_links_but_of_a_model_file(tmp_path: Path) -> None:
    path, link = tmp_path / "model.yaml", tmp_path / "link.yaml"
    path.write_text("old")
    path.chmod(0o640)
    try:
        link.symlink_to(path)
    except OSError:
        pytest.skip("no symbolic links here")
    document = parse_document(four_bar())
    assert document is not None
    save(document, link)
    assert link.is_symlink()
    assert load(path) == document
    assert stat.S_IMODE(path.stat().st_mode) in (0o640, 0o666)
    write_aside(link, "new\n")
    assert not link.is_symlink()
    assert load(path) == document


def test_a_missing_folder_is_an_error_of_the_system(tmp_path: Path) -> None:
    with pytest.raises(OSError, match="missing"):
        save(load(DATA / "five_bar.yaml"), tmp_path / "missing" / "model.yaml")
