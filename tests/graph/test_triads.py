"""Triads with legs of every kind: all real modes against many starts of an independent solver; the polynomial."""

from __future__ import annotations

import cmath
import math
from itertools import combinations_with_replacement
from typing import Any

import numpy as np
import pytest
from scipy.optimize import fsolve

import linkwright as lw
from linkwright.graph.legs import triad
from linkwright.graph.modes import Explorer
from linkwright.graph.motion import Motion
from linkwright.graph.triads import TriadSystem, trigonometric_roots
from linkwright.model.document import Document
from linkwright.model.quantities import Quantities
from linkwright.notation import Body
from linkwright.structure import decompose

THREE = list(combinations_with_replacement(("RR", "PR", "RP"), 3))
FIXED = [("PP", *pair) for pair in combinations_with_replacement(("RR", "PR", "RP"), 2)]


class Platform:
    """A platform at a random pose (place 0, angle 0) on three legs: its equations in complex numbers, and its file."""

    def __init__(self, kinds: tuple[str, ...], seed: int) -> None:
        random = np.random.default_rng(seed)
        self.kinds = kinds
        self.base = random.uniform(-3, 3, 3) + 1j * random.uniform(-3, 3, 3)
        self.on = random.uniform(-1, 1, 3) + 1j * random.uniform(-1, 1, 3)
        self.line, self.other = random.uniform(-3, 3, 3), random.uniform(-3, 3, 3)

    def known(self, i: int) -> float:
        """The dimension that a leg keeps: its length, or the offset of its slide."""
        arm = self.on[i] - self.base[i]
        if self.kinds[i] == "RR":
            return abs(arm)
        return float((cmath.exp(-1j * self.line[i]) * arm).imag)

    def equations(self, u: Any) -> list[float]:
        z, e = complex(u[0], u[1]), cmath.exp(1j * u[2])
        rests = []
        for i, kind in enumerate(self.kinds):
            arm = z + e * self.on[i] - self.base[i]
            along = cmath.exp(1j * self.line[i]) * (e if kind == "RP" else 1.0)
            if kind == "PP":
                rests.append(math.sin(u[2] / 2))
            else:
                size = abs(arm) if kind == "RR" else (along.conjugate() * arm).imag
                rests.append(size - self.known(i))
        return rests

    def found(self) -> list[complex]:
        """The distinct solutions of many starts, each as its angle's unit vector and place in one number."""
        random, poses = np.random.default_rng(7), []
        for start in random.uniform(-1, 1, (400, 3)) * [6, 6, math.pi]:
            u, _, good, _ = fsolve(self.equations, start, xtol=1e-13, full_output=True)
            if good == 1 and max(map(abs, self.equations(u))) < 1e-10:
                key = complex(u[0], u[1]) + 10 * cmath.exp(1j * u[2])
                if all(abs(key - other) > 1e-6 for other in poses):
                    poses.append(key)
        return sorted(poses, key=lambda p: (p.real, p.imag))

    def document(self) -> Document:
        frame, platform, joints = {}, {"Q": [0, 0]}, {}
        links: dict[str, Any] = {"frame": {"points": frame}}
        for i, kind in enumerate(self.kinds):
            a, b, line, known = f"A{i}", f"B{i}", float(self.line[i]), self.known(i)
            frame[a] = [self.base[i].real, self.base[i].imag]
            platform[b] = [self.on[i].real, self.on[i].imag]
            if kind == "RR":
                points = {a: [0, 0], b: [known, 0]}
            elif kind == "PR":
                points = {f"G{i}": [0.3, 0.1], b: [0.7, 0.1 + known]}
                joints[f"rail{i}"] = {"prismatic": ["frame", f"leg{i}"], "line": [f"{a} at {line!r}", f"G{i} at 0"]}
            elif kind == "RP":
                points = {a: [0, 0], f"H{i}": [0.4, known]}
                joints[f"rod{i}"] = {"prismatic": ["platform", f"leg{i}"], "line": [f"{b} at {line!r}", f"H{i} at 0"]}
            else:
                turn = float(self.other[i])
                points = {f"G{i}": [0, 0]}
                joints[f"rail{i}"] = {"prismatic": ["frame", f"leg{i}"], "line": [f"{a} at {line!r}", f"G{i} at 0"]}
                ends = [f"{b} at {turn!r}", f"G{i} at {turn - line!r}"]
                joints[f"rod{i}"] = {"prismatic": ["platform", f"leg{i}"], "line": ends}
            links[f"leg{i}"] = {"points": points}
        links["platform"] = {"points": platform}
        units = {"length": "m", "angle": "rad", "time": "s"}
        return Document.model_validate({"units": units, "links": links, "joints": joints})


