"""The compiled twins of the reductions (Numba): one pass, no lock held, the same bits as the plain ones.

No fast-math flag is set: none may fuse or reorder what the plain twin does apart and in order.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar, cast

import numpy as np

from linkwright._machine import needed

numba = needed("numba", "fast")
STRIP = 1 << 13
"""Values of a strip, which is gone through pose by pose while it is in the cache."""
F = TypeVar("F", bound=Callable[..., Any])


def _compiled(function: F) -> F:
    return cast(F, numba.njit(nogil=True, error_model="numpy")(function))


@_compiled
def moments(
    y: Any,
    first: int,
    count: Any,
    missing: Any,
    shift: Any,
    sum_: Any,
    square: Any,
    least: Any,
    least_at: Any,
    most: Any,
    most_at: Any,
) -> None:
    """Count in ``y`` (outputs, samples, poses), in place."""
    outputs, samples, poses = y.shape
    rows = max(STRIP // max(poses, 1), 16)
    for o in range(outputs):
        for start in range(0, samples, rows):
            stop = min(start + rows, samples)
            for j in range(poses):
                n, a, s, q = count[o, j], shift[o, j], sum_[o, j], square[o, j]
                low, low_at, high, high_at = least[o, j], least_at[o, j], most[o, j], most_at[o, j]
                before = n
                for i in range(start, stop):
                    v = y[o, i, j]
                    if abs(v) < np.inf:
                        if n == 0:
                            a = v
                        n += 1
                        d = v - a
                        s += d
                        q += d * d
                        if v < low:
                            low, low_at = v, first + i
                        if v > high:
                            high, high_at = v, first + i
                count[o, j], shift[o, j], sum_[o, j], square[o, j] = n, a, s, q
                missing[o, j] += stop - start - (n - before)
                least[o, j], least_at[o, j], most[o, j], most_at[o, j] = low, low_at, high, high_at


@_compiled
def histogram(y: Any, edges: Any, slots: Any, missing: Any) -> None:
    """Count in ``y`` (outputs, samples, poses), in place; ``edges`` (outputs, edges) bound the slots between them."""
    outputs, samples, poses = y.shape
    last = edges.shape[1] - 1
    for o in range(outputs):
        low, per = edges[o, 0], last / (edges[o, last] - edges[o, 0])
        even = True  # the slot can be reckoned, but for a step or two that rounding takes
        for k in range(last + 1):
            even = even and abs((edges[o, k] - low) * per - k) < 0.5
        for i in range(samples):
            for j in range(poses):
                v = y[o, i, j]
                if not abs(v) < np.inf:
                    missing[o, j] += 1
                    continue
                if even:
                    slot = int(min(max((v - low) * per + 1.0, 0.0), last + 1.0))
                    while slot > 0 and v < edges[o, slot - 1]:
                        slot -= 1
                    while slot <= last and v >= edges[o, slot]:
                        slot += 1
                else:
                    slot = np.searchsorted(edges[o], v, side="right")
                slots[o, slot, j] += 1
