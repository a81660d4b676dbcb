"""Instant centres: closed forms, and what holds for the links of any mechanism."""

from __future__ import annotations

from itertools import combinations, permutations
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from helpers.compiled import compiled_from, compiled_of, regular
from helpers.differences import misfit
from helpers.random_mechanisms import DURATION, RECIPES, mechanisms
from linkwright.results import Result
from linkwright.results.run import Run
from studies.models import UNITS, refused, slider_crank, trammel

T = np.linspace(0.0, DURATION, 4)
NEAR = 50.0
"""How far away (m, of links of a metre or so) an instant centre still has digits enough to be judged."""


def poles(run: Run, a: str, b: str, t: Any = T) -> Any:
    """x, y, u, v of pole(a, b) and their rates: (4, times) each."""
    return run.rates([f"pole({a}, {b}).{axis}" for axis in "xyuv"], t)


def every_pole(run: Run, links: Any) -> dict[tuple[str, str], Any]:
    """The same for every two links, both ways round."""
    pairs = list(permutations(links, 2))
    found = run.rates([f"pole({a}, {b}).{axis}" for a, b in pairs for axis in "xyuv"], T)
    return dict(zip(pairs, np.array(found).reshape(2, len(pairs), 4, T.size).swapaxes(0, 1), strict=True))


# Any mechanism.


@pytest.mark.parametrize("recipe", RECIPES)
@settings(max_examples=5)
@given(data=st.data())
def test_both_links_have_one_velocity_there(recipe: str, data: Any) -> None:
    """From any pinned point Q of a link, its velocity at the pole is v_Q + omega x (P - Q)."""
    plain = data.draw(mechanisms(recipe))
    compiled = compiled_of(plain)
    regular(compiled, T)
    run = Run(compiled, 0.0, DURATION, 50)
    found = every_pole(run, plain.links)
    for a, b in combinations(plain.links, 2):
        pole = found[a, b][0]
        near = np.hypot(*pole[:2]) < NEAR
        pole[:, ~near] = 0.0
        speeds = []
        for link in (a, b):
            point = next(iter(plain.links[link].points))
            x, y, vx, vy = run.evaluate([f"{point}.{row}" for row in ("x", "y", "vx", "vy")], T)
            omega = run.evaluate([f"{link}.omega"], T)[0]
            speeds.append(vx + 1j * vy + 1j * omega * (pole[0] - x + 1j * (pole[1] - y)))
        size = np.maximum(1.0, np.abs(speeds[0]))
        assert (np.abs(speeds[0] - speeds[1]) / size)[near].max(initial=0.0) < 1e-10, (a, b)


@pytest.mark.parametrize("recipe", ["four_bar", "six_bar", "five_bar", "elliptic_trammel"])
@settings(max_examples=8)
@given(data=st.data())
def test_three_poles_lie_on_a_line(recipe: str, data: Any) -> None:
    """Kennedy's theorem, for any three links."""
    plain = data.draw(mechanisms(recipe))
    compiled = compiled_of(plain)
    regular(compiled, T)
    run = Run(compiled, 0.0, DURATION, 50)
    found = every_pole(run, plain.links)
    for a, b, c in combinations(plain.links, 3):
        places = np.array([found[pair][0][:2] for pair in ((a, b), (b, c), (a, c))])
        near = np.abs(places).max(axis=(0, 1)) < NEAR
        (p, q, r) = places[:, :, near]
        area = (q - p)[0] * (r - p)[1] - (q - p)[1] * (r - p)[0]
        assert np.abs(area).max(initial=0.0) < 1e-8 * NEAR, (a, b, c)


def infinite_where_unknown(values: Any) -> Any:
    """Infinity in the place of NaN."""
    return np.where(np.isnan(values), np.inf, values)


@pytest.mark.parametrize("recipe", ["four_bar", "slider_crank", "inverted_slider_crank", "six_bar", "driven_in_series"])
@settings(max_examples=8)
@given(data=st.data())
@np.errstate(invalid="ignore")  # of poles at infinity
def test_centrodes_roll_on_each_other(recipe: str, data: Any) -> None:
    """The pole moves along both centrodes at one velocity: turned into one frame the rates of u, v agree.

    The rates are those of the rows, too: against differences.
    """
    plain = data.draw(mechanisms(recipe))
    compiled = compiled_of(plain)
    regular(compiled, T, 0.2)
    run = Run(compiled, -0.1, DURATION + 0.1, 50)
    found = every_pole(run, plain.links)
    for a, b in combinations(plain.links, 2):
        (pole, rate), (back, back_rate) = (infinite_where_unknown(found[pair]) for pair in ((a, b), (b, a)))
        angles = run.evaluate([f"{a}.angle", f"{b}.angle"], T)
        turned = zip((rate, back_rate), angles, strict=True)
        along = [(rates[2] + 1j * rates[3]) * np.exp(1j * angle) for rates, angle in turned]
        near = (np.hypot(*pole[:2]) < NEAR) & (np.hypot(*rate[:2]) < NEAR)
        if not near.any():
            continue
        size = np.maximum(1.0, np.abs(along[0]))
        assert (np.abs(along[0] - along[1]) / size)[near].max() < 1e-8, (a, b)
        assert np.abs(pole[:2] - back[:2])[:, near].max() < 1e-9 * NEAR
    a, b = list(plain.links)[-2:]
    names = [f"pole({a}, {b}).{axis}" for axis in "xyuv"]
    pole, rate = infinite_where_unknown(found[a, b])
    error = misfit(lambda t: run.evaluate(names, t), rate, T)
    close = (np.hypot(*pole[:2]) < 5) & (np.abs(rate).max(axis=0) < 5)
    assert error[:, close].max(initial=0.0) < 1e-5


