"""What is written: whole files or none, a summary in strict JSON, a table with units."""

from __future__ import annotations

import csv
import json
import math
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import linkwright as lw
from app.models import SOUND, STUCK, UNMET
from linkwright.app import Writing, examine_file, perform, write

FILES = ["cycle.csv", "linkwright-manifest.json", "report.html", "summary.json"]


@pytest.fixture(scope="module")
def job(tmp_path_factory: pytest.TempPathFactory) -> lw.Job:
    path = tmp_path_factory.mktemp("model") / "four_bar.yaml"
    path.write_text(SOUND, "utf-8")
    return lw.run(path, path.parent / "out")


def job_of(folder: Path, text: str) -> lw.Job:
    path = folder / "model.yaml"
    path.write_text(text, "utf-8")
    return perform(examine_file(path))


def names(folder: Path) -> list[str]:
    """All entries of a folder, hidden ones too."""
    return sorted(p.name for p in folder.iterdir()) if folder.exists() else []


# Whole or not at all.


def break_replace(monkeypatch: pytest.MonkeyPatch, at: str, error: BaseException) -> None:
    """The rename into place fails for one file."""
    real = {"path": Path.replace, "os": os.replace, "rename": os.rename}

    def failing(name: str) -> Callable[..., Any]:
        def replace(source: Any, target: Any, **more: Any) -> Any:
            if Path(target).name == at:
                raise error
            return real[name](source, target, **more)

        return replace

    monkeypatch.setattr(Path, "replace", failing("path"))
    monkeypatch.setattr(os, "replace", failing("os"))
    monkeypatch.setattr(os, "rename", failing("rename"))


@pytest.mark.parametrize(
    "error", [OSError(28, "No space left on device"), KeyboardInterrupt()], ids=["full", "interrupt"]
)
@pytest.mark.parametrize("at", FILES)
def test_a_rename_that_fails_leaves_nothing_half_written(
    job: lw.Job, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, at: str, error: BaseException
) -> None:
    with monkeypatch.context() as patch:
        break_replace(patch, at, error)
        with pytest.raises(type(error)):
            write(job, tmp_path)
    assert set(names(tmp_path)) < set(FILES)
    assert at not in names(tmp_path)
    write(job, tmp_path)
    assert names(tmp_path) == FILES


@pytest.mark.parametrize("at", ["cycle.csv", "report.html", "summary.json"])
def test_a_failed_rename_keeps_the_file_that_was_there(
    job: lw.Job, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, at: str
) -> None:
    (tmp_path / at).write_text("of yesterday", "utf-8")
    break_replace(monkeypatch, at, OSError(5, "Input/output error"))
    with pytest.raises(OSError, match="Input/output"):
        write(job, tmp_path, Writing(force=True))
    assert (tmp_path / at).read_text("utf-8") == "of yesterday"
    assert set(names(tmp_path)) <= set(FILES)


def test_a_disc_that_is_full(job: lw.Job, tmp_path: Path) -> None:
    resource = pytest.importorskip("resource")
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, hard))  # no file may grow beyond it
    try:
        with pytest.raises(OSError):
            write(job, tmp_path)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    assert names(tmp_path) == []


def test_what_lies_there_is_replaced_and_the_rest_left_alone(job: lw.Job, tmp_path: Path) -> None:
    for name in [*FILES, "notes.txt"]:
        (tmp_path / name).write_text("old", "utf-8")
    write(job, tmp_path, Writing(force=True))
    assert names(tmp_path) == sorted([*FILES, "notes.txt"])
    assert (tmp_path / "notes.txt").read_text("utf-8") == "old"
    assert all((tmp_path / name).read_text("utf-8") != "old" for name in FILES)


@pytest.mark.skipif(os.name == "nt", reason="modes are POSIX's")
def test_files_can_be_read_by_whoever_may_read_new_files(job: lw.Job, tmp_path: Path) -> None:
    (tmp_path / "new").write_text("", "utf-8")
    write(job, tmp_path / "out")
    modes = {(tmp_path / "out" / name).stat().st_mode & 0o777 for name in FILES}
    assert modes <= {(tmp_path / "new").stat().st_mode & 0o777, 0o644}


@pytest.mark.skipif(os.name == "nt", reason="links are POSIX's")
def test_a_link_in_place_of_a_file_is_replaced(job: lw.Job, tmp_path: Path) -> None:
    (tmp_path / "kept.json").write_text("old", "utf-8")
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "summary.json").symlink_to(tmp_path / "kept.json")
    write(job, tmp_path / "out", Writing(force=True))
    assert not (tmp_path / "out" / "summary.json").is_symlink()
    assert (tmp_path / "kept.json").read_text("utf-8") == "old"


