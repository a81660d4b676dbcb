"""Results by name: signals and expressions, in SI and as shown, by element, as an xarray dataset."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import linkwright as lw
from app.models import SOUND, STUCK


def result_of(folder: Path, text: str) -> lw.Result:
    path = folder / "model.yaml"
    path.write_text(text, "utf-8")
    cycle = lw.run(path).cycle
    assert cycle is not None
    return cycle.result


@pytest.fixture(scope="module")
def result(tmp_path_factory: pytest.TempPathFactory) -> lw.Result:
    return result_of(tmp_path_factory.mktemp("model"), SOUND)


def test_signals_are_in_si(result: lw.Result) -> None:
    assert result["crank.omega"] == pytest.approx(np.full(25, 4 * np.pi))
    assert result["crank.angle"] == pytest.approx(np.radians(40) + 4 * np.pi * result.t)
    assert np.hypot(result["A.x"], result["A.y"]) == pytest.approx(np.full(25, 0.04))
    assert result["A.vx"] == pytest.approx(-4 * np.pi * result["A.y"])
    assert all(result[name].shape == (25,) for name in result.names)
    assert result.t == pytest.approx(np.linspace(0, 0.5, 25))


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("2*A.x - 10 mm", lambda r: 2 * r["A.x"] - 0.01),
        ("hypot(P.vx, P.vy)", lambda r: np.hypot(r["P.vx"], r["P.vy"])),
        ("abs(rocker.omega)", lambda r: np.abs(r["rocker.omega"])),
        ("-motor.torque", lambda r: -r["motor.torque"]),
        ("motor.torque*motor.omega", lambda r: r["motor.power"]),
        ("force(frame, crank).x", lambda r: -r["force(crank, frame).x"]),
        ("force( frame,crank ).x", lambda r: r["force(frame, crank).x"]),
        ("sin(crank.angle)*a", lambda r: r["A.y"]),
        ("atan2(A.y, A.x)", lambda r: np.arctan2(r["A.y"], r["A.x"])),
        ("t*(1 mm/s)", lambda r: r.t * 1e-3),
        ("a + b", lambda r: np.full(25, 0.16)),
        ("t", lambda r: r.t),
        ("1", lambda r: np.ones(25)),
        ("P.x^2", lambda r: r["P.x"] ** 2),
    ],
)
def test_expressions(result: lw.Result, text: str, wanted: Any) -> None:
    assert result[text] == pytest.approx(wanted(result), rel=1e-12, abs=1e-15)


def test_the_force_of_either_link_on_the_other(result: lw.Result) -> None:
    for axis in "xy":
        pair = result[f"force(coupler, rocker).{axis}"], result[f"force(rocker, coupler).{axis}"]
        assert pair[0] == pytest.approx(-pair[1])
        assert pair[0] == pytest.approx(result[f"force(coupler, B).{axis}"])


@pytest.mark.parametrize(
    ("text", "unit", "size"),
    [
        ("P.x", "mm", 1e-3), ("P.vx", "mm/s", 1e-3), ("rocker.angle", "deg", np.pi / 180),
        ("rocker.alpha", "deg/s^2", np.pi / 180), ("motor.torque", "N*m", 1.0), ("motor.power", "W", 1.0),
        ("2*P.x", "mm", 1e-3), ("P.x*P.y", "mm^2", 1e-6), ("t", "s", 1.0), ("energy.kinetic", "J", 1.0),
    ],
)  # fmt: skip
def test_shown_in_the_models_units(result: lw.Result, text: str, unit: str, size: float) -> None:
    values, shown = result.shown(text)
    assert shown == unit
    assert values * size == pytest.approx(result[text], rel=1e-14)


def test_by_element(result: lw.Result) -> None:
    point = result.element("P")
    assert set(point) == {"x", "y", "vx", "vy", "ax", "ay", "jx", "jy"}
    assert point["vx"] is result["P.vx"]
    assert set(result.element("rocker")) == {"angle", "omega", "alpha", "jerk"}
    assert {"torque", "power", "angle"} <= set(result.element("motor"))
    assert {"x", "y"} == set(result.element("force(frame, crank)"))
    assert set(result.element("com(coupler)")) == set(point)
    assert {"x", "y", "moment"} == set(result.element("shaking"))
    for name in ("nobody", "", "P.x", "force(crank)"):
        with pytest.raises((KeyError, lw.ModelError)):
            result.element(name)


def test_every_signal_is_of_some_element(result: lw.Result) -> None:
    elements = {name.rpartition(".")[0] for name in result.names}
    known = [f"{element}.{attribute}" for element in elements for attribute in result.element(element)]
    assert len(known) == len({*known})
    # The sums over the mechanism are only given by name.
    assert {*known} - {*result.names} == {f"energy.{total}" for total in ("stored", "supplied", "dissipated")}
    assert {*known} > {*result.names}
    assert len(set(result.names)) == len(result.names)


@pytest.mark.parametrize(
    "text", ["nobody.x", "P.z", "P", "P.x + P.vx", "force(frame, rockr).x", "P.x +", "", "foo(P.x)"]
)
def test_an_unknown_name_says_what_is_wrong(result: lw.Result, text: str) -> None:
    """Raised as an error that a caller can catch, with words in it, not with a bare key."""
    with pytest.raises((KeyError, ValueError, lw.ModelError)) as caught:
        result[text]
    assert " " in str(caught.value)


def test_continuous_angles(result: lw.Result) -> None:
    for link in ("crank", "coupler", "rocker"):
        assert np.abs(np.diff(result[f"{link}.angle"])).max() < 1.0
    assert result["crank.angle"][-1] - result["crank.angle"][0] == pytest.approx(2 * np.pi)


def test_rates_of_a_result_are_rates(result: lw.Result) -> None:
    """A trigonometric sum through the samples of a whole turn, differentiated."""
    n = 24
    for low, high in (("P.x", "P.vx"), ("P.vy", "P.ay"), ("rocker.omega", "rocker.alpha"), ("P.ax", "P.jx")):
        spectrum = np.fft.rfft(result[low][:-1])
        spectrum *= 1j * np.arange(n // 2 + 1) * 2 * np.pi / 0.5
        spectrum[-1] = 0
        rate = np.fft.irfft(spectrum, n)
        assert rate == pytest.approx(result[high][:-1], abs=2e-2 * np.abs(result[high]).max())


def test_to_xarray(result: lw.Result) -> None:
    xarray = pytest.importorskip("xarray")
    data = result.to_xarray()
    assert isinstance(data, xarray.Dataset)
    assert dict(data.sizes) == {"time": 25}
    assert data["time"].attrs["units"] == "s"
    assert data["time"].values == pytest.approx(result.t)
    assert set(data.data_vars) == set(result.names)
    for name in result.names:
        assert data[name].dims == ("time",)
        assert np.array_equal(data[name].values, result[name], equal_nan=True)
    units = {name: data[name].attrs["units"] for name in result.names}
    assert units["P.x"] == "m"
    assert units["P.ay"] == "m/s^2"
    assert units["rocker.omega"] == "rad/s"
    assert units["motor.torque"] == "N*m"
    assert units["motor.power"] == "W"
    assert units["force(frame, crank).x"] == "N"
    assert units["energy.kinetic"] == "J"
    assert data.attrs["title"] == "Four-bar"


def test_a_dataset_of_a_run_that_stops_keeps_its_holes(tmp_path: Path) -> None:
    pytest.importorskip("xarray")
    result = result_of(tmp_path, STUCK)
    data = result.to_xarray()
    assert np.isnan(data["B.x"]).any()
    assert np.isfinite(data["A.x"]).all()
    assert result.failures
    assert result.certificate is None


def test_a_slide_without_a_force_has_no_line_of_action(tmp_path: Path) -> None:
    """Nothing has mass and nothing loads: all forces are zero, where they act is unknown; and nothing is raised."""
    text = """\
