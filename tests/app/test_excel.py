"""``--excel``: CSV files begin with the mark by which Excel knows UTF-8, nothing else differs, and all is read back."""

from __future__ import annotations

import json
import re
from codecs import BOM_UTF8
from pathlib import Path

import pytest
from click.testing import CliRunner

from linkwright.app.manifest import NAME
from linkwright.cli import cli

MODEL = """\
linkwright: 1
name: 曲柄摇杆机构
units: {length: mm, angle: deg, mass: kg, time: s, force: N, torque: N*m}
parameters:
  曲柄长: {value: 60, tolerance: 0.05}
links:
  frame: {points: {A: [0, 0], D: [200, 0]}}
  曲柄: {points: {A: [0, 0], B: [曲柄长, 0]}}
  连杆: {points: {B: [0, 0], C: [190, 0]}}
  摇杆: {points: {D: [0, 0], C: [120, 0]}}
assembly: {C: left of B-D}
drives:
  电机: {turns: 曲柄, on: frame, speed: 60 rpm, start: 0 deg}
measures:
  摆幅: {span: 摇杆.angle}
studies:
  cycle: {turns: 1 电机, samples: 12}
  sweep: {vary: {曲柄长: {from: 58, to: 62, count: 3}}, outputs: [摆幅]}
  accuracy: {outputs: [摇杆.angle], samples: 0}
exports:
  motor-expressions: {}
"""


def call(*words: object) -> None:
    result = CliRunner().invoke(cli, [*map(str, words)], catch_exceptions=False)
    assert result.exit_code == 0, result.output


@pytest.fixture
def model(tmp_path: Path) -> Path:
    (path := tmp_path / "机构.yaml").write_text(MODEL, "utf-8")
    return path


WORDS = [["run"], ["sweep"], ["accuracy"], ["export", "--to", "mjcf"], ["export", "--to", "motor-expressions"]]


@pytest.mark.parametrize("words", WORDS, ids=" ".join)
def test_only_the_mark_is_added(words: list[str], model: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "1750000000")
    call(words[0], model, *words[1:], "--out", tmp_path / "plain")
    call(words[0], model, *words[1:], "--out", tmp_path / "excel", "--excel")
    names = sorted(path.name for path in (tmp_path / "plain").iterdir())
    assert names == sorted(path.name for path in (tmp_path / "excel").iterdir())
    tables = [name for name in names if name.endswith(".csv")]
    assert tables
    for name in names:
        plain, excel = ((tmp_path / folder / name).read_bytes() for folder in ("plain", "excel"))
        assert not plain.startswith(BOM_UTF8)
        if name == NAME:  # it holds the sizes and hashes of the others
            assert [*json.loads(plain)] == [*json.loads(excel)]
        else:
            assert excel == (BOM_UTF8 if name in tables else b"") + plain


def test_the_mark_stands_before_comments(model: Path, tmp_path: Path) -> None:
    call("run", model, "--out", tmp_path / "out", "--excel", "--csv-comments")
    assert (tmp_path / "out" / "cycle.csv").read_bytes().startswith(BOM_UTF8 + b"# linkwright ")


def test_files_with_the_mark_are_replaced_as_linkwrights_own(model: Path, tmp_path: Path) -> None:
    for words in ([], ["--excel"], []):
        call("run", model, "--out", tmp_path / "out", *words)


@pytest.mark.parametrize("command", ["run", "sweep", "accuracy", "workspace", "cam", "export", "limits", "new"])
def test_commands_that_write_tables_have_the_option(command: str) -> None:
    text = CliRunner().invoke(cli, [command, "--help"]).output
    assert ("--excel" in text) == ("--csv-comments" in text or command == "new")
    assert command == "limits" or "--excel" in text


def test_a_table_to_fill_in_is_read_back(tmp_path: Path) -> None:
    for words in ([], ["--excel"]):
        call("new", "hinge", "--table", "--force", "--out", tmp_path / "铰链.csv", *words)
        assert (tmp_path / "铰链.csv").read_bytes().startswith(BOM_UTF8) == bool(words)
        call("export", tmp_path / "铰链.csv", "--to", "process-simulate", "--out", tmp_path / "out")


def test_a_result_with_the_mark_is_a_table_of_another_model(model: Path, tmp_path: Path) -> None:
    call("run", model, "--out", tmp_path, "--excel", "--force")
    head = (tmp_path / "cycle.csv").read_text("utf-8-sig").splitlines()[0].split(",")
    assert head[0] == "t [s]"
    (tmp_path / "表.csv").write_bytes(BOM_UTF8 + "时间,转角\r\n0,0\r\n0.3,30\r\n0.6,60\r\n1,100\r\n".encode())
    tables = "tables:\n  规律: {file: 表.csv, x: 时间 s, y: 转角 deg}\nassembly:"
    text = MODEL.replace("assembly:", tables).replace("speed: 60 rpm, start: 0 deg", "position: 规律(t)")
    text = text[: text.index("studies:")] + "studies:\n  cycle: {duration: 1 s, samples: 12}\n"
    (tmp_path / "表.yaml").write_text(text, "utf-8")
    call("run", tmp_path / "表.yaml", "--out", tmp_path / "out")


ENGLISH = {
    "t [s]": "time, as signals are called",
    "摇杆.angle": "a signal",
    "曲柄长": "a parameter",
    "摆幅": "a measure",
    "d(": "a sensitivity",
}
"""Beginnings of heads that have no words of the program, or only behind a name."""


@pytest.mark.parametrize("language", ["zh", "en"])
def test_heads_are_in_the_language(model: Path, tmp_path: Path, language: str) -> None:
    """With the mark for spreadsheets, the columns that a study brings itself have Chinese heads; their units, the names
    of the model and all values stay. In English, and without the mark, the heads are those of programs."""
    folder, plain = tmp_path / "out", tmp_path / "plain"
    call("--lang", language, "run", model, "-o", folder, "--excel")
    call("--lang", language, "run", model, "-o", plain)
    files = [name for name in ("accuracy.csv", "accuracy_bands.csv", "sweep.csv") if (folder / name).exists()]
    assert len(files) == 3
    for name in files:
        mine, theirs = ((each / name).read_text("utf-8-sig").split("\n") for each in (folder, plain))
        assert mine[1:] == theirs[1:]
        if language == "en":
            assert mine == theirs
            continue
        heads = list(zip(mine[0].split(","), theirs[0].split(","), strict=True))
        assert len([1 for head, before in heads if head != before]) >= 2, name
        for head, before in heads:
            assert head.partition(" [")[2] == before.partition(" [")[2]
            if not before.startswith(tuple(ENGLISH)):
                assert re.search("[\u4e00-\u9fff]", head), (name, head)
            elif " " in before.partition(" [")[0]:
                assert re.search("[\u4e00-\u9fff]", head.partition(" ")[2]), (name, head)
