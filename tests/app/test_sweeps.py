"""Sweeps as files and from Python: tables that say what the outcome does, in the file's units."""

from __future__ import annotations

import csv
import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.io import netcdf_file

import linkwright as lw
from linkwright.app import Writing, write
from linkwright.app.job import examine_document, perform
from linkwright.studies import RunContext
from linkwright.studies.sweep.outcome import SweepOutcome
from studies.models import four_bar

VARY = {"a": {"normal": 40, "sigma": 0.05}, "b": ["110 mm", 120, 250]}


def model(**sweep: Any) -> lw.Document:
    studies = {
        "cycle": {"turns": "1 motor", "samples": 24},
        "sweep": {"vary": VARY, "outputs": ["swing", "torque", "P.x", "rocker.angle"], "samples": 40, **sweep},
    }
    measures = {"swing": {"span": "rocker.angle"}, "torque": {"extremes": "motor.torque"}}
    require = {"swing": ">= 60 deg"}
    return lw.Document.model_validate(four_bar(measures=measures, require=require, studies=studies))


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> tuple[SweepOutcome, Path]:
    folder = tmp_path_factory.mktemp("out")
    job = perform(examine_document(model()), RunContext(out=folder))
    assert job.sweep is not None
    write(job, folder, Writing(["netcdf"]))
    return job.sweep, folder


def table(path: Path) -> tuple[list[str], np.ndarray]:
    with path.open(encoding="utf-8", newline="") as stream:
        header, *rows = csv.reader(stream)
    return header, np.array([[float(cell) if cell else np.nan for cell in row] for row in rows]).T


def test_the_files(written: tuple[SweepOutcome, Path]) -> None:
    names = {path.name for path in written[1].iterdir()}
    expected = {
        "linkwright-manifest.json",
        "report.html",
        "summary.json",
        "cycle.csv",
        "cycle.nc",
        "sweep.csv",
        "sweep_bands.csv",
        "sweep.nc",
    }
    assert names == expected


def test_a_row_for_each_sample(written: tuple[SweepOutcome, Path]) -> None:
    outcome, folder = written
    header, columns = table(folder / "sweep.csv")
    figures = ["swing [deg]", "torque min [N*m]", "torque max [N*m]"]
    assert header == ["sample", "a [mm]", "b [mm]", *figures, "swing met", "failed", "since [s]"]
    assert outcome.table is not None
    scale = np.array([[1e-3], [1e-3], [np.pi / 180], [1.0], [1.0]])
    exact = np.concatenate([outcome.table.parameters, outcome.table.figures])
    np.testing.assert_allclose(columns[1:6] * scale, exact, rtol=1e-15)
    np.testing.assert_array_equal(columns[0], np.arange(40))
    np.testing.assert_array_equal(columns[6], outcome.table.met[0])
    np.testing.assert_array_equal(columns[7], outcome.table.failed)
    np.testing.assert_array_equal(columns[8], outcome.table.since)
    assert outcome.table.failed.sum() == outcome.failed > 0


def test_a_row_for_each_pose(written: tuple[SweepOutcome, Path]) -> None:
    outcome, folder = written
    header, columns = table(folder / "sweep_bands.csv")
    assert header[:6] == [
        "t [s]",
        *(f"P.x {kind} [mm]" for kind in ("mean", "deviation", "least", "largest")),
        "P.x count",
    ]
    band = outcome.bands["P.x"]
    np.testing.assert_allclose(columns[0], outcome.t, rtol=1e-15)
    for column, key in zip(columns[1:5], ("mean", "deviation", "least", "largest"), strict=True):
        np.testing.assert_allclose(column * 1e-3, getattr(band, key), rtol=1e-15)
    np.testing.assert_array_equal(columns[5], band.count)


def test_netcdf_holds_the_same_in_si(written: tuple[SweepOutcome, Path]) -> None:
    outcome, folder = written
    assert outcome.table is not None
    with netcdf_file(folder / "sweep.nc", mmap=False) as file:
        v = file.variables
        np.testing.assert_array_equal(v["a"][:], outcome.table.parameters[0])
        np.testing.assert_array_equal(v["measure swing"][:], outcome.table.figures[0])
        np.testing.assert_array_equal(v["P.x mean"][:], outcome.bands["P.x"].mean)
        assert v["P.x mean"].units == b"m"
        assert v["a"].dimensions == ("sample",)
        assert v["P.x mean"].dimensions == ("time",)
        assert b"varied.cannot-assemble" in file.findings


def test_the_summary(written: tuple[SweepOutcome, Path]) -> None:
    outcome, folder = written
    data = json.loads((folder / "summary.json").read_text("utf-8"))
    entry = data["sweep"]
    assert (entry["samples"], entry["failed"], entry["plan"], entry["poses"]) == (40, outcome.failed, "latin", 25)
    assert entry["vary"]["a"]["nominal"] == 40
    assert entry["vary"]["a"]["unit"] == "mm"
    swing = entry["measures"]["swing"]
    assert swing["mean"] == pytest.approx(np.degrees(outcome.measures[0].mean), rel=1e-14)
    assert swing["count"] == 40 - outcome.failed
    share = entry["require"]["swing"]
    assert share["share"] == share["met"] / 40
    assert share["low"] < share["share"] < share["high"]
    assert entry["files"] == ["sweep.csv", "sweep_bands.csv"]
    assert "varied.cannot-assemble" in {finding["code"] for finding in data["findings"]}
    assert data["done"]


def test_the_report_shows_tables_and_charts(written: tuple[SweepOutcome, Path]) -> None:
    text = (written[1] / "report.html").read_text("utf-8")
    section = re.search(r'<section id="sweep">.*?</section>', text, re.DOTALL)
    assert section is not None
    assert section[0].count('class="plot study') >= 2 + 2 * 3
    assert "nan" not in section[0].lower().replace("nano", "")
    assert 'href="#sweep"' in text
    for word in ("Yield: share of samples", "swing: samples", "torque max"):
        assert word in section[0]


def test_from_python_the_same_as_from_the_file(written: tuple[SweepOutcome, Path], tmp_path: Path) -> None:
    lw.save(model(), tmp_path / "model.yaml")
    outcome = lw.sweep(tmp_path / "model.yaml")
    assert outcome.table is not None
    assert written[0].table is not None
    np.testing.assert_array_equal(outcome.table.figures, written[0].table.figures)


def test_what_is_given_in_python_goes_before_the_file() -> None:
    outcome = lw.sweep(model(), {"a": np.linspace(39, 41, 3)}, ["swing"])
    assert (outcome.samples, outcome.plan.name) == (3, "grid")
    assert outcome.table is not None
    assert outcome.table.parameters[0].tolist() == [0.039, 0.04, 0.041]
    assert [found.column.name for found in outcome.measures] == ["swing"]


def test_faults_are_raised() -> None:
    with pytest.raises(lw.ModelError) as refusal:
        lw.sweep(model(), {"z": [1, 2]}, ["swing"])
    assert [finding.code for finding in refusal.value.findings] == ["name.unknown-parameter"]
