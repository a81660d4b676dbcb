"""What rules of assembly as ``C: left of B-D`` mean, in a sentence for whoever reads a table of modes."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from linkwright.findings import Said

_RULE = re.compile(r"([^\s;:]+): (left|right) of ([^\s-]+)-([^\s;-]+)")


def side_sentences(rules: Iterable[str]) -> Iterator[Said]:
    """The sentence on the first rule of a side among some; none where there is no such rule."""
    for rule in rules:
        if match := _RULE.search(rule):
            point, side, first, second = match.groups()
            yield Said(f"assembly.side.{side}", rule=match.group(), point=point, first=first, second=second)
            return
