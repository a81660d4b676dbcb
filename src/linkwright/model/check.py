"""Whether a mechanism's names fit together: every fault at once, each with its element and mend."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

from linkwright.elements.distances import circular
from linkwright.elements.entries import NOUNS, JointEntry
from linkwright.elements.points import links_of_points
from linkwright.expressions.language import FUNCTIONS
from linkwright.expressions.unknown import likeliest
from linkwright.findings import Finding, Joined, Term
from linkwright.model.mechanism import FRAME, Mechanism
from linkwright.model.motions import ARGUMENT
from linkwright.model.pins import pins
from linkwright.model.places import find_typed_values
from linkwright.model.references import KINDS, reference_faults
from linkwright.model.slides import in_loops
from linkwright.model.stiff_elements import stiff_element_faults
from linkwright.model.tolerances import tolerance_faults
from linkwright.model.values import check_values
from linkwright.model.walk import Found, Reference

__all__ = ["FRAME", "check_names", "check_values"]


def check_names(m: Mechanism, fields: Sequence[Found] | None = None) -> list[Finding]:
    """All faults of names and references in a mechanism; ``fields`` is what its typed fields hold. Those of its short
    forms are told by these."""
    named = [
        one
        for one in fields or find_typed_values(m)
        if isinstance(one, Reference) and one.context.path[0] not in _SHORT
    ]
    found = [*reference_faults(named), *(finding for part in _PARTS for finding in part(m))]
    if FRAME in m.links:
        return found
    return [f for f in found if f.code != "name.unknown" or f.data["name"] != FRAME]  # follows from its absence


def _parameters(m: Mechanism) -> Iterator[Finding]:
    return tolerance_faults(m.parameters)


def _links(m: Mechanism) -> Iterator[Finding]:
    if FRAME not in m.links:
        meant = next((name for name in m.links if likeliest(name, [FRAME])), None)
        hint = Term("frame-none") if meant is None else Term("frame-other", name=meant)
        yield Finding("model.no-frame", ("links",), {"links": Joined(list(m.links)[:20]) or "-", "hint": hint})
    elif m.links[FRAME].mass is not None:
        yield Finding("model.frame-mass", ("links", FRAME, "mass"))
    if not any(name != FRAME for name in m.links):
        yield Finding("model.no-moving-link", ("links",))
    for name, link in m.links.items():
        if not link.points:
            yield Finding("model.no-points", ("links", name), {"name": name})
        for point in circular(link.points):
            yield Finding("triangle.circular", ("links", name, "points", point), {"point": point, "link": name})


def _collisions(m: Mechanism) -> Iterator[Finding]:
    """Names of links, points, prismatic joints, drives and springs are owners of signals, and must differ; so must
    those of what else has whole turns counted, as links and drives have."""
    points, slides = links_of_points(m), dict(m.joints_but_pins())
    sections = {noun: section for section, noun in NOUNS.items()}
    owners = {"shaking": Term("the-shaking"), "energy": Term("the-energies")}
    kinds = [("link", name) for name in m.links] + [("point", name) for name in points]
    kinds += [("joint", name) for name in slides] + [("drive", name) for name in m.movers]
    kinds += [
        (one.noun, one.name) for one in m.acting() if one.kind.signals(one.entry) or one.kind.counted_angle(one.entry)
    ]
    for kind, name in kinds:
        if name in owners:
            path: tuple[str, ...] = m.path_of(name) if kind == "drive" else (sections.get(kind, f"{kind}s"), name)
            path = ("links", points[name], "points", name) if kind == "point" else path
            data = {"name": name, "first": owners[name], "second": Term(f"a-{kind}")}
            yield Finding("name.taken", path, data)
        owners.setdefault(name, Term(f"a-{kind}"))
    called = {**dict.fromkeys(FUNCTIONS, Term("a-function")), **dict.fromkeys(m.parameters, Term("a-parameter"))}
    for kind, functions in (("table", m.tables), ("law", m.laws)):
        for name in functions:
            if name in called:
                data = {"name": name, "first": called[name], "second": Term(f"a-{kind}")}
                yield Finding("name.taken", (f"{kind}s", name), data)
        called |= dict.fromkeys(functions, Term(f"a-{kind}"))
    if ARGUMENT in m.parameters:
        for name, law in m.laws.items():
            for i, segment in enumerate(law.segments):
                if segment.formula is not None:
                    yield Finding("law.argument-taken", ("laws", name, "segments", i), {"name": ARGUMENT})


def _joints(m: Mechanism) -> Iterator[Finding]:
    points = links_of_points(m)
    for name, joint in m.joints.items():
        if isinstance(joint, JointEntry):
            for code, data, *within in joint.name_faults(m):
                yield Finding(code, ("joints", name, *within), data)
    for name, joint in m.joints.items():
        ends = joint.joint_points
        if len({*joint.links}) < len(joint.links):
            yield Finding("joint.same-link", ("joints", name), {"name": joint.links[0]})
        if joint.revolute and name in points and name not in ends:
            data = {"name": name, "first": Term("a-point"), "second": Term("a-joint")}
            yield Finding("name.taken", ("joints", name), data)


def _pins(m: Mechanism) -> Iterator[Finding]:
    for name, pin in pins(m).items():
        for link, count in Counter(pin.links).items():
            if count > 1:
                at = Joined(point for member, point in pin.members if member == link)
                path = ("joints", name) if name in m.joints else ("links", link)
                yield Finding("joint.pin-twice", path, {"link": link, "points": at, "pin": name})


def _paths(m: Mechanism) -> Iterator[Finding]:
    """That two drives follow each path, and laws are stated once."""
    for name, path in m.paths.items():
        if path.moves == path.on:
            yield Finding("joint.same-link", ("paths", name), {"name": path.moves})
        if len(drives := m.path_drives(name)) != 2:
            yield Finding(
                "path.drives", ("paths", name), {"name": name, "count": len(drives), "drives": Joined(drives)}
            )
        for taken, noun in ((m.links, "a-link"), (m.joints, "a-joint")):
            if name in taken:
                yield Finding(
                    "name.taken", ("paths", name), {"name": name, "first": Term(noun), "second": Term("a-path")}
                )
    for name, drive in m.drives.items():
        law = drive.speed if drive.position is None else drive.position
        if drive.output in m.paths and law is not None:
            yield Finding("path.two-laws", ("drives", name), {"drive": name, "path": drive.output})
        elif drive.output is not None and drive.output not in m.paths and law is None:
            yield Finding("drive.law", ("drives", name))


def _drives(m: Mechanism) -> Iterator[Finding]:
    if not m.drives:
        yield Finding("model.no-drive", ("drives",))
    acting: dict[frozenset[str], str] = {}
    moved: dict[frozenset[str], str] = {}
    for name, drive in m.movers.items():
        path = m.path_of(name)
        if drive.link == drive.on:
            yield Finding("joint.same-link", path, {"name": drive.link})
        if drive.output is not None:
            if drive.output not in KINDS["output"].known(m):
                continue
            entry = m.prescribed(name)
            if not (entry.moves or drive.moves) and {entry.link, entry.on} == {drive.link, drive.on}:
                data = {"name": drive.output, "link": drive.link, "on": drive.on}
                yield Finding("drive.output-own", (*path, "output"), data)
                continue
        for seen, entry in ((acting, drive), (moved, m.prescribed(name))):
            pair = frozenset((entry.link, entry.on))
            if entry.moves:
                continue  # two directions, or two points, are different motions
            if pair in seen:
                yield Finding("drive.twice", path, {"other": seen[pair], "a": entry.link, "b": entry.on})
                break
            seen[pair] = name


def _acting(m: Mechanism) -> Iterator[Finding]:
    for one in m.acting():
        yield from one.kind.faults(m, one.path, one.entry)
        if (weight := one.kind.weighs(one.entry)) is not None and weight.link == FRAME:
            yield Finding("model.frame-mass", one.path)


def _resisting(m: Mechanism) -> Iterator[Finding]:
    """What follows from reactions needs a motion, and reactions that statics determines and that are linear in what
    acts."""
    for one in (one for one in m.acting() if one.kind.resists):
        if not m.drives:
            yield Finding("friction.still", one.path)
        yield from one.kind.moment_faults(one.path, one.entry, one.kind.rubs_in(one.entry) not in in_loops(m))
        for name, follower in m.followers.items():
            if follower.has_second_contact and one.kind.rubs_in(one.entry) == name:
                yield Finding("friction.second-contact", one.path, {"name": name})


_PARTS = (_parameters, _links, _collisions, _joints, _pins, _paths, _drives, _acting, _resisting, stiff_element_faults)
_SHORT = ("cylinders", "cams")
