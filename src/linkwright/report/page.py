"""The report as one HTML file that needs nothing else: styles, scripts and data stand in it."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from linkwright.drawing.charts import named
from linkwright.findings import Said, Term, Text
from linkwright.presentation.blocks import Chart, Charts
from linkwright.presentation.chart_data import pooled
from linkwright.presentation.html_file import asset, html_file
from linkwright.presentation.payload import Exact
from linkwright.presentation.scripts import built
from linkwright.report import sections
from linkwright.report.data import LiveNumber, ReportData
from linkwright.report.html_blocks import section
from linkwright.report.mechanism_drawing import drawing
from linkwright.report.packed import packed, packed_live, without_series, without_values
from linkwright.report.signal_list import KINDS
from linkwright.words import say

LIVE_WORDS = (
    "back",
    "balances",
    "cams",
    "changed",
    "closes",
    "copy",
    "drag",
    "failed_drive",
    "failed_group",
    "failed_higher",
    "failed_number",
    "failed_parameter",
    "hold",
    "move",
    "no_number",
    "not_computed",
    "original",
    "others",
    "out_of_reach",
    "out_of_reach_end",
    "out_of_reach_locked",
    "requirements",
    "reset",
    "reset_one",
    "sampled",
    "shape",
    "undo",
    "unsound",
    "within_tolerances",
)
PLOT_WORDS = (
    "axis",
    "components",
    "default",
    "export",
    "magnitude",
    "no_match",
    "overlay",
    "polar",
    "remove",
    "remove_signal",
    "search",
    "view",
)
PLACES = {
    name: f"{{{name}}}" for name in ("change", "error", "met", "name", "off", "time", "total", "unit", "value", "what")
}
"""The places of the scripts' texts, which the scripts fill."""
SCRIPT_WORDS = (
    "report.areas",
    "report.areas_of_file",
    "report.arrow_acceleration",
    "report.arrow_length",
    "report.arrow_load",
    "report.arrow_moment",
    "report.arrow_radius",
    "report.arrow_reaction",
    "report.arrow_velocity",
    "report.arrow_weight",
    "report.centrodes",
    "report.choose_all",
    "report.choose_none",
    "report.copied",
    "report.dimension_lines",
    "report.drawing",
    "report.drawing_keys",
    "report.fail",
    "report.find_name",
    "report.fit",
    "report.fit_all",
    "report.full_screen",
    "report.hover_magnitude",
    "report.hover_moment",
    "report.hover_reaction",
    "report.hover_speed",
    "report.link_names",
    *(f"report.live.{key}" for key in LIVE_WORDS),
    "report.not_assembled",
    "report.pass",
    "report.paths",
    "report.pause",
    "report.play",
    *(f"report.plots.{key}" for key in PLOT_WORDS),
    "report.point_names",
    "report.real_time",
    "report.show",
    "report.speed",
    "report.view",
    "report.zoom_in",
    "report.zoom_out",
)
"""The keys that the page's scripts read."""
STUDY_WORDS = tuple(f"report.plots.{key}" for key in ("contour", "family", "reset_zoom"))
"""The same of a page with charts of studies."""
ALSO_CALLED = tuple(
    f"plot.{kind}"
    for kind in [
        "acceleration",
        "alpha",
        "angle",
        "effort",
        "force",
        "moment",
        "omega",
        "position",
        "slide",
        "torque",
        "velocity",
    ]
)
"""The titles of plots of which there are other words, by which their signals are looked for."""


