"""The sweep study: closed forms, statistics of known distributions, lost samples, interruption, kept figures."""

from __future__ import annotations

import signal
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import linkwright as lw
from linkwright.app.job import examine_document, perform
from linkwright.blocks import UNIT
from linkwright.studies import RunContext, sampling_state
from linkwright.studies.sampling import Interrupted
from linkwright.studies.sweep.outcome import SweepOutcome
from studies.models import CRANK, four_bar, slider_crank

STEPS = {"from": 45, "to": 55, "count": 5}


def document(cycle: dict[str, Any] | None = None, **sections: Any) -> lw.Document:
    studies = {"cycle": cycle or {"turns": "1 motor", "samples": 24}}
    measures = {"stroke": {"span": "guide.s"}}
    return lw.Document.model_validate(slider_crank(**{"measures": measures, "studies": studies, **sections}))


def exact(r: Any, length: Any, e: float = 0.02) -> Any:
    """The stroke of an offset slider-crank between its two dead centres."""
    return np.sqrt((length + r) ** 2 - e**2) - np.sqrt((length - r) ** 2 - e**2)


def test_strokes_over_a_grid() -> None:
    outcome = lw.sweep(document(), {"r": STEPS, "l": [150, 170]})
    assert outcome.table is not None
    r, length = outcome.table.parameters
    assert r.tolist() == pytest.approx([0.045, 0.045, 0.0475, 0.0475, 0.05, 0.05, 0.0525, 0.0525, 0.055, 0.055])
    assert length.tolist() == [0.15, 0.17] * 5
    np.testing.assert_allclose(outcome.table.figures[0], exact(r, length), rtol=1e-13)
    (found,) = outcome.measures
    assert found.count == outcome.samples == 10
    assert (found.least, found.largest) == (outcome.table.figures[0].min(), outcome.table.figures[0].max())
    assert (found.least_at, found.largest_at) == (1, 8)
    assert found.counts.sum() == 10
    assert (found.edges[0], found.edges[-1]) == (found.least, found.largest)


def test_each_sample_is_what_a_file_with_its_values_gives() -> None:
    data = document(measures={"torque": {"extremes": "motor.torque"}, "rms": {"rms": "motor.torque"}})
    outcome = lw.sweep(data, {"r": [45, 52], "l": [150, 171]})
    assert outcome.table is not None
    for k, (r, length) in enumerate(((45, 150), (45, 171), (52, 150), (52, 171))):
        job = lw.run(data.replace(r=r, l=length))
        assert job.cycle is not None
        alone = [f.value for m in job.cycle.measures for f in m.found]
        np.testing.assert_allclose(outcome.table.figures[:, k], alone, rtol=1e-9)


def test_a_bare_parameter_that_options_alone_use_is_in_their_unit() -> None:
    """Degrees, wherever the document is compiled: in its own process too."""
    data = slider_crank(measures={"stroke": {"span": "guide.s"}})
    data["parameters"] |= {"begin": "10 deg", "low": 20, "high": "2*low"}
    data["drives"] = {"motor": {**CRANK, "start": "begin"}}
    data["studies"] = {"cycle": {"turns": "1 motor", "samples": 24}}
    outcome = lw.sweep(lw.Document.model_validate(data), {"begin": ["low", "high"]})
    assert outcome.table is not None
    assert outcome.table.parameters[0] == pytest.approx(np.radians([20, 40]))


def test_signals_at_each_pose_are_those_of_runs_alone() -> None:
    data = lw.Document.model_validate(four_bar())
    outcome = lw.sweep(data, {"a": [38, 40, 42]}, ["P.x", "rocker.angle", "abs(P.vx) + a*1/(1 s)"], poses=36)
    rows = {}
    for a in (38, 40, 42):
        result = lw.compile(data.replace(a=a))
        run = lw.Run(result, 0.0, 1.0, 36)
        rows[a] = lw.Result(run)
    for text, band in outcome.bands.items():
        each = np.stack([rows[a][text] for a in rows])
        np.testing.assert_allclose(band.least, each.min(axis=0), rtol=1e-9)
        np.testing.assert_allclose(band.largest, each.max(axis=0), rtol=1e-9)
        np.testing.assert_allclose(band.mean, each.mean(axis=0), rtol=1e-9)
        np.testing.assert_allclose(band.deviation, each.std(axis=0, ddof=1), rtol=1e-6)
        assert (band.count == 3).all()
    assert outcome.t.tolist() == np.linspace(0, 1, 37).tolist()


