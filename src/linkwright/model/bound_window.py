"""A window bound to SI, as all ask it that looks at one: runs, many samples, derivatives, the graph, its check."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from linkwright.data_classes import dataclass
from linkwright.expressions.dimensions import Dimensions
from linkwright.expressions.fields import Expression
from linkwright.expressions.language import Node, parse
from linkwright.expressions.units import ANGLE, TIME, Dimension


@dataclass(frozen=True)
class BoundWindow:
    """Where a signal lies between two ends, which are expressions of parameters; of an angle, also any whole turns
    from there. Without a ``signal`` it is the time that lies there."""

    ends: tuple[Expression, Expression]
    signal: str | None = None
    node: Node | None = None
    """The signal bound to SI."""
    dimension: Dimension = TIME

    @classmethod
    def of(cls, entry: Any, dimensions: Dimensions) -> BoundWindow:
        """What a file states: two ends, or these of one signal."""
        if not isinstance(entry, Mapping):
            return cls(entry)
        ((text, ends),) = entry.items()
        node = parse(text)
        return cls(ends, text, dimensions.bind(node, None), dimensions.dimension(node))

    @property
    def turning(self) -> bool:
        """Whether whole turns don't count."""
        return self.dimension == ANGLE

    @property
    def nodes(self) -> list[Node]:
        """The expressions of signals on which it depends."""
        return [] if self.node is None else [self.node]
