"""docs/zh/papers/five-bar.md: the paper prints lengths, equations and drawings of the workspace, no areas."""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import numpy as np

import linkwright as lw
from linkwright.model.document import parse_document, plain
from linkwright.studies.workspace.outcome import Workspace
from validation.papers import GALLERY, Array, Rows, Tables, below, inputs
from validation.test_transfer_coefficients import by_the_paper

LENGTHS: dict[str, float | str] = {"l1": 8, "l2": 26, "l3": 28, "l4": 10, "l5": 30, "r2": 20}
L1, L2, L3, L4, L5, R2 = 8.0, 26.0, 28.0, 10.0, 30.0, 20.0
ALPHA = math.radians(60)
EXAMPLE = GALLERY / "five-bar.yaml"
TIMES = np.array([0.0, 0.4, 0.8, 1.2, 1.6])


def document(mode: str = "left") -> Any:
    """The gallery's model in one of its modes, its lengths and alpha with tolerances, whatever they are."""
    data = plain(lw.load(EXAMPLE))
    data["assembly"]["C"] = f"{mode} of B-D"
    data["parameters"] = {name: {"value": entry, "tolerance": 0.01} for name, entry in data["parameters"].items()}
    data["parameters"]["alpha"]["tolerance"] = "0.1 deg"
    found = parse_document(data)
    assert found is not None
    return found


@cache
def run(mode: str) -> lw.Run:
    return lw.Run(lw.compile(document(mode)), 0.0, 2.0, 180)


def discriminant(theta1: Array, theta4: Array) -> tuple[Array, Array, Array, Array]:
    """A + B, C and D of (5), and Delta of (6); mm."""
    a = L1**2 + L3**2 + L4**2 + L5**2 - L2**2
    b = 2 * L4 * L5 * np.cos(theta4) - 2 * L1 * L4 * np.cos(theta4 - theta1) - 2 * L1 * L5 * np.cos(theta1)
    c = 2 * L3 * L4 * np.cos(theta4) + 2 * L3 * L5 - 2 * L1 * L3 * np.cos(theta1)
    d = 2 * L3 * L4 * np.sin(theta4) - 2 * L1 * L3 * np.sin(theta1)
    return a + b, c, d, 4 * d**2 - 4 * (a + b + c) * (a + b - c)


def theta3(theta1: Array, theta4: Array, sign: float) -> Array:
    """By the roots of (5): theta3 = 2 arctan X."""
    ab, c, d, delta = discriminant(theta1, theta4)
    return np.asarray(2 * np.arctan((2 * d + sign * np.sqrt(delta)) / (2 * (ab + c))))


def working_point(theta1: Array, theta4: Array, sign: float) -> Array:
    """(7)."""
    u = theta3(theta1, theta4, sign) - ALPHA
    return np.array([L5 + L4 * np.cos(theta4) - R2 * np.cos(u), L4 * np.sin(theta4) - R2 * np.sin(u)])


def condition() -> Rows:
    """The condition of full rotation; (6) on all pairs of angles and the sine of the transmission angle in it; the
    drives that turn fully whatever the other does."""
    lengths = sorted((L1, L2, L3, L4, L5))
    short, rest = lengths[4] + lengths[0] + lengths[1], lengths[2] + lengths[3]
    assert short < rest
    turn = np.radians(np.arange(0.0, 360.0))
    delta = discriminant(turn[:, None], turn[None])[3]
    smallest = math.degrees(math.asin(math.sqrt(float(delta.min())) / (4 * L2 * L3)))
    every = [one for workspace in workspaces().values() for one in workspace.turning]
    assert len(every) == 2 * len(workspaces()) and all(one.whole for one in every)
    return [[f"{short:g} < {rest:g}"], [f"{delta.min():.0f}"], [f"{smallest:.5f}"], ["是"], ["是"]]


def points() -> Rows:
    """(7) for both roots of (5), and the point by linkwright in both modes; mm."""
    rows: Rows = []
    for mode, sign in (("left", -1.0), ("right", 1.0)):
        one, four, x, y = run(mode).evaluate(["crank1.angle", "crank4.angle", "P.x", "P.y"], TIMES)
        paper, ours = working_point(one, four, sign), 1e3 * np.array([x, y])
        below(paper - ours, 1e-10)
        for k in range(TIMES.size):
            places = ["({:.4f}, {:.4f})".format(*found[:, k]) for found in (paper, ours)]
            rows.append([*(f"{math.degrees(angle[k]):.3f}" for angle in (one, four)), *places])
    return rows


