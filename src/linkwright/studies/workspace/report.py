"""The workspace study as entries of the summary, sentences and tables, in the file's units."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from linkwright.expressions import units as u
from linkwright.findings import Joined, Said, Text
from linkwright.presentation.blocks import Block, Charts, Section, Sentences, StudyReport, Table, table
from linkwright.presentation.cells import Cell, NumberCell, Numbers, Unit, numbers, percent
from linkwright.presentation.json_numbers import known
from linkwright.studies.sides import side_sentences
from linkwright.studies.workspace.certificate import RegionCertificate
from linkwright.studies.workspace.doubts import sized
from linkwright.studies.workspace.outcome import Workspace, WorkspaceOutcome
from linkwright.studies.workspace.parts_report import section_documents
from linkwright.studies.workspace.picture import areas, pictures
from linkwright.studies.workspace.region_columns import mode_cell, value_cells, value_heads
from linkwright.studies.workspace.shapes import ShapeFigures, figures
from linkwright.studies.workspace.steps import SliderSteps


def workspace_entry(outcome: WorkspaceOutcome) -> dict[str, Any]:
    """Entries of the summary: lengths in the file's unit, areas in its square."""
    unit, size = outcome.compiled.quantities.unit_of(u.LENGTH)
    regions, unions, overlaps, curves, turning = [], [], [], [], []
    for one in outcome.workspaces:
        values = outcome.values_in_units(one)
        for reached in one.regions:
            region = reached.region
            more = {"unit": unit, "steps": region.steps, "rough": region.rough / size}
            more["certificate"] = certificate_entry(region.certificate, size)
            regions.append({"mode": reached.mode, **values, **_shape_entry(reached.figures, size), **more})
        if one.regions:
            both = sum_of_overlaps(one)
            unions.append({**values, **_shape_entry(figures(one.union), size), "several": both / size**2, "unit": unit})
        for overlap in one.overlaps:
            first, second = one.regions[overlap.first], one.regions[overlap.second]
            told = figures(overlap.shape)
            overlaps.append(
                {
                    "modes": [first.mode, second.mode],
                    **values,
                    "area": told.area / size**2,
                    "share": told.area / min(first.figures.area, second.figures.area),
                    "parts": told.parts,
                    "bounds": _bounds(told.bounds, size),
                    "unit": unit,
                }
            )
        turning += [{**values, **found.as_dict(outcome.compiled.quantities)} for found in one.turning]
        for curve in one.curves:
            told_curve = {"length": curve.length / size, "parts": len(curve.stretches), "unit": unit}
            closed = all(stretch.closed for stretch in curve.stretches)
            bounds = _bounds(curve.bounds, size)
            curves.append({"mode": curve.mode, **values, **told_curve, "closed": closed, "bounds": bounds})
    entry: dict[str, Any] = {"point": outcome.point, "drives": _drives(outcome), "chord": outcome.chord / size}
    entry |= {
        "unit": unit,
        "area_unit": f"{unit}^2",
        "regions": regions,
        "union": unions,
        "overlap": overlaps,
        "turning": turning,
    }
    entry |= {"curves": curves} if curves else {}
    return {"workspace": entry | {name: part.as_dict() for name, part in outcome.parts.items()}}


def certificate_entry(found: RegionCertificate, size: float) -> dict[str, Any]:
    """What is proven of a region, lengths in units of ``size`` m."""
    area = None if found.area is None else [bound / size**2 for bound in found.area]
    entry = {"grade": found.grade, "certified": found.certified, "area": area}
    faults = [{"kind": one.kind, "size": sized(one, size), "at": [x / size for x in one.at]} for one in found.faults]
    return entry | {"parts": found.parts, "holes": found.holes, "finest": found.finest / size, "faults": faults}


def sum_of_overlaps(one: Workspace) -> float:
    """The area (m2) that several modes reach."""
    import shapely

    return float(shapely.union_all([overlap.shape for overlap in one.overlaps]).area) if one.overlaps else 0.0


def _bounds(bounds: tuple[float, ...], size: float) -> list[float | None]:
    return [known(edge / size) for edge in bounds]


def _shape_entry(found: ShapeFigures, size: float) -> dict[str, Any]:
    return {
        "area": found.area / size**2,
        "perimeter": found.perimeter / size,
        "holes": found.holes,
        "parts": found.parts,
        "bounds": _bounds(found.bounds, size),
        "centroid": _bounds(found.centroid, size),
    }


def _drives(outcome: WorkspaceOutcome) -> dict[str, Any]:
    made = {}
    for drive in outcome.compiled.graph.drives:
        unit, size = outcome.compiled.quantities.drive_unit(drive)
        low, high = outcome.options.range(outcome.compiled, drive) or (math.nan, math.nan)
        made[drive] = {"from": low / size, "to": high / size, "unit": unit}
    return made


def report(outcome: WorkspaceOutcome) -> StudyReport:
    """What was found, pictures for all values of varied parameters, tables."""
    summary = workspace_entry(outcome)
    drawn = [*pictures(outcome), *(chart for part in section_documents(outcome) for chart in part.charts(outcome))]
    blocks: list[Block] = [
        Sentences(workspace_sentences(outcome)),
        Charts(drawn, SliderSteps(outcome).sliders()),
        *workspace_tables(outcome, summary["workspace"]),
    ]
    return StudyReport([Section("workspace", blocks)], summary, areas(outcome))


