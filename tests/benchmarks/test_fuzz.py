"""A share of the fuzzer's cases, all planted faults, and that the fuzzer's parts do what they say."""

from __future__ import annotations

import random
import subprocess
import sys
from pathlib import Path
from typing import Any

import fuzz as script
import fuzz_cases
import fuzz_judge
import mutations
import pytest
from fuzz_judge import Verdict, gaps, unsound
from patience import limited

from linkwright import gallery
from linkwright.exports import TARGETS
from linkwright.studies import STUDIES

FUZZ = Path(script.__file__)
posix = pytest.mark.skipif(sys.platform == "win32", reason="processes are forked, and limited as POSIX has it")


def fuzz(*words: object) -> subprocess.CompletedProcess[str]:
    """The script in a process of its own: it forks, which processes with threads shouldn't."""
    command = [sys.executable, str(FUZZ), *map(str, words)]
    return subprocess.run(command, capture_output=True, encoding="utf-8", timeout=900, check=False)


@posix
@pytest.mark.parametrize(
    ("seed", "count"), [(0, 100), *(pytest.param(*more, marks=pytest.mark.long) for more in [(100, 300), (400, 200)])]
)
def test_a_share_of_the_cases(seed: int, count: int) -> None:
    done = fuzz("--seed", seed, "--count", count, "--jobs", 1)
    assert done.returncode == 0, done.stdout + done.stderr
    assert f"cases {count}, failures 0" in done.stdout


@pytest.mark.long
@posix
def test_planted_faults_are_found() -> None:
    """Else the fuzzer is weak."""
    done = fuzz("--plants")
    assert done.returncode == 0, done.stdout + done.stderr
    assert len(done.stdout.splitlines()) == len(script.PLANTS) >= 5


@posix
@pytest.mark.parametrize(("seed", "count"), [(0, 6), (10, 5), pytest.param(20, 200, marks=pytest.mark.long)])
def test_a_share_of_grown_mechanisms(seed: int, count: int) -> None:
    done = fuzz("--class", "mechanisms", "--seed", seed, "--count", count, "--jobs", 1)
    assert done.returncode == 0, done.stdout + done.stderr
    assert f"cases {count}, failures 0" in done.stdout


def test_cases_come_again_by_their_seed() -> None:
    assert [fuzz_cases.case_of(seed) for seed in range(20)] == [fuzz_cases.case_of(seed) for seed in range(20)]
    assert len({case.files[fuzz_cases.MODEL] for case in map(fuzz_cases.case_of, range(60))}) > 50


@pytest.mark.parametrize("kind", fuzz_cases.KINDS)
def test_every_class_gives_cases(kind: str) -> None:
    """Which differ from each other, and whose command is one of the program's."""
    cases = [fuzz_cases.case_of(seed, kind) for seed in range(5)]
    assert {case.kind for case in cases} == {kind}
    assert len({(case.words, *case.files.items()) for case in cases}) > 3


def test_every_study_and_export_is_tried() -> None:
    told = " ".join(
        content.decode("utf-8", "replace") + " ".join(case.words)
        for case in (fuzz_cases.case_of(seed, kind) for kind in ("options", "exports") for seed in range(100))
        for content in case.files.values()
    )
    assert [name for name in (*STUDIES, *TARGETS) if name not in told] == []


@pytest.mark.parametrize(
    "change", ["_structure", "_numbers", "_units", "_names", "_lines", "_letters", "_cut", "_depth"]
)
def test_each_change_changes(change: str) -> None:
    text = gallery.text("crank-shaper")
    random_ = random.Random(1)
    files = {getattr(mutations, change)(random_, text) for _ in range(20)}
    assert len(files - {text}) > 5


def test_time_that_is_not_used_up() -> None:
    with limited(5):
        assert sum(range(10)) == 45