@pytest.mark.parametrize("plan", ["random", "latin", "sobol"])
def test_mean_and_deviation_of_a_linear_output(plan: str) -> None:
    """B lies at r on the crank: B.x is linear in r, so it is normal with known mean and deviation."""
    n, mean, sigma = 3 * UNIT, 0.05, 2e-5
    vary = {"r": {"normal": 50, "sigma": 0.02}}
    outcome = lw.sweep(document(), vary, ["B.x"], n, plan=plan, seed=7, poses=8)
    band, c = outcome.bands["B.x"], np.abs(np.cos(2 * np.pi * np.arange(9) / 8))
    assert (np.abs(np.abs(band.mean) - mean * c) <= 4 * sigma * c / np.sqrt(n) + 1e-16).all()
    assert (np.abs(band.deviation - sigma * c) <= 4 * sigma * c / np.sqrt(2 * n) + 1e-16).all()


def test_the_share_that_meets_a_requirement() -> None:
    """With no offset the stroke is 2 r: half of the samples have one of at least twice the mean."""
    data = document(parameters={"r": 50, "l": 160, "e": 0}, require={"stroke": ">= 100 mm"})
    vary = {"r": {"normal": 50, "sigma": 0.1}}
    outcome = lw.sweep(data, vary, samples=4000, plan="random", seed=3)
    share = outcome.shares["stroke"]
    assert outcome.table is not None
    assert share.met == int((outcome.table.parameters[0] >= 0.05).sum()) == int(outcome.table.met.sum())
    assert share.low is not None
    assert share.high is not None
    assert share.low < 0.5 < share.high
    assert outcome.done
    assert lw.sweep(data, {"r": [49, 50, 51]}).shares["stroke"].low is None  # a grid is no sample of anything


def test_samples_that_cannot_be_assembled() -> None:
    data = lw.Document.model_validate(
        four_bar(measures={"swing": {"span": "rocker.angle"}}, require={"swing": ">= 1 deg"})
    )
    outcome = lw.sweep(data, {"b": [100, 120, 250]}, ["swing", "B.x"], poses=24)
    assert outcome.table is not None
    assert outcome.failed == 1
    assert outcome.table.failed.tolist() == [False, False, True]
    assert outcome.table.since.tolist() == pytest.approx([np.nan, np.nan, 0.0], nan_ok=True)
    assert np.isnan(outcome.table.figures[0]).tolist() == [False, False, True]
    assert outcome.table.met.tolist() == [[True, True, False]]
    assert (outcome.bands["B.x"].count == 2).all()
    assert outcome.measures[0].count == 2
    (finding,) = outcome.warnings
    assert (finding.code, finding.severity) == ("varied.cannot-assemble", "warning")
    assert "1 of 3 samples" in finding.what
    assert "coupler" in finding.what
    assert outcome.done


def test_samples_that_stop_on_their_way_are_lost_where_they_stop() -> None:
    data = lw.Document.model_validate(four_bar(drives={"motor": {**CRANK, "start": "90 deg"}}))
    outcome = lw.sweep(data, {"c": [80, 55]}, ["B.x"], poses=360)
    assert outcome.table is not None
    # A is too near to O4 where |A O4|^2 = a^2 + d^2 - 2 a d cos(angle) is less than (b - c)^2.
    angle = np.degrees(np.arccos((40**2 + 100**2 - (120 - 55) ** 2) / (2 * 40 * 100)))
    assert outcome.table.since[1] == np.ceil(270 - angle) / 360
    count = outcome.bands["B.x"].count
    crank = 90 + np.arange(361)
    near = np.abs((crank + 180) % 360 - 180) < angle
    assert count.tolist() == np.where(near, 1, 2).tolist()


def test_no_sample_can_be_assembled() -> None:
    data = lw.Document.model_validate(four_bar(measures={"swing": {"span": "rocker.angle"}}))
    outcome = lw.sweep(data, {"b": [250, 300]})
    assert [f.code for f in outcome.failures] == ["varied.cannot-assemble"]
    assert not outcome.done
    assert outcome.failed == 2
    assert np.isnan(outcome.measures[0].mean)


