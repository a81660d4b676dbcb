"""Searches for the extremes of figures over a box, all of them a round at a time.

Places are evaluated many at a time, and what is found for one figure serves all. From vertex to vertex by flips; inside
by a pattern search (Hooke and Jeeves, J. ACM 8 (1961) 212-229) that tries all coordinates at once.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import field

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass

Array = NDArray[np.float64]
Evaluate = Callable[[Array], Mapping[str, Array]]
"""Figures by name, (samples,) in SI, NaN where a sample has none, of deviations (contributors, samples)."""

PAIRS = 300
"""The most pairs of coordinates that are flipped together."""
ROUNDS = 100
"""The most rounds of a search."""
FIRST, LAST = 0.25, 1e-4
"""The first and the last step inside, over the width of the box."""


@dataclass
class LocalExtreme:
    """One side of one figure: the largest ``value`` of ``sign`` times its deviation, found ``at`` the deviations
    (contributors,)."""

    name: str
    sign: float
    value: float = -np.inf
    at: Array = field(default_factory=lambda: np.empty(0))


@dataclass
class Climb:
    """A search for an extreme from a place ``at`` (contributors,), with a ``step``, both in shares of the box."""

    extreme: LocalExtreme
    at: Array
    value: float
    step: float = FIRST


class DeviationBox:
    """The box ``low`` .. ``low + width`` (contributors,) of deviations. Places in it are given in shares of it,
    (contributors, places). ``nominal`` are the figures' values at no deviation.

    ``extremes`` are what was found so far, least and largest of each figure; of ``looked`` places so many are ``lost``
    to a figure.
    """

    def __init__(self, evaluate: Evaluate, low: Array, width: Array, nominal: Mapping[str, float]) -> None:
        self.evaluate, self.low, self.width, self.nominal = evaluate, low, width, nominal
        self.free = np.flatnonzero(width > 0)
        self.extremes = {name: (LocalExtreme(name, -1.0), LocalExtreme(name, 1.0)) for name in nominal}
        self.looked, self.lost = 0, dict.fromkeys(nominal, 0)

    def look(self, places: Array) -> dict[str, Array]:
        """Evaluate some places; extremes take what is better."""
        deviations = self.low[:, None] + self.width[:, None] * places
        found = {name: np.asarray(row) for name, row in self.evaluate(deviations).items() if name in self.nominal}
        self.looked += places.shape[1]
        for name, row in found.items():
            self.lost[name] += int(np.count_nonzero(~np.isfinite(row)))
            for extreme in self.extremes[name]:
                value = self.value(extreme, row)
                k = int(value.argmax())
                if value[k] > extreme.value:
                    extreme.value, extreme.at = float(value[k]), deviations[:, k]
        return found

    def value(self, extreme: LocalExtreme, row: Array) -> Array:
        """What an extreme wants to be large, of values of its figure."""
        known = extreme.sign * (row - self.nominal[extreme.name])
        return np.where(np.isfinite(known), known, -np.inf)

    def best(
        self, wanted: Sequence[LocalExtreme], places: Array, found: Mapping[str, Array], count: int
    ) -> Iterator[Climb]:
        """Searches from the best places for each extreme that is wanted."""
        for extreme in wanted:
            value = self.value(extreme, found[extreme.name])
            for k in np.argsort(-value, kind="stable")[:count].tolist():
                if value[k] > -np.inf:
                    yield Climb(extreme, places[:, k], float(value[k]))

    def flipped(self, climbs: Sequence[Climb]) -> list[Climb]:
        """From vertex to vertex, by the flip of a coordinate that helps most; where none does, of two."""
        eye = np.eye(self.low.size, dtype=bool)[:, self.free]
        i, j = np.triu_indices(self.free.size, 1)
        pairs = eye[:, i] | eye[:, j] if i.size <= PAIRS else eye[:, :0]
        flips, alive = dict.fromkeys(range(len(climbs)), 0), [*range(len(climbs))]
        for _ in range(ROUNDS):
            if not alive:
                break
            tried = [np.where((eye, pairs)[flips[k]], 1 - climbs[k].at[:, None], climbs[k].at[:, None]) for k in alive]
            better = self.move_searches([climbs[k] for k in alive], tried)
            for k, helped in zip(alive, better, strict=True):
                flips[k] = 0 if helped else flips[k] + 1
            alive = [k for k in alive if flips[k] < 2]
        return [*climbs]

    def climb(self, climbs: Sequence[Climb]) -> None:
        """Inside the box, by steps along each coordinate, then along all that helped; smaller ones where none did."""
        directions = np.eye(self.low.size)[:, self.free]
        directions = np.concatenate([directions, -directions], axis=1)
        for _ in range(ROUNDS):
            alive = {(id(one.extreme), one.at.tobytes()): one for one in climbs if one.step >= LAST}
            climbs = [*alive.values()]  # of those at the same place one
            if not climbs:
                break
            before = [(one.at, one.value) for one in climbs]
            tried = [np.clip(one.at[:, None] + one.step * directions, 0, 1) for one in climbs]
            rows = self.rows(climbs, tried)
            along = []
            for one, places, values, (at, value) in zip(climbs, tried, rows, before, strict=True):
                gain = np.where(np.isfinite(values), np.maximum(values - value, 0.0), 0.0)
                moves = (places - at[:, None]) * (gain > 0)
                slope = moves * (gain / max(float(gain.max()), 1e-300))
                along.append(np.clip(at[:, None] + np.stack([moves.sum(axis=1), slope.sum(axis=1)], axis=1), 0, 1))
                self.move_to_best(one, places, values)
            for one, (_, value), places, values in zip(climbs, before, along, self.rows(climbs, along), strict=True):
                self.move_to_best(one, places, values)
                if not one.value > value:
                    one.step /= 4

    def move_searches(self, climbs: Sequence[Climb], tried: Sequence[Array]) -> list[bool]:
        """Whether each search is helped by one of the places that it tries; it goes to the best."""
        found = zip(climbs, tried, self.rows(climbs, tried), strict=True)
        return [self.move_to_best(one, places, values) for one, places, values in found]

    def rows(self, climbs: Sequence[Climb], tried: Sequence[Array]) -> list[Array]:
        """What each search wants to be large, at the places that it tries; all are evaluated together."""
        found = self.look(np.concatenate(tried, axis=1))
        ends = np.cumsum([places.shape[1] for places in tried])
        cut = {name: np.split(row, ends[:-1]) for name, row in found.items()}
        return [self.value(one.extreme, cut[one.extreme.name][k]) for k, one in enumerate(climbs)]

    def move_to_best(self, climb: Climb, places: Array, values: Array) -> bool:
        """Go to the best of some places if it's better."""
        k = int(values.argmax()) if values.size else -1
        if k < 0 or not values[k] > climb.value:
            return False
        climb.at, climb.value = places[:, k], float(values[k])
        return True
