"""Standard input, output and error of the process: where they are closed, full, lack letters, or have no reader."""

from __future__ import annotations

import codecs
import errno
import io
import os
import sys
import warnings
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import click

from linkwright.escape import line, visible
from linkwright.findings import reason
from linkwright.words import say

CANNOT = 2
"""The exit code where what was asked can't be told."""
FULL = (errno.ENOSPC, errno.EFBIG, errno.EIO)
"""What a stream answers; where files can't be written, the commands themselves say which."""


def prepare() -> None:
    """Put an empty stream in place of each that is closed, else the next file would get its number; a terminal that
    lacks a letter shows another. Warnings of NumPy tell a user nothing: what isn't a number is told by findings."""
    if not sys.warnoptions:
        warnings.filterwarnings("ignore", category=RuntimeWarning)
    for name, mode in (("stdin", "r"), ("stdout", "w"), ("stderr", "w")):
        stream = getattr(sys, name)
        if stream is None:
            setattr(sys, name, Path(os.devnull).open(mode, encoding="utf-8"))  # noqa: SIM115
        elif isinstance(stream, io.TextIOWrapper) and mode == "w":
            stream.reconfigure(errors="linkwright.replace")


_INSTEAD = {"✓": "√", "✗": "×", "²": "^2", "³": "^3", "⁴": "^4", "·": "*", "−": "-", "–": "-", "σ": "sigma"}
"""What stands for a letter in an encoding that lacks it, such as GBK or ASCII, where the encoding has that."""


def _replaced(error: UnicodeError) -> tuple[str, int]:
    """What is written in place of letters that a stream lacks: their like, so that what they mean isn't lost."""
    if not isinstance(error, UnicodeEncodeError):
        raise error
    letters = error.object[error.start : error.end]
    return "".join(_instead(letter, error.encoding) for letter in letters), error.end


def _instead(letter: str, encoding: str) -> str:
    for other in (_INSTEAD.get(letter, "?"), _PLAIN.get(letter, "?")):
        try:
            other.encode(encoding)
        except UnicodeEncodeError:
            continue
        return other
    return "?"


_PLAIN = {"✓": "+", "✗": "x"}
"""The same where the encoding has not even that."""

codecs.register_error("linkwright.replace", _replaced)


@contextmanager
def read_or_not() -> Iterator[None]:
    """What is printed may go into a pipe whose reader has left (``linkwright run FILE | head``): then all is done."""
    try:
        yield
        sys.stdout.flush()
    except BrokenPipeError:
        _discard()


def failed(error: OSError) -> int:
    """Tell in one line that the system refuses something, such as to print; gives the exit code."""
    if error.filename is not None:
        text = say("cli.system-file", file=error.filename, reason=reason(error))
    else:
        text = say("cli.system-output" if error.errno in FULL else "cli.system", reason=reason(error))
    with suppress(OSError):
        click.echo(line(text), err=True)
    _discard()
    return CANNOT


def interrupted(stop: KeyboardInterrupt) -> int:
    """Tell in one line that the user stopped the program, and how to go on where a study can; gives the exit code."""
    click.echo(line(str(getattr(stop, "what", None) or say("cli.interrupted"))), err=True)
    return 130


def misused(error: click.ClickException) -> int:
    """Tell what is wrong with the arguments, which are quoted; gives the exit code."""
    stream = io.StringIO()
    if isinstance(error, click.MissingParameter):  # its sentence ends in a full stop of its own
        text = say("cli.missing", what=error.format_message().removesuffix("."))
        error = click.UsageError(text, error.ctx)
    error.message = line(error.message)  # type: ignore[misc]
    error.show(stream)
    click.echo(visible(stream.getvalue()), err=True, nl=False)
    return CANNOT


def _discard() -> None:
    """Let nothing come of what the buffers still hold: the interpreter would complain of it at its end."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    for stream in (sys.stdout, sys.stderr):
        os.dup2(nowhere, stream.fileno())
