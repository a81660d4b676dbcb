"""From the faults that validation finds in plain data to findings."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from linkwright.model import actions as a
from linkwright.model import elements as e
from linkwright.model import motions as m
from linkwright.model import parts as p
from linkwright.model.absent import absent
from linkwright.model.cams import Cam
from linkwright.model.findings import Finding, Term
from linkwright.model.mechanism import Document
from linkwright.model.tolerances import Stated
from linkwright.model.unknown import near
from linkwright.model.written import Frozen, describe
from linkwright.model.yaml_text import Path, Source

_CLASSES: dict[str, type[Frozen]] = {
    "units": p.Units,
    "parameters": p.Parameter,
    "plane": p.Plane,
    "links": p.Link,
    "joints": p.Joint,
    "cylinders": p.Cylinder,
    "drives": p.Drive,
    "tables": a.Table,
    "laws": m.MotionLaw,
    "cams": Cam,
    "loads": a.Load,
    "springs": e.Spring,
    "counterweights": e.Counterweight,
    "measures": a.Measure,
}

_WANTED = {
    "dict_type": "mapping", "model_type": "mapping", "model_attributes_type": "mapping",
    "string_type": "text", "tuple_type": "list", "list_type": "list",
}  # fmt: skip


def findings_of(faults: Iterable[Any], source: Source) -> list[Finding]:
    """Pydantic's errors as findings with lines; what the reader of the text has named already is left out."""
    found: dict[tuple[Any, ...], Finding] = {}
    for fault in faults:
        finding = _finding(fault, source.data)
        if not any(_nested(finding.path, bad) for bad in source.spoilt):
            line = source.line(finding.path)
            found.setdefault((finding.path, finding.code, str(finding.data)), finding.located(line))
    elsewhere = {finding.path[:2] for finding in found.values() if finding.code.startswith("element.")}
    return [f for f in found.values() if f.path[:2] not in elsewhere or f.code not in _FOLLOWING]


_FOLLOWING = {"file.unknown-key", "joint.kind", "drive.kind", "drive.law", "drive.on", "load.empty", "spring.ends"}
"""What else is wrong with an entry that stands for an element which there isn't: it follows from that."""


def _nested(path: Path, other: Path) -> bool:
    """Whether one of two places lies in the other."""
    both = min(len(path), len(other))
    return bool(path) and path[:both] == other[:both]


def written(loc: tuple[Any, ...], data: Any) -> Path:
    """The place in the file: pydantic's, without the names of its branches and of what isn't written."""
    path: list[Any] = []
    for key in loc:
        inside = range(len(data)) if isinstance(data, list | tuple) else data if isinstance(data, Mapping) else ()
        if key in inside:
            data = data[key]
            path.append(key)
    return tuple(path)


def _finding(fault: Any, data: Any) -> Finding:
    context, kind, path = dict(fault.get("ctx") or {}), fault["type"], written(fault["loc"], data)
    named = absent(path[-1], fault["input"]) if kind == "extra_forbidden" and path else None
    if kind in _WANTED and path[:1] == ("joints",):
        named = absent("type", fault["input"])
    if named and (named[0] != "element.limits" or path[0] in ("joints", "cylinders")):  # limits are a study, too
        return Finding(named[0], path, {"name": named[1]})
    if kind == "finding":
        return Finding(context.pop("code"), path, context)
    if kind == "missing":
        name = str(fault["loc"][-1])
        return Finding("file.missing", path, {"name": name, "known": ", ".join(known_keys((*path, name)))})
    if kind == "extra_forbidden":
        name = str(path[-1])
        return Finding("file.unknown-key", path, {"name": name[:60], "near": near(name, known_keys(path))})
    wanted: Any = context.get("expected") if kind == "literal_error" else Term(_WANTED.get(kind, "other"))
    return Finding("file.expected", path, {"wanted": wanted, "given": describe(fault["input"])})


def known_keys(path: Path) -> list[str]:
    """The keys that may stand beside the last one of a path."""
    inside = path[0] == "parameters" and "tolerance" in path[2:-1]
    segment = path[0] == "laws" and "segments" in path[2:-1]
    owner = Stated if inside else m.Segment if segment else Document if len(path) == 1 else _CLASSES.get(str(path[0]))
    if owner is None:
        return []
    return [field.alias or name for name, field in owner.model_fields.items()]
