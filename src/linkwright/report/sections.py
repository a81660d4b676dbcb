"""The page's sections as HTML. Every text from outside passes through ``markup`` exactly once."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from linkwright.escape import markup
from linkwright.expressions.units import printed
from linkwright.report.accuracy_page import section as accuracy_section
from linkwright.report.cam import section as cam_section
from linkwright.report.data import Check, Failure, Grid, Measure, Plot, ReportData
from linkwright.report.modes import section
from linkwright.report.sweep import section as sweep_section
from linkwright.report.workspace import section as workspace_section

GROUPS = ("motion", "force")
WIDE = 7
"""Tables of more columns are set narrower."""


def header(data: ReportData) -> str:
    """Title, subtitle and the state of affairs at a glance."""
    words = data["words"]
    required = [m["verdict"] for m in data["measures"] if m["verdict"] is not None]
    checks = [check["ok"] for check in data["certificate"]]
    badges = []
    if data["failures"]:
        badges.append(_mark(False, words["report.summary_failures"].format(count=len(data["failures"]))))
    if required:
        text = words["report.summary_requirements"].format(met=sum(required), total=len(required))
        badges.append(_mark(all(required), text))
    if checks:
        text = words["report.summary_checks"].format(ok=sum(checks), total=len(checks))
        badges.append(_mark(all(checks), text))
    subtitle = f'<p class="subtitle">{markup(data["subtitle"])}</p>' if data["subtitle"] else ""
    source = f'<p class="source">{markup(data["source"])}</p>' if data["source"] else ""
    return (
        f"<header><h1>{markup(data['title'])}</h1>{subtitle}{source}"
        f'<p class="origin">{markup(data["origin"])}</p>'
        f'<p class="summary">{" ".join(badges)}</p>{_contents(data)}</header>'
    )


def _contents(data: ReportData) -> str:
    parts = [("mechanism", True), ("measures", bool(data["measures"]))]
    parts += [("certificate", bool(data["certificate"])), ("limits", bool(data.get("limits")))]
    parts += [("reactions", bool(data.get("reactions")))]
    parts += [("sweep", "sweep" in data), ("accuracy", "accuracy" in data), ("workspace", "workspace" in data)]
    parts += [("cam", "cam" in data)]
    parts += [(group, any(plot["group"] == group for plot in data["plots"])) for group in GROUPS]
    parts += [("modes", "modes" in data), ("structure", bool(data["structure"])), ("model", bool(data["model_text"]))]
    words = data["words"]
    links = (f'<a href="#{name}">{markup(words[f"report.{name}"])}</a>' for name, here in parts if here)
    return f'<nav aria-label="{markup(words["report.contents"])}">{"".join(links)}</nav>'


def failures(data: ReportData) -> str:
    """A banner with what went wrong and what mends it; nothing where all is well."""
    sign = '<span aria-hidden="true">⚠\ufe0e</span> '
    return _findings(data, "failures", data["failures"], "banner", sign)


def notes(data: ReportData) -> str:
    """The same of notes: nothing is wrong, but it may not be meant."""
    return _findings(data, "notes", data.get("notes", ()), "banner notes", "")


def _findings(data: ReportData, name: str, found: Sequence[Failure], kind: str, sign: str) -> str:
    if not found:
        return ""
    words = data["words"]
    rows = "".join(
        f"<li><p><code>{markup(f['code'])}</code> {_lines(f['what'])}</p>"
        + (f"<p><b>{markup(words['report.mend'])}:</b> {_lines(f['mend'])}</p>" if f["mend"] else "")
        + "</li>"
        for f in found
    )
    return (
        f'<section id="{name}" class="{kind}" aria-labelledby="{name}-title">'
        f'<h2 id="{name}-title">{sign}{markup(words[f"report.{name}"])}</h2>'
        f"<ul>{rows}</ul></section>"
    )


def stage(data: ReportData) -> str:
    """Places for the animated drawing (screen) and the one with ghost poses (paper)."""
    words = data["words"]
    return (
        f'<section id="mechanism"><h2>{markup(words["report.mechanism"])}</h2>'
        f'<div id="drawing" class="panel screen"></div>'
        f'<figure class="paper"><div id="still"></div>'
        f"<figcaption>{markup(words['report.still'])}</figcaption></figure>"
        f"<noscript><p>{markup(words['report.no_script'])}</p></noscript></section>"
    )


def measures(data: ReportData) -> str:
    """Measures with value, unit, where it happens, requirement and verdict."""
    heads = ("measure", "value", "where", "requirement", "verdict")
    return _table(data, "measures", heads, (_measure(measure, data) for measure in data["measures"]))


def _measure(measure: Measure, data: ReportData) -> Sequence[str]:
    verdict = measure["verdict"]
    words = data["words"]
    unit = f'<span class="unit">{_unit(measure["unit"])}</span>'
    values = "".join(
        f'<span class="line"><span class="end">{markup(entry["label"])}</span> '
        f"<b>{markup(entry['text']) or _number(entry['value'])}</b> {unit}</span>"
        for entry in measure["values"]
    )
    where = "".join(f'<span class="line">{markup(entry["at"])}</span>' for entry in measure["values"])
    text = f'<span class="note">{markup(measure["text"])}</span>' if measure["text"] else ""
    judged = "–" if verdict is None else _mark(verdict, words["report.pass" if verdict else "report.fail"])
    requirement = markup(measure["requirement"]) if measure["requirement"] else "–"
    for grade in dict.fromkeys(entry["grade"] for entry in measure["values"]):
        text += f'<span class="note">{markup(grade)}</span>'
    return (f"<b>{markup(measure['name'])}</b>{text}", values, where, requirement, judged)


def certificate(data: ReportData) -> str:
    """What proves the figures, line by line."""
    rows = (_check(check, data) for check in data["certificate"])
    after = "".join(f'<p class="note">{markup(remark)}</p>' for remark in data["remarks"])
    return _table(data, "certificate", ("check", "figure", "meaning", "verdict"), rows, after)


def _check(check: Check, data: ReportData) -> Sequence[str]:
    word = data["words"]["report.holds" if check["ok"] else "report.violated"]
    figure = f'<span class="figure">{markup(check["figure"])}</span>'
    return (f"<b>{markup(check['name'])}</b>", figure, markup(check["sentence"]), _mark(check["ok"], word))


def limits(data: ReportData) -> str:
    """The tables of the limits study."""
    return _grids(data, "limits", data.get("limits", []))


def reactions(data: ReportData) -> str:
    """The tables of a structure's reactions."""
    return _grids(data, "reactions", data.get("reactions", []))