def workspace_sentences(outcome: WorkspaceOutcome) -> list[Text]:
    """What was found, and how exact it is."""
    unit, size = outcome.compiled.quantities.unit_of(u.LENGTH)
    if curves := [curve for one in outcome.workspaces for curve in one.curves]:
        return [Said("workspace.sentence.curves", point=outcome.point, count=len(curves))]
    if not outcome.regions:
        return [Said("workspace.sentence.none")]
    data = {"point": outcome.point, "count": len(outcome.regions), "unit": unit}
    told: list[Text] = [Said("workspace.sentence", chord=f"{outcome.chord / size:.2g}", **data)]
    rough = max(one.region.rough for one in outcome.regions)
    if rough > outcome.chord:
        told.append(Said("workspace.rough", rough=f"{rough / size:.2g}", unit=unit))
    told += _proven([one.region.certificate for one in outcome.regions], unit, size)
    told += side_sentences(one.mode for one in outcome.regions)
    return [*told, *(text for part in section_documents(outcome) for text in part.sentences(outcome))]


def _proven(every: list[RegionCertificate], unit: str, size: float) -> list[Text]:
    """What the certificates of all regions say together."""
    enclosed = [one for one in every if one.area is not None]
    told = list[Text]()
    if enclosed:
        finest = max(one.finest for one in enclosed) / size
        sure = all(one.parts and one.holes for one in enclosed)
        counts = Said("workspace.counts.certified", finest=f"{finest:.2g}", unit=unit)
        told += [Said("workspace.certified"), counts if sure else Said("workspace.counts.open")]
    searched = len(every) - len(enclosed)
    return [*told, Said("workspace.searched", count=searched)] if searched else told


def workspace_tables(outcome: WorkspaceOutcome, entry: dict[str, Any]) -> list[Table]:
    """Its entry as tables, and those of its parts."""
    made = []
    for name, (columns, cells) in _TABLES.items():
        rows = ([*value_cells(outcome, one), *cells(one)] for one in entry.get(name, ()))
        made.append(table("workspace", name, [*value_heads(outcome), *columns], rows))
    return [*made, *(one for part in section_documents(outcome) for one in part.tables(outcome))]


Entry = Mapping[str, Any]


def _region(one: Entry) -> list[Cell]:
    proven = one["certificate"]
    sure = proven["certified"] or not proven["faults"]
    within = numbers(proven["area"] or (), unit=u.squared(one["unit"]))
    grade = Said(f"workspace.grade.{proven['grade'] if sure else 'contradicted'}")
    return [mode_cell(one), _area(one, "area"), within, *_shape(one), grade]


def _shape(one: Entry) -> list[Cell]:
    proven = one.get("certificate", {})
    counts: list[Cell] = [
        Said("workspace.count-open", count=one[what])
        if proven.get("area") and not proven[what]
        else NumberCell(one[what])
        for what in ("holes", "parts")
    ]
    return [NumberCell(one["perimeter"], unit=one["unit"]), *counts, *_extents(one)]


def _extents(one: Entry) -> Iterator[Numbers]:
    for low, high in zip(one["bounds"][:2], one["bounds"][2:], strict=True):
        yield numbers(() if low is None else without_traces((low, high)), 6, one["unit"])


TRACE = 1e-6
"""The share of the larger end of a range below which the other one is only what is left of zero: six digits are
shown."""


def without_traces(ends: tuple[float, float]) -> tuple[float, ...]:
    """The ends of a range, with zero for what is only a trace beside the larger one."""
    largest = max(map(abs, ends))
    return tuple(0.0 if abs(end) < TRACE * largest else float(end) for end in ends)


def _area(one: Entry, key: str) -> NumberCell:
    return NumberCell(one[key], unit=u.squared(one["unit"]))


def _turning(one: Entry) -> list[Cell]:
    intervals: Text = Joined(numbers(ends, 6) for ends in one["intervals"])
    if one["whole"] or not one["intervals"]:
        intervals = Said("workspace.everywhere" if one["whole"] else "workspace.nowhere")
    signs = Joined(f"{group} {sign:+d}" for group, sign in one["mode"].items()) or Said("workspace.every-mode")
    return [one["drive"], intervals, one["other"], Unit(one["unit"]), signs]


_SHAPE = ("perimeter", "holes", "parts", "x", "y")
_TABLES: Mapping[str, tuple[tuple[str, ...], Callable[[Entry], list[Cell]]]] = {
    "regions": (("mode", "area", "within", *_SHAPE, "grade"), _region),
    "union": (("area", *_SHAPE, "both"), lambda one: [_area(one, "area"), *_shape(one), _area(one, "several")]),
    "overlap": (
        ("modes", "area", "share", "parts"),
        lambda one: [" / ".join(one["modes"]), _area(one, "area"), percent(one["share"]), NumberCell(one["parts"])],
    ),
    "turning": (("drive", "intervals", "other", "unit", "signs"), _turning),
    "curves": (
        ("mode", "length", "parts", "x", "y"),
        lambda one: [
            mode_cell(one),
            NumberCell(one["length"], unit=one["unit"]),
            NumberCell(one["parts"]),
            *_extents(one),
        ],
    ),
}
"""By their key in the entry: the columns, and the cells of one row."""
