"""True extremes are proven, false ones refuted, what can't be decided is left open where it lies."""

import numpy as np
import pytest
from scipy.optimize import minimize_scalar

from helpers.compiled import compiled_from
from helpers.examples import four_bar
from helpers.runs import example_run, trees
from linkwright.enclosures import Claim, Proof, prove, prove_all, sign
from linkwright.expressions.language import Node, parse
from linkwright.results import Run


def bound(run: Run, text: str) -> Node:
    return run.compiled.quantities.dimensions.bind(parse(text), None)


def extremes(run: Run, node: Node, a: float, b: float) -> tuple[float, float]:
    """By dense samples and bounded minimisation beside the best of them."""
    t = np.linspace(a, b, 4001)

    def value(at: float) -> float:
        return float(run.jets(node, np.array([at])).d[0][0])

    found = []
    for way in (1.0, -1.0):
        v = way * np.asarray(run.jets(node, t).d[0])
        i = int(np.argmin(v))
        low, high = t[max(i - 1, 0)], t[min(i + 1, 4000)]
        best = minimize_scalar(
            lambda at, w=way: w * value(at), bounds=(low, high), method="bounded", options={"xatol": 1e-13}
        )
        found.append(way * min(best.fun, v[i]))
    return found[0], found[1]


def claims(run: Run, names: dict[str, tuple[float, float]]) -> list[Claim]:
    made = []
    for name, (a, b) in names.items():
        node = trees(run)[name]
        low, high = extremes(run, node, a, b)
        made.append(Claim(node, ((a, b),), 0.0 if 0 <= low < 1e-6 * high else low, high))  # a magnitude's kink
    return made


CASES = {
    "paper_feeder.yaml": {
        "stroke": (0, 1.5),
        "M0_feed": (0.6, 1.5),
        "F61x_return": (0, 0.6),
        "feed_speed_max": (0.6, 1.5),
    },
    "four_bar.yaml": {"swing": (0, 0.5), "torque": (0, 0.5), "pin_force_max": (0, 0.5), "omega_rocker_max": (0, 0.5)},
    "class_four.yaml": {"lift": (0, 1), "tilt": (0, 1)},
    "slider_crank_gas.yaml": {"big_end": (0, 0.04)},
}


@pytest.mark.parametrize("name", CASES)
def test_true_extremes_are_proven(name: str) -> None:
    run = example_run(name)
    made = claims(run, CASES[name])
    for claim, proof in zip(made, prove_all(run, made, run.breaks), strict=True):
        assert proof.is_proven, proof
        assert proof.low <= claim.low + claim.tolerance
        assert proof.high >= claim.high - claim.tolerance
        assert proof.low >= claim.low - claim.tolerance
        assert proof.high <= claim.high + claim.tolerance
        assert 0 < proof.panels < 500


@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("end", ["low", "high"])
def test_false_extremes_are_refuted(name: str, end: str) -> None:
    """A limit that is off by 1e-6 of the range, at a time where the run itself passes it."""
    run = example_run(name)
    for claim in claims(run, CASES[name]):
        off = 1e-6 * (claim.high - claim.low)
        low, high = (claim.low + off, claim.high) if end == "low" else (claim.low, claim.high - off)
        (a, b) = claim.spans[0]
        proof = prove(run, claim.node, [(a, b)], low, high, run.breaks)
        assert not proof.is_proven
        assert proof.reason == "refuted"
        assert proof.refuted is not None
        value = run.jets(claim.node, np.array([proof.refuted.time])).d[0][0]
        assert (value < low) if end == "low" else (value > high)


def test_a_window_is_all_that_counts() -> None:
    run = example_run("paper_feeder.yaml")
    node = trees(run)["stroke"]
    low, high = extremes(run, node, 0.2, 0.4)
    assert prove(run, node, [(0.2, 0.4)], low, high).is_proven
    assert prove(run, node, [(0.2, 0.41)], low, high).refuted is not None


def test_a_narrow_peak_between_samples_is_found() -> None:
    """A spike of 1e-5 of the run, which searches on a grid step over."""
    run = Run(compiled_from(four_bar()), 0.0, 6.0, 100)
    node = bound(run, "1/(1 + (t - 2.345678 s)^2/(0.00003 s)^2)")
    proof = prove(run, node, [(0.0, 6.0)], 0.0, 0.5)
    assert proof.refuted is not None
    assert proof.refuted.time == pytest.approx(2.345678, abs=1e-4)
    assert prove(run, node, [(0.0, 6.0)], 0.0, 1.0).is_proven


