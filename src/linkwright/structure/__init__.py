"""Structure: joints, mobility and the decomposition into Assur groups."""

from linkwright.structure.decomposition import Driven, Group, Structure, decompose
from linkwright.structure.topology import FRAME, Connection, Topology

__all__ = ["FRAME", "Connection", "Driven", "Group", "Structure", "Topology", "decompose"]
