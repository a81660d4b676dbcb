"""The paper feeder integrated in time by Exudyn, the crank's speed prescribed, against the kinetostatics.

The model is that of benchmarks/feeder_exudyn.py. Exudyn's error, measured against the Newton-Euler equations, falls
with the square of the step (Newmark, index 2): 0.013 N at 500 steps over 0.6 s, 0.005 N at 1000, 0.001 N at 2000, of
forces up to 525 N; torque 0.0007 N m of 62. The test takes 1000 steps and allows some twice that.
"""

from __future__ import annotations

import numpy as np
import pytest
from feeder_exudyn import PINS, Model

from helpers.compiled import compiled_from
from helpers.examples import feeder

pytest.importorskip("exudyn")

END, STEPS = 0.6, 1000
FORCE, TORQUE = 0.012, 0.002


@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_reactions_and_torque_of_the_paper_feeder() -> None:
    model = Model()
    for name in (*PINS, "slide", "motor"):
        model.sense(name)
    model.run(END, STEPS)
    compiled = compiled_from(feeder())
    t = model.stored("A")[:, 0]
    assert t.size == STEPS
    for pin, links in PINS.items():
        expected = compiled.evaluate([f"force({links}).{axis}" for axis in "xy"], t)
        # Exudyn states the force on the joint's first marker, of the second link on the first.
        assert np.abs(model.stored(pin)[:, 1:3].T + expected).max() < FORCE, pin
    slide, torque = compiled.evaluate(["force(guide, slider).x", "motor.torque"], t)
    assert np.abs(model.stored("slide")[:, 1] + slide).max() < FORCE
    assert np.abs(model.stored("motor")[:, 1] + torque).max() < TORQUE
    assert np.abs(torque).max() > 60
