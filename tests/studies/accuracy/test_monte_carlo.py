"""Random samples of deviations: linear problems with known statistics, lost samples, the same bits in any way."""

from __future__ import annotations

import pickle
import signal
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy import stats

import linkwright as lw
from linkwright.blocks import RUNNERS, UNIT
from linkwright.results import Run
from linkwright.studies import RunContext, sampling_state
from linkwright.studies.accuracy.monte_carlo import SampleStatistics, check_monte_carlo, monte_carlo
from linkwright.studies.cycle.options import span
from linkwright.studies.sampling import Interrupted
from linkwright.studies.sampling_task import SampleWork
from studies.accuracy.by_hand import contributors, options, stated
from studies.models import four_bar, slider_crank

HALVES = {"r": (3e-5, "normal"), "e": (6e-5, "normal"), "l": (1e-5, "triangular")}
R = np.array([[1, 0.6, 0], [0.6, 1, 0], [0, 0, 1]])
LINEAR = "2*B.x + C.y - 3*l"
"""2 r cos(angle) + e - 3 l: exactly linear in all three."""


def document(data: Any, **accuracy: Any) -> lw.Document:
    cycle = {"turns": "1 motor", "samples": 24}
    return lw.Document.model_validate({**data, "studies": {"cycle": cycle, "accuracy": accuracy}})


def crank(**accuracy: Any) -> lw.Document:
    measures = {"at_start": {"value": LINEAR, "where": "start"}}
    given = {"outputs": ["at_start", LINEAR], "samples": 3 * UNIT, "seed": 5, "poses": 12, **accuracy}
    return document(slider_crank(measures=measures), **given)


def performed(
    monkeypatch: pytest.MonkeyPatch, given: lw.Document, halves: Any, correlation: Any = None, **site: Any
) -> SampleStatistics:
    compiled, asked = lw.compile(given), options(given)
    stated(monkeypatch, lambda compiled: contributors(compiled, halves, correlation))
    run = Run(compiled, 0.0, span(compiled, asked.cycle)[0], asked.steps)
    return monte_carlo(run, asked, RunContext(document=given, **site))


@pytest.mark.parametrize("plan", ["random", "latin", "sobol"])
def test_sigma_of_a_linear_output_is_that_of_the_superposition(monkeypatch: pytest.MonkeyPatch, plan: str) -> None:
    """Within five standard errors at every pose: sigma^2 = sum c_i c_j r_ij sigma_i sigma_j."""
    given = crank(plan=plan)
    found = performed(monkeypatch, given, HALVES, R)
    of, n = contributors(lw.compile(given), HALVES, R), 3 * UNIT
    angle = 2 * np.pi * np.arange(13) / 12
    c = np.stack([2 * np.cos(angle), np.ones(13), np.full(13, -3.0)])
    sigma = np.sqrt(np.einsum("ip,ij,jp->p", c, of.covariance, c))
    mean, deviation, least, largest, count = found.curves[LINEAR]
    assert (count == n).all()
    assert (np.abs(mean) < 5 * sigma / np.sqrt(n)).all()
    assert (np.abs(deviation - sigma) < 5 * sigma / np.sqrt(2 * n)).all()
    assert (least < -2.5 * sigma).all()
    assert (largest > 2.5 * sigma).all()
    at_start = found.figures["at_start"]
    nominal = 2 * 0.05 + 0.02 - 3 * 0.16
    assert at_start.mean - nominal == pytest.approx(mean[0], abs=1e-15)
    assert at_start.sigma == pytest.approx(deviation[0], rel=1e-9)
    assert (at_start.samples, at_start.failed, at_start.counts.sum()) == (n, 0, n)
    assert at_start.convergence[-1] == pytest.approx([n, at_start.mean, at_start.sigma], rel=1e-9)
    assert len(at_start.convergence) == 12
    if plan == "sobol":
        assert at_start.mean_interval is at_start.sigma_interval is None
    else:
        assert at_start.mean_interval is not None
        assert at_start.sigma_interval is not None
        assert at_start.sigma_interval[0] < sigma[0] < at_start.sigma_interval[1]
        half = stats.t.ppf(0.975, n - 1) * at_start.sigma / np.sqrt(n)
        assert at_start.mean_interval == pytest.approx((at_start.mean - half, at_start.mean + half), rel=1e-12)
    # Nearly normal: 99.73 % lie within three standard deviations.
    low, high = (end - nominal for end in at_start.interval)
    assert (low, high) == pytest.approx((-3 * sigma[0], 3 * sigma[0]), rel=0.12)  # five standard errors


def test_an_expression_of_deviating_parameters_follows(monkeypatch: pytest.MonkeyPatch) -> None:
    """f = 2 e is no contributor: it is moved along, and C with it."""
    data = slider_crank(measures={"at": {"value": "C.y", "where": "start"}})
    data["parameters"]["f"] = "2*e"
    data["links"]["frame"]["points"]["F"] = [0, "f/2"]
    found = performed(monkeypatch, document(data, samples=2000), {"e": (6e-5, "uniform")})
    assert found.figures["at"].sigma == pytest.approx(6e-5 / np.sqrt(3), rel=0.04)
    assert found.figures["at"].largest < 0.02006


FIELDS = ("mean", "sigma", "least", "largest", "failed", "interval", "mean_interval", "sigma_interval")


def same(a: SampleStatistics, b: SampleStatistics) -> None:
    for name, one in a.figures.items():
        assert [getattr(one, key) for key in FIELDS] == [getattr(b.figures[name], key) for key in FIELDS]
        np.testing.assert_array_equal(one.convergence, b.figures[name].convergence)
        np.testing.assert_array_equal(one.counts, b.figures[name].counts)
    for text, rows in a.curves.items():
        np.testing.assert_array_equal(rows, b.curves[text])


