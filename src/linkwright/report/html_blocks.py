"""What an outcome shows as HTML, block by block. Every text from outside passes through ``markup`` exactly once."""

from __future__ import annotations

from collections.abc import Container, Iterable, Sequence
from functools import singledispatch

from linkwright.escape import markup, printed
from linkwright.presentation.blocks import (
    Block,
    Bullets,
    Card,
    Cards,
    Charts,
    Check,
    Checks,
    Copied,
    Measure,
    Measures,
    Section,
    Sentences,
    Table,
    filled,
)
from linkwright.presentation.cells import Cell, NumberCell, Numbers
from linkwright.report.prose import prose
from linkwright.report.stacks import stacks
from linkwright.words import say

WIDE = 7
"""Tables of more columns are set narrower, their units below the figures where need be."""

NOTHING = "–"
"""Stands where a cell has nothing; a column of measures in which all cells have nothing is left out."""


def section(shown: Section) -> str:
    """A section under its heading; nothing where there is nothing in it. Of one that only verifies, the line that is
    left when it is folded is the heading."""
    blocks = [block for block in shown.blocks if filled(block)]
    stated = "" if any(isinstance(block, Measures) for block in blocks) else of_file()
    if len(blocks) == 1 and isinstance(blocks[0], Checks):
        return f'<section id="{shown.name}">{stated}{_folded(blocks[0], "h2")}</section>'
    body = "".join(f"{_hint(blocks, block)}{html(block)}" for block in blocks)
    return body and f'<section id="{shown.name}"><h2>{markup(shown.title)}</h2>{stated}{body}</section>'


def of_file() -> str:
    """What stands over results that a page doesn't compute anew, to be seen once its numbers are changed."""
    return f'<p class="of-file">◐ {markup(say("report.of_file"))}</p>'


def _hint(blocks: Sequence[Block], block: Block) -> str:
    """Before the first charts of a section that the script draws: what one can do with them, and what stands there
    where no script runs."""
    drawn = [one for one in blocks if isinstance(one, Charts) and any(chart.content for chart in one.charts)]
    if block not in drawn[:1]:
        return ""
    absent = f"<noscript><p>{markup(say('report.no_script_charts'))}</p></noscript>"
    return f'{absent}<p class="hint charts-hint screen">{markup(say("report.charts_hint"))}</p>'


@singledispatch
def html(block: Block) -> str:
    """A block that has something in it."""
    raise NotImplementedError(type(block).__name__)


@html.register
def _(block: Sentences) -> str:
    kind = ' class="note"' if block.note else ""
    return "".join(f"<p{kind}>{prose(text)}</p>" for text in block.texts)


@html.register
def _(block: Bullets) -> str:
    return f"<ul>{''.join(f'<li>{prose(text)}</li>' for text in block.texts)}</ul>"


@html.register
def _(block: Table) -> str:
    heads = [prose(head) for head in block.heads]
    wide = len(heads) > WIDE
    rows = ([_cell(cell, wide) for cell in row] for row in block.rows)
    kind = "limits wide" if wide else "limits"
    return f"<h3>{markup(block.title)}</h3>{table(kind, heads, rows, block.numeric)}"


@html.register
def _(block: Charts) -> str:
    return stacks(block.charts, block.sliders)


@html.register
def _(block: Copied) -> str:
    return (
        f'<button type="button" class="copy screen" data-copy="{markup(block.text)}" hidden>'
        f"{markup(block.title)}</button>"
    )


@html.register
def _(block: Cards) -> str:
    return f'<div class="modes">{"".join(_card(card, block.section) for card in block.cards)}</div>'


def _card(card: Card, section: str) -> str:
    lines = [f"{section}:", *(f"  {line}" for line in card.lines)] if card.lines else [str(card.unknown)]
    head = f"<b>{markup(card.title)}</b> {prose(card.note)}"
    return f"<figure>{card.draw()}<figcaption>{head}<pre>{markup(chr(10).join(lines))}</pre></figcaption></figure>"


