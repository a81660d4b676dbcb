"""Trajectories over workspaces, written: sentence, pictures, table, CSV."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache, partial
from typing import Any

import numpy as np

from linkwright.drawing.charts import named
from linkwright.drawing.colour_scale import colours
from linkwright.drawing.plane import Bounds, PicturePlane, framed_box, outline
from linkwright.drawing.tiled import tiled
from linkwright.expressions import units as u
from linkwright.findings import CLAUSES, Joined, Said, Text
from linkwright.model.csv_text import cell, head, table_text
from linkwright.presentation.blocks import Chart, Table, table
from linkwright.presentation.cells import Cell, NumberCell, Unit, numbers
from linkwright.presentation.charts import Axis, ColouredLines, ColourScale, Layer, Plane
from linkwright.studies.workspace.curve_lines import lines
from linkwright.studies.workspace.outcome import WorkspaceOutcome
from linkwright.studies.workspace.plane_layers import layers_of
from linkwright.studies.workspace.region_columns import region_cells, region_heads
from linkwright.studies.workspace.steps import SliderSteps
from linkwright.studies.workspace.trajectories_outcome import RegionTrajectories, TrajectoriesPart
from linkwright.studies.workspace.trajectory_picture import STOPS, ColouredLine, Scale, trajectory_picture

KINDS = ("singular", "modes", "pins")
THIN = 2.0
"""Trajectories of a page, which are many, are thinned to so many steps of its lines."""
PICTURES = 48
"""The most pictures."""


def trajectories_sentences(outcome: WorkspaceOutcome) -> list[Text]:
    """What is held, what moves, what the pictures show."""
    part = _part(outcome)
    held, moving = part.drives
    data = {"point": outcome.point, "held": held, "moving": moving}
    told: list[Text] = [Said("trajectories.sentence", count=len(part.values), **data)]
    if len(part.regions) > PICTURES:
        told.append(Said("workspace.shown.first", count=len(part.regions), limit=PICTURES))
    return told


def trajectories_tables(outcome: WorkspaceOutcome) -> list[Table]:
    """The trajectories of each region counted and measured."""
    own = ("held", "values", "drive-unit", "assembled", "whole", "stretches", "length", "unit")
    held, moving = _part(outcome).drives
    rows = [[*region_cells(outcome, entry), *_cells(entry)] for entry in _part(outcome).as_dict()]
    heads = [*region_heads(outcome), *own]
    return [table("trajectories", "trajectories", heads, rows, held=held, moving=moving)]


def _cells(entry: dict[str, Any]) -> list[Cell]:
    values = entry["values"]
    drive = [entry["hold"], numbers((values["from"], values["to"]), 6), Unit(values["unit"])]
    counts = [f"{entry['assembled']}/{values['count']}", NumberCell(entry["whole"]), NumberCell(entry["stretches"])]
    return [*drive, *counts, NumberCell(entry["length"]), Unit(entry["unit"])]


def trajectories_charts(outcome: WorkspaceOutcome) -> Sequence[Chart]:
    """A picture of each region's trajectories."""
    return _charts(_part(outcome))


@lru_cache(maxsize=2)
def _charts(part: TrajectoriesPart) -> Sequence[Chart]:
    """The pictures; they are wanted for the report and as a file. Those of a mode have the same axes."""
    regions = [one for one in part.regions if not one.reached.shape.is_empty][:PICTURES]
    modes = {one.reached.mode for one in regions}
    boxes = {
        mode: framed_box(one.reached.shape.bounds for one in regions if one.reached.mode == mode) for mode in modes
    }
    steps = SliderSteps(part.outcome)
    return tuple(_chart(part, one, boxes[one.reached.mode], steps) for one in regions)


def _chart(part: TrajectoriesPart, one: RegionTrajectories, box: Bounds, steps: SliderSteps) -> Chart:
    """The picture of one region."""
    outcome, compiled = part.outcome, part.outcome.compiled
    unit, size = compiled.quantities.unit_of(u.LENGTH)
    plane, (held, moving) = PicturePlane.of(box, unit, size), part.drives
    drive_unit, drive_size = compiled.quantities.drive_unit(held)
    values = outcome.values_text(one.workspace)
    mode = one.reached.mode or Said("workspace.one-mode")
    told = Said("workspace.for", values=values) if values else ""
    data = {"point": outcome.point, "held": held, "moving": moving}
    title = Said("trajectories.picture", mode=mode, values=told, **data)
    each = [
        ColouredLine(
            each.held / drive_size,
            [stretch.at / size for stretch in each.stretches],
            f"{held} = {each.held / drive_size:.6g} {drive_unit}".strip(),
        )
        for each in one.found.each
    ]
    over, legend = _singular(outcome, one, plane, size)
    scale = _scale(part, named(Said("trajectories.scale", **data), drive_unit))
    shape = outline(one.reached.shape, plane, size)
    drawing = partial(trajectory_picture, plane, each, scale, shape, over, legend, title)
    name = Said("trajectories.scale", **data)
    shown = partial(_plane, outcome, one, box, scale, Axis(name, drive_unit), each)
    return steps.chart(one.workspace, f"trajectories {one.reached.mode}", title, shown, drawing)


