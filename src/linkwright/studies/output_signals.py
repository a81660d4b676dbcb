"""What counts as the output of a mechanism where nobody says."""

from __future__ import annotations

from linkwright.kernels import Compiled
from linkwright.structure import FRAME


def output_signals(compiled: Compiled) -> list[str]:
    """The angles of all links hinged on the frame and the travels of all slides, but those that a drive holds."""
    m, topology = compiled.mechanism, compiled.structure.topology
    moved = {name: m.prescribed(name) for name in m.movers}
    driven = {topology.drivable_joints(name)[0].joint: {drive.link, drive.on} for name, drive in moved.items()}
    found = []
    for pin in topology.pins.values():
        if FRAME in pin.links:
            held = driven.get(pin.name, set())
            found += [f"{link}.angle" for link in pin.links if link != FRAME and {link, FRAME} != held]
    found += [f"{name}.s" for name, _ in m.prismatic_joints() if name not in driven]
    return list(dict.fromkeys(found))
