"""The proof of a written model: its text read again, its joints set, and what its loops and links miss."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any
from xml.etree import ElementTree as ET

import numpy as np
from numpy.typing import NDArray

from linkwright.exports.mjcf.write import body_name

Array = NDArray[np.float64]


def missed(text: str, q: Mapping[str, Array], poses: Mapping[str, Array]) -> float:
    """The largest distance (m) by which a loop is open, or a link's origin or its axis' end 1 m away is off, with
    the joints at ``q`` (times,) by name. ``poses`` are the links' x, y, cosine and sine, (4, times)."""
    root = ET.fromstring(text)
    times = len(next(iter(q.values()))) if q else 1
    frames: dict[str, Array] = {}
    sites: dict[str, Array] = {}
    zero = np.zeros(times, dtype=complex)
    _place(root.find("worldbody"), zero, zero + 1, q, frames, sites)
    gaps = [sites[c.attrib["site1"]] - sites[c.attrib["site2"]] for c in root.iter("connect")]
    for link, (x, y, c, s) in poses.items():
        origin, turn = frames[body_name(link)]
        gaps += [origin - (x + 1j * y), turn - (c + 1j * s)]
    return max((float(np.abs(gap).max()) for gap in gaps), default=0.0)


def _place(
    body: Any, origin: Array, turn: Array, q: Mapping[str, Array], frames: dict[str, Array], sites: dict[str, Array]
) -> None:
    """Put a body and all that hang on it, its frame as complex numbers: origin, and the unit vector of its x axis."""
    if "name" in body.attrib:
        frames[body.attrib["name"]] = np.array([origin, turn])
    for site in body.findall("site"):
        sites[site.attrib["name"]] = origin + turn * _plane(site.attrib["pos"])
    for child in body.findall("body"):
        at = origin + turn * _plane(child.attrib["pos"])
        turned = turn * np.exp(1j * float(child.attrib["euler"].split()[2]))
        joint = child.find("joint")
        moved = q[joint.attrib["name"]] - float(joint.attrib["ref"])
        if joint.get("type") == "slide":
            at = at + turned * _plane(joint.attrib["axis"]) * moved
        else:
            arm = _plane(joint.attrib["pos"])
            at = at + turned * arm * (1 - np.exp(1j * moved))
            turned = turned * np.exp(1j * moved)
        _place(child, at, turned, q, frames, sites)


def _plane(text: str) -> complex:
    x, y, _ = map(float, text.split())
    return complex(x, y)
