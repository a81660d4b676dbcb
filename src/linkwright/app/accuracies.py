"""The accuracy study by itself: that of a file, or one stated in Python."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from linkwright.app.single_study import perform_alone
from linkwright.model.document import Document
from linkwright.studies.accuracy.outcome import AccuracyOutcome


def accuracy(
    model: str | Path | Document,
    outputs: Sequence[str] | None = None,
    samples: int | None = None,
    *,
    plan: str | None = None,
    seed: int | None = None,
    poses: int | None = None,
    kernel: str | None = None,
    options: Mapping[str, Any] | None = None,
    out: str | Path | None = None,
    folder: str | Path | None = None,
    workers: int | None = None,
    cluster: str | None = None,
    fresh: bool = False,
    force: bool = False,
) -> AccuracyOutcome:
    """What the tolerances and clearances of a mechanism do to its outputs: measures by name, signals, expressions.

    What isn't given is that of the file's study ``accuracy``; ``options`` are further keys of it, written as there:
    ``{"general": "ISO 2768-m", "positions": {"far": "max E.x"}}``. ``samples`` are random, 0 for none. The span is
    that of the file's cycle. With ``out``, a folder, files are written there, and an interrupted study is gone on
    with, unless ``fresh``; files that linkwright didn't write are overwritten only with ``force``. ``workers`` are
    threads of this process, ``cluster`` is the address of a Dask scheduler. Raises :class:`ModelError` with all
    findings.
    """
    given = {"outputs": outputs, "samples": samples, "plan": plan, "seed": seed, "poses": poses, "kernel": kernel}
    outcome = perform_alone(
        model,
        "accuracy",
        {**(options or {}), **{key: value for key, value in given.items() if value is not None}},
        out=out,
        folder=folder,
        workers=workers,
        cluster=cluster,
        fresh=fresh,
        force=force,
    )
    assert isinstance(outcome, AccuracyOutcome)
    return outcome
