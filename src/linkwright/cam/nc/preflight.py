"""What speaks against a job before a line of it is written."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from linkwright.cam.disc import Disc
from linkwright.cam.extremes import curvature, extremes
from linkwright.cam.nc.groove import Groove
from linkwright.cam.nc.job import MillingJob, path
from linkwright.cam.nc.posts import Post
from linkwright.cam.nc.reader import NCFault

SMALLEST = 10
"""A cutter's radius is no smaller than so many of the last digits of the coordinates."""
STILL = 1e-9
"""A follower that moves less than this (m or rad per rad) dwells."""


def faults(disc: Disc, job: MillingJob, post: Post) -> Iterator[NCFault]:
    """Why a job can't be milled so, or not on this control; line 0."""
    roller = disc.follower.radius
    sharpest = extremes(disc, curvature())[1]
    if roller * sharpest.value >= 1:
        data = {"theta": f"{math.degrees(sharpest.theta):.4g}", "radius": f"{1e3 / sharpest.value:.4g}"}
        yield NCFault("nc.undercut", 0, data | {"roller": f"{1e3 * roller:.4g}"})
        return
    smallest = SMALLEST * 10.0**-job.decimals
    if job.cutter < smallest:
        yield NCFault("nc.small-cutter", 0, {"cutter": f"{job.cutter:.4g}", "smallest": f"{smallest:.4g}"})
        return
    hollow = extremes(disc, curvature(-roller))[0]
    if hollow.value < 0 and -1e3 / hollow.value <= job.cutter * (1 + 1e-9):
        data = {"theta": f"{math.degrees(hollow.theta):.4g}", "radius": f"{-1e3 / hollow.value:.4g}"}
        yield NCFault("nc.concave", 0, data | {"cutter": f"{job.cutter:.4g}"})
    if job.groove:
        yield from _groove(disc, job)
    if job.compensation and not post.compensates:
        yield NCFault("nc.no-compensation", 0, {"post": post.name})
    if job.compensation and job.lead <= job.cutter:
        yield NCFault("nc.short-lead", 0, {"lead": f"{job.lead:.4g}", "cutter": f"{job.cutter:.4g}"})
    if job.decimals > post.most:
        yield NCFault("nc.decimals", 0, {"post": post.name, "most": str(post.most)})
    least = 1e3 * min(_allowed(disc, job), default=math.inf)
    rounding = 10.0**-job.decimals / math.sqrt(2)
    if least < rounding:
        yield NCFault("nc.fine", 0, {"allowed": f"{least:.2g}", "rounding": f"{rounding:.2g}"})


def _groove(disc: Disc, job: MillingJob) -> Iterator[NCFault]:
    """Hollows of both flanks have larger radii than the roller, so a cutter that fits between them fits into these."""
    roller, cutter = 1e3 * disc.follower.radius, job.cutter
    if cutter > roller * (1 + 1e-9):
        yield NCFault("nc.wide-cutter", 0, {"cutter": f"{cutter:.6g}", "roller": f"{roller:.6g}"})
        return
    deepest = extremes(disc, curvature())[0]
    if 1e-3 * roller * -deepest.value >= 1:
        data = {"theta": f"{math.degrees(deepest.theta):.4g}", "radius": f"{-1e3 / deepest.value:.4g}"}
        yield NCFault("nc.undercut-outer", 0, data | {"roller": f"{roller:.4g}"})
        return
    work = Groove(disc, job)
    if (left := work.max_side_offset - work.cleared) > cutter:
        yield NCFault("nc.allowance", 0, {"allowance": f"{left:.4g}", "cutter": f"{cutter:.4g}"})
    if job.compensation and job.lead > cutter and any(work.finishing_lead(flank) is None for flank in (-1, 1)):
        yield NCFault("nc.groove-lead", 0, {"cutter": f"{cutter:.4g}", "roller": f"{roller:.4g}"})


def warnings(disc: Disc, job: MillingJob) -> Iterator[NCFault]:
    """What is unwise."""
    moving = np.abs(np.broadcast_to(disc.look(np.array([job.start])).lift.d[1], 1))[0]
    if moving > STILL:
        yield NCFault("nc.no-dwell", 0, {"theta": f"{math.degrees(job.start):.4g}"})


def _allowed(disc: Disc, job: MillingJob) -> Iterator[float]:
    """How far elements may be off along the path (m)."""
    yield from path(disc, job).at(np.linspace(0.0, 1.0, 721))[3] / 1e3
