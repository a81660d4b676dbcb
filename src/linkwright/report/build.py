"""A run as the data of its report."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, cast

import numpy as np
from numpy.typing import NDArray

from linkwright.elements.cylinder import ends_of
from linkwright.elements.force import FORCES, SignalChart
from linkwright.escape import printed
from linkwright.expressions.units import LENGTH, TIME, Dimension
from linkwright.findings import Finding, Said, Term, Text
from linkwright.measures import sampled_times
from linkwright.model.document import Document, dump
from linkwright.model.origin import Origin, hashed
from linkwright.model.yaml_text import Source, read_text
from linkwright.presentation.blocks import Section
from linkwright.presentation.json_numbers import listed
from linkwright.presentation.lettering import without_hanzi_spaces
from linkwright.report.arrows import arrow_data, arrows, force_name
from linkwright.report.centrodes import centrodes
from linkwright.report.data import (
    Fact,
    JointData,
    LinkData,
    LiveData,
    Plot,
    Pose,
    Problem,
    ReportData,
    Scene,
    Series,
    Severity,
    SpringData,
    Time,
    Trace,
)
from linkwright.report.first_plots import first_plots
from linkwright.report.joint_shapes import is_cylinder, joint_shapes
from linkwright.report.live import can_be_live, live_data, recorded_for
from linkwright.report.outlines import Shapes
from linkwright.report.packed import rounded
from linkwright.report.structure_summary import facts
from linkwright.report.summary import drawn, found
from linkwright.results import Result
from linkwright.structure import FRAME
from linkwright.studies.cycle.report import untaken
from linkwright.studies.drive_sweep import Sweep
from linkwright.studies.registry import Outcomes

Array = NDArray[np.float64]


MAX_STEPS = 800
"""Poses in a report: enough for any screen, few enough for a page that opens at once."""


_RATES = (("position", ""), ("velocity", "v"), ("acceleration", "a"))


def report_data(
    document: Document,
    outcomes: Outcomes,
    examined: Sequence[Finding] = (),
    origin: Origin | None = None,
    text: str | Source | None = None,
) -> ReportData:
    """Everything that the report of some outcomes shows, in the file's units. One of them has something to draw.

    ``examined`` are the findings on the file itself, ``text`` is what stands in it, or was read of it. Without an
    ``origin`` it is that of a document made in Python.
    """
    origin = origin or Origin(None, hashed(dump(document).encode()))
    whole, shown = drawn(outcomes), outcomes.reports()
    assert whole is not None
    result = whole.thinned(MAX_STEPS)
    if can_be_live(result):
        result = result.at(rounded(sampled_times(result.run, result.run.steps)))
    findings = [*examined, *found(outcomes)]
    picture, curves = scene(result), plots(result) if result.t[-1] > result.t[0] else []
    source = text if isinstance(text, Source) else Source(text=text)
    if source.data is None:
        source = read_text((source.text or dump(document)).encode())
    shown_arrows = arrows(result) if can_be_live(result) else []
    live = live_data(document, source, result, picture, curves, shown_arrows)
    if live and shown_arrows:
        picture["arrows"] = arrow_data(result, shown_arrows)
    data: ReportData = {
        "title": document.title,
        "subtitle": without_hanzi_spaces(document.note or ""),
        "source": Said("report.source", source=without_hanzi_spaces(document.source)) if document.source else "",
        "title_block": title_block(document, origin),
        "version": origin.version,
        "time": axis(result),
        "scene": picture,
        "plots": curves,
        "first": first_plots(curves, result),
        "live": live,
        "recorded": "" if live else Said(f"report.recorded.{recorded_for(result) or 'numbers'}"),
        "sections": [*_untaken(result, live), *(section for one in shown for section in one.sections)],
        "structure": facts(result.run.compiled),
        "problems": [_problem(finding) for finding in findings],
        "model_text": source.text or "",
    }
    if areas := [area for one in shown for area in one.areas]:
        data["scene"]["areas"] = [{"name": area.name, "rings": area.rings} for area in areas]
    return data


def _untaken(result: Result, live: LiveData | None) -> list[Section]:
    """The measures of a motion that can't be followed, for a page that may be brought to one that can."""
    if not (live and live["measures"] and result.failures and result.certificate is None):
        return []
    return [Section("measures", [untaken(result.run.compiled.quantities)])]


def title_block(document: Document, origin: Origin) -> list[Fact]:
    """Where the results come from, and what the file says of itself."""
    entries: dict[str, Text | None] = {
        "file": origin.file or Said("report.title_block.python"),
        "sha256": origin.short,
        "date": origin.minute,
        "author": document.author,
        "revision": document.revision,
        "version": origin.version,
    }
    return [{"name": Said(f"report.title_block.{key}"), "sentence": text} for key, text in entries.items() if text]


