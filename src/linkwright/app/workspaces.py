"""The workspace study by itself: that of a file, or one stated in Python."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from linkwright.app.single_study import perform_alone
from linkwright.model.document import Document
from linkwright.studies.workspace.outcome import WorkspaceOutcome


def workspace(
    model: str | Path | Document,
    point: str | None = None,
    values: Mapping[str, Sequence[Any]] | None = None,
    *,
    modes: str | None = None,
    drives: Mapping[str, Sequence[Any]] | None = None,
    chord: float | None = None,
    options: Mapping[str, Any] | None = None,
    out: str | Path | None = None,
    folder: str | Path | None = None,
    fresh: bool = False,
    force: bool = False,
) -> WorkspaceOutcome:
    """Where a point gets to with two drives, in each assembly mode.

    What isn't given is that of the file's study ``workspace``: ``values`` of parameters (its key ``for``), as
    ``{"alpha": [0, 60, 90]}``; ``options`` are further keys of it, written as there, ``None`` for what is to be left
    out. With ``out``, a folder, files are written there, over those that linkwright didn't write only with ``force``,
    and an interrupted study is resumed, unless ``fresh``: regions that it has found aren't computed again. Raises
    :class:`ModelError` with all findings.
    """
    given = {"point": point, "for": values, "modes": modes, "drives": drives, "chord": chord}
    stated = {key: value for key, value in given.items() if value is not None}
    every = {**(options or {}), **stated}
    without = [key for key, value in every.items() if value is None]
    outcome = perform_alone(model, "workspace", every, without, out=out, folder=folder, fresh=fresh, force=force)
    assert isinstance(outcome, WorkspaceOutcome)
    return outcome
