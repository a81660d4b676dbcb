"""The comparison with other engines: each comes as near to 50 digits as its method lets it. How fast isn't asked."""

from __future__ import annotations

import json
import sys
from types import SimpleNamespace
from typing import Any

import contest
import exact
import numpy as np
import peers
import pytest
from run import FEEDER, OUTPUTS

import linkwright as lw
from linkwright.kernels import KERNELS

POSES, STEPS = 1200, 600


@pytest.fixture(scope="module", autouse=True)
def one_kernel() -> Any:
    """The kernel that compiles nothing; the others are held to it elsewhere."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(contest, "KERNELS", {"numpy": KERNELS["numpy"]})
        yield


@pytest.fixture(scope="module")
def figures(one_kernel: None) -> Any:
    return peers.measure(POSES, rounds=1, steps=STEPS)


def errors(figures: Any, part: str, engine: str, how: str = "") -> dict[str, float | None]:
    """The errors of the one row of an engine whose way begins so."""
    rows = [row for row in figures[part]["rows"] if row["engine"] == engine and row["how"].startswith(how)]
    assert len(rows) == 1
    return rows[0]["errors"]


def test_50_digits_and_the_kinetostatics_agree() -> None:
    t = np.linspace(0.0, 1.5, 13)
    true = exact.reference(exact.feeder, OUTPUTS, t)
    found = lw.compile(lw.load(FEEDER)).evaluate(OUTPUTS, t)
    assert (np.abs(found - true) < 1e-14 * np.abs(true).max(axis=1, keepdims=True)).all()


@pytest.mark.parametrize("part", ["paper_feeder", "four_bar_positions", "four_bar_rates"])
def test_every_row_has_a_time_a_ratio_and_errors(figures: Any, part: str) -> None:
    rows = figures[part]["rows"]
    assert [row["how"] for row in rows if row["engine"] == "linkwright"] == [
        "numpy, 1 thread",
        "numpy, 2 threads",
        "numpy, 2 threads, from times to new arrays",
    ]
    assert min(row["ratio"] for row in rows if row["how"] == figures[part]["fastest"]) == 1.0
    for row in rows:
        assert row["ns_per_pose"] > 0
        assert 0 < row["ratio_range"][0] <= row["ratio"] <= row["ratio_range"][1]
    for row in rows[:3]:
        assert max(row["errors"].values()) < 1e-10
        assert row["errors"]["position_mm"] < 1e-11


def test_exudyn(figures: Any) -> None:
    pytest.importorskip("exudyn")
    off = errors(figures, "paper_feeder", "Exudyn")
    assert off["position_mm"] < 0.03
    assert 1e-3 < off["force_N"] < 0.15  # second order: 0.009 N at 1800 steps, nine times that at 600
    assert off["torque_Nm"] < 0.02


def test_mujoco_integrated_in_time(figures: Any) -> None:
    pytest.importorskip("mujoco")
    off = errors(figures, "paper_feeder", "MuJoCo", "RK4")
    assert off["position_mm"] < 0.02
    assert off["force_N"] < 0.15
    assert off["torque_Nm"] < 0.03
    coarse, fine = (errors(figures, "paper_feeder", "MuJoCo", f"Euler, {n} ") for n in (STEPS, 6 * STEPS))
    assert 20 * fine["force_N"] < coarse["force_N"] < 5


def test_mujoco_with_its_state_set(figures: Any) -> None:
    pytest.importorskip("mujoco")
    off = errors(figures, "paper_feeder", "MuJoCo", "state set")
    assert off["force_N"] is None
    assert off["torque_Nm"] < 1e-11
    assert off["acceleration_m_s2"] < 1e-11


@pytest.mark.parametrize("part", ["four_bar_positions", "four_bar_rates"])
def test_pylinkage(figures: Any, part: str) -> None:
    pytest.importorskip("pylinkage")
    pytest.importorskip("numba")
    off = errors(figures, part, "pylinkage")
    assert off["position_mm"] < 1e-7
    assert off.get("acceleration_m_s2", 0.0) < 1e-8


def test_an_engine_or_kernel_that_isnt_there_is_left_out_and_said(monkeypatch: pytest.MonkeyPatch) -> None:
    absent = SimpleNamespace(available=lambda: False)
    monkeypatch.setattr(contest, "KERNELS", {"numpy": KERNELS["numpy"], "absent": absent})
    monkeypatch.setattr(peers, "importlib", SimpleNamespace(util=SimpleNamespace(find_spec=lambda name: None)))
    figures = peers.measure(POSES, rounds=1)
    parts = ("paper_feeder", "four_bar_positions", "four_bar_rates")
    assert {row["engine"] for part in parts for row in figures[part]["rows"]} == {"linkwright"}
    said = "\n".join(peers.lines(figures))
    for name in ("kernel absent", "exudyn", "mujoco", "pylinkage"):
        assert said.count(f"left out: {name} ") + said.count(f"left out: {name}:") == 1


@pytest.mark.parametrize("words", [[], ["--json"]])
def test_it_prints_tables_or_json(
    figures: Any, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], words: list[str]
) -> None:
    monkeypatch.setattr(peers, "measure", lambda poses, rounds: {**figures, "poses": poses})
    monkeypatch.setattr(sys, "argv", ["peers.py", *words, "--poses", "7"])
    peers.main()
    text = capsys.readouterr().out
    if words:
        assert json.loads(text, parse_constant=pytest.fail)["poses"] == 7
    else:
        assert text.count("numpy, 1 thread ") >= 3
        assert "of 200" in text or not any("ratio_of_200" in row for row in figures["paper_feeder"]["rows"])


def test_the_largest_error_of_each_kind_counts() -> None:
    found = np.array([[1.0, 2.0], [3.0, 4.5], [np.nan, 1.0], [2.0, 2.0]])
    true = np.array([[1.0, 2.5], [3.25, 4.5], [1.0, 1.0], [1.0, 2.0]])
    off = peers.errors(["C.x", "C.y", "force(a, b).x", "force(a, b).y"], found, true)
    assert off == {"position_mm": 500.0, "force_N": None}


def test_ratios_are_those_of_the_rounds() -> None:
    slow, fast = (contest.Way("", "", poses, lambda: (0.0, np.empty(0))) for poses in (10, 100))
    slow.seconds, fast.seconds = [10.0, 20.0, 60.0], [100.0, 100.0, 200.0]
    assert slow.ratios(fast) == [1.0, 2.0, 3.0]
    assert slow.ns() == 2e9


def test_the_first_round_warms_up() -> None:
    given = iter([(9.0, np.zeros(1)), (1.0, np.ones(1)), (2.0, np.full(1, 2.0))])
    way = contest.Way("", "", 1, lambda: next(given))
    contest.contest([way], 2)
    assert way.seconds == [1.0, 2.0]
    assert way.found == 2.0
