"""What an outcome shows on a terminal, block by block."""

from __future__ import annotations

from functools import singledispatch

from rich.markup import escape
from rich.table import Table as Grid

from linkwright.cli.consoles import out, wide
from linkwright.escape import printed
from linkwright.presentation.blocks import (
    Block,
    Bullets,
    Cards,
    Checks,
    Measure,
    Measures,
    MeasureValue,
    Section,
    Sentences,
    Table,
    filled,
)
from linkwright.presentation.lettering import columns, folded, widest
from linkwright.words import say


def show(section: Section, verbose: bool = False) -> None:
    """A section without its heading: its blocks, those that are details only where these are asked for."""
    for block in section.blocks:
        if not filled(block) or (getattr(block, "detail", False) and not verbose):
            continue
        if isinstance(block, Checks) and not verbose:
            summed(block)
        else:
            lines(block)


def summed(block: Checks) -> None:
    """A verification in a line, and what of it fails."""
    total, failed = len(block.checks), block.failed
    out.print(f"{_mark(not failed)} {escape(say('cli.verified', passed=total - len(failed), total=total))}")
    if failed:
        lines(Checks(failed))
    out.print()


def _mark(ok: bool) -> str:
    return "[green]✓[/]" if ok else "[bold red]✗[/]"


def table(*heads: object, right: tuple[int, ...] = ()) -> Grid:
    """A table with these heads, the columns of these numbers set right."""
    made = Grid(box=None, header_style="bold", padding=(0, 2, 0, 0))
    for i, head in enumerate(heads):
        made.add_column(escape(str(head)), overflow="fold", justify="right" if i in right else "left")
    return made


def fitted(grid: Grid, room: int) -> Grid:
    """The table in a ``room`` of so many columns, where it can be: words and numbers stay whole, and the column that
    takes the most lines is widened until there is no room left. Rich alone would break numbers between their digits."""
    texts = [[out.render_str(str(cell)).plain for cell in (one.header, *one.cells)] for one in grid.columns]
    full = [max(columns(line) for text in some for line in text.split("\n")) for some in texts]
    widths = [max(map(widest, some)) for some in texts]
    gap = 2 if sum(widths) + 2 * len(widths) <= room else 1
    free = room - sum(widths) - gap * len(widths)
    if free < 0:
        return grid
    if sum(full) + 2 * len(full) <= room:
        return _wide(grid, full)
    heights = [_height(some, width) for some, width in zip(texts, widths, strict=True)]
    for _ in range(free):
        if not (narrow := [i for i in range(len(full)) if widths[i] < full[i]]):
            break
        i = max(narrow, key=lambda i: (heights[i], widths[i] - full[i]))
        widths[i] += 1
        heights[i] = _height(texts[i], widths[i])
    grid.padding = (0, gap, 0, 0)
    return _wide(grid, widths)


def _wide(grid: Grid, widths: list[int]) -> Grid:
    """The table with columns of these widths, which Rich needn't look for."""
    for one, width in zip(grid.columns, widths, strict=True):
        one.width = width
    return grid


def _height(texts: list[str], width: int) -> int:
    """The lines of the cell that takes most of them in a column of so many letters."""
    return max(sum(1 for line in text.split("\n") for _ in folded(line, width)) for text in texts)


@singledispatch
def lines(block: Block) -> None:
    """Print a block that has something in it; those of pictures have nothing here."""


@lines.register(Sentences)
@lines.register(Bullets)
def _(block: Sentences | Bullets) -> None:
    for text in block.texts:
        out.print(escape(str(text)))


@lines.register
def _(block: Table) -> None:
    made = table(*block.heads, right=block.numeric)
    for row in block.rows:
        made.add_row(*(escape(str(cell)) for cell in row))
    out.print(f"[bold underline]{escape(str(block.title))}[/]")
    wide.print(fitted(made, wide.width))
    out.print()


@lines.register
def _(block: Cards) -> None:
    made = table(*block.heads)
    for number, card in enumerate(block.cards, start=1):
        made.add_row(str(number), escape(str(card.note)), escape("\n".join(card.lines) or str(card.unknown)))
    out.print()
    out.print(fitted(made, out.width))


@lines.register
def _(block: Measures) -> None:
    heads = ("measure", "value", "unit", "at", "requirement", "verdict", "grade")
    made = table(*(say(f"cli.column.{head}") for head in heads), right=(1,))
    for measure in block.measures:
        for i, value in enumerate(measure.values or [MeasureValue()]):
            made.add_row(*_measured(measure, value, first=i == 0))
    wide.print(fitted(made, wide.width))
    out.print()


def _measured(measure: Measure, value: MeasureValue, *, first: bool) -> list[str]:
    """A line of a measure; what is required and whether it is met stand on its first one."""
    name = " ".join(filter(None, (measure.name, str(value.label))))
    number = str(value.text) or ("-" if value.value is None else f"{value.value:.7g}")
    required = [measure.requirement or "", _verdict(measure.verdict)] if first else ["", ""]
    at, grade = escape(str(value.at)), escape(str(value.grade))
    return [escape(name), escape(number), escape(printed(measure.unit)), at, escape(required[0]), required[1], grade]


def _verdict(met: bool | None) -> str:
    if met is None:
        return ""
    return f"[green]{say('cli.met')}[/]" if met else f"[bold red]{say('cli.not_met')}[/]"


@lines.register
def _(block: Checks) -> None:
    made = table(*(say(f"cli.column.{head}") for head in ("check", "figure", "verdict")), right=(1,))
    for check in block.checks:
        made.add_row(escape(str(check.name)), escape(check.figure), f"{_mark(check.ok)} {escape(str(check.sentence))}")
    out.print(fitted(made, out.width))
    for note in block.remarks:
        out.print(escape(str(note)))
    out.print()
