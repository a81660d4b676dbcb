"""A slice of the random mechanisms, and that the judge finds what is wrong with poses."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import random_mechanisms as script
from judge import Judge
from numpy.typing import NDArray
from sketches import GROUPS, PERIOD, Sketch, sketch

from helpers.longer import mostly_long
from linkwright.compilation import compile_mechanism
from linkwright.graph.rows import BodyPlace, Named
from linkwright.kernels import Compiled
from linkwright.model.document import Document

Array = NDArray[np.float64]
T = np.linspace(0.0, PERIOD, 49)


@pytest.mark.parametrize("first", mostly_long(range(0, 60, 10), lambda first: first % 20 == 0))
def test_ten_mechanisms(first: int) -> None:
    """Assembled and right, or refused by a finding; never wrong, never doubtful."""
    found = [script.judged(seed) for seed in range(first, first + 10)]
    assert [script.fault(v) for v in found if v.faults] == []
    assert not any(v.doubtful for v in found)
    assert sum(v.came == script.ASSEMBLED for v in found) >= 2
    assert all("." in v.came for v in found if v.came != script.ASSEMBLED)


def test_the_sketches_hold_all_kinds() -> None:
    every = [sketch(seed) for seed in range(60)]
    assert {kind for s in every for kind in s.kinds} == {*GROUPS, "moved drive"}
    assert {len(s.drives) for s in every} == {1, 2, 3}
    assert {joint.kind for s in every for joint in s.joints.values()} == {"R", "P"}
    assert any(len(joint.links) > 2 for s in every for joint in s.joints.values())
    assert sketch(7).data() == sketch(7).data()


# What the judge finds.


def four_bar() -> Sketch:
    """A crank on the frame with a pinned dyad, in its sketch pose."""
    s = Sketch(0)
    for link, pose in {"L1": (0, 0, 0.5), "L2": (0.3, 0.1, 0.7), "L3": (1, 0, 1.9)}.items():
        s.pose[link] = pose
    from sketches import Drive, Joint, Law

    s.joints = {
        "A": Joint("R", ["frame", "L1"], (0.0, 0.0)),
        "B": Joint("R", ["L1", "L2"], (0.2, 0.1)),
        "C": Joint("R", ["L2", "L3"], (0.8, 0.7)),
        "D": Joint("R", ["frame", "L3"], (1.0, 0.0)),
    }
    s.drives = {"M1": Drive("A", "R", "L1", "frame", Law(0.5, size=0.4))}
    return s


def compiled() -> tuple[Sketch, Compiled]:
    s = four_bar()
    return s, compile_mechanism(Document.model_validate(s.stated(s.mechanism())))


def faults(s: Sketch, c: Compiled) -> str:
    return "; ".join(Judge(s, c).faults(T))


def lie(monkeypatch: pytest.MonkeyPatch, wrong: Callable[[Named, Array, Array], Array]) -> None:
    """From now on the values of each row are reported as ``wrong`` makes them of name, times and values."""
    honest = Compiled.possible_rows

    def evaluate(c: Compiled, names: Any, t: Array, rates: bool = False) -> Array:
        y = honest(c, names, t, rates)
        for i, name in enumerate(names):
            values = y[i, 0] if rates else y[i]
            values[:] = wrong(name, t, values.copy())
        return y

    monkeypatch.setattr(Compiled, "possible_rows", evaluate)


def test_nothing_is_wrong_with_a_four_bar() -> None:
    assert faults(*compiled()) == ""


def test_a_joint_that_misses(monkeypatch: pytest.MonkeyPatch) -> None:
    lie(monkeypatch, lambda name, t, y: y + 1e-9 if name == BodyPlace("L2", "x") else y)
    assert faults(*compiled()).startswith("closure")


def test_a_drive_that_is_off_its_law() -> None:
    s, c = compiled()
    s.drives["M1"].law = type(s.drives["M1"].law)(0.5, size=0.4001)
    assert faults(s, c).startswith("closure")


def test_the_other_mode_from_the_start() -> None:
    s, c = compiled()
    (group,) = c.structure.groups
    c.assembly.branches[group] *= -1
    assert "off the sketch" in faults(s, c)


def test_the_other_mode_on_the_way(monkeypatch: pytest.MonkeyPatch) -> None:
    """Both modes close, so that only the branch tells."""
    s, c = compiled()
    (group,) = c.structure.groups
    honest = Compiled.inputs

    def inputs(self: Compiled, t: Array, *args: Any, **kwargs: Any) -> Array:
        x = honest(self, t, *args, **kwargs)
        row = self.graph.inputs.index(f"branch:{group.label}")
        x[row] = np.where((t > 2) & (t < 2.5), -x[row], x[row])
        return x

    monkeypatch.setattr(Compiled, "inputs", inputs)
    found = faults(s, c)
    assert "closure" not in found
    assert "the determinant changes sign at" in found
    assert "the triangle at" in found
    assert "jump at 2" in found


def test_a_motion_that_does_not_come_back(monkeypatch: pytest.MonkeyPatch) -> None:
    s, c = compiled()
    judge = Judge(s, c)
    lie(monkeypatch, lambda name, t, y: y + 1e-6 * t if name == BodyPlace("L2", "x") else y)
    assert any(fault.startswith("doesn't come back") for fault in judge.faults(T))


def test_a_pose_that_is_no_number(monkeypatch: pytest.MonkeyPatch) -> None:
    lie(monkeypatch, lambda name, t, y: np.where(t > 3, np.nan, y))
    assert faults(*compiled()) == "not a number"


def test_forces_out_of_balance_are_faults(monkeypatch: pytest.MonkeyPatch) -> None:
    seed = next(seed for seed in range(60) if script.judged(seed).figures.get("equilibrium"))
    lie(monkeypatch, lambda name, t, y: y * (1 + 1e-6) if str(name).startswith("force(") else y)
    assert any(fault.startswith("equilibrium") for fault in script.judged(seed).faults)


def test_an_exception_is_a_fault(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(script, "perform", lambda examined: 1 / 0)
    verdict = script.judged(0)
    assert verdict.came == "ZeroDivisionError"
    assert len(verdict.faults) == 1


# The script.


def call(monkeypatch: pytest.MonkeyPatch, *words: str) -> int:
    monkeypatch.setattr("sys.argv", ["random_mechanisms.py", "--jobs", "1", *words])
    return script.main()


def test_the_script_prints_counts(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    assert call(monkeypatch, "--count", "3", "--seed", "5") == 0
    out = capsys.readouterr().out
    assert out.splitlines()[1].split()[:2] == ["all", "3"]
    assert "failures: 0" in out


def test_a_fault_ends_in_exit_code_1(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr(script, "judged", lambda seed: script.Verdict(seed, ("triad",), faults=["closure 1"]))
    assert call(monkeypatch, "--count", "2", "--seed", "41") == 1
    assert "seed 42 (triad; assembled): closure 1" in capsys.readouterr().out


def test_an_interrupt_prints_the_counts_so_far(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def judged(seed: int) -> script.Verdict:
        if seed == 2:
            raise KeyboardInterrupt
        return script.Verdict(seed, ("triad",))

    monkeypatch.setattr(script, "judged", judged)
    assert call(monkeypatch, "--count", "9") == 0
    assert capsys.readouterr().out.splitlines()[1].split()[:2] == ["all", "2"]
