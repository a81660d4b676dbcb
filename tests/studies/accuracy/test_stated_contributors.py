"""Contributors from what a file states: their limits, distributions and directions; each fault has its finding."""

from __future__ import annotations

import math
from typing import Any

import mpmath as mp
import numpy as np
import pytest

from helpers.compiled import compiled_from
from linkwright.findings import Finding, ModelError
from linkwright.kernels import Compiled
from linkwright.studies.accuracy.contributors import Contributor, Contributors
from linkwright.studies.accuracy.options import AccuracyOptions
from linkwright.studies.accuracy.stated_contributors import check_contributors, contributors, skipped
from studies.models import slider_crank, speakable


def given(parameters: dict[str, Any]) -> Compiled:
    """A slider-crank with other parameters besides or instead of its own (r 50, l 160, e 20 mm)."""
    data = slider_crank()
    start = {"motor": {**data["drives"]["motor"], "start": "phi"}}
    return compiled_from({**data, "parameters": {**data["parameters"], "phi": "30 deg", **parameters}, "drives": start})


def options(**entries: Any) -> AccuracyOptions:
    return AccuracyOptions.model_validate(entries, context=slider_crank()["studies"])


def made(parameters: dict[str, Any], /, **entries: Any) -> Contributors:
    return contributors(given(parameters), options(**entries))


def one(parameters: dict[str, Any], /, **entries: Any) -> Contributor:
    (contributor,) = made(parameters, **entries).every
    return contributor


def found(parameters: dict[str, Any], /, **entries: Any) -> list[tuple[str, str]]:
    findings = list(check_contributors(given(parameters), options(**entries)))
    assert all(isinstance(finding, Finding) and speakable(finding) for finding in findings)
    return [(f.code, f.element.removeprefix("studies.accuracy.").removeprefix("parameters.")) for f in findings]


# Limits and distributions.


def test_limits_of_a_parameter() -> None:
    for tolerance, low, high in (
        (0.05, -0.05, 0.05),
        ([-0.02, 0.08], -0.02, 0.08),
        ("r/1000", -0.05, 0.05),
        ("ISO 2768-m", -0.3, 0.3),
        ("h7", -0.025, 0),
        ("IT8", -0.0195, 0.0195),
    ):
        r = one({"r": {"value": 50, "tolerance": tolerance}})
        assert (r.low, r.high) == pytest.approx((low * 1e-3, high * 1e-3), rel=1e-12)
        assert r.mean == pytest.approx((r.low + r.high) / 2, abs=1e-18)
        assert r.sigma == pytest.approx((r.high - r.low) / 6, rel=1e-12)
        assert (r.name, r.nominal, r.unit, r.size, r.distribution) == ("r", 0.05, "mm", 1e-3, "normal")
    assert one({"r": {"value": 50, "tolerance": [-0.02, "2*e"]}}, parameters=["r"]).stated == "[-0.02, 2*e]"


def test_a_class_takes_the_size_of_a_negative_coordinate() -> None:
    assert one({"r": {"value": -50, "tolerance": "h7"}}).low == pytest.approx(-25e-6)


def test_angles() -> None:
    stated = {"limits": "ISO 2768-m", "side": "60 mm"}
    phi = one({"phi": {"value": "30 deg", "tolerance": stated}})
    assert phi.high == pytest.approx(math.radians(20 / 60), rel=1e-12)
    assert (phi.unit, phi.size) == ("deg", pytest.approx(math.pi / 180))
    assert one({"phi": {"value": "30 deg", "tolerance": "0.5 deg"}}).high == pytest.approx(math.radians(0.5))
    general = made({"phi": {"value": "30 deg", "tolerance": {"side": "60 mm"}}}, general="ISO 2768-m")
    assert general.names == ["r", "l", "e", "phi"]
    assert general.every[3].high == phi.high


