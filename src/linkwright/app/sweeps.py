"""A sweep by itself: that of a file, or one stated in Python."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import closing, contextmanager
from pathlib import Path
from typing import Any

from linkwright.app.job import Examined, examine_document, perform, read_file, write
from linkwright.blocks import RUNNERS, Runner
from linkwright.model.document import load, parse_document, plain
from linkwright.model.findings import raise_errors
from linkwright.model.mechanism import Document
from linkwright.studies import Site, SweepOutcome


@contextmanager
def runner_of(workers: int | None = None, cluster: str | None = None) -> Iterator[Runner | None]:
    """Threads of this process, so many of them, or the workers of a Dask cluster by its address; else the study's own
    choice."""
    if cluster is None and workers is None:
        yield None
        return
    runner: Runner = RUNNERS["threads"](workers) if cluster is None else RUNNERS["cluster"](cluster)  # type: ignore[call-arg]
    with closing(runner):
        yield runner


def examine_sweep(path: Path, kernel: str | None = None) -> Examined:
    """Read and compile a model file for its sweep alone, to be computed by ``kernel`` where one is given."""
    read = read_file(path)
    if read.document is None:
        return read
    examined = examine_document(_with(read.document, {"kernel": kernel}), path.parent, only="sweep")
    examined.source = read.source
    examined.findings = examined.located(examined.findings)
    return examined


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
) -> SweepOutcome:
    """Many samples of a mechanism's parameters: the measures of each, its signals reduced at each pose.

    What isn't given is that of the file's study ``sweep``; with another ``vary`` its ``plan`` and ``samples`` don't
    count. ``vary`` is written as there:
    ``{"AB": {"from": 150, "to": 160, "count": 11}, "BC": {"normal": 395, "sigma": 0.02}, "CD": [295, 300, 305]}``.
    The span is that of the file's cycle. With ``out``, a folder, files are written there, and an interrupted sweep is
    gone on with, unless ``fresh``. ``workers`` are threads of this process, ``cluster`` is the address of a Dask
    scheduler. Raises :class:`ModelError` with all findings.
    """
    document = model if isinstance(model, Document) else load(model)
    tables = Path(folder) if folder else None if isinstance(model, Document) else Path(model).parent
    given = {"vary": vary, "outputs": outputs, "samples": samples, "plan": plan, "seed": seed, "poses": poses}
    given |= {"keep": keep, "histogram": histogram, "kernel": kernel}
    examined = examine_document(_with(document, given), tables, only="sweep")
    raise_errors(examined.findings)
    target = Path(out) if out is not None else None
    with runner_of(workers, cluster) as runner:
        job = perform(examined, Site(out=target, runner=runner, fresh=fresh))
    raise_errors(examined.findings)
    if target is not None:
        write(job, target)
    assert job.sweep is not None
    return job.sweep


def _with(document: Document, given: Mapping[str, Any]) -> Document:
    """The document with other options of its sweep."""
    data = plain(document)
    options = data.setdefault("studies", {}).setdefault("sweep", {})
    if given.get("vary") is not None:  # those of the file belong to its own parameters
        options = data["studies"]["sweep"] = {k: v for k, v in options.items() if k not in ("plan", "samples")}
    options |= {key: _listed(value) for key, value in given.items() if value is not None}
    made = parse_document(data)
    assert made is not None
    return made


def _listed(value: Any) -> Any:
    """NumPy's arrays and numbers as plain ones."""
    if isinstance(value, Mapping):
        return {key: _listed(entry) for key, entry in value.items()}
    if isinstance(value, str) or not hasattr(value, "__iter__"):
        return value
    return [_listed(entry) for entry in value]
