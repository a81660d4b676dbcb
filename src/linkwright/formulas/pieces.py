"""A drive's law over a span of time in pieces, each one formula in t."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import pairwise
from math import floor

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions.language import Binary, Call, Node, Number, evaluate
from linkwright.formulas.functions import PiecewiseFunction
from linkwright.formulas.switches import FORMULAS, SWITCHES
from linkwright.formulas.terms import MADE, T, affine, function_call, plain
from linkwright.notation import Jet

Array = NDArray[np.float64]

GRID = 4096
"""Steps on which breaks are looked for where an argument isn't a straight line in t."""
MOST = 1000
"""The most pieces of one drive."""
ZERO = np.zeros(1)


@dataclass(frozen=True)
class FormulaPiece:
    """A formula in t (a tree, SI) from ``start`` to ``stop`` (s)."""

    start: float
    stop: float
    formula: Node


class TooManyError(ValueError):
    """A law of more than :data:`MOST` pieces."""


@dataclass(frozen=True)
class Unfolding:
    """Takes a law's tree (bound to SI) apart over 0 .. ``stop`` (s): its ``parameters`` become numbers, the
    ``functions`` that it calls become formulas."""

    stop: float
    parameters: Mapping[str, float]
    functions: Mapping[str, PiecewiseFunction]

    def pieces(self, law: Node) -> list[FormulaPiece]:
        """The pieces. Raises :class:`TooManyError`."""
        names: dict[str, Node] = {name: Number(value) for name, value in self.parameters.items()}
        node = plain(law, {**names, "t": T}, self.functions)
        found: list[FormulaPiece] = []
        for start, stop in self._between(0.0, self.stop, self._knots(node)):
            opened = self._opened(node, (start + stop) / 2)
            for a, b in self._between(start, stop, self._cases(opened, start, stop)):
                formula = self._chosen(opened, (a + b) / 2)
                if found and found[-1].formula == formula:
                    a = found.pop().start
                found.append(FormulaPiece(a, b, formula))
                if len(found) > MOST:
                    raise TooManyError
        return found

    def _between(self, start: float, stop: float, times: Iterator[float]) -> list[tuple[float, float]]:
        """The span cut at some times."""
        inner = np.unique([time for time in times if start < time < stop])
        inner = inner[np.diff(inner, prepend=start) > 1e-12 * self.stop]
        if inner.size and stop - inner[-1] <= 1e-12 * self.stop:
            inner = inner[:-1]
        if inner.size > MOST:
            raise TooManyError
        ends = [start, *inner.tolist(), stop]
        return list(pairwise(ends))

    def _knots(self, node: Node) -> Iterator[float]:
        """The times at which a called function goes over to its next formula."""
        for call in _calls(node):
            if call.name in self.functions:
                function, x = self.functions[call.name], call.args[0]
                levels = function.knots
                if function.period is not None:
                    at = self._values(x, np.linspace(0.0, self.stop, GRID + 1))
                    low, high = (floor((end - levels[0]) / function.period) for end in (np.nanmin(at), np.nanmax(at)))
                    if high - low > MOST:
                        raise TooManyError
                    levels = np.concatenate([levels + k * function.period for k in range(low, high + 1)])
                yield from self._roots(x, levels, 0.0, self.stop)

    def _cases(self, node: Node, start: float, stop: float) -> Iterator[float]:
        """The times at which another case of a function begins."""
        for call in _calls(node):
            if call.name in SWITCHES:
                for difference in SWITCHES[call.name](*call.args):
                    yield from self._roots(difference, ZERO, start, stop)

    def _roots(self, node: Node, levels: Array, start: float, stop: float) -> Iterator[float]:
        """The times at which a tree has one of some values."""
        line = affine(node)
        if line is not None:
            if line[1]:
                yield from ((levels - line[0]) / line[1]).tolist()
            return
        from scipy.optimize import brentq

        t = np.linspace(start, stop, GRID + 1)
        values = self._values(node, t)
        for level in np.unique(levels).tolist():
            off = values - level
            yield from t[off == 0].tolist()
            for i in np.flatnonzero(off[:-1] * off[1:] < 0):
                yield brentq(
                    lambda at, of=level: self._values(node, np.array([at]))[0] - of, t[i], t[i + 1], xtol=1e-15
                )

    def _values(self, node: Node, t: Array) -> Array:
        def function(call: Call) -> Jet:
            x = evaluate(call.args[0], lambda name: Jet([t]), function)
            return self.functions[call.name].at(x if isinstance(x, Jet) else Jet([x]))

        with np.errstate(all="ignore"):
            value = evaluate(node, lambda name: Jet([t]), function)
        return np.broadcast_to(np.asarray(value.d[0] if isinstance(value, Jet) else value, dtype=float), t.shape)

    def _opened(self, node: Node, at: float) -> Node:
        """The tree with the formulas of all that it calls, near a time."""
        if isinstance(node, Binary):
            return MADE[node.op](self._opened(node.left, at), self._opened(node.right, at))
        if not isinstance(node, Call):
            return node
        args = [self._opened(arg, at) for arg in node.args]
        if node.name not in self.functions:
            return function_call(node.name, *args)
        return self.functions[node.name].formula(float(self._values(node.args[0], np.array([at]))[0]), args[0])

    def _chosen(self, node: Node, at: float) -> Node:
        """The opened tree with the cases that hold at a time."""
        if isinstance(node, Binary):
            return MADE[node.op](self._chosen(node.left, at), self._chosen(node.right, at))
        if not isinstance(node, Call):
            return node
        args = [self._chosen(arg, at) for arg in node.args]
        if node.name not in FORMULAS:
            return function_call(node.name, *args)
        return FORMULAS[node.name](args, [float(self._values(arg, np.array([at]))[0]) for arg in node.args])


def _calls(node: Node) -> Iterator[Call]:
    """The calls in a tree."""
    if isinstance(node, Call):
        yield node
        for arg in node.args:
            yield from _calls(arg)
    elif isinstance(node, Binary):
        yield from _calls(node.left)
        yield from _calls(node.right)
