"""Command lines of linkwright in forks of one process that has imported it: JSON lines with a folder, a path and words
come in by standard input; exit code, standard output and standard error of each leave by standard output."""

from __future__ import annotations

import json
import os
import sys
import tempfile
from pathlib import Path
from typing import Any, NoReturn


def main() -> None:
    import linkwright.app
    import linkwright.cli
    import linkwright.exports
    import linkwright.report

    assert linkwright.cli
    for line in sys.stdin:
        asked = json.loads(line)
        with tempfile.TemporaryDirectory() as said:
            out, err = Path(said, "out"), Path(said, "err")
            if (child := os.fork()) == 0:
                perform(asked, out, err)
            _, status = os.waitpid(child, 0)
            answer = [os.waitstatus_to_exitcode(status), *(f.read_text(encoding="utf-8") for f in (out, err))]
        sys.__stdout__.write(json.dumps(answer) + "\n")
        sys.__stdout__.flush()


def perform(asked: dict[str, Any], out: Path, err: Path) -> NoReturn:
    """One command line, in the fork."""
    import traceback

    from linkwright.cli import main as command

    code = 1
    for number, file in ((1, out), (2, err)):
        os.dup2(os.open(file, os.O_WRONLY | os.O_CREAT), number)
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
