"""Followers as functions of the driving joint: the pieces of the motion law, each times 1 where it holds and
times 0 elsewhere, which comparisons say."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from math import floor, pi

import numpy as np

from linkwright.data_classes import dataclass
from linkwright.exports.followed_laws import Ridden, ridden
from linkwright.exports.process_simulate.fitting import horner, polynomial
from linkwright.exports.process_simulate.linkage import MM
from linkwright.exports.process_simulate.motion import ToolMotion
from linkwright.exports.process_simulate.trees import Tree, add, call, joint, multiply, number
from linkwright.laws.pieces import Piece, SmoothPart

FITTED, HALVED, SAMPLES = 1e-10, 6, 64
"""A formula of the file's own becomes polynomials within this (rad or mm): times it is halved, places of each part."""


def followers(motion: ToolMotion) -> dict[str, Tree]:
    """The value of each follower (rad or mm, its own whole turns kept) from the driving joint's."""
    every = ((name, ridden(motion.compiled, name)) for name in motion.compiled.mechanism.followers)
    return {name: _Follower(motion, name, how).tree() for name, how in every if how is not None}


@dataclass(frozen=True)
class _Term:
    """A formula of the driving joint's value up to where the next one begins."""

    start: float
    tree: Tree


class _Follower:
    def __init__(self, motion: ToolMotion, name: str, how: Ridden) -> None:
        unit = 1.0 if motion.compiled.mechanism.followers[name].turning else MM
        self.scale, self.base = how.scale * unit, how.base * unit
        self.law = motion.compiled.motions[how.law]
        # The law's argument is ahead + way times the driving joint's value.
        self.way = how.way * motion.sign / motion.unit
        self.ahead = how.way * motion.reach.zero + how.ahead
        self.moved = joint(motion.joint.kind, motion.joint.joint)
        self.ends = tuple(float(end) for end in motion.of_drive(np.array(motion.hull)))

    def tree(self) -> Tree:
        """All pieces of the range, the first and the last one open at their outer ends."""
        terms: list[_Term] = []
        for term in sorted(self.terms(), key=lambda term: term.start):
            if not terms or terms[-1].tree != term.tree:
                terms.append(term)
        starts = [number(term.start) for term in terms]
        masked = []
        for i, term in enumerate(terms):
            masks = [call(">=", self.moved, starts[i])] if i else []
            masks += [call("<", self.moved, starts[i + 1])] if i + 1 < len(terms) else []
            masked.append(multiply(*masks, term.tree))
        return add(number(self.base), *masked)

    def terms(self) -> Iterator[_Term]:
        """The pieces of the law's turns that the range meets."""
        period = self.law.period
        low, high = sorted(self.ahead + self.way * end for end in self.ends)
        for turn in range(floor(low / period), floor(high / period) + 1):
            for part in self.law.curve.parts:
                start, stop = part.start + turn * period, part.stop + turn * period
                if start < high and stop > low:
                    yield from self.formulas(part, turn * period)

    def formulas(self, part: SmoothPart, shift: float) -> Iterator[_Term]:
        """One piece, ``shift`` (rad) later in the law."""
        if isinstance(part, Piece):
            yield _Term(self.start(part.start + shift, part.stop + shift), self.piece(part, shift))
            return
        for start, stop, coefficients in _fitted(part, part.start, part.stop, FITTED / abs(self.scale)):
            width = stop - start
            across = self.argument(2 / width, (start + stop) / 2 + shift)
            yield _Term(self.start(start + shift, stop + shift), horner(self.scale * coefficients, across))

    def start(self, start: float, stop: float) -> float:
        """The least value of the driving joint on a stretch of the law."""
        return min((end - self.ahead) / self.way for end in (start, stop))

    def argument(self, factor: float, origin: float) -> Tree:
        """The law's argument less an origin, times a factor."""
        return add(multiply(number(factor * self.way), self.moved), number(factor * (self.ahead - origin)))

    def piece(self, part: Piece, shift: float) -> Tree:
        """Powers by Horner's scheme over the width of the piece, so that decimals do; and waves."""
        width, origin = part.stop - part.start, part.origin + shift
        powers = [self.scale * power * width**i for i, power in enumerate(part.powers)] or [0.0]
        while len(powers) > 1 and not powers[-1]:
            powers.pop()
        terms = [horner(np.array(powers), self.argument(1 / width, origin))]
        for amplitude, rate, even in part.waves:
            turned = self.argument(rate * pi, origin)
            terms.append(multiply(number(self.scale * amplitude), call("cos" if even else "sin", turned)))
        return add(*terms)


def _fitted(
    part: SmoothPart, start: float, stop: float, tolerance: float, depth: int = 0
) -> Iterator[tuple[float, float, np.typing.NDArray[np.float64]]]:
    """Polynomials in -1..1 over parts of a stretch, by rising power, within a tolerance (as the law has its values)."""
    x = (start + stop) / 2 - (stop - start) / 2 * np.cos(np.linspace(0, pi, SAMPLES + 1))
    coefficients, error = polynomial(x, part.at(x, 0), tolerance)
    if error <= tolerance or depth == HALVED:
        yield start, stop, coefficients
        return
    for a, b in pairwise((start, (start + stop) / 2, stop)):
        yield from _fitted(part, a, b, tolerance, depth + 1)
