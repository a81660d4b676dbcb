"""Where the program begins: interrupts are taken over before anything else is imported."""

from __future__ import annotations

import sys

from linkwright.interrupts import end, install


def main() -> None:
    """The program ``linkwright``."""
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