def axis(result: Result) -> Time:
    """What the drawing and the plots run over: the time, or in a sweep the drive's value."""
    run, quantities = result.run, result.run.compiled.quantities
    if isinstance(run, Sweep):
        unit, size = quantities.drive_unit(run.drive)
        return {"values": ((run.origin + result.t) / size).tolist(), "unit": unit, "label": run.drive}
    unit, size = quantities.unit_of(TIME)
    return {"values": (result.t / size).tolist(), "unit": unit, "label": Said("plot.time")}


def _problem(finding: Finding) -> Problem:
    severity = cast("Severity", finding.severity)
    return {"code": finding.code, "severity": severity, "what": finding.said("what"), "mend": finding.said("mend")}


def scene(result: Result) -> Scene:
    """The mechanism for the drawing: links, joints, and the paths of points that move."""
    compiled = result.run.compiled
    unit, size = compiled.quantities.unit_of(LENGTH)
    geometry = compiled.assembly.start.geometry if compiled.assembly.start else None
    assert geometry is not None
    moving = compiled.structure.topology.moving
    poses = dict(
        zip(moving, compiled.evaluate(compiled.graph.pose_rows, result.t).reshape(-1, 4, result.t.size), strict=True)
    )
    links: list[LinkData] = []
    outlines: Shapes = {}
    if compiled.mechanism.cams:
        from linkwright.report.cam_shapes import cam_shapes

        outlines = cam_shapes(compiled, size)
    for link_name, lines in joint_shapes(result, size, compiled.assembly.size()).items():
        outlines.setdefault(link_name, []).extend(lines)
    for name, entry in compiled.mechanism.links.items():
        points = {p: [c / size for c in geometry.point(name, p)] for p in entry.points}
        pose: Pose = {"x": [0.0], "y": [0.0], "c": [1.0], "s": [0.0]}
        if name != FRAME:
            x, y, c, s = poses[name]
            pose = {"x": listed(x / size), "y": listed(y / size), "c": listed(c), "s": listed(s)}
        link: LinkData = {"name": name, "fixed": name == FRAME, "points": points, "pose": pose}
        if name in outlines:
            link["outlines"] = outlines[name]
        links.append(link)
    return {
        "length_unit": unit,
        "time": axis(result)["values"],
        "links": links,
        "joints": _joints(result),
        "traces": _traces(result, size),
        "centrodes": centrodes(result, size),
        "springs": _springs(result),
        "driven": [[drive.link, drive.on] for drive in compiled.mechanism.drives.values() if drive.turns],
    }


def _joints(result: Result) -> list[JointData]:
    compiled = result.run.compiled
    assert compiled.assembly.start is not None
    geometry = compiled.assembly.start.geometry
    found: list[JointData] = []
    for pin in compiled.structure.topology.pins.values():
        first = pin.links[0]
        for link in pin.links[1:]:
            points = [pin.point(first), pin.point(link)]
            found.append({"name": pin.name, "kind": "revolute", "links": [first, link], "points": points})
    for name, joint in compiled.mechanism.prismatic_joints():
        assert joint.line is not None
        angles = [float(geometry.heading_angle(name, link)) for link in joint.links]
        points = [line.point for line in joint.line]
        joined: JointData = {"name": name, "kind": "prismatic", "links": list(joint.links), "points": points}
        joined["angles"] = angles
        if is_cylinder(compiled.structure.topology, name):
            joined["look"] = "cylinder"
        found.append(joined)
    return found


def _springs(result: Result) -> list[SpringData]:
    mechanism = result.run.compiled.mechanism
    drawn = ((one.name, one.kind.outline(mechanism, one.entry)) for one in mechanism.acting())
    return [{"name": name, **line._asdict()} for name, line in drawn if line]  # type: ignore[typeddict-item]


def _traces(result: Result, size: float) -> list[Trace]:
    found: list[Trace] = []
    for point in _moving_points(result):
        x, y = result[f"{point}.x"], result[f"{point}.y"]
        found.append({"name": point, "x": listed(x / size), "y": listed(y / size)})
    return found


def _moving_points(result: Result) -> list[str]:
    """The points that move, in the file's order; those that no file names, as the ends of rods, are left out."""
    compiled = result.run.compiled
    unnamed = ends_of(compiled.mechanism.cylinders)
    links_of_points = [p for p in compiled.quantities.signals.links_of_points if p not in unnamed]
    spans = {p: max(_span(result[f"{p}.x"]), _span(result[f"{p}.y"])) for p in links_of_points}
    largest = max(spans.values(), default=0.0)
    return [p for p, span in spans.items() if span > 1e-9 * largest]


