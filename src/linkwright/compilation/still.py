"""A mechanism without drives, compiled at the pose at which it stands."""

from __future__ import annotations

from pathlib import Path

from linkwright.compilation.pipeline import prepare
from linkwright.compilation.stages import Uses
from linkwright.findings import Finding, Joined
from linkwright.graph.assembly import Assembly
from linkwright.graph.standing import standing
from linkwright.kernels.still import Still
from linkwright.model.mechanism import Mechanism
from linkwright.structure import Structure

HELD = ("structure.overconstrained", "structure.redundant", "structure.loop-of-slides")
"""What may be said of a structure that stands all the same."""


def examine_still(
    mechanism: Mechanism, folder: Path | None = None, uses: Uses = ()
) -> tuple[Still | None, list[Finding]]:
    """As :func:`linkwright.compilation.examine`, of a mechanism that nothing drives."""
    made = prepare(mechanism, folder, uses, driven=False)
    findings = [finding for finding in made.findings if finding.code not in HELD]
    if mechanism.drives and not findings:
        findings = [Finding("reactions.drives", ("drives",), {"names": Joined(mechanism.drives)})]
    if findings:
        return None, findings
    system, z, findings = standing(made.quantities, made.structure)
    if z is None:
        return None, made.spelled.with_file_paths(findings)
    structure = Structure(made.structure.topology, ())
    still = Still(
        made.mechanism,
        made.quantities,
        structure,
        Assembly(),
        laws={},
        tables=made.tables,
        plane=made.spelled.plane,
        folder=folder,
        system=system,
        z=z,
    )
    return still, [*made.spelled.warnings]
