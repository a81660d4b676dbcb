"""The stages from a mechanism to one that is ready to run, in their order.

    desugar      short forms as the links, joints and lengths that they stand for
    check        names and references
    quantities   dimensions, bare numbers in SI
    laws         motions of drives, tables of acting elements; numbers that make no sense
    structure    driven links and Assur groups, in the order of solution
    assemble     the assembly mode of each group, the start pose

A stage gives its value and its findings; the next one goes on with what is sound, so that all findings come at once.
:func:`prepare` goes as far as what is known before the assembly modes are settled, :func:`examine` all the way.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from linkwright.compilation.stages import Laws, Uses, assemble, check, desugar, laws, quantities, structure, warnings
from linkwright.data_classes import dataclass
from linkwright.findings import Finding, raise_errors
from linkwright.kernels import Compiled
from linkwright.kernels.law import DriveLaw
from linkwright.kernels.motions import StatedMotion
from linkwright.kernels.tables import StatedTable
from linkwright.model.desugar import Spelled, with_file_paths
from linkwright.model.document import located
from linkwright.model.mechanism import Mechanism
from linkwright.model.model_file import read_model_file
from linkwright.model.named_numbers import NamedNumbers
from linkwright.model.quantities import Quantities
from linkwright.structure import Structure
from linkwright.structure.refusals import EXCESS


@dataclass
class Prepared:
    """A mechanism as far as it is known before its assembly modes are settled, its short forms spelled out."""

    spelled: Spelled
    quantities: Quantities
    structure: Structure
    stated: Laws
    findings: list[Finding]
    """What keeps it from being solved."""
    warnings: list[Finding]
    """What is odd with its structure."""

    @property
    def mechanism(self) -> Mechanism:
        """The mechanism that is solved."""
        return self.spelled.mechanism

    @property
    def laws(self) -> dict[str, DriveLaw]:
        """The law of each drive."""
        return self.stated.drives

    @property
    def motions(self) -> dict[str, StatedMotion]:
        """The motion laws by name, that drives ask."""
        return self.stated.motions

    @property
    def tables(self) -> dict[str, StatedTable]:
        """The tables by name, that acting elements ask."""
        return self.stated.tables


def prepare(mechanism: Mechanism, folder: Path | None = None, uses: Uses = (), driven: bool = True) -> Prepared:
    """Dimensions, drive laws and structure of a mechanism, with all findings on them; ``uses`` as for :func:`examine`.
    It needs drives, unless it isn't ``driven``."""
    spelled = desugar(mechanism)
    unnamed = check(spelled, driven)
    numbers, unclear = quantities(spelled, uses, unnamed)
    return _with_numbers(spelled, numbers, folder, unnamed, unclear, driven)


def _with_numbers(
    spelled: Spelled,
    numbers: Quantities,
    folder: Path | None,
    unnamed: Sequence[Finding],
    unclear: Sequence[Finding] = (),
    driven: bool = True,
) -> Prepared:
    """The stages that follow the dimensions, after the findings of those before."""
    stated, wrong = laws(numbers, folder, named=not unnamed)
    findings = [*unnamed, *unclear, *wrong]
    found, unsolved = structure(numbers, stated, named=not unnamed, redundancy=driven and not findings)
    if driven and findings:  # what is in excess may follow from the rest, which sound numbers alone tell
        unsolved = [finding for finding in unsolved if finding.code not in EXCESS]
    said = [f for f in unsolved if f.severity != "error"]
    wrong = [*findings, *(f for f in unsolved if f.severity == "error")]
    return Prepared(spelled, numbers, found, stated, *map(spelled.with_file_paths, (wrong, said)))


def examine(mechanism: Mechanism, folder: Path | None = None, uses: Uses = ()) -> tuple[Compiled | None, list[Finding]]:
    """Compile a mechanism as far as it goes, with all findings; ``folder`` is where its table files lie, ``uses`` the
    expressions of studies, which tell the units of what the mechanism leaves open.

    The result is ``None`` where an error stops it; warnings alone don't.
    """
    return _assembled(prepare(mechanism, folder, uses), folder, uses)


def _assembled(made: Prepared, folder: Path | None, uses: Uses = ()) -> tuple[Compiled | None, list[Finding]]:
    """The stages that follow the structure."""
    if made.findings:
        return None, made.findings
    assembly = assemble(made.quantities, made.structure, made.stated)
    if assembly.findings:
        return None, made.spelled.with_file_paths(assembly.findings)
    parts = (made.mechanism, made.quantities, made.structure, assembly, made.laws, made.tables, made.motions)
    odd = [*made.warnings, *warnings(made.spelled, made.quantities, made.stated, assembly)]
    compiled = Compiled(*parts, plane=made.spelled.plane, folder=folder, copies=made.spelled.copies)
    if made.quantities.signals.undetermined and (refused := _undetermined(compiled, uses)):
        return None, made.spelled.with_file_paths(refused)
    return compiled, odd


def _undetermined(compiled: Compiled, uses: Uses) -> list[Finding]:
    """What asks for reactions that a redundant mechanism leaves undetermined."""
    from linkwright.compilation.undetermined_uses import undetermined_uses

    others = uses(compiled.mechanism) if callable(uses) else uses
    return list(undetermined_uses(compiled, [*compiled.quantities.places, *others]))


def compile_model(model: str | Path | Mechanism, folder: str | Path | None = None) -> Compiled:
    """A model file, document or mechanism ready to run; studies aren't looked at.

    ``folder`` is where the tables of a document lie; those of a file lie beside it. Raises :class:`ModelError` with all
    findings, of a file with their lines.
    """
    if isinstance(model, Mechanism):
        return compile_mechanism(model, folder)
    read = read_model_file(Path(model))
    raise_errors(read.findings)
    assert read.document is not None
    compiled, findings = examine(read.document, Path(folder or Path(model).parent))
    return _sound((compiled, located(with_file_paths(read.document, findings), read.source)))


def compile_mechanism(mechanism: Mechanism, folder: str | Path | None = None) -> Compiled:
    """A mechanism ready to run. Raises :class:`ModelError` with every finding when it can't be."""
    return _sound(examine(mechanism, Path(folder) if folder else None))


def compile_named(named: NamedNumbers, folder: Path | None = None) -> Compiled:
    """The mechanism of named numbers ready to run, with the dimensions that they were named by. Raises
    :class:`ModelError` with every finding when it can't be."""
    made = _with_numbers(named.spelled, named.quantities, folder, check(named.spelled))
    return _sound(_assembled(made, folder))


def _sound(examined: tuple[Compiled | None, list[Finding]]) -> Compiled:
    compiled, findings = examined
    raise_errors(findings)
    assert compiled is not None
    return compiled
