"""docs/zh/papers/paper-feeder.md: the printed figures are those of data/paper_feeder.json, and these."""

from __future__ import annotations

from functools import cache

import numpy as np

import linkwright as lw
from validation.papers import GALLERY, Array, Rows, Tables, below, inputs, percent
from validation.test_paper_feeder import DATA, as_the_paper_read_them

LENGTHS: dict[str, float | str] = {"AB": 155, "BC": 395, "CD": 300, "DE": 500, "AD": 300, "AH": 580}
CHANGES = {  # the last rows of Tables 2 and 3
    "return": {"F61x": 608.78, "F61y": 647.37, "F32x": 591.83, "F32y": 650.88, "M0": 102.16},
    "feed": {"F61x": 308.43, "F61y": 162.51, "F32x": 296.61, "F32y": 162.90, "M0": 14.71},
}
THEORY = {246: -40.0, 24: 640.25}
"""Section 1.2.2: s_e (mm) by (7) and (11) at both limits, theta1 in whole degrees."""
THEORY_STROKE = 680.25
STEPS = np.linspace(0.0, 1.5, 201)
"""The paper's own."""


@cache
def run() -> lw.Run:
    return lw.Run(lw.compile(lw.load(GALLERY / "feeder.yaml")), 0.0, 1.5, 200)


@cache
def measures() -> dict[str, lw.MeasureResult]:
    return {one.name: one for one in lw.run(GALLERY / "feeder.yaml").cycle.measures}


def signals(*names: str, t: Array = STEPS) -> Array:
    """In SI."""
    return run().evaluate(list(names), t)


def points() -> Rows:
    """Table 1."""
    rows = []
    for name, printed in DATA["table_1_mm"].items():
        at = 1e3 * signals(f"{name}.x", f"{name}.y", t=np.zeros(1))[:, 0]
        off = max(abs(at - printed))
        assert off < 0.005
        rows.append(["({:g}, {:g}, 0)".format(*printed), "({:.4f}, {:.4f})".format(*at), f"{off:.4f}"])
    return rows


def crank_at(degrees: float) -> Array:
    """When theta1 is so large: the crank turns clockwise, from B of Table 1."""
    start = np.degrees(np.arctan2(61.78, 142.16))
    return np.array([((start - degrees) % 360) / 240])


def motion() -> Rows:
    """Section 1.2.2, in the order of the page."""
    found, paper = measures(), DATA["kinematics"]
    right, left = (found[f"{side}_limit_angle"] for side in ("right", "left"))
    start = 1e3 * signals("E.x", t=np.zeros(1))[0, 0]
    ends = 1e3 * signals("E.x", t=np.array([right.found[0].time, left.found[0].time]))[0]
    theory = {degrees: 1e3 * signals("E.x", t=crank_at(degrees))[0, 0] for degrees in THEORY}
    assert all(abs(theory[degrees] - printed) < 0.01 for degrees, printed in THEORY.items())
    assert round(1e3 * signals("E.x").min(), 3) == -39.999  # on the paper's steps
    stroke, speed = found["stroke"].shown(), found["feed_speed"].shown()
    return [
        [f"{paper['stroke_mm']}", f"{stroke:.4f}", f"{stroke - paper['stroke_mm']:+.3f}"],
        [f"{paper['x_max_mm']}", f"{start:.4f}", f"{start - paper['x_max_mm']:+.3f}"],
        [f"{paper['x_min_mm']}", f"{ends[1]:.4f}", f"{ends[1] - paper['x_min_mm']:+.3f}"],
        ["0.6", f"{left.found[0].time:.4f}", f"{left.found[0].time - 0.6:+.3f}"],
        [f"{paper['feed_speed_mm_s']}", f"{speed:.4f}", f"{speed - paper['feed_speed_mm_s']:+.3f}"],
        [f"{paper['right_limit_deg']}", f"{right.shown():.4f}", f"{right.shown() - 24:+.3f}"],
        [f"{paper['left_limit_deg']}", f"{left.shown():.4f}", f"{left.shown() - 246:+.3f}"],
        ["-40", f"{theory[246]:.4f}", f"{theory[246] + 40:+.3f}"],
        ["640.25", f"{theory[24]:.4f}", f"{theory[24] - 640.25:+.3f}"],
        [f"{THEORY_STROKE}", f"{theory[24] - theory[246]:.4f}", f"{theory[24] - theory[246] - THEORY_STROKE:+.3f}"],
    ]