def _grids(data: ReportData, name: str, grids: Iterable[Grid]) -> str:
    """A section of tables alone."""
    tables = "".join(map(_grid, grids))
    title = markup(data["words"][f"report.{name}"]) if tables else ""
    return tables and f'<section id="{name}"><h2>{title}</h2>{tables}</section>'


def _grid(grid: Grid) -> str:
    heads = "".join(f'<th scope="col">{markup(head)}</th>' for head in grid["heads"])
    rows = "".join(
        "<tr>"
        + "".join(
            f'<td data-head="{markup(head)}">{_lines(cell)}</td>' for head, cell in zip(grid["heads"], row, strict=True)
        )
        + "</tr>"
        for row in grid["rows"]
    )
    title = f"<h3>{markup(grid['title'])}</h3>"
    wide = " wide" if len(grid["heads"]) > WIDE else ""
    return f'{title}<table class="limits{wide}"><thead><tr>{heads}</tr></thead><tbody>{rows}</tbody></table>'


def sweep(data: ReportData) -> str:
    """The tables and charts of a sweep."""
    if "sweep" not in data:
        return ""
    return sweep_section(data["sweep"], data["words"]["report.sweep"], "".join(map(_grid, data["sweep"]["tables"])))


def accuracy(data: ReportData) -> str:
    """Worst case, statistics and contributors of each output."""
    if "accuracy" not in data:
        return ""
    return accuracy_section(data["accuracy"], data["words"]["report.accuracy"], _grid)


