"""The joint functions of a bonnet's four-bar hinge in Tecnomatix: the published equations against the solver.

Source: "Kinematic Setup of Four-Bar Mechanism Based on Tecnomatix", Modeling and Simulation 7(2), 2018, 33-38,
doi 10.12677/MOS.2018.72005. Equations (1) to (13) and (16) are transcribed as printed; the paper prints no
coordinates, so those here are made up. Fixed pins at the origin (link 4, driving, length l3) and at (x1, 0) (link 2,
l1); moving pins (x3, z3) and (x2, z2). In the tool j2 is the pin at the origin, j3 that at (x3, z3), j4 that at
(x2, z2). The tolerance is round-off: both sides are closed forms.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest
from numpy.typing import NDArray

from helpers.compiled import compiled_from
from linkwright.exports.process_simulate import evaluator
from linkwright.exports.process_simulate.functions import Wish, make
from linkwright.exports.process_simulate.motion import ToolMotion

Array = NDArray[np.float64]
Place = tuple[float, float]
OPEN = 60.0, (95.0, 70.0), (-20.0, 110.0)
"""x1, (x2, z2), (x3, z3): the diagonal from (x3, z3) to (x1, 0) lies between l2 and l3."""
CROSSED = 60.0, (-25.0, 45.0), (-20.0, 110.0)
"""It doesn't: (x2, z2) lies on the same side of it as the origin."""
FRONT = 60.0, (110.0, 50.0), (35.0, 80.0)
"""An open one whose driving link leans towards the other fixed pin, x3 > 0."""
TURN = np.radians(np.linspace(0.0, 35.0, 71))


class Printed:
    """The paper's equations, by their numbers."""

    def __init__(self, x1: float, p2: Place, p3: Place, alpha0: Callable[[float, float], float] | None = None) -> None:
        (x2, z2), (x3, z3) = p2, p3
        self.x1 = x1
        self.l0 = x1  # (1)
        self.l1 = math.sqrt((x1 - x2) ** 2 + z2**2)  # (2)
        self.l2 = math.sqrt((x2 - x3) ** 2 + (z2 - z3) ** 2)  # (3)
        self.l3 = math.sqrt(x3**2 + z3**2)  # (4)
        self.alpha0 = (alpha0 or (lambda x, z: -math.atan(z / x)))(x3, z3)  # (5)
        l1, l2, l3 = self.l1, self.l2, self.l3
        self.beta0 = math.acos((l2**2 + l3**2 - (x2**2 + z2**2)) / (2 * l2 * l3))  # (6)
        self.gamma0 = math.pi - math.acos((l1**2 + l2**2 - ((x3 - x1) ** 2 + z3**2)) / (2 * l1 * l2))  # (7)

    def gamma(self, turn: Array) -> Array:
        """(10), and (15)."""
        above = self.l0**2 + self.l3**2 - self.l1**2 - self.l2**2
        above = above + 2 * self.l0 * self.l3 * np.cos(turn + self.alpha0)
        return np.asarray(np.arccos(above / (2 * self.l1 * self.l2)) - self.gamma0)

    def diagonal(self, turn: Array) -> Array:
        """(12)."""
        alpha = turn + self.alpha0  # (8)
        return np.asarray(np.sqrt((self.l3 * np.sin(alpha)) ** 2 + (self.x1 + self.l3 * np.cos(alpha)) ** 2))

    def betas(self, l4: Array) -> tuple[Array, Array]:
        """The two arccosines of (13)."""
        first = np.arccos((self.l2**2 + l4**2 - self.l1**2) / (2 * self.l2 * l4))
        return np.asarray(first), np.arccos((self.l3**2 + l4**2 - self.l0**2) / (2 * self.l3 * l4))

    def beta(self, turn: Array) -> Array:
        """(13)."""
        first, second = self.betas(self.diagonal(turn))
        return first + second - self.beta0

    def beta16(self, turn: Array, sign: float = 1.0) -> Array:
        """(16): (13) with pi - T(j2) - alpha0 in place of alpha; with ``sign`` -1, the mended x1 - l3 cos(...)."""
        rest = math.pi - turn - self.alpha0
        l4 = np.sqrt((self.l3 * np.sin(rest)) ** 2 + (self.x1 + sign * self.l3 * np.cos(rest)) ** 2)
        first, second = self.betas(l4)
        return first + second - self.beta0


