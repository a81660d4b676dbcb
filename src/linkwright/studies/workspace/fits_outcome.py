"""Required circles and rectangles in each region of a workspace study, and the largest there is room for."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions import units as u
from linkwright.findings import Finding
from linkwright.kernels import Compiled
from linkwright.studies.workspace.fit_options import PATH, RequiredFit, RequiredFits
from linkwright.studies.workspace.fits import (
    FigureMargin,
    LargestCircle,
    Rectangle,
    circle_fits,
    largest_circle,
    largest_rectangle,
    rectangle_fits,
)
from linkwright.studies.workspace.outcome import Reached, Workspace, WorkspaceOutcome, in_units, values_text
from linkwright.studies.workspace.path_options import valued
from linkwright.studies.workspace.path_outcome import parameters_of

Array = NDArray[np.float64]

ROUND = 181
"""Corners of a circle when it is drawn."""


@dataclass(frozen=True, eq=False)
class FigureFit:
    """A figure in a region: ``fit`` of a required one, ``figure`` the largest; ``size`` is a radius, or width and
    height (m), ``angle`` rad."""

    name: str
    index: int
    workspace: Workspace
    reached: Reached
    size: tuple[float, ...]
    angle: float
    fit: FigureMargin | None
    figure: LargestCircle | Rectangle | None

    @property
    def centre(self) -> tuple[float, float]:
        """Where it was put."""
        found = self.fit or self.figure
        assert found is not None
        return found.centre

    @property
    def passed(self) -> bool:
        """Whether it fits; the largest does."""
        return self.fit is None or self.fit.fits

    @property
    def rank(self) -> tuple[bool, float]:
        """How good it is."""
        return self.passed, self.size[0] if self.fit is None else self.fit.margin

    @property
    def outline(self) -> Array:
        """Its corners, (2, n) in m."""
        if len(self.size) == 1:
            turn = np.linspace(0.0, 2 * np.pi, ROUND)
            around = self.size[0] * np.stack([np.cos(turn), np.sin(turn)])
        else:
            c, s = np.cos(self.angle), np.sin(self.angle)
            corners = np.array([[-1.0, 1, 1, -1, -1], [-1, -1, 1, 1, -1]]) * np.array(self.size)[:, None] / 2
            around = np.array([[c, -s], [s, c]]) @ corners
        return np.asarray(np.array(self.centre)[:, None] + around)


@dataclass(frozen=True, eq=False)
class Required:
    """The part of the outcome: each figure in each region."""

    compiled: Compiled
    placed: tuple[FigureFit, ...]

    @cached_property
    def best(self) -> dict[str, FigureFit]:
        """The best place of each figure."""
        return self._best(self.placed)

    def within(self, index: int) -> dict[str, FigureFit]:
        """The best place of each figure in one workspace."""
        return self._best(tuple(one for one in self.placed if one.index == index))

    @staticmethod
    def _best(placed: tuple[FigureFit, ...]) -> dict[str, FigureFit]:
        found: dict[str, FigureFit] = {}
        for one in placed:
            if one.name not in found or one.rank > found[one.name].rank:
                found[one.name] = one
        return found

    def as_dict(self) -> list[dict[str, Any]]:
        """Entries of the summary, in the file's units."""
        return [self._entry(one) for one in self.placed]

    def _entry(self, one: FigureFit) -> dict[str, Any]:
        unit, size = self.compiled.quantities.unit_of(u.LENGTH)
        degree = self.compiled.quantities.unit_of(u.ANGLE)[1]
        keys = ("radius",) if len(one.size) == 1 else ("width", "height")
        entry = {
            "figure": one.name,
            "shape": "circle" if len(one.size) == 1 else "rectangle",
            "mode": one.reached.mode,
            **in_units(self.compiled, one.workspace.values),
            **{key: length / size for key, length in zip(keys, one.size, strict=True)},
            **({} if len(one.size) == 1 else {"angle": one.angle / degree}),
            "centre": [place / size for place in one.centre],
            "unit": unit,
            "best": self.best[one.name] is one,
        }
        if one.figure is not None:
            return entry | {"largest": True, "at_most": one.figure.at_most / size}
        assert one.fit is not None
        told = {"fits": one.fit.fits, "margin": one.fit.margin / size, "scale": one.fit.scale}
        return entry | {"largest": False, **told, "outside": one.fit.outside}


def required(fits: RequiredFits, outcome: WorkspaceOutcome) -> Required:
    """Each figure in each region. One that fits into none of them is a failure."""
    compiled = outcome.compiled
    placed = [
        made
        for index, one in enumerate(outcome.workspaces)
        for name, figure in fits.root.items()
        for reached in one.regions
        if (made := _fit_figure(compiled, name, figure, index, one, reached)) is not None
    ]
    found = Required(compiled, tuple(placed))
    outcome.failures += [_nowhere(compiled, best) for best in found.best.values() if not best.passed]
    return found


def _fit_figure(
    compiled: Compiled, name: str, figure: RequiredFit, index: int, one: Workspace, reached: Reached
) -> FigureFit | None:
    parameters = parameters_of(one, compiled)
    known: dict[str, list[float]] = {}
    for place, _ in figure.stated_numbers(compiled, name):
        dimension = compiled.quantities.dimensions.resolve(place.wanted)
        known.setdefault(str(place.path[-1]), []).append(valued(compiled, place.expression, dimension, parameters))
    (angle,), (aspect,) = known.get("angle", [0.0]), known.get("aspect", [1.0])
    centre = (known["centre"][0], known["centre"][1]) if "centre" in known else None
    shape = reached.shape
    fit: FigureMargin | None = None
    found: LargestCircle | Rectangle | None = None
    size: tuple[float, ...]
    if figure.circle is not None:
        size = (known["circle"][0],)
        fit = circle_fits(shape, size[0], centre)
    elif figure.rectangle is not None:
        size = (known["rectangle"][0], known["rectangle"][1])
        fit = rectangle_fits(shape, size[0], size[1], angle, centre)
    elif figure.largest == "circle":
        found = largest_circle(shape)
        size = (found.radius,) if found else ()
    else:
        found = largest_rectangle(shape, aspect, angle)
        size = (found.width, found.height) if found else ()
    return FigureFit(name, index, one, reached, size, angle, fit, found) if fit or found else None


def _nowhere(compiled: Compiled, best: FigureFit) -> Finding:
    """What is to be said of a figure that fits nowhere."""
    assert best.fit is not None
    unit, size = compiled.quantities.unit_of(u.LENGTH)
    data = {
        "name": best.name,
        "mode": best.reached.mode or "-",
        "values": values_text(compiled, best.workspace.values) or "-",
        "by": f"{-best.fit.margin / size:.4g} {unit}",
        "share": f"{100 * best.fit.outside:.3g}",
        "scale": f"{best.fit.scale:.4g}",
    }
    return Finding("workspace.fit-none", (*PATH, best.name), data)
