"""Command lines of linkwright in forks of one process that has imported it, as starting takes longest.

Lines of JSON come in by standard input: ``folder``, ``path`` (places before Python's own), ``words``, the ``seconds``
that it may take, and maybe ``environment`` (variables to set) and ``merged`` (standard error in standard output). A
line of JSON leaves for each: exit code (negative where a signal ended it), standard output, standard error. Only where
processes are forked.

    forked_commands.py [MODEL]

A model is run at the start: all that is imported and read once for commands is there then. Kinds of other packages are
found by the first command, so that a ``path`` to some needs a process without a model.
"""

import contextlib
import gc
import io
import json
import os
import signal
import sys
import tempfile
import traceback
from pathlib import Path
from typing import Any, NoReturn


def main() -> None:
    """Perform what comes until nothing does."""
    import linkwright.app
    import linkwright.cli
    import linkwright.exports
    import linkwright.report  # noqa: F401  (all that commands import)

    for model in sys.argv[1:]:
        warm_up(model)
    gc.freeze()  # what is there stays
    for line in sys.stdin:
        with tempfile.TemporaryDirectory() as folder:
            said = Path(folder, "out"), Path(folder, "err")
            if (child := os.fork()) == 0:
                perform(json.loads(line), *said)
            _, status = os.waitpid(child, 0)
            texts = (file.read_text(encoding="utf-8", errors="replace") for file in said)
            print(json.dumps([os.waitstatus_to_exitcode(status), *texts]), flush=True)


def warm_up(model: str) -> None:
    """Run a model, of which nothing is kept."""
    from linkwright.cli import main as command

    with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()) as said:
        sys.argv = ["linkwright", "run", model, "--out", str(Path(folder, "out"))]
        try:
            command()
        except SystemExit as done:
            if done.code:
                raise SystemExit(f"{model} can't be run:\n{said.getvalue()}") from None


def perform(asked: dict[str, Any], out: Path, err: Path) -> NoReturn:
    """One command line, in the fork."""
    from linkwright.__main__ import main as command

    signal.alarm(int(asked["seconds"]))
    code = 1
    for number, file in ((1, out), (2, err)):
        os.dup2(os.open(file, os.O_WRONLY | os.O_CREAT), number)
    if asked.get("merged"):
        os.dup2(1, 2)
    os.environ.update(asked.get("environment", {}))
    os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
    try:
        os.chdir(asked["folder"])
        sys.path[:0] = asked["path"]
        sys.argv = ["linkwright", *asked["words"]]
        command()
        code = 0
    except SystemExit as done:
        code = done.code if isinstance(done.code, int) else int(bool(done.code))
    except BaseException:
        traceback.print_exc()
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(code)


if __name__ == "__main__":
    main()