# Closed forms.


def test_the_circles_of_cardan() -> None:
    """A bar of length l between two rails rolls a circle of radius l/2 inside one of radius l."""
    run = Run(compiled_from(trammel()), 0.0, 1.0, 60)
    t = np.linspace(0.0, 1.0, 37)
    x, y, u, v = poles(run, "bar", "frame", t)[0]
    assert np.hypot(x, y) == pytest.approx(0.1, abs=1e-14)
    assert np.hypot(u - 0.05, v) == pytest.approx(0.05, abs=1e-14)
    a, b = run.evaluate(["A.x", "B.y"], t)
    assert np.array([x, y]) == pytest.approx(np.array([a, b]), abs=1e-14)


def test_the_ellipses_of_the_antiparallelogram() -> None:
    """Cranks of 100 that cross, on a ground of 60 mm: ellipses about the pivots, the same about the coupler's pins."""
    data = {
        "units": UNITS,
        "links": {
            "frame": {"points": {"A": [0, 0], "D": [60, 0]}},
            "left": {"points": {"A": [0, 0], "B": [100, 0]}},
            "bar": {"points": {"B": [0, 0], "C": [60, 0]}},
            "right": {"points": {"D": [0, 0], "C": [100, 0]}},
        },
        "assembly": {"C": "crossed"},
        "drives": {"motor": {"turns": "left", "on": "frame", "speed": "60 rpm", "start": "40 deg"}},
    }
    run = Run(compiled_from(data), 0.0, 0.25, 60)
    x, y, u, v = poles(run, "bar", "frame", np.linspace(0.0, 0.25, 23))[0]
    assert np.hypot(x, y) + np.hypot(x - 0.06, y) == pytest.approx(0.1, abs=1e-14)
    assert np.hypot(u, v) + np.hypot(u - 0.06, v) == pytest.approx(0.1, abs=1e-14)
    assert np.ptp(x) > 0.05


def test_pins_are_poles() -> None:
    """At 90 and 270 deg the rod doesn't turn: there any point would do as the slider's on it, and none is given."""
    run = Run(compiled_from(slider_crank()), 0.0, 1.0, 60)
    assert not np.isfinite(poles(run, "slider", "rod", np.array([0.25, 0.75]))[0]).any()
    t = np.linspace(0.01, 1.01, 13)
    for pair, point in ((("crank", "frame"), "A"), (("rod", "crank"), "B"), (("slider", "rod"), "C")):
        pole, place = poles(run, *pair, t)[0], run.evaluate([f"{point}.x", f"{point}.y"], t)
        assert pole[:2] == pytest.approx(place, abs=1e-13)


# At infinity, at rest, and what isn't one.


def parallelogram(start: float) -> dict[str, Any]:
    return {
        "units": UNITS,
        "links": {
            "frame": {"points": {"A": [0, 0], "D": [100.1, 0]}},
            "left": {"points": {"A": [0, 0], "B": [33.3, 0]}},
            "bar": {"points": {"B": [0, 0], "C": [100.1, 0]}},
            "right": {"points": {"D": [0, 0], "C": [33.3, 0]}},
        },
        "assembly": {"C": "open"},
        "drives": {"motor": {"turns": "left", "on": "frame", "speed": "60 rpm", "start": f"{start} deg"}},
        "studies": {"cycle": {"duration": "0.3 s", "samples": 30}},
    }


def test_links_that_only_shift_have_none() -> None:
    """The parallelogram's bar turns by round-off alone; a slider by nothing."""
    run = Run(compiled_from(parallelogram(20)), 0.0, 0.3, 60)
    t = np.linspace(0.0, 0.3, 61)
    assert not np.isfinite(poles(run, "bar", "frame", t)[0]).any()
    assert not np.isfinite(poles(run, "left", "right", t)[0]).any()
    assert np.isfinite(poles(run, "left", "bar", t)).all()
    slider = Run(compiled_from(slider_crank()), 0.0, 1.0, 60)
    assert not np.isfinite(poles(slider, "slider", "frame", t)[0]).any()
    assert not np.isfinite(poles(slider, "frame", "slider", t)[0]).any()


def test_rest_has_none_and_a_table_is_blank_there() -> None:
    drive = {"turns": "crank", "on": "frame", "position": "step5(t, 0.35 s, 20 deg, 0.65 s, 80 deg)"}
    run = Run(compiled_from(slider_crank(drives={"motor": drive})), 0.0, 1.0, 10)
    result = Result(run)
    assert "pole(rod, frame).x" not in result.names
    head, *rows = result.to_csv(more=["pole(rod, frame).x"]).splitlines()
    assert head.endswith(',"pole(rod, frame).x [mm]"')
    filled = [bool(row.rpartition(",")[2]) for row in rows]
    assert filled == [k in (4, 5, 6) for k in range(11)]
    assert np.isfinite(result["pole(rod, frame).x"]).tolist() == filled
    assert set(result.element("pole(rod, frame)")) == {"x", "y", "u", "v"}


@pytest.mark.parametrize(
    ("signal", "code"),
    [
        ("pole(rod, rod).x", "signal.same-link"),
        ("pole(rod, B).x", "name.unknown"),
        ("pole(rd, frame).x", "name.unknown"),
        ("pole(rod).x", "signal.unknown"),
        ("pole(rod, frame, crank).x", "signal.unknown"),
        ("pole(rod, frame).vx", "signal.no-attribute"),
    ],
)
def test_what_is_no_pole_is_refused(signal: str, code: str) -> None:
    found = refused(slider_crank(measures={"m": {"max": signal}}))
    assert [(f.code, f.path) for f in found] == [(code, ("measures", "m", "max"))]
