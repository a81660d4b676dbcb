"""Still pictures as parts of a page."""

from __future__ import annotations

from collections.abc import Iterable

from linkwright.escape import markup
from linkwright.presentation.blocks import Chart


def figures(charts: Iterable[Chart]) -> str:
    """Charts as HTML, each with its title and what one can do with it, which isn't printed."""
    return "".join(
        f'<figure class="chart-still"><figcaption>{_caption(chart)}</figcaption>{chart.drawing}</figure>'
        for chart in charts
    )


def _caption(chart: Chart) -> str:
    hint = f'<span class="note screen">{markup(chart.hint)}</span>' if chart.hint else ""
    return f"{markup(chart.title)}{hint}"
