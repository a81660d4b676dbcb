"""The numbers that a cam study states, in SI (a job's in mm and minutes), and what is wrong with them."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field, replace

from linkwright.cam.checks import Limits
from linkwright.cam.closing import Closing
from linkwright.cam.disc import Disc
from linkwright.cam.extremes import moving
from linkwright.cam.nc.before import faults
from linkwright.cam.nc.job import Job
from linkwright.cam.nc.posts import POSTS
from linkwright.cam.solid import Blank
from linkwright.findings import Finding, Term
from linkwright.kernels import Compiled
from linkwright.model import units as u
from linkwright.model.dimensions import DimensionError
from linkwright.model.fields import Expression
from linkwright.model.quantities import LARGEST
from linkwright.model.unknown import unknown
from linkwright.studies.cam.figures import FIGURES, OF_FACE, OF_ROLLER, SECOND, Range, closed_by, every, of_forces
from linkwright.studies.cam.force_numbers import Asked, given, read
from linkwright.studies.cam.milled import as_finding
from linkwright.studies.cam.options import PATH, CamNc, CamOptions

MM, MINUTE = 1e3, 60.0
QUARTER = 0.25
"""Of the feed: what the cutter goes down with where it isn't stated."""

CAM_ITSELF = {"nc.undercut", "nc.undercut-outer", "nc.concave"}
"""Faults of the cam, not of a job: those of the run come with the base circle that mends them."""
MOST_PASSES = 200
"""More than a thick cam takes in fine steps; many more are a slip, and a file without end."""


@dataclass(frozen=True)
class Stated:
    """What a study wants, in numbers. ``required`` are least and largest values by figure."""

    limits: Limits
    tolerance: float
    period: float
    base: Range | None = None
    against: tuple[str, float, float] | None = None
    blank: Blank | None = None
    job: Job | None = None
    required: dict[str, Range] = field(default_factory=dict)
    forces: Asked | None = None
    play: float | None = None


