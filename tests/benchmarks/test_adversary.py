"""A few documents of measures with known truth, and that the script counts what is wrong."""

from __future__ import annotations

import pickle
from typing import Any

import adversary as script
import pytest

from helpers.adversary import Case, Verdict, Wanted
from helpers.adversary.judging import REFUSED, RIGHT, WRONG

CASE = Case("kink", "m0", {"max": "x"}, {"": Wanted(1.0, 1e-9)}, 3e-4, 3e-4)


def call(monkeypatch: pytest.MonkeyPatch, *words: str) -> int:
    monkeypatch.setattr("sys.argv", ["adversary.py", "--jobs", "1", *words])
    return script.main()


def told(monkeypatch: pytest.MonkeyPatch, **words: Any) -> None:
    monkeypatch.setattr(script, "tried", lambda seed: script.Outcome(seed, **words))


def test_a_document_is_judged() -> None:
    outcome = script.tried(1)
    assert outcome.raised == ""
    assert len(outcome.verdicts) > 5
    assert pickle.loads(pickle.dumps(outcome)) == outcome  # it comes from another process


def test_the_script_prints_counts(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    told(monkeypatch, verdicts=[Verdict(CASE, RIGHT, "searched", 1e-4), Verdict(CASE, REFUSED, why="measure.x")])
    assert call(monkeypatch, "--count", "60") == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[1].split() == ["all", "4", "2", "0", "0", "2", "0", "0.0001"]
    for first in ("kink", "1e-04", "searched", "measure.x"):
        assert any(line.split()[:1] == [first] for line in lines), first
    assert "wrong in silence 0" in lines[-1]


def test_what_is_wrong_ends_in_exit_code_1(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    told(monkeypatch, verdicts=[Verdict(CASE, WRONG, "enclosed", 0.0, "value: 0.9, truth 1.0")])
    assert call(monkeypatch, "--count", "30", "--seed", "7") == 1
    assert "seed 7: m0 (kink, width 0.0003 of the run, enclosed): {'max': 'x'} value: 0.9" in capsys.readouterr().out


def test_what_is_raised_ends_in_exit_code_1(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(script, "judged", lambda batch, given: 1 / 0)
    assert call(monkeypatch, "--count", "30", "--seed", "5") == 1
    assert "seed 5: ZeroDivisionError" in capsys.readouterr().out


def test_a_document_is_shown(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    assert call(monkeypatch, "--show", "0") == 0
    assert '"measures"' in capsys.readouterr().out
