"""Geneva drives: motion against the geometry of pin and slot over many turns, forces against Newton and Euler by raw
geometry, the certificate that holds and that fails what is wrong."""

from __future__ import annotations

from collections.abc import Callable
from math import cos, degrees, hypot, pi, radians, sin
from typing import Any

import numpy as np
import pytest

import linkwright as lw
from elements.geneva.drives import ARM, LINE, SLOT, A, arc, model, radius
from helpers.compiled import compiled_from
from helpers.expected import expected_forces
from helpers.newton_euler import Array, Gap, Oracle, State, cross
from helpers.plain import plain_of
from linkwright.elements.geneva import contact
from linkwright.graph.rows import BodyPlace
from linkwright.results import Run, certify
from results.test_certificate import lie

TURN = 2 * pi


def staircase(n: int, pins: int, psi: Array) -> Array:
    """The wheel's angle (rad, against the driver, from where a slot points at it) by that of the first pin: by sines in
    the triangle of both centres and the pin, one pin at a time."""
    turned = np.zeros_like(psi)
    for k in range(pins):
        behind = psi + TURN * k / pins
        whole = np.round(behind / TURN)
        here, step = behind - TURN * whole, TURN / n
        pin = radius(n) * np.exp(1j * here)
        engaged = np.abs(here) < pi / 2 - pi / n
        beta = np.angle((A - pin).conj())
        turned += np.where(engaged, beta, np.sign(here) * step / 2) + whole * step - (step / 2 if k else 0.0)
    return turned


@pytest.mark.parametrize("speed", ["60 rpm", "-60 rpm"])
@pytest.mark.parametrize(("n", "pins"), [(3, 1), (4, 1), (4, 2), (4, 4), (5, 1), (6, 3), (8, 1), (12, 2)])
def test_it_indexes_over_many_turns(n: int, pins: int, speed: str) -> None:
    """Twelve turns either way; the wheel ends n-ths of a turn further, to round-off."""
    t = np.linspace(0.0, 12.0, 1931)
    compiled = compiled_from(model(n, pins=pins, psi=3.0, speed=speed))
    angle, omega, alpha = compiled.evaluate(["wheel.angle", "wheel.omega", "wheel.alpha"], t)
    psi = radians(3.0) + TURN * t * (-1 if speed.startswith("-") else 1)
    expected = radians(LINE) + pi - radians(SLOT) - staircase(n, pins, psi)
    assert np.abs(angle - expected).max() < 1e-12 * np.abs(expected).max()
    assert angle[-1] - angle[0] == pytest.approx(-np.sign(psi[-1]) * 12 * pins * TURN / n, abs=1e-11)
    locked = np.abs(np.mod(pins * (psi + pi / pins), TURN) / pins - pi / pins) > pi / 2 - pi / n
    assert locked.any() == (pins < 2 * n / (n - 2))
    assert np.abs(np.array([omega, alpha])[:, locked]).max(initial=0.0) == 0.0


# Forces.


def engaged(n: int) -> Gap:
    """How far the pin lies beside the middle line of the slot that is nearest to it (m)."""

    def gap(of: Oracle, q: Array) -> float:
        out, turn = of.point(q, "driver", "P1") - of.point(q, "wheel", "Q"), of.pose(q, "wheel")[2] + radians(SLOT)
        heading = turn + np.round((np.arctan2(out[1], out[0]) - turn) * n / TURN) * TURN / n
        return cross(np.array([cos(heading), sin(heading)]), out)

    return gap


def locked(n: int, sense: int, angle: float) -> Gap:
    """How far a corner of the wheel, on its rim and at the end of its arc, lies outside of the driver's disc (m)."""
    rim = A * cos(pi / n)
    beside = np.arccos((A**2 + rim**2 - arc(n) ** 2) / (2 * A * rim))
    local = radians(LINE) + pi + sense * beside - angle
    corner = np.array([rim * cos(local), rim * sin(local)]) * 1e-3

    def gap(of: Oracle, q: Array) -> float:
        return float(hypot(*(of.at(q, "wheel", corner) - of.point(q, "driver", "O")))) - arc(n) * 1e-3

    return gap


def states(oracle: Oracle, run: Any, t: Array) -> list[State]:
    """The oracle's states from guesses that are a little off."""
    links = oracle.plain.moving
    point = {"driver": "O", "wheel": "Q", "arm": "G"}
    rows = run.evaluate([name for k in links for name in (f"{point[k]}.x", f"{point[k]}.y", f"{k}.angle")], t)
    return [oracle.settle(rows[:, i] + 1e-3, float(time)) for i, time in enumerate(t)]


