"""Measures of many samples against those of a run of each, compiled from a file with its parameters, and closed forms.

The tolerance of 1e-9 of a measure's size is far above what is seen (1e-13 and less): both find the same roots to
round-off, and the panels of both integrate to 1e-12. It leaves room for extremes at kinks of forces, and for figures
that are small differences of the samples' parameters.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from helpers.longer import mostly_long
from kernels.test_parameter_batch import class_four, platform
from linkwright.compilation import compile_mechanism
from linkwright.expressions.units import si_text
from linkwright.kernels import Compiled
from linkwright.kernels.parameter_batch import Varied
from linkwright.measures import MeasureResult, bound_measures, measure_all
from linkwright.model.document import Document, load, replaced
from linkwright.reductions import REDUCTIONS
from linkwright.results import Run
from linkwright.studies.batch_plan import Many, Measuring
from linkwright.studies.cycle.options import CycleOptions, span
from studies.models import UNITS, four_bar, slider_crank
from studies.test_measures import SIGNALS

Array = NDArray[np.float64]
ROOT = Path(__file__).parents[2]
CLOSE = 1e-9


def run_of(document: Document, compiled: Compiled) -> Run:
    options = CycleOptions.model_validate(dict(document.studies["cycle"]))
    stop, findings = span(compiled, options)
    assert not findings
    return Run(compiled, 0.0, stop, options.samples)


@dataclass
class Batch:
    """Samples of a model file, with the values (names, samples) of the parameters that vary."""

    document: Document
    names: Sequence[str]
    values: Array
    folder: Path | None = None

    @classmethod
    def round_nominal(cls, path: str, share: float, samples: int, seed: int = 0) -> Batch:
        """All parameters that are plain numbers, spread evenly round their values."""
        document = load(ROOT / path)
        quantities = compile_mechanism(document, (ROOT / path).parent).quantities
        free = [name for name, value in quantities.mechanism.parameters.items() if value.value.text[:1].isdigit()]
        shares = np.random.default_rng(seed).uniform(-share, share, (len(free), samples))
        nominal = np.array([quantities.parameters[name] for name in free])
        return cls(document, free, nominal[:, None] * (1 + shares), (ROOT / path).parent)

    @cached_property
    def compiled(self) -> Compiled:
        return compile_mechanism(self.document, self.folder)

    @cached_property
    def varied(self) -> Varied:
        return Varied(self.compiled, self.names)

    @cached_property
    def p(self) -> Array:
        return self.varied.parameters(self.values)

    @cached_property
    def measuring(self) -> Measuring:
        return Measuring(self.varied, run_of(self.document, self.compiled))

    def alone(self, i: int) -> Run:
        """The run of a sample, compiled on its own."""
        dimensions = self.compiled.quantities.dimensions
        units = {name: si_text(dimensions.resolve(dimensions.of(name))) for name in self.names}
        texts = {
            name: f"{float(value)!r} {units[name]}".strip()
            for name, value in zip(self.names, self.values[:, i], strict=True)
        }
        document = replaced(self.document, texts)
        return run_of(document, compile_mechanism(document, self.folder))

    def check(self, stop: Array | None = None) -> Many:
        """Every figure, time and verdict of every sample is that of its own run."""
        many = self.measuring.evaluate(self.p, stop)
        for i in range(self.values.shape[1]):
            run = self.alone(i)
            for result in measure_all(run)[0]:
                same(many, result, run, i)
        return many


def same(many: Many, result: MeasureResult, run: Run, i: int) -> None:
    figures = many.figures[result.name]
    assert {f.label for f in result.found} == {*figures}
    size = max(float(np.nanmax(np.abs(f.values))) for f in figures.values())
    tree = bound_measures(run.compiled.quantities, [result.name])[0].signal
    if result.measure.reduction == "mean":  # which may be zero
        size = max(size, float(np.abs(run.jets(tree, run.t).d[0]).max()))
    for f in result.found:
        found, time = figures[f.label].values[i], figures[f.label].times[i]
        assert found == pytest.approx(f.value, rel=CLOSE, abs=CLOSE * size), (result.name, f.label)
        assert np.isnan(time) == (f.time is None)
        if f.time is not None and result.measure.reduction != "dwell" and result.measure.wrap is None:
            there = float(run.jets(tree, np.array([time])).d[0][0])  # of equal extremes either may be named
            assert there == pytest.approx(f.value, rel=CLOSE, abs=CLOSE * size)
    if result.verdict is not None:
        assert many.met[result.name][i] == result.verdict


def batch(data: Mapping[str, Any], **values: Sequence[float]) -> Batch:
    """Samples of a model's data; values are in SI."""
    return Batch(Document.model_validate(dict(data)), [*values], np.array([*values.values()], dtype=float))


