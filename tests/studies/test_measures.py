"""Every reduction against a closed form; extremes to round-off, whatever the number of samples."""

from __future__ import annotations

import math
from typing import Any

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from linkwright.reductions import REDUCTIONS
from studies.models import at, cycle_of, four_bar, job_of, measured, refused, slider_crank, slider_x, value

R, L, E = 50.0, 160.0, 20.0
TOP, BOTTOM = math.sqrt((L + R) ** 2 - E**2), math.sqrt((L - R) ** 2 - E**2)
TOP_ANGLE = math.degrees(math.asin(E / (L + R)))
BOTTOM_ANGLE = 180 + math.degrees(math.asin(E / (L - R)))


def near(wanted: float, tolerance: float = 1e-12) -> Any:
    return pytest.approx(wanted, rel=tolerance, abs=tolerance)


# Each reduction.


def test_span_max_min_extremes() -> None:
    data = slider_crank()
    assert value(data, span="guide.s") == near(TOP - BOTTOM)
    assert value(data, max="guide.s") == near(TOP)
    assert value(data, min="guide.s") == near(BOTTOM)
    found = measured(data, both={"extremes": "guide.s"})["both"]
    assert (found.shown("min"), found.shown("max")) == (near(BOTTOM), near(TOP))


def test_places_of_extremes() -> None:
    """The times of extremes are as good as a stationary point allows: half the digits of the value."""
    found = measured(slider_crank(), both={"extremes": "guide.s"})["both"]
    times = {f.label: f.time for f in found.found}
    assert times["max"] == near(TOP_ANGLE / 360, 1e-12)
    assert times["min"] == near(BOTTOM_ANGLE / 360, 1e-12)


def test_value_where() -> None:
    data = slider_crank()
    assert value(data, value="motor.angle", where="max guide.s") == near(TOP_ANGLE, 1e-11)
    assert value(data, value="motor.angle", where="min guide.s") == near(BOTTOM_ANGLE, 1e-11)
    assert value(data, value="motor.angle", where="start") == 0.0
    assert value(data, value="motor.angle", where="end") == near(360.0)
    assert value(data, value="guide.s", where="max guide.s") == near(TOP)
    assert value(data, value="B.y", where="max B.x^2 - B.y^2") == near(0.0, 1e-9)
    assert value(data, value="t", where="max C.vx") == near(value(data, value="t", where="min -C.vx"))


def test_value_where_in_a_window() -> None:
    data = slider_crank(windows={"w": ["0.3 s", "0.4 s"], "back": {"motor.angle": ["90 deg", "100 deg"]}})
    assert value(data, value="t", where="max guide.s", window="w") == near(0.3)
    assert value(data, value="t", where="min guide.s", window="w") == near(0.4)
    assert value(data, value="motor.angle", where="start", window="back") == near(90.0)
    assert value(data, value="motor.angle", where="end", window="back") == near(100.0)


def quad(f: Any, low: float = 0.0, high: float = 2 * math.pi) -> float:
    with mpmath.workdps(25):
        return float(mpmath.quad(f, np.linspace(low, high, 9).tolist()) / (high - low))


def test_mean_and_rms() -> None:
    def s(angle: Any) -> Any:
        return R * mpmath.cos(angle) + mpmath.sqrt(L**2 - (R * mpmath.sin(angle) - E) ** 2)

    data = slider_crank()
    assert value(data, mean="guide.s") == near(quad(s))
    assert value(data, rms="guide.s") == near(math.sqrt(quad(lambda a: s(a) ** 2)))
    assert value(data, rms="B.x") == near(R / math.sqrt(2))
    assert value(data, mean="B.x") == near(0.0, 1e-11)
    assert value(data, mean="abs(B.x)") == near(2 * R / math.pi)
    assert value(data, mean="t") == near(0.5)
    assert value(data, rms="t") == near(1 / math.sqrt(3))


def test_mean_over_a_window() -> None:
    windows = {"half": {"motor.angle": ["0 deg", "180 deg"]}, "quarter": ["0 s", "0.25 s"]}
    data = slider_crank(windows=windows)
    assert value(data, mean="B.y", window="half") == near(2 * R / math.pi)
    assert value(data, mean="B.x", window="quarter") == near(2 * R / math.pi)
    assert value(data, rms="B.x", window="quarter") == near(R / math.sqrt(2))


def test_a_test_covers_each_reduction() -> None:
    """Those of a path, dwells and efficiencies have files of their own in tests/reductions."""
    others = {"span", "max", "min", "extremes", "mean", "rms", "path", "straightness", "dwell", "efficiency", "share"}
    assert {*REDUCTIONS} == {*others, "value"}


