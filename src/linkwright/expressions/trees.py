"""The syntax trees of expressions: numbers with units, names, calls, operations."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from linkwright.data_classes import dataclass
from linkwright.expressions.units import is_unit


@dataclass(frozen=True)
class Number:
    """A literal; ``unit`` is ``None`` for a bare number, whose unit then comes from where it stands."""

    value: float
    unit: str | None = None


@dataclass(frozen=True)
class Name:
    """A parameter (``AB``), the time ``t``, ``pi``, or a signal (``E.x``)."""

    text: str


@dataclass(frozen=True)
class Call:
    """A function or table of its arguments; with ``attribute``, a signal such as ``force(a, b).x``."""

    name: str
    args: tuple[Node, ...]
    attribute: str | None = None


@dataclass(frozen=True)
class Negative:
    """A value with its sign changed."""

    of: Node


@dataclass(frozen=True)
class Binary:
    """``+``, ``-``, ``*``, ``/`` or ``^`` of two values."""

    op: str
    left: Node
    right: Node


Node = Number | Name | Call | Negative | Binary


def children(node: Node) -> tuple[Node, ...]:
    """The nodes right below; the names inside a signal's brackets are part of its own name."""
    if isinstance(node, Call):
        return node.args if node.attribute is None else ()
    if isinstance(node, Negative):
        return (node.of,)
    return (node.left, node.right) if isinstance(node, Binary) else ()


def nodes(node: Node) -> Iterator[Node]:
    """The node and all nodes below it, from left to right."""
    todo = [node]
    while todo:
        top = todo.pop()
        yield top
        todo += reversed(children(top))


def replaced(node: Node, name: str, by: Node) -> Node:
    """The tree with another one in place of a name."""
    return with_parts(node, lambda part: by if part == Name(name) else None)


def with_parts(node: Node, part: Callable[[Node], Node | None]) -> Node:
    """The tree with others in place of those of its nodes for which ``part`` gives one."""
    if (other := part(node)) is not None:
        return other
    if isinstance(node, Call):
        return node if node.attribute else Call(node.name, tuple(with_parts(arg, part) for arg in node.args))
    if isinstance(node, Negative):
        return Negative(with_parts(node.of, part))
    if isinstance(node, Binary):
        return Binary(node.op, with_parts(node.left, part), with_parts(node.right, part))
    return node


def height(node: Node) -> int:
    """The number of levels of a tree."""
    levels, front = 0, [node]
    while front:
        levels += 1
        front = [child for top in front for child in (top.args if isinstance(top, Call) else children(top))]
    return levels


def is_signal(node: Node) -> bool:
    """Whether the node names a signal of the mechanism rather than a parameter or a function."""
    if isinstance(node, Name):
        return "." in node.text
    return isinstance(node, Call) and node.attribute is not None


def signals_in(*trees: Node) -> list[Name | Call]:
    """The signals that expressions name, as often as they do."""
    return [part for tree in trees for part in nodes(tree) if isinstance(part, Name | Call) and is_signal(part)]


def signal_text(node: Name | Call) -> str:
    """The canonical spelling of a signal: ``E.x``, ``force(frame, crank).x``."""
    if isinstance(node, Name):
        return node.text
    args = ", ".join(signal_text(arg) if isinstance(arg, Name | Call) else "?" for arg in node.args)
    return f"{node.name}({args})" + (f".{node.attribute}" if node.attribute else "")


_LEVELS = {"+": 1, "-": 1, "*": 2, "/": 2, "^": 4}


def text_of(node: Node) -> str:
    """A readable text of a tree, for messages; it parses to the same tree."""
    return _text(node)[0]


def _text(node: Node) -> tuple[str, int]:
    """The text and how tightly its outermost operation binds."""
    if isinstance(node, Number):
        return (f"{node.value:.12g} {node.unit}", 4) if node.unit else (f"{node.value:.12g}", 5)
    if isinstance(node, Name):
        return node.text, 5
    if isinstance(node, Negative):
        return "-" + _within(node.of, 3), 3
    if isinstance(node, Binary):
        level = _LEVELS[node.op]
        left, right = (level, level + 1) if level < 4 else (level + 1, 3)
        space = " " if level < 3 else ""
        # Behind a number with a unit, a factor such as "s" would be read as part of the unit.
        taken = level == 2 and isinstance(node.right, Name) and is_unit(node.right.text) and _ends_in_unit(node.left)
        right_text = _within(node.right, 6 if taken else right)
        return f"{_within(node.left, left)}{space}{node.op}{space}{right_text}", level
    args = ", ".join(text_of(arg) for arg in node.args)
    return f"{node.name}({args})" + (f".{node.attribute}" if node.attribute else ""), 5


def _ends_in_unit(node: Node) -> bool:
    while isinstance(node, Binary | Negative):
        node = node.right if isinstance(node, Binary) else node.of
    return isinstance(node, Number) and node.unit is not None


def _within(node: Node, least: int) -> str:
    text, level = _text(node)
    return text if level >= least else f"({text})"
