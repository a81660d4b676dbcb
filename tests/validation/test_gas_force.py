"""Gas force on a slider-crank: R. L. Norton, Design of Machinery, ch. 13 (engine dynamics), eqs. 13.8a and 13.8b.

Eq. 13.8a is exact, T = F tan(phi) x with the rod's angle phi and the piston's place x: held to 1e-12 of the largest.
Eq. 13.8b, T = F r sin(theta) (1 + r/l cos(theta)), drops terms of (r/l)^2: held to that order. Over a cycle the work of
the gas is the area of the pV diagram, so the mean torque is that area over 4 pi, inertia or not.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import linkwright as lw
from linkwright.kernels import Compiled

EXAMPLE = Path(__file__).parents[2] / "examples" / "slider_crank_gas.yaml"
R, L, AREA = 0.045, 0.14, np.pi / 4 * 0.086**2
OMEGA = 3000 * np.pi / 30


def pressure(theta: Any) -> Any:
    """The pressure (Pa) of the example's file at crank angles (rad)."""
    angle, bar = np.loadtxt(EXAMPLE.parent / "gas.csv", delimiter=",", skiprows=1).T
    return np.interp(np.mod(np.degrees(theta), 720), angle, bar) * 1e5


def massless() -> Compiled:
    document = lw.load(EXAMPLE)
    data = document.model_dump(exclude_defaults=True, by_alias=True)
    for name in ("crank", "rod", "piston"):
        data["links"][name] = {"points": data["links"][name]["points"]}
    return lw.compile(lw.Document.model_validate(data), EXAMPLE.parent)


def test_gas_torque_of_norton() -> None:
    t = np.linspace(0.0, 0.04, 331)
    theta = OMEGA * t
    force = pressure(theta) * AREA
    sine = R / L * np.sin(theta)
    x = R * np.cos(theta) + L * np.sqrt(1 - sine**2)
    exact = force * sine / np.sqrt(1 - sine**2) * x
    (torque,) = massless().evaluate(["engine.torque"], t)
    assert np.abs(-torque - exact).max() < 1e-12 * np.abs(exact).max()
    approximate = force * R * np.sin(theta) * (1 + R / L * np.cos(theta))
    assert np.abs(-torque - approximate).max() < (R / L) ** 2 * np.abs(exact).max()


def test_side_thrust_is_the_force_times_the_tangent_of_the_rod() -> None:
    t = np.linspace(0.0, 0.04, 57)
    sine = R / L * np.sin(OMEGA * t)
    expected = -pressure(OMEGA * t) * AREA * sine / np.sqrt(1 - sine**2)
    (normal,) = massless().evaluate(["force(piston, frame).normal"], t)
    assert np.abs(normal - expected).max() < 1e-12 * np.abs(expected).max()


def test_mean_torque_is_the_work_of_the_cycle_over_four_pi() -> None:
    """The area of the pV diagram by Gauss quadrature between the points of the file, with dV/dtheta in closed form."""
    angle = np.radians(np.loadtxt(EXAMPLE.parent / "gas.csv", delimiter=",", skiprows=1)[:, 0])
    nodes, weights = np.polynomial.legendre.leggauss(20)
    middle, half = (angle[1:] + angle[:-1])[:, None] / 2, np.diff(angle)[:, None] / 2
    theta = middle + half * nodes
    slope = R * np.sin(theta) * (1 + R * np.cos(theta) / np.sqrt(L**2 - (R * np.sin(theta)) ** 2))
    work = float((pressure(theta) * AREA * slope * half * weights).sum())
    job = lw.run(EXAMPLE)
    assert job.exit_code == 0
    measures = {m.name: m for m in job.cycle.measures}  # type: ignore[union-attr]
    assert measures["mean_torque"].shown() == pytest.approx(work / (4 * np.pi), rel=1e-11)
    assert measures["power"].shown() == pytest.approx(work / 0.04 / 1e3, rel=1e-11)
    certificate = job.cycle.result.certificate  # type: ignore[union-attr]
    assert certificate is not None
    assert certificate.sound(1e-12)


def test_the_foundation_feels_the_momentum_alone() -> None:
    """The gas pushes on the cylinder head as on the piston: shaking is minus the rate of change of the momentum."""
    t = np.linspace(0.0, 0.04, 97)
    theta = OMEGA * t
    s, c = np.sin(theta), np.cos(theta)
    g = np.sqrt(L**2 - (R * s) ** 2)
    pin = -R * OMEGA**2 * np.array([c, s])
    reach = -(R**2) * ((c**2 - s**2) / g + (R * s * c) ** 2 / g**3) * OMEGA**2
    piston = np.array([pin[0] + reach, 0 * t])
    expected = -0.6 * (pin + piston) / 2 - 0.5 * piston
    compiled = lw.compile(lw.load(EXAMPLE), EXAMPLE.parent)
    shaking = compiled.evaluate(["shaking.x", "shaking.y"], t)
    assert np.abs(shaking - expected).max() < 1e-11 * np.abs(expected).max()
    document = lw.load(EXAMPLE)
    data = document.model_dump(exclude_defaults=True, by_alias=True)
    del data["loads"]["gas"]["against"]
    outside = lw.compile(lw.Document.model_validate(data), EXAMPLE.parent)
    (felt,) = outside.evaluate(["shaking.x"], t)
    assert np.abs(felt - expected[0] + pressure(theta) * AREA).max() < 1e-11 * np.abs(felt).max()
    others = [n.text for n in compiled.quantities.signals.all() if not n.text.startswith("shaking")]
    assert np.array_equal(compiled.evaluate(others, t), outside.evaluate(others, t), equal_nan=True)