linkwright: 1
units: {length: mm, angle: deg, time: s}
links:
  frame:  {points: {A: [0, 0], F: [0, 20]}}
  crank:  {points: {A: [0, 0], B: [50, 0]}}
  rod:    {points: {B: [0, 0], C: [160, 0]}}
  slider: {points: {C: [0, 0]}}
joints:
  guide: {prismatic: [frame, slider], line: [F at 0 deg, C at 0 deg]}
assembly: {C: ahead of B along guide}
drives:
  motor: {turns: crank, on: frame, speed: 60 rpm, start: 0 deg}
studies:
  cycle: {turns: 1 motor, samples: 12}
"""
    result = result_of(tmp_path, text)
    assert np.isnan(result["force(frame, slider).arm"]).all()
    assert result["force(frame, slider).normal"] == pytest.approx(np.zeros(13))
    assert result["motor.torque"] == pytest.approx(np.zeros(13))


def test_a_link_alone_on_a_rail(tmp_path: Path) -> None:
    """The smallest machine: one driven slide, no group at all."""
    text = """\
linkwright: 1
units: {length: mm, angle: deg, time: s}
links:
  frame: {points: {R: [0, 0]}}
  block: {points: {Q: [0, 0]}}
joints:
  rail: {prismatic: [frame, block], line: [R at 90 deg, Q at 90 deg]}
drives:
  motor: {slides: block, on: frame, speed: 10 mm/s, start: 5 mm}
studies:
  cycle: {duration: 1 s, samples: 4}
"""
    result = result_of(tmp_path, text)
    assert result.shown("Q.y")[0] == pytest.approx([5, 7.5, 10, 12.5, 15])
    assert result["motor.force"] == pytest.approx(np.zeros(5))
    assert np.isnan(result["force(frame, block).arm"]).all()
