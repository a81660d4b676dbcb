"""``linkwright sweep``: the sweep alone, what it prints and writes, interrupted and gone on with as a process."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

import linkwright as lw
from linkwright.cli import cli
from studies.models import slider_crank

VARY = {"r": {"normal": 50, "sigma": 0.1}, "l": {"uniform": [155, 165]}}


@pytest.fixture
def model(tmp_path: Path) -> Path:
    sweep = {"vary": VARY, "outputs": ["stroke", "C.x"], "samples": 50}
    studies = {"cycle": {"turns": "1 motor", "samples": 16}, "sweep": sweep}
    measures = {"stroke": {"span": "guide.s"}}
    data = slider_crank(measures=measures, require={"stroke": ">= 90 mm"}, studies=studies)
    lw.save(lw.Document.model_validate(data), tmp_path / "model.yaml")
    return tmp_path / "model.yaml"


def call(*words: object) -> Result:
    return CliRunner().invoke(cli, [str(word) for word in words], catch_exceptions=False)


def test_the_sweep_alone(model: Path, tmp_path: Path) -> None:
    result = call("sweep", model, "--out", tmp_path / "out", "--workers", 1)
    assert result.exit_code == 0
    assert "50 samples (plan: Latin hypercube (latin)), 17 poses each" in result.stdout
    assert "stroke" in result.stdout
    assert "100 %" in result.stdout
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == [
        "linkwright-manifest.json", "report.html", "summary.json", "sweep.csv", "sweep_bands.csv",
    ]  # fmt: skip


def test_run_performs_it_with_the_others(model: Path, tmp_path: Path) -> None:
    assert call("run", model, "--netcdf").exit_code == 0
    names = {path.name for path in (tmp_path / "model_linkwright").iterdir()}
    assert {"cycle.csv", "sweep.csv", "sweep_bands.csv", "sweep.nc", "summary.json"} <= names


def test_json(model: Path) -> None:
    result = call("sweep", model, "--json")
    assert result.exit_code == 0
    assert json.loads(result.stdout)["sweep"]["samples"] == 50


def test_a_kernel_that_is_not_there(model: Path) -> None:
    result = call("sweep", model, "--kernel", "abacus")
    assert result.exit_code == 2
    assert "study.choice" in result.stderr


def test_a_cluster_that_is_not_there(model: Path) -> None:
    pytest.importorskip("distributed")
    result = call("sweep", model, "--cluster", "nonsense")
    assert result.exit_code == 2
    assert "blocks.cluster-unreachable" in result.stderr


def test_a_file_without_a_sweep(tmp_path: Path) -> None:
    lw.save(lw.Document.model_validate(slider_crank()), tmp_path / "model.yaml")
    result = call("sweep", tmp_path / "model.yaml")
    assert result.exit_code == 2
    assert "vary" in result.stderr


def test_a_folder_that_cannot_be_written(model: Path, tmp_path: Path) -> None:
    (tmp_path / "taken").write_text("a file", "utf-8")
    result = call("sweep", model, "--out", tmp_path / "taken")
    assert result.exit_code == 2
    assert "taken" in result.stderr


@pytest.mark.skipif(os.name == "nt", reason="signals are another matter there")
def test_interrupted_it_says_how_to_go_on_and_does(model: Path, tmp_path: Path) -> None:
    document = lw.load(model)
    studies = {**document.studies, "sweep": {**document.studies["sweep"], "samples": 400_000, "kernel": "numpy"}}
    lw.save(document.model_copy(update={"studies": studies}), model)
    command = [sys.executable, "-m", "linkwright", "sweep", str(model), "--out", str(tmp_path / "out")]
    process = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)
    begun = time.monotonic()
    while not (tmp_path / "out").exists() and time.monotonic() - begun < 60:
        time.sleep(0.05)
    time.sleep(2)
    process.send_signal(signal.SIGINT)
    _, told = process.communicate(timeout=60)
    assert process.returncode == 130
    assert "Interrupted: " in told
    assert "run the same command again to resume" in told
    assert {path.suffix for path in (tmp_path / "out").iterdir()} == {".samples", ".signals", ".json"}
