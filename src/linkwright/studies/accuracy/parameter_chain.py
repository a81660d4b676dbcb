"""How the parameters of a file follow one another: their exact derivatives."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.language import evaluate
from linkwright.model.quantities import Quantities
from linkwright.model.sampled import names_in
from linkwright.notation import Jet

Array = NDArray[np.float64]


def derived(quantities: Quantities, name: str) -> bool:
    """Whether a parameter's value is an expression that names other parameters."""
    known = quantities.parameters
    return not known.keys().isdisjoint(names_in(quantities.mechanism.parameters[name].value.node))


def derivatives(quantities: Quantities, names: Sequence[str]) -> Array:
    """Of all parameters, in their order, by the named ones, which aren't derived: (parameters, names) in SI.

    The expressions are evaluated on jets whose rate is the row of derivatives. NaN or infinite where one has no
    derivative at the nominal values.
    """
    rows = dict(zip(names, np.eye(len(names)), strict=True))
    jets = {name: Jet((quantities.parameters[name], row)) for name, row in rows.items()}
    with np.errstate(all="ignore"):
        for name in quantities.order:
            expression = quantities.mechanism.parameters[name].value
            if name in jets or jets.keys().isdisjoint(names_in(expression.node)):
                continue
            node = quantities.bind(expression, quantities.dimensions.of(name))
            value = evaluate(node, lambda part: jets.get(part.text, quantities.parameters[part.text]))
            if isinstance(value, Jet):
                jets[name] = value
    made = np.zeros((len(quantities.parameters), len(names)))
    for i, name in enumerate(quantities.parameters):
        if name in jets:
            made[i] = jets[name].d[1]
    return made