@pytest.mark.parametrize(
    ("said", "study", "name", "sigma"),
    [
        ({}, {}, "normal", 0.1 / 3),
        ({"cp": 2}, {"cp": 1.5}, "normal", 0.1 / 6),
        ({}, {"cp": 1.5}, "normal", 0.1 / 4.5),
        ({"sigma": "20 um"}, {"cp": 1.5}, "normal", 0.02),
        ({}, {"distribution": "uniform"}, "uniform", 0.1 / 3**0.5),
        ({"distribution": "triangular"}, {"distribution": "uniform"}, "triangular", 0.1 / 6**0.5),
        ({"sigma": "20 um"}, {"distribution": "uniform"}, "normal", 0.02),
        ({"distribution": "truncated", "sigma": 1e6}, {}, "truncated", 0.1 / 3**0.5),
    ],
)
def test_distributions(said: dict[str, Any], study: dict[str, Any], name: str, sigma: float) -> None:
    r = one({"r": {"value": 50, "tolerance": {"limits": 0.1, **said}}}, **study)
    assert r.distribution == name
    assert r.sigma == pytest.approx(sigma * 1e-3, rel=1e-9)
    assert r.quantile(np.array([0.5]))[0] == pytest.approx(0, abs=1e-15)


# Which parameters, and the general tolerance.


def test_the_general_tolerance_is_for_lengths_that_state_none() -> None:
    stated = {"r": {"value": 50, "tolerance": 0.01}, "m": {"value": "1 kg"}, "gap": "l - r", "k": 2}
    every = made(stated, general="ISO 2768-f").every
    assert {c.name: (c.stated, round(c.high * 1e3, 9)) for c in every} == {
        "r": ("0.01", 0.01),
        "l": ("ISO 2768-f", 0.2),
        "e": ("ISO 2768-f", 0.1),
    }
    assert made(stated, general="ISO 2768-f", parameters=["e", "r"]).names == ["e", "r"]
    own = {**stated, "e": {"value": 20, "tolerance": {"distribution": "uniform"}}}
    assert made(own, general="ISO 2768-f").every[-1].distribution == "uniform"


def test_lengths_without_a_general_tolerance_are_told() -> None:
    parameters = {"e": 0, "r": 0.4, "l": {"value": 160, "tolerance": 0.05}, "x": "4001 mm"}
    (warning,) = skipped(given(parameters), options(general="ISO 2768-m"))
    assert (warning.code, warning.severity) == ("tolerance.skipped", "warning")
    assert str(warning.data["names"]) == "r, e, x"
    assert made(parameters, general="ISO 2768-m").names == ["l"]
    assert not skipped(given({}), options(general="ISO 2768-m"))


# Directions.


def test_derived_parameters_follow() -> None:
    """Against derivatives in 40 digits of the same expressions written out for mpmath."""
    parameters = {
        "r": {"value": 50, "tolerance": 0.1},
        "e": {"value": 20, "tolerance": 0.1},
        "phi": {"value": "30 deg", "tolerance": "1 deg"},
        "l": "hypot(3*r, e)*(1 + 0.1*sin(phi)) + 2 mm",
        "k": "step5(l, 0 mm, 0, 400 mm, 1)*exp(-r/e) + atan2(e, r)/acos(0.2) + max(0.1, e/r)^1.5",
        "m": "abs(e - r)*sqrt(l/r)",
    }
    every = made(parameters)
    names = list(given(parameters).graph.parameters)
    with mp.workdps(40):

        def length(r: Any, e: Any, phi: Any) -> Any:
            return mp.hypot(3 * r, e) * (1 + mp.mpf("0.1") * mp.sin(phi)) + mp.mpf("0.002")

        def k(r: Any, e: Any, phi: Any) -> Any:
            u = length(r, e, phi) / mp.mpf("0.4")
            step = 10 * u**3 - 15 * u**4 + 6 * u**5
            return step * mp.exp(-r / e) + mp.atan2(e, r) / mp.acos(mp.mpf("0.2")) + (e / r) ** mp.mpf("1.5")

        def m(r: Any, e: Any, phi: Any) -> Any:
            return (r - e) * mp.sqrt(length(r, e, phi) / r)

        at = (mp.mpf("0.05"), mp.mpf("0.02"), mp.pi / 6)
        for i, name in enumerate(("r", "e", "phi")):
            order = tuple(int(i == j) for j in range(3))
            wanted = {"l": length, "k": k, "m": m}
            column = every.every[every.names.index(name)].direction
            for follower, function in wanted.items():
                exact = float(mp.diff(function, at, order))
                assert column[names.index(follower)] == pytest.approx(exact, rel=1e-12, abs=1e-13), (follower, name)
            for other in ("r", "e", "phi"):
                assert column[names.index(other)] == (other == name)
    assert every.directions.shape == (len(names), 3)


