"""A section of a model file whose entries are known by a registry: studies, and what is exported."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any, ClassVar, Protocol, TypeVar

from pydantic import BaseModel, ValidationError

from linkwright.expressions.unknown import near
from linkwright.expressions.written import describe
from linkwright.findings import Finding, Term, alternatives
from linkwright.model.faults import finding_of, written_path


class Optioned(Protocol):
    """What stands in such a section: its name there, an example of its options as a file has them, and their model."""

    name: ClassVar[str]
    example: ClassVar[str]
    options: ClassVar[type[BaseModel]]


T = TypeVar("T", bound=Optioned)


def read_section(
    section: str, raw: Mapping[str, Mapping[str, Any]], known: Mapping[str, T], unknown: str, wrong: str
) -> tuple[list[tuple[T, Any]], list[Finding]]:
    """The entries of a section with their parsed options, and what is wrong with it.

    ``unknown`` and ``wrong`` are the codes for a name that isn't known and for an option. Options may look at those of
    the other entries: these are the context of their validation. An owner that has ``without`` is read without the
    keys that are wrong, so that all else can be looked at: the findings tell that it can't be performed.
    """
    read, findings = [], []
    for name, entry in raw.items():
        owner = known.get(name)
        if owner is None:
            findings.append(Finding(unknown, (section, name), {"name": name, "near": near(name, known, listed=True)}))
            continue
        try:
            read.append((owner, owner.options.model_validate(entry, context=raw)))
        except ValidationError as error:
            faults = error.errors(include_url=False)
            findings += [_option_finding(wrong, owner, (section, name), entry, fault) for fault in faults]
            if (
                rest := _sound_options(owner, entry, {fault["loc"][0] for fault in faults if fault["loc"]}, raw)
            ) is not None:
                read.append((owner, rest))
    return read, findings


def _sound_options(owner: Any, entry: Mapping[str, Any], wrong: set[Any], raw: Any) -> Any:
    """The options without the keys that are wrong and those that can't be judged without them; ``None``: none can."""
    without = getattr(owner, "without", None)
    if without is None or not wrong or (left := without(wrong)) is None:
        return None
    try:
        return owner.options.model_validate({k: v for k, v in entry.items() if k not in left}, context=raw)
    except ValidationError:
        return None


def _option_finding(
    code: str, owner: Optioned, place: tuple[str, str], entry: Mapping[str, Any], fault: Any
) -> Finding:
    """A fault of an option as a finding: its own where the option has one, else what the type wants."""
    if (found := finding_of(fault, entry, owner.options, place)) is not None:
        return found
    path = (*place, *written_path(fault["loc"], entry))
    key = ".".join(map(str, path[2:]))
    return Finding(code, path, {code.split(".")[0]: place[1], "key": key, "reason": _reason(fault)})


_REASONS = {
    "bool_parsing": "bool", "bool_type": "bool", "float_parsing": "number", "float_type": "number",
    "int_from_float": "whole", "int_parsing": "whole", "int_type": "whole", "string_type": "text",
    "greater_than": "above", "greater_than_equal": "least", "less_than": "below", "less_than_equal": "most",
    "literal_error": "choice",
}  # fmt: skip
"""What a value must be, by the kind of pydantic's fault on it."""


def _reason(fault: Any) -> Term | str:
    kind = _REASONS.get(fault["type"])
    if kind is None:
        return str(fault["msg"])
    data = dict(fault.get("ctx", {}))
    if kind == "choice":
        data["expected"] = alternatives(re.findall("'([^']*)'", str(data["expected"])))
    return Term(f"must-{kind}", given=describe(fault["input"]), **data)
