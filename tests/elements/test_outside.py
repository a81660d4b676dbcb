"""Kinds of joints of other packages: one file each, made known by an entry point, with no other file changed."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from helpers.outside import linkwright, planted, table, without_kinds

MODEL = {
    "linkwright": 1,
    "units": {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"},
    "links": {
        "frame": {"points": {"O": [0, 0]}},
        "sun": {"points": {"O": [0, 0], "S": [20, 0]}, "mass": 1, "shape": "disc 20 mm at O"},
        "arm": {"points": {"O": [0, 0], "P": [60, 0]}, "mass": 0.5, "shape": "rod O-P"},
        "planet": {"points": {"P": [0, 0], "Q": [40, 0]}, "mass": 2, "shape": "disc 40 mm at P"},
    },
    "parameters": {"z": {"value": 2, "tolerance": 0.01}},
    "joints": {"mesh": {"gear_on_carrier": ["sun", "planet", "arm"], "points": ["O", "P", "O"], "ratio": "z"}},
    "assembly": {"Q": [100, 0]},
    "drives": {
        "motor": {"turns": "arm", "on": "frame", "speed": "60 rpm", "start": 0},
        "hold": {"turns": "sun", "on": "frame", "position": "30 deg*sin(180 deg*t/(1 s))"},
    },
    "loads": {"pull": {"on": "planet", "at": "Q", "force": [10, 5]}},
    "measures": {"turned": {"extremes": "planet.angle"}},
    "studies": {"cycle": {"period": "2 s", "samples": 60}},
}
"""A planet on an arm, rolling about a sun that a second drive turns to and fro."""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "model.yaml").write_text(json.dumps(MODEL), encoding="utf-8")
    return tmp_path


def test_a_kind_from_outside_runs_and_is_proven(folder: Path) -> None:
    """Angles by the planet's kinematics, torques by Newton and Euler about the fixed and the moving centre."""
    done = linkwright(folder, "run", "model.yaml", "--out", "out", "--json")
    assert done.returncode == 0, done.stderr
    columns, t = table(folder / "out" / "cycle.csv")
    arm = 2 * np.pi * t
    sun = np.radians(30) * np.sin(np.pi * t)
    alpha_sun = -np.radians(30) * np.pi**2 * np.sin(np.pi * t)
    planet = arm - (sun - arm) / 2
    assert np.radians(columns["planet.angle [deg]"]) == pytest.approx(planet, abs=1e-11)
    # The mesh acts with m on the sun and ratio m on the planet, and with the opposite of both on the arm.
    q = np.array([60 * np.cos(arm) + 40 * np.cos(planet), 60 * np.sin(arm) + 40 * np.sin(planet)]) * 1e-3
    p = np.array([60 * np.cos(arm), 60 * np.sin(arm)]) * 1e-3
    pulled = (q - p)[0] * 5 - (q - p)[1] * 10
    m = (2 * 0.04**2 / 2 * (-alpha_sun / 2) - pulled) / 2
    assert columns["hold.torque [N*m]"] == pytest.approx(0.02**2 / 2 * alpha_sun - m, abs=1e-12)
    # At constant speed the inertia of the planet's centre has no moment about O.
    at_arm = p[0] * 5 - p[1] * 10
    assert columns["motor.torque [N*m]"] == pytest.approx(3 * m - at_arm, abs=1e-12)


def test_a_kind_from_outside_is_known_everywhere(folder: Path) -> None:
    checked = linkwright(folder, "check", "model.yaml")
    assert checked.returncode == 0
    assert "mesh: gears on a carrier" in checked.stdout
    assert "gear_on_carrier" in linkwright(folder, "schema").stdout
    limits = linkwright(folder, "limits", "model.yaml")
    assert limits.returncode == 0, limits.stderr
    modes = linkwright(folder, "modes", "model.yaml")
    assert modes.returncode == 0, modes.stderr
    refused = linkwright(folder, "export", "model.yaml", "--to", "mjcf")
    assert refused.returncode != 0
    assert "mesh (gears on a carrier)" in refused.stderr + refused.stdout
    assert "Traceback" not in checked.stderr + limits.stderr + modes.stderr + refused.stderr


def test_a_wrong_sign_in_a_kind_fails_the_certificate(folder: Path) -> None:
    mesh = (("(b.angle - c.angle)", "(c.angle - b.angle)"), ("(b.turn - c.turn)", "(c.turn - b.turn)"))
    planted(folder, "gear_on_carrier", *mesh)
    done = linkwright(folder, "run", "model.yaml", "--out", "out")
    assert done.returncode == 1
    assert "motion.unproven" in done.stderr


def test_an_entry_point_that_is_gone_leaves_the_kind_unknown(folder: Path) -> None:
    done = without_kinds(folder, "check", "model.yaml")
    assert done.returncode == 2
    assert "gear_on_carrier" in done.stderr
    assert "pin_in_slot" in done.stderr
