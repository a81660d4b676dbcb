"""Mechanisms with wheels that drive each other, and what they keep and where they push, from raw geometry."""

from __future__ import annotations

import copy
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from helpers.newton_euler import Array, Gap, Oracle
from helpers.plain import plain_of
from helpers.toothed import Contact, Toothed

UNITS = {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"}
Start = dict[str, tuple[float, float, float]]


@dataclass(frozen=True)
class Wheels:
    """A mechanism as a file has it, its ``start`` about (m, rad), and of each joint of wheels its gap and contact."""

    data: dict[str, Any]
    start: Start
    gaps: dict[str, Gap]
    contacts: dict[str, Contact] = field(default_factory=dict)

    def oracle(self) -> Toothed:
        """The mechanism from raw geometry."""
        joints = {
            name: joint
            for name, joint in self.data.get("joints", {}).items()
            if name not in {key.split("/")[0] for key in self.gaps}
        }
        return Toothed(plain_of({**self.data, "joints": joints}, self.start), self.gaps, self.contacts)

    def studied(self, **studies: Any) -> dict[str, Any]:
        """A file with a cycle of some turns."""
        data = copy.deepcopy(self.data)
        data["studies"] = {"cycle": {"duration": "2.5 s", "samples": 40}, **studies}
        return data


def body(points: dict[str, list[float]], mass: float, com: list[float], inertia: float) -> dict[str, Any]:
    return {"points": points, "mass": mass, "com": com, "inertia": inertia}


def rolled(a: str, b: str, carrier: str, first: float, second: float, drawn: float = 0.0) -> Gap:
    """What passes at the pitch circle of one wheel but not at the other's (m), by angles alone."""

    def gap(oracle: Oracle, q: Array) -> float:
        turned = [oracle.pose(q, link)[2] for link in (a, b, carrier)]
        return float(first * (turned[0] - turned[2]) + second * (turned[1] - turned[2]) - drawn)

    return gap


def teeth(a: tuple[str, str], b: tuple[str, str], first: float, second: float, alpha: float) -> Contact:
    """Teeth of external gears, or of a gear a in a ring b (``second`` negative): they push along lines of action at
    ``alpha`` (rad) to the tangent through the pitch point, always into the first gear."""

    def contact(oracle: Oracle, q: Array, flank: int) -> tuple[str, str, Array, Array]:
        start, end = oracle.point(q, *a), oracle.point(q, *b)
        outward = (end - start) / np.hypot(*(end - start)) * (1.0 if second > 0 else -1.0)
        place = start + first * outward
        tangent = np.array([-outward[1], outward[0]])
        return a[0], b[0], flank * np.cos(alpha) * tangent - np.sin(alpha) * outward, place

    return contact


def pair() -> dict[str, Any]:
    """Two gears on the frame; the torque on the second changes its sign, as its mass lies beside its centre."""
    return {
        "linkwright": 1,
        "units": UNITS,
        "gravity": [0, -9810],
        "links": {
            "frame": {"points": {"O": [0, 0], "M": [90, 0]}},
            "pinion": body({"O": [0, 0], "B": [20, 0]}, 0.4, [12, 3], 2e2),
            "wheel": body({"M": [0, 0], "W": [40, 0]}, 2.0, [25, 8], 1.5e3),
        },
        "joints": {"mesh": {"gears": ["pinion", "wheel"], "centres": ["O", "M"], "teeth": [15, 30]}},
        "assembly": {"W": [130, 0]},
        "drives": {"motor": {"turns": "pinion", "on": "frame", "speed": "60 rpm", "start": "0 deg"}},
    }


def shifted() -> dict[str, Any]:
    """The same with a module and profile shift: 3 mm (15 + 30)/2 = 67.5 mm at 68.4 mm."""
    data = pair()
    data["links"]["frame"]["points"]["M"] = [68.4, 0]
    data["joints"]["mesh"] |= {"module": 3}
    data["assembly"]["W"] = [108.4, 0]
    return data


def planetary() -> dict[str, Any]:
    """Sun 40 mm, planet 20 mm, ring 80 mm that turns too, with an eccentric mass on all."""
    return {
        "linkwright": 1,
        "units": UNITS,
        "gravity": [0, -9810],
        "links": {
            "frame": {"points": {"O": [0, 0]}},
            "sun": body({"O": [0, 0], "S": [20, 0]}, 1.0, [3, 2], 4e2),
            "arm": body({"O": [0, 0], "P": [60, 0]}, 0.7, [25, 4], 3e2),
            "planet": body({"P": [0, 0], "Q": [10, 0]}, 0.5, [2, 3], 1e2),
            "ring": body({"O": [0, 0], "R": [80, 0]}, 1.5, [-5, 9], 4e3),
        },
        "joints": {
            "sun_mesh": {"gears": ["sun", "planet"], "centres": ["O", "P"], "carrier": "arm", "radii": [40, 20]},
            "ring_mesh": {
                "gears": ["planet", "ring"],
                "internal": "ring",
                "centres": ["P", "O"],
                "carrier": "arm",
                "radii": [20, 80],
                "pressure_angle": 25,
            },
        },
        "assembly": {"P": [60, 0], "Q": [70, 0]},
        "drives": {
            "motor": {"turns": "sun", "on": "frame", "speed": "60 rpm", "start": "0 deg"},
            "hold": {"turns": "ring", "on": "frame", "speed": "-10 rpm", "start": "0 deg"},
        },
        "loads": {"brake": {"on": "arm", "torque": -1.5}},
    }


def ring_first() -> dict[str, Any]:
    """The same with the ring named first."""
    data = planetary()
    data["joints"]["ring_mesh"] |= {"gears": ["ring", "planet"], "centres": ["O", "P"], "radii": [80, 20]}
    return data


def five_bar() -> dict[str, Any]:
    """Two cranks in mesh, and a dyad on both."""
    return {
        "linkwright": 1,
        "units": UNITS,
        "gravity": [0, -9810],
        "links": {
            "frame": {"points": {"O": [0, 0], "M": [130, 0]}},
            "crank": body({"O": [0, 0], "B": [35, 0]}, 0.4, [12, 3], 2e2),
            "second": body({"M": [0, 0], "D": [40, 0]}, 0.5, [15, -3], 3e2),
            "left": body({"B": [0, 0], "C": [110, 0]}, 0.7, [50, 4], 8e2),
            "right": body({"D": [0, 0], "C": [120, 0]}, 0.8, [55, -4], 9e2),
        },
        "joints": {"mesh": {"gears": ["crank", "second"], "centres": ["O", "M"], "teeth": [20, 40]}},
        "assembly": {"D": [170, 0], "C": "left of B-D"},
        "drives": {"motor": {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": "0 deg"}},
    }


def on_a_coupler() -> dict[str, Any]:
    """A four-bar whose coupler carries a gear that meshes with one on the crank: a carrier in general motion."""
    return {
        "linkwright": 1,
        "units": UNITS,
        "gravity": [0, -9810],
        "links": {
            "frame": {"points": {"A": [0, 0], "D": [120, 0]}},
            "crank": body({"A": [0, 0], "B": [35, 0]}, 0.4, [12, 3], 2e2),
            "coupler": body({"B": [0, 0], "C": [110, 0], "G": [60, 0]}, 0.7, [50, 4], 8e2),
            "rocker": body({"D": [0, 0], "C": [80, 0]}, 0.8, [45, -4], 6e2),
            "wheel": body({"G": [0, 0], "W": [25, 0]}, 0.6, [7, -4], 3e2),
        },
        "joints": {
            "mesh": {"gears": ["crank", "wheel"], "centres": ["B", "G"], "carrier": "coupler", "radii": [35, 25]}
        },
        "assembly": {"C": [111, 79.5], "W": [100, 45]},
        "drives": {"motor": {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": "0 deg"}},
    }


def on_a_rack(a: tuple[str, str], b: tuple[str, str], heading: float, radius: float, drawn: float) -> Gap:
    """How far a pinion's centre came along a rack's line (m), less what it rolled; ``radius`` is negative to the right
    of the line."""

    def gap(oracle: Oracle, q: Array) -> float:
        angle = oracle.pose(q, b[0])[2]
        along = np.array([np.cos(angle + heading), np.sin(angle + heading)])
        away = oracle.point(q, *a) - oracle.point(q, *b)
        return float(away @ along + radius * (oracle.pose(q, a[0])[2] - angle) - drawn)

    return gap


def rack_teeth(a: tuple[str, str], b: tuple[str, str], heading: float, radius: float, alpha: float) -> Contact:
    """Teeth of a rack that push into the pinion, away from the rack."""

    def contact(oracle: Oracle, q: Array, flank: int) -> tuple[str, str, Array, Array]:
        angle = oracle.pose(q, b[0])[2] + heading
        along, left = np.array([np.cos(angle), np.sin(angle)]), np.array([-np.sin(angle), np.cos(angle)])
        push = flank * np.cos(alpha) * along + np.sign(radius) * np.sin(alpha) * left
        return a[0], b[0], push, oracle.point(q, *a) - radius * left

    return contact


def rack(above: bool) -> dict[str, Any]:
    """A slider-crank whose slider has a rack, and a pinion above or below of it with an eccentric mass."""
    side = 1 if above else -1
    return {
        "linkwright": 1,
        "units": UNITS,
        "gravity": [0, -9810],
        "links": {
            "frame": {"points": {"A": [0, 0], "F": [0, 10], "M": [180, 10 + 5 + side * 25]}},
            "crank": body({"A": [0, 0], "B": [35, 0]}, 0.5, [15, 2], 2e2),
            "rod": body({"B": [0, 0], "C": [120, 0]}, 0.4, [60, 3], 6e2),
            "slider": body({"C": [0, 0], "G": [20, 5]}, 0.9, [10, 0], 3e2),
            "pinion": body({"M": [0, 0], "E": [0, 90]}, 1.2, [5, 40], 9e2),
        },
        "joints": {
            "guide": {"prismatic": ["frame", "slider"], "line": ["F at 0 deg", "C at 0 deg"]},
            "mesh": {"rack": ["pinion", "slider"], "centre": "M", "pitch_line": "G at 180 deg", "radius": 25},
        },
        "assembly": {"C": [150, 10], "E": [180, 105 + side * 25]},
        "drives": {"motor": {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": "0 deg"}},
    }


def on_a_fixed_rack() -> dict[str, Any]:
    """A pinion on a slider that a crank pushes along a rack on the frame; the slider carries the pinion."""
    data = rack(above=True)
    data["links"]["frame"]["points"] = {"A": [0, 0], "F": [0, 10], "G": [100, -20]}
    data["links"]["slider"] = body({"C": [0, 0], "M": [30, 5]}, 0.9, [10, 0], 3e2)
    data["joints"]["mesh"] = {
        "rack": ["pinion", "frame"],
        "centre": "M",
        "carrier": "slider",
        "pitch_line": "G at 0 deg",
        "teeth": 28,
        "module": 2.5,
    }
    data["assembly"] = {"C": [150, 10], "E": [180, 105]}
    return data


def _rack(above: bool) -> Wheels:
    # The line runs to the left: a pinion above it lies on its right.
    data, radius = rack(above), -0.025 if above else 0.025
    start: Start = {
        "crank": (0.0, 0.0, 0.0),
        "rod": (0.035, 0.0, float(np.arcsin(10 / 120))),
        "slider": (0.035 + float(np.sqrt(0.12**2 - 0.01**2)), 0.01, 0.0),
        "pinion": (0.18, 0.04 if above else -0.01, 0.0),
    }
    drawn = -(0.18 - start["slider"][0] - 0.02)
    ends = (("pinion", "M"), ("slider", "G"), float(np.pi), radius)
    return Wheels(data, start, {"mesh": on_a_rack(*ends, drawn)}, {"mesh": rack_teeth(*ends, ALPHA)})


def _fixed_rack() -> Wheels:
    x = 0.035 + float(np.sqrt(0.12**2 - 0.01**2))
    start: Start = {
        "crank": (0.0, 0.0, 0.0),
        "rod": (0.035, 0.0, float(np.arcsin(10 / 120))),
        "slider": (x, 0.01, 0.0),
        "pinion": (x + 0.03, 0.015, 0.0),
    }
    turned = float(np.arctan2(180 - 1e3 * (x + 0.03), 90))
    start["pinion"] = (*start["pinion"][:2], -turned)
    ends = (("pinion", "M"), ("frame", "G"), 0.0, 0.035)
    drawn = x + 0.03 - 0.1 + 0.035 * -turned
    return Wheels(on_a_fixed_rack(), start, {"mesh": on_a_rack(*ends, drawn)}, {"mesh": rack_teeth(*ends, ALPHA)})


def dyad(first: tuple[float, float], second: tuple[float, float], a: float, b: float) -> tuple[float, float]:
    """The directions (rad) of two links from two places to where they meet, left of the line between these."""
    apart = np.subtract(second, first)
    d = float(np.hypot(*apart))
    along = (d * d + a * a - b * b) / (2 * d)
    e = apart / d
    at = np.array(first) + along * e + np.sqrt(a * a - along * along) * np.array([-e[1], e[0]])
    return tuple(float(np.arctan2(*(at - base)[::-1])) for base in (first, second))  # type: ignore[return-value]


def _four_bar() -> Wheels:
    data = on_a_coupler()
    coupler, rocker = dyad((0.035, 0.0), (0.12, 0.0), 0.110, 0.080)
    centre = np.array([0.035 + 0.06 * np.cos(coupler), 0.06 * np.sin(coupler)])
    drawn = float(np.arctan2(0.045 - centre[1], 0.100 - centre[0]))
    constant = 0.035 * (0.0 - coupler) + 0.025 * (drawn - coupler)
    start: Start = {
        "crank": (0.0, 0.0, 0.0),
        "coupler": (0.035, 0.0, coupler),
        "rocker": (0.12, 0.0, rocker),
        "wheel": (*centre.tolist(), drawn),
    }
    gap = rolled("crank", "wheel", "coupler", 0.035, 0.025, constant)
    return Wheels(data, start, {"mesh": gap}, {"mesh": teeth(("crank", "B"), ("wheel", "G"), 0.035, 0.025, ALPHA)})


ALPHA = float(np.radians(20))
_PAIR: Start = {"pinion": (0.0, 0.0, 0.0), "wheel": (0.09, 0.0, 0.0)}
_SHIFTED: Start = {"pinion": (0.0, 0.0, 0.0), "wheel": (0.0684, 0.0, 0.0)}
_TRAIN: Start = {"sun": (0.0, 0.0, 0.0), "arm": (0.0, 0.0, 0.0), "planet": (0.06, 0.0, 0.0), "ring": (0.0, 0.0, 0.0)}
_FIVE = dyad((0.035, 0.0), (0.17, 0.0), 0.11, 0.12)
_TRAIN_GAPS = {
    "sun_mesh": rolled("sun", "planet", "arm", 0.04, 0.02),
    "ring_mesh": rolled("planet", "ring", "arm", 0.02, -0.08),
}
_TRAIN_TEETH = {
    "sun_mesh": teeth(("sun", "O"), ("planet", "P"), 0.04, 0.02, ALPHA),
    "ring_mesh": teeth(("planet", "P"), ("ring", "O"), 0.02, -0.08, float(np.radians(25))),
}
GEARS = {
    "pair": Wheels(
        pair(),
        _PAIR,
        {"mesh": rolled("pinion", "wheel", "frame", 0.03, 0.06)},
        {"mesh": teeth(("pinion", "O"), ("wheel", "M"), 0.03, 0.06, ALPHA)},
    ),
    "profile shift": Wheels(
        shifted(),
        _SHIFTED,
        {"mesh": rolled("pinion", "wheel", "frame", 0.0228, 0.0456)},
        {
            "mesh": teeth(
                ("pinion", "O"), ("wheel", "M"), 0.0228, 0.0456, float(np.arccos(67.5 / 68.4 * np.cos(np.radians(20))))
            )
        },
    ),
    "planetary train": Wheels(planetary(), _TRAIN, _TRAIN_GAPS, _TRAIN_TEETH),
    "ring first": Wheels(ring_first(), _TRAIN, _TRAIN_GAPS, _TRAIN_TEETH),
    "five-bar": Wheels(
        five_bar(),
        {
            "crank": (0.0, 0.0, 0.0),
            "second": (0.13, 0.0, 0.0),
            "left": (0.035, 0.0, _FIVE[0]),
            "right": (0.17, 0.0, _FIVE[1]),
        },
        {"mesh": rolled("crank", "second", "frame", 20, 40)},
        {"mesh": teeth(("crank", "O"), ("second", "M"), 0.13 / 3, 0.26 / 3, ALPHA)},
    ),
    "carrier in general motion": _four_bar(),
}
RACKS = {"above": _rack(above=True), "below": _rack(above=False), "fixed rack, moving carrier": _fixed_rack()}


# Rolling discs: two gaps of one joint, NAME and NAME/rolled.


def wheel(on: dict[str, Any], ground: str = "frame") -> dict[str, Any]:
    """A crank and a rod push a wheel with an eccentric mass, which rolls."""
    return {
        "linkwright": 1,
        "units": UNITS,
        "gravity": [0, -9810],
        "links": {
            "frame": {"points": {"A": [0, 60], "G": [300, 0]}},
            "arm": body({"A": [0, 0], "B": [90, 0]}, 1.0, [40, 3], 9e2),
            "rod": body({"B": [0, 0], "C": [260, 0]}, 0.8, [120, -5], 5e3),
            "wheel": body({"C": [0, 0], "P": [0, -60]}, 4.0, [10, 5], 7e3),
        },
        "joints": {"ground": {"rolling": ["wheel", ground], "centre": "C", "radius": 60, **on}},
        "assembly": {"C": [350, 60], "P": [350, 0]},
        "drives": {"motor": {"turns": "arm", "on": "frame", "speed": "60 rpm", "start": "0 deg"}},
    }


def touching(a: tuple[str, str], b: tuple[str, str], radius: float) -> tuple[dict[str, Gap], dict[str, Contact]]:
    """A disc above a line along the x axis of a link."""

    def apart(oracle: Oracle, q: Array) -> tuple[float, float, float]:
        angle = oracle.pose(q, b[0])[2]
        away = oracle.point(q, *a) - oracle.point(q, *b)
        c, s = np.cos(angle), np.sin(angle)
        return float(c * away[0] + s * away[1]), float(c * away[1] - s * away[0]), float(angle)

    first: list[float] = []

    def rolled(oracle: Oracle, q: Array) -> float:
        x, _, angle = apart(oracle, q)
        passed = x + radius * (oracle.pose(q, a[0])[2] - angle)
        first[:] = first or [passed]
        return float(passed - first[0])

    def contact(way: int) -> Contact:
        def found(oracle: Oracle, q: Array, flank: int) -> tuple[str, str, Array, Array]:
            angle = oracle.pose(q, b[0])[2]
            ways = np.array([[-np.sin(angle), np.cos(angle)], [np.cos(angle), np.sin(angle)]])
            return a[0], b[0], flank * ways[way], oracle.point(q, *a) - radius * ways[0]

        return found

    gaps: dict[str, Gap] = {"ground": lambda oracle, q: apart(oracle, q)[1] - radius, "ground/rolled": rolled}
    return gaps, {"ground": contact(0), "ground/rolled": contact(1)}


def round_about(
    a: tuple[str, str], b: tuple[str, str], radius: float, circle: float, inside: bool
) -> tuple[dict[str, Gap], dict[str, Contact]]:
    """A disc on or in a circle, by the angle of the line of centres as seen from where it was drawn."""
    sign = -1.0 if inside else 1.0
    apart = circle + sign * radius
    first: list[float] = []

    def away(oracle: Oracle, q: Array) -> Array:
        return np.asarray(oracle.point(q, *a) - oracle.point(q, *b))

    def touches(oracle: Oracle, q: Array) -> float:
        return float(sign * (np.hypot(*away(oracle, q)) - apart))

    def rolled(oracle: Oracle, q: Array) -> float:
        x, y = away(oracle, q)
        passed = circle * oracle.pose(q, b[0])[2] + sign * radius * oracle.pose(q, a[0])[2] - apart * np.arctan2(y, x)
        first[:] = first or [float(passed)]
        return float(passed - first[0])

    def contact(way: int) -> Contact:
        def found(oracle: Oracle, q: Array, flank: int) -> tuple[str, str, Array, Array]:
            unit = away(oracle, q) / np.hypot(*away(oracle, q))
            ways = np.array([sign * unit, [-unit[1], unit[0]]])
            return a[0], b[0], flank * ways[way], oracle.point(q, *b) + circle * unit

        return found

    return {"ground": touches, "ground/rolled": rolled}, {"ground": contact(0), "ground/rolled": contact(1)}


def roller(inside: bool) -> dict[str, Any]:
    """An eccentric disc on a crank moves an arm with a roller; or the roller runs in a ring on the crank."""
    return {
        "linkwright": 1,
        "units": UNITS,
        "gravity": [0, -9810],
        "links": {
            "frame": {"points": {"A": [0, 0], "D": [120, 40]}},
            "cam": body({"A": [0, 0], "E": [15, 0]}, 2.0, [10, 3], 2e3),
            "arm": body({"D": [0, 0], "R": [110, 0]}, 0.7, [50, 4], 9e2),
            "roll": body({"R": [0, 0], "S": [12, 0]}, 0.3, [2, 1], 5e1),
        },
        "joints": {
            "ground": {
                "rolling": ["roll", "cam"],
                "centre": "R",
                "radius": 12,
                "on_circle": {"centre": "E", "radius": 90 if inside else 45, "inside": inside},
            }
        },
        "drives": {"motor": {"turns": "cam", "on": "frame", "speed": "60 rpm", "start": "0 deg"}},
    }


def _roller(inside: bool) -> Wheels:
    data = roller(inside)
    apart = 0.078 if inside else 0.057
    to_centre, _ = dyad((0.015, 0.0), (0.12, 0.04), apart, 0.11)
    centre = np.array([0.015 + apart * np.cos(to_centre), apart * np.sin(to_centre)])
    arm = float(np.arctan2(centre[1] - 0.04, centre[0] - 0.12))
    x, y = (1e3 * centre).tolist()
    data["assembly"] = {"R": [x, y], "S": [x + 12, y]}  # drawn as it is put together
    start: Start = {"cam": (0.0, 0.0, 0.0), "arm": (0.12, 0.04, arm), "roll": (*centre.tolist(), 0.0)}
    gaps, contacts = round_about(("roll", "R"), ("cam", "E"), 0.012, 0.09 if inside else 0.045, inside)
    return Wheels(data, start, gaps, contacts)


def _wheel() -> Wheels:
    start: Start = {
        "arm": (0.0, 0.06, 0.0),
        "rod": (0.09, 0.06, 0.0),
        "wheel": (0.35, 0.06, 0.0),
    }
    return Wheels(wheel({"on_line": "G at 0 deg"}), start, *touching(("wheel", "C"), ("frame", "G"), 0.06))


ROLLING = {"on the ground": _wheel(), "on a circle": _roller(inside=False), "in a ring": _roller(inside=True)}


# Belts whose loose strand is slack: the tight one pulls along the line that touches both wheels.


def strand(a: tuple[str, str], b: tuple[str, str], first: float, second: float) -> Contact:
    """The strand to the left (flank 1) or right of the line of centres; ``second`` is negative for an open belt."""

    def contact(oracle: Oracle, q: Array, flank: int) -> tuple[str, str, Array, Array]:
        start, end = oracle.point(q, *a), oracle.point(q, *b)
        size = float(np.hypot(*(end - start)))
        lean = float(np.arcsin((first + second) / size))
        along = (end - start) / size
        c, s = np.cos(flank * (np.pi / 2 - lean)), np.sin(flank * (np.pi / 2 - lean))
        out = np.array([c * along[0] - s * along[1], s * along[0] + c * along[1]])
        place, other = start + first * out, end - second * out
        return a[0], b[0], (other - place) / np.hypot(*(other - place)), place

    return contact


def belt(crossed: bool) -> Wheels:
    """The pair of gears with a belt instead."""
    data = pair()
    data["links"]["frame"]["points"]["M"] = [150, 20]
    data["joints"]["mesh"] = {"belt": ["pinion", "wheel"], "centres": ["O", "M"], "radii": [30, 60], "crossed": crossed}
    data["assembly"]["W"] = [190, 20]
    second = 0.06 if crossed else -0.06
    start: Start = {"pinion": (0.0, 0.0, 0.0), "wheel": (0.15, 0.02, 0.0)}
    ends = (("pinion", "O"), ("wheel", "M"), 0.03, second)
    return Wheels(data, start, {"mesh": rolled("pinion", "wheel", "frame", 0.03, second)}, {"mesh": strand(*ends)})


def _belt_on_an_arm() -> Wheels:
    """A timing belt from a wheel that stands still to one on an arm that turns."""
    data = {
        "linkwright": 1,
        "units": UNITS,
        "gravity": [0, -9810],
        "links": {
            "frame": {"points": {"O": [0, 0]}},
            "arm": body({"O": [0, 0], "P": [150, 0]}, 0.7, [70, 4], 3e3),
            "hand": body({"P": [0, 0], "Q": [60, 0]}, 0.5, [30, 3], 4e2),
        },
        "joints": {
            "mesh": {"belt": ["frame", "hand"], "centres": ["O", "P"], "carrier": "arm", "teeth": [40, 20], "pitch": 5}
        },
        "assembly": {"Q": [210, 0]},
        "drives": {"motor": {"turns": "arm", "on": "frame", "speed": "60 rpm", "start": "0 deg"}},
    }
    first, second = 0.2 / (2 * np.pi), -0.1 / (2 * np.pi)
    start: Start = {"arm": (0.0, 0.0, 0.0), "hand": (0.15, 0.0, 0.0)}
    gap = rolled("frame", "hand", "arm", first, second)
    return Wheels(data, start, {"mesh": gap}, {"mesh": strand(("frame", "O"), ("hand", "P"), first, second)})


BELTS = {"open": belt(crossed=False), "crossed": belt(crossed=True), "on an arm": _belt_on_an_arm()}
