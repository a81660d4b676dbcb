"""Long functions split over helping joints: each stands for a part, within the longest text that is allowed."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import field

from linkwright.data_classes import dataclass
from linkwright.exports.process_simulate.trees import Tree, add, joint, multiply, number

Size = Callable[[Tree], int]
Start = Callable[[Tree], float]
Name = Callable[[str, int], str]


@dataclass
class _Split:
    """``size`` tells how long a tree's text is, ``start`` its value at the zero pose, where all joints are 0, and
    ``name`` what the n-th helper of a joint is called."""

    longest: int
    size: Size
    start: Start
    name: Name
    functions: dict[str, Tree] = field(default_factory=dict)
    parts: dict[Tree, Tree] = field(default_factory=dict)
    helpers: int = 0

    def function(self, of: str, tree: Tree) -> bool:
        """Add a function, and before it the helpers that it wants; whether it is short enough then."""
        for part, helper in self.parts.items():
            if self.size(tree) > self.longest:
                tree = _replaced(tree, part, helper)
        while (size := self.size(tree)) > self.longest:
            best = None
            for part in set(tree.every()) - {tree}:
                if part.op in ("number", "T", "D"):
                    continue
                helping = add(part, number(-self.start(part)))
                helper = add(joint("D", self.name(of, self.helpers + 1)), number(self.start(part)))
                if self.size(helping) > self.longest:
                    continue
                rest = _replaced(tree, part, helper)
                key = (self.size(rest), self.size(helping), repr(part))
                if key[0] < size and (best is None or key < best[0]):
                    best = key, part, helping, helper, rest
            if best is None:
                return False
            _, part, helping, helper, tree = best
            self.helpers += 1
            self.functions[self.name(of, self.helpers)] = helping
            self.parts[part] = helper
        self.functions[of] = tree
        return True


def split(functions: Mapping[str, Tree], longest: int, size: Size, start: Start, name: Name) -> dict[str, Tree] | None:
    """Functions within a length, helpers before those that ask for them; ``None`` where that can't be.

    A helper is a sliding joint, whatever its value means: such a value has no turns.
    """
    made = _Split(longest, size, start, name)
    if all(made.function(of, tree) for of, tree in functions.items()):
        return made.functions
    return None


def least(functions: Mapping[str, Tree], longest: int, size: Size, start: Start, name: Name) -> int:
    """The least length over ``longest``, which isn't enough, to which functions can be split."""
    low, high = longest, max(map(size, functions.values()))
    while high - low > 1:
        middle = (low + high) // 2
        if split(functions, middle, size, start, name) is None:
            low = middle
        else:
            high = middle
    return high


def _replaced(tree: Tree, part: Tree, by: Tree) -> Tree:
    """A tree with another in place of all that are like ``part``."""
    if tree == part:
        return by
    args = tuple(_replaced(arg, part, by) for arg in tree.args)
    if args == tree.args:
        return tree
    made = {"+": add, "*": multiply}.get(tree.op)
    return made(*args) if made else Tree(tree.op, args)