def bits(many: Many) -> list[bytes]:
    """All that is known of each sample."""
    rows = [row for found in many.figures.values() for f in found.values() for row in (f.values, f.times)]
    return [column.tobytes() for column in np.array([*rows, many.failed, *many.met.values()], dtype=float).T.copy()]


# Against runs of their own.


ROUND_NOMINAL = [
    "examples/paper_feeder.yaml",
    "examples/four_bar.yaml",
    "examples/slider_crank.yaml",
    "examples/quick_return.yaml",
    "examples/jansen_leg.yaml",
    "examples/press_law.yaml",
    "examples/five_bar.yaml",
    "examples/tailgate.yaml",
    "src/linkwright/gallery/walking-leg.yaml",
    "src/linkwright/gallery/pumpjack.yaml",
    "src/linkwright/gallery/dwell-six-bar.yaml",
]


OTHERS = ("four_bar", "jansen_leg", "walking-leg", "pumpjack", "dwell-six-bar")
"""Of these, what has the same kinds of measures and groups as another."""


@pytest.mark.parametrize("samples", [2, pytest.param(8, marks=pytest.mark.long)])
@pytest.mark.parametrize("path", mostly_long(ROUND_NOMINAL, lambda path: Path(path).stem not in OTHERS))
def test_each_sample_has_the_measures_of_its_own_run(path: str, samples: int) -> None:
    share = 0.002 if "tailgate" in path else 0.01
    many = Batch.round_nominal(path, share, samples).check()
    assert not many.failed.any()


@pytest.mark.parametrize("path", ["examples/slider_crank_gas.yaml", "examples/straight_line.yaml"])
def test_measures_that_go_through_a_run_of_each_sample(path: str) -> None:
    """Means of forces that a table of straight lines makes; dwells, straightness, instant centres."""
    one = Batch.round_nominal(path, 0.002, 2)
    assert one.measuring.single
    one.check()


@pytest.mark.parametrize("made", [platform, class_four])
def test_higher_groups(made: Callable[[], Document]) -> None:
    """Groups that Newton's method solves, followed from the start of each sample."""
    document = made()
    quantities = compile_mechanism(document).quantities
    names = [*quantities.parameters]
    shares = 1 + np.random.default_rng(0).uniform(-0.005, 0.005, (len(names), 3))
    some = Batch(document, names, np.array([*quantities.parameters.values()])[:, None] * shares)
    assert not some.check().failed.any()
    assert bits(some.measuring.evaluate(some.p[:, 1:])) == bits(some.measuring.evaluate(some.p))[1:]


@pytest.mark.long
def test_a_drive_with_dwells() -> None:
    """Its law has corners that depend on the lengths; the dwell itself is taken of each sample on its own."""
    some = Batch.round_nominal("examples/paper_feeder_dwell.yaml", 0.01, 2)
    assert some.measuring.single == {"left_dwell_1mm"}
    some.check()


def test_every_reduction() -> None:
    """Whatever a measure may be, a sample has it as its own run has."""
    measures: dict[str, dict[str, Any]] = {kind: {kind: "P.y"} for kind in REDUCTIONS}
    measures["value"] |= {"where": "min P.x"}
    measures["dwell"] |= {"within": "5 mm"}
    measures |= {"efficiency": {"efficiency": ["drag"]}, "share": {"share": ["oil"], "useful": ["drag"]}}
    measures |= {"path": {"path": "P"}, "straightness": {"straightness": "P"}}
    named = {f"{kind}_": measure for kind, measure in measures.items()}
    drag = {"on": "coupler", "at": "P", "force": ["-20 N*P.vx/(1 m/s)", "-20 N*P.vy/(1 m/s)"]}
    oil = {"turns": "rocker", "on": "frame", "damping": "0.1 N*m*s/rad"}
    data = four_bar(measures=named, loads={"drag": drag}, springs={"oil": oil})
    some = batch(data, a=[0.04, 0.042], b=[0.12, 0.118])
    assert some.measuring.single == {"straightness_", "dwell_"}
    some.check()


