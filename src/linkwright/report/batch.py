"""The index page of a batch of exports: a row for each mechanism, with links to its files."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any
from urllib.parse import quote

from linkwright import _version
from linkwright.data_classes import dataclass
from linkwright.escape import markup
from linkwright.findings import Said
from linkwright.model.origin import Origin
from linkwright.presentation.html_file import html_file
from linkwright.words import say


@dataclass(frozen=True)
class BatchRow:
    """A row with its name, its model, its cells as the file has them, and what was exported."""

    name: str
    model: str
    cells: Sequence[str]
    exported: Any


def batch_page(file: str, target: str, heads: Sequence[str], rows: Sequence[BatchRow], origin: Origin) -> str:
    """The page as the text of an HTML file (UTF-8); it links to files named ``NAME_FILE`` beside it."""
    return html_file(
        Said("batch.page.title", file=file, target=target), partial(_body, file, target, heads, rows, origin)
    )


def _body(file: str, target: str, heads: Sequence[str], rows: Sequence[BatchRow], origin: Origin) -> str:
    columns = [
        say("batch.page.name"), say("batch.page.model"), *heads, say("batch.page.result"), say("batch.page.files"),
    ]  # fmt: skip
    head = "".join(f"<th>{markup(column)}</th>" for column in columns)
    body = "".join(_row(row, columns) for row in rows)
    title, subtitle = say("batch.page.title", file=file, target=target), say("batch.page.subtitle", count=len(rows))
    footer = say("batch.page.footer", version=_version.__version__, file=file, sha256=origin.short, date=origin.date)
    return f"""<header><h1>{markup(title)}</h1><p class="subtitle">{markup(subtitle)}</p></header>
<main class="batch"><table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table></main>
<footer>{markup(footer)}</footer>"""


def _row(row: BatchRow, columns: Sequence[str]) -> str:
    """A row; each cell has its column's head besides, which narrow screens show instead of the line of heads."""
    names = [*row.exported.files]
    page = next((name for name in names if name.endswith(".html")), None)
    name = markup(row.name) if page is None else _link(row, page, row.name)
    told = [*row.exported.sentences, *(f"{warning.what} {warning.mend}" for warning in row.exported.warnings)]
    links = "<br>".join(_link(row, file, file) for file in names)
    cells = [
        name,
        markup(row.model),
        *(f'<span class="figure">{markup(cell)}</span>' for cell in row.cells),
        "<br>".join(map(markup, told)),
        links,
    ]
    shown = (f'<td data-head="{markup(head)}">{cell}</td>' for head, cell in zip(columns, cells, strict=True))
    return f"<tr>{''.join(shown)}</tr>"


def _link(row: BatchRow, file: str, text: str) -> str:
    return f'<a href="{quote(f"{row.name}_{file}")}">{markup(text)}</a>'
