"""The four-bar of exact.py in pylinkage, by its compiled path: ``step_fast`` of a whole turn in one call."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from contest import Array, Way, timed
from exact import FOUR_BAR
from numpy.typing import NDArray

START, SPEED = 0.5, 2 * math.pi


def linkage(poses: int) -> Any:
    """The four-bar, its crank at the start, to turn once in ``poses`` steps."""
    from pylinkage import Crank, Ground, RRRDyad
    from pylinkage.simulation import Linkage

    ab, bc, cd, ad = FOUR_BAR.values()
    a, d = Ground(0.0, 0.0, name="A"), Ground(float(ad), 0.0, name="D")
    crank = Crank(anchor=a, radius=ab, angular_velocity=SPEED / poses, initial_angle=START, name="B")
    # The start of C is a hint: the nearer one of two places is taken from there.
    dyad = RRRDyad(anchor1=crank.output, anchor2=d, distance1=bc, distance2=cd, x=2.0, y=3.0, name="C")
    made = Linkage([a, d, crank, dyad], name="four-bar")
    made.set_input_velocity(crank, SPEED)
    made.compile()
    return made


def way(poses: int, pick: NDArray[np.intp], rates: bool) -> Way:
    """Positions of B and C, with ``rates`` their velocities and accelerations too; outputs at poses ``pick``."""
    made = linkage(poses)
    begin = made.get_coords()

    def run() -> tuple[float, Array]:
        made.set_coords(begin)
        kept: list[Any] = []
        action = made.step_fast_with_kinematics if rates else made.step_fast
        seconds = timed(lambda: kept.append(action(iterations=poses)))
        parts = kept[0] if rates else [kept[0]]
        return seconds, np.concatenate([part[pick, 2 + k].T for k in (0, 1) for part in parts])

    return Way("pylinkage", f"compiled, 1 thread{', with rates' * rates}", poses, run)
