"""A page in Chinese is Chinese all over: what is English on it comes from the model file."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from functools import cache
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import pytest

from linkwright.app import examine_file, export, perform
from linkwright.model.yaml_text import read_text
from linkwright.reductions import REDUCTIONS
from linkwright.report import page
from linkwright.report.build import report_data
from linkwright.words import in_language

EXAMPLES = Path(__file__).parents[2] / "examples"
NAMES = (
    "bracket",
    "five_bar_path",
    "four_bar_accuracy",
    "four_bar_sweep",
    "heat_seal_cam",
    "jansen_leg",
    "paper_feeder",
)

UNREAD = {"code", "pre", "script", "style"}
ATTRIBUTES = {"alt", "aria-label", "aria-valuetext", "data-head", "placeholder", "title"}
FREE = {"name", "note", "source"}
"""Free texts of a model file."""
FORMAT = {"left", "right", "of", "ahead", "behind", "along"}
"""Words with which a model file states assembly modes: ``C: left of B-D``."""
WORD = re.compile(r"[A-Za-z]{2,}")
RUN = re.compile(rf"(?<![\w.-]){WORD.pattern}(?: {WORD.pattern})+(?![\w-])")

REDUCED = re.compile(rf"的 (?:{'|'.join(REDUCTIONS)})(?!\w)")
"""A reduction as files have it, in a sentence: ``E.x 的 span``."""


class Read(HTMLParser):
    """What one reads on a page, or hears: its texts, and attributes that are texts."""

    def __init__(self, html: str) -> None:
        super().__init__()
        self.texts: list[str] = []
        self.unread: list[str] = []
        self.words = False
        self.feed(html)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = dict(attrs)
        if tag in UNREAD or given.get("lang") == "en":
            self.unread.append(tag)
        self.words = given.get("id") == "languages"
        self.texts += [value for key, value in attrs if key in ATTRIBUTES and value]

    def handle_endtag(self, tag: str) -> None:
        if self.unread and self.unread[-1] == tag:
            self.unread.pop()

    def handle_data(self, data: str) -> None:
        if self.words:
            self.texts += strings(json.loads(data)["words"])  # those that the page's scripts show
            self.words = False
        elif not self.unread:
            self.texts.append(data)


def strings(data: Any) -> Iterator[str]:
    """All texts in a piece of JSON or YAML."""
    if isinstance(data, str):
        yield data
    elif isinstance(data, dict | list):
        for part in data.values() if isinstance(data, dict) else data:
            yield from strings(part)


def keys(data: Any) -> Iterator[str]:
    """All keys in it."""
    if isinstance(data, dict):
        yield from data
    if isinstance(data, dict | list):
        for part in data.values() if isinstance(data, dict) else data:
            yield from keys(part)


def english(texts: list[str], model: dict[str, Any]) -> list[str]:
    """Words in a row that neither the model nor the format of model files has all of."""
    free = sorted((model[key] for key in FREE & model.keys()), key=len, reverse=True)
    rest = {key: value for key, value in model.items() if key not in FREE}
    known = FORMAT | {word for text in (*keys(rest), *strings(rest)) for word in WORD.findall(text)}
    found = []
    for text in texts:
        plain = " ".join(text.split())
        for written in free:
            plain = plain.replace(" ".join(written.split()), "")
        found += [run for run in RUN.findall(plain) if {*WORD.findall(run)} - known]
    return found


@cache
def model_of(name: str) -> dict[str, Any]:
    data: dict[str, Any] = read_text((EXAMPLES / f"{name}.yaml").read_bytes()).data
    return data


@pytest.mark.parametrize("name", NAMES)
def test_no_sentence_of_a_page_is_english(name: str) -> None:
    with in_language("zh"):
        job = perform(examine_file(EXAMPLES / f"{name}.yaml"))
        assert job.examined.document is not None
        html = page(report_data(job.examined.document, job.outcomes, job.examined.findings, job.examined.origin))
    texts = Read(html).texts
    assert len(texts) > 100
    assert english(texts, model_of(name)) == []
    assert [text for text in texts if REDUCED.search(text)] == []


def test_no_sentence_of_a_sheet_is_english() -> None:
    with in_language("zh"):
        html = export(EXAMPLES / "bonnet_hinge.yaml", "process-simulate").files["joint_functions.html"]
    assert isinstance(html, str)
    texts = [text.replace("Process Simulate", "") for text in Read(html).texts]
    assert len(texts) > 50
    assert english(texts, model_of("bonnet_hinge")) == []


def test_english_is_seen() -> None:
    model = {"name": "A feeder", "links": {"frame": {}, "upper": {}}, "assembly": {"C": "left of B-D"}}
    html = """<h1>A feeder：结果</h1><p>杆组 frame upper，模式：C: right of B-D</p>
    <pre>no text</pre><script>no text</script><a lang="en">In English</a>
    <p>closure of frame</p><p>No values</p><td data-head="Largest value">1</td><svg aria-label="the cam angle"/>
    <script id="languages">{"words": {"texts": {"a": "not assembled"}, "n": 1}, "others": {"en": "No text"}}</script>"""
    assert english(Read(html).texts, model) == [
        "closure of frame",
        "No values",
        "Largest value",
        "the cam angle",
        "not assembled",
    ]
