"""Mechanisms with the kinds of joints in ``outside``, and what these kinds keep once more, from raw geometry.

Of each kind: alone in a loop, in a dyad's place, with three links on one pin, with several drives; of gears also on a
link of a dyad over several turns.
"""

from __future__ import annotations

import copy
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from helpers.newton_euler import Array, Gap, Oracle
from helpers.plain import plain_of

UNITS = {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"}
MOTOR = {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": "0 deg"}
Start = dict[str, tuple[float, float, float]]


@dataclass(frozen=True)
class Case:
    """A mechanism as a file has it, its ``start`` about (m, rad), its gap, also with its
    dimension or play ``moved`` (SI), and on how many links the report draws the joint. ``output`` is an angle."""

    data: dict[str, Any]
    start: Start
    moved: Callable[..., Gap]
    joint: str
    output: str
    symbols: int

    @property
    def gap(self) -> Gap:
        """What the joint misses by at the nominal dimensions."""
        return self.moved()

    def oracle(self) -> Oracle:
        """The mechanism from raw geometry."""
        joints = {name: joint for name, joint in self.data.get("joints", {}).items() if name != self.joint}
        data = {**self.data, "joints": joints, "parameters": {}}
        return Oracle(plain_of(data, self.start), gaps={self.joint: self.gap})


def body(points: dict[str, list[float]], mass: float, com: list[float], inertia: float) -> dict[str, Any]:
    return {"points": points, "mass": mass, "com": com, "inertia": inertia}


# A point on a wave.


def wave(pin: tuple[str, str], on: tuple[str, str]) -> Callable[..., Gap]:
    """How far a point lies off a wave over the x axis of a link from a point on, along the normal (m), less ``off``:
    exact to the first order."""
    return lambda **moved: _wave(pin, on, **moved)


def _wave(pin: tuple[str, str], on: tuple[str, str], h: float = 0.0, off: float = 0.0) -> Gap:
    height = HEIGHT + h

    def gap(oracle: Oracle, q: Array) -> float:
        away = oracle.point(q, *pin) - oracle.point(q, *on)
        angle = oracle.pose(q, on[0])[2]
        c, s = np.cos(angle), np.sin(angle)
        x, y = c * away[0] + s * away[1], -s * away[0] + c * away[1]
        k = 2 * np.pi / LENGTH
        return float((y - height * np.sin(k * x)) / np.hypot(1.0, height * k * np.cos(k * x)) - off)

    return gap


HEIGHT, LENGTH = 0.008, 0.120
WAVE = {"height": "h", "length": 120}
PARAMETERS = {"h": {"value": 8, "tolerance": 0.1}}


def on_frame(**more: Any) -> dict[str, Any]:
    """A rod between a crank and a wave on the frame."""
    return {
        "linkwright": 1,
        "units": UNITS,
        "gravity": [0, -9810],
        "parameters": PARAMETERS,
        "links": {
            "frame": {"points": {"O": [0, 0], "G": [0, -20]}},
            "crank": body({"O": [0, 0], "B": [30, 0]}, 0.4, [12, 3], 2e2),
            "rod": body({"B": [0, 0], "E": [100, 0]}, 0.8, [60, 5], 9e2),
        },
        "joints": {"edge": {"pin_on_wave": ["rod", "frame"], "pin": "E", "along": "G at 0 deg", **WAVE}},
        "assembly": {"E": [126, -18]},
        "drives": {"motor": MOTOR},
        **more,
    }


def lever() -> dict[str, Any]:
    data = on_frame(assembly={"T": [65, 56]})
    data["links"] = {
        "frame": {"points": {"O": [0, 0], "C": [0, -90]}},
        "crank": data["links"]["crank"],
        "lever": body({"C": [0, 0], "T": [160, 0]}, 0.5, [80, 4], 1e3),
    }
    data["joints"] = {"edge": {"pin_on_wave": ["crank", "lever"], "pin": "B", "along": "C at 0 deg", **WAVE}}
    return data


def three_on_a_pin() -> dict[str, Any]:
    data = on_frame(assembly={"E": [126, -18], "K": [115, 30]})
    data["links"]["frame"]["points"]["F"] = [0, 30]
    data["links"]["bar"] = body({"B": [0, 0], "K": [90, 0]}, 0.6, [40, -6], 7e2)
    data["links"]["slider"] = body({"K": [0, 0]}, 1.2, [5, 0], 3e2)
    data["joints"]["guide"] = {"prismatic": ["frame", "slider"], "line": ["F at 0 deg", "K at 0 deg"]}
    return data


def on_a_slider() -> dict[str, Any]:
    data = on_frame()
    data["links"]["frame"]["points"] = {"O": [0, 0], "F": [0, -20]}
    data["links"]["plate"] = body({"G": [0, 0]}, 1.5, [40, -10], 2e3)
    data["joints"]["guide"] = {"prismatic": ["frame", "plate"], "line": ["F at 0 deg", "G at 0 deg"]}
    data["joints"]["edge"]["pin_on_wave"] = ["rod", "plate"]
    data["drives"]["push"] = {"slides": "plate", "on": "frame", "speed": "15 mm/s", "start": "2 mm"}
    return data


ROD = {"crank": (0.0, 0.0, 0.0), "rod": (0.03, 0.0, -0.2)}
WAVES = {
    "alone in a loop": Case(
        lever(),
        {"crank": (0.0, 0.0, 0.0), "lever": (0.0, -0.09, 1.15)},
        wave(("crank", "B"), ("lever", "C")),
        "edge",
        "lever.angle",
        1,
    ),
    "in a dyad's place": Case(on_frame(), ROD, wave(("rod", "E"), ("frame", "G")), "edge", "rod.angle", 1),
    "three links on a pin": Case(
        three_on_a_pin(),
        {**ROD, "bar": (0.03, 0.0, 0.34), "slider": (0.115, 0.03, 0.0)},
        wave(("rod", "E"), ("frame", "G")),
        "edge",
        "rod.angle",
        1,
    ),
    "several drives": Case(
        on_a_slider(), {**ROD, "plate": (0.002, -0.02, 0.0)}, wave(("rod", "E"), ("plate", "G")), "edge", "rod.angle", 1
    ),
}


# Gears on a carrier.


def mesh(a: str, b: str, carrier: str, drawn: float) -> Callable[..., Gap]:
    """What two gears of the ratio 2 miss by (rad), whose angles against their carrier came to ``drawn`` when they were
    put together."""
    return lambda z=0.0: _mesh(a, b, carrier, 2.0 + z, drawn)


def _mesh(a: str, b: str, carrier: str, ratio: float, drawn: float) -> Gap:
    def gap(oracle: Oracle, q: Array) -> float:
        turned_a, turned_b, base = (oracle.pose(q, link)[2] for link in (a, b, carrier))
        return float(turned_a - base + ratio * (turned_b - base) - drawn)

    return gap


def planets(sun: str, points: list[str], **more: Any) -> dict[str, Any]:
    """A planet on an arm that rolls about a sun."""
    return {
        "linkwright": 1,
        "units": UNITS,
        "gravity": [0, -9810],
        "parameters": {"z": {"value": 2, "tolerance": 0.01}},
        "links": {
            "frame": {"points": {"O": [0, 0]}},
            "crank": body({"O": [0, 0], "P": [60, 0]}, 0.5, [25, 4], 3e2),
            "planet": body({"P": [0, 0], "Q": [40, 0]}, 2.0, [6, 3], 1.5e3),
        },
        "joints": {"mesh": {"gear_on_carrier": [sun, "planet", "crank"], "points": points, "ratio": "z"}},
        "assembly": {"Q": [100, 0]},
        "drives": {"motor": MOTOR},
        **more,
    }


def with_a_rod() -> dict[str, Any]:
    data = planets("frame", ["O", "P", "O"], assembly={"Q": [100, 0], "K": [150, 10]})
    data["links"]["frame"]["points"]["F"] = [0, 10]
    data["links"]["rod"] = body({"P": [0, 0], "K": [120, 0]}, 0.6, [50, -6], 7e2)
    data["links"]["slider"] = body({"K": [0, 0]}, 1.2, [5, 0], 3e2)
    data["joints"]["guide"] = {"prismatic": ["frame", "slider"], "line": ["F at 0 deg", "K at 0 deg"]}
    return data


def with_a_sun() -> dict[str, Any]:
    data = planets("sun", ["O", "P", "O"])
    data["links"]["sun"] = body({"O": [0, 0], "S": [20, 0]}, 1.0, [3, 2], 4e2)
    data["drives"]["hold"] = {"turns": "sun", "on": "frame", "speed": "25 rpm", "start": "0 deg"}
    return data


def five_bar() -> dict[str, Any]:
    """Two cranks that gears hold on each other, and a dyad on both."""
    data = planets("crank", ["O", "M", "O"], assembly={"D": [170, 0], "C": "left of B-D"})
    data["links"] = {
        "frame": {"points": {"O": [0, 0], "M": [130, 0]}},
        "crank": body({"O": [0, 0], "B": [35, 0]}, 0.4, [12, 3], 2e2),
        "second": body({"M": [0, 0], "D": [40, 0]}, 0.5, [15, -3], 3e2),
        "left": body({"B": [0, 0], "C": [110, 0]}, 0.7, [50, 4], 8e2),
        "right": body({"D": [0, 0], "C": [120, 0]}, 0.8, [55, -4], 9e2),
    }
    data["joints"]["mesh"] |= {"gear_on_carrier": ["crank", "second", "frame"]}
    return data


def drag_link() -> dict[str, Any]:
    """A gear on a link of a dyad that turns on and on."""
    data = planets("follower", ["D", "W", "D"], assembly={"C": [48, 64], "V": [55, -80]})
    data["links"] = {
        "frame": {"points": {"A": [0, 0], "D": [20, 0], "W": [20, -80]}},
        "crank": body({"A": [0, 0], "B": [60, 0]}, 0.4, [12, 3], 2e2),
        "coupler": body({"B": [0, 0], "C": [65, 0]}, 0.7, [30, 4], 8e2),
        "follower": body({"D": [0, 0], "C": [70, 0]}, 0.8, [35, -4], 9e2),
        "wheel": body({"W": [0, 0], "V": [35, 0]}, 0.8, [5, -4], 9e2),
    }
    data["joints"]["mesh"] |= {"gear_on_carrier": ["follower", "wheel", "frame"]}
    return data


def dyad(first: tuple[float, float], second: tuple[float, float], a: float, b: float) -> tuple[float, float]:
    """The directions (rad) of two links from two places to where they meet, left of the line between these."""
    apart = np.subtract(second, first)
    d = float(np.hypot(*apart))
    along = (d * d + a * a - b * b) / (2 * d)
    e = apart / d
    at = np.array(first) + along * e + np.sqrt(a * a - along * along) * np.array([-e[1], e[0]])
    return tuple(float(np.arctan2(*(at - base)[::-1])) for base in (first, second))  # type: ignore[return-value]


ARM: Start = {"crank": (0.0, 0.0, 0.0), "planet": (0.06, 0.0, 0.0)}
FIVE = dyad((0.035, 0.0), (0.17, 0.0), 0.11, 0.12)
DRAG = dyad((0.02, 0.0), (0.06, 0.0), 0.07, 0.065)


def _gears() -> dict[str, Case]:
    fixed, turned = mesh("frame", "planet", "crank", 0.0), mesh("sun", "planet", "crank", 0.0)
    more = {**ARM, "rod": (0.06, 0.0, 0.08), "slider": (0.18, 0.01, 0.0)}
    five = {"crank": (0.0, 0.0, 0.0), "second": (0.13, 0.0, 0.0), "left": (0.035, 0.0, FIVE[0])}
    drag = {"crank": (0.0, 0.0, 0.0), "coupler": (0.06, 0.0, DRAG[1]), "follower": (0.02, 0.0, DRAG[0])}
    drag_gap = mesh("follower", "wheel", "frame", DRAG[0])
    return {
        "alone in a loop": Case(planets("frame", ["O", "P", "O"]), ARM, fixed, "mesh", "planet.angle", 2),
        "in a dyad's place": Case(
            five_bar(),
            {**five, "right": (0.17, 0.0, FIVE[1])},
            mesh("crank", "second", "frame", 0.0),
            "mesh",
            "second.angle",
            2,
        ),
        "three links on a pin": Case(with_a_rod(), more, fixed, "mesh", "planet.angle", 2),
        "several drives": Case(with_a_sun(), {**ARM, "sun": (0.0, 0.0, 0.0)}, turned, "mesh", "planet.angle", 2),
        "on a link of a dyad": Case(
            drag_link(), {**drag, "wheel": (0.02, -0.08, 0.0)}, drag_gap, "mesh", "wheel.angle", 2
        ),
    }


GEARS = _gears()
CASES = {**{f"wave {name}": case for name, case in WAVES.items()}, **{f"gears {n}": c for n, c in GEARS.items()}}


def studied(case: Case, **studies: Any) -> dict[str, Any]:
    """A case as a file with a cycle of some turns."""
    data = copy.deepcopy(case.data)
    data["studies"] = {"cycle": {"duration": "2.5 s", "samples": 40}, **studies}
    return data


def structure(drawn: bool) -> dict[str, Any]:
    """Two pairs of gears of different ratios on one arm, which hold each other; a rod holds the arm. Whether the links
    are drawn, so that they can be placed one after the other."""
    places = {"Q": [60, 40], "P": [60, 0], "S": [20, 0], "G": [60, -80]}
    return {
        "linkwright": 1,
        "units": UNITS,
        "links": {
            "frame": {"points": {"O": [0, 0], "G": [60, -80]}},
            "sun": {"points": {"O": [0, 0], "S": [20, 0]}},
            "arm": {"points": {"O": [0, 0], "P": [60, 0]}},
            "planet": {"points": {"P": [0, 0], "Q": [40, 0]}},
            "rod": {"points": {"P": [0, 0], "G": [0, -80]}},
        },
        "joints": {
            f"mesh{ratio}": {"gear_on_carrier": ["sun", "planet", "arm"], "points": ["O", "P", "O"], "ratio": ratio}
            for ratio in (2, 3)
        },
        "assembly": places if drawn else {"G": places["G"]},
        "loads": {"pull": {"on": "planet", "at": "Q", "force": [10, 5]}},
        "studies": {"reactions": {}},
    }
