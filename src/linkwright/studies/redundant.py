"""Studies and exports that don't take redundant mechanisms: refused by name."""

from __future__ import annotations

from linkwright.findings import Finding, Joined
from linkwright.structure import Structure


def refused_redundant(structure: Structure, owner: object, path: tuple[str, str]) -> list[Finding]:
    """That a study or export, at its ``path``, can't be had of a redundant mechanism."""
    if not structure.releases or getattr(owner, "redundant", False):
        return []
    joints = Joined(structure.spare_joints)
    return [Finding("structure.redundant-study", path, {"name": path[1], "joints": joints})]
