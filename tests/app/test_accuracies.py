"""The accuracy study from a file and from Python: files, summary and outcome say the same."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import linkwright as lw
from helpers.accuracies import MM, NOMINAL, stroke
from linkwright.app import Writing, write
from linkwright.app.job import examine_document, perform
from linkwright.studies import RunContext
from studies.models import TURN, slider_crank

LIMITS = {"r": 0.05, "l": [-0.02, 0.08], "e": 0.1}


def model(toleranced: bool = True, **accuracy: Any) -> lw.Document:
    parameters = {name: {"value": NOMINAL[name] / MM, "tolerance": tolerance} for name, tolerance in LIMITS.items()}
    asked = {"outputs": ["stroke", "C.x"], "positions": {"far": "max C.x"}, "samples": 400, "kernel": "numpy"}
    studies = {"cycle": {**TURN, "samples": 24}, "accuracy": {**asked, **accuracy}}
    data = slider_crank(measures={"stroke": {"span": "guide.s"}}, studies=studies)
    return lw.Document.model_validate({**data, **({"parameters": parameters} if toleranced else {})})


def test_the_files(tmp_path: Path) -> None:
    job = perform(examine_document(model()), RunContext(out=tmp_path))
    write(job, tmp_path, Writing(["netcdf"]))
    assert {path.name for path in tmp_path.iterdir()} == {
        "linkwright-manifest.json", "report.html", "summary.json", "cycle.csv", "cycle.nc", "accuracy.csv",
        "accuracy_bands.csv", "accuracy.nc",
    }  # fmt: skip
    entry = json.loads((tmp_path / "summary.json").read_text("utf-8"))
    assert entry["done"]
    nominal, *slopes = stroke(*NOMINAL.values())
    found = entry["accuracy"]["stroke"]
    assert found["nominal"] == pytest.approx(nominal / MM, rel=1e-12)
    coefficients = {row["parameter"]: row["coefficient"] for row in found["contributors"]}
    assert coefficients == pytest.approx(dict(zip(NOMINAL, slopes, strict=True)), rel=1e-9)
    assert found["monte_carlo"]["samples"] == entry["accuracy_study"]["samples"] == 400
    far = entry["accuracy"]["C.x"]["positions"]["far"]
    assert far["nominal"] == pytest.approx(np.sqrt(210**2 - 20**2), rel=1e-12)
    assert {row["parameter"]: row["coefficient"] for row in far["contributors"]} == pytest.approx(
        {"r": 210 / 209.0454496, "l": 210 / 209.0454496, "e": -20 / 209.0454496}, rel=1e-8
    )
    assert 'id="accuracy"' in (tmp_path / "report.html").read_text("utf-8")


def test_what_is_given_in_python_goes_before_the_file(tmp_path: Path) -> None:
    outcome = lw.accuracy(model(), ["C.y - C.x"], 0, options={"positions": {"up": "0.25 s"}}, out=tmp_path)
    assert [*outcome.every] == ["C.y - C.x", "C.y - C.x at up"]
    assert outcome.samples == 0
    assert "accuracy_bands.csv" in {path.name for path in tmp_path.iterdir()}


def test_faults_are_raised() -> None:
    with pytest.raises(lw.ModelError) as refusal:
        lw.accuracy(model(), ["nothing"], 10)
    assert [finding.code for finding in refusal.value.findings] == ["study.no-output"]


def test_a_signal_without_any_value_is_left_out_and_named(tmp_path: Path) -> None:
    outcome = lw.accuracy(model(positions={}), ["sqrt(C.x - 999)", "C.x"], 20, out=tmp_path)
    assert [*outcome.every] == ["C.x"]
    told = [finding.what for finding in outcome.warnings if finding.code == "measure.not-finite"]
    assert told == ["The measure sqrt(C.x - 999) has no finite value."]


def test_clearances_are_written(tmp_path: Path) -> None:
    outcome = lw.accuracy(model(), ["stroke"], 0, options={"clearances": {"B": 0.02}, "positions": {}}, out=tmp_path)
    entry = json.loads((tmp_path / "summary.json").read_text("utf-8"))
    play = entry["accuracy"]["stroke"]["play"]
    # Both ends of the stroke lie along the crank and the rod, so that the clearance adds to it twice.
    assert play["bound"] == pytest.approx(2 * 0.02, rel=0.02)
    assert play["high"] == pytest.approx(entry["accuracy"]["stroke"]["worst_case"]["high"] + play["bound"])
    assert entry["accuracy_study"]["joints"][0]["clearance"] == pytest.approx(0.02)
    assert len(outcome.joints) == 1
    assert "Effect of clearances" in (tmp_path / "report.html").read_text("utf-8")
    alone = lw.accuracy(model(toleranced=False), options={"clearances": {"B": 0.02}}, out=tmp_path)
    assert alone.figures["stroke"].play == outcome.figures["stroke"].play
    assert (alone.samples, alone.every["C.x at far"].worst) == (0, (0.0, 0.0))
    assert "NaN" not in (tmp_path / "summary.json").read_text("utf-8")
