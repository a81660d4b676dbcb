"""Followers that formats can hold which have motion laws by their pieces: a line of one law at a line of the motor."""

from __future__ import annotations

from linkwright.data_classes import dataclass
from linkwright.expressions.language import Binary, Call, ExpressionError, Name, Negative, Node, evaluate, nodes
from linkwright.graph.geometry import Geometry
from linkwright.kernels import Compiled


@dataclass(frozen=True)
class Ridden:
    """A follower's value: ``base`` plus ``scale`` times the ``law`` at ``ahead`` plus ``way`` times its motor's value;
    all in SI."""

    law: str
    base: float
    scale: float
    ahead: float
    way: float


def ridden(compiled: Compiled, name: str) -> Ridden | None:
    """How a follower rides on its law at the nominal parameters; ``None`` where its formula isn't of that form."""
    quantities, follower = compiled.quantities, compiled.mechanism.followers[name]
    motor = Name(f"{follower.motor}.{compiled.mechanism.movers[follower.motor].value}")
    tree = follower.tree(Geometry(quantities, quantities.parameters), motor)
    called = [] if tree is None else [n for n in nodes(tree) if isinstance(n, Call) and n.name in compiled.motions]
    if tree is None or len(called) != 1:
        return None
    outer = _line(tree, called[0], quantities.parameters)
    inner = _line(called[0].args[0], motor, quantities.parameters)
    return None if outer is None or inner is None else Ridden(called[0].name, *outer, *inner)


def _line(node: Node, of: Node, parameters: dict[str, float]) -> tuple[float, float] | None:
    """What a tree is where ``of`` is 0, and its slope over that; ``None`` where it isn't a line of it."""
    if node == of:
        return 0.0, 1.0
    if of not in nodes(node):
        try:
            return float(evaluate(node, lambda name: parameters[name.text])), 0.0
        except (KeyError, ExpressionError):  # another signal or law
            return None
    if isinstance(node, Negative):
        inner = _line(node.of, of, parameters)
        return None if inner is None else (-inner[0], -inner[1])
    if not isinstance(node, Binary):
        return None
    left, right = _line(node.left, of, parameters), _line(node.right, of, parameters)
    if left is None or right is None:
        return None
    (a, slope), (b, other) = left, right
    if node.op in "+-":
        sign = 1.0 if node.op == "+" else -1.0
        return a + sign * b, slope + sign * other
    if node.op == "*" and not (slope and other):
        return a * b, a * other + slope * b
    return (a / b, slope / b) if node.op == "/" and b and not other else None
