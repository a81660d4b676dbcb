"""Where the program begins: interrupts are taken over before anything else is imported."""

from __future__ import annotations

import atexit
import gc
import os
import sys

from linkwright.interrupts import end, install


def main() -> None:
    """The program ``linkwright``."""
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # its matrices are small: more threads would wait, and cost time
    gc.set_threshold(300_000, 20, 100)  # nearly all objects of a run stay: looking for garbage takes a twentieth of it
    atexit.register(gc.freeze)  # the process ends with all that it holds: none of it is looked through for garbage
    try:
        install()
        from linkwright.cli import main as carry_out

        carry_out()
    except KeyboardInterrupt as stop:  # before or after what the command line itself does
        from linkwright.cli.streams import interrupted

        sys.exit(interrupted(stop))
    finally:
        end()


if __name__ == "__main__":
    main()
