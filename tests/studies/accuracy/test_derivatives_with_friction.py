"""Derivatives of measures with friction, by dimensions and by the coefficient, against differences of many samples."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from ruamel.yaml import YAML

from helpers.compiled import compiled_from
from linkwright.kernels.parameter_batch import Varied
from linkwright.reductions import kind_of
from linkwright.results import Run
from linkwright.studies.accuracy.derivatives import Derivatives
from linkwright.studies.accuracy.signal_sensitivities import Slopes
from linkwright.studies.batch_plan import Measuring

EXAMPLE = Path(__file__).parents[3] / "examples" / "slider_crank_friction.yaml"
NAMES = ["r", "l", "mu"]
MEASURES: dict[str, Any] = {
    "largest": {"max": "motor.torque", "window": "part"},
    "given": {"mean": "motor.power"},
    "reaction": {"rms": "force(frame, crank).x"},
    "efficiency": {"efficiency": ["work"]},
    "stroke": {"efficiency": ["work"], "window": "out"},
    "share": {"share": ["rail", "bearing_B"], "useful": ["work"]},
}
OFFSETS, WEIGHTS = np.array([-2, -1, 1, 2]), np.array([1, -8, 8, -1]) / 12  # differences of fourth order


def test_they_are_slopes_of_the_measures() -> None:
    """Signs of velocities change, and the load's window with them, at times that depend on nothing but the drive here;
    forces jump there, and the measures go on with the dimensions."""
    data = YAML(typ="safe").load(EXAMPLE.read_text("utf-8"))
    data["measures"], data["windows"]["part"] = MEASURES, ["0.3 s", "0.45 s"]
    compiled = compiled_from(data)
    run, varied = Run(compiled, 0.0, 0.5, 120), Varied(compiled, NAMES)
    start = np.array([compiled.quantities.parameters[name] for name in NAMES])
    directions = varied.parameters(start[:, None] + np.eye(3)) - compiled.parameters[:, None]
    derivatives = Derivatives(run, Slopes(run, directions))
    steps = 2e-4 * start
    shifts = (steps[:, None] * OFFSETS)[None] * np.eye(3)[:, :, None]
    many = Measuring(varied, run).evaluate(varied.parameters((start[:, None, None] + shifts).reshape(3, -1)))
    for name, measure in compiled.mechanism.measures.items():
        for one, label in zip(derivatives.of(name), kind_of(measure).labels, strict=True):
            values = many.figures[name][label].values.reshape(3, -1)
            expected = values @ WEIGHTS / steps * start
            size = np.abs(expected).max()
            assert one.sides[:, 0] * start / size == pytest.approx(expected / size, abs=2e-7), name
