"""What an outcome shows as plain values: sections of sentences, tables, charts and the like.

Texts are those of the catalogue (:class:`~linkwright.findings.Said`), which become words where a terminal or a page
shows them; charts become numbers or pictures only where they are shown.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cached_property
from hashlib import blake2s
from typing import Any

from linkwright.data_classes import dataclass
from linkwright.findings import Said, Text
from linkwright.presentation.cells import Cell, NumberCell
from linkwright.presentation.chart_data import ChartData
from linkwright.presentation.charts import Content
from linkwright.words import LANGUAGES, in_language, language


@dataclass(frozen=True)
class Sentences:
    """Paragraphs; ``note`` sets them small, ``detail`` leaves them to the page."""

    texts: Sequence[Text]
    note: bool = False
    detail: bool = False


@dataclass(frozen=True)
class Bullets:
    """Sentences as a list."""

    texts: Sequence[Text]


@dataclass(frozen=True)
class Table:
    """A table: its heads and rows of equal length. One without rows isn't shown; ``detail`` leaves it to the page."""

    name: str
    title: Text
    heads: Sequence[Text]
    rows: Sequence[Sequence[Cell]]
    detail: bool = False

    @property
    def numeric(self) -> tuple[int, ...]:
        """The columns that hold numbers alone, whose units stand elsewhere."""
        columns = enumerate(zip(*self.rows, strict=True))
        return tuple(i for i, cells in columns if all(isinstance(c, NumberCell) and not c.unit for c in cells))


def table(of: str, name: str, heads: Iterable[Text], rows: Iterable[Sequence[Cell]], **data: Any) -> Table:
    """The table ``name`` of the texts ``of``: its title is ``OF.table.NAME`` of the catalogue, its heads
    ``OF.column.HEAD``, filled with ``data``; a head that is no mere key stays what it is."""
    columns = [head if isinstance(head, Said) else Said(f"{of}.column.{head}", **data) for head in heads]
    return Table(name, Said(f"{of}.table.{name}", **data), columns, [*rows])


@dataclass(frozen=True)
class Chart:
    """What is ``shown``, in numbers, which a page draws and files can't; ``draw`` gives a still picture of it as SVG,
    for files, and for pages where there are no numbers. Charts of one ``stack`` show the same for other values of
    parameters; ``step`` are the positions of their sliders. ``hint`` says what one can do with it on a screen."""

    title: Text
    draw: Callable[[], str] | None = None
    stack: str | None = None
    step: tuple[int, ...] = ()
    hint: Text = ""
    shown: Callable[[], Content] | None = None

    @cached_property
    def content(self) -> Content | None:
        """What is shown."""
        return None if self.shown is None else self.shown()

    @cached_property
    def data(self) -> ChartData:
        """The same as data for a page, of a chart that has numbers."""
        assert self.content is not None
        return ChartData(self.content)

    @cached_property
    def key(self) -> str:
        """By which a page finds its data, the same in all languages."""
        with in_language(LANGUAGES[0]):
            told = json.dumps([str(self.title), self.data.plain, [str(text) for text in self.data.texts]])
        return blake2s(told.encode(), digest_size=6).hexdigest()

    @cached_property
    def _drawings(self) -> dict[str, str]:
        return {}

    @property
    def drawing(self) -> str:
        """The SVG, in the language of the moment."""
        assert self.draw is not None
        if language() not in self._drawings:
            self._drawings[language()] = self.draw()
        return self._drawings[language()]


@dataclass(frozen=True)
class Slider:
    """A varied parameter: its values as texts, rising, and the number of the one at which it starts."""

    name: str
    texts: Sequence[str]
    start: int


@dataclass(frozen=True)
class Charts:
    """Pictures beside each other, with the sliders that choose among those of a stack."""

    charts: Sequence[Chart]
    sliders: Sequence[Slider] = ()


@dataclass(frozen=True)
class Copied:
    """A text for the clipboard, as a spreadsheet takes it, behind a button with a ``title``."""

    title: Text
    text: str


@dataclass(frozen=True)
class Card:
    """A small picture with a title, a note, and lines for a file; ``unknown`` stands where there are none."""

    title: Text
    note: Text
    draw: Callable[[], str]
    lines: Sequence[str]
    unknown: Text


@dataclass(frozen=True)
class Cards:
    """Pictures with their lines, which stand in a ``section`` of a file; ``heads`` are those of a table of the same."""

    section: str
    heads: tuple[Text, Text, Text]
    cards: Sequence[Card]


@dataclass(frozen=True)
class MeasureValue:
    """One number of a measure, in its unit: ``label`` tells the ends of extremes apart, ``at`` says where it happens,
    ``grade`` how sure it is; ``text`` stands for a value that is no number."""

    label: Text = ""
    value: float | None = None
    text: Text = ""
    at: Text = ""
    grade: Text = ""


@dataclass(frozen=True)
class Measure:
    """A named result with its requirement. ``verdict``: met, not met, or ``None`` where nothing is required."""

    name: str
    text: Text
    values: Sequence[MeasureValue]
    unit: str
    requirement: str | None
    verdict: bool | None


@dataclass(frozen=True)
class Measures:
    """The measures of a run."""

    measures: Sequence[Measure]


@dataclass(frozen=True)
class Check:
    """One line of a verification: its figure and what it means, in a sentence."""

    name: Text
    figure: str
    sentence: Text
    ok: bool


@dataclass(frozen=True)
class Checks:
    """What verifies a run, and what else is to be said of it."""

    checks: Sequence[Check]
    remarks: Sequence[Text] = ()

    @property
    def failed(self) -> list[Check]:
        """Those that fail."""
        return [check for check in self.checks if not check.ok]


Block = Sentences | Bullets | Table | Charts | Copied | Cards | Measures | Checks


@dataclass(frozen=True)
class Section:
    """A part of an outcome under a heading of its own, ``report.NAME`` of the catalogue."""

    name: str
    blocks: Sequence[Block]

    @property
    def title(self) -> Said:
        """The heading."""
        return Said(f"report.{self.name}")

    @property
    def shown(self) -> bool:
        """Whether there is anything in it."""
        return any(map(filled, self.blocks))


@dataclass(frozen=True)
class Area:
    """What lies behind the mechanism: a shape by its rings of places [x, y], holes among them, in the length unit."""

    name: Text
    rings: Sequence[Sequence[Sequence[float]]]


@dataclass(frozen=True)
class StudyReport:
    """What an outcome shows: its sections, its entries of ``summary.json``, what lies behind the mechanism."""

    sections: Sequence[Section]
    summary: Mapping[str, Any]
    areas: Sequence[Area] = ()


File = str | bytes | None
"""What a file holds; ``None`` where there is none to write."""


@dataclass(frozen=True)
class FileOf:
    """How a file is made of an outcome. ``option`` of the command speaks of it: without it, one that has to be
    ``asked`` for isn't written, any other only where the package that it ``needs`` (with its extra) is there; a run
    says so of one that is ``due``, where an outcome has what it holds."""

    make: Callable[[Any], File]
    option: str = ""
    asked: bool = False
    needs: tuple[str, str] | None = None
    due: Callable[[Any], bool] = bool


def filled(block: Block) -> bool:
    """Whether there is anything in a block."""
    if isinstance(block, Table | Cards):
        return bool(block.rows if isinstance(block, Table) else block.cards)
    (first, *_) = vars(block).values()
    return bool(first)
