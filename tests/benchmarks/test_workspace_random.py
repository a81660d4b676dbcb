"""The script counts what became of random mechanisms; a case each of two families that take no time."""

from __future__ import annotations

import json
import pickle
from pathlib import Path

import pytest
import workspace_random as script

from helpers.reach import Outcome, Verdict, product
from helpers.reach.judging import OFF, OPEN, RAISED, REFUSED, RIGHT, WRONG

FAMILY = "five-bar, any"


def call(monkeypatch: pytest.MonkeyPatch, *words: str) -> int:
    monkeypatch.setattr("sys.argv", ["workspace_random.py", "--jobs", "1", *words])
    return script.main()


def told(monkeypatch: pytest.MonkeyPatch, *outcomes: str) -> None:
    verdicts = [Verdict("left", one, "area" if one == WRONG else "") for one in outcomes]
    monkeypatch.setattr(script, "tried", lambda seed: Outcome(seed, FAMILY, verdicts, 1.5))


@pytest.mark.parametrize("seed", [6, 19])
def test_a_case_is_judged(seed: int) -> None:
    """Two cylinders; a crank with a slide."""
    outcome = script.tried(seed)
    assert outcome.outcome in (RIGHT, OPEN)
    assert pickle.loads(pickle.dumps(outcome)) == outcome  # it comes from another process


def test_counts(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    told(monkeypatch, RIGHT, OPEN)
    assert call(monkeypatch, "--count", "3", "--lines", str(tmp_path / "lines")) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[1].split() == ["all", "3", "0", "3", "0", "0", "0", "0", "1.50", "1.5"]
    assert lines[2].split()[:2] == ["five-bar,", "any"]
    assert [json.loads(line)["seed"] for line in (tmp_path / "lines").read_text().splitlines()] == [0, 1, 2]


@pytest.mark.parametrize(("outcome", "code"), [(OFF, 0), (REFUSED, 0), (WRONG, 1), (RAISED, 1)])
def test_a_case_is_as_bad_as_its_worst_mode(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], outcome: str, code: int
) -> None:
    told(monkeypatch, RIGHT, outcome)
    assert call(monkeypatch, "--only", "7", "9") == code
    assert f"seed 7 ({FAMILY}): {outcome}" in capsys.readouterr().out
    assert call(monkeypatch, "--only", "7", "9", "--json") == code
    assert json.loads(capsys.readouterr().out)[outcome] == 2


def test_what_is_raised_is_counted(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(product, "studied", lambda case: 1 / 0)
    outcome = script.tried(6)
    assert outcome.outcome == RAISED
    assert "ZeroDivisionError" in outcome.verdicts[0].why


def test_a_case_is_shown(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    assert call(monkeypatch, "--show", "6") == 0
    assert json.loads(capsys.readouterr().out)["studies"]["workspace"]["point"] == "P"
