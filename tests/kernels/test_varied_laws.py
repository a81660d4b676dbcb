"""Motion laws whose numbers vary: values against models that are read anew, derivatives against differences."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest

from helpers.cams import pair
from helpers.compiled import compiled_from
from helpers.differences import OFFSETS, WEIGHTS
from linkwright.cam.cams_of_mechanism import disc
from linkwright.cam.followers import NoFollower
from linkwright.findings import ModelError
from linkwright.kernels import Compiled
from linkwright.kernels.manufactured_cam import with_cut_cams
from linkwright.kernels.parameter_batch import Varied
from linkwright.kernels.tangents import Tangents
from linkwright.laws import LAWS, MotionError

H, W = {"h": "20 deg"}, {"h": "20 deg", "w": "100 deg"}
BACK = {"rise": "-h", "over": "360-w", "match": "acceleration"}


def both_ways(name: str) -> tuple[list[Any], dict[str, Any]]:
    """A rise and its mirror image by a registered law."""
    rise, fall = ({key: "h", "over": "w", "law": name} for key in ("rise", "fall"))
    if LAWS[name].mirrored:
        return [rise, fall, {"dwell": "360-2*w"}], W
    if min(LAWS[name].continuity) > 0:
        return [rise, {"dwell": "90-w/2"}, {"fall": "h", "over": "100+v", "law": name}, {"dwell": "170-w/2-v"}], {
            **W,
            "v": "10 deg",
        }
    blend = {"rise": "(k-h)/2", "over": "130-w/2", "match": "acceleration"}
    return [rise, blend, {"rise": "-k", "over": 100, "law": name}, blend], {**W, "k": "30 deg"}


RATES = {"v": "0.02 deg/deg", "a": "0.001 deg/deg^2", "k": "4 deg"}
VIA = [["w/3", "k"], ["w/2", "h-2"], ["w*0.7", "h"]]
ZONES = ["b", "0.1", "0.2-b", 0.2, 0.2, "0.1+b", "0.2-b"]
KINDS: dict[str, tuple[list[Any], Mapping[str, Any], dict[str, Any]]] = {
    **{name: (*both_ways(name), {}) for name in LAWS},
    "skew": (
        [{"rise": "h", "over": 90, "law": "mcv50", "skew": "s"}, {"fall": "h", "over": 270, "law": "cycloidal"}],
        {**H, "s": 0.4},
        {},
    ),
    "fractions": (
        [
            {"rise": "h", "over": 90, "fractions": ["b", "c", "1-b-c-z", "z"]},
            {"fall": "h", "over": 270, "fractions": ["b", "c", "1-b-c", 0], "skew": "s"},
        ],
        {**H, "b": 0.2, "c": 0.3, "z": 0.1, "s": 0.4},
        {},
    ),
    "zones": (
        [{"rise": "h", "over": "w", "fractions": ZONES}, {"fall": "h", "over": "360-w", "fractions": ZONES}],
        {**W, "b": 0.1},
        {},
    ),
    "powers": (
        [{"rise": "h", "over": "w", "powers": [3, 4, 6]}, {"fall": "h", "over": "360-w", "powers": [3, 4, 5]}],
        W,
        {},
    ),
    "formula": (
        [
            {"rise": "h", "over": "w", "formula": "a*u^3*(10-15*u+6*u^2) + (1-a)*(u-sin(360 deg*u)/(2*pi))"},
            {"fall": "h", "over": "360-w", "formula": "u^n*(1+n-n*u)"},
        ],
        {**W, "a": 0.4, "n": 5.5},
        {},
    ),
    "polynomial": ([{"rise": "h", "over": "w", "from": ["v", "a"], "to": ["-v", 0], "via": VIA[:2]}, BACK],
                   {**W, **RATES}, {}),
    "cubic": ([{"rise": "h", "over": "w", "from": ["v"], "to": ["-v"], "via": VIA, "spline": "cubic"}, BACK],
              {**W, "v": RATES["v"], "k": RATES["k"]}, {}),
    "quintic": ([{"rise": "h", "over": "w", "from": ["v", "a"], "to": [0, "a"], "via": VIA, "spline": "quintic"}, BACK],
                {**W, **RATES}, {}),
    "control": ([{"control": [0, 0, 0, "k", "h", "h", "k", 0, 0, 0], "over": "w"}, {"dwell": "360-w"}],
                {**W, "k": "4 deg"}, {}),
    "harmonics": (
        [{"harmonics": [["a", "b"], [2, "c"]], "over": "w"}, {"rise": 0, "over": "360-w", "match": "velocity"}],
        {"a": "1 deg", "w": "100 deg", "b": "4 deg", "c": "0 deg"},
        {},
    ),
    "advance": (
        [{"rise": "h", "over": "w", "law": "cycloidal"}, {"dwell": "d"}],
        {"h": "20 deg", "w": "70 deg", "d": "20 deg"},
        {"period": "w+d", "beyond": "advance", "start": "h/3"},
    ),
    "hold": (
        [{"rise": "h", "over": "w", "law": "cycloidal"}, {"dwell": "d"}, {"rise": "h", "over": "w", "law": "poly_345"}],
        {"h": "20 deg", "w": "70 deg", "d": "20 deg"},
        {"beyond": "hold", "start": "h/3"},
    ),
}  # fmt: skip
SIGNALS = ["motor.angle", "motor.omega", "motor.alpha", "motor.jerk"]
T = np.linspace(0.0513, 8.93, 50)


def turning(segments: list[Any], parameters: Mapping[str, Any], law: dict[str, Any]) -> Compiled:
    return compiled_from(
        {
            "units": {"length": "mm", "angle": "deg", "time": "s"},
            "links": {"frame": {"points": {"O": [0, 0]}}, "arm": {"points": {"O": [0, 0]}}},
            "parameters": dict(parameters),
            "laws": {"shape": {"over": "angle", "of": "angle", "segments": segments, **law}},
            "drives": {"motor": {"turns": "arm", "on": "frame", "position": "shape(40 deg*t/(1 s) + 10 deg)"}},
        }
    )


@pytest.mark.parametrize("kind", KINDS)
def test_samples_are_models_read_anew(kind: str) -> None:
    segments, parameters, law = KINDS[kind]
    base = turning(segments, parameters, law)
    names = [*parameters]
    nominal = np.array([base.quantities.parameters[name] for name in names])
    some = np.random.default_rng(3).uniform(-1, 1, (nominal.size, 3))
    values = nominal[:, None] + 0.03 * np.where(nominal == 0, 1.0, nominal)[:, None] * some
    varied = Varied(base, names)
    found = varied.evaluate(SIGNALS, varied.parameters(values), T)
    assert np.isfinite(found).all()
    for i, column in enumerate(values.T):
        given = {name: f"{float(v)!r}{_unit(parameters[name])}" for name, v in zip(names, column, strict=True)}
        wanted = turning(segments, given, law).evaluate(SIGNALS, T)
        assert np.abs(found[:, i] - wanted).max(axis=1) == pytest.approx(0, abs=1e-12 * (1 + np.abs(wanted).max()))


def _unit(text: Any) -> str:
    unit = str(text).partition(" ")[2]
    return {"": "", "deg": " rad", "deg/deg": "", "deg/deg^2": "/(1 rad)"}[unit]


@pytest.mark.parametrize("kind", KINDS)
def test_derivatives_are_those_of_samples(kind: str) -> None:
    """But beside joins that the parameters move, where differences cross them."""
    segments, parameters, law = KINDS[kind]
    base, names = turning(segments, parameters, law), [*parameters]
    size = len(names)
    rows = [base.graph.parameters.index(name) for name in names]
    _, exact = Tangents(base, np.eye(len(base.parameters))[:, rows]).evaluate(SIGNALS[:3], T)
    nominal, step = base.parameters[rows], 2e-4
    aside = (np.eye(size)[:, :, None] * OFFSETS * step).reshape(size, -1)
    varied = Varied(base, names)
    moved = varied.evaluate(SIGNALS[:3], varied.parameters(nominal[:, None] + aside), T)
    numeric = moved.reshape(3, size, OFFSETS.size, T.size).transpose(0, 1, 3, 2) @ WEIGHTS / step
    error = np.abs(exact - numeric) / np.abs(numeric).max(axis=(1, 2), keepdims=True)
    far = (error > 1e-8).any(axis=(0, 1))
    joins = base.motions["shape"]
    place = np.radians(40 * T + 10)[far]
    near = np.array(
        [np.abs((place - at + 0.5 * joins.period) % joins.period - 0.5 * joins.period) for at in joins.breaks]
    )
    assert (near.min(axis=0) < 40 * step).all()
    assert far.sum() <= 5


CAMS = [("swinging", "roller"), ("swinging", "face"), ("sliding", "roller"), ("sliding", "knife"), ("sliding", "face")]
LIFT = {"h": 0.1, "w": 1.7, "v": 1.3, "b": 0.3, "rb": 0.04}
AT = np.linspace(0.02, 0.85, 9)


def relation(guide: str, touch: str, **parameters: float) -> Compiled:
    """A cam pair whose law's height, widths and fractions are parameters, and its base circle."""
    data = pair(guide, touch)
    given = LIFT | {"h": 0.1 if guide == "swinging" else 0.008} | parameters
    data["parameters"] = {name: repr(value) for name, value in given.items()}
    data["cams"]["rider"]["base"] = "rb"
    data["laws"]["lift"]["segments"] = [
        {"rise": "h", "over": "w", "law": "poly_4567"},
        {"dwell": "2.6-w"},
        {"fall": "h", "over": "v", "fractions": ["b", 0, "1-b", 0]},
        {"dwell": "2*pi-2.6-v"},
    ]
    return compiled_from(data)


