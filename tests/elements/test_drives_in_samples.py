"""Samples of mechanisms with drives without joints, paths, differentials, static friction: as files of their own."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from ruamel.yaml import YAML

import linkwright as lw

EXAMPLES = Path(__file__).parents[2] / "examples"
CASES: dict[str, tuple[str, tuple[float, ...], dict[str, Any], str]] = {
    "levelled_bucket": ("reach", (2300, 2500), {"length": {"max": "level.s"}, "force": {"max": "level.force"}}, "4 s"),
    "pick_and_place": ("stroke", (150, 210), {"torque": {"max": "left_motor.torque"}, "x": {"max": "P.x"}}, "1 s"),
    "phase_differential": ("r", (35, 45), {"torque": {"max": "trim.torque"}, "turn": {"min": "cage.alpha"}}, "1 s"),
    "lifting_crank": ("mu_s", (0.12, 0.2), {"first": {"max": "motor.breakaway_forward"}}, "1 s"),
}


@pytest.mark.parametrize("name", CASES)
def test_samples_are_files_of_their_own(name: str) -> None:
    parameter, values, measures, duration = CASES[name]
    data: dict[str, Any] = YAML(typ="safe").load((EXAMPLES / f"{name}.yaml").read_text(encoding="utf-8"))
    data |= {"measures": measures, "require": {}, "studies": {"cycle": {"duration": duration, "samples": 60}}}
    document = lw.Document.model_validate(data)
    outcome = lw.sweep(document, {parameter: list(values)})
    assert outcome.table is not None
    for k, value in enumerate(values):
        job = lw.run(document.replace(**{parameter: value}))
        assert job.cycle is not None
        alone = [found.value for measure in job.cycle.measures for found in measure.found]
        np.testing.assert_allclose(outcome.table.figures[:, k], alone, rtol=1e-7, atol=1e-9)