def test_a_folder_that_can_not_be_is_an_oserror(job: lw.Job, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("", "utf-8")
    with pytest.raises(OSError):
        write(job, tmp_path / "file" / "below")
    with pytest.raises(OSError):
        write(job, tmp_path / "file")


# The summary.


def read_summary(folder: Path) -> Any:
    def refuse(constant: str) -> None:
        raise AssertionError(f"{constant} is no JSON")

    return json.loads((folder / "summary.json").read_text("utf-8"), parse_constant=refuse)


def test_summary_of_a_sound_run(job: lw.Job) -> None:
    assert job.folder is not None
    data = read_summary(job.folder)
    assert data["linkwright"] == lw.__version__
    assert data["name"] == "Four-bar"
    assert data["done"] is True
    assert data["findings"] == []
    assert data["run"]["rows"] == 25
    assert data["run"]["unit"] == "s"
    assert (data["run"]["start"], data["run"]["stop"]) == (0.0, pytest.approx(0.5))
    assert list(data["measures"]) == ["swing", "torque"]


def test_measures_in_the_summary(job: lw.Job) -> None:
    """``value`` and ``unit``, or ``min`` and ``max``; in the file's units."""
    measures = read_summary(job.folder)["measures"]  # type: ignore[arg-type]
    assert job.cycle is not None
    angle = job.cycle.result.shown("rocker.angle")[0]
    swing, torque = measures["swing"], measures["torque"]
    assert swing["unit"] == "deg"
    assert swing["value"] == pytest.approx(float(np.ptp(angle)), rel=5e-3)
    assert swing["value"] >= float(np.ptp(angle))
    assert (swing["require"], swing["met"]) == ("70 deg .. 80 deg", True)
    assert torque["unit"] == "N*mm"
    samples = job.cycle.result["motor.torque"] * 1000
    assert torque["min"] == pytest.approx(float(samples.min()), rel=0.05)
    assert torque["max"] >= float(samples.max())
    assert set(torque["at"]) == {"min", "max"}
    assert torque["at_unit"] == "s"
    assert "value" not in torque
    assert "met" not in torque


def test_the_certificate_in_the_summary(job: lw.Job) -> None:
    data = read_summary(job.folder)["certificate"]  # type: ignore[arg-type]
    for name in ("closure", "equilibrium", "power", "work"):
        assert 0 <= data[name] < 1e-9
    assert (data["mobility"], data["gruebler"], data["rank"], data["loops"]) == (1, 1, 8, 1)
    assert 0 < data["smallest_determinant"] <= 1
    place = data["smallest_determinant_at"]
    assert place["group"] == "coupler-rocker"
    assert place["unit"] == "s"
    assert 0 <= place["time"] <= 0.5
    assert data["branches"] == {"coupler-rocker": "B: left of A-O4"}
    assert data["kernel"] == "numpy"
    assert data["poses"] == 25


def test_summary_of_runs_that_fail(tmp_path: Path) -> None:
    for text, code in ((STUCK, "motion.cannot-assemble"), (UNMET, None)):
        job = job_of(tmp_path, text)
        write(job, tmp_path / "out")
        data = read_summary(tmp_path / "out")
        assert data["done"] is False
        assert [f["code"] for f in data["findings"]] == ([code] if code else [])
    assert data["measures"]["swing"]["met"] is False


@pytest.mark.parametrize("signal", ["P.x/0", "1/(P.x - P.x)", "log(-a/b)"])
def test_what_is_no_number_is_left_out_of_the_summary(tmp_path: Path, signal: str) -> None:
    text = SOUND.replace("{span: rocker.angle}", f'{{max: "{signal}"}}').replace(
        "  swing: 70 deg .. 80 deg", "  torque: '>= -1e9'"
    )
    job = job_of(tmp_path, text)
    write(job, tmp_path / "out")
    data = read_summary(tmp_path / "out")
    assert "value" not in data["measures"]["swing"]
    assert data["done"] is False


def test_units_of_time_in_the_summary(tmp_path: Path) -> None:
    text = SOUND.replace("time: s", "time: ms").replace("-9.80665 m/s^2", "-9.80665 m/s^2")
    job = job_of(tmp_path, text)
    assert job.examined.findings == []
    assert job.summary["run"]["unit"] == "ms"
    assert job.summary["run"]["stop"] == pytest.approx(500.0)
    assert job.summary["measures"]["torque"]["at_unit"] == "ms"
    assert 0 <= job.summary["measures"]["torque"]["at"]["max"] <= 500
    assert job.summary["certificate"]["smallest_determinant_at"]["unit"] == "ms"


def test_a_name_in_any_script(tmp_path: Path) -> None:
    job = job_of(tmp_path, SOUND.replace("name: Four-bar", "name: 四连杆机构 – „Größe“"))
    write(job, tmp_path / "out")
    assert read_summary(tmp_path / "out")["name"] == "四连杆机构 – „Größe“"
    assert "四连杆机构" in (tmp_path / "out" / "report.html").read_text("utf-8")


# The table.


def read_table(folder: Path) -> tuple[list[str], list[list[str]]]:
    with (folder / "cycle.csv").open(newline="", encoding="utf-8") as stream:
        header, *rows = csv.reader(stream)
    return header, rows


def test_the_table_has_a_column_for_every_signal(job: lw.Job) -> None:
    header, rows = read_table(job.folder)  # type: ignore[arg-type]
    assert job.cycle is not None
    result = job.cycle.result
    assert header[0] == "t [s]"
    assert len(header) == 1 + len(result.names)
    assert len(set(header)) == len(header)
    assert len(rows) == 25
    assert {len(row) for row in rows} == {len(header)}
    for column, name in enumerate(result.names, start=1):
        values, unit = result.shown(name)
        assert header[column] == (f"{name} [{unit}]" if unit else name)
        assert [float(row[column]) for row in rows] == values.tolist()
    assert [float(row[0]) for row in rows] == result.t.tolist()


@pytest.mark.parametrize(
    ("name", "unit"),
    [
        ("P.x", "mm"), ("P.vy", "mm/s"), ("P.ax", "mm/s^2"), ("P.jy", "mm/s^3"), ("rocker.angle", "deg"),
        ("rocker.omega", "deg/s"), ("rocker.alpha", "deg/s^2"), ("rocker.jerk", "deg/s^3"), ("motor.torque", "N*m"),
        ("motor.power", "W"), ("shaking.x", "N"), ("shaking.moment", "N*m"), ("energy.kinetic", "J"),
    ],
)  # fmt: skip
def test_units_in_the_header(job: lw.Job, name: str, unit: str) -> None:
    assert f"{name} [{unit}]" in read_table(job.folder)[0]  # type: ignore[arg-type]


def test_numbers_survive_the_table(job: lw.Job) -> None:
    """Written with all digits: what is read back is what was computed."""
    header, rows = read_table(job.folder)  # type: ignore[arg-type]
    assert job.cycle is not None
    column = header.index("P.x [mm]")
    assert np.array([float(row[column]) for row in rows]) / 1000 == pytest.approx(job.cycle.result["P.x"], rel=1e-15)


def test_blank_where_nothing_is_known(tmp_path: Path) -> None:
    job = job_of(tmp_path, STUCK)
    write(job, tmp_path / "out")
    header, rows = read_table(tmp_path / "out")
    assert job.cycle is not None
    known = np.isfinite(job.cycle.result["B.x"])
    assert 0 < known.sum() < 25
    for name in ("B.x [mm]", "coupler.angle [deg]", "motor.torque [N*m]"):
        column = header.index(name)
        assert [row[column] != "" for row in rows] == known.tolist()
    column = header.index("A.x [mm]")
    assert all(row[column] for row in rows)


def test_no_word_of_infinity_in_the_table(tmp_path: Path) -> None:
    """The jerk of (t/s)^2.5 is infinite at t = 0: unknown, not a word that no spreadsheet reads."""
    law = "position: 40 deg + 90 deg*(t/(1 s))^2.5"
    text = SOUND.replace("speed: 120 rpm, start: 40 deg", law).replace("turns: 1 motor", "duration: 0.5 s")
    job = job_of(tmp_path, text)
    assert job.examined.findings == []
    write(job, tmp_path / "out")
    cells = {cell for row in read_table(tmp_path / "out")[1] for cell in row}
    assert not [cell for cell in cells if cell and not math.isfinite(float(cell))]


def test_to_csv_gives_the_text_and_writes_it(job: lw.Job, tmp_path: Path) -> None:
    assert job.cycle is not None
    text = job.cycle.result.to_csv()
    assert job.cycle.result.to_csv(tmp_path / "table.csv") == text
    assert (tmp_path / "table.csv").read_text("utf-8") == text
    assert names(tmp_path) == ["table.csv"]
    assert text == (job.folder / "cycle.csv").read_text("utf-8")  # type: ignore[operator]
