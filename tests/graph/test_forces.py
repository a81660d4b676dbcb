"""Reactions, efforts and energies of random mechanisms against the full Newton-Euler system of all links."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from helpers.compiled import compiled_from, compiled_of, regular
from helpers.expected import expected_energies, expected_forces, oracle_states, worst
from helpers.plain import FRAME, Law, Plain, PlainDrive, PlainLink, PlainLoad, document_of
from helpers.random_mechanisms import DURATION, RECIPES, mechanisms
from linkwright.results.certificate import equilibrium, power
from linkwright.results.independent_check import Reports

T = np.linspace(0.0, DURATION, 4)


@pytest.mark.parametrize("recipe", RECIPES)
@settings(max_examples=8)
@given(data=st.data())
def test_forces_solve_newton_and_euler(recipe: str, data: Any) -> None:
    """All reactions and efforts to 1e-9 of the largest force."""
    plain = data.draw(mechanisms(recipe))
    compiled = compiled_of(plain)
    regular(compiled, T)
    oracle, states = oracle_states(plain, T)
    rows = expected_forces(oracle, states)
    error, name = worst(compiled.evaluate(list(rows), T), rows, 1e-3)
    assert error < 1e-9, name
    energies = expected_energies(oracle, states)
    error, name = worst(compiled.evaluate(list(energies), T), energies, 1e-3)
    assert error < 1e-11, name


@settings(max_examples=25)
@given(mechanisms(), st.data())
def test_loads_on_the_frame_and_between_links_solve_newton_and_euler(plain: Plain, data: Any) -> None:
    """Reactions, efforts and shaking against the oracle; the certificate's proofs take the counterparts too."""
    pick = lambda options: data.draw(st.sampled_from(options))  # noqa: E731
    loads = {"outside": PlainLoad(FRAME, (0.2, -0.3), (4.0, -7.0), torque=1.5)}
    for i in range(2):
        on = pick(list(plain.links))
        against = pick([link for link in plain.links if link != on])
        loads[f"between{i}"] = PlainLoad(on, (0.1, 0.4), (5.0, 3.0), pick((None, on, against)), None, 2.0, against)
    plain = replace(plain, loads=loads)
    compiled = compiled_of(plain)
    regular(compiled, T)
    rows = expected_forces(*oracle_states(plain, T))
    error, name = worst(compiled.evaluate(list(rows), T), rows, 1e-3)
    assert error < 1e-9, name
    reports = Reports(compiled, T)
    assert max(equilibrium(reports), power(reports)) < 1e-9


@settings(max_examples=20)
@given(mechanisms())
def test_action_and_reaction_are_opposite(plain: Any) -> None:
    compiled = compiled_of(plain)
    regular(compiled, T)
    for contact in compiled.quantities.signals.contacts:
        if contact.on == contact.joint:
            continue
        attributes = ("x", "y", "normal", "moment") if contact.sliding else ("x", "y")
        there = [f"force({contact.link}, {contact.on}, {contact.joint}).{a}" for a in attributes]
        back = [f"force({contact.on}, {contact.link}, {contact.joint}).{a}" for a in attributes]
        one, other = compiled.evaluate(there, T), compiled.evaluate(back, T)
        assert np.abs(one + other).max() <= 1e-12 * max(1e-3, np.abs(one).max())


@settings(max_examples=15)
@given(mechanisms())
def test_forces_on_a_shared_pin_sum_to_zero(plain: Any) -> None:
    compiled = compiled_of(plain)
    regular(compiled, T)
    for pin in compiled.structure.topology.pins.values():
        if len(pin.links) < 3:
            continue
        names = [f"force({link}, {pin.name}).{axis}" for axis in "xy" for link in pin.links]
        forces = compiled.evaluate(names, T).reshape(2, len(pin.links), -1)
        assert np.abs(forces.sum(axis=1)).max() < 1e-10 * max(1e-3, np.abs(forces).max())


def one_arm(**drive: Any) -> Plain:
    """A bar of 2 kg on a pivot, its centre 0.5 m out."""
    links = {
        FRAME: PlainLink({"O": (0.0, 0.0)}),
        "bar": PlainLink({"O": (0.0, 0.0)}, 2.0, (0.5, 0.0), 0.1),
    }
    return Plain(
        links,
        {"O": ((FRAME, "O"), ("bar", "O"))},
        {},
        {"motor": PlainDrive(**drive)},
        {FRAME: (0.0, 0.0, 0.0), "bar": (0.0, 0.0, 0.0)},
        gravity=(0.0, -10.0),
    )


