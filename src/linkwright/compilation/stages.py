"""The stages of compiling, each a function from what the ones before it gave; :mod:`~linkwright.compilation.pipeline`
has their order."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import field
from functools import partial
from pathlib import Path

from linkwright.data_classes import dataclass
from linkwright.findings import Finding, Joined
from linkwright.graph import assembly as modes
from linkwright.graph.assembly import Assembly
from linkwright.kernels.followers import follower_faults
from linkwright.kernels.law import DriveLaw
from linkwright.kernels.laws import action_tables, drive_laws, values_at
from linkwright.kernels.motions import StatedMotion, motion_laws
from linkwright.kernels.starts import moved_starts
from linkwright.kernels.tables import StatedTable
from linkwright.model.check import check_names, check_values
from linkwright.model.desugar import Spelled, spell_out
from linkwright.model.mechanism import Mechanism
from linkwright.model.places import ExpressionPlace
from linkwright.model.plausible import implausible
from linkwright.model.quantities import Quantities
from linkwright.model.unused_parameters import unused_parameters
from linkwright.structure import Structure, Topology, decompose

Uses = Sequence[ExpressionPlace] | Callable[[Mechanism], Sequence[ExpressionPlace]]
"""Expressions outside a mechanism that tell the units of what it leaves open, or a function that finds them for one
whose short forms are spelled out."""


@dataclass
class Laws:
    """The functions that a file states, by name: of ``drives`` over the time, the ``motions`` that these ask, the
    ``tables`` that acting elements ask."""

    drives: dict[str, DriveLaw] = field(default_factory=dict)
    motions: dict[str, StatedMotion] = field(default_factory=dict)
    tables: dict[str, StatedTable] = field(default_factory=dict)


def desugar(mechanism: Mechanism) -> Spelled:
    """Sketch, cylinders and followers as the links, joints, lengths and motions that they stand for."""
    return spell_out(mechanism)


def check(spelled: Spelled, driven: bool = True) -> list[Finding]:
    """What is wrong with names and references. One that needn't be ``driven`` needs no drive."""
    missing = "model.no-drive" if spelled.findings or not driven else ""  # a drive with a fault is one
    named = (f for f in check_names(spelled.mechanism, spelled.fields) if f.code != missing)
    found = [*spelled.findings, *(f for f in named if f not in spelled.findings)]
    if [finding.code for finding in found] == ["model.no-drive"]:
        return _immobile(Topology(spelled.mechanism)) or found
    return found


def _immobile(topology: Topology) -> list[Finding]:
    """That a mechanism without drives couldn't move either."""
    if topology.gruebler > 0:
        return []
    return [Finding("model.no-freedom", ("drives",), {"mobility": topology.gruebler})]


def quantities(spelled: Spelled, uses: Uses, reported: Sequence[Finding]) -> tuple[Quantities, list[Finding]]:
    """The numbers in SI, and what is wrong with their dimensions besides what is ``reported``."""
    m = spelled.mechanism
    made = Quantities(m, uses(m) if callable(uses) else uses, spelled.fields)
    return made, [finding for finding in made.findings if not _is_reported(finding, reported)]


def _is_reported(finding: Finding, others: Sequence[Finding]) -> bool:
    """Whether a finding was made before. A law's `sketch` without value isn't an unknown parameter besides."""
    return any(other.path == finding.path and other.code in (finding.code, "sketch.no-value") for other in others)


def laws(q: Quantities, folder: Path | None, named: bool) -> tuple[Laws, list[Finding]]:
    """Laws and tables, with what is wrong with them and with all other numbers; none where dimensions are unclear.
    Names are sound where ``named``."""
    if q.findings:
        return Laws(), []
    motions, unmade = motion_laws(q)
    drives, unstated = drive_laws(q, folder, motions, named=named)
    tables, unread = action_tables(q, folder)
    wrong = [*check_values(q), *unmade, *unstated]
    # Where a number or a law is wrong, so are the values of followers.
    wrong += follower_faults(q, motions, {} if wrong else drives, named=named)
    return Laws(drives, motions, tables), [*wrong, *(fault for fault in unread if fault not in wrong)]


def structure(q: Quantities, stated: Laws, named: bool, redundancy: bool) -> tuple[Structure, list[Finding]]:
    """Driven links and groups in the order of solution, and why there are none. Where all else is sound, ``redundancy``
    has equations of joints looked for that follow from the others."""
    m = q.mechanism
    found = decompose(m) if named else Structure(Topology(m), ())
    if not (redundancy and found.findings):
        idle = redundancy and m.stiffness and not found.findings
        return found, [Finding("stiffness.no-effect", ("stiffness",), severity="note")] if idle else [*found.findings]
    from linkwright.graph.redundant import redundant

    spared = redundant(q, found, partial(values_at, stated.drives))
    q.signals.leave_undetermined(spared[0].self_stress.components)
    return spared


def assemble(q: Quantities, found: Structure, stated: Laws) -> Assembly:
    """The assembly mode of each group and the start pose."""
    return modes.assemble(q, found, values_at(stated.drives, 0.0))


def warnings(spelled: Spelled, q: Quantities, stated: Laws, assembly: Assembly) -> list[Finding]:
    """What is odd with a mechanism that can run."""
    moved = moved_starts(spelled, q, stated.drives)
    # Of a mechanism without a sketch, whose lengths all stand in it, files alone are told (app/job.py).
    unused = unused_parameters(spelled.written, q) if spelled.written.sketch else ()
    odd = [*moved, *unused, *implausible(q), *([] if moved else assembly.notes)]
    return [*spelled.warnings, *_moments(q), *spelled.with_file_paths(odd)]


def _moments(q: Quantities) -> Iterator[Finding]:
    """A warning that moments of slides in a loop of slides aren't determined."""
    if slides := q.signals.looped:
        data = {"joints": Joined(slides)}
        yield Finding("structure.moments-indeterminate", ("joints", slides[0]), data, severity="warning")
