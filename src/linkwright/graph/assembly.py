"""The assembly mode of each group: from the file's rules to a branch, at the start pose where that is needed."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import field
from typing import Any

import numpy as np

from linkwright.data_classes import dataclass
from linkwright.elements import OuterPin
from linkwright.expressions.dimensions import DimensionError
from linkwright.expressions.fields import AssemblyRule
from linkwright.expressions.units import LENGTH
from linkwright.findings import Finding, Joined, ModelError, Term, enumerated
from linkwright.graph.geometry import Geometry
from linkwright.graph.higher_groups import (
    assemble_as_drawn,
    assemble_higher_group,
    closes_in_a_singular_pose,
    drawn_phases,
    only_coordinates,
)
from linkwright.graph.motion import Motion, Unknowns, solve_motion
from linkwright.graph.prescribed_places import out_of_reach
from linkwright.graph.wedges import Parallel
from linkwright.groups import Dyad
from linkwright.model.pins import Pin
from linkwright.model.quantities import Quantities
from linkwright.model.sketch import Drawn, drawn_rules
from linkwright.notation import Jet, Pair
from linkwright.structure import Connection, Group, HigherGroup, Structure


class _CannotStart(Exception):
    """The start pose stops at a group; the finding is noted."""


@dataclass
class Assembly:
    """The branch (+1 or -1) of each group with two modes; ``findings`` says what is missing or wrong, ``notes`` which
    rules choose the mode that mirrors the drawn one."""

    branches: dict[Group, float] = field(default_factory=dict)
    rules: dict[Group, str] = field(default_factory=dict)  # the rule that settled each, as the file has it
    starts: dict[HigherGroup, list[float]] = field(default_factory=dict)
    findings: list[Finding] = field(default_factory=list)
    notes: list[Finding] = field(default_factory=list)
    start: Motion | None = None

    def size(self) -> float:
        """The mechanism's extent at the start pose (m)."""
        assert self.start is not None
        motion = self.start
        points = [
            motion.bodies[link].point(motion.point(link, name)).now
            for link, entry in motion.geometry.mechanism.links.items()
            for name in entry.points
        ]
        xs, ys = [float(p.x) for p in points], [float(p.y) for p in points]
        return math.hypot(max(xs) - min(xs), max(ys) - min(ys)) or 1.0


def assemble(quantities: Quantities, structure: Structure, start: Mapping[str, float]) -> Assembly:
    """Settle all branches. ``start`` holds each drive's value (rad or m) at the start of the motion."""
    return _Assembler(quantities, structure).run(start)


