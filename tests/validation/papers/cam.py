"""docs/zh/papers/cam.md: the sizes, Table 1, the curvature; the reversal by which the paper draws the profile."""

from __future__ import annotations

import math
import re
from functools import cache
from typing import Any

import numpy as np

import linkwright as lw
from helpers.heat_seal import performed
from linkwright.formulas.evaluate import value
from linkwright.model.document import plain
from linkwright.studies.cam.files import FILES
from validation.papers import GALLERY, Array, Rows, Tables, below, inputs, percent

SIZES: dict[str, float | str] = {"centres": 85, "base": 39, "roller": 20, "arm": 90, "swing": "12 deg"}
ANGLES = (90, 180, 75, 15)
ENDS = (6, 18, 23, 24)
"""Of the segments, s: Table 1, for a motor of 15 deg/s."""
CURVATURE, RADIUS = 0.045, 22.25
M = 12.0


def data() -> dict[str, Any]:
    """The gallery's model with its cam study, without NC code."""
    found = plain(lw.load(GALLERY / "cam.yaml"))
    found["studies"] = {"cam": {"period": found["studies"]["cam"]["period"]}}
    return found


@cache
def outcome(sense: str | None) -> Any:
    """Of the cam study; ``sense`` is that in which the arm rises, where it isn't the cam's."""
    found = data()
    if sense:
        found["cams"]["heat_seal"]["sense"] = sense
    return performed(found).cam


def figure(name: str, sense: str | None = None) -> float:
    """In SI."""
    return float(next(one.value for one in outcome(sense).figures if one.name == name))


def times() -> Rows:
    """What each segment turns and when it ends: (1) and Table 1, against the law of the model."""
    pieces = texts()
    ends = [stop for _, stop, _ in pieces]
    assert ends == [*ENDS]
    entries = data()["laws"]["lift"]["segments"]
    over = [entry.get("over", entry.get("dwell")) for entry in entries]
    assert over == [*ANGLES]
    return [[f"{angle}", f"{end}", f"{stop:g}"] for angle, end, stop in zip(ANGLES, ENDS, ends, strict=True)]


def texts() -> list[tuple[float, float, str]]:
    """The pieces of cam_motion.txt."""
    lines = str(FILES["cam_motion.txt"].make(outcome(None))).splitlines()
    found = (re.match(r"  (\d+) <= t <=? (\d+) +(.*)", line) for line in lines)
    return [(float(one[1]), float(one[2]), one[3]) for one in found if one]


def printed(t: Array) -> Array:
    """phi (deg) by Table 1."""
    rise, fall = t / 6, (t - 18) / 5

    def share(turn: Array) -> Array:
        return turn - np.sin(2 * math.pi * turn) / (2 * math.pi)

    return np.select([t < 6, t < 18, t < 23], [M * share(rise), M + 0 * t, M - M * share(fall)], 0.0)


def expressions() -> Rows:
    """The texts of cam_motion.txt, and how far they are from Table 1."""
    rows = []
    for start, stop, text in texts():
        t = np.linspace(start, stop, 200, endpoint=False)
        rows.append([f"`{text}`", below(value(text, t, degrees=True) - printed(t), 1e-12, "°")])
    return rows


def positions() -> Rows:
    """phi in some places: by Table 1, by the motion of the arm in the mechanism."""
    t = np.array([0.0, 1.5, 3.0, 4.5, 6.0, 12.0, 18.0, 20.5, 22.0, 23.0])
    run = lw.Run(lw.compile(lw.load(GALLERY / "cam.yaml")), 0.0, 24.0, 240)
    angle = np.degrees(run.evaluate(["arm.angle"], t)[0])
    ours = angle[0] - angle
    below(ours - printed(t), 1e-9)
    return [
        [f"{at:g}", f"{paper:.6f}", f"{found:.6f}"] for at, paper, found in zip(t, printed(t), abs(ours), strict=True)
    ]


def curvature() -> Rows:
    """The printed figures and both cams of these sizes: the arm rises as the cam turns, and against it."""
    other = "counter-clockwise"
    both = [[figure(name, sense) * size for sense in (None, other)] for name, size in EXTREMES]
    rows = []
    for paper, (one, two), text in zip((CURVATURE, RADIUS), both, ("{:.7f}", "{:.4f}"), strict=True):
        rows.append([f"{paper}", text.format(one), percent(one, paper), text.format(two), percent(two, paper)])
    assert abs(both[0][0] - CURVATURE) < 5e-5 and abs(both[1][0] - RADIUS) < 0.04
    return rows


EXTREMES = (("profile_curvature_max", 1e-3), ("profile_radius_min", 1e3))


def others() -> Rows:
    """What the paper doesn't print, of both cams."""
    rows = []
    for name, size, digits in (("pitch_radius_min", 1e3, 4), ("pressure_angle_max", math.degrees(1), 3)):
        rows.append([f"{figure(name, sense) * size:.{digits}f}" for sense in (None, "counter-clockwise")])
    return rows


def reversal() -> Rows:
    """The frame turns back about O and the arm swings by Table 1: the roller's centre, and the offset of its path."""
    head, *lines = str(FILES["cam_profile.csv"].make(outcome(None))).splitlines()
    names = [name.split(" [")[0] for name in head.split(",")]
    table = dict(zip(names, np.array([line.split(",") for line in lines], float).T, strict=True))
    start = math.acos((85**2 + 90**2 - 59**2) / (2 * 85 * 90))  # r_b + r_0 from O to B
    psi = start + np.radians(printed(table["theta"] / 15))
    centre = np.exp(1j * np.radians(table["theta"])) * (85 - 90 * np.exp(-1j * psi))
    pitch, profile = table["pitch x"] + 1j * table["pitch y"], table["profile x"] + 1j * table["profile y"]
    normal = table["normal x"] + 1j * table["normal y"]
    along = np.gradient(pitch)
    assert abs((normal.conj() * along).real / abs(along))[1:-1].max() < 1e-2
    return [[below(abs(centre - pitch), 1e-9, "mm")], [below(abs(profile + 20 * normal - pitch), 1e-9, "mm")]]


def tables() -> Tables:
    return {
        "inputs": inputs("cam", SIZES),
        "times": times(),
        "expressions": expressions(),
        "positions": positions(),
        "curvature": curvature(),
        "others": others(),
        "reversal": reversal(),
    }