def page(data: ReportData) -> str:
    """The whole report as the text of an HTML file (UTF-8)."""
    blocks: dict[str, object] = {"data": {"time": data["time"], "scene": data["scene"], "plots": data["plots"]}}
    if charts := _charts(data):
        blocks["charts"] = Exact(pooled({key: chart.data.plain for key, chart in charts.items()}))
    script = "report_studies.js" if charts else "report.js"
    scripts = [f"/*! uPlot\n{asset(__package__, 'LICENSE.uplot.txt').strip()}\n*/\n{_built(script)}"]
    if live := data.get("live"):
        blocks["data"] = {
            "time": {**data["time"], "values": []},
            "scene": without_values(data["scene"]),
            "plots": without_series(data["plots"]),
            "first": data.get("first", ()),
            "live": True,
        }
        blocks["live"] = Exact(packed_live(live))
        scripts.insert(0, f"globalThis.linkwrightPrograms={live['code']}")
    sheets = ["mechanism.css", *(["studies.css"] if charts else [])]
    return html_file(
        data["title"],
        partial(_body, data, drawing(data["scene"])),  # drawn once: where no script runs, no language is chosen
        data=blocks,
        scripts=scripts,
        words=partial(_words, data),
        before=_built("uplot.min.css") + "\n",
        style="\n".join(["", _built("lw.css"), *map(partial(asset, __package__), sheets)]),
    )


def _body(data: ReportData, still: str) -> str:
    return "\n".join(
        [
            sections.header(data),
            sections.problems(data),
            "<main>",
            sections.stage(still),
            '<div class="results">',
            sections.dimensions(data),
            *map(section, sections.results(data)),
            sections.plots(data),
            *map(section, sections.verification(data)),
            sections.structure(data),
            sections.model(data),
            "</div>",
            "</main>",
            sections.footer(data),
        ]
    )


def _charts(data: ReportData) -> dict[str, Chart]:
    """The charts that the page's script draws, by their keys."""
    blocks = (block for part in data["sections"] for block in part.blocks if isinstance(block, Charts))
    return {chart.key: chart for block in blocks for chart in block.charts if chart.content is not None}


def _words(data: ReportData) -> dict[str, object]:
    """The words that the page's scripts read: texts by their keys, and what they show of the data in words."""
    live, charts = data.get("live"), _charts(data)
    return {
        "texts": {key: say(key, **PLACES) for key in (*SCRIPT_WORDS, *(STUDY_WORDS if charts else ()))},
        "time": str(data["time"]["label"]),
        "axis": str(named(data["time"]["label"], data["time"]["unit"])),
        "titles": [str(plot["title"]) for plot in data["plots"]],
        "also": [_also(plot["title"]) for plot in data["plots"]] if live else [],
        "label": str(_label("{title}")),
        "label_unit": str(_label(named("{title}", "{unit}"))),
        "names": _names(live["numbers"]) if live else [],
        "locked": [str(one["locked"]) for one in live["numbers"]] if live else [],
        "faults": packed([str(one["what"]) for one in live["conditions"]]) if live else packed([]),
        "groups": [[str(part) for part in one] for one in live["groups"]] if live else [],
        "gap": ["\n".join(map(str, one)) for one in live["gap"]] if live else [],
        "kinds": {kind: say(f"report.kind.{kind}") for kind in KINDS} if live else {},
        "column": "t" if data["time"]["label"] == Said("plot.time") else str(data["time"]["label"]),
        "charts": {key: [str(chart.title), *map(str, chart.data.texts)] for key, chart in charts.items()},
        "areas": [str(area["name"]) for area in data["scene"].get("areas", ())],
    }


def _names(numbers: Sequence[LiveNumber]) -> list[str]:
    """What numbers are called where that isn't their label, else empty."""
    return ["" if (name := str(one["called"])) == one["label"] else name for one in numbers]


def _also(title: Text) -> str:
    """Other words by which the signals of a plot are looked for."""
    if not isinstance(title, Said) or title.key not in ALSO_CALLED:
        return ""
    return say(title.key.replace("plot.", "plot.also.", 1))


def _label(title: Text) -> Text:
    """What a plot shows, for those who don't see it: a text with places for its signals."""
    return Term("colon", first=title, then="{signals}")


def _built(name: str) -> str:
    return built(__package__, f"assets/{name}")
