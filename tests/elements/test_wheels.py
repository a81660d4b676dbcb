"""Kinds of wheels that drive each other, held to raw geometry: motion by angles, forces along lines of action."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from functools import cache, partial
from pathlib import Path

import numpy as np
import pytest

from elements.wheels import BELTS, GEARS, RACKS, ROLLING, Wheels
from helpers.compiled import compiled_from
from helpers.expected import expected_angles, expected_forces, expected_motion
from helpers.newton_euler import Array, State
from helpers.outside import linkwright, table
from helpers.plain import UNITS
from helpers.toothed import Toothed
from linkwright.results import Run, certify
from linkwright.results.independent_check import Reports

CASES: dict[str, Wheels] = {
    **{f"gears: {name}": case for name, case in GEARS.items()},
    **{f"rack: {name}": case for name, case in RACKS.items()},
    **{f"rolling: {name}": case for name, case in ROLLING.items()},
    **{f"belt: {name}": case for name, case in BELTS.items()},
}
Followed = tuple[Toothed, list[State], dict[str, Array]]


def file(name: str) -> str:
    return re.sub(r"\W+", "_", name)


@cache
def follow(folder: Path, name: str) -> Followed:
    """A mechanism's oracle, its states at some times, and the columns of its proven run there (SI)."""
    case, degree = CASES[name], np.pi / 180
    sizes = UNITS | {"mm/s": 1e-3, "mm/s^2": 1e-3, "deg/s": degree, "deg/s^2": degree}
    (folder / f"{file(name)}.yaml").write_text(json.dumps(case.studied()), encoding="utf-8")
    done = linkwright(folder, "run", f"{file(name)}.yaml", "--out", file(name))
    assert done.returncode == 0, (name, done.stderr)
    columns, _ = table(folder / file(name) / "cycle.csv")
    own = {}
    for head, values in columns.items():
        text, unit = re.fullmatch(r"(.*?)(?: \[(.*)\])?", head).groups()  # type: ignore[union-attr]
        if unit is None or unit in sizes or unit in ("W", "J"):
            own[text] = values[::2] * sizes.get(unit or "", 1.0)
    oracle = case.oracle()
    return oracle, oracle.follow(own["t"]), own


@pytest.fixture(scope="module")
def followed(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Followed]:
    """Each mechanism followed once, when it is asked for."""
    return partial(follow, tmp_path_factory.mktemp("wheels"))


@pytest.mark.parametrize("name", CASES)
def test_they_move_as_raw_geometry_has_it(name: str, followed: Callable[[str], Followed]) -> None:
    oracle, states, own = followed(name)
    orders = {"angle": expected_angles(oracle, states), **expected_motion(oracle, states)}
    compared = 0
    for order, rows in orders.items():
        limit = {"velocity": 1e-8, "acceleration": 5e-6}.get(order, 1e-11)  # second differences of gaps
        largest = max(1.0, *(float(np.abs(values).max()) for values in rows.values()))
        for row, values in rows.items():
            if row in own:
                assert own[row] == pytest.approx(values, rel=0, abs=limit * largest), row
                compared += 1
    assert compared > 10


@pytest.mark.parametrize("name", CASES)
def test_forces_are_those_of_newton_and_euler(name: str, followed: Callable[[str], Followed]) -> None:
    """All pins, drives, the shaking force; and the forces of the teeth themselves."""
    oracle, states, own = followed(name)
    rows = expected_forces(oracle, states)
    rows |= {key.rsplit(",", 1)[0] + ")" + key[key.rindex(")") + 1 :]: row for key, row in rows.items() if "(" in key}
    compared = [row for row in rows if row in own]
    assert sum("force(" in row for row in compared) >= 4
    scale = max(float(np.abs(rows[row]).max()) for row in compared)
    for row in compared:
        assert own[row] == pytest.approx(rows[row], rel=0, abs=1e-7 * scale), row
    results = [oracle.forces(state) for state in states]
    for joint in {contact.split("/")[0] for contact in CASES[name].contacts}:
        every = [contact for contact in oracle.contacts if contact.split("/")[0] == joint]
        a, b, _, _ = oracle.contacts[joint](oracle, states[0].q, 1)
        link, other = (a, b) if a in oracle.index else (b, a)
        force = np.array([sum(result.reactions[one, link][:2] for one in every) for result in results])
        parts = [own[f"{joint}.{part}"] for part in ("force", "normal", "tangential") if f"{joint}.{part}" in own]
        size = parts[0] if f"{joint}.force" in own else np.hypot(*parts) if len(parts) == 2 else np.abs(parts[0])
        assert size == pytest.approx(np.hypot(*force.T), rel=0, abs=1e-7 * scale)
        for k, axis in enumerate("xy"):
            keys = [f"force({link}, {on}{more}).{axis}" for on in (other, joint) for more in ("", f", {joint}")]
            keys += [f"force({other}, {link}{more}).{axis}" for more in ("", f", {joint}")]
            key = next(key for key in keys if key in own)
            sign = 1.0 if key.startswith(f"force({other}") else -1.0
            assert sign * own[key] == pytest.approx(force[:, k], rel=0, abs=1e-7 * scale), key


@pytest.mark.parametrize("name", CASES)
def test_power_is_force_times_speed(name: str, followed: Callable[[str], Followed]) -> None:
    _, _, own = followed(name)
    for joint in CASES[name].data["joints"]:
        if f"{joint}.power" in own:
            power = own[f"{joint}.tangential"] * own[f"{joint}.speed"]
            assert own[f"{joint}.power"] == pytest.approx(power, rel=1e-9, abs=1e-12)


def test_the_cases_have_forces_of_both_signs(followed: Callable[[str], Followed]) -> None:
    """Both flanks bear in most of them."""
    both = [
        name
        for name in CASES
        if any(row.endswith(".tangential") and v.min() < 0 < v.max() for row, v in followed(name)[2].items())
    ]
    assert len(both) >= len(CASES) - 2


@pytest.mark.parametrize("turns", [0.4, 30.0, 500.0])
def test_wheels_turn_many_times_between_two_samples(turns: float) -> None:
    """The closure of what rolls is proven by turns that are counted from the rates, however few the samples are."""
    data = {
        "linkwright": 1,
        "units": {"length": "m", "angle": "rad", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"},
        "links": {
            "frame": {"points": {"A": [0, 0], "G": [0, -0.1]}},
            "arm": {"points": {"A": [0, 0], "B": [0.05, 0]}},
            "rod": {"points": {"B": [0, 0], "C": [0.3, 0]}},
            "wheel": {"points": {"C": [0, 0], "P": [0.04, 0]}, "mass": 0.3, "com": [0.01, 0], "inertia": 0.02},
        },
        "joints": {"rim": {"rolling": ["wheel", "frame"], "centre": "C", "radius": 0.04, "on_line": "G at 0 rad"}},
        "assembly": {"B": [0.05, 0], "C": [0.34, -0.06], "P": [0.34, -0.02]},
        "drives": {"motor": {"turns": "arm", "on": "frame", "speed": 5, "start": 0}},
    }
    run = Run(compiled_from(data), 0.0, 2 * np.pi * turns / 5, 20)
    certificate = certify(run)
    assert certificate.closure < 1e-9 and certificate.signals is not None and certificate.signals < 1e-9
    reports = Reports(run.compiled, run.t)
    assert np.diff(reports.turned("arm")) == pytest.approx(2 * np.pi * turns / 20, rel=1e-9)
