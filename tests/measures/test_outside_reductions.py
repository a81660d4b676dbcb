"""Reductions of other packages: one file each, made known by an entry point, with no other file changed."""

from __future__ import annotations

import copy
import csv
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from helpers.outside import linkwright, without_kinds

MODEL: dict[str, Any] = {
    "linkwright": 1,
    "units": {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"},
    "parameters": {"r": {"value": 100, "tolerance": 0.5}},
    "links": {"frame": {"points": {"A": [0, 0]}}, "crank": {"points": {"A": [0, 0], "B": ["r", 0]}}},
    "drives": {"motor": {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": 0}},
    "windows": {"half": ["0 s", "0.5 s"]},
    "measures": {
        "peaky": {"peak_to_peak_over_rms": "B.x + 50 mm"},
        "middle": {"median": "B.x", "window": "half"},
    },
    "require": {"peaky": "<= 3", "middle": "-1 .. 1 mm"},
    "studies": {"cycle": {"period": "1 s", "samples": 60}},
}
"""A crank of one turn: B.x = r cos(2 pi t)."""


def peaky(r: float) -> float:
    """The closed form, r in mm."""
    return 2 * r / float(np.sqrt(r**2 / 2 + 50**2))


def told(folder: Path, measures: Any = None, **studies: Any) -> tuple[Any, Path]:
    """The command line's run of the model with more studies."""
    data = copy.deepcopy(MODEL)
    data["studies"] |= studies
    data["measures"] |= measures or {}
    (folder / "model.yaml").write_text(json.dumps(data), encoding="utf-8")
    return linkwright(folder, "run", "model.yaml", "--out", "out"), folder / "out"


def test_it_is_measured_shown_and_held_to_its_limits(tmp_path: Path) -> None:
    done, out = told(tmp_path)
    assert done.returncode == 0, done.stderr
    entries = json.loads((out / "summary.json").read_text(encoding="utf-8"))["measures"]
    assert entries["peaky"]["value"] == pytest.approx(peaky(100), rel=1e-12)
    assert entries["middle"]["value"] == pytest.approx(0.0, abs=1e-9)
    assert (entries["middle"]["unit"], entries["middle"]["met"]) == ("mm", True)
    assert "peak_to_peak_over_rms of B.x + 50 mm" in (out / "report.html").read_text("utf-8").replace("\u00a0", " ")
    assert "median of B.x, window half" in (out / "report.html").read_text(encoding="utf-8")
    assert "peaky" in done.stdout


def test_its_key_is_in_the_schema_and_among_those_that_may_be_meant(tmp_path: Path) -> None:
    schema = json.loads(linkwright(tmp_path, "schema").stdout)
    (entry,) = schema["properties"]["measures"]["patternProperties"].values()
    assert {"median", "peak_to_peak_over_rms", "max"} <= entry["properties"].keys()
    done, _ = told(tmp_path, {"wrong": {"medain": "B.x"}})
    assert done.returncode == 2
    assert "Did you mean one of these: median, mean?" in done.stderr
    done, _ = told(tmp_path, {"wrong": {"median": "B.x", "max": "B.x"}})
    assert done.returncode == 2
    assert "max, median" in done.stderr


def test_without_its_package_its_key_is_unknown(tmp_path: Path) -> None:
    (tmp_path / "model.yaml").write_text(json.dumps(MODEL), encoding="utf-8")
    done = without_kinds(tmp_path, "check", "model.yaml")
    assert done.returncode == 2
    assert "peak_to_peak_over_rms" in done.stderr


@pytest.mark.parametrize("kernel", ["numpy", "llvm"])
def test_sweeps_take_it(tmp_path: Path, kernel: str) -> None:
    done, out = told(tmp_path, sweep={"vary": {"r": [90, 100, 130]}, "kernel": kernel})
    assert done.returncode == 0, done.stderr
    with (out / "sweep.csv").open(encoding="utf-8-sig") as file:
        rows = list(csv.DictReader(file))
    assert [float(row["peaky"]) for row in rows] == pytest.approx([peaky(r) for r in (90, 100, 130)], rel=1e-9)
    assert [float(row["middle [mm]"]) for row in rows] == pytest.approx([0, 0, 0], abs=1e-9)


def test_accuracy_takes_its_derivative(tmp_path: Path) -> None:
    done, out = told(tmp_path, accuracy={"outputs": ["peaky"], "samples": 0})
    assert done.returncode == 0, done.stderr
    found = json.loads((out / "summary.json").read_text(encoding="utf-8"))["accuracy"]["peaky"]
    slope = (peaky(100 + 1e-3) - peaky(100 - 1e-3)) / 2e-3
    assert found["contributors"][0]["coefficient"] == pytest.approx(slope, rel=1e-8)
    assert found["worst_case"]["deviation"] == pytest.approx([-slope / 2, slope / 2], rel=1e-8)


def test_accuracy_refuses_by_name_what_has_no_derivative(tmp_path: Path) -> None:
    done, _ = told(tmp_path, accuracy={"samples": 0})
    assert done.returncode == 2
    assert "no derivative of the reduction median" in done.stderr
    assert "peak_to_peak_over_rms" not in done.stderr
