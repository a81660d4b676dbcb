"""Friction against constructions of textbooks: friction circles, a slope that locks itself, a drawer that jams.

Friction circles (Beer, Johnston, Vector Mechanics for Engineers: Statics, ch. 8): a rod without mass passes its force
along a tangent of the circles of radius mu r about its pins. To 2e-10 N m of 50 N m: round-off.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

import linkwright as lw
from helpers.compiled import compiled_from
from helpers.friction import SIZES, slider_crank
from linkwright.results.jamming import Laws, followed, laws, meets, several
from linkwright.results.self_locking import locked_stretches

CRANK, ROD, OMEGA, START = 0.05, 0.16, 10 * math.pi, 0.3


def by_friction_circles(t: float, mu: float, push: float) -> float:
    """The torque (N m) on the crank: the rod's line of force is turned out of the pins' line as the circles say."""
    theta = START + OMEGA * t
    phi = math.asin(-CRANK * math.sin(theta) / ROD)
    turning = -CRANK * math.cos(theta) * OMEGA / (ROD * math.cos(phi))  # of the rod
    a, b, c = (mu * SIZES[name] for name in "ABC")
    size = -math.copysign(1, turning - OMEGA) * b - math.copysign(1, turning) * c
    force = math.copysign(1, -push)  # the sense in which the rod pushes
    line = phi + math.asin(size / ROD) * force
    along = abs(push / math.cos(line))
    unit = np.array([math.cos(line), math.sin(line)]) * force
    at = CRANK * np.array([math.cos(theta), math.sin(theta)])
    on_rod = -math.copysign(1, turning - OMEGA) * b * along
    own = -math.copysign(1, OMEGA) * a * along
    return float(along * (at[0] * unit[1] - at[1] * unit[0]) + on_rod - own)


@pytest.mark.parametrize("mu", [0.0, 0.05, 0.1, 0.4])
@pytest.mark.parametrize("push", [-1000.0, 700.0])
def test_slider_crank_by_friction_circles(mu: float, push: float) -> None:
    t = np.linspace(0.0, 0.2, 97)
    torque = compiled_from(slider_crank(mu, None, push)).evaluate(["motor.torque"], t)[0]
    assert torque == pytest.approx([by_friction_circles(at, mu, push) for at in t], abs=2e-10)


def slope(angle: float, mu: float, up: bool) -> dict[str, Any]:
    """A block of 2 kg drawn along a slope."""
    return {
        "linkwright": 1,
        "units": {"length": "m", "angle": "rad", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"},
        "gravity": "earth",
        "links": {
            "frame": {"points": {"O": [0, 0]}},
            "block": {"points": {"P": [0, 0]}, "mass": 2, "shape": "point P"},
        },
        "joints": {"plane": {"prismatic": ["frame", "block"], "line": [f"O at {angle}", "P at 0"]}},
        "drives": {"pull": {"slides": "block", "on": "frame", "speed": 0.1 if up else -0.1, "start": 0}},
        "friction": {"rub": {"slide": "plane", "length": 0.2, "coefficient": mu}},
    }


@pytest.mark.parametrize("angle", [0.1, 0.25, 0.6])
@pytest.mark.parametrize("mu", [0.1, 0.3])
def test_slope_and_its_self_locking(angle: float, mu: float) -> None:
    """Up W (sin a + mu cos a), down W (sin a - mu cos a), which changes its sign at tan a = mu: the block has to be
    pushed down a slope that locks it."""
    weight, t = 2 * 9.80665, np.array([0.1])
    up, down = (compiled_from(slope(angle, mu, way)).evaluate(["pull.force"], t)[0, 0] for way in (True, False))
    assert up == pytest.approx(weight * (math.sin(angle) + mu * math.cos(angle)), rel=1e-13)
    assert down == pytest.approx(weight * (math.sin(angle) - mu * math.cos(angle)), rel=1e-12)
    assert (down < 0) == (math.tan(angle) < mu)


ARM, GUIDE = 0.09, 0.06


def drawer(mu: float) -> dict[str, Any]:
    """The slider-crank with its rod at an arm beside a short guide, in which the rod's force tilts the slider."""
    data = slider_crank(0.0, mu) | {"assembly": {"R": "ahead of B along guide"}}
    data["links"]["rod"]["points"] = {"B": [0, 0], "R": [160, 0]}
    data["links"]["slider"]["points"] = {"C": [0, 0], "R": [0, 1000 * ARM]}
    del data["friction"]["at_A"], data["friction"]["at_B"], data["friction"]["at_C"]
    return data


