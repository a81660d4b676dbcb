"""What can be carried in blocks: works, their tasks, where results go, and the fixed cut into atoms."""

from __future__ import annotations

from functools import cached_property
from typing import Any, Protocol

from numpy.typing import NDArray

from linkwright.data_classes import dataclass

Arrays = dict[str, NDArray[Any]]

UNIT = 4096
"""Samples of a unit: what has a random stream of its own, and over which sums run before they are folded."""

SMALLEST, LARGEST, ENOUGH = 1 << 17, 1 << 20, 64
"""Poses of an atom, between which the cut looks for some ``ENOUGH`` atoms."""


class Task(Protocol):
    """A work made ready in one process."""

    @property
    def atoms(self) -> int:
        """How many atoms there are."""

    def poses(self, atom: int) -> int:
        """How many poses an atom has: the measure of progress."""

    def perform(self, atom: int) -> Arrays:
        """What comes of an atom; a function of the atom alone. Several threads call it at a time."""


class Work(Protocol):
    """What a process needs to make a task ready: can be pickled, and is small beside its results."""

    @property
    def key(self) -> str:
        """A hash of all that the results depend on: a task is kept, and a study resumed, under it."""

    def open(self) -> Task:
        """The task: compiles what there is to compile. Called once in a process."""


class Sink(Protocol):
    """Where results go, atom by atom in their order."""

    @property
    def next(self) -> int:
        """The atom to go on with."""

    def take(self, atom: int, result: Arrays) -> None:
        """Take the result of atom ``next``."""

    def save(self) -> None:
        """Make what was taken outlast the process."""


@dataclass(frozen=True)
class Cut:
    """Samples x poses cut into atoms: units of :data:`UNIT` samples, each cut into equal ranges of poses.

    A function of ``samples`` and ``poses`` alone; in both directions only the last piece is shorter. Atoms are
    numbered unit by unit, so that each range of poses meets its units in their order.
    """

    samples: int
    poses: int

    def __post_init__(self) -> None:
        if self.samples < 0 or self.poses < 0:
            raise ValueError("samples and poses can't be negative")

    @cached_property
    def width(self) -> int:
        """Poses of a range."""
        size = min(max(self.samples * self.poses // ENOUGH, SMALLEST), LARGEST)
        most = max(size // max(min(UNIT, self.samples), 1), 1)
        return max(-(-self.poses // max(-(-self.poses // most), 1)), 1)

    @property
    def units(self) -> int:
        """How many units of samples there are."""
        return -(-self.samples // UNIT)

    @property
    def ranges(self) -> int:
        """How many ranges of poses each unit has."""
        return -(-self.poses // self.width)

    @property
    def atoms(self) -> int:
        """How many atoms there are."""
        return self.units * self.ranges

    def unit(self, atom: int) -> int:
        """The unit of samples to which an atom belongs."""
        return atom // self.ranges

    def range(self, atom: int) -> int:
        """The number of an atom's range of poses."""
        return atom % self.ranges

    def sample_slice(self, atom: int) -> slice:
        """The samples of an atom."""
        start = self.unit(atom) * UNIT
        return slice(start, min(start + UNIT, self.samples))

    def pose_slice(self, atom: int) -> slice:
        """The poses of an atom."""
        start = self.range(atom) * self.width
        return slice(start, min(start + self.width, self.poses))

    def size(self, atom: int) -> int:
        """Samples x poses of an atom."""
        samples = min(UNIT, self.samples - self.unit(atom) * UNIT)
        return samples * min(self.width, self.poses - self.range(atom) * self.width)
