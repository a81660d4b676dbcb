"""Accuracy where numbers of motion laws deviate: measures against differences of models with other laws; what is
refused."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import linkwright as lw
from helpers.cams import pair
from helpers.compiled import compiled_from
from linkwright.compilation import examine
from linkwright.kernels.parameter_batch import Varied
from linkwright.laws import LAWS
from linkwright.measures import measure_all
from linkwright.model.document import parse_document
from linkwright.reductions import kind_of
from linkwright.results import Run
from linkwright.studies.accuracy.derivatives import Derivatives
from linkwright.studies.accuracy.signal_sensitivities import Slopes
from linkwright.studies.batch_plan import Measuring
from linkwright.studies.registry import read_studies

OFFSETS, WEIGHTS = np.array([-2, -1, 1, 2]), np.array([1, -8, 8, -1]) / 12  # differences of fourth order
PARAMETERS = {"h": "20 deg", "w": "100 deg", "b": 0.3, "k": "40 deg/s"}
JUMPING = [
    {"rise": "h", "over": "w", "law": "parabolic", "skew": 0.4},
    {"dwell": "180-w"},
    {"fall": "h", "over": "w", "fractions": ["b", 0, "0.9-b", 0.1]},
    {"dwell": "180-w"},
]
MEASURES = {
    "rms": {"rms": "motor.alpha"},
    "rough": {"rms": "motor.jerk", "window": "some"},
    "torque": {"mean": "abs(motor.torque)"},
    "top": {"max": "motor.alpha"},
    "twisted": {"max": "arm.alpha*(1 + cos(motor.angle))*(1 + t/(1 s))"},
    "force": {"max": "force(frame, arm).x"},
    "stroke": {"span": "P.y"},
    "at": {"value": "P.y", "where": "max motor.omega"},
}


def swinging(segments: list[Any] = JUMPING, **sections: Any) -> dict[str, Any]:
    """An arm that swings by a law over the angle of its own time."""
    return {
        "units": {"length": "mm", "angle": "deg", "time": "s", "mass": "kg", "force": "N", "torque": "N*m"},
        "links": {
            "frame": {"points": {"O": [0, 0]}},
            "arm": {"points": {"O": [0, 0], "P": [100, 0]}, "mass": 2, "com": [50, 0], "inertia": 1},
        },
        "parameters": PARAMETERS,
        "laws": {"shape": {"over": "angle", "of": "angle", "segments": segments}},
        "drives": {"motor": {"turns": "arm", "on": "frame", "position": "20 deg + shape(k*t + 10 deg)"}},
        "windows": {"some": ["4.6 s", "8 s"]},
        "measures": MEASURES,
        **sections,
    }


def test_measures_of_samples_are_those_of_models_read_anew() -> None:
    """The corners of means go with the samples' own joins."""
    base = compiled_from(swinging())
    names = [*PARAMETERS]
    nominal = np.array([base.quantities.parameters[name] for name in names])
    values = nominal[:, None] * (1 + np.array([[0.1, -0.05], [-0.1, 0.2], [0.2, -0.3], [0.02, 0.01]]))
    varied = Varied(base, names)
    many = Measuring(varied, Run(base, 0.0, 9.0, 40)).evaluate(varied.parameters(values))
    for i, column in enumerate(values.T):
        h, w, b, k = (repr(float(value)) for value in column)
        texts = {"h": f"{h} rad", "w": f"{w} rad", "b": b, "k": f"{k} rad/s"}
        results, _ = measure_all(Run(compiled_from(swinging(parameters=texts)), 0.0, 9.0, 40))
        for result in results:
            for found in result.found:
                assert many.figures[result.name][found.label].values[i] == pytest.approx(found.value, rel=1e-9)


