"""Measures that nothing moves, and those without bound, in a study of deviations."""

from __future__ import annotations

import warnings
from typing import Any

from linkwright.app.job import Job
from linkwright.kernels.parameter_batch import Varied
from linkwright.studies.accuracy.disagreement import disagreement
from linkwright.studies.batch_plan import Measuring
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


def level_hand() -> dict[str, Any]:
    """A hand that two parallelograms keep level, whatever the lengths are."""
    return {
        "units": UNITS,
        "parameters": {"L1": {"value": 80, "tolerance": 0.1}, "L2": {"value": 70, "tolerance": 0.1}},
        "links": {
            "frame": {"points": {"O": [0, 0], "S": [-20, 25]}},
            "upper": {"points": {"O": [0, 0], "E": ["L1", 0]}},
            "guide": {"points": {"S": [0, 0], "T1": ["L1", 0]}},
            "plate": {"points": {"E": [0, 0], "T1": [-20, 25], "T2": [20, 25]}},
            "fore": {"points": {"E": [0, 0], "W": ["L2", 0]}},
            "rod": {"points": {"T2": [0, 0], "H": ["L2", 0]}},
            "hand": {"points": {"W": [0, 0], "H": [20, 25]}},
        },
        "assembly": {"T1": [20, 94], "H": [125, 70]},
        "drives": {
            "shoulder": {"turns": "upper", "on": "frame", "position": "60 deg + 20 deg*sin(360 deg*t/(2 s))"},
            "elbow": {"turns": "fore", "on": "upper", "position": "-80 deg + 15 deg*cos(360 deg*t/(1 s))"},
        },
        "loads": {"payload": {"on": "hand", "at": "W", "force": [0, -1]}},
        "measures": {"tilt": {"extremes": "hand.angle"}, "reach": {"max": "W.x"}},
        "studies": {
            "cycle": {"period": "2 s", "samples": 50},
            "accuracy": {"outputs": ["tilt", "reach"], "samples": 60},
        },
    }


def test_an_output_that_is_zero_whatever_deviates_has_no_deviations() -> None:
    """Round-off had shares, and statistics of it disagreed by ten powers of ten; each sample was searched by itself."""
    job = without_warnings(level_hand())
    outcome = job.outcomes["accuracy"]
    assert job.exit_code == 0
    assert not outcome.warnings
    for name in ("tilt min", "tilt max"):
        figure = outcome.figures[name]
        assert abs(figure.nominal) < 1e-13
        assert (figure.worst, figure.sigma) == ((0.0, 0.0), 0.0)
        assert not figure.coefficients.any() and not figure.shares.any()
        assert (figure.searched.low, figure.searched.high, figure.searched.off) == (0.0, 0.0, 0.0)
        assert (figure.monte_carlo.mean, figure.monte_carlo.sigma) == (figure.nominal, 0.0)
        assert not disagreement(figure, outcome).parted
    reach = outcome.figures["reach"]
    assert reach.sigma > 0 and reach.searched.high > 0


def test_samples_of_an_output_that_is_zero_are_measured_together() -> None:
    run = job_of(level_hand()).outcomes["cycle"].result.run
    assert Measuring(Varied(run.compiled, ["L1", "L2"]), run).single == set()


def a_bar_that_stands(signal: str) -> dict[str, Any]:
    data = crank_alone(level={"rms": signal})
    data["parameters"] |= {"tip": {"value": 0, "tolerance": 0.1}}
    data["links"]["bar"] = {"points": {"A": [0, 0], "C": [30, "tip"]}}
    data["drives"]["hold"] = {"turns": "bar", "on": "frame", "position": "0 deg"}
    return data


def test_the_rms_of_nothing_has_no_transfer_coefficients() -> None:
    figure = without_warnings(a_bar_that_stands("A.vy")).outcomes["accuracy"].figures["level"]
    assert (figure.nominal, figure.sigma) == (0.0, 0.0)
    assert not figure.coefficients.any()


def test_the_rms_of_what_only_deviations_make_has_a_corner_at_zero() -> None:
    """C.y is the deviation of the tip: its rms is the magnitude, with slopes of 1 and -1 mm/mm."""
    figure = without_warnings(a_bar_that_stands("C.y")).outcomes["accuracy"].figures["level"]
    assert figure.nominal == 0.0
    assert sorted(figure.coefficients.ravel().round(12).tolist()) == [-1, 0, 0, 0, 0, 1]
