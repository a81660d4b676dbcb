"""The passes that mill a groove: down a ramp along the pitch curve, beside it, and along both flanks.

The cutter's centre may be as far beside the pitch curve as the roller's radius exceeds the cutter's. A first slot along
the pitch curve is entered at the top and goes down by a step in each turn, so nothing is plunged into the full. All
other passes start where something has been cut before, on quarter circles that stay within the groove.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from functools import cached_property
from itertools import accumulate
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.cam.disc import TURN, Disc
from linkwright.cam.nc.job import MillingJob, Pass, side, way
from linkwright.cam.nc.lead_in import around, beyond, leads, path_ends, share
from linkwright.cam.nc.path import CutterPath, Element
from linkwright.data_classes import dataclass

Array = NDArray[np.float64]

FLANKS = {-1: "inner", 1: "outer"}
SPOTS = 7200
"""Places of the pitch curve by which it is told how far beside it something lies."""
NEAR = 1e-3
"""How well that is told (mm), a digit at the best."""
MORE = 1.25
"""Leads bring the cutter so many times as far in as it must be, if that fits."""
LEAST = 10
"""The shortest lead in units of the last digit; a path with less room is entered and left without."""
SPARE, COARSE = 0.1, 0.01
"""A path that leaves more than so much (mm) to later passes may be off by this share of it."""
ASIDE = 1.01
"""Compensation is switched on over a straight way so many times the cutter's radius."""


