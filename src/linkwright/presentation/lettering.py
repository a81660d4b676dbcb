"""How wide letters are, and where a line of them may end: hanzi take two columns, and may stand at the end of a line
without a space, which none is added for where lines are joined."""

from __future__ import annotations

import re
from collections.abc import Iterator
from unicodedata import east_asian_width

FONT = (
    'system-ui, Arial, "DejaVu Sans", "Liberation Sans", "Noto Sans", "PingFang SC", "Microsoft YaHei", '
    '"Noto Sans CJK SC", "Source Han Sans SC", "WenQuanYi Micro Hei", sans-serif'
)
"""The fonts of pictures, as CSS has them: those of Latin letters, then those of hanzi."""
_WIDE = "\u2e80-\u9fff\uf900-\ufaff\uff00-\uffef"
_CLOSING = "，。；：、）”！？》"
_FULL_WIDTH = "，。；：、！？（）《》"
_UNSPACED = re.compile(f"(?<=[{_FULL_WIDTH}]) | (?=[{_FULL_WIDTH}])|(?<=[{_WIDE}]) (?=[{_WIDE}“])|(?<=”) (?=[{_WIDE}])")
"""Spaces beside full-width punctuation, and between hanzi."""
_PART = re.compile(f"[“（《]*(?:[{_WIDE}]|[^\\s{_WIDE}]+(?:(?<=\\d) %)?)[{_CLOSING}]*|\\s+")


def columns(text: str) -> int:
    """How many columns of a terminal a text takes; in pictures, how many letters' widths."""
    return sum(2 if east_asian_width(letter) in "WF" else 1 for letter in text)


def without_hanzi_spaces(text: str) -> str:
    """A text whose lines YAML has joined by spaces, without those that Chinese doesn't have there."""
    return _UNSPACED.sub("", text)


def folded(text: str, room: int) -> Iterator[str]:
    """A text in lines of at most ``room`` columns, but for words that are longer."""
    row = ""
    for part in _PART.findall(without_hanzi_spaces(" ".join(text.split()))):
        if row and columns(row + part.rstrip()) > room:
            yield row.rstrip()
            row = ""
        row += part if row else part.lstrip()
    yield row.rstrip()


def breaks(text: str, room: int) -> list[int]:
    """Where a text of one line is broken so that each line takes at most ``room`` columns, but for longer words."""
    found, start = [], 0
    for part in _PART.finditer(text):
        if part.start() > start and columns(text[start : part.end()].rstrip()) > room:
            start = part.start()
            found.append(start)
    return found


def widest(text: str) -> int:
    """How many columns the widest part of a text takes that isn't broken."""
    return max((columns(part.strip()) for part in _PART.findall(text)), default=0)
