"""Gallery models against closed forms, which the tests write out from the dimensions themselves.

Sources: Norton, Design of Machinery: quick-return ratios (ch. 3), position and rates of a four-bar by Freudenstein's
equation (ch. 4, 6), mechanical advantage (ch. 6); Freudenstein, Trans. ASME 77 (1955) 853-861; API Spec 11E.
Tolerances are relative to the size or the largest value: round-off of a few dozen steps, more
where a root is searched for.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from ruamel.yaml import YAML

from helpers.compiled import compiled_from
from linkwright import gallery
from linkwright.kernels import Compiled
from linkwright.results.run import Run
from linkwright.results.stationary import stationary

Array = NDArray[np.float64]
MM = 1e-3
INCH = 0.0254


def model(name: str, **parameters: Any) -> dict[str, Any]:
    """A gallery model's data, with other parameters where given."""
    data = YAML(typ="safe").load(gallery.text(name))
    assert {*parameters} <= {*data["parameters"]}
    data["parameters"] |= parameters
    return data  # type: ignore[no-any-return]


def rows(compiled: Compiled, t: Array, *names: str) -> Array:
    return Run(compiled, 0.0, float(t[-1]), 100).evaluate(names, t)


def turn(rpm: float, count: int = 73) -> Array:
    return np.linspace(0.0, 60.0 / abs(rpm), count)


# Quick returns.


def reversals(compiled: Compiled, name: str, stop: float) -> Array:
    """The times at which a signal turns back."""

    def rates(t: Array) -> tuple[Array, Array]:
        y = compiled.evaluate([name], t, rates=True)
        return y[:, 0], y[:, 1]

    return np.asarray(stationary(rates, 0.0, stop, 200)[0])


@pytest.mark.parametrize(("r", "d"), [(120, 300), (60, 300), (150, 300)])
def test_time_ratio_of_the_crank_shaper(r: float, d: float) -> None:
    """(180 + 2a)/(180 - 2a) with a = asin(r/d), the crank square to the lever where it reverses."""
    a = math.asin(r / d)
    data = model("crank-shaper", r=r, d=d)
    data["drives"]["motor"]["start"] = "0 deg"
    compiled = compiled_from(data)
    # From 0 deg the lever first reverses at 180 deg + a on the left, then at 360 deg - a on the right.
    period = 60 / 40
    left, right = reversals(compiled, "lever.angle", period)
    back = right - left
    assert (period - back) / back == pytest.approx((math.pi + 2 * a) / (math.pi - 2 * a), rel=1e-9)
    assert left / period * 2 * math.pi == pytest.approx(math.pi + a, rel=1e-9)
    ends = reversals(compiled, "F.x", period)
    assert ends == pytest.approx([left, right], rel=1e-9)  # the ram reverses with the lever
    x = rows(compiled, np.array([left, right]), "F.x")[0]
    assert x[1] - x[0] == pytest.approx(2 * 600 * MM * r / d, rel=1e-12)


@pytest.mark.parametrize(("r", "d"), [(120, 50), (120, 90), (100, 20)])
def test_time_ratio_of_the_whitworth_quick_return(r: float, d: float) -> None:
    """The crank turns 2 acos(d/r) on the way back; the stroke is twice the arm."""
    compiled = compiled_from(model("whitworth", r=r, d=d))
    period = 60 / 50
    right, left = reversals(compiled, "F.x", period)
    back = 2 * math.acos(d / r)
    assert (left - right) / period * 2 * math.pi == pytest.approx(back, rel=1e-9)
    x = rows(compiled, np.array([left, right]), "F.x")[0]
    assert x[1] - x[0] == pytest.approx(180 * MM, rel=1e-12)


def test_the_offset_slider_crank_takes_its_time_by_its_dead_centres() -> None:
    """Stroke and angles of the dead centres, where crank and rod are in line."""
    r, rod, e = 80.0, 220.0, 60.0
    compiled = compiled_from(model("offset-slider-crank"))  # clockwise, from the outer dead centre
    period = 60 / 45
    (inner,) = (t for t in reversals(compiled, "C.x", period) if 0.1 < t < period - 0.1)
    clockwise = math.pi + math.asin(e / (rod + r)) - math.asin(e / (rod - r))
    assert inner / period * 2 * math.pi == pytest.approx(clockwise, rel=1e-9)
    x = rows(compiled, np.array([0.0, inner]), "C.x")[0]
    stroke = math.sqrt((rod + r) ** 2 - e * e) - math.sqrt((rod - r) ** 2 - e * e)
    assert x[0] - x[1] == pytest.approx(stroke * MM, rel=1e-12)


# Straight lines, copies.


@pytest.mark.parametrize(("long", "short", "r"), [(250, 100, 80), (300, 120, 100), (90, 50, 25)])
def test_peaucellier_is_straight(long: float, short: float, r: float) -> None:
    """x = (L^2 - l^2)/(2 r) to 1e-12 of the size, and OP OR = L^2 - l^2 at every pose."""
    t = np.linspace(0, 2, 81)
    x, y, px, py = rows(compiled_from(model("peaucellier", L=long, l=short, r=r)), t, "R.x", "R.y", "P.x", "P.y")
    square = (long**2 - short**2) * MM**2
    assert np.abs(x - square / (2 * r * MM)).max() < 1e-12 * long * MM
    assert np.hypot(px, py) * np.hypot(x, y) == pytest.approx(square, rel=1e-12)
    assert np.ptp(y) > 0.5 * long * MM


