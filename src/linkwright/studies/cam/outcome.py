"""What the cam study gives."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import field
from functools import cached_property

from linkwright.cam.checks import CamCheck
from linkwright.cam.disc import TURN, Disc
from linkwright.cam.extremes import CamExtreme
from linkwright.cam.form_closure import Closing
from linkwright.cam.sizing import Feasible
from linkwright.data_classes import dataclass
from linkwright.expressions import units as u
from linkwright.findings import Finding
from linkwright.kernels import Compiled
from linkwright.laws import Motion
from linkwright.results import Result, Run
from linkwright.studies.cam.figures import CamFigure
from linkwright.studies.cam.forces import Pressed
from linkwright.studies.cam.milled_discs import Milled
from linkwright.studies.cam.options import CamOptions
from linkwright.studies.cam.plate import Plate
from linkwright.studies.cam.stated_dimensions import CamRequirements


@dataclass
class CamOutcome:
    """A plate cam: figures and checks, sizes, and what is made of it.

    ``plates`` are its discs, one, or both of a pair; ``closing`` is what holds the follower, ``None`` for a force.
    """

    compiled: Compiled
    options: CamOptions
    name: str
    stated: CamRequirements
    plates: list[Plate]
    closing: Closing | None = None
    figures: list[CamFigure] = field(default_factory=list)
    pressed: Pressed | None = None
    force_checks: list[CamCheck] = field(default_factory=list)
    map: Feasible | None = None
    failures: list[Finding] = field(default_factory=list)
    warnings: list[Finding] = field(default_factory=list)

    @property
    def done(self) -> bool:
        """Whether all is as asked."""
        return not self.failures

    @property
    def first(self) -> Plate:
        """The cam, or the first disc of a pair."""
        return self.plates[0]

    @property
    def second(self) -> Plate | None:
        """The second disc of a pair."""
        return next((plate for plate in self.plates if plate.second), None)

    @property
    def disc(self) -> Disc:
        """The first disc."""
        return self.first.disc

    @property
    def has_profile(self) -> bool:
        """Whether the first disc has a profile."""
        return self.first.has_profile

    @property
    def area(self) -> float:
        """Within the first disc's profile (m2)."""
        return self.first.area

    @property
    def milled(self) -> list[Milled]:
        """The files for the first disc."""
        return self.first.milled

    def add(self, found: Iterable[tuple[str, CamExtreme]], dimensions: Mapping[str, u.Dimension]) -> None:
        """Further figures by name."""
        for name, one in found:
            self.figures.append(CamFigure(name, one.value, one.theta, dimensions[name], self.stated.required.get(name)))

    @property
    def law(self) -> Motion:
        """The law of the follower."""
        return self.compiled.motions[self.compiled.mechanism.cams[self.name].law]

    @property
    def lift_dimension(self) -> u.Dimension:
        """An angle or a length."""
        return u.ANGLE if self.disc.follower.turns else u.LENGTH

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
