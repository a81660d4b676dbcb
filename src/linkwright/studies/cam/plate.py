"""One disc of a cam in the cam study: its checks, its contour, its NC code."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import field, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from linkwright.cam.cams_of_mechanism import Frame
from linkwright.cam.checks import CamCheck
from linkwright.cam.contact import on_face
from linkwright.cam.disc import TURN, Disc, DiscJets
from linkwright.cam.extremes import CamExtreme, extremes
from linkwright.cam.nc.path import Element
from linkwright.cam.splines import Spline
from linkwright.data_classes import dataclass
from linkwright.findings import Term
from linkwright.notation import Jet
from linkwright.studies.cam.figures import SECOND
from linkwright.studies.cam.milled_discs import Milled
from linkwright.studies.cam.stated_dimensions import CamRequirements

Array = NDArray[np.float64]


@dataclass
class Plate:
    """A disc and what is made of it; SI, but for what the machine tool gets (mm).

    ``elements`` is the contour in the disc's axes, which ``frame`` puts into the link's, ``outer`` the other flank of a
    groove, ``curves`` both as splines where these are asked for, ``area`` (m2) that within the profile, ``outer_area``
    that within the outer flank; all are missing where there is no profile. ``smallest`` is the base circle (m) that
    ``size`` asks for, ``None`` where none keeps the limits. ``path`` is where the file states it, ``second`` whether it
    is the second one of a pair, ``steps`` those of its turn in tables and charts; ``fits`` whether bore and hub lie
    within the profile, and a groove within its plate.
    """

    disc: Disc
    frame: Frame
    stated: CamRequirements
    path: tuple[str | int, ...]
    steps: int
    second: bool = False
    checks: list[CamCheck] = field(default_factory=list)
    smallest: float | None = None
    elements: list[Element] = field(default_factory=list)
    outer: list[Element] = field(default_factory=list)
    curves: list[list[Spline]] = field(default_factory=list)
    area: float = math.nan
    outer_area: float | None = None
    fits: bool = True
    milled: list[Milled] = field(default_factory=list)

    @property
    def has_profile(self) -> bool:
        """Whether there is a profile."""
        return math.isfinite(self.area)

    @property
    def volume(self) -> float | None:
        """Of the solid (m3), from the exact area."""
        blank = self.stated.blank
        if blank is None or not self.has_profile or (blank.groove and self.outer_area is None):
            return None
        return 1e-9 * blank.volume(1e6 * self.area, None if self.outer_area is None else 1e6 * self.outer_area)

    @property
    def prefix(self) -> str:
        """What names of its figures begin with."""
        return SECOND if self.second else ""

    def term_for(self, what: Term) -> Term:
        """Something of it, in words."""
        return Term("of-second", what=what) if self.second else what

    def points_along_link(self, points: Array) -> Array:
        """Points of the disc (2, ...) about its centre, in directions of the link's axes."""
        return replace(self.frame, origin=(0.0, 0.0)).placed(points)

    @cached_property
    def contour(self) -> list[Element]:
        """The contour about the centre in directions of the link's axes, counter-clockwise; mm."""
        return self._turn_elements(self.elements)

    @cached_property
    def flank(self) -> list[Element]:
        """Likewise the outer flank of a groove; empty where the roller doesn't run in one."""
        return self._turn_elements(self.outer)

    @property
    def splines(self) -> list[list[Spline]]:
        """The profile, then the outer flank of a groove, as splines about the centre in directions of the link's axes;
        empty unless asked for."""
        return [[replace(one, points=self.points_along_link(one.points)) for one in curve] for curve in self.curves]

    def _turn_elements(self, elements: list[Element]) -> list[Element]:
        def turn_place(place: tuple[float, float]) -> tuple[float, float]:
            x, y = self.points_along_link(np.array(place)).tolist()
            return x, y

        made = [
            replace(
                e,
                start=turn_place(e.start),
                end=turn_place(e.end),
                centre=None if e.centre is None else turn_place(e.centre),
            )
            for e in elements
        ]
        if self.frame.mirror > 0:
            return made
        return [replace(e, start=e.end, end=e.start) for e in reversed(made)]

    @cached_property
    def theta(self) -> Array:
        """The cam angles of tables and charts, a whole turn."""
        return np.linspace(0.0, TURN, self.steps + 1)

    @cached_property
    def look(self) -> DiscJets:
        """The cam at these; at the end of the turn from the left."""
        theta = self.theta.copy()
        theta[-1] = np.nextafter(TURN, 0.0)
        return self.disc.look(theta)

    @cached_property
    def extents(self) -> tuple[CamExtreme, CamExtreme]:
        """The least and the largest distance of the profile from the cam's centre (m)."""
        return self._away(-self.disc.follower.radius)

    @cached_property
    def outer_extents(self) -> tuple[CamExtreme, CamExtreme]:
        """The same of the outer flank of a groove."""
        return self._away(self.disc.follower.radius)

    def _away(self, offset: float) -> tuple[CamExtreme, CamExtreme]:
        def away(look: DiscJets) -> Jet:
            x, y = (p + offset * n for p, n in zip(look.pitch, look.normal, strict=True))
            return (x * x + y * y).sqrt()

        return extremes(self.disc, away)

    @cached_property
    def face(self) -> tuple[CamExtreme, CamExtreme]:
        """Between which places a flat face is touched (m), as :func:`linkwright.cam.contact.on_face` counts them."""
        near, far = extremes(self.disc, on_face(self.disc))
        if self.disc.follower.turns or self.frame.mirror > 0:
            return near, far
        return CamExtreme(-far.value, far.theta), CamExtreme(-near.value, near.theta)

    def figures(self) -> Iterator[tuple[str, CamExtreme]]:
        """The figures that it has, by name; those of the checks have been found there."""
        by = {check.name: check for check in self.checks}
        if (sharp := by.get("profile_radius")) is not None:
            yield f"{self.prefix}profile_curvature_max", CamExtreme(1 / sharp.value, sharp.theta)
        for name, check in (
            ("profile_radius_min", sharp),
            ("pitch_radius_min", by.get("pitch_radius")),
            ("hollow_radius_min", by.get("hollow_radius")),
            ("pressure_angle_max", self._steepest()),
        ):
            if check is not None:
                yield self.prefix + name, CamExtreme(check.value, check.theta)
        yield from zip((f"{self.prefix}radius_min", f"{self.prefix}radius_max"), self.extents, strict=True)
        if self.disc.follower.faced:
            yield from zip((f"{self.prefix}face_near", f"{self.prefix}face_far"), self.face, strict=True)

    def _steepest(self) -> CamCheck | None:
        """The larger of the pressure angles on the rise and on the return."""
        some = [check for check in self.checks if check.name.startswith("pressure")]
        return max(some, key=lambda check: check.value, default=None)
