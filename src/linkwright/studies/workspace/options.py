"""The options of the workspace study, and what is wrong with them."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from typing import Annotated, Protocol

from pydantic import Field

from linkwright.elements.fields import DriveName, Interval, ParameterName, PointName, freeze
from linkwright.expressions.fields import Expression, Frozen, FrozenDict
from linkwright.expressions.typed_fields import of_drive, of_parameter
from linkwright.expressions.units import ANGLE, LENGTH
from linkwright.expressions.unknown import near
from linkwright.findings import CLAUSES, Finding, Joined, ModelError
from linkwright.kernels import Compiled
from linkwright.kernels.parameter_batch import Varied
from linkwright.model.followers import no_followers
from linkwright.model.references import option_faults
from linkwright.structure import FRAME
from linkwright.studies.limits.ranges import stroke
from linkwright.studies.numbers import constant, interval
from linkwright.studies.sampling_options import one_of
from linkwright.studies.workspace.assembly_signs import combinations
from linkwright.studies.workspace.errors_options import ErrorsOptions
from linkwright.studies.workspace.fit_options import RequiredFits
from linkwright.studies.workspace.mesh import DriveBox
from linkwright.studies.workspace.path_options import WantedPaths
from linkwright.studies.workspace.quality_options import QualityOptions
from linkwright.studies.workspace.trajectories_options import TrajectoriesAsked

PATH = ("studies", "workspace")
TURN = 2 * math.pi
MOST = 200
"""The most regions of one study."""
SECTIONS: tuple[str, ...] = ("trajectories", "quality", "errors", "paths", "fits")
"""The keys of the options' sections, what is asked besides the regions, in the order in which they are performed and
shown."""

Which = one_of("workspace", "modes", ["all", "own"])


class WorkspaceOptions(Frozen):
    """Which point, in which assembly modes, for which values of parameters, over which ranges of the drives."""

    point: PointName
    modes: Which = "all"  # type: ignore[valid-type]
    for_: Annotated[dict[ParameterName, tuple[Expression, ...]], of_parameter(3), freeze] = Field(
        default_factory=FrozenDict, alias="for", examples=[{"alpha": [0, 60, 90]}]
    )
    drives: Annotated[dict[DriveName, Interval], of_drive(ANGLE, LENGTH), freeze] = Field(default_factory=FrozenDict)
    chord: float = Field(1e-6, ge=1e-9, le=1e-2)
    quality: QualityOptions | None = None
    errors: ErrorsOptions | None = None
    trajectories: TrajectoriesAsked | None = None
    paths: WantedPaths | None = None
    fits: RequiredFits | None = None

    def values(self, compiled: Compiled) -> list[dict[str, float]]:
        """Each combination of the parameters' values, in SI."""
        quantities = compiled.quantities
        lists = [
            [quantities.value(v, quantities.dimensions.of(name)) for v in some] for name, some in self.for_.items()
        ]
        return [dict(zip(self.for_, some, strict=True)) for some in itertools.product(*lists)]

    def box(self, compiled: Compiled) -> DriveBox:
        """The ranges of the two drives."""
        ranges = [self.range(compiled, drive) for drive in compiled.graph.drives]
        assert len(ranges) == 2 and None not in ranges
        low, high = ([r[end] for r in ranges if r is not None] for end in (0, 1))
        turns = self.turns(compiled)
        return DriveBox((low[0], low[1]), (high[0], high[1]), (turns[0], turns[1]))

    def range(self, compiled: Compiled, drive: str) -> tuple[float, float] | None:
        """The range of a drive's value, SI; ``None`` for a slide of which none is stated."""
        if drive in self.drives:
            quantities = compiled.quantities
            low, high = (quantities.value(end, quantities.drive_dimension(drive)) for end in self.drives[drive])
            return low, high
        return (0.0, TURN) if compiled.mechanism.prescribed(drive).turns else stroke(compiled, drive)

    def range_and_faults(self, compiled: Compiled, drive: str) -> tuple[tuple[float, float] | None, list[Finding]]:
        """The same, and what is wrong with one that is stated."""
        if drive not in self.drives:
            return self.range(compiled, drive), []
        quantities, path = compiled.quantities, (*PATH, "drives", drive)
        return interval(quantities, self.drives[drive], quantities.drive_dimension(drive), path)

    def turns(self, compiled: Compiled) -> tuple[bool, ...]:
        """Of which drives the range is a whole turn, so that its ends are one."""
        ranges = [(drive, self.range(compiled, drive)) for drive in compiled.graph.drives]
        return tuple(
            bool(compiled.mechanism.prescribed(drive).turns and r and r[1] - r[0] >= TURN * (1 - 1e-12))
            for drive, r in ranges
        )


