"""Calibration of a whole model: measurements from files and points, their poses, derived parameters, wrong input."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import linkwright as lw
from linkwright.findings import ModelError
from linkwright.results import Run
from linkwright.studies.accuracy.calibration_options import calibrate
from linkwright.studies.accuracy.calibration_outcome import Calibration
from linkwright.studies.accuracy.options import AccuracyOptions
from linkwright.studies.accuracy.stated_contributors import contributors
from studies.models import four_bar

Array = NDArray[np.float64]
LENGTHS = {"a": 40, "b": 120, "c": 80, "d": 100}
TRUE = {"a": 40.03, "b": 119.96, "c": 80.02, "d": 100.01}
ANGLES = [0, 30, 75, 120, 180, 225, 290, 350]


def model(parameters: dict[str, Any] | None = None, **sections: Any) -> lw.Document:
    given = parameters or {name: {"value": value, "tolerance": 0.05} for name, value in LENGTHS.items()}
    return lw.Document.model_validate({**four_bar(**sections), "parameters": given})


def measured(names: list[str], **sections: Any) -> Array:
    """Outputs of the true mechanism in mm and deg at the angles, (names, angles): one turn takes 1 s."""
    run = Run(lw.compile(model(TRUE, **sections)), 0.0, 1.0, 60)
    size = [np.pi / 180 if name.endswith(("angle", "omega")) else 1e-3 for name in names]
    return np.asarray(run.evaluate(names, np.array(ANGLES) / 360) / np.array(size)[:, None])


def points(names: list[str], **sections: Any) -> list[dict[str, float]]:
    rows = measured(names, **sections).T.tolist()
    return [{"t": angle / 360, **dict(zip(names, row, strict=True))} for angle, row in zip(ANGLES, rows, strict=True)]


def found(document: lw.Document, folder: Path | None = None, **options: Any) -> tuple[Calibration, list[str]]:
    compiled = lw.compile(document, folder)
    context = {"cycle": {"turns": "1 motor", "samples": 60}}
    asked = AccuracyOptions.model_validate({"outputs": ["P.x"], "calibrate": options}, context=context)
    assert asked.calibrate is not None
    run = Run(compiled, 0.0, 1.0, 60)
    made, notes = calibrate(run, asked.calibrate, contributors(compiled, asked))
    return made, [note.code for note in notes]


@pytest.mark.parametrize(("given", "codes"), [("s", []), ("2*s", []), ("s - s", ["accuracy.sigma"])])
def test_a_sigma_tells_the_unit_of_its_parameter_where_the_file_is_missing(given: str, codes: list[str]) -> None:
    studies = {"cycle": {"turns": "1 motor", "samples": 60}}
    asked = {"file": "later.csv", "parameters": ["a"], "sigma": {"P.x": given}}
    studies["accuracy"] = {"outputs": ["P.x"], "samples": 0, "calibrate": asked}
    parameters = {"a": {"value": 40, "tolerance": 0.05}, "b": 120, "c": 80, "d": 100, "s": 0.005}
    found = lw.check(model(parameters, studies=studies))
    assert [finding.code for finding in found] == ["table.unreadable", *codes]


def deviations(made: Calibration) -> dict[str, float]:
    return {one.name: one.deviation / one.size for one in made.estimates}


def expected() -> dict[str, float]:
    return {name: TRUE[name] - LENGTHS[name] for name in LENGTHS}


def test_dimensions_are_found_from_a_file_over_the_crank_angle(tmp_path: Path) -> None:
    """Columns in other units than the model's, a gap, an angle given beyond the run by a turn, an empty line."""
    x, y, rocker = measured(["P.x", "P.y", "rocker.angle"]).tolist()
    lines = ["crank.angle [deg],P.x [m],P.y,rocker.angle [rad]"]
    for i, angle in enumerate(ANGLES):
        shown = angle + 360 * (i == 3)
        lines.append(f"{shown},{x[i] / 1e3!r},{'' if i == 2 else repr(y[i])},{float(np.radians(rocker[i]))!r}")
    (tmp_path / "measured.csv").write_text("\n".join([*lines, "", ""]), encoding="utf-8")
    made, notes = found(model(), tmp_path, file="measured.csv")
    assert deviations(made) == pytest.approx(expected(), abs=1e-9)
    assert made.at == "crank.angle"
    assert len(made.observed) == 3 * len(ANGLES) - 1
    assert made.observed[0].t == 0
    assert not notes
    assert made.converged
    assert all(after < 1e-9 * before for before, after in zip(made.before, made.after, strict=True))