def test_lengths_expand_together() -> None:
    parameters = {"r": 50, "e": -20, "l": "3*r - e", "k": "l/r"}
    warm = one(parameters, thermal={"warm-up": {"change": [-10, 40], "material": "Steel"}})
    assert (warm.name, warm.nominal, warm.unit, warm.size) == ("warm-up", 0, "K", 1)
    assert (warm.low, warm.high, warm.mean, warm.distribution) == (-10, 40, 15, "uniform")
    assert warm.sigma == pytest.approx(50 / 12**0.5)
    expected = {"r": 50e-3, "e": -20e-3, "l": 170e-3, "k": 0, "phi": 0}
    names = given(parameters).graph.parameters
    assert dict(zip(names, warm.direction, strict=True)) == pytest.approx(
        {n: 11.5e-6 * expected[n] for n in names}, abs=1e-18
    )
    two = made(
        {},
        thermal={
            "rod": {"change": [0, 30], "expansion": 23, "parameters": ["l"], "distribution": "normal", "sigma": 4},
            "rest": {"change": [0, 30], "expansion": "20/2", "parameters": ["r", "e"], "cp": 2},
        },
    )
    assert [(c.distribution, c.sigma) for c in two.every] == [("normal", 4.0), ("normal", 2.5)]
    assert two.directions[given({}).graph.parameters.index("l")].tolist() == pytest.approx([23e-6 * 0.16, 0])


# Correlations.

PAIR = {
    "r": {"value": 50, "tolerance": 0.05},
    "l": {"value": 160, "tolerance": 0.1},
    "e": {"value": 20, "tolerance": 0.1},
}


def test_correlations_make_one_matrix() -> None:
    every = made(
        PAIR,
        correlations=[{"of": ["e", "r"], "is": 0.8}, {"of": ["warm", "l"], "is": [[1, -0.3], [-0.3, 1]]}],
        thermal={"warm": {"change": [0, 1], "material": "steel"}},
    )
    assert every.names == ["r", "l", "e", "warm"]
    assert every.correlation.tolist() == [[1, 0, 0.8, 0], [0, 1, 0, -0.3], [0.8, 0, 1, 0], [0, -0.3, 0, 1]]
    assert every.covariance[0, 2] == pytest.approx(0.8 * 0.05e-3 / 3 * 0.1e-3 / 3)
    alike = made(PAIR, correlations=[{"of": ["r", "l", "e"], "is": 1}])
    assert alike.correlation.tolist() == np.ones((3, 3)).tolist()
    assert (made(PAIR).correlation == np.eye(3)).all()


def entry(*matrices: Any) -> dict[str, Any]:
    """One correlation after the other: of r, l and e where it is a matrix of three rows, else of r and l."""
    return {
        "correlations": [
            {"of": ["r", "l", "e"] if isinstance(m, list) and len(m) == 3 else ["r", "l"], "is": m} for m in matrices
        ]
    }


