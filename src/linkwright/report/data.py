"""What a report shows: plain data, in the file's display units, that also is its JSON payload.

Every part is a typed dict so that the same object feeds the page, a notebook widget and a test; the page's scripts have
the same types (``web/src/scene/data.ts``). Sequences are plain Python numbers; ``None`` stands for "no value here" (a
pose that can't be assembled).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Literal, NotRequired, TypedDict

from linkwright.findings import Text
from linkwright.presentation.blocks import Section

Values = Sequence[float | None]


class Time(TypedDict):
    """The axis that all plots and the drawing share. ``values``: increasing, in ``unit``."""

    values: Sequence[float]
    unit: str
    label: Text


class Pose(TypedDict):
    """Placement of a link's axes in the world over time: world = (x, y) + [[c, -s], [s, c]] local.

    ``x``, ``y``: origin, in the scene's length unit. ``c``, ``s``: unit vector of the link's x axis.
    Each of the scene's length, or of length 1 for a link that never moves.
    """

    x: Values
    y: Values
    c: Values
    s: Values


class LinkData(TypedDict):
    """A body with its named points in its own axes (length unit, x right, y up); ``outlines`` are closed lines there,
    of a cam or a roller."""

    name: str
    fixed: bool
    points: Mapping[str, Sequence[float]]
    pose: Pose
    outlines: NotRequired[Sequence[Sequence[Sequence[float]]]]


class JointData(TypedDict):
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

    In the length unit, one entry per pose. The moving one rolls on the fixed one. ``point`` is one of the link: by its
    velocity a page finds the centre of a changed mechanism.
    """

    link: str
    point: str
    x: Values
    y: Values
    u: Values
    v: Values


class SpringData(TypedDict):
    """A spring between a point of each of two links; ``look``: a coil, or barrel and rod of a gas spring or damper."""

    name: str
    links: Sequence[str]
    points: Sequence[str]
    look: Literal["coil", "strut"]


ArrowKind = Literal["velocity", "acceleration", "reaction", "load", "weight", "moment"]


class ArrowData(TypedDict):
    """An arrow of a live report: the labels of the two ``rows`` of its vector, or of the one of a moment (positive
    counter-clockwise), in ``unit``.

    It begins at a point, ``at`` = [link, point], or at the ``places`` in two other rows, in the length unit. ``name``
    is what it belongs to: a point, a reaction, a load, a link, a torque.
    """

    kind: ArrowKind
    name: str
    unit: str
    rows: Sequence[str]
    at: NotRequired[Sequence[str]]
    places: NotRequired[Sequence[str]]


class AreaData(TypedDict):
    """What lies behind the mechanism: a shape by its rings of places [x, y], holes among them, in the length unit."""

    name: Text
    rings: Sequence[Sequence[Sequence[float]]]


class Scene(TypedDict):
    """The mechanism as ``assets/mechanism.js`` draws it.

    ``time``: one entry per pose, increasing. ``driven``: the links that drives turn, each with the link against which.
    ``values``: the rows that arrows name, where they are known.
    """

    length_unit: str
    time: Sequence[float]
    links: Sequence[LinkData]
    joints: Sequence[JointData]
    traces: Sequence[Trace]
    centrodes: NotRequired[Sequence[Centrode]]
    springs: NotRequired[Sequence[SpringData]]
    areas: NotRequired[Sequence[AreaData]]
    driven: NotRequired[Sequence[Sequence[str]]]
    arrows: NotRequired[Sequence[ArrowData]]
    values: NotRequired[Mapping[str, Values]]


class Series(TypedDict):
    """One curve of a plot; ``values`` over the report's time, in the plot's unit."""

    name: str
    values: Values


class Plot(TypedDict):
    """Curves of one unit against time. ``group`` is its heading; ``unit`` is as printed, mm/s²."""

    title: Text
    group: Literal["motion", "force"]
    unit: str
    series: Sequence[Series]


class Fact(TypedDict):
    """One line about the structure, or of the title block."""

    name: Text
    sentence: Text


Severity = Literal["error", "warning", "note"]


class Problem(TypedDict):
    """A coded finding: how much it matters, what is wrong and what mends it."""

    code: str
    severity: Severity
    what: Text
    mend: Text


class LiveNumber(TypedDict):
    """A number of the model file that can be moved in the page.

    ``label`` is its place in short, ``called`` that in words; ``value`` and the bounds ``low`` and ``high``, those of
    its ``tolerance``, and ``scale``, by which changes of numbers are compared, are in SI; ``size`` is the SI value of
    its ``unit``. A ``named`` one is a parameter or a length of the sketch. A ``drawn`` one follows from the sketch
    until it is moved; it has no digits in the file. ``locked`` says why it can't be moved. Its digits stand in columns
    ``start`` to ``end`` of a ``line`` of the data.
    """

    name: str
    label: str
    called: Text
    value: float
    low: float
    high: float
    tolerance: Sequence[float] | None
    scale: float
    unit: str
    size: float
    named: bool
    drawn: bool
    locked: Text
    line: int
    start: int
    end: int