def test_all_kinds_of_curves() -> None:
    """Motion, forces, energies and expressions with corners: extremes, means, roots of mean squares."""
    kinds = ("extremes", "mean", "rms")
    measures = {f"m{i}{kind}": {kind: signal} for i, signal in enumerate(SIGNALS) for kind in kinds}
    shares = 1 + np.random.default_rng(0).uniform(-0.03, 0.03, (4, 4))
    values = dict(zip("abcd", np.array([[0.04], [0.12], [0.08], [0.1]]) * shares, strict=True))
    some = batch(four_bar(measures=measures), **values)
    assert not some.measuring.single
    some.check()


R, L, E = np.array([0.05, 0.048, 0.055, 0.06]), np.array([0.16, 0.17, 0.15, 0.2]), np.array([0.02, -0.01, 0.0, 0.03])


def slider_cranks(**sections: Any) -> Batch:
    return batch(slider_crank(**sections), r=R, l=L, e=E)


def values(some: Batch, label: str = "", **measure: Any) -> Array:
    """One measure of samples, SI."""
    data = {**some.document.model_dump(exclude_unset=True, by_alias=True), "measures": {"m": measure}}
    made = Batch(Document.model_validate(data), some.names, some.values)
    return made.measuring.evaluate(made.p).figures["m"][label].values


# Closed forms.


def near(wanted: Array, tolerance: float = 1e-12) -> Any:
    return pytest.approx(wanted, rel=tolerance, abs=tolerance)


def test_strokes_and_dead_centres_in_closed_form() -> None:
    some = slider_cranks(
        measures={
            "stroke": {"span": "guide.s"},
            "far": {"value": "motor.angle", "where": "max guide.s", "wrap": [-180, 180]},
            "near": {"value": "motor.angle", "where": "min guide.s", "wrap": ["0 deg", "360 deg"]},
            "fast": {"max": "abs(B.vx)"},
        }
    )
    many = some.measuring.evaluate(some.p)
    figures = {name: found[""].values for name, found in many.figures.items()}
    assert figures["stroke"] == near(np.sqrt((L + R) ** 2 - E**2) - np.sqrt((L - R) ** 2 - E**2))
    assert figures["far"] == near(np.arcsin(E / (L + R)))
    assert figures["near"] == near(np.pi + np.arcsin(E / (L - R)))
    assert figures["fast"] == near(2 * np.pi * R)
    assert many.figures["far"][""].times % 1.0 == near(np.arcsin(E / (L + R)) / (2 * np.pi) % 1.0)


def test_means_in_closed_form() -> None:
    turn = {"up": {"motor.angle": ["0 deg", "180 deg"]}, "late": ["0.25 s", "0.75 s"]}
    some = slider_cranks(windows=turn)
    assert values(some, mean="abs(B.x)") == near(2 * R / np.pi)
    assert values(some, mean="max(B.x, r/2)") == near(R / np.pi * (np.sqrt(3) / 2 + np.pi / 3))
    assert values(some, rms="B.x") == near(R / np.sqrt(2))
    assert values(some, mean="B.y", window="up") == near(2 * R / np.pi)
    assert values(some, mean="B.x", window="late") == near(-2 * R / np.pi)
    assert values(some, path="B") == near(2 * np.pi * R)
    stroke = np.sqrt((L + R) ** 2 - E**2) - np.sqrt((L - R) ** 2 - E**2)
    assert values(some, path="C") == near(2 * stroke, 1e-10)


def test_windows_follow_the_parameters() -> None:
    windows = {
        "high": {"B.y": ["0.5*r", "2*r"]},
        "early": ["0 s", "(5 s/m)*r"],
        "never": {"B.y": ["1.5*r", "2*r"]},
        "steep": {"crank.angle": ["30 deg", "150 deg"]},
    }
    some = slider_cranks(windows=windows)
    assert values(some, max="t", window="high") == near(np.full(4, 5 / 12))
    assert values(some, min="t", window="steep") == near(np.full(4, 1 / 12))
    assert values(some, mean="B.y", window="high") == near(R * 3 * np.sqrt(3) / (2 * np.pi))
    assert values(some, max="motor.angle", window="early") == near(np.pi / 2 * R / 0.05)
    assert np.isnan(values(some, max="B.y", window="never")).all()
    assert np.isnan(values(some, mean="B.y", window="never")).all()
    assert np.isnan(values(some, value="B.y", where="start", window="never")).all()


