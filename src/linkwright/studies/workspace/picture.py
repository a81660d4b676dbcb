"""Workspaces as pictures: regions by mode, the curves by kind, axes of one scale in the file's unit."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache, partial

import numpy as np
from numpy.typing import NDArray

from linkwright.drawing.charts import points
from linkwright.drawing.plane import Bounds, PicturePlane, framed, framed_box, outline
from linkwright.expressions import units as u
from linkwright.findings import CLAUSES, Joined, Said, Text
from linkwright.presentation.blocks import Area, Chart
from linkwright.presentation.charts import Plane
from linkwright.studies.workspace.curve_lines import lines
from linkwright.studies.workspace.outcome import Workspace, WorkspaceOutcome
from linkwright.studies.workspace.overlay import Overlay
from linkwright.studies.workspace.parts_report import section_documents
from linkwright.studies.workspace.plane_layers import layers_of
from linkwright.studies.workspace.shapes import pieces
from linkwright.studies.workspace.steps import SliderSteps

Array = NDArray[np.float64]

KINDS = ("singular", "modes", "pins", "limit")


@lru_cache(maxsize=1)
def pictures(outcome: WorkspaceOutcome) -> Sequence[Chart]:
    """A picture of each workspace, all on the same axes; they are wanted for the report and as files."""
    if not outcome.workspaces:
        return ()
    steps, overlays = SliderSteps(outcome), [_over(outcome, index) for index in range(len(outcome.workspaces))]
    drawn = [shape for one in outcome.workspaces for shape in (*(r.shape for r in one.regions), *one.curves)]
    bounds = framed_box(shape.bounds for shape in (*drawn, *(overlay for some in overlays for overlay in some)))
    charts: list[Chart] = []
    for one, over in zip(outcome.workspaces, overlays, strict=True):
        text = outcome.values_text(one)
        told = Said("workspace.for", values=text) if text else ""
        title = Said("workspace.picture", point=outcome.point, values=told)
        shown, drawing = (
            partial(_plane, outcome, one, bounds, over),
            partial(picture, outcome, one, title, bounds, over),
        )
        charts.append(steps.chart(one, "regions", title, shown, drawing))
    return tuple(charts)


def _plane(outcome: WorkspaceOutcome, one: Workspace, box: Bounds, over: Sequence[Overlay]) -> Plane:
    """The same for a page."""
    layers = layers_of(outcome)
    return layers.plane(layers.workspace(one, over), box)


def _over(outcome: WorkspaceOutcome, index: int) -> list[Overlay]:
    return [overlay for part in section_documents(outcome) for overlay in part.overlays(outcome, index)]


def picture(outcome: WorkspaceOutcome, one: Workspace, title: Text, box: Bounds, over: Sequence[Overlay] = ()) -> str:
    """One workspace as SVG, with what is drawn over it, in a ``box`` (m) of the plane."""
    unit, size = outcome.compiled.quantities.unit_of(u.LENGTH)
    plane = PicturePlane.of(box, unit, size)
    shapes: list[str] = []
    legend: list[tuple[str, Text]] = []
    for i, reached in enumerate(one.regions):
        shapes.append(f'<path class="region m{i % 4}" d="{outline(reached.shape, plane, size)}"/>')
        text = Said("workspace.kind.region", mode=reached.mode or Said("workspace.one-mode"))
        legend.append((f"region m{i % 4}", text))
    for i, curve in enumerate(one.curves):
        for stretch in curve.stretches:
            way = points(*plane.to_picture(*(stretch.at / size)))
            shapes.append(f'<polyline class="path m{i % 4}" points="{way}"/>')
        legend.append((f"path m{i % 4}", Said("workspace.kind.curve", mode=curve.mode or Said("workspace.one-mode"))))
    for kind in KINDS:
        paths = [line for r in one.regions for line in lines(r.region.sheet, r.region.segments, kind, plane, size)]
        if paths:
            shapes += [f'<polyline class="kind k-{kind}" points="{way}"/>' for way in paths]
            groups = Joined((group.label for group in outcome.compiled.graph.branched), CLAUSES)
            data = {"point": outcome.point, "drives": ", ".join(outcome.compiled.graph.drives), "groups": groups}
            legend.append((f"kind k-{kind}", Said(f"workspace.kind.{kind}", **data)))
    for overlay in over:
        for line in overlay.lines:
            shapes.append(
                f'<polyline class="over {overlay.kind}" points="{points(*plane.to_picture(*(line / size)))}"/>'
            )
        legend.append((f"over {overlay.kind}", overlay.text))
    return framed(plane, shapes, legend, title)


def areas(outcome: WorkspaceOutcome) -> list[Area]:
    """The regions of the file's own parameters, to lie behind the mechanism, thinned to what can be seen."""
    compiled = outcome.compiled
    size = compiled.quantities.unit_of(u.LENGTH)[1]
    own = dict(zip(compiled.graph.parameters, compiled.parameters.tolist(), strict=True))
    found: list[Area] = []
    for one in outcome.workspaces:
        if not all(np.isclose(value, own[name], rtol=1e-12, atol=0) for name, value in one.values.items()):
            continue
        for reached in one.regions:
            bounds = np.array(reached.shape.bounds)
            thin = reached.shape.simplify(5e-4 * float((bounds[2:] - bounds[:2]).max()))
            lines = [ring for polygon in pieces(thin) for ring in (polygon.exterior, *polygon.interiors)]
            rings = [(np.array(line.coords)[:-1] / size).tolist() for line in lines]
            found.append(Area(reached.mode or Said("workspace.one-mode"), rings))
    return found
