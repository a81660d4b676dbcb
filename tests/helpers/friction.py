"""Mechanisms with friction whose forces are known in closed form."""

from __future__ import annotations

from typing import Any

SIZES = {"A": 0.010, "B": 0.012, "C": 0.008}
"""Radii of the pins (m)."""


def slider_crank(mu: float = 0.1, rail: float | None = 0.12, push: float = -1000.0) -> dict[str, Any]:
    """A centric slider-crank without mass: crank 50 mm, rod 160 mm, a force on the slider, friction in its pins and,
    where a coefficient is given, its guide."""
    friction = {f"at_{n}": {"pin": n, "radius": f"{r} m", "coefficient": mu} for n, r in SIZES.items()}
    if rail is not None:
        friction["rail"] = {"slide": "guide", "length": "60 mm", "coefficient": rail}
    return {
        "linkwright": 1,
        "units": {"length": "mm", "angle": "rad", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"},
        "links": {
            "frame": {"points": {"A": [0, 0]}},
            "crank": {"points": {"A": [0, 0], "B": [50, 0]}},
            "rod": {"points": {"B": [0, 0], "C": [160, 0]}},
            "slider": {"points": {"C": [0, 0]}},
        },
        "joints": {"guide": {"prismatic": ["frame", "slider"], "line": ["A at 0", "C at 0"]}},
        "assembly": {"C": "ahead of B along guide"},
        "drives": {"motor": {"turns": "crank", "on": "frame", "speed": "300 rpm", "start": 0.3}},
        "loads": {"resistance": {"on": "slider", "at": "C", "along": "guide", "force": push}},
        "friction": friction,
    }