def test_places_at_the_ends_of_several_intervals() -> None:
    """Over three turns the crank is up three times."""
    studies = {"cycle": {"turns": "3 motor", "samples": 90}}
    some = slider_cranks(windows={"up": {"B.y": ["r/2", "r"]}}, studies=studies)
    assert values(some, value="t", where="start", window="up") == near(np.full(4, 1 / 12))
    assert values(some, value="t", where="end", window="up") == near(np.full(4, 2 + 5 / 12))
    assert values(some, mean="B.y", window="up") == near(R * 3 * np.sqrt(3) / (2 * np.pi))


def test_angles_run_on() -> None:
    """Backwards over four turns, from an angle read off the axis; a coupler that swings about 180 deg."""
    drive = {"turns": "crank", "on": "frame", "speed": "-60 rpm", "start": "170 deg"}
    some = slider_cranks(drives={"motor": drive}, studies={"cycle": {"turns": "4 motor", "samples": 40}})
    assert values(some, span="crank.angle") == near(np.full(4, 8 * np.pi))
    assert values(some, value="crank.angle - motor.angle", where="end") == near(np.zeros(4))
    assert values(some, span="rod.angle") == near(np.arcsin((R + E) / L) + np.arcsin((R - E) / L))


def test_samples_too_fast_for_the_grid() -> None:
    """A drag link that turns 70 times where the nominal one turns once, and sweeps 70 whole turns."""
    drive = {"turns": "crank", "on": "frame", "speed": "n", "start": "0 deg"}
    measures = {"swept": {"span": "rocker.angle"}, "last": {"value": "rocker.angle", "where": "end", "wrap": [0, 360]}}
    data = four_bar(80, 70, 80, 30, drives={"motor": drive}, measures=measures)
    data["parameters"] |= {"n": "60 rpm"}
    data["studies"] = {"cycle": {"duration": "1 s", "samples": 60}}
    n = np.array([1.0, 70.0, 2.0])
    many = batch(data, n=2 * np.pi * n).check()
    assert many.figures["swept"][""].values == near(2 * np.pi * n, 1e-10)


def test_spans_of_their_own() -> None:
    """A turn at another speed takes another time."""
    drive = {"turns": "crank", "on": "frame", "speed": "n", "start": "0 deg"}
    data = slider_crank(drives={"motor": drive}, measures={"fast": {"max": "B.vx"}, "mean": {"mean": "abs(B.vx)"}})
    data["parameters"] |= {"n": "60 rpm"}
    n = 2 * np.pi * np.array([1.0, 0.9, 1.3])
    some = batch(data, n=n)
    many = some.check(stop=2 * np.pi / n)
    assert many.figures["fast"][""].values == near(0.05 * n)
    assert many.figures["mean"][""].values == near(0.05 * n * 2 / np.pi)


def test_loads_that_act_in_windows() -> None:
    """Their jumps are candidates of extremes; two may meet, or lie at the end of the run or of a measure's window."""
    push = {"on": "slider", "at": "C", "force": ["-r*1 N/mm", 0]}
    loads = {name: push | {"window": name} for name in ("w", "late", "same")}
    ends = {f"at_{end}": {"value": "motor.torque", "where": end, "window": "w"} for end in ("start", "end")}
    some = slider_cranks(
        loads=loads,
        windows={"w": {"B.y": ["0.5*r", "2*r"]}, "late": ["0.3 s", "5 s"], "same": {"B.y": ["0.5*r", "3*r"]}},
        measures={
            "torque": {"extremes": "motor.torque"},
            "mean": {"mean": "motor.torque"},
            "rms": {"rms": "motor.torque", "window": "late"},
            "inside": {"extremes": "motor.torque", "window": "w"},
            "place": {"value": "B.x", "where": "max motor.torque"},
            "x": {"max": "B.x"},
            **ends,
        },
    )
    assert not some.measuring.single
    some.check()


