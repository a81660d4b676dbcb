"""Windows in time and in the value of a signal, over several turns too."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import linkwright as lw
from linkwright.results.windows import intervals
from studies.models import cycle_of, job_of, refused, slider_crank, value

R = 50.0


def spans(data: dict[str, Any], window: Any) -> list[tuple[float, float]]:
    """The intervals (s) that a window means."""
    run = cycle_of({**data, "windows": {"w": window}}).result.run
    return [(float(a), float(b)) for a, b in intervals(run, run.compiled.quantities.window("w"))]


def turning(turns: float = 1, speed: str = "60 rpm", start: str = "0 deg", samples: int = 60) -> dict[str, Any]:
    drive = {"turns": "crank", "on": "frame", "speed": speed, "start": start}
    return slider_crank(drives={"motor": drive}, studies={"cycle": {"turns": f"{turns} motor", "samples": samples}})


def close(found: list[tuple[float, float]], wanted: list[tuple[float, float]]) -> None:
    assert len(found) == len(wanted), (found, wanted)
    assert np.allclose(found, wanted, rtol=0, atol=1e-12), (found, wanted)


@pytest.mark.parametrize(
    ("window", "wanted"),
    [
        (["0.2 s", "0.7 s"], [(0.2, 0.7)]),
        ([0.2, 0.7], [(0.2, 0.7)]),
        (["200 ms", "1 s/2"], [(0.2, 0.5)]),
        (["-1 s", "0.5 s"], [(0.0, 0.5)]),
        (["0.5 s", "9 s"], [(0.5, 1.0)]),
        (["0 s", "1 s"], [(0.0, 1.0)]),
        (["1 s", "2 s"], []),
        (["-2 s", "0 s"], []),
    ],
)
def test_in_time(window: list[Any], wanted: list[tuple[float, float]]) -> None:
    close(spans(turning(), window), wanted)


@pytest.mark.parametrize(
    ("window", "wanted"),
    [
        (["90 deg", "180 deg"], [(0.25, 0.5)]),
        ([90, 180], [(0.25, 0.5)]),
        (["0 deg", "180 deg"], [(0.0, 0.5)]),
        (["180 deg", "360 deg"], [(0.5, 1.0)]),
        (["-90 deg", "90 deg"], [(0.0, 0.25), (0.75, 1.0)]),
        (["270 deg", "450 deg"], [(0.0, 0.25), (0.75, 1.0)]),
        (["810 deg", "900 deg"], [(0.25, 0.5)]),
        (["-270 deg", "-180 deg"], [(0.25, 0.5)]),
        (["0 deg", "360 deg"], [(0.0, 1.0)]),
        (["10 deg", "400 deg"], [(0.0, 1.0)]),
    ],
)
def test_in_the_angle_of_a_drive(window: list[Any], wanted: list[tuple[float, float]]) -> None:
    close(spans(turning(), {"motor.angle": window}), wanted)


def test_in_an_angle_over_several_turns() -> None:
    """Every turn has its part; a window over the seam is one interval in the middle and two at the ends."""
    close(spans(turning(3), {"motor.angle": ["90 deg", "180 deg"]}), [(k + 0.25, k + 0.5) for k in range(3)])
    seam = [(0.0, 0.1), (0.9, 1.1), (1.9, 2.1), (2.9, 3.0)]
    close(spans(turning(3), {"motor.angle": ["-36 deg", "36 deg"]}), seam)
    close(spans(turning(2, "-60 rpm"), {"motor.angle": ["90 deg", "180 deg"]}), [(0.5, 0.75), (1.5, 1.75)])
    close(
        spans(turning(2, start="45 deg"), {"motor.angle": ["0 deg", "90 deg"]}),
        [(0, 0.125), (0.875, 1.125), (1.875, 2)],
    )
    close(spans(turning(1.5), {"crank.angle": ["170 deg", "190 deg"]}), [(170 / 360, 190 / 360), (530 / 360, 1.5)])


@pytest.mark.parametrize("samples", [2, 8, 500])
def test_do_not_depend_on_samples(samples: int) -> None:
    close(
        spans(turning(20, samples=samples), {"motor.angle": ["90 deg", "91 deg"]}),
        [(k + 90 / 360, k + 91 / 360) for k in range(20)],
    )


def test_in_the_value_of_any_signal() -> None:
    """B.x = 50 mm cos(a) lies in 0..25 mm from 60 to 90 and from 270 to 300 deg."""
    close(spans(turning(), {"B.x": ["0 mm", "25 mm"]}), [(60 / 360, 90 / 360), (270 / 360, 300 / 360)])
    close(
        spans(turning(), {"B.x": ["30 mm", "80 mm"]}),
        [(0.0, math.acos(0.6) / 2 / math.pi), (1 - math.acos(0.6) / 2 / math.pi, 1.0)],
    )
    close(spans(turning(), {"B.x": ["60 mm", "80 mm"]}), [])
    close(spans(turning(), {"B.x": ["-60 mm", "60 mm"]}), [(0.0, 1.0)])
    close(spans(turning(), {"motor.omega": ["0 rpm", "61 rpm"]}), [(0.0, 1.0)])


@settings(max_examples=25)
@given(st.integers(-720, 720), st.integers(1, 350), st.floats(-500, 500), st.sampled_from([-1, 1]), st.integers(1, 4))
def test_the_length_of_a_window_of_an_angle(low: int, width: int, start: float, sign: int, turns: int) -> None:
    """Over whole turns a window always takes its share of the time, wherever it begins."""
    found = spans(
        turning(turns, f"{sign * 60} rpm", f"{start} deg"), {"motor.angle": [f"{low} deg", f"{low + width} deg"]}
    )
    assert sum(b - a for a, b in found) == pytest.approx(turns * width / 360, abs=1e-11)


@settings(max_examples=10)
@given(st.floats(-170, 170), st.floats(1, 300))
def test_mean_over_a_window_of_an_angle(low: float, width: float) -> None:
    a, b = math.radians(low), math.radians(low + width)
    data = {**turning(2), "windows": {"w": {"motor.angle": [f"{low} deg", f"{low + width} deg"]}}}
    assert value(data, mean="B.x", window="w") == pytest.approx(R * (math.sin(b) - math.sin(a)) / (b - a), abs=1e-10)
    crosses = (low < 0 < low + width) or (low < 360 < low + width)
    assert value(data, max="B.x", window="w") == pytest.approx(
        R if crosses else max(R * math.cos(a), R * math.cos(b)), abs=1e-10
    )


def test_extremes_at_both_sides_of_a_seam() -> None:
    data = {**turning(2), "windows": {"w": {"motor.angle": ["-30 deg", "60 deg"]}}}
    assert value(data, max="B.y", window="w") == pytest.approx(R * math.sin(math.pi / 3), rel=1e-12)
    assert value(data, min="B.y", window="w") == pytest.approx(-R / 2, rel=1e-12)
    assert value(data, value="motor.angle", where="start", window="w") == pytest.approx(0.0, abs=1e-12)
    assert value(data, value="motor.angle", where="end", window="w") == pytest.approx(720.0)


def test_many_turns_cost_in_proportion(monkeypatch: pytest.MonkeyPatch) -> None:
    """Twice the turns, about twice the poses computed."""
    poses = {100: 0, 200: 0}
    real = lw.Compiled.possible_rows
    for turns in poses:

        def counted(self: Any, names: Any, t: Any, *more: Any, turns: int = turns, **options: Any) -> Any:
            poses[turns] += t.size
            return real(self, names, t, *more, **options)

        monkeypatch.setattr(lw.Compiled, "possible_rows", counted)
        value({**turning(turns), "windows": {"w": {"motor.angle": [90, 91]}}}, mean="B.x", window="w")
    assert poses[200] < 2.5 * poses[100]


def test_a_window_that_the_run_never_enters_is_a_failure() -> None:
    for window in (["2 s", "3 s"], {"B.x": ["60 mm", "80 mm"]}):
        job = job_of({**turning(), "windows": {"w": window}, "measures": {"m": {"max": "B.x", "window": "w"}}})
        assert job.cycle is not None
        assert [f.code for f in job.cycle.failures] == ["measure.nothing"]
        assert job.cycle.failures[0].path == ("measures", "m")
        assert job.exit_code == 1


@pytest.mark.parametrize(
    "window",
    [
        ["0.5 s", "0.2 s"],
        ["0.5 s", "0.5 s"],
        ["0 mm", "1 mm"],
        ["t", "2 s"],
        ["foo", "2 s"],
        {"motor.angle": ["90 deg", "0 deg"]},
        {"motor.angle": ["0 mm", "1 mm"]},
        {"nobody.angle": ["0 deg", "1 deg"]},
        {"motor.angle +": ["0 deg", "1 deg"]},
        {"B.x + B.vx": ["0 mm", "1 mm"]},
        {"motor.angle": ["0 deg", "1 deg"], "B.x": ["0 mm", "1 mm"]},
    ],
    ids=str,
)
def test_a_window_that_makes_no_sense_is_refused(window: Any) -> None:
    measures = {"m": {"max": "B.x", "window": "w"}}
    for finding in refused({**turning(), "windows": {"w": window}, "measures": measures}):
        assert finding.path[:2] == ("windows", "w")
