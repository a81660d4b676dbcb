"""The paper feeder over its whole cycle against constraint equations and Newton-Euler equations of all its links.

The data are those of the paper feeder's paper (see test_paper_feeder.py); the oracle is written in the tests and
shares nothing with linkwright. Tolerance: 1e-11 of the stroke and of the largest force, the oracle's round-off.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from helpers.compiled import compiled_from
from helpers.examples import feeder
from helpers.expected import expected_angles, expected_forces, expected_motion, oracle_states, worst
from helpers.newton_euler import Oracle
from helpers.plain import Plain, plain_of
from linkwright.kernels import Compiled
from linkwright.results.run import Run

T = np.linspace(0.0, 1.5, 61)


def guess() -> dict[str, tuple[float, float, float]]:
    """Where the links are at the start, by eye (m, rad); the oracle settles it."""
    return {
        "crank": (0.0, 0.0, 0.4),
        "coupler": (0.142, 0.062, 0.55),
        "rocker": (0.3, 0.0, 0.8),
        "slider": (0.64, 0.37, 0.0),
        "guide": (0.64, 0.58, 0.0),
    }


@pytest.fixture(scope="module")
def plain() -> Plain:
    return plain_of(feeder(), guess())


@pytest.fixture(scope="module")
def compiled() -> Compiled:
    return compiled_from(feeder())


def test_the_oracle_starts_at_the_paper_s_pose(plain: Plain) -> None:
    oracle = Oracle(plain)
    assert oracle.first.q[2] == pytest.approx(math.atan2(61.78, 142.16), abs=1e-13)
    assert oracle.point(oracle.first.q, "rocker", "E")[0] == pytest.approx(0.64028, abs=1e-5)


def test_motion(plain: Plain, compiled: Compiled) -> None:
    oracle, states = oracle_states(plain, T)
    for order, rows in expected_motion(oracle, states).items():
        error, name = worst(compiled.evaluate(list(rows), T), rows, 0.0)
        assert error < 1e-11, (order, name)
    angles = expected_angles(oracle, states)
    found = Run(compiled, 0.0, 1.5, 60).evaluate(list(angles), T)
    assert np.abs(found - np.array(list(angles.values()))).max() < 1e-11


def test_forces(plain: Plain, compiled: Compiled) -> None:
    oracle, states = oracle_states(plain, T)
    rows = expected_forces(oracle, states)
    error, name = worst(compiled.evaluate(list(rows), T), rows, 0.0)
    assert error < 1e-11, name
    assert max(np.abs(row).max() for row in rows.values()) > 500.0
