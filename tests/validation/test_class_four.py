"""A group of class IV with six links (examples/class_four.yaml) against its loop equations in complex numbers.

Artobolevskii, *Theory of Mechanisms and Machines*: class IV, as four of its links close a changeable contour of four
sides. The loops are written here from the drawing, solved by scipy's fsolve and polished by Newton's method with
complex slopes; places are held to 1e-10 of the size, velocities and accelerations to 1e-9 of the largest, since both
sides have their round-off; forces to 1e-9 by the Newton-Euler equations of the test helpers.
"""

from __future__ import annotations

import cmath
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.optimize import fsolve

import linkwright as lw
from helpers.expected import expected_forces, oracle_states, worst
from helpers.plain import plain_of
from linkwright.graph.rows import BodyPlace
from linkwright.model.document import plain

EXAMPLE = Path(__file__).parents[2] / "examples" / "class_four.yaml"
SIZE, OMEGA = 0.4, 2 * math.pi

# Dimensions in m, as complex numbers in the axes of their links.
F2, F4, CRANK = -0.154 + 0.065j, 0.242 + 0.028j, 0.030
B, C = 0.135, 0.052 - 0.119j  # of base, from A
D, P = 0.097, 0.051 + 0.107j  # of left, from B
E, Q = 0.142, 0.087 - 0.098j  # of right, from C
TOP, LEG2, LEG4 = 0.152, 0.130, 0.151
LINKS = ("base", "left", "right", "top", "leg2", "leg4")
# d(loop)/d(angle) over i e^(i angle): how each loop holds each link.
HOLD = np.array([[B - C, D, -E, TOP, 0, 0], [B, P, 0, 0, -LEG2, 0], [C, 0, Q, 0, 0, -LEG4]])


def loops(angles: Any, crank: float) -> np.ndarray:
    """Ring B-D-E-C, and the loops over both legs."""
    return np.asarray(HOLD @ np.exp(1j * np.asarray(angles)) + np.array([0, -F2, -F4]) + CRANK * _crank(crank))


def _crank(crank: float) -> np.ndarray:
    return np.array([0, 1, 1]) * cmath.exp(1j * crank)


def split(values: np.ndarray) -> np.ndarray:
    return np.concatenate([values.real, values.imag])


def solved(crank: float, start: np.ndarray) -> np.ndarray:
    angles = np.asarray(fsolve(lambda a: split(loops(a, crank)), start, xtol=1e-12))
    for _ in range(2):
        slopes = HOLD * (1j * np.exp(1j * angles))
        angles = angles - np.linalg.solve(np.vstack([slopes.real, slopes.imag]), split(loops(angles, crank)))
    return angles


def rates(angles: np.ndarray, crank: float) -> tuple[np.ndarray, np.ndarray]:
    """First and second derivatives of the angles in time, at a constant speed of the crank."""
    slopes = HOLD * (1j * np.exp(1j * angles))
    matrix = np.vstack([slopes.real, slopes.imag])
    first = np.linalg.solve(matrix, -split(1j * OMEGA * CRANK * _crank(crank)))
    bent = slopes @ (1j * first**2) - OMEGA**2 * CRANK * _crank(crank)
    return first, np.linalg.solve(matrix, -split(bent))


@pytest.fixture(scope="module")
def compiled() -> lw.Compiled:
    return lw.compile(lw.load(EXAMPLE))


def test_positions_and_rates_over_the_turn(compiled: lw.Compiled) -> None:
    t = np.linspace(0.0, 1.0, 25)
    names = [f"{link}.{order}" for order in ("angle", "omega", "alpha") for link in LINKS]
    ours = compiled.evaluate(names, t).reshape(3, 6, -1)
    points = {p: compiled.evaluate([f"{p}.x", f"{p}.y"], t).T @ [1, 1j] for p in "ABCDEPQ"}
    angles = ours[0, :, 0]
    for k, crank in enumerate(OMEGA * t):
        angles = solved(crank, angles)
        base, left, right = np.exp(1j * angles[:3])
        a = CRANK * cmath.exp(1j * crank)
        b, c = a + B * base, a + C * base
        places = {"A": a, "B": b, "C": c, "D": b + D * left, "P": b + P * left, "E": c + E * right, "Q": c + Q * right}
        assert max(abs(points[name][k] - at) for name, at in places.items()) < 1e-10 * SIZE
        assert np.abs(np.exp(1j * ours[0, :, k]) - np.exp(1j * angles)).max() < 1e-10
        first, second = rates(angles, crank)
        assert np.abs(ours[1, :, k] - first).max() < 1e-9 * np.abs(ours[1]).max()
        assert np.abs(ours[2, :, k] - second).max() < 1e-9 * np.abs(ours[2]).max()


def test_forces_over_the_turn(compiled: lw.Compiled) -> None:
    t = np.linspace(0.0, 1.0, 9)
    moving = compiled.structure.topology.moving
    x = compiled.evaluate([row for link in moving for row in BodyPlace.all(link)], np.zeros(1))
    start = {link: (x, y, math.atan2(s, c)) for link, (x, y, c, s) in zip(moving, x.reshape(-1, 4), strict=True)}
    oracle, states = oracle_states(plain_of(plain(lw.load(EXAMPLE)), start), t)
    expectation = expected_forces(oracle, states)
    error, signal = worst(compiled.evaluate(list(expectation), t), expectation, 1.0)
    assert error < 1e-9, signal


def test_all_that_many_starts_find_are_the_modes() -> None:
    """1000 starts of fsolve on the loops find the same poses, each on a circuit of its own."""
    outcome = lw.modes(EXAMPLE)
    assert not outcome.complete  # no proof for this group, and it says so
    random, found = np.random.default_rng(2), []
    for start in random.uniform(-math.pi, math.pi, (1000, 6)):
        angles, _, good, _ = fsolve(lambda a: split(loops(a, 0.0)), start, full_output=True)
        if good == 1 and np.abs(loops(angles, 0.0)).max() < 1e-10:
            axes = np.exp(1j * angles)
            if all(np.abs(axes - other).max() > 1e-5 for other in found):
                found.append(axes)
    ours = [np.array([complex(*mode.bodies[link].axis.now) for link in LINKS]) for mode in outcome.modes]
    assert len(found) == len(ours) == 2
    assert all(min(np.abs(axes - other).max() for other in found) < 1e-8 for axes in ours)
    assert outcome.survey.places == [(0, 0), (1, 0)]
    assert all(circuit.turns for circuit in outcome.circuits)
