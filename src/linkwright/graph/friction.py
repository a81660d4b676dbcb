"""Efforts that follow from the reactions which they change in turn: Coulomb's friction.

All reactions are affine in the efforts m, so that the forces of seats are f(m) = f0 + B m, and each effort obeys
m_i = factor_i * sum |f_i(m)| + rest_i, the sum over its seats. Newton's method solves this while the factors grow from
zero in a few shares, in a fixed number of steps that are part of the program: every kernel runs them, and as the last
step carries the derivatives of an implicit function, rates and sensitivities are exact. Whether the steps arrived, and
whether the mechanism jams, is judged by :mod:`linkwright.results.jamming`, from the rows of the system.

Most of the steps belong to the whole factors. The size of a force has a kink where the force passes through zero, and
Newton's method goes to and fro across it before it converges; the shares only have to bring it near the solution that
belongs to the motion.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import field
from typing import TYPE_CHECKING, NamedTuple

from linkwright.data_classes import dataclass
from linkwright.elements.force import Acting, Reactions, Resistance, Seats
from linkwright.groups.linear import Factor
from linkwright.notation import Scalar, Wrench
from linkwright.notation.jets import call

if TYPE_CHECKING:
    from collections.abc import Callable

    from linkwright.graph.forces import Forces
    from linkwright.graph.view import View

STEPS_AT_SHARE = {0.25: 1, 0.5: 1, 0.75: 1, 1.0: 9}
"""The shares of the factors in turn, and Newton's steps for each. One share and four steps serve far from jamming and
from forces that pass through zero."""
SOLVED = 1e-9
"""Efforts whose laws miss by more than this share of their sum aren't a solution: they are NaN."""
TINY = 1e-300
"""Added to the square of a force (N2), so that one that is zero has slopes ..."""
LEAST = math.sqrt(TINY)
"""... and the length of such a force (N), which is no force."""


class Resisting(NamedTuple):
    """What resists, as a pose asks it: what an effort of 1 does to links, its law, and the forces of its seats."""

    name: str
    units: list[tuple[str, Wrench]]
    law: Resistance
    seats: Callable[[Reactions], Seats]

    @classmethod
    def of(cls, view: View, one: Acting) -> Resisting:
        """An element at the pose of a view."""
        kind, name, entry = one.kind, one.name, one.entry
        return cls(
            name,
            [*kind.unit_wrenches(view, name, entry)],
            kind.resistance(view, name, entry),
            lambda reactions: kind.seats(view, name, entry, reactions),
        )


@dataclass
class FrictionSystem:
    """The laws of all efforts: of each the forces of its seats with no effort, and what a unit of each effort adds."""

    names: list[str]
    laws: list[Resistance]
    loads: list[list[tuple[Scalar, ...]]]
    slopes: list[list[list[tuple[Scalar, ...]]]]  # by effort, then by unit of an effort, as the loads
    drives: dict[str, Scalar]  # the drives' efforts with no effort of friction
    efforts: dict[str, Scalar] = field(default_factory=dict)

    @classmethod
    def of(cls, resisting: Sequence[Resisting], base: Forces, alone: Sequence[Forces]) -> FrictionSystem:
        """The system from the forces without any effort, and those of a unit of each alone."""

        def seats(one: Resisting, forces: Forces) -> list[tuple[Scalar, ...]]:
            return [*one.seats(forces.reaction)]

        return cls(
            [one.name for one in resisting],
            [one.law for one in resisting],
            [seats(one, base) for one in resisting],
            [[seats(one, forces) for forces in alone] for one in resisting],
            base.efforts,
        )

    def solved(self) -> list[Scalar]:
        """The efforts (N, N m); NaN where the steps didn't arrive, or jamming was passed."""
        m: list[Scalar] = [0.0 for _ in self.names]
        coulomb = any(self.loads) and any(not _zero(law.factor) for law in self.laws)
        sound: Scalar = 1.0
        for share, steps in STEPS_AT_SHARE.items() if coulomb else ((1.0, 1),):
            for _ in range(steps):
                gaps, rows = self._linear(m, share)
                m = [one - step for one, step in zip(m, Factor(rows).solve(gaps), strict=True)]
            sound = sound * (determinant(rows) > 0)
        if coulomb:
            size = sum((call("abs", one) for one in m), TINY)
            for gap in self._linear(m, 1.0)[0]:
                sound = sound * (call("abs", gap) <= SOLVED * size)
            m = [call("where", sound, one, math.nan) for one in m]
        self.efforts = dict(zip(self.names, m, strict=True))
        return m

    @property
    def shape(self) -> list[list[int]]:
        """Of each effort how many parts the force of each seat has."""
        return [[len(load) for load in loads] for loads in self.loads]

    @property
    def numbers(self) -> list[Scalar]:
        """Of each effort its factor and rest, then of each seat the force, and what a unit of each effort adds."""
        found: list[Scalar] = []
        for law, loads, slopes in zip(self.laws, self.loads, self.slopes, strict=True):
            found += [law.factor, law.rest]
            for k, load in enumerate(loads):
                found += [*load, *(part for unit in slopes for part in unit[k])]
        return found

    def _linear(self, m: list[Scalar], share: float) -> tuple[list[Scalar], list[list[Scalar]]]:
        """What the laws with a share of their factors miss at some efforts, and the slopes of that to each effort."""
        gaps: list[Scalar] = []
        rows: list[list[Scalar]] = []
        for i, law in enumerate(self.laws):
            size: Scalar = 0.0
            grown: list[Scalar] = [0.0 for _ in m]
            for k, load in enumerate(self.loads[i]):
                per = [unit[k] for unit in self.slopes[i]]
                force = [
                    part + sum((unit[a] * effort for unit, effort in zip(per, m, strict=True)), 0.0)
                    for a, part in enumerate(load)
                ]
                length = call("sqrt", sum((part * part for part in force), TINY))
                size = size + (length - LEAST)  # none presses where there is no force: LEAST is a root taken exactly
                for j, unit in enumerate(per):
                    along = sum((part * slope for part, slope in zip(force, unit, strict=True)), 0.0)
                    grown[j] = grown[j] + along / length
            factor = law.factor if share == 1 else law.factor * share
            gaps.append(m[i] - factor * size - law.rest)
            rows.append([(1.0 if i == j else 0.0) - factor * slope for j, slope in enumerate(grown)])
        return gaps, rows


def determinant(rows: list[list[Scalar]]) -> Scalar:
    """The determinant with its sign, by elimination without exchanges: the matrix is the unit matrix and less than what
    would make it singular."""
    left, product = [list(row) for row in rows], 1.0
    for k, row in enumerate(left):
        product = product * row[k]
        for other in left[k + 1 :]:
            factor = other[k] / row[k]
            other[k:] = [a - factor * b for a, b in zip(other[k:], row[k:], strict=True)]
    return product


def _zero(value: Scalar) -> bool:
    return isinstance(value, int | float) and value == 0
