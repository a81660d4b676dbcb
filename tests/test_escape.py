"""Text on its way out: what it becomes in each kind of place."""

from __future__ import annotations

import json
import re
from html.parser import HTMLParser
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest
from hypothesis import given
from hypothesis import strategies as st

from linkwright import escape
from linkwright.cam.nc.posts import POSTS
from linkwright.findings import Finding, ModelError
from linkwright.model.csv_text import table_text

UNSEEN = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f\u2028\u2029\u202a-\u202e\u2066-\u2069\ud800-\udfff\ufffe\uffff]")
ANY = st.text(st.characters(exclude_categories=()), max_size=30)


@given(ANY)
def test_nothing_unseen_is_left(text: str) -> None:
    for made in (escape.visible(text), escape.line(text), escape.markup(text), escape.cell(text)):
        assert not UNSEEN.search(made)
        made.encode()
    assert escape.visible(escape.visible(text)) == escape.visible(text)


@given(ANY)
def test_a_line_is_one(text: str) -> None:
    assert len(f"// {escape.line(text)}.".splitlines()) == 1
    assert len(escape.nc(text).splitlines()) <= 1
    assert len(escape.layer_name(text).splitlines()) <= 1


def test_harmless_text_stays_as_it_is() -> None:
    for text in ("Four-bar, 2nd (new)", "曲柄滑块机构 Ø20", "a b"):
        assert escape.line(text) == escape.visible(text) == escape.markup(text) == escape.cell(text) == text
    assert escape.line(" folded\nname\r\n") == "folded name"
    assert escape.visible("two\n\tlines") == "two\n\tlines"


@given(ANY)
def test_markup_is_text(text: str) -> None:
    made = escape.markup(text)
    element = ET.fromstring(f'<a b="{made}">{made}</a>')
    assert element.text or not made
    assert not [*element]


@given(st.dictionaries(ANY, ANY, max_size=3))
def test_json_keeps_its_values(data: dict[str, str]) -> None:
    text = json.dumps(data, ensure_ascii=False)
    for made in (escape.json_text(text), escape.script(text)):
        assert json.loads(made) == data
        assert not UNSEEN.search(made)
    assert "<" not in escape.script(text)


@pytest.mark.parametrize("text", ["1", "-1.5", "+2e-7", "-.5", "1e+300", "- 1", "a-b"])
def test_a_spreadsheet_takes_numbers_and_texts(text: str) -> None:
    assert escape.cell(text) == (text if text != "- 1" else "'- 1")


@pytest.mark.parametrize("text", ["=1+1", "+A1", "-A1", "@SUM(A1)", "-1.5+cmd|' /C calc'!A0", "\uff1d1", "--1", "-inf"])
def test_a_formula_is_text(text: str) -> None:
    assert escape.cell(text) == f"'{text}"


@pytest.mark.parametrize("text", ["\t=1+1", "\r=1+1"])
def test_no_cell_begins_with_a_line_end(text: str) -> None:
    assert escape.cell(text) == " =1+1"


def test_a_table_is_escaped_as_a_whole() -> None:
    assert table_text(["=a", "b\nc"], [["-1.5", "@d"]]) == "'=a,b c\n-1.5,'@d\n"


@given(ANY)
def test_a_string_in_csharp_holds_no_end(text: str) -> None:
    made = escape.csharp(text)
    assert re.fullmatch(r'([^"\\\x00-\x1f]|\\u[0-9a-f]{4})*', made)
    assert re.sub(r"\\u(....)", lambda found: chr(int(found[1], 16)), made) == text


@pytest.mark.parametrize("post", POSTS.values(), ids=POSTS)
@pytest.mark.parametrize(
    "text", ["a) G0 X99 (b", "a\nM30", "a\u2028M30", "%", "LOG,x", "(probeopen a.ngc)", "!~?\x18é\x85"]
)
def test_an_nc_comment_is_nothing_else(post: object, text: str) -> None:
    made = post.comment(text)  # type: ignore[attr-defined]
    inside = made[1:-1] if made.startswith("(") else made.removeprefix("; ")
    assert not set(inside) & set("()%!~?\n\r")
    assert inside.isascii()
    assert inside.isprintable()
    assert not re.match(r"\s*(log|probe)", inside, re.IGNORECASE)


def test_a_finding_is_seen_and_in_one_line() -> None:
    finding = Finding("table.no-column", ("tables", "a\nb"), {"name": "\x1b]0;x\x07angle\nerror: y", "known": "\u202e"})
    for text in (finding.what, finding.mend, finding.element, str(finding), str(ModelError([finding]))):
        assert not UNSEEN.search(text)
        assert "\n" not in text
    assert r"\x1b]0;x\x07angle error: y" in finding.what


def test_texts_are_escaped_nowhere_else() -> None:
    source = Path(escape.__file__).parent
    elsewhere = [path for path in source.rglob("*.py") if path.name not in ("escape.py", "csv_text.py", "csv_file.py")]
    for path in elsewhere:
        found = re.search(r"from html import|import (html|csv)\b|saxutils|csv\.writer", path.read_text("utf-8"))
        assert found is None, path


class _Text(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.tags: list[str] = []
        self.script = ""

    def handle_starttag(self, tag: str, attrs: object) -> None:
        self.tags.append(tag)

    def handle_data(self, data: str) -> None:
        self.script += data


def test_json_ends_no_script() -> None:
    reader = _Text()
    data = "</script><img src=x><!--"
    reader.feed(f"<script>{escape.script(json.dumps(data))}</script>")
    assert reader.tags == ["script"]
    assert json.loads(reader.script) == data
