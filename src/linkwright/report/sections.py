"""The page's sections as HTML. Every text from outside passes through ``markup`` exactly once."""

from __future__ import annotations

from collections.abc import Sequence

from linkwright.escape import markup
from linkwright.findings import Text
from linkwright.presentation.blocks import Check, Checks, Measure, Measures, Section
from linkwright.report.data import Plot, Problem, ReportData, Severity
from linkwright.report.html_blocks import mark, of_file, sign_of, signed
from linkwright.report.prose import prose
from linkwright.words import say

GROUPS = ("motion", "force")
SEVERITIES: dict[str, Severity] = {"errors": "error", "warnings": "warning", "notes": "note"}
"""The parts of a page with problems, in their order, and the severity of each one's problems."""
KINDS_OF_MARK = {"errors": "bad", "warnings": "warning", "notes": "quiet"}
"""How what counts them is marked: only an error is a failure."""


def header(data: ReportData) -> str:
    """Title, subtitle and the state of affairs at a glance."""
    required = [m.verdict for m in measures(data) if m.verdict is not None]
    checks = [check.ok for check in checks_of(data)]
    badges = []
    for part, found in _by_severity(data).items():
        text = say(f"report.summary_{part}", count=len(found))
        badges.append(f'<a id="count-{part}" href="#{part}">{signed(KINDS_OF_MARK[part], text)}</a>')
    if required:
        text = say("report.summary_requirements", met=sum(required), total=len(required))
        badges.append(f'<span id="requirements">{mark(all(required), text)}</span>')
    if checks:
        text = say("report.summary_checks", ok=sum(checks), total=len(checks))
        (place,) = [part.name for part in verification(data)][:1]
        badges.append(f'<a href="#{place}">{mark(all(checks), text)}</a>')
    subtitle = f'<p class="subtitle">{prose(data["subtitle"])}</p>' if data["subtitle"] else ""
    source = f'<p class="source">{prose(data["source"])}</p>' if data["source"] else ""
    return (
        f"<header><h1>{markup(data['title'])}</h1>{subtitle}{source}"
        f"{_title_block(data)}"
        f'<p class="summary" id="state">{" ".join(badges)}</p>{_contents(data)}</header>'
    )


def _title_block(data: ReportData) -> str:
    """Where the results come from, in pairs."""
    pairs = "".join(
        f"<div><dt>{markup(entry['name'])}</dt><dd>{markup(entry['sentence'])}</dd></div>"
        for entry in data["title_block"]
    )
    return f'<dl class="title-block" aria-label="{markup(say("report.title_block"))}">{pairs}</dl>'


def results(data: ReportData) -> list[Section]:
    """What the studies show but for what verifies it; these come first on the page."""
    return [part for part in data["sections"] if not _verifies(part)]


def verification(data: ReportData) -> list[Section]:
    """The sections with checks."""
    return [part for part in data["sections"] if _verifies(part)]


def _verifies(part: Section) -> bool:
    return any(isinstance(block, Checks) for block in part.blocks)


def measures(data: ReportData) -> list[Measure]:
    """All measures of the page."""
    return [one for part in data["sections"] for b in part.blocks if isinstance(b, Measures) for one in b.measures]


def checks_of(data: ReportData) -> list[Check]:
    """All checks that verify what it shows."""
    return [one for part in data["sections"] for b in part.blocks if isinstance(b, Checks) for one in b.checks]


def _contents(data: ReportData) -> str:
    shown = [(part.name, part.shown) for part in results(data)]
    parts = [("mechanism", True), ("dimensions", bool(data.get("live"))), *shown]
    parts.append(("plots", bool(data.get("live") and data["plots"])))
    parts += [(group, any(plot["group"] == group for plot in data["plots"])) for group in GROUPS]
    parts += [(part.name, part.shown) for part in verification(data)]
    parts += [("structure", bool(data["structure"])), ("model", bool(data["model_text"]))]
    links = (f'<a href="#{name}">{markup(say(f"report.{name}"))}</a>' for name, here in parts if here)
    return f'<nav aria-label="{markup(say("report.contents"))}">{"".join(links)}</nav>'


def problems(data: ReportData) -> str:
    """A banner for each severity, with what is wrong and what mends it; nothing where all is well."""
    return "\n".join(_banner(part, found) for part, found in _by_severity(data).items())


def _by_severity(data: ReportData) -> dict[str, list[Problem]]:
    """The problems of each part, errors first; parts without any are left out."""
    found = {part: [p for p in data["problems"] if p["severity"] == of] for part, of in SEVERITIES.items()}
    return {part: problems for part, problems in found.items() if problems}


