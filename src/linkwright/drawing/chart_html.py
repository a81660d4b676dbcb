"""Still pictures as parts of a page."""

from __future__ import annotations

from collections.abc import Iterable

from linkwright.escape import markup
from linkwright.presentation.blocks import Chart


def figures(charts: Iterable[Chart]) -> str:
    """Charts as HTML, each with its title."""
    return "".join(
        f'<figure class="chart-still"><figcaption>{markup(chart.title)}</figcaption>{chart.drawing}</figure>'
        for chart in charts
    )
