"""The Dask runner: blocks go to the workers of a cluster, results come back to this process.

The work itself is a result of the cluster too: it is sent once, each worker gets it from there, and where the only
worker that has it dies it is made again. What a dying worker had in hand Dask hands to another one.
"""

from __future__ import annotations

import logging
import time
from collections import deque
from collections.abc import Callable, Generator, Iterator
from concurrent.futures import ThreadPoolExecutor
from itertools import takewhile
from threading import Event
from typing import Any
from uuid import uuid4

from linkwright._machine import needed
from linkwright.blocks.runners import AHEAD, LOOK, Results, blocks, opened, register
from linkwright.blocks.work import Arrays, Task, Work
from linkwright.findings import Finding, ModelError

PATIENCE = 10.0
"""Seconds in which a scheduler must answer."""
RECOUNT = 2.0
"""Seconds after which the workers are counted anew."""
IDLE = 60.0
"""Seconds without any worker after which a study gives up."""


@register
class Cluster:
    """The workers of a Dask cluster, by the address of its scheduler, such as ``tcp://host:8786``."""

    name = "cluster"
    grain = 1 << 23

    def __init__(self, address: str) -> None:
        self.address = address
        self._client: Any = None
        self._workers, self._counted, self._seen = 0, -RECOUNT, time.monotonic()

    @property
    def client(self) -> Any:
        """The connection, opened when it is first wanted."""
        if self._client is None:
            distributed = needed("distributed", "cluster")
            import asyncio

            try:
                with ThreadPoolExecutor(1) as pool:  # whoever calls may have a loop of his own at work
                    pool.submit(asyncio.run, _asked(self.address)).result()
                self._client = distributed.Client(self.address, timeout=PATIENCE, set_as_default=False)
            except (OSError, ValueError) as error:
                data = {"address": self.address, "reason": str(error) or type(error).__name__}
                raise ModelError([Finding("blocks.cluster-unreachable", (), data)]) from None
        return self._client

    @property
    def workers(self) -> int:
        """The threads of all workers; 1 while there is none yet."""
        self._count()
        return max(self._workers, 1)

    def _count(self) -> None:
        """Count the workers' threads anew every few seconds; none for long is a finding."""
        now = time.monotonic()
        if now < self._counted + RECOUNT:
            return
        client = self.client
        try:
            self._workers, self._counted = sum(client.nthreads().values()), now
        except OSError:
            raise self._connection_error() from None
        if self._workers:
            self._seen = now
        elif now > self._seen + IDLE:
            raise ModelError([Finding("blocks.cluster-idle", (), {"address": self.address, "seconds": f"{IDLE:.0f}"})])

    def results(
        self, work: Work, task: Task, atoms: range, block: int, stop: Callable[[], bool]
    ) -> Generator[tuple[int, Arrays], None, None]:
        """Each atom with its result, in order."""
        client = self.client
        token = uuid4().hex
        handle = client.submit(_same, work, key=f"linkwright-work-{token}")
        rest = blocks(atoms, block)
        news = Event()
        window: deque[tuple[range, Any]] = deque()
        try:
            while True:
                for some in _next(rest, 0 if stop() else AHEAD * self.workers - len(window)):
                    key = f"linkwright-block-{token}-{some[0]}"
                    window.append((some, client.submit(_perform, handle, list(some), key=key)))
                    window[-1][1].add_done_callback(lambda _: news.set())
                if not window:
                    return
                while not window[0][1].done() and client.status == "running":
                    if stop():
                        return
                    self._count()
                    news.wait(LOOK)
                    news.clear()
                yield from self._gathered(window)
        finally:
            _forget(client, [handle, *(future for _, future in window)])

    def _gathered(self, window: deque[tuple[range, Any]]) -> Results:
        """The results of the first blocks, as far as they are finished; raises the fault of the very first one."""
        distributed = needed("distributed", "cluster")
        some, first = window[0]
        if self._client.status != "running" or first.status in ("cancelled", "lost"):
            raise self._connection_error()
        futures = (future for _, future in window)
        ready = list(takewhile(lambda future: future.status == "finished", futures)) or [first]
        try:
            gathered: list[Results] = self._client.gather(ready)
        except distributed.KilledWorker:
            raise ModelError([Finding("blocks.workers-died", (), {"first": some[0], "last": some[-1]})]) from None
        except (distributed.CancelledError, distributed.comm.CommClosedError):
            raise self._connection_error() from None
        for _ in ready:
            window.popleft()
        return [one for results in gathered for one in results]

    def _connection_error(self) -> ModelError:
        self.close()
        return ModelError([Finding("blocks.cluster-lost", (), {"address": self.address})])

    def close(self) -> None:
        """Close the connection; the cluster stays."""
        if self._client is None:
            return
        log = logging.getLogger("distributed.client")
        level = log.level
        if self._client.status != "running":
            log.setLevel(logging.CRITICAL)  # it would log the end of its attempts to connect as a traceback
        try:
            self._client.close(timeout=1)
        finally:
            log.setLevel(level)
            self._client = None


async def _asked(address: str) -> None:
    """See whether a scheduler answers: a client that got no answer can't be closed safely, so none is made."""
    distributed = needed("distributed", "cluster")
    options = distributed.Security().get_connection_args("client")
    comm = await distributed.comm.connect(address, timeout=PATIENCE, **options)
    await comm.close()


def _same(work: Work) -> Work:
    return work


def _perform(work: Work, atoms: list[int]) -> Results:
    task = opened(work)
    return [(atom, task.perform(atom)) for atom in atoms]


def _next(rest: Iterator[range], count: int) -> Iterator[range]:
    while count > 0 and (some := next(rest, None)) is not None:
        count -= 1
        yield some


def _forget(client: Any, futures: list[Any]) -> None:
    """Take back what nobody waits for any more; a cluster that is gone has nothing to take back."""
    if client.status == "running":
        client.cancel(futures, force=True)
    for future in futures:
        future.release()
