"""Structure: joints, mobility and the decomposition into Assur groups."""

from linkwright.model.mechanism import FRAME
from linkwright.structure.decomposition import decompose, decompose_without
from linkwright.structure.releases import Release, SelfStress
from linkwright.structure.steps import Chain, Driven, Group, HigherGroup, LinkPlacement, Step, Structure, Wedge
from linkwright.structure.topology import Connection, Topology

__all__ = [
    "FRAME",
    "Chain",
    "Connection",
    "Driven",
    "Group",
    "HigherGroup",
    "LinkPlacement",
    "Release",
    "SelfStress",
    "Step",
    "Structure",
    "Topology",
    "Wedge",
    "decompose",
    "decompose_without",
]
