"""The hot-melt cam of a strapping machine: Zhang, Fu, Gao, 'A quickly entity modeling method for planar cam based on
Pro/Mechanism' (2012): distance 85 mm, base circle 39 mm, roller 20 mm, arm 90 mm, swing 12 deg; cycloidal rise in 90
deg, dwell of 180 deg, cycloidal return in 75 deg, dwell of 15 deg.

Printed are a largest curvature of the profile of 0.045 1/mm and a least radius of 22.25 mm; that is the cam whose arm
swings in the sense of its turn. The digits below are of an independent computation of both senses (mpmath, 30 digits,
from the curvature of the reversal construction); tolerances are half a unit of the last digit.
"""

from __future__ import annotations

import numpy as np
import pytest

from helpers.heat_seal import EXAMPLE, heat_seal, performed
from linkwright.app.job import examine_file, perform
from linkwright.cam.nc.posts import POSTS


def test_the_example_and_its_nc_code() -> None:
    """The printed figures; the file of each control makes the lift within the tolerance, and holds no gouge."""
    job = perform(examine_file(EXAMPLE))
    assert job.exit_code == 0
    entry = job.summary["cam"]
    found = {name: figure["value"] for name, figure in entry["figures"].items()}
    assert found["profile_curvature_max"] == pytest.approx(0.045, abs=5e-5)  # as printed
    assert found["profile_radius_min"] == pytest.approx(22.25, abs=0.04)  # printed; 1/0.045 = 22.22
    assert found["profile_curvature_max"] == pytest.approx(0.0450156, abs=5e-8)
    assert found["profile_radius_min"] == pytest.approx(22.2145, abs=5e-5)
    assert found["pitch_radius_min"] == pytest.approx(42.2145, abs=5e-5)
    assert found["pressure_angle_max"] == pytest.approx(44.325, abs=5e-4)
    assert found["radius_min"] == pytest.approx(39, abs=1e-12)
    assert found["radius_max"] == pytest.approx(55.852, abs=5e-4)
    assert {*entry["nc"]} == {*POSTS}
    for made in entry["nc"].values():
        assert made["written"] and 0 < made["lift_error"] < made["tolerance"]
        assert 0 < made["gouge_mm"] < 0.004  # the tolerance of 0.002 deg at the arm's 90 mm is 0.0031 mm
    assert job.cam is not None and job.cam.smallest is not None
    smaller = heat_seal({"base": job.cam.smallest * 1e3 * (1 - 1e-6)}, limits={"pitch_over_roller": 2})
    assert [f.code for f in performed(smaller).found] == ["cam.limit"]


def test_the_sense_that_the_text_describes() -> None:
    """The arm swings against the cam."""
    job = performed(heat_seal({"sense": "counter-clockwise"}))
    assert job.cam is not None
    found = {figure.name: figure.value for figure in job.cam.figures}
    assert found["profile_curvature_max"] * 1e-3 == pytest.approx(0.0669892, abs=5e-8)
    assert found["profile_radius_min"] * 1e3 == pytest.approx(14.9278, abs=5e-5)
    assert found["pitch_radius_min"] * 1e3 == pytest.approx(34.9278, abs=5e-5)
    assert np.degrees(found["pressure_angle_max"]) == pytest.approx(41.904, abs=5e-4)
