"""The command line. Slow imports wait until a command needs them."""

from __future__ import annotations

import sys
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from linkwright._version import __version__
from linkwright.cli import studies
from linkwright.cli.execution import (
    COMMENTS,
    EXCEL,
    FILE,
    FORCE,
    JSON,
    NETCDF,
    OPEN,
    OUT,
    QUIET,
    VERBOSE,
    Telling,
    beside,
    carry_out,
    end,
    options,
    writable,
)
from linkwright.cli.language import install, process_language
from linkwright.cli.streams import failed, interrupted, misused, prepare, read_or_not
from linkwright.cli.usage import CommandGroup, Option, Whole, option
from linkwright.cli.wrapping import WideFormatter
from linkwright.words import in_language

if TYPE_CHECKING:
    from linkwright.app import Examined


class Commands(CommandGroup):
    """The commands; what makes one impossible from the start is told as findings."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Their names, with the studies that have one."""
        return sorted({*super().list_commands(ctx), *studies.names()})

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """A command by name."""
        own = super().get_command(ctx, cmd_name)
        return studies.StudyCommand(cmd_name) if own is None and cmd_name in studies.names() else own

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


click.Context.formatter_class = WideFormatter


@click.group(cls=Commands, help="cli.help", context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, prog_name="linkwright", cls=Option, help="cli.version")
def cli() -> None:
    """The group of commands."""


@cli.command(help="cli.run")
@options(FILE, OUT, OPEN, FORCE, COMMENTS, EXCEL, NETCDF, QUIET, VERBOSE, JSON)
def run(file: Path, out: Path | None, force: bool, comments: bool, excel: bool, netcdf: bool, **told: bool) -> None:
    """Perform a file's studies."""
    from linkwright import app

    how = app.Writing(["netcdf"] if netcdf else [], force=force, comments=comments, excel=excel)
    carry_out(app.examine_file(file), file, "run", out, Telling(**told), how)


@cli.command(help="cli.check")
@options(FILE, JSON)
def check(file: Path, as_json: bool) -> None:
    """Examine a file."""
    from linkwright import app
    from linkwright.cli import show

    examined: Examined = app.examine_file(file)
    tell = partial(show.structure, examined)
    end(file, examined, Telling(as_json), partial(show.check_data, examined), tell, examined.exit_code)


@cli.command(help="cli.study.modes")
@options(FILE, JSON)
def modes(file: Path, as_json: bool) -> None:
    """Find a file's assembly modes."""
    from linkwright import app
    from linkwright.cli import show

    with show.working(file, "modes", quiet=as_json):
        done = app.modes_of_file(file)
    end(file, done.examined, Telling(as_json), lambda: done.summary, lambda: show.modes(done), done.exit_code)


@cli.command(help="cli.export")
@options(FILE, OUT, FORCE, COMMENTS, EXCEL)
@option("--to", metavar="NAME", help="cli.to")
@option("--dialect", metavar="NAME", help="cli.dialect")
@option("--set", "settings", multiple=True, metavar="KEY=VALUE", help="cli.set")
@JSON
def export(
    file: Path,
    out: Path | None,
    force: bool,
    comments: bool,
    excel: bool,
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
    folder, how = out or beside(file), app.Writing(force=force, comments=comments, excel=excel)
    with show.working(file, to, quiet=as_json), writable(folder):
        if file.suffix.lower() == ".csv":
            job = app.export_batch(file, to, folder, how, settings, {"dialect": dialect})
        else:
            job = app.export_into(app.examine_export(file, to, settings, {"dialect": dialect}), to, folder, how)
    end(file, job.examined, Telling(as_json), lambda: job.summary, lambda: show.export(job, file), job.exit_code)


@cli.command(help="cli.bench")
@FILE
@option("--poses", type=Whole(1, 10**9), default=1_000_000, show_default=True, help="cli.poses")
@option("--output", "outputs", multiple=True, metavar="SIGNAL", help="cli.outputs")
@option("--kernel", "kernels", multiple=True, metavar="NAME", help="cli.kernels")
@option("--threads", type=Whole(1, 1024), help="cli.threads")
@JSON
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
    end(
        file,
        examined,
        Telling(as_json),
        lambda: done.as_dict() if done else show.check_data(examined),
        lambda: show.bench(done),
        code,
    )


@cli.command(help="cli.new")
@click.argument("name", required=False)
@option("--list", "as_list", is_flag=True, help="cli.list")
@option("--table", "as_table", is_flag=True, help="cli.new_table")
@option("-o", "--out", type=click.Path(path_type=Path), help="cli.new_out")
@option("--force", is_flag=True, help="cli.force")
@EXCEL
def new(name: str | None, as_list: bool, as_table: bool, out: Path | None, force: bool, excel: bool) -> None:
    """Start a model file from the gallery, or a table for a batch of exports."""
    from linkwright.app import new_files
    from linkwright.cli import show

    if name is None or as_list:
        with read_or_not():
            show.gallery()
        return
    file = out or Path(f"{Path(name).stem}.csv" if as_table else f"{name}.yaml")
    make = partial(new_files.new_table, excel=excel) if as_table else new_files.new
    if findings := make(name, file, force):
        show.refusals(findings)
        sys.exit(2)
    show.written(file)


@cli.command(help="cli.schema")
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
    install()
    code: Any = 0
    with in_language(process_language()):
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
