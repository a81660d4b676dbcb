"""The numbers of a mechanism for many sets of parameter values at once."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.language import Name, Node, nodes
from linkwright.findings import Finding
from linkwright.model.quantities import LARGEST, Quantities

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
    """A mechanism's numbers with some parameters given as arrays (samples,) in SI: values that depend on them come out
    as arrays. A parameter given so takes the place of its own expression.

    ``wrong`` (samples,) collects those of which a check finds some value bad.
    """

    samples: int

    def __init__(self, nominal: Quantities, given: Mapping[str, Array], samples: int) -> None:
        self.__dict__.update(nominal.__dict__)
        self.samples, self.wrong = samples, np.zeros(samples, dtype=bool)
        self.findings, self.parameters = [], dict(nominal.parameters)
        varying = dependent(nominal, frozenset(given))
        for name in self.order:
            if name in given:
                self.parameters[name] = given[name]  # type: ignore[assignment]
            elif name in varying:
                expression = self.mechanism.parameters[name].value
                self.parameters[name] = self.value(expression, self.dimensions.of(name))
            if self.bad(np.logical_not(np.abs(self.parameters[name]) < LARGEST)):
                data = {"text": self.mechanism.parameters[name].value.text[:60]}
                self.findings.append(Finding("parameters.value", ("parameters", name), data))

    def _plain(self, value: Any) -> Any:
        return value

    def bad(self, wrong: Any) -> bool:
        """Whether something is wrong with the value of some sample; these are noted."""
        self.wrong |= wrong
        return bool(np.any(wrong))

    def column(self, name: str) -> Any:
        """A parameter: a number, or (samples, 1), NaN of those of which something is wrong already."""
        value: Any = self.parameters[name]
        return np.where(self.wrong, np.nan, value)[:, None] if isinstance(value, np.ndarray) else value

    def rows(self) -> Array:
        """All parameters, in their order: (parameters, samples)."""
        rows = [np.broadcast_to(value, self.samples) for value in self.parameters.values()]
        return np.array(rows).reshape(len(rows), self.samples)
