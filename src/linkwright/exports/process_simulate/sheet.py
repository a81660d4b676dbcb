"""The sheet that goes with joint functions: one HTML page that shows which text goes to which joint of the tool, and
what the linkage does over its driving range."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from importlib.resources import files

import numpy as np
from numpy.typing import NDArray

from linkwright import _version
from linkwright.drawing.chart_html import figures
from linkwright.drawing.charts import Axes, points
from linkwright.drawing.plane import PicturePlane
from linkwright.escape import markup
from linkwright.exports.process_simulate.facts import HingeFacts
from linkwright.exports.process_simulate.functions import JointFunction, JointFunctions
from linkwright.exports.process_simulate.sheet_drawing import anchors, linkage, places
from linkwright.findings import SENTENCES, Joined, Said
from linkwright.kernels import Compiled
from linkwright.presentation.blocks import Chart
from linkwright.presentation.html_file import html_file
from linkwright.presentation.scripts import built
from linkwright.report.prose import prose
from linkwright.words import say

Array = NDArray[np.float64]

FAR = 0.5
"""How far from what is drawn an instant centre still is, over its size."""
_UNITS = {"T": "rad", "D": "mm"}


def sheet(compiled: Compiled, functions: JointFunctions, facts: HingeFacts) -> str:
    """The whole sheet as the text of an HTML file (UTF-8)."""
    title = Said("sheet.title", name=compiled.mechanism.title)
    style = files(__package__).joinpath("sheet.css").read_text("utf-8")
    body = partial(_body, title, compiled, functions, facts)
    return html_file(title, body, scripts=[built(__package__, "sheet.js")], style=style, kind="sheet")


def _body(title: Said, compiled: Compiled, functions: JointFunctions, facts: HingeFacts) -> str:
    subtitle = say(
        "sheet.subtitle",
        dialect=functions.dialect,
        decimals=functions.decimals,
        drive=functions.driving.name,
        range=_limits(functions.driving, facts),
        error=_error(functions.max_error, " / ".join(dict.fromkeys(_UNITS[f.kind] for f in functions.functions))),
    )
    return f"""<header><h1>{markup(title)}</h1><p class="subtitle">{prose(subtitle)}</p></header>
<main>
<section id="linkage"><div class="two">{_linkage(compiled, functions, facts)}{_plane(compiled, facts)}</div></section>
<section id="joints"><h2>{markup(say("sheet.functions"))}</h2>{_table(compiled, functions, facts)}</section>
<section id="facts"><h2>{markup(say("sheet.facts"))}</h2>{_facts(compiled, functions, facts)}
<div class="three">{figures(_charts(functions, facts))}</div></section>
</main>
<footer>{markup(say("sheet.footer", version=_version.__version__))}</footer>"""


def _number_text(value: float) -> str:
    return f"{value + 0.0:.5g}".replace("-", "−")


def _places(place: Sequence[float] | Array, whole: float) -> str:
    """Coordinates as text, without what is round-off in a linkage of the size ``whole``."""
    return ", ".join(_number_text(round(float(part) / whole, 10) * whole) for part in place)


def _error(value: float, unit: str) -> str:
    return f"{value:.1e} {unit}".replace("e-0", "e-").strip()


def _linkage(compiled: Compiled, functions: JointFunctions, facts: HingeFacts) -> str:
    """The drawing with its key."""
    labels: dict[str, list[str]] = {}
    for function in (functions.driving, *(f for f in functions.functions if not f.helper)):
        labels.setdefault(_anchor(compiled, function), []).append(function.name)
    title, ends = say("sheet.drawing.title"), (facts.zero, facts.zero + float(facts.value[facts.far]))
    drawn = linkage(compiled, facts.drive, ends, functions.driving.child, labels, title)
    links = "".join(f"<li>{i} {markup(name)}</li>" for i, name in enumerate(compiled.mechanism.links, start=1))
    there = functions.motion.of_drive(np.array([functions.zero + facts.value[facts.far]]))
    far = _value(float(there[0]), functions.driving, facts)
    notes = [say("sheet.drawing.note", drive=functions.driving.name, far=far)]
    if compiled.plane is None:
        notes.append(say("sheet.axis.flat"))
    else:
        notes.append(say("sheet.axis", normal=", ".join(_number_text(part) for part in compiled.plane.normal)))
    note = f'<p class="note">{prose(Joined(notes, SENTENCES))}</p>'
    return f"<figure><figcaption>{markup(say('sheet.drawing'))}</figcaption>{drawn}<ol>{links}</ol>{note}</figure>"


def _anchor(compiled: Compiled, function: JointFunction) -> str:
    """The pin or slide of a joint; where a pin holds more than two links the joint is called after its child too."""
    known = anchors(compiled)
    return function.joint if function.joint in known else function.joint.removesuffix(f"_{function.child}")


def _table(compiled: Compiled, functions: JointFunctions, facts: HingeFacts) -> str:
    """A row of each joint, and below it the text to paste."""
    unit, size = facts.units["length"]
    whole = compiled.assembly.size() / size
    joints = (functions.driving, *functions.functions)
    spots = anchors(compiled)
    at = places(compiled, facts.drive, spots.values(), (facts.zero,))[0]
    heads = [say(f"sheet.column.{head}", unit=unit) for head in ("joint", "links", "place", "limits", "error")]
    rows = []
    for joint in joints:
        name, where = f'<td class="name-cell">{markup(joint.name)}', ""
        if joint.helper:
            links = say("sheet.helper")
        else:
            place = at[spots[_anchor(compiled, joint)]]
            where = _places((place if compiled.plane is None else compiled.plane.place(*place)) / size, whole)
            where = _note("sheet.mirrored") if joint.mirrored else where
            links = f"{joint.parent} / {joint.child}"
            if joint.name != joint.joint:
                name += f'<span class="note">{markup(say("sheet.model", joint=joint.joint))}</span>'
        off = _error(joint.error, _UNITS[joint.kind]) if joint.text and not joint.helper else "–"
        flipped = _note("sheet.flipped") if joint.sign < 0 else ""
        values = (f"{markup(links)}{flipped}", where, _limits(joint, facts), off)
        kinds = ("", ' class="figure"', ' class="figure"', ' class="figure"')
        shown = zip(kinds, heads[1:], values, strict=True)
        cells = [f"{name}</td>", *(f'<td{kind} data-head="{markup(head)}">{text}</td>' for kind, head, text in shown)]
        text = (
            f'<div class="paste"><code>{markup(joint.text)}</code><button class="copy" type="button" hidden '
            f'data-done="{markup(say("sheet.copied"))}">{markup(say("sheet.copy"))}</button></div>'
            if joint.text
            else _note("sheet.driving")
        )
        rows.append(
            f'<tr class="first">{"".join(cells)}</tr><tr class="text"><td colspan="{len(heads)}">{text}</td></tr>'
        )
    head = "".join(f"<th>{markup(text)}</th>" for text in heads)
    return f"<table><thead><tr>{head}</tr></thead><tbody>{''.join(rows)}</tbody></table>"


def _limits(joint: JointFunction, facts: HingeFacts) -> str:
    """A joint's limits."""
    low, high = (_value(limit, joint, facts) for limit in joint.limits)
    return f"{low.split()[0]} … {high}"