@dataclass(frozen=True)
class Groove:
    """A groove and the job that mills it; mm."""

    disc: Disc
    job: MillingJob

    @property
    def max_side_offset(self) -> float:
        """How far the cutter's centre may be beside the pitch curve; less than a digit is nothing."""
        room = 1e3 * self.disc.follower.radius - self.job.cutter
        return room if room >= self.unit else 0.0

    @property
    def unit(self) -> float:
        """The last digit."""
        return float(10.0**-self.job.decimals)

    @property
    def cleared(self) -> float:
        """How far the rough passes get."""
        return max(0.0, self.max_side_offset - self.job.allowance)

    def passes(self) -> Iterator[Pass]:
        """All passes."""
        yield self.slot()
        if not self.max_side_offset:
            return
        beside = self.beside()
        yield from (replace(one, z=z) for z in self.job.levels for one in beside)
        last = [self.finish(flank) for flank in FLANKS] if self._roughed else beside[-2:]
        yield from last if self._roughed else ()
        if self.job.spring:
            yield from (replace(one, z=-self.job.depth, note=f"spring: {one.note}") for one in last)

    def slot(self) -> Pass:
        """Down along the pitch curve by a step in each turn, and a turn at the full depth; a cutter as large as the
        roller finishes both flanks by it."""
        route, levels = self.route(0.0, -1, slot=True), self.job.levels
        turn, again = route.elements(), route.elements(share(route, self.job.overlap))
        gone = [length / sum(e.length for e in turn) for length in accumulate(e.length for e in turn)]
        heights = [top + (z - top) * part for top, z in zip([0.0, *levels], levels, strict=False) for part in gone]
        flat = turn * (1 if self.max_side_offset or not self.job.spring else 2) + again
        ramp = math.degrees(math.atan(-levels[0] / sum(e.length for e in turn)))
        note = f"slot, ramp {ramp:.2f} deg to"
        return Pass(-self.job.depth, (*turn * len(levels), *flat), note, (*heights, *[-self.job.depth] * len(flat)))

    def beside(self) -> list[Pass]:
        """At each level, outward from the slot by no more than the cutter's radius at a time."""
        count = math.ceil(self.cleared / self.job.cutter - 1e-9)
        made = []
        for k in range(1, count + 1):
            for flank, name in FLANKS.items():
                far = self.cleared * k / count
                route = self.route(far, flank)
                lead = self.lead(route, flank, far, 0.0, self.cleared / count) or 0.0
                note = f"{name} flank {k}/{count}"
                made.append(Pass(0.0, around(route, self.job.overlap, lead, -flank), note))
        return made

    def finish(self, flank: int) -> Pass:
        """A flank at the full depth; with compensation what is programmed is the flank itself."""
        beside, aside = side(self.job), ASIDE * self.job.cutter
        route = self.route(self.max_side_offset + (self.job.cutter if beside else 0.0), flank)
        elements = around(route, self.job.overlap, self.finishing_lead(flank) or 0.0, -flank)
        return Pass(-self.job.depth, elements, f"finish {FLANKS[flank]} flank", side=beside, aside=aside)

    def finishing_lead(self, flank: int) -> float | None:
        """The radius of its leads; with compensation they exceed the cutter, ``None`` where such don't fit."""
        aside = self.job.cutter if self.job.compensation else 0.0
        route = self.route(self.max_side_offset + aside, flank)
        return self.lead(route, flank, self.max_side_offset, -self.cleared, self.max_side_offset - self.cleared, aside)

    @property
    def _roughed(self) -> bool:
        """Whether the flanks are finished by passes of their own."""
        return self.job.allowance > 0 or self.job.compensation

    def route(self, far: float, flank: int, slot: bool = False) -> CutterPath:
        """The path so far beside the pitch curve towards a flank, which lies on the right of a climbing cutter. It is
        coarse where it leaves enough to later passes."""
        job, offset, spare = self.job, flank * far / 1e3, min(self.max_side_offset - far, self.job.cutter)
        cuts = offset if slot else flank * self.disc.follower.radius
        coarse = spare > SPARE
        allowed = COARSE * spare / 1e3 if coarse else job.tolerance
        sense = -flank * way(self.disc, job)
        return CutterPath(self.disc, offset, job.start, sense, allowed, job.decimals, job.arcs, coarse, cuts)

    def lead(
        self, route: CutterPath, flank: int, far: float, least: float, uncut: float, aside: float = 0.0
    ) -> float | None:
        """The radius of both leads: the job's, or what brings the cutter in from where nothing is left ``uncut`` (mm),
        or the largest for which it, ``aside`` of them, stays between ``least`` and ``far`` beside the pitch curve,
        towards the flank; ``None`` where there is none."""
        both, near = path_ends(route, share(route, self.job.overlap)), max(NEAR, self.unit)

        def fits(radius: float) -> bool:
            made = leads(both, radius, -flank, self.job.decimals)
            places = np.concatenate([_lead_centres(lead, aside, k > 0) for k, lead in enumerate(made)])
            beside = flank * self.offset(places)
            return bool(beside.max() <= far + near and beside.min() >= least - near)

        low, high = max(aside * (1 + NEAR), LEAST * self.unit), max(self.job.lead, MORE * uncut)
        if high <= low or not fits(low):
            return None
        if fits(high):
            return high
        while high - low > NEAR:
            middle = (low + high) / 2
            low, high = (middle, high) if fits(middle) else (low, middle)
        return low

    def offset(self, places: Array) -> Array:
        """How far places (n, 2) lie outward of the pitch curve."""
        pitch, normal, tree = self._pitch
        which = tree.query(places)[1]
        return np.asarray(((places - pitch[which]) * normal[which]).sum(axis=1))

    @cached_property
    def _pitch(self) -> tuple[Array, Array, Any]:
        """Places of the pitch curve, its outward normals there, the tree of the places."""
        from scipy.spatial import KDTree

        look = self.disc.look(np.linspace(0.0, TURN, SPOTS, endpoint=False))
        pitch = look.offset(0.0)
        return 1e3 * pitch.T, (look.offset(1.0) - pitch).T, KDTree(1e3 * pitch.T)


def _lead_centres(lead: Element, cutter: float, last: bool) -> Array:
    """Where a cutter's centre goes on a lead (n, 2); one of the radius ``cutter`` with compensation, which is switched
    on before the first lead or off after the last."""
    assert lead.centre is not None
    outer, centre = np.array(lead.end if last else lead.start), np.array(lead.centre)
    out = np.array(lead.start) - centre
    radius = float(np.hypot(*out))
    angles = math.atan2(out[1], out[0]) + lead.turn * lead.swept * np.linspace(0.0, 1.0, 17)
    arc = centre + (radius - cutter) * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    inward = (centre - outer) * cutter / radius
    beside = outer + np.array(beyond(lead, ASIDE * cutter, last))
    return np.concatenate([arc, [outer + inward, beside, beside + inward] if cutter else np.empty((0, 2))])
