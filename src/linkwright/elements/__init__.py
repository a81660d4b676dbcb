"""The kinds of elements that a mechanism is made of, one file each, found by name."""

from linkwright.elements.force import FORCES, ForceContext, ForceKind, ForceReports
from linkwright.elements.joint import KINDS, STILL, Inner, JointGeometry, JointKind, Outer, Twist, kind, register
from linkwright.elements.pin import InnerPin, OuterPin
from linkwright.elements.slide import InnerLine, OuterLine

__all__ = [
    "FORCES",
    "KINDS",
    "STILL",
    "ForceContext",
    "ForceKind",
    "ForceReports",
    "Inner",
    "InnerLine",
    "InnerPin",
    "JointGeometry",
    "JointKind",
    "Outer",
    "OuterLine",
    "OuterPin",
    "Twist",
    "kind",
    "register",
]
