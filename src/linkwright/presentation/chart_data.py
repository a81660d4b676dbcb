"""Charts as plain data for the page's scripts: short numbers, texts by their number, each line once.

Numbers have six digits of the range of their row: finer than a screen shows. Lines are whole steps of the plane's
``fine`` from place to place. ``web/src/plots/study_data.ts`` reads this.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import singledispatch
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.escape import printed
from linkwright.findings import Text
from linkwright.presentation.charts import (
    Axis,
    Band,
    Bars,
    ColouredLines,
    ColourScale,
    Content,
    Dots,
    Field,
    Graph,
    Limit,
    Line,
    Lines,
    Plane,
    Region,
    Spots,
)

Array = NDArray[np.float64]
Plain = dict[str, Any]

DIGITS = 6
STEPS = 4094
"""A coarse field has so many steps between its ends."""
LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/"
"""Digits of numbers. Two of them are a number of a coarse field: 0 for none, then from the low to the high end."""
WIDE = 8.0
"""A coarse field of positive values whose ends are farther apart than by this factor has even ratios."""
OUTER = (0.5, 99.5)
"""Per cent between which the values of another one lie; those beyond are at its ends."""


class ChartData:
    """The data of a chart: ``plain`` without texts but for their numbers among ``texts``."""

    def __init__(self, content: Content) -> None:
        self.texts: list[Text] = []
        self.plain: Plain = _plain(content, self)

    def text(self, text: Text) -> int:
        """The number of a text."""
        if text not in self.texts:
            self.texts.append(text)
        return self.texts.index(text)

    def axis(self, axis: Axis) -> Plain:
        return {"name": self.text(axis.name), "unit": printed(axis.unit)}

    def limits(self, limits: Iterable[Limit]) -> list[Plain]:
        kinds = ({"upright": True} if one.upright else {} for one in limits)
        return [
            {"text": self.text(one.text), "value": short(one.value), **kind}
            for one, kind in zip(limits, kinds, strict=True)
        ]

    def scale(self, scale: ColourScale) -> Plain:
        ends = {"low": short(scale.low), "high": short(scale.high)}
        return {"axis": self.axis(scale.axis), **ends, "stops": [*scale.stops]}


def short(value: float) -> float | int | None:
    """A number with few digits; ``None`` where it is none."""
    if not np.isfinite(value):
        return None
    rounded = float(f"{value:.9g}")
    return int(rounded) if rounded.is_integer() and abs(rounded) < 1e9 else rounded


def numbers(values: Array) -> list[float | int | None]:
    """Numbers with ``DIGITS`` digits of their range; ``None`` where there is none."""
    known = values[np.isfinite(values)]
    if not known.size:
        return [None] * values.size
    size, span = float(np.abs(known).max()), float(np.ptp(known))
    if span <= 1e-9 * size:
        return [short(value) for value in values.tolist()]
    decimals = DIGITS - 1 - int(np.floor(np.log10(span)))
    return [short(round(value, decimals)) if np.isfinite(value) else None for value in values.tolist()]


def steps(values: Array) -> Plain | list[float | int | None]:
    """The values of an axis: even ones by their ends and number."""
    if values.size > 3 and np.isfinite(values).all():
        even = np.linspace(values[0], values[-1], values.size)
        if np.abs(even - values).max() <= 1e-9 * (np.abs(values).max() or 1.0):
            return {"from": short(values[0]), "to": short(values[-1]), "count": values.size}
    return numbers(values)


def path(line: Array, fine: float) -> str:
    """A line (2, n) as whole steps: its first place, then from each place to the next, x and y in turn. A step is
    written in letters of five bits each, the least first, 32 in all but its last letter; its sign is its least bit."""
    places = np.rint(line.T / fine).astype(np.int64)
    moved = np.diff(places, axis=0)
    steps = [*places[0].tolist(), *moved[moved.any(axis=1)].ravel().tolist()]
    return "".join(_letters(2 * step if step >= 0 else -2 * step - 1) for step in steps)


def _letters(number: int) -> str:
    made = ""
    while number >= 32:
        made += LETTERS[32 + number % 32]
        number //= 32
    return made + LETTERS[number]


@singledispatch
def _plain(content: Content, data: ChartData) -> Plain:
    raise NotImplementedError(type(content).__name__)


@_plain.register
def _(content: Graph, data: ChartData) -> Plain:
    rows = [{"name": data.text(row.name), "colour": row.colour, **_row(row)} for row in content.rows]
    made: Plain = {"x": data.axis(content.x), "at": steps(content.at), "y": data.axis(content.y), "rows": rows}
    if content.limits:
        made["limits"] = data.limits(content.limits)
    if content.names:
        made["names"] = [data.text(name) for name in content.names]
    return made


@_plain.register
def _(content: Plane, data: ChartData) -> Plain:
    layers = [_layer(layer, data, content.fine) for layer in content.layers]
    made: Plain = {"x": data.axis(content.x), "y": data.axis(content.y)}
    made |= {"fine": short(content.fine), "layers": layers}
    if content.equal:
        made["equal"] = True
    if content.limits:
        made["limits"] = data.limits(content.limits)
    if content.box is not None:
        made["box"] = [short(edge) for edge in content.box]
    return made


@singledispatch
def _row(row: object) -> Plain:
    raise NotImplementedError(type(row).__name__)


@_row.register
def _(row: Line) -> Plain:
    return {"values": numbers(row.values), "dash": row.dash}


@_row.register
def _(row: Dots) -> Plain:
    known = np.flatnonzero(np.isfinite(row.values))
    few: Plain = {"values": numbers(row.values)}
    if known.size < row.values.size / 2:
        few = {"values": numbers(row.values[known]), "of": known.tolist()}
    return {"look": "dots", **few}


@_row.register
def _(row: Band) -> Plain:
    return {"look": "strong" if row.strong else "band", "values": numbers(row.high), "low": numbers(row.low)}


@_row.register
def _(row: Bars) -> Plain:
    together = row.edges.size > 2 and np.array_equal(row.edges[1:, 0], row.edges[:-1, 1])
    ends = np.append(row.edges[:, 0], row.edges[-1:, 1]) if together else row.edges.ravel()
    return {"look": "bars", "values": numbers(row.values), "edges" if together else "pairs": steps(ends)}


@singledispatch
def _layer(layer: object, data: ChartData, fine: float) -> Plain:
    raise NotImplementedError(type(layer).__name__)


@_layer.register
def _(layer: Region, data: ChartData, fine: float) -> Plain:
    paths = [path(ring, fine) for ring in layer.rings]
    return {"kind": "region", "name": data.text(layer.name), "colour": layer.colour, "paths": paths}


@_layer.register
def _(layer: Lines, data: ChartData, fine: float) -> Plain:
    look = {"colour": layer.colour, "dash": layer.dash, "width": layer.width}
    paths = [path(line, fine) for line in layer.lines]
    return {"kind": "lines", "name": data.text(layer.name), **look, "paths": paths}


@_layer.register
def _(layer: ColouredLines, data: ChartData, fine: float) -> Plain:
    groups = [{"value": short(value), "paths": [path(line, fine) for line in some]} for value, some in layer.lines]
    return {"kind": "coloured", "name": data.text(layer.name), "scale": data.scale(layer.scale), "groups": groups}


@_layer.register
def _(layer: Spots, data: ChartData, fine: float) -> Plain:
    made: Plain = {"kind": "spots", "name": data.text(layer.name), "colour": layer.colour, "cross": layer.cross}
    made |= {"x": numbers(layer.x), "y": numbers(layer.y)}
    if layer.values is not None and layer.scale is not None:
        made |= {"values": numbers(layer.values), "scale": data.scale(layer.scale)}
    return made


@_layer.register
def _(layer: Field, data: ChartData, fine: float) -> Plain:
    values = coarse(layer.values) if layer.coarse else {"values": numbers(layer.values.ravel())}
    made: Plain = {"kind": "field", "axis": data.axis(layer.axis), "x": steps(layer.x), "y": steps(layer.y), **values}
    made |= {"levels": [short(level) for level in layer.levels], "colours": [*layer.colours]}
    made |= {"limits": data.limits(layer.limits)} if layer.limits else {}
    made |= {"paths": [path(ring, fine) for ring in layer.rings]} if layer.rings else {}
    return made | ({"family": True} if layer.family else {})


def coarse(values: Array) -> Plain:
    """Values with three digits, two letters each, between two ends; evenly, or by even ratios."""
    known = values[np.isfinite(values)]
    if not known.size:
        return {"packed": "AA" * values.size, "low": 0, "high": 1, "ratios": False}
    low, high = float(known.min()), float(known.max())
    ratios = bool(low > 0 and high > WIDE * low)
    if not ratios:
        low, high = (float(end) for end in np.percentile(known, OUTER))
    low, high = float(f"{low:.9g}"), float(f"{high:.9g}")
    if not high > low:
        high = low + (abs(low) or 1.0) * 1e-9
    with np.errstate(invalid="ignore"):
        share = np.log(values / low) / np.log(high / low) if ratios else (values - low) / (high - low)
    number = np.where(np.isfinite(values), 1 + np.rint(STEPS * np.clip(np.nan_to_num(share), 0, 1)), 0).astype(int)
    packed = "".join(LETTERS[k >> 6] + LETTERS[k & 63] for k in number.ravel().tolist())
    return {"packed": packed, "low": low, "high": high, "ratios": ratios}


def pooled(charts: Mapping[str, Plain]) -> Plain:
    """The charts of a page by their keys, with all their lines in one list, each once."""
    known: dict[str, int] = {}

    def of(value: Any) -> Any:
        if isinstance(value, Mapping):
            return {key: numbered(entry) if key == "paths" else of(entry) for key, entry in value.items()}
        return [of(entry) for entry in value] if isinstance(value, list) else value

    def numbered(paths: Sequence[str]) -> list[int]:
        return [known.setdefault(each, len(known)) for each in paths]

    made = {key: of(chart) for key, chart in charts.items()}
    return {"charts": made, "paths": [*known]}