def test_a_nominal_motion_that_stops_is_the_failure() -> None:
    sections = {"measures": {"swing": {"span": "rocker.angle"}}, "drives": {"motor": {**CRANK, "start": "90 deg"}}}
    outcome = lw.sweep(lw.Document.model_validate(four_bar(c=55, **sections)), {"b": [119, 120]})
    assert not outcome.done
    assert not outcome.performed
    assert all(f.code.startswith("motion.") for f in outcome.failures)


def test_a_motion_through_change_points_is_not_varied() -> None:
    parallel = {"cycle": {"turns": "1 motor", "samples": 24, "through": "keep"}}
    data = four_bar(a=40, b=100, c=40, d=100, studies=parallel)
    outcome = lw.sweep(lw.Document.model_validate(data), {"a": [40, 41]}, ["B.x"])
    assert [f.code for f in outcome.failures] == ["varied.passage"]


# The same figures, whoever computes them and in however many goes.

VARY = {"r": {"normal": 50, "sigma": 0.5}, "l": {"uniform": [150, 170]}}
MANY: dict[str, Any] = {"vary": VARY, "outputs": ["stroke", "C.x"], "samples": 2 * UNIT + 50, "poses": 40}


def same(a: SweepOutcome, b: SweepOutcome) -> None:
    assert a.table is not None
    assert b.table is not None
    for key in ("parameters", "figures", "met", "failed", "since"):
        np.testing.assert_array_equal(getattr(a.table, key), getattr(b.table, key))
    for text in a.bands:
        for key in ("mean", "deviation", "least", "largest", "count", "least_at", "largest_at"):
            np.testing.assert_array_equal(getattr(a.bands[text], key), getattr(b.bands[text], key))
    for x, y in zip(a.measures, b.measures, strict=True):
        assert (x.mean, x.deviation, x.least, x.largest, x.count) == (y.mean, y.deviation, y.least, y.largest, y.count)
        np.testing.assert_array_equal(x.counts, y.counts)


def performed(
    out: Path | None = None, stop_after: int | None = None, settle: bool = True, **options: Any
) -> SweepOutcome:
    data = document()
    studies = {**data.studies, "sweep": {**MANY, **options}}
    examined = examine_document(
        lw.Document.model_validate({**slider_crank(), "measures": {"stroke": {"span": "guide.s"}}, "studies": studies})
    )
    assert not examined.findings

    pressed: list[int] = []

    def progress(done: int, total: int) -> None:
        if stop_after is not None and done >= stop_after and not pressed:
            pressed.append(done)
            signal.raise_signal(signal.SIGINT)  # Ctrl-C

    job = perform(examined, RunContext(out=out, progress=progress))
    assert job.sweep is not None
    if settle:
        job.sweep.settle()
    return job.sweep


@pytest.fixture(scope="module")
def whole() -> SweepOutcome:
    return performed()


def test_one_thread_gives_the_same(whole: SweepOutcome) -> None:
    same(whole, lw.sweep(document(), **MANY, workers=1))


def test_an_interrupted_sweep_goes_on_to_the_same_figures(whole: SweepOutcome, tmp_path: Path) -> None:
    with pytest.raises(Interrupted) as stop:
        performed(tmp_path, stop_after=1)
    assert 0 < stop.value.carried.atoms < stop.value.carried.total
    assert str(tmp_path) in str(stop.value.what)
    assert [*tmp_path.iterdir()]
    outcome = performed(tmp_path)
    same(whole, outcome)
    assert 0 < outcome.poses < whole.poses
    assert not [*tmp_path.iterdir()]


def test_a_finished_sweep_is_kept_until_its_files_are_written(whole: SweepOutcome, tmp_path: Path) -> None:
    """Writing them may fail, on a full disk."""
    performed(tmp_path, settle=False)
    outcome = performed(tmp_path)
    same(whole, outcome)
    assert outcome.poses == 0
    assert not [*tmp_path.iterdir()]