def crank(position: str, **sections: Any) -> dict[str, Any]:
    """One link that a drive turns, over a second."""
    return {
        "units": UNITS,
        "links": {
            "frame": {"points": {"A": [0, 0]}},
            "crank": {"points": {"A": [0, 0], "B": [100, 0]}, "mass": 1, "shape": "rod A-B"},
        },
        "drives": {"motor": {"turns": "crank", "on": "frame", "position": position}},
        "studies": {"cycle": {"duration": "1 s", "samples": 60}},
        **sections,
    }


def test_extremes_right_beside_the_joins_of_laws() -> None:
    """A cubic polynomial's jerk is -12 h/w^3 all over, a cycloid's 4 pi^2 h/w^3 at its ends (and minus that of a fall):
    extremes on one side of a jump, where the rate needn't change its sign."""
    turn, h, w = 2 * np.pi, np.radians([20.0, 20.6, 19.0]), np.radians([90.0, 87.3, 95.0])
    dwell = {"dwell": "180-w"}
    for kind, jerks in (({"from": [0], "to": [0]}, (-12, 12)), ({"law": "cycloidal"}, (-(turn**2), turn**2))):
        segments = [{"rise": "h", "over": "w", **kind}, dwell, {"rise": "-h", "over": "w", **kind}, dwell]
        some = batch(
            crank(
                "push(360 deg*t/(1 s) + 200 deg)",
                parameters={"h": "20 deg", "w": "90 deg"},
                laws={"push": {"over": "angle", "of": "angle", "segments": segments}},
                measures={"jerk": {"extremes": "crank.jerk"}, "torque": {"extremes": "motor.torque"}},
            ),
            h=h,
            w=w,
        )
        assert not some.measuring.single
        many = some.check()
        for label, factor in zip(("min", "max"), jerks, strict=True):
            found = many.figures["jerk"][label].values
            assert found == pytest.approx(factor * h / w**3 * turn**3, rel=1e-8)


def test_an_extreme_between_a_jump_and_the_next_place_of_the_grid() -> None:
    """The torque -a t - k s (s - d), s from 0.5 s on only: largest 0.2 ms behind the jump of its rate and falling again
    at the next place of any grid."""
    loads = {"ramp": {"on": "crank", "torque": "a*t/(1 s)"}, "hill": {
        "on": "crank", "torque": "b + k*(t/(1 s) - 0.5)*(t/(1 s) - 0.5006)", "window": "late"}}  # fmt: skip
    a, k = np.array([200.0, 202.0]), np.array([1e6, 0.99e6])
    some = batch(
        crank(
            "360 deg*t/(1 s)",
            parameters={"a": "200 N*m", "b": "1 N*m", "k": "1e6 N*m"},
            loads=loads,
            windows={"late": ["0.5 s", "2 s"]},
            measures={"top": {"max": "motor.torque", "window": "late"}},
        ),
        a=a,
        k=k,
    )
    place = 3e-4 - a / (2 * k)
    assert some.check().figures["top"][""].values == near(-1 - a / 2 + k * place**2)


# What fails, what isn't met.


def test_samples_that_can_not_go_round() -> None:
    """A four-bar whose crank is too long for a turn, one that comes to a change point, one that is no four-bar."""
    a, b = np.array([0.04, 0.07, 0.06, 0.01, 0.05]), np.array([0.12, 0.12, 0.12, 0.30, np.nan])
    measures = {"swing": {"span": "rocker.angle"}, "lift": {"extremes": "P.y"}, "mean": {"mean": "P.x"}}
    data = four_bar(measures=measures, require={"swing": ">= 0 deg", "lift": "<= b"})
    some = batch(data, a=a, b=b)
    many = some.measuring.evaluate(some.p)
    assert many.failed.tolist() == [False, True, True, True, True]
    for found in many.figures.values():
        for figures in found.values():
            assert np.isnan(figures.values).tolist() == many.failed.tolist()
            assert np.isnan(figures.times[1:]).all()
    assert many.met["swing"].tolist() == [True, False, False, False, False]
    assert many.good.tolist() == [True, False, False, False, False]


