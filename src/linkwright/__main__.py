"""Where the program begins: interrupts are taken over before anything else is imported."""

from __future__ import annotations

import gc
import os
import sys
from types import ModuleType

from linkwright.interrupts import end, install


def main() -> None:
    """The program ``linkwright``."""
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # its matrices are small: more threads would wait, and cost time
    if os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "__all__") == "__all__":
        _pydantic_without_plugins()
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


def _pydantic_without_plugins() -> None:
    """Stand in for pydantic's search for plugins: it imports what reads all installed packages, a thirtieth of a run,
    before it sees that it isn't to look for any. A pydantic that searches elsewhere is only as slow as it is."""
    search = ModuleType("pydantic.plugin._loader")
    vars(search)["get_plugins"] = tuple
    sys.modules[search.__name__] = search


if __name__ == "__main__":
    main()
