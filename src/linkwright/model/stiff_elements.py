"""What can't have the stiffness that a file states for it."""

from __future__ import annotations

from collections.abc import Iterator

from linkwright.elements.joint import kind
from linkwright.expressions.typed_fields import Context
from linkwright.findings import Finding
from linkwright.model.mechanism import Mechanism
from linkwright.model.pins import pins
from linkwright.model.walk import references


def stiff_element_faults(m: Mechanism) -> Iterator[Finding]:
    """Links of which one stiffness doesn't tell how they yield, and joints that can't tilt."""
    slides = {name for name, joint in m.joints_but_pins() if kind(joint.kind).parallel}
    jointed = {link for _, joint in m.joints_but_pins() for link in joint.links}
    loaded: dict[str, str] = {}
    for one in m.acting():
        if one.kind.acts:
            inside = references(one.entry, Context(m, one.path))
            loaded |= {reference.name: one.name for reference in inside if reference.ref.kind == "link"}
    for name, entry in m.stiffness.items():
        path = ("stiffness", name)
        if entry.tilt is not None and name not in slides:
            yield Finding("stiffness.tilt", (*path, "tilt"), {"name": name})
        if name not in m.links:
            continue
        count = sum(name in pin.links for pin in pins(m).values())
        if count != 2 or name in jointed:
            yield Finding("stiffness.link", path, {"link": name})
        elif name in loaded:
            yield Finding("stiffness.loaded", path, {"link": name, "name": loaded[name]})
