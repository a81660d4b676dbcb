"""A sweep by itself: that of a file, or one stated in Python."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from linkwright.app.single_study import perform_alone
from linkwright.model.document import Document
from linkwright.studies.sweep.outcome import SweepOutcome


def sweep(
    model: str | Path | Document,
    vary: Mapping[str, Any] | None = None,
    outputs: Sequence[str] | None = None,
    samples: int | None = None,
    *,
    plan: str | None = None,
    seed: int | None = None,
    poses: int | None = None,
    keep: str | None = None,
    histogram: int | None = None,
    kernel: str | None = None,
    out: str | Path | None = None,
    folder: str | Path | None = None,
    workers: int | None = None,
    cluster: str | None = None,
    fresh: bool = False,
    force: bool = False,
) -> SweepOutcome:
    """Many samples of a mechanism's parameters: the measures of each, its signals reduced at each pose.

    What isn't given is that of the file's study ``sweep``; with another ``vary`` its ``plan`` and ``samples`` don't
    count. ``vary`` is written as there:
    ``{"AB": {"from": 150, "to": 160, "count": 11}, "BC": {"normal": 395, "sigma": 0.02}, "CD": [295, 300, 305]}``.
    The span is that of the file's cycle. With ``out``, a folder, files are written there, and an interrupted sweep is
    gone on with, unless ``fresh``; files that linkwright didn't write are overwritten only with ``force``. ``workers``
    are threads of this process, ``cluster`` is the address of a Dask scheduler. Raises :class:`ModelError` with all
    findings.
    """
    given = {"vary": vary, "outputs": outputs, "samples": samples, "plan": plan, "seed": seed, "poses": poses}
    given |= {"keep": keep, "histogram": histogram, "kernel": kernel}
    own = () if vary is None else ("plan", "samples")  # those of the file belong to its own parameters
    outcome = perform_alone(
        model, "sweep", given, own, out=out, folder=folder, workers=workers, cluster=cluster, fresh=fresh, force=force
    )
    assert isinstance(outcome, SweepOutcome)
    return outcome
