"""The options of clearances in joints, and what is wrong with them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Annotated

from pydantic import Field

from linkwright.elements.cam_contact import cam_followers
from linkwright.expressions.fields import Expression, Name
from linkwright.expressions.typed_fields import Quantity
from linkwright.expressions.units import LENGTH
from linkwright.expressions.unknown import near, proposed
from linkwright.expressions.written import Shortened
from linkwright.findings import Finding
from linkwright.graph.geometry import Geometry
from linkwright.kernels import Compiled
from linkwright.model.pins import Pin
from linkwright.model.places import Path
from linkwright.studies.accuracy.rollers import rollers
from linkwright.studies.numbers import positive


class Clearance(Shortened):
    """The clearance of a joint. Of a pin mostly written as its radial clearance alone."""

    main = "clearance"
    alone = "the clearance alone"

    clearance: Annotated[Expression, Quantity(LENGTH)] = Field(
        description="of a pin: radial, half the difference of the diameters; of a guide: half the whole play across it"
    )
    length: Annotated[Expression | None, Quantity(LENGTH)] = Field(
        None, description="of a guide: the distance of its two ends, where it bears"
    )
    centre: Name | None = Field(
        None, description="of a guide: the point in the middle of its length; the second line's point by default"
    )
    in_: Name | None = Field(
        None, alias="in", description="the link in which a pin of three links or more is fixed; else it floats"
    )


def check_clearances(compiled: Compiled, clearances: Mapping[str, Clearance], at: Path) -> Iterator[Finding]:
    """What is wrong with clearances that are well-formed; ``at`` is their place in the file."""
    signals, guides = compiled.quantities.signals, dict(compiled.mechanism.prismatic_joints())
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
        elif name in guides:
            yield from _of_guide(compiled, name, entry, sound, path)
        elif name in signals.pins:
            yield from _of_pin(compiled, signals.pins[name], entry, sound, path)
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
    joints = [*signals.pins, *(joint for joint, _ in compiled.mechanism.prismatic_joints())]
    if name not in signals.homes:
        return Finding("clearance.no-joint", path, {"name": name, "near": near(name, joints)})
    called = [pin.name for pin in signals.pins.values() if any(point == name for _, point in pin.members)]
    if called:
        return Finding("clearance.no-joint", path, {"name": name, "near": proposed(called)})
    return Finding("clearance.one-link", path, {"name": name, "link": signals.homes[name]})


def _of_guide(
    compiled: Compiled, name: str, entry: Clearance, lengths: Mapping[str, float], path: Path
) -> Iterator[Finding]:
    m = compiled.mechanism
    if entry.in_ is not None:
        yield Finding("clearance.not-of-guide", (*path, "in"), {"name": name, "key": "in"})
    if entry.length is None:
        yield Finding("clearance.no-length", path, {"name": name})
    links = m.joints[name].links
    if name in (loop := compiled.quantities.signals.looped):
        yield Finding("clearance.indeterminate", path, {"name": name, "loop": ", ".join(loop)})
    if entry.centre is not None and not any(entry.centre in m.links[link].points for link in links):
        data = {"name": entry.centre, "links": ", ".join(links)}
        yield Finding("clearance.centre", (*path, "centre"), data)
    if len(lengths) == 2 and lengths["clearance"] >= lengths["length"] / 2:
        yield Finding("clearance.short-guide", path, {"name": name})


def _of_roller(
    compiled: Compiled, cam: str, entry: Clearance, lengths: Mapping[str, float], path: Path
) -> Iterator[Finding]:
    drive = cam_followers(compiled.mechanism)[cam]
    name = drive.cam.touches
    for key, given in (("length", entry.length), ("centre", entry.centre), ("in", entry.in_)):
        if given is not None:
            yield Finding("clearance.not-of-pin", (*path, key), {"name": name, "key": key})
    assert drive.cam.roller is not None
    radius = compiled.quantities.value(drive.cam.roller, LENGTH)
    if lengths.get("clearance", 0.0) >= radius:
        text, size = compiled.quantities.unit_of(LENGTH)
        yield Finding("clearance.roller", path, {"name": name, "radius": f"{radius / size:.6g} {text}"})


def _of_pin(
    compiled: Compiled, pin: Pin, entry: Clearance, lengths: Mapping[str, float], path: Path
) -> Iterator[Finding]:
    for key, given in (("length", entry.length), ("centre", entry.centre)):
        if given is not None:
            yield Finding("clearance.not-of-pin", (*path, key), {"name": pin.name, "key": key})
    if entry.in_ is not None and entry.in_ not in pin.links:
        data = {"name": pin.name, "link": entry.in_, "links": ", ".join(pin.links)}
        yield Finding("clearance.not-on-pin", (*path, "in"), data)
    if "clearance" not in lengths:
        return
    geometry = Geometry(compiled.quantities, compiled.quantities.parameters)
    for link, own in pin.members:
        arms = [
            geometry.point(link, point).minus(geometry.point(link, own))
            for point in compiled.mechanism.links[link].points
        ]
        reach = max(math.hypot(float(arm.x), float(arm.y)) for arm in arms)
        if 0 < reach <= lengths["clearance"]:
            text, size = compiled.quantities.unit_of(LENGTH)
            data = {"name": pin.name, "link": link, "length": f"{reach / size:.6g} {text}"}
            yield Finding("clearance.too-large", path, data)
            return
