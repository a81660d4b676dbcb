"""Random expressions of a mechanism's signals, as texts of a model file."""

from __future__ import annotations

from helpers.plain import FRAME, Plain
from helpers.random_mechanisms import Source

ONE = ("sin", "cos", "tan", "asin", "acos", "atan", "exp", "log", "sqrt", "abs")
TWO = ("atan2", "hypot", "min", "max")
OPERATORS = ("+", "-", "*", "/")
POWERS = ("2", "3", "0.5", "(-1)", "(-2)")


def signals(plain: Plain) -> list[str]:
    """Signals of links and points, each brought to a pure number."""
    found = ["(t/(1 s))"]
    for name, link in plain.links.items():
        if name == FRAME:
            continue
        found += [f"({name}.omega/(1 rad/s))", f"({name}.angle/(1 rad))", f"({name}.alpha/(1 rad/s^2))"]
        for point in link.points:
            found += [f"({point}.x/(1 m))", f"({point}.y/(1 m))", f"({point}.vx/(1 m/s))"]
    return found


def expression(source: Source, leaves: list[str], depth: int) -> str:
    """A random tree of some depth over the functions of model files; mostly plain arithmetic."""
    if depth == 0 or source.pick((False,) * 5 + (True,)):
        return source.pick(leaves) if source.pick((True, True, False)) else f"{source.uniform(0.1, 3):.3g}"
    kind = source.pick(("operator",) * 4 + ("one",) * 3 + ("two", "power"))
    parts = [expression(source, leaves, depth - 1) for _ in range(2 if kind in ("operator", "two") else 1)]
    if kind == "operator":
        return f"({parts[0]}{source.pick(OPERATORS)}{parts[1]})"
    if kind == "two":
        return f"{source.pick(TWO)}({parts[0]}, {parts[1]})"
    if kind == "power":
        return f"({parts[0]})^{source.pick(POWERS)}"
    function = source.pick(ONE)
    angle = "*(1 rad)" if function in ("sin", "cos", "tan") else ""
    back = "/(1 rad)" if function in ("asin", "acos", "atan") else ""
    return f"({function}(({parts[0]}){angle}){back})"
