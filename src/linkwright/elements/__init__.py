"""The kinds of elements that a mechanism is made of, one file each, found by name."""

from linkwright.elements import cam_contact, pin, pin_in_slot, slide  # noqa: F401  (each registers itself)
from linkwright.elements.joint import KINDS, STILL, Inner, JointGeometry, JointKind, Outer, Twist, kind, register
from linkwright.elements.pin import InnerPin, OuterPin
from linkwright.elements.slide import InnerLine, OuterLine

__all__ = [
    "KINDS",
    "STILL",
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
