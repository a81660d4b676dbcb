"""Theo Jansen's leg: pose and foot path. Sources and figures in data/jansen.json.

The published pose has two decimals and was solved from rounded figures: 0.01 of a length of 50. The own poses are
circle intersections in double precision, held to 1e-12 of the size.
"""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from helpers.compiled import compiled_from
from helpers.examples import UNITS
from linkwright.results.certificate import certify
from linkwright.results.run import Run
from linkwright.results.stationary import stationary

DATA: dict[str, Any] = json.loads((Path(__file__).parent / "data" / "jansen.json").read_text())
LENGTHS: dict[str, float] = DATA["lengths"]
POINTS = ("A", "C", "E", "D", "F", "G")


def apex(base: float, from_start: float, from_end: float) -> list[float]:
    """The third corner of a triangle on a base along x, to its left."""
    x = (from_start**2 - from_end**2 + base**2) / (2 * base)
    return [x, math.sqrt(from_start**2 - x * x)]


def leg(start: float = 0.0) -> dict[str, Any]:
    """The leg in its lengths a to m, which stand for metres here."""
    n = LENGTHS
    return {
        "linkwright": 1,
        "units": dict(UNITS),
        "links": {
            "frame": {"points": {"O": [0, 0], "B": [-n["a"], -n["l"]]}},
            "crank": {"points": {"O": [0, 0], "A": [n["m"], 0]}},
            "j": {"points": {"A": [0, 0], "C": [n["j"], 0]}},
            "k": {"points": {"A": [0, 0], "D": [n["k"], 0]}},
            "shoulder": {"points": {"B": [0, 0], "C": [n["b"], 0], "E": apex(n["b"], n["d"], n["e"])}},
            "c": {"points": {"B": [0, 0], "D": [n["c"], 0]}},
            "f": {"points": {"E": [0, 0], "F": [n["f"], 0]}},
            "foot": {"points": {"D": [0, 0], "F": [n["g"], 0], "G": apex(n["g"], n["i"], n["h"])}},
        },
        "assembly": {"C": "right of A-B", "D": "left of A-B", "F": "right of E-D"},
        "drives": {"motor": {"turns": "crank", "on": "frame", "speed": 1, "start": start}},
    }


def pose(crank: float) -> dict[str, list[float]]:
    compiled = compiled_from(leg(crank))
    rows = compiled.evaluate([f"{p}.{axis}" for p in POINTS for axis in "xy"], np.zeros(1))[:, 0].reshape(-1, 2)
    return {name: [float(x), float(y)] for name, (x, y) in zip(POINTS, rows, strict=True)}


def test_published_pose() -> None:
    published = DATA["published_pose"]
    found = pose(math.atan2(published["A"][1], published["A"][0]))
    for name in POINTS:
        assert found[name] == pytest.approx(published[name], abs=0.0125), name


@pytest.mark.parametrize(("own", "crank"), [("at0", 0.0), ("at90", math.pi / 2)])
def test_own_poses(own: str, crank: float) -> None:
    found = pose(crank)
    for name, expected in DATA["own"][own].items():
        assert found[name] == pytest.approx(expected, abs=1e-10), name


def test_foot_path_extents() -> None:
    """Root-found extremes of the foot over a turn; the own figures are of a fine sampling, 2e-5 short at most."""
    compiled = compiled_from(leg())
    run = Run(compiled, 0.0, 2 * math.pi, 100)
    names = ["G.x", "G.y"]
    times = stationary(lambda t: run.rates(names, t), run.start, run.stop, run.steps)
    x, y = (run.evaluate([name], t)[0] for name, t in zip(names, times, strict=True))
    extents = {"xmin": x.min(), "xmax": x.max(), "ymin": y.min(), "ymax": y.max()}
    for key, value in DATA["own"]["foot"].items():
        assert extents[key] == pytest.approx(value, abs=2e-5), key
        assert (extents[key] <= value + 1e-9) if key.endswith("min") else (extents[key] >= value - 1e-9)


def test_the_leg_is_proven_over_a_turn() -> None:
    certificate = certify(Run(compiled_from(leg()), 0.0, 2 * math.pi, 100))
    assert certificate.closure < 1e-13
    assert (certificate.mobility, certificate.gruebler, certificate.loops) == (1, 1, 3)
