"""Mechanisms that pass change points with ``through: keep``, at random against closed forms that know of none: run and
limits over several turns.

The closed forms are those of plane geometry: the figures are parallelograms, kites and isosceles triangles, whose lines
of symmetry turn at half the speed.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from linkwright.app.job import Job
from studies.models import UNITS, at, codes, job_of

Array = NDArray[np.float64]
Closed = Callable[[Array], Array]
"""The output (deg or mm) by the crank's angle (rad)."""

TURN = 2 * math.pi


class Family:
    """A mechanism with an output, its closed form, and how often the crank turns until the pose repeats."""

    def __init__(self, output: str, model: dict[str, Any], closed: Closed) -> None:
        self.output, self.model, self.closed = output, model, closed


def four_bar(a: float, b: float, c: float, d: float, at_c: tuple[float, float], closed: Closed) -> Family:
    """AB = a, BC = b, CD = c on the ground AD = d; C is sketched at the start."""
    model = {
        "links": {
            "frame": {"points": {"A": [0, 0], "D": [d, 0]}},
            "crank": {"points": {"A": [0, 0], "B": [a, 0]}},
            "coupler": {"points": {"B": [0, 0], "C": [b, 0]}},
            "rocker": {"points": {"D": [0, 0], "C": [c, 0]}},
        },
        "assembly": {"C": [*at_c]},
    }
    return Family("rocker.angle", model, closed)


def parallelogram(rng: np.random.Generator, start: float) -> Family:
    """The rocker does what the crank does."""
    a, b = rng.uniform(20, 100, 2)
    c = (b + a * math.cos(start), a * math.sin(start))
    return four_bar(a, b, a, b, c, np.degrees)


def antiparallelogram(rng: np.random.Generator, start: float) -> Family:
    """tan(rocker/2) = -(d + a)/(d - a) tan(crank/2): against the crank where this is the shorter link, with it where
    the ground is."""
    a, d = rng.uniform(20, 100, 2)
    k = (d + a) / (d - a)

    def closed(angle: Array) -> Array:
        return np.degrees(-2 * np.unwrap(np.arctan2(k * np.sin(angle / 2), np.cos(angle / 2))))

    rocker = math.radians(float(closed(np.array([start]))[0]))
    return four_bar(a, d, a, d, (d + a * math.cos(rocker), a * math.sin(rocker)), closed)


def rhombus(rng: np.random.Generator, start: float) -> Family:
    """A parallelogram too, whose crank pin also passes the rocker's pivot."""
    a = rng.uniform(20, 100)
    return four_bar(a, a, a, a, (a + a * math.cos(start), a * math.sin(start)), np.degrees)


def galloway(rng: np.random.Generator, start: float) -> Family:
    """A kite about AC, whose direction is half the crank's angle: two turns of the crank are one of the rocker."""
    a = rng.uniform(20, 60)
    b = a * rng.uniform(1.1, 3)

    def pin(angle: Array) -> tuple[Array, Array]:
        along = a * np.cos(angle / 2) + np.sqrt(b**2 - (a * np.sin(angle / 2)) ** 2)
        return along * np.cos(angle / 2), along * np.sin(angle / 2)

    def closed(angle: Array) -> Array:
        x, y = pin(angle)
        return np.degrees(np.unwrap(np.arctan2(y, x - a)))

    x, y = pin(np.array([start]))
    return four_bar(a, b, b, a, (float(x[0]), float(y[0])), closed)


def kite_about_its_diagonal(rng: np.random.Generator, start: float) -> Family:
    """AB = BC and CD = DA: C is the mirror image of A by the line BD, which swings, or turns where AB is the longer
    side."""
    a, d = rng.uniform(20, 100, 2)

    def diagonal(angle: Array) -> Array:
        return np.unwrap(np.arctan2(-a * np.sin(angle), d - a * np.cos(angle)))

    def closed(angle: Array) -> Array:
        return np.degrees(2 * diagonal(angle) - np.pi)

    rocker = math.radians(float(closed(np.array([start]))[0]))
    return four_bar(a, a, d, d, (d + d * math.cos(rocker), d * math.sin(rocker)), closed)


