"""What the cam study gives."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from linkwright.cam.checks import Check
from linkwright.cam.disc import TURN, Disc, Look
from linkwright.cam.extremes import Extreme, extremes
from linkwright.cam.nc.path import Element
from linkwright.cam.pairs import Frame
from linkwright.cam.sizing import Feasible
from linkwright.cam.splines import Spline
from linkwright.kernels import Compiled
from linkwright.laws import Motion
from linkwright.model import units as u
from linkwright.model.findings import Finding
from linkwright.notation import Jet
from linkwright.results import Result, Run
from linkwright.studies.cam.forces import Pressed
from linkwright.studies.cam.milled import Milled
from linkwright.studies.cam.options import CamOptions
from linkwright.studies.cam.stated import FIGURES, Range, Stated

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Figure:
    """A figure (SI) and the cam angle (rad) at which it is taken; ``wanted`` are the least and the largest value that
    are required."""

    name: str
    value: float
    theta: float
    wanted: Range | None = None
    of: u.Dimension | None = None

    @property
    def kept(self) -> bool:
        """Whether the requirement is met, or there is none."""
        return self.wanted is None or self.wanted[0] <= self.value <= self.wanted[1]

    @property
    def dimension(self) -> u.Dimension:
        """What it is."""
        return FIGURES[self.name] if self.of is None else self.of


@dataclass
class CamOutcome:
    """A plate cam: figures and checks, sizes, and what is made of it; SI, but for what the machine tool gets (mm).

    ``elements`` is the contour in the disc's axes, which ``frame`` puts into the link's, ``outer`` the other flank of a
    groove, ``curves`` both as splines where these are asked for, ``area`` (m2) that within the profile; all are missing
    where there is no profile.
    ``smallest`` is the base circle (m) that ``size`` asks for, ``None`` where none keeps the limits.
    """

    compiled: Compiled
    options: CamOptions
    name: str
    disc: Disc
    frame: Frame
    stated: Stated
    figures: list[Figure] = field(default_factory=list)
    checks: list[Check] = field(default_factory=list)
    pressed: Pressed | None = None
    force_checks: list[Check] = field(default_factory=list)
    smallest: float | None = None
    map: Feasible | None = None
    elements: list[Element] = field(default_factory=list)
    outer: list[Element] = field(default_factory=list)
    curves: list[list[Spline]] = field(default_factory=list)
    area: float = math.nan
    milled: list[Milled] = field(default_factory=list)
    failures: list[Finding] = field(default_factory=list)
    warnings: list[Finding] = field(default_factory=list)

    @property
    def done(self) -> bool:
        """Whether all is as asked."""
        return not self.failures

    def add(self, found: Iterable[tuple[str, Extreme]], dimensions: Mapping[str, u.Dimension]) -> None:
        """Further figures by name."""
        for name, one in found:
            self.figures.append(Figure(name, one.value, one.theta, self.stated.required.get(name), dimensions[name]))

    @property
    def made(self) -> bool:
        """Whether there is a profile."""
        return math.isfinite(self.area)

    @property
    def volume(self) -> float | None:
        """Of the solid (m3), from the exact area."""
        blank = self.stated.blank
        return None if blank is None or not self.made else 1e-9 * blank.volume(1e6 * self.area)

    @property
    def law(self) -> Motion:
        """The law of the follower."""
        return self.compiled.motions[self.compiled.mechanism.cams[self.name].law]

    @property
    def lift_dimension(self) -> u.Dimension:
        """An angle or a length."""
        return u.ANGLE if self.disc.follower.turns else u.LENGTH

    def placed(self, points: Array) -> Array:
        """Points of the disc (2, ...) about its centre, in directions of the link's axes."""
        return replace(self.frame, origin=(0.0, 0.0)).placed(points)

    @cached_property
    def contour(self) -> list[Element]:
        """The contour about the centre in directions of the link's axes, counter-clockwise; mm."""
        return self._put(self.elements)

    @cached_property
    def flank(self) -> list[Element]:
        """Likewise the outer flank of a groove; empty where the roller doesn't run in one."""
        return self._put(self.outer)

    @property
    def splines(self) -> list[list[Spline]]:
        """The profile, then the outer flank of a groove, as splines about the centre in directions of the link's axes;
        empty unless asked for."""
        return [[replace(one, points=self.placed(one.points)) for one in curve] for curve in self.curves]

    def _put(self, elements: list[Element]) -> list[Element]:
        def put(place: tuple[float, float]) -> tuple[float, float]:
            x, y = self.placed(np.array(place)).tolist()
            return x, y

        made = [
            replace(e, start=put(e.start), end=put(e.end), centre=None if e.centre is None else put(e.centre))
            for e in elements
        ]
        if self.frame.mirror > 0:
            return made
        return [replace(e, start=e.end, end=e.start) for e in reversed(made)]

    @cached_property
    def theta(self) -> Array:
        """The cam angles of tables and charts, a whole turn."""
        return np.linspace(0.0, TURN, self.options.steps + 1)

    @cached_property
    def look(self) -> Look:
        """The cam at these; at the end of the turn from the left."""
        theta = self.theta.copy()
        theta[-1] = np.nextafter(TURN, 0.0)
        return self.disc.look(theta)

    @cached_property
    def result(self) -> Result:
        """A turn of the cam where its motor has a speed, else the pose at the start, for a drawing."""
        cam = self.compiled.mechanism.cams[self.name]
        for drive in self.compiled.mechanism.drives.values():
            if {drive.turns, drive.on} == {cam.cam, cam.on} and drive.speed is not None:
                speed = abs(self.compiled.quantities.value(drive.speed, u.OMEGA))
                if speed > 0:
                    return Result(Run(self.compiled, 0.0, TURN / speed, 360))
        return Result(Run(self.compiled, 0.0, 0.0, 1))


def figures(disc: Disc, checks: list[Check], required: dict[str, Range]) -> Iterator[Figure]:
    """The figures that a cam has; those of the checks have been found there."""
    by = {check.name: check for check in checks}
    if (sharp := by.get("profile_radius")) is not None:
        yield Figure("profile_curvature_max", 1 / sharp.value, sharp.theta, required.get("profile_curvature_max"))
    for name, check in (
        ("profile_radius_min", sharp),
        ("pitch_radius_min", by.get("pitch_radius")),
        ("hollow_radius_min", by.get("hollow_radius")),
        ("pressure_angle_max", steepest(checks)),
    ):
        if check is not None:
            yield Figure(name, check.value, check.theta, required.get(name))
    for name, found in zip(("radius_min", "radius_max"), extents(disc), strict=True):
        yield Figure(name, found.value, found.theta, required.get(name))


def steepest(checks: list[Check]) -> Check | None:
    """The larger of the pressure angles on the rise and on the return."""
    some = [check for check in checks if check.name.startswith("pressure")]
    return max(some, key=lambda check: check.value, default=None)


def extents(disc: Disc) -> tuple[Extreme, Extreme]:
    """The least and the largest distance of the profile from the cam's centre (m)."""

    def away(look: Look) -> Jet:
        x, y = (p - disc.follower.radius * n for p, n in zip(look.pitch, look.normal, strict=True))
        return (x * x + y * y).sqrt()

    return extremes(disc, away)
