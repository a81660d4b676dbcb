"""A thousand random four-bars in both assembly modes, half of them in each dialect, against two circles that meet."""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.typing import NDArray

from helpers.compiled import compiled_from
from linkwright.exports.process_simulate import evaluator
from linkwright.exports.process_simulate.angles import linkage
from linkwright.exports.process_simulate.dialects import DIALECTS
from linkwright.exports.process_simulate.joints import joints_of, named
from linkwright.exports.process_simulate.printer import text
from linkwright.graph.geometry import Geometry
from linkwright.kernels import Compiled

Array = NDArray[np.float64]
COUNT = 500
LEAST_SINE = 0.05
"""Four-bars are moved over ranges in which coupler and rocker stay so far from being in line."""


def four_bar() -> Compiled:
    return compiled_from(
        {
            "linkwright": 1,
            "units": {"length": "mm", "angle": "deg"},
            "parameters": {"a": 40, "b": 120, "c": 80, "d": 100},
            "links": {
                "frame": {"points": {"O": [0, 0], "D": ["d", 0]}},
                "crank": {"points": {"O": [0, 0], "B": ["a", 0]}},
                "coupler": {"points": {"B": [0, 0], "C": ["b", 0]}},
                "rocker": {"points": {"D": [0, 0], "C": ["c", 0]}},
            },
            "assembly": {"C": "left of B-D"},
            "drives": {"motor": {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": 40}},
        }
    )


def closed(a: float, b: float, c: float, d: float, side: float, theta: Array) -> tuple[Array, Array, Array]:
    """Directions of coupler and rocker (rad, continuous) at crank angles, and the sine of the angle between them."""
    crank = a * np.exp(1j * theta)
    base = d - crank
    with np.errstate(invalid="ignore"):
        along = (np.abs(base) ** 2 + b * b - c * c) / (2 * np.abs(base))
        pin = crank + base / np.abs(base) * (along + 1j * side * np.sqrt(b * b - along**2))
        coupler, rocker = pin - crank, pin - d
        sine = np.abs((coupler.conj() * rocker).imag) / (b * c)
    return np.unwrap(np.angle(coupler)), np.unwrap(np.angle(rocker)), sine


def moved(rng: np.random.Generator) -> tuple[tuple[float, ...], float, Array]:
    """Lengths (mm), a mode, and crank angles around a zero pose, which comes first."""
    while True:
        lengths, side = tuple(rng.uniform(30, 150, 4)), float(rng.choice([-1, 1]))
        start = rng.uniform(-math.pi, math.pi)
        ways = []
        for way in (-1.0, 1.0):
            theta = start + way * np.linspace(0, math.pi, 121)
            sine = closed(*lengths, side, theta)[2]
            good = np.flatnonzero(~(sine > LEAST_SINE))
            ways.append(theta[: good[0]] if good.size else theta)
        if min(map(len, ways)) > 5:
            return lengths, side, np.concatenate([ways[0][:0:-1], ways[1]])


@pytest.mark.parametrize("dialect", ["seed", "wizard"])
def test_random_four_bars_agree_with_two_circles(dialect: str) -> None:
    compiled, rng = four_bar(), np.random.default_rng(len(dialect))
    structure, quantities = compiled.structure, compiled.quantities
    joints = named(joints_of(structure), {}, (), ())
    names, kinds = {j.joint: j.name for j in joints}, {j.name: j.kind for j in joints}
    (group,) = structure.groups
    worst = 0.0
    for _ in range(COUNT):
        lengths, side, theta = moved(rng)
        geometry = Geometry(quantities, {name: 1e-3 * length for name, length in zip("abcd", lengths, strict=True)})
        poses = theta - theta[np.argmin(np.abs(theta - theta.mean()))]
        zero = theta[poses == 0.0][0]
        # The group's own branch counts from its first outer pin.
        branch = side if group.outer[0].joint == "B" else -side
        links = linkage(structure, geometry, {group: branch}, joints, DIALECTS[dialect], "motor", zero, poses)
        texts = {name: text(tree, DIALECTS[dialect], names, 12) for name, tree in links.functions.items()}
        fine = np.sort(np.append(np.interp(np.linspace(0, len(poses) - 1, 301), range(len(poses)), poses), 0.0))
        values = dict(zip(texts, evaluator.evaluate([*texts.items()], dialect, kinds, "O", fine), strict=True))
        coupler, rocker, _ = closed(*lengths, side, fine + zero)
        at = int(np.flatnonzero(fine == 0.0)[0])
        expected = {"B": coupler - fine, "C": rocker - coupler, "D": rocker}
        worst = max(worst, *(float(np.abs(values[j] - (e - e[at])).max()) for j, e in expected.items()))
    assert worst < 1e-8
