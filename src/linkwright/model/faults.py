"""From the faults that validation finds in plain data to findings."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import replace
from itertools import islice
from typing import Any

from linkwright.expressions.unknown import likeliest, near
from linkwright.expressions.written import describe
from linkwright.findings import Finding, Joined, Term, alternatives
from linkwright.model.absent import SAYS_KIND, absent
from linkwright.model.known_keys import keys_at
from linkwright.model.yaml_text import MAX_FINDINGS, Path, Source

_WANTED = {
    "dict_type": "mapping", "model_type": "mapping", "model_attributes_type": "mapping",
    "string_type": "text", "tuple_type": "list", "list_type": "list",
}  # fmt: skip

MOST = 10 * MAX_FINDINGS
"""More faults than these aren't looked at: each is compared with all that it may mean."""


def findings_of(faults: Iterable[Any], source: Source, owner: Any) -> list[Finding]:
    """Pydantic's errors on data of the type ``owner`` as findings with lines, of very many the first ones; what the
    reader of the text has named already is left out."""
    found: dict[tuple[Any, ...], Finding] = {}
    for fault in islice(faults, MOST):
        finding = _finding(fault, source.data, owner)
        if not any(_nested(finding.path, bad) for bad in source.spoilt):
            line = source.line(finding.path)
            found.setdefault((finding.path, finding.code, str(finding.data)), finding.located(line))
    return _without_followers([*found.values()])


_FOLLOWING = {
    "joint.kind", "joint.line", "joint.at", "drive.kind", "drive.law", "drive.start", "drive.on", "load.empty",
    "spring.ends", "spring.law", "spring.stray", "mass.missing", "mass.incomplete",
    "measure.reduction", "law.way",
}  # fmt: skip
"""What else is wrong with an entry of which a key has another name: it follows from that."""


def _without_followers(findings: list[Finding]) -> list[Finding]:
    """Findings without those that follow from others: from an element which there isn't, from a key of another name."""
    elsewhere = {_entry(f.path) for f in findings if f.code.startswith("element.")}
    keys = [f for f in findings if f.code in ("file.unknown-key", "file.kind")]
    renamed = {(f.path[:-1], name) for f in keys for name in f.data["near"].likely}
    entries = {path for path, _ in renamed}

    def follows(f: Finding) -> bool:
        if f.code == "file.missing":
            return (f.path, f.data["name"]) in renamed
        if _entry(f.path) in elsewhere:
            return f.code in {"file.unknown-key", *_FOLLOWING}
        return f.path in entries and f.code in _FOLLOWING

    return [f for f in findings if not follows(f)]


def _inside(path: Path) -> Path:
    """A place in the sections in which it stands: those of the file or of a sub-assembly."""
    return path[2:] if path[:1] == ("subassemblies",) else path


def _entry(path: Path) -> Path:
    """The entry of a section in which a place lies."""
    return path[: len(path) - len(_inside(path)) + 2]


def _nested(path: Path, other: Path) -> bool:
    """Whether one of two places lies in the other."""
    both = min(len(path), len(other))
    return bool(path) and path[:both] == other[:both]


def written_path(loc: tuple[Any, ...], data: Any) -> Path:
    """The place in the file: pydantic's, without the names of its branches and of what isn't written."""
    path: list[Any] = []
    for key in loc:
        inside = range(len(data)) if isinstance(data, list | tuple) else data if isinstance(data, Mapping) else ()
        if key in inside:
            data = data[key]
            path.append(key)
    return tuple(path)


def _finding(fault: Any, raw: Any, owner: Any) -> Finding:
    context, kind, path = dict(fault.get("ctx") or {}), fault["type"], written_path(fault["loc"], raw)
    elsewhere = kind == "extra_forbidden" and path and not _is_key(path, raw, owner)
    named = absent(path[-1], fault["input"]) if elsewhere else None
    section = _inside(path)[:1]
    within = len(_inside(path)) > 1
    if named and within and section == tuple(named[0].split(".")[1:]):  # what it belongs under is where it stands
        named = None
    if kind in _WANTED and section == ("joints",):
        named = absent("type", fault["input"])
    if named and (named[0] != "element.limits" or {*section} & {"joints", "cylinders"}):  # limits are a study, too
        return Finding(named[0], path, {"name": named[1]})
    if (found := finding_of(fault, raw, owner)) is not None:
        return _with_section(found)
    wanted = _WANTED.get(kind, "other")
    data: dict[str, Any] = {"wanted": Term(wanted), "given": describe(fault["input"]), "hint": Term(f"{wanted}-as")}
    if kind == "literal_error":
        choices = re.findall("'([^']*)'", str(context["expected"]))
        data |= {"wanted": alternatives(choices), "hint": near(str(fault["input"]), choices, listed=True)}
    return _with_section(Finding("file.expected", path, data))


def _is_key(path: Path, raw: Any, owner: Any) -> bool:
    """Whether a key is no element that is looked for elsewhere: it belongs to another kind of the same section, or is
    the singular or plural of a key of an entry whose kind is clear."""
    key, known = str(path[-1]), keys_at(owner, path[:-1], raw)
    other = not {f"{key}s", key.removesuffix("s")}.isdisjoint(known)
    return key in known or (other and known != keys_at(owner, path[:-1]))


def _with_section(found: Finding) -> Finding:
    """A finding on what should be entries by name, with an example of the section."""
    hint = found.data.get("hint")
    section = _inside(found.path)[:1]
    if not isinstance(hint, Term) or hint.key != "term.mapping-as" or not {*section} & {*_SECTIONS}:
        return found
    return replace(found, data={**found.data, "hint": Term(f"section-{section[0]}")})


_SECTIONS = (
    "units", "parameters", "links", "joints", "assembly", "drives", "loads", "measures", "require", "studies",
    "exports", "subassemblies", "copies",
)  # fmt: skip
"""The sections of which the catalogue has an example."""


def finding_of(fault: Any, data: Any, owner: Any, place: Path = ()) -> Finding | None:
    """A fault as its own finding, or on a key that is missing or unknown; ``None`` where it is one of a value.

    ``data`` is what stands at ``place``, of the type ``owner``.
    """
    kind, path = fault["type"], written_path(fault["loc"], data)
    if kind == "finding":
        context = dict(fault["ctx"])
        return Finding(context.pop("code"), (*place, *path), context)
    if kind == "missing":
        keys = Joined(keys_at(owner, path, data))
        return Finding("file.missing", (*place, *path), {"name": str(fault["loc"][-1]), "known": keys})
    if kind == "extra_forbidden":
        name, known = str(path[-1]), keys_at(owner, path[:-1], data)
        kind = fault["input"]
        if name in SAYS_KIND and isinstance(kind, str) and likeliest(kind, known):
            return Finding("file.kind", (*place, *path), {"name": name, "kind": kind[:60], "near": near(kind, known)})
        hint = near(name, [key for key in known if key != name])  # it may be one of another kind
        return Finding("file.unknown-key", (*place, *path), {"name": name[:60], "near": hint})
    return None
