"""Interrupted and killed workspace studies: the files of the resumed one are byte for byte those of a whole one."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner, Result

import linkwright as lw
from helpers.workspaces import arm
from linkwright.app.job import Job, carry_out, examine_file
from linkwright.app.manifest import NAME
from linkwright.cli import cli
from linkwright.model.document import parse_document
from linkwright.studies.interruption import Stopped
from linkwright.studies.run_context import RunContext
from linkwright.studies.workspace.region_files import FOLDER

DATE = ("SOURCE_DATE_EPOCH", "1700000000")
MANY = {"chord": 1e-4, "for": {"b": [*range(20, 32)]}}


@pytest.fixture(autouse=True)
def _one_date(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(*DATE)


def saved(path: Path, **options: Any) -> Path:
    document = parse_document(arm(**options))
    assert document is not None
    lw.save(document, path)
    return path


FIVE = {"chord": 1e-3, "for": {"b": [30, 35, 20, 25, 28]}}


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return saved(tmp_path / "arm.yaml", **FIVE)


@pytest.fixture(scope="module")
def whole_file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What such a file gives when nothing stops it."""
    folder = tmp_path_factory.mktemp("whole")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv(*DATE)
        lw.run(saved(folder / "arm.yaml", **FIVE), folder / "out")
    return folder / "out"


