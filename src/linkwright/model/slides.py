"""Loops of slides: links that only slides join keep their directions to each other, in such a loop one slide too many.

Around a loop of slides alone the last slide's two directions agree already, so that it states one equation instead of
two, and the loop has one more degree of freedom than Gruebler's count says. By which slides of the loop moments pass
isn't determined by statics: a couple may go round through all of them.
"""

from __future__ import annotations

from collections.abc import Iterable

from linkwright.model.mechanism import Mechanism

Pair = frozenset[str]


def pairs_of(m: Mechanism) -> dict[str, Pair]:
    """The two links of each slide; of several slides between the same two links the first one."""
    found: dict[Pair, str] = {}
    for name, joint in m.prismatic_joints():
        found.setdefault(frozenset(joint.links), name)
    return {name: pair for pair, name in found.items() if len(pair) == 2}


def closing(pairs: Iterable[tuple[str, Pair]]) -> list[str]:
    """The slides that close a loop of slides named before them."""
    parts: dict[str, set[str]] = {}
    found = []
    for name, (a, b) in ((name, tuple(pair)) for name, pair in pairs):
        first, second = (parts.setdefault(link, {link}) for link in (a, b))
        if first is second:
            found.append(name)
            continue
        first |= second
        parts |= dict.fromkeys(second, first)
    return found


def in_loops(m: Mechanism) -> tuple[str, ...]:
    """The slides that lie in a loop of slides, whose moments statics doesn't determine."""
    pairs = pairs_of(m)
    return tuple(name for name, pair in pairs.items() if _around(pairs, name, pair))


def _around(pairs: dict[str, Pair], name: str, pair: Pair) -> bool:
    """Whether the other slides join the two links of one."""
    others = [(other, links) for other, links in pairs.items() if other != name]
    return closing([*others, (name, pair)])[-1:] == [name]
