"""The command line. Slow imports wait until a command needs them."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from linkwright._version import __version__
from linkwright.cli.streams import failed, interrupted, misused, prepare, read_or_not
from linkwright.cli.usage import Group
from linkwright.words import say

if TYPE_CHECKING:
    from linkwright.app import Examined, Writing
    from linkwright.blocks import Runner


class Commands(Group):
    """The commands; what makes one impossible from the start is told as findings."""

    def invoke(self, ctx: click.Context) -> Any:
        """Carry out a command."""
        try:
            return super().invoke(ctx)
        except Exception as error:
            findings = getattr(error, "findings", None)  # that of a ModelError, which is a slow import
            if findings is None:
                raise
            from linkwright.cli import show

            show.refusals([*findings])
            sys.exit(2)


@click.group(cls=Commands, help=say("cli.help"), context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, prog_name="linkwright")
def cli() -> None:
    """The group of commands."""


_file = click.argument("file", type=click.Path(path_type=Path))
_json = click.option("--json", "as_json", is_flag=True, help=say("cli.json"))
_out = click.option("--out", type=click.Path(path_type=Path), help=say("cli.out"))
_netcdf = click.option("--netcdf", is_flag=True, help=say("cli.netcdf"))


def _written(command: Callable[..., None]) -> Callable[..., None]:
    """The options of a command that writes results to a folder."""
    for option in (
        click.option("--csv-comments", "comments", is_flag=True, help=say("cli.csv_comments")),
        click.option("--force", is_flag=True, help=say("cli.force_folder")),
        _out,
        _file,
    ):
        command = option(command)
    return command


@cli.command(help=say("cli.run"))
@_written
@_netcdf
@_json
def run(file: Path, out: Path | None, force: bool, comments: bool, netcdf: bool, as_json: bool) -> None:
    """Perform a file's studies."""
    from linkwright import app

    how = app.Writing(["netcdf"] if netcdf else [], force=force, comments=comments)
    _carry_out(app.examine_file(file), file, "run", out, as_json, how)


def _carry_out(
    examined: Examined,
    file: Path,
    study: str,
    out: Path | None,
    as_json: bool,
    how: Writing,
    runner: Runner | None = None,
    fresh: bool = False,
) -> None:
    """Perform the studies of a file, write what comes of them, and tell it."""
    from linkwright import app
    from linkwright.cli import show
    from linkwright.studies import Site

    folder = out or _beside(file)
    with show.working(file, study, quiet=as_json) as progress, _writable(folder):
        job = app.carry_out(examined, Site(out=folder, runner=runner, progress=progress, fresh=fresh), how)
    _end(file, examined, as_json, lambda: job.summary, lambda: show.job(job, file), job.exit_code)


def _beside(file: Path) -> Path:
    """The usual folder of a file's results. Raises :class:`ModelError` for a link: it may have come with the file."""
    from linkwright.model.output_files import refuse_link

    folder = file.parent / f"{file.stem}_linkwright"
    refuse_link(folder)
    return folder


def _end(
    file: Path, examined: Examined, as_json: bool, data: Callable[[], Any], tell: Callable[[], None], code: int
) -> None:
    """What came out of a command, as JSON or for people, and its exit code."""
    from linkwright.app.job import summary_text
    from linkwright.cli import show

    with read_or_not():
        if as_json:
            show.plain(summary_text(data()))
        else:
            show.findings(examined, file)
            tell()
    sys.exit(code)


@contextmanager
def _writable(folder: Path) -> Iterator[None]:
    """A folder that can't be written to is told as such."""
    from linkwright.cli import show

    try:
        yield
    except OSError as error:
        show.cannot_write(folder, error)
        sys.exit(2)


@cli.command(help=say("cli.check"))
@_file
@_json
def check(file: Path, as_json: bool) -> None:
    """Examine a file."""
    from linkwright import app
    from linkwright.cli import show

    examined: Examined = app.examine_file(file)
    tell = partial(show.structure, examined)
    _end(file, examined, as_json, partial(show.check_data, examined), tell, examined.exit_code)