def test_parameters_follow_the_estimated_ones_exactly() -> None:
    """The ground is an expression of the crank that isn't linear: its own derivative changes with the crank."""
    given = {name: {"value": value, "tolerance": 0.5} for name, value in LENGTHS.items() if name != "d"}
    law = "a^2/(16 mm)"
    true = {"a": 40.2, "b": 119.6, "c": 80.2}
    rows = Run(lw.compile(model({**true, "d": law})), 0.0, 1.0, 60).evaluate(["P.x", "P.y"], np.array(ANGLES) / 360)
    listed = [
        {"t": angle / 360, "P.x": x * 1e3, "P.y": y * 1e3} for angle, x, y in zip(ANGLES, *rows.tolist(), strict=True)
    ]
    made, _ = found(model({**given, "d": law}), points=listed)
    assert deviations(made) == pytest.approx({name: true[name] - LENGTHS[name] for name in true}, abs=1e-9)


def test_of_angles_alone_the_scale_stays_open_and_is_named() -> None:
    made, notes = found(model(), points=points(["rocker.angle", "coupler.angle"]), sigma={"rocker.angle": 0.01})
    assert notes == ["accuracy.scale-open"]
    (open_,) = made.confounded
    assert open_.names == [*LENGTHS]
    assert open_.scaling
    assert all(one.interval is None and not one.identified for one in made.estimates)
    assert np.isnan(made.correlation).all()
    some, notes = found(model(), points=points(["rocker.angle"]), parameters=["a", "b", "c"])
    assert not notes  # with the ground given, the others are told
    assert all(one.identified for one in some.estimates)


def test_an_offset_of_two_origins_is_not_told_apart() -> None:
    """The start of the drive, and the polar angle of a point on its crank."""
    sections = four_bar()
    sections["links"]["crank"]["points"]["Q"] = "20 at q"
    sections["parameters"] = {"q": {"value": "10 deg", "tolerance": 0.1}, "s": {"value": "0 deg", "tolerance": 0.1}}
    sections["parameters"] |= LENGTHS
    sections["drives"] = {"motor": {**sections["drives"]["motor"], "start": "s"}}
    document = lw.Document.model_validate(sections)
    run = Run(lw.compile(document), 0.0, 1.0, 60)
    rows = run.evaluate(["Q.x", "Q.y"], np.array(ANGLES) / 360).T.tolist()
    listed = [{"t": a / 360, "Q.x": x * 1e3 + 0.01, "Q.y": y * 1e3} for a, (x, y) in zip(ANGLES, rows, strict=True)]
    made, notes = found(document, points=listed)
    assert notes == ["accuracy.not-identifiable"]
    (open_,) = made.confounded
    assert open_.deviations["q"] == pytest.approx(-open_.deviations["s"], rel=1e-9)


