"""Mechanisms with two drives, whose regions are known in closed form."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from helpers.compiled import compiled_from
from helpers.examples import UNITS
from linkwright.kernels import Compiled
from linkwright.studies.workspace.sheet import ModeSheet

Array = NDArray[np.float64]
Points = NDArray[np.complex128]


def five_bar(l1: float, l2: float, l3: float, l4: float, l5: float) -> Compiled:
    """Cranks O1-B and O4-D, couplers B-C and D-C, ground O1-O4 (m)."""
    return compiled_from(
        {
            "linkwright": 1,
            "units": UNITS,
            "links": {
                "frame": {"points": {"O1": [0, 0], "O4": [l5, 0]}},
                "crank1": {"points": {"O1": [0, 0], "B": [l1, 0]}},
                "link2": {"points": {"B": [0, 0], "C": [l2, 0]}},
                "link3": {"points": {"D": [0, 0], "C": [l3, 0]}},
                "crank4": {"points": {"O4": [0, 0], "D": [l4, 0]}},
            },
            "assembly": {"C": "left of B-D"},
            "drives": {
                "motor": {"turns": "crank1", "on": "frame", "speed": 1, "start": 2.0},
                "servo": {"turns": "crank4", "on": "frame", "speed": 1, "start": 1.0},
            },
        }
    )


def arm(l1: float, l2: float) -> Compiled:
    """A shoulder O, an elbow A, the hand P: an open chain."""
    data: dict[str, Any] = {
        "linkwright": 1,
        "units": UNITS,
        "links": {
            "frame": {"points": {"O": [0, 0]}},
            "upper": {"points": {"O": [0, 0], "A": [l1, 0]}},
            "fore": {"points": {"A": [0, 0], "P": [l2, 0]}},
        },
        "drives": {
            "shoulder": {"turns": "upper", "on": "frame", "speed": 1, "start": 0},
            "elbow": {"turns": "fore", "on": "upper", "speed": 1, "start": 1.0},
        },
    }
    return compiled_from(data)


def triad_turned_round() -> dict[str, Any]:
    """A five-bar whose couplers carry a dyad with P on it: forward there are dyads alone, but with P held at a place
    no two of the links hang on known pins."""
    return {
        "linkwright": 1,
        "units": UNITS,
        "links": {
            "frame": {"points": {"O1": [0, 0], "O4": [1.0, 0]}},
            "crank1": {"points": {"O1": [0, 0], "B": [0.5, 0]}},
            "crank4": {"points": {"O4": [0, 0], "D": [0.5, 0]}},
            "link2": {"points": {"B": [0, 0], "C": [1.2, 0], "M": [0.6, 0.5]}},
            "link3": {"points": {"D": [0, 0], "C": [1.2, 0], "K": [0.6, -0.5]}},
            "arm": {"points": {"M": [0, 0], "N": [1.5, 0]}},
            "hand": {"points": {"K": [0, 0], "N": [1.5, 0], "P": [1.0, 0.4]}},
        },
        "assembly": {"C": "left of B-D", "N": "left of M-K"},
        "drives": {
            "motor": {"turns": "crank1", "on": "frame", "speed": 1, "start": 2.0},
            "servo": {"turns": "crank4", "on": "frame", "speed": 1, "start": 1.0},
        },
    }


LEGS = ("RR", "PR", "RP")
"""The joints of the leg that guides a coupler, from the frame inwards: a rocker, a slider, a rocking block."""


@dataclass(frozen=True)
class ArmOnCoupler:
    """A crank O1-A, a coupler, guided by a leg of some joints, and on it at E a driven arm E-P (m): with P held at a
    place the coupler is the platform of a triad. Its motion is known by complex numbers."""

    leg: str
    crank: float = 0.3
    length: float = 0.7
    rocker: float = 0.5
    base: float = 0.8
    aside: float = 0.05
    tip: complex = 0.5 + 0.4j
    arm: float = 0.35

    def coupler(self, theta: Array, side: float) -> tuple[Points, Points]:
        """The coupler's place A and its direction at angles of the crank, in one of two modes (+1 or -1)."""
        a = self.crank * np.exp(1j * theta)
        gap = self.base - a
        with np.errstate(invalid="ignore"):
            if self.leg == "RR":
                along = (self.length**2 - self.rocker**2 + np.abs(gap) ** 2) / (2 * np.abs(gap))
                b = a + gap / np.abs(gap) * (along + 1j * side * np.sqrt(self.length**2 - along**2))
                return a, (b - a) / self.length
            if self.leg == "PR":
                across = self.aside - a.imag
                return a, (side * np.sqrt(self.length**2 - across**2) + 1j * across) / self.length
            return a, gap / (side * np.sqrt(np.abs(gap) ** 2 - self.aside**2) + 1j * self.aside)

    def placed(self, q: Array, side: float) -> Points:
        """P at values of the drives, (2, n)."""
        a, way = self.coupler(q[0], side)
        return np.asarray(a + way * (self.tip + self.arm * np.exp(1j * q[1])))

    def compiled(self) -> Compiled:
        """The mechanism, begun where it closes."""
        theta = np.linspace(0, 2 * np.pi, 100)
        start = float(theta[np.isfinite(self.coupler(theta, 1.0)[1])][0]) + 0.1
        coupler: dict[str, Any] = {"A": [0, 0], "B": [self.length, 0], "E": [self.tip.real, self.tip.imag]}
        links: dict[str, Any] = {
            "frame": {"points": {"O1": [0, 0], "O4": [self.base, 0], "H": [0, self.aside]}},
            "crank": {"points": {"O1": [0, 0], "A": [self.crank, 0]}},
            "coupler": {"points": coupler},
            "arm": {"points": {"E": [0, 0], "P": [self.arm, 0]}},
        }
        data: dict[str, Any] = {"linkwright": 1, "units": UNITS, "links": links}
        if self.leg == "RR":
            links["rocker"] = {"points": {"O4": [0, 0], "B": [self.rocker, 0]}}
            data["assembly"] = {"B": "left of A-O4"}
        elif self.leg == "PR":
            links["block"] = {"points": {"B": [0, 0]}}
            data["joints"] = {"rail": {"prismatic": ["frame", "block"], "line": ["H at 0 deg", "B at 0 deg"]}}
            data["assembly"] = {"B": "ahead of A along rail"}
        else:
            del coupler["B"]
            coupler["G"] = [0, self.aside]
            links["block"] = {"points": {"O4": [0, 0]}}
            data["joints"] = {"rail": {"prismatic": ["coupler", "block"], "line": ["G at 0 deg", "O4 at 0 deg"]}}
            data["assembly"] = {"O4": "ahead of A along rail"}
        data["drives"] = {
            "motor": {"turns": "crank", "on": "frame", "speed": 1, "start": start},
            "servo": {"turns": "arm", "on": "coupler", "speed": 1, "start": 1.0},
        }
        return compiled_from(data)

    def sheet(self, side: float) -> ModeSheet:
        """The sheet of the mode in which the coupler is on one side."""
        model = self.compiled()
        q = np.stack([np.linspace(0, 6.2, 60), np.full(60, 0.3)])
        true = self.placed(q, side)
        for sign in (1.0, -1.0):
            sheet = ModeSheet(model, "P", ("motor", "servo"), (sign,))
            at = sheet.place(q)[0]
            if np.nanmax(np.abs(at[0] + 1j * at[1] - true)) < 1e-9:
                return sheet
        raise AssertionError(self)


def random_arm(seed: int) -> ArmOnCoupler:
    """Of any lengths that close somewhere."""
    random = np.random.default_rng(seed)
    while True:
        crank, length, rocker, base, arm = random.uniform(
            [0.15, 0.4, 0.3, 0.4, 0.2], [0.6, 1.0, 0.9, 1.1, 0.6]
        ).tolist()
        tip = complex(*random.uniform([-0.3, -0.5], [0.8, 0.5]))
        found = ArmOnCoupler(LEGS[seed % 3], crank, length, rocker, base, 0.05, tip, arm)
        if np.isfinite(found.coupler(np.linspace(0, 6.2, 60), 1.0)[1]).sum() > 10:
            return found