@html.register
def _(block: Measures) -> str:
    heads = ("measure", "value", "where", "requirement", "verdict")
    columns = [*zip(*map(_measure, block.measures), strict=True)]
    shown = [i for i, cells in enumerate(columns) if i < 2 or {*cells} != {NOTHING}]
    rows = zip(*(columns[i] for i in shown), strict=True)
    return table("measures", (markup(say(f"report.{heads[i]}")) for i in shown), rows)


def _measure(measure: Measure) -> Sequence[str]:
    unit = f'<span class="unit">{markup(printed(measure.unit))}</span>'
    values = "".join(
        f'<span class="line value"><span class="end">{markup(entry.label)}</span> '
        f"<b>{markup(entry.text) or _number(entry.value)}</b> {unit}</span>"
        for entry in measure.values
    )
    places = any(str(entry.at) for entry in measure.values)
    where = (
        "".join(f'<span class="line where">{prose(entry.at)}</span>' for entry in measure.values) if places else NOTHING
    )
    text = f'<span class="note">{prose(measure.text)}</span>'
    for grade in dict.fromkeys(str(entry.grade) for entry in measure.values):
        text += f'<span class="note grade">{prose(grade)}</span>'
    judged = NOTHING
    if measure.verdict is not None:
        judged = mark(measure.verdict, say("report.pass" if measure.verdict else "report.fail"))
    requirement = f'<span class="line">{markup(measure.requirement)}</span>' if measure.requirement else NOTHING
    return (f"<b>{markup(measure.name)}</b>{text}", values, where, requirement, judged)


@html.register
def _(block: Checks) -> str:
    return _folded(block)


def _folded(block: Checks, heading: str = "span") -> str:
    """The checks behind a line with their result; open where one fails."""
    heads = (markup(say(f"report.{head}")) for head in ("check", "figure", "meaning", "verdict"))
    total, passed = len(block.checks), len(block.checks) - len(block.failed)
    line = mark(passed == total, say("report.summary_checks", ok=passed, total=total))
    after = "".join(f'<p class="note">{prose(remark)}</p>' for remark in block.remarks)
    opened = " open" if passed < total else ""
    return (
        f"<details{opened}><summary><{heading}>{line}</{heading}></summary>"
        f"{table('certificate', heads, map(_check, block.checks))}{after}</details>"
    )


def _check(check: Check) -> Sequence[str]:
    verdict = mark(check.ok, say("report.holds" if check.ok else "report.violated"))
    figure = f'<span class="figure">{markup(check.figure)}</span>'
    return (f"<b>{markup(check.name)}</b>", figure, prose(check.sentence), verdict)


def table(kind: str, heads: Iterable[str], rows: Iterable[Sequence[str]], numeric: Container[int] = ()) -> str:
    """A table of markup, its ``numeric`` columns set right; each cell has its column's head besides, which narrow
    screens show instead of the heads."""
    columns = [(' class="number"' if i in numeric else "", head) for i, head in enumerate(heads)]
    body = "".join(
        "<tr>"
        + "".join(f'<td{of} data-head="{head}">{cell}</td>' for (of, head), cell in zip(columns, row, strict=True))
        + "</tr>"
        for row in rows
    )
    head = "".join(f'<th scope="col"{of}>{title}</th>' for of, title in columns)
    return f'<table class="{kind}"><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>'


def mark(ok: bool, text: str) -> str:
    """A verdict that reads without colour: a sign and a word."""
    return signed("ok" if ok else "bad", text)


SIGNS = {"ok": "✓", "bad": "✗", "warning": "⚠\ufe0e", "quiet": "·"}
"""The sign of each kind of mark: passed, failed, to be looked at, to be known."""


def signed(kind: str, text: str) -> str:
    """A text with the sign of its kind, which stands for the colour."""
    return f'<span class="mark {kind}">{sign_of(kind)} {markup(text)}</span>'


def sign_of(kind: str) -> str:
    """The sign of a kind of mark, which is read by the eye alone."""
    return f'<span aria-hidden="true">{SIGNS[kind]}</span>'


def _number(value: float | None) -> str:
    return NOTHING if value is None else f"{value:.6g}".replace("-", "−")


def _cell(cell: Cell, wide: bool) -> str:
    text = (markup if wide else prose)(cell).replace("\n", "<br>")
    return text.replace("-", "−") if isinstance(cell, NumberCell | Numbers) else text
