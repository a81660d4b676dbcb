"""The report as one HTML file that needs nothing else: styles, scripts and data stand in it."""

from __future__ import annotations

import re
from importlib.resources import files

from linkwright.model.escape import markup
from linkwright.report import sections
from linkwright.report.data import ReportData
from linkwright.report.payload import script_json

# The browser itself is told to load nothing, so that the file stays self-contained whatever is put into it.
POLICY = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data:"

SCRIPT_WORDS = (
    "report.areas",
    "report.centrodes",
    "report.copied",
    "report.drawing",
    "report.link_names",
    "report.not_assembled",
    "report.paths",
    "report.pause",
    "report.play",
    "report.point_names",
    "report.real_time",
    "report.speed",
)
"""The keys that the page's scripts read."""


def page(data: ReportData) -> str:
    """The whole report as the text of an HTML file (UTF-8)."""
    style = f"{_asset('uplot.min.css')}\n{_asset('report.css')}"
    payload = script_json(
        {
            "words": {key: data["words"][key] for key in SCRIPT_WORDS},
            "time": data["time"],
            "scene": data["scene"],
            "plots": data["plots"],
        }
    )
    body = "\n".join(
        [
            sections.header(data),
            sections.failures(data),
            sections.notes(data),
            "<main>",
            sections.stage(data),
            '<div class="results">',
            sections.measures(data),
            sections.certificate(data),
            sections.limits(data),
            sections.reactions(data),
            sections.sweep(data),
            sections.accuracy(data),
            sections.workspace(data),
            sections.cam(data),
            sections.plots(data),
            sections.modes(data),
            sections.structure(data),
            sections.model(data),
            "</div>",
            "</main>",
            sections.footer(data),
        ]
    )
    return f"""<!DOCTYPE html>
<html lang="{markup(data["language"])}">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{POLICY}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta name="generator" content="linkwright {markup(data["version"])}">
<link rel="icon" href="data:,">
<title>{markup(data["title"])}</title>
<style>
{style}
</style>
</head>
<body>
{body}
<script type="application/json" id="data">{payload}</script>
<script>
/*! uPlot
{_asset("LICENSE.uplot.txt").strip()}
*/
{_asset("uplot.iife.min.js")}
</script>
<script type="module">
const mechanism = (() => {{
{_inlined(_asset("mechanism.js"))}
return {{ render, still }};
}})();
{_asset("report.js")}
{_asset("stacks.js")}
</script>
</body>
</html>
"""


def _asset(name: str) -> str:
    return files(__package__).joinpath("assets", name).read_text("utf-8")


def _inlined(module: str) -> str:
    """A module's source as the inside of a function: a page opened from disk may not import files."""
    without_default = re.sub(r"^export default .*$", "", module, flags=re.MULTILINE)
    return re.sub(r"^export (?=function|const)", "", without_default, flags=re.MULTILINE)
