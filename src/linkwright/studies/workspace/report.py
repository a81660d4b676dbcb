"""The workspace study as entries of the summary, sentences and tables, in the file's units."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from linkwright.expressions import units as u
from linkwright.findings import Said, Text
from linkwright.presentation.blocks import Block, Charts, Section, Sentences, StudyReport, Table
from linkwright.studies.workspace.certificate import Certificate
from linkwright.studies.workspace.doubts import sized
from linkwright.studies.workspace.outcome import Workspace, WorkspaceOutcome
from linkwright.studies.workspace.parts_report import written
from linkwright.studies.workspace.picture import areas, pictures
from linkwright.studies.workspace.shapes import Figures, figures
from linkwright.studies.workspace.steps import Steps


def workspace_entry(outcome: WorkspaceOutcome) -> dict[str, Any]:
    """Entries of the summary: lengths in the file's unit, areas in its square."""
    unit, size = outcome.compiled.quantities.unit_of(u.LENGTH)
    regions, unions, overlaps, curves, turning = [], [], [], [], []
    for one in outcome.workspaces:
        values = outcome.shown(one)
        for reached in one.regions:
            region = reached.region
            more = {"unit": unit, "steps": region.steps, "rough": region.rough / size}
            more["certificate"] = certificate_entry(region.certificate, size)
            regions.append({"mode": reached.mode, **values, **_told(reached.figures, size), **more})
        if one.regions:
            both = sum_of_overlaps(one)
            unions.append({**values, **_told(figures(one.union), size), "several": both / size**2, "unit": unit})
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


def certificate_entry(found: Certificate, size: float) -> dict[str, Any]:
    """What is proven of a region, lengths in units of ``size`` m."""
    area = None if found.area is None else [bound / size**2 for bound in found.area]
    entry = {"grade": found.grade, "certified": found.certified, "area": area}
    faults = [{"kind": one.kind, "size": sized(one, size), "at": [x / size for x in one.at]} for one in found.faults]
    return entry | {"parts": found.parts, "holes": found.holes, "finest": found.finest / size, "faults": faults}


def sum_of_overlaps(one: Workspace) -> float:
    """The area (m2) that several modes reach."""
    import shapely

    return float(shapely.union_all([overlap.shape for overlap in one.overlaps]).area) if one.overlaps else 0.0


def known(value: float) -> float | None:
    """A number, or nothing."""
    return value if math.isfinite(value) else None


def _bounds(bounds: tuple[float, ...], size: float) -> list[float | None]:
    return [known(edge / size) for edge in bounds]


def _told(found: Figures, size: float) -> dict[str, Any]:
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
    drawn = [*pictures(outcome), *(chart for part in written(outcome) for chart in part.charts(outcome))]
    blocks: list[Block] = [
        Sentences(workspace_sentences(outcome)),
        Charts(drawn, Steps(outcome).sliders()),
        *workspace_tables(outcome),
    ]
    return StudyReport([Section("workspace", blocks)], workspace_entry(outcome), areas(outcome))


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
    return [*told, *(text for part in written(outcome) for text in part.sentences(outcome))]


def _proven(every: list[Certificate], unit: str, size: float) -> list[Text]:
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


def workspace_tables(outcome: WorkspaceOutcome) -> list[Table]:
    """Tables of text; those with nothing in them are left out."""
    entry = workspace_entry(outcome)["workspace"]
    names = [*outcome.options.for_]
    grids = [
        _grid("regions", ("mode", "area", "within", *_SHAPE[1:], "grade"), names, entry["regions"]),
        _grid("union", (*_SHAPE, "both"), names, entry["union"]),
        _grid("overlap", ("modes", "area", "share", "parts"), names, entry["overlap"]),
        _grid("turning", ("drive", "intervals", "other", "unit", "signs"), names, entry["turning"]),
        _grid("curves", ("mode", "length", "parts", "x", "y"), names, entry.get("curves", [])),
    ]
    grids += [grid for part in written(outcome) for grid in part.tables(outcome)]
    return grids


_SHAPE = ("area", "perimeter", "holes", "parts", "x", "y")


def _grid(name: str, columns: tuple[str, ...], names: list[str], entries: list[Mapping[str, Any]]) -> Table:
    heads: list[Text] = [*names, *(Said(f"workspace.column.{column}") for column in columns)]
    rows = [[*(f"{entry[n]:.6g}" for n in names), *(_cell(entry, column) for column in columns)] for entry in entries]
    return Table(f"workspace-{name}", Said(f"workspace.table.{name}"), heads, rows)


def _between(ends: list[float], unit: str) -> str:
    low, high = ends
    return f"{low:.7g} .. {high:.7g} {unit}".rstrip()


def _cell(entry: Mapping[str, Any], column: str) -> Text:
    unit, proven = entry.get("unit", ""), entry.get("certificate", {})
    if column in ("x", "y") and "bounds" in entry:
        low, high = entry["bounds"]["xy".index(column) :: 2]
        return "-" if low is None else f"{low:.6g} .. {high:.6g} {unit}".rstrip()
    if column in ("area", "both"):
        return f"{entry['several' if column == 'both' else column]:.7g} {u.squared(unit)}".rstrip()
    if column == "within":
        return "-" if proven["area"] is None else _between(proven["area"], u.squared(unit))
    if column in ("perimeter", "length"):
        return f"{entry[column]:.7g} {unit}".rstrip()
    if column in ("parts", "holes") and proven.get("area") and not proven[column]:
        return Said("workspace.count-open", count=entry[column])
    if column == "grade":
        sure = proven["certified"] or not proven["faults"]
        return Said(f"workspace.grade.{proven['grade'] if sure else 'contradicted'}")
    if column == "modes":
        return " / ".join(entry["modes"])
    if column == "mode":
        return entry["mode"] or Said("workspace.one-mode")
    if column == "intervals":
        if entry["whole"]:
            return Said("workspace.everywhere")
        return ", ".join(f"{low:.6g} .. {high:.6g}" for low, high in entry["intervals"]) or Said("workspace.nowhere")
    if column == "signs":
        return ", ".join(f"{group} {sign:+d}" for group, sign in entry["mode"].items()) or Said("workspace.every-mode")
    value = entry[column]
    if column == "share":
        return f"{100 * value:.4g} %"
    return str(value) if isinstance(value, int | str) else f"{value:.7g}"
