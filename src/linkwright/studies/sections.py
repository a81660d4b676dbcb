"""A section of a model file whose entries are known by a registry: studies, and what is exported."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar, Protocol, TypeVar

from pydantic import BaseModel, ValidationError

from linkwright.model.faults import written
from linkwright.model.findings import Finding
from linkwright.model.unknown import near


class Optioned(Protocol):
    """What stands in such a section: its name there, and the model of its options."""

    name: ClassVar[str]
    options: ClassVar[type[BaseModel]]


T = TypeVar("T", bound=Optioned)


def read_section(
    section: str, raw: Mapping[str, Mapping[str, Any]], known: Mapping[str, T], unknown: str, wrong: str
) -> tuple[list[tuple[T, Any]], list[Finding]]:
    """The entries of a section with their parsed options, and what is wrong with it.

    ``unknown`` and ``wrong`` are the codes for a name that isn't known and for an option. Options may look at those of
    the other entries: these are the context of their validation.
    """
    read, findings = [], []
    for name, entry in raw.items():
        owner = known.get(name)
        if owner is None:
            findings.append(Finding(unknown, (section, name), {"name": name, "near": near(name, [*known])}))
            continue
        try:
            read.append((owner, owner.options.model_validate(entry, context=raw)))
        except ValidationError as error:
            findings += [_wrong(wrong, (section, name), entry, fault) for fault in error.errors(include_url=False)]
    return read, findings


def _wrong(code: str, place: tuple[str, str], entry: Mapping[str, Any], fault: Any) -> Finding:
    """A fault of an option as a finding: its own where the option has one, else what the type wants."""
    missing = fault["loc"][-1:] if fault["type"] == "missing" else ()
    path = (*place, *written(fault["loc"], entry), *missing)
    if fault["type"] == "finding":
        context = dict(fault["ctx"])
        return Finding(context.pop("code"), path, context)
    key = ".".join(map(str, path[2:]))
    return Finding(code, path, {code.split(".")[0]: place[1], "key": key, "reason": fault["msg"]})