def test_a_sample_that_just_misses_closing_between_two_places_of_the_grid() -> None:
    """At a crank angle of 180 deg, 3 deg off any place: the rods are to span 140 mm, the rocker takes 80 of them."""
    drive = {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": "0.7 deg"}
    data = four_bar(b=61, drives={"motor": drive}, measures={"swing": {"span": "rocker.angle"}})
    some = batch(data, b=0.06 + np.array([1e-4, 1e-9, -1e-9, 0.0]))
    assert some.measuring.evaluate(some.p).failed.tolist() == [False, False, True, True]
    assert np.isfinite(some.varied.evaluate(["P.x"], some.p, np.linspace(0, 1, some.measuring.steps + 1))).all()


def test_requirements_follow_the_parameters() -> None:
    some = slider_cranks(
        measures={"stroke": {"span": "guide.s"}, "s": {"extremes": "guide.s"}},
        require={"stroke": ">= l - 60 mm", "s": "100 mm .. l + r"},
    )
    many = some.check()
    stroke = np.sqrt((L + R) ** 2 - E**2) - np.sqrt((L - R) ** 2 - E**2)
    low = np.sqrt((L - R) ** 2 - E**2)
    assert many.met["stroke"].tolist() == (stroke >= L - 0.06).tolist()
    assert many.met["s"].tolist() == (low >= 0.1).tolist()
    assert many.good.tolist() == [True, False, False, False]


def test_a_measure_without_a_finite_value_has_none() -> None:
    """The others keep theirs; a root is of a number only where the crank is long enough."""
    some = slider_cranks()
    assert np.isnan(values(some, max="sqrt(B.x - r)")).all()
    found = values(some, max="sqrt(B.x + 55 mm)")
    assert np.isnan(found).tolist() == [False, False, False, True]
    assert found[:3] == near(np.sqrt(R[:3] + 0.055))


# One with another.


@pytest.mark.parametrize(
    "path",
    ["examples/paper_feeder.yaml", "examples/four_bar.yaml", "examples/tailgate.yaml", "examples/jansen_leg.yaml"],
)
def test_a_sample_does_not_depend_on_the_others_to_the_last_bit(path: str, monkeypatch: pytest.MonkeyPatch) -> None:
    some = Batch.round_nominal(path, 0.01 if "tailgate" not in path else 0.002, 23)
    whole = bits(some.measuring.evaluate(some.p))
    assert bits(some.measuring.evaluate(some.p[:, :1])) == whole[:1]
    assert bits(some.measuring.evaluate(some.p[:, 5:12])) == whole[5:12]
    order = np.random.default_rng(1).permutation(23)
    assert bits(some.measuring.evaluate(some.p[:, order])) == [whole[i] for i in order]
    monkeypatch.setattr("linkwright.studies.batch_plan.CHUNK", 3000)
    assert bits(some.measuring.evaluate(some.p)) == whole


def test_some_names_only() -> None:
    some = Batch.round_nominal("examples/paper_feeder.yaml", 0.01, 3)
    run = run_of(some.document, some.compiled)
    named = bound_measures(some.compiled.quantities, ["stroke", "M0_feed"])
    many = Measuring(some.varied, run, named).evaluate(some.p)
    assert [*many.figures] == ["stroke", "M0_feed"]
    assert [*many.met] == ["stroke"]
    whole = some.measuring.evaluate(some.p)
    assert many.figures["M0_feed"]["max"].values == near(whole.figures["M0_feed"]["max"].values)


def test_samples_in_which_a_denominator_vanishes_have_no_number() -> None:
    """The slider's largest x is sqrt((r + l)^2 - e^2): 209.04 mm at r = 50 mm, so that some samples pass 209 mm."""
    data = slider_crank(measures={"m": {"max": "1 mm/(210 mm - C.x)"}, "x": {"max": "C.x"}})
    radii = [0.045, 0.0505, 0.0509, 0.05095, 0.051, 0.055]
    some = batch(data, r=radii)
    many = some.measuring.evaluate(some.p)
    reach = np.sqrt((np.array(radii) + 0.16) ** 2 - 0.02**2)
    assert np.isnan(many.figures["m"][""].values).tolist() == (reach > 0.21).tolist()
    finite = reach < 0.21
    assert many.figures["m"][""].values[finite] == pytest.approx(1e-3 / (0.21 - reach[finite]), rel=1e-8)
    assert many.figures["x"][""].values == pytest.approx(reach, rel=1e-12)


def test_samples_near_a_change_point_have_the_peaks_of_their_own_runs() -> None:
    data = four_bar(d=100, measures={"torque": {"extremes": "motor.torque"}, "rms": {"rms": "rocker.omega"}})
    batch(data, d=[0.1, 0.0801, 0.080001, 0.08000001]).check()