class _Assembler:
    def __init__(self, quantities: Quantities, structure: Structure) -> None:
        self.quantities, self.structure = quantities, structure
        self.rules: dict[str, AssemblyRule] = dict(quantities.mechanism.assembly)
        self.used: set[str] = set()
        self.assembly = Assembly()
        self.geometry = Geometry(quantities, quantities.parameters)

    def run(self, start: Mapping[str, float]) -> Assembly:
        drives = self.drives = {name: Jet([value]) for name, value in start.items()}
        self.motion = Motion(self.structure, self.geometry, 0)
        try:
            with np.errstate(all="ignore"):
                solve_motion(self.structure, self.geometry, drives, self.branch, self.unknowns, self.motion)
        except _CannotStart:
            return self.assembly
        except Parallel as error:
            slides = enumerated([c.joint for c in error.wedge.outer])
            self.note("assembly.slides-parallel", ("links", error.wedge.link), link=error.wedge.link, joints=slides)
            return self.assembly
        except ModelError as error:
            self.assembly.findings += error.findings
            return self.assembly
        except ZeroDivisionError:
            self.degenerate(self.current)
            return self.assembly
        vague = [g for g, (_, solved) in self.motion.dyads.items() if not math.isfinite(solved.determinant)]
        if vague:
            self.degenerate(vague[0])
            return self.assembly
        self.assembly.start = self.motion
        moving = self.structure.topology.moving
        for name, rule in self.rules.items():
            # A group of one mode needs no sketch, and one of a redundant mechanism may keep other joints than its rule.
            spare = self.structure.releases or (rule.sketch is not None and self.owner(name, moving))
            if name not in self.used and not spare:
                self.note("assembly.unused", ("assembly", name), point=name)
        return self.assembly

    def note(self, code: str, path: tuple[str, ...], **data: Any) -> None:
        self.assembly.findings.append(Finding(code, path, data))

    def degenerate(self, group: Group) -> None:
        joints = Joined(c.joint for c in group.joints)
        self.note("assembly.degenerate", ("links", group.links[0]), links=enumerated(group.links), joints=joints)

    def branch(self, group: Group, dyad: Dyad) -> float:
        """The branch of a group reached at the start pose. Raises :class:`_CannotStart` when it can't close there."""
        self.current = group
        branch = 1.0
        if group.modes > 1:
            found = [
                (name, value) for name, rule in self.rules.items() if (value := self.rule(name, rule, group, dyad))
            ]
            self.used |= {name for name, _ in found}
            stated = [(name, value) for name, value in found if not isinstance(self.rules[name], Drawn)]
            found = stated or found
            signs = {math.copysign(1.0, value) for _, value in found if not math.isnan(value)}
            if len(signs) == 1:
                branch = signs.pop()
                name = found[0][0]
                self.assembly.rules[group] = f"{name}: {self.rules[name].text}"
                if stated and not self.assembly.notes:  # what comes after a mirrored group lies elsewhere anyway
                    self.mirrored(name, branch, group, dyad)
            elif not signs and any(isinstance(self.rules[name], Drawn) for name, _ in found):
                name = found[0][0]
                self.note("assembly.ambiguous", ("assembly", name), point=name, options=self.options(group))
            elif len(signs) > 1:
                self.note("assembly.contradiction", ("assembly", found[0][0]), rules=Joined(n for n, _ in found))
            elif not found and group.inner.joint in self.quantities.mechanism.cylinders:
                branch = group.front
                self.assembly.rules[group] = group.rule(branch)
            elif not found and self.structure.drawn:
                branch = self.as_drawn(group, dyad)
            elif not found:
                self.note(
                    "assembly.missing",
                    ("assembly",),
                    links=Joined(group.links),
                    options=self.options(group),
                )
            self.assembly.branches[group] = branch
        if (shortfall := dyad.shortfall()) is not None:
            data = shortfall_data(self.quantities, group, *shortfall)
            self.note("assembly.cannot-close", ("links", group.links[0]), **data)
            raise _CannotStart
        return branch

    def as_drawn(self, group: Group, dyad: Dyad) -> float:
        """The mode of a group that is nearest to the pose in which a redundant mechanism was found to close."""
        assert self.structure.drawn is not None
        away = []
        for sign in (1.0, -1.0):
            dyad.solve(sign, 0)  # puts the group's links into the motion
            bodies = [(self.structure.drawn[link], self.motion.bodies[link]) for link in group.meeting]
            origins = (body.point(Pair(0.0, 0.0)).now.minus(Pair(x, y)) for (x, y, _), body in bodies)
            away.append(sum(float(miss.dot(miss)) for miss in origins))
        return 1.0 if away[0] <= away[1] else -1.0

    def mirrored(self, name: str, branch: float, group: Group, dyad: Dyad) -> None:
        """A note where a rule of the file chooses the mode that the sketch doesn't show."""
        for point, rule in drawn_rules(self.quantities.mechanism).items():
            try:
                drawn = self.sketched(point, rule, group, dyad)
            except DimensionError:  # a place that no length is derived from
                continue
            if drawn == -branch:
                said, other, links = self.assembly.rules[group], group.rule(-branch), enumerated(group.links)
                data = {"rule": said, "other": other, "links": links, "point": point}
                self.assembly.notes.append(Finding("plausible.mirrored", ("assembly", name), data, severity="note"))
                return

    def unknowns(self, higher_group: HigherGroup) -> list[float]:
        """A higher group's coordinates at the start pose: Newton from its sketch. Raises :class:`_CannotStart`."""
        every = {n: self.geometry.position(r.sketch) for n, r in self.rules.items() if r.sketch is not None}
        sketch = {name: place for name, place in every.items() if self.owner(name, higher_group.links)}
        self.used |= sketch.keys()
        self.quantities.phases |= drawn_phases(self.motion, higher_group, sketch, self.drives)
        if self.structure.drawn is not None:
            found = assemble_as_drawn(self.motion, higher_group, self.structure.drawn, self.drives)
            if found is not None:
                self.assembly.starts[higher_group] = found
                return found
        if not sketch and (found := only_coordinates(self.motion, higher_group, self.drives)) is not None:
            self.assembly.starts[higher_group] = found
            return found
        if not sketch:
            wanted = [
                name for pin in self.structure.topology.pins.values() for name in self.unplaced(pin, higher_group)
            ]
            wanted = wanted or self.untied(higher_group)
            data = {"pins": Joined(wanted), "first": wanted[0] if wanted else "C"}
            self.note("assembly.no-sketch", ("assembly",), links=Joined(higher_group.links), **data)
            raise _CannotStart
        found = assemble_higher_group(self.motion, higher_group, sketch, self.drives)
        if found is None:
            self.not_found(higher_group, sketch)
            raise _CannotStart
        self.assembly.starts[higher_group] = found
        return found

    def not_found(self, higher_group: HigherGroup, sketch: Mapping[str, Pair]) -> None:
        """Why a higher group has no assembly: a prescribed place that is out of reach, else that none was found."""
        if (far := out_of_reach(self.motion, higher_group, self.drives)) is not None:
            unit, size = self.quantities.unit_of(LENGTH)
            wide, by = far.distance > far.limit, f"{abs(far.distance - far.limit) / size:.4g} {unit}"
            limit, distance = (f"{length / size:.6g} {unit}" for length in (far.limit, far.distance))
            data = {"drive": far.drive, "point": far.point, "pin": far.pin, "links": enumerated(far.links)}
            data |= {"distance": distance, "short": Term("reach-most" if wide else "reach-least", limit=limit, by=by)}
            self.note("assembly.out-of-reach", ("drives", far.drive), **data)
            return
        drawn = any(isinstance(self.rules[name], Drawn) for name in sketch)
        where = Term("places-of-sketch" if drawn else "places-of-assembly")
        first = higher_group.links[0]
        singular = sketch and closes_in_a_singular_pose(self.motion, higher_group, dict(sketch), self.drives)
        code = "assembly.singular-start" if singular else "assembly.not-found"
        self.note(code, ("links", first), links=Joined(higher_group.links), where=where)

    def unplaced(self, pin: Pin, higher_group: HigherGroup) -> list[str]:
        """The name by which a sketch gives a pin's place, where only links of the higher group, or later ones, are on
        it."""
        inside = [point for link, point in pin.members if link in higher_group.links]
        return [] if set(pin.links) & self.motion.bodies.keys() else inside[:1]

    def untied(self, higher_group: HigherGroup) -> list[str]:
        """The points of a higher group's links that aren't on known links: a sketch of one of them places its link."""
        links = self.quantities.mechanism.links
        placed = self.motion.bodies.keys() - {*higher_group.links}
        known = {point for link in placed for point in links[link].points}
        return [point for link in higher_group.links for point in links[link].points if point not in known]

    def owner(self, point: str, links: Sequence[str]) -> str | None:
        """The first of some links that carries a point."""
        every = self.quantities.mechanism.links
        return next((link for link in links if point in every[link].points), None)

    def pin_names(self, joint: str) -> set[str]:
        """A pin's name and the names of its points."""
        pin = self.structure.topology.pins.get(joint)
        return {joint} | ({point for _, point in pin.members} if pin else set())

    def rule(self, name: str, rule: AssemblyRule, group: Group, dyad: Dyad) -> float:
        """+1 or -1 where the rule speaks of this group, 0 where it doesn't, NaN where it can't decide."""
        if rule.sketch is not None:
            return self.sketched(name, rule, group, dyad)
        if rule.word in ("open", "crossed"):
            four = group.signature == "RRR" and name in self.pin_names(group.inner.joint)
            return self.four_bar(name, rule, group, dyad) if four else 0.0
        joints = {"first": group.outer[0], "second": group.outer[1], "inner": group.inner}
        names = {role: self.pin_names(c.joint) for role, c in joints.items()}
        told = [
            (sign, wanted)
            for sign, templates in zip((1.0, -1.0), dyad.rules, strict=False)
            for role, wanted in map(_template, templates)
            if name in names[role] and (rule.along in names[wanted.along] if wanted.along else rule.along is None)
        ]
        for sign, wanted in told:
            if rule.word == wanted.word and all(
                point in names[role] for point, role in zip(rule.reference, wanted.reference, strict=True)
            ):
                return sign
        if told:
            self.note("assembly.wrong-pins", ("assembly", name), point=name, options=self.options(group))
        return math.nan if told else 0.0

    def four_bar(self, name: str, rule: AssemblyRule, group: Group, dyad: Dyad) -> float:
        """Open: at the start pose the inner pin lies across the outer pins' line from the four-bar's fourth pin."""
        first, second = dyad.first, dyad.second
        assert isinstance(first, OuterPin)
        assert isinstance(second, OuterPin)
        opposite = self.opposite_pin(group)
        if opposite is None:
            self.note("assembly.not-four-bar", ("assembly", name), point=name, options=self.options(group))
            return math.nan
        line = second.base.now.minus(first.base.now)
        side = line.cross(opposite.minus(first.base.now))
        if abs(side) < 1e-9 * line.dot(line):
            self.note("assembly.ambiguous", ("assembly", name), point=name, options=self.options(group))
            return math.nan
        return math.copysign(1.0, -side if rule.word == "open" else side)

    def opposite_pin(self, group: Group) -> Pair | None:
        """The pin that joins the two known links of the group to each other: the fourth pin of a four-bar."""
        a, b = group.bases
        for c in self.structure.topology.connections:
            pin = self.structure.topology.pins.get(c.joint)
            if pin is not None and {c.a, c.b} == {a, b}:
                return self.motion.bodies[a].point(self.geometry.point(a, pin.point(a))).now
        return None

    def sketched(self, name: str, rule: AssemblyRule, group: Group, dyad: Dyad) -> float:
        """The mode in which the named point of one of the group's links comes nearest to its sketched place."""
        links = self.quantities.mechanism.links
        link = next((link for link in group.links if name in links[link].points), None)
        known = [base for base in self.motion.bodies if base not in group.links]
        if link is None or any(name in links[base].points for base in known):
            return 0.0
        if dyad.shortfall() is not None:
            return 1.0
        assert rule.sketch is not None
        goal, local = self.geometry.position(rule.sketch), self.geometry.point(link, name)
        away, places = [], []
        for sign in (1.0, -1.0):
            dyad.solve(sign, 0)  # puts the group's links into the motion
            places.append(self.motion.bodies[link].point(local).now)
            away.append(math.hypot(*places[-1].minus(goal)))
        alike = math.hypot(*places[0].minus(places[1])) < 1e-7 * max(map(abs, (*goal, *places[0])))
        if alike or abs(away[0] - away[1]) < 1e-6 * max(away):
            if not isinstance(rule, Drawn):  # of drawn points others may tell
                self.note("assembly.ambiguous", ("assembly", name), point=name, options=self.options(group))
            return math.nan
        return 1.0 if away[0] < away[1] else -1.0

    def options(self, group: Group) -> str:
        """How a group's two modes may be written."""
        return f"'{group.rule(1.0)}' / '{group.rule(-1.0)}'"


