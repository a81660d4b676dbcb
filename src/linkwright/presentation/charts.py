"""What charts show, as numbers: curves over an axis, and what lies in a plane. A page draws them.

Numbers are in the units of their axes, NaN where there is none; texts are those of the catalogue.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.findings import Text

Array = NDArray[np.float64]

Colour = int | Literal["ink", "muted", "warn"]
"""A colour of curves by its number, or one of drawings by its name."""


@dataclass(frozen=True)
class Axis:
    """What numbers along an axis are: how it is called, the unit as files write it ("" for none)."""

    name: Text
    unit: str = ""


@dataclass(frozen=True)
class Line:
    """A curve, broken where it has no value; ``dash`` numbers the kinds of dashes, 0 is a solid line."""

    name: Text
    values: Array
    colour: Colour = 0
    dash: int = 0


@dataclass(frozen=True)
class Dots:
    """A dot at each value."""

    name: Text
    values: Array
    colour: Colour = 0


@dataclass(frozen=True)
class Band:
    """What lies between two curves; a ``strong`` one is darker."""

    name: Text
    low: Array
    high: Array
    colour: Colour = 0
    strong: bool = False


@dataclass(frozen=True)
class Bars:
    """A bar from zero to each of the ``values`` (n,), between its two ``edges`` (n, 2)."""

    name: Text
    values: Array
    edges: Array
    colour: Colour = 0


Row = Line | Dots | Band | Bars


@dataclass(frozen=True)
class Limit:
    """A limit across a chart; an ``upright`` one lies on the horizontal axis."""

    text: Text
    value: float
    upright: bool = False


@dataclass(frozen=True)
class Graph:
    """Rows over one axis, ``at`` (n,) ascending values; with ``names``, these stand in place of numbers."""

    x: Axis
    at: Array
    y: Axis
    rows: Sequence[Row]
    limits: Sequence[Limit] = ()
    names: Sequence[Text] = ()


@dataclass(frozen=True)
class Region:
    """A filled shape by its rings (2, n), holes among them."""

    name: Text
    rings: Sequence[Array]
    colour: Colour = 0


@dataclass(frozen=True)
class Lines:
    """Lines (2, n) of one look."""

    name: Text
    lines: Sequence[Array]
    colour: Colour = 0
    dash: int = 0
    width: float = 1.4


@dataclass(frozen=True)
class ColourScale:
    """Colours ``stops``, as #rrggbb, even from ``low`` to ``high``, of the numbers of an axis."""

    axis: Axis
    low: float
    high: float
    stops: Sequence[str]


@dataclass(frozen=True)
class ColouredLines:
    """Lines that are coloured by a value each: ``lines`` are (value, its lines (2, n))."""

    name: Text
    scale: ColourScale
    lines: Sequence[tuple[float, Sequence[Array]]]


@dataclass(frozen=True)
class Spots:
    """Places (n,), with a ``scale`` coloured by their ``values`` (n,); ``cross``: small crosses."""

    name: Text
    x: Array
    y: Array
    values: Array | None = None
    scale: ColourScale | None = None
    colour: Colour = 0
    cross: bool = False


@dataclass(frozen=True)
class Field:
    """Values (rows, columns) on a grid ``x`` (columns,), ``y`` (rows,): bands of ``colours`` (#rrggbb) between
    ``levels``, one more than these, iso-lines at the levels and at the ``limits``.

    A ``coarse`` field is written with three digits, for maps of many places. It is seen within ``rings`` (2, n), if
    there are any. ``family``: a page may show it as curves over x, one for each y.
    """

    axis: Axis
    x: Array
    y: Array
    values: Array
    levels: Sequence[float]
    colours: Sequence[str]
    limits: Sequence[Limit] = ()
    rings: Sequence[Array] = ()
    coarse: bool = False
    family: bool = False


Layer = Region | Lines | ColouredLines | Spots | Field


@dataclass(frozen=True)
class Plane:
    """Layers over two axes, of one scale where these are ``equal``; ``fine`` is the step to which lines are rounded.
    ``box`` (least x, least y, largest x, largest y) is what is seen first, that of all layers by default."""

    x: Axis
    y: Axis
    layers: Sequence[Layer]
    equal: bool = True
    fine: float = 1e-3
    limits: Sequence[Limit] = ()
    box: tuple[float, float, float, float] | None = None


Content = Graph | Plane
