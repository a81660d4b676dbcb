"""Structure: joints, mobility and the decomposition into Assur groups."""

from linkwright.model.mechanism import FRAME
from linkwright.structure.decomposition import decompose
from linkwright.structure.steps import Chain, Cluster, Driven, Edge, Group, Step, Structure, Wedge
from linkwright.structure.topology import Connection, Topology

__all__ = [
    "FRAME",
    "Chain",
    "Cluster",
    "Connection",
    "Driven",
    "Edge",
    "Group",
    "Step",
    "Structure",
    "Topology",
    "Wedge",
    "decompose",
]
