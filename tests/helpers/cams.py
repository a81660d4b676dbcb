"""Cam pairs for tests: every follower, both sides, both senses, as model files in SI."""

from __future__ import annotations

import cmath
import math
from typing import Any

import numpy as np

from linkwright.graph.rows import BodyPlace

LAW: dict[str, Any] = {
    "over": "angle",
    "segments": [
        {"rise": 1, "over": 1.7, "law": "poly_4567"},
        {"dwell": 0.9},
        {"fall": 0.6, "over": 1.3, "law": "modified_sine"},
        {"fall": 0.4, "over": 1.4, "law": "cycloidal"},
        {"dwell": f"{2 * math.pi - 5.3!r}"},
    ],
}
FOLLOWERS = ("roller", "knife", "face")
GUIDES = ("swinging", "sliding")
SIGNS = ((1, 1), (1, -1), (-1, 1), (-1, -1))
"""Sides and senses."""


def law(of: str, height: float) -> dict[str, Any]:
    """A law without mirror symmetry, of some height (rad or m)."""
    segments = [dict(segment) for segment in LAW["segments"]]
    for segment in segments:
        for key in ("rise", "fall"):
            if key in segment:
                segment[key] *= height
    return {"over": "angle", "of": of, "segments": segments}


def pair(
    guide: str, touch: str, side: int = 1, sense: int = 1, inverted: bool = False, speed: float = 7.0, **more: Any
) -> dict[str, Any]:
    """A cam on the shaft O and a follower, with masses and a load; ``inverted``: the motor turns the carrier on the
    cam's link, which is the same."""
    links: dict[str, Any] = {
        "frame": {"points": {"O": [0.01, -0.02], "A": [0.09, 0.01], "S": [-0.02, -0.05]}},
        "disc": {"points": {"Q": [0.004, 0.003]}, "mass": 1.6, "com": [0.012, 0.02], "inertia": 4e-3},
        "arm": {
            "points": {"A": [0.005, 0.002], "B": [0.085, 0.03], "T": [0.1, 0.05]},
            "mass": 1.1,
            "com": [0.04, -0.01],
            "inertia": 2e-3,
        },
    }
    joints: dict[str, Any] = {"shaft": {"revolute": ["frame", "disc"], "at": ["O", "Q"]}}
    cam: dict[str, Any] = {"cam": "disc", "follower": "arm", "on": "frame", "base": 0.04, "law": "lift", "phase": 0.4}
    if guide == "swinging":
        cam["side"] = "left of shaft-A" if side > 0 else "right of O-A"
        height = 0.14
    else:
        del links["frame"]["points"]["A"]
        joints["guide"] = {"prismatic": ["arm", "frame"], "line": ["A at 0.7", "S at 2.0"]}
        cam["side"] = f"{'ahead of' if side > 0 else 'behind'} O along guide"
        height = 0.008
    if touch == "roller":
        cam |= {"roller": 0.012, "at": "B"}
    elif touch == "knife":
        cam |= {"knife": "B"}
    else:
        cam["face"] = f"B at {0.2 if guide == 'swinging' else 0.7 + math.pi / 2}"
    speed *= sense
    motor = {"turns": "disc", "on": "frame", "speed": speed, "start": 0.3}
    if inverted:
        motor = {"turns": "frame", "on": "disc", "speed": -speed, "start": -0.3}
    return {
        "linkwright": 1,
        "units": {"length": "m", "angle": "rad", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"},
        "gravity": [0.4, -9.81],
        "links": links,
        "joints": joints,
        "laws": {"lift": law("angle" if guide == "swinging" else "length", height)},
        "cams": {"rider": {**cam, **more}},
        "drives": {"motor": motor},
        "loads": {"push": {"on": "arm", "at": "T", "force": [3.0, -20.0], "torque": 0.3}},
    }


def closed_pair(guide: str, touch: str, side: int = 1, sense: int = 1, **more: Any) -> dict[str, Any]:
    """The same closed by a second disc: the follower's second contact C, whose arm makes 1.35 rad with the first one's
    (a face: 1.2 rad), or which lies 95 mm before it along the slide."""
    data = pair(guide, touch, side, sense, closed="conjugate", **more)
    points, cam = data["links"]["arm"]["points"], data["cams"]["rider"]
    first, pivot = complex(*points["B"]), complex(*points["A"])
    if guide == "sliding":
        place = first - side * 0.095 * cmath.exp(0.7j) + 0.004 * cmath.exp(2.3j)
    elif touch == "face":
        place = pivot + 0.07 * cmath.exp(1j * (0.2 + 1.2 * side)) - 0.003j * side
    else:
        place = pivot + 0.08 * cmath.exp(1j * (cmath.phase(first - pivot) + 1.35 * side))
    points["C"] = [place.real, place.imag]
    turned = 0.2 + 1.2 * side if guide == "swinging" else 0.7 + math.pi / 2
    cam["second"] = {"face": f"C at {turned}"} if touch == "face" else {"at": "C"}
    if touch == "roller":
        cam["second"]["roller"] = 0.009
    return data


def pose(c: Any, link: str, t: Any) -> tuple[Any, Any]:
    """Origin and x axis of a link as complex numbers."""
    x, y, cosine, sine = c.evaluate(BodyPlace.all(link), t)
    return x + 1j * y, cosine + 1j * sine


def moment(arm: Any, force: Any) -> Any:
    return (np.conj(arm) * force).imag


def newton_euler(c: Any, data: dict[str, Any], t: Any, contact: tuple[Any, Any], push: Any = 3.0 - 20.0j) -> Any:
    """Contact force, motor torque, the shaft's reaction on the cam and the guide's on the arm (of a slide its normal
    force and its moment about A), from six equations: (6, times). ``contact`` is a place and the normal there, ``push``
    the load on the arm (N), complex numbers (times,)."""
    place, normal = contact
    push = np.broadcast_to(push, t.shape)
    swinging = "A" in data["links"]["frame"]["points"]
    found = []
    rows: dict[str, Any] = {}
    for link in ("disc", "arm"):
        rows[link] = c.evaluate([f"com({link}).{a}" for a in ("x", "y", "ax", "ay")] + [f"{link}.alpha"], t)
    ends = c.evaluate(["O.x", "O.y", "A.x", "A.y", "T.x", "T.y"], t)
    gravity = 0.4 - 9.81j
    for k in range(t.size):
        matrix, right = np.zeros((6, 6)), np.zeros(6)
        o, a, tip = (ends[2 * i, k] + 1j * ends[2 * i + 1, k] for i in range(3))
        for row, link, mass, inertia, sign in ((0, "disc", 1.6, 4e-3, -1), (3, "arm", 1.1, 2e-3, 1)):
            x, y, ax, ay, alpha = rows[link][:, k]
            centre, force = x + 1j * y, mass * (ax + 1j * ay - gravity)
            torque = inertia * alpha
            unknown: list[tuple[int, complex, Any]] = [(0, sign * normal[k], place[k] - centre)]
            if link == "disc":
                unknown += [(2, 1.0, o - centre), (3, 1j, o - centre)]
                matrix[2, 1] = 1.0
            else:
                force, torque = force - push[k], torque - moment(tip - centre, push[k]) - 0.3
                if swinging:
                    unknown += [(4, 1.0, a - centre), (5, 1j, a - centre)]
                else:
                    unknown += [(4, 1j * np.exp(2j), a - centre)]
                    matrix[5, 5] = 1.0
            for column, unit, arm in unknown:
                matrix[row : row + 3, column] += [unit.real, unit.imag, moment(arm, unit)]
            right[row : row + 3] = [force.real, force.imag, torque]
        found.append(np.linalg.solve(matrix, right))
    return np.array(found).T
