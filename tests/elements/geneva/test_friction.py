"""Friction in the bearings of mechanisms whose followers touch on two sides: Newton and Euler, closed forms."""

from __future__ import annotations

from math import asin, pi
from pathlib import Path

import numpy as np
import pytest
from ruamel.yaml import YAML

from elements.geneva.drives import A, arc, model
from elements.geneva.test_follower import LOAD, engaged, states
from helpers.compiled import compiled_from
from helpers.expected import expected_forces
from helpers.newton_euler import Array, Oracle, State
from helpers.plain import plain_of
from linkwright.results import Run, certify

EXAMPLES = Path(__file__).parents[3] / "examples"
BEARINGS = {
    "wheel_bearing": {"pin": "Q", "radius": 12, "coefficient": 0.15},
    "driver_bearing": {"pin": "O", "radius": 10, "coefficient": 0.1},
}


def test_friction_beside_a_pin_in_a_slot_is_that_of_newton_and_euler() -> None:
    """With the reported moments of friction the oracle finds all other forces, and bearing forces that make these
    moments, by mu r times their size against the motion."""
    data = model(4, psi=-44.0, friction=BEARINGS, **LOAD)
    run, t = compiled_from(data), np.linspace(0.0, 88.0 / 360, 14)
    told = dict(zip(t.tolist(), run.evaluate([f"{name}.moment" for name in BEARINGS], t).T, strict=True))

    def rubbing(of: Oracle, state: State) -> list[tuple[str, Array, Array, float]]:
        none = np.zeros(2)
        wheel, driver = told[min(told, key=lambda time: abs(time - state.t))]
        moments = {"wheel": wheel, "driver": driver, "frame": -wheel - driver}
        return [(link, none, none, float(moment)) for link, moment in moments.items()]

    rows = run.evaluate(["O.x", "O.y", "driver.angle", "Q.x", "Q.y", "wheel.angle"], np.zeros(1))[:, 0]
    start = {"driver": tuple(rows[:3]), "wheel": tuple(rows[3:])}
    plain = plain_of({**data, "joints": {}, "friction": {}}, start)
    oracle = Oracle(plain, [rubbing], {"indexing": engaged(4)})
    found = states(oracle, run, t)
    expected = expected_forces(oracle, found)
    own = dict(zip(expected, run.evaluate([*expected], t), strict=True))
    scale = max(float(np.abs(values).max()) for values in expected.values())
    for name, values in expected.items():
        assert np.abs(own[name] - values).max() < 1e-8 * scale, name
    omega = run.evaluate(["wheel.omega", "driver.omega"], t)
    for k, (link, pin, size) in enumerate((("wheel", "Q", 0.15 * 0.012), ("driver", "O", 0.1 * 0.010))):
        force = np.hypot(*(expected[f"force(frame, {link}, {pin}).{axis}"] for axis in "xy"))
        moment = np.array([*told.values()])[:, k]
        assert np.abs(np.abs(moment) - size * force).max() < 1e-9 * np.abs(moment).max()
        assert (moment * omega[k] < 0).all()


@pytest.mark.parametrize("torque", [6.0, -6.0])
def test_a_locking_force_rubs_in_the_drivers_bearing(torque: float) -> None:
    """In the dwell the motor turns against mu r F, F being the force at the horn, whichever bears; nothing rubs where
    nothing turns."""
    data = model(4, psi=100.0, friction=BEARINGS, loads={"drill": {"on": "wheel", "torque": torque}})
    del data["gravity"]
    data["links"]["driver"]["com"] = [0, 0]
    t = np.linspace(0.0, 160 / 360, 9)
    names = ["motor.torque", "wheel_bearing.moment", "indexing.force"]
    motor, rests, force = compiled_from(data).evaluate(names, t)
    size = arc(4)
    horn = np.arccos((size**2 + (A * np.sin(pi / 4)) ** 2) / (2 * A * size))
    push = 6.0 / (A * 1e-3 * np.sin(horn))
    assert force == pytest.approx(-np.sign(torque) * push, rel=1e-12)
    assert motor == pytest.approx(0.1 * 0.010 * push, rel=1e-11)
    assert np.abs(rests).max() < 1e-12
    assert 0 < horn < asin(1.0)


def test_certificates_hold() -> None:
    """All stretches of Geneva drives, and of a conjugate cam whose second contact bears for half of a turn."""
    for n, pins in ((3, 1), (4, 2), (6, 1)):
        run = Run(compiled_from(model(n, pins=pins, psi=20.0, friction=BEARINGS, **LOAD)), 0.0, 1.0, 120)
        assert certify(run).sound(1e-10), (n, pins)
    data = YAML(typ="safe").load((EXAMPLES / "conjugate_cam.yaml").read_text(encoding="utf-8"))
    for key in ("measures", "require", "studies"):
        data.pop(key)
    alone = Run(compiled_from(data), 0.0, 0.2, 120)
    data["friction"] = {
        "shaft_bearing": {"pin": "O", "radius": 30, "coefficient": 0.1},
        "sley_bearing": {"pin": "A", "radius": 25, "coefficient": 0.2},
    }
    run = Run(compiled_from(data), 0.0, 0.2, 120)
    assert certify(run).sound(1e-10)
    force, without = (of.evaluate(["sley_drive.force"], run.t)[0] for of in (run, alone))
    assert force.min() < 0 < force.max()
    assert 1e-3 < np.abs(force - without).max() / np.abs(without).max() < 0.2