# Extremes are root-found.

SIGNALS = [
    "P.x", "P.vx", "P.ay", "rocker.angle", "rocker.omega", "rocker.alpha", "coupler.jerk", "motor.torque",
    "motor.power", "force(frame, crank).x", "force(coupler, rocker).y", "shaking.moment", "energy.kinetic",
    "hypot(P.vx, P.vy)", "abs(rocker.omega)*2 - P.x*(1 deg/s/mm)", "P.x*rocker.omega", "min(P.x, P.y)",
]  # fmt: skip


def golden(f: Any, a: float, b: float) -> float:
    """The largest value of f in a..b by golden section."""
    ratio = (math.sqrt(5) - 1) / 2
    c, d = b - ratio * (b - a), a + ratio * (b - a)
    fc, fd = f(c), f(d)
    for _ in range(60):
        if fc > fd:
            b, d, fd = d, c, fc
            c = b - ratio * (b - a)
            fc = f(c)
        else:
            a, c, fc = c, d, fd
            d = a + ratio * (b - a)
            fd = f(d)
    return max(fc, fd)


@pytest.fixture(scope="module")
def swinging() -> Any:
    """A four-bar with the extremes of every signal, and with a dense table of them."""
    measures = {f"m{i}": {"extremes": signal} for i, signal in enumerate(SIGNALS)}
    return cycle_of(four_bar(measures=measures))


@pytest.mark.parametrize("signal", SIGNALS)
def test_extremes_agree_with_golden_section(swinging: Any, signal: str) -> None:
    run = swinging.result.run
    found = swinging.measures[SIGNALS.index(signal)]
    t = np.linspace(run.start, run.stop, 4001)
    dense = at(run, signal, t)

    size = float(np.abs(dense).max())
    for label, sign in (("max", 1.0), ("min", -1.0)):
        i = int(np.argmax(sign * dense))
        refined = golden(
            lambda time, s=sign: s * float(at(run, signal, np.array([time]))[0]),
            t[max(i - 1, 0)],
            t[min(i + 1, t.size - 1)],
        )
        best = max(refined, sign * float(dense[i]))
        value = next(f.value for f in found.found if f.label == label)
        assert sign * value == pytest.approx(best, rel=1e-10, abs=1e-12 * size)
        assert sign * value >= best - 1e-13 * size


@pytest.mark.parametrize("samples", [2, 8, 61, 500, 2000])
def test_measures_do_not_depend_on_samples(swinging: Any, samples: int) -> None:
    measures = {m.name: {"extremes": m.measure.signal.raw} for m in swinging.measures}
    measures |= {"mean": {"mean": "motor.torque"}, "rms": {"rms": "motor.torque"}}
    studies = {"cycle": {"turns": "1 motor", "samples": samples}}
    outcome = cycle_of(four_bar(measures=measures, studies=studies))
    for m in outcome.measures[:-2]:
        other = next(o for o in swinging.measures if o.name == m.name)
        size = max(abs(f.value) for f in other.found)
        for f, g in zip(m.found, other.found, strict=True):
            assert f.value == pytest.approx(g.value, rel=1e-10, abs=1e-11 * size)
    reference = measured(four_bar(), mean={"mean": "motor.torque"}, rms={"rms": "motor.torque"})
    rms = reference["rms"].shown()
    assert [m.shown() for m in outcome.measures[-2:]] == pytest.approx(
        [reference["mean"].shown(), rms], abs=1e-11 * rms
    )


