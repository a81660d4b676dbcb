"""Mechanisms with two drives, whose regions are known in closed form."""

from __future__ import annotations

from typing import Any

from helpers.compiled import compiled_from
from helpers.examples import UNITS
from linkwright.kernels import Compiled


def five_bar(l1: float, l2: float, l3: float, l4: float, l5: float) -> Compiled:
    """Cranks O1-B and O4-D, couplers B-C and D-C, ground O1-O4 (m)."""
    return compiled_from(
        {
            "linkwright": 1,
            "units": UNITS,
            "links": {
                "frame": {"points": {"O1": [0, 0], "O4": [l5, 0]}},
                "crank1": {"points": {"O1": [0, 0], "B": [l1, 0]}},
                "link2": {"points": {"B": [0, 0], "C": [l2, 0]}},
                "link3": {"points": {"D": [0, 0], "C": [l3, 0]}},
                "crank4": {"points": {"O4": [0, 0], "D": [l4, 0]}},
            },
            "assembly": {"C": "left of B-D"},
            "drives": {
                "motor": {"turns": "crank1", "on": "frame", "speed": 1, "start": 2.0},
                "servo": {"turns": "crank4", "on": "frame", "speed": 1, "start": 1.0},
            },
        }
    )


def arm(l1: float, l2: float) -> Compiled:
    """A shoulder O, an elbow A, the hand P: an open chain."""
    data: dict[str, Any] = {
        "linkwright": 1,
        "units": UNITS,
        "links": {
            "frame": {"points": {"O": [0, 0]}},
            "upper": {"points": {"O": [0, 0], "A": [l1, 0]}},
            "fore": {"points": {"A": [0, 0], "P": [l2, 0]}},
        },
        "drives": {
            "shoulder": {"turns": "upper", "on": "frame", "speed": 1, "start": 0},
            "elbow": {"turns": "fore", "on": "upper", "speed": 1, "start": 1.0},
        },
    }
    return compiled_from(data)


def triad_turned_round() -> dict[str, Any]:
    """A five-bar whose couplers carry a dyad with P on it: forward there are dyads alone, but with P held at a place
    no two of the links hang on known pins."""
    return {
        "linkwright": 1,
        "units": UNITS,
        "links": {
            "frame": {"points": {"O1": [0, 0], "O4": [1.0, 0]}},
            "crank1": {"points": {"O1": [0, 0], "B": [0.5, 0]}},
            "crank4": {"points": {"O4": [0, 0], "D": [0.5, 0]}},
            "link2": {"points": {"B": [0, 0], "C": [1.2, 0], "M": [0.6, 0.5]}},
            "link3": {"points": {"D": [0, 0], "C": [1.2, 0], "K": [0.6, -0.5]}},
            "arm": {"points": {"M": [0, 0], "N": [1.5, 0]}},
            "hand": {"points": {"K": [0, 0], "N": [1.5, 0], "P": [1.0, 0.4]}},
        },
        "assembly": {"C": "left of B-D", "N": "left of M-K"},
        "drives": {
            "motor": {"turns": "crank1", "on": "frame", "speed": 1, "start": 2.0},
            "servo": {"turns": "crank4", "on": "frame", "speed": 1, "start": 1.0},
        },
    }


ARM = 0.35
"""The length of an arm on a coupler (m)."""
LEGS = ("RR", "PR", "RP")
"""The joints of the leg that guides the coupler, from the frame inwards."""
HEIGHT, LENGTH, ASIDE, TIP = 0.8, 0.7, 0.05, 0.5 + 0.4j


def arm_on_coupler(leg: str, **changes: float) -> Compiled:
    """A crank O1-A, a coupler, guided by a rocker, a slider or a rocking block, and on it at E a driven arm E-P: with P
    held at a place the coupler is the platform of a triad."""
    sizes = {"crank": 0.3, "length": LENGTH, "rocker": 0.5, "base": HEIGHT} | changes
    tip = [TIP.real, TIP.imag]
    coupler: dict[str, Any] = {"A": [0, 0], "B": [sizes["length"], 0], "E": tip}
    links: dict[str, Any] = {
        "frame": {"points": {"O1": [0, 0], "O4": [sizes["base"], 0], "H": [0, ASIDE]}},
        "crank": {"points": {"O1": [0, 0], "A": [sizes["crank"], 0]}},
        "coupler": {"points": coupler},
        "arm": {"points": {"E": [0, 0], "P": [ARM, 0]}},
    }
    data: dict[str, Any] = {"linkwright": 1, "units": UNITS, "links": links}
    if leg == "RR":
        links["rocker"] = {"points": {"O4": [0, 0], "B": [sizes["rocker"], 0]}}
        data["assembly"] = {"B": "left of A-O4"}
    elif leg == "PR":
        links["block"] = {"points": {"B": [0, 0]}}
        data["joints"] = {"rail": {"prismatic": ["frame", "block"], "line": ["H at 0 deg", "B at 0 deg"]}}
        data["assembly"] = {"B": "ahead of A along rail"}
    else:
        del coupler["B"]
        coupler["G"] = [0, ASIDE]
        links["block"] = {"points": {"O4": [0, 0]}}
        data["joints"] = {"rail": {"prismatic": ["coupler", "block"], "line": ["G at 0 deg", "O4 at 0 deg"]}}
        data["assembly"] = {"O4": "ahead of A along rail"}
    data["drives"] = {
        "motor": {"turns": "crank", "on": "frame", "speed": 1, "start": 1.0},
        "servo": {"turns": "arm", "on": "coupler", "speed": 1, "start": 1.0},
    }
    return compiled_from(data)