def test_derivatives_of_measures_cross_joins_that_move() -> None:
    """Where the acceleration jumps at a join, the mean and the largest value change with the join's place too."""
    base, names = compiled_from(swinging()), [*PARAMETERS]
    run, varied = Run(base, 0.0, 8.2, 200), Varied(base, names)
    start = np.array([base.quantities.parameters[name] for name in names])
    rows = [base.graph.parameters.index(name) for name in names]
    exact = Derivatives(run, Slopes(run, np.eye(len(base.parameters))[:, rows]))
    steps = 2e-4 * start
    shifts = (steps[:, None] * OFFSETS)[None] * np.eye(len(names))[:, :, None]
    many = Measuring(varied, run).evaluate(varied.parameters((start[:, None, None] + shifts).reshape(len(names), -1)))
    for name, measure in base.mechanism.measures.items():
        for derivative, label in zip(exact.of(name), kind_of(measure).labels, strict=True):
            figure = many.figures[name][label].values
            wanted = figure.reshape(len(names), -1) @ WEIGHTS / steps
            assert derivative.places.shape[0] == 1, name
            assert derivative.places[0] * start == pytest.approx(wanted * start, abs=2e-6 * np.abs(figure).max()), name


@pytest.mark.parametrize("start", ["(w/2 - 10 deg)/k", "1 s"])
def test_the_jump_of_a_load_at_a_join_counts_once(start: str) -> None:
    """The load sets in in the middle of a rise, where two pieces of its law join: with the join or at a fixed time."""
    segments = [{"rise": "h", "over": "w", "law": "modified_trapezoid"}, {"dwell": "180-w"}]
    segments += [{"fall": "h", "over": "w", "law": "cycloidal"}, {"dwell": "180-w"}]
    data = swinging(
        segments,
        loads={"push": {"on": "arm", "torque": 5, "window": "late"}},
        windows={"late": [start, "5 s"]},
        measures={"mean": {"mean": "motor.torque"}, "rms": {"rms": "motor.torque"}},
    )
    data["parameters"] = {**PARAMETERS, "w": "100 deg", "b": 0}
    base = compiled_from(data)
    run, row = Run(base, 0.0, 8.2, 200), base.graph.parameters.index("w")
    exact = Derivatives(run, Slopes(run, np.eye(len(base.parameters))[:, [row]]))
    w = float(base.parameters[row])
    found = []
    for offset in OFFSETS:
        data["parameters"]["w"] = f"{float(w * (1 + 1e-4 * offset))!r} rad"
        there = measure_all(Run(compiled_from(data), 0.0, 8.2, 200))[0]
        found.append([result.found[0].value for result in there])
    wanted = WEIGHTS @ np.array(found) / 1e-4
    for name, slope in zip(("mean", "rms"), wanted, strict=True):
        assert exact.of(name)[0].places[0] * w == pytest.approx(slope, abs=1e-5 * abs(found[0][1]))


def checked(data: dict[str, Any]) -> list[tuple[str, Any]]:
    document = parse_document(data)
    assert document is not None
    compiled, _ = examine(document)
    assert compiled is not None
    tasks, findings = read_studies(document.studies)
    assert not findings
    task = next(task for task in tasks if task.study.name == "accuracy")
    return [(f.code, str(f.data.get("names"))) for f in task.study.check(compiled, task.options)]


@pytest.mark.parametrize(
    "name", [name for name, law in LAWS.items() if not law.mirrored and name != "constant_velocity"]
)
def test_a_width_needs_another_to_take_it_up(name: str) -> None:
    studies = {"cycle": {"duration": "8.2 s", "samples": 20}, "accuracy": {"samples": 0}}
    given = {"h": {"value": "20 deg", "tolerance": "0.1 deg"}, "w": {"value": "100 deg", "tolerance": "1 deg"}, "k": 40}
    for width, fall, wrong in (("180-w", "h", None), (80, "h", "w"), ("180-w", 20, "h"), (80, 20, "h, w")):
        segments = [
            {"rise": "h", "over": "w", "law": name},
            {"dwell": width},
            {"fall": fall, "over": "w/2+50", "law": name},
            {"dwell": "130-w/2"},
        ]
        found = checked(swinging(segments, parameters=given, studies=studies))
        assert found == ([("accuracy.law", wrong)] if wrong else [])