def motion(x1: float, p2: Place, p3: Place, **wish: object) -> tuple[ToolMotion, dict[str, Array]]:
    """The hinge by linkwright: joints' turns since the drawn pose, by the solver and by the emitted text."""
    # alpha rises as the driving link turns clockwise, from -x towards +z.
    compiled = compiled_from(
        {
            "linkwright": 1,
            "units": {"length": "mm", "angle": "rad"},
            "sketch": {"P0": [0, 0], "P1": [x1, 0], "P2": list(p2), "P3": list(p3)},
            "links": {
                "frame": {"points": ["P0", "P1"]},
                "front": {"points": ["P1", "P2"]},
                "panel": {"points": ["P3", "P2"]},
                "rear": {"points": ["P0", "P3"]},
            },
            "drives": {"hinge": {"turns": "rear", "on": "frame", "speed": "-1 rpm", "start": "sketch"}},
        }
    )
    names = {"P0": "j2", "P3": "j3", "P2": "j4"}
    stops = (0.0, float(TURN[-1]))
    found = make(compiled, Wish("hinge", stops=stops, names=names, flipped=("P0",), left_out=("P1",), **wish))  # type: ignore[arg-type]
    kinds = {f.name: f.kind for f in (found.driving, *found.functions)}
    listed = [(f.name, f.text) for f in found.functions]
    rows = evaluator.evaluate(listed, found.dialect, kinds, "j2", TURN)
    solver = dict(zip([j.name for j in found.motion.told], found.motion.values(found.motion.told, TURN), strict=True))
    for (name, _), row in zip(listed, rows, strict=True):
        assert np.abs(row - solver[name]).max() < 1e-8
    return found.motion, solver


@pytest.mark.parametrize("hinge", [OPEN, CROSSED, FRONT], ids=["open", "crossed", "front"])
def test_equation_10_holds_in_every_arrangement(hinge: tuple[float, Place, Place]) -> None:
    """(5) read as atan2(z3, -x3): with the arctangent as printed, x3 > 0 is half a turn off."""
    printed = Printed(*hinge, alpha0=lambda x, z: math.atan2(z, -x))
    _, solver = motion(*hinge)
    sign = np.sign(solver["j4"][-1] * printed.gamma(TURN)[-1])
    assert np.abs(sign * printed.gamma(TURN) - solver["j4"]).max() < 1e-12


def test_equation_5_as_printed_holds_for_a_link_that_leans_back_only() -> None:
    for hinge, off in ((OPEN, False), (FRONT, True)):
        _, solver = motion(*hinge)
        asked = Printed(*hinge).alpha0 - math.atan2(hinge[2][1], -hinge[2][0])
        assert abs(asked) == pytest.approx(math.pi if off else 0.0, abs=1e-15)
        with np.errstate(invalid="ignore"):
            error = np.abs(np.abs(Printed(*hinge).gamma(TURN)) - np.abs(solver["j4"])).max()
        assert (not error < 0.1) == off


@pytest.mark.parametrize("hinge", [OPEN, FRONT], ids=["open", "front"])
def test_equation_13_holds_where_the_diagonal_lies_between(hinge: tuple[float, Place, Place]) -> None:
    printed = Printed(*hinge, alpha0=lambda x, z: math.atan2(z, -x))
    _, solver = motion(*hinge)
    assert np.abs(np.abs(printed.beta(TURN)) - np.abs(solver["j3"])).max() < 1e-12


def test_equation_13_takes_the_difference_where_it_does_not() -> None:
    printed = Printed(*CROSSED, alpha0=lambda x, z: math.atan2(z, -x))
    _, solver = motion(*CROSSED)
    assert np.abs(printed.beta(TURN)[0]) > 0.1  # not even zero at the zero pose
    first, second = printed.betas(printed.diagonal(TURN))
    assert np.abs(np.abs(np.abs(first - second) - printed.beta0) - np.abs(solver["j3"])).max() < 1e-12


def test_the_slip_in_equation_16() -> None:
    """(16) has x1 + l3 cos(pi - T - alpha0), which is x1 - l3 cos(alpha), where (12) has x1 + l3 cos(alpha)."""
    printed = Printed(*OPEN)
    _, solver = motion(*OPEN)
    assert printed.beta16(TURN)[0] == pytest.approx(
        0.13908477, abs=1e-8
    )  # no function of a joint: not zero at the zero pose
    assert np.abs(printed.beta16(TURN, -1.0) - printed.beta(TURN)).max() < 1e-14
    assert np.abs(np.abs(printed.beta16(TURN, -1.0)) - np.abs(solver["j3"])).max() < 1e-12


def test_the_slip_hides_behind_the_arctangent_of_5() -> None:
    """Where x3 > 0, (5) as printed is half a turn off, which turns the sign in (16) back; (15) is wrong there."""
    printed = Printed(*FRONT)
    _, solver = motion(*FRONT)
    assert np.abs(np.abs(printed.beta16(TURN)) - np.abs(solver["j3"])).max() < 1e-12
    assert np.abs(np.abs(printed.gamma(TURN)) - np.abs(solver["j4"])).max() > 0.1
