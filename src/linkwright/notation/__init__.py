"""The notation of the project: jets, plane vectors, rigid bodies. See docs/notation.md."""

from linkwright.notation.jets import MAX_ORDER, Jet, Scalar
from linkwright.notation.planar import Body, Pair, Vec, Wrench

__all__ = ["MAX_ORDER", "Body", "Jet", "Pair", "Scalar", "Vec", "Wrench"]
