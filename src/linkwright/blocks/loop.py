"""The loop: a work's atoms through a runner into a sink, from where the sink stands to the end."""

from __future__ import annotations

import signal
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager, suppress
from typing import Any, Protocol

from linkwright import interrupts
from linkwright.blocks.runners import Runner, Threads, opened
from linkwright.blocks.work import Sink, Task, Work
from linkwright.data_classes import dataclass
from linkwright.findings import Finding, ModelError

EVERY = 5.0
"""Seconds between two saves."""
SHARE = 20
"""A save may take one part in so many of the time: slow ones come less often."""
SPARE = 4
"""Blocks for each worker that there should be at least, so that the last ones end together."""


class Progress(Protocol):
    """Is told how far the work is."""

    def __call__(self, done: int, total: int) -> None:
        """So many of all its poses are done: told at the start and after each atom."""


@dataclass(frozen=True)
class Carried:
    """What came of carrying a work.

    ``atoms`` of ``total`` are in the sink; ``poses`` were performed this time, in ``seconds``. Where it isn't ``done``,
    it was ``interrupted`` or ``error`` says why; the next time goes on from what was saved.
    """

    atoms: int
    total: int
    poses: int
    seconds: float
    interrupted: bool = False
    error: Finding | None = None

    @property
    def done(self) -> bool:
        """Whether all atoms are in the sink and saved."""
        return self.atoms == self.total and self.error is None and not self.interrupted


def carry(
    work: Work,
    sink: Sink,
    runner: Runner | None = None,
    progress: Progress | None = None,
    block: int | None = None,
    every: float = EVERY,
) -> Carried:
    """Perform the atoms that the sink lacks, in blocks of so many; save every so many seconds and at the end.

    The runner is threads of this process unless another is given. Neither it nor ``block`` changes the results. An
    interrupt (Ctrl-C) stops handing out atoms, waits for those at work and saves; a second one gives up what isn't
    saved. Findings of the runner and of the sink's files come back as ``error``.
    """
    loop = _Loop(sink, runner or Threads(), progress, every)
    error: Finding | None = None
    with _interrupts(lambda: loop.task is None) as stop:
        try:
            loop.run(work, block, stop)
            sink.save()
            interrupted = sink.next < loop.total
        except KeyboardInterrupt:  # it may have torn the sink's state: what was last saved counts
            interrupted = True
        except Exception as fault:
            with suppress(ModelError):
                sink.save()
            if not isinstance(fault, ModelError):
                raise
            interrupted, error = False, fault.findings[0]
    return Carried(sink.next, loop.total, loop.poses, time.perf_counter() - loop.start, interrupted, error)


class _Loop:
    def __init__(self, sink: Sink, runner: Runner, progress: Progress | None, every: float) -> None:
        self.sink, self.runner, self.progress, self.every = sink, runner, progress, every
        self.task: Task | None = None
        self.total = self.poses = 0
        self.start = self._saved = time.perf_counter()

    def run(self, work: Work, block: int | None, stop: threading.Event) -> None:
        task = self.task = opened(work)
        self.total = task.atoms
        atoms = range(self.sink.next, task.atoms)
        before = sum(task.poses(atom) for atom in range(atoms.start)) if self.progress else 0
        every = before + sum(map(task.poses, atoms)) if self.progress else 0
        self._report_progress(before, every)
        if not atoms:
            return
        block = block or suited(task, atoms, self.runner)
        with closing(self.runner.results(work, task, atoms, block, stop.is_set)) as results:
            for atom, result in results:
                self.sink.take(atom, result)
                self.poses += task.poses(atom)
                self._report_progress(before + self.poses, every)
                self._save()

    def _report_progress(self, done: int, total: int) -> None:
        if self.progress is not None:
            self.progress(done, total)

    def _save(self) -> None:
        start = time.perf_counter()
        if start - self._saved >= self.every:
            self.sink.save()
            self._saved = time.perf_counter()
            self.every = max(self.every, SHARE * (self._saved - start))


def suited(task: Task, atoms: range, runner: Runner) -> int:
    """Atoms of a block: enough to be worth handing out, few enough to keep all workers busy to the end."""
    return max(min(runner.grain // max(task.poses(atoms[0]), 1), len(atoms) // (SPARE * runner.workers)), 1)


@contextmanager
def _interrupts(at_once: Callable[[], bool]) -> Iterator[threading.Event]:
    """The first interrupt sets the event, the second one, or one ``at_once``, is raised. Others' handlers stay."""
    stop = threading.Event()
    main, usual = threading.current_thread() is threading.main_thread(), signal.getsignal(signal.SIGINT)
    if not main or usual not in (signal.default_int_handler, interrupts.handle) or not callable(usual):
        yield stop
        return

    def handle(number: int, frame: Any) -> None:
        if stop.is_set() or at_once():
            usual(number, frame)
        else:
            stop.set()

    signal.signal(signal.SIGINT, handle)
    try:
        yield stop
    finally:
        signal.signal(signal.SIGINT, usual)