SWING = {"motor": {"turns": "crank", "on": "frame", "position": "60 deg + 20 deg*sin(360 deg*t/(1 s))"}}
PLAIN = [{"t": 0.1 * i, "P.x": 70.0 + i, "P.y": 20.0} for i in range(8)]
FAULTS: dict[str, tuple[dict[str, Any], str, list[str]]] = {
    "unknown parameter": ({"points": PLAIN, "parameters": ["a", "x"]}, "", ["accuracy.no-contributor"]),
    "unknown output": ({"points": [{**row, "Z.x": 1} for row in PLAIN]}, "", ["name.unknown-element"]),
    "no output": ({"points": [{**row, "a": 1} for row in PLAIN]}, "", ["study.no-output"]),
    "not in the run": ({"points": [*PLAIN, {"t": 1.2, "P.x": 70}]}, "", ["accuracy.no-pose"]),
    "unit of time": ({"points": [{"t": "3 mm", "P.x": 70}]}, "", ["expression.units-conflict"]),
    "sigma": ({"points": PLAIN, "sigma": {"P.x": 0, "E.x": 1}}, "", ["accuracy.not-measured", "accuracy.sigma"]),
    "too few": ({"points": PLAIN[:2]}, "", ["accuracy.few-measurements"]),
    "sigma open": ({"points": [{**PLAIN[0], "coupler.angle": 30}, *PLAIN[1:]]}, "", ["accuracy.sigma-open"]),
    "no place": ({"points": [{"P.x": 1.0}]}, "", ["accuracy.no-place"]),
    "another place": ({"points": PLAIN, "at": "rocker.angle"}, "", ["accuracy.no-place"]),
    "row without place": ({"points": [*PLAIN, {"P.x": 1.0}]}, "", ["accuracy.measured-number"]),
    "no file": ({"file": "nothing.csv"}, "", ["table.unreadable"]),
    "empty": ({"file": "m.csv"}, "", ["table.empty"]),
    "places alone": ({"file": "m.csv"}, "t\n0.1\n", ["accuracy.nothing-measured"]),
    "empty column": ({"file": "m.csv"}, "t,P.x,P.y\n0.1,3,\n0.2,4,\n", ["accuracy.empty-column"]),
    "not numbers": ({"file": "m.csv"}, "t,P.x\n0.1,many\n,3\nnan,3\n", ["accuracy.measured-number"] * 3),
    "unit": ({"file": "m.csv"}, "t,P.x [kg]\n0.1,3\n", ["accuracy.measured-unit"]),
    "no unit": ({"file": "m.csv"}, "t,P.x [furlong]\n0.1,3\n", ["units.unknown"]),
    "no such angle": ({"file": "m.csv"}, "crank.angle,P.x\nnan,3\n", ["accuracy.measured-number"]),
}


@pytest.mark.parametrize("name", FAULTS)
def test_each_fault_has_its_finding(name: str, tmp_path: Path) -> None:
    options, text, codes = FAULTS[name]
    if options.get("file") == "m.csv":
        (tmp_path / "m.csv").write_text(text, encoding="utf-8")
    with pytest.raises(ModelError) as caught:
        found(model(), tmp_path, **options)
    assert [finding.code for finding in caught.value.findings] == codes
    assert all(finding.what and finding.mend for finding in caught.value.findings)


def test_what_changes_nothing_is_told() -> None:
    made, notes = found(model(), points=points(["P.x"]), parameters=["a", "b", "c"])
    assert not notes
    made, notes = found(model(), points=points(["crank.omega"]), parameters=["a"])
    assert notes == ["accuracy.no-effect"]
    assert made.estimates[0].interval is None


def test_an_angle_that_comes_twice_needs_the_same_outputs() -> None:
    """The crank swings: it comes twice to 70 deg, in the same pose, with opposite speeds."""
    pose = [{"motor.angle": 70, "P.x": 80.0}, {"motor.angle": 65, "P.x": 81.0}, {"motor.angle": 60, "P.x": 82.0}]
    made, _ = found(model(drives=SWING), points=pose, parameters=["a"])
    assert next(one.t for one in made.observed) == pytest.approx(1 / 12, abs=1e-9)
    with pytest.raises(ModelError) as caught:
        found(model(drives=SWING), points=[{**row, "P.vx": 1.0} for row in pose[:2]], parameters=["a"])
    assert {finding.code for finding in caught.value.findings} == {"accuracy.several-poses"}


def test_a_wrong_row_is_an_outlier() -> None:
    rng = np.random.default_rng(4)
    listed = [{k: v + (k != "t") * rng.normal() * 1e-3 for k, v in row.items()} for row in points(["P.x", "P.y"])]
    listed[5]["P.x"] += 0.2
    made, notes = found(model(), points=listed, sigma={"P.x": 1e-3, "P.y": 1e-3})
    assert set(notes) == {"accuracy.poor-fit", "accuracy.outliers"}
    assert 6 in [one.row for one in made.observed if one.outlier]
    worst = max(made.observed, key=lambda one: abs(one.studentised))
    assert (worst.row, made.outputs[worst.output]) == (6, "P.x")
    assert worst.studentised > 0