@cli.command(help=say("cli.modes"))
@_file
@_json
def modes(file: Path, as_json: bool) -> None:
    """Find a file's assembly modes."""
    from linkwright import app
    from linkwright.cli import show

    with show.working(file, "modes", quiet=as_json):
        done = app.modes_of_file(file)
    _end(file, done.examined, as_json, lambda: done.summary, lambda: show.modes(done), done.exit_code)


@cli.command(help=say("cli.limits"))
@_file
@_json
def limits(file: Path, as_json: bool) -> None:
    """Perform the limits study alone."""
    from linkwright import app
    from linkwright.cli import show

    examined = app.examine_alone(file, "limits")
    with show.working(file, "limits", quiet=as_json):
        job = app.perform(examined)
    _end(file, examined, as_json, lambda: job.summary, lambda: show.job(job, file), job.exit_code)


def _at_length(command: Callable[..., None]) -> Callable[..., None]:
    """The options of a command that performs one long study alone."""
    for option in (
        _json,
        _netcdf,
        click.option("--fresh", is_flag=True, help=say("cli.fresh")),
        click.option("--kernel", metavar="NAME", help=say("cli.kernel")),
        click.option("--workers", type=click.IntRange(1, 1024), help=say("cli.workers")),
        click.option("--cluster", metavar="ADDRESS", help=say("cli.cluster")),
        _written,
    ):
        command = option(command)
    return command


def _perform_alone(
    study: str,
    given: Mapping[str, Any],
    file: Path,
    out: Path | None,
    cluster: str | None,
    workers: int | None,
    fresh: bool,
    force: bool,
    comments: bool,
    netcdf: bool,
    as_json: bool,
) -> None:
    """Perform one study of a file, with the options ``given`` in place of its own."""
    from linkwright import app

    examined = app.examine_alone(file, study, given)
    how = app.Writing(["netcdf"] if netcdf else [], force=force, comments=comments)
    with app.runner_of(workers, cluster) as runner:
        _carry_out(examined, file, study, out, as_json, how, runner, fresh)


@cli.command(help=say("cli.sweep"))
@_at_length
def sweep(kernel: str | None, **others: Any) -> None:
    """Perform the sweep alone, or go on with an interrupted one."""
    _perform_alone("sweep", {"kernel": kernel}, **others)


@cli.command(help=say("cli.accuracy"))
@click.option("--samples", type=click.IntRange(0, 10**9), help=say("cli.samples"))
@_at_length
def accuracy(samples: int | None, kernel: str | None, **others: Any) -> None:
    """Perform the accuracy study alone, or go on with an interrupted one."""
    _perform_alone("accuracy", {"samples": samples, "kernel": kernel}, **others)


@cli.command(help=say("cli.workspace"))
@_written
@click.option("--dxf", is_flag=True, help=say("cli.dxf"))
@click.option("--png", is_flag=True, help=say("cli.png"))
@click.option("--fresh", is_flag=True, help=say("cli.fresh"))
@_json
def workspace(
    file: Path, out: Path | None, force: bool, comments: bool, dxf: bool, png: bool, fresh: bool, as_json: bool
) -> None:
    """Perform the workspace study alone, or resume an interrupted one."""
    from linkwright import app
    from linkwright._machine import needed
    from linkwright.findings import ModelError

    examined = app.examine_alone(file, "workspace")
    for asked, package, extra in ((dxf, "ezdxf", "cad"), (png, "resvg_py", "png")):
        try:
            if asked:
                needed(package, extra)
        except ModelError as error:
            examined.findings += error.findings
    how = app.Writing(["png"] if png else [], force=force, comments=comments)
    _carry_out(examined, file, "workspace", out, as_json, how, fresh=fresh)


@cli.command(help=say("cli.export"))
@_written
@click.option("--to", metavar="NAME", help=say("cli.to"))
@click.option("--dialect", metavar="NAME", help=say("cli.dialect"))
@click.option("--set", "settings", multiple=True, metavar="KEY=VALUE", help=say("cli.set"))
@_json
def export(
    file: Path,
    out: Path | None,
    force: bool,
    comments: bool,
    to: str | None,
    dialect: str | None,
    settings: tuple[str, ...],
    as_json: bool,
) -> None:
    """Write a mechanism for another tool."""
    from linkwright import app
    from linkwright.cli import show

    if to is None:
        show.refusals([app.no_target()])
        sys.exit(2)
    folder, how = out or _beside(file), app.Writing(force=force, comments=comments)
    with show.working(file, to, quiet=as_json), _writable(folder):
        if file.suffix.lower() == ".csv":
            job = app.export_batch(file, to, folder, how, settings, {"dialect": dialect})
        else:
            job = app.export_into(app.examine_export(file, to, settings, {"dialect": dialect}), to, folder, how)
    _end(file, job.examined, as_json, lambda: job.summary, lambda: show.export(job, file), job.exit_code)


