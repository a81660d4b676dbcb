"""The numbers of a mechanism for many sets of parameter values at once."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.model.expressions import Name, Node, evaluate, nodes
from linkwright.model.fields import Expression
from linkwright.model.quantities import LARGEST, Quantities
from linkwright.model.units import Dimension

Array = NDArray[np.float64]


def dependent(quantities: Quantities, names: frozenset[str]) -> frozenset[str]:
    """The parameters that vary with those of some names, these among them."""
    found = set(names)
    for name in quantities.order:
        if names_in(quantities.mechanism.parameters[name].value.node) & found:
            found.add(name)
    return frozenset(found)


def names_in(node: Node) -> set[str]:
    """The names that stand in a tree."""
    return {part.text for part in nodes(node) if isinstance(part, Name)}


class Sampled(Quantities):
    """A mechanism's numbers with some parameters given as arrays (samples,) in SI, and all others that depend on
    them: values come out as arrays then, as plain numbers where nothing varies.

    A parameter given so takes the place of its own expression.
    """

    def __init__(self, nominal: Quantities, given: Mapping[str, Array]) -> None:
        self.__dict__.update(nominal.__dict__)
        self.varying = dependent(nominal, frozenset(given))
        self.parameters = dict(nominal.parameters)
        for name in self.order:
            if name in given:
                self.parameters[name] = np.asarray(given[name], dtype=float)  # type: ignore[assignment]
            elif name in self.varying:
                expression = self.mechanism.parameters[name].value
                self.parameters[name] = self.value(expression, self.dimensions.of(name))

    def value(self, expression: Expression, dimension: Dimension | None) -> Any:
        """The value in SI: (samples,) where it varies, else a number; NaN or infinite where it has none."""
        node = self.bind(expression, dimension)
        if not names_in(node) & self.varying:
            return super().value(expression, dimension)
        with np.errstate(all="ignore"):
            return evaluate(node, lambda name: self.parameters[name.text])

    def rows(self, samples: int) -> Array:
        """All parameters, in their order: (parameters, samples)."""
        return np.array([np.broadcast_to(value, samples) for value in self.parameters.values()]).reshape(-1, samples)

    @property
    def wrong(self) -> NDArray[np.bool_]:
        """The samples of which some parameter has no number to compute with."""
        found: NDArray[np.bool_] = np.zeros((), dtype=bool)
        for name in self.varying:
            found = found | ~(np.abs(self.parameters[name]) < LARGEST)
        return found