@pytest.mark.parametrize("scale", [0.4, 0.25, 0.8])
def test_the_pantograph_copies_at_its_scale(scale: float) -> None:
    """P = scale R, with all rates."""
    t = np.linspace(0, 4, 41)
    compiled = compiled_from(model("pantograph", scale=scale))
    for row in ("x", "y", "vx", "vy", "ax", "ay"):
        tracer, pen = rows(compiled, t, f"P.{row}", f"R.{row}")
        assert np.abs(tracer - scale * pen).max() < 1e-13 * np.abs(pen).max()


def test_chebyshev_is_on_the_line_at_its_end_and_middle() -> None:
    """At the crossed middle pose and at the left end the link's middle lies exactly at 4 units of height."""
    data = model("chebyshev-straight-line")
    compiled, middle = compiled_from(data), math.atan2(200, 150)
    for angle in (math.pi / 2, middle):
        data["drives"]["servo"] = {"turns": "left", "on": "frame", "start": f"{angle!r} rad", "speed": 1}
        y, x = compiled_from(data).evaluate(["P.y", "P.x"], np.zeros(1))[:, 0]
        assert y == pytest.approx(200 * MM, rel=1e-14)
        assert x == pytest.approx(0.0 if angle > 1.5 else 100 * MM, abs=1e-14)
    y = rows(compiled, np.linspace(0, 2, 201), "P.y")[0]
    assert np.abs(y - 200 * MM).max() < 0.0025 * 200 * MM


# Forces.


def test_the_toggle_press_by_its_mechanical_advantage() -> None:
    """Without masses torque x speed = force x speed: F/(T/r) = r w/|v|, by the velocities of the loop alone."""
    compiled = compiled_from(model("toggle-press"))
    r, up, low, back, pull = (v * MM for v in (60, 300, 350, 450, 390))
    t = turn(30, 37)[1:-1]
    t = t[np.abs(np.mod(90 + 180 * t + 180, 360) - 180) > 4]  # away from the toggle, where both vanish
    # Static forces: a slow press; the links' inertia falls with the square of the speed.
    data = model("toggle-press")
    for link in data["links"].values():
        link.pop("mass", None), link.pop("shape", None)
    torque = rows(compiled_from(data), t, "motor.torque")[0]
    theta = np.pi / 2 + math.pi * t
    bx, by = -back + r * np.cos(theta), -up + r * np.sin(theta)
    # The knee: at `up` from D = 0 and `pull` from B, on the left of the way from D to B.
    d2 = bx**2 + by**2
    a = (up**2 - pull**2 + d2) / (2 * np.sqrt(d2))
    h = np.sqrt(up**2 - a**2)
    ux, uy = bx / np.sqrt(d2), by / np.sqrt(d2)
    kx, ky = a * ux - h * uy, a * uy + h * ux
    # Rates: (K - B).(vK - vB) = 0 and K.vK = 0; then the ram below: (K - R).(vK - vR) = 0.
    w = math.pi
    vbx, vby = -r * w * np.sin(theta), r * w * np.cos(theta)
    ex, ey = kx - bx, ky - by
    rate = (ex * vbx + ey * vby) / (ex * -ky + ey * kx)  # of the upper link
    vkx, vky = -ky * rate, kx * rate
    ram = ky - np.sqrt(low**2 - kx**2)
    speed = vky + kx / (ky - ram) * vkx
    assert rows(compiled, t, "R.y")[0] == pytest.approx(ram, abs=1e-12)
    assert torque * w == pytest.approx(-200e3 * speed, abs=1e-9 * 200e3 * np.abs(speed).max())


def test_the_scissor_lift_holds_its_load_by_its_height() -> None:
    """h = sqrt(L^2 - x^2); the spindle holds (load + weight and inertia of the platform) x/h."""
    data = model("scissor-lift")
    data["drives"]["spindle"]["position"] = "1150 mm - 50 mm/s*t"
    for link in ("arm1", "arm2", "foot", "top_roller"):
        data["links"][link].pop("mass"), data["links"][link].pop("shape")
    data["links"]["platform"] |= {"mass": 40}
    length, g = 1.2, 9.80665
    t = np.linspace(0, 9, 31)
    x, v = 1.15 - 0.05 * t, -0.05
    height = np.sqrt(length**2 - x**2)
    speed = -x * v / height
    lift = -(v * v) / height - (x * v) ** 2 / height**3  # the platform's acceleration at constant spindle speed
    y, vy, ay, force, tilt = rows(compiled_from(data), t, "D.y", "D.vy", "D.ay", "spindle.force", "platform.angle")
    assert y == pytest.approx(height, rel=1e-13)
    assert vy == pytest.approx(speed, rel=1e-12)
    assert ay == pytest.approx(lift, rel=1e-11)
    assert np.abs(tilt).max() < 1e-13
    assert force == pytest.approx(-(3000 + 40 * (g + lift)) * x / height, rel=1e-11)


