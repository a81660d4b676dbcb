"""dev.py: when it installs, what it says when it can't, and that it passes on what it is told. No network."""

import ast
import importlib.util
import os
import runpy
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

DEV = Path(__file__).resolve().parents[1] / "dev.py"

PYPROJECT = """
[project]
name = "linkwright"
[project.optional-dependencies]
engines = ["engine-a>=1", "engine-b>=2"]
"""


class Machine:
    """Stands in for `subprocess.run`: records the commands and answers with the exit codes given."""

    def __init__(self, dev: ModuleType) -> None:
        self.dev = dev
        self.calls: list[list[str]] = []
        self.folders: list[Path | None] = []
        self.answers: dict[str, int] = {}  # exit code of the commands that hold a word

    def run(self, command: list[str], **options: Any) -> subprocess.CompletedProcess[str]:
        self.calls.append([str(word) for word in command])
        self.folders.append(options.get("cwd"))
        code = next((code for word, code in self.answers.items() if word in command), 0)
        if command[1:3] == ["-m", "venv"] and not code:
            self.dev.PYTHON.parent.mkdir(parents=True, exist_ok=True)
            self.dev.PYTHON.touch()
        return subprocess.CompletedProcess(command, code, stdout="what it said\n")

    def installs(self) -> list[str]:
        """What pip was asked for."""
        return [call[-1] for call in self.calls if call[1:4] == ["-m", "pip", "install"]]


@pytest.fixture
def load(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[[], ModuleType]]:
    """Loads a copy of dev.py that stands in a folder of its own, with spaces in its path."""
    root = tmp_path / "a folder with spaces"
    root.mkdir()
    shutil.copy(DEV, root)
    (root / "pyproject.toml").write_text(PYPROJECT, encoding="utf-8")
    monkeypatch.delenv("LINKWRIGHT_VENV", raising=False)

    def loader() -> ModuleType:
        spec = importlib.util.spec_from_file_location("dev_under_test", root / "dev.py")
        assert spec is not None and spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        return module

    yield loader


@pytest.fixture
def dev(load: Callable[[], ModuleType]) -> ModuleType:
    return load()


@pytest.fixture
def machine(dev: ModuleType, monkeypatch: pytest.MonkeyPatch) -> Machine:
    fake = Machine(dev)
    monkeypatch.setattr(dev.subprocess, "run", fake.run)
    return fake


