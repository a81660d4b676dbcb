"""How the command line shows things: findings, structure, measures, certificate."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any

import click
from rich.markup import escape
from rich.table import Table

from linkwright.app import Bench, Examined, ExportJob, Job, ModesJob
from linkwright.blocks import Progress as Told
from linkwright.cli.consoles import err, out, wide
from linkwright.cli.progress import Bar
from linkwright.escape import json_text, line
from linkwright.expressions.units import TIME
from linkwright.findings import Finding
from linkwright.report.accuracy_page import sentences as accuracy_sentences
from linkwright.report.accuracy_tables import further, overview
from linkwright.report.cam import cam_sentences, cam_tables
from linkwright.report.data import Grid, MeasureValue
from linkwright.report.facts import checks, facts, remarks
from linkwright.report.limits import limits_entry, limits_tables
from linkwright.report.modes import circuit_text, mode_text, modes_data
from linkwright.report.parts import measure
from linkwright.report.reactions import reactions_tables
from linkwright.report.sweep import sentence as sweep_sentence
from linkwright.report.sweep import sweep_tables
from linkwright.report.workspace import workspace_sentences, workspace_tables
from linkwright.words import say

_NUMBERS = ("value", "figure", "cold", "pose", "ratio", "deviation")
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
        bar = stack.enter_context(Bar(text))

        def told(done: int, total: int) -> None:
            status.stop()
            bar(done, total)

        yield told


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
    element = f"{item.element}: " if item.element else ""
    style = _STYLES[item.severity]
    err.print(f"{escape(place)}[{style}]{item.severity}[/] {escape(element + item.what)} [dim]\\[{item.code}][/]")
    err.print(f"    {escape(item.mend)}")


def structure(examined: Examined) -> None:
    """What a mechanism is made of, and what was inferred."""
    if examined.compiled is None:
        return
    table = Table(box=None, show_header=False, padding=(0, 2, 0, 0))
    table.add_column(style="bold", no_wrap=True)
    table.add_column(overflow="fold")
    for fact in facts(examined.compiled):
        table.add_row(escape(fact["name"]), escape(fact["sentence"]))
    out.print(table)


def check_data(examined: Examined) -> dict[str, Any]:
    """What `check --json` prints."""
    known = {} if examined.compiled is None else {f["name"]: f["sentence"] for f in facts(examined.compiled)}
    return {
        "ok": examined.exit_code == 0,
        "structure": known,
        "findings": [item.as_dict() for item in examined.findings],
    }


def job(done: Job, file: Path) -> None:
    """A job's measures, certificate and failures, and where its files lie."""
    if done.cycle is not None:
        _measures(done)
        _certificate(done)
    if done.limits is not None:
        _grids(limits_tables(limits_entry(done.limits)["limits"]))
    if done.reactions is not None:
        _grids(reactions_tables(done.reactions))
    if done.sweep is not None:
        out.print(escape(sweep_sentence(done.sweep)))
        _grids(sweep_tables(done.sweep))
    if done.accuracy is not None:
        for text in accuracy_sentences(done.accuracy):
            out.print(escape(text))
        _grids([*overview(done.accuracy), *further(done.accuracy)])
    if done.workspace is not None:
        for text in workspace_sentences(done.workspace):
            out.print(escape(text))
        _grids(workspace_tables(done.workspace))
    if done.cam is not None:
        for text in cam_sentences(done.cam):
            out.print(escape(text))
        _grids(cam_tables(done.cam))
    for item in done.examined.located(done.found):
        finding(item, file)
    _where(done)


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
    if done.outcome is None:
        return
    data = modes_data(done.outcome)
    table = _table("mode", "where_on", "assembly")
    for entry in data["modes"]:
        lines = entry["assembly"] or [say("modes.untold")]
        table.add_row(str(entry["number"]), escape(mode_text(entry)), escape("\n".join(lines)))
    for sentence in (*data["sentences"], *(circuit_text(entry, data) for entry in data["circuits"])):
        out.print(escape(sentence))
    if data["modes"]:
        out.print()
        out.print(table)


