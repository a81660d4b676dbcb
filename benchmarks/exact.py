"""The paper feeder and a four-bar in 50 digits, by a formulation of their own: what all engines are held to.

Points are complex numbers. The pose comes from intersecting two circles, the rates from the derivatives of the loop
equation, the forces of the feeder from the Newton-Euler equations of its five links at once: 15 unknowns.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from mpmath import mp, mpc, mpf
from numpy.typing import NDArray

Array = NDArray[np.float64]
DIGITS = 50
FOUR_BAR = {"AB": 1, "BC": 3, "CD": 3, "AD": 4}
"""Lengths (m) of the four-bar; its crank turns at 2 pi rad/s from 0.5 rad, C is on the left of the line from B to D."""
PINS = {"A": ("frame", "crank"), "B": ("crank", "coupler"), "C": ("coupler", "rocker"), "D": ("frame", "rocker")}
PINS |= {"E": ("rocker", "slider")}
MASSES = {"crank": "0.6", "coupler": "1.5", "rocker": "2", "slider": "1", "guide": "3"}


@dataclass(frozen=True)
class Loop:
    """A four-bar's points B and C with velocity and acceleration; the rates of coupler and rocker."""

    b: list[Any]
    c: list[Any]
    omega: tuple[Any, Any]
    alpha: tuple[Any, Any]

    @classmethod
    def at(cls, angle: Any, speed: Any, ab: Any, bc: Any, cd: Any, ad: Any) -> Loop:
        b = ab * mp.expj(angle)
        reach = abs(ad - b)
        along = (bc**2 - cd**2 + reach**2) / (2 * reach)
        c = b + (ad - b) / reach * mpc(along, mp.sqrt(bc**2 - along**2))
        # The derivatives of b + u = d + w, u and w turning at the rates asked for.
        u, w, vb, ab_ = c - b, c - ad, 1j * speed * b, -(speed**2) * b
        w2, w3 = _real(1j * u, -1j * w, -vb)
        a2, a3 = _real(1j * u, -1j * w, -ab_ + w2**2 * u - w3**2 * w)
        return cls([b, vb, ab_], [c, 1j * w3 * w, (1j * a3 - w3**2) * w], (w2, w3), (a2, a3))


def four_bar(t: Any) -> dict[str, Any]:
    """B and C of the four-bar (SI) at a time (s)."""
    loop = Loop.at(mpf("0.5") + 2 * mp.pi * t, 2 * mp.pi, *map(mpf, FOUR_BAR.values()))
    return {
        f"{name}.{k}{axis}": part for name, point in (("B", loop.b), ("C", loop.c)) for k, axis, part in _parts(point)
    }


def feeder(t: Any) -> dict[str, Any]:
    """The outputs of the paper feeder that a design study wants (SI) at a time (s)."""
    ab, bc, cd, de, ad, ah = (mpf(mm) / 1000 for mm in (155, 395, 300, 500, 300, 580))
    speed = -4 * mp.pi / 3
    loop = Loop.at(mp.atan2(mpf("61.78"), mpf("142.16")) + speed * t, speed, ab, bc, cd, ad)
    (b, _, b2), (c, _, c2), (w2, w3), (a2, a3) = loop.b, loop.c, loop.omega, loop.alpha
    a, d, share = mpc(0), mpc(ad), de / cd
    e = [d + (c - d) * share, loop.c[1] * share, c2 * share]
    g = mpc(e[0].real, ah)
    points = {"A": a, "B": b, "C": c, "D": d, "E": e[0], "G": g}
    moved = {  # each link's centre of mass, its acceleration, the link's angular acceleration and length
        "crank": (b / 2, b2 / 2, mpf(0), ab),
        "coupler": ((b + c) / 2, (b2 + c2) / 2, a2, bc),
        "rocker": ((d + e[0]) / 2, e[2] / 2, a3, de),
        "slider": (e[0], e[2], mpf(0), mpf(0)),
        "guide": (g, mpc(e[2].real), mpf(0), mpf(0)),
    }
    force = _forces(points, moved)
    found = {"coupler.omega": w2, "rocker.omega": w3, "coupler.alpha": a2, "rocker.alpha": a3}
    found |= {f"{name}.{k}{axis}": part for name, point in (("C", loop.c), ("E", e)) for k, axis, part in _parts(point)}
    for pin, links in PINS.items():
        found |= {f"force({', '.join(links)}).{axis}": force[pin, i] for i, axis in enumerate("xy")}
    return found | {"force(guide, slider).x": force["slide", 0], "motor.torque": force["motor", 0]}


def reference(of: Callable[[Any], dict[str, Any]], names: Sequence[str], times: Array) -> Array:
    """The named outputs (names, times) of ``four_bar`` or ``feeder``, rounded to doubles."""
    with mp.workdps(DIGITS):
        found = [of(mpf(float(t))) for t in times]
        return np.array([[float(values[name]) for values in found] for name in names])


def _parts(point: list[Any]) -> list[tuple[str, str, Any]]:
    """Components of a point, its velocity and its acceleration with their letters."""
    return [
        (k, axis, part)
        for k, z in zip(("", "v", "a"), point, strict=True)
        for axis, part in (("x", z.real), ("y", z.imag))
    ]


def _real(first: Any, second: Any, right: Any) -> tuple[Any, Any]:
    """Real r, s with r first + s second = right, all complex."""
    determinant = first.real * second.imag - first.imag * second.real
    r = (right.real * second.imag - right.imag * second.real) / determinant
    return r, (first.real * right.imag - first.imag * right.real) / determinant


def _forces(points: dict[str, Any], moved: dict[str, tuple[Any, Any, Any, Any]]) -> dict[tuple[str, int], Any]:
    """The forces of each joint's first link on its second, the couple of each slide and the motor's torque."""
    unknowns = [(pin, axis) for pin in PINS for axis in (0, 1)]
    unknowns += [(slide, part) for slide in ("rail", "slide") for part in (0, 1)] + [("motor", 0)]
    links = list(MASSES)
    matrix, right = mp.zeros(15, 15), mp.zeros(15, 1)

    def act(unknown: tuple[str, int], on: tuple[str, str], force: Any, at: Any, couple: int = 0) -> None:
        """Enter a unit of an unknown: on the second link as it is, on the first reversed."""
        for link, sign in zip(on, (-1, 1), strict=True):
            if link != "frame":
                row, arm = 3 * links.index(link), at - moved[link][0]
                moment = arm.real * force.imag - arm.imag * force.real + couple
                for k, value in enumerate((force.real, force.imag, moment)):
                    matrix[row + k, unknowns.index(unknown)] += sign * value

    for pin, on in PINS.items():
        for axis, unit in enumerate((mpc(1), mpc(0, 1))):
            act((pin, axis), on, unit, points[pin])
    for slide, on, normal, at in (
        ("rail", ("frame", "guide"), mpc(0, 1), "G"),
        ("slide", ("guide", "slider"), mpc(1), "E"),
    ):
        act((slide, 0), on, normal, points[at])
        act((slide, 1), on, mpc(0), points[at], couple=1)
    act(("motor", 0), ("frame", "crank"), mpc(0), points["A"], couple=1)
    for i, link in enumerate(links):
        mass, (_, acceleration, alpha, length) = mpf(MASSES[link]), moved[link]
        right[3 * i], right[3 * i + 1] = mass * acceleration.real, mass * (acceleration.imag + mpf("9.80665"))
        right[3 * i + 2] = mass * length**2 / 12 * alpha
    solved = mp.lu_solve(matrix, right)
    return {unknown: solved[i] for i, unknown in enumerate(unknowns)}
