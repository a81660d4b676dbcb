"""Expressions and friction that ask for reactions which a redundant mechanism leaves undetermined.

An expression of several of them may be determined all the same, such as the sum of two: it is, where no state of
self-stress changes its value.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.dimensions import DimensionError
from linkwright.expressions.language import Node, signal_text, signals_in
from linkwright.findings import Finding
from linkwright.kernels import Compiled
from linkwright.kernels.combined import combined
from linkwright.model.places import ExpressionPlace

Array = NDArray[np.float64]

SAME = 1e-8
"""A value that a state of self-stress changes by less than this share of it, and of the force of the state, is the
same."""


def undetermined_uses(compiled: Compiled, places: Iterable[ExpressionPlace]) -> Iterator[Finding]:
    """A finding on each expression, and each friction, that asks for what isn't determined."""
    signals = compiled.quantities.signals
    if not signals.undetermined:
        return
    for place in places:
        if (name := undetermined_in(compiled, place.expression.node)) is not None:
            yield Finding("stiffness.undetermined", place.path, {"signal": name})
    open_joints = {joint for joint, _, _ in signals.undetermined}
    for one in compiled.graph.actions.resisting:
        joint = one.kind.rubs_in(one.entry)
        if joint in open_joints and one.kind.laws(one.entry):
            yield Finding("stiffness.friction", one.path, {"name": one.name, "joint": joint})


def undetermined_in(compiled: Compiled, node: Node) -> str | None:
    """The first signal in an expression that isn't determined, unless its whole value is."""
    signals = compiled.quantities.signals
    found = []
    for part in signals_in(node):
        try:
            signal = signals.find(part)
        except DimensionError:  # told elsewhere
            continue
        if signals.is_undetermined(signal):
            found.append((signal_text(part), signal))
    if not found or (all(s.kind == "force" and s.attribute != "arm" for _, s in found) and _same(compiled, node)):
        return None
    return found[0][0]


def _same(compiled: Compiled, node: Node) -> bool:
    """Whether no state of self-stress changes the value of an expression."""
    stress, quantities = compiled.structure.self_stress, compiled.quantities
    t = np.array(stress.times)
    asked = dict.fromkeys(map(signal_text, signals_in(node)))
    rows = dict(zip(asked, compiled.possible_rows([*asked], t), strict=True))
    size = max((float(np.abs(row).max()) for row in rows.values()), default=0.0) or 1.0
    changed = dict(rows)
    weights = np.random.default_rng(0).uniform(1.0, 2.0, len(next(iter(stress.forces.values()))[0])) * size
    for text in rows:
        signal = compiled.graph.signal(text)
        if not quantities.signals.is_undetermined(signal):
            continue
        contact = quantities.signals.contact(signal.owners)
        changed[text] = rows[text] + np.array(stress.forces[contact.joint, contact.link, signal.attribute]) @ weights
    try:
        bound = quantities.dimensions.bind(node, None)
    except DimensionError:
        return False
    before, after = (
        combined(compiled, bound, t, {name: (row,) for name, row in of.items()}, 0).d[0] for of in (rows, changed)
    )
    return bool((np.abs(after - before) <= SAME * (np.abs(before) + size)).all())