def signals(guide: str) -> list[str]:
    value, rate, jerk = ("angle", "alpha", "jerk") if guide == "swinging" else ("s", "a", "j")
    return [f"rider.{value}", f"rider.{rate}", f"rider.{jerk}", "rider.force", "rider.pressure", "motor.torque"]


@pytest.mark.parametrize(("guide", "touch"), CAMS)
def test_samples_of_cams_are_models_read_anew(guide: str, touch: str) -> None:
    base = relation(guide, touch)
    names = [*LIFT]
    nominal = np.array([base.quantities.parameters[name] for name in names])
    values = nominal[:, None] * (1 + 0.02 * np.array([[1, -1, 0, 0, 1], [-1, 1, 1, 1, 0]]).T)
    varied = Varied(base, names)
    found = varied.evaluate(signals(guide), varied.parameters(values), AT)
    for i, column in enumerate(values.T):
        wanted = relation(guide, touch, **dict(zip(names, map(float, column), strict=True)))
        rows = wanted.evaluate(signals(guide), AT)
        assert (np.abs(found[:, i] - rows).max(axis=1) <= 1e-11 * np.abs(rows).max(axis=1)).all()


@pytest.mark.parametrize(("guide", "touch"), CAMS)
@pytest.mark.parametrize("made", [lambda c: c, with_cut_cams], ids=["designed", "cut"])
def test_derivatives_of_cams_are_those_of_samples(guide: str, touch: str, made: Any) -> None:
    """Where the law alone deviates, a cam that is cut is another one, as if designed so."""
    base = made(relation(guide, touch))
    names = [*LIFT]
    rows = [base.graph.parameters.index(name) for name in names]
    _, exact = Tangents(base, np.eye(len(base.parameters))[:, rows]).evaluate(signals(guide), AT)
    nominal, step = base.parameters[rows], 2e-3
    aside = nominal[:, None] * (1 + (np.eye(5)[:, :, None] * OFFSETS * step).reshape(5, -1))
    varied = Varied(relation(guide, touch), names)
    moved = varied.evaluate(signals(guide), varied.parameters(aside), AT).reshape(6, 5, OFFSETS.size, AT.size)
    numeric = moved.transpose(0, 1, 3, 2) @ WEIGHTS / (step * nominal[:, None])
    scale = np.abs(numeric).max(axis=2, keepdims=True) + np.abs(base.evaluate(signals(guide), AT))[:, None]
    assert (np.abs(exact - numeric) <= 1e-6 * scale).all()


