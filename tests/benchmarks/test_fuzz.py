"""Six hundred wrong model files of the gallery and the examples, and that the script finds what it looks for."""

from __future__ import annotations

import random

import fuzz as script
import mutations
import pytest
from patience import limited

from linkwright import gallery
from linkwright.model.findings import Finding


@pytest.mark.parametrize("first", range(0, 600, 100))
def test_a_hundred_files(first: int) -> None:
    """Findings with codes, places and words, or a sound run; nothing is raised, nothing hangs."""
    found = [script.tried(seed) for seed in range(first, first + 100)]
    assert [(case.seed, case.faults) for case in found if case.faults] == []
    assert sum(script.RUN in case.came for case in found) >= 3
    assert len({code for case in found for code in case.came}) > 15


def test_files_come_again_by_their_seed() -> None:
    assert [script.file_of(seed) for seed in range(20)] == [script.file_of(seed) for seed in range(20)]
    assert len({script.file_of(seed) for seed in range(100)}) > 95


@pytest.mark.parametrize(
    "change", ["_structure", "_numbers", "_units", "_names", "_lines", "_letters", "_cut", "_depth"]
)
def test_each_change_changes(change: str) -> None:
    text = gallery.text("crank-shaper")
    random_ = random.Random(1)
    files = {getattr(mutations, change)(random_, text) for _ in range(20)}
    assert len(files - {text}) > 5


def test_what_is_raised_is_a_fault(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(script, "examine", lambda raw, case: {}["no"])
    (fault,) = script.tried(0).faults
    assert fault.startswith("KeyError")


def test_a_hang_is_a_fault(monkeypatch: pytest.MonkeyPatch) -> None:
    def hang(raw: bytes, case: script.Case) -> None:
        while True:
            pass

    monkeypatch.setattr(script, "examine", hang)
    monkeypatch.setattr(script, "PATIENCE", 0.1)
    (fault,) = script.tried(0).faults
    assert fault.startswith("TimeoutError")


def test_time_that_is_not_used_up() -> None:
    with limited(5):
        assert sum(range(10)) == 45


@pytest.mark.parametrize(
    ("finding", "gap"),
    [
        (Finding("file.nothing", line=1), "catalogue"),
        (Finding("structure.loose", data={"links": "a", "freedom": 1, "hint": ""}), "neither line nor element"),
        (Finding("file.expected", ("a",), {"wanted": None, "given": "nan"}), "says"),
    ],
)
def test_gaps(finding: Finding, gap: str) -> None:
    assert any(gap in fault for fault in script.gaps(finding))


def test_words_that_lack_their_data() -> None:
    with pytest.raises(KeyError):
        list(script.gaps(Finding("file.expected", ("a",), {"wanted": "x"})))


def test_the_script(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr("sys.argv", ["fuzz.py", "--count", "5", "--jobs", "1"])
    assert script.main() == 0
    assert "files 5" in capsys.readouterr().out
    monkeypatch.setattr(script, "tried", lambda seed: script.Case(seed, ("x",), ["raised"]))
    assert script.main() == 1
    assert "seed 4: raised" in capsys.readouterr().out
    monkeypatch.setattr("sys.argv", ["fuzz.py", "--show", "3"])
    assert script.main() == 0
    assert capsys.readouterr().out == script.file_of(3) + "\n"
