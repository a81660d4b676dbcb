"""Gears against textbooks and closed forms.

J. E. Shigley, C. R. Mischke, R. G. Budynas, Mechanical Engineering Design, 7th to 9th ed.: example 13-6 (a planetary
train of 20, 30 and 80 teeth, the sun at 100 rev/min: arm 20, planet 33.3 rev/min) and example 13-7 (pinion, idler and
gear of module 2.5 mm, 2.5 kW at 1750 rev/min: tangential 0.546 kN, radial 0.199 kN, tooth 0.581 kN, reaction of the
idler's shaft 0.347 kN along both axes, 0.491 kN in all). Forces have three digits: half a unit of the last one.

Willis' formula, the cardan gear's straight line, and a geared five-bar against two drives in the same ratio are exact.
"""

from __future__ import annotations

import copy
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from ruamel.yaml import YAML

import linkwright as lw
from helpers.compiled import compiled_from

EXAMPLES = Path(__file__).parents[2] / "examples"
UNITS = {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"}
TURN = 2 * np.pi


def example(name: str) -> Any:
    return YAML(typ="safe").load((EXAMPLES / f"{name}.yaml").read_text("utf-8"))


def values(data: Any, *signals: str, stop: float = 1.0, count: int = 41) -> Any:
    return compiled_from(data).evaluate([*signals], np.linspace(0.0, stop, count))


def test_a_planetary_train_turns_as_printed() -> None:
    """Clockwise is negative here."""
    data = example("planetary_train")
    data["parameters"] = {"m": 2, "z1": 20, "z2": 30, "z3": 80}
    data["assembly"] = {"P": [50, 0], "Q": [80, 0]}
    data["drives"]["motor"]["speed"] = "-100 rpm"
    arm, planet = values(data, "arm.omega", "planet.omega") * 60 / TURN
    assert arm == pytest.approx(-20.0, abs=1e-11)
    assert planet == pytest.approx(100 / 3, abs=1e-11)


def test_torques_of_a_planetary_train_are_those_of_its_power() -> None:
    """The sun's torque by the ratio, the tangential force by the arm's, the ring's as what is left for the frame."""
    data = example("planetary_train")
    for link in ("sun", "planet", "arm"):  # without inertia, so that all is constant
        data["links"][link] = {"points": data["links"][link]["points"]}
    torque, first, second, shaking = values(
        data, "motor.torque", "sun_planet.tangential", "planet_ring.tangential", "shaking.moment", stop=2.0
    )
    assert torque == pytest.approx(60 / (1 + 72 / 24), rel=1e-12)
    assert first == pytest.approx(60 / 0.096, rel=1e-12)
    assert np.abs(second) == pytest.approx(60 / 0.096, rel=1e-12)
    # Motor 15 N m on the sun and the load of -60 N m: the frame gets what both exert besides.
    assert shaking == pytest.approx(-60, rel=1e-12)


def test_an_idler_loads_its_shaft_as_printed() -> None:
    """Gear 2 below, gear 4 beside the idler 3, gear 2 clockwise: what separates one mesh eases the other one's pull."""
    torque = 2500 / (1750 * TURN / 60)
    data = {
        "linkwright": 1,
        "units": UNITS,
        "links": {
            "frame": {"points": {"A": [0, -87.5], "B": [0, 0], "C": [100, 0]}},
            "pinion": {"points": {"A": [0, 0]}},
            "idler": {"points": {"B": [0, 0]}},
            "gear": {"points": {"C": [0, 0]}},
        },
        "joints": {
            "first": {"gears": ["pinion", "idler"], "centres": ["A", "B"], "teeth": [20, 50], "module": 2.5},
            "second": {"gears": ["idler", "gear"], "centres": ["B", "C"], "teeth": [50, 30], "module": 2.5},
        },
        "drives": {"motor": {"turns": "pinion", "on": "frame", "speed": "-1750 rpm", "start": "0 deg"}},
        "loads": {"brake": {"on": "gear", "torque": torque * 30 / 20}},
    }
    names = ("first.tangential", "first.separating", "first.force", "force(idler, frame).x", "force(idler, frame).y")
    tangential, radial, tooth, x, y = values(data, *names)[:, 0] / 1e3
    assert abs(tangential) == pytest.approx(0.546, abs=0.0005)
    assert radial == pytest.approx(0.199, abs=0.0005)
    assert tooth == pytest.approx(0.581, abs=0.0005)
    assert sorted(np.abs([x, y])) == pytest.approx([0.347, 0.347], abs=0.0005)
    assert np.hypot(x, y) == pytest.approx(0.491, abs=0.0005)


def test_the_cardan_gear_guides_along_a_straight_line() -> None:
    """P at twice the crank's projection, E on an ellipse with the half axes 60 and 20 mm."""
    data = example("cardan_gear")
    angle, px, py, ex, ey = values(data, "motor.angle", "P.x", "P.y", "E.x", "E.y", stop=3.0)
    assert px == pytest.approx(0.08 * np.cos(angle), abs=1e-14)
    assert np.abs(py).max() / 0.16 < 1e-12
    assert (ex / 0.06) ** 2 + (ey / 0.02) ** 2 == pytest.approx(1.0, abs=1e-12)


def test_a_geared_five_bar_moves_as_two_drives_in_its_ratio() -> None:
    """The same motion, and the power of the one motor is that of both."""
    data = example("geared_five_bar")
    coupled = copy.deepcopy(data)
    coupled["joints"] = {"ratio": {"coupling": ["second", "frame"], "follows": "start_angle - motor.angle*z1/z2"}}
    coupled["parameters"]["start_angle"] = "atan2(43, 25)"
    coupled["assembly"] = {"C": [90, 165]}
    del coupled["measures"]["tooth_force"], coupled["measures"]["bearing"]
    names = ("C.x", "C.y", "C.ax", "second.angle", "motor.torque", "force(left, right).x")
    geared, driven = values(data, *names), values(coupled, *names)
    scale = np.abs(driven).max(axis=1, keepdims=True)
    assert geared / scale == pytest.approx(driven / scale, abs=1e-10)


def test_bearings_feel_the_pressure_angle_and_motors_do_not() -> None:
    data = example("geared_five_bar")
    torques, bearings = [], []
    del data["joints"]["mesh"]["module"]
    for angle in (0, 20, 25):
        data["joints"]["mesh"]["pressure_angle"] = f"{angle} deg"
        torque, x, y = values(data, "motor.torque", "force(frame, second).x", "force(frame, second).y")
        torques.append(torque)
        bearings.append(np.hypot(x, y).max())
    assert torques[0] == pytest.approx(torques[1], abs=1e-12)
    assert torques[0] == pytest.approx(torques[2], abs=1e-12)
    assert len({round(size, 6) for size in bearings}) == 3


def test_extremes_stand_at_the_kink_of_the_separating_force() -> None:
    """The least separating force is 0, where the tangential one changes its sign; the mean is that of dense samples."""
    data = example("geared_five_bar")
    data["measures"] = {"least": {"min": "mesh.separating"}, "mean": {"mean": "mesh.separating"}}
    job = lw.run(lw.Document.model_validate(data))
    assert job.exit_code == 0
    found = job.summary["measures"]
    assert found["least"]["value"] == pytest.approx(0.0, abs=1e-9)
    t = (np.arange(200_000) + 0.5) / 200_000
    dense = compiled_from(data).evaluate(["mesh.separating"], t)[0].mean()
    assert found["mean"]["value"] == pytest.approx(dense, rel=1e-8)


def test_friction_in_a_bearing_counts_the_separating_force() -> None:
    """T r = M + mu rho T/cos(alpha), of a wheel whose bearing carries the force of its teeth alone."""
    data = {
        "linkwright": 1,
        "units": UNITS,
        "links": {
            "frame": {"points": {"O": [0, 0], "M": [90, 0]}},
            "pinion": {"points": {"O": [0, 0]}},
            "wheel": {"points": {"M": [0, 0]}},
        },
        "joints": {"mesh": {"gears": ["pinion", "wheel"], "centres": ["O", "M"], "teeth": [20, 40]}},
        "drives": {"motor": {"turns": "pinion", "on": "frame", "speed": "60 rpm", "start": "0 deg"}},
        "loads": {"brake": {"on": "wheel", "torque": 12}},
        "friction": {"bearing": {"pin": "M", "radius": 15, "coefficient": 0.2}},
        "studies": {"cycle": {"duration": "1 s", "samples": 10}},
    }
    expected = 12 / (0.06 - 0.2 * 0.015 / np.cos(np.radians(20)))
    tangential, moment = values(data, "mesh.tangential", "bearing.moment")
    assert tangential == pytest.approx(expected, rel=1e-12)
    assert moment == pytest.approx(0.003 * expected / np.cos(np.radians(20)), rel=1e-12)
    assert lw.run(lw.Document.model_validate(data)).exit_code == 0


def test_a_point_of_a_rolling_wheel_follows_a_cycloid() -> None:
    """From its lowest place, by the way of the centre: x = c - r sin(c/r), y = r - r cos(c/r)."""
    centre, x, y = values(example("rolling_wheel"), "C.x", "P.x", "P.y")
    way = centre - 0.35
    assert x == pytest.approx(0.35 + way - 0.06 * np.sin(way / 0.06), abs=1e-13)
    assert y == pytest.approx(0.06 - 0.06 * np.cos(way / 0.06), abs=1e-13)


def test_a_disc_on_a_slope_needs_a_third_of_its_slope() -> None:
    """A uniform disc that rolls down under its weight needs mu = tan(slope)/3 (J. L. Meriam, L. G. Kraige, Engineering
    Mechanics: Dynamics, ch. 6): held to the acceleration that it then has, 2/3 g sin(slope), a drive exerts nothing."""
    slope = np.radians(30)
    rate = 2 / 3 * 9.80665 * np.sin(slope)
    data = {
        "linkwright": 1,
        "units": UNITS,
        "gravity": "earth",
        # A slide along the slope carries one across it without mass, on which the disc's centre is pinned.
        "links": {
            "frame": {"points": {"G": [0, 0]}},
            "along": {"points": {"H": [0, 0]}},
            "across": {"points": {"C": [0, 0]}},
            "disc": {"points": {"C": [0, 0], "P": [0, -50]}, "mass": 3, "shape": "disc 50 at C"},
        },
        "joints": {
            "way": {"prismatic": ["frame", "along"], "line": ["G at -30 deg", "H at 0 deg"]},
            "lift": {"prismatic": ["along", "across"], "line": ["H at 90 deg", "C at 90 deg"]},
            "ground": {"rolling": ["disc", "frame"], "centre": "C", "radius": 50, "on_line": "G at -30 deg"},
        },
        "assembly": {"C": [25, 43.3], "P": [25, -6.7]},
        "drives": {"push": {"slides": "along", "on": "frame", "acceleration": f"{rate} m/s^2", "speed": 0, "start": 0}},
    }
    force, normal, tangential = values(data, "push.force", "ground.normal", "ground.tangential", stop=0.5)
    assert force == pytest.approx(0.0, abs=1e-9)
    assert normal == pytest.approx(3 * 9.80665 * np.cos(slope), rel=1e-12)
    assert np.abs(tangential) / normal == pytest.approx(np.tan(slope) / 3, rel=1e-9)


def test_strands_of_a_belt_pull_along_lines_that_touch_both_wheels() -> None:
    """Radii 50 and 150 mm at 400 mm: sin(beta) = 1/4; strands F0 + T/2 and F0 - T/2 (300 N at rest) as vectors."""
    data = example("belt_drive")
    names = ("left", "right", "tangential")
    left, right, tangential = values(data, *(f"drive.{name}" for name in names))
    x, y, torque = values(data, "force(frame, pulley).x", "force(frame, pulley).y", "motor.torque")
    assert left + right == pytest.approx(600, rel=1e-12)
    assert left - right == pytest.approx(tangential, abs=1e-9)
    assert torque == pytest.approx(0.05 * tangential, abs=1e-12)  # the pulley turns evenly
    cosine, sine = np.sqrt(15) / 4, 1 / 4
    # From the small pulley the left strand rises to the large one, the right one falls; the bearing holds against both.
    assert x == pytest.approx(-(left + right) * cosine, rel=1e-12)
    assert y == pytest.approx(9.80665 - (left - right) * sine, rel=1e-9)


def test_the_reserve_of_a_belt_is_that_to_eytelweins_limit() -> None:
    """Where it is used up, the ratio of the strands is exp(mu phi), phi = pi - 2 beta on the small pulley."""
    data = example("belt_drive")
    limit = np.exp(0.4 * (np.pi - 2 * np.arcsin(1 / 4)))
    reserve, left, right = values(data, "drive.reserve", "drive.left", "drive.right")
    most = 600 * (limit - 1) / (limit + 1)
    assert reserve == pytest.approx(most - np.abs(left - right), rel=1e-12)
    assert (300 + most / 2) / (300 - most / 2) == pytest.approx(limit, rel=1e-12)


@pytest.mark.parametrize(("pretension", "codes"), [(300, []), (50, ["belt.slips"]), (20, ["belt.slack", "belt.slips"])])
def test_belts_that_slip_or_hang_are_warned_of(pretension: float, codes: list[str]) -> None:
    data = example("belt_drive")
    del data["require"]
    data["joints"]["drive"]["pretension"] = f"{pretension} N"
    job = lw.run(lw.Document.model_validate(data))
    assert job.exit_code == 0
    found = [finding["code"] for finding in job.summary["findings"]]
    assert sorted({*found} & {"belt.slips", "belt.slack"}) == sorted(codes)


def test_friction_in_bearings_counts_both_strands() -> None:
    """A chain between equal wheels: the bearing carries |T|, so T r = M + mu rho |T|. No force is across, so the law of
    the strands can't be read off the force."""
    data = {
        "linkwright": 1,
        "units": UNITS,
        "links": {
            "frame": {"points": {"O": [0, 0], "M": [200, 0]}},
            "first": {"points": {"O": [0, 0]}},
            "second": {"points": {"M": [0, 0]}},
        },
        "joints": {"chain": {"belt": ["first", "second"], "centres": ["O", "M"], "radii": [40, 40]}},
        "drives": {"motor": {"turns": "first", "on": "frame", "speed": "60 rpm", "start": "0 deg"}},
        "loads": {"brake": {"on": "second", "torque": -8}},
        "friction": {"bearing": {"pin": "M", "radius": 10, "coefficient": 0.2}},
    }
    tangential, moment = values(data, "chain.tangential", "bearing.moment")
    assert tangential == pytest.approx(8 / (0.04 - 0.002), rel=1e-12)
    assert np.abs(moment) == pytest.approx(0.002 * 8 / 0.038, rel=1e-12)
