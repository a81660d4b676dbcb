"""The consoles on which the command line prints: results on standard output, findings and progress on standard
error."""

from __future__ import annotations

from typing import Any

from rich.console import Console
from rich.text import Text

from linkwright.escape import visible


class Stream(Console):
    """A console that shows control characters as their codes, and leaves it to the command what becomes of a pipe
    whose reader has left."""

    def render_str(self, text: str, **how: Any) -> Text:
        """Any text that is printed."""
        return super().render_str(visible(text), **how)

    def on_broken_pipe(self) -> None:
        """Raise the error on; Rich itself would end with exit code 1."""
        raise


out = Stream(highlight=False, soft_wrap=True)
wide = out if out.is_terminal else Stream(highlight=False, soft_wrap=True, width=120)  # a pipe has no width
err = Stream(stderr=True, highlight=False, soft_wrap=True)
