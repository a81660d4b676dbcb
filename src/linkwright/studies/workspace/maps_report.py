"""Quality and errors over workspaces, written: sentences, pictures, tables, CSV, shapes."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import lru_cache, partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.drawing.charts import named
from linkwright.drawing.levels import band_stops, levels_of
from linkwright.drawing.plane import PicturePlane, framed_box, outline
from linkwright.drawing.tiled import tiled
from linkwright.expressions import units as u
from linkwright.findings import CLAUSES, Joined, Said, Text
from linkwright.model.csv_text import cell, head, table_text
from linkwright.presentation.blocks import Chart, Table, table
from linkwright.presentation.cells import UNKNOWN, Cell, NumberCell, Numbers, Unit, numbers, percent
from linkwright.presentation.charts import Axis, Field, Layer, Lines, Plane
from linkwright.studies.workspace.curve_lines import lines
from linkwright.studies.workspace.errors_outcome import ErrorsPart, RegionErrors
from linkwright.studies.workspace.map_picture import beyond_edge, map_picture
from linkwright.studies.workspace.mapped_regions import RegionMaps
from linkwright.studies.workspace.outcome import WorkspaceOutcome
from linkwright.studies.workspace.plane_layers import layers_of
from linkwright.studies.workspace.quality import better
from linkwright.studies.workspace.quality_outcome import QualityPart, by_drives, closures
from linkwright.studies.workspace.raster import raster
from linkwright.studies.workspace.region_columns import region_cells, region_heads
from linkwright.studies.workspace.steps import SliderSteps

Array = NDArray[np.float64]
Part = QualityPart | ErrorsPart

CELLS = 160
"""Places of a picture's grid along its longer side."""
EVERY = 2
"""A page has every so many of these places in each direction."""
SINGULAR = ("singular", "modes", "pins")
"""Kinds of curves that lie over maps."""
PICTURES = 24
"""The most pictures of a part."""
ROWS = 5_000
"""About so many rows of a table of maps, at the most."""


def quality_sentences(outcome: WorkspaceOutcome) -> list[Text]:
    """Which determinants are meant, what the pictures show."""
    part = _quality(outcome)
    data = {"determinant": by_drives(outcome), "point": outcome.point}
    told = [Said("workspace.quality", **data)]
    if groups := closures(outcome):
        told.append(Said("workspace.quality.closures", groups=groups))
    return [*told, *_pictured(part, "better")]


def errors_sentences(outcome: WorkspaceOutcome) -> list[Text]:
    """What deviates, what is guaranteed."""
    part = _errors(outcome)
    unit, size = outcome.compiled.quantities.unit_of(u.LENGTH)
    told = [*_causes(part, unit, size)]
    if part.limit is not None:
        told.append(Said("workspace.errors.precise", limit=f"{part.limit / size:.6g}", unit=unit, point=outcome.point))
    return [*told, *_pictured(part, "worse")]


def _causes(part: ErrorsPart, unit: str, size: float) -> Iterator[Text]:
    """What deviates within limits, how joints with clearance are taken to lie, by kind; that the rest is guaranteed."""
    every = [one.causes for one in part.regions]
    names = dict.fromkeys(name for one in every for name in one.contributors.names)
    data = {"point": part.outcome.point}
    yield Said("workspace.errors" if names else "workspace.errors.clearances", names=Joined(names), **data)
    held = [joint for one in every for joint in one.held]
    for kind in dict.fromkeys(joint.kind for joint in held):
        plays = dict.fromkeys((joint.joint, joint.clearance) for joint in held if joint.kind == kind)
        told = (f"{joint} {clearance / size:.6g} {unit}" for joint, clearance in plays)
        yield Said(f"workspace.errors.{kind}", joints=Joined(told))
    yield Said("workspace.errors.guaranteed", **data)


def _pictured(part: Part, which: str) -> Iterator[Text]:
    if part.shown:
        yield Said(f"workspace.shown.{which}")
    if (count := len(part.regions) * len(part.shown)) > PICTURES:
        yield Said("workspace.shown.first", count=count, limit=PICTURES)