def _plane(
    outcome: WorkspaceOutcome,
    one: RegionTrajectories,
    box: Bounds,
    scale: Scale,
    axis: Axis,
    each: Sequence[ColouredLine],
) -> Plane:
    """The same for a page."""
    of, shares = layers_of(outcome), np.linspace(0.0, 1.0, STOPS + 1)
    stops = ColourScale(axis, scale.low, scale.high, colours(shares, scale.turn))
    lines = [(drawn.value, [of.thin(line * of.size, THIN) for line in drawn.lines]) for drawn in each]
    layers: list[Layer] = [
        of.region(one.reached, "muted"),
        ColouredLines(axis.name, stops, lines),
        *of.loci([one.reached], KINDS),
    ]
    return of.plane(layers, box)


def _singular(
    outcome: WorkspaceOutcome, one: RegionTrajectories, plane: PicturePlane, size: float
) -> tuple[list[str], list[tuple[str, Text]]]:
    """The singular positions of a region by kind, which lie over its trajectories, and the legend of them."""
    region, compiled = one.reached.region, outcome.compiled
    over: list[str] = []
    legend: list[tuple[str, Text]] = []
    data: dict[str, Text] = {"point": outcome.point, "drives": ", ".join(compiled.graph.drives)}
    data["groups"] = Joined((group.label for group in compiled.graph.branched), CLAUSES)
    for kind in KINDS:
        curves = [*lines(region.sheet, region.segments, kind, plane, size)]
        over += [f'<polyline class="kind k-{kind}" points="{curve}"/>' for curve in curves]
        legend += [(f"kind k-{kind}", Said(f"workspace.kind.{kind}", **data))] if curves else []
    return over, legend


def _scale(part: TrajectoriesPart, name: Text) -> Scale:
    """The colours of the held drive's values: over its whole range."""
    box = part.outcome.box
    assert box is not None
    unit, size = part.outcome.compiled.quantities.drive_unit(part.drives[0])
    return Scale(box.low[part.hold] / size, box.high[part.hold] / size, unit, box.turns[part.hold], name)


def trajectories_svg(outcome: WorkspaceOutcome) -> str | None:
    """The pictures: a row for each mode."""
    return (
        tiled(trajectories_charts(outcome))
        if "trajectories" in outcome.parts and trajectories_charts(outcome)
        else None
    )


def trajectories_csv(outcome: WorkspaceOutcome) -> str | None:
    """Each corner of each trajectory: the values of both drives, x, y."""
    part = _part(outcome)
    if not part.regions:
        return None
    quantities = outcome.compiled.quantities
    unit = quantities.unit_of(u.LENGTH)[0]
    names = [*outcome.options.for_]
    heads = [head(n, quantities.unit_of(quantities.dimensions.of(n))[0]) for n in names]
    drives = [head(drive, quantities.drive_unit(drive)[0]) for drive in part.drives]
    return table_text([*heads, "mode", drives[0], "stretch", drives[1], head("x", unit), head("y", unit)], _rows(part))


def _rows(part: TrajectoriesPart) -> Iterator[list[str]]:
    outcome = part.outcome
    quantities = outcome.compiled.quantities
    length = quantities.unit_of(u.LENGTH)[1]
    held, moving = (quantities.drive_unit(drive)[1] for drive in part.drives)
    for one in part.regions:
        front = [*map(cell, outcome.values_in_units(one.workspace).values()), one.reached.mode]
        for each in one.found.each:
            at_value = [*front, cell(each.held / held)]
            for number, stretch in enumerate(each.stretches, start=1):
                columns = [stretch.q / moving, *(stretch.at / length)]
                for row in zip(*(column.tolist() for column in columns), strict=True):
                    yield [*at_value, str(number), *map(cell, row)]


def _part(outcome: WorkspaceOutcome) -> TrajectoriesPart:
    found = outcome.parts["trajectories"]
    assert isinstance(found, TrajectoriesPart)
    return found
