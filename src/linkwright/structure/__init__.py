"""Structure: joints, mobility and the decomposition into Assur groups."""

from linkwright.model.mechanism import FRAME
from linkwright.structure.decomposition import decompose
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
    "Step",
    "Structure",
    "Topology",
    "Wedge",
    "decompose",
]