FLAT = {"dwell": 90}
CURVES = {"law": "cycloidal"}


def degrees(*values: float) -> list[float]:
    return np.radians(values).tolist()


WRONG: list[tuple[list[Any], dict[str, Any], dict[str, list[float]], list[bool], set[str]]] = [
    ([{"rise": 9, "over": "w", **CURVES}, FLAT, {"fall": 9, "over": "v", **CURVES}, FLAT],
     {"w": "90 deg", "v": "90 deg"},
     {"w": degrees(90, 80, 100, 0, -5), "v": degrees(90, 100, 90, 180, 185)},
     [False, False, True, True, True], {"law.over", "law.period"}),
    ([{"rise": "h", "over": 90, **CURVES}, FLAT, {"fall": "k", "over": 90, **CURVES}, FLAT],
     {"h": "9 deg", "k": "9 deg"},
     {"h": degrees(9, 10, 0), "k": degrees(9, 9, 0)},
     [False, True, False], {"law.not-closed"}),
    ([{"rise": 9, "over": 270, "fractions": ["b", "c", "1-b-c", "z"], "skew": "s"}, {"fall": 9, "over": 90, **CURVES}],
     {"b": 0.2, "c": 0.2, "z": 0, "s": 0.5},
     {"z": [0, 0.1, 0, 0, 0], "b": [0.2, 0.2, 0.2, 0, 0.3], "c": [0.2, 0.2, 0.9, 0.4, 0.7],
      "s": [0.5, 0.5, 0.5, 1.2, 0.3]},
     [False, True, True, True, False], {"law.fractions", "law.skew"}),
    ([{"rise": 9, "over": "w", "law": "double_harmonic"}, {"fall": 9, "over": "v", "law": "double_harmonic"}, FLAT],
     {"w": "135 deg", "v": "135 deg"},
     {"w": degrees(135, 130), "v": degrees(135, 140)},
     [False, True], {"law.end-acceleration"}),
    ([{"rise": 9, "over": 130, "match": "velocity"}, {"rise": 20, "over": 100, "law": "constant_velocity"},
      {"rise": -29, "over": 130, "from": ["f"], "to": [0]}],
     {"f": 0.2}, {"f": [0.2, 0.3]}, [False, True], {"drive.law-jumps"}),
    ([{"rise": 9, "over": 90, "via": [["a", 1], ["60", 6]], "from": [0], "to": [0]}, FLAT,
      {"rise": -9, "over": 180, "formula": "u^2*(3-2*u) + k*u + q*log(1-m*u)"}],
     {"a": "30 deg", "k": 0, "q": 0, "m": 0},
     {"a": degrees(30, 61, 60, 20, 20), "k": [0, 0, 0, 0.1, 0], "q": [0, 0, 0, 0, 1], "m": [0, 0, 0, 0, 2]},
     [False, True, True, True, True], {"law.via", "law.not-normal", "law.not-smooth"}),
]  # fmt: skip