def quality_tables(outcome: WorkspaceOutcome) -> list[Table]:
    """The least and greatest values of the maps by region; singular positions."""
    entries, unit = _quality(outcome).as_dict(), Unit(outcome.compiled.quantities.unit_of(u.LENGTH)[0])
    maps = [
        [*region_cells(outcome, entry), title(outcome, name), _value_range(one), Unit(one["unit"] or UNKNOWN)]
        for entry in entries
        for name, one in entry["maps"].items()
    ]

    def locus(one: dict[str, Any]) -> list[Cell]:
        kind = Said(f"workspace.locus.{one['kind']}")
        determinant = by_drives(outcome) if one["kind"] == "limit-position" else closures(outcome)
        return [kind, determinant or UNKNOWN, NumberCell(one["curves"]), NumberCell(one["length"], 6), unit]

    loci = [[*region_cells(outcome, entry), *locus(one)] for entry in entries for one in entry["loci"]]
    front = region_heads(outcome)
    return [
        table("workspace", "quality", [*front, "map", "ends", "unit"], maps),
        table("workspace", "loci", [*front, "locus", "determinant", "count", "length", "unit"], loci),
    ]


def errors_tables(outcome: WorkspaceOutcome) -> list[Table]:
    """The worst errors, and what is sure of each region."""
    part, errors, sure = _errors(outcome), list[list[Cell]](), list[list[Cell]]()
    for entry in part.as_dict():
        found = entry["maps"]
        rows = [(found[f"error {axis} least"]["least"], found[f"error {axis} most"]["greatest"]) for axis in "xy"]
        told = [
            _value_range(found["error worst"]),
            *(_between(*ends) for ends in rows),
            _value_range(found["spread worst"]),
        ]
        unit, front = entry["unit"], region_cells(outcome, entry)
        errors.append([*front, *told, Unit(unit)])
        whats = [entry[kind] for kind in ("guaranteed", "precise") if kind in entry]
        areas = [cell for w in whats for cell in (NumberCell(w["area"], 6, u.squared(unit)), percent(w["share"]))]
        sure.append([*front, *areas, numbers(entry["guaranteed"]["inward"], 4, unit)])
    kinds = ["guaranteed", "share-region", *(["precise", "share-region"] if part.limit is not None else []), "inward"]
    axes = (Said("workspace.column.error", axis=axis, point=outcome.point) for axis in "xy")
    shown: list[Text] = [title(outcome, "error worst"), *axes, title(outcome, "spread worst"), "unit"]
    return [
        table("workspace", "errors", [*region_heads(outcome), *shown], errors),
        table("workspace", "guaranteed", [*region_heads(outcome), *kinds], sure),
    ]


def title(outcome: WorkspaceOutcome, name: str) -> Said:
    """What a map shows, in words."""
    drive = name.removeprefix("effort ")
    if drive != name:
        turns = outcome.compiled.mechanism.prescribed(drive).turns
        return Said("workspace.map.torque" if turns else "workspace.map.push", drive=drive)
    return Said(f"workspace.map.{name.replace(' ', '-')}", determinant=by_drives(outcome), point=outcome.point)


def _value_range(one: dict[str, Any]) -> Numbers:
    return _between(one["least"], one["greatest"])


def _between(*ends: dict[str, Any] | None) -> Numbers:
    endless = Said("workspace.endless")
    return Numbers([NumberCell(None) if end is None else NumberCell(end["value"], 5, unknown=endless) for end in ends])


def quality_charts(outcome: WorkspaceOutcome) -> Sequence[Chart]:
    """A picture of each map that is shown, for each region."""
    return _charts(_quality(outcome))


def errors_charts(outcome: WorkspaceOutcome) -> Sequence[Chart]:
    """The same of the errors, with what is sure of the region."""
    return _charts(_errors(outcome))


