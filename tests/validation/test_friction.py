"""Friction against constructions of textbooks: friction circles, a slope that locks itself, a drawer that jams.

Friction circles (Beer, Johnston, Vector Mechanics for Engineers: Statics, ch. 8): a rod without mass passes its force
along a tangent of the circles of radius mu r about its pins. To 2e-10 N m of 50 N m: round-off.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import linkwright as lw
from helpers.compiled import compiled_from
from helpers.friction import SIZES, slider_crank
from linkwright.results.jamming import followed, laws

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
