"""Where a study is performed: what it may know of the file, the folder, and the one who waits for it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from linkwright.data_classes import dataclass
from linkwright.model.document import Document

if TYPE_CHECKING:
    from linkwright.blocks import Progress, Runner


@dataclass(frozen=True)
class RunContext:
    """Around a study.

    ``document`` is the file, ``folder`` where its tables lie. Into ``out`` go files that are too large for memory, and
    what an interrupted study needs to go on, and ``keep`` is told of each of these, with the study's name, before it is
    made; ``fresh`` begins anew all the same. ``runner`` performs large work (as many threads of this process as are of
    use where there is none), ``progress`` is told how far it is.
    """

    document: Document | None = None
    folder: Path | None = None
    out: Path | None = None
    runner: Runner | None = None
    progress: Progress | None = None
    fresh: bool = False
    keep: Callable[[Path, str], None] = lambda path, study: None


NOWHERE = RunContext()
"""Nothing is known, nothing outlasts the process."""
