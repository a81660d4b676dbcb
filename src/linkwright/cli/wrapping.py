"""Help texts in lines by the width of their letters: hanzi take two columns, and a line may end after each of them."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence

import click
from rich.cells import cell_len

_WIDE = "\u2e80-\u9fff\uf900-\ufaff\uff00-\uffef"
_CLOSING = "，。；：、）”！？》"
_PART = re.compile(f"[“（《]*[{_WIDE}][{_CLOSING}]*|[^\\s{_WIDE}]+[{_CLOSING}]*|\\s+")
GAP = 2
"""Columns between an option and what it does."""
FIRST = 30
"""The widest column of options."""


def lines(text: str, width: int) -> Iterator[str]:
    """A text in lines of at most ``width`` columns, but for words that are longer."""
    row = ""
    for part in _PART.findall(" ".join(text.split())):
        if row and cell_len(row + part.rstrip()) > width:
            yield row.rstrip()
            row = ""
        row += part if row else part.lstrip()
    if row:
        yield row.rstrip()


class WideFormatter(click.HelpFormatter):
    """Help whose columns stand below each other whatever letters they have."""

    def write_text(self, text: str) -> None:
        """Write paragraphs."""
        room = max(self.width - self.current_indent, 11)
        for k, paragraph in enumerate(text.split("\n\n")):
            if k:
                self.write("\n")
            for line in lines(paragraph, room):
                self.write(f"{' ' * self.current_indent}{line}\n")

    def write_dl(
        self, rows: Sequence[tuple[str, str]] | Iterable[tuple[str, str]], col_max: int = FIRST, col_spacing: int = GAP
    ) -> None:
        """Write options or commands with what they do."""
        rows = [*rows]
        first = min(max((cell_len(name) for name, _ in rows), default=0), col_max) + col_spacing
        room = max(self.width - self.current_indent - first, 10)
        for name, text in rows:
            said = [*lines(text, room)]
            head = " " * self.current_indent + name
            if cell_len(name) > first - col_spacing or not said:
                self.write(f"{head}\n")
            else:
                self.write(f"{head}{' ' * (first - cell_len(name))}{said.pop(0)}\n")
            for line in said:
                self.write(f"{' ' * (self.current_indent + first)}{line}\n")
