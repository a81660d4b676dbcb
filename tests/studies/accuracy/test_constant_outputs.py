"""Measures that nothing moves, and those without bound, in a study of deviations."""

from __future__ import annotations

import warnings
from typing import Any

from linkwright.app.job import Job
from studies.models import CRANK, TURN, UNITS, codes, job_of

PARAMETERS = {"AB": {"value": 40, "tolerance": 0.05}, "D": {"value": 100, "tolerance": 0.05}}
FRAME = {"points": {"A": [0, 0], "D": ["D", 0]}}


def crank_alone(**measures: Any) -> dict[str, Any]:
    """A crank that turns beside a pin on the frame."""
    return {
        "units": UNITS,
        "parameters": PARAMETERS,
        "links": {"frame": FRAME, "crank": {"points": {"A": [0, 0], "B": ["AB", 0]}}},
        "drives": {"motor": CRANK},
        "measures": measures,
        "studies": {"cycle": {**TURN, "samples": 12}, "accuracy": {"samples": 32}},
    }


def without_warnings(data: dict[str, Any]) -> Job:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        return job_of(data)


def test_a_path_that_is_a_point_stays_straight() -> None:
    job = without_warnings(crank_alone(still={"straightness": "D"}))
    assert job.exit_code == 0
    figure = job.outcomes["accuracy"].figures["still"]
    assert (figure.nominal, figure.sigma) == (0.0, 0.0)
    assert not figure.coefficients.any()


def test_an_unbounded_measure_has_no_transfer_coefficients() -> None:
    """The rocker stands still twice a turn."""
    links = {"coupler": {"points": {"B": [0, 0], "C": [120, 0]}}, "rocker": {"points": {"D": [0, 0], "C": [80, 0]}}}
    data = crank_alone(advantage={"max": "crank.omega/rocker.omega"}, swing={"max": "rocker.angle"})
    data["links"] |= links
    data["assembly"] = {"C": "left of B-D"}
    outcome = without_warnings(data).outcomes["accuracy"]
    assert [*outcome.figures] == ["swing"]
    assert "measure.not-finite" in codes(outcome.warnings)


def test_a_load_that_turns_round_at_a_dwell_moves_with_nothing() -> None:
    """Friction turns with the motion, whose zeros fill the dwells."""
    segments = [
        {"rise": 30, "over": 0.3, "law": "cycloidal"},
        {"dwell": 0.2},
        {"fall": 30, "over": 0.4, "law": "poly_345"},
        {"dwell": 0.1},
    ]
    data = {
        "units": UNITS,
        "gravity": "earth",
        "parameters": {"l": {"value": 100, "tolerance": 0.05}},
        "links": {
            "frame": {"points": {"A": [0, 0]}},
            "arm": {"points": {"A": [0, 0], "B": ["l", 0]}, "mass": 2, "shape": "point B"},
        },
        "friction": {"bearing": {"pin": "A", "radius": 5, "coefficient": 0.1}},
        "laws": {"swing": {"over": "time", "of": "angle", "segments": segments}},
        "drives": {"motor": {"turns": "arm", "on": "frame", "position": "10 deg + swing(t)"}},
        "measures": {"least": {"min": "abs(motor.torque)"}},
        "studies": {"cycle": {"duration": "1 s", "samples": 20}, "accuracy": {"samples": 32}},
    }
    job = without_warnings(data)
    assert job.exit_code == 0
    assert job.outcomes["accuracy"].figures["least"].sigma > 0
