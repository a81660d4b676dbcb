"""Motion of random mechanisms: against constraint equations solved in full, and against differences."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from helpers.compiled import compiled_from, compiled_of, regular
from helpers.differences import misfit
from helpers.expected import expected_angles, expected_motion, oracle_states, worst
from helpers.random_mechanisms import DURATION, RECIPES, mechanisms
from linkwright.graph.rows import BodyPlace
from linkwright.results.run import Run

T = np.linspace(0.0, DURATION, 4)


@pytest.mark.parametrize("recipe", RECIPES)
@settings(max_examples=6)
@given(data=st.data())
def test_motion_solves_the_constraint_equations(recipe: str, data: Any) -> None:
    """Positions to 1e-11, velocities and accelerations to 1e-9 of the largest of their kind."""
    plain = data.draw(mechanisms(recipe))
    compiled = compiled_of(plain)
    regular(compiled, T)
    oracle, states = oracle_states(plain, T)
    for order, rows in expected_motion(oracle, states).items():
        error, name = worst(compiled.evaluate(list(rows), T), rows, 1.0)
        assert error < (1e-11 if order == "position" else 1e-9), (order, name)
    angles = expected_angles(oracle, states)
    found = Run(compiled, 0.0, DURATION, 50).evaluate(list(angles), T)
    difference = found - np.array(list(angles.values()))
    turns = difference[:, :1] / (2 * np.pi)
    assert np.abs(turns - np.round(turns)).max() < 1e-10
    assert np.abs(difference - difference[:, :1]).max() < 1e-10


def test_the_pose_at_the_start_is_the_sketch() -> None:
    """With no solver between: the assembly rules and the drives' values alone give back the sketched pose."""

    @settings(max_examples=40)
    @given(mechanisms())
    def check(plain: Any) -> None:
        compiled = compiled_of(plain)
        regular(compiled, np.zeros(1), 0.2)
        names = [row for link in plain.moving for row in BodyPlace.all(link)]
        found = compiled.evaluate(names, np.zeros(1))[:, 0].reshape(-1, 4)
        x, y, angle = np.array([plain.start[link] for link in plain.moving]).T
        assert np.abs(found - np.array([x, y, np.cos(angle), np.sin(angle)]).T).max() < 1e-10

    check()


ORDERS = {
    "point": [("x", "vx", "ax", "jx"), ("y", "vy", "ay", "jy")],
    "com": [("x", "vx", "ax", "jx"), ("y", "vy", "ay", "jy")],
    "link": [("angle", "omega", "alpha", "jerk")],
    "slide": [("s", "v", "a", "j")],
}


TAME = 1e4
"""Rates beyond this (in SI, for links of a metre or so) belong to a pose that differences can't resolve."""


def chains(compiled: Any) -> list[list[str]]:
    """Every signal of motion with its successive rates, by name."""
    return [
        [signal.text.removesuffix(chain[0]) + rate for rate in chain]
        for signal in compiled.quantities.signals.all()
        for chain in ORDERS.get(signal.kind, [])
        if signal.attribute == chain[0]
    ]


@pytest.mark.parametrize("recipe", RECIPES)
@settings(max_examples=6)
@given(data=st.data())
def test_rates_agree_with_differences(recipe: str, data: Any) -> None:
    """Velocity, acceleration and jerk of all points and links against differences of the order below: 1e-7."""
    plain = data.draw(mechanisms(recipe))
    compiled = compiled_of(plain)
    regular(compiled, T, 0.2)
    run = Run(compiled, -0.1, DURATION + 0.1, 50)
    rows = chains(compiled)
    for k in range(3):
        lower, upper = [c[k] for c in rows], [c[k + 1] for c in rows]
        exact = run.evaluate(upper, T)
        assume(np.abs(exact).max() < TAME)
        errors = misfit(lambda t, names=lower: run.evaluate(names, t), exact, T).max(axis=1)
        assert errors.max() < 1e-7 * max(1.0, float(np.abs(exact).max())), upper[int(errors.argmax())]


@settings(max_examples=40)
@given(mechanisms())
def test_rates_of_any_signal_are_exact(plain: Any) -> None:
    """``Run.rates`` of every signal, forces, efforts, powers and energies too, against differences: 1e-7."""
    compiled = compiled_of(plain)
    regular(compiled, T, 0.2)
    run = Run(compiled, -0.1, DURATION + 0.1, 50)
    names = [s.text for s in compiled.quantities.signals.all() if s.attribute != "arm"]
    values, rates = run.rates(names, T)
    assert np.array_equal(values, run.evaluate(names, T))
    assume(np.abs(rates).max() < 10 * TAME)
    scale = np.maximum(np.abs(rates).max(axis=1), 1e-3 * max(1.0, np.abs(rates).max()))
    errors = misfit(lambda t: run.evaluate(names, t), rates, T).max(axis=1) / scale
    assert errors.max() < 1e-7, names[int(errors.argmax())]


@pytest.mark.parametrize("name", ["reach", "span", "determinant", "lever"])
def test_a_link_may_be_called_like_a_row_of_the_program(name: str) -> None:
    data = {
        "links": {"frame": {"points": {"A": [0, 0]}}, name: {"points": {"A": [0, 0], "B": ["1 m", 0]}}},
        "drives": {"motor": {"turns": name, "on": "frame", "speed": "1 rad/s", "start": 0}},
    }
    assert compiled_from(data).evaluate([BodyPlace(name, "cos")], np.zeros(1))[0] == 1.0
