"""Cylinders: one line of a file that stands for a barrel, a rod and the slide between them.

A cylinder ``lift`` from the point K to the point M becomes the links ``lift_barrel`` (pinned at K) and ``lift_rod``
(pinned at M) and the prismatic joint ``lift``, whose travel is the distance of the two pins.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from linkwright.elements.points import homes
from linkwright.expressions.fields import Expression
from linkwright.expressions.typed_fields import Context
from linkwright.expressions.written import FrozenDict
from linkwright.findings import Finding, Term
from linkwright.model.mechanism import Mechanism
from linkwright.model.parts import CylinderPart, Drive, Joint, Link
from linkwright.model.pins import shared_pins
from linkwright.model.references import reference_faults
from linkwright.model.walk import references

Path = tuple[str | int, ...]


def links_of(name: str) -> tuple[str, str]:
    """The names of a cylinder's two links."""
    return f"{name}_barrel", f"{name}_rod"


def with_cylinders(m: Mechanism) -> Mechanism:
    """The mechanism with the links and slides of its cylinders, and drives that say which links they slide.

    What has a fault is left out.
    """
    links, joints = dict(m.links), dict(m.joints)
    for name, cylinder in m.cylinders.items():
        barrel, rod = links_of(name)
        if {barrel, rod} & m.links.keys() or name in m.joints:
            continue
        links[barrel] = _part(barrel, cylinder.from_, cylinder.barrel, 1)
        links[rod] = _part(rod, cylinder.to, cylinder.rod, -1)
        line = [f"{cylinder.from_} at 0", f"{cylinder.to} at 0"]
        joints[name] = Joint.model_validate({"prismatic": [barrel, rod], "line": line})
    every = {name: _sliding(drive, joints) for name, drive in m.drives.items()}
    drives = {name: drive for name, drive in every.items() if drive.extends is None}
    update = {"links": FrozenDict(links), "joints": FrozenDict(joints), "drives": FrozenDict(drives)}
    return m.model_copy(update=update)


def _part(link: str, pin: str, part: CylinderPart | None, sign: int) -> Link:
    """Barrel or rod: its pin is the origin, its x axis runs from the barrel's pin to the rod's."""
    data: dict[str, Any] = {"points": {pin: [0, 0]}}
    if part is not None:
        data["mass"] = part.mass
        if _uniform(part):  # as long as puts its centre where it is
            data["points"][end_of(link)] = [_times(2 * sign, part.com), 0]
            data["shape"] = f"rod {pin}-{end_of(link)}"
        else:
            data |= {"com": [_times(sign, part.com), 0], "inertia": part.inertia}
    return Link.model_validate(data)


def _uniform(part: CylinderPart | None) -> bool:
    """Whether a part is a slender uniform rod, with a point at its far end."""
    return part is not None and part.inertia is None


def end_of(link: str) -> str:
    """The point at the far end of a barrel or rod."""
    return f"{link}_end"


def _times(factor: int, length: Expression) -> Any:
    return length.raw if factor == 1 else f"{factor}*({length.text})"


def _sliding(drive: Drive, joints: dict[str, Joint]) -> Drive:
    """A drive that extends a slide, as one that slides the slide's second link on its first."""
    if drive.extends is None or drive.extends not in joints or not joints[drive.extends].prismatic:
        return drive
    on, link = joints[drive.extends].links
    return drive.model_copy(update={"extends": None, "slides": link, "on_": on})


def cylinder_faults(m: Mechanism) -> Iterator[Finding]:
    """Faults of cylinders, and of drives that extend them, before they are spelled out."""
    yield from reference_faults(references(m, Context(m), "cylinders"))
    points = [*homes(m), *shared_pins(m)]
    for name, cylinder in m.cylinders.items():
        path: Path = ("cylinders", name)
        if cylinder.from_ == cylinder.to:
            yield Finding("cylinder.same-point", path, {"point": cylinder.to})
        if name in m.joints:
            yield _taken(path, name, "a-joint")
        for link, part in zip(links_of(name), (cylinder.barrel, cylinder.rod), strict=True):
            if link in m.links:
                yield _taken(path, link, "a-link")
            if _uniform(part) and end_of(link) in points:
                yield _taken(path, end_of(link), "a-point")
    for name, drive in m.drives.items():
        yield from reference_faults(references(drive, Context(m, ("drives", name)), "extends"))


def _taken(path: Path, name: str, by: str) -> Finding:
    return Finding("name.taken", path, {"name": name, "first": Term(by), "second": Term("a-cylinder")})


def cylinder_home(m: Mechanism, path: Path) -> Path | None:
    """Where a place of a cylinder's links or slide stands in the file."""
    if len(path) < 2 or path[0] not in ("links", "joints"):
        return None
    for name, cylinder in m.cylinders.items():
        if path[:2] == ("joints", name):
            return ("cylinders", name)
        for link, key, part in zip(links_of(name), ("barrel", "rod"), (cylinder.barrel, cylinder.rod), strict=True):
            if path[:2] == ("links", link):
                inside = part is not None and path[2:] not in ((), ("points", cylinder.from_), ("points", cylinder.to))
                return ("cylinders", name, key) if inside else ("cylinders", name)
    return None
