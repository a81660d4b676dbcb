"""Formulas in plain text evaluated by mpmath: independent of what evaluates them in the package."""

from __future__ import annotations

import ast
import operator
from typing import Any

import mpmath as mp

_OPERATORS: dict[type, Any] = {
    ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.Div: operator.truediv,
    ast.Pow: operator.pow,
}  # fmt: skip


def value(text: str, x: Any) -> Any:
    """The value of infix text with + - * / ^ ( ) sin cos pi and the argument x, numbers taken as written."""
    return _value(ast.parse(text.replace("^", "**"), mode="eval").body, x)


def _value(node: ast.expr, x: Any) -> Any:
    if isinstance(node, ast.Constant):
        return mp.mpf(repr(node.value))
    if isinstance(node, ast.Name):
        return {"x": x, "pi": mp.pi}[node.id]
    if isinstance(node, ast.UnaryOp):
        return -_value(node.operand, x)
    if isinstance(node, ast.Call):
        assert isinstance(node.func, ast.Name)
        return {"sin": mp.sin, "cos": mp.cos, "sqrt": mp.sqrt}[node.func.id](_value(node.args[0], x))
    assert isinstance(node, ast.BinOp)
    return _OPERATORS[type(node.op)](_value(node.left, x), _value(node.right, x))