def _value(value: float, joint: JointFunction, facts: HingeFacts) -> str:
    """A joint's value (rad or mm) in the file's unit of angles, of a slide in mm; that of a helper is only a number."""
    unit, size = ("", 1.0) if joint.helper else facts.units["angle"] if joint.kind == "T" else ("mm", 1.0)
    return f"{round(value / size, 3) + 0.0:.3f} {unit}".replace("-", "−").strip()


def _note(key: str) -> str:
    return f'<span class="note">{markup(say(key))}</span>'


def _joint_values(functions: JointFunctions, facts: HingeFacts, values: Array) -> tuple[Array, str]:
    """What the driving joint has at values of the drive since the zero pose, as the table of joints counts it, with its
    unit."""
    unit, size = facts.units["angle"] if functions.driving.kind == "T" else ("mm", 1.0)
    return functions.motion.of_drive(functions.zero + values) / size, unit


def _facts(compiled: Compiled, functions: JointFunctions, facts: HingeFacts) -> str:
    """The facts as a list."""
    whole = compiled.assembly.size() / facts.units["length"][1]
    told = facts.as_dict()
    opening, pole, step = told["opening"], told["pole"], facts.units["drive"][1]
    rows = [(say("sheet.opening", link=facts.panel), _range("sheet.opening.text", opening))]
    for least in told["transmission"]:
        key = "sheet.transmission.still" if least["at"] is None else "sheet.transmission.text"
        there, drive_unit = _joint_values(functions, facts, np.array([(least["at"] or 0.0) * step]))
        at = "" if least["at"] is None else _number_text(round(float(there[0]), 9))
        data = {"angle": _number_text(least["least"]), "unit": least["unit"], "group": least["group"], "at": at}
        rows.append((say("sheet.transmission"), say(key, drive=functions.driving.name, drive_unit=drive_unit, **data)))
    if any(value is not None for end in pole["ends"] for value in end):
        start, stop = (say("sheet.pole.far") if None in end else _places(end, whole) for end in pole["ends"])
        if abs(facts.value[0]) > abs(facts.value[-1]):
            start, stop = stop, start
        rows.append(
            (say("sheet.pole", link=facts.panel), say("sheet.pole.text", start=start, stop=stop, unit=pole["unit"]))
        )
    if "hand" in told and told["hand"]["min"] is not None:
        rows.append((say("sheet.hand", point=facts.handle), _range("sheet.hand.text", told["hand"])))
    for name, force in told["springs"].items():
        if force["min"] is not None:
            rows.append((say("sheet.spring", name=name), _range("sheet.spring.text", force)))
    if "swept" in told:
        x0, y0, x1, y1 = (_number_text(edge) for edge in told["swept"]["bounds"])
        data = {"area": f"{told['swept']['area']:.6g}", "unit": told["swept"]["unit"]}
        rows.append((say("sheet.swept"), say("sheet.swept.text", x0=x0, x1=x1, y0=y0, y1=y1, **data)))
    cells = "".join(f"<div><dt>{markup(name)}</dt><dd>{prose(text)}</dd></div>" for name, text in rows)
    return f'<dl class="facts">{cells}</dl>'