def isosceles_slider_crank(rng: np.random.Generator, start: float) -> Family:
    """Rod as long as the crank, in line: x = 2 r cos(crank)."""
    r = rng.uniform(20, 100)
    model = {
        "links": {
            "frame": {"points": {"A": [0, 0]}},
            "crank": {"points": {"A": [0, 0], "B": [r, 0]}},
            "rod": {"points": {"B": [0, 0], "C": [r, 0]}},
            "slider": {"points": {"C": [0, 0]}},
        },
        "joints": {"guide": {"prismatic": ["frame", "slider"], "line": ["A at 0 deg", "C at 0 deg"]}},
        "assembly": {"C": [2 * r * math.cos(start), 0]},
    }
    return Family("guide.s", model, lambda angle: 2 * r * np.cos(angle))


def crank_through_the_pivot(rng: np.random.Generator, start: float) -> Family:
    """A lever about D whose block is on a crank as long as the ground: an isosceles triangle, the lever turns at half
    the crank's speed, and its block passes through D."""
    r = rng.uniform(20, 100)
    model = {
        "links": {
            "frame": {"points": {"A": [0, 0], "D": [r, 0]}},
            "crank": {"points": {"A": [0, 0], "B": [r, 0]}},
            "block": {"points": {"B": [0, 0]}},
            "lever": {"points": {"D": [0, 0], "P": [3 * r, 0]}},
        },
        "joints": {"slot": {"prismatic": ["lever", "block"], "line": ["D at 0 deg", "B at 0 deg"]}},
        "assembly": {"P": [r - 3 * r * math.sin(start / 2), 3 * r * math.cos(start / 2)]},
    }
    return Family("lever.angle", model, lambda angle: np.degrees(angle / 2 + np.pi / 2))


FAMILIES = (
    parallelogram,
    antiparallelogram,
    rhombus,
    galloway,
    kite_about_its_diagonal,
    isosceles_slider_crank,
    crank_through_the_pivot,
)


def run_and_limits(family: Family, start: float, sign: float, turns: int) -> Job:
    drive = {"turns": "crank", "on": "frame", "speed": f"{sign * 60} rpm", "start": f"{math.degrees(start)!r} deg"}
    model = {
        "units": UNITS,
        **family.model,
        "drives": {"motor": drive},
        "measures": {"travel": {"span": family.output}, "rate": {"extremes": rate_of(family.output)}},
        "studies": {"cycle": {"turns": f"{turns} motor", "samples": 90, "through": "keep"}, "limits": {}},
    }
    return job_of(model)


def rate_of(output: str) -> str:
    return output.replace(".angle", ".omega").replace("guide.s", "C.vx")


def held_to_its_closed_form(make: Callable[[np.random.Generator, float], Family], seed: int) -> None:
    rng = np.random.default_rng([seed, FAMILIES.index(make)])
    # Not nearer than a few degrees to a change point at the start, where the sketch couldn't say which mode is meant.
    start = float(rng.choice([-1.0, 1.0]) * rng.uniform(0.15, 1.4) + rng.choice([0.0, math.pi]))
    sign, turns = float(rng.choice([-1.0, 1.0])), int(rng.integers(1, 4))
    family = make(rng, start)
    job = run_and_limits(family, start, sign, turns)
    assert job.cycle is not None
    assert codes(job.cycle.failures) == []
    assert job.cycle.result.certificate is not None
    assert job.cycle.result.certificate.sound()
    run = job.cycle.result.run
    unit = 1e-3 if family.output.endswith(".s") else math.radians(1.0)

    # The output all over the run, the very instants of the change points among the times.
    passages = np.array([p.time for p in run.compiled.passages.every])
    assert passages.size
    t = np.union1d(np.linspace(0.0, turns, 2401), passages)
    closed = family.closed(start + sign * TURN * t) * unit
    output = at(run, family.output, t)
    offset = TURN * round((output[0] - closed[0]) / TURN) if unit != 1e-3 else 0.0
    np.testing.assert_allclose(output - offset, closed, atol=1e-9 * np.abs(closed).max(), rtol=0)

    # Extremes and turns, of limits and of measures, from the closed form on a fine grid.
    fine = family.closed(start + sign * TURN * np.linspace(0.0, turns, 100_001)) * unit
    stroke = float(np.ptp(fine))
    assert job.limits is not None
    assert not job.limits.warnings
    motion = job.limits.motion
    assert motion is not None
    (course,) = (one for one in motion.courses if one.signal == family.output)
    assert course.stroke == pytest.approx(stroke, rel=1e-7)
    (travel,) = (one for one in job.cycle.measures if one.name == "travel")
    assert travel.found[0].value == pytest.approx(course.stroke, rel=1e-9)
    assert sorted({round(change.time, 9) for change in motion.touches}) == sorted({*np.round(passages, 9)})

    # The rate by differences of the closed form over four steps.
    step = 3e-6
    ahead = [family.closed(start + sign * TURN * (t + k * step)) * unit for k in (-2, -1, 1, 2)]
    slope = np.array([1, -8, 8, -1]) / 12 @ ahead
    rate = at(run, rate_of(family.output), t)
    np.testing.assert_allclose(rate, slope / step, atol=1e-7 * np.abs(rate).max(), rtol=0)


