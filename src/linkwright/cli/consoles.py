"""The consoles on which the command line prints: results on standard output, findings and progress on standard
error."""

from __future__ import annotations

from functools import partial
from typing import Any

from rich.console import Console, ConsoleOptions
from rich.containers import Lines
from rich.measure import Measurement
from rich.text import Text

from linkwright.escape import visible
from linkwright.presentation.lettering import breaks, widest


class Foldable(Text):
    """A text that may be broken between hanzi as well."""

    def wrap(self, console: Console, width: int, **how: Any) -> Lines:
        """In lines of this width."""
        if how.get("no_wrap"):
            return super().wrap(console, width, **how)
        lines = [
            part
            for line in self.split(allow_blank=True, include_separator=False)
            for part in line.divide(breaks(line.plain, width))
        ]
        for line in lines:
            line.rstrip()
        return Text("\n").join(lines).wrap(console, width, **how)

    def __rich_measure__(self, console: Console, options: ConsoleOptions) -> Measurement:
        """The least and the greatest width that it can make use of."""
        return Measurement(widest(self.plain), super().__rich_measure__(console, options).maximum)


class Stream(Console):
    """A console that shows control characters as their codes, and leaves it to the command what becomes of a pipe
    whose reader has left."""

    def render_str(self, text: str, **how: Any) -> Text:
        """Any text that is printed."""
        made = super().render_str(visible(text), **how)
        return Foldable(made.plain, made.style, justify=made.justify, overflow=made.overflow, spans=made.spans)

    def on_broken_pipe(self) -> None:
        """Raise the error on; Rich itself would end with exit code 1."""
        raise


_stream = partial(Stream, highlight=False, soft_wrap=True, emoji=False)
out = _stream()
wide = out if out.is_terminal else _stream(width=120)  # a pipe has no width
err = _stream(stderr=True)
