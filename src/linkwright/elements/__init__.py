"""The kinds of elements that a mechanism is made of, one file each, found by name."""

from linkwright.elements import (  # noqa: F401  (each registers itself)
    belt,
    cam_contact,
    counterweight,
    coupling,
    differential,
    friction,
    gears,
    geneva,
    load,
    pin,
    pin_in_slot,
    prescribed,
    rack,
    rolling,
    slide,
    spring,
    weld,
)
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
