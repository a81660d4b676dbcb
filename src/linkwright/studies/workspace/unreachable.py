"""Lengths that never close: by how much they miss, at the drives' values where they miss least."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.findings import Joined
from linkwright.graph.assembly import shortfall_data
from linkwright.graph.geometry import Geometry
from linkwright.graph.motion import solve_motion
from linkwright.groups import Dyad
from linkwright.kernels import Compiled
from linkwright.notation import Jet
from linkwright.structure import Group
from linkwright.studies.workspace.assembly_signs import combinations

STEPS = 20


class _Misses(Exception):
    """A group can't be closed."""


class _LengthGap:
    """How much is missing at drive values: the group that fails first, what it must span and what it can."""

    def __init__(self, compiled: Compiled, parameters: Mapping[str, float]) -> None:
        self.compiled = compiled
        self.geometry = Geometry(compiled.quantities, parameters)
        self.group: Group | None = None
        self.distance, self.limit = 0.0, 0.0

    def gap_at(self, q: Iterable[float], signs: tuple[float, ...]) -> tuple[int, float]:
        """How many groups are left from the first that fails, and by how much (m) that one does; (0, 0) for none."""
        groups = self.compiled.structure.groups
        given: dict[Group, float] = dict(zip(self.compiled.graph.branched, signs, strict=True))
        self.group = None

        def branch(group: Group, dyad: Dyad) -> float:
            missed = dyad.shortfall()
            if missed is not None:
                self.group, (self.distance, self.limit) = group, missed
                raise _Misses
            return given.get(group, 1.0)

        drives = {name: Jet([float(v)]) for name, v in zip(self.compiled.graph.drives, q, strict=True)}
        try:
            with np.errstate(all="ignore"):
                solve_motion(self.compiled.structure, self.geometry, drives, branch, _none)
        except (_Misses, ZeroDivisionError):
            pass
        if self.group is None:
            return 0, 0.0
        return len(groups) - groups.index(self.group), float(abs(self.distance - self.limit))


def _none(_: Any) -> list[float]:
    return []


def unreachable_data(
    compiled: Compiled, ranges: Sequence[tuple[float, float]], parameters: Mapping[str, float]
) -> dict[str, Any] | None:
    """What a finding says of lengths that close at no values of the drives; ``None`` where they do somewhere."""
    from scipy.optimize import minimize

    gap = _LengthGap(compiled, parameters)
    axes = [np.linspace(low, high, STEPS + 1) for low, high in ranges]
    places = np.stack(np.meshgrid(*axes)).reshape(len(ranges), -1).T
    looked = [(gap.gap_at(q, signs), tuple(q), signs) for signs in combinations(compiled) for q in places]
    (left, least), start, signs = min(looked)
    if not left:
        return None

    def missing(q: NDArray[np.float64]) -> float:
        low_left, by = gap.gap_at(q, signs)
        inside = all(a - 1e-12 <= v <= b + 1e-12 for v, (a, b) in zip(q, ranges, strict=True))
        return float(by) if low_left == left and inside else 2 * least + 1.0

    best = minimize(missing, start, method="Nelder-Mead", options={"xatol": 1e-9, "fatol": 1e-15 * (1 + least)})
    place = best.x if best.fun <= least else np.array(start)
    gap.gap_at(place, signs)
    assert gap.group is not None
    told = shortfall_data(compiled.quantities, gap.group, gap.distance, gap.limit)
    at = []
    for drive, value in zip(compiled.graph.drives, place, strict=True):
        unit, size = compiled.quantities.drive_unit(drive)
        at.append(f"{drive} = {value / size:.6g} {unit}")
    return {**told, "at": Joined(at)}
