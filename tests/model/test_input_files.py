"""Files that a model names: regular ones of bounded size alone, read without a wait."""

from __future__ import annotations

import os
import socket
import threading
from pathlib import Path

import pytest

import linkwright as lw
from linkwright.model.input_files import read_at_most, read_beside

posix = pytest.mark.skipif(os.name != "posix", reason="no such files there")
MODEL = """linkwright: 1
units: {length: mm, angle: deg, time: s}
links:
  frame: {points: {A: [0, 0]}}
  crank: {points: {A: [0, 0], B: [10, 0]}}
tables:
  rise: {file: rise.csv, x: time s, y: angle deg}
drives:
  motor: {turns: crank, on: frame, position: rise(t)}
studies:
  cycle: {duration: 1 s, samples: 8}
"""
RISE = "time,angle\n0,0\n1,1\n2,3\n3,7\n"


def beside(path: Path) -> str:
    """The code with which a file is refused, or nothing."""
    try:
        read_beside(path.name, path.parent, ("tables", "a", "file"))
    except lw.ModelError as error:
        (finding,) = error.findings
        assert finding.path == ("tables", "a", "file")
        assert finding.what and finding.mend
        return finding.code
    return ""


def answered(path: Path) -> str:
    """The same, where reading must not wait for anybody."""
    codes: list[str] = []
    thread = threading.Thread(target=lambda: codes.append(beside(path)), daemon=True)
    thread.start()
    thread.join(20)
    assert codes, "it waits"
    return codes[0]


def test_a_link_to_a_file_is_read(tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_bytes(b"a")
    try:
        (tmp_path / "link.csv").symlink_to("a.csv")
    except OSError:
        pytest.skip("no links here")
    assert read_beside("link.csv", tmp_path, ()) == b"a"


def test_a_folder_is_refused(tmp_path: Path) -> None:
    assert beside(tmp_path) == "file.irregular"


@posix
def test_devices_pipes_and_sockets_are_refused(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.csv")
    (tmp_path / "device.csv").symlink_to("/dev/zero")
    (tmp_path / "loop.csv").symlink_to("loop.csv")
    (tmp_path / "gone.csv").symlink_to("nowhere")
    assert answered(tmp_path / "pipe.csv") == "file.irregular"
    assert answered(tmp_path / "device.csv") == "file.irregular"
    assert answered(tmp_path / "loop.csv") == "table.unreadable"
    assert answered(tmp_path / "gone.csv") == "table.unreadable"
    place = tmp_path / "s"
    try:
        with socket.socket(socket.AF_UNIX) as one:
            one.bind(str(place))
            assert answered(place) == "file.irregular"
    except OSError:
        pytest.skip("the path is too long for a socket")


def test_a_file_is_read_up_to_the_limit(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("linkwright.model.input_files.MAX_BYTES", 5)
    path = tmp_path / "a.csv"
    path.write_bytes(b"12345")
    assert beside(path) == ""
    path.write_bytes(b"123456")
    assert beside(path) == "table.too-large"
    assert read_at_most(path, 3) == b"1234"


@posix
def test_a_file_without_a_stated_size_is_bounded_too() -> None:
    path = Path("/proc/self/maps")
    if not path.exists():
        pytest.skip("no such file here")
    assert path.stat().st_size == 0
    assert len(read_at_most(path, 10)) == 11


@pytest.mark.parametrize("name", ["a\0b", "x" * 300, "\ud800"])
def test_names_that_no_file_can_have(tmp_path: Path, name: str) -> None:
    assert beside(tmp_path / name) == "table.unreadable"


@posix
def test_a_model_that_names_a_pipe_or_is_one(tmp_path: Path) -> None:
    (tmp_path / "model.yaml").write_text(MODEL, encoding="utf-8")
    os.mkfifo(tmp_path / "rise.csv")
    (finding,) = lw.check(tmp_path / "model.yaml")
    assert (finding.code, finding.element, finding.line) == ("file.irregular", "tables.rise.file", 7)
    assert "rise.csv is a named pipe" in finding.what
    (finding,) = lw.check(tmp_path / "rise.csv")
    assert finding.code == "file.irregular"
    with pytest.raises(lw.ModelError, match="named pipe"):
        lw.load(tmp_path / "rise.csv")
    with pytest.raises(lw.ModelError, match="named pipe"):
        lw.sweep(tmp_path / "rise.csv")
    with pytest.raises(lw.ModelError, match="named pipe"):
        lw.export(tmp_path / "rise.csv", "mjcf")


@posix
def test_a_results_folder_with_a_pipe_for_its_manifest(tmp_path: Path) -> None:
    (tmp_path / "model.yaml").write_text(MODEL, encoding="utf-8")
    (tmp_path / "rise.csv").write_text(RISE, encoding="utf-8")
    lw.run(tmp_path / "model.yaml", tmp_path / "out")
    (manifest,) = (tmp_path / "out").glob("*manifest*")
    manifest.unlink()
    os.mkfifo(manifest)
    with pytest.raises(lw.ModelError):
        lw.run(tmp_path / "model.yaml", tmp_path / "out")


def test_a_file_that_nothing_uses_may_be_gone_in_a_sweep(tmp_path: Path) -> None:
    """Its table isn't read, and nothing depends on it."""
    used = MODEL.replace("rise(t)", "10 deg/s*t*k").replace("tables:", "parameters: {k: 1}\ntables:")
    sweep = "  sweep: {vary: {k: {from: 1, to: 2, count: 3}}, outputs: [crank.angle]}\n"
    (tmp_path / "model.yaml").write_text(used + sweep, encoding="utf-8")
    assert lw.run(tmp_path / "model.yaml").exit_code == 0
