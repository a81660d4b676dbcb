"""The options of clearances in joints, and what is wrong with them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Annotated

from pydantic import Field

from linkwright.elements.cam_contact import cam_followers
from linkwright.elements.clearance import StatedClearance
from linkwright.expressions.fields import Expression, Name
from linkwright.expressions.typed_fields import Quantity
from linkwright.expressions.units import LENGTH
from linkwright.expressions.unknown import near, proposed
from linkwright.expressions.written import Shortened
from linkwright.findings import Finding, Joined, Term
from linkwright.graph.geometry import Geometry
from linkwright.kernels import Compiled
from linkwright.model.places import Path
from linkwright.structure.topology import PIN
from linkwright.studies.accuracy.rollers import rollers
from linkwright.studies.numbers import positive


class Clearance(Shortened):
    """The clearance of a joint. Of a pin, or of one in a slot, mostly written as the clearance alone."""

    main = "clearance"

    clearance: Annotated[Expression, Quantity(LENGTH)]
    length: Annotated[Expression | None, Quantity(LENGTH)] = None
    centre: Name | None = None
    in_: Name | None = Field(None, alias="in")


def check_clearances(compiled: Compiled, clearances: Mapping[str, Clearance], at: Path) -> Iterator[Finding]:
    """What is wrong with clearances that are well-formed; ``at`` is their place in the file."""
    guarded, of_rollers = _doubly_held(compiled), rollers(compiled)
    for name, entry in clearances.items():
        path = (*at, name)
        lengths = dict(_lengths(compiled, entry))
        yield from (Finding(f.code, (*path, *f.path), f.data) for f in lengths.values() if isinstance(f, Finding))
        sound = {key: value for key, value in lengths.items() if isinstance(value, float)}
        if name in guarded:
            cam = guarded[name]
            data = {"name": name, "cam": cam, "closed": compiled.mechanism.cams[cam].closed}
            yield Finding("clearance.cam", path, data)
        elif name in compiled.structure.topology.joints:
            yield from _of_joint(compiled, name, entry, sound, path)
        elif name in of_rollers:
            yield from _of_roller(compiled, of_rollers[name], entry, sound, path)
        else:
            yield _no_joint(compiled, name, path)


def _doubly_held(compiled: Compiled) -> dict[str, str]:
    """The joints and rollers of cams that touch on two sides, with the cam: which contact holds isn't followed."""
    found = {}
    for cam, drive in cam_followers(compiled.mechanism).items():
        if drive.cam.closed not in ("conjugate", "yoke"):
            continue
        found[drive.cam.touches] = cam
        if drive.joint is not None:
            found[drive.joint] = cam
        for pin in compiled.quantities.signals.pins.values():
            if drive.on in pin.links and {drive.cam.cam, drive.link} & {*pin.links}:
                found[pin.name] = cam
    return found


def _lengths(compiled: Compiled, entry: Clearance) -> Iterator[tuple[str, float | Finding]]:
    """The lengths that an entry gives (m), or what is wrong with them."""
    quantities = compiled.quantities
    for key in ("clearance", "length"):
        expression = getattr(entry, key)
        if expression is None:
            continue
        text = expression.text[:60]
        value, wrong = positive(quantities, expression, LENGTH, (key,), "clearance.not-positive", text=text)
        yield key, wrong[0] if value is None else value


def _no_joint(compiled: Compiled, name: str, path: Path) -> Finding:
    signals = compiled.quantities.signals
    joints = [joint for joint, (kind, _) in compiled.structure.topology.joints.items() if kind.plays is not None]
    if name not in signals.links_of_points:
        return Finding("clearance.no-joint", path, {"name": name, "near": near(name, joints)})
    called = [pin.name for pin in signals.pins.values() if any(point == name for _, point in pin.members)]
    if called:
        return Finding("clearance.no-joint", path, {"name": name, "near": proposed(called)})
    return Finding("clearance.one-link", path, {"name": name, "link": signals.links_of_points[name]})


def _of_joint(
    compiled: Compiled, name: str, entry: Clearance, lengths: Mapping[str, float], path: Path
) -> Iterator[Finding]:
    kind, links = compiled.structure.topology.joints[name]
    if kind.plays is None:
        yield Finding("clearance.no-play", path, {"name": name, "kind": kind.title})
        return
    yield from _beyond(name, entry, kind.plays, kind.title, path)
    if name in (loop := compiled.quantities.signals.looped):
        yield Finding("clearance.indeterminate", path, {"name": name, "loop": Joined(loop)})
    length = None if entry.length is None else lengths.get("length", math.nan)
    stated = StatedClearance(lengths.get("clearance", math.nan), length, entry.centre, entry.in_)
    geometry = Geometry(compiled.quantities, compiled.quantities.parameters)
    for code, data, *within in kind.play_faults(geometry, name, links, stated):
        yield Finding(code, (*path, *within), data)


def _beyond(name: str, entry: Clearance, known: Sequence[str], kind: Term, path: Path) -> Iterator[Finding]:
    """What an entry says that clearances of such joints don't have."""
    for key, given in (("length", entry.length), ("centre", entry.centre), ("in", entry.in_)):
        if given is not None and key not in known:
            yield Finding("clearance.no-key", (*path, key), {"name": name, "kind": kind, "key": key})


def _of_roller(
    compiled: Compiled, cam: str, entry: Clearance, lengths: Mapping[str, float], path: Path
) -> Iterator[Finding]:
    drive = cam_followers(compiled.mechanism)[cam]
    name = drive.cam.touches
    yield from _beyond(name, entry, (), PIN.title, path)
    assert drive.cam.roller is not None
    radius = compiled.quantities.value(drive.cam.roller, LENGTH)
    if lengths.get("clearance", 0.0) >= radius:
        written = Geometry(compiled.quantities, {}).text_of(radius, LENGTH)
        yield Finding("clearance.roller", path, {"name": name, "radius": written})
