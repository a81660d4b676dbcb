"""What a cam is milled with, and the motions of the whole job: approach, passes, finish, spring pass, retreat."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from linkwright.cam.disc import Disc
from linkwright.cam.nc.path import Element, Path

Array = NDArray[np.float64]

QUARTER = math.pi / 2


@dataclass(frozen=True)
class Job:
    """Lengths in mm, speeds in mm/min and rpm. ``tolerance`` is how far the lift may be off (m or rad),
    ``blend`` (mm) how far a control that rounds corners may leave the path.

    ``depth`` is the cam's thickness with what the cutter goes beyond it, in passes of ``step`` at the most; these leave
    ``allowance`` for a last one at full depth, which ``spring`` repeats. ``climb``: with M3 clockwise around the cam.
    ``compensation``: the profile is programmed, and the control offsets the cutter (G41, G42). The path is entered and
    left on quarter circles of the radius ``lead`` and goes on beyond its start by ``overlap``, from the cam angle
    ``start`` (rad) on. ``arcs``: by G2 and G3, else chords alone.
    """

    cutter: float
    depth: float
    tolerance: float
    step: float
    feed: float
    plunge: float
    speed: float
    start: float = 0.0
    blend: float = 1e-3
    allowance: float = 0.0
    spring: bool = True
    climb: bool = True
    compensation: bool = False
    arcs: bool = True
    decimals: int = 4
    lead: float = 5.0
    overlap: float = 2.0
    clear: float = 5.0
    tool: int = 1
    number: int = 1000
    name: str = "CAM"

    @property
    def levels(self) -> list[float]:
        """The depths (negative) of the passes."""
        count = max(1, math.ceil(self.depth / self.step - 1e-9))
        return [-self.depth * (i + 1) / count for i in range(count)]


@dataclass(frozen=True)
class Pass:
    """One time around: the elements at the depth ``z``, those of entry and exit among them; ``entry`` is where the
    cutter goes down. ``leads`` are the first and the last element."""

    z: float
    elements: tuple[Element, ...]
    note: str

    @property
    def entry(self) -> tuple[float, float]:
        """Where the cutter goes down."""
        return self.elements[0].start


def way(disc: Disc, job: Job) -> int:
    """+1 where the cutter goes with growing cam angle; with M3 a climbing cutter goes clockwise around the outside."""
    return disc.sense if job.climb else -disc.sense


def path(disc: Disc, job: Job, allowance: float = 0.0) -> Path:
    """The programmed path of a pass that leaves an allowance (mm)."""
    offset = allowance / 1e3 - disc.follower.radius + (0.0 if job.compensation else job.cutter / 1e3)
    allowed = job.tolerance
    return Path(disc, offset, job.start, way(disc, job), allowed, job.decimals, job.arcs)


def passes(disc: Disc, job: Job) -> Iterator[Pass]:
    """All passes, from the top down."""
    if job.allowance > 0:
        rough = around(path(disc, job, job.allowance), job)
        for z in job.levels:
            yield Pass(z, rough, "rough")
        finish = Pass(-job.depth, around(path(disc, job), job), "finish")
        yield finish
    else:
        finish = Pass(0.0, around(path(disc, job), job), "finish")
        for z in job.levels:
            finish = replace(finish, z=z)
            yield finish
    if job.spring:
        yield replace(finish, note="spring")


def around(route: Path, job: Job) -> tuple[Element, ...]:
    """Entry, once around with the overlap, exit."""
    turn = route.elements()
    more = share(route, job.overlap)
    again = route.elements(more)
    _, tangents, normals, _ = route.at(np.array([0.0, more]))
    first = _lead(np.array(turn[0].start), tangents[:, 0], normals[:, 0], job.lead, job.decimals, True)
    last = _lead(np.array(again[-1].end), tangents[:, 1], normals[:, 1], job.lead, job.decimals, False)
    return (first, *turn, *again, last)


def share(route: Path, length: float) -> float:
    """The share of the turn that a length (mm) from the start takes, about."""
    look = route.look(np.zeros(1))
    speed = 1e3 * float(np.broadcast_to(look.speed.d[0], 1)[0] * abs(look.radius(route.offset)[0] / look.radius()[0]))
    return min(0.25, length / (speed * 2 * math.pi))


def _lead(at: Array, tangent: Array, normal: Array, radius: float, decimals: int, entry: bool) -> Element:
    """A quarter circle that comes in along the normal and ends on the tangent, or the reverse."""
    centre = at + radius * normal
    away = np.round(centre + (-radius if entry else radius) * tangent, decimals)
    turn = 1 if tangent[0] * normal[1] - tangent[1] * normal[0] > 0 else -1
    start, end = (away, at) if entry else (at, away)
    middle = _centre(start, end, turn * QUARTER, decimals)
    return Element(tuple(start), tuple(end), middle, turn)


def _centre(start: Array, end: Array, angle: float, decimals: int) -> tuple[float, float]:
    along = end - start
    found = (start + end) / 2 + np.array([-along[1], along[0]]) / (2 * math.tan(angle / 2))
    return tuple(start + np.round(found - start, decimals + 1))