class LiveEntry(TypedDict):
    """Where the file takes a further parameter: in its ``line`` of the data, in braces at ``column``, or below it with
    an ``indent``; without a line in a section of its own. ``unit`` stands behind the digits."""

    line: int | None
    column: int
    indent: str
    unit: str


class SignalOwner(TypedDict):
    """The element of the next ``count`` signals: its ``kind``, and ``of``, its names, of a point those of its links."""

    kind: str
    of: str
    count: int


class MeasuredSignal(TypedDict):
    """The signal that a measure is of. ``by``: its value, the negative one, its magnitude, or that of the vector of
    which it is the x component. ``level``: whether the measure's limits are limits of these values."""

    signal: str
    by: str
    level: bool


class LiveCondition(TypedDict):
    """A condition on a number: the ``place`` in the file, ``what`` is wrong where it isn't met; where that has a place
    for its ``{value}``, the SI ``size`` of the unit."""

    place: str
    what: Text
    size: float | None


class LiveOutline(TypedDict):
    """The ``lines`` (how many) on a ``link``, such as a cam's: the ``inputs`` of their program at each place of them.

    With the name of a signal as ``travel`` its lowest and highest value are inputs, too. With a ``width`` (m) lines are
    open, and drawn as slots.
    """

    link: str
    lines: int
    inputs: Sequence[Sequence[float]]
    travel: NotRequired[str]
    width: NotRequired[float]


class SaidBy(TypedDict):
    """The drive, by its number, by whose values it is said where the mechanism can't be assembled, with the size of
    their unit in SI."""

    drive: int
    size: float


class LiveData(TypedDict):
    """What the page needs to compute all values itself. Times in s, values in SI.

    ``code``: the programs as JavaScript. ``program``: what joins them. ``length`` and ``second``: SI sizes of the
    report's units. ``poses``: the links whose poses come first among the programs' outputs, four rows each;
    ``signals``: the names of the rows behind them, with their ``units`` and the ``owners``; then ``arrow_rows``: the
    labels of others that arrows name; ``sizes`` are those of the units of both. ``wrapped`` are the numbers of those
    that are angles without whole turns; ``axes`` can stand in place of the time. ``probes``: a value of every third
    row, which the page must find too, but for round-off of its ``scales``. ``measures``: what is taken of the samples,
    and of which signal (``measured``). ``outlines`` are lines on links, one program each; with ``cams`` some are
    those of cams. With ``power`` the last two rows are what the powers of a pose leave, and their size.
    ``numbers``: what can be moved, and the ``lines`` of the file where it stands; ``entry``: where the file takes a
    parameter that the sketch stands for; ``conditions`` on numbers are in the
    order of the program's. ``drives`` and ``parameters`` by their number; ``groups``: of each dyad with two modes
    its links and its outer joints; ``gap``: what is said of one that can't close, and what mends it, where it must span
    too much and where too little, with places for figures.
    """

    code: str
    program: Mapping[str, object]
    times: Sequence[float]
    length: float
    second: float
    poses: Sequence[str]
    signals: Sequence[str]
    arrow_rows: Sequence[str]
    sizes: Sequence[float]
    units: Sequence[str]
    owners: Sequence[SignalOwner]
    axes: Sequence[str]
    wrapped: Sequence[int]
    probes: Values
    scales: Sequence[float]
    measures: Sequence[Mapping[str, object]]
    outlines: Sequence[LiveOutline]
    cams: bool
    power: bool
    measured: Sequence[MeasuredSignal | None]
    numbers: Sequence[LiveNumber]
    entry: LiveEntry | None
    lines: Sequence[str]
    drives: Sequence[str]
    by: SaidBy | None
    groups: Sequence[Sequence[Text]]
    gap: Sequence[Sequence[Text]]
    parameters: Sequence[str]
    conditions: Sequence[LiveCondition]


class ReportData(TypedDict):
    """Everything on the page. Sentences: ``source``, what the mechanism is taken from; ``title_block``: model
    file, hash, date, author, revision and version. ``sections``: what the studies show. With ``live`` the page computes
    the values of scene and plots itself, else ``recorded`` says why not; ``first`` are the numbers of the plots that it
    shows unfolded."""

    title: str
    subtitle: str
    source: Text
    title_block: Sequence[Fact]
    version: str
    time: Time
    scene: Scene
    plots: Sequence[Plot]
    first: NotRequired[Sequence[int]]
    sections: Sequence[Section]
    structure: Sequence[Fact]
    live: NotRequired[LiveData | None]
    recorded: NotRequired[Text]
    problems: Sequence[Problem]
    model_text: str
