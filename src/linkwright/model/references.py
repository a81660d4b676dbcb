"""Names of elements among the fields of an entry: each must be that of an element of its kind."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any

from linkwright.elements.points import homes
from linkwright.expressions.unknown import unknown, unknown_point
from linkwright.findings import Finding
from linkwright.model.mechanism import Mechanism
from linkwright.model.walk import Reference

ELEMENTS: dict[str, Callable[[Mechanism], Mapping[str, Any]]] = {
    "link": lambda m: m.links,
    "point": homes,
    "slide": lambda m: dict(m.prismatic_joints()),
    "drive": lambda m: m.drives,
    "law": lambda m: m.laws,
    "window": lambda m: m.windows,
    "measure": lambda m: m.measures,
    "parameter": lambda m: m.parameters,
}
"""The elements of each kind that a :class:`~linkwright.expressions.typed_fields.Ref` may name."""


def reference_faults(found: Iterable[Reference]) -> Iterator[Finding]:
    """The names that no element has; of a point of a link that isn't known, the link alone is told."""
    for one in found:
        m, path = one.context.mechanism, one.context.path
        if one.ref.of is not None:
            link = getattr(one.context.entry, one.ref.of)
            if link in m.links and one.name not in m.links[link].points:
                yield unknown_point(path, link, one.name, m.links[link].points)
        elif one.name not in (known := ELEMENTS[one.ref.kind](m)):
            yield unknown(one.ref.kind, path, one.name, known)
