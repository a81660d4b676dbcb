"""The report page as text: self-contained, well-formed, escaped, of modest size."""

from __future__ import annotations

import itertools
import json
import re
from collections.abc import Callable
from dataclasses import is_dataclass, replace
from html.parser import HTMLParser
from typing import Any

import numpy as np
import pytest

from linkwright.presentation.blocks import Checks, Measures, Section, Sentences
from linkwright.presentation.payload import script_json
from linkwright.report import ReportData, compact, page
from linkwright.report.data import Severity
from linkwright.report.page import SCRIPT_WORDS
from linkwright.words import catalogue
from linkwright.words.en.report import TEXTS

HOSTILE = "</script><img src=x>&\"'"
VOID = {"meta", "link", "br", "img", "input"}


class Page(HTMLParser):
    """Elements, attributes and text of a page; complains about tags that don't nest."""

    def __init__(self, html: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.tags: list[tuple[str, dict[str, str | None]]] = []
        self.text: dict[str, str] = {}
        self.payload = ""
        self.feed(html)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append((tag, dict(attrs)))
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        here = self.open[-1] if self.open else ""
        self.text[here] = self.text.get(here, "") + data
        if here == "script" and self.tags[-1][1].get("id") == "data":
            self.payload += data


def test_page_is_self_contained(report: ReportData) -> None:
    html = page(report)
    parsed = Page(html)
    loads = [value for _, attrs in parsed.tags for key, value in attrs.items() if key in ("src", "href")]
    assert [value for value in loads if not value.startswith(("#", "data:", "?lang="))] == []
    assert "@import" not in html
    assert "url(" not in html
    policy = next(a["content"] for t, a in parsed.tags if t == "meta" and "http-equiv" in a)
    assert policy.startswith("default-src 'none'")
    assert re.search(r"^\s*(export|import)\b", parsed.text["script"], re.MULTILINE) is None


def test_scripts_stay_whole(report: ReportData) -> None:
    html = page(report)
    assert html.count("</script") == html.count("<script") == 4
    assert "The MIT License" in html  # the plots' library travels with its licence


def test_only_checks_are_counted(report: ReportData) -> None:
    """What else is said of the run stands below them."""
    html = page(report)
    assert "Verification: 1 of 2 checks passed" in html
    assert '</table><p class="note">201 poses computed with the numpy kernel: little work.</p>' in html


def test_payload_is_what_was_given(report: ReportData) -> None:
    data = json.loads(Page(page(report)).payload)
    assert data["scene"] == json.loads(json.dumps(compact(report["scene"])))
    assert data["plots"][0]["series"][0]["values"] == pytest.approx(report["plots"][0]["series"][0]["values"], rel=1e-6)
    words = json.loads(page(report).split('id="languages">')[1].split("</script")[0])["words"]
    assert set(words["texts"]) == set(SCRIPT_WORDS)
    assert words["titles"] == [plot["title"] for plot in report["plots"]]


def hostile(value: Any) -> Any:
    """A part of a report with all its texts hostile, but for names of sections, which are the program's own."""
    if isinstance(value, str):
        return HOSTILE
    if isinstance(value, list | tuple):
        return [hostile(each) for each in value]
    if not is_dataclass(value) or isinstance(value, type):
        return value
    kept = ("name",) if isinstance(value, Section) else ()
    return replace(value, **{key: hostile(each) for key, each in vars(value).items() if each and key not in kept})


@pytest.fixture
def said(monkeypatch: pytest.MonkeyPatch) -> Callable[[str], None]:
    """Has all texts of the page's frame say this."""

    def all_say(text: str) -> None:
        for key in (*TEXTS, "language.name", "language.choice"):
            monkeypatch.setitem(catalogue("en"), key, text)

    return all_say


def test_hostile_names_are_text_everywhere(report: ReportData, said: Callable[[str], None]) -> None:
    clean = [tag for tag, _ in Page(page(report)).tags]
    for key in ("title", "subtitle", "source", "version", "model_text"):
        report[key] = HOSTILE
    said(HOSTILE)
    report["sections"] = [hostile(section) for section in report["sections"]]
    for fact in (*report["structure"], *report["title_block"]):
        fact.update(name=HOSTILE, sentence=HOSTILE)
    for plot in report["plots"]:
        plot.update(title=HOSTILE, unit=HOSTILE)
        plot["series"][0]["name"] = HOSTILE
    crank = report["scene"]["links"][1]
    for joint in report["scene"]["joints"]:
        joint["links"] = [HOSTILE if link == crank["name"] else link for link in joint["links"]]
    crank["name"] = HOSTILE
    parsed = Page(page(report))
    assert [tag for tag, _ in parsed.tags] == clean
    assert parsed.text["h1"] == HOSTILE
    assert json.loads(parsed.payload)["scene"]["links"][1]["name"] == HOSTILE


def test_verdicts_read_without_colour(report: ReportData) -> None:
    html = page(report)
    assert "✓</span> passed" in html
    assert "✗</span> failed" in html
    assert "Requirements: 1 of 2 passed" in html


def test_results_come_before_what_verifies_them(report: ReportData) -> None:
    """Whatever the order of the studies, on the page as in its contents; the line in the header leads there."""
    report["sections"] = [*reversed(report["sections"]), Section("limits", [Sentences(["One."])])]
    html = page(report)
    order = ["measures", "limits", "motion", "force", "certificate", "structure", "model"]
    assert re.findall(r'<section id="(\w+)"', html) == ["mechanism", *order]
    assert re.findall(r'<a href="#(\w+)">', html.split("<nav aria")[1].split("</nav>")[0]) == ["mechanism", *order]
    assert '<a href="#certificate"><span class="mark bad">' in html.split("<nav aria")[0]


SEVERITIES: tuple[Severity, ...] = ("error", "warning", "note")
BADGES = {"error": "Errors: ", "warning": "Warnings: ", "note": "Notes: "}


@pytest.mark.parametrize("counts", list(itertools.product((0, 1, 2), repeat=3)))
def test_only_errors_are_failures(report: ReportData, counts: tuple[int, int, int]) -> None:
    """Each severity has its banner and its line in the header, in words of its own, errors first; the sign and the
    class of what failed are those of errors alone."""
    found = [(severity, i) for severity, count in zip(SEVERITIES, counts, strict=True) for i in range(count)]
    report["problems"] = [
        {"code": f"{severity}-{i}", "severity": severity, "what": "rocker is too short", "mend": "make it longer"}
        for severity, i in reversed(found)
    ]
    report["sections"] = []
    html = page(report)
    Page(html)
    header, banners = html.split("<header>")[1].split("</header>")[0], html.split("</header>")[1].split("<main>")[0]
    assert [banner.split('"')[0] for banner in banners.split('<section id="')[1:]] == [
        f"{severity}s" for severity, count in zip(SEVERITIES, counts, strict=True) if count
    ]
    for severity, count in zip(SEVERITIES, counts, strict=True):
        assert (f"{BADGES[severity]}{count}<" in header) == bool(count)
        assert (f'href="#{severity}s"' in header) == bool(count)
        part = banners.split(f'<section id="{severity}s"')[-1].split("</section>")[0] if count else ""
        assert part.count("<code>") == part.count(f"<code>{severity}-") == count
    assert ("mark bad" in header) == ("✗" in header) == ("banner errors" in banners) == bool(counts[0])


def test_empty_parts_leave_no_headings(report: ReportData) -> None:
    report["sections"] = [Section("measures", [Measures([])]), Section("certificate", [Checks([])])]
    report["structure"] = report["plots"] = []
    report["model_text"] = ""
    html = page(report)
    Page(html)
    for word in ("measures", "certificate", "structure", "motion", "force", "model"):
        assert f'id="{word}"' not in html
        assert f'href="#{word}"' not in html


def test_every_word_comes_from_the_catalogue(report: ReportData, said: Callable[[str], None]) -> None:
    """With every word marked, no letter outside the marks is left but those of the data."""
    report.update(
        title="1", subtitle="2", source="6", version="3", model_text="4", title_block=[], plots=[], structure=[]
    )
    report.update(sections=[], problems=[])
    said("#")
    body = page(report).split("<body>")[1].split("<script")[0]
    body = re.sub("<text[^>]*>.*?</text>", "", body)  # names of points and links
    assert re.findall(r"[A-Za-z]+", re.sub(r"<[^>]*>", "", body)) == []


def test_missing_word_is_loud(report: ReportData, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delitem(catalogue("en"), "report.play")
    with pytest.raises(KeyError, match=r"report\.play"):
        page(report)


def test_size_of_a_large_report(report: ReportData) -> None:
    """201 poses and 60 series stay under 400 kB."""
    rng = np.random.default_rng(1)
    series = [{"name": f"s{i}", "values": (rng.normal(size=201) * 1e3).tolist()} for i in range(60)]
    report["plots"] = [
        {"title": f"plot {i}", "group": "motion", "unit": "mm", "series": series[3 * i : 3 * i + 3]} for i in range(20)
    ]
    assert len(page(report).encode()) < 400_000


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        (1 / 3, 0.3333333),
        (680.0, 680),
        (float("nan"), None),
        (float("inf"), None),
        (-1.23456789e-12, -1.234568e-12),
        (1.5e300, 1.5e300),
        (np.float64(0.1), 0.1),
        (True, True),
        ((1.0, None, "a"), [1, None, "a"]),
    ],
)
def test_compact(value: object, expected: object) -> None:
    assert compact(value) == expected
    assert type(compact(value)) is type(expected)


def test_script_json_never_closes_the_script() -> None:
    text = script_json({"a": "</script><!--<script>"})
    assert "<" not in text
    assert json.loads(text) == {"a": "</script><!--<script>"}