@pytest.mark.parametrize("make", FAMILIES, ids=lambda make: make.__name__)
@pytest.mark.parametrize("seed", range(2))
def test_motion_and_limits_through_change_points(make: Callable[..., Family], seed: int) -> None:
    held_to_its_closed_form(make, seed)


@pytest.mark.long
@pytest.mark.parametrize("make", FAMILIES, ids=lambda make: make.__name__)
def test_many_of_them(make: Callable[..., Family]) -> None:
    for seed in range(2, 42):
        held_to_its_closed_form(make, seed)


DOUBLE_ROOTS = {
    # Straight-line lifts: each carries the platform's pin along an upright line, so that its angle has a double root.
    "scott-russell": {
        "units": UNITS,
        "links": {
            "frame": {"points": {"P1": [0, 0], "P2": [800, 0], "R": [0, 0]}},
            "short1": {"points": {"P1": [0, 0], "M1": [300, 0]}},
            "long1": {"points": {"S1": [0, 0], "M1": [300, 0], "T1": [600, 0]}},
            "short2": {"points": {"P2": [0, 0], "M2": [300, 0]}},
            "long2": {"points": {"S2": [0, 0], "M2": [300, 0], "T2": [600, 0]}},
            "platform": {"points": {"T1": [0, 0], "T2": [800, 0]}},
        },
        "joints": {
            "g1": {"pin_in_slot": ["long1", "frame"], "pin": "S1", "straight": "R at 0 deg"},
            "g2": {"pin_in_slot": ["long2", "frame"], "pin": "S2", "straight": "R at 0 deg"},
        },
        "assembly": {
            "S1": [500, 0], "M1": [250, 166], "T1": [0, 332], "S2": [1300, 0], "M2": [1050, 166], "T2": [800, 332],
        },
        "drives": {
            "ram": {
                "moves": "long1", "at": "S1", "on": "frame", "along": "R at 0 deg",
                "position": "500 mm - 50 mm*t/(1 s)",
            }
        },
        "studies": {"cycle": {"duration": "2 s", "samples": 40}},
    },
    # Two scissors side by side under one platform.
    "tandem-scissor": {
        "units": UNITS,
        "links": {
            "frame": {"points": {"A0": [0, 0], "E0": [1200, 0], "R": [0, 0]}},
            "up1": {"points": {"A0": [0, 0], "B1": [1000, 0], "M": [500, 0]}},
            "dn1": {"points": {"B0": [0, 0], "A1": [1000, 0], "M": [500, 0]}},
            "up2": {"points": {"E0": [0, 0], "F1": [1000, 0], "N": [500, 0]}},
            "dn2": {"points": {"F0": [0, 0], "E1": [1000, 0], "N": [500, 0]}},
            "platform": {"points": {"A1": [0, 0], "E1": [1200, 0]}},
        },
        "joints": {
            "r1": {"pin_in_slot": ["dn1", "frame"], "pin": "B0", "straight": "R at 0 deg"},
            "r2": {"pin_in_slot": ["dn2", "frame"], "pin": "F0", "straight": "R at 0 deg"},
        },
        "assembly": {
            "B0": [900, 0], "A1": [0, 436], "B1": [900, 436], "F0": [2100, 0], "E1": [1200, 436], "F1": [2100, 436],
        },
        "drives": {
            "ram": {
                "moves": "dn1", "at": "B0", "on": "frame", "along": "R at 0 deg",
                "position": "900 mm - 20 mm*t/(1 s)",
            }
        },
        "studies": {"cycle": {"duration": "5 s", "samples": 50}},
    },
}  # fmt: skip


@pytest.mark.parametrize("name", DOUBLE_ROOTS)
def test_a_group_with_a_double_root_in_every_pose_is_refused(name: str) -> None:
    """It was followed with a smallest singular value of round-off, and ended as NaN in the certificate."""
    job = job_of(DOUBLE_ROOTS[name])
    assert job.exit_code == 1
    assert codes(job.cycle.failures) == ["motion.singular-throughout"]
