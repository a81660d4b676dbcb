"""How wide letters are, and where a line of them may end: hanzi take two columns, and may stand at the end of a line
without a space, which none is added for where lines are joined."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from unicodedata import east_asian_width

FONT = (
    'system-ui, Arial, "DejaVu Sans", "Liberation Sans", "Noto Sans", "PingFang SC", "Microsoft YaHei", '
    '"Noto Sans CJK SC", "Source Han Sans SC", "WenQuanYi Micro Hei", sans-serif'
)
"""The fonts of pictures, as CSS has them: those of Latin letters, then those of hanzi."""
_WIDE = "\u2e80-\u9fff\uf900-\ufaff\uff00-\uffef"
_CLOSING = "，。；：、）”！？》"
_FULL_WIDTH = "，。；：、！？（）《》"
_NARROW = "\u2000"
"""Below it are no hanzi, and no punctuation that stands with them."""
_WORD = re.compile(r"\S+(?:(?<=\d) %)?|\s+")
"""A part of a text that has none of them."""


@cache
def _unspaced() -> re.Pattern[str]:
    """Spaces beside full-width punctuation, and between hanzi."""
    beside = f"(?<=[{_FULL_WIDTH}]) | (?=[{_FULL_WIDTH}])"
    return re.compile(f"{beside}|(?<=[{_WIDE}]) (?=[{_WIDE}“])|(?<=”) (?=[{_WIDE}])")


@cache
def _part() -> re.Pattern[str]:
    return re.compile(f"[“（《]*(?:[{_WIDE}]|[^\\s{_WIDE}]+(?:(?<=\\d) %)?)[{_CLOSING}]*|\\s+")


def _narrow(text: str) -> bool:
    """Whether a text is broken at spaces only: then the patterns above, which are slow to compile, aren't needed."""
    return max(text, default="") < _NARROW


def _parts(text: str) -> Iterator[re.Match[str]]:
    """The parts of a text between which a line may end."""
    return (_WORD if _narrow(text) else _part()).finditer(text)


def columns(text: str) -> int:
    """How many columns of a terminal a text takes; in pictures, how many letters' widths."""
    return sum(2 if east_asian_width(letter) in "WF" else 1 for letter in text)


def without_hanzi_spaces(text: str) -> str:
    """A text whose lines YAML has joined by spaces, without those that Chinese doesn't have there."""
    return text if _narrow(text) else _unspaced().sub("", text)


def folded(text: str, room: int) -> Iterator[str]:
    """A text in lines of at most ``room`` columns, but for words that are longer."""
    row = ""
    for part in (match[0] for match in _parts(without_hanzi_spaces(" ".join(text.split())))):
        if row and columns(row + part.rstrip()) > room:
            yield row.rstrip()
            row = ""
        row += part if row else part.lstrip()
    yield row.rstrip()


def breaks(text: str, room: int) -> list[int]:
    """Where a text of one line is broken so that each line takes at most ``room`` columns, but for longer words."""
    found, start = [], 0
    for part in _parts(text):
        if part.start() > start and columns(text[start : part.end()].rstrip()) > room:
            start = part.start()
            found.append(start)
    return found


def widest(text: str) -> int:
    """How many columns the widest part of a text takes that isn't broken."""
    return max((columns(part[0].strip()) for part in _parts(text)), default=0)
