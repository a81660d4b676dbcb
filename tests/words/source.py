"""What the package's source says about its texts: codes of findings, keys, and the data each call site gives them."""

from __future__ import annotations

import ast
import re
from collections import defaultdict
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import linkwright

ROOT = Path(linkwright.__file__).parent
CODE = re.compile(r"[a-z]+\.[a-z]+(?:-[a-z]+)*")
RAISERS = {"Finding", "fault", "DimensionError", "note", "_note"}


@cache
def nodes() -> dict[type[ast.AST], list[Any]]:
    """The nodes of all modules but the catalogue's by their type, parsed and walked once for all tests."""
    found: dict[type[ast.AST], list[Any]] = defaultdict(list)
    for path in sorted(ROOT.rglob("*.py")):
        if "words" not in path.relative_to(ROOT).parts:
            for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
                found[type(node)].append(node)
    return found


def texts() -> set[str]:
    """All string constants that look like a code."""
    constants = (node.value for node in nodes()[ast.Constant])
    return {value for value in constants if isinstance(value, str) and CODE.fullmatch(value)}


@cache
def raised() -> list[tuple[str, set[str] | None]]:
    """Each place that makes a finding: its code, and the names of its data (``None`` where not plain to see)."""
    return [found for function in nodes()[ast.FunctionDef] for found in _in_function(function)]


def _in_function(function: ast.FunctionDef) -> Iterator[tuple[str, set[str] | None]]:
    for node in ast.walk(function):
        if isinstance(node, ast.Call) and _name(node.func) in RAISERS and node.args:
            for code in _codes(node.args[0]):
                yield code, _data(node, function)
        if isinstance(node, ast.Yield) and isinstance(node.value, ast.Tuple) and len(node.value.elts) == 2:
            for code in _codes(node.value.elts[0]):
                yield code, _keys(node.value.elts[1], function)


def _name(function: ast.expr) -> str:
    return function.attr if isinstance(function, ast.Attribute) else getattr(function, "id", "")


def _codes(node: ast.expr) -> list[str]:
    values = [node.body, node.orelse] if isinstance(node, ast.IfExp) else [node]
    return [
        v.value for v in values if isinstance(v, ast.Constant) and isinstance(v.value, str) and CODE.fullmatch(v.value)
    ]


def _data(call: ast.Call, function: ast.FunctionDef) -> set[str] | None:
    names = {keyword.arg for keyword in call.keywords}
    if _name(call.func) != "Finding":
        return None if None in names else {name for name in names if name} - {"path", "line"}
    given = next((keyword.value for keyword in call.keywords if keyword.arg == "data"), None)
    given = call.args[2] if len(call.args) > 2 else given
    return set() if given is None else _keys(given, function)


def _keys(node: ast.expr, function: ast.FunctionDef) -> set[str] | None:
    if isinstance(node, ast.Name):
        written = [
            n.value
            for n in ast.walk(function)
            if (isinstance(n, ast.Assign) and any(isinstance(t, ast.Name) and t.id == node.id for t in n.targets))
        ]
        return _keys(written[0], function) if len(written) == 1 and isinstance(written[0], ast.Dict) else None
    if not isinstance(node, ast.Dict) or not all(isinstance(key, ast.Constant) for key in node.keys):
        return None
    return {str(key.value) for key in node.keys if isinstance(key, ast.Constant)}


def terms() -> set[str]:
    """The phrases of the catalogue that the source names: plainly, or by the start of their key."""
    makers = {"Term", "Near", "unexpected", "pair", "plain_number", "ExpressionError", "least"}
    found: set[str] = set()
    for node in nodes()[ast.Call]:
        if _name(node.func) in makers:
            prefix = "syntax-" if _name(node.func) == "ExpressionError" else ""
            for part in (part for arg in node.args for part in ast.walk(arg)):
                if isinstance(part, ast.Constant) and isinstance(part.value, str):
                    found.add(prefix + part.value)
    return found


def wanted() -> set[str]:
    """The phrases that say what is wanted where something else is given."""
    found: set[str] = set()
    for node in nodes()[ast.Call]:
        if node.args and _name(node.func) in ("unexpected", "pair", "plain_number"):
            last = node.args[-1] if _name(node.func) == "plain_number" else node.args[0]
            if isinstance(last, ast.Constant):
                found.add(str(last.value))
    return found


CALLS = {"say": "", "Said": "", "Term": "term."}
"""What makes words of the catalogue's texts, and how the keys begin that it takes."""


def spoken() -> Iterator[tuple[str, set[str] | None]]:
    """Each place that names a text: a pattern of its key, and the names of its data (``None`` where not plain to see,
    or where the key isn't plain itself)."""
    for node in nodes()[ast.Call]:
        if _name(node.func) in CALLS and node.args:
            names = {keyword.arg for keyword in node.keywords}
            for key in _patterns(node.args[0]):
                whole = None in names or HOLE in key
                given = None if whole else {name for name in names if name}
                yield re.escape(CALLS[_name(node.func)]) + key, given
    yield from ((key, None) for key in tables() if HOLE not in key)


def tables() -> Iterator[str]:
    """The keys that tables make of the texts they name, as patterns: of the title, of all heads."""
    for node in nodes()[ast.Call]:
        match node:
            case (
                ast.Call(func=ast.Name("table"), args=[ast.Constant(str(of)), *names])
                | ast.Call(func=ast.Name("partial"), args=[ast.Name("table"), ast.Constant(str(of)), *names])
            ):
                title = _patterns(names[0]) if names else []
                yield from (rf"{of}\.{key}" for key in (rf"table\.{(title or [HOLE])[0]}", rf"column\.{HOLE}"))


def named(keys: set[str]) -> set[str]:
    """Those of the keys that strings of the source make up, those with holes too where they tell at least a key's
    group."""
    strings = (node for kind in (ast.Constant, ast.JoinedStr, ast.IfExp, ast.BinOp) for node in nodes()[kind])
    found = {key for node in strings for key in _patterns(node)} | {*tables()}
    whole = {key for key in found if HOLE not in key}
    parts = {key for key in found - whole if GROUP.match(key)} - {re.escape("term.") + HOLE}
    made = re.compile("|".join(parts))
    return {key for key in keys if re.escape(key) in whole or made.fullmatch(key)}


HOLE = ".+"
GROUP = re.compile(r"[a-z_]+\\\.")


def _patterns(node: ast.expr) -> list[str]:
    """What a string may be, as regular expressions; nothing of what isn't plainly one."""
    match node:
        case ast.Constant(value=str(text)):
            return [re.escape(text)]
        case ast.JoinedStr(values=parts):
            return ["".join(_patterns(part)[0] if isinstance(part, ast.Constant) else HOLE for part in parts)]
        case ast.IfExp(body=body, orelse=other):
            return [*_patterns(body), *_patterns(other)]
        case ast.BinOp(left=left, op=ast.Add(), right=right):
            return [first + second for first in _patterns(left) for second in _patterns(right)]
    return []
