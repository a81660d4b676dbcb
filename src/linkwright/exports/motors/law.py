"""The law of a drive as one tree, and the functions that it calls."""

from __future__ import annotations

from pathlib import Path

from linkwright.expressions.language import Call, Node, nodes
from linkwright.formulas.functions import OfMotion, OfTable, PiecewiseFunction
from linkwright.graph.geometry import Geometry
from linkwright.kernels import Compiled
from linkwright.kernels.laws import read_table


def law_of(compiled: Compiled, drive: str) -> Node | None:
    """The tree of a drive's value in t, parameters, and called functions; bound to SI. ``None`` for a follower that has
    no formula."""
    quantities = compiled.quantities
    if (follower := compiled.mechanism.followers.get(drive)) is not None:
        motor = law_of(compiled, follower.motor)
        return None if motor is None else follower.tree(Geometry(quantities, quantities.parameters), motor)
    return quantities.law(drive)


def functions(compiled: Compiled, law: Node, folder: Path | None) -> dict[str, PiecewiseFunction]:
    """The tables and motion laws that a drive's law calls. Raises :class:`ModelError` where a file can't be read."""
    names = {node.name for node in nodes(law) if isinstance(node, Call)}
    tables = [name for name in compiled.mechanism.tables if name in names]
    found: dict[str, PiecewiseFunction] = {
        name: OfTable(read_table(compiled.quantities, name, folder)) for name in tables
    }
    return found | {name: OfMotion(motion) for name, motion in compiled.motions.items() if name in names}
