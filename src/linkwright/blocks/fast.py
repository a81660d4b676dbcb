"""The compiled twins of the reductions (Numba): one pass, no lock held, the same bits as the plain ones.

No fast-math flag is set: none may fuse or reorder what the plain twin does apart and in order.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar, cast

import numpy as np

from linkwright.blocks.packages import needed

numba = needed("numba", "fast")
F = TypeVar("F", bound=Callable[..., Any])


def _compiled(function: F) -> F:
    return cast(F, numba.njit(nogil=True, error_model="numpy")(function))


# Each of these loops touches few arrays: with more, LLVM gives up proving that they don't overlap, and vectorising.


@_compiled
def _sums(v: Any, shift: Any, sum_: Any, square: Any, count: Any) -> None:
    for j in range(v.size):
        d = v[j] - shift[j] if abs(v[j]) < np.inf else 0.0
        sum_[j] += d
        square[j] += d * d
    for j in range(v.size):
        count[j] += 1 if abs(v[j]) < np.inf else 0


@_compiled
def _extremes(v: Any, at: int, least: Any, least_at: Any, most: Any, most_at: Any) -> None:
    for j in range(v.size):
        low = v[j] if abs(v[j]) < np.inf else np.inf
        least_at[j] = at if low < least[j] else least_at[j]
        least[j] = low if low < least[j] else least[j]
    for j in range(v.size):
        high = v[j] if abs(v[j]) < np.inf else -np.inf
        most_at[j] = at if high > most[j] else most_at[j]
        most[j] = high if high > most[j] else most[j]


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
    for o in range(outputs):
        for j in range(poses):
            missing[o, j] += samples + count[o, j]
            if count[o, j] == 0:
                for i in range(samples):
                    if abs(y[o, i, j]) < np.inf:
                        shift[o, j] = y[o, i, j]
                        break
        for i in range(samples):
            _sums(y[o, i], shift[o], sum_[o], square[o], count[o])
            _extremes(y[o, i], first + i, least[o], least_at[o], most[o], most_at[o])
        for j in range(poses):
            missing[o, j] -= count[o, j]


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
