"""Where the program begins: interrupts are taken over before anything else is imported."""

from __future__ import annotations

import gc
import os
import sys

from linkwright.interrupts import end, install


def main() -> None:
    """The program ``linkwright``."""
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # its matrices are small: more threads would wait, and cost time
    os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "__all__")  # it would look for them in all installed packages
    gc.set_threshold(500_000, 5, 100)  # nearly all objects of a run stay: garbage is hardly ever worth looking for
    try:
        install()
        from linkwright.cli import main as carry_out

        carry_out()
    except KeyboardInterrupt as stop:  # before or after what the command line itself does
        from linkwright.cli.streams import interrupted

        sys.exit(interrupted(stop))
    finally:
        end()
        gc.freeze()  # the process gives all back at once: no garbage is looked for in it, which takes a tenth of a run


if __name__ == "__main__":
    main()
