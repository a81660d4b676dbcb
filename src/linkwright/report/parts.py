"""How the outcome of each study is written: its entries in the summary, its sections of the page, its files."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from linkwright._machine import needed
from linkwright.expressions.units import TIME
from linkwright.findings import Finding
from linkwright.measures import Grade, MeasureResult
from linkwright.model.document import Document
from linkwright.model.origin import Origin
from linkwright.report.accuracy import accuracy_entry
from linkwright.report.accuracy_files import bands_csv as accuracy_bands_csv
from linkwright.report.accuracy_files import contributors_csv
from linkwright.report.accuracy_files import netcdf_bytes as accuracy_netcdf
from linkwright.report.accuracy_page import accuracy_page
from linkwright.report.cam import cam_entry, cam_page
from linkwright.report.cam_files import FILES as CAM_FILES
from linkwright.report.data import Measure
from linkwright.report.facts import checks, remarks
from linkwright.report.limits import limits_entry, limits_tables
from linkwright.report.modes import modes_data, told
from linkwright.report.reactions import reactions_csv, reactions_entry, reactions_tables
from linkwright.report.summary import cycle_entry
from linkwright.report.sweep import sweep_entry, sweep_page
from linkwright.report.sweep_files import bands_csv, samples_csv
from linkwright.report.sweep_files import netcdf_bytes as sweep_netcdf
from linkwright.report.workspace import workspace_entry, workspace_page
from linkwright.report.workspace_files import boundary_csv, dxf, geojson, png, svg
from linkwright.report.workspace_parts import FILES as WORKSPACE_FILES
from linkwright.report.workspace_picture import areas
from linkwright.report.workspace_trajectories import trajectories_svg
from linkwright.results import Result
from linkwright.results.netcdf import netcdf_bytes
from linkwright.studies import CycleOutcome, LimitsOutcome, SweepOutcome
from linkwright.studies.accuracy.outcome import AccuracyOutcome
from linkwright.studies.sample_kept import store
from linkwright.studies.workspace.region_files import FOLDER as REGIONS
from linkwright.words import say


@dataclass(frozen=True)
class Part:
    """How one study is written.

    ``summary`` gives its entries in summary.json, ``page`` its keys of the report's data, ``result`` what the report
    draws (where no study before it has one), ``scene`` what lies behind that, ``files`` the text of further files by
    name (none of those it lacks), ``netcdf`` and ``png`` those that are written only where asked for, ``stores`` the
    names of the folders (Zarr stores, parts of an interrupted study) that the study fills while it runs. ``settle`` is
    told that all is written.
    """

    summary: Callable[[Any], dict[str, Any]]
    page: Callable[[Any], dict[str, Any]]
    result: Callable[[Any], Result | None]
    scene: Callable[[Any], dict[str, Any]] = lambda outcome: {}
    files: dict[str, Callable[[Any], str | bytes | None]] = field(default_factory=dict)
    netcdf: dict[str, Callable[[Any], str | bytes | None]] = field(default_factory=dict)
    png: dict[str, Callable[[Any], str | bytes | None]] = field(default_factory=dict)
    stores: Callable[[Any], Sequence[str]] = lambda options: ()
    settle: Callable[[Any], None] = lambda outcome: None

    def all_files(self, netcdf: bool = False, png: bool = False) -> dict[str, Callable[[Any], str | bytes | None]]:
        """All files with those that are asked for."""
        return self.files | (self.netcdf if netcdf else {}) | (self.png if png else {})


def _cycle_page(outcome: CycleOutcome) -> dict[str, Any]:
    result = outcome.result
    time_unit, second = result.run.compiled.quantities.unit_of(TIME)
    nearest = result.certificate.nearest if result.certificate else None
    nearest_text = f"{nearest.time / second:.6g} {time_unit}" if nearest else ""
    return {
        "measures": [measure(m, second, time_unit) for m in outcome.measures],
        "certificate": checks(result.certificate, nearest_text) if result.certificate else [],
        "remarks": remarks(result.certificate) if result.certificate else [],
    }


def _cycle_netcdf(outcome: CycleOutcome) -> bytes:
    return netcdf_bytes(outcome.result, outcome.result.names, outcome.warnings)


def _limits_page(outcome: LimitsOutcome) -> dict[str, Any]:
    return {"limits": limits_tables(limits_entry(outcome)["limits"])}


def measure(m: MeasureResult, second: float, time_unit: str) -> Measure:
    """A line of the table of measures."""
    entry, reduction = m.measure, m.measure.reduction
    data = {
        "reduction": reduction,
        "signal": m.measure.subject,
        "window": entry.window,
        "where": entry.where,
    }
    key = "measure.text.where" if entry.where else "measure.text.window" if entry.window else "measure.text"
    return {
        "name": m.name,
        "text": say(key, **data),
        "values": [
            {
                "label": say(f"measure.{f.label}") if f.label else "",
                "value": None if f.unbounded else f.value / m.size,
                "text": say("value.unbounded") if f.unbounded else "",
                "at": "" if f.time is None else _at(f.side, f"{f.time / second:.6g} {time_unit}"),
                "grade": grade_text(f.grade, second, time_unit),
            }
            for f in m.found
        ],
        "unit": m.unit,
        "requirement": m.requirement,
        "verdict": m.verdict,
    }


def _at(side: str, time: str) -> str:
    return say(f"measure.at.{side}" if side else "measure.at", time=time)


def grade_text(grade: Grade, second: float, time_unit: str) -> str:
    """How sure a number is, with the width below which a search may miss features."""
    width = "" if grade.width is None else f"{grade.width / second:.2g} {time_unit}"
    return say(f"grade.{grade.kind.value}", width=width)


PARTS: dict[str, Part] = {
    "cycle": Part(
        summary=cycle_entry,
        page=_cycle_page,
        result=lambda outcome: outcome.result,
        files={"cycle.csv": lambda outcome: outcome.result.to_csv()},
        netcdf={"cycle.nc": _cycle_netcdf},
    ),
    "limits": Part(summary=limits_entry, page=_limits_page, result=lambda outcome: outcome.result),
    "modes": Part(
        summary=lambda outcome: {"modes": told(outcome)},
        page=lambda outcome: {"modes": modes_data(outcome)},
        result=lambda outcome: None,
    ),
    "sweep": Part(
        summary=sweep_entry,
        page=sweep_page,
        result=lambda outcome: Result(outcome.run),
        files={"sweep.csv": samples_csv, "sweep_bands.csv": bands_csv},
        netcdf={"sweep.nc": sweep_netcdf},
        stores=lambda options: [store("sweep")] if options.keeps else [],
        settle=SweepOutcome.settle,
    ),
    "accuracy": Part(
        summary=accuracy_entry,
        page=accuracy_page,
        result=lambda outcome: Result(outcome.run),
        files={"accuracy.csv": contributors_csv, "accuracy_bands.csv": accuracy_bands_csv},
        netcdf={"accuracy.nc": accuracy_netcdf},
        settle=AccuracyOutcome.settle,
    ),
    "workspace": Part(
        summary=workspace_entry,
        page=workspace_page,
        result=lambda outcome: outcome.result,
        scene=lambda outcome: {"areas": areas(outcome)},
        files={
            "workspace.geojson": geojson,
            "workspace.svg": svg,
            "workspace_boundary.csv": boundary_csv,
            "workspace.dxf": dxf,
            **WORKSPACE_FILES,
        },
        png={
            "workspace.png": lambda outcome: png(svg(outcome), needed("resvg_py", "png")),
            "workspace_trajectories.png": lambda outcome: png(trajectories_svg(outcome), needed("resvg_py", "png")),
        },
        stores=lambda options: [REGIONS],
    ),
    "reactions": Part(
        summary=reactions_entry,
        page=lambda outcome: {"reactions": reactions_tables(outcome)},
        result=lambda outcome: outcome.result,
        files={"reactions.csv": reactions_csv},
    ),
    "cam": Part(summary=cam_entry, page=cam_page, result=lambda outcome: outcome.result, files=CAM_FILES),
}
"""By study, in the order in which they stand in summary and report."""


SCHEMA = 2
"""The version of the layout of ``summary.json``: 2 has grades, and ``null`` with ``unbounded`` where 1 had numbers."""


def drawn(outcomes: Mapping[str, Any]) -> Result | None:
    """What the report of some outcomes draws."""
    results = (part.result(outcomes[name]) for name, part in PARTS.items() if name in outcomes)
    return next((result for result in results if result is not None), None)


def found(outcomes: Mapping[str, Any]) -> list[Finding]:
    """What the studies found: failures and warnings; no warning of what is another one's failure."""
    failures = [finding for outcome in outcomes.values() for finding in outcome.failures]
    warnings = [finding for outcome in outcomes.values() for finding in outcome.warnings]
    told = {(finding.code, finding.path) for finding in failures}
    return [*failures, *(finding for finding in warnings if (finding.code, finding.path) not in told)]


def summary(document: Document, outcomes: Mapping[str, Any], findings: list[Finding], origin: Origin) -> dict[str, Any]:
    """What ``summary.json`` holds: origin, name, verdict, the entries of each study, all findings of the file and its
    run."""
    done = bool(outcomes) and all(outcome.done for outcome in outcomes.values())
    done = done and not any(finding.severity == "error" for finding in findings)
    data: dict[str, Any] = {"schema": SCHEMA, "linkwright": origin.version, **origin.as_dict()}
    data |= {"name": document.title, "done": done}
    for name, part in PARTS.items():
        if name in outcomes:
            entry = part.summary(outcomes[name])
            if "measures" in entry:  # the file's own stay what they are
                entry |= {"measures": entry["measures"] | data.get("measures", {})}
            data |= entry
    return data | {"findings": [finding.as_dict() for finding in findings]}
