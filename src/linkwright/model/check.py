"""Whether a mechanism's names fit together: every fault at once, each with its element and mend."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from typing import Any

from linkwright.model.findings import Finding
from linkwright.model.mechanism import Mechanism
from linkwright.model.pins import homes
from linkwright.model import units as u
from linkwright.model.quantities import Quantities
from linkwright.model.signals import near
from linkwright.model.units import is_unit

FRAME = "frame"
WHERE = re.compile(r"^\s*(?:(max|min)\s+(.+)|(start)|(end))\s*$")


def check_names(m: Mechanism) -> list[Finding]:
    """All faults of names and references in a mechanism."""
    return [finding for part in _PARTS for finding in part(m)]


def _unknown(kind: str, path: tuple[Any, ...], name: str, known: Iterable[str]) -> Finding:
    return Finding("name.unknown", path, {"kind": kind, "name": name, "near": near(name, list(known))})


def _links(m: Mechanism) -> Iterator[Finding]:
    if FRAME not in m.links:
        yield Finding("model.no-frame", ("links",), {"near": near(FRAME, list(m.links))})
    elif m.links[FRAME].mass is not None:
        yield Finding("model.frame-mass", ("links", FRAME, "mass"))
    if len(m.links) < 2:
        yield Finding("model.no-moving-link", ("links",))
    for name, link in m.links.items():
        if not link.points:
            yield Finding("model.no-points", ("links", name), {"name": name})
        for point in link.shape.points if link.shape else ():
            if point not in link.points:
                yield _unknown("point", ("links", name, "shape"), point, link.points)


def _collisions(m: Mechanism) -> Iterator[Finding]:
    """Names of links, points, prismatic joints and drives are owners of signals, and must differ."""
    owners: dict[str, str] = {"shaking": "the shaking force", "energy": "the energies"}
    kinds = (("link", m.links), ("point", homes(m)), ("joint", dict(m.prismatic_joints())), ("drive", m.drives))
    for kind, names in kinds:
        for name in names:
            if name in owners:
                path = (f"{kind}s", name) if kind != "point" else ("links", homes(m)[name], "points", name)
                yield Finding("name.taken", path, {"name": name, "first": owners[name], "second": kind})
            owners.setdefault(name, f"a {kind}")


def _joints(m: Mechanism) -> Iterator[Finding]:
    for name, joint in m.joints.items():
        points = joint.at or tuple(line.point for line in joint.line or ())
        if joint.links[0] == joint.links[1]:
            yield Finding("joint.same-link", ("joints", name), {"name": joint.links[0]})
        for link, point in zip(joint.links, points, strict=True):
            if link not in m.links:
                yield _unknown("link", ("joints", name), link, m.links)
            elif point not in m.links[link].points:
                yield Finding(
                    "name.unknown-point",
                    ("joints", name),
                    {"link": link, "name": point, "near": near(point, list(m.links[link].points))},
                )


def _drives(m: Mechanism) -> Iterator[Finding]:
    if not m.drives:
        yield Finding("model.no-drive", ("drives",))
    pairs: dict[frozenset[str], str] = {}
    for name, drive in m.drives.items():
        for link in (drive.link, drive.on):
            if link not in m.links:
                yield _unknown("link", ("drives", name), link, m.links)
        if drive.link == drive.on:
            yield Finding("joint.same-link", ("drives", name), {"name": drive.link})
        pair = frozenset((drive.link, drive.on))
        if pair in pairs:
            yield Finding("drive.twice", ("drives", name), {"other": pairs[pair], "a": drive.link, "b": drive.on})
        pairs[pair] = name


def _loads(m: Mechanism) -> Iterator[Finding]:
    for name, load in m.loads.items():
        path = ("loads", name)
        for link in [load.on, *([load.in_] if load.in_ else [])]:
            if link not in m.links:
                yield _unknown("link", path, link, m.links)
        if isinstance(load.at, str) and load.on in m.links and load.at not in m.links[load.on].points:
            yield _unknown("point", (*path, "at"), load.at, m.links[load.on].points)
        if load.along and load.along not in dict(m.prismatic_joints()):
            yield _unknown("prismatic joint", (*path, "along"), load.along, dict(m.prismatic_joints()))
        if load.on == FRAME:
            yield Finding("load.on-frame", path)


def _assembly(m: Mechanism) -> Iterator[Finding]:
    points, slides = homes(m), dict(m.prismatic_joints())
    pins = {*points, *(name for name, joint in m.joints.items() if joint.revolute)}
    for name, rule in m.assembly.items():
        for point in (name, *rule.reference):
            if point not in pins:
                yield _unknown("point", ("assembly", name), point, pins)
        if rule.along and rule.along not in slides:
            yield _unknown("prismatic joint", ("assembly", name), rule.along, slides)


def _measures(m: Mechanism) -> Iterator[Finding]:
    for name, measure in m.measures.items():
        if measure.window and measure.window not in m.windows:
            yield _unknown("window", ("measures", name, "window"), measure.window, m.windows)
        if measure.where is not None and not WHERE.match(measure.where):
            yield Finding("measure.bad-where", ("measures", name, "where"), {"given": measure.where})
        if measure.unit and not all(is_unit(w) for w in re.findall(r"[^\W\d][\w]*|°|%", measure.unit)):
            yield Finding("units.unknown", ("measures", name, "unit"), {"word": measure.unit})
    for name in m.require:
        if name not in m.measures:
            yield _unknown("measure", ("require", name), name, m.measures)
    for name, window in m.windows.items():
        if isinstance(window, dict) and len(window) != 1:
            yield Finding("window.one-signal", ("windows", name))


def _parameters(m: Mechanism) -> Iterator[Finding]:
    for name in m.parameters:
        if name in m.tables:
            yield Finding("name.taken", ("tables", name), {"name": name, "first": "a parameter", "second": "table"})


_PARTS = (_links, _collisions, _joints, _drives, _loads, _assembly, _measures, _parameters)


def check_values(quantities: Quantities) -> list[Finding]:
    """Faults of numbers: negative masses, rods without length, requirements that read backwards."""
    m, findings = quantities.mechanism, []

    def expect(path: tuple[Any, ...], what: str, value: float, least: float, strict: bool) -> None:
        if value < least or (strict and value == least):
            findings.append(Finding("value.too-small", path, {"what": what, "value": f"{value:g}"}))

    for name, link in m.links.items():
        if link.mass is not None:
            expect(("links", name, "mass"), "mass", quantities.value(link.mass, u.MASS), 0.0, False)
        if link.inertia is not None:
            expect(("links", name, "inertia"), "moment of inertia", quantities.value(link.inertia, u.INERTIA), 0.0, False)
        if link.shape and link.shape.radius:
            expect(("links", name, "shape"), "radius", quantities.value(link.shape.radius, u.LENGTH), 0.0, True)
    for name, window in m.windows.items():
        edges = window if isinstance(window, tuple) else next(iter(window.values()))
        dimension = u.TIME if isinstance(window, tuple) else None
        low, high = (quantities.value(edge, dimension) for edge in edges)
        if not low < high:
            findings.append(Finding("window.empty", ("windows", name)))
    return findings