@cache
def workspaces() -> dict[int, Workspace]:
    outcome = lw.workspace(EXAMPLE)
    assert not outcome.failures and not outcome.warnings
    return {round(math.degrees(one.values["alpha"])): one for one in outcome.workspaces}


def regions() -> Rows:
    """Areas (mm2) with their bounds, holes, and the extent (mm) of both modes."""
    rows: Rows = []
    for one in workspaces().values():
        for region in one.regions:
            proven, drawn = region.region.certificate, region.figures
            assert proven.certified and proven.area is not None and proven.holes
            x, y = (f"{drawn.bounds[i] * 1e3:.2f} .. {drawn.bounds[i + 2] * 1e3:.2f}" for i in (0, 1))
            low, high = (1e6 * bound for bound in proven.area)
            rows.append([f"{drawn.area * 1e6:.3f}", f"{low:.3f} .. {high:.3f}", f"{drawn.holes}", x, y])
    return rows


def overlaps() -> Rows:
    """What both modes reach."""
    found = {alpha: one.overlaps[0].shape for alpha, one in workspaces().items()}
    return [["是" if shape.is_empty else "否", f"{shape.area * 1e6:.3f}"] for shape in found.values()]


POSE = 36
"""Of 180: t = 0.4 s."""


@cache
def slopes() -> tuple[Array, Array, Array]:
    """By l1 .. l5, alpha, r2: the derivatives of x, y (mm/mm, mm/rad) by (10), and linkwright's; those of theta3 by
    l1 .. l5 (rad/mm), in closed form and linkwright's."""
    found = lw.accuracy(document(), ["P.x", "P.y", "link3.angle"], samples=0)
    names = found.contributors.names
    links = ["crank1.angle", "link2.angle", "link3.angle", "crank4.angle"]
    one, two, three, four = found.run.evaluate(links, found.run.t)[:, POSE]
    three -= math.pi
    turns = np.array([np.cos(one - two), 1, np.cos(three - two), -np.cos(four - two), -np.cos(two)])
    turns = turns / (L3 * np.sin(three - two))
    paper = by_the_paper(float(three), ALPHA, R2, float(four), turns)
    order = [names.index(name) for name in ("l1", "l2", "l3", "l4", "l5", "alpha", "r2")]
    size = np.array([1, 1, 1, 1, 1, 1e3, 1])
    ours = [found.curves[name].coefficients[order, POSE] * size for name in ("P.x", "P.y")]
    angle = found.curves["link3.angle"].coefficients[order[:5], POSE] / 1e3
    return paper, np.array(ours), np.array([turns, angle])


def coefficients() -> Rows:
    """(10) and linkwright's transfer coefficients."""
    paper, ours, angle = slopes()
    below(paper - ours, 1e-10)
    below(angle[0] - angle[1], 1e-12)
    turns = [[f"{v:.6f}" for v in column] for column in angle.T] + [["–", "–"]] * 2
    pairs = zip(*paper, *ours, strict=True)
    return [
        [*turn, *(f"{v:.6f}" for v in (px, ox, py, oy))] for turn, (px, py, ox, oy) in zip(turns, pairs, strict=True)
    ]


def slips() -> Rows:
    """What the scan has in (10) and (13), and what is right: dx/dr2, dy/dl4, dx/dalpha."""
    paper, _, angle = slopes()
    one, four = run("left").evaluate(["crank1.angle", "crank4.angle"], np.array([0.4]))
    u = float(theta3(one, four, -1.0)[0]) - ALPHA
    read = [-R2 * math.cos(u), math.sin(four[0]) - R2 * math.sin(u) * angle[0][3], R2 * math.sin(u)]
    right = [paper[0, 6], paper[1, 3], paper[0, 5]]
    return [[f"{a:.6f}", f"{b:.6f}"] for a, b in zip(read, right, strict=True)]


def tables() -> Tables:
    return {
        "inputs": inputs("five-bar", LENGTHS),
        "condition": condition(),
        "points": points(),
        "regions": regions(),
        "overlaps": overlaps(),
        "coefficients": coefficients(),
        "slips": slips(),
    }
