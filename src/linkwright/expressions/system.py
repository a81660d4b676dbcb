"""Linear equations between the powers of length, mass and time of things whose dimension is still unknown."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from fractions import Fraction

from linkwright.data_classes import dataclass

Power = Fraction | int
Powers = tuple[Power, ...]
Unknown = str | tuple[str, int]
"""A parameter's name, or something else whose dimension is open (a kind and a number)."""


@dataclass
class DimensionSystem:
    """Linear equations over unknown dimensions, eliminated as they come."""

    solved: dict[Unknown, tuple[dict[Unknown, Power], list[Power]]] = field(default_factory=dict)
    _values: dict[Unknown, tuple[list[Power], bool]] = field(default_factory=dict)

    def add(self, unknowns: Mapping[Unknown, Power], value: Powers) -> bool:
        """Add sum(unknowns) = value; ``False`` where it contradicts what is known."""
        row, right = self._reduced(dict(unknowns), [*value])
        if not row:
            return not any(right)
        # Rather what isn't a parameter, and rather a first power: no unit is the root of another.
        pivot = min(row, key=lambda name: (not isinstance(name, tuple), abs(row[name]) != 1))
        by = row.pop(pivot)
        if abs(by) != 1:
            by = 1 / Fraction(by)
        self.solved[pivot] = ({k: -v * by for k, v in row.items()}, [v * by for v in right])
        self._values.clear()
        return True

    def value(self, name: Unknown) -> tuple[list[Power], bool]:
        """The powers of an unknown where open ones are zero, and whether it is free of open ones."""
        if name not in self._values:
            row, right = self._reduced({name: -1}, [0] * 3)
            self._values[name] = right, not row
        return self._values[name]

    def _reduced(self, row: dict[Unknown, Power], right: list[Power]) -> tuple[dict[Unknown, Power], list[Power]]:
        """The equation with what is solved put in: sum(row) = right over open unknowns."""
        for name in [name for name in row if name in self.solved]:
            self._close(name)
            power = row.pop(name)
            others, constant = self.solved[name]
            for other, p in others.items():
                row[other] = row.get(other, 0) + power * p
            right = [r - power * c for r, c in zip(right, constant, strict=True)]
        return {name: power for name, power in row.items() if power}, right

    def _close(self, name: Unknown) -> None:
        """Bring a solved unknown's equation down to open ones, and all those on the way with it."""
        todo = [name]
        while todo:
            others, constant = self.solved[todo[-1]]
            known = [other for other in others if other in self.solved]
            deeper = [other for other in known if not self.solved[other][0].keys().isdisjoint(self.solved)]
            if deeper:
                todo += deeper
                continue
            if known:
                row, right = self._reduced(dict(others), [-c for c in constant])
                self.solved[todo[-1]] = (row, [-r for r in right])
            todo.pop()