def test_a_drawer_jams_where_its_guide_is_too_short() -> None:
    """The rod's force S has S cos f = 1000 N + mu max(S |sin f|, 2 S arm cos f/l), until 2 mu arm = l."""
    t = 0.13  # the slider goes ahead, against the force
    theta = START + OMEGA * t
    phi = math.asin((ARM - CRANK * math.sin(theta)) / ROD)
    critical = math.cos(phi) / max(math.sin(phi), 2 * ARM * math.cos(phi) / GUIDE)
    for mu in (0.1, 0.3, 0.33):
        compiled = compiled_from(drawer(mu))
        speed, torque = compiled.evaluate(["guide.v", "motor.torque"], np.array([t]))[:, 0]
        assert speed > 0
        force = 1000 / (math.cos(phi) * (1 - mu / critical))
        arm = CRANK * math.sin(phi - theta)
        assert torque == pytest.approx(force * arm, rel=1e-10)
        assert np.isinf(followed(laws(compiled, np.array([t])))[0]).all()
    jammed = compiled_from(drawer(0.5))
    assert np.isnan(jammed.evaluate(["motor.torque"], np.array([t]))).all()  # no wrong figure in any study
    share = followed(laws(jammed, np.array([t])))[0][0]
    assert critical / 0.5 <= share <= critical / 0.5 + 1 / 64


def test_a_mechanism_that_jams_is_told() -> None:
    data = drawer(0.5) | {"studies": {"cycle": {"turns": "1 motor", "samples": 60}}}
    job = lw.run(lw.Document.model_validate(data))
    assert job.cycle is not None
    assert [finding.code for finding in job.cycle.failures] == ["friction.jams"]


def notes(data: dict[str, Any]) -> list[Any]:
    """What a cycle of 200 ms says of friction."""
    job = lw.run(lw.Document.model_validate(data | {"studies": {"cycle": {"duration": "0.2 s", "samples": 60}}}))
    assert job.cycle is not None
    assert not job.cycle.failures
    return [finding for finding in job.cycle.warnings if finding.code.startswith("friction.")]


@pytest.mark.parametrize("mu", [0.05, 0.15])
def test_self_locking_of_a_slider_crank(mu: float) -> None:
    """Between the dead centre and the pose in which the rod's line of force touches the circle about A the load drives
    the crank, and yet the drive has to push: before and behind both dead centres, on the side of the driving stroke."""
    data = slider_crank(mu, None, push=1000.0)
    run = lw.run(lw.Document.model_validate(data | {"studies": {"cycle": {"duration": "0.2 s", "samples": 60}}}))
    found = locked_stretches(run.cycle.result.run, "motor")
    zones = []
    for dead in (math.pi, 2 * math.pi):
        at = (dead - START) / OMEGA
        sign = 1 if dead < 4 else -1  # it drives from pi to 2 pi
        edge = brentq(lambda t: by_friction_circles(t, mu, 1000.0), at + sign * 1e-4, at + sign * 0.02)
        zones.append(sorted((at, edge)))
    assert found == [pytest.approx(zone, abs=1e-9) for zone in zones]
    (note,) = notes(data)
    assert (note.code, note.severity, note.data["count"]) == ("friction.self-locking", "note", 2)


@pytest.mark.parametrize(("angle", "mu", "up"), [(0.1, 0.3, False), (0.1, 0.3, True), (0.25, 0.1, False)])
def test_self_locking_of_a_slope(angle: float, mu: float, up: bool) -> None:
    """Down a slope below the angle of friction alone, all along."""
    found = notes(slope(angle, mu, up))
    assert [note.code for note in found] == (["friction.self-locking"] if not up and math.tan(angle) < mu else [])
    assert all(note.data["share"] == "100" for note in found)