class Section(Protocol):
    """A section of the options: a pydantic model that checks itself against the mechanism."""

    def check(self, compiled: Compiled, options: WorkspaceOptions) -> Iterator[Finding]:
        """What is wrong with it; ``options`` are those of the whole study."""


def sections(options: WorkspaceOptions) -> list[tuple[str, Section]]:
    """The sections that are given, by key."""
    return [(key, section) for key in SECTIONS if (section := getattr(options, key)) is not None]


def check(compiled: Compiled, options: WorkspaceOptions) -> Iterator[Finding]:
    """What is wrong with options that are well-formed."""
    drives = compiled.graph.drives
    if len(compiled.graph.motors) < len(drives):
        yield no_followers(compiled.mechanism, "workspace")
        return
    if not 1 <= len(drives) <= 2:
        yield Finding("workspace.drives", ("drives",), {"count": len(drives), "names": Joined(drives) or "-"})
    if compiled.structure.higher_groups:
        higher_groups = compiled.structure.higher_groups
        data = {"groups": Joined((c.label for c in higher_groups), CLAUSES)}
        yield Finding("workspace.cluster", ("links", higher_groups[0].links[0]), data)
    unnamed = option_faults(compiled.mechanism, options, PATH)
    yield from unnamed
    yield from _point(compiled, options.point)
    for _, section in sections(options):
        yield from section.check(compiled, options)
    wrong = [*_values(compiled, options)]
    yield from wrong
    yield from _drives(compiled, options)
    if not wrong and not unnamed:
        count = math.prod(map(len, options.for_.values())) * len(combinations(compiled, options.modes))
        if count > MOST:
            yield Finding("workspace.too-many", PATH, {"count": count, "limit": MOST})


def _point(compiled: Compiled, point: str) -> Iterator[Finding]:
    links_of_points, frame = compiled.quantities.signals.links_of_points, compiled.mechanism.links[FRAME].points
    if point in frame:
        moving = [name for name in links_of_points if name not in frame]
        yield Finding("workspace.fixed-point", (*PATH, "point"), {"name": point, "near": near(point, moving)})


def _values(compiled: Compiled, options: WorkspaceOptions) -> Iterator[Finding]:
    quantities = compiled.quantities
    names = []
    for name, values in options.for_.items():
        path = (*PATH, "for", name)
        if name not in quantities.parameters:
            continue
        names.append(name)
        if not values:
            yield Finding("workspace.no-values", path, {"name": name})
        for i, value in enumerate(values):
            yield from constant(quantities, value, quantities.dimensions.of(name), (*path, i))[1]
    try:
        Varied(compiled, names)
    except ModelError as error:
        yield from error.findings


def _drives(compiled: Compiled, options: WorkspaceOptions) -> Iterator[Finding]:
    for drive in compiled.graph.drives:
        path = (*PATH, "drives", drive)
        unit, size = compiled.quantities.drive_unit(drive)
        found, wrong = options.range_and_faults(compiled, drive)
        yield from wrong
        if found is None:
            if not wrong:
                yield Finding("workspace.no-range", ("drives", drive), {"drive": drive, "unit": unit})
        elif compiled.mechanism.prescribed(drive).turns and found[1] - found[0] > TURN * (1 + 1e-9):
            yield Finding("study.wide-range", path, {"drive": drive, "limit": f"{TURN / size:.4g}", "unit": unit})
