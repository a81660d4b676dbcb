"""Documents: a mechanism with what is asked of it, as one model file; from files and back."""

from __future__ import annotations

import json
import warnings
from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import AfterValidator, BeforeValidator, Field, ValidationError

from linkwright.elements.fields import freeze
from linkwright.expressions.fields import FrozenDict, Name, Text, fault, frozen
from linkwright.expressions.unknown import near
from linkwright.expressions.written import describe, unexpected
from linkwright.findings import Finding, ModelError, Term, capped
from linkwright.model.copies import with_copies
from linkwright.model.faults import findings_of
from linkwright.model.input_files import read_at_most
from linkwright.model.mechanism import MAX_ENTRIES, Mechanism, at_most
from linkwright.model.output_files import write_aside
from linkwright.model.pins import pins
from linkwright.model.plane import in_plane
from linkwright.model.sketch import with_sketch
from linkwright.model.yaml_text import MAX_BYTES, MAX_FINDINGS, Source, read_text
from linkwright.model.yaml_write import write_text

VERSION = 1
"""The version of the file format."""
_bound = at_most(MAX_ENTRIES)


def _options(raw: Any) -> Any:
    if not isinstance(raw, Mapping):
        raise unexpected("mapping", raw)
    return frozen(raw)


def _version(raw: Any) -> Any:
    if isinstance(raw, bool) or not isinstance(raw, int) or raw != VERSION:
        raise fault("file.version", given=describe(raw), known=VERSION)
    return raw


Options = Annotated[dict[str, Any], BeforeValidator(_options), AfterValidator(FrozenDict)]


class Document(Mechanism):
    """A model file: a mechanism and the raw options of its studies and exports."""

    linkwright: Annotated[Literal[1], BeforeValidator(_version)] = 1
    studies: Annotated[dict[Name, Options], _bound, freeze] = Field(default_factory=FrozenDict)
    exports: Annotated[dict[Text, Options], _bound, freeze] = Field(default_factory=FrozenDict)

    def __repr__(self) -> str:
        m = with_copies(self).mechanism
        joints = sum(len(pin.links) - 1 for pin in pins(m).values()) + sum(1 for _ in m.joints_but_pins())
        return f"<{type(self).__name__} {self.title!r}: links {len(m.links)}, joints {joints}>"

    __str__ = __repr__

    def replace(self, **parameters: float | str) -> Document:
        """The same document with other values of some parameters, numbers or expressions as in a file.

        The lengths derived from a sketch are parameters too.

        Raises :class:`ModelError` for a name that is no parameter or a value that can't be read.
        """
        return replaced(self, parameters)


def read_document(raw: bytes) -> tuple[Document | None, Source]:
    """A document from a file's bytes; the source holds the line marks and all findings of form."""
    document, source = _read(raw)
    if source.findings and source.text is not None:
        from linkwright.model.respelled_lines import read_respelled

        source.findings = read_respelled(source.text, source.findings, lambda text: _read(text.encode())[1].findings)
    source.findings = capped(sorted(source.findings, key=lambda finding: finding.line or 0), MAX_FINDINGS)
    return (None if source.findings else document), source


def _read(raw: bytes) -> tuple[Document | None, Source]:
    """The same of the text as it stands, with all its findings in any order."""
    source = read_text(raw)
    document = None
    if isinstance(source.data, dict):
        if "linkwright" not in source.data:
            source.findings.append(Finding("file.version", data={"given": Term("nothing"), "known": VERSION}, line=1))
        document = parse_document(source.data, source)
    elif not source.findings:
        source.findings.append(Finding("file.mapping", line=1))
    return document, source


def parse_document(data: dict[str, Any], source: Source | None = None) -> Document | None:
    """A document from plain data; faults become findings in ``source``, or :class:`ModelError` without one."""
    try:
        return Document.model_validate(data)
    except ValidationError as error:
        found = findings_of(error.errors(include_url=False), source or Source(data), Document)
        if source is None:
            raise ModelError(capped(found, MAX_FINDINGS)) from None
        source.findings += found
        return None


def located(findings: Iterable[Finding], source: Source) -> list[Finding]:
    """Findings with the lines of their elements, in the file's order, notes last."""
    found = [_located(finding, source) for finding in findings]
    return sorted(found, key=lambda finding: (finding.severity == "note", finding.line or 0))


def _located(finding: Finding, source: Source) -> Finding:
    if (other := finding.other) is not None and other.line is None:
        finding = replace(finding, other=replace(other, line=source.line(other.path)))
    return finding if finding.line else finding.located(source.line(finding.path))


def load(path: str | Path) -> Document:
    """The document in a model file; what is remarked on its text, such as another encoding than UTF-8, is a warning of
    Python.

    Raises :class:`ModelError` with all findings of form, OSError where the file can't be read.
    """
    document, source = read_document(read_at_most(Path(path), MAX_BYTES))
    if document is None:
        raise ModelError(source.findings)
    for remark in source.remarks:
        warnings.warn(f"{path}: {remark}", stacklevel=2)
    return document


def replaced(document: Document, parameters: Mapping[str, Any]) -> Document:
    """The document with other values of some parameters; see :meth:`Document.replace`."""
    data, placed = plain(document), with_copies(document)
    declared = with_sketch(in_plane(placed.mechanism).mechanism).parameters
    unknown = [name for name in parameters if name not in declared]
    if unknown:
        raise ModelError(
            Finding("name.unknown-parameter", ("parameters", name), {"name": name, "near": near(name, [*declared])})
            for name in unknown
        )
    for name, value in parameters.items():
        *owner, name = placed.parameter_path(name)
        known = data
        for key in owner:
            known = known.setdefault(key, {})
        known[name] = {**entry, "value": value} if isinstance(entry := known.get(name), dict) else value
    made = parse_document(data)
    assert made is not None
    return made


def dump(document: Document) -> str:
    """The document as the text of a model file; expressions and units stand as they were written."""
    if not isinstance(document, Document):
        raise TypeError("dump and save take a document; linkwright.load reads one from a file")
    return write_text(plain(document))


def plain(document: Document) -> dict[str, Any]:
    """The document as plain data, sections and keys in the order of the format."""
    data = document.model_dump(exclude_defaults=True, by_alias=True)
    for name, stated in data.get("subassemblies", {}).items():
        head = {key: stated.pop(key) for key in ("note", "ports") if key in stated}
        data["subassemblies"][name] = {**head, **_short(stated)}
    data = _short(data)
    ordered = {"linkwright": VERSION, **{k: value for k, value in data.items() if value not in ({}, None)}}
    return json.loads(json.dumps(ordered))  # type: ignore[no-any-return]


def _short(sections: dict[str, Any]) -> dict[str, Any]:
    """Sections with the values of parameters alone, where nothing else is said of them."""
    for holder in (sections, *sections.get("copies", {}).values()):
        for name, entry in holder.get("parameters", {}).items():
            if set(entry) == {"value"}:
                holder["parameters"][name] = entry["value"]
    return sections


def save(document: Document, path: str | Path) -> None:
    """Write a model file, aside first and then renamed, so that no half-written file is left; a link is followed."""
    write_aside(Path(path).resolve(), dump(document))
