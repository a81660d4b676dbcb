"""What a report shows: plain data, in the file's display units, that also is its JSON payload.

Every part is a typed dict so that the same object feeds the page, a notebook widget and a test. Sequences
are plain Python numbers; ``None`` stands for "no value here" (a pose that can't be assembled).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import isfinite
from typing import Literal, NotRequired, TypedDict

import numpy as np
from numpy.typing import NDArray

from linkwright.report.modes import ModesData

Values = Sequence[float | None]


def listed(values: NDArray[np.float64]) -> list[float | None]:
    """An array as plain numbers."""
    return [known(value) for value in values.tolist()]


def known(value: float) -> float | None:
    """A number, where it is one."""
    return value if isfinite(value) else None


class Time(TypedDict):
    """The axis that all plots and the drawing share. ``values``: increasing, in ``unit``."""

    values: Sequence[float]
    unit: str
    label: str


class Pose(TypedDict):
    """Placement of a link's axes in the world over time: world = (x, y) + [[c, -s], [s, c]] local.

    ``x``, ``y``: origin, in the scene's length unit. ``c``, ``s``: unit vector of the link's x axis.
    Each of the scene's length, or of length 1 for a link that never moves.
    """

    x: Values
    y: Values
    c: Values
    s: Values


class Link(TypedDict):
    """A body with its named points in its own axes (length unit, x right, y up); ``outlines`` are closed lines there,
    of a cam or a roller."""

    name: str
    fixed: bool
    points: Mapping[str, Sequence[float]]
    pose: Pose
    outlines: NotRequired[Sequence[Sequence[Sequence[float]]]]


class Joint(TypedDict):
    """A revolute joint (two coincident points) or a prismatic one (two coincident lines).

    ``links`` and ``points`` are parallel pairs. ``angles`` (prismatic only): direction of the line through
    each point, in radians, counter-clockwise from its link's x axis. The first link carries the guide, or the
    fixed one. ``look="cylinder"`` draws barrel and rod instead of a guide and a block.
    """

    name: str
    kind: Literal["revolute", "prismatic"]
    links: Sequence[str]
    points: Sequence[str]
    angles: NotRequired[Sequence[float]]
    look: NotRequired[Literal["cylinder"]]


class Trace(TypedDict):
    """The path of a point in the world (length unit)."""

    name: str
    x: Values
    y: Values


class Centrode(TypedDict):
    """The paths of a link's instant centre: in the world (``x``, ``y``) and in the link's own axes (``u``, ``v``).

    In the length unit, one entry per pose. The moving one rolls on the fixed one.
    """

    link: str
    x: Values
    y: Values
    u: Values
    v: Values


class Spring(TypedDict):
    """A spring between a point of each of two links; ``look``: a coil, or barrel and rod of a gas spring or damper."""

    name: str
    links: Sequence[str]
    points: Sequence[str]
    look: Literal["coil", "strut"]


class Area(TypedDict):
    """What lies behind the mechanism: a shape by its rings of places [x, y], holes among them, in the length unit."""

    name: str
    rings: Sequence[Sequence[Sequence[float]]]


class Scene(TypedDict):
    """The mechanism as ``assets/mechanism.js`` draws it. ``time``: one entry per pose, increasing."""

    length_unit: str
    time: Sequence[float]
    links: Sequence[Link]
    joints: Sequence[Joint]
    traces: Sequence[Trace]
    centrodes: NotRequired[Sequence[Centrode]]
    springs: NotRequired[Sequence[Spring]]
    areas: NotRequired[Sequence[Area]]


class Series(TypedDict):
    """One curve of a plot; ``values`` over the report's time, in the plot's unit."""

    name: str
    values: Values


class Plot(TypedDict):
    """Curves of one unit against time. ``group`` says under which heading it stands."""

    title: str
    group: Literal["motion", "force"]
    unit: str
    series: Sequence[Series]


class MeasureValue(TypedDict):
    """One number of a measure; ``label`` tells the ends of extremes apart, ``at`` says where it happens, ``grade`` how
    sure it is; ``text`` stands for a value that is no number."""

    label: str
    value: float | None
    text: str
    at: str
    grade: str


class Measure(TypedDict):
    """A named result with its requirement. ``verdict``: met, not met, or None where nothing is required."""

    name: str
    text: str
    values: Sequence[MeasureValue]
    unit: str
    requirement: str | None
    verdict: bool | None


class Grid(TypedDict):
    """A table of text: its heads and rows of equal length."""

    name: str
    title: str
    heads: Sequence[str]
    rows: Sequence[Sequence[str]]


class Chart(TypedDict):
    """A still chart: its title and the SVG. Charts of one ``stack`` show the same for other values of parameters;
    ``step`` are the positions of their sliders."""

    title: str
    drawing: str
    stack: NotRequired[str]
    step: NotRequired[Sequence[int]]


class Slider(TypedDict):
    """A varied parameter: its values as texts, rising, and the number of the one at which it starts."""

    name: str
    texts: Sequence[str]
    start: int


class SweepData(TypedDict):
    """A sweep: what was done in a sentence, tables of text, charts."""

    sentence: str
    tables: Sequence[Grid]
    charts: Sequence[Chart]


class OutputData(TypedDict):
    """One output of the accuracy study: sentences, its contributors as a table and tab-separated, charts."""

    name: str
    sentences: Sequence[str]
    review: Grid
    copied: str
    charts: Sequence[Chart]


class AccuracyData(TypedDict):
    """The accuracy study: what was done in sentences, a table of all outputs, each output, further tables."""

    sentences: Sequence[str]
    overview: Sequence[Grid]
    outputs: Sequence[OutputData]
    tables: Sequence[Grid]


class WorkspaceData(TypedDict):
    """The workspace study: what was found in sentences, a picture of each workspace, the sliders that choose among
    them, tables."""

    sentences: Sequence[str]
    charts: Sequence[Chart]
    sliders: Sequence[Slider]
    tables: Sequence[Grid]


class CamData(TypedDict):
    """The cam study: what was found in sentences, pictures and charts, tables."""

    sentences: Sequence[str]
    charts: Sequence[Chart]
    tables: Sequence[Grid]


class Check(TypedDict):
    """One line of the certificate: its figure and what it means, in a sentence."""

    name: str
    figure: str
    sentence: str
    ok: bool


class Fact(TypedDict):
    """One line about the structure."""

    name: str
    sentence: str


class Failure(TypedDict):
    """A coded finding: what is wrong and what mends it."""

    code: str
    what: str
    mend: str


class ReportData(TypedDict):
    """Everything on the page. Sentences: ``source``, what the mechanism is taken from; ``origin``, model file, hash,
    date and version. ``remarks``: what else is to be said of the run beside its checks; ``words``: the texts of the
    catalogue, in ``language``."""

    title: str
    subtitle: str
    source: str
    origin: str
    version: str
    words: Mapping[str, str]
    time: Time
    scene: Scene
    plots: Sequence[Plot]
    measures: Sequence[Measure]
    certificate: Sequence[Check]
    remarks: Sequence[str]
    limits: NotRequired[Sequence[Grid]]
    reactions: NotRequired[Sequence[Grid]]
    structure: Sequence[Fact]
    failures: Sequence[Failure]
    notes: NotRequired[Sequence[Failure]]
    model_text: str
    modes: NotRequired[ModesData]
    sweep: NotRequired[SweepData]
    accuracy: NotRequired[AccuracyData]
    workspace: NotRequired[WorkspaceData]
    cam: NotRequired[CamData]