def test_the_first_call_makes_the_environment_and_installs(
    dev: ModuleType, machine: Machine, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("LC_ALL", "en_US.UTF-8")
    assert dev.main(["run", "feeder.yaml"]) == 0
    assert machine.calls[0] == [sys.executable, "-m", "venv", str(dev.ROOT / ".venv")]
    assert machine.installs() == ["."]
    assert machine.calls[-1] == [str(dev.PYTHON), "-m", "linkwright", "run", "feeder.yaml"]
    said = capfd.readouterr()
    assert said.err == "setting up .venv (once, about a minute)\n"
    assert said.out == ""  # a command's own output goes alone down a pipe


def test_a_chinese_system_is_told_so_in_chinese(
    dev: ModuleType, machine: Machine, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("LC_ALL", "zh_CN.UTF-8")
    assert dev.main(["run", "feeder.yaml"]) == 0
    assert capfd.readouterr().err == "正在创建 .venv（仅首次，约一分钟）\n"


def test_a_second_call_installs_nothing(dev: ModuleType, machine: Machine) -> None:
    dev.main(["check", "feeder.yaml"])
    machine.calls.clear()
    dev.main(["check", "feeder.yaml"])
    assert machine.calls == [[str(dev.PYTHON), "-m", "linkwright", "check", "feeder.yaml"]]


def test_an_extra_is_added_to_those_that_are_there(dev: ModuleType, machine: Machine) -> None:
    for task in ("run", "lint", "test", "all", "smoke", "run"):
        dev.main([task])
    assert machine.installs() == [".", ".[dev]", ".[test]", "engine-a>=1", "engine-b>=2"]


def test_a_changed_pyproject_installs_again(dev: ModuleType, machine: Machine) -> None:
    dev.main(["test"])
    machine.calls.clear()
    (dev.ROOT / "pyproject.toml").write_text(PYPROJECT + "# changed\n", encoding="utf-8")
    dev.main(["run"])
    assert machine.installs() == ["."]


def test_a_checkout_in_another_place_installs_again(
    dev: ModuleType, machine: Machine, monkeypatch: pytest.MonkeyPatch
) -> None:
    dev.main(["run"])
    machine.calls.clear()
    elsewhere = dev.ROOT.with_name("elsewhere")  # an editable install points at where the checkout was
    elsewhere.mkdir()
    shutil.copy(dev.ROOT / "pyproject.toml", elsewhere)
    monkeypatch.setattr(dev, "ROOT", elsewhere)
    dev.main(["run"])
    assert machine.installs() == ["."]


def test_a_failed_install_is_told_and_redone(
    dev: ModuleType, machine: Machine, capfd: pytest.CaptureFixture[str]
) -> None:
    machine.answers = {"install": 7}
    assert dev.main(["run"]) == 7
    assert "what it said\ndev.py: pip install failed" in capfd.readouterr().err
    assert not dev.STAMP.exists()
    machine.answers = {}
    assert dev.main(["run"]) == 0
    assert machine.installs() == [".", "."]


def test_a_failed_extra_leaves_what_was_there(dev: ModuleType, machine: Machine) -> None:
    dev.main(["run"])
    machine.answers = {".[test]": 1}
    assert dev.main(["test"]) == 1
    assert dev.installed() == {"base"}


def test_an_interrupted_install_is_redone(dev: ModuleType, machine: Machine, monkeypatch: pytest.MonkeyPatch) -> None:
    dev.main(["run"])

    def interrupted(*arguments: str) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(dev, "pip", interrupted)
    assert dev.main(["test"]) == 130
    assert dev.installed() == set()


def test_an_engine_without_a_wheel_is_no_obstacle(
    dev: ModuleType, machine: Machine, capfd: pytest.CaptureFixture[str]
) -> None:
    machine.answers = {"engine-a>=1": 1}
    assert dev.main(["test"]) == 0
    assert machine.installs() == [".[test]", "engine-a>=1", "engine-b>=2"]
    assert "no wheel of engine-a>=1 here" in capfd.readouterr().err
    assert dev.installed() == {"base", "test"}


def test_an_environment_made_by_hand_is_installed_into(dev: ModuleType, machine: Machine) -> None:
    dev.PYTHON.parent.mkdir(parents=True)
    dev.PYTHON.touch()
    machine.answers = {"--version": 1}  # and has no pip
    dev.main(["run"])
    assert [call[1:3] for call in machine.calls] == [
        ["-m", "pip"],
        ["-m", "ensurepip"],
        ["-m", "pip"],
        ["-m", "linkwright"],
    ]


@pytest.mark.skipif(os.name == "nt", reason="environments hold no symbolic links on Windows")
def test_an_environment_whose_python_is_gone_is_made_again(dev: ModuleType, machine: Machine) -> None:
    dev.PYTHON.parent.mkdir(parents=True)
    dev.PYTHON.symlink_to(dev.ROOT / "gone")
    dev.main(["run"])
    assert machine.calls[0][1:3] == ["-m", "venv"]
    assert not dev.PYTHON.is_symlink()


@pytest.mark.parametrize("text", ["", "[]", "{}", "not json", '{"key": 1, "extras": null}'])
def test_a_spoilt_stamp_counts_as_none(dev: ModuleType, text: str) -> None:
    dev.VENV.mkdir()
    dev.STAMP.write_text(text, encoding="utf-8")
    assert dev.installed() == set()


def test_the_environment_can_lie_elsewhere(
    load: Callable[[], ModuleType], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("LINKWRIGHT_VENV", "some where")
    monkeypatch.chdir(tmp_path)
    assert tmp_path / "some where" == load().VENV


def test_missing_ensurepip_is_one_line(
    dev: ModuleType, machine: Machine, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(dev.importlib.util, "find_spec", lambda name: None)
    assert dev.main(["run"]) == 2
    said = capfd.readouterr().err
    assert said.count("\n") == 1
    assert f"sudo apt install python3.{sys.version_info[1]}-venv" in said
    assert machine.calls == []
    assert not dev.VENV.exists()


def test_too_old_a_python_is_one_line(monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]) -> None:
    with monkeypatch.context() as patch, pytest.raises(SystemExit) as left:
        patch.setattr(sys, "version_info", (3, 9, 18, "final", 0))
        runpy.run_path(str(DEV))
    assert left.value.code == 2
    said = capfd.readouterr().err
    assert said.count("\n") == 1
    assert "needs Python 3.11 or newer" in said and "is Python 3.9.18" in said


def test_an_old_python_can_read_the_file_as_far_as_the_message() -> None:
    ast.parse(DEV.read_text(encoding="utf-8"), feature_version=(3, 7))


@pytest.mark.parametrize("code", [0, 1, 2, 5, 77])
@pytest.mark.parametrize("task", ["run", "check", "test", "lint", "smoke", "web", "bench", "all"])
def test_exit_codes_are_passed_on(dev: ModuleType, machine: Machine, task: str, code: int) -> None:
    dev.ensure({"base", "dev", "test"})
    commands = ["linkwright", "pytest", "mypy", "tools/smoke.py", "tools/web.py", "benchmarks/run.py"]
    machine.answers = dict.fromkeys(commands, code)
    assert dev.main([task]) == code


def test_bench_of_a_file_is_linkwrights_own(dev: ModuleType, machine: Machine) -> None:
    dev.ensure({"base", "test"})
    assert dev.main(["bench", "examples/four_bar.yaml", "--json"]) == 0
    assert machine.calls[-1][1:] == ["-m", "linkwright", "bench", "examples/four_bar.yaml", "--json"]
    assert dev.main(["bench", "--json"]) == 0
    assert machine.calls[-1][1:] == ["benchmarks/run.py", "--json"]


@pytest.mark.skipif(os.name == "nt", reason="signals are POSIX's")
def test_a_signal_becomes_an_exit_code(dev: ModuleType, machine: Machine) -> None:
    dev.ensure({"base"})
    machine.answers = {"linkwright": -11}
    assert dev.main(["run"]) == 139


def test_all_goes_on_after_a_failure_and_names_it(
    dev: ModuleType, machine: Machine, capfd: pytest.CaptureFixture[str]
) -> None:
    machine.answers = {"ruff": 3}
    assert dev.main(["all"]) == 3
    for done in (["tools/smoke.py"], ["tools/web.py", "--check"]):
        assert [call[1:] for call in machine.calls].count(done) == 1
    assert machine.calls[-1][1:] == ["-m", "pytest", "-n", "auto", "--dist", "worksteal"]
    assert capfd.readouterr().out.splitlines()[-1] == "failed: lint"


@pytest.mark.parametrize(
    ("given", "passed"),
    [
        ([], ["-n", "auto", "--dist", "worksteal"]),
        (
            ["tests/test_dev.py", "-k", "stamp"],
            ["-n", "auto", "--dist", "worksteal", "tests/test_dev.py", "-k", "stamp"],
        ),
        (["-n0"], ["-n0"]),
        (["-p", "no:xdist"], ["-p", "no:xdist"]),
        (["-x"], ["-x"]),
        (["--pdb"], ["--pdb"]),
    ],
)
def test_tests_run_in_parallel_unless_told(
    dev: ModuleType, machine: Machine, given: list[str], passed: list[str]
) -> None:
    dev.main(["test", *given])
    assert machine.calls[-1] == [str(dev.PYTHON), "-m", "pytest", *passed]
    assert machine.folders[-1] == dev.ROOT


def test_linkwright_runs_in_the_folder_of_the_user(dev: ModuleType, machine: Machine) -> None:
    dev.main(["run", "my models/feeder one.yaml", "--out", "o u t"])
    assert machine.calls[-1][-3:] == ["my models/feeder one.yaml", "--out", "o u t"]
    assert machine.folders[-1] is None


@pytest.mark.parametrize("arguments", [[], ["help"], ["-h"]])
def test_help_sets_up_nothing(
    dev: ModuleType, machine: Machine, capfd: pytest.CaptureFixture[str], arguments: list[str]
) -> None:
    assert dev.main(arguments) == 0
    assert "python3 dev.py run FILE" in capfd.readouterr().out
    assert machine.calls == []
    assert not dev.VENV.exists()


def test_help_option_goes_on_to_linkwright(dev: ModuleType, machine: Machine) -> None:
    dev.main(["--help"])
    assert machine.calls[-1] == [str(dev.PYTHON), "-m", "linkwright", "--help"]