def test_an_unbounded_value_stays_open_at_its_pole() -> None:
    run = Run(compiled_from(four_bar()), 0.0, 6.0, 100)
    proof = prove(run, bound(run, "1/(t - 2.5)"), [(0.0, 6.0)], -1e3, 1e3)
    assert not proof.is_proven
    if proof.refuted is None:
        assert proof.reason == "undefined"
        assert all(abs(a - 2.5) < 0.01 and abs(b - 2.5) < 0.01 for a, b in proof.open)


def test_a_jump_counts_with_both_sides() -> None:
    """A load over a window of time makes the torque jump; with its ends as edges the limits are proven."""
    data = four_bar()
    data["loads"] = {"tool": {"on": "rocker", "at": "C", "force": [12, -7], "window": "pushed"}}
    data["windows"] = {"pushed": [1.0, 3.0]}
    run = Run(compiled_from(data), 0.0, 6.0, 100)
    node = bound(run, "motor.torque")
    spans = [(0.0, 1.0), (1.0, 3.0), (3.0, 6.0)]
    ends = [extremes(run, node, a + 1e-9, b - 1e-9) for a, b in spans]
    low, high = min(e[0] for e in ends), max(e[1] for e in ends)
    assert prove(run, node, [(0.0, 6.0)], low - 1e-6, high + 1e-6, run.breaks).is_proven
    without = prove(run, node, [(0.0, 6.0)], low - 1e-6, high + 1e-6)
    assert without.refuted is None


def test_many_turns() -> None:
    """The panels grow with the turns that the drives make."""
    run = Run(compiled_from(four_bar(a=1.0, b=3.0, c=3.0, d=4.0)), 0.0, 40 * 2 * np.pi, 4000)
    node = bound(run, "rocker.omega")
    low, high = extremes(run, node, 0.0, 2 * np.pi)
    proof = prove(run, node, [(run.start, run.stop)], low, high)
    assert proof.is_proven, proof.reason


def test_the_budget_ends_it() -> None:
    run = example_run("four_bar.yaml")
    node = trees(run)["torque"]
    low, high = extremes(run, node, 0.0, 0.5)
    proof = prove(run, node, [(0.0, 0.5)], low, high, budget=60)
    assert not proof.is_proven
    assert proof.reason == "budget"
    assert proof.open
    assert prove(run, node, [(0.0, 0.5)], low, high, budget=60) == proof


def test_change_points_are_said() -> None:
    run = example_run("parallelogram.yaml")
    node = trees(run)["lift"]
    proof = prove(run, node, [(run.start, run.stop)], *extremes(run, node, run.start, run.stop))
    assert proof.reason == "change-point"
    assert all(any(a < p.time < b for p in run.compiled.passages.every) for a, b in proof.open)


def test_signs() -> None:
    run = Run(compiled_from(four_bar()), 0.0, 6.0, 100)
    assert sign(run, bound(run, "2 + sin(t*(1 rad)/(1 s))"), [(0.0, 6.0)]) == ((), "")
    open_, reason = sign(run, bound(run, "sin(t*(1 rad)/(1 s))"), [(1.0, 6.0)])
    assert reason
    assert len(open_) == 1
    assert open_[0][0] < np.pi < open_[0][1]
    assert open_[0][1] - open_[0][0] < 1e-6


def test_what_lies_just_outside_a_window_neither_refutes_nor_hinders() -> None:
    """A window of 1e-3 of the run, with the extremes of a steep line at its ends."""
    run = Run(compiled_from(four_bar()), 0.0, 6.0, 100)
    node = bound(run, "motor.angle")
    a, b = 3.0, 3.006
    assert prove(run, node, [(a, b)], a + 0.5, b + 0.5).is_proven


def test_a_window_without_length_is_no_proof() -> None:
    run = Run(compiled_from(four_bar()), 0.0, 6.0, 100)
    assert not prove(run, bound(run, "motor.angle"), [(3.0, 3.0)], -1e3, 1e3).is_proven
    assert not prove(run, bound(run, "motor.angle"), [(0.0, 6.0)], np.nan, 1e3, budget=200).is_proven


def test_nothing_decided_is_no_proof() -> None:
    assert not Proof(0.0, 1.0, ((0.0, 1.0),), "budget").is_proven
