"""Help texts in lines by the width of their letters."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import click

from linkwright.presentation.lettering import columns, folded
from linkwright.words import say

GAP = 2
"""Columns between an option and what it does."""
FIRST = 30
"""The widest column of options."""


class WideFormatter(click.HelpFormatter):
    """Help whose columns stand below each other whatever letters they have."""

    def write_usage(self, prog: str, args: str = "", prefix: str | None = None) -> None:
        """Write how a command is called."""
        usage = say("click.usage")
        super().write_usage(prog, args, usage if columns(usage[-1]) > 1 else f"{usage} ")

    def write_heading(self, heading: str) -> None:
        """Write the heading of options or commands."""
        self.write(f"{' ' * self.current_indent}{say('cli.heading', heading=heading)}\n")

    def write_text(self, text: str) -> None:
        """Write paragraphs."""
        room = max(self.width - self.current_indent, 11)
        for k, paragraph in enumerate(text.split("\n\n")):
            if k:
                self.write("\n")
            for line in folded(paragraph, room):
                self.write(f"{' ' * self.current_indent}{line}\n")

    def write_dl(
        self, rows: Sequence[tuple[str, str]] | Iterable[tuple[str, str]], col_max: int = FIRST, col_spacing: int = GAP
    ) -> None:
        """Write options or commands with what they do."""
        rows = [*rows]
        first = min(max((columns(name) for name, _ in rows), default=0), col_max) + col_spacing
        room = max(self.width - self.current_indent - first, 10)
        for name, text in rows:
            said = [*folded(text, room)]
            head = " " * self.current_indent + name
            if columns(name) > first - col_spacing or not text:
                self.write(f"{head}\n")
            else:
                self.write(f"{head}{' ' * (first - columns(name))}{said.pop(0)}\n")
            for line in said:
                self.write(f"{' ' * (self.current_indent + first)}{line}\n")
