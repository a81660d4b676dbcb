"""Parts of a model with other names in them: of elements, tables and parameters, wherever the typed fields hold them.

The texts stay as they are written but for the names. Where in a text a name or an expression stands is found as for
numbers (:mod:`linkwright.model.number_places`): there another one takes its place, and no other's.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import field
from typing import Any

from pydantic import BaseModel
from pydantic_core import PydanticCustomError

from linkwright.data_classes import dataclass
from linkwright.expressions.fields import Expression, FrozenDict, Written
from linkwright.expressions.parser import names_at
from linkwright.expressions.typed_fields import Named
from linkwright.model.number_places import span_of_part
from linkwright.model.references import KINDS
from linkwright.model.walk import Spec, all_fields

_MARK = "name_that_no_file_has"
EXPRESSION = Named(parts=lambda text: [(0, len(text))])
NAMESPACES = FrozenDict(
    {
        "parameters": "parameter",
        "tables": "function",
        "laws": "function",
        "windows": "window",
        "measures": "measure",
        "require": "measure",
    }
)
"""The namespaces of sections; all others have names of elements."""


def namespace(section: str) -> str:
    """Among which names those of a section must differ."""
    return str(NAMESPACES.get(section, "element"))


@dataclass
class Renaming:
    """New names by the old ones, in each namespace; ``used`` collects the old ones that were met."""

    names: Mapping[str, Mapping[str, str]]
    used: set[str] = field(default_factory=set)

    def name(self, name: str, of: str = "element") -> str:
        """A name of a namespace, as it is now."""
        self.used.add(name)
        return str(self.names[of].get(name, name))

    def text(self, text: str) -> str:
        """The text of an expression."""
        for at in reversed(names_at(text)):
            text = f"{text[: at.start]}{self.name(text[at.start : at.end], at.role)}{text[at.end :]}"
        return text

    def entry(self, entry: BaseModel) -> BaseModel:
        """An entry with all that it holds."""
        changed = {}
        for name, spec in all_fields(type(entry)).values():
            value = getattr(entry, name)
            if value is not None and (new := self.value(value, spec)) is not value:
                changed[name] = new
        return entry.model_copy(update=changed) if changed else entry

    def value(self, value: Any, spec: Spec, around: Named | None = None) -> Any:
        """What a field holds of which ``spec`` says what it is, and ``around`` what texts in it are."""
        while spec.form == "union":
            around, spec = _texts(spec) or around, spec.branch(value)
        around = _texts(spec) or around
        if isinstance(value, Written):
            return self.written(value, around.namespace if around else "")
        if isinstance(value, str):
            return value if around is None else self.string(value, around)
        if isinstance(value, BaseModel):
            return self.entry(value)
        if isinstance(value, Mapping):
            held = {key: self.value(one, spec.item(0), around) for key, one in value.items()}
            return FrozenDict({self.key(key, spec): one for key, one in held.items()})
        if isinstance(value, tuple):
            return tuple(self.value(one, spec.item(i), around) for i, one in enumerate(value))
        return value

    def string(self, text: str, of: Named) -> str:
        """A name, or a text with expressions in it."""
        if of.namespace or of.parts is None:
            return self.name(text, of.namespace or "element")
        for start, end in sorted(of.parts(text), reverse=True):
            text = f"{text[:start]}{self.text(text[start:end])}{text[end:]}"
        return text

    def key(self, key: str, spec: Spec) -> str:
        """The key of a mapping."""
        if spec.key is None:
            return key
        return self.name(key) if spec.key.declared else str(self.value(key, spec.key))

    def written(self, value: Written, of: str = "") -> Written:
        """A value that has a spelling of its own; its names are ``of`` a namespace, unless they say themselves."""
        raw, kind = value.raw, type(value)
        if isinstance(raw, list | tuple):
            parts = [self.text(part) if isinstance(part, str) else part for part in raw]
            return value if parts == [*raw] else kind(parts)
        if not isinstance(raw, str):
            return value
        if isinstance(value, Expression):
            return value if (new := self.text(raw)) == raw else kind(new)
        text = raw
        for index, (part, _) in enumerate(value.quantities()):
            old = part.text.strip()
            if (new := self.text(old)) != old and (span := span_of_part(text, old, kind(text), index)) is not None:
                text = f"{text[: span[0]]}{new}{text[span[1] :]}"
        for index, (name, ref) in enumerate(value.names()):
            new = self.name(name, (of or "element") if ref is None else _of_kind(ref.kind))
            if new != name and (at := _name_at(text, name, kind(text), index)) is not None:
                text = f"{text[:at]}{new}{text[at + len(name) :]}"
        return value if text == raw else kind(text)


def _texts(spec: Spec) -> Named | None:
    """What texts are of which a field says something."""
    if spec.named is not None:
        return spec.named
    if spec.ref is not None:
        return Named(_of_kind(spec.ref.kind))
    return None if spec.quantity is None else EXPRESSION


def _of_kind(kind: str) -> str:
    return namespace(KINDS[kind].section)


def _name_at(text: str, name: str, written: Written, index: int) -> int | None:
    """Where one of the names of a written value stands in its text: there another takes its place, and no other's."""
    wanted = [one for one, _ in written.names()]
    wanted[index] = _MARK
    for match in re.finditer(rf"\b{re.escape(name)}\b", text):
        try:
            other = type(written)(f"{text[: match.start()]}{_MARK}{text[match.end() :]}")
        except PydanticCustomError:
            continue
        if [one for one, _ in other.names()] == wanted:
            return match.start()
    return None