def _banner(part: str, found: Sequence[Problem]) -> str:
    rows = "".join(
        f"<li><p><code>{markup(f['code'])}</code> {_lines(f['what'])}</p>"
        + (f"<p><b>{markup(say('report.mend'))}</b> {_lines(f['mend'])}</p>" if f["mend"] else "")
        + "</li>"
        for f in found
    )
    return (
        f'<section id="{part}" class="banner {part}" aria-labelledby="{part}-title">'
        f'<h2 id="{part}-title">{sign_of(KINDS_OF_MARK[part])} {markup(say(f"report.{part}"))}</h2>{of_file()}'
        f"<ul>{rows}</ul></section>"
    )


def stage(still: str) -> str:
    """Places for the animated drawing (screen) and the one with ghost poses (paper), and the ``still`` one itself for
    pages whose scripts don't run."""
    caption = f"<figcaption>{markup(say('report.still'))}</figcaption>"
    return (
        f'<section id="mechanism"><h2>{markup(say("report.mechanism"))}</h2>'
        f'<div id="drawing" class="panel screen"></div>'
        f'<figure class="paper"><div id="still"></div>{caption}</figure>'
        f'<noscript><figure class="panel">{still}{caption}</figure></noscript></section>'
    )


def dimensions(data: ReportData) -> str:
    """The place of the numbers that can be moved; the script fills it. Where there are none a line says why."""
    if not data.get("live"):
        why = data.get("recorded")
        return f'<p id="recorded" class="hint screen">{prose(why)}</p>' if why else ""
    title = markup(say("report.dimensions"))
    return f'<section id="dimensions"><h2>{title}</h2><div id="numbers" class="panel"></div></section>'


def structure(data: ReportData) -> str:
    """Mobility, loops, groups: one sentence each."""
    if not data["structure"]:
        return ""
    rows = "".join(
        f"<div><dt>{markup(fact['name'])}</dt><dd>{_lines(fact['sentence'])}</dd></div>" for fact in data["structure"]
    )
    title = markup(say("report.structure"))
    return f'<section id="structure"><h2>{title}</h2>{of_file()}<dl>{rows}</dl></section>'


def plots(data: ReportData) -> str:
    """One figure per plot under its group's heading; the script fills them, and where none runs a sentence says so.
    Of a live report the first ones stand before all others, with a place for what a reader chooses."""
    absent = f"<noscript><p>{markup(say('report.no_script'))}</p></noscript>"
    hint = f'<p class="hint screen">{markup(say("report.plots_hint"))}</p>'
    first = list(data.get("first", ())) if data.get("live") else []
    out = ""
    if data.get("live") and data["plots"]:
        figures = "".join(_plot(i, data["plots"][i]) for i in first)
        out += (
            f'<section id="plots"><h2>{markup(say("report.plots"))}</h2><div id="plot-bar" class="screen"></div>{hint}'
            f'<div id="first-plots" class="plots">{figures}</div></section>'
        )
        hint = ""
    for group in GROUPS:
        every = [(i, plot) for i, plot in enumerate(data["plots"]) if plot["group"] == group]
        figures = "".join(_plot(i, plot) for i, plot in every if i not in first)
        if every:
            title = f"<h2>{markup(say(f'report.{group}'))}</h2>"
            place = f'<div class="plots" data-of="{group}">{figures}</div>'
            out += f'<section id="{group}">{title}{absent}{hint}{place}</section>'
            hint = ""
    whole = markup(say("report.whole_time"))
    return out and f'{out}<button type="button" id="whole" class="screen" hidden>{whole}</button>'


def _plot(index: int, plot: Plot) -> str:
    unit = f' <span class="unit">{markup(plot["unit"])}</span>' if plot["unit"] else ""
    return (
        f'<figure class="plot" data-plot="{index}" data-group="{plot["group"]}">'
        f"<figcaption>{markup(plot['title'])}{unit}</figcaption>"
        f'<div class="chart"></div><div class="legend lw"></div></figure>'
    )


def model(data: ReportData) -> str:
    """The model file as it was given."""
    if not data["model_text"]:
        return ""
    return (
        f'<section id="model"><h2>{markup(say("report.model"))}</h2>'
        f"<details><summary>{markup(say('report.model_show'))}</summary>"
        f"<pre>{markup(data['model_text'])}</pre></details></section>"
    )


def footer(data: ReportData) -> str:
    """Which version made the page; on paper the header alone says it, so that this has no page of its own."""
    made = say("report.made_with", version=data["version"])
    return f'<footer class="screen">{markup(made)}</footer>'


def _lines(text: Text) -> str:
    return prose(text).replace("\n", "<br>")
