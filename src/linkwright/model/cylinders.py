"""Cylinders spelled out (:mod:`linkwright.elements.cylinder`), and drives that extend them or slides."""

from __future__ import annotations

from collections.abc import Iterator

from linkwright.elements.cylinder import end_of
from linkwright.elements.drive import Drive
from linkwright.elements.points import links_of_points
from linkwright.expressions.typed_fields import Context
from linkwright.expressions.written import FrozenDict
from linkwright.findings import Finding, Term
from linkwright.model.mechanism import Mechanism
from linkwright.model.parts import Joint, Link
from linkwright.model.pins import shared_pins
from linkwright.model.references import reference_faults
from linkwright.model.walk import references

Path = tuple[str | int, ...]


def with_cylinders(m: Mechanism) -> Mechanism:
    """The mechanism with the links and slides of its cylinders, and drives that say which links they slide.

    What has a fault is left out.
    """
    links, joints = dict(m.links), dict(m.joints)
    for name, cylinder in m.cylinders.items():
        own, slide = cylinder.stands_for(name)
        if own.keys() & m.links.keys() or name in m.joints:
            continue
        links |= {link: Link.model_validate(data) for link, data in own.items()}
        joints[name] = Joint.model_validate(slide)
    every = {name: _sliding(drive, joints) for name, drive in m.drives.items()}
    drives = {name: drive for name, drive in every.items() if drive.extends is None}
    update = {"links": FrozenDict(links), "joints": FrozenDict(joints), "drives": FrozenDict(drives)}
    return m.model_copy(update=update)


def _sliding(drive: Drive, joints: dict[str, Joint]) -> Drive:
    """A drive that extends a slide, as one that slides the slide's second link on its first."""
    if drive.extends is None or drive.extends not in joints or not joints[drive.extends].prismatic:
        return drive
    on, link = joints[drive.extends].links
    return drive.model_copy(update={"extends": None, "slides": link, "on_": on})


def cylinder_faults(m: Mechanism) -> Iterator[Finding]:
    """Faults of cylinders, and of drives that extend them, before they are spelled out."""
    yield from reference_faults(references(m, Context(m), "cylinders"))
    points = [*links_of_points(m), *shared_pins(m)]
    for name, cylinder in m.cylinders.items():
        path: Path = ("cylinders", name)
        if cylinder.from_ == cylinder.to:
            yield Finding("cylinder.same-point", path, {"point": cylinder.to})
        if name in m.joints:
            yield _name_taken(path, name, "a-joint")
        for link, _, part in cylinder.parts(name):
            if link in m.links:
                yield _name_taken(path, link, "a-link")
            if part is not None and part.uniform and end_of(link) in points:
                yield _name_taken(path, end_of(link), "a-point")
    for name, drive in m.drives.items():
        yield from reference_faults(references(drive, Context(m, ("drives", name)), "extends"))


def _name_taken(path: Path, name: str, by: str) -> Finding:
    return Finding("name.taken", path, {"name": name, "first": Term(by), "second": Term("a-cylinder")})


def cylinder_path(m: Mechanism, path: Path) -> Path | None:
    """Where a place of a cylinder's links or slide stands in the file."""
    if len(path) < 2 or path[0] not in ("links", "joints"):
        return None
    for name, cylinder in m.cylinders.items():
        if path[:2] == ("joints", name):
            return ("cylinders", name)
        for link, key, part in cylinder.parts(name):
            if path[:2] == ("links", link):
                inside = part is not None and path[2:] not in ((), ("points", cylinder.from_), ("points", cylinder.to))
                return ("cylinders", name, key) if inside else ("cylinders", name)
    return None
