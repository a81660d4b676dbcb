"""The chains of the scaling benchmark move as their closed form says, and the script gives every figure."""

from __future__ import annotations

import json
import sys

import contest
import large_models
import numpy as np
import pytest
import scaling
import whole_runs

import linkwright as lw
from linkwright.kernels import KERNELS


@pytest.fixture(autouse=True)
def one_kernel(monkeypatch: pytest.MonkeyPatch) -> None:
    """The kernel that compiles nothing; the others are held to it elsewhere."""
    monkeypatch.setattr(contest, "KERNELS", {"numpy": KERNELS["numpy"]})


@pytest.mark.parametrize("dyads", [1, 3, 12])
def test_the_chain_moves_as_its_closed_form_says(dyads: int) -> None:
    compiled = lw.compile(scaling.chain(dyads))
    t = np.linspace(0.0, 1.0, 9)
    q = compiled.inputs(t)
    found = compiled.evaluate([f"B{dyads}.y", "motor.torque", f"L{dyads}.alpha"], t)
    true = np.array([*scaling.exact(dyads, q[0], q[2]), q[2]])
    assert np.abs(found - true).max() < 1e-13 * np.abs(true).max()
    assert len(compiled.structure.groups) == dyads


def test_the_figures_of_a_chain() -> None:
    short, long = (scaling.measure(dyads, poses=300, repeats=1) for dyads in (2, 4))
    assert short["instructions"] < long["instructions"] < 3 * short["instructions"]
    for row in (short, long):
        figures = row["kernels"]["numpy"]
        assert figures["error"] < 1e-13
        assert min(row["graph_s"], *figures.values()) >= 0
        assert figures["ns_per_pose_and_dyad"] == pytest.approx(figures["ns_per_pose"] / row["dyads"])


def test_whole_processes(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    """A class of mechanism from its file to results, and to the answers to its faults."""
    monkeypatch.setattr(whole_runs, "CLASSES", {"grid": large_models.grid})
    monkeypatch.setattr(sys, "argv", ["scaling.py", "--json", "--links", "10"])
    scaling.main()
    (row,) = json.loads(capsys.readouterr().out)
    assert (row["class"], row["links"], row["done"]) == ("grid", 7, True)
    assert row["run_mb"] > 20
    assert all(row[f"check_{fault}_s"] > 0 for fault in large_models.FAULTS)
    assert len(list(whole_runs.table([row]))) == 2


@pytest.mark.parametrize("words", [[], ["--json"]])
def test_it_prints_a_table_or_json_and_progress_apart(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], words: list[str]
) -> None:
    monkeypatch.setattr(sys, "argv", ["scaling.py", *words, "--largest", "5", "--poses", "100", "--repeats", "1"])
    scaling.main()
    out, progress = capsys.readouterr()
    assert [line.split()[0] for line in progress.splitlines()] == ["1", "2", "5"]  # the first to warm up
    if words:
        assert [row["dyads"] for row in json.loads(out)] == [2, 5]
    else:
        assert [line.split()[0] for line in out.splitlines()] == ["dyads", "2", "5"]
