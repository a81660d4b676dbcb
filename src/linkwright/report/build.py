"""A run as the data of its report."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

import numpy as np
from numpy.typing import NDArray

import linkwright
from linkwright.model.document import dump
from linkwright.model.findings import Finding
from linkwright.model.mechanism import Document
from linkwright.model.units import LENGTH, TIME
from linkwright.report.centrodes import centrodes
from linkwright.report.data import Failure, Joint, Link, Measure, Plot, Pose, ReportData, Scene, Series, Trace
from linkwright.report.facts import checks, facts
from linkwright.report.modes import modes_data
from linkwright.results import Result
from linkwright.structure import FRAME
from linkwright.studies import CycleOutcome, MeasureResult, ModesOutcome
from linkwright.words import LANGUAGE, catalogue, say

Array = NDArray[np.float64]


MAX_STEPS = 800
"""Poses in a report: enough for any screen, few enough for a page that opens at once."""


def report_data(document: Document, outcome: CycleOutcome, modes: ModesOutcome | None = None) -> ReportData:
    """Everything that the report of a run shows, in the file's units."""
    result = outcome.result.thinned(MAX_STEPS)
    quantities = result.run.compiled.quantities
    time_unit, second = quantities.unit_of(TIME)
    nearest = result.certificate.nearest if result.certificate else None
    nearest_text = f"{nearest.time / second:.6g} {time_unit}" if nearest else ""
    words = {key: text for key, text in catalogue().items() if key.startswith("report.")}
    data: ReportData = {
        "title": document.name,
        "subtitle": document.note or "",
        "version": linkwright.__version__,
        "language": LANGUAGE,
        "words": words,
        "time": {"values": (result.t / second).tolist(), "unit": time_unit, "label": say("plot.time")},
        "scene": scene(result),
        "plots": plots(result),
        "measures": [measure(m, second, time_unit) for m in outcome.measures],
        "certificate": checks(result.certificate, nearest_text) if result.certificate else [],
        "structure": facts(result.run.compiled),
        "failures": [_failure(f) for f in (*outcome.failures, *outcome.warnings)],
        "model_text": dump(document),
    }
    return data if modes is None else {**data, "modes": modes_data(modes)}


def _failure(finding: Finding) -> Failure:
    return {"code": finding.code, "what": finding.what, "mend": finding.mend}


def scene(result: Result) -> Scene:
    """The mechanism for the drawing: links, joints, and the paths of points that move."""
    compiled = result.run.compiled
    unit, size = compiled.quantities.unit_of(LENGTH)
    _, second = compiled.quantities.unit_of(TIME)
    geometry = compiled.assembly.start.geometry if compiled.assembly.start else None
    assert geometry is not None
    moving = compiled.structure.topology.moving
    rows = [f"{link}:{row}" for link in moving for row in ("x", "y", "cos", "sin")]
    poses = dict(zip(rows, compiled.evaluate(rows, result.t), strict=True))
    links: list[Link] = []
    for name, entry in compiled.mechanism.links.items():
        points = {p: [c / size for c in geometry.point(name, p)] for p in entry.points}
        pose: Pose = {"x": [0.0], "y": [0.0], "c": [1.0], "s": [0.0]}
        if name != FRAME:
            x, y, c, s = (poses[f"{name}:{row}"] for row in ("x", "y", "cos", "sin"))
            pose = {"x": _listed(x / size), "y": _listed(y / size), "c": _listed(c), "s": _listed(s)}
        links.append({"name": name, "fixed": name == FRAME, "points": points, "pose": pose})
    return {
        "length_unit": unit,
        "time": (result.t / second).tolist(),
        "links": links,
        "joints": _joints(result),
        "traces": _traces(result, size),
        "centrodes": centrodes(result, size),
    }


def _joints(result: Result) -> list[Joint]:
    compiled = result.run.compiled
    assert compiled.assembly.start is not None
    geometry = compiled.assembly.start.geometry
    found: list[Joint] = []
    for pin in compiled.structure.topology.pins.values():
        first = pin.links[0]
        for link in pin.links[1:]:
            points = [pin.point(first), pin.point(link)]
            found.append({"name": pin.name, "kind": "revolute", "links": [first, link], "points": points})
    for name, joint in compiled.mechanism.prismatic_joints():
        assert joint.line is not None
        angles = [float(geometry.heading_angle(name, link)) for link in joint.links]
        points = [line.point for line in joint.line]
        found.append(
            {
                "name": name,
                "kind": "prismatic",
                "links": list(joint.links),
                "points": points,
                "angles": angles,
            }
        )
    return found


