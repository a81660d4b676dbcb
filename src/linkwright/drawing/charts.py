"""Still charts as SVG: axes with round numbers and lines within them. (Reports have charts as numbers.)"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright.escape import markup, printed
from linkwright.findings import Term, Text
from linkwright.presentation.lettering import columns

Array = NDArray[np.float64]

WIDTH, HEIGHT = 400.0, 220.0
LEFT, RIGHT, TOP, BOTTOM = 58.0, 12.0, 8.0, 36.0
MOST_POSES, MOST_CHARTS = 400, 24
LETTER = 6.5
"""The width of a letter."""
NARROW = 0.2
"""A band narrower than this share of the signal's span is hardly seen."""


class Axes:
    """Places of values in a drawing, with the axes' lines and numbers; ``x`` and ``y`` are their ranges."""

    def __init__(self, x: tuple[float, float], y: tuple[float, float], label: Text) -> None:
        self.x, self.y, self.label = widened(*x), widened(*y), label

    def across(self, values: Array) -> Array:
        """Where values lie from the left."""
        low, high = self.x
        return np.asarray(LEFT + (values - low) / (high - low) * (WIDTH - LEFT - RIGHT))

    def up(self, values: Array) -> Array:
        """Where values lie from the top."""
        low, high = self.y
        return np.asarray(HEIGHT - BOTTOM - (values - low) / (high - low) * (HEIGHT - TOP - BOTTOM))

    def line(self, x: Array, y: Array, kind: str) -> str:
        """A line of some class, broken where there is no value."""
        runs = stretches(np.isfinite(y))
        return "".join(
            f'<polyline class="{kind}" points="{points(self.across(x[run]), self.up(y[run]))}"/>' for run in runs
        )

    def drawing(self, shapes: Sequence[str], title: Text) -> str:
        """The whole: grid, shapes, numbers."""
        lines, numbers = [], []
        for value in ticks(*self.x, 6):
            x, text = float(self.across(np.array(value))), number_text(value)
            lines.append(f"M{x:.1f} {TOP:.0f}V{HEIGHT - BOTTOM:.0f}")
            x = min(x, WIDTH - LETTER * columns(text) / 2)
            numbers.append(f'<text x="{x:.1f}" y="{HEIGHT - BOTTOM + 14:.0f}" text-anchor="middle">{text}</text>')
        for value in ticks(*self.y, 5):
            y = float(self.up(np.array(value)))
            lines.append(f"M{LEFT:.0f} {y:.1f}H{WIDTH - RIGHT:.0f}")
            numbers.append(f'<text x="{LEFT - 6:.0f}" y="{y + 4:.1f}" text-anchor="end">{number_text(value)}</text>')
        middle = (LEFT + WIDTH - RIGHT) / 2
        numbers.append(f'<text x="{middle:.0f}" y="{HEIGHT - 5:.0f}" text-anchor="middle">{markup(self.label)}</text>')
        return (
            f'<svg class="lw still" viewBox="0 0 {WIDTH:.0f} {HEIGHT:.0f}" role="img" aria-label="{markup(title)}">'
            f'<path class="grid" d="{"".join(lines)}"/>{"".join(shapes)}{"".join(numbers)}</svg>'
        )


def widened(low: float, high: float) -> tuple[float, float]:
    """A range that has a width: values that differ by no more than round-off lie in its middle."""
    size = max(abs(low), abs(high)) or 1.0
    return (low, high) if high - low > 1e-12 * size else (low - 1e-6 * size, high + 1e-6 * size)


def ticks(low: float, high: float, count: int) -> list[float]:
    """Round numbers in a range, some ``count`` of them."""
    rough = (high - low) / count
    base = 10.0 ** np.floor(np.log10(rough))
    step = float(base * next(m for m in (1, 2, 5, 10) if m * base >= rough * (1 - 1e-9)))
    first = int(np.ceil(low / step - 1e-9))
    last = int(np.floor(high / step + 1e-9))
    return [k * step for k in range(first, last + 1)]


def round_below(value: float) -> float:
    """The largest of 1, 2 or 5 times a power of ten that isn't above a positive value."""
    base = 10.0 ** np.floor(np.log10(value))
    return float(f"{base * max(m for m in (1, 2, 5) if m * base <= value * (1 + 1e-9)):.1g}")


def number_text(value: float) -> str:
    """A number at an axis."""
    return f"{value:.7g}".replace("-", "−")


def thinned(count: int, most: int) -> NDArray[np.intp]:
    """So many places, both ends among them, or all where they are fewer."""
    return np.unique(np.linspace(0, count - 1, most).round().astype(int))


def points(x: Array, y: Array) -> str:
    """Places as an SVG attribute."""
    return " ".join(f"{a:.1f},{b:.1f}" for a, b in zip(x.tolist(), y.tolist(), strict=True))


def named(name: Text, unit: str) -> Text:
    """A name with its unit."""
    return Term("with-unit", name=name, unit=printed(unit)) if unit else name


def stretches(known: NDArray[np.bool_]) -> list[NDArray[np.intp]]:
    """The unbroken runs of poses with a value."""
    places = np.flatnonzero(known)
    return [run for run in np.split(places, np.flatnonzero(np.diff(places) > 1) + 1) if run.size]