def _range(key: str, told: dict[str, float | str]) -> str:
    low, high = (_number_text(float(told[end])) for end in ("min", "max"))
    return say(key, low=low, high=high, unit=told["unit"])


def _charts(functions: JointFunctions, facts: HingeFacts) -> list[Chart]:
    """Opening over the driving joint; forces over the opening."""
    (angle_unit, angle), (force_unit, force) = facts.units["angle"], facts.units["force"]
    (value, drive_unit), opening = _joint_values(functions, facts, facts.value), facts.opening / angle
    made: list[Chart] = []

    def chart(title: str, label: str, x: Array, rows: Sequence[Array]) -> None:
        known = np.concatenate([row[np.isfinite(row)] for row in rows])
        if known.size and np.isfinite(x).all():
            axes = Axes((float(x.min()), float(x.max())), (float(known.min()), float(known.max())), label)
            zero = np.array([x.min(), x.max()])
            shapes = [axes.line(zero, 0 * zero, "shift")] if known.min() < 0 < known.max() else []
            shapes += [axes.line(x, row, f"mean s{i % 3}") for i, row in enumerate(rows)]
            made.append(Chart(title, partial(axes.drawing, shapes, title)))

    title = say("sheet.chart.opening", link=facts.panel, unit=angle_unit)
    chart(title, say("sheet.chart.drive", drive=functions.driving.name, unit=drive_unit), value, [opening])
    over = say("sheet.chart.over", link=facts.panel, unit=angle_unit)
    if facts.hand is not None:
        title = say("sheet.chart.hand", point=facts.handle, unit=force_unit)
        chart(title, over, opening, [facts.hand / force])
    if facts.springs:
        title = say("sheet.chart.springs", names=Joined(facts.springs), unit=force_unit)
        chart(title, over, opening, [row / force for row in facts.springs.values()])
    return made


def _plane(compiled: Compiled, facts: HingeFacts) -> str:
    """The picture of what the panel sweeps, with the path of its instant centre."""
    unit, size = facts.units["length"]
    named = places(compiled, facts.drive, anchors(compiled).values(), (facts.zero,))[0]
    pins = np.array([*named.values()]).T / size
    shown = pins
    if facts.swept is not None:
        x0, y0, x1, y1 = (edge / size for edge in facts.swept.bounds)
        shown = np.concatenate([pins, [[x0, x1], [y0, y1]]], axis=1)
    pole = facts.pole / size
    low, high = shown.min(axis=1), shown.max(axis=1)
    reach = (high - low).max() * FAR + 1e-12
    with np.errstate(invalid="ignore"):
        near = ((pole >= low[:, None] - reach) & (pole <= high[:, None] + reach)).all(axis=0)
    pole = np.where(near, pole, np.nan)
    if facts.swept is None and (near.sum() < 2 or np.ptp(pole[:, near], axis=1).max() < 1e-6 * reach):
        return ""
    every = np.concatenate([shown, pole[:, near]], axis=1)
    plane = PicturePlane((*every.min(axis=1).tolist(), *every.max(axis=1).tolist()), unit)
    shapes = []
    if facts.swept is not None:
        drawn = facts.swept.simplify(0.1 / plane.scale * size)
        parts = getattr(drawn, "geoms", [drawn])
        rings = [ring for part in parts for ring in (part.exterior, *part.interiors)]
        path = "".join(f"M{points(*plane.to_picture(*(np.array(ring.coords).T / size)))}Z" for ring in rings)
        shapes.append(f'<path class="area" d="{path}"/>')
    for look, corners in (("end", facts.outline_end), ("outline", facts.outline)):
        if corners is not None:
            shapes.append(f'<polygon class="{look}" points="{points(*plane.to_picture(*(corners / size)))}"/>')
    breaks = np.flatnonzero(~near)
    for run in np.split(np.arange(near.size), breaks):
        run = run[near[run]]
        if run.size > 1:
            shapes.append(f'<polyline class="pole" points="{points(*plane.to_picture(*pole[:, run]))}"/>')
    for name, x, y in zip(named, *plane.to_picture(*pins), strict=True):
        shapes.append(f'<circle class="pivot" cx="{x:.1f}" cy="{y:.1f}" r="2"/>')
        shapes.append(f'<text class="point" x="{x + 4:.1f}" y="{y - 4:.1f}">{markup(name)}</text>')
    title = say(f"sheet.chart.{'pole' if facts.swept is None else 'swept'}", link=facts.panel)
    picture = (
        f'<svg class="lw still swept" viewBox="0 0 {plane.right + 12:.0f} {plane.bottom + 36:.0f}" role="img" '
        f'aria-label="{markup(title)}">{plane.grid()}{"".join(shapes)}</svg>'
    )
    return f"<figure><figcaption>{markup(title)}</figcaption>{picture}</figure>"
