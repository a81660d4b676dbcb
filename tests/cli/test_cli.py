"""The command line in process: what it prints, where, and its exit codes."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import click
import jsonschema
import pytest
from click.testing import CliRunner, Result

import linkwright
from app.models import FORM, FORM_LINES, KINDS, NAMES, NAMES_LINES, NO_STUDY, SOUND, STUCK, UNMET, WARNED
from linkwright.cli import cli, main

FILES = ["cycle.csv", "linkwright-manifest.json", "report.html", "summary.json"]
EXAMPLES = Path(__file__).parents[2] / "examples"


def call(*words: Any) -> Result:
    """One command; a crash is passed on, so that a test shows its traceback."""
    return CliRunner().invoke(cli, [str(word) for word in words], catch_exceptions=False)


@pytest.fixture
def model(tmp_path: Path) -> Any:
    def write(text: str, name: str = "model.yaml") -> Path:
        path = tmp_path / name
        path.write_text(text, "utf-8", newline="\n")
        return path

    return write


def names(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.iterdir())


# Help and version.


@pytest.mark.parametrize("flag", ["--help", "-h"])
def test_help(flag: str) -> None:
    result = call(flag)
    assert result.exit_code == 0
    assert {"run", "check", "schema"} <= set(result.stdout.split())
    for command in ("run", "check", "schema"):
        page = call(command, flag)
        assert page.exit_code == 0
        assert "Usage" in page.stdout


def test_every_option_says_what_it_does() -> None:
    for name, command in cli.commands.items():
        assert command.help, name
        for parameter in command.params:
            if isinstance(parameter, click.Option):
                assert parameter.help, (name, parameter.name)


def test_version() -> None:
    result = call("--version")
    assert result.exit_code == 0
    assert linkwright.__version__ in result.stdout
    assert "linkwright" in result.stdout


@pytest.mark.parametrize(
    "words",
    [
        ["fly"],
        ["--wings"],
        ["run"],
        ["check"],
        ["run", "a.yaml", "b.yaml"],
        ["run", "a.yaml", "--out"],
        ["run", "a.yaml", "--wings"],
        ["check", "a.yaml", "--out", "x"],
        ["schema", "a.yaml"],
        [],
    ],
)
def test_a_wrong_command_is_2(words: list[str], monkeypatch: pytest.MonkeyPatch, capsys: Any) -> None:
    """By the entry point itself, as the shell sees it."""
    monkeypatch.setattr("sys.argv", ["linkwright", *words])
    with pytest.raises(SystemExit) as left:
        main()
    assert left.value.code == 2
    printed = capsys.readouterr()
    assert printed.out == ""
    assert "Usage" in printed.err or "Error" in printed.err
    assert "Traceback" not in printed.err


@pytest.mark.parametrize("words", [["--help"], ["--version"], ["run", "--help"], ["schema"]])
def test_the_entry_point_leaves_with_0(words: list[str], monkeypatch: pytest.MonkeyPatch, capsys: Any) -> None:
    monkeypatch.setattr("sys.argv", ["linkwright", *words])
    try:
        main()
    except SystemExit as left:
        assert not left.code
    assert capsys.readouterr().out


# Check.


def test_check_says_what_a_file_describes(model: Any) -> None:
    path = model(SOUND)
    result = call("check", path)
    assert result.exit_code == 0
    assert result.stderr == ""
    for word in ("crank", "coupler", "rocker", "A", "B", "RRR", "motor", "Mobility"):
        assert word in result.stdout
    assert names(path.parent) == ["model.yaml"]


def test_check_as_json(model: Any) -> None:
    data = json.loads(call("check", model(SOUND), "--json").stdout)
    assert data["ok"] is True
    assert data["findings"] == []
    assert data["structure"]
    data = json.loads(call("check", model(NAMES), "--json").stdout)
    assert data["ok"] is False
    assert sorted({f["line"] for f in data["findings"]}) == NAMES_LINES


@pytest.mark.parametrize(("text", "code"), KINDS.values(), ids=KINDS)
def test_check_exit_code(model: Any, text: str, code: int) -> None:
    """Of what can be seen without running: a motion that stops later, or a missing study, is none of its matter."""
    seen = code if text not in (STUCK, UNMET, NO_STUDY) else 0
    for words in ((), ("--json",)):
        result = call("check", model(text), *words)
        assert result.exit_code == seen
        assert "Traceback" not in result.output


@pytest.mark.parametrize("example", sorted(EXAMPLES.glob("*.yaml")), ids=lambda path: path.stem)
def test_check_of_the_examples(example: Path) -> None:
    assert call("check", example).exit_code == 0


# Faults: lines, elements, mends, and no traceback.


@pytest.mark.parametrize("command", ["run", "check"])
@pytest.mark.parametrize(("text", "lines"), [(FORM, FORM_LINES), (NAMES, NAMES_LINES)], ids=["form", "names"])
def test_faults_with_their_lines(model: Any, command: str, text: str, lines: list[int]) -> None:
    path = model(text)
    result = call(command, path)
    assert result.exit_code == 2
    assert result.stdout == ""
    for line in lines:
        assert f"{path}:{line}: " in result.stderr
    assert "Traceback" not in result.stderr
    for finding in linkwright.check(path):
        assert finding.what in result.stderr
        assert finding.mend in result.stderr
        assert finding.code in result.stderr
        assert finding.element in result.stderr
    assert names(path.parent) == ["model.yaml"]


@pytest.mark.parametrize(("text", "code"), KINDS.values(), ids=KINDS)
def test_run_exit_code(model: Any, text: str, code: int) -> None:
    result = call("run", model(text))
    assert result.exit_code == code
    assert "Traceback" not in result.output
    if code:
        assert result.output.strip()


def test_markup_in_a_name_is_printed_as_it_stands(model: Any) -> None:
    result = call("check", model(SOUND.replace("span: rocker.angle", 'span: "[bold]rocker.angle"')))
    assert result.exit_code == 2
    assert "[bold]rocker.angle" in result.stderr


@pytest.mark.parametrize("command", ["run", "check"])
def test_a_missing_file(tmp_path: Path, command: str) -> None:
    result = call(command, tmp_path / "nowhere.yaml")
    assert result.exit_code == 2
    assert "nowhere.yaml" in result.stderr
    assert result.stdout == ""
    assert names(tmp_path) == []


@pytest.mark.parametrize("command", ["run", "check"])
def test_a_folder_instead_of_a_file(tmp_path: Path, command: str) -> None:
    for path in (tmp_path, ".", "/"):
        result = call(command, path)
        assert result.exit_code == 2
        assert result.stdout == ""


# Run.


def test_run_writes_beside_the_file(model: Any) -> None:
    path = model(SOUND, "my four-bar.yaml")
    result = call("run", path)
    assert result.exit_code == 0
    folder = path.with_name("my four-bar_linkwright")
    assert names(folder) == FILES
    assert str(folder) in result.stdout
    assert "swing" in result.stdout
    assert result.stderr == ""


def test_netcdf_is_written_where_asked(model: Any, tmp_path: Path) -> None:
    from scipy.io import netcdf_file

    assert call("run", model(SOUND), "--netcdf", "--out", tmp_path / "out").exit_code == 0
    assert names(tmp_path / "out") == [
        "cycle.csv",
        "cycle.nc",
        "linkwright-manifest.json",
        "report.html",
        "summary.json",
    ]
    with netcdf_file(tmp_path / "out" / "cycle.nc", mmap=False) as file:
        assert (file.title, file.findings) == (b"Four-bar", b"none")
        assert file.variables["A.x"][0] == pytest.approx(0.04 * math.cos(math.radians(40)))
    assert call("run", model(WARNED), "--netcdf", "--out", tmp_path / "out").exit_code == 0
    with netcdf_file(tmp_path / "out" / "cycle.nc", mmap=False) as file:
        assert file.findings.startswith(b"motion.not-periodic: ")


def test_run_prints_measures_requirements_and_proofs(model: Any) -> None:
    path = model(SOUND)
    text = call("run", path).stdout
    measures = json.loads((path.with_name("model_linkwright") / "summary.json").read_text("utf-8"))["measures"]
    assert f"{measures['swing']['value']:.7g}" in text
    assert f"{measures['torque']['max']:.7g}" in text
    assert "70 deg .. 80 deg" in text
    assert "N·mm" in text
    checks = (text.count("✓"), text.count("✗"), "Closure" in text)
    assert checks == (1, 0, False) and "checks passed" in text  # all in one line, where none fails
    told = call("run", path, "--verbose").stdout
    assert told.count("✓") > 4
    for word in ("Closure", "Equilibrium"):
        assert word in told


def test_run_out(model: Any, tmp_path: Path) -> None:
    out = tmp_path / "new" / "folder"
    result = call("run", model(SOUND), "--out", out)
    assert result.exit_code == 0
    assert names(out) == FILES
    assert names(tmp_path) == ["model.yaml", "new"]


def test_run_json_prints_the_summary_and_nothing_else(model: Any, tmp_path: Path) -> None:
    out = tmp_path / "out"
    result = call("run", model(SOUND), "--out", out, "--json")
    assert result.exit_code == 0
    assert result.stderr == ""
    assert json.loads(result.stdout) == json.loads((out / "summary.json").read_text("utf-8"))


@pytest.mark.parametrize(("text", "code"), KINDS.values(), ids=KINDS)
def test_run_json_is_json_whatever_happens(model: Any, text: str, code: int) -> None:
    result = call("run", model(text), "--json")
    assert result.exit_code == code
    data = json.loads(result.stdout, parse_constant=pytest.fail)
    assert data["done"] is (code == 0)
    assert code == 0 or data["findings"] or not all(m["met"] for m in data["measures"].values() if "met" in m)


def test_a_requirement_not_met_is_1_and_said(model: Any) -> None:
    path = model(UNMET)
    result = call("run", path)
    assert result.exit_code == 1
    assert ">= 90 deg" in result.stdout
    assert "FAILED" in result.stdout
    assert names(path.with_name("model_linkwright")) == FILES


def test_a_motion_that_stops_is_1_and_reported(model: Any) -> None:
    path = model(STUCK)
    result = call("run", path)
    assert result.exit_code == 1
    assert "motion.cannot-assemble" in result.stderr
    assert "93.8" in result.stderr
    assert names(path.with_name("model_linkwright")) == FILES


def test_one_that_can_not_start_is_1_and_writes_nothing(model: Any) -> None:
    path = model(STUCK.replace("start: 40 deg", "start: 170 deg"))
    result = call("run", path)
    assert result.exit_code == 1
    assert "assembly.cannot-close" in result.stderr
    assert names(path.parent) == ["model.yaml"]


def test_a_warning_is_0_and_said(model: Any) -> None:
    result = call("run", model(WARNED))
    assert result.exit_code == 0
    assert "motion.not-periodic" in result.stderr


def test_a_law_that_ends_on_the_way_is_no_crash(model: Any) -> None:
    law = "position: 40 deg + 10 deg*sqrt(1 - t/(0.2 s))"
    text = SOUND.replace("speed: 120 rpm, start: 40 deg", law).replace("turns: 1 motor", "duration: 0.5 s")
    for words in ((), ("--json",)):
        result = call("run", model(text), *words)
        assert result.exit_code in (1, 2)
        assert "drive.not-finite" in result.output


@pytest.mark.parametrize("words", [[], ["--json"]])
def test_a_place_that_can_not_be_written(model: Any, tmp_path: Path, words: list[str]) -> None:
    """A folder below a file can't be made, whoever runs it."""
    (tmp_path / "file").write_text("", "utf-8")
    for out in (tmp_path / "file" / "below", tmp_path / "file"):
        result = call("run", model(SOUND), "--out", out, *words)
        assert result.exit_code == 2
        assert str(out) in result.stderr
        assert "Traceback" not in result.stderr
        if words:
            assert not result.stdout.strip() or json.loads(result.stdout)


