"""Links that no joint places: bars on pins in slots alone, turned or moved, against closed forms and an own Newton in
plain numbers."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from helpers.compiled import compiled_from
from linkwright.results.certificate import certify
from linkwright.results.run import Run

G = 9.80665
UNITS = {"length": "m", "angle": "rad", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"}


def bar(drive: dict[str, Any], sketch: dict[str, Any], length: float = 2.0, **more: Any) -> dict[str, Any]:
    """A bar with A in an upright slot through T, B in a level one through H."""
    return {
        "units": UNITS,
        "gravity": "earth",
        "links": {
            "frame": {"points": {"T": [0, 0], "H": [0, 0]}},
            "bar": {"points": {"A": [0, 0], "B": [length, 0]}, "mass": 60, "com": [length / 2, 0], "inertia": 20},
        },
        "joints": {
            "low": {"pin_in_slot": ["bar", "frame"], "pin": "A", "straight": f"T at {math.pi / 2!r}"},
            "up": {"pin_in_slot": ["bar", "frame"], "pin": "B", "straight": "H at 0"},
        },
        "assembly": sketch,
        "drives": {"motor": drive},
        **more,
    }


def test_a_door_whose_upper_roller_is_moved() -> None:
    """By virtual work with the level place q of B and the height s = sqrt(4 - q^2): F v = d/dt (T + m g y)."""
    q0, v = 0.28, 0.15
    drive = {"moves": "bar", "at": "B", "on": "frame", "along": "H at 0", "position": f"{q0} m + {v} m*t/(1 s)"}
    compiled = compiled_from(bar(drive, {"A": [0, -1.98], "B": [q0, 0]}))
    t = np.linspace(0.0, 10.0, 31)
    force, height, turn = compiled.evaluate(["motor.force", "A.y", "bar.angle"], t)
    q = q0 + v * t
    s = np.sqrt(4 - q * q)
    # T = v^2 (m/2 (1/4 + q^2/(4 s^2)) + I/(2 s^2)), y = -s/2; F v = d/dt (T + m g y).
    expected = 60 * G * q / (2 * s) + v * v * (60 * q / s**4 + 20 * q / s**4)
    np.testing.assert_allclose(force, expected, rtol=1e-11)
    np.testing.assert_allclose(height, -s, rtol=1e-12)
    np.testing.assert_allclose(np.sin(turn), s / 2, rtol=1e-12)


def test_a_trammel_that_is_turned() -> None:
    """A = (0, -l sin), B = (l cos, 0): the bar turns at the prescribed rate, the outer point on an ellipse."""
    drive = {"turns": "bar", "on": "frame", "speed": "2 rad/s", "start": 0.3}
    data = bar(drive, {"A": [0, -0.59], "B": [1.9, 0]})
    data["links"]["bar"]["points"]["P"] = [3.0, 0]
    t = np.linspace(0.0, 7.0, 41)
    angle = 0.3 + 2 * t
    x, y, torque = compiled_from(data).evaluate(["P.x", "P.y", "motor.torque"], t)
    np.testing.assert_allclose(x, 3 * np.cos(angle), atol=1e-12)
    np.testing.assert_allclose(y, np.sin(angle), atol=1e-12)
    # The centre runs on a circle at constant speed: gravity alone asks for a torque.
    np.testing.assert_allclose(torque, -60 * G * np.cos(angle), atol=1e-9 * 60 * G)


@pytest.mark.parametrize("seed", range(12))
def test_random_bodies_on_slots(seed: int) -> None:
    """Two pins of a body in straight or circular slots, a third point moved along a line; the pose by an own Newton."""
    random = np.random.default_rng(seed)
    round_ = seed % 2 == 0  # the first slot is an arc about a centre

    def there(pose: np.ndarray, name: str) -> np.ndarray:
        c, s = math.cos(pose[2]), math.sin(pose[2])
        return pose[:2] + np.array([[c, -s], [s, c]]) @ local[name]

    def miss(pose: np.ndarray, q: float) -> np.ndarray:
        a, b, p = (there(pose, n) - at for n, at in zip("ABC", (base, points["B"], points["C"]), strict=True))
        first = np.hypot(*a) - radius if round_ else math.cos(ways[0]) * a[1] - math.sin(ways[0]) * a[0]
        second = math.cos(ways[1]) * b[1] - math.sin(ways[1]) * b[0]
        return np.array([first, second, p @ [math.cos(ways[2]), math.sin(ways[2])] - q])

    def slopes(pose: np.ndarray, q: float) -> np.ndarray:
        return np.array([(miss(pose + h, q) - miss(pose - h, q)) / 2e-6 for h in np.eye(3) * 1e-6]).T

    while True:  # bodies far from dead centres
        local = {name: random.normal(size=2) for name in "ABC"}
        start = np.array([*random.normal(size=2), random.uniform(-3, 3)])
        ways, radius = random.uniform(-3, 3, 3).tolist(), float(random.uniform(1, 3))
        points = {name: there(start, name) for name in "ABC"}
        base = points["A"] - radius * np.array([math.cos(ways[0]), math.sin(ways[0])]) if round_ else points["A"]
        if np.linalg.cond(slopes(start, 0.0)) < 8:
            break
    frame = {"P": base.tolist(), "Q": points["B"].tolist(), "R": points["C"].tolist()}
    slot = {"arc": {"centre": "P", "radius": radius}} if round_ else {"straight": f"P at {ways[0]!r}"}
    data = {
        "units": UNITS,
        "gravity": [0, -9.81],
        "links": {
            "frame": {"points": frame},
            "body": {
                "points": {n: p.tolist() for n, p in local.items()}, "mass": 2.0, "com": [0.1, 0.2], "inertia": 0.3,
            },
        },
        "joints": {
            "one": {"pin_in_slot": ["body", "frame"], "pin": "A", **slot},
            "two": {"pin_in_slot": ["body", "frame"], "pin": "B", "straight": f"Q at {ways[1]!r}"},
        },
        "assembly": {n: points[n].tolist() for n in "ABC"},
        "drives": {
            "motor": {
                "moves": "body", "at": "C", "on": "frame", "along": f"R at {ways[2]!r}",
                "position": "0.02 m*sin(3 rad/s*t)",
            }
        },
    }  # fmt: skip
    t = np.linspace(0.0, 1.0, 6)
    compiled = compiled_from(data)
    x, y, turned = compiled.evaluate(["A.x", "A.y", "body.angle"], t)

    pose = start.copy()
    for i, now in enumerate(t):
        q = 0.02 * math.sin(3 * now)
        for _ in range(30):
            pose = pose - np.linalg.solve(slopes(pose, q), miss(pose, q))
        np.testing.assert_allclose([x[i], y[i]], there(pose, "A"), atol=1e-9)
        np.testing.assert_allclose(math.sin((turned[i] - pose[2]) / 2), 0.0, atol=1e-9)
    assert certify(Run(compiled, float(t[0]), float(t[-1]), len(t) - 1)).sound()


def test_a_rod_on_a_floating_bar() -> None:
    """What is pinned on a bar that floats hangs on it; both of them in one group or one after the other."""
    drive = {
        "moves": "bar",
        "at": "A",
        "on": "frame",
        "along": f"T at {math.pi / 2!r}",
        "position": "-1 m + 0.1 m*t/(1 s)",
    }
    data = bar(drive, {"A": [0, -1], "B": [1.7, 0], "D": [2.5, -0.5]})
    data["links"]["rod"] = {"points": {"B": [0, 0], "D": [1, 0]}, "mass": 1, "com": [0.5, 0], "inertia": 0.1}
    data["links"]["frame"]["points"]["U"] = [0, -0.5]
    data["joints"]["tail"] = {"pin_in_slot": ["rod", "frame"], "pin": "D", "straight": "U at 0"}
    t = np.linspace(0.0, 5.0, 9)
    compiled = compiled_from(data)
    (x,) = compiled.evaluate(["D.x"], t)
    np.testing.assert_allclose(x, np.sqrt(4 - (1 - 0.1 * t) ** 2) + math.sqrt(0.75), rtol=1e-12)
    assert certify(Run(compiled, float(t[0]), float(t[-1]), len(t) - 1)).sound()
