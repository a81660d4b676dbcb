"""Heads of CSV files in the words of the language, for readers of spreadsheets (``--excel``); for programs they stay as
they are."""

from __future__ import annotations

import re

from linkwright.model.csv_text import with_heads
from linkwright.words import known, say

PROGRAMS = "en"
"""The language near which heads are: they stay as programs know them."""
_HEAD = re.compile(r"(.*?)( \[[^\[\]]*\])?")


def worded(name: str, text: str) -> str:
    """The text of a CSV file with its heads in words: those of the file's own columns, and what follows the name of a
    signal or a measure in others. Names of the model stay."""
    return with_heads(text, lambda head: _word(head, name.removesuffix(".csv")))


def _word(head: str, stem: str) -> str:
    match = _HEAD.fullmatch(head)
    assert match is not None
    title, unit = match[1], match[2] or ""
    if known(own := f"csv.{stem}.{title.replace(' ', '_')}"):
        return f"{say(own)}{unit}"
    for space in [found.start() for found in re.finditer(" ", title)]:
        if known(suffix := f"csv.of.{title[space + 1 :].replace(' ', '_')}"):
            return f"{title[:space]} {say(suffix)}{unit}"
    return head
