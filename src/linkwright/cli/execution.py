"""From a command's words to what is shown: the options that commands share, and how one is carried out."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

import click

from linkwright.cli.streams import read_or_not
from linkwright.cli.usage import option
from linkwright.data_classes import dataclass

if TYPE_CHECKING:
    from linkwright.app import Examined, Job, Writing
    from linkwright.blocks import Runner


FILE = click.argument("file", type=click.Path(path_type=Path))
JSON = option("--json", "as_json", is_flag=True, help="cli.json")
OUT = option("-o", "--out", type=click.Path(path_type=Path), help="cli.out")
NETCDF = option("--netcdf", is_flag=True, help="cli.netcdf")
QUIET = option("-q", "--quiet", is_flag=True, help="cli.quiet")
VERBOSE = option("-v", "--verbose", is_flag=True, help="cli.verbose")
OPEN = option("--open", "opened", is_flag=True, help="cli.open")
FORCE = option("--force", is_flag=True, help="cli.force_folder")
COMMENTS = option("--csv-comments", "comments", is_flag=True, help="cli.csv_comments")
EXCEL = option("--excel", is_flag=True, help="cli.excel")


def options(*every: Callable[..., Any]) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """Several options of a command, in the order of its help."""

    def made(command: Callable[..., None]) -> Callable[..., None]:
        for declare in reversed(every):
            command = declare(command)
        return command

    return made


@dataclass(frozen=True)
class Telling:
    """How much is shown of what came out: as JSON, problems alone, with all details; ``opened``, the page as well."""

    as_json: bool = False
    quiet: bool = False
    verbose: bool = False
    opened: bool = False


def shown(file: Path) -> Path:
    """What a model file is called."""
    from linkwright.model.input_files import STDIN, STDIN_NAME

    return STDIN_NAME if file == STDIN else file


def beside(file: Path) -> Path:
    """The usual folder of a file's results. Raises :class:`ModelError` for a link: it may have come with the file."""
    from linkwright.model.output_files import refuse_link

    file = shown(file)
    folder = file.parent / f"{file.stem}_linkwright"
    refuse_link(folder)
    return folder


def carry_out(
    examined: Examined,
    file: Path,
    study: str,
    out: Path | None,
    telling: Telling,
    how: Writing,
    runner: Runner | None = None,
    fresh: bool = False,
) -> NoReturn:
    """Perform the studies of a file, write what comes of them, and tell it."""
    from linkwright import app
    from linkwright.cli import show
    from linkwright.studies import RunContext

    folder = out or beside(file)
    with show.working(file, study, quiet=telling.as_json or telling.quiet) as progress, writable(folder):
        job = app.carry_out(examined, RunContext(out=folder, runner=runner, progress=progress, fresh=fresh), how)
    end_of_job(job, file, telling)


def end_of_job(job: Job, file: Path, telling: Telling) -> NoReturn:
    """What came out of a file's studies."""
    from linkwright.cli import show

    if telling.opened and job.folder is not None:
        show.opened(job.folder)
    end(file, job.examined, telling, lambda: job.summary, lambda: show.job(job, shown(file), telling), job.exit_code)


def end(
    file: Path, examined: Examined, telling: Telling, data: Callable[[], Any], tell: Callable[[], None], code: int
) -> NoReturn:
    """What came out of a command, as JSON or for people, and its exit code."""
    from linkwright.app.job import summary_text
    from linkwright.cli import show

    with read_or_not():
        if telling.as_json:
            show.plain(summary_text(data()))
        else:
            show.findings(examined, shown(file))
            tell()
    sys.exit(code)


@contextmanager
def writable(folder: Path) -> Iterator[None]:
    """A folder that can't be written to is told as such."""
    from linkwright.cli import show

    try:
        yield
    except OSError as error:
        show.cannot_write(folder, error)
        sys.exit(2)
