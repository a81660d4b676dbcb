"""A model's short forms spelled out: what the file says in one line, as the links and joints that it stands for."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import field, replace
from functools import cached_property

from linkwright.data_classes import dataclass
from linkwright.findings import Finding
from linkwright.model.copied_places import copied_path, with_copied_places
from linkwright.model.copies import with_copies
from linkwright.model.cylinders import cylinder_faults, cylinder_path, with_cylinders
from linkwright.model.followers import follower_entries, with_followers
from linkwright.model.mechanism import Mechanism
from linkwright.model.placed_copies import PlacedCopy
from linkwright.model.places import find_typed_values
from linkwright.model.plane import LinkagePlane, in_plane
from linkwright.model.sketch import drawn_values, sketch_faults, sketch_path, with_sketch
from linkwright.model.walk import Found

Path = tuple[str | int, ...]


@dataclass(frozen=True)
class Spelled:
    """A mechanism without short forms, made from the ``written`` one; ``findings`` says what can't be spelled out.
    ``placed`` is the same with its copies of sub-assemblies spelled out alone, which are its ``copies``.

    ``plane`` is where the sketch lies in the vehicle, if it has three coordinates, ``warnings`` what is odd with it.
    ``drawn`` has the values in the sketch, as expressions, of drives that are given another start than ``sketch``.
    """

    written: Mechanism
    placed: Mechanism
    mechanism: Mechanism
    findings: tuple[Finding, ...] = ()
    plane: LinkagePlane | None = None
    warnings: tuple[Finding, ...] = ()
    drawn: Mapping[str, str] = field(default_factory=dict)
    copies: tuple[PlacedCopy, ...] = ()

    @cached_property
    def fields(self) -> list[Found]:
        """What the typed fields of the mechanism hold."""
        return find_typed_values(self.mechanism)

    def with_file_paths(self, findings: Iterable[Finding]) -> list[Finding]:
        """Findings with their places as the file has them."""
        return with_file_paths(self.written, findings)


def with_file_paths(m: Mechanism, findings: Iterable[Finding]) -> list[Finding]:
    """Findings on what a mechanism's short forms stand for, with their places as it is written.

    What is wrong with a place of the sketch spoils the lengths derived from it too, and is told at the place alone; a
    follower with a fault has no signals, which isn't told wherever they are named.
    """
    placed = with_copies(m)
    found = [replace(f, path=_short_path(placed.mechanism, f.path)) for f in findings]
    told = {f.code for f in found if len(f.path) == 2 and f.path[0] == "sketch"}
    declared = {name for _, name, _, _ in follower_entries(placed.mechanism)}
    found = [f for f in found if f.code != "name.unknown-element" or f.data["name"] not in declared]
    found = [f for f in found if f.path != ("sketch",) or f.code not in told]
    return with_copied_places(m, placed, found)


def file_paths(m: Mechanism, paths: Iterable[Path]) -> list[Path]:
    """The places in the file of those of a mechanism's spelled out form."""
    placed = with_copies(m)
    return [copied_path(m, placed, _short_path(placed.mechanism, path)) for path in paths]


def _short_path(m: Mechanism, path: Path) -> Path:
    """The place of the sketch or the cylinder that a place follows from."""
    return next((at for of in (cylinder_path, sketch_path) if (at := of(m, path))), path)


def spell_out(written: Mechanism) -> Spelled:
    """The mechanism that the solver sees, as far as the short forms are sound."""
    placed = with_copies(written)
    m = placed.mechanism
    flat = in_plane(m)
    plain, unfollowed = with_followers(with_cylinders(with_sketch(flat.mechanism)))
    wrong = tuple(finding for finding in flat.findings if finding.severity == "error")
    odd = [finding for finding in placed.findings if finding.severity != "error"]
    unplaced = (finding for finding in placed.findings if finding not in odd)
    findings = (*unplaced, *sketch_faults(m), *wrong, *cylinder_faults(m), *unfollowed)
    warnings = (*odd, *(finding for finding in flat.findings if finding not in wrong))
    return Spelled(written, m, plain, findings, flat.plane, warnings, drawn_values(flat.mechanism), placed.copies)
