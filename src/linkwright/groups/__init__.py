"""The Assur groups, one file each, found by signature (outer, inner, outer joint)."""

from linkwright.groups import prp, rpp, rpr, rrp, rrr  # noqa: F401  (each registers itself)
from linkwright.groups.dyad import REGISTRY, Dyad, Solved

__all__ = ["REGISTRY", "Dyad", "Solved"]
