"""Mechanisms whose motion or forces have a closed form: held to 1e-12 of the size, round-off of a few steps.

Sources: slider-crank, Norton, Design of Machinery, ch. 13 (exact form); quick return and scotch yoke, any textbook;
Peaucellier's inversor (1864), exact straight line; Cardan's trammel, ellipse.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from helpers.compiled import compiled_from
from helpers.examples import UNITS, four_bar, slider_crank
from linkwright.results.run import Run

Array = NDArray[np.float64]
W = 2.0
T = np.linspace(0.0, 2 * np.pi / W, 97)[:-1]
THETA = W * T


def evaluated(data: dict[str, Any], *names: str) -> Array:
    data["drives"]["motor"] |= {"speed": W, "start": 0}
    return Run(compiled_from(data), 0.0, 2 * np.pi / W, 100).evaluate(names, T)


@pytest.mark.parametrize("e", [0.0, 0.25, -0.4])
@pytest.mark.parametrize("way", [1, -1])
def test_slider_crank_motion(e: float, way: int) -> None:
    """x = r cos + sqrt(l^2 - (r sin - e)^2) and its derivatives; behind the crank pin the root is negative."""
    r, rod = 0.5, 1.7
    data = slider_crank(r, rod, e, assembly={"C": f"{'ahead of' if way > 0 else 'behind'} B along bore"})
    found = evaluated(data, "C.x", "C.vx", "C.ax", "C.y", "rod.omega")
    c, s = np.cos(THETA), np.sin(THETA)
    y = r * s - e
    root = way * np.sqrt(rod**2 - y**2)
    slope = -r * c * y / root
    bend = (r * s * y - (r * c) ** 2 - slope**2) / root
    assert found[0] == pytest.approx(r * c + root, abs=1e-13)
    assert found[1] == pytest.approx(W * (-r * s + slope), abs=1e-12)
    assert found[2] == pytest.approx(W**2 * (-r * c + bend), abs=1e-11)
    assert found[3] == pytest.approx(np.full(T.size, e), abs=1e-15)
    assert found[4] == pytest.approx(-W * r * c / root, abs=1e-12)


def test_slider_crank_forces() -> None:
    """Piston of mass m under a constant force, links without mass: torque, side thrust, pin and bearing forces."""
    r, rod, m, force = 0.5, 1.7, 3.0, -40.0
    data = slider_crank(r, rod, loads={"gas": {"on": "piston", "at": "C", "along": "bore", "force": force}})
    data["links"]["piston"] |= {"mass": m, "shape": "point C"}
    names = [
        "motor.torque",
        "force(frame, piston).normal",
        "force(frame, piston).moment",
        "force(rod, piston).x",
        "force(rod, piston).y",
        "force(frame, crank).x",
        "shaking.x",
        "shaking.y",
    ]
    torque, normal, moment, px, py, ax, sx, sy = evaluated(data, *names)
    c, s = np.cos(THETA), np.sin(THETA)
    cos_phi = np.sqrt(1 - (r * s / rod) ** 2)
    tan_phi = -(r * s / rod) / cos_phi
    slope = -r * s - r * c * r * s / (rod * cos_phi)
    acceleration = evaluated(data, "C.ax")[0]
    along = m * acceleration - force  # what the rod must push the piston with
    assert torque == pytest.approx(along * slope, abs=1e-10)
    assert px == pytest.approx(along, abs=1e-10)
    assert py == pytest.approx(along * tan_phi, abs=1e-10)
    assert normal == pytest.approx(-along * tan_phi, abs=1e-10)
    assert np.abs(moment).max() < 1e-12
    assert ax == pytest.approx(along, abs=1e-10)
    assert sx == pytest.approx(force - m * acceleration, abs=1e-10)
    assert np.abs(sy).max() < 1e-10


def test_scotch_yoke_is_harmonic() -> None:
    r = 0.3
    data = {
        "linkwright": 1,
        "units": UNITS,
        "links": {
            "frame": {"points": {"A": [0, 0], "F": [0, 0]}},
            "crank": {"points": {"A": [0, 0], "B": [r, 0]}},
            "block": {"points": {"B": [0, 0]}},
            "yoke": {"points": {"Y": [0, 0]}, "mass": 2, "shape": "point Y"},
        },
        "joints": {
            "slot": {"prismatic": ["yoke", "block"], "line": ["Y at pi/2", "B at pi/2"]},
            "bed": {"prismatic": ["frame", "yoke"], "line": ["F at 0", "Y at 0"]},
        },
        "drives": {"motor": {"turns": "crank", "on": "frame"}},
    }
    x, v, a, j, torque, slot = evaluated(data, "Y.x", "Y.vx", "Y.ax", "Y.jx", "motor.torque", "slot.s")
    c, s = np.cos(THETA), np.sin(THETA)
    for found, expected in ((x, c), (v, -W * s), (a, -(W**2) * c), (j, W**3 * s), (slot, s)):
        assert found == pytest.approx(r * expected, abs=1e-13)
    assert torque == pytest.approx(2 * (-(W**2) * r * c) * (-r * s), abs=1e-12)


def test_quick_return_of_an_inverted_slider_crank() -> None:
    """Whitworth's slotted lever: its angle is that of the crank pin seen from its pivot."""
    r, d = 0.4, 1.0
    data = {
        "linkwright": 1,
        "units": UNITS,
        "links": {
            "frame": {"points": {"A": [0, 0], "D": [-d, 0]}},
            "crank": {"points": {"A": [0, 0], "B": [r, 0]}},
            "block": {"points": {"B": [0, 0]}},
            "lever": {"points": {"D": [0, 0]}},
        },
        "joints": {"slot": {"prismatic": ["lever", "block"], "line": ["D at 0", "B at 0"]}},
        "assembly": {"B": "ahead of D along slot"},
        "drives": {"motor": {"turns": "crank", "on": "frame"}},
    }
    angle, omega, slot, block = evaluated(data, "lever.angle", "lever.omega", "slot.s", "block.angle")
    c, s = np.cos(THETA), np.sin(THETA)
    square = d * d + 2 * d * r * c + r * r
    assert angle == pytest.approx(np.arctan2(r * s, d + r * c), abs=1e-13)
    assert omega == pytest.approx(W * (r * r + r * d * c) / square, abs=1e-12)
    assert slot == pytest.approx(np.sqrt(square), abs=1e-13)
    assert block == pytest.approx(angle, abs=1e-13)


