"""The title block: where the results come from, and what the file says of itself."""

from __future__ import annotations

from pathlib import Path

import pytest

from linkwright import Builder, dump
from linkwright.findings import ModelError
from linkwright.model.document import load, parse_document, read_document
from linkwright.model.origin import Origin
from linkwright.report import ReportData, page
from linkwright.report.build import title_block
from linkwright.report.summary import summary
from linkwright.studies.registry import Outcomes
from linkwright.words import in_language

TAILGATE = Path(__file__).parents[2] / "examples" / "tailgate.yaml"
ORIGIN = Origin("tailgate.yaml", "0123456789abcdef", {}, "2026-01-31T12:34:56+01:00", "1.2.3")


def pairs(document: object, origin: Origin) -> dict[str, str]:
    return {str(entry["name"]): str(entry["sentence"]) for entry in title_block(document, origin)}  # type: ignore[arg-type]


def test_it_says_where_results_come_from() -> None:
    assert pairs(load(TAILGATE), ORIGIN) == {
        "File": "tailgate.yaml",
        "SHA-256": "0123456789ab",
        "Date": "2026-01-31 12:34 +01:00",
        "Author": "the linkwright authors",
        "Revision": "A",
        "linkwright version": "1.2.3",
    }
    with in_language("zh"):
        assert [*pairs(load(TAILGATE), ORIGIN)] == ["文件", "SHA-256", "日期", "编制", "版次", "linkwright 版本"]


def test_what_isn_t_given_is_left_out() -> None:
    document = Builder("bare").frame(A=[0, 0]).build()
    shown = pairs(document, Origin(None, "0" * 64))
    assert [*shown] == ["File", "SHA-256", "Date", "linkwright version"]
    assert shown["File"] == "made in Python"


def test_it_stands_in_the_header(report: ReportData) -> None:
    header = page(report).split("<header>")[1].split("</header>")[0]
    assert header.count('<dl class="title-block"') == 1
    assert "<div><dt>Revision</dt><dd>B</dd></div>" in header


def test_author_and_revision_are_texts_of_the_file() -> None:
    """They come back as they were; a number has lost its zeros and is refused; the summary has them."""
    document = Builder("bare", author="Tang", revision="1.10").frame(A=[0, 0]).build()
    text = dump(document)
    assert "author: Tang\nrevision: '1.10'\n" in text.replace('"', "'")
    assert read_document(text.encode())[0] == document
    with pytest.raises(ModelError, match="revision"):
        parse_document({"linkwright": 1, "links": {"frame": {}}, "revision": 1.1})
    told = summary(document, Outcomes(), [], ORIGIN)
    assert (told["author"], told["revision"]) == ("Tang", "1.10")
    assert not {"author", "revision"} & {*summary(Builder("bare").frame(A=[0, 0]).build(), Outcomes(), [], ORIGIN)}
