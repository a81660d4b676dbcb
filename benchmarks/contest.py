"""Ways of computing the same thing, timed in turns: machines are noisy, so that ratios are taken round by round."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.graph.program import Program
from linkwright.kernels import KERNELS
from linkwright.model.findings import ModelError

Array = NDArray[np.float64]


@dataclass
class Way:
    """One way: ``run`` computes ``poses`` poses and gives the seconds it took, and its outputs at the samples."""

    engine: str
    how: str
    poses: int
    run: Callable[[], tuple[float, Array]]
    steps: int | None = None  # of a turn, where poses follow from those before them
    seconds: list[float] = field(default_factory=list)
    found: Array | None = None

    def each(self) -> list[float]:
        """Seconds a pose, round by round."""
        return [seconds / self.poses for seconds in self.seconds]

    def ns(self) -> float:
        """The median time of a pose (ns)."""
        return 1e9 * statistics.median(self.each())

    def ratio(self, other: Way) -> float:
        """How many times longer a pose takes than in another way: the median of the rounds."""
        return statistics.median(a / b for a, b in zip(self.each(), other.each(), strict=True))


def contest(ways: Sequence[Way], rounds: int) -> None:
    """Time all ways, one after the other in every round; the first is to warm up."""
    for k in range(rounds + 1):
        for way in ways:
            seconds, way.found = way.run()
            if k:
                way.seconds.append(seconds)


def timed(action: Callable[[], object]) -> float:
    """The seconds that an action takes."""
    start = time.perf_counter()
    action()
    return time.perf_counter() - start


class Threads:
    """A kernel over the pose axis in equal parts, a thread and a kernel of its own for each.

    Kernels may keep work space between calls, so that threads don't share one.
    """

    def __init__(self, kernel: str, program: Program, threads: int) -> None:
        self.kernels = [KERNELS[kernel](program) for _ in range(threads)]
        self.pool = ThreadPoolExecutor(threads) if threads > 1 else None

    def run(self, x: Array, p: Array, out: Array) -> Array:
        """All outputs (outputs, poses), written into ``out``."""
        if self.pool is None:
            return self.kernels[0].run(x, p, out)
        bounds = np.linspace(0, x.shape[1], len(self.kernels) + 1).astype(int)
        parts = [
            self.pool.submit(kernel.run, x[:, a:b], p, out[:, a:b])
            for kernel, (a, b) in zip(self.kernels, pairwise(bounds), strict=True)
        ]
        for part in parts:
            part.result()
        return out


def linkwright_ways(
    compiled: Any, names: Sequence[str], t: Array, samples: Array, skipped: list[str], threads: Sequence[int] = (1, 2)
) -> Iterator[Way]:
    """Every kernel that is here over the times ``t`` (s), its outputs at the times ``samples``.

    The inputs are ready and ``out`` is there; the last way of each kernel goes from times to fresh outputs.
    """
    program, p = compiled.graph.program(names), compiled.parameters
    x, few, out = compiled.inputs(t), compiled.inputs(samples), np.empty((len(names), t.size))
    for name in KERNELS:
        try:
            spreads = {n: Threads(name, program, n) for n in threads}
            spreads[threads[0]].run(few, p, np.empty((len(names), samples.size)))
        except (ImportError, ModelError) as error:
            skipped.append(f"kernel {name}: {error}")
            continue

        def run(spread: Threads) -> tuple[float, Array]:
            return timed(lambda: spread.run(x, p, out)), spread.run(few, p, np.empty((len(names), samples.size)))

        def whole(spread: Threads) -> tuple[float, Array]:
            return timed(lambda: spread.run(compiled.inputs(t), p, np.empty_like(out))), run(spread)[1]

        for n, spread in spreads.items():
            yield Way("linkwright", f"{name}, {n} thread{'s' * (n > 1)}", t.size, lambda s=spread: run(s))
        yield Way("linkwright", f"{name}, {n} threads, from times to new arrays", t.size, lambda s=spread: whole(s))
