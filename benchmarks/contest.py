"""Ways of computing the same thing, timed in turns: machines are noisy, so that ratios are taken round by round."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from linkwright.kernels import KERNELS, Compiled, Kernel
from linkwright.kernels.threaded import spread

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

    def ratios(self, other: Way) -> list[float]:
        """How many times longer a pose takes than in another way, round by round."""
        return [a / b for a, b in zip(self.each(), other.each(), strict=True)]


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


def kernels(skipped: list[str]) -> Iterator[type[Kernel]]:
    """Every kernel whose packages are installed; the others are noted."""
    for name in KERNELS:
        if KERNELS[name].available():
            yield KERNELS[name]
        else:
            skipped.append(f"kernel {name}: its package isn't installed")


def linkwright_ways(
    compiled: Compiled, names: Sequence[str], t: Array, samples: Array, skipped: list[str]
) -> Iterator[Way]:
    """Every kernel over the times ``t`` (s) on one and two threads, its outputs at the times ``samples``.

    The inputs are ready and ``out`` is there; the last way of each kernel goes from times to new arrays.
    """
    program, p = compiled.graph.program(names), compiled.parameters
    x, few, out = compiled.inputs(t), compiled.inputs(samples), np.empty((len(names), t.size))
    for kind in kernels(skipped):
        kernel = kind(program)
        for threads in (1, 2):

            def ready(kernel: Kernel = kernel, threads: int = threads) -> tuple[float, Array]:
                return timed(lambda: spread(kernel, x, p, out, threads)), kernel.run(few, p)

            yield Way("linkwright", f"{kernel.name}, {threads} thread{'s' * (threads > 1)}", t.size, ready)

        def whole(kernel: Kernel = kernel) -> tuple[float, Array]:
            return timed(lambda: spread(kernel, compiled.inputs(t), p, workers=2)), kernel.run(few, p)

        yield Way("linkwright", f"{kernel.name}, 2 threads, from times to new arrays", t.size, whole)
