"""Expressions of signals from rows of these that are at hand already."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.language import Call, Name, Node, evaluate, is_signal
from linkwright.kernels.compiled import Compiled
from linkwright.notation import Jet

Array = NDArray[np.float64]


def combined(
    compiled: Compiled,
    node: Node,
    t: Array,
    rows: Mapping[str, Sequence[Array]],
    order: int,
    given: Mapping[str, Any] | None = None,
) -> Jet:
    """An expression (bound to SI) at times ``t`` to an order of derivatives, from the signals' ``rows``.

    ``given`` are parameters other than the nominal ones: numbers, or arrays that broadcast with the times.
    """
    value = expressed(compiled, node, t, rows, order, given)
    return Jet([np.broadcast_to(np.asarray(d, dtype=float), t.shape) for d in value.d])


def expressed(
    compiled: Compiled,
    node: Node,
    t: Array,
    rows: Mapping[str, Sequence[Any]],
    order: int,
    given: Mapping[str, Any] | None = None,
) -> Jet:
    """The same with entries as they come out; those of ``rows`` and ``given`` may be duals."""
    parameters = compiled.quantities.parameters if given is None else given
    time = Jet([t, np.ones_like(t)]).truncated(order)

    def name_value(name: Name) -> Any:
        if is_signal(name):
            return Jet([*rows[name.text]])
        return time if name.text == "t" else parameters[name.text]

    def call_value(call: Call) -> Jet:
        if is_signal(call):
            return Jet([*rows[compiled.quantities.signals.find(call).text]])
        argument = evaluate(call.args[0], name_value, call_value)
        return (
            compiled.tables[call.name]
            .at_parameters(parameters)
            .or_nan(argument if isinstance(argument, Jet) else Jet.constant(argument, order))
        )

    try:
        with np.errstate(all="ignore"):
            value = evaluate(node, name_value, call_value)
    except ZeroDivisionError:
        value = np.nan
    return value if isinstance(value, Jet) else Jet.constant(value, order)