def held(data: dict[str, Any], run: Any, gap: Gap, t: Array) -> None:
    """Reactions, torques and the contact's force are those of the oracle, at some times."""
    joints = {name: joint for name, joint in data["joints"].items() if name != "indexing"}
    rows = run.evaluate(["O.x", "O.y", "driver.angle", "Q.x", "Q.y", "wheel.angle", "indexing.force"], np.zeros(1))[
        :, 0
    ]
    start = {"driver": tuple(rows[:3]), "wheel": tuple(rows[3:6]), "arm": (0.0, 0.0, radians(12))}
    oracle = Oracle(plain_of({**data, "joints": joints}, start), gaps={"indexing": gap})
    found = states(oracle, run, t)
    expected = expected_forces(oracle, found)
    push = np.array([oracle.forces(state).reactions["indexing", "wheel"] for state in found])
    expected["indexing.force"] = np.sign(push[:, 2]) * np.hypot(push[:, 0], push[:, 1])
    own = run.evaluate([*expected, "indexing.arm"], t)
    scale = max(float(np.abs(values).max()) for name, values in expected.items() if not name.endswith(".power"))
    for name, values in expected.items():
        assert np.abs(own[[*expected].index(name)] - values).max() < 1e-8 * max(scale, float(np.abs(values).max())), (
            name
        )
    # The moment on the wheel about its centre, which is its origin.
    moment = own[[*expected].index("indexing.force")] * own[-1]
    assert np.abs(moment - push[:, 2]).max() < 1e-8 * np.abs(push[:, 2]).max()
    omega = run.evaluate(["wheel.omega", "wheel.alpha"], t)
    motion = np.array([[oracle.pose(state.v, "wheel")[2], oracle.pose(state.a, "wheel")[2]] for state in found]).T
    assert np.abs(omega - motion).max() < 1e-7 * max(1.0, np.abs(motion).max())


LOAD = {"loads": {"brake": {"on": "wheel", "torque": -3.0}, "push": {"on": "wheel", "at": "T", "force": [20, -15]}}}


@pytest.mark.parametrize("arm", [False, True])
@pytest.mark.parametrize("n", [3, 4, 6])
def test_a_pin_in_a_slot_pushes_as_newton_and_euler_want(n: int, arm: bool) -> None:
    reach = 90 - 180 / n
    data = model(n, psi=-0.98 * reach, arm=arm, **LOAD)
    run = compiled_from(data)
    t = np.linspace(0.0, 2 * 0.98 * reach / 360, 13)
    assert run.evaluate(["indexing.engaged"], t).min() == 1.0
    held(data, run, engaged(n), t)


@pytest.mark.parametrize("arm", [False, True])
@pytest.mark.parametrize(("n", "torque"), [(3, 9.0), (4, -9.0), (6, 9.0)])
def test_a_locking_arc_holds_as_newton_and_euler_want(n: int, torque: float, arm: bool) -> None:
    """A corner of the wheel on the driver's disc, that on the side of the moment; the motor doesn't feel it."""
    reach = 90 - 180 / n
    data = model(n, psi=1.02 * reach, arm=arm, loads={"brake": {"on": "wheel", "torque": torque}})
    if arm:
        del data["gravity"]  # so that the moment keeps its sign
    run = compiled_from(data)
    t = np.linspace(0.0, (360 - 2.04 * reach) / 360, 13)
    force, taken, angle = run.evaluate(["indexing.force", "indexing.engaged", "wheel.angle"], t)
    assert taken.max() == 0.0
    assert (np.sign(force) == -np.sign(torque)).all()
    base = radians(12) if arm else 0.0
    held(data, run, locked(n, -int(np.sign(torque)), float(angle[0]) - base), t)


# The proof.


@pytest.mark.parametrize("arm", [False, True])
@pytest.mark.parametrize(("n", "pins"), [(3, 1), (4, 1), (4, 2), (5, 2), (8, 1)])
def test_its_certificate_holds_over_all_stretches(n: int, pins: int, arm: bool) -> None:
    """Also at poses right where pins enter and leave: samples of 5 degrees."""
    run = Run(compiled_from(model(n, pins=pins, psi=0.0, arm=arm, **LOAD)), 0.0, 2.0, 144)
    found = certify(run)
    assert found.sound(1e-11), found.residuals
    assert {*found.residuals} == {"closure", "equilibrium", "power", "work", "signals"}


LIES: dict[Any, str] = {
    "indexing.force": "equilibrium",
    "motor.torque": "equilibrium",
    "wheel.omega": "power",
    "wheel.alpha": "equilibrium",
}


