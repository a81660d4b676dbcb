"""What a cam is milled with, and the motions of the whole job: approach, passes, finish, spring pass, retreat."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from linkwright.cam.disc import Disc
from linkwright.cam.nc.lead_in import around
from linkwright.cam.nc.path import CutterPath, Element
from linkwright.data_classes import dataclass


@dataclass(frozen=True)
class MillingJob:
    """Lengths in mm, speeds in mm/min and rpm. ``tolerance`` is how far the lift may be off (m or rad),
    ``blend`` (mm) how far a control that rounds corners may leave the path.

    ``depth`` is the cam's thickness with what the cutter goes beyond it, in passes of ``step`` at the most; these leave
    ``allowance`` for a last one at full depth, which ``spring`` repeats. ``climb``: with M3 clockwise around the cam.
    ``compensation``: the profile is programmed, and the control offsets the cutter (G41, G42). The path is entered and
    left on quarter circles of the radius ``lead`` and goes on beyond its start by ``overlap``, from the cam angle
    ``start`` (rad) on. ``arcs``: by G2 and G3, else chords alone. ``groove``: what is milled is the groove in which the
    roller runs, ``depth`` deep.
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
    groove: bool = False

    @property
    def levels(self) -> list[float]:
        """The depths (negative) of the passes."""
        count = max(1, math.ceil(self.depth / self.step - 1e-9))
        return [-self.depth * (i + 1) / count for i in range(count)]


@dataclass(frozen=True)
class Pass:
    """Around the cam: the elements at the depth ``z``, those of entry and exit among them; ``entry`` is where the
    cutter goes down. With ``heights`` it goes down on its way from the top: the depths at the elements' ends.

    ``side`` is +1 where the control runs the cutter left of the path (G41), -1 right (G42), 0 on it; that is switched
    on and off on straight ways of the length ``aside`` (mm), on the side away from what is cut.
    """

    z: float
    elements: tuple[Element, ...]
    note: str
    heights: tuple[float, ...] = ()
    side: int = 0
    aside: float = 0.0

    @property
    def entry(self) -> tuple[float, float]:
        """Where the cutter goes down."""
        return self.elements[0].start


def way(disc: Disc, job: MillingJob) -> int:
    """+1 where the cutter goes with growing cam angle; with M3 a climbing cutter goes clockwise around the outside."""
    return disc.sense if job.climb else -disc.sense


def side(job: MillingJob) -> int:
    """The side on which a control runs the cutter: a climbing one with M3 has what it cuts on its right."""
    return (1 if job.climb else -1) if job.compensation else 0


def path(disc: Disc, job: MillingJob, allowance: float = 0.0) -> CutterPath:
    """The programmed path of a pass that leaves an allowance (mm)."""
    offset = allowance / 1e3 - disc.follower.radius + (0.0 if job.compensation else job.cutter / 1e3)
    allowed = job.tolerance
    return CutterPath(disc, offset, job.start, way(disc, job), allowed, job.decimals, job.arcs)


def passes(disc: Disc, job: MillingJob) -> Iterator[Pass]:
    """All passes around a profile, from the top down."""

    def profile_pass(allowance: float, note: str) -> Pass:
        elements = around(path(disc, job, allowance), job.overlap, job.lead)
        return Pass(-job.depth, elements, note, side=side(job), aside=job.cutter + job.lead)

    if job.allowance > 0:
        rough = profile_pass(job.allowance, "rough")
        for z in job.levels:
            yield replace(rough, z=z)
        finish = profile_pass(0.0, "finish")
        yield finish
    else:
        finish = profile_pass(0.0, "finish")
        for z in job.levels:
            finish = replace(finish, z=z)
            yield finish
    if job.spring:
        yield replace(finish, note="spring")
