"""Structure: joints, mobility and the decomposition into Assur groups."""

from linkwright.structure.decomposition import Chain, Cluster, Driven, Edge, Group, Structure, decompose
from linkwright.structure.topology import FRAME, Connection, Topology

__all__ = ["FRAME", "Chain", "Cluster", "Connection", "Driven", "Edge", "Group", "Structure", "Topology", "decompose"]