@pytest.mark.parametrize("row", LIES)
def test_the_certificate_fails_wrong_numbers(row: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    run = Run(compiled_from(model(psi=40.0, **LOAD)), 0.0, 1.0, 200)
    assert certify(run).sound()
    told = lie(monkeypatch, row, lambda y: y * (1 + 1e-6))
    wrong = certify(run)
    assert told
    assert LIES[row] in wrong.unproven(), wrong.residuals


def test_the_certificate_fails_a_wheel_that_is_turned(monkeypatch: pytest.MonkeyPatch) -> None:
    run = Run(compiled_from(model(psi=40.0)), 0.0, 1.0, 200)
    c, s = run.compiled.evaluate([BodyPlace("wheel", "cos"), BodyPlace("wheel", "sin")], run.t)
    for part, turned in (("cos", c * cos(1e-6) - s * sin(1e-6)), ("sin", s * cos(1e-6) + c * sin(1e-6))):
        told = lie(monkeypatch, BodyPlace("wheel", part), lambda y, to=turned: to if y.shape == to.shape else y)
    wrong = certify(run)
    assert told
    assert "closure" in wrong.unproven(), wrong.residuals


def planted(monkeypatch: pytest.MonkeyPatch, name: str, wrong: Callable[..., Any]) -> dict[str, float]:
    """What isn't proven of a drive of which a formula is wrong."""
    honest = getattr(contact, name)
    monkeypatch.setattr(contact, name, lambda *of: wrong(honest, *of))
    return certify(Run(compiled_from(model(psi=40.0, **LOAD)), 0.0, 1.0, 200)).unproven()


def test_the_certificate_fails_a_wrong_motion(monkeypatch: pytest.MonkeyPatch) -> None:
    """A pin a millionth further out than it is, and slots that lie beside where they are."""
    with monkeypatch.context() as m:
        wrong = planted(m, "advanced", lambda honest, psi, ratio, half: honest(psi, ratio * 1.000001, half))
        assert {"closure", "power"} <= {*wrong}
    with monkeypatch.context() as m:
        wrong = planted(m, "advanced", lambda honest, psi, ratio, half: honest(psi, ratio, half) + 1e-6)
        assert "closure" in wrong


def test_the_certificate_fails_a_wrong_contact(monkeypatch: pytest.MonkeyPatch) -> None:
    """A pin that leaves its slot too early, and a horn that bears at another place of the disc."""
    with monkeypatch.context() as m:
        wrong = planted(m, "in_slot", lambda honest, cosine, half: honest(cosine, half * 1.01))
        assert {"closure", "equilibrium", "work"} <= {*wrong}
    with monkeypatch.context() as m:
        m.setattr(contact.Dimensions, "horn", property(lambda self: (0.8, 0.6)))
        assert "equilibrium" in certify(Run(compiled_from(model(psi=40.0, **LOAD)), 0.0, 1.0, 200)).unproven()


# Where it stands in a mechanism.


@pytest.mark.parametrize("start", [0.0, 33.0, -250.0, 725.0])
def test_the_slot_that_is_stated_comes_first(start: float) -> None:
    """Whatever the motor's start: where the first pin is in the wheel, the stated slot points at it."""
    data = model(5, psi=0.0)
    data["drives"]["motor"]["start"] = start
    angle = compiled_from(data).evaluate(["wheel.angle"], np.array([(LINE - ARM - start) % 360 / 360.0]))[0, 0]
    away = degrees(angle) + SLOT - LINE - 180
    whole = np.round((start - LINE + ARM + (LINE - ARM - start) % 360) / 360)
    assert away == pytest.approx(-whole * 72, abs=1e-9)


def test_a_driver_that_is_the_base_of_its_drive() -> None:
    """The same where the drive is stated the other way round."""
    data, other = model(psi=-20.0, arm=True), model(psi=-20.0, arm=True)
    other["drives"]["motor"] = {"turns": "arm", "on": "driver", "speed": "-60 rpm", "start": 20 - LINE + ARM}
    other["drives"]["swing"] = {"turns": "arm", "on": "frame", "speed": "25 rpm", "start": "12 deg"}
    t = np.linspace(0.0, 2.0, 61)
    names = ["wheel.angle", "wheel.alpha", "indexing.force", "force(arm, wheel).x", "force(driver, arm).y"]
    found, expected = (compiled_from(one).evaluate(names, t) for one in (other, data))
    assert np.abs(found - expected).max() < 1e-11 * np.abs(expected).max()


def test_the_wheel_carries_a_linkage() -> None:
    """A rocker on a point of the wheel: its motion, and the motor's torque by the power balance alone."""
    data = model(4, psi=-60.0)
    x, y = data["links"]["frame"]["points"]["Q"]
    data["links"]["frame"]["points"]["D"] = [x + 120, y]
    data["links"]["rod"] = {"points": {"T": [0, 0], "C": [130, 0]}, "mass": 0.5, "shape": "rod T-C"}
    data["links"]["rocker"] = {"points": {"D": [0, 0], "C": [110, 0]}, "mass": 0.7, "shape": "rod D-C"}
    data["assembly"] = {"C": "left of T-D"}
    data["studies"] = {"cycle": {"turns": "4 motor", "samples": 300}}
    job = lw.run(lw.Document.model_validate(data))
    assert job.cycle is not None
    certificate = job.cycle.result.certificate
    assert certificate is not None
    assert certificate.sound(1e-10)
    assert not [finding for finding in job.found if finding.severity == "error"]
