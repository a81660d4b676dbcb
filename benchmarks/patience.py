"""An end to what takes too long; the same work on many seeds by some processes."""

from __future__ import annotations

import contextlib
import multiprocessing
import signal
from collections.abc import Callable, Iterable, Iterator
from typing import Any, TypeVar

T = TypeVar("T")


def spread(work: Callable[[int], T], seeds: Iterable[int], jobs: int, chunk: int) -> Iterator[T]:
    """What the work gives for each seed, as it comes, by some processes that take ``chunk`` seeds at a time."""
    if jobs == 1:
        yield from map(work, seeds)
        return
    quiet = (signal.SIGINT, signal.SIG_IGN)  # the parent takes the interrupt
    with multiprocessing.Pool(jobs, signal.signal, quiet) as pool:
        yield from pool.imap_unordered(work, seeds, chunksize=chunk)


class OutOfTime(BaseException):
    """What took too long; an exception that no code of the program handles as one of its own."""


@contextlib.contextmanager
def limited(seconds: float) -> Iterator[None]:
    """Raises :class:`OutOfTime` after some seconds of this process' own time, where the system can tell."""
    if not hasattr(signal, "setitimer"):
        yield
        return

    def late(*_: Any) -> None:
        raise OutOfTime(f"over {seconds:g} s")

    before = signal.signal(signal.SIGPROF, late)
    signal.setitimer(signal.ITIMER_PROF, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)
