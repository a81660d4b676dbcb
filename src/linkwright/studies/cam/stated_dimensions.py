"""The numbers that a cam study states, in SI (a job's in mm and minutes), and what is wrong with them."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import field, replace

from linkwright.cam.checks import CamLimits
from linkwright.cam.disc import Disc
from linkwright.cam.extremes import moving
from linkwright.cam.form_closure import Closing
from linkwright.cam.nc.job import MillingJob
from linkwright.cam.nc.posts import POSTS
from linkwright.cam.nc.preflight import faults
from linkwright.cam.solid import Blank
from linkwright.data_classes import dataclass
from linkwright.expressions.typed_fields import Context, Sign
from linkwright.expressions.unknown import unknown
from linkwright.findings import Finding, Term
from linkwright.kernels import Compiled
from linkwright.model.walk import QuantityPlace, sites
from linkwright.studies.cam.figures import FIGURES, OF_FACE, OF_ROLLER, SECOND, Range, closed_by, every, of_forces
from linkwright.studies.cam.force_numbers import FollowerForces, available_figures, read
from linkwright.studies.cam.milled_discs import as_finding
from linkwright.studies.cam.options import PATH, CamOptions
from linkwright.studies.numbers import constant

MM, MINUTE = 1e3, 60.0
QUARTER = 0.25
"""Of the feed: what the cutter goes down with where it isn't stated."""

CAM_ITSELF = {"nc.undercut", "nc.undercut-outer", "nc.concave"}
"""Faults of the cam, not of a job: those of the run come with the base circle that mends them."""
MOST_PASSES = 200
"""More than a thick cam takes in fine steps; many more are a slip, and a file without end."""


@dataclass(frozen=True)
class CamRequirements:
    """What a study wants, in numbers. ``required`` are least and largest values by figure."""

    limits: CamLimits
    tolerance: float
    period: float
    base: Range | None = None
    against: tuple[str, float, float] | None = None
    blank: Blank | None = None
    job: MillingJob | None = None
    required: dict[str, Range] = field(default_factory=dict)
    forces: FollowerForces | None = None
    play: float | None = None


