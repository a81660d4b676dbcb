"""Charts as parts of a page."""

from __future__ import annotations

from collections.abc import Iterable

from linkwright.escape import markup, printed
from linkwright.presentation.blocks import Chart
from linkwright.presentation.charts import Content, Graph, Plane


def figures(charts: Iterable[Chart]) -> str:
    """Charts as HTML, each with its title: places that the script fills, and still pictures of those that have no
    numbers, with what one can do with them, which isn't printed."""
    return "".join(_still(chart) if chart.content is None else _place(chart, chart.content) for chart in charts)


def _still(chart: Chart) -> str:
    hint = f'<span class="note screen">{markup(chart.hint)}</span>' if chart.hint else ""
    caption = f"<figcaption>{markup(chart.title)}{hint}</figcaption>"
    return f'<figure class="chart-still">{caption}{chart.drawing}</figure>'


def _kind(content: Plane) -> str:
    return "plane equal" if content.equal else "plane"


def _place(chart: Chart, content: Content) -> str:
    kind, unit = ("graph", content.y.unit) if isinstance(content, Graph) else (_kind(content), "")
    shown = f' <span class="unit">{markup(printed(unit))}</span>' if unit else ""
    return (
        f'<figure class="plot study {kind}" data-chart="{chart.key}">'
        f"<figcaption><span>{markup(chart.title)}{shown}</span></figcaption>"
        f'<div class="chart"></div><div class="legend lw"></div></figure>'
    )
