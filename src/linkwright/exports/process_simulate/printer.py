"""Trees as text in a dialect: fixed decimals, never an exponent."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from linkwright.exports.process_simulate.trees import Tree, multiply, number

if TYPE_CHECKING:
    from linkwright.exports.process_simulate.dialects import Dialect

COMPARISON, SUM, PRODUCT, ATOM = 0, 1, 2, 3


def text(tree: Tree, dialect: Dialect, names: Mapping[str, str], decimals: int) -> str:
    """The text of a tree; ``names`` are those of the joints in the tool."""
    return _Printer(dialect, names, decimals).text_within(dialect.lower(tree), SUM)


def decimal(value: float, decimals: int) -> str:
    """A number not below zero with at most so many decimals."""
    shown = f"{value:.{decimals}f}"
    return shown.rstrip("0").rstrip(".") if "." in shown else shown


class _Printer:
    def __init__(self, dialect: Dialect, names: Mapping[str, str], decimals: int) -> None:
        self.dialect, self.names, self.decimals = dialect, names, decimals

    def text_within(self, tree: Tree, level: int) -> str:
        """The text of a tree, in brackets where it binds less than its place asks for."""
        shown, own = self.text_and_level(tree)
        return shown if own >= level else f"({shown})"

    def text_and_level(self, tree: Tree) -> tuple[str, int]:
        if tree.negative:
            rest = self.text_within(multiply(number(-1.0), tree), PRODUCT) if self.dialect.minus else self.bare(tree)
            return (f"-{rest}", SUM) if self.dialect.minus else (f"(-1)({rest})", PRODUCT)
        if tree.op == "number":
            return decimal(tree.value, self.decimals), ATOM
        if tree.op in ("T", "D"):
            return f"{tree.op}({self.names[tree.name]})", ATOM
        if tree.op == "+":
            return self.sum(tree), SUM
        if tree.op == "*":
            return "*".join(self.text_within(arg, PRODUCT) for arg in tree.args), PRODUCT
        if tree.op == "/":
            return f"{self.text_within(tree.args[0], PRODUCT)}/{self.text_within(tree.args[1], ATOM)}", PRODUCT
        if tree.op in (">=", "<"):
            return tree.op.join(self.text_within(arg, SUM) for arg in tree.args), COMPARISON
        return f"{tree.op}({','.join(self.text_within(arg, SUM) for arg in tree.args)})", ATOM

    def bare(self, tree: Tree) -> str:
        """The opposite of a negative tree, where it stands in brackets anyway."""
        return self.text_within(multiply(number(-1.0), tree), SUM)

    def sum(self, tree: Tree) -> str:
        shown = ""
        for term in tree.args:
            if term.negative and self.dialect.minus:
                shown += f"-{self.text_within(multiply(number(-1.0), term), PRODUCT)}"
            else:
                shown += f"{'+' if shown else ''}{self.text_within(term, PRODUCT)}"
        return shown
