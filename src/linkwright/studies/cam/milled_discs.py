"""NC code of a cam for one control: what speaks against it, the file, and its proof by reading it back."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

from linkwright.cam.cams_of_mechanism import Frame
from linkwright.cam.disc import Disc
from linkwright.cam.nc.groove import Groove
from linkwright.cam.nc.job import MillingJob, Pass, passes
from linkwright.cam.nc.path import Sharp
from linkwright.cam.nc.posts import POSTS, Post
from linkwright.cam.nc.preflight import faults, warnings
from linkwright.cam.nc.proof import NCProof, prove
from linkwright.cam.nc.reader import Move, NCFault, read
from linkwright.data_classes import dataclass
from linkwright.findings import Finding
from linkwright.studies.cam.options import PATH

AT = (*PATH, "nc")


@dataclass(frozen=True)
class Milled:
    """A file for one control and what came of reading it back. Only a ``proven`` one is written."""

    post: Post
    job: MillingJob
    text: str
    proof: NCProof

    @property
    def lines(self) -> int:
        """Of the file."""
        return self.text.count("\n")

    @property
    def longest(self) -> int:
        """The length of its longest line."""
        return max(map(len, self.text.splitlines()))

    @property
    def deep(self) -> bool:
        """Whether it is as deep as asked, but for the last digit."""
        return abs(self.job.depth - 1e3 * self.proof.depth) <= 10.0**-self.job.decimals

    @property
    def proven(self) -> bool:
        """Whether the follower's lift on the milled cam is within the tolerance, the depth as asked, and no control
        would stop."""
        proof = self.proof
        sound = not proof.faults and self.longest <= self.post.longest
        return sound and self.deep and proof.worst <= self.job.tolerance


def milled(
    disc: Disc, job: MillingJob, names: tuple[str, ...], angles: int, told: Sequence[str] = ()
) -> tuple[list[Milled], list[Finding]]:
    """A file for each control that has nothing against it, and all findings, warnings among them. ``told`` are further
    remarks in the files."""
    found = [as_finding(fault, severity="warning") for fault in warnings(disc, job)]
    made: list[Milled] = []
    ways: list[Pass] = []  # the same for all
    for post in (POSTS[name] for name in names):
        if wrong := [as_finding(fault) for fault in faults(disc, job, post)]:
            found += [finding for finding in wrong if finding not in found]
            continue
        try:
            ways = ways or [*(Groove(disc, job).passes() if job.groove else passes(disc, job))]
        except Sharp as sharp:
            data = {"theta": f"{math.degrees(sharp.theta):.4g}"}
            found.append(Finding("nc.sharp", AT, data))
            break  # it is so for all
        text = post.text(job, ways, [*notes(job), *told])
        one = Milled(post, job, text, proven(disc, job, text, angles, made))
        found += wrongs(one)
        made.append(one)
    return made, found


def proven(disc: Disc, job: MillingJob, text: str, angles: int, before: list[Milled]) -> NCProof:
    """The proof of a file; that of an earlier one where it is read back to the very same motions."""
    found = read(text)
    if not found.faults:
        for one in before:
            if not one.proof.faults and _ways(one.proof.moves) == _ways(found.moves):
                return replace(one.proof, moves=tuple(found.moves))
    return prove(disc, text, job.cutter / 1e3, angles, job.groove)


def _ways(moves: list[Move] | tuple[Move, ...]) -> list[Move]:
    """Motions wherever they stand, those before the first cut left out: controls begin differently."""
    first = next((k for k, move in enumerate(moves) if move.feed is not None), 0)
    return [replace(move, line=0) for move in moves[first:]]


def notes(job: MillingJob) -> list[str]:
    """What the file says of itself."""
    return [f"CUTTER R{job.cutter:g} MM", "XY ZERO AT THE CAM'S CENTRE", "Z ZERO AT THE TOP"]


def axis_comments(frame: Frame) -> list[str]:
    """How the machine's axes lie in the cam: those of the disc, which the link's are turned or mirrored against."""
    turned = math.degrees(frame.angle) % 360
    told = [f"X AXIS AT {turned:.6g} DEG OF THE CAM'S LINK"] if min(turned, 360 - turned) > 1e-9 else []
    return [*told, *(["THE CAM SEEN FROM BEHIND"] if frame.mirror < 0 else [])]


def wrongs(one: Milled) -> Iterator[Finding]:
    """Why a file isn't written."""
    post = one.post.name
    for fault in one.proof.faults[:3]:
        yield as_finding(fault, post)
    if one.longest > one.post.longest:
        data = {"post": post, "length": one.longest, "most": one.post.longest}
        yield Finding("nc.long-line", AT, data)
    if not one.proof.faults and not one.deep:
        data = {"post": post, "depth": f"{1e3 * one.proof.depth:.6g}", "wanted": f"{one.job.depth:.6g}"}
        yield Finding("nc.depth", AT, data)
    if not one.proof.faults and one.proof.worst > one.job.tolerance:
        share = one.proof.worst / one.job.tolerance
        gouge = f"{1e3 * one.proof.gouge:.3g}"
        yield Finding("nc.off", AT, {"post": post, "share": f"{share:.3g}", "gouge": gouge})


def as_finding(fault: NCFault, post: str = "", severity: str = "error") -> Finding:
    """A fault of NC code as a finding of the study."""
    return Finding(fault.key, AT, {"line": fault.line, "post": post, **fault.data}, severity=severity)