def _table(*columns: str) -> Table:
    table = Table(box=None, header_style="bold", padding=(0, 2, 0, 0))
    for column in columns:
        table.add_column(
            say(f"cli.column.{column}"), overflow="fold", justify="right" if column in _NUMBERS else "left"
        )
    return table


_NOTHING: MeasureValue = {"label": "", "value": None, "text": "", "at": "", "grade": ""}


def _measures(done: Job) -> None:
    assert done.cycle is not None
    if not done.cycle.measures:
        return
    time_unit, second = done.cycle.result.run.compiled.quantities.unit_of(TIME)
    table = _table("measure", "value", "unit", "at", "requirement", "verdict", "grade")
    for m in done.cycle.measures:
        entry = measure(m, second, time_unit)
        verdict = {True: f"[green]{say('cli.met')}[/]", False: f"[bold red]{say('cli.not_met')}[/]", None: ""}
        for i, value in enumerate(entry["values"] or [_NOTHING]):
            name = " ".join(filter(None, (m.name, value["label"])))
            number = value["text"] or ("-" if value["value"] is None else f"{value['value']:.7g}")
            last = (entry["requirement"] or "", verdict[m.verdict]) if i == 0 else ("", "")
            table.add_row(
                escape(name), number, escape(m.unit), escape(value["at"]), escape(last[0]), last[1], value["grade"]
            )
    wide.print(table)
    out.print()


def _certificate(done: Job) -> None:
    assert done.cycle is not None
    certificate = done.cycle.result.certificate
    if certificate is None:
        return
    time_unit, second = done.cycle.result.run.compiled.quantities.unit_of(TIME)
    at = f"{certificate.nearest.time / second:.6g} {time_unit}" if certificate.nearest else ""
    table = _table("check", "figure", "verdict")
    for check in checks(certificate, at):
        mark = "[green]✓[/]" if check["ok"] else "[bold red]✗[/]"
        table.add_row(escape(check["name"]), check["figure"], f"{mark} {escape(check['sentence'])}")
    out.print(table)
    for note in remarks(certificate):
        out.print(escape(note))
    out.print()


def _grids(grids: list[Grid]) -> None:
    for grid in grids:
        table = Table(box=None, header_style="bold", padding=(0, 2, 0, 0))
        for head in grid["heads"]:
            table.add_column(escape(head), overflow="fold")
        for row in grid["rows"]:
            table.add_row(*map(escape, row))
        out.print(f"[bold underline]{escape(grid['title'])}[/]")
        wide.print(table)
        out.print()


def cannot_write(folder: Path, error: OSError) -> None:
    """The folder can't be written to."""
    finding(Finding("file.unwritable", data={"file": str(folder), "reason": error.strerror or str(error)}))


def bench(done: Bench | None) -> None:
    """The kernels' times, and what they stand against."""
    if done is None:
        return
    fill = f"{done.fill_ns_per_pose:.3g}"
    counts = {"outputs": len(done.outputs), "instructions": done.instructions, "threads": done.threads}
    out.print(say("cli.bench.work", poses=done.poses, fill=fill, **counts))
    table = _table("kernel", "cold", "pose", "ratio", "deviation")
    for name, times in done.kernels.items():
        ratio = times.ns_per_pose / done.fill_ns_per_pose
        numbers = (f"{times.cold_s:.3f}", f"{times.ns_per_pose:.3g}", f"{ratio:.3g}", f"{times.deviation:.1e}")
        table.add_row(name, *numbers)
    out.print(table)
    if done.missing:
        out.print(say("cli.bench.missing", names=", ".join(done.missing)))


def gallery() -> None:
    """The models of the gallery, a line each."""
    from linkwright.gallery import names, title

    width = max(map(len, names()))
    for name in names():
        out.print(escape(f"{name:{width}s}  {title(name)}"))


def refusals(findings: list[Finding]) -> None:
    """Why a command wasn't carried out."""
    for item in findings:
        finding(item)


def written(path: Path) -> None:
    """Where something was written."""
    out.print(escape(line(say("cli.written", folder=path))))
