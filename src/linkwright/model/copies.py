"""Copies of sub-assemblies spelled out: the links, joints and all else that they stand for, under names of their own.

What a sub-assembly names means its own elements first, then those of the file. Own names get the copy's name in front
(``left_coupler``), ports become what the copy is joined to. The frame is the file's own: its points in a sub-assembly
are added to it, shifted by ``at``. Copies within sub-assemblies are spelled out in these first, once for all.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import field, replace
from typing import Any

from pydantic_core import PydanticCustomError

from linkwright.data_classes import dataclass
from linkwright.elements.mirror import NotMirroredError, mirrored
from linkwright.expressions.fields import AssemblyRule, Expression, FrozenDict
from linkwright.expressions.parser import names_at
from linkwright.expressions.unknown import near, unknown
from linkwright.expressions.written import MAX_NAME
from linkwright.findings import Finding, Joined
from linkwright.model.copy_entry import NO_TOLERANCE, Copy, CopyParameter
from linkwright.model.mechanism import FRAME, MAX_ENTRIES, MAX_LINKS, Mechanism, mechanism_of
from linkwright.model.mirrored_signals import mirror_of, mirrored_window
from linkwright.model.number_places import stands_for_number
from linkwright.model.parts import Link, Parameter
from linkwright.model.placed_copies import (
    ALL,
    OF_PORTS,
    REFERRING,
    SECTIONS,
    Path,
    Placed,
    PlacedCopy,
    own_names,
    placed_copy,
)
from linkwright.model.renamed import Renaming, namespace
from linkwright.model.shifted import shifted_link, shifted_rule
from linkwright.model.sketch import Drawn, sketch_faults, with_sketch
from linkwright.model.walk import all_fields

MAX_DEPTH = 20
"""So many sub-assemblies may stand in one another."""
UNMIRRORED = ("parameters", "tables", "laws", "measures", "require")
"""The sections that have no place in the plane."""


def with_copies(m: Mechanism) -> Placed:
    """The mechanism with what its copies stand for, as far as they are sound."""
    if not m.copies and not m.subassemblies:
        return Placed(m)
    placing = _Placing(m)
    placed = placing.place(m, ())
    used = _used(m)
    for name in m.subassemblies:
        if name not in used:
            unused = Finding("subassembly.unused", ("subassemblies", name), {"name": name}, severity="warning")
            placing.findings.append(unused)
    return replace(placed, findings=tuple(placing.findings))


def _used(m: Mechanism) -> set[str]:
    """The sub-assemblies of which there is a copy in the mechanism, or in what it has copies of."""
    used: set[str] = set()
    open_ = [m.copies]
    while open_:
        more = {copy.of for copy in open_.pop().values()} & m.subassemblies.keys() - used
        used |= more
        open_ += (m.subassemblies[name].copies for name in more)
    return used


@dataclass
class _Made:
    """What one copy adds, by section, and how it stands in the whole."""

    entries: dict[str, dict[str, Any]]
    shared: dict[str, Link]
    """The points that it adds to links of others."""
    copies: tuple[PlacedCopy, ...] = ()
    turned: frozenset[str] = frozenset()
    """Those of its links that are mirrored."""


@dataclass
class _Placing:
    m: Mechanism
    flat: dict[str, Placed | None] = field(default_factory=dict)
    open: list[str] = field(default_factory=list)
    findings: list[Finding] = field(default_factory=list)
    too_large: bool = False
    """Whether copies make more than a mechanism may have."""

    def note(self, code: str, path: Path, **data: Any) -> None:
        """Add a finding."""
        self.findings.append(Finding(code, path, data))

    def flattened(self, name: str) -> Placed | None:
        """What a sub-assembly consists of, without short forms of copies and sketches; ``None`` where it can't be."""
        if name not in self.flat:
            self.flat[name] = None  # while it is being made
            self.open.append(name)
            self.flat[name] = self._flattened(name)
            self.open.pop()
        return self.flat[name]

    def _flattened(self, name: str) -> Placed | None:
        path: Path = ("subassemblies", name)
        stated = self.m.subassemblies[name]
        own = mechanism_of(stated)
        if deep := [point for point, place in own.sketch.items() if place.third is not None]:
            self.note("subassembly.sketch", (*path, "sketch", deep[0]), name=name)
            return None
        placed = self.place(own, path, stated.ports)
        self.findings += (replace(f, path=(*path, *f.path)) for f in sketch_faults(placed.mechanism))
        made = with_sketch(placed.mechanism)
        drawn = [point for point in stated.ports if isinstance(made.assembly.get(point), Drawn)]
        rules = {point: rule for point, rule in made.assembly.items() if point not in drawn}
        made = made.model_copy(update={"assembly": FrozenDict(rules), "sketch": FrozenDict()})
        self._check_ports(made, stated.ports, path)
        if placed.failed and not placed.mechanism.links:
            return None
        return replace(placed, mechanism=made)

    def _check_ports(self, m: Mechanism, ports: tuple[str, ...], path: Path) -> None:
        """Note what is wrong with ports, and with links that aren't the sub-assembly's own."""
        known = Renaming({space: {} for space in ALL})
        for section, (name, spec) in all_fields(type(m)).items():
            if section in SECTIONS:
                known.value(getattr(m, name), spec)
        with_ports = [name for name in SECTIONS if name not in REFERRING and namespace(name) in OF_PORTS]
        declared = {key: section for section in with_ports for key in getattr(m, section)}
        for i, port in enumerate(ports):
            section = declared.get(port, "links")
            if section != "links" or port == FRAME:
                self.note("subassembly.port-own", (*path, "ports", i), name=port)
            elif port not in known.used and port not in m.links:
                self.note("subassembly.port-unused", (*path, "ports", i), name=port)
        for name, link in m.links.items():
            if name not in (FRAME, *ports):
                continue
            if link.mass is not None:
                self.note("subassembly.mass", (*path, "links", name, "mass"), name=name)
            for point in (point for point in link.points if point in ports):
                self.note("subassembly.port-given", (*path, "links", name, "points", point), point=point, link=name)

    def place(self, m: Mechanism, path: Path, ports: tuple[str, ...] = ()) -> Placed:
        """A mechanism, or what a sub-assembly consists of, with what its copies stand for."""
        entries: dict[str, dict[str, Any]] = {section: dict(getattr(m, section)) for section in SECTIONS}
        copies: list[PlacedCopy] = []
        failed: set[str] = set()
        turned = m.turned
        for name, copy in m.copies.items():
            at = (*path, "copies", name)
            if (count := len(copies) + 1 + self._copies_within(copy)) > MAX_ENTRIES:
                self._too_many(at, count, MAX_ENTRIES, "copies")
            made = None if self.too_large else self.copy(name, copy, at)  # each further copy would say so once more
            if made is None or not self._merge(entries, made, at):
                failed.add(name)
            else:
                copies += made.copies
                turned |= made.turned
        plain = {"copies": FrozenDict(), "subassemblies": FrozenDict()}
        merged = {section: FrozenDict(found) for section, found in entries.items()}
        self._check_joins(m, copies, {FRAME, *ports}, path)
        whole = m.model_copy(update=merged | plain).with_turned(turned)
        return Placed(whole, tuple(copies), failed=frozenset(failed))

    def _copies_within(self, copy: Copy) -> int:
        """The copies, of any depth, in what a copy is of."""
        able = copy.of in self.m.subassemblies and copy.of not in self.open and len(self.open) < MAX_DEPTH
        flat = self.flattened(copy.of) if able else None
        return 0 if flat is None else len(flat.copies)

    def _merge(self, entries: dict[str, dict[str, Any]], made: _Made, at: Path) -> bool:
        """Add what a copy stands for; what is there already is noted."""
        for section, added in made.entries.items():
            for name in added:
                if name in entries[section]:
                    self.note("subassembly.taken", at, name=name, section=section)
                    return False
            limit = MAX_LINKS if section == "links" else MAX_ENTRIES
            if (count := len(entries[section]) + len(added)) > limit:
                return self._too_many(at, count, limit, section)
        for name, link in made.shared.items():
            known = entries["links"].get(name)
            if known is not None and (count := len({**known.points, **link.points})) > MAX_ENTRIES:
                return self._too_many(at, count, MAX_ENTRIES, "points")
        for section, added in made.entries.items():
            entries[section] |= added
        for name, link in made.shared.items():
            if name == FRAME and name not in entries["links"]:  # as files begin with it
                entries["links"] = {FRAME: Link(points={}), **entries["links"]}
            if (known := entries["links"].get(name)) is not None:
                points = FrozenDict({**known.points, **link.points})
                entries["links"][name] = known.model_copy(update={"points": points})
        return True

    def _too_many(self, at: Path, count: int, limit: int, section: str) -> bool:
        """Note that a copy makes too much of something; nothing more is added then."""
        self.note("subassembly.too-many", at, count=count, limit=limit, section=section)
        self.too_large = True
        return False

    def _check_joins(self, m: Mechanism, copies: list[PlacedCopy], also: set[str], path: Path) -> None:
        """Note what copies are joined to and isn't there: neither in what they stand in nor in other copies. A name
        that several copies are joined to is a pin between these."""
        own = own_names(m)
        known = also.union(*(own[space] for space in OF_PORTS), *(copy.names for copy in copies))
        joined = Counter(target for copy in m.copies.values() for target in {*copy.join.values()})
        for name, copy in m.copies.items():
            for port, target in copy.join.items():
                if target not in known and joined[target] < 2:
                    data = {"name": target[:60], "near": near(target, sorted(known))}
                    self.note("name.unknown-element", (*path, "copies", name, "join", port), **data)

    def copy(self, name: str, copy: Copy, path: Path) -> _Made | None:
        """What a copy stands for; ``None`` where it can't be told, which is noted."""
        if copy.of not in self.m.subassemblies:
            self.findings.append(unknown("subassembly", (*path, "of"), copy.of, self.m.subassemblies))
            return None
        if copy.of in self.open:
            circle = Joined([*self.open[self.open.index(copy.of) :], copy.of], " > ")
            self.note("subassembly.circular", (*path, "of"), name=copy.of, circle=circle)
            return None
        if len(self.open) >= MAX_DEPTH:
            self.note("subassembly.deep", (*path, "of"), limit=MAX_DEPTH)
            self.too_large = True
            return None
        if (flat := self.flattened(copy.of)) is None:
            return None
        self._check_copy(copy, flat.mechanism, path)
        own = own_names(flat.mechanism, ports := self.m.subassemblies[copy.of].ports)
        new = {space: {one: f"{name}_{one}" for one in names} for space, names in own.items()}
        if long := [one for names in new.values() for one in names.values() if len(one) > MAX_NAME]:
            self.note("subassembly.long-name", path, name=long[0][:80], limit=MAX_NAME)
            return None
        joined = {port: copy.join.get(port, f"{name}_{port}") for port in ports}
        for space in OF_PORTS:
            new[space] = {**new[space], **joined}
        try:
            return self._made(name, copy, path, flat, Renaming(new), ports)
        except PydanticCustomError as error:  # an expression that has become too long
            data = dict(error.context or {})
            self.note(str(data.pop("code", "file.long")), path, **data)
            return None

    def _made(
        self, name: str, copy: Copy, path: Path, flat: Placed, renaming: Renaming, ports: tuple[str, ...]
    ) -> _Made:
        m, shared = flat.mechanism, (FRAME, *ports)
        mirror = mirror_of(m, renaming.names["element"], shared, copy.at)
        made = _Made({section: {} for section in SECTIONS}, {})
        for section, entries in made.entries.items():
            attribute, spec = all_fields(type(m))[section]
            for old, entry in getattr(m, attribute).items():
                value = renaming.value(entry, spec.item(0))
                if copy.mirrored and section not in UNMIRRORED:
                    try:
                        seen = mirrored_window if section == "windows" else mirrored
                        value = seen(value, renaming.name(old), mirror)
                    except NotMirroredError:
                        self.note("subassembly.mirrored", (*path, "mirrored"), name=old, section=section, of=copy.of)
                if section == "links" and len(value.points) < len(entry.points):
                    twice = Joined(one for one in entry.points if one in ports)
                    self.note("subassembly.same-point", (*path, "join"), link=old, points=twice)
                if section == "links" and old in shared:
                    made.shared[renaming.name(old)] = shifted_link(value, copy.at) if old == FRAME else value
                    continue
                key = renaming.key(old, spec) if section in REFERRING else renaming.name(old, namespace(section))
                entries[key] = shifted_rule(value, copy.at) if isinstance(value, AssemblyRule) else value
        given: dict[str, Path] = {}
        for old, stated in copy.parameters.items():
            if old in m.parameters:
                new = renaming.name(old, "parameter")
                made.entries["parameters"][new] = _given(stated, made.entries["parameters"][new])
                given[new] = (*path, "parameters", old)
        own = placed_copy(path, copy.of, flat, renaming, ports, given)
        within = frozenset(renaming.name(link) for link in m.turned)
        made.turned = within ^ mirror.links if copy.mirrored else within
        made.copies = (own, *(one.renamed(renaming, path) for one in flat.copies))
        return made

    def _check_copy(self, copy: Copy, m: Mechanism, path: Path) -> None:
        """Note what a copy states and its sub-assembly hasn't, and the other way round."""
        ports = self.m.subassemblies[copy.of].ports
        for port in copy.join:
            if port not in ports:
                data = {"name": port[:60], "of": copy.of, "near": near(port, ports)}
                self.note("subassembly.no-port", (*path, "join", port), **data)
        if missing := [port for port in ports if port not in copy.join]:
            self.note("subassembly.unjoined", path, ports=Joined(missing), of=copy.of, example=missing[0])
        for name, stated in copy.parameters.items():
            known = m.parameters.get(name)
            if known is None:
                data = {"name": name[:60], "of": copy.of, "near": near(name, [*m.parameters])}
                self.note("subassembly.no-parameter", (*path, "parameters", name), **data)
            elif known.tolerance is not None and stated.tolerance is None and _depends(stated.value):
                self.note("subassembly.tolerance", (*path, "parameters", name), name=name, value=stated.value.text[:60])


def _depends(value: Expression) -> bool:
    """Whether a value follows from other parameters."""
    names = (value.text[at.start : at.end] for at in names_at(value.text) if at.role == "parameter")
    return any(name != "pi" and not stands_for_number(name) for name in names)


def _given(stated: CopyParameter, known: Parameter) -> Parameter:
    """A parameter of a sub-assembly with the value that a copy gives it; its tolerance stays unless one is given."""
    tolerance = None if stated.tolerance == NO_TOLERANCE else stated.tolerance or known.tolerance
    return known.model_copy(update={"value": stated.value, "tolerance": tolerance, "note": stated.note or known.note})
