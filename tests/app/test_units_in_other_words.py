"""Units that aren't known: wherever a unit stands by itself, the one that is meant is proposed."""

from __future__ import annotations

from pathlib import Path

import pytest

import linkwright as lw
from linkwright.app.batch import export_batch
from linkwright.findings import Finding
from linkwright.words import in_language

MODEL = """linkwright: 1
units: {length: mm, angle: deg, time: s}
links:
  frame: {points: {A: [0, 0]}}
  crank: {points: {A: [0, 0], B: [50, 0]}}
drives: {motor: {turns: crank, on: frame, speed: 45 rpm, start: 0 deg}}
measures: {peak: {max: abs(crank.omega), unit: UNIT}}
tables: {rise: {file: rise.csv, x: a COLUMN, y: b}}
studies: {cycle: {turns: 1 motor}}
"""


def in_model(folder: Path, unit: str, column: str) -> list[Finding]:
    (folder / "model.yaml").write_text(MODEL.replace("UNIT", unit).replace("COLUMN", column), encoding="utf-8")
    (folder / "rise.csv").write_text("a,b\n0,0\n1,1\n2,0\n", encoding="utf-8")
    return lw.check(folder / "model.yaml")


@pytest.mark.parametrize(("unit", "meant"), [("转/分", "rpm"), ("弧度/秒", "rad/s"), ("deg/sec", "deg/s")])
def test_units_of_measures(unit: str, meant: str, tmp_path: Path) -> None:
    (found,) = in_model(tmp_path, unit, "deg")
    assert found.code == "units.unknown"
    for language in ("en", "zh"):
        with in_language(language):
            assert meant in found.mend and "kg" not in found.mend


@pytest.mark.parametrize(("unit", "meant"), [("度", "deg"), ("毫米", "mm")])
def test_units_of_columns(unit: str, meant: str, tmp_path: Path) -> None:
    (found,) = in_model(tmp_path, "rpm", unit)
    assert found.code == "units.unknown" and f"'{meant}'" in found.mend


def test_units_of_batches(tmp_path: Path) -> None:
    file = tmp_path / "hinges.csv"
    file.write_text("name,x1 [毫米],opening [度]\nA,60,35\n", encoding="utf-8")
    found = export_batch(file, "process-simulate", tmp_path / "out").examined.findings
    assert [(one.code, meant in one.mend) for one, meant in zip(found, ("mm", "deg"), strict=True)] == [
        ("units.unknown", True)
    ] * 2


def test_what_means_no_unit_gets_the_usual_ones(tmp_path: Path) -> None:
    (found,) = in_model(tmp_path, "furlong", "deg")
    assert "mm, deg, kg" in found.mend