def forces(window: str) -> Rows:
    """Table 2 or 3: minimum, maximum and change of each column."""
    found, read, rows = measures(), as_the_paper_read_them(), []
    for name, extremes in DATA["tables"][window].items():
        low, high = (found[f"{name}_{window}"].shown(label) for label in ("min", "max"))
        start, stop = (read[name, window, i] for i in (0, 1))
        printed = (*extremes, CHANGES[window][name])
        for paper, exact, step in zip(printed, (low, high, high - low), (start, stop, stop - start), strict=True):
            assert abs(exact / paper - 1) < 6e-3 and abs(step / paper - 1) < 6e-4
            rows.append([f"{paper:.2f}", f"{exact:.3f}", percent(exact, paper), f"{step:.2f}", percent(step, paper)])
    return rows


def formulas() -> Rows:
    """Equations (6), (7), (11), (12), (14) to (17), (19) to (22) as printed, but (6) in its quadrant."""
    l1, l2, l3, arm, l6, l5 = 0.155, 0.395, 0.5, 0.3, 0.3, 0.58
    t = np.linspace(0.0, 1.5, 1501)
    theta1, w1 = signals("crank.angle", "crank.omega", t=t)
    a, b = l6 - l1 * np.cos(theta1), -l1 * np.sin(theta1)
    c = (a**2 + b**2 + arm**2 - l2**2) / (2 * arm)
    theta3 = 2 * np.arctan((b + np.sqrt(a**2 + b**2 - c**2)) / (a - c))  # (7)
    theta2 = np.arctan2(b + arm * np.sin(theta3), a + arm * np.cos(theta3))  # (6)
    w3 = w1 * l1 * np.sin(theta1 - theta2) / (arm * np.sin(theta3 - theta2))  # (14)
    w2 = -w1 * l1 * np.sin(theta1 - theta3) / (l2 * np.sin(theta2 - theta3))  # (15)
    alpha3 = l2 * w2**2 + l1 * w1**2 * np.cos(theta1 - theta2) - arm * w3**2 * np.cos(theta3 - theta2)  # (19)
    alpha3 = alpha3 / (arm * np.sin(theta3 - theta2))
    alpha2 = arm * w3**2 - l1 * w1**2 * np.cos(theta1 - theta3) - l2 * w2**2 * np.cos(theta2 - theta3)  # (20)
    alpha2 = alpha2 / (l2 * np.sin(theta2 - theta3))
    sine, cosine = np.sin(theta3), np.cos(theta3)
    by_paper = {
        "coupler.angle": theta2,
        "rocker.angle": theta3,
        "E.x": l6 + l3 * cosine,  # (11)
        "AH - E.y": l5 - l3 * sine,  # (12)
        "rocker.omega": w3,
        "coupler.omega": w2,
        "E.vx": -w3 * l3 * sine,  # (16)
        "-E.vy": -w3 * l3 * cosine,  # (17)
        "rocker.alpha": alpha3,
        "coupler.alpha": alpha2,
        "E.ax": -alpha3 * l3 * sine - w3**2 * l3 * cosine,  # (21)
        "-E.ay": w3**2 * l3 * sine - alpha3 * l3 * cosine,  # (22)
    }
    units = {"angle": "rad", "omega": "rad/s", "alpha": "rad/s²", "x": "m", "y": "m"}
    units |= {"vx": "m/s", "vy": "m/s", "ax": "m/s²", "ay": "m/s²"}
    rows = []
    for name, values in by_paper.items():
        plain = name.removeprefix("AH").lstrip("- ")
        ours = signals(plain, t=t)[0]
        ours = 0.58 - ours if name.startswith("AH") else -ours if name.startswith("-") else ours
        bound = 1e-12 if plain.endswith((".angle", ".x", ".y")) else 1e-10
        off = np.sin((values - ours) / 2) * 2 if plain.endswith(".angle") else values - ours
        rows.append([f"`{name}`", below(off, bound, units[plain.split(".")[1]])])
    return rows


FORCES = [  # the column F_q of (39): M0, F12 .. M65; F36 is the force of link 3 on the ground, F45 that of 4 on 5
    "motor.torque",
    "force(crank, coupler).x",
    "force(crank, coupler).y",
    "force(crank, frame).x",
    "force(crank, frame).y",
    "force(coupler, rocker).x",
    "force(coupler, rocker).y",
    "force(rocker, slider).x",
    "force(rocker, slider).y",
    "force(rocker, frame).x",
    "force(rocker, frame).y",
    "force(slider, guide).x",
    "force(frame, guide).y",
    "force(frame, guide).moment",
]