@pytest.mark.parametrize(
    ("changed", "gap"),
    [
        ({"code": "file.nothing"}, "catalogue"),
        ({"line": None, "element": ""}, "neither line nor element"),
        ({"what": "Expected a number, got None."}, "says"),
        ({"mend": " "}, "says"),
        ({"code": "motion.unproven"}, "unproven"),
        ({"code": "reactions.unproven"}, "unproven"),
    ],
)
def test_gaps(changed: dict[str, Any], gap: str) -> None:
    sound = {"code": "structure.loose", "line": 3, "element": "a", "what": "It is 'None'.", "mend": "Mend it."}
    assert list(gaps(sound)) == []
    assert any(gap in fault for fault in gaps(sound | changed))


@pytest.mark.parametrize(
    ("name", "content", "fault"),
    [
        ("a.csv", b"x,y\n1,2\n3,\n", ""),
        ("a.csv", b"x,y\n1,nan\n", "NaN"),
        ("a.csv", b"x,y\n1\n", "whole"),
        ("a.csv", b"x,y\n1,2", "whole"),
        ("a.json", b'{"a": 1}', ""),
        ("a.json", b'{"a": NaN}', "JSON"),
        ("a.geojson", b'{"a"', "JSON"),
        ("a.xml", b"<a></a>", ""),
        ("a.svg", b"<a>", "XML"),
        ("a.html", b"<html></html>\n", ""),
        ("a.html", b"<html>", "early"),
        ("a.dxf", b"0\nEOF\n", ""),
        ("a.dxf", b"10\nnan\n0\nEOF\n", "whole"),
        ("a.nc", b"G1 X1", ""),
        ("a.nc", b"G1 Xnan", "aren't"),
        ("a.txt", b"", "empty"),
        (".a.csv.0f", b"x", "aside"),
        (".linkwright.lock", b"", ""),
    ],
)
def test_files_that_are_not_sound(name: str, content: bytes, fault: str) -> None:
    found = list(unsound(name, content))
    assert fault in found[0] if fault else found == []


def test_names_of_the_input_are_no_numbers() -> None:
    assert list(unsound("a.txt", b"# inf", b"name: inf")) == []


def test_the_script(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    failing = [Verdict("text", 4, 2, ("file.yaml",), ["raised"]), Verdict("tree", 5, 0, ("nothing found",))]
    monkeypatch.setattr(script, "judged", lambda tasks, jobs: iter(failing))
    monkeypatch.setattr("sys.argv", ["fuzz.py", "--save", str(tmp_path / "counts.json")])
    assert script.main() == 1
    told = capsys.readouterr().out
    assert "text 4: raised" in told and "cases 2, failures 1" in told
    assert '"failed": {' in (tmp_path / "counts.json").read_text("utf-8")
    monkeypatch.setattr("sys.argv", ["fuzz.py", "--show", "3"])
    assert script.main() == 0
    assert fuzz_cases.case_of(3).files[fuzz_cases.MODEL].decode() in capsys.readouterr().out


def test_fewer_lines_that_fail_alike(monkeypatch: pytest.MonkeyPatch) -> None:
    def judged(case: fuzz_cases.Case) -> Verdict:
        bad = b"bad" in case.files[fuzz_cases.MODEL]
        return Verdict(case.kind, case.seed, faults=["KeyError: a"] if bad else [])

    monkeypatch.setattr(script, "judge", judged)
    text = "".join(f"line {i}\n" for i in range(20)) + "bad\n" + "more\n" * 9
    case = fuzz_cases.Case("text", 0, {fuzz_cases.MODEL: text.encode()}, ())
    assert script.smaller(case) == ["bad\n"]


def test_the_judge_leaves_no_folder(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(fuzz_judge.tempfile, "tempdir", str(tmp_path))
    here = Path.cwd()
    case = fuzz_cases.Case("text", 1, {fuzz_cases.MODEL: b"linkwright: 1\n"}, ("check", "model.yaml", "--json"))
    verdict = fuzz_judge.judge(case)
    assert (verdict.code, verdict.faults, Path.cwd(), [*tmp_path.iterdir()]) == (2, [], here, [])