def test_trammel_draws_an_ellipse() -> None:
    """A bar with a block in each of two crossed slots, turned by a crank of half its length (Cardan)."""
    half = 0.5
    data = {
        "linkwright": 1,
        "units": UNITS,
        "links": {
            "frame": {"points": {"O": [0, 0]}},
            "crank": {"points": {"O": [0, 0], "M": [half, 0]}},
            "bar": {"points": {"M": [0, 0], "X": [half, 0], "Y": [-half, 0], "P": [1.5, 0]}},
            "block": {"points": {"X": [0, 0]}},
        },
        "joints": {"slot": {"prismatic": ["frame", "block"], "line": ["O at 0", "X at 0"]}},
        "assembly": {"X": "ahead of M along slot"},
        "drives": {"motor": {"turns": "crank", "on": "frame"}},
    }
    data["drives"]["motor"] |= {"speed": 1, "start": -1}
    t = np.linspace(0.0, 2.0, 41)  # away from 90 deg, where the bar may change its mode
    xx, yx, px, py = compiled_from(data).evaluate(["X.x", "Y.x", "P.x", "P.y"], t)
    theta = t - 1
    assert xx == pytest.approx(2 * half * np.cos(theta), abs=1e-13)
    assert np.abs(yx).max() < 1e-13
    assert px == pytest.approx((half + 1.5) * np.cos(theta), abs=1e-13)
    assert py == pytest.approx((half - 1.5) * np.sin(theta), abs=1e-13)