# Four-bars by Freudenstein's equation.


def freudenstein(theta: Array, a: float, b: float, c: float, d: float, side: float) -> Array:
    """The follower's angle for crank a, coupler b, follower c, ground d along x; side -1 has the open form."""
    k1, k2, k3 = d / a, d / c, (a * a - b * b + c * c + d * d) / (2 * a * c)
    p = np.cos(theta) - k1 - k2 * np.cos(theta) + k3
    q = -2 * np.sin(theta)
    r = k1 - (k2 + 1) * np.cos(theta) + k3
    return np.asarray(2 * np.arctan2(-q + side * np.sqrt(q * q - 4 * p * r), 2 * p))


@pytest.mark.parametrize(
    ("name", "links", "rpm", "start", "follower"),
    [
        ("crank-rocker", (60, 190, 120, 200), 60, 0.0, "rocker"),
        ("double-crank", (90, 100, 110, 50), 120, 0.0, "follower"),
        ("wiper", (40, 300, 55, 305), 45, math.pi / 2, "driver"),
    ],
)
def test_followers_by_freudenstein(
    name: str, links: tuple[float, ...], rpm: float, start: float, follower: str
) -> None:
    a, b, c, d = links
    t = turn(rpm)[:-1] + 1e-3
    theta = start + rpm * math.pi / 30 * t
    found = rows(compiled_from(model(name)), t, f"{follower}.angle")[0]
    expected = freudenstein(theta, a, b, c, d, -1.0)
    assert np.abs(np.sin((found - expected) / 2)).max() < 1e-13
    # Speeds: w4 = w a sin(theta2 - theta3)/(c sin(theta4 - theta3)).
    cx, cy = d + c * np.cos(expected), c * np.sin(expected)
    coupler = np.arctan2(cy - a * np.sin(theta), cx - a * np.cos(theta))
    w = rpm * math.pi / 30 * a * np.sin(theta - coupler) / (c * np.sin(expected - coupler))
    assert rows(compiled_from(model(name)), t, f"{follower}.omega")[0] == pytest.approx(w, abs=1e-11 * np.abs(w).max())


def test_the_pumpjack_by_api_11e() -> None:
    """As in API Spec 11E: the beam's angle is that of J, from saddle to crank pin, and that between C and J by the
    law of cosines; the torque factor is A R sin(alpha)/(C sin(beta))."""
    front, rear, pitman, i, h, g, r = (v * INCH for v in (72, 64, 74.5, 64, 116, 41, 24))
    t = turn(12)
    theta = 12 * math.pi / 30 * t
    jx, jy = i + r * np.cos(theta), (g - h) + r * np.sin(theta)  # from the saddle bearing to the crank pin
    j = np.hypot(jx, jy)
    chi = np.arccos((rear**2 + j**2 - pitman**2) / (2 * rear * j))
    beam = np.arctan2(jy, jx) + chi
    compiled = compiled_from(model("pumpjack"))
    found, omega, torque = rows(compiled, t, "beam.angle", "beam.omega", "motor.torque")
    assert np.abs(np.sin((found - beam) / 2)).max() < 1e-13
    # alpha is between crank and pitman, beta between pitman and beam.
    ex, ey = rear * np.cos(beam), rear * np.sin(beam)
    pit = np.arctan2(ey - jy, ex - jx)
    factor = front * r * np.sin(theta - pit) / (rear * np.sin(beam - pit))
    assert front * omega / (12 * math.pi / 30) == pytest.approx(factor, abs=1e-12 * front)
    # Against the same model without ropes, their torque on the crank is the load times the factor.
    bare = model("pumpjack", rods="0 kN")
    assert torque - rows(compiled_from(bare), t, "motor.torque")[0] == pytest.approx(
        -30e3 * factor, abs=1e-10 * 30e3 * front
    )


def test_hoecken_is_on_its_line_where_the_crank_is_square_to_the_ground() -> None:
    """By the proportions 1 : 2 : 2.5 : 2.5 : 5 P = B + 2 (C - B); it is exactly 4 r high at 90 and 270 deg."""
    data = model("hoecken-straight-line")
    t = np.array([0.25, 0.5, 0.75])
    x, y, cx, cy = rows(compiled_from(data), t, "P.x", "P.y", "C.x", "C.y")
    theta = 2 * np.pi * t
    assert x == pytest.approx(2 * cx - 40 * MM * np.cos(theta), abs=1e-14)
    assert y == pytest.approx(2 * cy - 40 * MM * np.sin(theta), abs=1e-14)
    assert y[[0, 2]] == pytest.approx(160 * MM, rel=1e-13)


def test_the_gallery_is_read_from_its_files() -> None:
    """What is validated here is what ``linkwright new`` writes."""
    folder = Path(gallery.__file__).parent
    assert model("wiper") == YAML(typ="safe").load((folder / "wiper.yaml").read_text("utf-8"))
