"""The assembly modes of a mechanism of dyads as signs of its groups, named as a file states them."""

from __future__ import annotations

import itertools

from linkwright.kernels import Compiled

Signs = tuple[float, ...]


def combinations(compiled: Compiled, which: str = "all") -> list[Signs]:
    """The signs of the groups with two modes, in their order: all combinations, the file's own first, or that alone.

    A cylinder's group has one: its length isn't negative.
    """
    groups, own = compiled.graph.branched, compiled.assembly.branches
    mine = tuple(float(own[group]) for group in groups)
    if which == "own":
        return [mine]
    cylinders = compiled.mechanism.cylinders
    free = [(s,) if group.inner.joint in cylinders else (s, -s) for group, s in zip(groups, mine, strict=True)]
    return [*itertools.product(*free)]


def named(compiled: Compiled, signs: Signs) -> str:
    """A mode by the rules that a file's assembly section would hold; nothing where there is one mode only."""
    return "; ".join(group.rule(sign) for group, sign in zip(compiled.graph.branched, signs, strict=True))