def _template(text: str) -> tuple[str, AssemblyRule]:
    """A dyad's rule with the roles of its joints for names: whose place it states, and the rule."""
    role, rule = text.format(first="first", second="second", inner="inner").split(": ")
    return role, AssemblyRule(rule)


def shortfall_data(quantities: Quantities, group: Group, distance: float, limit: float) -> dict[str, Any]:
    """The data of a group that can't close: the distance (m) between its outer joints and the one it can span."""
    unit, size = quantities.unit_of(LENGTH)
    joints: tuple[Connection, ...] = group.outer
    by, wide = f"{abs(distance - limit) / size:.4g}", distance > limit
    return {
        "links": enumerated(group.links),
        "joints": enumerated([c.joint for c in joints]),
        "distance": f"{distance / size:.6g}",
        "limit": f"{limit / size:.6g}",
        "by": by,
        "unit": unit,
        "short": Term("gap-wide" if wide else "gap-narrow", by=by, limit=f"{limit / size:.6g}", unit=unit),
        "lengths": Term("lengths-longer" if wide else "lengths-equal", by=by, unit=unit),
    }


def shortfall_at(
    quantities: Quantities,
    structure: Structure,
    branches: Mapping[Group, float],
    drives: Mapping[str, float],
    failing: Group,
    unknowns: Unknowns,
    parameters: Mapping[str, float] | None = None,
) -> tuple[float, float]:
    """The distance (m) that a group must span at a pose at which it can't close, and the nearest that it can; at the
    nominal ``parameters`` or at others."""
    found: list[tuple[float, float]] = []

    def branch(group: Group, dyad: Dyad) -> float:
        if group == failing and (shortfall := dyad.shortfall()) is not None:
            found.append(shortfall)
            raise _CannotStart
        return branches.get(group, 1.0)

    geometry = Geometry(quantities, quantities.parameters if parameters is None else parameters)
    with suppress(_CannotStart, ZeroDivisionError), np.errstate(all="ignore"):
        solve_motion(structure, geometry, {name: Jet([value]) for name, value in drives.items()}, branch, unknowns)
    return found[0] if found else (math.nan, math.nan)
