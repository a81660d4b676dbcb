"""Ctrl-C at any moment: an interrupt waits where it would come out as another error, or get lost.

An import may turn it into an ImportError, and a module that tries what it can import passes over that. Some modules of
ruamel.yaml pass over it by a bare ``except:``. That of pydantic turns one that comes while it builds a validator into
an error of the schema. Of a finalizer, Python prints what it raises and goes on.
"""

from __future__ import annotations

import contextlib
import os
import signal
import sys
import threading
from types import FrameType
from typing import Any

SWALLOWING = ("ruamel/yaml/comments.py", "ruamel/yaml/serializer.py", "ruamel/yaml/tokens.py")
"""Ends of the names of files that pass over an interrupt."""
TURNING = ("pydantic/_internal/_model_construction.py", "pydantic/type_adapter.py")
"""Those that turn it into another error."""
DEAF = ("<frozen importlib._bootstrap>", *(name.replace("/", os.sep) for name in (*SWALLOWING, *TURNING)))
"""Ends of the names of files in whose calls no interrupt is raised."""
AGAIN = 0.02
"""Seconds after which an interrupt that can't be raised comes again."""


def install() -> None:
    """Take over interrupts, unless the process is told to handle or ignore them otherwise."""
    if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
        signal.signal(signal.SIGINT, handle)
        sys.unraisablehook = _unraisable


def end() -> None:
    """Nothing is left to be done: an interrupt ends the process at once."""
    with contextlib.suppress(KeyboardInterrupt):  # one that came while it was done
        if signal.getsignal(signal.SIGINT) is handle:
            signal.signal(signal.SIGINT, signal.SIG_DFL)


def handle(number: int, frame: FrameType | None) -> None:
    """Raise KeyboardInterrupt, as soon as it can't get lost."""
    while frame is not None:
        if frame.f_code.co_filename.endswith(DEAF):
            return _come_again()
        frame = frame.f_back
    raise KeyboardInterrupt


def _come_again() -> None:
    timer = threading.Timer(AGAIN, signal.raise_signal, [signal.SIGINT])
    timer.daemon = True
    timer.start()


def _unraisable(found: Any) -> None:
    if issubclass(found.exc_type, KeyboardInterrupt):
        _come_again()
    else:
        sys.__unraisablehook__(found)