def test_fresh_begins_anew(whole: SweepOutcome, tmp_path: Path) -> None:
    with pytest.raises(Interrupted):
        performed(tmp_path, stop_after=1)
    outcome = lw.sweep(document(), **MANY, out=tmp_path, fresh=True)
    same(whole, outcome)
    assert outcome.poses == whole.poses


def test_another_sweep_is_not_gone_on_with(tmp_path: Path) -> None:
    with pytest.raises(Interrupted):
        performed(tmp_path, stop_after=1)
    assert performed(tmp_path, seed=1).poses == performed().poses


def test_more_samples_than_rows(whole: SweepOutcome, monkeypatch: pytest.MonkeyPatch) -> None:
    """Statistics are the same; the histogram reaches beyond the first unit's figures and loses none of these."""
    monkeypatch.setattr(sampling_state, "ROWS", 5000)
    outcome = performed()
    assert outcome.table is None
    (a,), (b,) = outcome.measures, whole.measures
    assert (a.mean, a.deviation, a.least, a.largest, a.least_at) == (
        b.mean,
        b.deviation,
        b.least,
        b.largest,
        b.least_at,
    )
    assert a.counts.sum() + a.under + a.over == outcome.samples
    assert a.edges[0] < a.least
    assert a.largest < a.edges[-1]
    (c,), values = whole.measures, whole.table.figures[0] if whole.table else np.empty(0)
    assert a.counts.tolist() == np.histogram(values, a.edges)[0].tolist()
    assert c.counts.sum() == outcome.samples


# Every value of every sample.


def test_all_values_are_kept_in_memory(whole: SweepOutcome) -> None:
    outcome = lw.sweep(document(), {"r": STEPS}, ["B.x", "C.x"], poses=8, keep="all")
    assert outcome.values is not None
    assert outcome.table is not None
    r, angle = outcome.table.parameters[0], 2 * np.pi * np.arange(9) / 8
    np.testing.assert_allclose(outcome.values[0], np.outer(r, np.cos(angle)), atol=1e-16)
    np.testing.assert_array_equal(outcome.values[1].min(axis=0), outcome.bands["C.x"].least)


def test_too_many_values_for_memory(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sampling_state, "memory_to_keep", lambda: 80)
    with pytest.raises(lw.ModelError) as refusal:
        lw.sweep(document(), {"r": STEPS}, ["B.x"], keep="all")
    assert [f.code for f in refusal.value.findings] == ["study.no-folder"]


def test_all_values_are_stored_and_an_interrupted_store_goes_on(tmp_path: Path) -> None:
    zarr = pytest.importorskip("zarr")
    with pytest.raises(Interrupted):
        performed(tmp_path / "a", stop_after=1, keep="all")
    performed(tmp_path / "a", keep="all")
    outcome = performed(tmp_path / "b", keep="all")
    assert sorted(path.name for path in (tmp_path / "a").iterdir()) == ["sweep.zarr"]
    a, b = (zarr.open_group(tmp_path / name / "sweep.zarr", mode="r") for name in "ab")
    assert {*a} == {*b} == {"t", "r", "l", "stroke", "C.x"}
    assert outcome.table is not None
    for name in a:
        np.testing.assert_array_equal(a[name][...], b[name][...])
    np.testing.assert_array_equal(a["r"][...], outcome.table.parameters[0])
    np.testing.assert_array_equal(a["stroke"][...], outcome.table.figures[0])
    np.testing.assert_array_equal(a["C.x"][...].min(axis=0), outcome.bands["C.x"].least)
    assert a["C.x"].attrs["units"] == "m"
    performed(tmp_path / "a", keep="all", seed=5)  # a finished store gives way, as other files do
    assert (a["r"][...] != b["r"][...]).any()


def test_no_sample_has_a_value() -> None:
    """The rocker stands still twice a turn, whatever the crank's length: that isn't told of the first sample."""
    data = four_bar(measures={"advantage": {"max": "crank.omega/rocker.omega"}})
    outcome = lw.sweep(lw.Document.model_validate(data), {"a": {"from": 39, "to": 41, "count": 3}})
    (finding,) = [f for f in outcome.warnings + outcome.failures if f.code.startswith("study.")]
    assert (finding.code, finding.data["samples"]) == ("study.never-a-value", 3)
