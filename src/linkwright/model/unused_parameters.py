"""Parameters that nothing uses: slips, as ``BA`` for the length ``AB`` of a sketch, which keeps its drawn value."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any

from linkwright.expressions.language import Name, nodes
from linkwright.expressions.typed_fields import Path
from linkwright.expressions.unknown import likeliest
from linkwright.findings import Finding, Joined, Term
from linkwright.model.mechanism import Mechanism, scopes
from linkwright.model.number_places import stands_for_number
from linkwright.model.quantities import Quantities
from linkwright.model.sketch import drawn_parameters

_WORD = re.compile(r"[^\W\d]\w*")
_PROSE = {"name", "note", "source", "author", "revision"}
"""Sections that nothing reads names from."""


def unused_parameters(written: Mechanism, q: Quantities) -> Iterator[Finding]:
    """A warning for each parameter of a mechanism, as it is ``written``, whose value changes nothing: no expression has
    it, no drawn length its name, nor anything that is said besides, such as what a study varies."""
    used = {part.text for place in q.places for part in nodes(place.expression.node) if isinstance(part, Name)}
    parts = [*scopes(written)]
    if len(parts) == 1 and used.issuperset(written.parameters):
        return
    for at, part in parts:
        yield from _unused(at, part, used if part is written else set())


def _unused(at: Path, part: Mechanism, used: set[str]) -> Iterator[Finding]:
    """The parameters of a mechanism, or of a sub-assembly, that it doesn't use, beside those that are ``used``."""
    stated = [name for name in part.parameters if not stands_for_number(name)]
    drawn = drawn_parameters(part, stated=True)
    # What isn't an expression is looked through as text: a name that stands anywhere counts.
    written = part.model_dump(mode="json", exclude_defaults=True, exclude=_PROSE)
    used = used | drawn.keys() | {*_words([content for key, content in written.items() if key != "parameters"])}
    used |= {*_words([*written.get("parameters", {}).values()])}
    for name in stated:
        if name in used:
            continue
        lengths = [other for other in drawn if other not in stated]
        meant = [other for other in lengths if sorted(other) == sorted(name)] or likeliest(name, lengths)
        alike = likeliest(name, [other for other in stated if other in used])
        if meant:
            mend = Term("unused-meant", names=Joined(meant))
        else:
            mend = Term("unused-alike", names=Joined(alike)) if alike else Term("unused-plain")
        yield Finding(
            "name.unused-parameter", (*at, "parameters", name), {"name": name, "mend": mend}, severity="warning"
        )


def _words(data: Any) -> Iterator[str]:
    """All words of plain data, keys and texts."""
    if isinstance(data, Mapping):
        for key, content in data.items():
            yield from _WORD.findall(str(key))
            yield from _words(content)
    elif isinstance(data, list | tuple):
        for content in data:
            yield from _words(content)
    elif isinstance(data, str):
        yield from _WORD.findall(data)
