"""Many command lines of linkwright in one process, as its start takes longest: JSON lists of words come in by standard
input, and of each its exit code, standard output and standard error leave."""

from __future__ import annotations

import io
import json
import sys
from contextlib import redirect_stderr, redirect_stdout


def perform(words: list[str]) -> tuple[int, str, str]:
    """One command line."""
    from linkwright.cli import main

    out, err, code = io.StringIO(), io.StringIO(), 0
    sys.argv = ["linkwright", *words]
    with redirect_stdout(out), redirect_stderr(err):
        try:
            main()
        except SystemExit as done:
            code = int(done.code or 0)
        except Exception as error:  # as a process of its own would show
            err.write(f"Traceback: {error!r}")
            code = 1
    return code, out.getvalue(), err.getvalue()


if __name__ == "__main__":
    print(json.dumps([perform(words) for words in json.load(sys.stdin)]))