def _span(values: Array) -> float:
    known = values[np.isfinite(values)]
    return float(np.ptp(known)) if known.size else 0.0


def plots(result: Result) -> list[Plot]:
    """Motion and force plots, those in which something happens; of a sweep, whose speed means nothing, places only."""
    compiled, sweep = result.run.compiled, isinstance(result.run, Sweep)
    m, links = compiled.mechanism, compiled.structure.topology.moving
    found: list[Plot | None] = []
    for point in _moving_points(result):
        for title, axes in _RATES[: 1 if sweep else None]:
            names = [f"{point}.{axes}{axis}" for axis in "xy"]
            found.append(_plot(result, Said(f"plot.{title}", name=point), "motion", names))
    for attribute in ("angle", "omega", "alpha")[: 1 if sweep else None]:
        names = [f"{link}.{attribute}" for link in links]
        found.append(_plot(result, Said(f"plot.{attribute}"), "motion", names))
    sliding = [name for name, joint in m.joints_but_pins() if joint.prismatic or "s" in joint.signals]
    found += [_plot(result, Said("plot.slide", name=n), "motion", [f"{n}.s"]) for n in sliding]
    if not sweep:
        found += _force_plots(result)
    return [plot for plot in found if plot is not None]


def link_title(name: str) -> Text:
    """A link in the title of a plot: the frame by what it is, others by their names."""
    return Term("frame-link") if name == FRAME else name


def _force_plots(result: Result) -> list[Plot | None]:
    m, signals = result.run.compiled.mechanism, result.run.compiled.quantities.signals
    found: list[Plot | None] = []
    for contact in signals.reactions:
        name = force_name(result, contact)
        title = Said("plot.force", a=link_title(contact.link), b=link_title(contact.on))
        found.append(_plot(result, title, "force", [f"{name}.x", f"{name}.y"]))
        if f"{name}.moment" in result.names:
            title = Said("plot.moment", a=link_title(contact.link), b=link_title(contact.on))
            found.append(_plot(result, title, "force", [f"{name}.moment"]))
    motors = result.run.compiled.graph.motors
    turning = [name for name in motors if m.drives[name].turns]
    sliding = [name for name in motors if name not in turning]
    found.append(_plot(result, Said("plot.torque"), "force", [f"{n}.torque" for n in turning]))
    found.append(_plot(result, Said("plot.effort"), "force", [f"{n}.force" for n in sliding]))
    found += _follower_charts(result)
    found += _charts(result)
    found.append(_plot(result, Said("plot.power"), "force", [f"{n}.power" for n in motors]))
    found.append(_plot(result, Said("plot.shaking"), "force", ["shaking.x", "shaking.y"]))
    found.append(_plot(result, Said("plot.shaking_moment"), "force", ["shaking.moment"]))
    return found


def _follower_charts(result: Result) -> list[Plot | None]:
    """The charts of followers, as the kinds have them: one of all signals that share a title and a dimension."""
    shown: dict[tuple[Said, Literal["motion", "force"], Dimension], list[str]] = {}
    for name, follower in result.run.compiled.mechanism.followers.items():
        for chart in follower.charts:
            title = Said(f"plot.{chart.title}", attribute=chart.attribute)
            key = (title, chart.group, follower.signals[chart.attribute])
            shown.setdefault(key, []).append(f"{name}.{chart.attribute}")
    return [_plot(result, title, group, names) for (title, group, _), names in shown.items()]


def _charts(result: Result) -> list[Plot | None]:
    """The charts of what acts, as the kinds have them: one of all elements that share a title."""
    acting = [*result.run.compiled.mechanism.acting()]
    used = {one.kind.name for one in acting}
    shown: dict[SignalChart, list[str]] = {c: [] for name in FORCES if name in used for c in FORCES[name].charts}
    for one in acting:
        for chart in one.kind.charts:
            if chart.attribute in one.kind.signals(one.entry):
                shown[chart].append(f"{one.name}.{chart.attribute}")
    return [_plot(result, Said(f"plot.{chart.title}"), chart.group, names) for chart, names in shown.items()]


def _plot(result: Result, title: Said, group: Literal["motion", "force"], names: Sequence[str]) -> Plot | None:
    """A plot of some signals of one unit; ``None`` where all of them stay zero."""
    shown = [(name, *result.shown(name)) for name in names]
    if not any(_largest(values) > 0 for _, values, _ in shown):
        return None
    series: list[Series] = [{"name": name, "values": listed(values)} for name, values, _ in shown]
    return {"title": title, "group": group, "unit": printed(shown[0][2]), "series": series}


def _largest(values: Array) -> float:
    """The largest magnitude, round-off beside whole numbers counted as zero."""
    top = float(np.nanmax(np.abs(values), initial=0.0))
    return top if top > 1e-12 else 0.0
