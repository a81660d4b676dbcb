"""What loads and springs are given at each pose: whole turns of angles, tables, the time; all functions on symbols."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
import pytest

from helpers.acting import acting
from helpers.compiled import compiled_from
from helpers.examples import four_bar
from helpers.plain import document_of
from helpers.random_mechanisms import Seeded, build, driven_elsewhere, sketched
from linkwright.kernels import Compiled
from linkwright.results import Run, certify

# A drag link: the ground is the shortest link, and every link turns fully.
DRAG: dict[str, Any] = {"a": 3, "b": 3.2, "c": 3.4, "d": 1}


def torque(law: str, **more: Any) -> dict[str, Any]:
    return {"load": {"on": "rocker", "torque": law}} | more


def at(data: dict[str, Any], names: list[str], t: Any) -> Any:
    return compiled_from(data).evaluate(names, np.asarray(t, dtype=float))


def test_a_load_follows_an_angle_over_whole_turns() -> None:
    """A load that grows with the angle of a link that turns three times, against the reported continuous angle."""
    data = four_bar(**DRAG, loads=torque("1 N*m*rocker.angle"), measures={})
    compiled = compiled_from(data)
    t = np.random.default_rng(1).uniform(0, 6 * np.pi, 200)
    angle = Run(compiled, 0.0, 6 * np.pi, 100).evaluate(["rocker.angle"], t)[0]
    assert np.ptp(angle) > 5 * np.pi
    power, omega = compiled.evaluate(["motor.power", "rocker.omega"], t)
    assert -power == pytest.approx(angle * omega, rel=1e-12)
    assert certify(Run(compiled, 0.0, 6 * np.pi, 100)).sound(1e-11)


def test_the_whole_turns_are_the_same_whatever_is_asked_first() -> None:
    data = four_bar(**DRAG, loads=torque("1 N*m*rocker.angle"))
    t = np.linspace(0.0, 20.0, 41)
    once = at(data, ["motor.torque"], t)[0]
    for times in (t[::-1], t):
        compiled = compiled_from(data)
        found = np.array([compiled.evaluate(["motor.torque"], np.array([time]))[0, 0] for time in times])
        assert np.array_equal(found, once if times is t else once[::-1])


def test_a_torsional_spring_starts_within_half_a_turn_of_its_free_angle() -> None:
    for turns in (-1, 0, 2):
        free = 0.3 + turns * 2 * np.pi
        springs = {"s": {"turns": "coupler", "on": "rocker", "stiffness": 2, "free": free}}
        data = four_bar(**DRAG, springs=springs)
        t = np.linspace(0.0, 12.0, 50)
        angle, first, other = at(data, ["s.angle", "coupler.omega", "rocker.omega"], t)
        assert abs(angle[0] - free) <= np.pi
        slope = np.gradient(angle, t, edge_order=2)
        assert np.abs(slope - (first - other))[1:-1].max() < 0.1


def test_tables_within_tables() -> None:
    tables = {
        "inner": {"points": [["-7 rad", "0 m"], ["0 rad", "2 m"], ["9 rad", "-3 m"]], "between": "linear"},
        "outer": {"points": [["-9 m", "0 N*m"], ["0 m", "5 N*m"], ["9 m", "7 N*m"]], "between": "linear"},
    }
    loads = {"l": {"on": "crank", "torque": "outer(inner(motor.angle) + inner(0.5*motor.angle))"}}
    t = np.linspace(0, 6, 30)
    inner = np.interp(0.5 + t, [-7, 0, 9], [0, 2, -3]) + np.interp(0.25 + t / 2, [-7, 0, 9], [0, 2, -3])
    assert at(four_bar(loads=loads, tables=tables), ["motor.torque"], t)[0] == pytest.approx(
        -np.interp(inner, [-9, 0, 9], [0, 5, 7]), rel=1e-13
    )


FUNCTIONS = {
    "sin(motor.angle)": np.sin,
    "cos(motor.angle)": np.cos,
    "tan(motor.angle/9)": lambda q: np.tan(q / 9),
    "asin(sin(motor.angle)/2)": lambda q: np.arcsin(np.sin(q) / 2),
    "acos(sin(motor.angle)/2)": lambda q: np.arccos(np.sin(q) / 2),
    "atan(motor.angle)": np.arctan,
    "atan2(sin(motor.angle), 2)": lambda q: np.arctan2(np.sin(q), 2),
    "atan2(-1, cos(motor.angle))": lambda q: np.arctan2(-1, np.cos(q)),
    "exp(-motor.angle)": lambda q: np.exp(-q),
    "log(motor.angle)": np.log,
    "sqrt(motor.angle)": np.sqrt,
    "hypot(motor.angle, 2)": lambda q: np.hypot(q, 2),
    "abs(sin(motor.angle))": lambda q: np.abs(np.sin(q)),
    "min(motor.angle, 2)": lambda q: np.minimum(q, 2),
    "max(2, motor.angle)": lambda q: np.maximum(q, 2),
    "max(min(3, 4), 2)*motor.angle": lambda q: 3 * q,
    "step5(motor.angle, 1, 0, 3, 2)": lambda q: 2 * _smooth((q - 1) / 2),
    "2^motor.angle": lambda q: 2.0**q,
    "motor.angle^1.5": lambda q: q**1.5,
}


def _smooth(u: Any) -> Any:
    u = np.clip(u, 0, 1)
    return u**3 * (10 - 15 * u + 6 * u**2)


@pytest.mark.parametrize("text", FUNCTIONS)
def test_every_function_works_on_signals(text: str) -> None:
    t = np.linspace(0.1, 5.0, 37)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        found = at(four_bar(loads={"l": {"on": "crank", "torque": f"1 N*m*({text})"}}), ["motor.torque"], t)[0]
    assert -found == pytest.approx(FUNCTIONS[text](t + 0.5), rel=1e-13, abs=1e-14)


def test_numbers_of_springs_may_be_parameters() -> None:
    entry = {"from": "A", "to": "C", "gas": 40, "progression": 1.3, "length": [1, 6], "exponent": 1}
    names = ["gas", "progression", "exponent"]
    by_name = entry | {name: name[0] + "0" for name in names} | {"length": ["low", "high"]}
    values = {name[0] + "0": entry[name] for name in names} | {"low": 1, "high": 6}
    t = np.linspace(0, 6, 9)
    signals = ["motor.torque", "s.energy", "s.force"]
    one = at(four_bar(springs={"s": entry}), signals, t)
    assert at(four_bar(springs={"s": by_name}, parameters=values), signals, t) == pytest.approx(one, rel=1e-13)


def test_motion_alone_asks_no_tables() -> None:
    tables = {"f": {"points": [["0 rad", "0 N*m"], ["1 rad", "1 N*m"]], "between": "linear"}}
    compiled: Compiled = compiled_from(four_bar(loads=torque("f(motor.angle)"), tables=tables))
    asked: list[int] = []
    fill = compiled.supply.fill
    compiled.supply.fill = lambda *args: (asked.append(1), fill(*args))[1]  # type: ignore[method-assign,func-returns-value]
    compiled.evaluate(["C.x", "rocker.alpha"], np.zeros(3))
    assert not asked
    compiled.evaluate(["motor.torque"], np.zeros(3))
    assert asked


@pytest.mark.parametrize("seed", range(3))
def test_beyond_the_dyads_too(seed: int) -> None:
    """Loads and springs on mechanisms that are solved all together: the balances of the certificate."""
    plain = build("six_bar", Seeded(seed))
    moved = driven_elsewhere(plain, Seeded(seed))
    sections, _, _ = acting(plain, Seeded(seed))
    document = document_of(sketched(moved, moved.moving))
    loads = {name: load for name, load in sections["loads"].items() if "M1" not in str(load)}
    document |= {**sections, "loads": document.get("loads", {}) | loads}
    compiled = compiled_from(document)
    assert compiled.structure.higher_groups or any(any(group.chains) for group in compiled.structure.groups)
    assert certify(Run(compiled, 0.0, 0.05, 10)).sound(1e-9)
