"""Friction where the force of a seat passes through zero: Newton's steps arrive at the fixed point of the laws.

The reference is the plain iteration m <- factor * sum |f0 + B m| + rest in NumPy. The laws of these systems are a
contraction, so that it converges to the one solution that there is (Banach), with no derivative involved.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from linkwright.elements.force import Resistance
from linkwright.graph.friction import FrictionSystem

STRETCH = 0.9
"""How much of a difference between efforts each law keeps, at most: the sum over all efforts stays below 1."""


def random_system(random: np.random.Generator, near: float) -> FrictionSystem:
    """Efforts of pins (one force of two parts) and guides (two seats of one part). Where they obey their laws, all
    forces of seats have the size ``near``: loads cancel what chosen efforts add, and rests make these the solution."""
    count = int(random.integers(2, 5))
    names = [f"f{i}" for i in range(count)]
    efforts = random.normal(size=count)
    laws, loads, slopes = [], [], []
    for i in range(count):
        parts, seats = (2, 1) if random.random() < 0.5 else (1, 2)
        units = random.normal(size=(count, seats, parts))
        stretch = sum(float(np.hypot.reduce(seat)) for unit in units for seat in unit)
        factor = STRETCH / stretch * random.choice([-1.0, 1.0])
        forces = near * random.normal(size=(seats, parts))
        pressing = sum(float(np.hypot.reduce(force)) for force in forces)
        laws.append(Resistance(float(factor), float(efforts[i] - factor * pressing)))
        loads.append([tuple(map(float, load)) for load in forces - np.tensordot(efforts, units, 1)])
        slopes.append([[tuple(map(float, seat)) for seat in unit] for unit in units])
    return FrictionSystem(names, laws, loads, slopes, {})


def fixed_point(system: FrictionSystem) -> np.ndarray:
    efforts = np.zeros(len(system.names))
    for _ in range(500):
        new = np.empty_like(efforts)
        for i, law in enumerate(system.laws):
            pressing = 0.0
            for k, load in enumerate(system.loads[i]):
                per_unit = np.array([unit[k] for unit in system.slopes[i]])
                pressing += float(np.hypot.reduce(np.array(load) + efforts @ per_unit))
            new[i] = law.factor * pressing + law.rest
        efforts = new
    return efforts


@pytest.mark.parametrize("near", [1e-6, 1e-3, 0.03, 0.3])
def test_newton_arrives_at_the_fixed_point(near: float) -> None:
    random = np.random.default_rng(17)
    for _ in range(60):
        system = random_system(random, near)
        solved = [float(effort) for effort in system.solved()]
        assert not any(math.isnan(effort) for effort in solved)
        np.testing.assert_allclose(solved, fixed_point(system), rtol=1e-9, atol=1e-9)