@lru_cache(maxsize=4)
def _charts(part: Part) -> Sequence[Chart]:
    """The pictures of a part; they are wanted for the report and as a file. Those of a mode have the same axes."""
    count = -(-PICTURES // max(len(part.shown), 1))
    regions = [one for one in part.regions[:count] if part.shown and not one.reached.shape.is_empty]
    modes: dict[str, list[RegionMaps]] = {}
    for one in regions:
        modes.setdefault(one.reached.mode, []).append(one)
    pictured = {mode: _Pictured(part, some) for mode, some in modes.items()}
    return tuple(chart for one in regions for chart in pictured[one.reached.mode].charts(one))[:PICTURES]


class _Pictured:
    """The pictures of one mode's regions: the same axes, and by map the same levels, for all values."""

    def __init__(self, part: Part, regions: Sequence[RegionMaps]) -> None:
        self.part, self.steps = part, SliderSteps(part.outcome)
        self.unit, self.size = part.outcome.compiled.quantities.unit_of(u.LENGTH)
        self.box = framed_box(one.reached.shape.bounds for one in regions)
        self.plane = PicturePlane.of(self.box, self.unit, self.size)
        self.found = {id(one): raster(one.reached.region, one.maps, CELLS) for one in regions}
        self.levels = {name: self._levels(name, regions) for name in part.shown}

    def _values(self, one: RegionMaps, name: str) -> Array:
        return self.found[id(one)].map(name, _score(self.part, name)) / one.maps.maps[name].size

    def _levels(self, name: str, regions: Sequence[RegionMaps]) -> list[float]:
        if (stated := self.part.levels.get(name)) is not None:
            return [level / regions[0].maps.maps[name].size for level in stated]
        return levels_of(np.concatenate([self._values(one, name).ravel() for one in regions]))

    def charts(self, one: RegionMaps) -> Iterator[Chart]:
        """A picture of each map that is shown of a region."""
        outcome, shape = self.part.outcome, outline(one.reached.shape, self.plane, self.size)
        over, legend = _over(self.part, one, self.plane, self.size)
        found = self.found[id(one)]
        axes = (found.x / self.size, found.y / self.size)
        values_text = outcome.values_text(one.workspace)
        told = Said("workspace.for", values=values_text) if values_text else ""
        data = {"point": outcome.point, "mode": one.reached.mode or Said("workspace.one-mode"), "values": told}
        for name in self.part.shown:
            heading = Said("workspace.map", map=title(outcome, name), **data)
            scale = named(title(outcome, name), one.maps.maps[name].unit)
            values, levels = self._values(one, name), self.levels[name]
            drawing = partial(map_picture, self.plane, axes, values, levels, shape, over, legend, heading, scale)
            stack = f"{type(self.part).__name__} {name} {one.reached.mode}"
            axis = Axis(title(outcome, name), one.maps.maps[name].unit)
            yield self.steps.chart(
                one.workspace, stack, heading, partial(self._plane, one, axes, values, levels, axis), drawing
            )

    def _plane(
        self, one: RegionMaps, axes: tuple[Array, Array], values: Array, levels: Sequence[float], axis: Axis
    ) -> Plane:
        """A map for a page, of every other place."""
        of = layers_of(self.part.outcome)
        rings, (x, y) = of.rings(one.reached.shape), (axis[::EVERY] for axis in axes)
        some, bands = beyond_edge(values[::EVERY, ::EVERY]), band_stops(len(levels) + 1)
        layers: list[Layer] = [Field(axis, x, y, some, levels, bands, rings=rings, coarse=True)]
        if isinstance(one, RegionErrors):
            for dash, (kind, shape) in enumerate((("guaranteed", one.sure.shape), ("precise", one.sure.precise))):
                if shape is not None and not shape.is_empty:
                    layers.append(Lines(Said(f"workspace.kind.{kind}"), of.rings(shape), "warn", dash, 1.8))
        else:
            layers += of.loci([one.reached], SINGULAR, "warn")
        return of.plane(layers, self.box)


def _score(part: Part, name: str) -> Callable[[Array], Array]:
    """Which of several poses counts: of the quality the better, of errors the worse."""
    return np.abs if isinstance(part, ErrorsPart) else lambda values: better(name, values)


def _over(part: Part, one: RegionMaps, plane: PicturePlane, size: float) -> tuple[list[str], list[tuple[str, Text]]]:
    """What lies over a map, and the legend of it: singular positions by kind, or what is sure."""
    outcome, region = part.outcome, one.reached.region
    shapes: list[str] = []
    legend: list[tuple[str, Text]] = []
    if isinstance(one, RegionErrors):
        for kind, shape in (("guaranteed", one.sure.shape), ("precise", one.sure.precise)):
            if shape is not None and not shape.is_empty:
                shapes.append(f'<path class="part p-{kind}" d="{outline(shape, plane, size)}"/>')
                legend.append((f"part p-{kind}", Said(f"workspace.kind.{kind}")))
        return shapes, legend
    data: dict[str, Text] = {"point": outcome.point, "drives": ", ".join(outcome.compiled.graph.drives)}
    data["groups"] = Joined((group.label for group in outcome.compiled.graph.branched), CLAUSES)
    for kind in SINGULAR:
        ways = [*lines(region.sheet, region.segments, kind, plane, size)]
        shapes += [f'<polyline class="locus k-{kind}" points="{way}"/>' for way in ways]
        legend += [(f"locus k-{kind}", Said(f"workspace.kind.{kind}", **data))] if ways else []
    return shapes, legend


def quality_svg(outcome: WorkspaceOutcome) -> str | None:
    """The pictures: a row for each map and mode."""
    return tiled(quality_charts(outcome)) if "quality" in outcome.parts and quality_charts(outcome) else None


def errors_svg(outcome: WorkspaceOutcome) -> str | None:
    """The same of the errors."""
    return tiled(errors_charts(outcome)) if "errors" in outcome.parts and errors_charts(outcome) else None


def errors_shapes(outcome: WorkspaceOutcome) -> Iterator[tuple[Any, dict[str, Any]]]:
    """What is sure of each region."""
    part = _errors(outcome)
    for one, entry in zip(part.regions, part.as_dict(), strict=True):
        told = {"mode": one.reached.mode, "values": outcome.values_in_units(one.workspace)}
        for kind, shape in (("guaranteed", one.sure.shape), ("precise", one.sure.precise)):
            if shape is not None:
                limit = {"limit": entry[kind]["limit"]} if kind == "precise" else {}
                yield shape, {"kind": kind, **told, **limit, "area": entry[kind]["area"]}


def quality_csv(outcome: WorkspaceOutcome) -> str | None:
    """The maps at some of the drives' values."""
    return _csv(outcome.parts.get("quality"))


def errors_csv(outcome: WorkspaceOutcome) -> str | None:
    """The same of the errors."""
    return _csv(outcome.parts.get("errors"))


def _csv(part: Part | None) -> str | None:
    if part is None or not part.regions:
        return None
    outcome = part.outcome
    quantities = outcome.compiled.quantities
    unit, size = quantities.unit_of(u.LENGTH)
    names, maps = [*outcome.options.for_], part.regions[0].maps.maps.values()
    drives = [(drive, *quantities.drive_unit(drive)) for drive in outcome.compiled.graph.drives]
    heads = [head(n, quantities.unit_of(quantities.dimensions.of(n))[0]) for n in names]
    heads += ["mode", *(head(d, w) for d, w, _ in drives), head("x", unit), head("y", unit)]
    sizes = [*(scale for _, _, scale in drives), size, size, *(one.size for one in maps)]
    stride = int(np.ceil((part.steps + 1) / max((ROWS / len(part.regions)) ** 0.5, 8.0)))
    return table_text([*heads, *(head(one.name, one.unit) for one in maps)], _rows(part, stride, np.array(sizes)))


def _rows(part: Part, stride: int, sizes: Array) -> Iterable[list[str]]:
    for one in part.regions:
        values = part.outcome.values_in_units(one.workspace).values()
        front = [*map(cell, values), one.reached.mode]
        q = np.stack(np.meshgrid(*one.maps.axes, indexing="ij"))
        columns = np.concatenate([q, one.maps.at, [found.values for found in one.maps.maps.values()]])
        some = columns[:, ::stride, ::stride].reshape(len(columns), -1)
        for row in (some[:, np.isfinite(some[2])] / sizes[:, None]).T.tolist():
            yield [*front, *map(cell, row)]


def _quality(outcome: WorkspaceOutcome) -> QualityPart:
    found = outcome.parts["quality"]
    assert isinstance(found, QualityPart)
    return found


def _errors(outcome: WorkspaceOutcome) -> ErrorsPart:
    found = outcome.parts["errors"]
    assert isinstance(found, ErrorsPart)
    return found
