"""Many symbols made at once."""

from __future__ import annotations

import gc
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def without_collection() -> Iterator[None]:
    """Make many symbols without Python's search for cycles, of which symbols have none: it would look through all of
    them again and again, which takes longer than making them. A decorator, too."""
    enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if enabled:
            gc.enable()
