"""The values of a block divided: where each is computed, in which of several functions, and what passes between them.

Emitters that write code write functions of limited length, as compilers' time grows faster than it. What passes from
one function to the next lies in numbered rows (of values of poses) and scalars (of a sample).
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Mapping
from dataclasses import field

from linkwright.data_classes import dataclass
from linkwright.kernels.listing import Listing, P, Value, X
from linkwright.kernels.straight_line import Code, whole_power, written

SCALAR, SHARED, OWN = "scalar", "shared", "own"
FORMS = {
    "apart": {0: SCALAR, X: OWN, P: SCALAR, X | P: OWN},
    "each": {0: SCALAR, X: OWN, P: OWN, X | P: OWN},
    "over": {0: SCALAR, X: SHARED, P: SCALAR, X | P: OWN},
}
"""Where a value is computed, by what it depends on: once a sample; for each pose, once for all samples; for both.

apart: inputs of each sample and pose, parameters of each sample; each: both of each pose; over: inputs of each pose,
parameters of each sample."""
ORDER = (SCALAR, SHARED, OWN)
"""The places in the order in which they are computed."""
Key = tuple[str, int] | tuple[str, str, int]
At = tuple[str, int]
"""A function of a block: its place, and its number there."""


@dataclass
class Rows:
    """Numbered places of rows or scalars; those given back are used again."""

    places: dict[Key, int] = field(default_factory=dict)
    free: list[int] = field(default_factory=list)
    count: int = 0

    def __getitem__(self, key: Key) -> int:
        if key not in self.places:
            if not self.free:
                self.free.append(self.count)
                self.count += 1
            self.places[key] = self.free.pop()
        return self.places[key]

    def run(self, keys: Iterable[Key]) -> int:
        """New places for some keys, side by side; the first of them."""
        first = self.count
        for key in keys:
            self.places[key], self.count = self.count, self.count + 1
        return first

    def release(self, key: Key) -> None:
        self.free.append(self.places.pop(key))


class Division:
    """A listing's values by the ``places`` of a form, in functions (``chunks``) of at most ``longest`` values.

    Inputs and constants are computed nowhere, but for parameters that are scalars.
    """

    def __init__(self, listing: Listing, form: Mapping[int, str], longest: int) -> None:
        self.listing = listing
        self.places = [form[needs] for needs in listing.needs]
        self.chunks: dict[str, list[list[int]]] = {place: [] for place in ORDER}
        self._chunk_of: dict[int, At] = {}
        for i, value in enumerate(listing.values):
            if value.source is None if self.places[i] != SCALAR else not value.constant:
                chunks = self.chunks[self.places[i]]
                if not chunks or len(chunks[-1]) >= longest:
                    chunks.append([])
                chunks[-1].append(i)
                self._chunk_of[i] = self.places[i], len(chunks) - 1
        # Outputs that are inputs, constants or scalars are written in a chunk of their place.
        self._writes: dict[At, list[tuple[int, int]]] = {}
        for k, i in enumerate(listing.outputs):
            place = OWN if self.places[i] == SCALAR else self.places[i]
            if not self.chunks[place]:
                self.chunks[place].append([])
            at = self._chunk_of.get(i, (place, 0))
            self._writes.setdefault(at if at[0] == place else (place, 0), []).append((k, i))
        self._users = defaultdict[int, set[At]](set)
        for i, at in self._chunk_of.items():
            for arg in listing.values[i].args:
                self._users[arg].add(at)
        for at, outputs in self._writes.items():
            for _, i in outputs:
                self._users[i].add(at)
        in_order = [(place, n) for place in ORDER for n in range(len(self.chunks[place]))]
        nth = {at: n for n, at in enumerate(in_order)}
        self._last = {i: in_order[max(map(nth.__getitem__, users))] for i, users in self._users.items()}

    def passed_on(self, i: int, at: At) -> bool:
        """Whether another function than ``at`` uses a value."""
        return i in self._users and self._users[i] != {at}

    def outputs(self, at: At) -> dict[int, list[int]]:
        """The values that a function writes as outputs, and the numbers of these."""
        found: dict[int, list[int]] = {}
        for k, i in self._writes.get(at, []):
            found.setdefault(i, []).append(k)
        return found

    def last_used(self, at: At) -> list[int]:
        """The values that no function after ``at`` uses."""
        return [i for i, last in self._last.items() if last == at]

    def computed(self, code: Code, value: Value, known: Callable[[int], str]) -> str:
        """Write a value's operation; ``known`` gives its operands."""
        name, taken = value.op, [known(i) for i in value.args]
        if name == "power" and (power := _whole_power(self.listing.values[value.args[1]])):
            return whole_power(code, taken[0], power)
        return written(code, name, taken)


def _whole_power(value: Value) -> int:
    """A whole power of few factors; 0 for another."""
    return int(value.number) if value.constant and value.number.is_integer() and 0 < value.number <= 32 else 0