@pytest.mark.parametrize("rows", [True, False])
def test_any_threads_and_an_interruption_give_the_same_bits(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, rows: bool
) -> None:
    if not rows:
        monkeypatch.setattr(sampling_state, "ROWS", 5000)
    whole = performed(monkeypatch, crank(), HALVES, R, runner=RUNNERS["threads"](2))  # type: ignore[call-arg]
    same(whole, performed(monkeypatch, crank(), HALVES, R, runner=RUNNERS["threads"](1)))  # type: ignore[call-arg]
    pressed = []

    def progress(done: int, total: int) -> None:
        if done and not pressed:
            pressed.append(done)
            signal.raise_signal(signal.SIGINT)  # Ctrl-C

    with pytest.raises(Interrupted):
        performed(monkeypatch, crank(), HALVES, R, out=tmp_path, progress=progress)
    told: list[int] = []
    same(whole, performed(monkeypatch, crank(), HALVES, R, out=tmp_path, progress=lambda d, _: told.append(d)))
    assert told[0] > 0
    assert [path.name for path in tmp_path.iterdir() if not path.name.startswith("accuracy-")] == []


def test_more_samples_than_rows(monkeypatch: pytest.MonkeyPatch) -> None:
    """Statistics are the same; the coverage interval comes from fine bins."""
    whole = performed(monkeypatch, crank(), HALVES, R).figures
    monkeypatch.setattr(sampling_state, "ROWS", 5000)
    for name, a in performed(monkeypatch, crank(), HALVES, R).figures.items():
        b = whole[name]
        assert (a.mean, a.sigma, a.least, a.largest) == (b.mean, b.sigma, b.least, b.largest)
        assert a.sigma_interval == pytest.approx(b.sigma_interval, rel=1e-9)
        assert a.interval == pytest.approx(b.interval, abs=0.05 * a.sigma)  # where samples are some 0.02 sigma apart
        assert a.counts.sum() == a.samples
        assert a.counts.size == 40
        assert a.convergence[:, 0].tolist() == [UNIT, 2 * UNIT, 3 * UNIT]
        assert a.convergence[-1, 1:].tolist() == [a.mean, a.sigma]


@pytest.mark.parametrize("plan", ["random", "sobol"])
def test_the_share_that_cannot_be_assembled(monkeypatch: pytest.MonkeyPatch, plan: str) -> None:
    """The crank turns over while d + a <= b + c: b uniform about 59.8 +- 0.6 mm is too short where b < 60 mm, 2/3."""
    data = four_bar(b=60.2, measures={"swing": {"span": "rocker.angle"}})
    given = document(data, outputs=["swing", "P.x"], samples=1500, plan=plan, poses=24)
    found = performed(monkeypatch, given, {"b": (6e-4, "uniform")})
    swing = found.figures["swing"]
    assert swing.samples == 1500
    assert swing.failed == found.failed == pytest.approx(500, abs=5 * np.sqrt(1500 * 2 / 9))
    assert swing.counts.sum() == 1500 - swing.failed
    assert found.curves["P.x"][4].min() == 1500 - swing.failed
    share, cause = found.warnings
    assert {share.severity, cause.severity} == {"warning"}
    assert share.code == {"random": "accuracy.samples-fail", "sobol": "accuracy.points-fail"}[plan]
    assert cause.code == "varied.cannot-assemble"
    assert f"{swing.failed} of 1500" in share.what
    assert f"{swing.failed} of 1500" in cause.what
    if plan == "random":
        assert float(share.data["low"]) < 100 / 3 < float(share.data["high"])


def test_more_samples_than_a_plan_has(monkeypatch: pytest.MonkeyPatch) -> None:
    given = crank(plan="latin", samples=10**8)
    of = contributors(lw.compile(given), {"r": (1e-5, "normal"), "e": (1e-5, "uniform")}, [[1, 0.99], [0.99, 1]])
    codes = [finding.code for finding in check_monte_carlo(options(given), of)]
    assert codes == ["study.too-many-samples", "accuracy.correlation-limit"]


def test_another_process_has_all_in_the_work() -> None:
    """The document's own tolerances, correlated; what comes of a unit is the same after the work was sent."""
    data = slider_crank(measures={"at_start": {"value": LINEAR, "where": "start"}})
    data["parameters"] |= {"r": {"value": 50, "tolerance": 0.03}, "e": {"value": 20, "tolerance": [-0.02, 0.06]}}
    together = [{"of": ["r", "e"], "is": 0.6}]
    given = document(data, outputs=["at_start", LINEAR], correlations=together, poses=12, samples=UNIT + 10)
    work = SampleWork(given, (), "numpy", "accuracy")
    here, sent = work.open(), pickle.loads(pickle.dumps(work))
    assert sent.key == work.key
    there = sent.open().perform(1)
    for name, value in here.perform(1).items():
        np.testing.assert_array_equal(there[name], value)
    figure = lw.accuracy(given).figures["at_start"]
    assert figure.monte_carlo is not None
    assert figure.monte_carlo.sigma_interval is not None
    low, high = figure.monte_carlo.sigma_interval
    sigma = np.sqrt(4 + 16 / 9 + 2 * 0.6 * 2 * 4 / 3) * 1e-5  # 2 r and e, of 1e-5 and 4/3 e-5 m
    assert figure.sigma == pytest.approx(sigma, rel=1e-9)
    assert low < sigma < high
    assert figure.monte_carlo.mean - figure.nominal == pytest.approx(2e-5, abs=5 * sigma / 64)
