"""What the workspace study gives, in SI."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from functools import cached_property
from itertools import combinations
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.findings import Finding
from linkwright.kernels import Compiled
from linkwright.results import Result, Run
from linkwright.studies.workspace.mesh import RIM, DriveBox
from linkwright.studies.workspace.regions import Region
from linkwright.studies.workspace.shapes import ShapeFigures, figures, without_slivers
from linkwright.studies.workspace.turning import TurningValues

if TYPE_CHECKING:
    from linkwright.studies.workspace.options import WorkspaceOptions

Array = NDArray[np.float64]


def in_units(compiled: Compiled, values: Mapping[str, float]) -> dict[str, float]:
    """Values of parameters in their units; angles in the file's."""
    quantities = compiled.quantities
    sizes = {name: quantities.unit_of(quantities.dimensions.of(name))[1] for name in values}
    return {name: float(f"{value / sizes[name]:.12g}") for name, value in values.items()}


def values_text(compiled: Compiled, values: Mapping[str, float]) -> str:
    """The same in a line."""
    quantities = compiled.quantities
    units = {name: quantities.unit_of(quantities.dimensions.of(name))[0] for name in values}
    return ", ".join(f"{name} = {v:.6g} {units[name]}".strip() for name, v in in_units(compiled, values).items())


@dataclass(frozen=True)
class Reached:
    """What one assembly mode reaches: ``mode`` as the file's assembly section states it."""

    mode: str
    signs: tuple[float, ...]
    region: Region

    @property
    def shape(self) -> Any:
        """The Shapely polygon, or several (m)."""
        return self.region.shape

    @cached_property
    def figures(self) -> ShapeFigures:
        """Its area and the like."""
        return figures(self.shape)


@dataclass(frozen=True)
class Overlap:
    """What two modes both reach: their numbers, and the shape."""

    first: int
    second: int
    shape: Any


@dataclass(frozen=True)
class Workspace:
    """The workspace for one combination of parameter values (SI): a region of each mode, or with one drive a curve.

    ``turning`` says at which values of one drive the other goes through all of its range.
    """

    values: dict[str, float]
    regions: tuple[Reached, ...]
    curves: tuple[Any, ...] = ()
    chord: float = 0.0
    turning: tuple[TurningValues, ...] = ()

    @cached_property
    def union(self) -> Any:
        """What some mode reaches; the gaps of a root of ``RIM`` that regions leave where two modes meet are closed."""
        import shapely

        shapes = [one.shape for one in self.regions]
        if len(shapes) > 1:
            gap = max(self.chord / 2, 2 * RIM**0.5 * self.regions[0].region.sheet.compiled.graph.size)
            grown = [shape.buffer(gap, join_style="mitre") for shape in shapes]
            shapes = [shapely.union_all(grown).buffer(-gap, join_style="mitre")]
        return without_slivers(shapely.union_all(shapes), self.chord)

    @cached_property
    def overlaps(self) -> tuple[Overlap, ...]:
        """What each two modes both reach."""
        import shapely

        return tuple(
            Overlap(i, k, without_slivers(shapely.intersection(a.shape, b.shape), self.chord))
            for (i, a), (k, b) in combinations(enumerate(self.regions), 2)
        )


@dataclass(eq=False)
class WorkspaceOutcome:
    """The workspaces of a study, one for each combination of parameter values; ``chord`` in m.

    ``parts`` are what is asked of them besides, by name; each has ``as_dict()``.
    """

    compiled: Compiled
    options: WorkspaceOptions
    chord: float
    box: DriveBox | None = None
    workspaces: list[Workspace] = field(default_factory=list)
    parts: dict[str, Any] = field(default_factory=dict)
    failures: list[Finding] = field(default_factory=list)
    warnings: list[Finding] = field(default_factory=list)

    @property
    def done(self) -> bool:
        """Whether there is a workspace for all values."""
        return not self.failures

    @property
    def result(self) -> Result | None:
        """A pose as an array of one, for a drawing: that of the start."""
        return Result(Run(self.compiled, 0.0, 0.0, 1)) if self.workspaces else None

    @property
    def point(self) -> str:
        """The working point."""
        return self.options.point

    def values_in_units(self, one: Workspace) -> dict[str, float]:
        """The varied parameters of a workspace by name, in their units; angles in the file's."""
        return in_units(self.compiled, one.values)

    def values_text(self, one: Workspace) -> str:
        """The same in a line."""
        return values_text(self.compiled, one.values)

    @property
    def regions(self) -> list[Reached]:
        """The regions of all workspaces."""
        return [one for workspace in self.workspaces for one in workspace.regions]
