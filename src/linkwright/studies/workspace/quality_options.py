"""The section ``quality`` of a workspace study's options: the maps of each region, and its singular positions."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Annotated, ClassVar

from pydantic import BeforeValidator, Discriminator, Field, Tag

from linkwright.elements.fields import DriveName, freeze
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, FrozenDict, Two, pair
from linkwright.expressions.typed_fields import Quantity, of_drive
from linkwright.expressions.units import Dimension
from linkwright.findings import Finding, Joined, Term
from linkwright.kernels import Compiled
from linkwright.model.mechanism import Mechanism
from linkwright.studies.numbers import constant
from linkwright.studies.workspace.maps_options import MapsAsked, limit
from linkwright.studies.workspace.quality import QualityTask, kinds, possible

if TYPE_CHECKING:
    from linkwright.studies.workspace.options import WorkspaceOptions

_NEEDS = {"speed": "speeds", "speed any way": "speeds", "force": "efforts", "force any way": "efforts"}
Limits = Annotated[dict[DriveName, Expression], freeze]
Force = Annotated[
    Annotated[Two, BeforeValidator(pair("force")), Tag("a pair")] | Annotated[Expression, Tag("a size")],
    Discriminator(lambda raw: "a pair" if isinstance(raw, list | tuple) else "a size"),
]


class QualityOptions(MapsAsked):
    """How well the mechanism works over its workspace, for a task."""

    section: ClassVar[str] = "quality"

    speeds: Annotated[Limits, of_drive(u.OMEGA, u.SPEED)] = Field(
        default_factory=FrozenDict, examples=[{"motor": "30 rpm"}]
    )
    efforts: Annotated[Limits, of_drive(u.TORQUE, u.FORCE)] = Field(
        default_factory=FrozenDict, examples=[{"motor": "2 N*m"}]
    )
    force: Annotated[Force | None, Quantity(u.FORCE)] = None

    def kinds_in(self, mechanism: Mechanism) -> Mapping[str, Dimension]:
        return possible(mechanism)

    def check(self, compiled: Compiled, options: WorkspaceOptions) -> Iterator[Finding]:
        """What is wrong with the task, the maps' names and their lines."""
        yield from self.check_drives(compiled)
        if len(compiled.graph.drives) != 2:
            return
        yield from self.task(compiled)[1]
        both = (1.0, 1.0)
        given = QualityTask(
            both if self.speeds else None, both if self.efforts else None, None if self.force is None else 1.0
        )
        known = kinds(compiled, given)
        needs = _NEEDS | {f"effort {drive}": "force" for drive in compiled.graph.drives}
        yield from self.check_maps(compiled, known, {name: key for name, key in needs.items() if name not in known})

    def task(self, compiled: Compiled) -> tuple[QualityTask, list[Finding]]:
        """The task in SI, and what is wrong with it."""
        speeds, wrong = self._limits(compiled, "speeds", self.speeds, {True: u.OMEGA, False: u.SPEED})
        efforts, more = self._limits(compiled, "efforts", self.efforts, {True: u.TORQUE, False: u.FORCE})
        path = (*self.path, "force")
        if isinstance(self.force, tuple):
            found = [constant(compiled.quantities, value, u.FORCE, (*path, i)) for i, value in enumerate(self.force)]
        elif self.force is not None:
            found = [limit(compiled, self.force, u.FORCE, path, Term("size-of-force"))]
        else:
            found = []
        values, faults = _sorted(found)
        force = (values[0], values[1]) if len(values) == 2 else values[0] if values else None
        return QualityTask(speeds, efforts, force), [*wrong, *more, *faults]

    def _limits(
        self, compiled: Compiled, key: str, given: Mapping[str, Expression], dimensions: Mapping[bool, Dimension]
    ) -> tuple[tuple[float, float] | None, list[Finding]]:
        """The limits of both drives, and what is wrong with them; ``dimensions`` by whether a drive turns."""
        path, drives, found, wrong = (*self.path, key), compiled.graph.drives, [], list[Finding]()
        if given and (lacking := [name for name in drives if name not in given]):
            wrong.append(Finding("workspace.limit-missing", path, {"key": key, "drives": Joined(lacking)}))
        for name in drives:
            if name in given:
                dimension = dimensions[bool(compiled.mechanism.prescribed(name).turns)]
                what = Term("drive-limit", drive=name, under=key)
                found.append(limit(compiled, given[name], dimension, (*path, name), what))
        values, faults = _sorted(found)
        return (values[0], values[1]) if len(values) == 2 else None, [*wrong, *faults]


def _sorted(found: Sequence[tuple[float | None, list[Finding]]]) -> tuple[list[float], list[Finding]]:
    """Values, and what is wrong with the others."""
    return [value for value, _ in found if value is not None], [fault for _, faults in found for fault in faults]
