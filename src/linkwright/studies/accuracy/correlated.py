"""Correlations that a file states, as one matrix: each entry and the whole must be a correlation matrix."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.unknown import near
from linkwright.findings import Finding, Joined
from linkwright.studies.accuracy.stated_options import Correlation

Array = NDArray[np.float64]
PATH = ("studies", "accuracy", "correlations")

ROUND = 1e-9
"""What is left of a number that a file states with rounding: by so much a matrix may miss symmetry, its eigenvalues
zero."""


def matrix(names: Sequence[str], stated: Sequence[Correlation]) -> Array:
    """The coefficients of all named deviations; pairs of which nothing is said are independent."""
    whole = np.eye(len(names))
    for entry in stated:
        at = [names.index(name) for name in entry.of]
        whole[np.ix_(at, at)] = _block(entry)
    return whole


def _block(entry: Correlation) -> Array:
    n = len(entry.of)
    if isinstance(entry.is_, tuple):
        return np.array(entry.is_)
    return np.where(np.eye(n, dtype=bool), 1.0, entry.is_)


def check(names: Sequence[str], stated: Sequence[Correlation]) -> Iterator[Finding]:
    """What is wrong with the entries; of the whole where each is right."""
    seen: dict[frozenset[str], int] = {}
    sound = True
    for i, entry in enumerate(stated):
        path = (*PATH, i)
        for finding in (*_names(names, entry, i), *_matrix(entry, i)):
            sound = False
            yield finding
        pairs = [frozenset((a, b)) for k, a in enumerate(entry.of) for b in entry.of[:k] if a != b]
        for pair in dict.fromkeys(pairs):
            if pair in seen and seen[pair] != i:
                sound = False
                yield Finding("tolerance.correlation-pair", path, {"names": Joined(sorted(pair))})
            seen.setdefault(pair, i)
    if sound and len(stated) > 1 and (least := _least(matrix(names, stated))) < -ROUND * len(names):
        yield Finding("tolerance.correlation-indefinite", PATH, {"least": f"{least:.3g}"})


def _names(names: Sequence[str], entry: Correlation, i: int) -> Iterator[Finding]:
    for k, name in enumerate(entry.of):
        if name not in names:
            data = {"name": name[:60], "near": near(name, [*names])}
            yield Finding("tolerance.no-contributor", (*PATH, i, "of", k), data)
        elif name in entry.of[:k]:
            yield Finding("tolerance.correlation-twice", (*PATH, i, "of", k), {"name": name})


def _matrix(entry: Correlation, i: int) -> Iterator[Finding]:
    path, n = (*PATH, i, "is"), len(entry.of)
    if isinstance(entry.is_, tuple) and [len(row) for row in entry.is_] != [n] * n:
        yield Finding("tolerance.correlation-shape", path, {"count": n})
        return
    block, count = _block(entry), 0
    if (np.abs(block) > 1).any():
        count += 1
        worst = block.flat[np.abs(block).argmax()]
        yield Finding("tolerance.correlation-range", path, {"value": f"{worst:.6g}"})
    if (np.diag(block) != 1).any():
        count += 1
        yield Finding("tolerance.correlation-diagonal", path)
    if (np.abs(block - block.T) > ROUND).any():
        count += 1
        yield Finding("tolerance.correlation-symmetry", path)
    if not count and (least := _least(block)) < -ROUND * n:
        yield Finding("tolerance.correlation-indefinite", path, {"least": f"{least:.3g}"})


def _least(block: Array) -> float:
    return float(np.linalg.eigvalsh(block).min())
