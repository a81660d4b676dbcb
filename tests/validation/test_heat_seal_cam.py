"""The hot-melt cam of a strapping machine: Zhang, Fu, Gao, 'A quickly entity modeling method for planar cam based on
Pro/Mechanism' (2012): distance 85 mm, base circle 39 mm, roller 20 mm, arm 90 mm, swing 12 deg; cycloidal rise in 90
deg, dwell of 180 deg, cycloidal return in 75 deg, dwell of 15 deg.

Printed are a largest curvature of the profile of 0.045 1/mm and a least radius of 22.25 mm; that is the cam whose arm
swings in the sense of its turn. The digits below are held to the reversal construction by numerical derivatives in 40
digits (mpmath); tolerances are half a unit of the last digit.
"""

from __future__ import annotations

import math

import mpmath as mp
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
    found = {name: figure["value"] for name, figure in job.summary["measures"].items()}
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
    assert job.cam is not None and job.cam.first.smallest is not None
    smaller = heat_seal({"base": job.cam.first.smallest * 1e3 * (1 - 1e-6)}, limits={"pitch_over_roller": 2})
    assert [f.code for f in performed(smaller).found] == ["cam.limit"]


def radius(degrees: float, sense: int) -> mp.mpf:
    """The pitch curve's radius of curvature (mm) by the paper's construction: the cam rests, the frame turns back."""
    start = mp.acos((mp.mpf(85) ** 2 + 90**2 - 59**2) / (2 * 85 * 90))

    def share(turn: mp.mpf) -> mp.mpf:
        return turn - mp.sin(2 * mp.pi * turn) / (2 * mp.pi)

    def centre(theta: mp.mpf) -> mp.mpc:
        rise, fall = theta / (mp.pi / 2), (theta - 3 * mp.pi / 2) / (75 * mp.pi / 180)
        lift = share(rise) if rise < 1 else 1 if fall < 0 else 1 - share(fall)
        psi = start + lift * 12 * mp.pi / 180
        return mp.expj(-sense * theta) * (85 - 90 * mp.expj(-psi))

    with mp.workdps(40):
        at = mp.mpf(degrees) * mp.pi / 180
        first, second = mp.diff(centre, at), mp.diff(centre, at, 2)
        return abs(first) ** 3 / abs(mp.im(mp.conj(first) * second))


@pytest.mark.parametrize(("sense", "least"), [("clockwise", 42.2145), ("counter-clockwise", 34.9278)])
def test_the_least_radius_by_the_construction_itself(sense: str, least: float) -> None:
    """There, and no less a hundredth of a degree to either side."""
    job = performed(heat_seal({"sense": sense}))
    assert job.cam is not None
    (found,) = (figure for figure in job.cam.figures if figure.name == "pitch_radius_min")
    at, turn = math.degrees(found.theta), -1 if sense == "clockwise" else 1
    value = radius(at, turn)
    assert float(value) == pytest.approx(found.value * 1e3, rel=1e-11)
    assert float(value) == pytest.approx(least, abs=5e-5)
    assert value < min(radius(at - 0.01, turn), radius(at + 0.01, turn))


def test_the_sense_that_the_text_describes() -> None:
    """The arm swings against the cam."""
    job = performed(heat_seal({"sense": "counter-clockwise"}))
    assert job.cam is not None
    found = {figure.name: figure.value for figure in job.cam.figures}
    assert found["profile_curvature_max"] * 1e-3 == pytest.approx(0.0669892, abs=5e-8)
    assert found["profile_radius_min"] * 1e3 == pytest.approx(14.9278, abs=5e-5)
    assert found["pitch_radius_min"] * 1e3 == pytest.approx(34.9278, abs=5e-5)
    assert np.degrees(found["pressure_angle_max"]) == pytest.approx(41.904, abs=5e-4)
