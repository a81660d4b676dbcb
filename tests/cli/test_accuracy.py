"""``linkwright accuracy``: the study alone, for people and as JSON."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

import linkwright as lw
from app.test_accuracies import model
from linkwright.cli import cli


@pytest.fixture
def file(tmp_path: Path) -> Path:
    lw.save(model(), tmp_path / "model.yaml")
    return tmp_path / "model.yaml"


def call(*words: object) -> Result:
    return CliRunner().invoke(cli, [str(word) for word in words], catch_exceptions=False)


def test_the_study_alone(file: Path, tmp_path: Path) -> None:
    result = call("accuracy", file, "--out", tmp_path / "out", "--samples", 100, "--workers", 1, "--fresh")
    assert result.exit_code == 0
    assert "3 contributors; 100 random samples, computed with the numpy kernel." in result.stdout
    for text in ("stroke", "100.879 mm", "-0.11", "maximum: ", "far: 0.01518", "r 99 %"):
        assert text in result.stdout
    assert {path.name for path in (tmp_path / "out").iterdir()} == {
        "linkwright-manifest.json", "report.html", "summary.json", "accuracy.csv", "accuracy_bands.csv",
    }  # fmt: skip


def test_json(file: Path) -> None:
    result = call("accuracy", file, "--samples", 0, "--json")
    assert result.exit_code == 0
    data = json.loads(result.stdout)
    assert list(data["accuracy"]) == ["stroke", "C.x"]
    assert data["accuracy"]["stroke"]["monte_carlo"] is None


def test_a_file_without_tolerances(tmp_path: Path) -> None:
    lw.save(model(toleranced=False), tmp_path / "model.yaml")
    result = call("accuracy", tmp_path / "model.yaml")
    assert result.exit_code == 2
    assert "tolerance.none" in result.stderr