@dataclass
class DimensionReader:
    """Reads the options for one cam, whose follower ``closing`` keeps on; ``findings`` is what is wrong with them."""

    compiled: Compiled
    options: CamOptions
    name: str
    disc: Disc
    closing: Closing | None = None
    findings: list[Finding] = field(default_factory=list)

    def __post_init__(self) -> None:
        stated = sites(self.options, Context(self.compiled.mechanism, PATH))
        self.sites = {site.path[len(PATH) :]: site for site in stated}

    def read(self) -> CamRequirements:
        """All numbers, with NaN for those that are wrong."""
        o, job = self.options, self._job()
        return CamRequirements(
            self._limits(None if job is None else job.cutter / MM),
            self._number("tolerance"),
            self._number("period"),
            self._range("size", "base") if o.size else None,
            self._against(),
            self._blank(),
            job,
            dict(self._required()),
            self._forces(),
            self._play(),
        )

    def _forces(self) -> FollowerForces | None:
        if self.options.forces is None:
            return None
        asked, found = read(self.compiled, self.name, self.disc, self.options.forces, self._number)
        self.findings += found
        return asked if self.closing is None else replace(asked, second=self.closing.second)

    def _play(self) -> float | None:
        play = self.options.limits.play
        if play is not None and self.closure != "yoke":
            data = {"keys": "limits: play, closed: yoke"}
            self.findings.append(Finding("cam.together", (*PATH, "limits", "play"), data))
        return None if play is None else self._number("limits", "play")

    @property
    def closure(self) -> str:
        """What keeps the follower on, as the file says."""
        return self.compiled.mechanism.cams[self.name].closed

    def _number(self, *path: str | int) -> float:
        """The constant at a place of the options; NaN with a finding where it is none or has the wrong sign."""
        site, index = self.sites.get(path), 0
        if site is None:  # an end of an interval
            site, index = self.sites[path[:-1]], int(path[-1])
        return self._value(site, index, path)

    def _value(self, site: QuantityPlace, index: int, path: tuple[str | int, ...]) -> float:
        (expression, of), at, quantities = site.parts[index], (*PATH, *path), self.compiled.quantities
        wanted, sign = of.dimension_at(site.context), of.sign_at(site.context)
        assert wanted is not None
        value, found = constant(quantities, expression, quantities.dimensions.resolve(wanted), at)
        self.findings += found
        if value is None:
            return math.nan
        if (sign is Sign.POSITIVE and value <= 0) or (sign is Sign.NOT_NEGATIVE and value < 0):
            key = next(name for name in reversed(path) if isinstance(name, str))
            least = Term("cam-zero" if sign is Sign.NOT_NEGATIVE else "cam-positive")
            data = {"key": key, "text": expression.text[:60], "least": least}
            self.findings.append(Finding("cam.not-positive", at, data))
            return math.nan
        return value

    def _maybe(self, *path: str) -> float | None:
        return self._number(*path) if path in self.sites else None

    def _limits(self, cutter: float | None) -> CamLimits:
        stated = self._maybe("limits", "cutter")
        return CamLimits(
            self._maybe("limits", "pressure_rise"),
            self._maybe("limits", "pressure_return"),
            self._maybe("limits", "pitch_over_roller"),
            self._maybe("limits", "profile_radius"),
            cutter if stated is None else stated,
            groove=self.closure == "groove",
        )

    def _range(self, *path: str) -> Range:
        low, high = (self._number(*path, i) for i in range(2))
        if low >= high:
            texts = [expression.text[:60] for expression, _ in self.sites[path].parts]
            self.findings.append(Finding("value.not-rising", (*PATH, *path), {"low": texts[0], "high": texts[1]}))
        return low, high

    def _against(self) -> tuple[str, float, float] | None:
        size = self.options.size
        for name in size.against if size else ():
            known = [key for key in vars(self.disc.follower) if key != "base"]
            if name not in known:
                self.findings.append(unknown("length", (*PATH, "size", "against", name), name, known))
                continue
            return (name, *self._range("size", "against", name))
        return None

    def _blank(self) -> Blank | None:
        b = self.options.blank
        if b is None:
            return None

        keys = ("thickness", "bore", "hub", "height", "key_width", "key_depth", "radius", "groove")
        stated = [key for key in keys if getattr(b, key) is not None]
        lengths = {key: MM * self._number("blank", key) for key in stated}
        turned = self._number("blank", "key_angle")
        made = Blank(**lengths, key_angle=turned)
        if made.bore and made.key_width >= 2 * made.bore:
            self.findings.append(Finding("cam.keyway", (*PATH, "blank", "key_width")))
        elif made.hub and made.hub <= made.bore + made.key_depth:
            self.findings.append(Finding("cam.hub", (*PATH, "blank", "hub")))
        if (self.closure == "groove") != ("groove" in stated):
            self.findings.append(Finding("cam.groove-blank", (*PATH, "blank"), {"closed": self.closure}))
        elif made.groove >= made.thickness:
            self.findings.append(Finding("cam.groove-deep", (*PATH, "blank", "groove")))
        return made

    def _job(self) -> MillingJob | None:
        o = self.options.nc
        if o is None:
            return None

        def length(key: str) -> float:
            return MM * self._number("nc", key)

        before = len(self.findings)
        depth, feed = length("depth"), self._feed("feed")
        step = depth if o.step is None else length("step")
        if depth > MOST_PASSES * step:
            data = {"count": f"{math.ceil(depth / step):.6g}", "most": MOST_PASSES}
            self.findings.append(Finding("cam.passes", (*PATH, "nc", "step"), data))
        start = middle_of_dwell(self.disc) if o.start is None else self._number("nc", "start") % (2 * math.pi)
        job = MillingJob(
            cutter=length("cutter"),
            depth=depth,
            tolerance=self._number("nc", "tolerance"),
            step=step,
            feed=feed,
            plunge=QUARTER * feed if o.plunge is None else self._feed("plunge"),
            speed=30 / math.pi * self._number("nc", "speed"),
            start=start,
            blend=length("blend"),
            allowance=length("allowance"),
            spring=o.spring,
            climb=o.climb,
            compensation=o.compensation,
            arcs=o.arcs,
            decimals=o.decimals,
            lead=length("lead"),
            overlap=length("overlap"),
            clear=length("clear"),
            tool=o.tool,
            number=o.number,
            name="".join(c for c in self.name.upper() if c.isascii() and (c.isalnum() or c in "_-"))[:24] or "CAM",
            groove=self.compiled.mechanism.cams[self.name].closed == "groove",
        )
        if len(self.findings) == before:
            self.findings += self._unfit(job, o.post)
        return job

    def _unfit(self, job: MillingJob, posts: tuple[str, ...]) -> Iterator[Finding]:
        """What speaks against a job on some control; of the cam itself the run tells it, with what mends it."""
        told = [as_finding(fault) for post in posts for fault in faults(self.disc, job, POSTS[post])]
        return (one for i, one in enumerate(told) if one.code not in CAM_ITSELF and one not in told[:i])

    def _feed(self, key: str) -> float:
        return MM * MINUTE * self._number("nc", key)

    def _required(self) -> list[tuple[str, Range]]:
        made = []
        turns = self.disc.follower.turns
        figures = every(turns) | of_forces(turns)
        there = FIGURES.keys() | closed_by(self.closure, turns)
        there |= available_figures(self.compiled, self.name, self.disc, self.options.forces)
        absent = OF_ROLLER if self.disc.follower.faced else OF_FACE
        there -= absent | {SECOND + name for name in absent}
        for name, requirement in self.options.require.items():
            if name not in figures:
                self.findings.append(unknown("measure", (*PATH, "require", name), name, figures))
                continue
            if name not in there:
                self.findings.append(Finding("cam.no-figure", (*PATH, "require", name), {"name": name}))
                continue
            site = self.sites["require", name]
            ends = [self._value(site, i, ("require", name)) for i in range(len(site.parts))]
            low = -math.inf if requirement.low is None else ends[0]
            made.append((name, (low, math.inf if requirement.high is None else ends[-1])))
        return made


def middle_of_dwell(disc: Disc) -> float:
    """The cam angle in the middle of the longest dwell, rad; 0 where there is none."""
    busy = {
        (a, b) for a, b in disc.pieces for start, stop, _ in moving(disc.lift, tuple(disc.pieces)) if a <= start < b
    }
    dwells = [piece for piece in disc.pieces if piece not in busy]
    return max(((b - a, (a + b) / 2) for a, b in dwells), default=(0.0, 0.0))[1]