def cam(data: ReportData) -> str:
    """The pictures, charts and tables of a cam."""
    if "cam" not in data:
        return ""
    return cam_section(data["cam"], data["words"]["report.cam"], "".join(map(_grid, data["cam"]["tables"])))


def workspace(data: ReportData) -> str:
    """The pictures and tables of workspaces."""
    if "workspace" not in data:
        return ""
    found = data["workspace"]
    return workspace_section(found, data["words"]["report.workspace"], "".join(map(_grid, found["tables"])))


def structure(data: ReportData) -> str:
    """Mobility, loops, groups: one sentence each."""
    if not data["structure"]:
        return ""
    rows = "".join(
        f"<div><dt>{markup(fact['name'])}</dt><dd>{_lines(fact['sentence'])}</dd></div>" for fact in data["structure"]
    )
    title = markup(data["words"]["report.structure"])
    return f'<section id="structure"><h2>{title}</h2><dl>{rows}</dl></section>'


def modes(data: ReportData) -> str:
    """Assembly modes and circuits, where the file asks for them."""
    return section(data["modes"], data["words"]) if "modes" in data else ""


def plots(data: ReportData) -> str:
    """One figure per plot under its group's heading; the script fills them."""
    words = data["words"]
    hint = f'<p class="hint screen">{markup(words["report.plots_hint"])}</p>'
    out = ""
    for group in GROUPS:
        figures = "".join(_plot(i, plot) for i, plot in enumerate(data["plots"]) if plot["group"] == group)
        if figures:
            title = f"<h2>{markup(words[f'report.{group}'])}</h2>"
            out += f'<section id="{group}">{title}{hint}<div class="plots">{figures}</div></section>'
            hint = ""
    whole = markup(words["report.whole_time"])
    return out and f'{out}<button type="button" id="whole" class="screen" hidden>{whole}</button>'


def _plot(index: int, plot: Plot) -> str:
    unit = f' <span class="unit">{_unit(plot["unit"])}</span>' if plot["unit"] else ""
    return (
        f'<figure class="plot" data-plot="{index}">'
        f"<figcaption>{markup(plot['title'])}{unit}</figcaption>"
        f'<div class="chart"></div><div class="legend lw"></div></figure>'
    )


def model(data: ReportData) -> str:
    """The model file as it was given."""
    if not data["model_text"]:
        return ""
    words = data["words"]
    return (
        f'<section id="model"><h2>{markup(words["report.model"])}</h2>'
        f"<details><summary>{markup(words['report.model_show'])}</summary>"
        f"<pre>{markup(data['model_text'])}</pre></details></section>"
    )


def footer(data: ReportData) -> str:
    """Which version made the page."""
    made = data["words"]["report.made_with"].format(version=data["version"])
    return f"<footer>{markup(made)}</footer>"


def _table(data: ReportData, name: str, heads: Sequence[str], rows: Iterable[Sequence[str]], after: str = "") -> str:
    titles = [markup(data["words"][f"report.{head}"]) for head in heads]
    body = "".join(
        "<tr>"
        + "".join(f'<td data-head="{title}">{cell}</td>' for title, cell in zip(titles, row, strict=True))
        + "</tr>"
        for row in rows
    )
    if not body:
        return ""
    head = "".join(f'<th scope="col">{title}</th>' for title in titles)
    return (
        f'<section id="{name}"><h2>{markup(data["words"][f"report.{name}"])}</h2>'
        f'<table class="{name}"><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>{after}</section>'
    )


def _mark(ok: bool, text: str) -> str:
    """A verdict that reads without colour: a sign and a word."""
    sign, kind = ("✓", "ok") if ok else ("✗", "bad")
    return f'<span class="mark {kind}"><span aria-hidden="true">{sign}</span> {markup(text)}</span>'


def _number(value: float | None) -> str:
    return "–" if value is None else f"{value:.6g}".replace("-", "−")


def _unit(unit: str) -> str:
    return markup(printed(unit))


def _lines(text: str) -> str:
    return markup(text).replace("\n", "<br>")
