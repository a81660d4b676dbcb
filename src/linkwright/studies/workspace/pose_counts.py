"""The curves of a mode held against the number of poses: it jumps across each as it must, and nowhere else.

Across an image of the singular curve two poses meet and end; where two modes meet, and at an end of a drive's range,
one pose of the mode ends. What doesn't fit tells of a curve that is missing, or of one that isn't there.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.studies.workspace.curves import Segments
from linkwright.studies.workspace.places import FOLD, LIMIT, MODES, ModePlaces
from linkwright.studies.workspace.sheet import ModeSheet

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

JUMPS = {FOLD: 2, MODES: 1, LIMIT: 1}
"""By so much the number of poses jumps across a curve; across the images of undefined poses by any number."""
ASIDE, ALONE = 4.0, 12.0
"""The poses are counted so many chords beside the middle of a piece, if no other is within so many ..."""
LONG = 64.0
"""... and the piece is longer than so many."""
BLURRED = 0.1
"""A function that changes by more than this share within half the way aside may have a zero that near."""
LATTICE, WIDER = 200, (0.0123, 0.0171)
"""They are also counted on a lattice of so many places a side, wider than the curves by these shares."""
MARGIN = 2.0
"""A way from one place of the lattice to the next passes a curve that is within so many chords."""


@dataclass(frozen=True)
class Contradiction:
    """The ``length`` (m) of curves over which the number of poses doesn't fit them, and a place (m)."""

    length: float
    at: tuple[float, float]


@dataclass(frozen=True, eq=False)
class DrivePaths:
    """The pieces of curves as they are drawn: ends (2, n) both, the ``drives`` (end, drive, n) there, the ``kind`` of
    each, and whether it is ``exact``, drawn to the chord tolerance."""

    a: Array
    b: Array
    drives: Array
    kind: NDArray[np.str_]
    exact: Mask

    @classmethod
    def of(cls, sheet: ModeSheet, segments: Sequence[Segments]) -> DrivePaths:
        """The paths of curves in the drives' plane, but for pieces an end of which has no place."""
        if not segments:
            none = np.empty((2, 0))
            return cls(none, none, np.empty((2, 2, 0)), np.empty(0, dtype=str), np.empty(0, dtype=bool))
        drives = np.concatenate([np.stack([one.a, one.b]) for one in segments], axis=2)
        a, b = sheet.place(drives.transpose(1, 0, 2).reshape(2, -1))[0].reshape(2, 2, -1).transpose(1, 0, 2)
        kind = np.concatenate([np.full(one.off.size, one.kind) for one in segments])
        exact = np.concatenate([one.off == 0 for one in segments])
        known = np.isfinite(a).all(axis=0) & np.isfinite(b).all(axis=0)
        return cls(a[:, known], b[:, known], drives[:, :, known], kind[known], exact[known])

    @cached_property
    def _tree(self) -> Any:
        import shapely

        return shapely.STRtree(shapely.linestrings(np.stack([self.a, self.b]).transpose(2, 0, 1)))

    def near(self, lines: Any, distance: float) -> NDArray[np.int_]:
        """Pairs (2, pairs): which of some lines or points, and which piece within a distance of it."""
        return np.asarray(self._tree.query(lines, predicate="dwithin", distance=distance))

    def count(self, lines: Any, distance: float) -> NDArray[np.int_]:
        """How many pieces are within a distance of each of some lines or points."""
        return np.bincount(self.near(lines, distance)[0], minlength=len(lines))


def contradiction(places: ModePlaces, paths: DrivePaths, chord: float) -> Contradiction | None:
    """Where the number of poses contradicts the curves, if over more than a step of the lattice: on less, curves that
    touch each other are drawn as one."""
    if not paths.kind.size:
        return None
    low, high = np.minimum(paths.a, paths.b).min(axis=1), np.maximum(paths.a, paths.b).max(axis=1)
    step = float((high - low).max()) / LATTICE
    across, length = _across(places, paths, chord)
    between = _between(places, paths, low, high, chord)
    over = float(length.sum()) + step * between.shape[1]
    if over < step:
        return None
    # A missing curve spoils the jumps of those it runs beside, so it comes first.
    x, y = np.concatenate([between, across[:, np.argsort(-length)]], axis=1)[:, 0].tolist()
    return Contradiction(over, (x, y))


def _across(places: ModePlaces, paths: DrivePaths, chord: float) -> tuple[Array, Array]:
    """Middles of pieces across which the number doesn't jump as it must, (2, n), and their lengths (m)."""
    import shapely

    way = paths.b - paths.a
    length = np.hypot(*way)
    some = np.flatnonzero(paths.exact & np.isin(paths.kind, list(JUMPS)) & (length > LONG * chord))
    middle = (paths.a + paths.b)[:, some] / 2
    alone = paths.count(shapely.points(middle.T), ALONE * chord) == 1
    some, middle = some[alone], middle[:, alone]
    aside = ASIDE * chord * np.stack([-way[1], way[0]])[:, some] / length[some]
    left, right = places.count(np.concatenate([middle + aside, middle - aside], axis=1)).reshape(2, -1)
    expected = np.array([JUMPS[kind] for kind in paths.kind[some].tolist()], dtype=int)
    wrong = np.abs(left - right) != expected
    wrong[wrong] = ~_blurred(places, middle[:, wrong], aside[:, wrong], paths.kind[some[wrong]])
    return middle[:, wrong], length[some[wrong]]


def _blurred(places: ModePlaces, middle: Array, aside: Array, kind: NDArray[np.str_]) -> Mask:
    """Beside which pieces, by their middles, another kind of curve is too near to be told from them: some function of
    its changes within half the way aside by much of its value."""
    found = np.zeros(kind.size, dtype=bool)
    others = np.array(places.kinds)[:, None] != kind
    for way in (aside, -aside):
        far, near = (places.functions(middle + share * way) for share in (1.0, 0.5))
        found |= ((np.abs(far - near) > BLURRED * np.abs(far)) & others).any(axis=(0, 1))
    return found


def _between(places: ModePlaces, paths: DrivePaths, low: Array, high: Array, chord: float) -> Array:
    """Middles of the ways between neighbours on a lattice that pass no curve though the number changes: (2, n)."""
    import shapely

    share = np.linspace(-WIDER[0], 1 + WIDER[1], LATTICE)
    lattice = np.stack(np.meshgrid(*(low[:, None] + (high - low)[:, None] * share)))
    count = places.count(lattice.reshape(2, -1)).reshape(LATTICE, LATTICE)
    found = []
    for axis in (0, 1):
        rows, columns = np.nonzero(np.diff(count, axis=axis))
        ends = np.stack([lattice[:, rows, columns], lattice[:, rows + (axis == 0), columns + (axis == 1)]])
        passed = paths.count(shapely.linestrings(ends.transpose(2, 0, 1)), MARGIN * chord) > 0
        found.append(ends.mean(axis=0)[:, ~passed])
    return np.concatenate(found, axis=1)