@pytest.mark.parametrize("mu", [0.1, 0.5])
def test_a_drawer_has_one_force_or_two(mu: float) -> None:
    """Where the force pulls the drawer ahead, its friction is k |force - friction|: force k/(1 + k), and above k = 1
    also force k/(k - 1), that of a wedged drawer which the rod pushes ahead."""
    t = np.array([0.13])
    phi = math.asin((ARM - CRANK * math.sin(START + OMEGA * t[0])) / ROD)
    k = mu * max(abs(math.tan(phi)), 2 * ARM / GUIDE)
    data = drawer(mu)
    data["loads"]["resistance"]["force"] = 1000.0
    compiled = compiled_from(data)
    speed, effort = compiled.evaluate(["guide.v", "rail.force"], t)[:, 0]
    assert speed > 0
    assert effort == pytest.approx(-1000 * k / (1 + k), rel=1e-12)
    of = laws(compiled, t)
    assert several(of, followed(of)[1]).tolist() == [k > 1]
    if k > 1:
        wedged = np.array([[-1000 * k / (k - 1)]])
        assert np.abs(of.linear(wedged, 1.0)[0]).max() < 1e-9
        data["drives"]["motor"]["start"] = START + OMEGA * 0.125
        job = lw.run(lw.Document.model_validate(data | {"studies": {"cycle": {"duration": "0.01 s", "samples": 20}}}))
        assert job.cycle is not None
        assert "friction.several" in [one.code for one in job.cycle.warnings]


def test_two_ways_to_jam() -> None:
    """One law m = c |f + b m|: with f along b the effort grows to infinity at c |b| = 1; with f against b, and not
    quite in its line, the line m/c touches the hyperbola |f + b m| at a finite effort."""
    b, grows, meets_ = np.array([[[1.0], [0.0]]]), np.array([[1.0], [0.5]]), np.array([[-1.0], [0.5]])
    for f, expected in ((grows, False), (meets_, True)):
        of = Laws(np.array([[3.0]]), np.zeros((1, 1)), [[(f, b)]])
        share = followed(of)[0][0]
        assert np.isfinite(share)
        # Touching: (1/c^2 - 1) m^2 - 2 (b f) m - |f|^2 has a double root.
        critical = 1.0 if not expected else math.sqrt(1 / (1 - 1 / (1 + 0.25)))
        assert critical / 3 <= share <= critical / 3 + 1 / 64
        assert meets(of) is expected


@pytest.mark.parametrize("degrees", [15, 30])
@pytest.mark.parametrize("mu", [0.05, 0.15])
@pytest.mark.parametrize("ahead", [True, False])
def test_a_wedge_press(degrees: float, mu: float, ahead: bool) -> None:
    """A wedge between a base and a block on a wall, all three rubbing: P = Q tan(a + 2 phi) as it lifts the load Q, and
    Q tan(a - 2 phi) as it yields, which is negative where the wedge locks itself (Beer, Johnston, Statics, ch. 8)."""
    alpha, q = math.radians(degrees), 500.0
    data = {
        "linkwright": 1,
        "units": {"length": "mm", "angle": "rad", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"},
        "links": {
            "frame": {"points": {"O": [0, 0]}},
            "wedge": {"points": {"D": [0, 0]}},
            "block": {"points": {"S": [0, 0]}},
        },
        "joints": {
            "base": {"prismatic": ["frame", "wedge"], "line": ["O at 0", "D at 0"]},
            "face": {"prismatic": ["wedge", "block"], "line": [f"D at {math.pi - alpha}", f"S at {math.pi - alpha}"]},
            "wall": {"prismatic": ["frame", "block"], "line": ["O at 90 deg", "S at 90 deg"]},
        },
        "drives": {"press": {"slides": "wedge", "on": "frame", "speed": 10 if ahead else -10, "start": 0}},
        "loads": {"work": {"on": "block", "at": "S", "force": [0, -q]}},
        "friction": {f"{name}_f": {"slide": name, "coefficient": mu} for name in ("base", "face", "wall")},
    }
    phi = math.atan(mu) * (1 if ahead else -1)
    compiled = compiled_from(data)
    (force,) = compiled.evaluate(["press.force"], np.array([0.1, 0.4]))
    assert force == pytest.approx([q * math.tan(alpha + 2 * phi)] * 2, rel=1e-10)
    study = {"cycle": {"duration": "1 s", "samples": 20}}
    job = lw.run(lw.Document.model_validate(data | {"measures": {"eta": {"efficiency": ["work"]}}, "studies": study}))
    assert job.cycle is not None and job.exit_code == 0
    assert job.cycle.result.certificate.sound()
    ideal, real = math.tan(alpha), math.tan(alpha + 2 * phi)
    expected = ideal / real if ahead else real / ideal
    assert job.cycle.measures[0].shown() == pytest.approx(expected, rel=1e-9)
    locks = not ahead and alpha < 2 * math.atan(mu)
    assert ("friction.self-locking" in [one.code for one in job.cycle.warnings]) is locks
