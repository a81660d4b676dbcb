"""Pictures for several values of parameters as stacks: on screen sliders choose the one on top; on paper, and without
scripts, all of them stand beside each other."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import product
from zlib import crc32

from linkwright.drawing.chart_html import figures
from linkwright.escape import markup
from linkwright.presentation.blocks import Chart, Slider
from linkwright.words import say

MARKS = 9
"""A slider with more values has marks at its ends alone."""


def stacks(charts: Sequence[Chart], sliders: Sequence[Slider]) -> str:
    """Pictures as HTML, below the sliders of their parameters."""
    if not charts:
        return ""
    if not sliders:
        return f'<div class="plots">{figures(charts)}</div>'
    found: dict[str, dict[Sequence[int], Chart]] = {}
    for number, chart in enumerate(charts):  # of two pictures for the same values one is enough
        found.setdefault(chart.stack or str(number), {}).setdefault(chart.step, chart)
    own = f"step-{crc32(str(sorted(found)).encode()):x}"
    bars = "".join(_slider(own, number, slider) for number, slider in enumerate(sliders))
    label = markup(say("report.steps"))
    pictures = "".join(_stack(some, sliders) for some in found.values())
    return (
        f'<div class="stacks"><div class="sliders panel screen" role="group" aria-label="{label}" hidden>{bars}</div>'
        f'<div class="plots">{pictures}</div></div>'
    )


def _slider(of: str, number: int, slider: Slider) -> str:
    """A slider with its parameter's name, the value at which it stands, and marks."""
    name, texts, start = markup(slider.name), slider.texts, slider.start
    last = len(texts) - 1
    own = f"{of}-{number}"
    ends = range(len(texts)) if len(texts) <= MARKS else (0, last)
    marks = "".join(f'<span style="--at:{k / last:.4f}">{markup(_bare(texts[k], texts))}</span>' for k in ends)
    data = " ".join(f'data-text-{k}="{markup(text)}"' for k, text in enumerate(texts))
    return (
        f'<div class="slider"><label for="{own}">{name}</label><output for="{own}">{markup(texts[start])}</output>'
        f'<div class="track"><input type="range" id="{own}" min="0" max="{last}" step="1" value="{start}" '
        f'aria-valuetext="{markup(texts[start])}" {data}/>'
        f'<div class="marks" aria-hidden="true">{marks}</div></div></div>'
    )


def _bare(text: str, texts: Sequence[str]) -> str:
    """A value without its unit, which stands beside the slider, where there are many."""
    return text.partition(" ")[0] if len(texts) > 2 else text


def _stack(charts: Mapping[Sequence[int], Chart], sliders: Sequence[Slider]) -> str:
    """A stack's pictures with their positions of the sliders; where it has none, a note."""
    if () in charts:  # the same for all values
        return figures([charts[()]])
    made = ""
    for step in product(*(range(len(slider.texts)) for slider in sliders)):
        place = f'data-step="{" ".join(map(str, step))}"'
        if step in charts:
            made += figures([charts[step]]).replace("<figure ", f"<figure {place} ", 1)
        else:
            made += f'<p class="none" {place}>{markup(say("report.no_picture"))}</p>'
    return f'<div class="stack">{made}</div>'