def equations(forces: Array, corrected: bool) -> Array:
    """A1 F - B1 of (39) over the paper's steps (14, 201): as printed, or with its three slips put right."""
    (xa, ya), (xb, yb), (xc, yc), (xd, yd), (xe, ye) = (signals(f"{p}.x", f"{p}.y") for p in "ABCDE")
    x1, y1, x2, y2, x3, y3 = (xa + xb) / 2, (ya + yb) / 2, (xb + xc) / 2, (yb + yc) / 2, (xd + xe) / 2, (yd + ye) / 2
    a, b, c, d, e = (signals(f"{p}.ax", f"{p}.ay") for p in "ABCDE")
    masses, g, yf = (0.6, 1.5, 2.0, 1.0, 3.0), 9.80665, 0.58
    moved = ((a + b) / 2, (b + c) / 2, (d + e) / 2, e, e)
    f = [-mass * acceleration for mass, acceleration in zip(masses, moved, strict=True)]  # of inertia
    turned = signals("crank.alpha", "coupler.alpha", "rocker.alpha")
    inertias = [mass * length**2 / 12 for mass, length in zip(masses, (0.155, 0.395, 0.5), strict=False)]
    m1, m2, m3 = (-inertia * alpha for inertia, alpha in zip(inertias, turned, strict=True))
    weights = [mass * g for mass in masses]
    torque, f12x, f12y, f16x, f16y, f23x, f23y, f34x, f34y, f36x, f36y, f45, f65, m65 = forces
    sign = -1 if corrected else 1
    third = (y3 - yc) * f23x + (xc - x3) * f23y + (ye - y3) * f34x + (x3 - xe) * f34y
    rows = [
        -f12x - f16x + f[0][0],
        -f12y - f16y + f[0][1] - weights[0],
        torque + (yb - y1) * f12x + (x1 - xb) * f12y + sign * (y1 - ya) * f16x + (x1 - xa) * f16y + m1,
        f12x - f23x + f[1][0],
        f12y - f23y + f[1][1] - weights[1],
        (y2 - yb) * f12x + sign * (x2 - xb) * f12y + (yc - y2) * f23x + (x2 - xc) * f23y + m2,
        f23x - f34x - f36x + f[2][0],
        f23y - f34y - f36y + f[2][1] - weights[2],
        third + (yd - y3) * f36x + (x3 - xd) * f36y + m3,
        f34x - f45 + (f[3][0] if corrected else 0),
        f34y + f[3][1] - weights[3],
        f45 + f[4][0],
        f65 - weights[4],
        (yf - ye) * f45 + m65,
    ]
    return np.array(rows)


def solved_without_the_sliders_inertia() -> Array:
    """F32x over the steps by (39) with the signs put right and (33) as printed."""
    zero = np.zeros((14, STEPS.size))
    right = equations(zero, corrected=True)
    right[9] = 0
    unit = [zero + np.eye(14)[:, [i]] for i in range(14)]
    matrix = np.array([equations(one, corrected=True) - equations(zero, corrected=True) for one in unit])
    found = np.linalg.solve(matrix.transpose(2, 1, 0), -right.T[..., None])[..., 0].T
    return -found[5]


def slips() -> Rows:
    """Of (33) and of two elements of A1; the other rows hold as printed."""
    forces = signals(*FORCES)
    printed, corrected = (abs(equations(forces, which)).max(axis=1) for which in (False, True))
    assert corrected.max() < 1e-12
    rows = [[f"{printed[i]:.3f} {unit}"] for i, unit in ((9, "N"), (2, "N·m"), (5, "N·m"))]
    return [*rows, [below(np.delete(printed, [2, 5, 9]), 1e-12)]]


def without_inertia() -> Rows:
    """The largest F32x of Table 2 on the paper's steps: (33) as printed, and complete."""
    inside = STEPS < 0.6 + 1e-9
    printed = DATA["tables"]["return"]["F32x"][1]
    found = [solved_without_the_sliders_inertia()[inside].max(), signals("force(rocker, coupler).x")[0][inside].max()]
    return [[f"{printed:.2f}", f"{value:.2f}", percent(value, printed)] for value in found]


def tables() -> Tables:
    return {
        "inputs": inputs("feeder", LENGTHS),
        "table-1": points(),
        "motion": motion(),
        "table-2": forces("return"),
        "table-3": forces("feed"),
        "formulas": formulas(),
        "slips": slips(),
        "without-inertia": without_inertia(),
    }
