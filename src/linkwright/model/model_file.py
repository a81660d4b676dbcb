"""A model file as it is read: its document, or everything that keeps it from being one."""

from __future__ import annotations

from dataclasses import field
from pathlib import Path

from linkwright import gallery
from linkwright.data_classes import dataclass
from linkwright.expressions.unknown import likeliest, proposed
from linkwright.findings import Finding, ModelError, Term, reason
from linkwright.model.document import Document, read_document
from linkwright.model.input_files import read_at_most
from linkwright.model.yaml_text import MAX_BYTES, Source


@dataclass(frozen=True)
class ModelFile:
    """What a model file holds: its bytes (``None`` where it can't be read), its document with the lines of its parts,
    or the findings that say why there is none; remarks on its text are findings too."""

    content: bytes | None = None
    document: Document | None = None
    source: Source = field(default_factory=Source)
    findings: tuple[Finding, ...] = ()


def read_model_file(path: Path) -> ModelFile:
    """Read a model file, without looking into what it describes."""
    try:
        raw = read_at_most(path, MAX_BYTES)
    except ModelError as error:
        return ModelFile(findings=tuple(error.findings))
    except FileNotFoundError:
        data = {"file": str(path), "hint": _other_file(path)}
        return ModelFile(findings=(Finding("file.not-found", data=data),))
    except (OSError, ValueError) as error:
        data = {"file": str(path), "reason": reason(error)}
        return ModelFile(findings=(Finding("file.unreadable", data=data),))
    document, source = read_document(raw)
    return ModelFile(raw, document, source, (*source.findings, *source.remarks))


def _other_file(path: Path) -> Term:
    """What may be meant by the name of a file that isn't there: one beside it, a model of the gallery."""
    if path.stem in gallery.names():
        return Term("gallery-model", name=path.stem)
    beside = {other.stem: other.name for other in sorted(path.parent.glob("*.y*ml"))} if path.parent.is_dir() else {}
    found = likeliest(path.stem, [*beside])
    return proposed([beside[stem] for stem in found]) if found else Term("file-name")