@pytest.mark.parametrize("seed", [1, 2, 3])
@pytest.mark.parametrize("kinds", [*THREE, *FIXED], ids="-".join)
def test_all_modes_and_no_other(kinds: tuple[str, ...], seed: int) -> None:
    """What 400 starts of scipy find is what the polynomial finds, to 1e-8 (fsolve's own accuracy)."""
    platform = Platform(kinds, seed)
    outcome = lw.modes(platform.document())
    assert outcome.complete
    ours = []
    for mode in outcome.modes:
        body, at = mode.bodies["platform"], mode.places["Q"]
        ours.append(complex(*at) + 10 * complex(*body.axis.now))
    ours.sort(key=lambda p: (p.real, p.imag))
    assert len(ours) <= 6
    assert np.abs(np.array(ours) - np.array(platform.found())).max() < 1e-8


@pytest.mark.parametrize("kinds", THREE, ids="-".join)
def test_harmonics_above_the_third_vanish(kinds: tuple[str, ...]) -> None:
    """To round-off; the roots are then all the zeros of the polynomial, as sign changes on a fine grid confirm."""
    document = Platform(kinds, 5).document()
    quantities, structure = Quantities(document), decompose(document)
    motion = Motion(structure, Explorer(quantities, structure, {}).geometry, 0)
    motion.bodies["frame"] = Body.fixed(0)
    shape = triad(motion, structure.higher_groups[0], {})
    assert shape is not None
    assert sorted("".join("PR"[turns] for turns in leg.turning) for leg in shape.legs) == sorted(kinds)
    system = TriadSystem(motion, shape)
    angles, harmonics = trigonometric_roots(system.sampled)
    assert harmonics[4:].max() < 1e-13
    values = system.sampled(np.linspace(-3.1, 2 * math.pi - 3.1, 20_000))
    assert int((values[1:] * values[:-1] < 0).sum()) == len(angles)


def test_double_roots_are_found() -> None:
    """cos(2 phi) - 1 has double roots at 0 and pi, found to the square root of round-off."""
    found, _ = trigonometric_roots(lambda phi: np.cos(2 * phi) - 1)
    for root in (0.0, math.pi):
        assert min(abs(cmath.exp(1j * phi) - cmath.exp(1j * root)) for phi in found) < 1e-6


def test_a_polynomial_that_vanishes_is_told() -> None:
    found, harmonics = trigonometric_roots(lambda phi: 0.0 * phi)
    assert found == []
    assert harmonics.size == 0


def test_a_platform_that_moves_by_itself_is_not_called_complete() -> None:
    """Three equal parallel legs carry the platform round: the poses are no finite number."""
    legs = {f"leg{i}": {"points": {f"A{i}": [0, 0], f"B{i}": [1, 0]}} for i in range(3)}
    frame = {"points": {f"A{i}": [i, 0.3 * i * i] for i in range(3)}}
    plate = {"points": {f"B{i}": [i, 0.3 * i * i] for i in range(3)}}
    units = {"length": "m", "angle": "rad", "time": "s"}
    data = {"units": units, "links": {"frame": frame, **legs, "plate": plate}}
    outcome = lw.modes(Document.model_validate(data))
    assert not outcome.complete


def test_two_modes_that_meet_are_one_singular_mode() -> None:
    """Legs that all point to one centre: the platform's two nearest poses have come together."""
    base = [cmath.rect(2.0, angle) for angle in (0.1, 2.2, 4.1)]
    on = [cmath.rect(0.7, angle) for angle in (0.1, 2.2, 4.1)]
    legs = {f"leg{i}": {"points": {f"A{i}": [0, 0], f"B{i}": [1.3, 0]}} for i in range(3)}
    frame = {"points": {f"A{i}": [z.real, z.imag] for i, z in enumerate(base)}}
    plate = {"points": {f"B{i}": [z.real, z.imag] for i, z in enumerate(on)}}
    units = {"length": "m", "angle": "rad", "time": "s"}
    data = {"units": units, "links": {"frame": frame, **legs, "plate": plate}}
    outcome = lw.modes(Document.model_validate(data))
    here = [m for m in outcome.modes if abs(complex(*m.places["B0"]) - on[0]) < 1e-3]
    assert len(here) == 1
    assert here[0].singular
