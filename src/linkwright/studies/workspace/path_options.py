"""The section ``paths`` of a workspace study: what is wanted of each path, and what is wrong with that."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
from numpy.typing import NDArray
from pydantic import ConfigDict, Field, RootModel

from linkwright.elements.fields import DriveName, Vector, freeze
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Frozen, Text
from linkwright.expressions.fields import Name as NameField
from linkwright.expressions.language import ExpressionError, evaluate
from linkwright.expressions.typed_fields import Quantity, of_drive
from linkwright.expressions.written import Fault
from linkwright.findings import Finding, Joined, ModelError
from linkwright.kernels import Compiled
from linkwright.laws import DEGREES
from linkwright.model.actions import FileBeside
from linkwright.studies import numbers
from linkwright.studies.numbers import constant
from linkwright.studies.sampling_options import one_of
from linkwright.studies.workspace.target_path import (
    PATH,
    Path_,
    TargetPath,
    from_csv,
    from_dxf,
    from_formula,
    path_through_points,
)

if TYPE_CHECKING:
    from linkwright.studies.workspace.options import WorkspaceOptions

Array = NDArray[np.float64]

SOURCES = ("points", "file", "drawing", "x")
MOST = 100
"""The most paths of one study."""

Between = one_of("workspace", "between", [*DEGREES])
Pace = one_of("workspace", "timing", ["even", "rest"])


class WantedPath(Frozen):
    """A path that the working point is wanted to follow, and how the drives shall move along it."""

    points: Annotated[tuple[Vector, ...] | None, Quantity(u.LENGTH)] = Field(None, max_length=10_000)
    file: FileBeside | None = None
    drawing: FileBeside | None = None
    layer: Text | None = None
    x: Expression | None = None
    y: Expression | None = None
    between: Between = "cubic"  # type: ignore[valid-type]
    motor: DriveName
    speed: Annotated[Expression | None, of_drive(u.OMEGA, u.SPEED, lambda c: c.entry.motor)] = None
    duration: Annotated[Expression | None, Quantity(u.TIME)] = None
    timing: Pace = "even"  # type: ignore[valid-type]
    never_reverse: bool = False
    tolerance: Annotated[Expression | None, Quantity(u.LENGTH)] = None
    samples: int = Field(361, ge=2, le=100_000)

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        sources = [key for key in SOURCES if key in given]
        if len(sources) != 1 or ("x" in given) != ("y" in given):
            yield "workspace.path-source", {"given": Joined(sources) or "-"}
        if ("speed" in given) == ("duration" in given):
            yield "workspace.path-pace", {}
        for key, of in (("layer", ("drawing",)), ("timing", ("duration",)), ("between", ("points", "file"))):
            if key in given and not any(one in given for one in of):
                yield "workspace.path-key", {"key": key, "of": Joined(of)}


class WantedPaths(RootModel[Annotated[dict[NameField, WantedPath], freeze, Field(min_length=1, max_length=MOST)]]):
    """Paths by name."""

    model_config = ConfigDict(frozen=True)

    def check(self, compiled: Compiled, options: WorkspaceOptions) -> Iterator[Finding]:
        """What is wrong with them and with their files."""
        if len(compiled.graph.drives) != 2:
            yield Finding("workspace.section-drives", PATH, {"count": len(compiled.graph.drives)})
            return
        for name, path in self.root.items():
            yield from _check(compiled, path, (*PATH, name))


def _check(compiled: Compiled, path: WantedPath, at: Path_) -> Iterator[Finding]:
    if path.speed is not None and path.motor in compiled.graph.drives:
        speed, faults = constant(compiled.quantities, path.speed, rate_of(compiled, path.motor), (*at, "speed"))
        yield from faults
        if speed == 0:
            yield Finding("workspace.path-still", (*at, "speed"))
    for key, expression, dimension in (("duration", path.duration, u.TIME), ("tolerance", path.tolerance, u.LENGTH)):
        if expression is not None:
            yield from positive(compiled, expression, dimension, (*at, key))
    if path.points is not None:
        wrong = [
            fault
            for i, point in enumerate(path.points)
            for k, value in enumerate(point)
            for fault in constant(compiled.quantities, value, u.LENGTH, (*at, "points", i, k))[1]
        ]
        yield from wrong
        if wrong:
            return
    try:
        build_path(compiled, path, at, compiled.quantities.parameters)
    except ModelError as error:
        yield from error.findings


def rate_of(compiled: Compiled, drive: str) -> u.Dimension:
    """The dimension of a drive's speed."""
    return u.OMEGA if compiled.mechanism.prescribed(drive).turns else u.SPEED


def positive(compiled: Compiled, expression: Expression, dimension: u.Dimension, at: Path_) -> list[Finding]:
    """What is wrong with a value that must be positive."""
    data = {"key": str(at[-1]), "text": expression.text[:60]}
    return numbers.positive(compiled.quantities, expression, dimension, at, "workspace.not-positive", **data)[1]


def build_path(compiled: Compiled, path: WantedPath, at: Path_, parameters: Mapping[str, float]) -> TargetPath:
    """The path itself, for values of the parameters (SI). Raises ModelError."""
    quantities, source = compiled.quantities, (*at, next(key for key in SOURCES if getattr(path, key) is not None))
    if path.file is not None:
        made = from_csv(path.file, compiled.folder, path.between, source)
    elif path.drawing is not None:
        made = from_dxf(path.drawing, quantities.unit_of(u.LENGTH)[1], compiled.folder, path.layer, source)
    elif path.points is not None:
        points = [[valued(compiled, value, u.LENGTH, parameters) for value in point] for point in path.points]
        made = path_through_points(np.array(points).reshape(-1, 2), path.between, source)
    else:
        assert path.x is not None and path.y is not None
        made = from_formula(quantities, path.x.text, path.y.text, at, parameters)
    return replace(made, path=at)


def valued(
    compiled: Compiled, expression: Expression, dimension: u.Dimension, parameters: Mapping[str, float]
) -> float:
    """A constant for values of the parameters (SI); NaN where it has none."""
    node = compiled.quantities.bind(expression, dimension)
    try:
        with np.errstate(all="ignore"):
            return float(evaluate(node, lambda name: parameters[name.text]))
    except (ArithmeticError, ExpressionError):
        return float("nan")
