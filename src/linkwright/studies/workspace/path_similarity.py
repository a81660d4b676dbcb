"""Whether two meshes have found the same curves, so that a finer one will find no others."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from linkwright.studies.workspace.curves import Traced

Array = NDArray[np.float64]

KINDS = ("singular", "modes")
"""The curves that a mesh may miss."""
MEET = 1e-7
"""Ends of pieces that are nearer than so many steps are one."""
BESIDE = 1.5
"""An end on one mesh has one of the other within so many steps of the finer: a piece of the coarser has up to 2.83."""


def alike(coarse: Traced, fine: Traced, step: Array) -> bool:
    """Whether there are as many curves that hang together, each nowhere far from one of the other mesh; ``step`` (2,)
    is the finer mesh's."""
    for kind in KINDS:
        some, others = (np.stack(pieces[kind]).transpose(2, 0, 1).reshape(-1, 2) / step for pieces in (coarse, fine))
        if not (_count(some) == _count(others) and _near(some, others) and _near(others, some)):
            return False
    return True


def _count(ends: Array) -> int:
    """How many of the curves that pieces make have no end in common; both ends of each follow each other."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    if not ends.size:
        return 0
    places = np.round(ends / MEET)
    order = np.lexsort(places.T)
    new = (places[order[1:]] != places[order[:-1]]).any(axis=1)
    number = np.empty(order.size, dtype=int)
    number[order] = np.concatenate([[0], new.cumsum()])
    first, last = number.reshape(-1, 2).T
    joined = coo_array((np.ones(first.size), (first, last)), shape=(number.max() + 1,) * 2)
    return int(connected_components(joined, directed=False)[0])


def _near(some: Array, others: Array) -> bool:
    """Whether all ends have one of the others nearby."""
    from scipy.spatial import cKDTree

    if not some.size or not others.size:
        return some.size == others.size
    return bool((cKDTree(others).query(some)[0] <= BESIDE).all())
