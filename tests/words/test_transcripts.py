"""What pages show of commands that aren't run for them is what the program's texts can give: sentences and headings of
console blocks marked `no-run` are held against the catalogue of their language."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from string import Formatter

import pytest

from linkwright.words import catalogue

ROOT = Path(__file__).parents[2]
_PROBLEM = re.compile(r"\S+:\d+: (?:错误|警告|提示) [^：]+：(.*) \[[\w.-]+\]")
_BLOCK = re.compile(r"(<!-- no-run -->\n+)?```console( no-run)?\n(.*?)```", re.DOTALL)


def unrun_lines(page: Path) -> Iterator[str]:
    """The lines of output in the blocks of a page that aren't run."""
    for marked, beside, text in _BLOCK.findall(page.read_text(encoding="utf-8")):
        if marked or beside:
            yield from (line for line in text.splitlines() if line.strip("., ") and not line.startswith(("$ ", "    ")))


FEW = 4
"""Texts with places and fewer hanzi than these become nearly anything."""


@cache
def patterns(language: str) -> re.Pattern[str]:
    """What any text of a language can become."""
    found = set()
    for text in catalogue(language).values():
        own = len(re.findall("[\u4e00-\u9fff]", re.sub(r"\{[^{}]*\}", "", text)))
        if own >= FEW or (own and "{" not in text):
            parts = Formatter().parse(text)
            pieces = (re.escape(part or "") + (".+?" if name is not None else "") for part, name, _, _ in parts)
            found.add("".join(pieces).replace(r"\ ", r"\s*"))
    return re.compile("|".join(sorted(found, key=len, reverse=True)))


def pieces(line: str) -> list[str]:
    """The cells of a row, or a sentence as it is, of a problem its own; without marks."""
    if problem := _PROBLEM.fullmatch(line):
        return [problem[1]]
    return [cell for cell in re.split(r"\s{2,}", line.strip().lstrip("✓✗ ")) if re.search("[\\u4e00-\\u9fff]", cell)]


PAGES = sorted({page for page in (ROOT / "docs" / "zh").rglob("*.md") if [*unrun_lines(page)]})


def strange(language: str, line: str) -> list[str]:
    """The parts of a line that no text of a language gives."""
    known = patterns(language)
    return [piece for piece in pieces(line) if not known.fullmatch(piece)]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_of_each_page(page: Path) -> None:
    offending = {line: bad for line in unrun_lines(page) if (bad := strange("zh", line))}
    assert offending == {}


def test_a_sentence_that_nothing_says_is_seen() -> None:
    assert strange("zh", "P 的工作空间：8 个区域（边界误差小于 3e-05 mm）。") == []
    assert strange("zh", "P 的工作区：8 个区域。") and strange("zh", "alpha  模式  周长  孔数")
    assert len(PAGES) >= 4