def _traces(result: Result, size: float) -> list[Trace]:
    found: list[Trace] = []
    for point in _moving_points(result):
        x, y = result[f"{point}.x"], result[f"{point}.y"]
        found.append({"name": point, "x": _listed(x / size), "y": _listed(y / size)})
    return found


def _moving_points(result: Result) -> list[str]:
    homes = result.run.compiled.quantities.signals.homes
    spans = {p: max(_span(result[f"{p}.x"]), _span(result[f"{p}.y"])) for p in homes}
    largest = max(spans.values(), default=0.0)
    return [p for p, span in spans.items() if span > 1e-9 * largest]


def _span(values: Array) -> float:
    known = values[np.isfinite(values)]
    return float(np.ptp(known)) if known.size else 0.0


def _listed(values: Array) -> list[float | None]:
    return [value if value == value and abs(value) != np.inf else None for value in values.tolist()]


def plots(result: Result) -> list[Plot]:
    """Motion and force plots, those in which something happens."""
    compiled = result.run.compiled
    m, signals = compiled.mechanism, compiled.quantities.signals
    links = compiled.structure.topology.moving
    found: list[Plot | None] = []
    for point in _moving_points(result):
        for title, axes in (("position", ""), ("velocity", "v"), ("acceleration", "a")):
            names = [f"{point}.{axes}{axis}" for axis in "xy"]
            found.append(_plot(result, say(f"plot.{title}", name=point), "motion", names))
    for attribute in ("angle", "omega", "alpha"):
        names = [f"{link}.{attribute}" for link in links]
        found.append(_plot(result, say(f"plot.{attribute}"), "motion", names))
    found += [_plot(result, say("plot.slide", name=n), "motion", [f"{n}.s"]) for n, _ in m.prismatic_joints()]
    seen: set[str] = set()
    for contact in signals.contacts:
        key = contact.joint if contact.on != contact.joint else f"{contact.joint}/{contact.link}"
        if key in seen:
            continue
        seen.add(key)
        name = f"force({contact.link}, {contact.on})"
        if f"{name}.x" not in result.names:
            name = f"force({contact.link}, {contact.on}, {contact.joint})"
        title = say("plot.force", a=contact.link, b=contact.on)
        found.append(_plot(result, title, "force", [f"{name}.x", f"{name}.y"]))
        if contact.sliding:
            title = say("plot.moment", a=contact.link, b=contact.on)
            found.append(_plot(result, title, "force", [f"{name}.moment"]))
    turning = [name for name, drive in m.drives.items() if drive.turns]
    sliding = [name for name in m.drives if name not in turning]
    found.append(_plot(result, say("plot.torque"), "force", [f"{n}.torque" for n in turning]))
    found.append(_plot(result, say("plot.effort"), "force", [f"{n}.force" for n in sliding]))
    found.append(_plot(result, say("plot.power"), "force", [f"{n}.power" for n in m.drives]))
    found.append(_plot(result, say("plot.shaking"), "force", ["shaking.x", "shaking.y"]))
    found.append(_plot(result, say("plot.shaking_moment"), "force", ["shaking.moment"]))
    return [plot for plot in found if plot is not None]


def _plot(result: Result, title: str, group: Literal["motion", "force"], names: Sequence[str]) -> Plot | None:
    """A plot of some signals of one unit; ``None`` where all of them stay zero."""
    shown = [(name, *result.shown(name)) for name in names]
    if not any(_largest(values) > 0 for _, values, _ in shown):
        return None
    series: list[Series] = [{"name": name, "values": _listed(values)} for name, values, _ in shown]
    return {"title": title, "group": group, "unit": shown[0][2], "series": series}


def _largest(values: Array) -> float:
    """The largest magnitude, round-off beside whole numbers counted as zero."""
    top = float(np.nanmax(np.abs(values), initial=0.0))
    return top if top > 1e-12 else 0.0


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
                "value": f.value / m.size,
                "at": "" if f.time is None else say("measure.at", time=f"{f.time / second:.6g} {time_unit}"),
            }
            for f in m.found
        ],
        "unit": m.unit,
        "requirement": m.requirement,
        "verdict": m.verdict,
    }
