"""Expressions computed together have the extremes and mean squares that each has by itself."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import linkwright as lw
from linkwright.expressions.fields import Expression
from linkwright.measures.probe import Probe, Search
from linkwright.measures.together import look_ahead, mean_squares
from linkwright.results import Run
from linkwright.results.windows import intervals

EXAMPLES = Path(__file__).parents[2] / "examples"

CASES = {
    "four_bar": ("motor.torque", "rocker.angle", "force(frame, crank).x^2 + force(frame, crank).y^2"),
    "paper_feeder": ("rail.s", "rail.a", "motor.power", "energy.kinetic"),
    "slider_crank_gas": ("bore_line.s", "engine.torque", "engine.power"),
    "slotted_lever": ("motor.torque", "motor.power", "abs(motor.power)", "E.x"),  # a load jumps
}


def probes(name: str, texts: tuple[str, ...], stop: float = 1.0) -> list[Probe]:
    """Probes of one search."""
    compiled = lw.compile(lw.load(EXAMPLES / f"{name}.yaml"), folder=EXAMPLES)
    period = lw.run(EXAMPLES / f"{name}.yaml").cycle.result.run.stop
    run = Run(compiled, 0.0, stop * period, 90)
    trees = [compiled.quantities.bind(Expression(text), None) for text in texts]
    search = Search(run, trees)
    return [Probe(search, tree, intervals(run, None)) for tree in trees]


@pytest.mark.parametrize("name", CASES)
def test_extremes_are_those_of_each_alone(name: str) -> None:
    alone, together = (probes(name, CASES[name]) for _ in range(2))
    look_ahead(together)
    for one, other in zip(alone, together, strict=True):
        assert other.ahead is not None and one.ahead is None
        size = max(abs(one.top().value), abs(one.bottom().value))
        for a, b in ((one.top(), other.top()), (one.bottom(), other.bottom())):
            assert b.value == pytest.approx(a.value, rel=1e-12, abs=1e-13 * size)
        times = [peak.time for peak in one.peaks]
        assert times == [peak.time for peak in other.peaks]


@pytest.mark.parametrize("name", CASES)
def test_mean_squares_are_those_of_each_alone(name: str) -> None:
    some = probes(name, CASES[name])
    sizes = [1e-6 * max(abs(one.top().value), abs(one.bottom().value)) for one in some]
    squared = [index % 2 == 1 for index in range(len(some))]
    found = mean_squares(some, squared, sizes)
    for one, power, value in zip(some, (1 if s else 2 for s in squared), found, strict=True):
        assert value == pytest.approx(one.mean(power).value, rel=1e-11)
        t = np.linspace(one.run.start, one.run.stop, 20_001)
        assert value == pytest.approx(np.trapezoid(one.values(t) ** power, t) / (t[-1] - t[0]), rel=2e-4)


def test_what_does_not_settle_together_is_integrated_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    (one, *_) = some = probes("slotted_lever", CASES["slotted_lever"])
    want = [probe.mean(2).value for probe in some]
    asked: list[Probe] = []
    own = Probe.mean

    def mean(probe: Probe, power: int = 1, rule: int = 0) -> object:
        asked.append(probe)
        return own(probe, power, rule)

    monkeypatch.setattr(Probe, "mean", mean)
    monkeypatch.setattr("linkwright.measures.together.HALVED", 1)
    monkeypatch.setattr("linkwright.measures.together.FEWEST", 2)
    monkeypatch.setattr(one.run, "grid", 8)
    found = mean_squares(some, [False] * len(some), [0.0] * len(some))
    assert asked
    assert found == pytest.approx(want, rel=1e-11)


def test_round_off_is_not_refined() -> None:
    """The mean square of what is round-off of its dimension ends at the first panels."""
    texts = ("crank.omega - 2*crank.omega/2", "crank.omega")
    (noise, speed) = some = probes("four_bar", texts)
    found = mean_squares(some, [False, False], [100.0, 100.0])
    assert abs(found[0]) < 1e-20
    assert found[1] == pytest.approx(speed.mean(2).value, rel=1e-13)
    assert noise.length() == speed.length()
