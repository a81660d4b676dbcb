"""Studies and exports that don't take redundant mechanisms: refused by name."""

from __future__ import annotations

from linkwright.findings import Finding, Joined
from linkwright.results import Run
from linkwright.structure import Structure


def refused_redundant(structure: Structure, owner: object, path: tuple[str, str]) -> list[Finding]:
    """That a study or export, at its ``path``, can't be had of a redundant mechanism."""
    if not structure.releases or getattr(owner, "redundant", False):
        return []
    joints = Joined(structure.spare_joints)
    return [Finding("structure.redundant-study", path, {"name": path[1], "joints": joints})]


def with_redundant_joints(run: Run, findings: list[Finding]) -> list[Finding]:
    """Findings on singular poses of a run; of a redundant mechanism with a remark that all joints together may have
    none there."""
    structure = run.compiled.structure
    if not structure.releases:
        return findings
    path = ("joints", structure.spare_joints[0])
    data = {"joints": Joined(structure.spare_joints)}
    return [*findings, Finding("motion.redundant-joints", path, data, severity="warning")]
