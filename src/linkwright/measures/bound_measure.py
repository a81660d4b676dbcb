"""A measure bound to SI: what runs, many samples and derivatives take, whether a file states it or a study makes it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field
from typing import Any

import numpy as np

from linkwright.data_classes import dataclass
from linkwright.expressions.fields import Requirement
from linkwright.expressions.language import Node
from linkwright.expressions.units import Dimension, unit
from linkwright.model.bound_window import BoundWindow
from linkwright.model.quantities import Quantities
from linkwright.reductions import Measure, MeasureKind, figure, kind_of


@dataclass(frozen=True, eq=False)
class BoundMeasure:
    """A measure ready to be taken. ``dimension`` is that of its figures; ``trees`` are its expressions bound to SI by
    their keys, "" for the signal; ``path`` is where findings say it stands."""

    name: str
    entry: Measure
    dimension: Dimension
    trees: Mapping[str, Node]
    window: BoundWindow | None = None
    requirement: Requirement | None = None
    path: tuple[str | int, ...] = field(kw_only=True)

    @classmethod
    def of_name(cls, quantities: Quantities, name: str) -> BoundMeasure:
        """A measure of the mechanism by its name."""
        mechanism, dimensions = quantities.mechanism, quantities.dimensions
        entry = mechanism.measures[name]
        window = None if entry.window is None else quantities.window(entry.window)
        dimension = dimensions.resolve(figure(name, entry))
        # What an expression of plain numbers is may follow from the bounds on the figure.
        kind = dimension if entry.dimension is None else None
        trees = {"": quantities.bind(entry.signal, kind), **_others(quantities, entry)}
        requirement = mechanism.require.get(name)
        return cls(name, entry, dimension, trees, window, requirement, path=("measures", name))

    @classmethod
    def of_entry(
        cls, quantities: Quantities, name: str, entry: Measure, window: BoundWindow | None, path: tuple[str | int, ...]
    ) -> BoundMeasure:
        """A measure of signals that stands in no file."""
        dimension = entry.dimension or quantities.dimensions.dimension(entry.signal.node)
        trees = {"": quantities.dimensions.bind(entry.signal.node, None), **_others(quantities, entry)}
        return cls(name, entry, dimension, trees, window, path=path)

    @property
    def kind(self) -> MeasureKind:
        """The reduction."""
        return kind_of(self.entry)

    @property
    def signal(self) -> Node:
        """What is reduced."""
        return self.trees[""]

    @property
    def nodes(self) -> list[Node]:
        """All expressions on which it depends, that of its window among them."""
        return [*self.trees.values(), *(self.window.nodes if self.window is not None else ())]

    @property
    def content(self) -> list[Any]:
        """All that tells it from others, as plain data."""
        entry = self.entry.model_dump(mode="json", exclude_none=True)
        window = None if self.window is None else [self.window.signal, *(end.text for end in self.window.ends)]
        return [self.name, entry, window]

    def unit(self, quantities: Quantities) -> tuple[str, float]:
        """The unit in which its figures are shown, and its SI value."""
        text = self.entry.unit
        return quantities.unit_of(self.dimension) if text is None else (text, unit(text)[0])

    def wrapped(self, quantities: Quantities, value: Any) -> Any:
        """A figure, or those of samples, in the range of whole turns that the measure states."""
        if self.entry.wrap is None:
            return value
        low, high = (quantities.value(end, self.dimension) for end in self.entry.wrap)
        with np.errstate(invalid="ignore"):
            return low + (value - low) % (high - low)

    def requirement_met(self, quantities: Quantities, figures: Iterable[Any]) -> Any:
        """Whether figures, or those of each sample, meet the requirement; NaN doesn't."""
        assert self.requirement is not None
        low, high = (
            default if end is None else quantities.value(end, self.dimension)
            for end, default in ((self.requirement.low, -np.inf), (self.requirement.high, np.inf))
        )
        return np.logical_and.reduce([(low <= value) & (value <= high) for value in figures])


def bound_measures(quantities: Quantities, names: Sequence[str] | None = None) -> list[BoundMeasure]:
    """Measures of the mechanism by their names, or all."""
    wanted = quantities.mechanism.measures if names is None else names
    return [BoundMeasure.of_name(quantities, name) for name in wanted]


def _others(quantities: Quantities, entry: Measure) -> dict[str, Node]:
    """The expressions beside the signal."""
    return {key: quantities.dimensions.bind(expression.node, None) for key, expression in entry.also.items()}