@pytest.mark.parametrize(("segments", "parameters", "values", "wrong", "codes"), WRONG)
def test_samples_in_which_a_law_makes_no_sense(
    segments: list[Any],
    parameters: dict[str, Any],
    values: dict[str, list[float]],
    wrong: list[bool],
    codes: set[str],
) -> None:
    """They have no values, the others have theirs; each fault is told once, as a file with such numbers has it."""
    varied = Varied(turning(segments, parameters, {}), [*values])
    given = np.array([*values.values()])
    p = varied.parameters(given)
    assert np.isnan(p).any(axis=0).tolist() == wrong
    assert (~np.isfinite(varied.evaluate(SIGNALS[:2], p, T)).all(axis=(0, 2))).tolist() == wrong
    assert varied.failures(p, T).cause.tolist() == [0 if bad else -1 for bad in wrong]
    faults = varied.faults(given)
    assert {fault.code for fault in faults} == codes
    assert len({(fault.code, fault.path) for fault in faults}) == len(faults)
    alone = [fault for column in given.T for fault in varied.faults(column[:, None])]
    assert {str(fault) for fault in faults} <= {str(fault) for fault in alone}


def test_a_period_that_doesnt_divide_a_turn_of_the_cam() -> None:
    data = pair("swinging", "roller")
    data["parameters"] = {"p": repr(np.pi)}
    data["laws"]["lift"] |= {
        "period": "p",
        "segments": [{"rise": 0.1, "over": "p/2", **CURVES}, {"fall": 0.1, "over": "p/2", **CURVES}],
    }
    varied = Varied(compiled_from(data), ["p"])
    given = np.array([[np.pi, 2 * np.pi / 3, 2.0, 2 * np.pi]])
    assert np.isnan(varied.parameters(given)[0]).tolist() == [False, False, True, False]
    assert [fault.code for fault in varied.faults(given)] == ["cam.period"]


