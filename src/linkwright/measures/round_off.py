"""How far round-off may carry an expression: its value with every signal known to some digits only.

Each signal stands for all numbers that its round-off can't tell apart: :data:`LITTLE` of its own size or of what is
usual of its dimension, whichever is more, as that is the size of the terms that cancel in it (of rates, their own).
Interval arithmetic carries these sets through the expression. A set that holds zero is no more than round-off.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.enclosures.intervals import Intervals, lift
from linkwright.expressions.language import Call, Name, Node, evaluate, is_signal
from linkwright.notation import Jet
from linkwright.results import Run
from linkwright.results.margins import LEAST_MARGIN, margins

Array = NDArray[np.float64]

LITTLE = 1e-13
"""What signals are off by at most, over their own size or what is usual of their dimension ..."""
INTERPOLATED = 1e-11
"""... where they are interpolated between poses beside a change point ..."""
DIGITS = 2e-15
"""... and what those of positions usually are."""
COARSER, SHRINKS, TINY = 100.0, 0.2, 1e-300
"""With so many times less digits the values that can't be told from those of a vanishing expression spread to this
share the more, at least."""
WHOLE = Intervals(-np.inf, np.inf)


def spreads(run: Run, trees: Sequence[Node], t: Array, little: Array | float = LITTLE) -> list[Intervals]:
    """The values (SI) that round-off can't tell from those of each expression at times (s): (times,) each. ``little``
    is what signals are off by, at all times or at each."""
    names = run.signals_of(trees)
    values = run.evaluate(names, t) if names else np.empty((0, t.size))
    sizes = run.usual(run.dimension(name) for name in names)
    # Rates of bodies that don't touch may differ by any power of ten, as where one steps: none tells of another's.
    sizes = [0.0 if _is_rate(run, name) else size for name, size in zip(names, sizes, strict=True)]
    with np.errstate(all="ignore"):
        rows = {
            name: Intervals(row - off, row + off)
            for name, row, size in zip(names, values, sizes, strict=True)
            for off in (little * np.maximum(np.abs(row), size),)
        }
    return [_spread(run, tree, t, rows) for tree in trees]


def _is_rate(run: Run, name: str) -> bool:
    dimension = run.dimension(name)
    return dimension.mass == 0 and dimension.time < 0


def vanishing(run: Run, trees: Sequence[Node], t: Array) -> list[bool]:
    """Which expressions are zero but for round-off at all times (s): zero can't be told from their values, and what
    can't shrinks with the digits of the signals. Values that any digits leave open, such as the angle of two numbers
    that are round-off, aren't zero."""
    little, found = _lost(run, t), []
    for fine, coarse in zip(spreads(run, trees, t, little), spreads(run, trees, t, COARSER * little), strict=True):
        with np.errstate(all="ignore"):
            width, wider = fine.high - fine.low, coarse.high - coarse.low
            shrinks = (width <= SHRINKS * wider) | (width <= TINY)
        found.append(bool((fine.contains(0.0) & np.isfinite(wider) & shrinks).all()))
    return found


def _lost(run: Run, t: Array) -> Array | float:
    """What signals are off by at times (s): more beside the change points through which a motion is carried, where a
    system that is nearly singular spreads the round-off of its forces, and in their bands, where these are
    interpolated."""
    passages = run.compiled.passages
    if not passages.every:
        return LITTLE
    lost = LITTLE / np.clip(margins(run, t).min(axis=0, initial=1.0), LEAST_MARGIN, 1.0) ** 2
    return np.asarray(np.where(passages.outside(t), lost, np.maximum(lost, INTERPOLATED)))


def reachable(run: Run, tree: Node) -> tuple[float, float]:
    """Between which values (SI) an expression stays whatever its signals are: a square root isn't negative."""
    t = np.zeros(1)
    found = _spread(run, tree, t, dict.fromkeys(run.signals_of([tree]), WHOLE), clock=WHOLE)
    # Bounds are widened by round-off; zero is meant exactly.
    low, high = float(found.low[0]), float(found.high[0])
    tiny = float(np.finfo(float).tiny)
    return (0.0 if abs(low) <= tiny else low), (0.0 if abs(high) <= tiny else high)


def _spread(run: Run, tree: Node, t: Array, rows: dict[str, Intervals], clock: Intervals | None = None) -> Intervals:
    parameters, signals = run.compiled.quantities.parameters, run.compiled.quantities.signals

    def of_name(name: Name) -> Any:
        if is_signal(name):
            return rows[run.canonical(name)]
        if name.text == "t":
            return Intervals(t) if clock is None else clock
        return parameters[name.text]

    def of_call(call: Call) -> Any:
        if is_signal(call):
            return rows[signals.find(call).text]
        if clock is not None:
            return WHOLE
        # A table along its slope over the set of its arguments.
        argument = lift(evaluate(call.args[0], of_name, of_call))
        middle = np.broadcast_to((argument.low + argument.high) / 2, t.shape)
        jet = run.compiled.tables[call.name].at_parameters(parameters).or_nan(Jet([middle, np.ones_like(middle)]))
        off = np.abs(jet.d[1]) * (argument.high - argument.low) / 2 + LITTLE * np.abs(jet.d[0])
        return Intervals(jet.d[0] - off, jet.d[0] + off)

    try:
        with np.errstate(all="ignore"):
            found = lift(evaluate(tree, of_name, of_call))
    except ZeroDivisionError:
        found = WHOLE
    return Intervals(np.broadcast_to(found.low, t.shape), np.broadcast_to(found.high, t.shape))