@dataclass
class Reader:
    """Reads the options for one cam, whose follower ``closing`` keeps on; ``findings`` is what is wrong with them."""

    compiled: Compiled
    options: CamOptions
    name: str
    disc: Disc
    closing: Closing | None = None
    findings: list[Finding] = field(default_factory=list)

    def read(self) -> Stated:
        """All numbers, with NaN for those that are wrong."""
        o, job = self.options, self._job()
        return Stated(
            self._limits(None if job is None else job.cutter / MM),
            self._number(o.tolerance, u.LENGTH, "tolerance"),
            self._number(o.period, u.TIME, "period"),
            self._range(o.size.base, "size", "base") if o.size else None,
            self._against(),
            self._blank(),
            job,
            dict(self._required()),
            self._forces(),
            self._play(),
        )

    def _forces(self) -> Asked | None:
        if self.options.forces is None:
            return None
        asked, found = read(self.compiled, self.name, self.disc, self.options.forces, self._number)
        self.findings += found
        return asked if self.closing is None else replace(asked, second=self.closing.second)

    def _play(self) -> float | None:
        play = self.options.limits.play
        if play is not None and self.closed != "yoke":
            data = {"keys": "limits: play, closed: yoke"}
            self.findings.append(Finding("cam.together", (*PATH, "limits", "play"), data))
        return None if play is None else self._number(play, u.LENGTH, "limits", "play", zero=True)

    @property
    def closed(self) -> str:
        """What keeps the follower on, as the file says."""
        return self.compiled.mechanism.cams[self.name].closed

    def _number(
        self, of: Expression, dimension: u.Dimension, *path: str | int, least: float | None = 0.0, zero: bool = False
    ) -> float:
        """A constant, positive unless ``zero`` is let be or ``least`` is ``None``; NaN with a finding else."""
        at = (*PATH, *path)
        try:
            value = self.compiled.quantities.value(of, dimension)
        except DimensionError as error:
            self.findings.append(Finding(error.key, at, self.compiled.quantities.spelt(error.data)))
            return math.nan
        if not abs(value) < LARGEST:
            self.findings.append(Finding("value.not-finite", at, {"text": of.text[:60]}))
        elif least is not None and not (value >= 0 if zero else value > 0):
            key = next(name for name in reversed(path) if isinstance(name, str))
            data = {"key": key, "text": of.text[:60], "least": Term("cam-zero" if zero else "cam-positive")}
            self.findings.append(Finding("cam.not-positive", at, data))
        else:
            return value
        return math.nan

    def _maybe(self, of: Expression | None, dimension: u.Dimension, *path: str) -> float | None:
        return None if of is None else self._number(of, dimension, *path)

    def _limits(self, cutter: float | None) -> Limits:
        o = self.options.limits
        stated = self._maybe(o.cutter, u.LENGTH, "limits", "cutter")
        return Limits(
            self._maybe(o.pressure_rise, u.ANGLE, "limits", "pressure_rise"),
            self._maybe(o.pressure_return, u.ANGLE, "limits", "pressure_return"),
            self._maybe(o.pitch_over_roller, u.PURE, "limits", "pitch_over_roller"),
            self._maybe(o.profile_radius, u.LENGTH, "limits", "profile_radius"),
            cutter if stated is None else stated,
            groove=self.closed == "groove",
        )

    def _range(self, of: tuple[Expression, Expression], *path: str, least: float | None = 0.0) -> Range:
        low, high = (self._number(end, u.LENGTH, *path, i, least=least) for i, end in enumerate(of))
        if low >= high:
            data = {"low": of[0].text[:60], "high": of[1].text[:60]}
            self.findings.append(Finding("value.not-rising", (*PATH, *path), data))
        return low, high

    def _against(self) -> tuple[str, float, float] | None:
        size = self.options.size
        for name, ends in size.against.items() if size else ():
            known = [key for key in vars(self.disc.follower) if key != "base"]
            if name not in known:
                self.findings.append(unknown("length", (*PATH, "size", "against", name), name, known))
                continue
            signed = name in ("offset", "face")
            return (name, *self._range(ends, "size", "against", name, least=None if signed else 0.0))
        return None

    def _blank(self) -> Blank | None:
        b = self.options.blank
        if b is None:
            return None

        keys = ("thickness", "bore", "hub", "height", "key_width", "key_depth", "radius", "groove")
        stated = {key: of for key in keys if (of := getattr(b, key)) is not None}
        lengths = {key: MM * self._number(of, u.LENGTH, "blank", key) for key, of in stated.items()}
        turned = self._number(b.key_angle, u.ANGLE, "blank", "key_angle", least=None)
        made = Blank(**lengths, key_angle=turned)
        if made.bore and made.key_width >= 2 * made.bore:
            self.findings.append(Finding("cam.keyway", (*PATH, "blank", "key_width")))
        elif made.hub and made.hub <= made.bore + made.key_depth:
            self.findings.append(Finding("cam.hub", (*PATH, "blank", "hub")))
        if (self.closed == "groove") != ("groove" in stated):
            self.findings.append(Finding("cam.groove-blank", (*PATH, "blank"), {"closed": self.closed}))
        elif made.groove >= made.thickness:
            self.findings.append(Finding("cam.groove-deep", (*PATH, "blank", "groove")))
        return made

    def _job(self) -> Job | None:
        o = self.options.nc
        if o is None:
            return None

        def length(key: str, zero: bool = False) -> float:
            return MM * self._number(getattr(o, key), u.LENGTH, "nc", key, zero=zero)

        before = len(self.findings)
        depth, feed = length("depth"), self._feed(o, "feed")
        step = depth if o.step is None else length("step")
        if depth > MOST_PASSES * step:
            data = {"count": f"{math.ceil(depth / step):.6g}", "most": MOST_PASSES}
            self.findings.append(Finding("cam.passes", (*PATH, "nc", "step"), data))
        lift = u.ANGLE if self.disc.follower.turns else u.LENGTH
        start = (
            middle_of_dwell(self.disc)
            if o.start is None
            else self._number(o.start, u.ANGLE, "nc", "start", least=None) % (2 * math.pi)
        )
        job = Job(
            cutter=length("cutter"),
            depth=depth,
            tolerance=self._number(o.tolerance, lift, "nc", "tolerance"),
            step=step,
            feed=feed,
            plunge=QUARTER * feed if o.plunge is None else self._feed(o, "plunge"),
            speed=30 / math.pi * self._number(o.speed, u.OMEGA, "nc", "speed"),
            start=start,
            blend=length("blend"),
            allowance=length("allowance", zero=True),
            spring=o.spring,
            climb=o.climb,
            compensation=o.compensation,
            arcs=o.arcs,
            decimals=o.decimals,
            lead=length("lead"),
            overlap=length("overlap", zero=True),
            clear=length("clear"),
            tool=o.tool,
            number=o.number,
            name="".join(c for c in self.name.upper() if c.isascii() and (c.isalnum() or c in "_-"))[:24] or "CAM",
            groove=self.compiled.mechanism.cams[self.name].closed == "groove",
        )
        if len(self.findings) == before:
            self.findings += self._unfit(job, o.post)
        return job

    def _unfit(self, job: Job, posts: tuple[str, ...]) -> Iterator[Finding]:
        """What speaks against a job on some control; of the cam itself the run tells it, with what mends it."""
        told = [as_finding(fault) for post in posts for fault in faults(self.disc, job, POSTS[post])]
        return (one for i, one in enumerate(told) if one.code not in CAM_ITSELF and one not in told[:i])

    def _feed(self, o: CamNc, key: str) -> float:
        return MM * MINUTE * self._number(getattr(o, key), u.SPEED, "nc", key)

    def _required(self) -> list[tuple[str, Range]]:
        made = []
        turns = self.disc.follower.turns
        figures = every(turns) | of_forces(turns)
        there = FIGURES.keys() | closed_by(self.closed, turns)
        there |= given(self.compiled, self.name, self.disc, self.options.forces)
        absent = OF_ROLLER if self.disc.follower.faced else OF_FACE
        there -= absent | {SECOND + name for name in absent}
        for name, requirement in self.options.require.items():
            if name not in figures:
                self.findings.append(unknown("measure", (*PATH, "require", name), name, figures))
                continue
            if name not in there:
                self.findings.append(Finding("cam.no-figure", (*PATH, "require", name), {"name": name}))
                continue
            low, high = (
                end if bound is None else self._number(bound, figures[name], "require", name, least=None)
                for bound, end in ((requirement.low, -math.inf), (requirement.high, math.inf))
            )
            made.append((name, (low, high)))
        return made


def middle_of_dwell(disc: Disc) -> float:
    """The cam angle in the middle of the longest dwell, rad; 0 where there is none."""
    busy = {
        (a, b) for a, b in disc.pieces for start, stop, _ in moving(disc.lift, tuple(disc.pieces)) if a <= start < b
    }
    dwells = [piece for piece in disc.pieces if piece not in busy]
    return max(((b - a, (a + b) / 2) for a, b in dwells), default=(0.0, 0.0))[1]
