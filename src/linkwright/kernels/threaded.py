"""One kernel over many poses on several threads: each takes a stretch of the poses."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from functools import cache

import numpy as np
from numpy.typing import NDArray

from linkwright._machine import processors
from linkwright.kernels.registry import Kernel

Array = NDArray[np.float64]

FEWEST = 1 << 13
"""Fewer poses than this a thread cost more than they spare."""
EVEN = 64
"""Stretches begin at multiples of so many poses, so that rows stay aligned."""


@cache
def pool(workers: int) -> ThreadPoolExecutor:
    """Threads that are kept."""
    return ThreadPoolExecutor(workers, thread_name_prefix="linkwright")


def stretches(poses: int, workers: int) -> list[slice]:
    """Equal stretches of the poses, one for each worker that is worth it."""
    count = max(1, min(workers, poses // FEWEST))
    step = -(-poses // count // EVEN) * EVEN if count > 1 else max(poses, 1)
    return [slice(start, min(start + step, poses)) for start in range(0, poses, step)]


def spread(kernel: Kernel, x: Array, p: Array, out: Array | None = None, workers: int = 0) -> Array:
    """``kernel.run`` over inputs x (inputs, poses) on ``workers`` threads (0: as many as are of use to the kernel).

    The figures are those of one thread, to the last bit.
    """
    poses = x.shape[1]
    if out is None:
        out = np.empty((len(kernel.program.outputs), poses))
    parts = stretches(poses, workers or (processors() if kernel.scales else 1))

    def run_part(part: slice) -> None:
        kernel.run(x[:, part], p if p.ndim == 1 else p[:, part], out[:, part])

    if len(parts) == 1:
        run_part(parts[0])
    else:
        list(pool(len(parts)).map(run_part, parts))
    return out
