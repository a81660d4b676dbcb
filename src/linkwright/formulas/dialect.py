"""The words of a motor's expressions: which functions there are, and what an angle is counted in.

``creo`` is what PTC documents of user-defined motors in Creo Mechanism ("About the Functions Dialog Box", "To Create a
User-Defined Motor Function", support.ptc.com): sin, cos, tan, asin, acos, ln, sqrt; asin goes from -90 to 90, so angles
are in degrees; a domain is written ``1 < t < 10``. ``radians`` is the same for tools that count in radians.
"""

from __future__ import annotations

from math import pi

from linkwright.expressions.language import Binary, Call, Node, Number
from linkwright.formulas.terms import MADE, scaled, shifted, text, times

DIALECTS = {"creo": 180 / pi, "radians": 1.0}
"""How many of its units an angle of a radian has."""


def spoken(node: Node, dialect: str, stop: float) -> Node:
    """A tree in the words of a dialect, its powers and angles from their own zeros in 0 .. ``stop`` on."""
    unit = DIALECTS[dialect]
    if isinstance(node, Binary):
        left, right = spoken(node.left, dialect, stop), spoken(node.right, dialect, stop)
        return (
            MADE[node.op](left, right) if node.op in "+/" else MADE[node.op](shifted(left, stop), shifted(right, stop))
        )
    if not isinstance(node, Call):
        return node
    args = [spoken(arg, dialect, stop) for arg in node.args]
    if node.name in ("sin", "cos", "tan"):
        return Call(node.name, (shifted(scaled(args[0], unit), stop),))
    if node.name in ("asin", "acos"):
        return times(Number(1 / unit), Call(node.name, tuple(args)))
    return Call({"log": "ln"}.get(node.name, node.name), tuple(args))


def line(node: Node, size: float, dialect: str, stop: float) -> str:
    """The text of a tree in SI, in a unit of this ``size``."""
    return text(scaled(spoken(node, dialect, stop), 1 / size))
