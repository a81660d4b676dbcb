"""The fuzzer's processes: a case that hangs where no signal reaches it, or that takes its process down, is a fault."""

from __future__ import annotations

import multiprocessing
import os
import resource
import signal
import time
from collections import deque
from collections.abc import Callable, Generator, Iterable
from multiprocessing.connection import Connection, wait
from pathlib import Path

import fuzz_judge
from fuzz_cases import case_of
from fuzz_judge import Verdict, judge

KILLED_AFTER = 60.0
"""Seconds of processor time that a case is given before its process is killed."""
ASLEEP = 1200.0
"""Seconds by the clock, for what hangs without computing."""
ROOM = 3 << 30
"""Bytes that a process may have; what asks for more gets a MemoryError."""
CASES = 400
"""Cases after which a process is replaced by another."""
Task = tuple[int, str | None]


def judged(tasks: Iterable[Task], jobs: int, plant: Callable[[], None] | None = None) -> Generator[Verdict]:
    """The verdicts on cases, by their seeds and classes, as they come. ``plant`` is called first in each process."""
    waiting, workers = deque(tasks), []
    try:
        while waiting or workers:
            while waiting and len(workers) < jobs:
                workers.append(_Worker(plant))
            for worker in [worker for worker in workers if worker.task is None]:
                if not waiting or worker.left == 0:
                    workers.remove(worker)
                    worker.end()
                else:
                    worker.give(waiting.popleft())
            ready = wait([worker.pipe for worker in workers], 0.5)
            for worker in [*workers]:
                verdict = worker.verdict(worker.pipe in ready)
                if verdict is not None:
                    yield verdict
                if worker.dead:
                    workers.remove(worker)
                    worker.end()
    finally:
        for worker in workers:
            worker.end()


class _Worker:
    """A process, and the case that it performs."""

    def __init__(self, plant: Callable[[], None] | None) -> None:
        context = multiprocessing.get_context("fork")
        self.pipe, theirs = context.Pipe()
        self.process = context.Process(target=_work, args=(theirs, plant), daemon=True)
        self.process.start()
        theirs.close()
        self.task: Task | None = None
        self.since, self.used, self.left, self.dead = 0.0, 0.0, CASES, False

    def give(self, task: Task) -> None:
        """Give it a case."""
        self.task, self.since, self.used = task, time.monotonic(), self._seconds()
        self.left -= 1
        self.pipe.send(task)

    def verdict(self, ready: bool) -> Verdict | None:
        """What came of its case, if it is done, hangs, or has died of it."""
        if self.task is None:
            return None
        seed, kind = self.task
        spent = self._seconds() - self.used
        late = spent > KILLED_AFTER and spent > KILLED_AFTER + fuzz_judge.LONGER.get(case_of(seed, kind).kind, 0.0)
        late = late or time.monotonic() - self.since > ASLEEP
        if not ready and not late:
            return None
        made = None
        if ready:
            try:
                made = self.pipe.recv()
            except EOFError:
                self.process.join(10)
        self.task, self.dead = None, made is None
        fault = f"died: {self.process.exitcode}" if ready else f"hangs: over {KILLED_AFTER:g} s"
        return made or Verdict(case_of(seed, kind).kind, seed, faults=[fault])

    def _seconds(self) -> float:
        """The processor time that the process has used; where the system doesn't tell, time by the clock."""
        try:
            fields = Path(f"/proc/{self.process.pid}/stat").read_text().rpartition(")")[2].split()
        except OSError:
            return time.monotonic()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def end(self) -> None:
        """End the process."""
        self.process.kill()
        self.process.join()
        self.pipe.close()


def _work(pipe: Connection, plant: Callable[[], None] | None) -> None:
    """A process: takes seeds, gives verdicts. The parent takes interrupts."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    _, most = resource.getrlimit(resource.RLIMIT_DATA)
    resource.setrlimit(resource.RLIMIT_DATA, (ROOM, most))
    if plant is not None:
        plant()
    while True:
        try:
            seed, kind = pipe.recv()
            pipe.send(judge(case_of(seed, kind)))
        except EOFError:
            return


def patience(seconds: float, killed_after: float) -> None:
    """Other limits of time, for tests."""
    global KILLED_AFTER
    fuzz_judge.PATIENCE, KILLED_AFTER = seconds, killed_after


def imported() -> None:
    """Import all that cases need, once for all processes."""
    from linkwright import app, cli, report, studies  # noqa: F401
    from linkwright.cli import show  # noqa: F401