TIED = [{"of": ["r", "l"], "is": 0.9}, {"of": ["l", "e"], "is": 0.9}]
FAULTS: dict[str, tuple[dict[str, Any], dict[str, Any], list[tuple[str, str]]]] = {
    "larger than the dimension": ({"r": {"value": 50, "tolerance": 50}}, {}, [("tolerance.too-large", "r.tolerance")]),
    "larger below": ({"r": {"value": -50, "tolerance": [-60, 1]}}, {}, [("tolerance.too-large", "r.tolerance")]),
    "larger than a mass": ({"m": {"value": "1 kg", "tolerance": "2 kg"}}, {}, [("tolerance.too-large", "m.tolerance")]),
    "derived": ({"l": {"value": "3*r", "tolerance": 1}}, {}, [("tolerance.derived", "l.tolerance")]),
    "derived and named": ({"l": "3*r"}, {"parameters": ["l"]}, [("tolerance.derived", "0")]),
    "upside down": ({"r": {"value": 50, "tolerance": [1, -1]}}, {}, [("tolerance.limits", "r.tolerance")]),
    "negative": ({"r": {"value": 50, "tolerance": -1}}, {}, [("tolerance.limits", "r.tolerance")]),
    "both zero": ({"r": {"value": 50, "tolerance": [0, 0]}}, {}, [("tolerance.limits", "r.tolerance")]),
    "no sigma": (
        {"r": {"value": 50, "tolerance": {"limits": 1, "sigma": 0}}}, {}, [("study.sigma", "r.tolerance.sigma")],
    ),
    "negative cp": (
        {"r": {"value": 50, "tolerance": {"limits": 1, "cp": "-1"}}}, {}, [("tolerance.cp", "r.tolerance.cp")],
    ),
    "no general cp": (PAIR, {"cp": 0}, [("tolerance.cp", "cp")]),
    "size of a class": ({"x": {"value": "4 m", "tolerance": "h7"}}, {}, [("tolerance.size", "x.tolerance")]),
    "small for the general class": (
        {"r": 0.4}, {"general": "ISO 2768-m", "parameters": ["r"]}, [("tolerance.size", "r.tolerance")],
    ),
    "class of a mass": (
        {"m": {"value": "1 kg", "tolerance": "h7"}}, {}, [("tolerance.class-dimension", "m.tolerance")],
    ),
    "fit of an angle": (
        {"phi": {"value": "30 deg", "tolerance": {"limits": "h7", "side": 60}}}, {},
        [("tolerance.class-dimension", "phi.tolerance")],
    ),
    "angle without a side": (
        {"phi": {"value": "30 deg", "tolerance": "ISO 2768-m"}}, {}, [("tolerance.side", "phi.tolerance")],
    ),
    "fit of an angle without a side": (
        {"phi": {"value": "30 deg", "tolerance": "h7"}}, {}, [("tolerance.class-dimension", "phi.tolerance")],
    ),
    "side of nothing": (
        {"phi": {"value": "30 deg", "tolerance": {"limits": "ISO 2768-m", "side": 0}}}, {},
        [("value.too-small", "phi.tolerance.side")],
    ),
    "nothing": ({}, {}, [("tolerance.none", "studies.accuracy")]),
    "nothing to estimate": (
        {}, {"clearances": {"B": 0.1}, "calibrate": {"points": [{"t": 0.1, "B.x": 1}]}},
        [("tolerance.none", "studies.accuracy")],
    ),
    "no tolerance": ({}, {"parameters": ["r"]}, [("tolerance.missing", "0")]),
    "unknown": (PAIR, {"parameters": ["R"]}, [("name.unknown-parameter", "0")]),
    "twice": (PAIR, {"parameters": ["r", "r"]}, [("tolerance.named-twice", "1")]),
    "no derivative": (
        {**PAIR, "z": {"value": 0, "tolerance": "1 mm"}, "k": "sqrt(z/r)"}, {}, [("tolerance.no-derivative", "k")],
    ),
    "unknown in a correlation": (
        PAIR, {"correlations": [{"of": ["r", "R"], "is": 0.5}]},
        [("tolerance.no-contributor", "correlations.0.of.1")],
    ),
    "correlated with itself": (
        PAIR, {"correlations": [{"of": ["r", "r"], "is": 0.5}]},
        [("tolerance.correlation-twice", "correlations.0.of.1")],
    ),
    "pair twice": (PAIR, entry(0.5, 0.4), [("tolerance.correlation-pair", "correlations.1")]),
    "out of range": (PAIR, entry(1.01), [("tolerance.correlation-range", "correlations.0.is")]),
    "diagonal": (PAIR, entry([[0.9, 0.5], [0.5, 1]]), [("tolerance.correlation-diagonal", "correlations.0.is")]),
    "unsymmetric": (PAIR, entry([[1, 0.5], [0.4, 1]]), [("tolerance.correlation-symmetry", "correlations.0.is")]),
    "shape": (PAIR, entry([[1, 0.5], [0.5]]), [("tolerance.correlation-shape", "correlations.0.is")]),
    "indefinite": (
        PAIR, entry([[1, 0.9, -0.9], [0.9, 1, 0.9], [-0.9, 0.9, 1]]),
        [("tolerance.correlation-indefinite", "correlations.0.is")],
    ),
    "indefinite as a whole": (PAIR, {"correlations": TIED}, [("tolerance.correlation-indefinite", "correlations")]),
    "unknown material": (
        {}, {"thermal": {"warm": {"change": [0, 1], "material": "steal"}}},
        [("tolerance.material", "thermal.warm.material")],
    ),
    "change that falls": (
        {}, {"thermal": {"warm": {"change": [1, 1], "material": "steel"}}},
        [("value.not-rising", "thermal.warm.change")],
    ),
    "expansion of an angle": (
        {}, {"thermal": {"warm": {"change": [0, 1], "material": "steel", "parameters": ["phi", "no"]}}},
        [
            ("name.unknown-parameter", "thermal.warm.parameters.1"),
            ("tolerance.not-a-length", "thermal.warm.parameters.0"),
        ],
    ),
    "expansion of a derived length": (
        {"l": "3*r"}, {"thermal": {"warm": {"change": [0, 1], "material": "steel", "parameters": ["l"]}}},
        [("tolerance.derived", "thermal.warm.parameters.0")],
    ),
    "expansion in mm": (
        {}, {"thermal": {"warm": {"change": ["0 mm", "1/0"], "expansion": "1 mm"}}},
        [
            ("expression.units-conflict", "thermal.warm.change"), ("value.not-finite", "thermal.warm.change"),
            ("expression.units-conflict", "thermal.warm.expansion"),
        ],
    ),
    "named as a parameter": (
        {}, {"thermal": {"r": {"change": [0, 1], "material": "steel"}}}, [("tolerance.thermal-name", "thermal.r")],
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", FAULTS)
def test_each_fault_has_its_finding(name: str) -> None:
    parameters, entries, expected = FAULTS[name]
    assert found(parameters, **entries) == expected
    with pytest.raises(ModelError):
        made(parameters, **entries)


def test_a_mechanism_without_lengths_doesnt_expand() -> None:
    data = slider_crank(parameters={"k": 2})
    data["links"] = {
        "frame": {"points": {"A": [0, 0], "F": [0, 20]}},
        "crank": {"points": {"A": [0, 0], "B": [50, 0]}},
        "rod": {"points": {"B": [0, 0], "C": [160, 0]}},
        "slider": {"points": {"C": [0, 0]}},
    }
    entries = options(thermal={"warm": {"change": [0, 1], "material": "steel"}})
    assert [f.code for f in check_contributors(compiled_from(data), entries)] == ["tolerance.no-length"]


def test_all_faults_are_told_at_once() -> None:
    codes = [
        code
        for code, _ in found(
            {"r": {"value": 50, "tolerance": {"limits": 60, "cp": -1}}, "e": {"value": 20, "tolerance": [1, 0]}},
            cp=-1,
            correlations=[{"of": ["r", "E"], "is": 2}],
            thermal={"warm": {"change": [1, 0], "material": "?"}},
        )
    ]
    assert codes == [
        "tolerance.cp", "tolerance.cp", "tolerance.too-large", "tolerance.limits", "value.not-rising",
        "tolerance.material", "tolerance.no-contributor", "tolerance.correlation-range",
    ]  # fmt: skip


def test_form_of_the_options() -> None:
    for entries, code in (
        ({"thermal": {"warm": {"change": [0, 1]}}}, "tolerance.material-or-expansion"),
        (
            {"thermal": {"w": {"change": [0, 1], "material": "steel", "expansion": 1}}},
            "tolerance.material-or-expansion",
        ),
        ({"general": "IT99"}, "tolerance.unknown-class"),
        ({"distribution": "gauss"}, "tolerance.distribution"),
        ({"correlations": [{"of": ["r", "l"], "is": "much"}]}, "file.expected"),
    ):
        with pytest.raises(ValueError, match=code.replace(".", r"\.")):
            options(**entries)