@settings(max_examples=15)
@given(st.floats(20, 60), st.floats(110, 250), st.floats(-30, 30), st.floats(-400, 400))
def test_stroke_of_any_slider_crank(r: float, l: float, e: float, start: float) -> None:  # noqa: E741
    """Over one whole turn, wherever it starts."""
    drive = {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": f"{start} deg"}
    stroke = math.sqrt((l + r) ** 2 - e**2) - math.sqrt((l - r) ** 2 - e**2)
    assert value(slider_crank(r, l, e, drives={"motor": drive}), span="guide.s") == near(stroke)


@pytest.mark.parametrize("turns", [1, 7, 40])
def test_extremes_over_many_turns(turns: int) -> None:
    studies = {"cycle": {"turns": f"{turns} motor", "samples": 50}}
    assert value(slider_crank(studies=studies), span="guide.s") == near(TOP - BOTTOM)


@pytest.mark.parametrize("samples", [8, 50, 200])
def test_a_short_move_in_a_long_rest_is_seen(samples: int) -> None:
    """10 ms of motion in 2 s: a 3-4-5 move of 10 deg, its peaks in closed form."""
    drive = {"turns": "crank", "on": "frame", "position": "step5(t, 0.7131 s, 0 deg, 0.7231 s, 10 deg)"}
    data = slider_crank(drives={"motor": drive}, studies={"cycle": {"duration": "2 s", "samples": samples}})
    found = measured(data, speed={"max": "motor.omega"}, rate={"extremes": "motor.alpha"}, mean={"mean": "motor.omega"})
    assert found["mean"].shown() == near(5.0, 1e-6)
    assert found["speed"].shown() == near(10 * 15 / 8 / 0.01, 1e-10)
    assert found["rate"].shown("max") == near(10 * 10 / math.sqrt(3) / 0.01**2, 1e-9)
    assert found["rate"].shown("min") == near(-10 * 10 / math.sqrt(3) / 0.01**2, 1e-9)


def test_a_high_peak_does_not_hide_the_rest() -> None:
    """Beside a peak of 1e8 the other turning points still count."""
    found = measured(slider_crank(), m={"extremes": "B.y + 1e8 mm*exp(-((t - 0.4 s)/(0.01 s))^2)"})["m"]
    assert found.shown("max") == near(1e8, 1e-6)
    assert found.shown("min") == near(-R, 1e-9)


def test_window_ends_count() -> None:
    """Where a signal only rises, its extremes are at the ends of the window or run."""
    windows = {"w": ["0.1 s", "0.4 s"], "late": ["0.9 s", "5 s"], "early": ["-1 s", "0.2 s"]}
    data = slider_crank(windows=windows)
    assert value(data, "", span="t") == near(1.0)
    for window, ends in (("w", (0.1, 0.4)), ("late", (0.9, 1.0)), ("early", (0.0, 0.2))):
        found = measured(data, m={"extremes": "motor.angle", "window": window})["m"]
        assert (found.shown("min"), found.shown("max")) == (near(360 * ends[0]), near(360 * ends[1]))
        assert [f.time for f in found.found] == [near(ends[0]), near(ends[1])]


def test_an_extreme_outside_the_window_does_not_count() -> None:
    data = slider_crank(windows={"w": ["0.2 s", "0.3 s"]})
    assert value(data, max="guide.s", window="w") == near(float(slider_x(0.4 * math.pi)))
    assert value(data, min="guide.s", window="w") == near(float(slider_x(0.6 * math.pi)))


def test_a_constant_signal() -> None:
    data = slider_crank()
    assert value(data, span="C.y") == near(0.0)
    assert value(data, max="C.y") == near(E)
    assert value(data, max="r") == R
    assert value(data, mean="2*r + l") == near(2 * R + L)


# Kinks and corners.


def test_kinks_of_abs() -> None:
    data = slider_crank()
    assert value(data, min="abs(C.vx)") == near(0.0, 1e-9)
    assert value(data, max="abs(B.y)") == near(R)
    assert value(data, max="-abs(guide.s - 150 mm)") == near(0.0, 1e-10)
    times = sorted(value(data, value="t", where=f"{which} abs(C.vx)") for which in ("min",))
    assert times[0] in (near(TOP_ANGLE / 360, 1e-9), near(BOTTOM_ANGLE / 360, 1e-9))
    speeds = measured(data, fast={"max": "abs(C.vx)"}, least={"min": "C.vx"}, most={"max": "C.vx"})
    assert speeds["fast"].shown() == near(max(-speeds["least"].shown(), speeds["most"].shown()))


def test_corners_of_min_and_max() -> None:
    """min(x, -x) = -|x|: the corner at zero is its largest value."""
    data = slider_crank()
    assert value(data, max="min(B.x, -B.x)") == near(0.0, 1e-10)
    assert value(data, min="max(B.x, B.y)") == near(-R / math.sqrt(2))
    assert value(data, max="min(B.x, B.y)") == near(R / math.sqrt(2))


@pytest.mark.parametrize("start", ["0 deg", "30 deg", "-90 deg"])
def test_infinite_slopes_do_not_hide_an_extreme(start: str) -> None:
    """sqrt|sin| has vertical tangents where it is zero; its top is 1 all the same."""
    drive = {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": start}
    data = slider_crank(drives={"motor": drive})
    assert value(data, max="sqrt(abs(sin(motor.angle)))") == near(1.0)
    assert value(data, min="sqrt(abs(sin(motor.angle)))") == near(0.0, 1e-7)


# Arithmetic, units, wrap.


def test_arithmetic_of_signals() -> None:
    data = slider_crank()
    assert value(data, max="2*guide.s - 10 mm + r/2") == near(2 * TOP - 10 + R / 2)
    assert value(data, max="-guide.s") == near(-BOTTOM)
    assert value(data, max="hypot(B.x, B.y)^2") == near(R**2)
    assert value(data, max="sin(motor.angle)^3") == near(1.0)
    assert value(data, max="B.x/l") == near(R / L)
    assert value(data, span="atan2(B.y, B.x + 2*r)") == near(60.0)
    assert value(data, max="B.vx*B.vy") == near((R * 2 * math.pi) ** 2 / 2)
    assert value(data, max="B.x - t*(1 mm/s)") == near(R)


def test_units_follow_the_file_and_can_be_overridden() -> None:
    data = slider_crank()
    found = measured(
        data,
        plain={"max": "guide.s"},
        metres={"max": "guide.s", "unit": "m"},
        inches={"max": "guide.s", "unit": "in"},
        speed={"max": "motor.omega"},
        rpm={"max": "motor.omega", "unit": "rpm"},
        rad={"max": "motor.angle", "unit": "rad"},
        power={"max": "motor.power"},
        mw={"max": "motor.power", "unit": "mW"},
        ratio={"max": "B.x/l"},
        area={"max": "B.x^2"},
        energy={"max": "energy.kinetic"},
    )
    units = {name: m.unit for name, m in found.items()}
    assert units["plain"] == "mm"
    assert units["speed"] == "deg/s"
    assert (units["power"], units["area"], units["energy"]) == ("W", "mm^2", "J")
    assert units["ratio"] in ("", "1")
    assert found["metres"].shown() == near(TOP / 1000)
    assert found["inches"].shown() == near(TOP / 25.4)
    assert (found["rpm"].shown(), found["rpm"].unit) == (near(60.0), "rpm")
    assert found["speed"].shown() == near(360.0)
    assert found["rad"].shown() == near(2 * math.pi)
    assert found["mw"].shown() == near(1000 * found["power"].shown())


@pytest.mark.parametrize("unit", ["kg", "s", "N*m", "mm/s", "deg"])
def test_a_unit_of_another_quantity_is_refused(unit: str) -> None:
    """A length can't be shown in kilograms."""
    found = refused(slider_crank(measures={"m": {"max": "guide.s", "unit": unit}}))
    assert [f.element for f in found] == ["measures.m.unit"]


@pytest.mark.parametrize(("low", "high", "wanted"), [(0, 360, 343), (-180, 180, -17), (360, 720, 703), (-17, 343, -17)])
def test_wrap(low: float, high: float, wanted: float) -> None:
    drive = {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": "-377 deg"}
    data = slider_crank(drives={"motor": drive})
    found = value(data, value="motor.angle", where="start", wrap=[low, high])
    assert (found - wanted) % (high - low) == near(0.0, 1e-9) or (wanted - found) % (high - low) == near(0.0, 1e-9)
    assert low - 1e-9 <= found <= high + 1e-9


def test_wrap_of_a_link_that_turns_backwards() -> None:
    """The feeder's left limit angle: a clockwise crank, in 0..360."""
    drive = {"turns": "crank", "on": "frame", "speed": "-60 rpm", "start": "-30 deg"}
    data = slider_crank(drives={"motor": drive})
    assert value(data, value="crank.angle", where="min guide.s", wrap=[0, 360]) == near(BOTTOM_ANGLE, 1e-11)
    assert value(data, value="crank.angle", where="min guide.s") == near(BOTTOM_ANGLE - 360, 1e-11)


@pytest.mark.parametrize("wrap", [[0, 0], [360, 0], ["0 mm", "360 mm"], [0, "nowhere"]])
def test_a_wrap_that_makes_no_sense_is_refused(wrap: list[Any]) -> None:
    for finding in refused(slider_crank(measures={"m": {"max": "motor.angle", "wrap": wrap}})):
        assert finding.path[:2] == ("measures", "m")


# What has no value.


# Nowhere a number; one at t = 0 only; none at all; none; and for half the run infinite or none.
@pytest.mark.parametrize(
    "signal", ["B.x/0", "sqrt(B.x - r)", "log(B.x/r - 2)", "B.x/(B.x - B.x)", "(B.x/r)^(-0.5)", "sqrt(B.x + r/2)"]
)
def test_a_measure_without_a_finite_value_fails_the_run(signal: str) -> None:
    job = job_of(slider_crank(measures={"m": {"max": signal}}, require={"m": ">= 0"}))
    assert job.cycle is not None
    assert [f.code for f in job.cycle.failures] == ["measure.not-finite"]
    assert job.cycle.measures[0].found == ()
    assert job.cycle.measures[0].verdict is False
    assert job.exit_code == 1


@pytest.mark.parametrize(
    ("signal", "code"),
    [
        ("pole(slider, frame).x", "measure.not-finite"),
        ("abs(pole(rod, frame).y)", "measure.unbounded"),
        ("pole(rod, frame).u", "measure.unbounded"),
    ],
)
def test_an_instant_centre_at_infinity_is_no_figure(signal: str, code: str) -> None:
    """The slider's is there all the time; the rod's for two instants of a turn, where its turning reverses."""
    job = job_of(slider_crank(measures={"m": {"extremes": signal}}))
    assert [f.code for f in job.cycle.failures] == [code]


def test_an_instant_centre_that_goes_to_infinity_along_a_line_stays_on_it() -> None:
    """The rod's lies on the crank's line and above the slider: there x is that of C, also where y is unbounded."""
    data = slider_crank()
    assert value(data, label="max", extremes="pole(rod, frame).x") == near(value(data, max="C.x"), 1e-9)


def test_an_instant_centre_in_a_window_without_infinity() -> None:
    """It lies on the crank's line, above or below the slider: x is that of C."""
    windows = {"w": {"motor.angle": ["20 deg", "50 deg"]}}
    found = measured(slider_crank(windows=windows), m={"extremes": "pole(rod, frame).y", "window": "w"})["m"]
    wanted = [float(slider_x(math.radians(a))) * math.tan(math.radians(a)) for a in (20, 50)]
    assert [found.shown("min"), found.shown("max")] == [near(y) for y in wanted]


def test_a_step_of_no_width_in_a_measure_is_no_crash() -> None:
    assert job_of(slider_crank(measures={"m": {"max": "step5(t, 1 s, 0 mm, 1 s, 5 mm)"}})).exit_code in (1, 2)


@pytest.mark.parametrize(
    "measure",
    [
        {"max": "Q.x"},
        {"max": "B.x + B.vx"},
        {"max": "force(frame, rod).x"},
        {"max": "motor.force"},
        {"max": "B.x +"},
        {"max": "nothing(B.x)"},
        {"value": "B.x", "where": "max Q.x"},
        {"value": "B.x", "where": "max B.x +"},
        {"value": "B.x", "where": "max B.x + B.vx"},
        {"value": "B.x", "where": "middle"},
        {"max": "B.x", "window": "nowhere"},
        {"max": "B.x", "unit": "furlong"},
        {"max": "B.x", "min": "B.y"},
        {"max": "B.x", "where": "start"},
        {"value": "B.x"},
        {"largest": "B.x"},
        {},
        {"path": "Q"},
        {"path": "B.x"},
        {"path": "crank"},
        {"path": "B", "straightness": "B"},
        {"path": "B", "unit": "s"},
        {"straightness": "Q"},
        {"straightness": "B", "unit": "N"},
        {"dwell": "B.x"},
        {"within": "1 mm"},
        {"max": "B.x", "within": "1 mm"},
        {"dwell": "B.x", "within": "1 deg"},
        {"dwell": "B.x", "within": "0 mm"},
        {"dwell": "B.x", "within": "-1 mm"},
        {"dwell": "B.x", "within": "B.y"},
        {"dwell": "B.x", "within": "1 mm", "unit": "mm"},
        {"max": "pole(rod).x"},
        {"max": "pole(rod, rod).x"},
        {"max": "pole(rod, B).x"},
        {"max": "pole(rod, frame).vx"},
    ],
    ids=str,
)
def test_a_measure_that_can_not_be_read_is_refused_by_name(measure: dict[str, Any]) -> None:
    for finding in refused(slider_crank(measures={"m": measure})):
        assert finding.path[:2] == ("measures", "m")


def test_a_table_in_a_measure_is_a_function_or_refused() -> None:
    tables = {"lift": {"points": [["0 deg", "0 mm"], ["120 deg", "6 mm"], ["240 deg", "3 mm"], ["360 deg", "0 mm"]]}}
    job = job_of(slider_crank(tables=tables, measures={"m": {"max": "lift(motor.angle)"}}))
    assert job.exit_code == 2 or not job.cycle.failures