@pytest.fixture(scope="module")
def long(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A study of some seconds."""
    return saved(tmp_path_factory.mktemp("long") / "long.yaml", **MANY)


@pytest.fixture(scope="module")
def whole(long: Path) -> dict[str, bytes]:
    """What it writes when nothing stops it."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv(*DATE)
        assert call("workspace", long, "--out", long.parent / "whole").exit_code == 0
    return contents(long.parent / "whole")


def interrupted(file: Path, out: Path, after: int = 2) -> Job:
    def told(done: int, total: int) -> None:
        if done >= after:
            raise KeyboardInterrupt

    job = carry_out(examine_file(file), RunContext(out=out, progress=told))
    assert job.exit_code == 130
    return job


def call(*words: object) -> Result:
    return CliRunner().invoke(cli, [str(word) for word in words], catch_exceptions=False)


def contents(folder: Path) -> dict[str, bytes]:
    """All files of a folder, but the manifest; of a DXF its entities, as its head has a time and a random number."""
    found = {path.name: path.read_bytes() for path in folder.iterdir() if path.is_file() and path.name != NAME}
    return {
        name: content.partition(b"ENTITIES")[2].partition(b"ENDSEC")[0] if name.endswith(".dxf") else content
        for name, content in found.items()
    }


def resumable(out: Path) -> dict[str, str]:
    found: dict[str, str] = json.loads((out / NAME).read_text("utf-8"))["written"]["studies"].get("resumable", {})
    return found


def test_resumed_it_writes_the_same_bytes(file: Path, tmp_path: Path) -> None:
    """And the folder then holds nothing else, with no word of it in the manifest."""
    saved(file, chord=1e-3, quality={"steps": 20}, **{"for": {"b": [30, 35, 20, 25]}})
    assert call("workspace", file, "--out", tmp_path / "whole").exit_code == 0
    interrupted(file, tmp_path / "out")
    kept = [*(tmp_path / "out" / FOLDER).iterdir()]
    assert 2 <= len(kept) < 4
    assert resumable(tmp_path / "out") == {FOLDER: "workspace"}
    assert call("workspace", file, "--out", tmp_path / "out").exit_code == 0
    assert contents(tmp_path / "out") == contents(tmp_path / "whole")
    assert {"summary.json", "workspace.geojson", "workspace_boundary.csv", "workspace_maps.csv"} <= contents(
        tmp_path / "out"
    ).keys()
    assert [path for path in (tmp_path / "out").iterdir() if path.is_dir()] == []
    assert resumable(tmp_path / "out") == {}


def test_interrupted_twice_it_keeps_what_both_have_done(file: Path, whole_file: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    interrupted(file, out, 1)
    first = {path.name for path in (out / FOLDER).iterdir()}
    interrupted(file, out, len(first) + 1)
    assert first < {path.name for path in (out / FOLDER).iterdir()}
    lw.run(file, out)
    assert contents(out) == contents(whole_file)


def test_a_changed_file_takes_nothing_that_is_stale(file: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    interrupted(file, out)
    text = file.read_text("utf-8")
    file.write_text(text.replace("a: 40", "a: 41"), "utf-8")
    assert file.read_text("utf-8") != text
    lw.run(file, out)
    lw.run(file, tmp_path / "whole")
    assert contents(out) == contents(tmp_path / "whole")


def test_a_damaged_part_is_found_again_with_a_note(file: Path, whole_file: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    interrupted(file, out)
    path = min((out / FOLDER).iterdir())
    path.write_bytes(path.read_bytes()[:-100])
    result = call("workspace", file, "--out", out)
    assert result.exit_code == 0
    damaged, whole = (json.loads((folder / "summary.json").read_text("utf-8")) for folder in (out, whole_file))
    (note,) = damaged.pop("findings")
    assert (note["code"], note["severity"]) == ("workspace.part-damaged", "note") and path.name in note["what"]
    assert whole.pop("findings") == [] and damaged == whole
    assert "workspace.part-damaged" in result.output


def test_regions_of_another_version_are_refused(file: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with monkeypatch.context() as patch:
        patch.setattr("linkwright._version.__version__", "0.0.9")
        interrupted(file, tmp_path / "out")
    result = call("workspace", file, "--out", tmp_path / "out")
    assert (result.exit_code, "started with linkwright 0.0.9" in result.stderr) == (2, True)
    assert call("workspace", file, "--out", tmp_path / "out", "--fresh").exit_code == 0


def test_fresh_restarts(file: Path, whole_file: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    interrupted(file, out)
    for path in (out / FOLDER).iterdir():
        path.write_bytes(b"damaged")
    result = call("workspace", file, "--out", out, "--fresh")
    assert result.exit_code == 0 and "workspace.part-damaged" not in result.output
    assert contents(out) == contents(whole_file)
    saved(file, chord=1e-3)
    interrupted(file, tmp_path / "python", 1)
    for path in (tmp_path / "python" / FOLDER).iterdir():
        path.write_bytes(b"damaged")
    assert lw.workspace(file, out=tmp_path / "python", fresh=True).warnings == []


def test_from_python(file: Path, whole_file: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Interrupted in ``lw.workspace``, resumed by the same call."""

    def interrupting(*given: Any) -> Any:
        raise KeyboardInterrupt

    with monkeypatch.context() as patch, pytest.raises(Stopped) as stopped:
        patch.setattr("linkwright.studies.workspace.parallel.wait", interrupting)
        lw.workspace(file, out=tmp_path / "out")
    assert "resumes" in stopped.value.outcome.failures[-1].mend
    assert [*(tmp_path / "out" / FOLDER).iterdir()]
    assert lw.workspace(file, out=tmp_path / "out").done
    assert contents(tmp_path / "out") == contents(whole_file)


def test_a_section_of_the_file_can_be_left_out(file: Path) -> None:
    saved(file, chord=1e-3, quality={"steps": 20})
    assert "quality" in lw.workspace(file).parts
    assert not lw.workspace(file, options={"quality": None}).parts


def test_a_foreign_folder_of_that_name_is_not_touched(file: Path, tmp_path: Path) -> None:
    (tmp_path / "out" / FOLDER).mkdir(parents=True)
    (tmp_path / "out" / FOLDER / "mine").write_text("mine", "utf-8")
    result = call("workspace", file, "--out", tmp_path / "out")
    assert result.exit_code == 2 and FOLDER in result.stderr
    assert (tmp_path / "out" / FOLDER / "mine").read_text("utf-8") == "mine"


def begun(file: Path, out: Path) -> subprocess.Popen[bytes]:
    """A process that has kept a region and goes on."""
    command = [sys.executable, "-m", "linkwright", "workspace", str(file), "--out", str(out)]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    since = time.monotonic()
    while not [*(out / FOLDER).glob("*.region")] and time.monotonic() - since < 60 and process.poll() is None:
        time.sleep(0.005)
    return process


def test_killed_it_is_resumed(long: Path, whole: dict[str, bytes], tmp_path: Path) -> None:
    """``kill -9`` of a process, while it computes regions."""
    out = tmp_path / "out"
    with begun(long, out) as process:
        process.kill()
    assert process.returncode not in (0, 1, 2, 130)
    kept = {path: path.stat().st_mtime_ns for path in (out / FOLDER).glob("*.region")}
    assert 1 <= len(kept) < len(MANY["for"]["b"])
    assert not (out / "summary.json").exists()
    interrupted(long, out, len(kept) + 1)
    assert all(path.stat().st_mtime_ns == since for path, since in kept.items())  # taken, not written again
    assert call("workspace", long, "--out", out).exit_code == 0
    assert contents(out) == whole


def test_two_at_once(long: Path, whole: dict[str, bytes], tmp_path: Path) -> None:
    """The second is refused; the first loses nothing."""
    out = tmp_path / "out"
    with begun(long, out) as first:
        second = call("workspace", long, "--out", out)
        _, complaint = first.communicate(timeout=120)
    assert first.returncode == 0, complaint
    assert (second.exit_code, "folder.busy-with" in second.stderr) == (2, True)
    assert contents(out) == whole


@pytest.mark.skipif(sys.platform == "win32", reason="signals are POSIX's")
def test_ctrl_c_says_how_to_resume(long: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    with begun(long, out) as process:
        process.send_signal(signal.SIGINT)
        _, told = process.communicate(timeout=60)
    assert process.returncode == 130 and b"Interrupted after" in told
    summary = json.loads((out / "summary.json").read_text("utf-8"))
    assert "resumes" in summary["findings"][0]["mend"]
    assert resumable(out) == {FOLDER: "workspace"}
