"""Parameters beside a sketch that nothing uses: slips, as ``BA`` for the length ``AB``, which keeps its drawn value."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any

from linkwright.expressions.language import Name, nodes
from linkwright.expressions.unknown import likeliest
from linkwright.findings import Finding, Joined, Term
from linkwright.model.desugar import Spelled
from linkwright.model.number_places import stands_for_number
from linkwright.model.quantities import Quantities

_WORD = re.compile(r"[^\W\d]\w*")


def unused_parameters(spelled: Spelled, q: Quantities) -> Iterator[Finding]:
    """A warning for each parameter of a sketched mechanism whose value changes nothing: no expression of the mechanism
    has it, nor anything that the file says besides, such as what a study varies."""
    lengths = [name for name in q.mechanism.parameters if name not in spelled.written.parameters]
    if not (spelled.written.sketch and lengths):
        return
    stated = [name for name in spelled.written.parameters if not stands_for_number(name)]
    used = {part.text for place in q.places for part in nodes(place.expression.node) if isinstance(part, Name)}
    if used.issuperset(stated):
        return
    # What isn't an expression of the mechanism is looked through as text: a name that stands anywhere counts.
    written = spelled.written.model_dump(mode="json", exclude_defaults=True)
    used |= {*_words([content for key, content in written.items() if key != "parameters"])}
    used |= {*_words([*written["parameters"].values()])}
    for name in stated:
        if name in used:
            continue
        meant = [other for other in lengths if sorted(other) == sorted(name)] or likeliest(name, lengths)
        mend = Term("unused-meant", names=Joined(meant)) if meant else Term("unused-plain")
        yield Finding("name.unused-parameter", ("parameters", name), {"name": name, "mend": mend}, severity="warning")


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