def test_peaucellier_draws_a_straight_line() -> None:
    """Eight links, pins of three links; the pen stays at x = (L^2 - l^2) / (2 r), to round-off."""
    long, short, r = 5.0, 2.0, 1.6
    data = {
        "linkwright": 1,
        "units": UNITS,
        "links": {
            "frame": {"points": {"O": [0, 0], "Q": [r, 0]}},
            "crank": {"points": {"Q": [0, 0], "P": [r, 0]}},
            "up": {"points": {"O": [0, 0], "A": [long, 0]}},
            "down": {"points": {"O": [0, 0], "B": [long, 0]}},
            "a1": {"points": {"P": [0, 0], "A": [short, 0]}},
            "b1": {"points": {"P": [0, 0], "B": [short, 0]}},
            "a2": {"points": {"A": [0, 0], "R": [short, 0]}},
            "b2": {"points": {"B": [0, 0], "R": [short, 0]}},
        },
        "assembly": {"A": "left of O-P", "B": "right of O-P", "R": "right of B-A"},
        "drives": {"motor": {"turns": "crank", "on": "frame", "speed": 1, "start": -0.4}},
    }
    t = np.linspace(0.0, 0.8, 41)
    compiled = compiled_from(data)
    x, y, vx, ax, jx = compiled.evaluate(["R.x", "R.y", "R.vx", "R.ax", "R.jx"], t)
    assert x == pytest.approx(np.full(t.size, (long**2 - short**2) / (2 * r)), abs=1e-12)
    assert np.ptp(y) > 2
    assert np.abs(vx).max() < 1e-11
    assert np.abs(ax).max() < 1e-10
    assert np.abs(jx).max() < 1e-8
    assert compiled.structure.topology.gruebler == 1


def test_a_parallelogram_moves_its_coupler_without_turning_it() -> None:
    data = four_bar(1, 3, 1, 3)
    data["drives"]["motor"] |= {"start": 0.3, "speed": 1}
    t = np.linspace(0.0, 2.5, 30)
    angle, omega, cx, cy = compiled_from(data).evaluate(["coupler.angle", "coupler.omega", "C.x", "C.y"], t)
    assert max(np.abs(angle).max(), np.abs(omega).max()) < 1e-13
    assert cx == pytest.approx(3 + np.cos(0.3 + t), abs=1e-13)
    assert cy == pytest.approx(np.sin(0.3 + t), abs=1e-13)


def test_chebyshev_s_lambda_mechanism_has_a_right_angle_at_its_pivot() -> None:
    """Arms 2, 5, 5 on a ground of 4, the coupler twice as long as its pin: by Thales B-D-P is a right angle."""
    data = four_bar(2, 5, 5, 4)
    data["links"]["coupler"]["points"]["P"] = [10, 0]
    x, y, cx, cy, bx, by = evaluated(data, "P.x", "P.y", "C.x", "C.y", "B.x", "B.y")
    assert x == pytest.approx(2 * cx - bx, abs=1e-12)
    assert y == pytest.approx(2 * cy - by, abs=1e-12)
    assert np.abs((x - 4) * (bx - 4) + y * by).max() < 1e-11


def test_mean_torque_of_a_frictionless_turn_is_nil() -> None:
    """Over a whole turn at constant speed the drive's work is nil, whatever the masses: trapezoids converge fast."""
    data = four_bar(1, 3, 3, 4, gravity=[0, -9.81])
    for link, mass in (("crank", 1.0), ("coupler", 2.0), ("rocker", 3.0)):
        data["links"][link] |= {"mass": mass, "com": [0.4, 0.2], "inertia": 0.3}
    torque = evaluated(data, "motor.torque")[0]
    assert abs(torque.mean()) < 1e-9 * np.abs(torque).max()
