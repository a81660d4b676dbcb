"""Break functions: what is zero where an expression may have a pole, a jump, an edge of its domain or a kink.

Each function of expressions that isn't smooth everywhere contributes the functions of time whose zeros are the places
to look at: denominators, ``cos(u)`` for ``tan(u)``, ``u`` for ``log``, ``sqrt`` and fractional powers, ``1 - u`` and
``1 + u`` for ``asin`` and ``acos``, ``y`` for ``atan2(y, x)``, the arguments of ``abs``, the differences of ``min``,
``max`` and the ends of ``step5``. Signals that are quotients publish their denominators.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from enum import Enum

from linkwright.data_classes import dataclass
from linkwright.expressions.language import Binary, Call, Name, Negative, Node, Number, is_signal, nodes
from linkwright.expressions.trees import children
from linkwright.model.signals import Signal
from linkwright.results.discontinuities import switches

Find = Callable[[Name | Call], Signal]
"""Gives the signal that a node names."""


class ZeroKind(Enum):
    """What a zero of a break function may do to the expression."""

    POLE = "pole"
    EDGE = "edge"
    JUMP = "jump"
    KINK = "kink"

    @property
    def hard(self) -> bool:
        """Whether the expression need not be continuous there."""
        return self is not ZeroKind.KINK


@dataclass(frozen=True)
class Feature:
    """A break function (bound to SI) and what its zeros may mean."""

    node: Node
    kind: ZeroKind


def features(node: Node, find: Find) -> list[Feature]:
    """The break functions of an expression, inner ones before those that contain them, each once."""
    found: dict[Feature, None] = {}
    for part in _inner_first(node):
        for feature in _own_features(part, find):
            if varies(feature.node):
                found[feature] = None
    return [*found]


def varies(node: Node) -> bool:
    """Whether an expression depends on the time or on signals."""
    return any(is_signal(part) or part == Name("t") for part in nodes(node))


def denominator(signal: Signal) -> Node | None:
    """What a signal that is a quotient is divided by, as an expression of other signals."""
    published = QUOTIENTS.get((signal.kind, signal.attribute)) or QUOTIENTS.get((signal.kind, ""))
    return None if published is None else published(signal)


def _normal(signal: Signal) -> Node:
    return Call("force", tuple(Name(owner) for owner in signal.owners), "normal")


def _turning(signal: Signal) -> Node:
    a, b = (Name(f"{link}.omega") for link in signal.owners)
    return Binary("-", a, b)


QUOTIENTS: dict[tuple[str, str], Callable[[Signal], Node]] = {("force", "arm"): _normal, ("pole", ""): _turning}
"""The denominators of signals by kind and attribute, "" for all attributes of a kind: the lever arm of a slide's
reaction is divided by its normal force, the place of an instant centre by the relative angular velocity."""


def _inner_first(node: Node) -> Iterator[Node]:
    for child in children(node):
        yield from _inner_first(child)
    yield node


def _own_features(node: Node, find: Find) -> Iterator[Feature]:
    """The break functions of a node alone, without those of its operands."""
    if is_signal(node):
        assert isinstance(node, Name | Call)
        if (divisor := denominator(find(node))) is not None:
            yield Feature(divisor, ZeroKind.POLE)
    elif isinstance(node, Binary) and node.op == "/":
        yield from (Feature(factor, ZeroKind.POLE) for factor in _factors(node.right))
    elif isinstance(node, Binary) and node.op == "^":
        yield from _of_power(node.left, node.right)
    elif isinstance(node, Call):
        rule = _FUNCTIONS.get(node.name)
        yield from rule(node) if rule else ()
        yield from (Feature(switch, ZeroKind.KINK) for switch in switches(node))


def _of_power(base: Node, exponent: Node) -> Iterator[Feature]:
    power = constant(exponent)
    if power is not None and power >= 0 and power == int(power):
        return
    kind = ZeroKind.POLE if power is not None and power < 0 else ZeroKind.EDGE
    yield from (Feature(factor, kind) for factor in _factors(base))


def constant(node: Node) -> float | None:
    """The value of a number, with its sign."""
    if isinstance(node, Negative):
        value = constant(node.of)
        return None if value is None else -value
    return node.value if isinstance(node, Number) else None


def _factors(node: Node) -> Iterator[Node]:
    """The factors of a denominator whose zeros are its own, so that each crosses zero by itself."""
    if isinstance(node, Negative):
        yield from _factors(node.of)
    elif isinstance(node, Binary) and node.op == "*":
        yield from _factors(node.left)
        yield from _factors(node.right)
    elif (isinstance(node, Binary) and node.op == "/") or (
        isinstance(node, Binary) and node.op == "^" and (constant(node.right) or 0) > 0
    ):
        yield from _factors(node.left)
    elif isinstance(node, Call) and node.attribute is None and node.name in ("abs", "sqrt"):
        yield from _factors(node.args[0])
    else:
        yield node


def _tan(node: Call) -> Iterator[Feature]:
    yield Feature(Call("cos", node.args), ZeroKind.POLE)


def _edge(node: Call) -> Iterator[Feature]:
    yield from (Feature(factor, ZeroKind.EDGE) for factor in _factors(node.args[0]))


def _arc(node: Call) -> Iterator[Feature]:
    one = Number(1.0)
    yield Feature(Binary("-", one, node.args[0]), ZeroKind.EDGE)
    yield Feature(Binary("+", one, node.args[0]), ZeroKind.EDGE)


def _atan2(node: Call) -> Iterator[Feature]:
    yield Feature(node.args[0], ZeroKind.JUMP)


def _hypot(node: Call) -> Iterator[Feature]:
    square = [Binary("^", arg, Number(2.0)) for arg in node.args]
    yield Feature(Binary("+", *square), ZeroKind.KINK)


_FUNCTIONS: dict[str, Callable[[Call], Iterator[Feature]]] = {
    "tan": _tan,
    "log": _edge,
    "sqrt": _edge,
    "asin": _arc,
    "acos": _arc,
    "atan2": _atan2,
    "hypot": _hypot,
}
