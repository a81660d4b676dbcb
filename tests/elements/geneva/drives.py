"""Geneva drives for tests: in any position, on the frame or on a moving arm, with unbalanced links."""

from __future__ import annotations

from math import cos, pi, radians, sin
from typing import Any

UNITS = {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"}
A, ARC = 100.0, 0.8
"""The centre distance (mm), and the radius of the locking disc over that of the pins' circle."""
LINE, ARM, SLOT = 25.0, 40.0, 17.0
"""Directions (deg): of the line of centres on its link, of the first pin on the driver, of a slot on the wheel."""


def radius(n: int) -> float:
    """That of the pins' circle (mm)."""
    return A * sin(pi / n)


def arc(n: int) -> float:
    """That of the locking disc (mm): between the wheel's rim and the pin."""
    low = A * (1 - cos(pi / n))
    return low + ARC * (radius(n) - low)


def model(
    n: int = 4, *, pins: int = 1, psi: float = 0.0, speed: str = "60 rpm", arm: bool = False, **sections: Any
) -> dict[str, Any]:
    """A drive whose first pin starts at the angle ``psi`` (deg) from the line of centres; on a turning ``arm``."""
    across = [10 + A * cos(radians(LINE)), 20 + A * sin(radians(LINE))]
    centres = {"O": [10, 20], "Q": across}
    names = [f"P{k + 1}" for k in range(pins)]
    angles = (radians(ARM) + 2 * pi * k / pins for k in range(pins))
    places = [[radius(n) * cos(angle), radius(n) * sin(angle)] for angle in angles]
    on, driver = "arm" if arm else "frame", {"O": [0, 0], **dict(zip(names, places, strict=True))}
    drive = {"geneva": ["driver", "wheel"], "centres": ["O", "Q"], "pins": names, "slots": n, "arc": arc(n)}
    data: dict[str, Any] = {
        "linkwright": 1,
        "units": UNITS,
        "gravity": [0, -9810],
        "links": {
            "frame": {"points": {"G": [0, 0]} if arm else centres},
            "driver": {"points": driver, "mass": 1.5, "com": [8, -3], "inertia": 2500},
            "wheel": {"points": {"Q": [0, 0], "T": [30, 40]}, "mass": 4, "com": [6, 11], "inertia": 9000},
        },
        "joints": {"indexing": {**drive, "slot": SLOT, **({"carrier": "arm"} if arm else {})}},
        "drives": {"motor": {"turns": "driver", "on": on, "speed": speed, "start": psi + LINE - ARM}},
    }
    if arm:
        data["links"]["arm"] = {"points": {"G": [0, 0], **centres}, "mass": 2, "com": [50, 30], "inertia": 6000}
        data["drives"]["swing"] = {"turns": "arm", "on": "frame", "speed": "25 rpm", "start": "12 deg"}
    return {**data, **sections}
