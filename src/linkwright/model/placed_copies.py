"""Copies of sub-assemblies as they stand in a mechanism: which names are theirs, and where they come from."""

from __future__ import annotations

from collections.abc import Container, Iterable, Mapping
from dataclasses import replace

from linkwright.data_classes import dataclass
from linkwright.expressions.fields import FrozenDict
from linkwright.findings import Finding
from linkwright.model.cylinders import with_cylinders
from linkwright.model.mechanism import FRAME, Mechanism
from linkwright.model.renamed import NAMESPACES, Renaming, namespace
from linkwright.model.sections import Sections

Path = tuple[str | int, ...]

SECTIONS = tuple(name for name in Sections.model_fields if name not in ("copies", "sketch"))
"""The sections that a copy adds to; a sketch has become lengths by then."""
REFERRING = ("assembly", "require")
"""The sections whose keys are names from other ones."""
ALL = ("element", *dict.fromkeys(NAMESPACES.values()))
OF_PORTS = ("element", "function", "window")
"""The namespaces of ports: values and results have their own."""


@dataclass(frozen=True)
class PlacedCopy:
    """A copy as it stands in the whole: the ``path`` of its entry in the file, the sub-assembly ``of`` which it is.

    ``names`` has the names in the sub-assembly by those of the copy; ``owned`` the sections and names of its entries,
    ``points`` its points; ``shared`` the links of others that it adds points to. ``parameters`` are all of its own and
    of copies within; ``given`` has the places of those that have a value of their own.
    """

    path: Path
    of: str
    names: Mapping[str, str]
    owned: frozenset[tuple[str, str]]
    points: frozenset[str]
    shared: Mapping[str, str]
    given: Mapping[str, Path]
    parameters: frozenset[str]
    within: tuple[Path, ...] = ()
    """The entries of the copies in which it stands, the outermost first."""

    def renamed(self, renaming: Renaming, path: Path) -> PlacedCopy:
        """The same within a copy of what it stands in, whose entry stands at ``path``."""

        def new(name: str) -> str:
            return next((of[name] for of in renaming.names.values() if name in of), name)

        return replace(
            self,
            names=FrozenDict({new(name): old for name, old in self.names.items()}),
            owned=frozenset((section, renaming.name(name, namespace(section))) for section, name in self.owned),
            points=frozenset(map(renaming.name, self.points)),
            shared=FrozenDict({renaming.name(link): old for link, old in self.shared.items()}),
            given=FrozenDict({renaming.name(name, "parameter"): path for name, path in self.given.items()}),
            within=(path, *self.within),
            parameters=frozenset(renaming.name(name, "parameter") for name in self.parameters),
        )


@dataclass(frozen=True)
class Placed:
    """A mechanism whose copies are spelled out; ``failed`` are the names of those that couldn't be."""

    mechanism: Mechanism
    copies: tuple[PlacedCopy, ...] = ()
    findings: tuple[Finding, ...] = ()
    failed: frozenset[str] = frozenset()

    def parameter_path(self, name: str) -> tuple[str, ...]:
        """Where in the file a parameter has, or may be given, a value of its own: one of a copy in the copy's entry."""
        for copy in self.copies:
            if copy.path[0] == "copies" and name in copy.parameters:
                return ("copies", str(copy.path[1]), "parameters", copy.names[name])
        return ("parameters", name)


def placed_copy(
    path: Path, of: str, flat: Placed, renaming: Renaming, ports: Container[str], given: Mapping[str, Path]
) -> PlacedCopy:
    """A copy whose entry stands at ``path``, of a sub-assembly that is ``flat``, under new names; ``given`` has the
    places of the parameters that it states."""
    m = flat.mechanism
    names = {new: old for space in renaming.names.values() for old, new in space.items() if old not in ports}
    theirs = {(section, new) for one in flat.copies for section, new in one.owned}
    shared = {name for name in m.links if name == FRAME or name in ports}
    owned: dict[tuple[str, str], str] = {}
    for section in SECTIONS:
        for old in getattr(m, section):
            if (section, old) not in theirs and not (section == "links" and old in shared):
                owned[section, renaming.name(old, namespace(section))] = old
    points = {point for link in m.links.values() for point in link.points if point not in ports}
    points -= {point for one in flat.copies for point in one.points}
    return PlacedCopy(
        path,
        of,
        FrozenDict({**names, **{new: old for (_, new), old in owned.items()}}),
        frozenset(owned),
        frozenset(map(renaming.name, points)),
        FrozenDict({renaming.name(link): link for link in shared}),
        FrozenDict(given),
        frozenset(renaming.names["parameter"].values()),
    )


def own_names(m: Mechanism, ports: Iterable[str] = ()) -> dict[str, list[str]]:
    """The names that a mechanism declares, also by short forms, in each namespace; without the frame and the ports."""
    full, shared = with_cylinders(m), {FRAME, *ports}
    found: dict[str, dict[str, None]] = {space: {} for space in ALL}
    for section in SECTIONS:
        if section not in REFERRING:
            found[namespace(section)] |= dict.fromkeys(getattr(full, section))
    found["element"] |= dict.fromkeys(point for link in full.links.values() for point in link.points)
    return {
        space: [name for name in names if space not in OF_PORTS or name not in shared] for space, names in found.items()
    }