@cli.command(help=say("cli.cam"))
@_written
@click.option("--post", metavar="NAME", multiple=True, help=say("cli.post"))
@_json
def cam(file: Path, out: Path | None, force: bool, comments: bool, post: tuple[str, ...], as_json: bool) -> None:
    """Perform the cam study alone."""
    from linkwright import app

    _carry_out(app.examine_cam(file, post), file, "cam", out, as_json, app.Writing(force=force, comments=comments))


@cli.command(help=say("cli.bench"))
@_file
@click.option("--poses", type=click.IntRange(1, 10**9), default=1_000_000, show_default=True, help=say("cli.poses"))
@click.option("--output", "outputs", multiple=True, metavar="SIGNAL", help=say("cli.outputs"))
@click.option("--kernel", "kernels", multiple=True, metavar="NAME", help=say("cli.kernels"))
@click.option("--threads", type=click.IntRange(1, 1024), help=say("cli.threads"))
@_json
def bench(
    file: Path, poses: int, outputs: tuple[str, ...], kernels: tuple[str, ...], threads: int | None, as_json: bool
) -> None:
    """Time the kernels on a file."""
    from linkwright import app
    from linkwright.cli import show

    examined = app.examine_file(file)
    with show.working(file, "bench", quiet=as_json):
        done = app.bench_file(examined, outputs, poses, threads or 0, kernels)
    code = examined.exit_code
    _end(
        file,
        examined,
        as_json,
        lambda: done.as_dict() if done else show.check_data(examined),
        lambda: show.bench(done),
        code,
    )


@cli.command(help=say("cli.new"))
@click.argument("name", required=False)
@click.option("--list", "as_list", is_flag=True, help=say("cli.list"))
@click.option("--table", "as_table", is_flag=True, help=say("cli.new_table"))
@click.option("--out", type=click.Path(path_type=Path), help=say("cli.new_out"))
@click.option("--force", is_flag=True, help=say("cli.force"))
def new(name: str | None, as_list: bool, as_table: bool, out: Path | None, force: bool) -> None:
    """Start a model file from the gallery, or a table for a batch of exports."""
    from linkwright.app import start
    from linkwright.cli import show

    if name is None or as_list:
        with read_or_not():
            show.gallery()
        return
    file = out or Path(f"{Path(name).stem}.csv" if as_table else f"{name}.yaml")
    if findings := (start.new_table if as_table else start.new)(name, file, force):
        show.refusals(findings)
        sys.exit(2)
    show.written(file)


@cli.command(help=say("cli.schema"))
def schema() -> None:
    """Print the JSON Schema."""
    import json

    from linkwright.exports.schema import file_schema

    with read_or_not():
        click.echo(json.dumps(file_schema(), indent=2, ensure_ascii=False))


def main() -> None:
    """The command line as a process: a user's mistake is a message, an interrupt says so, and so does a system that
    refuses something."""
    prepare()
    code: Any = 0
    try:
        code = _performed()
        with read_or_not():
            pass
    except BrokenPipeError:
        with read_or_not():
            raise
    except OSError as error:
        code = failed(error)
    sys.exit(code)


def _performed() -> Any:
    """Carry out the command; its exit code."""
    try:
        # Not by click's own main, which gives a closed pipe an exit code of its own.
        with cli.make_context("linkwright", sys.argv[1:]) as context:
            cli.invoke(context)
    except SystemExit as done:
        return done.code
    except click.exceptions.Exit as done:
        return done.exit_code
    except click.ClickException as error:
        return misused(error)
    except KeyboardInterrupt as stop:
        return interrupted(stop)
    return 0
