"""Whether a mechanism's names fit together: every fault at once, each with its element and mend."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from linkwright.elements.points import homes
from linkwright.expressions.language import FUNCTIONS
from linkwright.expressions.typed_fields import Context
from linkwright.expressions.unknown import likeliest, near, unknown, unknown_point
from linkwright.findings import Finding, Term
from linkwright.model.mechanism import FRAME, Mechanism
from linkwright.model.motions import ARGUMENT
from linkwright.model.pins import pins
from linkwright.model.references import reference_faults
from linkwright.model.tolerances import tolerance_faults
from linkwright.model.values import check_values
from linkwright.model.walk import references

__all__ = ["FRAME", "check_names", "check_values"]


def check_names(m: Mechanism) -> list[Finding]:
    """All faults of names and references in a mechanism."""
    found = [finding for part in _PARTS for finding in part(m)]
    if FRAME in m.links:
        return found
    return [f for f in found if f.code != "name.unknown" or f.data["name"] != FRAME]  # follows from its absence


def _parameters(m: Mechanism) -> Iterator[Finding]:
    return tolerance_faults(m.parameters)


def _links(m: Mechanism) -> Iterator[Finding]:
    if FRAME not in m.links:
        meant = next((name for name in m.links if likeliest(name, [FRAME])), None)
        hint = Term("frame-none") if meant is None else Term("frame-other", name=meant)
        yield Finding("model.no-frame", ("links",), {"links": ", ".join(list(m.links)[:20]) or "-", "hint": hint})
    elif m.links[FRAME].mass is not None:
        yield Finding("model.frame-mass", ("links", FRAME, "mass"))
    if not any(name != FRAME for name in m.links):
        yield Finding("model.no-moving-link", ("links",))
    for name, link in m.links.items():
        if not link.points:
            yield Finding("model.no-points", ("links", name), {"name": name})
        for point in dict.fromkeys(link.shape.points) if link.shape else ():
            if point not in link.points:
                yield unknown_point(("links", name, "shape"), name, point, link.points)


def _collisions(m: Mechanism) -> Iterator[Finding]:
    """Names of links, points, prismatic joints, drives and springs are owners of signals, and must differ."""
    points, slides = homes(m), dict(m.joints_but_pins())
    owners = {"shaking": Term("the-shaking"), "energy": Term("the-energies")}
    kinds = [("link", name) for name in m.links] + [("point", name) for name in points]
    kinds += [("joint", name) for name in slides] + [("drive", name) for name in m.drives]
    kinds += [(one.noun, one.name) for one in m.acting() if one.kind.signals(one.entry)]
    for kind, name in kinds:
        if name in owners:
            path = ("links", points[name], "points", name) if kind == "point" else (f"{kind}s", name)
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
    points = homes(m)
    for name, joint in m.joints.items():
        ends = joint.ends
        if len({*joint.links}) < len(joint.links):
            yield Finding("joint.same-link", ("joints", name), {"name": joint.links[0]})
        for link, point in zip(joint.links, ends, strict=True):
            if link not in m.links:
                yield unknown("link", ("joints", name), link, m.links)
            elif point not in m.links[link].points:
                yield unknown_point(("joints", name), link, point, m.links[link].points)
        if joint.revolute and name in points and name not in ends:
            data = {"name": name, "first": Term("a-point"), "second": Term("a-joint")}
            yield Finding("name.taken", ("joints", name), data)


def _pins(m: Mechanism) -> Iterator[Finding]:
    for name, pin in pins(m).items():
        for link, count in Counter(pin.links).items():
            if count > 1:
                at = ", ".join(point for member, point in pin.members if member == link)
                path = ("joints", name) if name in m.joints else ("links", link)
                yield Finding("joint.pin-twice", path, {"link": link, "points": at, "pin": name})


def _drives(m: Mechanism) -> Iterator[Finding]:
    if not m.drives:
        yield Finding("model.no-drive", ("drives",))
    acting: dict[frozenset[str], str] = {}
    moved: dict[frozenset[str], str] = {}
    for name, drive in m.drives.items():
        path = ("drives", name)
        for link in dict.fromkeys((drive.link, drive.on)):
            if link not in m.links:
                yield unknown("link", path, link, m.links)
        if drive.link == drive.on:
            yield Finding("joint.same-link", path, {"name": drive.link})
        if drive.output is not None and (fault := _output(m, name)) is not None:
            yield fault
            continue
        for seen, entry in ((acting, drive), (moved, m.prescribed(name))):
            pair = frozenset((entry.link, entry.on))
            if pair in seen:
                yield Finding("drive.twice", path, {"other": seen[pair], "a": entry.link, "b": entry.on})
                break
            seen[pair] = name


def _output(m: Mechanism, name: str) -> Finding | None:
    """What is wrong with the output of a drive."""
    drive, slides = m.drives[name], dict(m.prismatic_joints())
    path, output = ("drives", name, "output"), m.drives[name].output
    assert output is not None
    if output not in slides and (output not in m.links or output == FRAME):
        return Finding("drive.output", path, {"name": output, "near": near(output, [*slides, *m.links])})
    moved = m.prescribed(name)
    if {moved.link, moved.on} == {drive.link, drive.on}:
        return Finding("drive.output-own", path, {"name": output, "link": drive.link, "on": drive.on})
    return None


def _acting(m: Mechanism) -> Iterator[Finding]:
    for one in m.acting():
        yield from reference_faults(references(one.entry, Context(m, one.path)))
        yield from one.kind.faults(m, one.path, one.entry)


def _assembly(m: Mechanism) -> Iterator[Finding]:
    slides = dict(m.prismatic_joints())
    pivots = {**homes(m), **{name: "" for name, joint in m.joints.items() if joint.revolute}}
    for name, rule in m.assembly.items():
        for point in dict.fromkeys((name, *rule.reference)):
            if point not in pivots:
                yield unknown("point", ("assembly", name), point, pivots)
        if rule.along and rule.along not in slides:
            yield unknown("slide", ("assembly", name), rule.along, slides)


def _measures(m: Mechanism) -> Iterator[Finding]:
    return reference_faults(references(m, Context(m), "measures", "require"))


_PARTS = (_parameters, _links, _collisions, _joints, _pins, _drives, _acting, _assembly, _measures)