@pytest.mark.parametrize(("link", "on", "sign"), [("bar", FRAME, 1.0), (FRAME, "bar", -1.0)])
def test_signs_of_a_single_arm(link: str, on: str, sign: float) -> None:
    """By hand: a level bar at rest wants a torque of m g l on it, counter-clockwise, and the pin bears its weight."""
    compiled = compiled_of(one_arm(kind="turns", link=link, on=on, law=Law(0.0, 0.0)))
    names = ["motor.torque", "force(frame, bar).x", "force(frame, bar).y", "shaking.y", "shaking.moment"]
    torque, fx, fy, shaking, moment = compiled.evaluate(names, np.zeros(1))[:, 0]
    assert torque == pytest.approx(sign * 2 * 10 * 0.5, abs=1e-12)
    assert (fx, fy) == pytest.approx((0.0, 20.0), abs=1e-12)
    assert (shaking, moment) == pytest.approx((-20.0, -10.0), abs=1e-12)


def test_centrifugal_force_of_a_single_arm() -> None:
    """By hand: m omega^2 l towards the pivot."""
    plain = one_arm(kind="turns", link="bar", on=FRAME, law=Law(0.0, 3.0))
    found = compiled_of(plain).evaluate(["force(frame, bar).x", "force(frame, bar).y"], np.zeros(1))[:, 0]
    assert found == pytest.approx((-2.0 * 9.0 * 0.5, 20.0), abs=1e-12)


def test_side_load_on_a_slide_gives_normal_and_moment() -> None:
    """By hand: a block on a level rail, pushed down by 7 N at 0.3 m ahead of its line point."""
    data = {
        "linkwright": 1,
        "units": {"length": "m", "angle": "deg", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"},
        "links": {"frame": {"points": {"O": [0, 0]}}, "block": {"points": {"P": [0, 0], "Q": [0.3, 0]}}},
        "joints": {"rail": {"prismatic": ["frame", "block"], "line": ["O at 0", "P at 0"]}},
        "drives": {"push": {"slides": "block", "on": "frame", "start": 1, "speed": 2}},
        "loads": {"weight": {"on": "block", "at": "Q", "force": [-4, -7]}},
    }
    names = [f"force(frame, block).{a}" for a in ("x", "y", "normal", "moment", "arm")]
    found = compiled_from(data).evaluate([*names, "push.force", "push.power", "rail.s"], np.zeros(1))[:, 0]
    assert found == pytest.approx((0.0, 7.0, 7.0, 2.1, 0.3, 4.0, 8.0, 1.0), abs=1e-12)


def test_without_mass_and_loads_there_are_no_forces() -> None:
    plain = one_arm(kind="turns", link="bar", on=FRAME, law=Law(0.0, 3.0))
    data = document_of(plain)
    for key in ("mass", "com", "inertia"):
        del data["links"]["bar"][key]
    found = compiled_from(data).evaluate(["motor.torque", "force(frame, bar).x", "shaking.y"], np.zeros(2))
    assert not found.any()


def test_a_rod_between_a_point_by_coordinates_and_one_in_polar_form() -> None:
    """[1, 0.5] and '1 at 0.5' are two places, though written with the same figures."""
    data = document_of(one_arm(kind="turns", link="bar", on=FRAME, law=Law(0.0, 0.0)))
    points = {"O": [0, 0], "P": [1, 0.5], "Q": "1 at 0.5"}
    data["links"]["bar"] = {"points": points, "mass": 2, "shape": "rod P-Q"}
    (torque,) = compiled_from(data).evaluate(["motor.torque"], np.zeros(1))[:, 0]
    assert torque == pytest.approx(2 * 10 * (1 + np.cos(0.5)) / 2)


def test_a_moment_of_inertia_without_mass_wants_its_torque() -> None:
    """A flywheel given by its moment of inertia alone: T = I alpha."""
    data = document_of(one_arm(kind="turns", link="bar", on=FRAME, law=Law(0.0, 0.0)))
    data["links"]["bar"] |= {"mass": 0}
    data["drives"]["motor"] |= {"acceleration": 3}
    torque, fx = compiled_from(data).evaluate(["motor.torque", "force(frame, bar).x"], np.array([0.7]))[:, 0]
    assert (torque, fx) == pytest.approx((0.1 * 3, 0.0), abs=1e-15)
