"""Friction in random mechanisms against a fixed point of the full Newton-Euler system, from raw geometry."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from helpers.compiled import compiled_from, compiled_of, regular
from helpers.expected import expected_forces, oracle_states, worst
from helpers.friction import slider_crank
from helpers.newton_euler import Oracle, Reactions, State
from helpers.plain import FRAME, Plain, document_of
from helpers.random_mechanisms import DURATION, RECIPES, mechanisms
from linkwright.results.certificate import equilibrium, power, work
from linkwright.results.independent_check import Reports
from linkwright.results.jamming import followed, laws
from linkwright.results.run import Run

T = np.linspace(0.0, DURATION, 4)
RADIUS, LENGTH, COEFFICIENT, VISCOUS = 0.03, 0.6, 0.04, 0.07


@dataclass
class Rubbing:
    """Friction in the oracle: a value for each joint in each state, corrected by the law until it stands."""

    plain: Plain
    pins: list[str]
    slides: list[str]

    def __post_init__(self) -> None:
        self.values: dict[tuple[float, str], float] = {}

    def __call__(self, oracle: Oracle, state: State) -> list[tuple[str, Any, Any, float]]:
        found = []
        for name in self.pins:
            (first, _), (second, _) = self.plain.pins[name]
            moment = self.values.get((state.t, name), 0.0)
            found += [(second, np.zeros(2), np.zeros(2), moment), (first, np.zeros(2), np.zeros(2), -moment)]
        for name in self.slides:
            slide = self.plain.slides[name]
            (a, b), force = slide.links, self.values.get((state.t, name), 0.0) * self.along(oracle, state, name)
            at = oracle.point(state.q, b, slide.points[1])
            found += [(b, force, at, 0.0), (a, -force, at, 0.0)]
        return found

    def along(self, oracle: Oracle, state: State, name: str) -> Any:
        slide = self.plain.slides[name]
        heading = oracle.pose(state.q, slide.links[0])[2] + slide.angles[0]
        return np.array([math.cos(heading), math.sin(heading)])

    def correct(self, oracle: Oracle, state: State, solved: Reactions) -> float:
        """The values that the law makes of the reactions; by how much they differ from the last."""

        def omega(link: str) -> float:
            return 0.0 if link == FRAME else float(oracle.pose(state.v, link)[2])

        moved = 0.0
        for name in self.pins:
            (first, _), (second, _) = self.plain.pins[name]
            speed = omega(second) - omega(first)
            pressed = float(np.hypot(*solved.reactions[name, second][:2]))
            value = -math.copysign(COEFFICIENT * RADIUS * pressed, speed) - VISCOUS * speed
            moved = max(moved, abs(value - self.values.get((state.t, name), 0.0)))
            self.values[state.t, name] = value
        for name in self.slides:
            slide = self.plain.slides[name]
            (a, b), (pa, pb) = slide.links, slide.points
            along = self.along(oracle, state, name)
            local = self.plain.links[b].points[pb]
            at = oracle.point(state.q, b, pb)
            away = at - oracle.point(state.q, a, pa)
            there = oracle.velocity(state, b, local)
            here = oracle.velocity(state, a, self.plain.links[a].points[pa]) if a != FRAME else np.zeros(2)
            speed = float(along @ (there - here - omega(a) * np.array([-away[1], away[0]])))
            x, y, moment = solved.reactions[name, b]
            pressed = max(abs(-along[1] * x + along[0] * y), 2 * abs(moment) / LENGTH)
            value = -math.copysign(COEFFICIENT * pressed, speed) - VISCOUS * speed
            moved = max(moved, abs(value - self.values.get((state.t, name), 0.0)))
            self.values[state.t, name] = value
        return moved


def rubbing(plain: Plain) -> tuple[dict[str, Any], Rubbing]:
    """The file of a mechanism with friction in up to three pins of two links and all slides outside loops, and the
    same for the oracle."""
    looped = compiled_of(plain).quantities.signals.looped
    pins = [name for name, members in plain.pins.items() if len(members) == 2][:3]
    slides = [name for name in plain.slides if name not in looped]
    data = document_of(plain, length="m", angle="rad", mass="kg", time="s", force="N", torque="N*m")
    law = {"coefficient": COEFFICIENT}
    data["friction"] = {}
    for name in pins:
        links = [link for link, _ in plain.pins[name]]
        viscous = f"{VISCOUS} N*m*s/rad"
        own = {"pin": name, "in": links[::-1], "radius": f"{RADIUS} m", "viscous": viscous}
        data["friction"][f"pin_{name}"] = own | law
    for name in slides:
        own = {"slide": name, "length": f"{LENGTH} m", "viscous": f"{VISCOUS} N*s/m"}
        data["friction"][f"slide_{name}"] = own | law
    return data, Rubbing(plain, pins, slides)


@pytest.mark.parametrize("recipe", RECIPES)
@settings(max_examples=2)
@given(data=st.data())
def test_friction_solves_newton_and_euler(recipe: str, data: Any) -> None:
    """All reactions and efforts to 1e-9 of the largest force; equilibrium and the balance of power hold, too."""
    plain = data.draw(mechanisms(recipe))
    file, friction = rubbing(plain)
    assume(file["friction"])
    compiled = compiled_from(file)
    regular(compiled, T)
    speeds = [f"{name}.{'omega' if 'pin' in entry else 'v'}" for name, entry in file["friction"].items()]
    assume(np.abs(compiled.evaluate(speeds, T)).min() > 1e-6)  # at rest the sense is open
    share, efforts = followed(laws(compiled, T))
    assume(np.isinf(share).all())
    own = [f"{name}.{'moment' if 'pin' in entry else 'force'}" for name, entry in file["friction"].items()]
    assume(np.abs(compiled.evaluate(own, T) - efforts).max() < 1e-9 * np.abs(efforts).max())  # else it is told
    oracle, states = oracle_states(plain, T, [friction])
    assume(all(settle(oracle, state, friction) for state in states))
    rows = expected_forces(oracle, states)
    error, name = worst(compiled.evaluate(list(rows), T), rows, 1e-3)
    assert error < 1e-9, name
    reports = Reports(compiled, T)
    assert max(equilibrium(reports), power(reports)) < 1e-9
    powers = compiled.evaluate([f"{name}.power" for name in file["friction"]], T)
    assert (powers <= 0).all()
    assert (powers < 0).any()


def settle(oracle: Oracle, state: State, friction: Rubbing) -> bool:
    """Whether the fixed point is reached."""
    for _ in range(60):
        solved = oracle.forces(state)
        if friction.correct(oracle, state, solved) <= 1e-13 * max(abs(e) for e in (*solved.efforts.values(), 1e-3)):
            return True
    return False


def test_rates_are_those_of_the_forces() -> None:
    """By central differences of the sixth order at regular times."""
    compiled = compiled_from(slider_crank())
    names, t, h = ["motor.torque", "rail.force", "at_B.moment", "shaking.x"], np.linspace(0.011, 0.18, 9), 2e-4
    _, rates = compiled.rates(names, t)
    weights = ((1, 3 / 4), (2, -3 / 20), (3, 1 / 60))
    differences = sum(
        w / h * (compiled.evaluate(names, t + k * h) - compiled.evaluate(names, t - k * h)) for k, w in weights
    )
    assert np.abs(rates - differences).max() < 1e-7 * np.abs(rates).max()


def test_work_is_lost_in_the_joints() -> None:
    """What the drive gives over a turn, the load's work being none, is what friction takes."""
    compiled = compiled_from(slider_crank())
    run = Run(compiled, 0.0, 0.2, 360)
    assert work(run, 0.0) < 1e-12
