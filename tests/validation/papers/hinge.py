"""docs/zh/papers/hinge.md: the paper prints no dimensions; its equations by the gallery's, against the solver."""

from __future__ import annotations

import math
from functools import cache

import numpy as np

import linkwright as lw
from linkwright.model.document import parse_document, plain
from validation.papers import GALLERY, Array, Rows, Tables, below, inputs
from validation.test_joint_functions_of_a_hinge import CROSSED, FRONT, OPEN, TURN, Printed, motion

COORDINATES: dict[str, float | str] = {"x1": 60, "x2": 95, "z2": 70, "x3": -20, "z3": 110}
HINGE = 60.0, (95.0, 70.0), (-20.0, 110.0)


def leaning(x: float, z: float) -> float:
    """alpha_0 in its quadrant."""
    return math.atan2(z, -x)


@cache
def exported() -> lw.Exported:
    """With the senses of the paper: j2 and j4 are positive as the bonnet opens."""
    return lw.export(lw.load(GALLERY / "hinge.yaml"), "process-simulate", flipped=["O", "C"])


@cache
def run() -> lw.Run:
    """T(j2) rises evenly, from 0 to 35 deg in 4 s."""
    data = plain(lw.load(GALLERY / "hinge.yaml"))
    data["drives"]["hinge"]["position"] = "sketch - opening*t/(4 s)"
    document = parse_document(data)
    assert document is not None
    return lw.Run(lw.compile(document), 0.0, 4.0, 70)


def signals(*names: str) -> Array:
    return run().evaluate(list(names), run().t)


def quantities() -> Rows:
    """(1) to (7), and the same measured in the mechanism in its closed pose: mm and rad."""
    paper = Printed(*HINGE)
    o, f, c, b = (signals(f"{p}.x", f"{p}.y")[:, 0] * 1e3 for p in "OFCB")
    rear, front, panel = signals("rear.angle", "front.angle", "panel.angle")[:, 0]
    lengths = [float(np.hypot(*(q - p))) for p, q in ((o, f), (f, c), (c, b), (o, b))]
    found = [*lengths, math.pi - rear, math.pi + panel - rear, math.pi - (front - panel)]
    stated = [paper.l0, paper.l1, paper.l2, paper.l3, paper.alpha0, paper.beta0, paper.gamma0]
    return [[f"{a:.9f}", f"{b:.9f}", below(a - b, 1e-9)] for a, b in zip(stated, found, strict=True)]


def functions() -> Rows:
    """T(j4) by (15) and T(j3) by (13), deg, against the turns of the links; every 5 deg of T(j2)."""
    paper = Printed(*HINGE)
    rear, front, panel = (one - one[0] for one in signals("rear.angle", "front.angle", "panel.angle"))
    below(-rear - TURN, 1e-12)
    columns = (paper.gamma(TURN), panel - front, paper.beta(TURN), panel - rear)
    below(columns[0] - columns[1], 1e-12)
    below(columns[2] - columns[3], 1e-12)
    texts = exported().summary["functions"]
    names = {"T(j2)": "T2"}
    for name, column in (("j4", columns[0]), ("j3", columns[2])):
        text = texts[name].replace("T(j2)", names["T(j2)"])
        below(eval(text, {"acos": np.arccos, "sqrt": np.sqrt, "cos": np.cos, "T2": TURN}) - column, 1e-8)
    every = np.degrees(np.array([TURN, *map(abs, columns)])).T[::10]
    return [[f"{row[0]:.0f}", *(f"{v:.6f}" for v in row[1:])] for row in every]


def places() -> Rows:
    """(11), (12), mm: B and the diagonal l4, over the range."""
    paper, alpha = Printed(*HINGE), TURN + Printed(*HINGE).alpha0
    bx, by, fx, fy = signals("B.x", "B.y", "F.x", "F.y") * 1e3
    return [
        [below(bx + paper.l3 * np.cos(alpha), 1e-10, "mm")],
        [below(by - paper.l3 * np.sin(alpha), 1e-10, "mm")],
        [below(np.hypot(bx - fx, by - fy) - paper.diagonal(TURN), 1e-10, "mm")],
    ]


def texts() -> Rows:
    """The joint functions as written, and their largest deviation from the solver, rad."""
    summary = exported().summary
    return [[f"`{text}`", f"{summary['joints'][name]['error']:.1e}"] for name, text in summary["functions"].items()]


def constants() -> Rows:
    """The numbers of T(j4)'s text by the paper's names."""
    paper = Printed(*HINGE)
    two = 2 * paper.l1 * paper.l2
    found = {
        "a": paper.alpha0,
        "b": math.pi - paper.gamma0,
        "c": -(paper.l0**2 + paper.l3**2 - paper.l1**2 - paper.l2**2) / two,
        "d": 2 * paper.l0 * paper.l3 / two,
    }
    text = exported().summary["functions"]["j4"]
    assert all(f"{number:.9f}" in text for number in found.values())
    return [[f"{number:.9f}"] for number in found.values()]


ARRANGEMENTS = (OPEN, FRONT, CROSSED)


def arrangements() -> Rows:
    """How far the equations are from the solver, in three hinges: as printed, and put right."""
    rows = []
    for hinge in ARRANGEMENTS:
        as_printed, right = Printed(*hinge), Printed(*hinge, alpha0=leaning)
        _, solver = motion(*hinge)
        first, second = right.betas(right.diagonal(TURN))
        with np.errstate(invalid="ignore"):
            cases = [
                (as_printed.gamma(TURN), solver["j4"]),
                (right.gamma(TURN), solver["j4"]),
                (right.beta(TURN), solver["j3"]),
                (abs(first - second) - right.beta0, solver["j3"]),
                (right.beta16(TURN), solver["j3"]),
                (right.beta16(TURN, -1.0), solver["j3"]),
            ]
        rows.append([worst(abs(formula) - abs(turn)) for formula, turn in cases])
    return rows


def worst(off: Array) -> str:
    """The largest deviation in degrees, or that there is no real number."""
    if np.isnan(off).any():
        return "无实数值"
    largest = np.degrees(abs(off).max())
    return f"{largest:.3f}°" if largest > 1e-3 else below(largest, 1e-10, "°")


def at_zero() -> Rows:
    """T(j3) by (16) in the closed pose, deg: as printed, and put right."""
    paper = Printed(*HINGE)
    return [[f"{abs(np.degrees(paper.beta16(TURN, sign)[0])):.4f}°"] for sign in (1.0, -1.0)]


def tables() -> Tables:
    return {
        "inputs": inputs("hinge", COORDINATES),
        "quantities": quantities(),
        "functions": functions(),
        "places": places(),
        "texts": texts(),
        "constants": constants(),
        "arrangements": arrangements(),
        "at-zero": at_zero(),
    }
