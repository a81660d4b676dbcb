"""A study by itself: that of a file, or one stated in Python."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import closing, contextmanager
from pathlib import Path
from types import MappingProxyType
from typing import Any

from linkwright.app.job import Examined, Writing, carry_out, examine_document, read_file, read_model
from linkwright.blocks import RUNNERS, Runner
from linkwright.exports import TARGETS
from linkwright.findings import Finding, Joined, Term, raise_errors
from linkwright.model.document import Document, parse_document, plain
from linkwright.studies import STUDIES, RunContext


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


def examine_alone(path: Path, study: str, given: Mapping[str, Any] = MappingProxyType({})) -> Examined:
    """Read and compile a model file for one study alone, with the options ``given`` in place of the file's."""
    read = read_file(path)
    if read.document is None:
        return read
    return examine_one(read.document, path.parent, study, given).read_from(read)


def placed(path: Path, study: str, values: Mapping[tuple[str, ...], Any]) -> dict[str, Any]:
    """The options of a file's study that change where ``values`` stand at their places within them."""
    deep = any(len(place) > 1 for place in values)  # only then it matters what the file says beside
    document = read_file(path).document if deep else None
    options = (document.studies.get(study) or {}) if document is not None else {}
    changed: dict[str, Any] = {}
    for (first, *rest), value in values.items():
        inner = changed[first] = value if not rest else dict(options.get(first) or {})
        for key in rest[:-1]:
            inner[key] = inner = dict(inner.get(key) or {})
        if rest:
            inner[rest[-1]] = [*value] if isinstance(value, tuple) else value
    return changed


_SECTIONS: dict[str, tuple[str, str, Mapping[str, Any]]] = {
    "studies": ("study.missing", "only", STUDIES),
    "exports": ("export.missing", "to", TARGETS),
}
"""The sections of which one entry can be asked for: the finding where the file doesn't have it, the key of
:func:`~linkwright.app.job.examine_document`, the registry."""

_LACKING = {"file.missing", "cam.none", "tolerance.none"}
"""Of a study that the file doesn't have, what says that it needs more than options of its own."""


def examine_one(
    document: Document,
    folder: Path | None,
    name: str,
    given: Mapping[str, Any],
    without: Sequence[str] = (),
    section: str = "studies",
) -> Examined:
    """Compile a document for one study, or one export, with the options ``given`` in place of its own and ``without``
    some of these. Where it has none and can't do without, that is the finding, with an example."""
    code, key, known = _SECTIONS[section]
    examined = examine_document(altered(document, name, given, without, section), folder, **{key: name})
    own = getattr(document, section)
    lacking = [f for f in examined.findings if f.code in _LACKING and f.path == (section, name)]
    if lacking and name not in own:
        data = {"name": name, "has": Joined(own) or Term("none"), "example": known[name].example}
        rest = [f for f in examined.findings if f not in lacking or f.code != "file.missing"]
        examined.findings = [Finding(code, (section,), data), *rest]
    return examined


def perform_alone(
    model: str | Path | Document,
    study: str,
    given: Mapping[str, Any],
    without: Sequence[str] = (),
    *,
    out: str | Path | None = None,
    folder: str | Path | None = None,
    workers: int | None = None,
    cluster: str | None = None,
    fresh: bool = False,
    force: bool = False,
) -> Any:
    """The outcome of one study with the options ``given`` in place of the file's, and ``without`` some of these. Raises
    :class:`ModelError` with all findings."""
    read = read_model(model, folder)
    assert read.document is not None
    examined = examine_one(read.document, read.folder, study, given, without)
    if read.file is not None:
        examined.read_from(read)
    target = Path(out) if out is not None else None
    with runner_of(workers, cluster) as runner:
        job = carry_out(examined, RunContext(out=target, runner=runner, fresh=fresh), Writing(force=force))
    raise_errors(examined.findings)
    if job.stopped is not None:
        raise job.stopped
    return job.outcomes[study]


def altered(
    document: Document, name: str, given: Mapping[str, Any], without: Sequence[str] = (), section: str = "studies"
) -> Document:
    """The document with other options of a study, or of an export; what is ``None`` isn't given."""
    data = plain(document)
    entries = data.setdefault(section, {})
    options = {key: value for key, value in entries.get(name, {}).items() if key not in without}
    entries[name] = options | {key: _listed(value) for key, value in given.items() if value is not None}
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
