"""docs/zh/papers/accuracy.md: the paper prints equations only; its coefficients, completed, by the gallery's model."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

import linkwright as lw
from linkwright.model.document import plain, replaced
from validation.papers import GALLERY, Array, Rows, Tables, below

EXAMPLE = GALLERY / "accuracy.yaml"
NAMES = ("l1", "l2", "l3", "l4", "phi1")
POSES = (0, 60, 120)
"""Of 121: phi1 = 90, 120, 150 deg."""


@cache
def study() -> Any:
    return lw.accuracy(EXAMPLE, ["rocker.angle", "coupler.angle"], samples=0)


@cache
def angles() -> Array:
    """phi1, phi2, phi3 over the run."""
    found: Array = study().run.evaluate(["crank.angle", "coupler.angle", "rocker.angle"], study().run.t)
    return found


def lengths() -> Array:
    return np.array([one.nominal for one in study().contributors.every])[:4]


def coefficients() -> Array:
    """dphi3 by l1 .. l4 (rad/m) and phi1: from (3), times exp(-i phi2), real part. (5, 121)"""
    l1, _, l3, _ = lengths()
    one, two, three = angles()
    above = [np.cos(one - two), 1 + 0 * one, -np.cos(three - two), -np.cos(two), l1 * np.sin(two - one)]
    return np.array(above) / (l3 * np.sin(two - three))


def ours(signal: str = "rocker.angle") -> Array:
    """linkwright's. (5, 121)"""
    assert tuple(study().contributors.names) == NAMES
    found: Array = study().curves[signal].coefficients
    return found


SIZES = np.degrees([1e-3] * 4 + [np.radians(1)])
"""deg/mm of a length, deg/deg of the crank's zero."""


def inputs() -> Rows:
    parameters = plain(lw.load(EXAMPLE))["parameters"]
    rows = []
    for name in NAMES:
        value, tolerance = parameters[name]["value"], parameters[name]["tolerance"]
        rows.append([str(value).replace(" deg", "°"), f"`{tolerance}`"])
    return rows


def equations() -> Rows:
    """(3); its derivative by l1 as printed; the same times exp(-i phi1), real part."""
    l1, l2, l3, l4 = lengths()
    one, two, three = angles()
    transmission = np.arccos(np.cos(two - three))
    assert round(float(np.degrees(transmission.min())), 1) == 45.4
    e1, e2, e3 = (np.exp(1j * angle) for angle in (one, two, three))
    by_l1 = ours("coupler.angle")[0], ours()[0]
    derivative = e1 + l2 * e2 * 1j * by_l1[0] - l3 * e3 * 1j * by_l1[1]
    real = 1 - l2 * np.sin(two - one) * by_l1[0] + l3 * np.sin(three - one) * by_l1[1]
    return [
        [below(l1 * e1 + l2 * e2 - l3 * e3 - l4, 1e-12, "m")],
        [below(derivative, 1e-11)],
        [below(real, 1e-11)],
    ]


def compared() -> Rows:
    """The transfer coefficients at three positions: by the formula, by linkwright."""
    formula, found = coefficients(), ours()
    below((formula - found) / np.abs(found).max(axis=0), 1e-13)
    rows = []
    for i, size in enumerate(SIZES):
        pairs = ((values[i, k] * size for values in (formula, found)) for k in POSES)
        rows.append([f"{value:.6f}" for pair in pairs for value in pair])
    return rows


def limits() -> Rows:
    """The local errors |dphi3/dq| delta of the largest deviations at three positions, their sum; linkwright's limit."""
    made = study().contributors
    half = (made.high - made.low) / 2
    parts = np.degrees(np.abs(coefficients()[:, POSES]) * half[:, None])
    worst = np.degrees(study().curves["rocker.angle"].worst[:, POSES])
    total = parts.sum(axis=0)
    below((worst[1] - worst[0]) / 2 - total, 1e-12)
    rows = [[f"{v:.6f}" for v in row] for row in parts]
    rows.append([f"{v:.6f}" for v in total])
    rows.append([f"{(high - low) / 2:.6f}" for low, high in worst.T])
    rows.append([f"{low:+.6f} .. {high:+.6f}" for low, high in worst.T])
    return rows


def first_order() -> Rows:
    """(1)'s difference itself and (2), deg, all deviations at their upper limits: what the higher terms amount to."""
    made = study().contributors
    shifted = {name: one.nominal + up for name, one, up in zip(NAMES, made.every, made.high, strict=True)}
    texts = {name: f"{value:.17g} {'rad' if name == 'phi1' else 'm'}" for name, value in shifted.items()}
    run = lw.Run(lw.compile(replaced(lw.load(EXAMPLE), texts)), 0.0, 1.0, 120)
    exact = np.degrees(run.evaluate(["rocker.angle"], study().run.t)[0] - angles()[2])[list(POSES)]
    linear = np.degrees(made.high @ ours())[list(POSES)]
    return [
        [f"{a:.6f}" for a in linear],
        [f"{b:.6f}" for b in exact],
        [f"{a - b:+.6f}" for a, b in zip(linear, exact, strict=True)],
    ]


def tables() -> Tables:
    return {
        "inputs": inputs(),
        "equations": equations(),
        "coefficients": compared(),
        "limits": limits(),
        "first-order": first_order(),
    }