def test_rates_that_must_agree() -> None:
    """The velocity at a join is that of both sides, so neither deviates alone."""
    segments = [
        {"rise": "h", "over": 100, "from": [0], "to": ["v"]},
        {"rise": "80*0.2", "over": 80, "law": "constant_velocity"},
        {"rise": "-h-16", "over": 180, "match": "velocity"},
    ]
    segments[2] = {"rise": "-h-16", "over": 180, "from": [0.2], "to": [0]}
    studies = {"cycle": {"duration": "8.2 s", "samples": 20}, "accuracy": {"samples": 0}}
    given = {"h": {"value": 20, "tolerance": 0.1}, "v": {"value": 0.2, "tolerance": 0.001}, "k": 40}
    assert checked(swinging(segments, parameters=given, studies=studies)) == [("accuracy.law", "v")]


def test_a_table_that_a_deviation_opens() -> None:
    studies = {"cycle": {"duration": "2 s", "samples": 20}, "accuracy": {"samples": 0}}
    for last, wrong in (("a", []), (20, [("accuracy.table", "a")])):
        table = {"points": [[0, "a"], ["0.7 s", 40], ["1.2 s", 35], ["2 s", last]], "period": "2 s"}
        drive = {"turns": "arm", "on": "frame", "position": "move(t)"}
        given = {"a": {"value": "20 deg", "tolerance": "0.1 deg"}}
        data = swinging(tables={"move": table}, drives={"motor": drive}, parameters=given, studies=studies)
        assert checked({**data, "laws": {}}) == wrong


def test_a_law_of_a_cam_is_an_error_of_its_profile() -> None:
    """Linear, at the vertices, by random samples; of the lift it is the error itself."""
    data = pair("swinging", "roller")
    data["parameters"] = {"h": {"value": 0.1, "tolerance": 1e-4}, "w": {"value": 1.7, "tolerance": 1e-3}}
    data["laws"]["lift"]["segments"] = [
        {"rise": "h", "over": "w", "law": "modified_sine"},
        {"dwell": "2.6-w"},
        {"fall": "h", "over": 1.3, "law": "cycloidal"},
        {"dwell": "2*pi-3.9"},
    ]
    data["measures"] = {
        "turn": {"value": "arm.angle", "where": "start"},
        "force": {"value": "rider.force", "where": "start"},
    }
    data["studies"] = {"cycle": {"duration": 0.2, "samples": 20}, "accuracy": {"samples": 400, "seed": 1}}
    document = parse_document(data)
    assert document is not None
    outcome = lw.accuracy(document)
    assert not outcome.failures
    share = LAWS["modified_sine"]  # at 0.7 rad of 1.7; the follower swings clockwise as it rises
    wanted = -share.at(0.7 / 1.7), 0.1 * share.at(0.7 / 1.7, 1) * 0.7 / 1.7**2
    assert outcome.figures["turn"].coefficients[:, 0] == pytest.approx(np.array(wanted), rel=1e-9)
    for figure in outcome.figures.values():
        assert figure.searched is not None
        assert figure.monte_carlo is not None
        assert figure.monte_carlo.sigma == pytest.approx(figure.sigma, rel=0.1)
        assert figure.searched.low == pytest.approx(figure.worst[0], rel=0.01)


def test_the_rise_that_gives_a_stroke_is_found() -> None:
    """From measured positions, as any other dimension."""
    data = swinging(
        measures={},
        parameters=PARAMETERS
        | {"h": {"value": "20 deg", "tolerance": "1 deg"}, "w": {"value": "100 deg", "tolerance": "5 deg"}},
        studies={"cycle": {"duration": "8.2 s", "samples": 40}, "accuracy": {"samples": 0, "outputs": ["P.x"]}},
    )
    true = swinging(parameters=PARAMETERS | {"h": "20.7 deg", "w": "97 deg"})
    t = np.array([0.4, 1.1, 1.9, 3.0, 5.0, 6.3])
    y = Run(compiled_from(true), 0.0, 8.2, 40).evaluate(["P.y"], t)[0]
    data["studies"]["accuracy"]["calibrate"] = {
        "points": [{"t": float(time), "P.y": float(value) * 1e3} for time, value in zip(t, y, strict=True)]
    }
    document = parse_document(data)
    assert document is not None
    made = lw.accuracy(document).calibration
    assert made is not None
    found = {one.name: np.degrees(one.deviation) for one in made.estimates}
    assert found == pytest.approx({"h": 0.7, "w": -3.0}, abs=1e-8)
