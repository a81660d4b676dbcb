"""Pictures of workspaces as one file."""

from __future__ import annotations

from collections.abc import Iterable

from linkwright.drawing.charts import LETTER
from linkwright.drawing.plane import LEFT, LINE, WIDTH
from linkwright.escape import markup
from linkwright.presentation.blocks import Chart
from linkwright.presentation.lettering import FONT, folded

TITLE = f".title {{ font: 600 13px {FONT}; fill: #1d2733; }}"
BOLD = 1.35 * LETTER
"""The width of a letter of a title."""
ABREAST = 4
"""Pictures beside each other in a file, at the most."""


def tiled(charts: Iterable[Chart]) -> str:
    """Pictures as one, each below its title: those of a stack beside each other, stacks one below the other."""
    stacks: dict[str, list[Chart]] = {}
    for number, chart in enumerate(charts):
        stacks.setdefault(chart.stack or str(number), []).append(chart)
    made, top, width = [], 0.0, 0.0
    for stack in stacks.values():
        for first in range(0, len(stack), ABREAST):
            row, high, left = stack[first : first + ABREAST], 0.0, 0.0
            titles = [[*folded(str(chart.title), int((WIDTH - LEFT) / BOLD))] for chart in row]
            head = LINE * max(map(len, titles)) + 8
            for chart, title in zip(row, titles, strict=True):
                for i, line in enumerate(title, start=1):
                    place = f'x="{left + LEFT:.0f}" y="{top + LINE * i:.0f}"'
                    made.append(f'<text class="title" {place}>{markup(line)}</text>')
                box = chart.drawing.split('viewBox="0 0 ', 1)[1].split('"', 1)[0]
                across, down = map(float, box.split())
                place = f'<svg x="{left:.0f}" y="{top + head:.0f}" width="{across:.0f}" height="{down:.0f}" '
                made.append(chart.drawing.replace("<svg ", place, 1))
                high, left = max(high, head + down), left + across
            top, width = top + high, max(width, left)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.0f}" height="{top:.0f}" '
        f'viewBox="0 0 {width:.0f} {top:.0f}" color="#1d2733"><style>{TITLE}</style>'
        f'<rect width="100%" height="100%" fill="#fff"/>{"".join(made)}</svg>\n'
    )
