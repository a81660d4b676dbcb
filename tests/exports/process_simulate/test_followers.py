"""Followers of cams as text in the camshaft's angle: read by Python itself, against closed forms and the solver."""

from __future__ import annotations

import math
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import linkwright as lw
from helpers.cams import pair
from linkwright.compilation import compile_mechanism
from linkwright.exports.process_simulate.evaluator import NotInDialect, read

EXAMPLES = Path(__file__).parents[3] / "examples"


def read_by_python(done: Any, driving: str, value: float) -> dict[str, float]:
    """The joints' values where the driving joint has one: the texts are Python's as well, but for (-1)(x)."""
    values = {driving: value}
    known: dict[str, Any] = {"T": values.__getitem__, "D": values.__getitem__, "sin": math.sin, "cos": math.cos}
    for name, text in done.summary["functions"].items():
        values[name] = float(eval(text.replace("(-1)(", "(-1)*("), known | {joint: joint for joint in values}))
    return values


@pytest.mark.parametrize("dialect", ["seed", "wizard"])
def test_a_follower_by_its_law(dialect: str) -> None:
    """The example of the strapping machine, which turns clockwise: 12 deg up by a cycloid in 90 deg, 180 deg of rest,
    down in 75 deg."""
    done = lw.export(EXAMPLES / "heat_seal_cam.yaml", "process-simulate", dialect=dialect)
    assert done.summary["max_error"] < 1e-8
    for turned in (0, 10, 45, 89, 91, 200, 269, 271, 300, 344, 346, 359):
        up, down = np.clip([turned / 90, (turned - 270) / 75], 0, 1)
        lift = up - down - (np.sin(2 * np.pi * up) - np.sin(2 * np.pi * down)) / (2 * np.pi)
        found = read_by_python(done, "O", math.radians(360 - turned))["A"]  # the range is one turn up from the start
        assert found == pytest.approx(-math.radians(12) * lift, abs=1e-8)


@pytest.mark.parametrize("guide", ["swinging", "sliding"])
def test_any_pair_by_the_solver(guide: str) -> None:
    """Both senses and sides, the motor counted the other way, the joint flipped, other zeros and ranges."""
    ways = product((1, -1), (1, -1), (False, True))
    for (side, sense, inverted), dialect in zip(ways, ["seed", "wizard"] * 4, strict=True):
        model = lw.Document.model_validate(pair(guide, "roller", side, sense, inverted))
        options: dict[str, Any] = {"dialect": dialect, "zero": 0.9, "range": [-2.0, 3.5]}
        options |= {"flipped": ["shaft"]} if side < 0 else {}
        done = lw.export(model, "process-simulate", **options)
        c = compile_mechanism(model)
        start, speed = (-0.3, -7.0 * sense) if inverted else (0.3, 7.0 * sense)
        signal, size = ("arm.angle", 1.0) if guide == "swinging" else ("guide.s", -1000.0)  # from the arm to the frame
        for motor in np.linspace(-2.0, 3.5, 9):
            at, zero = c.evaluate([signal], (np.array([motor, 0.9]) - start) / speed)[0]
            counted = (motor - 0.9) * (-1.0 if inverted else 1.0) * (-1.0 if side < 0 else 1.0)
            found = read_by_python(done, "shaft", counted)["A" if guide == "swinging" else "guide"]
            assert found == pytest.approx(size * (at - zero), abs=2e-8)


def test_what_hangs_on_a_follower() -> None:
    """All of the example's linkage within the proof; the slide's stroke is that of the run."""
    done = lw.export(EXAMPLES / "cam_linkage.yaml", "process-simulate", longest=190)
    assert done.summary["max_error"] < 1e-8
    assert done.summary["limits"]["guide"]["high"] == pytest.approx(49.75125, abs=1e-5)
    assert max(map(len, done.summary["functions"].values())) <= 190
    assert "comparison" in done.files["joint_functions.txt"]


def test_a_formula_of_the_file_becomes_polynomials() -> None:
    data = pair("sliding", "knife")
    rise = {"rise": 0.008, "over": 2, "formula": "0.5 - 0.5*cos(pi*sin(pi/2*u)^2)"}
    data["laws"]["lift"]["segments"] = [rise, {"fall": 0.008, "over": 2, "law": "poly_345"}, {"dwell": 2 * math.pi - 4}]
    done = lw.export(lw.Document.model_validate(data), "process-simulate")
    assert done.summary["max_error"] < 1e-8


def test_comparisons_stand_in_brackets() -> None:
    at = {"j": np.array([0.4, 0.5])}
    assert read("(T(j)>=0.5)*3+(T(j)<0.5)", "seed", {"j": "T"})(at).tolist() == [1.0, 3.0]
    for text in ("T(j)>=0.5", "(T(j)>0.5)", "(T(j)=0.5)", "(0.1<T(j)<0.5)"):
        with pytest.raises(NotInDialect):
            read(text, "seed", {"j": "T"})