def test_the_default_folder_taken_by_a_file(model: Any, tmp_path: Path) -> None:
    path = model(SOUND)
    (tmp_path / "model_linkwright").write_text("mine", "utf-8")
    result = call("run", path)
    assert result.exit_code == 2
    assert (tmp_path / "model_linkwright").read_text("utf-8") == "mine"


def test_a_second_run_replaces_the_first(model: Any) -> None:
    path = model(SOUND)
    call("run", path)
    folder = path.with_name("model_linkwright")
    path.write_text(SOUND.replace("name: Four-bar", "name: Another"), "utf-8")
    assert call("run", path).exit_code == 0
    assert names(folder) == FILES
    assert json.loads((folder / "summary.json").read_text("utf-8"))["name"] == "Another"


# Schema.


def test_schema_is_a_json_schema_that_the_examples_fulfil() -> None:
    from ruamel.yaml import YAML

    result = call("schema")
    assert result.exit_code == 0
    schema = json.loads(result.stdout)
    validator = jsonschema.validators.validator_for(schema)
    validator.check_schema(schema)
    files = sorted(EXAMPLES.glob("*.yaml"))
    assert len(files) >= 5
    for path in files:
        validator(schema).validate(json.loads(json.dumps(YAML(typ="safe").load(path.read_text("utf-8")))))


def test_schema_knows_the_studies_options() -> None:
    schema = json.loads(call("schema").stdout)
    cycle = schema["properties"]["studies"]["properties"]["cycle"]
    text = json.dumps(cycle)
    for option in ("period", "duration", "turns", "samples"):
        assert option in text


def test_schema_refuses_what_the_file_may_not_hold() -> None:
    from ruamel.yaml import YAML

    schema = json.loads(call("schema").stdout)
    validator = jsonschema.validators.validator_for(schema)(schema)
    sound = YAML(typ="safe").load(SOUND)
    assert validator.is_valid(sound)
    for change in (
        {"wings": 2},
        {"links": []},
        {"linkwright": 2},
        {"drives": {"motor": {"turns": "crank", "on": "frame", "sped": 1}}},
        {"studies": {"cycle": {"colour": 1}}},
        {"studies": {"cylce": {}}},
    ):
        assert not validator.is_valid({**sound, **change}), change
