"""A bar for long work on the terminal: the share done, the rate in poses or the count of pieces, the time left."""

from __future__ import annotations

import time
from collections.abc import Callable
from types import TracebackType
from typing import Any

from linkwright.cli.consoles import err
from linkwright.words import say

PATIENCE = 1.0
"""Seconds of work before the bar shows."""
FEW = 1000
"""So few in all aren't poses but pieces of work: they are counted."""


class ProgressBar:
    """A progress of poses or other work (see :class:`linkwright.blocks.Progress`), for a ``with``; on standard error.

    It shows on a terminal only, unless ``shown`` says yes or no, and only where the work lasts over a second; ``first``
    is called right before.
    """

    def __init__(
        self, text: str, shown: bool | None = None, console: Any = None, first: Callable[[], None] = lambda: None
    ) -> None:
        self._text, self._console, self._before = text, console or err, first
        self._shown = self._console.is_terminal if shown is None else shown
        self._bar: Any = None
        self._start = time.monotonic()
        self._first: int | None = None
        self._total = 0

    def __enter__(self) -> ProgressBar:
        return self

    def __call__(self, done: int, total: int) -> None:
        """So many of all poses are done. Another total is that of other work."""
        if self._first is None or total != self._total:
            self._first, self._total, self._start = done, total, time.monotonic()
        spent = time.monotonic() - self._start
        if not self._shown or (self._bar is None and spent < PATIENCE):
            return
        if self._bar is None:
            self._before()
            self._bar = self._made(total)
            self._bar.start()
        speed = (done - self._first) / max(spent, 1e-9)
        left = (total - done) / speed if speed > 0 else None
        what = say("cli.count", done=done, total=total) if total < FEW else say("cli.rate", rate=rate(speed))
        tail = what + (say("cli.left", time=duration(left)) if left is not None else "")
        self._bar.update(self._bar.task_ids[0], completed=done, total=total, tail=tail)

    def _made(self, total: int) -> Any:
        from rich.markup import escape
        from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn

        columns = TextColumn("{task.description}"), BarColumn(), TaskProgressColumn(), TextColumn("{task.fields[tail]}")
        bar = Progress(*columns, console=self._console, transient=True)
        bar.add_task(escape(self._text), total=total, tail="")
        return bar

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._bar is not None:
            self._bar.stop()


def rate(speed: float) -> str:
    """Poses per second in three digits: 38.2 M."""
    for size, letter in ((1e9, " G"), (1e6, " M"), (1e3, " k")):
        if speed >= 0.9995 * size:
            return f"{speed / size:.3g}{letter}"
    return f"{speed:.3g}"


def duration(seconds: float) -> str:
    """A time left, in hours, minutes and seconds."""
    minutes, s = divmod(round(seconds), 60)
    hours, m = divmod(minutes, 60)
    return f"{hours}:{m:02d}:{s:02d}" if hours else f"{m}:{s:02d}"
