"""Independent pieces of work on several threads; what is done when an interrupt comes is kept."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from contextlib import suppress
from typing import TypeVar

from linkwright.blocks import Progress

Item = TypeVar("Item")
Result = TypeVar("Result")

LOOK = 0.5
"""Seconds after which a wait looks up, where a system's own wait can't be interrupted."""


def run_in_threads(
    work: Callable[[Item], Result], items: Sequence[Item], workers: int, progress: Progress | None = None
) -> tuple[dict[int, Result], bool]:
    """What comes of items, by their numbers, and whether an interrupt has stopped it: then those at work are waited
    for, the others don't begin. ``progress`` is told at the start and now and then."""
    pool, stopped = ThreadPoolExecutor(workers, "linkwright"), False
    futures = [pool.submit(work, item) for item in items]
    try:
        open_, done = set(futures), set[Future[Result]]()
        while True:
            for future in done:
                future.result()
            if progress is not None:
                progress(len(items) - len(open_), len(items))
            if not open_:
                break
            done, open_ = wait(open_, LOOK, FIRST_COMPLETED)
    except KeyboardInterrupt:
        stopped = True
    finally:
        with suppress(KeyboardInterrupt):  # a second one waits for none
            pool.shutdown(wait=True, cancel_futures=True)
    return {i: future.result() for i, future in enumerate(futures) if future.done() and not future.cancelled()}, stopped
