"""Runners: who performs the atoms. Each gives their results in order, with a bounded number of them under way."""

from __future__ import annotations

from collections import OrderedDict, deque
from collections.abc import Callable, Generator, Iterator
from concurrent.futures import Future, ThreadPoolExecutor, wait
from threading import Event, Lock
from typing import Protocol

from linkwright._machine import processors
from linkwright.blocks.work import Arrays, Task, Work
from linkwright.notation.registry import Registry

AHEAD = 2
"""Blocks under way for each worker: one at work, one waiting for it."""
KEPT = 4
"""Tasks that a process keeps open."""
LOOK = 0.5
"""Seconds after which a wait looks up: whether to stop, whether there is still someone to wait for."""

Results = list[tuple[int, Arrays]]


class Runner(Protocol):
    """Who performs the atoms of a work."""

    name: str
    grain: int
    """Poses of a block, so that handing it out costs little beside performing it."""

    @property
    def workers(self) -> int:
        """How many blocks are performed at a time."""

    def results(
        self, work: Work, task: Task, atoms: range, block: int, stop: Callable[[], bool]
    ) -> Generator[tuple[int, Arrays], None, None]:
        """Each atom with its result, in order, handed out ``block`` at a time.

        Once ``stop()`` holds, nothing more is handed out; what is under way may still come. Closing the iterator
        lets go of the rest. Raises :class:`~linkwright.findings.ModelError` where the runner itself fails.
        """

    def close(self) -> None:
        """Let go of what the runner opened."""


RUNNERS: Registry[type[Runner]] = Registry({"cluster": "linkwright.blocks.cluster"})


def register(cls: type[Runner]) -> type[Runner]:
    """Register a runner under its name; a second one of the same name is an error."""
    RUNNERS[cls.name] = cls
    return cls


def blocks(atoms: range, block: int) -> Iterator[range]:
    """Consecutive atoms, some at a time."""
    return (atoms[i : i + block] for i in range(0, len(atoms), block))


@register
class Threads:
    """Threads of this process, as many as it has processors unless told otherwise: kernels hold no lock."""

    name = "threads"
    grain = 1 << 20

    def __init__(self, workers: int | None = None) -> None:
        if workers is not None and workers < 1:
            raise ValueError("there must be at least one worker")
        self.workers = workers or processors()

    def results(
        self, work: Work, task: Task, atoms: range, block: int, stop: Callable[[], bool]
    ) -> Generator[tuple[int, Arrays], None, None]:
        """Each atom with its result, in order."""
        closed = Event()
        rest = blocks(atoms, block)
        window: deque[tuple[range, Future[Results]]] = deque()
        pool = ThreadPoolExecutor(self.workers, "linkwright")

        def perform(some: range) -> Results:
            return [(atom, task.perform(atom)) for atom in some if not (closed.is_set() or stop())]

        try:
            while True:
                while len(window) < AHEAD * self.workers and not stop() and (some := next(rest, None)) is not None:
                    window.append((some, pool.submit(perform, some)))
                if not window:
                    return
                some, future = window.popleft()
                while not wait([future], LOOK).done:
                    pass
                done = future.result()
                yield from done
                if len(done) < len(some):
                    return
        finally:
            closed.set()
            pool.shutdown(wait=True, cancel_futures=True)

    def close(self) -> None:
        """Nothing is open between two works."""


_tasks: OrderedDict[str, Task] = OrderedDict()
_opening = Lock()


def opened(work: Work) -> Task:
    """The work's task, kept by its key in this process."""
    with _opening:
        if work.key not in _tasks:
            _tasks[work.key] = work.open()
            while len(_tasks) > KEPT:
                _tasks.popitem(last=False)
        _tasks.move_to_end(work.key)
        return _tasks[work.key]
