"""How the command line shows things: findings, structure, measures, certificate."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
from rich.markup import escape
from rich.table import Table

from linkwright.cli import terminal
from linkwright.cli.consoles import err, out
from linkwright.cli.progress import ProgressBar
from linkwright.escape import json_text, line
from linkwright.findings import Finding, Joined, Term, reason
from linkwright.report.structure_summary import facts
from linkwright.studies.registry import STUDIES
from linkwright.words import in_language, language, say

if TYPE_CHECKING:
    from linkwright.app import Bench, Examined, ExportJob, Job, ModesJob
    from linkwright.blocks import Progress as Told
    from linkwright.cli.execution import Telling

_STYLES = {"error": "bold red", "warning": "bold yellow", "note": "bold"}


def plain(text: str) -> None:
    """JSON on standard output, in letters that it knows."""
    try:
        text.encode(sys.stdout.encoding or "utf-8")
    except UnicodeEncodeError:
        text = json.dumps(json.loads(text), indent=2)
    click.echo(json_text(text))


@contextmanager
def working(file: Path, study: str, quiet: bool) -> Iterator[Told | None]:
    """A spinner while a command works, on a terminal only; told of progress it becomes a bar."""
    if quiet or not err.is_terminal:
        yield None
        return
    text = line(say("cli.working", study=study, file=file))
    with ExitStack() as stack:
        status = stack.enter_context(err.status(escape(text)))
        yield stack.enter_context(ProgressBar(text, first=status.stop))


def findings(examined: Examined, file: Path) -> None:
    """All findings with their lines, on standard error."""
    for item in examined.findings:
        finding(item, file)
    if examined.findings:
        counts = {f"{s}s": sum(f.severity == s for f in examined.findings) for s in ("error", "warning", "note")}
        text = say("cli.findings.notes" if counts["notes"] else "cli.findings", file=file, **counts)
        err.print(escape(line(text)))


def finding(item: Finding, file: Path | None = None) -> None:
    """One finding: place, element, what, mend."""
    place = f"{line(str(file))}:{item.line}: " if file and item.line else f"{line(str(file))}: " if file else ""
    what = str(Term("colon", first=item.element, then=item.what) if item.element else item.what)
    style, severity = _STYLES[item.severity], say(f"cli.severity.{item.severity}")
    err.print(f"{escape(place)}[{style}]{severity}[/] {escape(what)} [dim]\\[{item.code}][/]")
    err.print(f"    {escape(item.mend)}")


def structure(examined: Examined) -> None:
    """What a mechanism is made of, and what was inferred."""
    if examined.compiled is None:
        return
    table = Table(box=None, show_header=False, padding=(0, 2, 0, 0))
    table.add_column(style="bold", no_wrap=True)
    table.add_column(overflow="fold")
    for fact in facts(examined.compiled):
        table.add_row(escape(str(fact["name"])), escape(str(fact["sentence"])))
    out.print(table)


def check_data(examined: Examined) -> dict[str, Any]:
    """What `check --json` prints."""
    known = {}
    for fact in [] if examined.compiled is None else facts(examined.compiled):
        with in_language("en"):  # a key, which stays
            name = str(fact["name"])
        known[name] = str(fact["sentence"])
    return {
        "ok": examined.exit_code == 0,
        "structure": known,
        "findings": [item.as_dict() for item in examined.findings],
    }


def job(done: Job, file: Path, telling: Telling) -> None:
    """What the studies of a job show, what they found, and where its files lie."""
    if not telling.quiet:
        for report in done.outcomes.reports():
            for section in report.sections:
                terminal.show(section, telling.verbose)
    for item in done.examined.located(done.found):
        finding(item, file)
    if not telling.quiet:
        _where(done)


def opened(folder: Path) -> None:
    """Show a folder's report in a browser."""
    if (page := folder / "report.html").is_file():
        click.launch(str(page))


def _where(done: Job | ExportJob) -> None:
    """Where files lie, the new ones and those that are no longer current."""
    if done.folder is not None:
        written(done.folder)
    if done.outdated is not None:
        err.print(escape(line(say("cli.outdated", folder=done.outdated))))


def export(done: ExportJob, file: Path) -> None:
    """What an export says of itself, what it found, and where its files lie."""
    for text in done.exported.sentences if done.exported is not None else ():
        out.print(escape(text))
    for item in done.found:
        finding(item, file)
    _where(done)


def modes(done: ModesJob) -> None:
    """Assembly modes, the circuits on which they lie, the lines that select them."""
    if done.outcome is not None:
        for section in STUDIES["modes"].report(done.outcome).sections:
            terminal.show(section, verbose=True)


def cannot_write(folder: Path, error: OSError) -> None:
    """The folder can't be written to."""
    finding(Finding("file.unwritable", data={"file": str(folder), "reason": reason(error)}))


def bench(done: Bench | None) -> None:
    """The kernels' times, and what they stand against."""
    if done is None:
        return
    fill = f"{done.fill_ns_per_pose:.3g}"
    counts = {"outputs": len(done.outputs), "instructions": done.instructions, "threads": done.threads}
    out.print(say("cli.bench.work", poses=done.poses, fill=fill, **counts))
    table = terminal.table(*(say(f"cli.column.{name}") for name in ("kernel", "cold", "pose", "ratio", "deviation")))
    for name, times in done.kernels.items():
        ratio = times.ns_per_pose / done.fill_ns_per_pose
        numbers = (f"{times.cold_s:.3f}", f"{times.ns_per_pose:.3g}", f"{ratio:.3g}", f"{times.deviation:.1e}")
        table.add_row(name, *numbers)
    out.print(table)
    if done.missing:
        out.print(say("cli.bench.missing", names=Joined(done.missing)))


def gallery() -> None:
    """The models of the gallery, a line each, in the present language."""
    from linkwright.gallery import names, title

    width = max(map(len, names()))
    for name in names():
        out.print(escape(f"{name:{width}s}  {title(name, language())}"))


def refusals(findings: list[Finding]) -> None:
    """Why a command wasn't carried out."""
    for item in findings:
        finding(item)


def written(path: Path) -> None:
    """Where something was written."""
    out.print(escape(line(say("cli.written", folder=path))))
