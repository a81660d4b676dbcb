"""Model files to documents and back."""

from __future__ import annotations

import json
import os
import tempfile
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from linkwright.model.findings import Finding, ModelError
from linkwright.model.mechanism import Document
from linkwright.model.yaml_text import MAX_FINDINGS, Source, read_text, write_text


def read_document(raw: bytes) -> tuple[Document | None, Source]:
    """A document from a file's bytes; the source holds the line marks and all findings of form."""
    source = read_text(raw)
    if source.findings:
        return None, source
    if not isinstance(source.data, dict):
        source.findings.append(Finding("file.mapping", line=1))
        return None, source
    if "linkwright" not in source.data:
        source.findings.append(Finding("file.version", line=1))
    document = parse_document(source.data, source)
    return (None if source.findings else document), source


def parse_document(data: dict[str, Any], source: Source) -> Document | None:
    """A document from plain data; faults become findings in ``source``."""
    try:
        return Document.model_validate(data)
    except ValidationError as error:
        known = {}
        for fault in error.errors(include_url=False):
            finding = _finding(fault, source)
            known.setdefault((finding.path, finding.code), finding)
        source.findings += list(known.values())[:MAX_FINDINGS]
        return None


def load(path: str | Path) -> Document:
    """The document in a model file. Raises :class:`ModelError` with all findings of form, OSError if unreadable."""
    document, source = read_document(Path(path).read_bytes())
    if document is None:
        raise ModelError(source.findings)
    return document


def dump(document: Document) -> str:
    """The document as the text of a model file; expressions and units stand as they were written."""
    return write_text(plain(document))


def plain(document: Document) -> dict[str, Any]:
    """The document as plain data, in the file's order."""
    data = document.model_dump(exclude_defaults=True, by_alias=True)
    data["parameters"] = {
        name: entry["value"] if set(entry) == {"value"} else entry for name, entry in data.get("parameters", {}).items()
    }
    ordered = {"linkwright": 1, **{key: value for key, value in data.items() if value not in ({}, None)}}
    return json.loads(json.dumps(ordered))  # type: ignore[no-any-return]


def save(document: Document, path: str | Path) -> None:
    """Write a model file, aside first and then renamed, so that no half-written file is left."""
    write_aside(Path(path), dump(document))


def write_aside(path: Path, text: str) -> None:
    """Write ``text`` to ``path`` whole or not at all."""
    handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
    try:
        with os.fdopen(handle, "w", encoding="utf-8", newline="\n") as stream:
            stream.write(text)
        Path(name).chmod(0o644)
        Path(name).replace(path)
    except BaseException:
        Path(name).unlink(missing_ok=True)
        raise


# Pydantic's own faults, as findings of ours.
_FAULTS = {"missing": "file.missing", "extra_forbidden": "file.unknown-key"}


def _finding(fault: Any, source: Source) -> Finding:
    path = tuple(key for key in fault["loc"] if not _is_branch(key))
    context = dict(fault.get("ctx") or {})
    if fault["type"] == "finding":
        code = context.pop("code")
        return Finding(code, path, context, source.line(path))
    code = _FAULTS.get(fault["type"], "file.expected")
    key = str(path[-1]) if path else ""
    data = {"key": key, "known": _known_keys(path)}
    if code == "file.expected":
        from linkwright.model.fields import describe

        data = {"wanted": _wanted(fault), "given": describe(fault["input"])}
    return Finding(code, path, data, source.line(path))


def _is_branch(key: Any) -> bool:
    """Whether a part of pydantic's place names a branch of a union and no entry of the file."""
    return isinstance(key, str) and (key == "[key]" or "[" in key or key in ("Expression", "Position", "str"))


def _wanted(fault: Any) -> str:
    names = {
        "dict_type": "a mapping", "model_type": "a mapping", "model_attributes_type": "a mapping",
        "tuple_type": "a list", "list_type": "a list", "string_type": "a word", "literal_error": "one of the known words",
        "too_short": "a longer list", "too_long": "a shorter list",
    }  # fmt: skip
    if fault["type"] == "literal_error":
        return str(fault["ctx"]["expected"])
    return names.get(fault["type"], fault["msg"])


def _known_keys(path: tuple[str | int, ...]) -> str:
    """The keys that may stand beside a wrong one."""
    from linkwright.model import mechanism as m

    sections: dict[Any, Any] = {
        "links": m.Link, "joints": m.Joint, "drives": m.Drive, "tables": m.Table, "loads": m.Load,
        "measures": m.Measure, "parameters": m.Parameter,
    }  # fmt: skip
    owner = m.Document if len(path) == 1 else m.Units if path[0] == "units" else sections.get(path[0])
    if owner is None:
        return ""
    return ", ".join(field.alias or name for name, field in owner.model_fields.items())