def test_a_second_contact_that_the_law_places_is_refused() -> None:
    data = pair("sliding", "roller", closed="conjugate")
    data["parameters"] = {"h": "0.008"}
    data["laws"]["lift"]["segments"] = [
        {"rise": "h", "over": "pi", "law": "cycloidal"},
        {"fall": "h", "over": "pi", "law": "cycloidal"},
    ]
    with pytest.raises(ModelError) as error:
        Varied(compiled_from(data), ["h"])
    assert [finding.code for finding in error.value.findings] == ["varied.second"]


def test_the_disc_of_a_sample() -> None:
    base = relation("swinging", "roller")
    given = base.quantities.parameters | {"h": 0.11, "w": 1.6, "b": 0.35}
    theta = np.linspace(0.0, 6.2, 40)
    found = disc(base, "rider", given).look(theta)
    wanted = disc(relation("swinging", "roller", h=0.11, w=1.6, b=0.35), "rider").look(theta)
    for a, b in zip((*found.pitch, found.pressure), (*wanted.pitch, wanted.pressure), strict=True):
        assert np.abs(np.asarray(a.d[0]) - b.d[0]).max() < 1e-15
    for wrong in ({"w": 2.7}, {"w": 0.0}, {"h": float("nan")}):
        with pytest.raises((MotionError, NoFollower)):
            disc(base, "rider", base.quantities.parameters | wrong)


@pytest.mark.parametrize("kind", ["modified_sine", "gutman_13", "fractions", "quintic", "harmonics"])
def test_many_places_and_few_come_to_the_same_bits(kind: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Few places pick their piece's numbers, many are asked piece by piece."""
    segments, parameters, law = KINDS[kind]
    base = turning(segments, parameters, law)
    share = 1 + 0.01 * np.random.default_rng(1).uniform(-1, 1, (4, len(parameters)))
    given = {n: base.quantities.parameters[n] * row[:, None] for n, row in zip(parameters, share.T, strict=True)}
    made, x = base.motions["shape"].at_parameters(given), np.linspace(-3.0, 9.0, 300)
    few = [made.at(x, order) for order in range(5)]
    monkeypatch.setattr("linkwright.laws.curve.SMALL", 0)
    many = [made.at(x, order) for order in range(5)]
    alone = [[made.at(x[i : i + 1], order)[:, 0] for i in (0, 77, 250)] for order in range(5)]
    for a, b, c in zip(few, many, alone, strict=True):
        assert np.array_equal(a, b)
        assert np.array_equal(a[:, [0, 77, 250]].T, c)
