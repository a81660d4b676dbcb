"""Joints that have a link follow a drive, as cams do: each becomes a prescribed motion, named like the joint."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from linkwright.elements.follower import FOLLOWERS, Follower
from linkwright.expressions.typed_fields import Context, Path
from linkwright.findings import Finding, Joined, Term
from linkwright.model.mechanism import FOLLOWING, Mechanism
from linkwright.model.pins import Pin, pins
from linkwright.model.references import reference_faults
from linkwright.model.walk import references


def follower_entries(m: Mechanism) -> Iterator[tuple[str, str, Any, type[Follower]]]:
    """What a file says of followers: section, name, entry, kind."""
    for section in FOLLOWING:
        for name, entry in getattr(m, section).items():
            if entry.follows:
                yield section, name, entry, FOLLOWERS[entry.kind]


def with_followers(m: Mechanism) -> tuple[Mechanism, list[Finding]]:
    """A mechanism whose other short forms are spelled out, with its followers as prescribed motions; and what is wrong
    with those that are left out."""
    found, faults = dict[str, Follower](), list[Finding]()
    if not (every := [*follower_entries(m)]):
        return m, faults
    pinned = pins(m)
    for section, name, entry, kind in every:
        made = _read(m, pinned, (section, name), entry, kind)
        if isinstance(made, Follower):
            found[name] = made
        else:
            faults += made
    return m.with_followers(found), faults


def no_followers(m: Mechanism, study: str) -> Finding:
    """That a study moves each drive on its own, which a mechanism with followers doesn't let it."""
    return Finding("study.cams", m.path_of(next(iter(m.followers))), {"study": study, "names": Joined(m.followers)})


def _read(
    m: Mechanism, pinned: Mapping[str, Pin], path: tuple[str, str], entry: Any, kind: type[Follower]
) -> Follower | list[Finding]:
    """The follower, or what is wrong."""
    name, findings = path[1], list[Finding]()
    if (taken := m.path_of(name)) != path:
        data = {"name": name, "first": Term(f"a-{taken[0][:-1]}"), "second": Term(f"a-{path[0][:-1]}")}
        findings.append(Finding("name.taken", path, data))
    named = [*references(entry, Context(m, path))]
    missing = [*reference_faults(one for one in named if one.ref.kind != "law" and one.ref.of is None)]
    findings += reference_faults(one for one in named if one.ref.kind == "law")
    if missing:
        return [*findings, *missing]
    made = kind.read(m, name, pinned)
    if not isinstance(made, Follower):
        return [*findings, *made]
    return [*findings, *_unlawful(m, path, made)] or made


def _unlawful(m: Mechanism, path: Path, made: Follower) -> Iterator[Finding]:
    """Motion laws whose argument or value isn't that of motor and follower; a motor whose law is its output's."""
    motor, value = m.drives[made.motor], "angle" if made.turning else "length"
    if motor.output is not None:
        yield Finding("joint.follower-output", path, {"motor": made.motor, "output": motor.output})
    over = "angle" if motor.turns else "length"
    for key, name in made.laws.items():
        law = m.laws.get(name)
        if law is not None and (law.over, law.of) != (over, value):
            given = Joined([f"over: {law.over}", f"of: {law.of}"])
            data = {"law": name, "over": over, "of": value, "given": given}
            terms = {"argument": Term(f"dimension-{over}"), "value": Term(f"dimension-{value}")}
            yield Finding("joint.follower-law", (*path, key), data | terms)
